(* The gain of a cut, as fig. 2 and fig. 3 use it, is the gain (5), (7) of a pair of patches for two parts. *)
From Coq Require Import Reals Lra Lia.
From Infoscene Require Import Sums Information FiniteSums LogSum PairGain CutGain.
Open Scope R_scope.

(* One of the two numbers, by the label of the part. *)
Definition of_two_parts (first second : R) (k : nat) : R := match k with O => first | _ => second end.

(* A F log F = J log (J / A), where J = A F. *)
Lemma weighted_form_factor_term (total_area area flux : R) : 0 < total_area -> 0 < area -> 0 <= flux ->
  area / total_area * xlog2 (flux / area) 1 = xlog2 flux area / total_area.
Proof.
  intros HT HA HF. destruct (Req_dec flux 0) as [->|N].
  - replace (0 / area) with 0 by (field; lra). rewrite !xlog2_0. field. lra.
  - assert (0 < flux / area) by (apply Rdiv_lt_0_compat; lra).
    rewrite !xlog2_nonzero by lra. replace (flux / area / 1) with (flux / area) by (field; lra). field. lra.
Qed.

(* Weights w = A / A_T, probabilities P = F = (exchange area) / A; the receiver j may have any weight. *)
Theorem cut_gain_is_pair_gain_of_two_parts (total_area area flux part_area part_flux receiver : R) :
  0 < total_area -> 0 < part_area < area -> 0 <= part_flux <= flux -> 0 < receiver ->
  cut_gain total_area area flux part_area part_flux
  = pair_gain 2 (area / total_area) (flux / area) receiver
      (of_two_parts (part_area / total_area) ((area - part_area) / total_area))
      (of_two_parts (part_flux / part_area) ((flux - part_flux) / (area - part_area))).
Proof.
  intros HT HA HF Hr. rewrite receiver_weight_drops_out; trivial.
  - unfold pair_gain_without_receiver, of_two_parts, cut_gain. simpl.
    rewrite !weighted_form_factor_term by lra. field. lra.
  - apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra].
  - intros [|k] _; simpl; (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra]).
  - simpl. field. lra.
Qed.
