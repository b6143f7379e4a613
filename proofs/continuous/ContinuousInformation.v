(* Corollary 1 for a continuous kernel on an interval: divide [0, 1] into intervals and replace f(x, y) by what the
   intervals exchange. As the longest interval shrinks, discrete mutual information tends to the continuous one of
   eq. (4), here the integral of f log f with A_T = 1; and that is the least upper bound over all divisions. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement Corollary1 DoubleIntegral
  ContinuousEntropy Divisions.
Open Scope R_scope.

(* Interval k has its length as weight and exchanges the double integral of f with interval l. *)
Definition discretized (f : R -> R -> R) (n : nat) (p : nat -> R) : chain :=
  {| states := n;
     weight := fun k => p (S k) - p k;
     transition := fun k l => double_integral f (p k) (p (S k)) (p l) (p (S l)) / (p (S k) - p k) |}.

(* Eq. (4) with A_T = 1. *)
Definition continuous_information (f : R -> R -> R) : R :=
  double_integral (fun x y => xlog2 (f x y) 1) 0 1 0 1.

Section Kernel.
Variable f : R -> R -> R.
Hypothesis f_continuous : continuous_in_both f.
Hypothesis f_nonneg : forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> 0 <= f x y.

Let flogf (x y : R) : R := xlog2 (f x y) 1.

Lemma flogf_continuous : continuous_in_both flogf.
Proof. intros x y. apply (continuity_1d_2d_pt_comp (fun u => xlog2 u 1)); [apply xlogx_continuous|apply f_continuous]. Qed.

(* An interval of no length exchanges nothing, so w_k P_kl is the double integral in any case. *)
Lemma joint_of_discretized : forall n p, division n p -> forall k l,
  joint (weight (discretized f n p)) (transition (discretized f n p)) k l =
  double_integral f (p k) (p (S k)) (p l) (p (S l)).
Proof.
  intros n p D k l. unfold joint. simpl.
  destruct (Req_dec (p (S k) - p k) 0) as [E|E]; [|field; exact E].
  destruct (double_integral_is_area_times_value f f_continuous (p k) (p (S k)) (p l) (p (S l)))
    as [x [y [_ [_ ->]]]]; try apply (breaks_grow _ _ D). rewrite E. lra.
Qed.

(* Each exchange is its cell's area times a value of f at some point of the cell. *)
Lemma exchange_value : forall n p, division n p -> forall k l, (k < n)%nat -> (l < n)%nat ->
  exists x y, (0 <= x <= 1 /\ p k <= x <= p (S k)) /\ (0 <= y <= 1 /\ p l <= y <= p (S l)) /\
  double_integral f (p k) (p (S k)) (p l) (p (S l)) =
    (p (S k) - p k) * (p (S l) - p l) * f x y.
Proof.
  intros n p D k l Hk Hl.
  destruct (double_integral_is_area_times_value f f_continuous (p k) (p (S k)) (p l) (p (S l)))
    as [x [y [Hx [Hy E]]]]; try apply (breaks_grow _ _ D).
  assert (B := breaks_between n p D). assert (B1 := B k ltac:(lia)). assert (B2 := B (S k) ltac:(lia)).
  assert (B3 := B l ltac:(lia)). assert (B4 := B (S l) ltac:(lia)).
  exists x, y. repeat split; try lra.
Qed.

(* Halving every interval refines the chain. *)
Theorem halved_division_refines : forall n p, division n p ->
  refined_by (discretized f n p) (discretized f (n * 2) (halved p)).
Proof.
  intros n p D. assert (D' := halved_division n p D). exists (fun k => (k / 2)%nat). split.
  - intros k Hk. apply Nat.div_lt_upper_bound; [lia|]. change (k < n * 2)%nat in Hk. change (states _) with n. lia.
  - intros k _. simpl. assert (H := breaks_grow _ _ D' k). lra.
  - intros k l Hk Hl. rewrite joint_of_discretized by assumption.
    destruct (exchange_value _ _ D' k l Hk Hl) as [x [y [[Hx _] [[Hy _] ->]]]].
    assert (H1 := breaks_grow _ _ D' k). assert (H2 := breaks_grow _ _ D' l).
    repeat apply Rmult_le_pos; try lra. now apply f_nonneg.
  - intros k l Hk Hl E. rewrite joint_of_discretized by assumption.
    destruct (exchange_value _ _ D' k l Hk Hl) as [x [y [_ [_ ->]]]]. simpl in E. rewrite E. lra.
  - intros i Hi. change (states (discretized f (n * 2) (halved p))) with (n * 2)%nat.
    rewrite part_sum_of_halves by exact Hi. cbn [sum weight discretized].
    rewrite Nat.add_0_r, Nat.add_1_r. destruct (halved_length p i) as [-> ->]. lra.
  - intros i j Hi Hj. rewrite joint_of_discretized by assumption.
    change (states (discretized f (n * 2) (halved p))) with (n * 2)%nat. unfold block_sum.
    rewrite part_sum_of_halves by exact Hi.
    assert (C := double_integral_over_cells f f_continuous (fun r => halved p (i * 2 + r)) 2
      (fun r => halved p (j * 2 + r)) 2).
    cbv beta in C. rewrite !Nat.add_0_r in C.
    replace (i * 2 + 2)%nat with (S i * 2)%nat in C by lia.
    replace (j * 2 + 2)%nat with (S j * 2)%nat in C by lia.
    rewrite !halved_even in C. rewrite C.
    + apply sum_ext. intros r _. rewrite part_sum_of_halves by exact Hj. apply sum_ext. intros q _.
      rewrite joint_of_discretized by assumption.
      now replace (i * 2 + S r)%nat with (S (i * 2 + r)) by lia;
      replace (j * 2 + S q)%nat with (S (j * 2 + q)) by lia.
    + intros r. replace (j * 2 + S r)%nat with (S (j * 2 + r)) by lia. apply (breaks_grow _ _ D').
Qed.

(* ---- Convergence ---- *)

(* Each term of I is the cell's area times f log f at one point of the cell, and each cell of the double integral
   the area times f log f at another; f log f is uniformly continuous. *)
Theorem discrete_information_tends_to_continuous : forall eps, 0 < eps ->
  exists delta, 0 < delta /\ forall n p, division n p ->
  (forall k, (k < n)%nat -> p (S k) - p k < delta) ->
  Rabs (information (discretized f n p) - continuous_information f) <= eps.
Proof.
  intros eps Heps.
  destruct (uniform_continuity_2d flogf 0 1 0 1 (fun x y _ _ => flogf_continuous x y) (mkposreal eps Heps))
    as [delta U]. simpl in U.
  exists delta. split; [apply cond_pos|]. intros n p D Hp.
  unfold information. rewrite mutual_information_of_joint. change (states (discretized f n p)) with n.
  unfold continuous_information.
  assert (C := double_integral_over_cells flogf flogf_continuous p n p n (breaks_grow _ _ D)).
  rewrite (first_break _ _ D), (last_break _ _ D) in C. fold flogf. rewrite C. clear C.
  set (area := fun k l => (p (S k) - p k) * (p (S l) - p l)).
  assert (T : forall k l, (k < n)%nat -> (l < n)%nat ->
    - (area k l * eps) <=
    xlog2 (joint (weight (discretized f n p)) (transition (discretized f n p)) k l)
      (weight (discretized f n p) k * weight (discretized f n p) l) -
    double_integral flogf (p k) (p (S k)) (p l) (p (S l)) <= area k l * eps).
  { intros k l Hk Hl. rewrite joint_of_discretized by assumption.
    destruct (exchange_value n p D k l Hk Hl) as [x [y [[Hx Hx'] [[Hy Hy'] ->]]]].
    destruct (double_integral_is_area_times_value flogf flogf_continuous (p k) (p (S k)) (p l) (p (S l)))
      as [u [v [Hu [Hv ->]]]]; try apply (breaks_grow _ _ D).
    cbn [weight discretized]. fold (area k l).
    assert (X : xlog2 (area k l * f x y) (area k l) = area k l * flogf x y)
      by (unfold flogf; rewrite <- xlog2_scale; f_equal; ring).
    rewrite X.
    assert (B := breaks_between n p D). assert (B1 := B k ltac:(lia)). assert (B2 := B (S k) ltac:(lia)).
    assert (B3 := B l ltac:(lia)). assert (B4 := B (S l) ltac:(lia)).
    assert (Lk := Hp k Hk). assert (Ll := Hp l Hl).
    assert (E : Rabs (flogf x y - flogf u v) < eps)
      by (apply U; try lra; apply Rabs_def1; lra).
    apply Rabs_def2 in E.
    assert (0 <= area k l) by (apply Rmult_le_pos; [assert (H := breaks_grow _ _ D k)|assert (H := breaks_grow _ _ D l)]; lra).
    split; nra. }
  assert (A : sum n (fun k => sum n (fun l => area k l * eps)) = eps).
  { rewrite (sum_ext n _ (fun k => (p (S k) - p k) * eps)).
    - rewrite sum_scale_right, lengths_sum_to_one by assumption. lra.
    - intros k _. unfold area. rewrite sum_scale_right, sum_scale, lengths_sum_to_one by assumption. lra. }
  rewrite <- sum_minus.
  rewrite (sum_ext n _ (fun k => sum n (fun l =>
    xlog2 (joint (weight (discretized f n p)) (transition (discretized f n p)) k l)
      (weight (discretized f n p) k * weight (discretized f n p) l) -
    double_integral flogf (p k) (p (S k)) (p l) (p (S l))))) by (intros; symmetry; apply sum_minus).
  apply Rabs_le. split.
  - rewrite <- A. replace (- sum n (fun k => sum n (fun l => area k l * eps)))
      with (sum n (fun k => sum n (fun l => - (area k l * eps)))).
    + apply sum_le. intros k Hk. apply sum_le. intros l Hl. now apply T.
    + rewrite (sum_ext n _ (fun k => -1 * sum n (fun l => area k l * eps))).
      * rewrite sum_scale. lra.
      * intros k _. rewrite <- sum_scale. apply sum_ext. intros. lra.
  - rewrite <- A at 1. apply sum_le. intros k Hk. apply sum_le. intros l Hl. now apply T.
Qed.

(* t halvings of a division: each is a refinement, and the intervals become shorter than any length. *)
Fixpoint halvings (n : nat) (p : nat -> R) (t : nat) : nat * (nat -> R) :=
  match t with
  | O => (n, p)
  | S t => let (m, q) := halvings n p t in ((m * 2)%nat, halved q)
  end.

Lemma halvings_division : forall n p, division n p -> forall t,
  let (m, q) := halvings n p t in
  division m q /\ (forall k, (k < m)%nat -> q (S k) - q k <= (1 / 2) ^ t) /\
  information (discretized f n p) <= information (discretized f m q).
Proof.
  intros n p D. induction t as [|t IH]; simpl.
  - split; [exact D|split; [|lra]]. intros k Hk.
    assert (B := breaks_between n p D). assert (B1 := B k ltac:(lia)). assert (B2 := B (S k) ltac:(lia)). lra.
  - destruct (halvings n p t) as [m q]. destruct IH as [IH1 [IH2 IH3]].
    split; [now apply halved_division|split].
    + intros j Hj. destruct (even_or_odd j) as [k [-> | ->]]; destruct (halved_length q k) as [E1 E2];
      specialize (IH2 k ltac:(lia)); lra.
    + apply Rle_trans with (1 := IH3). now apply refinement_bounds_information, halved_division_refines.
Qed.

Lemma fine_halvings : forall n p, division n p -> forall eps, 0 < eps ->
  exists m q, division m q /\ information (discretized f n p) <= information (discretized f m q) /\
  Rabs (information (discretized f m q) - continuous_information f) <= eps.
Proof.
  intros n p D eps Heps. destruct (discrete_information_tends_to_continuous eps Heps) as [delta [Hd C]].
  destruct (pow_lt_1_zero (1 / 2) ltac:(rewrite Rabs_right; lra) delta Hd) as [t Ht].
  specialize (Ht t ltac:(lia)). rewrite Rabs_right in Ht by (left; apply pow_lt; lra).
  assert (H := halvings_division n p D t). destruct (halvings n p t) as [m q]. destruct H as [H1 [H2 H3]].
  exists m, q. split; [exact H1|split; [exact H3|]]. apply C; [exact H1|].
  intros k Hk. apply Rle_lt_trans with (2 := Ht). now apply H2.
Qed.

(* Discrete mutual information never exceeds the continuous one. *)
Theorem discrete_information_at_most_continuous : forall n p, division n p ->
  information (discretized f n p) <= continuous_information f.
Proof.
  intros n p D. apply le_epsilon. intros eps Heps.
  destruct (fine_halvings n p D eps Heps) as [m [q [_ [H1 H2]]]]. apply Rabs_le_between in H2. lra.
Qed.

(* Corollary 1. *)
Theorem continuous_information_is_least_upper_bound :
  is_lub (fun x => exists n p, division n p /\ x = information (discretized f n p))
    (continuous_information f).
Proof.
  split.
  - intros x [n [p [D ->]]]. now apply discrete_information_at_most_continuous.
  - intros b Hb. apply le_epsilon. intros eps Heps.
    assert (D : division 1 INR) by (split; [reflexivity|reflexivity|intros; rewrite S_INR; lra]).
    destruct (fine_halvings 1 INR D eps Heps) as [m [q [D' [_ H]]]].
    assert (information (discretized f m q) <= b) by (apply Hb; exists m, q; auto).
    apply Rabs_le_between in H. lra.
Qed.
End Kernel.
