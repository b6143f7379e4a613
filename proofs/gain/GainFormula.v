(* The gain of a refinement, eqs. (10) and (11): twice the pair gains of eq. (5) and one self term, which is null
   for planar patches; and the bound 2 w_i log m on the whole gain of a regular subdivision, with or without it. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement StateRefinement Theorem1 PairGain.
Open Scope R_scope.

(* ---- Eq. (10) ---- *)

(* A symmetric double sum is twice its upper triangle and its diagonal. *)
Lemma symmetric_double_sum : forall n f, (forall i j, (i < n)%nat -> (j < n)%nat -> f i j = f j i) ->
  sum n (fun i => sum n (fun j => f i j)) =
  2 * sum n (fun j => sum j (fun i => f i j)) + sum n (fun i => f i i).
Proof.
  induction n as [|n IH]; intros f H; simpl; [lra|].
  rewrite sum_plus, IH by auto with arith.
  rewrite (sum_ext n (fun j => f n j) (fun j => f j n)) by (intros; apply H; lia). lra.
Qed.

Lemma information_terms_symmetric : forall n w P, reciprocal n w P ->
  forall i j, (i < n)%nat -> (j < n)%nat -> w i * xlog2 (P i j) (w j) = w j * xlog2 (P j i) (w i).
Proof.
  intros n w P K i j Hi Hj. rewrite <- !xlog2_scale, (Rmult_comm (w j) (w i)). f_equal. now apply K.
Qed.

(* Eq. (10): I = 2 sum over i < j + sum over i = j. *)
Theorem mutual_information_of_upper_triangle : forall n w P, reciprocal n w P ->
  mutual_information n w P =
  2 * sum n (fun j => sum j (fun i => w i * xlog2 (P i j) (w j))) +
  sum n (fun i => w i * xlog2 (P i i) (w i)).
Proof.
  intros n w P K. unfold mutual_information.
  apply (symmetric_double_sum n (fun i j => w i * xlog2 (P i j) (w j))).
  now apply information_terms_symmetric.
Qed.

(* ---- Eq. (11) ---- *)

Lemma sum_others_plus : forall n s f g,
  sum_others n s (fun j => f j + g j) = sum_others n s f + sum_others n s g.
Proof.
  intros. unfold sum_others. rewrite <- sum_plus. apply sum_ext. intros j _. destruct (Nat.eqb j s); lra.
Qed.

(* A symmetric double sum, split at state s, and over the refined labels at its sub-states. *)
Lemma symmetric_sum_split : forall n s f, (s < n)%nat ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> f i j = f j i) ->
  sum n (fun i => sum n (fun j => f i j)) =
  sum_others n s (fun i => sum_others n s (fun j => f i j)) +
  2 * sum_others n s (fun j => f s j) + f s s.
Proof.
  intros n s f Hs H. rewrite (sum_others_and_state n s) by assumption.
  rewrite (sum_others_and_state n s (fun j => f s j)) by assumption.
  rewrite (sum_others_ext n s _ (fun i => sum_others n s (fun j => f i j) + f s i)).
  - rewrite (sum_others_plus n s (fun i => sum_others n s (fun j => f i j)) (fun i => f s i)). lra.
  - intros i Hi _. rewrite (H s i) by assumption. now apply sum_others_and_state.
Qed.

Lemma symmetric_sum_split_refined : forall n s m f, (s < n)%nat -> (1 <= m)%nat ->
  (forall i j, (i < n - 1 + m)%nat -> (j < n - 1 + m)%nat -> f i j = f j i) ->
  sum (n - 1 + m) (fun i => sum (n - 1 + m) (fun j => f i j)) =
  sum_others n s (fun i => sum_others n s (fun j => f i j)) +
  2 * sum_others n s (fun j => sum m (fun k => f (substate n s k) j)) +
  sum m (fun k => sum m (fun l => f (substate n s k) (substate n s l))).
Proof.
  intros n s m f Hs Hm H. destruct m as [|q]; [lia|].
  assert (Hsub := fun k => substate_below n (S q) s k Hs).
  replace (n - 1 + S q)%nat with (n + q)%nat in * by lia.
  rewrite (sum_others_and_substates n q s) by assumption.
  rewrite (sum_others_ext n s _ (fun i => sum_others n s (fun j => f i j) +
    sum (S q) (fun k => f (substate n s k) i))).
  2: { intros i Hi _. rewrite (sum_others_and_substates n q s) by assumption. f_equal.
       apply sum_ext. intros k Hk. apply H; [lia|auto]. }
  rewrite (sum_ext (S q) _ (fun k => sum_others n s (fun j => f (substate n s k) j) +
    sum (S q) (fun l => f (substate n s k) (substate n s l))))
    by (intros; now apply sum_others_and_substates).
  rewrite sum_others_plus, sum_plus.
  replace (sum (S q) (fun k => sum_others n s (fun j => f (substate n s k) j)))
    with (sum_others n s (fun j => sum (S q) (fun k => f (substate n s k) j))); [lra|].
  unfold sum_others. rewrite sum_exchange. apply sum_ext. intros j _.
  destruct (Nat.eqb j s); [symmetry; now apply sum_zero|reflexivity].
Qed.

Section Gain.
Variables (n s m : nat).
Variables (w : nat -> R) (P : nat -> nat -> R) (w' : nat -> R) (P' : nat -> nat -> R).
Hypothesis coarse : markov_chain n w P.
Hypothesis coarse_reciprocal : reciprocal n w P.
Hypothesis refined : markov_chain (n - 1 + m) w' P'.
Hypothesis refinement : refines_state n s m w P w' P'.

(* The pair gain (5) of s and another state j. *)
Definition gain_with (j : nat) : R :=
  pair_gain m (w s) (P s j) (w j) (fun k => w' (substate n s k)) (fun k => P' (substate n s k) j).

(* The second line of (11). *)
Definition self_gain : R :=
  sum m (fun k => sum m (fun l => w' (substate n s k) *
    xlog2 (P' (substate n s k) (substate n s l)) (w' (substate n s l)))) - w s * xlog2 (P s s) (w s).

(* Eq. (11): the terms between other states are the same before and after. *)
Theorem gain_is_pair_gains_and_self_gain :
  mutual_information (n - 1 + m) w' P' - mutual_information n w P =
  sum_others n s gain_with + self_gain.
Proof.
  assert (Hs := state_below _ _ _ _ _ _ _ refinement).
  assert (Hm := some_substate _ _ _ _ _ _ _ refinement).
  assert (K := refined_chain_is_reciprocal n s m w P w' P' coarse_reciprocal refinement).
  unfold mutual_information.
  rewrite (symmetric_sum_split n s (fun i j => w i * xlog2 (P i j) (w j))) by
    (try assumption; now apply information_terms_symmetric).
  rewrite (symmetric_sum_split_refined n s m (fun i j => w' i * xlog2 (P' i j) (w' j))) by
    (try assumption; now apply information_terms_symmetric).
  rewrite (sum_others_ext n s
    (fun i => sum_others n s (fun j => w' i * xlog2 (P' i j) (w' j)))
    (fun i => sum_others n s (fun j => w i * xlog2 (P i j) (w j)))).
  2: { intros i Hi His. apply sum_others_ext. intros j Hj Hjs.
       now rewrite !(other_weight _ _ _ _ _ _ _ refinement), (other_transition _ _ _ _ _ _ _ refinement). }
  rewrite (sum_others_ext n s gain_with (fun j =>
    2 * sum m (fun k => w' (substate n s k) * xlog2 (P' (substate n s k) j) (w' j)) +
    (-2) * (w s * xlog2 (P s j) (w j)))).
  - rewrite sum_others_plus, !sum_others_scale. unfold self_gain. lra.
  - intros j Hj Hjs. unfold gain_with, pair_gain.
    rewrite (other_weight _ _ _ _ _ _ _ refinement) by assumption. lra.
Qed.

(* The parts carry all of w_s P_sj, as eq. (5) needs. *)
Lemma substates_carry_all : forall j, (j < n)%nat -> j <> s ->
  sum m (fun k => w' (substate n s k) * P' (substate n s k) j) = w s * P s j.
Proof.
  intros j Hj Hjs. symmetry.
  exact (joint_with_other_state n s m w P w' P' coarse_reciprocal refinement j Hj Hjs).
Qed.

Lemma substate_weight_nonneg : forall k, (k < m)%nat -> 0 <= w' (substate n s k).
Proof.
  intros k Hk. apply (weight_nonneg _ _ _ refined), substate_below; [|exact Hk].
  exact (state_below _ _ _ _ _ _ _ refinement).
Qed.

Lemma substate_transition_nonneg : forall k j, (k < m)%nat -> (j < n - 1 + m)%nat ->
  0 <= P' (substate n s k) j.
Proof.
  intros k j Hk Hj. apply (transition_nonneg _ _ _ refined); [|exact Hj]. apply substate_below; [|exact Hk].
  exact (state_below _ _ _ _ _ _ _ refinement).
Qed.

(* A planar patch does not see itself, nor its parts each other: the self term is null, and the gain is the sum
   of the pair gains. *)
Theorem gain_of_planar_patch_is_sum_of_pair_gains : P s s = 0 ->
  mutual_information (n - 1 + m) w' P' - mutual_information n w P = sum_others n s gain_with.
Proof.
  intros H0. rewrite gain_is_pair_gains_and_self_gain.
  assert (self_gain = 0); [|lra]. unfold self_gain. rewrite H0, xlog2_0, Rmult_0_r, Rminus_0_r.
  assert (E := proj2 (refined_state_is_sum_of_substates n s m w P w' P'
    coarse coarse_reciprocal refined refinement)).
  unfold joint at 1 in E. rewrite H0, Rmult_0_r in E. symmetry in E.
  assert (Hs := state_below _ _ _ _ _ _ _ refinement).
  assert (J : forall k l, (k < m)%nat -> (l < m)%nat ->
    0 <= joint w' P' (substate n s k) (substate n s l)).
  { intros k l Hk Hl. apply Rmult_le_pos; [now apply substate_weight_nonneg|].
    apply substate_transition_nonneg; [exact Hk|now apply substate_below]. }
  apply sum_zero. intros k Hk. apply sum_zero. intros l Hl.
  assert (Ek := sum_nonneg_zero m _ (fun k Hk => sum_nonneg m _ (fun l Hl => J k l Hk Hl)) E k Hk).
  assert (El := sum_nonneg_zero m _ (fun l Hl => J k l Hk Hl) Ek l Hl). unfold joint in El.
  rewrite <- xlog2_scale, El. apply xlog2_0.
Qed.

(* ---- The whole gain of a regular subdivision ---- *)

Hypothesis regular : forall k, (k < m)%nat -> w' (substate n s k) = w s / INR m.
Hypothesis state_weight_positive : 0 < w s.

(* Eq. (6) for s and j. *)
Lemma gain_with_at_most : forall j, (j < n)%nat -> j <> s ->
  gain_with j <= 2 * w s * P s j * log2 (INR m).
Proof.
  intros j Hj Hjs.
  assert (Hs := state_below _ _ _ _ _ _ _ refinement).
  assert (Hm := some_substate _ _ _ _ _ _ _ refinement).
  assert (Hp := transition_nonneg _ _ _ coarse s j Hs Hj).
  assert (Hw := weight_nonneg _ _ _ coarse j Hj).
  assert (E : gain_with j = regular_gain m (w s) (P s j) (w j) (fun k => P' (substate n s k) j)).
  { unfold gain_with, regular_gain, pair_gain. do 2 f_equal. apply sum_ext. intros k Hk. now rewrite regular. }
  assert (C : sum m (fun k => w s / INR m * P' (substate n s k) j) = w s * P s j).
  { rewrite <- substates_carry_all by assumption. apply sum_ext. intros k Hk. now rewrite regular. }
  assert (Hq : forall k, (k < m)%nat -> 0 <= P' (substate n s k) j)
    by (intros; apply substate_transition_nonneg; [assumption|lia]).
  rewrite E. destruct (Req_dec (w j) 0) as [E0|E0].
  - assert (P s j = 0).
    { assert (X := coarse_reciprocal s j Hs Hj). unfold joint in X. rewrite E0, Rmult_0_l in X.
      apply Rmult_integral in X. destruct X; [lra|assumption]. }
    rewrite null_pair_gains_nothing; auto. rewrite H. lra.
  - apply regular_gain_at_most; auto. lra.
Qed.

(* The self term: each J_kl is at most J_ss, so J_kl log (J_kl m^2 / w_s^2) <= J_kl log (J_ss m^2 / w_s^2). *)
Lemma self_gain_at_most : self_gain <= 2 * w s * P s s * log2 (INR m).
Proof.
  assert (Hs := state_below _ _ _ _ _ _ _ refinement).
  assert (Hm := some_substate _ _ _ _ _ _ _ refinement).
  assert (HM : 0 < INR m) by (apply lt_0_INR; lia).
  assert (E := proj2 (refined_state_is_sum_of_substates n s m w P w' P'
    coarse coarse_reciprocal refined refinement)).
  assert (J : forall k l, (k < m)%nat -> (l < m)%nat ->
    0 <= joint w' P' (substate n s k) (substate n s l)).
  { intros k l Hk Hl. apply Rmult_le_pos; [now apply substate_weight_nonneg|].
    apply substate_transition_nonneg; [exact Hk|now apply substate_below]. }
  assert (Jle : forall k l, (k < m)%nat -> (l < m)%nat ->
    joint w' P' (substate n s k) (substate n s l) <= joint w P s s).
  { intros k l Hk Hl. rewrite E.
    apply Rle_trans with (sum m (fun l => joint w' P' (substate n s k) (substate n s l))).
    - now apply (term_le_sum m (fun l => joint w' P' (substate n s k) (substate n s l))); [intros; apply J|].
    - apply (term_le_sum m (fun k => sum m (fun l => joint w' P' (substate n s k) (substate n s l))));
      [intros; apply sum_nonneg; intros; now apply J|exact Hk]. }
  set (part := w s / INR m). assert (Hpart : 0 < part) by now apply Rdiv_lt_0_compat.
  assert (X : sum m (fun k => sum m (fun l => w' (substate n s k) *
      xlog2 (P' (substate n s k) (substate n s l)) (w' (substate n s l)))) <=
    joint w P s s * log2 (joint w P s s / (part * part))).
  { rewrite E at 1. rewrite <- sum_scale_right. apply sum_le. intros k Hk.
    rewrite <- sum_scale_right. apply sum_le. intros l Hl.
    specialize (J k l Hk Hl). specialize (Jle k l Hk Hl).
    rewrite <- xlog2_scale, !regular by assumption. fold part.
    unfold joint in J at 1. unfold joint in Jle at 1. unfold joint at 1.
    rewrite regular in * by assumption. fold part in J, Jle. fold part.
    set (x := part * P' (substate n s k) (substate n s l)) in *.
    destruct (Req_dec x 0) as [Ex|Ex]; [rewrite Ex, xlog2_0; lra|].
    rewrite xlog2_nonzero by assumption. apply Rmult_le_compat_l; [exact J|].
    assert (0 < part * part) by now apply Rmult_lt_0_compat.
    apply log2_le; [apply Rdiv_lt_0_compat; lra|].
    apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact Jle]. }
  unfold self_gain. rewrite <- xlog2_scale. fold (joint w P s s).
  replace (2 * w s * P s s * log2 (INR m)) with (joint w P s s * (2 * log2 (INR m))) by (unfold joint; ring).
  destruct (Req_dec (joint w P s s) 0) as [E0|E0].
  - rewrite E0 in *. rewrite xlog2_0. lra.
  - assert (Hj : 0 < joint w P s s).
    { assert (0 <= joint w P s s); [|lra]. apply Rmult_le_pos; [lra|].
      now apply (transition_nonneg _ _ _ coarse). }
    assert (Hp2 : 0 < part * part) by now apply Rmult_lt_0_compat.
    assert (Hw2 : 0 < w s * w s) by now apply Rmult_lt_0_compat.
    rewrite xlog2_nonzero by assumption.
    rewrite log2_div in X by assumption. rewrite log2_div by assumption.
    rewrite (log2_mult part part) in X by assumption. unfold part in X at 1 2.
    rewrite (log2_div (w s) (INR m)) in X by assumption. rewrite (log2_mult (w s) (w s)) by assumption.
    nra.
Qed.

(* Dividing state s into m parts of equal weight gains at most 2 w_s log m, self term included. *)
Theorem regular_refinement_gains_at_most :
  mutual_information (n - 1 + m) w' P' - mutual_information n w P <= 2 * w s * log2 (INR m).
Proof.
  assert (Hs := state_below _ _ _ _ _ _ _ refinement).
  rewrite gain_is_pair_gains_and_self_gain, <- (bound_summed_over_receivers n m (w s) (P s)) by
    now apply (row_sum_one _ _ _ coarse).
  rewrite (sum_others_and_state n s) by assumption. apply Rplus_le_compat; [|exact self_gain_at_most].
  apply sum_le. intros j Hj. destruct (Nat.eqb_spec j s); [lra|]. now apply gain_with_at_most.
Qed.
End Gain.
