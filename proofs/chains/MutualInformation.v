(* Mutual information as section 2 of the paper defines it: the Shannon entropy of the stationary distribution less
   the entropy rate; it is never negative and never above the entropy. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement.
Open Scope R_scope.

(* Eq. (1): - sum of w_i log w_i, with 0 log 0 = 0. *)
Definition entropy (n : nat) (weight : nat -> R) : R := - sum n (fun i => xlog2 (weight i) 1).

(* Eq. (2): - sum of w_i P_ij log P_ij. *)
Definition entropy_rate (n : nat) (weight : nat -> R) (transition : nat -> nat -> R) : R :=
  - sum n (fun i => sum n (fun j => weight i * xlog2 (transition i j) 1)).

(* I = H - H_s: the logarithm of a quotient is a difference, and column j of the joint probabilities sums to w_j. *)
Theorem mutual_information_is_entropy_less_entropy_rate : forall n w P,
  markov_chain n w P -> stationary n w P ->
  mutual_information n w P = entropy n w - entropy_rate n w P.
Proof.
  intros n w P C S.
  assert (J : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= joint w P i j).
  { intros. apply Rmult_le_pos; [now apply (weight_nonneg _ _ _ C)|now apply (transition_nonneg _ _ _ C)]. }
  assert (Z := stationary_joint_null n w P J S).
  unfold entropy, entropy_rate, mutual_information.
  transitivity (sum n (fun i => sum n (fun j => w i * xlog2 (P i j) 1 - joint w P i j * log2 (w j)))).
  - apply sum_ext. intros i Hi. apply sum_ext. intros j Hj. unfold joint.
    destruct (Req_dec (P i j) 0) as [->|Hp]; [rewrite !xlog2_0; lra|].
    destruct (Req_dec (w i) 0) as [->|Hi0]; [lra|].
    assert (w j <> 0).
    { intros E. specialize (Z i j Hi Hj E). unfold joint in Z. apply Rmult_integral in Z. tauto. }
    assert (H1 := transition_nonneg _ _ _ C i j Hi Hj). assert (H2 := weight_nonneg _ _ _ C j Hj).
    rewrite !xlog2_nonzero, !log2_div, log2_1 by lra. lra.
  - rewrite (sum_ext n _ (fun i => sum n (fun j => w i * xlog2 (P i j) 1) -
      sum n (fun j => joint w P i j * log2 (w j)))) by (intros; apply sum_minus).
    rewrite sum_minus, (sum_exchange n n (fun i j => joint w P i j * log2 (w j))).
    rewrite (sum_ext n (fun j => sum n (fun i => joint w P i j * log2 (w j))) (fun j => xlog2 (w j) 1)); [lra|].
    intros j Hj. rewrite sum_scale_right, S by assumption.
    destruct (Req_dec (w j) 0) as [->|H0]; [rewrite xlog2_0; lra|].
    rewrite xlog2_nonzero by assumption. now replace (w j / 1) with (w j) by field.
Qed.

(* I >= 0: the chain refines the chain of a single state, whose mutual information is 0. *)
Theorem mutual_information_nonneg : forall n w P,
  markov_chain n w P -> stationary n w P -> 0 <= mutual_information n w P.
Proof.
  intros n w P C S.
  assert (J : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= joint w P i j).
  { intros. apply Rmult_le_pos; [now apply (weight_nonneg _ _ _ C)|now apply (transition_nonneg _ _ _ C)]. }
  assert (one_part : forall f, part_sum n (fun _ => 0%nat) 0 f = sum n f) by (intros; reflexivity).
  assert (H : refines 1 n (fun _ => 0%nat) (fun _ => 1) (fun _ _ => 1) w P).
  { split.
    - intros. lia.
    - exact (weight_nonneg _ _ _ C).
    - exact J.
    - now apply stationary_joint_null.
    - intros i Hi. replace i with 0%nat by lia. rewrite one_part. symmetry. exact (total_weight_one _ _ _ C).
    - intros i j Hi Hj. replace i with 0%nat by lia. replace j with 0%nat by lia.
      transitivity 1; [unfold joint; lra|].
      unfold block_sum. rewrite one_part, <- (total_weight_one _ _ _ C).
      apply sum_ext. intros k Hk. rewrite one_part. unfold joint.
      rewrite sum_scale, (row_sum_one _ _ _ C) by assumption. lra. }
  apply Rle_trans with (2 := refinement_of_several_states_never_lowers_mutual_information _ _ _ _ _ _ _ H).
  unfold mutual_information. simpl. rewrite xlog2_nonzero by lra.
  replace (1 / 1) with 1 by field. rewrite log2_1. lra.
Qed.

(* I <= H: no probability is above one, so the entropy rate is not negative. *)
Theorem mutual_information_at_most_entropy : forall n w P,
  markov_chain n w P -> stationary n w P -> mutual_information n w P <= entropy n w.
Proof.
  intros n w P C S. rewrite mutual_information_is_entropy_less_entropy_rate by assumption.
  enough (sum n (fun i => sum n (fun j => w i * xlog2 (P i j) 1)) <= 0) by (unfold entropy_rate; lra).
  rewrite <- (sum_zero n (fun _ => 0)) by auto. apply sum_le. intros i Hi.
  rewrite <- (sum_zero n (fun _ => 0)) by auto. apply sum_le. intros j Hj.
  assert (Hw := weight_nonneg _ _ _ C i Hi). assert (Hp := transition_nonneg _ _ _ C i j Hi Hj).
  assert (P i j <= 1).
  { rewrite <- (row_sum_one _ _ _ C i Hi). apply (term_le_sum n (fun j => P i j)); [|exact Hj].
    intros. now apply (transition_nonneg _ _ _ C). }
  destruct (Req_dec (P i j) 0) as [->|H0]; [rewrite xlog2_0; lra|].
  rewrite xlog2_nonzero by assumption. replace (P i j / 1) with (P i j) by field.
  assert (log2 (P i j) <= 0) by (rewrite <- log2_1; apply log2_le; lra).
  assert (P i j * log2 (P i j) <= 0) by nra. nra.
Qed.
