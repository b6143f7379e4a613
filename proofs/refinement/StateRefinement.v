(* One state s of a chain is refined into m sub-states: the labels of the refined chain, sums over them, and
   what follows about w_s and w_s P_ss from both chains being Markov chains. The frame of Theorem1.v. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement.
Open Scope R_scope.

(* ---- Labels ----
   The coarse states are 0 .. n-1; state s < n is refined into m >= 1 sub-states. The first sub-state takes over
   the label s, the others get the new labels n, n+1, ..., n+m-2; every other state keeps its label. *)
Definition substate (n s k : nat) : nat :=
  match k with O => s | S k' => (n + k')%nat end.

(* The coarse state in which a refined state lies. *)
Definition parent_state (n s k : nat) : nat := if (k <? n)%nat then k else s.

(* Each refined state is either one of the other states or a sub-state. *)
Lemma refined_label : forall n m s x, (s < n)%nat -> (1 <= m)%nat -> (x < n - 1 + m)%nat ->
  ((x < n)%nat /\ x <> s) \/ (exists k, (k < m)%nat /\ x = substate n s k).
Proof.
  intros n m s x Hs Hm Hx. destruct (Nat.eq_dec x s) as [->|].
  - right. exists 0%nat. split; [lia|reflexivity].
  - destruct (Nat.lt_ge_cases x n); [now left|right].
    exists (S (x - n)). simpl. split; lia.
Qed.

Lemma substate_below : forall n m s k, (s < n)%nat -> (k < m)%nat -> (substate n s k < n - 1 + m)%nat.
Proof. intros n m s [|k] Hs Hk; simpl; lia. Qed.

Lemma parent_of_substate : forall n s k, (s < n)%nat -> parent_state n s (substate n s k) = s.
Proof.
  intros n s [|k] Hs; unfold parent_state; simpl; [|destruct (Nat.ltb_spec (n + k) n)];
  try destruct (Nat.ltb_spec s n); lia.
Qed.

Lemma parent_of_other : forall n s j, (j < n)%nat -> parent_state n s j = j.
Proof. intros n s j Hj. unfold parent_state. destruct (Nat.ltb_spec j n); lia. Qed.

(* The sum over all states but s. *)
Definition sum_others (n s : nat) (f : nat -> R) : R :=
  sum n (fun j => if Nat.eqb j s then 0 else f j).

Lemma sum_others_and_state : forall n s f, (s < n)%nat -> sum n f = sum_others n s f + f s.
Proof.
  intros n s f Hs. rewrite <- (sum_single n s f Hs). unfold sum_others. rewrite <- sum_plus.
  apply sum_ext. intros j _. destruct (Nat.eqb j s); lra.
Qed.

Lemma sum_others_and_substates : forall n m s f, (s < n)%nat ->
  sum (n + m) f = sum_others n s f + sum (S m) (fun k => f (substate n s k)).
Proof.
  intros n m s f Hs. rewrite sum_append, sum_first, (sum_others_and_state n s f Hs). simpl. lra.
Qed.

Lemma sum_others_ext : forall n s f g,
  (forall j, (j < n)%nat -> j <> s -> f j = g j) -> sum_others n s f = sum_others n s g.
Proof.
  intros n s f g H. apply sum_ext. intros j Hj. destruct (Nat.eqb_spec j s); auto.
Qed.

Lemma sum_others_scale : forall n s c f, sum_others n s (fun j => c * f j) = c * sum_others n s f.
Proof.
  intros. unfold sum_others. rewrite <- sum_scale. apply sum_ext. intros j _.
  destruct (Nat.eqb j s); lra.
Qed.

(* The sum over the parts of s is the sum over its sub-states; any other state is its own only part. *)
Lemma part_sum_of_refined_state : forall n m s f, (s < n)%nat ->
  part_sum (n + m) (parent_state n s) s f = sum (S m) (fun k => f (substate n s k)).
Proof.
  intros n m s f Hs. unfold part_sum. rewrite (sum_others_and_substates n m s) by assumption.
  unfold sum_others. rewrite sum_zero.
  - rewrite Rplus_0_l. apply sum_ext. intros k _. now rewrite parent_of_substate, Nat.eqb_refl.
  - intros j Hj. destruct (Nat.eqb_spec j s); [reflexivity|].
    rewrite parent_of_other by assumption. now destruct (Nat.eqb_spec j s).
Qed.

Lemma part_sum_of_other_state : forall n m s i f, (s < n)%nat -> (i < n)%nat -> i <> s ->
  part_sum (n + m) (parent_state n s) i f = f i.
Proof.
  intros n m s i f Hs Hi His. unfold part_sum. rewrite (sum_others_and_substates n m s) by assumption.
  rewrite (sum_zero (S m)).
  - unfold sum_others. rewrite Rplus_0_r, <- (sum_single n i f Hi). apply sum_ext. intros j Hj.
    rewrite parent_of_other by assumption.
    destruct (Nat.eqb_spec j s) as [->|]; [|reflexivity].
    destruct (Nat.eqb_spec s i); [lia|reflexivity].
  - intros k _. rewrite parent_of_substate by assumption. destruct (Nat.eqb_spec s i); [lia|reflexivity].
Qed.

Section StateRefinement.
Variables (n s m : nat).
Variables (w : nat -> R) (P : nat -> nat -> R) (w' : nat -> R) (P' : nat -> nat -> R).
Hypothesis state_below_n : (s < n)%nat.
Hypothesis at_least_one_substate : (1 <= m)%nat.
Hypothesis coarse : markov_chain n w P.
Hypothesis refined : markov_chain (n - 1 + m) w' P'.
Hypothesis other_weight_unchanged : forall j, (j < n)%nat -> j <> s -> w' j = w j.

(* The two totals are both one, and all other weights are unchanged. *)
Lemma refined_weight_is_sum_of_substates : w s = sum m (fun k => w' (substate n s k)).
Proof.
  assert (Hw := other_weight_unchanged). destruct m as [|q]; [lia|].
  assert (T := total_weight_one _ _ _ coarse). assert (T' := total_weight_one _ _ _ refined).
  replace (n - 1 + S q)%nat with (n + q)%nat in T' by lia.
  rewrite (sum_others_and_state n s) in T by assumption.
  rewrite (sum_others_and_substates n q s) in T' by assumption.
  rewrite (sum_others_ext n s w' w) in T' by auto. lra.
Qed.

(* The joint probabilities between s and the other states are those of the sub-states. *)
Hypothesis joint_with_others : forall j, (j < n)%nat -> j <> s ->
  joint w P s j = sum m (fun k => joint w' P' (substate n s k) j).

(* What is left of w_s when all transitions to the other states are taken off, on both sides. *)
Lemma refined_self_joint_is_sum_of_substates :
  joint w P s s = sum m (fun k => sum m (fun l => joint w' P' (substate n s k) (substate n s l))).
Proof.
  assert (W := refined_weight_is_sum_of_substates). assert (X := joint_with_others).
  assert (E : w s = sum_others n s (fun j => joint w P s j) + joint w P s s).
  { rewrite <- (sum_others_and_state n s (fun j => joint w P s j)) by assumption.
    unfold joint. rewrite sum_scale, (row_sum_one _ _ _ coarse) by assumption. lra. }
  assert (E' : sum m (fun k => w' (substate n s k)) =
    sum_others n s (fun j => sum m (fun k => joint w' P' (substate n s k) j)) +
    sum m (fun k => sum m (fun l => joint w' P' (substate n s k) (substate n s l)))).
  { transitivity (sum m (fun k => sum_others n s (fun j => joint w' P' (substate n s k) j) +
      sum m (fun l => joint w' P' (substate n s k) (substate n s l)))).
    - destruct m as [|q]; [lia|]. apply sum_ext. intros k Hk.
      rewrite <- (sum_others_and_substates n q s (fun x => joint w' P' (substate n s k) x)) by assumption.
      replace (n + q)%nat with (n - 1 + S q)%nat by lia.
      unfold joint. rewrite sum_scale, (row_sum_one _ _ _ refined); [lra|].
      now apply substate_below.
    - rewrite sum_plus. f_equal. unfold sum_others. rewrite sum_exchange. apply sum_ext. intros j _.
      destruct (Nat.eqb j s); [now apply sum_zero|reflexivity]. }
  rewrite (sum_others_ext n s (fun j => joint w P s j) _ X) in E. lra.
Qed.

Hypothesis other_transition_unchanged : forall i j,
  (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j.
Hypothesis substates_cover_s : forall j, (j < n)%nat -> j <> s ->
  P j s = sum m (fun k => P' j (substate n s k)).
Hypothesis refined_stationary : stationary (n - 1 + m) w' P'.

(* Then (w', P') is a refinement by the parent map. *)
Lemma refined_state_refines : refines n (n - 1 + m) (parent_state n s) w P w' P'.
Proof.
  assert (Hw := other_weight_unchanged). assert (HP := other_transition_unchanged).
  assert (Hb := substates_cover_s).
  assert (W := refined_weight_is_sum_of_substates). assert (X := joint_with_others).
  assert (Y := refined_self_joint_is_sum_of_substates).
  assert (J : forall k l, (k < n - 1 + m)%nat -> (l < n - 1 + m)%nat -> 0 <= joint w' P' k l).
  { intros k l Hk Hl. apply Rmult_le_pos;
      [now apply (weight_nonneg _ _ _ refined)|now apply (transition_nonneg _ _ _ refined)]. }
  split.
  - intros k Hk. unfold parent_state. destruct (Nat.ltb_spec k n); assumption.
  - exact (weight_nonneg _ _ _ refined).
  - exact J.
  - now apply stationary_joint_null.
  - intros i Hi. destruct m as [|q]; [lia|]. replace (n - 1 + S q)%nat with (n + q)%nat by lia.
    destruct (Nat.eq_dec i s) as [->|His].
    + now rewrite part_sum_of_refined_state.
    + rewrite part_sum_of_other_state by assumption. now rewrite Hw.
  - intros i j Hi Hj. destruct m as [|q]; [lia|]. replace (n - 1 + S q)%nat with (n + q)%nat by lia.
    unfold block_sum. destruct (Nat.eq_dec i s) as [->|His], (Nat.eq_dec j s) as [->|Hjs].
    + rewrite part_sum_of_refined_state, Y by assumption. apply sum_ext. intros k _.
      now rewrite part_sum_of_refined_state.
    + rewrite part_sum_of_refined_state, X by assumption. apply sum_ext. intros k _.
      now rewrite part_sum_of_other_state.
    + rewrite part_sum_of_other_state, part_sum_of_refined_state by assumption.
      unfold joint. rewrite sum_scale, <- Hb, Hw by assumption. reflexivity.
    + rewrite !part_sum_of_other_state by assumption. unfold joint. now rewrite Hw, HP.
Qed.
End StateRefinement.
