(* Around Theorem 1: reciprocity may be weakened to stationarity and (b) follows from the rows summing to one;
   and controls, concrete chains that show what happens when (a) or (b) is dropped. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement StateRefinement Theorem1.
Open Scope R_scope.

(* (b) is no independent hypothesis: the rows of both chains sum to one and all transitions between other states
   are unchanged, so what is left of row j is the same on both sides. *)
Theorem cover_follows_from_rows : forall n s m w P w' P',
  (s < n)%nat -> (1 <= m)%nat -> markov_chain n w P -> markov_chain (n - 1 + m) w' P' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j) ->
  forall j, (j < n)%nat -> j <> s -> P j s = sum m (fun k => P' j (substate n s k)).
Proof.
  intros n s m w P w' P' Hs Hm C C' HP j Hj Hjs.
  assert (E := row_sum_one _ _ _ C j Hj). destruct m as [|q]; [lia|].
  assert (E' := row_sum_one _ _ _ C' j ltac:(lia)).
  replace (n - 1 + S q)%nat with (n + q)%nat in E' by lia.
  rewrite (sum_others_and_state n s (fun i => P j i)) in E by assumption.
  rewrite (sum_others_and_substates n q s (fun i => P' j i)) in E' by assumption.
  rewrite (sum_others_ext n s (fun i => P' j i) (fun i => P j i)) in E' by auto. lra.
Qed.

(* Stationarity: the column of an other state j sums to w_j on both sides, and the contributions of the other
   states are the same, so those of s and of its sub-states are. *)
Lemma joint_with_other_state_by_stationarity : forall n s m w P w' P',
  (s < n)%nat -> (1 <= m)%nat -> stationary n w P -> stationary (n - 1 + m) w' P' ->
  (forall j, (j < n)%nat -> j <> s -> w' j = w j) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j) ->
  forall j, (j < n)%nat -> j <> s ->
  joint w P s j = sum m (fun k => joint w' P' (substate n s k) j).
Proof.
  intros n s m w P w' P' Hs Hm S S' Hw HP j Hj Hjs.
  assert (E := S j Hj). destruct m as [|q]; [lia|]. assert (E' := S' j ltac:(lia)).
  replace (n - 1 + Datatypes.S q)%nat with (n + q)%nat in E' by lia.
  rewrite (sum_others_and_state n s) in E by assumption.
  rewrite (sum_others_and_substates n q s) in E' by assumption.
  rewrite (sum_others_ext n s (fun i => joint w' P' i j) (fun i => joint w P i j)), Hw in E' by
    (try assumption; intros; unfold joint; now rewrite Hw, HP). lra.
Qed.

(* Theorem 1 for stationary chains, which need not be reciprocal, and without (b). *)
Theorem refinement_of_stationary_chain_never_lowers_mutual_information : forall n s m w P w' P',
  (s < n)%nat -> (1 <= m)%nat ->
  markov_chain n w P -> stationary n w P ->
  markov_chain (n - 1 + m) w' P' -> stationary (n - 1 + m) w' P' ->
  (forall j, (j < n)%nat -> j <> s -> w' j = w j) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j) ->
  mutual_information n w P <= mutual_information (n - 1 + m) w' P'.
Proof.
  intros n s m w P w' P' Hs Hm C S C' S' Hw HP.
  apply (refinement_of_several_states_never_lowers_mutual_information _ _ (parent_state n s)).
  apply refined_state_refines; try assumption.
  - now apply joint_with_other_state_by_stationarity.
  - now apply (cover_follows_from_rows n s m w P w' P').
Qed.

(* ---- Controls ---- *)

Lemma xlog2_same : forall x, x <> 0 -> xlog2 x x = 0.
Proof. intros x H. rewrite xlog2_nonzero by assumption. replace (x / x) with 1 by now field. rewrite log2_1. lra. Qed.

Lemma xlog2_1_half : xlog2 1 (1 / 2) = 1.
Proof. rewrite xlog2_nonzero by lra. replace (1 / (1 / 2)) with 2 by field. rewrite log2_2. lra. Qed.

(* Two states of weight 1/2 that are never left: I = 1. *)
Definition half (i : nat) : R := 1 / 2.
Definition stay (i j : nat) : R := if Nat.eqb i j then 1 else 0.

(* The second one halved: weights 1/2, 1/4, 1/4. *)
Definition half_quarter_quarter (i : nat) : R := match i with O => 1 / 2 | _ => 1 / 4 end.

Ltac small_index i := destruct i as [|[|[|i]]]; try lia.

Lemma two_states_that_stay : markov_chain 2 half stay /\ reciprocal 2 half stay /\
  mutual_information 2 half stay = 1.
Proof.
  split; [|split].
  - split; unfold half, stay.
    + intros. lra.
    + intros i j _ _. destruct (Nat.eqb i j); lra.
    + simpl. lra.
    + intros i Hi. small_index i; simpl; lra.
  - intros i j _ _. unfold joint, half, stay. rewrite Nat.eqb_sym. reflexivity.
  - unfold mutual_information, half, stay. simpl. rewrite xlog2_1_half, xlog2_0. lra.
Qed.

(* Theorem 1 can be strict: one state of weight 1 (I = 0) refined into the two above (I' = 1). *)
Theorem refinement_can_raise_mutual_information :
  markov_chain 1 (fun _ => 1) (fun _ _ => 1) /\ reciprocal 1 (fun _ => 1) (fun _ _ => 1) /\
  markov_chain 2 half stay /\ refines_state 1 0 2 (fun _ => 1) (fun _ _ => 1) half stay /\
  mutual_information 1 (fun _ => 1) (fun _ _ => 1) = 0 /\ mutual_information 2 half stay = 1.
Proof.
  destruct two_states_that_stay as [C [K I]].
  split; [|split; [|split; [exact C|split; [|split; [|exact I]]]]].
  - split; intros; simpl; lra.
  - intros i j _ _. reflexivity.
  - split; try lia.
    intros k j Hk Hj. apply K; [|exact Hj]. apply (substate_below 1 2); lia.
  - unfold mutual_information. simpl. rewrite xlog2_same by lra. lra.
Qed.

(* Without (a): the sub-states jump anywhere in proportion to weight, while state 0 is still never left; the
   weights are then not the stationary ones. Everything else holds, and I falls from 1 to 1/2. *)
Definition substates_jump_anywhere (i j : nat) : R :=
  match i with O => stay 0 j | _ => half_quarter_quarter j end.

Theorem without_reciprocity_mutual_information_can_fall :
  markov_chain 3 half_quarter_quarter substates_jump_anywhere /\
  (forall j, (j < 2)%nat -> j <> 1%nat -> half_quarter_quarter j = half j) /\
  (forall i j, (i < 2)%nat -> (j < 2)%nat -> i <> 1%nat -> j <> 1%nat ->
     substates_jump_anywhere i j = stay i j) /\
  (forall j, (j < 2)%nat -> j <> 1%nat ->
     stay j 1 = sum 2 (fun k => substates_jump_anywhere j (substate 2 1 k))) /\
  ~ stationary 3 half_quarter_quarter substates_jump_anywhere /\
  mutual_information 3 half_quarter_quarter substates_jump_anywhere = 1 / 2 /\
  mutual_information 2 half stay = 1.
Proof.
  repeat split; try (unfold substates_jump_anywhere, half_quarter_quarter, stay, half).
  - intros i _. destruct i; lra.
  - intros i j _ _. destruct i, j; simpl; try lra; destruct (Nat.eqb 0 _); lra.
  - simpl. lra.
  - intros i Hi. small_index i; simpl; lra.
  - intros j Hj Hj1. small_index j; reflexivity.
  - intros i j Hi Hj Hi1 Hj1. small_index i; small_index j; reflexivity.
  - intros j Hj Hj1. small_index j; simpl; lra.
  - intros S. specialize (S 0%nat ltac:(lia)). unfold joint in S. simpl in S. lra.
  - unfold mutual_information. simpl. rewrite xlog2_1_half, xlog2_0, !xlog2_same by lra. lra.
  - apply two_states_that_stay.
Qed.

(* Without (b): every state jumps anywhere in proportion to weight. The chain is reciprocal, so (a) holds, but
   P_01 = 0 while the sub-states receive 1/2 of state 0; I falls from 1 to 0. By [cover_follows_from_rows] some
   other transition must then change too, here P'_00 = 1/2. *)
Definition all_jump_anywhere (i j : nat) : R := half_quarter_quarter j.

Theorem without_cover_mutual_information_can_fall :
  markov_chain 3 half_quarter_quarter all_jump_anywhere /\
  reciprocal 3 half_quarter_quarter all_jump_anywhere /\
  (forall j, (j < 2)%nat -> j <> 1%nat -> half_quarter_quarter j = half j) /\
  sum 2 (fun k => all_jump_anywhere 0 (substate 2 1 k)) <> stay 0 1 /\
  mutual_information 3 half_quarter_quarter all_jump_anywhere = 0 /\
  mutual_information 2 half stay = 1.
Proof.
  repeat split; try (unfold all_jump_anywhere, half_quarter_quarter, stay, half).
  - intros i _. destruct i; lra.
  - intros i j _ _. destruct j; lra.
  - simpl. lra.
  - intros i _. simpl. lra.
  - intros i j _ _. unfold joint. apply Rmult_comm.
  - intros j Hj Hj1. small_index j; reflexivity.
  - simpl. lra.
  - unfold mutual_information. simpl. rewrite !xlog2_same by lra. lra.
  - apply two_states_that_stay.
Qed.

(* Without (b) alone: all else of the theorem's list holds, and the sub-states' rows sum to one, but that of
   state 0 sums to 3/2, so this is no Markov chain. I falls from 1 to 1/2. *)
Definition substates_receive_too_much (i j : nat) : R :=
  match i, j with O, O => 1 | _, _ => half_quarter_quarter j end.

Theorem without_cover_alone_mutual_information_can_fall :
  reciprocal 3 half_quarter_quarter substates_receive_too_much /\
  (forall j, (j < 2)%nat -> j <> 1%nat -> half_quarter_quarter j = half j) /\
  (forall i j, (i < 2)%nat -> (j < 2)%nat -> i <> 1%nat -> j <> 1%nat ->
     substates_receive_too_much i j = stay i j) /\
  sum 3 half_quarter_quarter = 1 /\
  (forall k, (k < 2)%nat -> sum 3 (substates_receive_too_much (substate 2 1 k)) = 1) /\
  sum 2 (fun k => substates_receive_too_much 0 (substate 2 1 k)) <> stay 0 1 /\
  mutual_information 3 half_quarter_quarter substates_receive_too_much = 1 / 2 /\
  mutual_information 2 half stay = 1.
Proof.
  repeat split; try (unfold substates_receive_too_much, half_quarter_quarter, stay, half).
  - intros i j _ _. unfold joint. destruct i, j; simpl; lra.
  - intros j Hj Hj1. small_index j; reflexivity.
  - intros i j Hi Hj Hi1 Hj1. small_index i; small_index j; reflexivity.
  - simpl. lra.
  - intros k Hk. small_index k; simpl; lra.
  - simpl. lra.
  - unfold mutual_information. simpl. rewrite xlog2_1_half, !xlog2_same by lra. lra.
  - apply two_states_that_stay.
Qed.
