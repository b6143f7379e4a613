(* States grouped together: weights and joint probabilities of a group are sums over its states. The grouped chain is
   again a reciprocal Markov chain, and of two groupings the finer refines the coarser. This is the "additivity of the
   integral" of sections 3.4 and 3.5, with sums in place of integrals. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums Refinement Corollary1.
Open Scope R_scope.

Definition grouped_weight (N : nat) (group : nat -> nat) (weight : nat -> R) (i : nat) : R :=
  part_sum N group i weight.

Definition grouped_transition (N : nat) (group : nat -> nat) (weight : nat -> R) (transition : nat -> nat -> R)
    (i j : nat) : R :=
  block_sum N group i j (joint weight transition) / grouped_weight N group weight i.

(* N states fall into n groups, none of them empty. *)
Definition groups (n N : nat) (group : nat -> nat) : Prop :=
  (forall k, (k < N)%nat -> (group k < n)%nat) /\ (forall i, (i < n)%nat -> exists k, (k < N)%nat /\ group k = i).

Section Grouping.
Variables (n N : nat) (group : nat -> nat) (w : nat -> R) (P : nat -> nat -> R).
Hypothesis grouping : groups n N group.
Hypothesis chain : markov_chain N w P.
Hypothesis reciprocity : reciprocal N w P.
Hypothesis positive : forall k, (k < N)%nat -> 0 < w k.

Lemma grouped_weight_positive : forall i, (i < n)%nat -> 0 < grouped_weight N group w i.
Proof.
  intros i Hi. destruct (proj2 grouping i Hi) as [k [Hk Ek]]. unfold grouped_weight, part_sum.
  apply Rlt_le_trans with (if Nat.eqb (group k) i then w k else 0).
  - rewrite Ek, Nat.eqb_refl. now apply positive.
  - apply (term_le_sum N (fun k => if Nat.eqb (group k) i then w k else 0)); [| assumption].
    intros l Hl. destruct (Nat.eqb (group l) i); [left; now apply positive | lra].
Qed.

Lemma grouped_joint : forall i j, (i < n)%nat ->
  joint (grouped_weight N group w) (grouped_transition N group w P) i j = block_sum N group i j (joint w P).
Proof.
  intros i j Hi. unfold joint at 1, grouped_transition. assert (H := grouped_weight_positive i Hi). field. lra.
Qed.

(* Exchange the two sums. *)
Theorem grouped_chain_is_reciprocal :
  reciprocal n (grouped_weight N group w) (grouped_transition N group w P).
Proof.
  intros i j Hi Hj. rewrite !grouped_joint, !block_sum_masked by assumption. rewrite sum_exchange.
  apply sum_ext. intros l Hl. apply sum_ext. intros k Hk. rewrite andb_comm.
  destruct (Nat.eqb (group l) j && Nat.eqb (group k) i)%bool; [now apply reciprocity | reflexivity].
Qed.

Theorem grouped_chain_is_markov :
  markov_chain n (grouped_weight N group w) (grouped_transition N group w P).
Proof.
  constructor.
  - intros i Hi. left. now apply grouped_weight_positive.
  - intros i j Hi Hj. unfold grouped_transition, Rdiv. apply Rmult_le_pos.
    + rewrite block_sum_masked. apply sum_nonneg. intros k Hk. apply sum_nonneg. intros l Hl.
      destruct (Nat.eqb (group k) i && Nat.eqb (group l) j)%bool; [| lra].
      apply Rmult_le_pos; [now apply (weight_nonneg _ _ _ chain) | now apply (transition_nonneg _ _ _ chain)].
    + left. now apply Rinv_0_lt_compat, grouped_weight_positive.
  - unfold grouped_weight. rewrite sum_over_parts by exact (proj1 grouping). exact (total_weight_one _ _ _ chain).
  - intros i Hi. unfold grouped_transition, Rdiv. rewrite sum_scale_right. unfold block_sum.
    rewrite sum_part_sum. rewrite (part_sum_ext N group i _ w).
    + fold (grouped_weight N group w i). apply Rinv_r. assert (H := grouped_weight_positive i Hi). lra.
    + intros k Hk _. rewrite sum_over_parts by exact (proj1 grouping). unfold joint.
      rewrite sum_scale, (row_sum_one _ _ _ chain) by assumption. ring.
Qed.

(* The states themselves refine the grouped chain. *)
Theorem states_refine_their_groups :
  refines n N group (grouped_weight N group w) (grouped_transition N group w P) w P.
Proof.
  assert (J : forall k l, (k < N)%nat -> (l < N)%nat -> 0 <= joint w P k l).
  { intros k l Hk Hl.
    apply Rmult_le_pos; [now apply (weight_nonneg _ _ _ chain) | now apply (transition_nonneg _ _ _ chain)]. }
  constructor.
  - exact (proj1 grouping).
  - exact (weight_nonneg _ _ _ chain).
  - exact J.
  - now apply stationary_joint_null, reciprocal_is_stationary.
  - reflexivity.
  - intros i j Hi Hj. now apply grouped_joint.
Qed.
End Grouping.

(* States in parts, parts in patches: the chain of the parts refines the chain of the patches. *)
Theorem finer_grouping_refines_coarser : forall n m N part patch w P,
  groups m N part -> groups n m patch ->
  markov_chain N w P -> reciprocal N w P -> (forall k, (k < N)%nat -> 0 < w k) ->
  refines n m patch
    (grouped_weight N (fun k => patch (part k)) w) (grouped_transition N (fun k => patch (part k)) w P)
    (grouped_weight N part w) (grouped_transition N part w P).
Proof.
  intros n m N part patch w P Gm Gn C Rc Pos.
  assert (Gc : groups n N (fun k => patch (part k))).
  { split.
    - intros k Hk. apply Gn. now apply Gm.
    - intros i Hi. destruct (proj2 Gn i Hi) as [p [Hp Ep]]. destruct (proj2 Gm p Hp) as [k [Hk Ek]].
      exists k. split; [assumption |]. now rewrite Ek. }
  pose proof (grouped_chain_is_markov m N part w P Gm C Pos) as M.
  pose proof (grouped_chain_is_reciprocal m N part w P Gm Rc Pos) as S.
  assert (J : forall k l, (k < m)%nat -> (l < m)%nat ->
    0 <= joint (grouped_weight N part w) (grouped_transition N part w P) k l).
  { intros k l Hk Hl. apply Rmult_le_pos; [now apply (weight_nonneg _ _ _ M) | now apply (transition_nonneg _ _ _ M)]. }
  constructor.
  - exact (proj1 Gn).
  - exact (weight_nonneg _ _ _ M).
  - exact J.
  - now apply stationary_joint_null, reciprocal_is_stationary.
  - intros i Hi. unfold grouped_weight.
    rewrite (part_sum_of_part_sums m N patch part); [reflexivity | exact (proj1 Gm)].
  - intros i j Hi Hj. rewrite (grouped_joint n N) by assumption.
    rewrite <- (block_sum_of_block_sums m N patch part) by exact (proj1 Gm).
    unfold block_sum at 1 3. apply part_sum_ext. intros k Hk _. apply part_sum_ext. intros l Hl _.
    symmetry. now apply (grouped_joint m N).
Qed.
