(* The gain (5) of a pair of patches when one is subdivided, and its bound (6) for regular subdivision: attained
   only by concentration on one part, and so not at all where that part would need a probability above one. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums LogSum.
Open Scope R_scope.

(* ---- Eq. (5) ---- *)

(* Patch i has weight [weight], and probability [probability] of going to j, whose weight is [receiver];
   part k of i has weight [part_weight k] and probability [part_probability k] of going to j. First line of (5). *)
Definition pair_gain (m : nat) (weight probability receiver : R)
    (part_weight part_probability : nat -> R) : R :=
  2 * (sum m (fun k => part_weight k * xlog2 (part_probability k) receiver)
       - weight * xlog2 probability receiver).

(* Second line of (5): w_j is left out, x log x being xlog2 x 1. *)
Definition pair_gain_without_receiver (m : nat) (weight probability : R)
    (part_weight part_probability : nat -> R) : R :=
  2 * (sum m (fun k => part_weight k * xlog2 (part_probability k) 1) - weight * xlog2 probability 1).

(* The parts of i carry all of w_i P_ij: w_i P_ij = w_j P_ji, which the parts cover, each being reciprocal. *)
Lemma joint_of_parts_from_reciprocity_and_cover :
  forall m weight probability receiver back part_weight part_probability part_back,
  weight * probability = receiver * back ->
  (forall k, (k < m)%nat -> part_weight k * part_probability k = receiver * part_back k) ->
  back = sum m part_back ->
  sum m (fun k => part_weight k * part_probability k) = weight * probability.
Proof.
  intros m w p r b v q b' H Hk Hb. rewrite H, Hb, <- sum_scale. now apply sum_ext.
Qed.

Lemma xlog2_receiver : forall x y, 0 <= x -> 0 < y -> xlog2 x y = xlog2 x 1 - x * log2 y.
Proof.
  intros x y Hx Hy. destruct (Req_dec x 0) as [->|H0]; [rewrite !xlog2_0; lra|].
  rewrite !xlog2_nonzero, !log2_div, log2_1 by lra. lra.
Qed.

(* The terms with log w_j cancel, since the parts carry all of w_i P_ij. *)
Theorem receiver_weight_drops_out : forall m weight probability receiver part_weight part_probability,
  0 <= probability -> 0 < receiver -> (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m (fun k => part_weight k * part_probability k) = weight * probability ->
  pair_gain m weight probability receiver part_weight part_probability =
  pair_gain_without_receiver m weight probability part_weight part_probability.
Proof.
  intros m w p r v q Hp Hr Hq C. unfold pair_gain, pair_gain_without_receiver.
  rewrite (sum_ext m _ (fun k => v k * xlog2 (q k) 1 - v k * q k * log2 r)).
  - rewrite sum_minus, sum_scale_right, C, (xlog2_receiver p r) by assumption. lra.
  - intros k Hk. rewrite (xlog2_receiver (q k) r) by auto. lra.
Qed.

(* With w_ik = w_i / m the factor w_i / m stands in front, and log w_j drops out. *)
Theorem pair_gain_of_regular_subdivision : forall m weight probability receiver part_probability,
  (1 <= m)%nat -> 0 <= probability -> 0 < receiver -> (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m (fun k => weight / INR m * part_probability k) = weight * probability ->
  pair_gain m weight probability receiver (fun _ => weight / INR m) part_probability =
  2 * (weight / INR m * sum m (fun k => xlog2 (part_probability k) 1) - weight * xlog2 probability 1).
Proof.
  intros m w p r q Hm Hp Hr Hq C. rewrite receiver_weight_drops_out by assumption.
  unfold pair_gain_without_receiver. now rewrite sum_scale.
Qed.

(* The gain of a pair is not negative: the log-sum inequality with a_k = v_k P_kj, b_k = v_k w_j. *)
Theorem pair_gain_nonneg : forall m weight probability receiver part_weight part_probability,
  0 <= receiver -> (forall k, (k < m)%nat -> 0 <= part_weight k) ->
  (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  (receiver = 0 -> weight * probability = 0) ->
  weight = sum m part_weight ->
  sum m (fun k => part_weight k * part_probability k) = weight * probability ->
  0 <= pair_gain m weight probability receiver part_weight part_probability.
Proof.
  intros m w p r v q Hr Hv Hq H0 Hw C.
  assert (Hvq : forall k, (k < m)%nat -> 0 <= v k * q k) by (intros; apply Rmult_le_pos; auto).
  assert (L := log_sum_inequality m (fun k => v k * q k) (fun k => v k * r) Hvq).
  cbv beta in L. rewrite sum_scale_right, <- Hw, C, xlog2_scale in L.
  rewrite (sum_ext m (fun k => xlog2 (v k * q k) (v k * r)) (fun k => v k * xlog2 (q k) r)) in L
    by (intros; apply xlog2_scale).
  unfold pair_gain. enough (w * xlog2 p r <= sum m (fun k => v k * xlog2 (q k) r)) by lra.
  apply L.
  - intros k Hk. apply Rmult_le_pos; auto.
  - intros k Hk E. apply Rmult_integral in E. destruct E as [E|E]; [rewrite E; lra|].
    apply (sum_nonneg_zero m (fun k => v k * q k)); auto. rewrite C. auto.
Qed.

(* ---- Eq. (6): regular subdivision ---- *)

Section RegularSubdivision.
Variables (m : nat) (weight probability receiver : R) (part_probability : nat -> R).
Hypothesis some_part : (1 <= m)%nat.
Hypothesis weight_positive : 0 < weight.
Hypothesis probability_nonneg : 0 <= probability.
Hypothesis receiver_positive : 0 < receiver.
Hypothesis part_probability_nonneg : forall k, (k < m)%nat -> 0 <= part_probability k.
(* w_ik = w_i / m, and the parts carry all of w_i P_ij. *)
Hypothesis parts_carry_all :
  sum m (fun k => weight / INR m * part_probability k) = weight * probability.

Definition regular_gain : R :=
  pair_gain m weight probability receiver (fun _ => weight / INR m) part_probability.

Lemma part_count_positive : 0 < INR m.
Proof. apply lt_0_INR. lia. Qed.

Lemma part_probabilities_sum : sum m part_probability = INR m * probability.
Proof.
  assert (H := part_count_positive). assert (E := parts_carry_all). rewrite sum_scale in E.
  apply (Rmult_eq_reg_l (weight / INR m)).
  - rewrite E. field. lra.
  - assert (0 < weight / INR m) by now apply Rdiv_lt_0_compat. lra.
Qed.

Lemma part_probability_at_most_all : forall k, (k < m)%nat -> part_probability k <= INR m * probability.
Proof. intros. rewrite <- part_probabilities_sum. now apply term_le_sum. Qed.

(* The one part that is not null has m P_ij. *)
Theorem only_nonnull_part_has_m_times_probability : forall k, (k < m)%nat ->
  (forall l, (l < m)%nat -> l <> k -> part_probability l = 0) ->
  part_probability k = INR m * probability.
Proof.
  intros k Hk H. rewrite <- part_probabilities_sum, <- (sum_single m k part_probability Hk).
  apply sum_ext. intros l Hl. destruct (Nat.eqb_spec l k); [reflexivity|]. symmetry. auto.
Qed.

(* x log x <= x log M for 0 <= x <= M, with equality only at 0 and M. *)
Lemma xlogx_below_chord : forall x M, 0 <= x <= M -> 0 < M ->
  xlog2 x 1 <= x * log2 M /\ (xlog2 x 1 = x * log2 M -> x = 0 \/ x = M).
Proof.
  intros x M [Hx HM] HM0. destruct (Req_dec x 0) as [->|H0]; [rewrite xlog2_0; split; [lra|auto]|].
  rewrite xlog2_nonzero by assumption. replace (x / 1) with x by field.
  destruct (Req_dec x M) as [->|H1]; [split; [lra|auto]|].
  assert (log2 x < log2 M) by (apply log2_increasing; lra).
  assert (x * log2 x < x * log2 M) by (apply Rmult_lt_compat_l; lra). split; [lra|intros; lra].
Qed.

(* The gap to the bound is a sum of terms, none negative. *)
Lemma gap_to_bound : 0 < probability ->
  2 * weight * probability * log2 (INR m) - regular_gain =
  2 * (weight / INR m) * sum m (fun k =>
    part_probability k * log2 (INR m * probability) - xlog2 (part_probability k) 1).
Proof.
  intros Hp. assert (Hm := part_count_positive). unfold regular_gain.
  rewrite receiver_weight_drops_out by assumption. unfold pair_gain_without_receiver.
  rewrite sum_scale, sum_minus, sum_scale_right, part_probabilities_sum, log2_mult by assumption.
  rewrite (xlog2_nonzero probability 1) by lra. replace (probability / 1) with probability by field.
  field. lra.
Qed.

Lemma gap_terms_nonneg : 0 < probability -> forall k, (k < m)%nat ->
  0 <= part_probability k * log2 (INR m * probability) - xlog2 (part_probability k) 1.
Proof.
  intros Hp k Hk. assert (Hm := part_count_positive).
  assert (H := proj1 (xlogx_below_chord (part_probability k) (INR m * probability)
    (conj (part_probability_nonneg k Hk) (part_probability_at_most_all k Hk))
    (Rmult_lt_0_compat _ _ Hm Hp))). lra.
Qed.

Lemma null_pair_gains_nothing : probability = 0 -> regular_gain = 0.
Proof.
  intros E. unfold regular_gain, pair_gain. rewrite E, xlog2_0, sum_zero; [lra|].
  intros k Hk. assert (H := part_probability_at_most_all k Hk). rewrite E in H.
  assert (0 <= part_probability k) by auto.
  replace (part_probability k) with 0 by lra. rewrite xlog2_0. lra.
Qed.

(* Eq. (6), the bound. *)
Theorem regular_gain_at_most : regular_gain <= 2 * weight * probability * log2 (INR m).
Proof.
  destruct (Req_dec probability 0) as [E|E]; [rewrite null_pair_gains_nothing, E; lra|].
  assert (Hp : 0 < probability) by lra. assert (Hm := part_count_positive).
  assert (G := gap_to_bound Hp). assert (H := sum_nonneg _ _ (gap_terms_nonneg Hp)).
  assert (0 < weight / INR m) by now apply Rdiv_lt_0_compat.
  assert (0 <= 2 * (weight / INR m) * sum m (fun k =>
    part_probability k * log2 (INR m * probability) - xlog2 (part_probability k) 1))
    by (apply Rmult_le_pos; lra). lra.
Qed.

(* It is attained exactly when one part has all. *)
Theorem regular_gain_attained_iff_concentrated : 0 < probability ->
  regular_gain = 2 * weight * probability * log2 (INR m) <->
  exists k, (k < m)%nat /\ part_probability k = INR m * probability /\
    forall l, (l < m)%nat -> l <> k -> part_probability l = 0.
Proof.
  intros Hp. assert (Hm := part_count_positive). assert (G := gap_to_bound Hp).
  assert (Hall : 0 < INR m * probability) by now apply Rmult_lt_0_compat.
  assert (0 < weight / INR m) by now apply Rdiv_lt_0_compat. split.
  - intros E.
    assert (Z : forall k, (k < m)%nat -> part_probability k = 0 \/ part_probability k = INR m * probability).
    { intros k Hk. apply (xlogx_below_chord (part_probability k) (INR m * probability)); auto.
      - split; [auto|now apply part_probability_at_most_all].
      - symmetry. apply Rminus_diag_uniq. revert k Hk. apply sum_nonneg_zero.
        + now apply gap_terms_nonneg.
        + apply (Rmult_eq_reg_l (2 * (weight / INR m))); lra. }
    (* some part is not null, for otherwise they would not sum to m P_ij; it has m P_ij and leaves nothing *)
    assert (D : (forall k, (k < m)%nat -> part_probability k = 0) \/
                exists k, (k < m)%nat /\ part_probability k <> 0).
    { clear - m. induction m as [|n IH]; [left; lia|].
      destruct IH as [A|[k [Hk A]]]; [|right; exists k; split; [lia|exact A]].
      destruct (Req_dec (part_probability n) 0) as [B|B]; [left|right; exists n; split; [lia|exact B]].
      intros k Hk. destruct (Nat.eq_dec k n) as [->|]; [exact B|]. apply A. lia. }
    destruct D as [A|[k [Hk A]]].
    + assert (S := part_probabilities_sum). rewrite sum_zero in S by assumption. lra.
    + exists k. destruct (Z k Hk) as [B|B]; [contradiction|]. split; [exact Hk|split; [exact B|]].
      intros l Hl Hlk.
      assert (S := part_probabilities_sum).
      assert (R0 : sum m (fun l => if Nat.eqb l k then 0 else part_probability l) = 0).
      { assert (S1 := sum_single m k part_probability Hk).
        transitivity (sum m part_probability - sum m (fun j => if Nat.eqb j k then part_probability j else 0));
          [|lra].
        rewrite <- sum_minus. apply sum_ext. intros j _. destruct (Nat.eqb j k); lra. }
      assert (R1 := sum_nonneg_zero m (fun l => if Nat.eqb l k then 0 else part_probability l)).
      cbv beta in R1. specialize (R1 ltac:(intros j Hj; destruct (Nat.eqb j k); [lra|auto]) R0 l Hl).
      destruct (Nat.eqb_spec l k); [contradiction|exact R1].
  - intros [k [Hk [E Z]]]. apply Rminus_diag_uniq_sym. rewrite G, sum_zero; [lra|].
    intros l Hl. destruct (Nat.eq_dec l k) as [->|Hlk].
    + rewrite E, xlog2_nonzero by lra. replace (INR m * probability / 1) with (INR m * probability) by field. lra.
    + rewrite Z, xlog2_0 by assumption. lra.
Qed.

(* Eq. (6), as the paper words it: the maximum is attained when all parts but one are null. *)
Theorem regular_gain_attained : forall k, (k < m)%nat ->
  (forall l, (l < m)%nat -> l <> k -> part_probability l = 0) ->
  regular_gain = 2 * weight * probability * log2 (INR m).
Proof.
  intros k Hk Z. destruct (Req_dec probability 0) as [E|E].
  - rewrite null_pair_gains_nothing, E; lra.
  - apply regular_gain_attained_iff_concentrated; [lra|]. exists k.
    auto using only_nonnull_part_has_m_times_probability.
Qed.

(* The bound is "theoretical": where m P_ij > 1 no part can have it, and the gain stays below. *)
Theorem regular_gain_below_where_m_times_probability_exceeds_one :
  (forall k, (k < m)%nat -> part_probability k <= 1) -> 1 < INR m * probability ->
  regular_gain < 2 * weight * probability * log2 (INR m).
Proof.
  intros H1 Hmp. assert (Hm := part_count_positive).
  assert (Hp : 0 < probability) by (destruct (Req_dec probability 0) as [E|]; [rewrite E in Hmp|]; lra).
  destruct regular_gain_at_most as [H|H]; [exact H|exfalso].
  apply regular_gain_attained_iff_concentrated in H; [|exact Hp].
  destruct H as [k [Hk [E _]]]. specialize (H1 k Hk). lra.
Qed.

(* There the gain is at most - 2 w_i P_ij log P_ij, since no term P log P of a part is positive. *)
Theorem regular_gain_at_most_entropy_term :
  (forall k, (k < m)%nat -> part_probability k <= 1) ->
  regular_gain <= - (2 * weight * xlog2 probability 1).
Proof.
  intros H1. assert (Hm := part_count_positive). unfold regular_gain.
  rewrite receiver_weight_drops_out by assumption. unfold pair_gain_without_receiver.
  assert (sum m (fun k => weight / INR m * xlog2 (part_probability k) 1) <= 0); [|lra].
  rewrite <- (sum_zero m (fun _ => 0)) by auto. apply sum_le. intros k Hk.
  assert (0 < weight / INR m) by now apply Rdiv_lt_0_compat.
  assert (X : xlog2 (part_probability k) 1 <= part_probability k * log2 1).
  { apply xlogx_below_chord; [split; auto|lra]. }
  rewrite log2_1 in X. nra.
Qed.
End RegularSubdivision.

(* The bound (6) summed over all j: 2 w_i log m, when the row of i sums to one. *)
Theorem bound_summed_over_receivers : forall n m weight probability,
  sum n probability = 1 ->
  sum n (fun j => 2 * weight * probability j * log2 (INR m)) = 2 * weight * log2 (INR m).
Proof.
  intros n m w p H. rewrite sum_scale_right, sum_scale, H. lra.
Qed.
