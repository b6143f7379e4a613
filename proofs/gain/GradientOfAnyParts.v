(* Section 5, any number of parts of any weights: the gain (5) grows with the gradient of the form factors along the parts,
   and it is at least weight times form factor times the square of the gradient, over ln 2 (Pinsker's inequality). *)
From Coq Require Import Reals Lra Lia Arith.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums LogSum PairGain GradientRaisesGain Enclosure.
Open Scope R_scope.

(* The mean over the parts of |P_kj - P_ij|, relative to P_ij: parts with P_ij (1 + g) and P_ij (1 - g) of equal weight have
   the gradient g. *)
Definition relative_gradient (m : nat) (weight probability : R) (part_weight part_probability : nat -> R) : R :=
  sum m (fun k => part_weight k * Rabs (part_probability k - probability)) / (weight * probability).

(* ---- One term: (r - 1)^2 <= (4 + 2 r) / 3 (r ln r - r + 1) ---- *)

Lemma ln_at_least : forall r, 0 < r -> 1 - / r <= ln r.
Proof.
  intros r Hr. assert (0 < / r) by now apply Rinv_0_lt_compat.
  destruct (Req_dec (/ r) 1) as [E|N].
  - assert (r = 1) by (rewrite <- (Rinv_inv r), E; apply Rinv_1). subst. rewrite ln_1. lra.
  - assert (L := ln_below_tangent (/ r) H N). rewrite ln_Rinv in L by exact Hr. lra.
Qed.

Lemma above_minimum_is_positive : forall r x, 0 < r -> Rmin 1 r <= x -> 0 < x.
Proof. intros r x Hr H. apply Rlt_le_trans with (2 := H). apply Rmin_glb_lt; lra. Qed.

(* (r + 1) ln r - 2 (r - 1) has the sign of r - 1: its derivative is ln r + 1 / r - 1 >= 0. *)
Lemma sign_of_slope : forall r, 0 < r -> 0 <= (r - 1) * ((r + 1) * ln r - 2 * (r - 1)).
Proof.
  intros r Hr. set (u := fun r => (r + 1) * ln r - 2 * (r - 1)).
  assert (D : forall c, 0 < c -> is_derive u c (ln c + / c - 1)).
  { intros c Hc. unfold u. auto_derive; [exact Hc|]. field. lra. }
  destruct (MVT_gen u 1 r (fun c => ln c + / c - 1)) as [c [Hc E]].
  - intros x [H _]. apply D, (above_minimum_is_positive r); lra.
  - intros x [H _]. apply (above_minimum_is_positive r x Hr) in H.
    apply derivable_continuous_pt. exists (ln x + / x - 1). apply is_derive_Reals, D. exact H.
  - change (0 <= (r - 1) * u r). assert (u 1 = 0) by (unfold u; rewrite ln_1; ring).
    replace (u r) with ((ln c + / c - 1) * (r - 1)) by lra.
    assert (Hc0 := above_minimum_is_positive r c Hr (proj1 Hc)).
    assert (L := ln_at_least c Hc0). replace ((r - 1) * ((ln c + / c - 1) * (r - 1))) with ((ln c + / c - 1) * (r - 1) ^ 2) by ring.
    apply Rmult_le_pos; [lra|apply pow2_ge_0].
Qed.

Lemma square_below_divergence : forall r, 0 < r -> 3 * (r - 1) ^ 2 <= (4 + 2 * r) * (r * ln r - r + 1).
Proof.
  intros r Hr. set (f := fun r => (4 + 2 * r) * (r * ln r - r + 1) - 3 * (r - 1) ^ 2).
  assert (D : forall c, 0 < c -> is_derive f c (4 * ((c + 1) * ln c - 2 * (c - 1)))).
  { intros c Hc. unfold f. auto_derive; [exact Hc|]. field. lra. }
  destruct (MVT_gen f 1 r (fun c => 4 * ((c + 1) * ln c - 2 * (c - 1)))) as [c [Hc E]].
  - intros x [H _]. apply D, (above_minimum_is_positive r); lra.
  - intros x [H _]. apply (above_minimum_is_positive r x Hr) in H.
    apply derivable_continuous_pt. exists (4 * ((x + 1) * ln x - 2 * (x - 1))). apply is_derive_Reals, D. exact H.
  - assert (f 1 = 0) by (unfold f; rewrite ln_1; ring).
    enough (0 <= f r) by (unfold f in *; lra).
    replace (f r) with (4 * ((c + 1) * ln c - 2 * (c - 1)) * (r - 1)) by lra.
    assert (S := sign_of_slope c (above_minimum_is_positive r c Hr (proj1 Hc))). set (v := (c + 1) * ln c - 2 * (c - 1)) in *.
    destruct (Rtotal_order c 1) as [L|[L|L]].
    + assert (r < 1) by (destruct (Rlt_dec r 1); [assumption|rewrite Rmin_left in Hc by lra; lra]). nra.
    + replace v with 0 by (unfold v; rewrite L, ln_1; ring). lra.
    + assert (1 < r) by (destruct (Rlt_dec 1 r); [assumption|rewrite Rmax_left in Hc by lra; lra]). nra.
Qed.

(* With a factor l to choose: |r - 1| <= l (4 + 2 r) / 6 + (r ln r - r + 1) / (2 l). *)
Lemma deviation_below_divergence : forall r l, 0 <= r -> 0 < l ->
  Rabs (r - 1) <= l * (2 + r) / 3 + (xlog2 r 1 * ln 2 - r + 1) / (2 * l).
Proof.
  intros r l [Hr|<-] Hl; assert (L2 := ln_2_positive).
  - rewrite xlog2_nonzero by lra. replace (r * log2 (r / 1) * ln 2) with (r * ln r).
    2: { unfold log2. replace (r / 1) with r by field. field. lra. }
    assert (S := square_below_divergence r Hr). set (h := r * ln r - r + 1) in *.
    set (d := Rabs (r - 1)). assert (Ed : d ^ 2 = (r - 1) ^ 2) by apply pow2_abs.
    assert (0 <= (2 * l * (2 + r) - 3 * d) ^ 2) by apply pow2_ge_0.
    apply (Rmult_le_reg_r (6 * l * (2 + r))); [nra|].
    replace ((l * (2 + r) / 3 + h / (2 * l)) * (6 * l * (2 + r))) with
      (2 * l ^ 2 * (2 + r) ^ 2 + 3 * (2 + r) * h) by (field; lra). nra.
  - rewrite xlog2_0. replace (Rabs (0 - 1)) with 1 by (rewrite Rabs_left; lra).
    apply (Rmult_le_reg_r (6 * l)); [lra|].
    replace ((l * (2 + 0) / 3 + (0 * ln 2 - 0 + 1) / (2 * l)) * (6 * l)) with (4 * l ^ 2 + 3) by (field; lra).
    assert (0 <= (2 * l - 3 / 2) ^ 2) by apply pow2_ge_0. nra.
Qed.

(* ---- The parts ---- *)

Section Parts.
Variables (m : nat) (weight probability receiver : R) (part_weight part_probability : nat -> R).
Hypothesis some_weight : 0 < weight.
Hypothesis some_probability : 0 < probability.
Hypothesis some_receiver : 0 < receiver.
Hypothesis part_weight_nonneg : forall k, (k < m)%nat -> 0 <= part_weight k.
Hypothesis part_probability_nonneg : forall k, (k < m)%nat -> 0 <= part_probability k.
Hypothesis weights_add_up : sum m part_weight = weight.
Hypothesis parts_carry_all : sum m (fun k => part_weight k * part_probability k) = weight * probability.

(* The gain is 2 w P times the mean of r log r over the parts, r = P_kj / P_ij. *)
Lemma pair_gain_by_ratios :
  pair_gain m weight probability receiver part_weight part_probability =
  2 * probability * sum m (fun k => part_weight k * xlog2 (part_probability k / probability) 1).
Proof.
  rewrite receiver_weight_drops_out by (assumption || lra). unfold pair_gain_without_receiver.
  set (p := probability) in *. set (c := log2 p).
  assert (X : forall x, 0 <= x -> xlog2 x 1 = p * xlog2 (x / p) 1 + x * c).
  { intros x [Hx|<-].
    - assert (0 < x / p) by now apply Rdiv_lt_0_compat.
      rewrite !xlog2_nonzero by lra. unfold c. replace (x / 1) with x by field.
      replace (x / p / 1) with (x / p) by (field; unfold p in *; lra).
      rewrite log2_div by assumption. field. unfold p in *; lra.
    - replace (0 / p) with 0 by (field; unfold p in *; lra). rewrite !xlog2_0. ring. }
  rewrite (sum_ext m _ (fun k => p * (part_weight k * xlog2 (part_probability k / p) 1)
    + part_weight k * part_probability k * c)).
  - rewrite sum_plus, sum_scale, sum_scale_right, parts_carry_all.
    rewrite (xlog2_nonzero p 1) by (unfold p in *; lra). replace (p / 1) with p by field. fold c. ring.
  - intros k Hk. rewrite (X (part_probability k)) by auto. ring.
Qed.

(* Pinsker's inequality. *)
Theorem pair_gain_is_at_least_squared_gradient :
  weight * probability * relative_gradient m weight probability part_weight part_probability ^ 2 / ln 2
  <= pair_gain m weight probability receiver part_weight part_probability.
Proof.
  rewrite pair_gain_by_ratios. assert (L2 := ln_2_positive).
  set (g := relative_gradient m weight probability part_weight part_probability).
  set (D := sum m (fun k => part_weight k * xlog2 (part_probability k / probability) 1)).
  assert (Hg : weight * g = sum m (fun k => part_weight k * Rabs (part_probability k / probability - 1))).
  { unfold g, relative_gradient. replace (weight * (sum m (fun k => part_weight k * Rabs (part_probability k - probability)) / (weight * probability)))
      with (sum m (fun k => part_weight k * Rabs (part_probability k - probability)) * / probability) by (field; lra).
    rewrite <- sum_scale_right. apply sum_ext. intros k _.
    replace (part_probability k / probability - 1) with ((part_probability k - probability) * / probability) by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (/ probability)); [ring|]. left. now apply Rinv_0_lt_compat. }
  assert (Hg0 : 0 <= g).
  { apply (Rmult_le_reg_l weight); [exact some_weight|]. rewrite Rmult_0_r, Hg. apply sum_nonneg. intros k Hk.
    apply Rmult_le_pos; [auto|apply Rabs_pos]. }
  assert (Er : sum m (fun k => part_weight k * (part_probability k / probability)) = weight).
  { rewrite (sum_ext m _ (fun k => part_weight k * part_probability k * / probability)) by (intros; field; lra).
    rewrite sum_scale_right, parts_carry_all. field. lra. }
  assert (B : forall l, 0 < l -> weight * g <= weight * l + D * ln 2 / (2 * l)).
  { intros l Hl. rewrite Hg.
    apply Rle_trans with (sum m (fun k => part_weight k * (l * (2 + part_probability k / probability) / 3 +
      (xlog2 (part_probability k / probability) 1 * ln 2 - part_probability k / probability + 1) / (2 * l)))).
    - apply sum_le. intros k Hk. apply Rmult_le_compat_l; [auto|]. apply deviation_below_divergence; [|exact Hl].
      apply Rmult_le_pos; [auto|]. left. now apply Rinv_0_lt_compat.
    - right. rewrite (sum_ext m _ (fun k => part_weight k * (2 * l / 3 + 1 / (2 * l)) +
        (part_weight k * (part_probability k / probability) * (l / 3 - 1 / (2 * l)) +
         part_weight k * xlog2 (part_probability k / probability) 1 * (ln 2 / (2 * l))))) by (intros; field; lra).
      rewrite !sum_plus, !sum_scale_right, weights_add_up, Er. fold D. field. lra. }
  destruct Hg0 as [Hg0|<-].
  - assert (H := B (g / 2) ltac:(lra)).
    assert (Hw : weight * g ^ 2 <= 2 * (D * ln 2)).
    { apply (Rmult_le_compat_r (2 * g)) in H; [|lra].
      replace ((weight * (g / 2) + D * ln 2 / (2 * (g / 2))) * (2 * g)) with (weight * g ^ 2 + 2 * (D * ln 2)) in H by (field; lra).
      lra. }
    apply (Rmult_le_reg_r (ln 2)); [exact L2|].
    replace (weight * probability * g ^ 2 / ln 2 * ln 2) with (probability * (weight * g ^ 2)) by (field; lra).
    replace (2 * probability * D * ln 2) with (probability * (2 * (D * ln 2))) by ring.
    apply Rmult_le_compat_l; lra.
  - replace (weight * probability * 0 ^ 2 / ln 2) with 0 by (field; lra).
    assert (H := log_sum_inequality m (fun k => part_weight k * (part_probability k / probability)) (fun k => part_weight k * 1)).
    cbv beta in H. rewrite Er in H. rewrite sum_scale_right, weights_add_up in H.
    rewrite (sum_ext m (fun k => xlog2 (part_weight k * (part_probability k / probability)) (part_weight k * 1))
      (fun k => part_weight k * xlog2 (part_probability k / probability) 1)) in H by (intros; apply xlog2_scale). fold D in H.
    rewrite xlog2_nonzero in H by lra. replace (weight / (weight * 1)) with 1 in H by (field; lra). rewrite log2_1 in H.
    assert (0 <= D).
    { rewrite Rmult_0_r in H. apply H.
      - intros k Hk. apply Rmult_le_pos; [auto|]. apply Rmult_le_pos; [auto|]. left. now apply Rinv_0_lt_compat.
      - intros k Hk. rewrite Rmult_1_r. auto.
      - intros k Hk E. rewrite Rmult_1_r in E. rewrite E. ring. }
    nra.
Qed.
End Parts.

(* Halves with form factors F (1 + g) and F (1 - g) have the gradient g. *)
Theorem gradient_of_halves : forall weight F g, 0 < weight -> 0 < F -> 0 <= g ->
  relative_gradient 2 weight F (fun _ => weight / 2) (fun k => match k with O => F * (1 + g) | _ => F * (1 - g) end) = g.
Proof.
  intros w F g Hw HF Hg. assert (0 <= F * g) by (apply Rmult_le_pos; lra). unfold relative_gradient. simpl.
  replace (F * (1 + g) - F) with (F * g) by ring. replace (F * (1 - g) - F) with (- (F * g)) by ring.
  rewrite Rabs_Ropp, Rabs_pos_eq by assumption. field. lra.
Qed.

(* ---- The gain grows with the gradient ---- *)

(* Part k has the form factor F (1 + t d_k), the d_k cancelling out over the parts: the larger t, the larger the gain. *)
Theorem larger_gradient_of_any_parts_gains_more :
  forall m weight F receiver part_weight direction s t,
  0 < weight -> 0 < F -> 0 < receiver -> (forall k, (k < m)%nat -> 0 <= part_weight k) -> sum m part_weight = weight ->
  sum m (fun k => part_weight k * direction k) = 0 ->
  (exists k, (k < m)%nat /\ 0 < part_weight k /\ direction k <> 0) ->
  0 <= s -> s < t -> (forall k, (k < m)%nat -> 0 <= 1 + t * direction k) ->
  pair_gain m weight F receiver part_weight (fun k => F * (1 + s * direction k))
  < pair_gain m weight F receiver part_weight (fun k => F * (1 + t * direction k)).
Proof.
  intros m w F r v d s t Hw HF Hr Hv Ev Ed [k0 [Hk0 [Hv0 Hd0]]] Hs Hst Ht.
  assert (Hq : 0 <= s / t < 1).
  { split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
    apply (Rmult_lt_reg_r t); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Hs' : forall k, (k < m)%nat -> 0 <= 1 + s * d k).
  { intros k Hk. specialize (Ht k Hk). replace (1 + s * d k) with (s / t * (1 + t * d k) + (1 - s / t)) by (field; lra).
    assert (0 <= s / t * (1 + t * d k)) by (apply Rmult_le_pos; lra). lra. }
  assert (C : forall x, sum m (fun k => v k * (F * (1 + x * d k))) = w * F).
  { intros x. rewrite (sum_ext m _ (fun k => v k * F + v k * d k * (F * x))) by (intros; ring).
    rewrite sum_plus, !sum_scale_right, Ev, Ed. ring. }
  assert (N : forall x, (forall k, (k < m)%nat -> 0 <= 1 + x * d k) -> forall k, (k < m)%nat -> 0 <= F * (1 + x * d k))
    by (intros x H k Hk; apply Rmult_le_pos; [lra|auto]).
  set (G := fun x => sum m (fun k => v k * xlog2 (1 + x * d k) 1)).
  assert (E : forall x, (forall k, (k < m)%nat -> 0 <= 1 + x * d k) ->
    pair_gain m w F r v (fun k => F * (1 + x * d k)) = 2 * F * G x).
  { intros x Hx. rewrite (pair_gain_by_ratios m w F r v) by (auto || apply N; auto). unfold G. f_equal.
    apply sum_ext. intros k _. replace (F * (1 + x * d k) / F) with (1 + x * d k) by (field; lra). reflexivity. }
  rewrite (E s Hs'), (E t Ht).
  assert (P : 0 < 2 * F * G t).
  { rewrite <- (E t Ht).
    apply Rlt_le_trans with (2 := pair_gain_is_at_least_squared_gradient m w F r v (fun k => F * (1 + t * d k))
      Hw HF Hr Hv (N t Ht) Ev (C t)).
    assert (L2 := ln_2_positive). apply Rdiv_lt_0_compat; [|exact L2].
    apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat|]. apply pow_lt. unfold relative_gradient.
    apply Rdiv_lt_0_compat; [|now apply Rmult_lt_0_compat].
    apply Rlt_le_trans with (v k0 * Rabs (F * (1 + t * d k0) - F)).
    - apply Rmult_lt_0_compat; [exact Hv0|]. apply Rabs_pos_lt.
      replace (F * (1 + t * d k0) - F) with (F * (t * d k0)) by ring.
      repeat apply Rmult_integral_contrapositive_currified; lra.
    - apply (term_le_sum m (fun k => v k * Rabs (F * (1 + t * d k) - F))); [|exact Hk0].
      intros k Hk. apply Rmult_le_pos; [auto|apply Rabs_pos]. }
  assert (L : G s <= s / t * G t).
  { unfold G. rewrite <- sum_scale. apply sum_le. intros k Hk.
    replace (s / t * (v k * xlog2 (1 + t * d k) 1)) with (v k * (s / t * xlog2 (1 + t * d k) 1)) by ring.
    apply Rmult_le_compat_l; [auto|].
    destruct (xlogx_below_chord_of_two_points (1 + t * d k) 1 (s / t)) as [B _]; [auto|lra|lra|].
    replace (s / t * (1 + t * d k) + (1 - s / t) * 1) with (1 + s * d k) in B by (field; lra).
    rewrite (xlog2_nonzero 1 1) in B by lra. replace (1 / 1) with 1 in B by field. rewrite log2_1 in B. lra. }
  assert (0 < G t) by (apply (Rmult_lt_reg_l (2 * F)); lra).
  apply Rmult_lt_compat_l; [lra|]. apply Rle_lt_trans with (1 := L).
  rewrite <- (Rmult_1_l (G t)) at 2. apply Rmult_lt_compat_r; lra.
Qed.

(* Control: of two divisions that differ in their parts, the one with the larger gradient may gain less. Halves with form
   factors 1.9 and 0.1, and an eighth with 4.52 beside seven eighths. *)
Theorem larger_gradient_of_other_parts_may_gain_less : exists v q v' q' : nat -> R,
  (forall k, (k < 2)%nat -> 0 < v k /\ 0 < q k /\ 0 < v' k /\ 0 < q' k) /\
  sum 2 v = 1 /\ sum 2 v' = 1 /\ sum 2 (fun k => v k * q k) = 1 /\ sum 2 (fun k => v' k * q' k) = 1 /\
  relative_gradient 2 1 1 v' q' < relative_gradient 2 1 1 v q /\
  pair_gain 2 1 1 1 v q < pair_gain 2 1 1 1 v' q'.
Proof.
  exists (fun _ => 1 / 2), (fun k => match k with O => 19 / 10 | _ => 1 / 10 end),
    (fun k => match k with O => 1 / 8 | _ => 7 / 8 end), (fun k => match k with O => 452 / 100 | _ => 348 / 700 end).
  split; [intros [|k] _; lra|]. repeat split; try (simpl; lra).
  - unfold relative_gradient. simpl. repeat match goal with |- context [Rabs ?x] =>
      first [rewrite (Rabs_pos_eq x) by lra | rewrite (Rabs_left x) by lra] end. lra.
  - unfold pair_gain. simpl. rewrite !xlog2_nonzero by lra. unfold log2.
    assert (L2 := ln_2_positive). apply (Rmult_lt_reg_r (ln 2)); [exact L2|]. field_simplify; [|lra|lra].
    interval with (i_prec 60).
Qed.
