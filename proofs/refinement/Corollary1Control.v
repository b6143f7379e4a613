(* Control for Corollary 1: without a bound mutual information may grow without limit. The chain on 2^t states of
   equal weight that never leaves a state has I = t, and each of them refines the one before. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement StateRefinement Theorem1
  Theorem1Variants Corollary1.
Open Scope R_scope.

(* n states of weight 1/n, none ever left. *)
Definition chain_that_stays (n : nat) : chain :=
  {| states := n; weight := fun _ => 1 / INR n; transition := stay |}.

Lemma chain_that_stays_is_markov_and_reciprocal : forall n, (1 <= n)%nat ->
  let C := chain_that_stays n in
  markov_chain (states C) (weight C) (transition C) /\ reciprocal (states C) (weight C) (transition C).
Proof.
  intros n Hn C. assert (H : 0 < INR n) by (apply lt_0_INR; lia). split; simpl.
  - split.
    + intros. left. apply Rdiv_lt_0_compat; lra.
    + intros i j _ _. unfold stay. destruct (Nat.eqb i j); lra.
    + assert (E : forall m, sum m (fun _ => 1 / INR n) = INR m / INR n).
      { induction m as [|m IH]; simpl sum; [simpl; lra|]. rewrite IH, S_INR. lra. }
      rewrite E. field. lra.
    + intros i Hi. exact (sum_single_sym n i (fun _ => 1) Hi).
  - intros i j _ _. unfold joint, stay. now rewrite Nat.eqb_sym.
Qed.

(* I = log n. *)
Lemma information_of_chain_that_stays : forall n, (1 <= n)%nat ->
  information (chain_that_stays n) = log2 (INR n).
Proof.
  intros n Hn. assert (H : 0 < INR n) by (apply lt_0_INR; lia).
  assert (W := total_weight_one _ _ _ (proj1 (chain_that_stays_is_markov_and_reciprocal n Hn))).
  simpl in W. unfold information, mutual_information. simpl.
  transitivity (sum n (fun _ => 1 / INR n * log2 (INR n))).
  - apply sum_ext. intros i Hi. rewrite <- (sum_single_sym n i (fun _ => 1 / INR n * log2 (INR n)) Hi).
    apply sum_ext. intros j _. unfold stay. destruct (Nat.eqb i j); [|rewrite xlog2_0; lra].
    rewrite xlog2_nonzero by lra. replace (1 / (1 / INR n)) with (INR n) by (field; lra). lra.
  - rewrite sum_scale_right, W. lra.
Qed.

(* Halving every state: state k of 2 n lies in state k / 2. *)
Lemma halved_chain_refines : forall n, (1 <= n)%nat ->
  refined_by (chain_that_stays n) (chain_that_stays (n * 2)).
Proof.
  intros n Hn. exists (fun k => (k / 2)%nat).
  unfold chain_that_stays. cbn [states weight transition].
  assert (H : 0 < INR n) by (apply lt_0_INR; lia).
  assert (H2 : INR (n * 2) = INR n * 2) by (rewrite mult_INR; simpl; lra).
  assert (Part : forall i c, (i < n)%nat -> part_sum (n * 2) (fun k => (k / 2)%nat) i (fun _ => c) = 2 * c).
  { intros i c Hi. unfold part_sum.
    rewrite (sum_flatten n 2 (fun k _ => if Nat.eqb k i then c else 0)).
    rewrite <- (sum_single n i (fun _ => 2 * c) Hi).
    apply sum_ext. intros k _. simpl. destruct (Nat.eqb k i); lra. }
  destruct (chain_that_stays_is_markov_and_reciprocal (n * 2) ltac:(lia)) as [C K]. cbn [chain_that_stays states weight transition] in C, K.
  assert (J : forall k l, (k < n * 2)%nat -> (l < n * 2)%nat ->
    0 <= joint (fun _ => 1 / INR (n * 2)) stay k l).
  { intros. apply Rmult_le_pos; [now apply (weight_nonneg _ _ _ C k)|now apply (transition_nonneg _ _ _ C)]. }
  split.
  - intros k Hk. apply Nat.div_lt_upper_bound; lia.
  - exact (weight_nonneg _ _ _ C).
  - exact J.
  - now apply stationary_joint_null, reciprocal_is_stationary.
  - intros i Hi. rewrite Part, H2 by assumption. field. lra.
  - intros i j Hi Hj. unfold joint at 1. unfold stay at 1.
    transitivity (part_sum (n * 2) (fun k => (k / 2)%nat) i
      (fun _ => if Nat.eqb i j then 1 / INR (n * 2) else 0)).
    { rewrite Part, H2 by assumption. destruct (Nat.eqb i j); [field; lra|lra]. }
    unfold block_sum. apply part_sum_ext. intros k Hk Ek. unfold part_sum, joint.
    rewrite (sum_ext (n * 2) _ (fun l => if Nat.eqb k l then
      (if Nat.eqb (l / 2) j then 1 / INR (n * 2) else 0) else 0)).
    + rewrite (sum_single_sym (n * 2) k (fun l => if Nat.eqb (l / 2) j then 1 / INR (n * 2) else 0)) by assumption.
      now rewrite Ek.
    + intros l _. unfold stay. destruct (Nat.eqb (l / 2) j), (Nat.eqb k l); lra.
Qed.

Theorem without_bound_mutual_information_grows_without_limit :
  let U := fun t => chain_that_stays (2 ^ t) in
  (forall t, refined_by (U t) (U (S t))) /\ (forall t, information (U t) = INR t) /\
  ~ has_ub (fun t => information (U t)).
Proof.
  assert (P : forall t, (1 <= 2 ^ t)%nat) by (induction t; simpl; lia).
  assert (I : forall t, information (chain_that_stays (2 ^ t)) = INR t).
  { intros t. rewrite information_of_chain_that_stays by apply P.
    induction t as [|t IH]; [simpl; apply log2_1|].
    replace (2 ^ S t)%nat with (2 * 2 ^ t)%nat by reflexivity.
    rewrite mult_INR, log2_mult by (apply lt_0_INR; specialize (P t); lia).
    rewrite IH, (S_INR t). replace (INR 2) with 2 by (simpl; lra). rewrite log2_2. lra. }
  split; [|split; [exact I|]].
  - intros t. replace (2 ^ S t)%nat with (2 ^ t * 2)%nat by (simpl; lia). apply halved_chain_refines, P.
  - intros [b B]. destruct (Rle_or_lt b 0) as [Hb|Hb].
    { assert (INR 1 <= b) by (rewrite <- I; apply B; now exists 1%nat). simpl in *. lra. }
    destruct (archimed_cor1 (/ b)) as [t [Ht Ht0]]; [now apply Rinv_0_lt_compat|].
    assert (b < INR t).
    { destruct (Rle_or_lt (INR t) b) as [Hle|]; [|assumption].
      assert (/ b <= / INR t) by (apply Rinv_le_contravar; [now apply lt_0_INR|exact Hle]). lra. }
    assert (INR t <= b); [|lra]. rewrite <- I. apply B. now exists t.
Qed.
