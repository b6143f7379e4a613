(* Section 4.2, n = 1, 2, 3, 4: the printed and the corrected mutual information cut and the mean square cut, each enclosed
   to 30 decimals. The slope (or the polynomial) has opposite signs at the two decimals, and it changes sign only once. *)
From Coq Require Import Reals Lra Lia.
From Infoscene Require Import Sums Enclosure Extremum MeanSquareCut InformationCut GradientPatch Decimals.
Open Scope R_scope.

Lemma printed_from_slopes : forall n lower upper,
  0 < lower < 1 -> 0 < upper < 1 -> 0 < cut_slope n 1 lower -> cut_slope n 1 upper < 0 ->
  exists l, lower < l < upper /\ only_maximiser (printed_objective n) 0 1 l.
Proof.
  intros n lower upper HL HU PL NU.
  destruct (information_cut_between_slopes n 1 lower upper (le_n 1) HL HU PL NU) as [l [Hl M]].
  exists l; split; [exact Hl|]; apply maximiser_only_depends_on_values with (cut_objective n 1); [|exact M].
  intros x _; symmetry; apply printed_objective_has_irradiance_exponent_1.
Qed.

Lemma corrected_from_slopes : forall n lower upper,
  0 < lower < 1 -> 0 < upper < 1 -> 0 < cut_slope (S n) (S n) lower -> cut_slope (S n) (S n) upper < 0 ->
  exists l, lower < l < upper /\ only_maximiser (corrected_objective (S n)) 0 1 l.
Proof.
  intros n lower upper HL HU PL NU.
  destruct (information_cut_between_slopes (S n) (S n) lower upper ltac:(lia) HL HU PL NU) as [l [Hl M]].
  exists l; split; [exact Hl|]; apply maximiser_only_depends_on_values with (cut_objective (S n) (S n)); [|exact M].
  intros x _; symmetry; apply corrected_objective_has_irradiance_exponent_n.
Qed.

Ltac enclose_information_cut criterion lower upper :=
  apply criterion; unfold lower, upper; [lra|lra| |];
  unfold cut_slope, cut_ratio; simpl Nat.add; simpl INR; interval with (i_prec 160).

Ltac enclose_mean_square_cut lower upper :=
  apply mean_square_cut_between_signs; [lia|..]; unfold lower, upper; try lra;
  unfold mean_square_polynomial; simpl sum; simpl INR; interval with (i_prec 160).

Theorem information_cut_printed_1_enclosed : exists l,
  information_cut_printed_1_lower < l < information_cut_printed_1_upper /\ only_maximiser (printed_objective 1) 0 1 l.
Proof. enclose_information_cut printed_from_slopes information_cut_printed_1_lower information_cut_printed_1_upper. Qed.

Theorem information_cut_printed_2_enclosed : exists l,
  information_cut_printed_2_lower < l < information_cut_printed_2_upper /\ only_maximiser (printed_objective 2) 0 1 l.
Proof. enclose_information_cut printed_from_slopes information_cut_printed_2_lower information_cut_printed_2_upper. Qed.

Theorem information_cut_printed_3_enclosed : exists l,
  information_cut_printed_3_lower < l < information_cut_printed_3_upper /\ only_maximiser (printed_objective 3) 0 1 l.
Proof. enclose_information_cut printed_from_slopes information_cut_printed_3_lower information_cut_printed_3_upper. Qed.

Theorem information_cut_printed_4_enclosed : exists l,
  information_cut_printed_4_lower < l < information_cut_printed_4_upper /\ only_maximiser (printed_objective 4) 0 1 l.
Proof. enclose_information_cut printed_from_slopes information_cut_printed_4_lower information_cut_printed_4_upper. Qed.

Theorem information_cut_corrected_1_enclosed : exists l,
  information_cut_corrected_1_lower < l < information_cut_corrected_1_upper /\ only_maximiser (corrected_objective 1) 0 1 l.
Proof. enclose_information_cut corrected_from_slopes information_cut_corrected_1_lower information_cut_corrected_1_upper. Qed.

Theorem information_cut_corrected_2_enclosed : exists l,
  information_cut_corrected_2_lower < l < information_cut_corrected_2_upper /\ only_maximiser (corrected_objective 2) 0 1 l.
Proof. enclose_information_cut corrected_from_slopes information_cut_corrected_2_lower information_cut_corrected_2_upper. Qed.

Theorem information_cut_corrected_3_enclosed : exists l,
  information_cut_corrected_3_lower < l < information_cut_corrected_3_upper /\ only_maximiser (corrected_objective 3) 0 1 l.
Proof. enclose_information_cut corrected_from_slopes information_cut_corrected_3_lower information_cut_corrected_3_upper. Qed.

Theorem information_cut_corrected_4_enclosed : exists l,
  information_cut_corrected_4_lower < l < information_cut_corrected_4_upper /\ only_maximiser (corrected_objective 4) 0 1 l.
Proof. enclose_information_cut corrected_from_slopes information_cut_corrected_4_lower information_cut_corrected_4_upper. Qed.

Theorem mean_square_cut_1_enclosed : exists l,
  mean_square_cut_1_lower < l < mean_square_cut_1_upper /\ only_minimiser (gradient_mean_square_error 1) 0 1 l.
Proof. enclose_mean_square_cut mean_square_cut_1_lower mean_square_cut_1_upper. Qed.

Theorem mean_square_cut_2_enclosed : exists l,
  mean_square_cut_2_lower < l < mean_square_cut_2_upper /\ only_minimiser (gradient_mean_square_error 2) 0 1 l.
Proof. enclose_mean_square_cut mean_square_cut_2_lower mean_square_cut_2_upper. Qed.

Theorem mean_square_cut_3_enclosed : exists l,
  mean_square_cut_3_lower < l < mean_square_cut_3_upper /\ only_minimiser (gradient_mean_square_error 3) 0 1 l.
Proof. enclose_mean_square_cut mean_square_cut_3_lower mean_square_cut_3_upper. Qed.

Theorem mean_square_cut_4_enclosed : exists l,
  mean_square_cut_4_lower < l < mean_square_cut_4_upper /\ only_minimiser (gradient_mean_square_error 4) 0 1 l.
Proof. enclose_mean_square_cut mean_square_cut_4_lower mean_square_cut_4_upper. Qed.

(* The two decimals the paper prints are the optimal cuts of the printed expressions, correctly rounded ... *)
Theorem paper_information_cuts_are_rounded_maximisers : forall l1 l2 l3 l4,
  only_maximiser (printed_objective 1) 0 1 l1 -> only_maximiser (printed_objective 2) 0 1 l2 ->
  only_maximiser (printed_objective 3) 0 1 l3 -> only_maximiser (printed_objective 4) 0 1 l4 ->
  Rabs (l1 - 48 / 100) < 5 / 1000 /\ Rabs (l2 - 61 / 100) < 5 / 1000 /\
  Rabs (l3 - 68 / 100) < 5 / 1000 /\ Rabs (l4 - 74 / 100) < 5 / 1000.
Proof.
  intros l1 l2 l3 l4 M1 M2 M3 M4.
  destruct information_cut_printed_1_enclosed as [x1 [B1 X1]]; rewrite (maximiser_is_unique _ _ _ _ _ M1 X1).
  destruct information_cut_printed_2_enclosed as [x2 [B2 X2]]; rewrite (maximiser_is_unique _ _ _ _ _ M2 X2).
  destruct information_cut_printed_3_enclosed as [x3 [B3 X3]]; rewrite (maximiser_is_unique _ _ _ _ _ M3 X3).
  destruct information_cut_printed_4_enclosed as [x4 [B4 X4]]; rewrite (maximiser_is_unique _ _ _ _ _ M4 X4).
  unfold information_cut_printed_1_lower, information_cut_printed_1_upper, information_cut_printed_2_lower,
    information_cut_printed_2_upper, information_cut_printed_3_lower, information_cut_printed_3_upper,
    information_cut_printed_4_lower, information_cut_printed_4_upper in *.
  repeat split; apply Rabs_def1; lra.
Qed.

Theorem paper_mean_square_cuts_are_rounded_minimisers : forall l1 l2 l3 l4,
  only_minimiser (gradient_mean_square_error 1) 0 1 l1 -> only_minimiser (gradient_mean_square_error 2) 0 1 l2 ->
  only_minimiser (gradient_mean_square_error 3) 0 1 l3 -> only_minimiser (gradient_mean_square_error 4) 0 1 l4 ->
  l1 = 1 / 2 /\ Rabs (l2 - 64 / 100) < 5 / 1000 /\
  Rabs (l3 - 72 / 100) < 5 / 1000 /\ Rabs (l4 - 77 / 100) < 5 / 1000.
Proof.
  intros l1 l2 l3 l4 M1 M2 M3 M4.
  rewrite (minimiser_is_unique _ _ _ _ _ M1 mean_square_cut_of_linear_radiosity_is_one_half).
  destruct mean_square_cut_2_enclosed as [x2 [B2 X2]]; rewrite (minimiser_is_unique _ _ _ _ _ M2 X2).
  destruct mean_square_cut_3_enclosed as [x3 [B3 X3]]; rewrite (minimiser_is_unique _ _ _ _ _ M3 X3).
  destruct mean_square_cut_4_enclosed as [x4 [B4 X4]]; rewrite (minimiser_is_unique _ _ _ _ _ M4 X4).
  unfold mean_square_cut_2_lower, mean_square_cut_2_upper, mean_square_cut_3_lower, mean_square_cut_3_upper,
    mean_square_cut_4_lower, mean_square_cut_4_upper in *.
  repeat split; try apply Rabs_def1; lra.
Qed.

(* ... and for n = 2, 3, 4 they are not those of the corrected expression: its cuts round to 0.62, 0.70, 0.76. *)
Theorem corrected_information_cuts_round_to_62_70_76 : forall l2 l3 l4,
  only_maximiser (corrected_objective 2) 0 1 l2 ->
  only_maximiser (corrected_objective 3) 0 1 l3 -> only_maximiser (corrected_objective 4) 0 1 l4 ->
  Rabs (l2 - 62 / 100) < 5 / 1000 /\ Rabs (l3 - 70 / 100) < 5 / 1000 /\ Rabs (l4 - 76 / 100) < 5 / 1000.
Proof.
  intros l2 l3 l4 M2 M3 M4.
  destruct information_cut_corrected_2_enclosed as [x2 [B2 X2]]; rewrite (maximiser_is_unique _ _ _ _ _ M2 X2).
  destruct information_cut_corrected_3_enclosed as [x3 [B3 X3]]; rewrite (maximiser_is_unique _ _ _ _ _ M3 X3).
  destruct information_cut_corrected_4_enclosed as [x4 [B4 X4]]; rewrite (maximiser_is_unique _ _ _ _ _ M4 X4).
  unfold information_cut_corrected_2_lower, information_cut_corrected_2_upper, information_cut_corrected_3_lower,
    information_cut_corrected_3_upper, information_cut_corrected_4_lower, information_cut_corrected_4_upper in *.
  repeat split; apply Rabs_def1; lra.
Qed.

(* "Very near": the printed cuts lie within 0.036 of the mean square cuts, and the corrected ones within 0.019. *)
Theorem printed_cuts_lie_within_36_thousandths_of_mean_square_cuts : forall n information_cut mean_square_cut,
  (1 <= n <= 4)%nat -> only_maximiser (printed_objective n) 0 1 information_cut ->
  only_minimiser (gradient_mean_square_error n) 0 1 mean_square_cut ->
  Rabs (information_cut - mean_square_cut) < 36 / 1000.
Proof.
  intros n l q Hn Ml Mq.
  destruct n as [|[|[|[|[|n]]]]]; try lia.
  - destruct information_cut_printed_1_enclosed as [x [B X]]; rewrite (maximiser_is_unique _ _ _ _ _ Ml X).
    destruct mean_square_cut_1_enclosed as [y [D Y]]; rewrite (minimiser_is_unique _ _ _ _ _ Mq Y).
    unfold information_cut_printed_1_lower, information_cut_printed_1_upper, mean_square_cut_1_lower, mean_square_cut_1_upper in *.
    apply Rabs_def1; lra.
  - destruct information_cut_printed_2_enclosed as [x [B X]]; rewrite (maximiser_is_unique _ _ _ _ _ Ml X).
    destruct mean_square_cut_2_enclosed as [y [D Y]]; rewrite (minimiser_is_unique _ _ _ _ _ Mq Y).
    unfold information_cut_printed_2_lower, information_cut_printed_2_upper, mean_square_cut_2_lower, mean_square_cut_2_upper in *.
    apply Rabs_def1; lra.
  - destruct information_cut_printed_3_enclosed as [x [B X]]; rewrite (maximiser_is_unique _ _ _ _ _ Ml X).
    destruct mean_square_cut_3_enclosed as [y [D Y]]; rewrite (minimiser_is_unique _ _ _ _ _ Mq Y).
    unfold information_cut_printed_3_lower, information_cut_printed_3_upper, mean_square_cut_3_lower, mean_square_cut_3_upper in *.
    apply Rabs_def1; lra.
  - destruct information_cut_printed_4_enclosed as [x [B X]]; rewrite (maximiser_is_unique _ _ _ _ _ Ml X).
    destruct mean_square_cut_4_enclosed as [y [D Y]]; rewrite (minimiser_is_unique _ _ _ _ _ Mq Y).
    unfold information_cut_printed_4_lower, information_cut_printed_4_upper, mean_square_cut_4_lower, mean_square_cut_4_upper in *.
    apply Rabs_def1; lra.
Qed.

Theorem corrected_cuts_lie_within_19_thousandths_of_mean_square_cuts : forall n information_cut mean_square_cut,
  (1 <= n <= 4)%nat -> only_maximiser (corrected_objective n) 0 1 information_cut ->
  only_minimiser (gradient_mean_square_error n) 0 1 mean_square_cut ->
  Rabs (information_cut - mean_square_cut) < 19 / 1000.
Proof.
  intros n l q Hn Ml Mq.
  destruct n as [|[|[|[|[|n]]]]]; try lia.
  - destruct information_cut_corrected_1_enclosed as [x [B X]]; rewrite (maximiser_is_unique _ _ _ _ _ Ml X).
    destruct mean_square_cut_1_enclosed as [y [D Y]]; rewrite (minimiser_is_unique _ _ _ _ _ Mq Y).
    unfold information_cut_corrected_1_lower, information_cut_corrected_1_upper, mean_square_cut_1_lower, mean_square_cut_1_upper in *.
    apply Rabs_def1; lra.
  - destruct information_cut_corrected_2_enclosed as [x [B X]]; rewrite (maximiser_is_unique _ _ _ _ _ Ml X).
    destruct mean_square_cut_2_enclosed as [y [D Y]]; rewrite (minimiser_is_unique _ _ _ _ _ Mq Y).
    unfold information_cut_corrected_2_lower, information_cut_corrected_2_upper, mean_square_cut_2_lower, mean_square_cut_2_upper in *.
    apply Rabs_def1; lra.
  - destruct information_cut_corrected_3_enclosed as [x [B X]]; rewrite (maximiser_is_unique _ _ _ _ _ Ml X).
    destruct mean_square_cut_3_enclosed as [y [D Y]]; rewrite (minimiser_is_unique _ _ _ _ _ Mq Y).
    unfold information_cut_corrected_3_lower, information_cut_corrected_3_upper, mean_square_cut_3_lower, mean_square_cut_3_upper in *.
    apply Rabs_def1; lra.
  - destruct information_cut_corrected_4_enclosed as [x [B X]]; rewrite (maximiser_is_unique _ _ _ _ _ Ml X).
    destruct mean_square_cut_4_enclosed as [y [D Y]]; rewrite (minimiser_is_unique _ _ _ _ _ Mq Y).
    unfold information_cut_corrected_4_lower, information_cut_corrected_4_upper, mean_square_cut_4_lower, mean_square_cut_4_upper in *.
    apply Rabs_def1; lra.
Qed.
