(* Section 5, "the larger the gradient the larger the increase in mutual information": for a patch divided into two halves of
   equal area whose form factors are F (1 + g) and F (1 - g), the gain (5) rises strictly with g, from 0 to the bound (6). *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums LogSum PairGain.
Open Scope R_scope.

(* The gain (5) of the pair: a patch of weight w (its relative area) and form factor F to a patch of weight receiver. *)
Definition gain_of_halves (weight F receiver g : R) : R :=
  pair_gain 2 weight F receiver (fun _ => weight / 2) (fun k => match k with O => F * (1 + g) | _ => F * (1 - g) end).

(* (1 + g) log (1 + g) + (1 - g) log (1 - g), with 0 log 0 = 0. *)
Definition gradient_information (g : R) : R := xlog2 (1 + g) 1 + xlog2 (1 - g) 1.

(* x log x lies strictly below its chord between two different points: the log-sum inequality (12) for two terms. *)
Lemma xlogx_below_chord_of_two_points : forall x y t, 0 <= x -> 0 <= y -> 0 <= t <= 1 ->
  xlog2 (t * x + (1 - t) * y) 1 <= t * xlog2 x 1 + (1 - t) * xlog2 y 1 /\
  (0 < t < 1 -> x <> y -> xlog2 (t * x + (1 - t) * y) 1 < t * xlog2 x 1 + (1 - t) * xlog2 y 1).
Proof.
  intros x y t Hx Hy Ht.
  set (a := fun i : nat => match i with O => t * x | _ => (1 - t) * y end).
  set (b := fun i : nat => match i with O => t * 1 | _ => (1 - t) * 1 end).
  assert (A : forall i, (i < 2)%nat -> 0 <= a i) by (intros [|i] _; apply Rmult_le_pos; lra).
  assert (B : forall i, (i < 2)%nat -> 0 <= b i) by (intros [|i] _; apply Rmult_le_pos; lra).
  assert (Z : forall i, (i < 2)%nat -> b i = 0 -> a i = 0).
  { intros [|i] _; unfold a, b; intros E.
    - replace t with 0 by lra. lra.
    - replace (1 - t) with 0 by lra. lra. }
  assert (L := log_sum_inequality 2 a b A B Z). assert (Q := log_sum_equality 2 a b A B Z).
  assert (Ea : sum 2 a = t * x + (1 - t) * y) by (simpl; lra).
  assert (Eb : sum 2 b = 1) by (simpl; lra).
  assert (Es : sum 2 (fun i => xlog2 (a i) (b i)) = t * xlog2 x 1 + (1 - t) * xlog2 y 1).
  { unfold a, b; simpl. rewrite !xlog2_scale. lra. }
  rewrite Ea, Eb, Es in *. split; [exact L|]. intros Ht' N.
  destruct L as [L|L]; [exact L|exfalso]. symmetry in L. apply Q with (i := 0%nat) in L; [|lia].
  unfold a, b in L. apply N. assert (t * (1 - t) * (x - y) = 0) by lra.
  apply Rmult_integral in H. destruct H as [H|H]; [|lra].
  apply Rmult_integral in H. lra.
Qed.

(* 1 + g and 1 - g both lie on the segment between 1 + h and 1 - h when 0 <= g < h. *)
Theorem gradient_information_rises : forall g h, 0 <= g -> g < h -> h <= 1 ->
  gradient_information g < gradient_information h.
Proof.
  intros g h Hg Hgh Hh. unfold gradient_information. set (t := (1 + g / h) / 2).
  assert (Q : 0 <= g / h < 1).
  { split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
    apply (Rmult_lt_reg_r h); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Ht : 0 < t < 1) by (unfold t; lra).
  destruct (xlogx_below_chord_of_two_points (1 + h) (1 - h) t) as [_ S1]; [lra|lra|lra|].
  destruct (xlogx_below_chord_of_two_points (1 + h) (1 - h) (1 - t)) as [S2 _]; [lra|lra|lra|].
  specialize (S1 Ht ltac:(lra)).
  replace (t * (1 + h) + (1 - t) * (1 - h)) with (1 + g) in S1 by (unfold t; field; lra).
  replace ((1 - t) * (1 + h) + (1 - (1 - t)) * (1 - h)) with (1 - g) in S2 by (unfold t; field; lra).
  lra.
Qed.

(* The gain is weight times form factor times that function of g alone: F comes out of the logarithms. *)
Theorem gain_of_halves_depends_on_gradient : forall weight F receiver g,
  0 < F -> 0 < receiver -> 0 <= g <= 1 ->
  gain_of_halves weight F receiver g = weight * F * gradient_information g.
Proof.
  intros w F r g HF Hr Hg. unfold gain_of_halves.
  rewrite receiver_weight_drops_out.
  - unfold pair_gain_without_receiver, gradient_information. simpl.
    assert (X : forall x, 0 <= x -> xlog2 (F * x) 1 = F * xlog2 x 1 + F * x * log2 F).
    { intros x Hx. destruct (Req_dec x 0) as [->|N]; [rewrite Rmult_0_r, !xlog2_0; lra|].
      assert (0 < F * x) by (apply Rmult_lt_0_compat; lra).
      rewrite !xlog2_nonzero by lra. unfold Rdiv. rewrite Rinv_1, !Rmult_1_r, log2_mult by lra. ring. }
    rewrite !X by lra. replace (xlog2 F 1) with (F * xlog2 1 1 + F * 1 * log2 F) by (rewrite <- X by lra; f_equal; ring).
    rewrite (xlog2_nonzero 1 1) by lra. replace (1 / 1) with 1 by field. rewrite log2_1. field.
  - lra.
  - exact Hr.
  - intros [|k] _; apply Rmult_le_pos; lra.
  - simpl. field.
Qed.

(* The claim of section 5. *)
Theorem larger_gradient_gains_more : forall weight F receiver g h,
  0 < weight -> 0 < F -> 0 < receiver -> 0 <= g -> g < h -> h <= 1 ->
  gain_of_halves weight F receiver g < gain_of_halves weight F receiver h.
Proof.
  intros w F r g h Hw HF Hr Hg Hgh Hh. rewrite !gain_of_halves_depends_on_gradient by lra.
  apply Rmult_lt_compat_l; [now apply Rmult_lt_0_compat|now apply gradient_information_rises].
Qed.

(* Without a gradient nothing is gained. *)
Theorem no_gradient_gains_nothing : forall weight F receiver,
  0 < F -> 0 < receiver -> gain_of_halves weight F receiver 0 = 0.
Proof.
  intros w F r HF Hr. rewrite gain_of_halves_depends_on_gradient by lra. unfold gradient_information.
  rewrite !xlog2_nonzero by lra. replace ((1 + 0) / 1) with 1 by field. replace ((1 - 0) / 1) with 1 by field.
  rewrite log2_1. ring.
Qed.

(* With the whole form factor in one half the gain is the bound (6), 2 w F log 2. *)
Theorem full_gradient_gains_the_bound : forall weight F receiver,
  0 < F -> 0 < receiver -> gain_of_halves weight F receiver 1 = 2 * weight * F * log2 2.
Proof.
  intros w F r HF Hr. rewrite gain_of_halves_depends_on_gradient by lra. unfold gradient_information.
  replace (1 - 1) with 0 by ring. rewrite xlog2_0, xlog2_nonzero by lra. replace ((1 + 1) / 1) with 2 by field. ring.
Qed.
