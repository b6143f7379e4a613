(* Control for AcrossTheGradient.v: where weight over flux does not rise from edge to edge, a strip in the middle of the patch can
   gain more than every straight cut. Flux density 1; weight density 3 between 1/4 and 3/4, and 1 elsewhere. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information LogSum Stationarity GradientPatch IntegralsOverParts AcrossTheGradient.
Open Scope R_scope.

Definition even_flux (x : R) : R := 1.
Definition in_middle (x : R) : R := if Rle_dec x (1 / 4) then 0 else if Rle_dec x (3 / 4) then 1 else 0.
Definition heavy_middle_weight (x : R) : R := 1 + 2 * in_middle x.

(* A part with flux a and weight a outside the middle, and flux b and weight 3 b inside: the log-sum inequality (12). *)
Lemma mixed_part : forall a b, 0 <= a -> 0 <= b ->
  xlog2 (a + b) (a + 3 * b) <= - b * log2 3 /\ (0 < a -> 0 < b -> xlog2 (a + b) (a + 3 * b) < - b * log2 3).
Proof.
  intros a b Ha Hb.
  set (f := fun i : nat => match i with O => a | _ => b end).
  set (h := fun i : nat => match i with O => a | _ => 3 * b end).
  assert (F : forall i, (i < 2)%nat -> 0 <= f i) by (intros [|i] _; unfold f; lra).
  assert (G : forall i, (i < 2)%nat -> 0 <= h i) by (intros [|i] _; unfold h; lra).
  assert (Z : forall i, (i < 2)%nat -> h i = 0 -> f i = 0) by (intros [|i] _; unfold f, h; lra).
  assert (L := log_sum_inequality 2 f h F G Z). assert (Q := log_sum_equality 2 f h F G Z).
  assert (Ef : sum 2 f = a + b) by (simpl; lra). assert (Eh : sum 2 h = a + 3 * b) by (simpl; lra).
  assert (Es : sum 2 (fun i => xlog2 (f i) (h i)) = - b * log2 3).
  { unfold f, h; simpl. replace (xlog2 a a) with 0.
    - destruct (Req_dec b 0) as [->|N]; [rewrite xlog2_0; ring|]. rewrite xlog2_nonzero by exact N.
      replace (b / (3 * b)) with (1 / 3) by (field; exact N). rewrite log2_div, log2_1 by lra. ring.
    - destruct (Req_dec a 0) as [->|N]; [now rewrite xlog2_0|]. rewrite xlog2_nonzero by exact N.
      replace (a / a) with 1 by (field; exact N). rewrite log2_1. ring. }
  rewrite Ef, Eh, Es in *. split; [exact L|]. intros Pa Pb. destruct L as [L|L]; [exact L|exfalso].
  symmetry in L. assert (X := proj1 Q L 0%nat ltac:(lia)). unfold f, h in X.
  assert (0 < a * b) by now apply Rmult_lt_0_compat. lra.
Qed.

(* Two parts that share the middle and the rest between them, not both pure. *)
Lemma mixed_division : forall a b, 0 <= a <= 1 / 2 -> 0 <= b <= 1 / 2 ->
  (0 < a /\ 0 < b) \/ (a < 1 / 2 /\ b < 1 / 2) ->
  two_sided_information 1 2 (a + b) (a + 3 * b) < - (1 / 2) * log2 3.
Proof.
  intros a b Ha Hb H. unfold two_sided_information.
  replace (1 - (a + b)) with ((1 / 2 - a) + (1 / 2 - b)) by lra.
  replace (2 - (a + 3 * b)) with ((1 / 2 - a) + 3 * (1 / 2 - b)) by lra.
  destruct (mixed_part a b) as [L1 S1]; [lra|lra|]. destruct (mixed_part (1 / 2 - a) (1 / 2 - b)) as [L2 S2]; [lra|lra|].
  destruct H as [[H1 H2]|[H1 H2]].
  - specialize (S1 H1 H2). lra.
  - specialize (S2 ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma integral_of_constant_piece : forall (f : R -> R) k a b, a <= b -> (forall x, a < x < b -> f x = k) ->
  ex_RInt f a b /\ RInt f a b = k * (b - a).
Proof.
  intros f k a b Hab E. split.
  - apply (ex_RInt_ext (V := R_NormedModule) (fun _ => k)); [|apply ex_RInt_const].
    intros x. rewrite Rmin_left, Rmax_right by lra. intros Hx. symmetry. now apply E.
  - rewrite (RInt_ext (V := R_CompleteNormedModule) f (fun _ => k)).
    + rewrite (RInt_const (V := R_CompleteNormedModule)). change ((b - a) * k = k * (b - a)). ring.
    + intros x. rewrite Rmin_left, Rmax_right by lra. apply E.
Qed.

(* A function that is p outside the middle and q inside, integrated up to c. *)
Lemma integral_of_three_pieces : forall (f : R -> R) p q c, 0 <= c <= 1 ->
  (forall x, 0 <= x <= 1 -> f x = p + (q - p) * in_middle x) ->
  ex_RInt f 0 c /\
  (c <= 1 / 4 -> RInt f 0 c = p * c) /\
  (1 / 4 <= c <= 3 / 4 -> RInt f 0 c = p / 4 + q * (c - 1 / 4)) /\
  (3 / 4 <= c -> RInt f 0 c = p * (c - 1 / 2) + q / 2).
Proof.
  intros f p q c Hc E.
  assert (P1 : forall b, 0 <= b <= 1 / 4 -> ex_RInt f 0 b /\ RInt f 0 b = p * (b - 0)).
  { intros b Hb. apply integral_of_constant_piece; [lra|]. intros x Hx. rewrite E by lra. unfold in_middle.
    destruct (Rle_dec x (1 / 4)); lra. }
  assert (P2 : forall b, 1 / 4 <= b <= 3 / 4 -> ex_RInt f (1 / 4) b /\ RInt f (1 / 4) b = q * (b - 1 / 4)).
  { intros b Hb. apply integral_of_constant_piece; [lra|]. intros x Hx. rewrite E by lra. unfold in_middle.
    destruct (Rle_dec x (1 / 4)), (Rle_dec x (3 / 4)); lra. }
  assert (P3 : forall b, 3 / 4 <= b <= 1 -> ex_RInt f (3 / 4) b /\ RInt f (3 / 4) b = p * (b - 3 / 4)).
  { intros b Hb. apply integral_of_constant_piece; [lra|]. intros x Hx. rewrite E by lra. unfold in_middle.
    destruct (Rle_dec x (1 / 4)), (Rle_dec x (3 / 4)); lra. }
  assert (join : forall a b, ex_RInt f 0 a -> ex_RInt f a b -> ex_RInt f 0 b /\ RInt f 0 b = RInt f 0 a + RInt f a b).
  { intros a b I J. split; [now apply (ex_RInt_Chasles (V := R_NormedModule) f 0 a b)|].
    symmetry. now apply (RInt_Chasles (V := R_CompleteNormedModule) f 0 a b). }
  destruct (P1 (1 / 4)) as [I1 V1]; [lra|].
  assert (Q2 : forall b, 1 / 4 <= b <= 3 / 4 -> ex_RInt f 0 b /\ RInt f 0 b = p / 4 + q * (b - 1 / 4)).
  { intros b Hb. destruct (P2 b Hb) as [J V]. destruct (join _ _ I1 J) as [I W].
    split; [exact I|]. rewrite W, V1, V. lra. }
  destruct (Q2 (3 / 4)) as [I2 V2]; [lra|].
  assert (Q3 : forall b, 3 / 4 <= b <= 1 -> ex_RInt f 0 b /\ RInt f 0 b = p * (b - 1 / 2) + q / 2).
  { intros b Hb. destruct (P3 b Hb) as [J V]. destruct (join _ _ I2 J) as [I W].
    split; [exact I|]. rewrite W, V2, V. lra. }
  split; [|split; [|split]].
  - destruct (Rle_dec c (1 / 4)); [apply P1; lra|]. destruct (Rle_dec c (3 / 4)); [apply Q2; lra|apply Q3; lra].
  - intros H. rewrite (proj2 (P1 c ltac:(lra))). real_equation. ring.
  - intros H. now apply Q2.
  - intros H. apply Q3. lra.
Qed.

(* The strip in the middle keeps the two densities apart; every straight cut mixes them in at least one part. *)
Theorem strip_beats_every_straight_cut :
  share_of_strips even_flux heavy_middle_weight in_middle /\
  forall c, 0 <= c <= 1 ->
    straight_cut_information even_flux heavy_middle_weight c <
    division_information even_flux heavy_middle_weight in_middle.
Proof.
  assert (F := fun c Hc => integral_of_three_pieces even_flux 1 1 c Hc ltac:(intros; unfold even_flux; ring)).
  assert (W := fun c Hc => integral_of_three_pieces heavy_middle_weight 1 3 c Hc
    ltac:(intros; unfold heavy_middle_weight; ring)).
  assert (Fs := fun c Hc => integral_of_three_pieces (fun x => even_flux x * in_middle x) 0 1 c Hc
    ltac:(intros; unfold even_flux; ring)).
  assert (Ws := fun c Hc => integral_of_three_pieces (fun x => heavy_middle_weight x * in_middle x) 0 3 c Hc
    ltac:(intros x _; unfold heavy_middle_weight, in_middle; destruct (Rle_dec x (1 / 4)), (Rle_dec x (3 / 4)); ring)).
  assert (U : 0 <= 1 <= 1) by lra. split.
  - split; [|split; [apply Fs; lra|apply Ws; lra]].
    intros x _. unfold in_middle. destruct (Rle_dec x (1 / 4)), (Rle_dec x (3 / 4)); lra.
  - assert (D : division_information even_flux heavy_middle_weight in_middle = - (1 / 2) * log2 3).
    { unfold division_information, divided_flux, divided_weight, total_flux, total_weight.
      rewrite (proj2 (proj2 (proj2 (F 1 U)))), (proj2 (proj2 (proj2 (W 1 U)))) by lra.
      rewrite (proj2 (proj2 (proj2 (Fs 1 U)))), (proj2 (proj2 (proj2 (Ws 1 U)))) by lra.
      unfold two_sided_information. rewrite !xlog2_nonzero by lra.
      replace ((0 * (1 - 1 / 2) + 1 / 2) / (0 * (1 - 1 / 2) + 3 / 2)) with (1 / 3) by field.
      replace ((1 * (1 - 1 / 2) + 1 / 2 - (0 * (1 - 1 / 2) + 1 / 2)) /
        (1 * (1 - 1 / 2) + 3 / 2 - (0 * (1 - 1 / 2) + 3 / 2))) with 1 by field.
      rewrite log2_div, log2_1 by lra. field. }
    intros c Hc. rewrite D. destruct (F c Hc) as [_ [F1 [F2 F3]]]. destruct (W c Hc) as [_ [W1 [W2 W3]]].
    unfold straight_cut_information, total_flux, total_weight.
    rewrite (proj2 (proj2 (proj2 (F 1 U)))), (proj2 (proj2 (proj2 (W 1 U)))) by lra.
    replace (1 * (1 - 1 / 2) + 1 / 2) with 1 by lra. replace (1 * (1 - 1 / 2) + 3 / 2) with 2 by lra.
    destruct (Rle_dec c (1 / 4)) as [H1|H1]; [|destruct (Rle_dec c (3 / 4)) as [H2|H2]].
    + rewrite F1, W1 by exact H1. replace (1 * c) with (c + 0) at 1 by ring. replace (1 * c) with (c + 3 * 0) by ring.
      apply mixed_division; lra.
    + rewrite F2, W2 by lra. replace (1 / 4 + 1 * (c - 1 / 4)) with (1 / 4 + (c - 1 / 4)) by ring.
      apply mixed_division; lra.
    + rewrite F3, W3 by lra. replace (1 * (c - 1 / 2) + 1 / 2) with ((c - 1 / 2) + 1 / 2) by ring.
      replace (1 * (c - 1 / 2) + 3 / 2) with ((c - 1 / 2) + 3 * (1 / 2)) by field.
      apply mixed_division; lra.
Qed.
