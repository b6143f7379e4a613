(* Section 2, "the amount of information that the destination patch conveys about the source patch, and vice versa":
   mutual information is the uncertainty about the source less what remains of it once the destination is known, and
   the same with source and destination exchanged. Zero weights and zero probabilities are allowed. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement MutualInformation.
Open Scope R_scope.

(* The probability of having come from i, when now in j: w_i P_ij over the probability of being in j (0 where that is 0). *)
Definition source_given_destination (n : nat) (w : nat -> R) (P : nat -> nat -> R) (j i : nat) : R :=
  joint w P i j / sum n (fun k => joint w P k j).

(* H(next | current) is the entropy rate (2); H(previous | current) is the same for the chain run backwards. *)
Definition entropy_of_destination_given_source (n : nat) (w : nat -> R) (P : nat -> nat -> R) : R :=
  entropy_rate n w P.
Definition entropy_of_source_given_destination (n : nat) (w : nat -> R) (P : nat -> nat -> R) : R :=
  - sum n (fun j => sum n (fun k => joint w P k j) *
                    sum n (fun i => xlog2 (source_given_destination n w P j i) 1)).

(* The joint probabilities read as destination first, source second. *)
Definition information_about (n : nat) (first second : nat -> R) (J : nat -> nat -> R) : R :=
  sum n (fun i => sum n (fun j => xlog2 (J i j) (first i * second j))).

(* I is symmetric in source and destination: transposing the joint probabilities only exchanges two sums. *)
Theorem information_is_symmetric : forall n first second J,
  information_about n first second J = information_about n second first (fun j i => J i j).
Proof.
  intros n f g J. unfold information_about. rewrite sum_exchange.
  apply sum_ext. intros j _. apply sum_ext. intros i _. now rewrite Rmult_comm.
Qed.

Theorem mutual_information_is_information_about : forall n w P,
  mutual_information n w P = information_about n w w (joint w P).
Proof. exact mutual_information_of_joint. Qed.

(* In a reciprocal chain the source seen from the destination is distributed as the destination seen from the source. *)
Theorem reciprocal_chain_runs_backwards_alike : forall n w P,
  markov_chain n w P -> reciprocal n w P ->
  forall i j, (i < n)%nat -> (j < n)%nat -> w j <> 0 -> source_given_destination n w P j i = P j i.
Proof.
  intros n w P C K i j Hi Hj Hw. unfold source_given_destination.
  rewrite (reciprocal_is_stationary n w P C K j Hj), (K i j Hi Hj). unfold joint. now field.
Qed.

(* Hence H(previous | current) = H(next | current). *)
Theorem conditional_entropies_agree_for_reciprocal_chain : forall n w P,
  markov_chain n w P -> reciprocal n w P ->
  entropy_of_source_given_destination n w P = entropy_of_destination_given_source n w P.
Proof.
  intros n w P C K. unfold entropy_of_source_given_destination, entropy_of_destination_given_source, entropy_rate.
  f_equal. apply sum_ext. intros j Hj. rewrite (reciprocal_is_stationary n w P C K j Hj), sum_scale.
  destruct (Req_dec (w j) 0) as [->|Hw]; [lra|]. f_equal. apply sum_ext. intros i Hi.
  now rewrite (reciprocal_chain_runs_backwards_alike n w P C K).
Qed.

(* The two readings of I agree for every stationary chain, reciprocal or not: H less H(source | destination)
   is I, since J_ij log (J_ij / w_j) = J_ij log (J_ij / (w_i w_j)) + J_ij log w_i, and row i sums to w_i. *)
Theorem mutual_information_is_what_destination_tells_of_source : forall n w P,
  markov_chain n w P -> stationary n w P ->
  mutual_information n w P = entropy n w - entropy_of_source_given_destination n w P.
Proof.
  intros n w P C S.
  assert (J : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= joint w P i j).
  { intros. apply Rmult_le_pos; [now apply (weight_nonneg _ _ _ C)|now apply (transition_nonneg _ _ _ C)]. }
  assert (Z := stationary_joint_null n w P J S).
  unfold entropy, entropy_of_source_given_destination.
  rewrite mutual_information_of_joint, sum_exchange.
  transitivity (sum n (fun j => sum n (fun i => w j * xlog2 (source_given_destination n w P j i) 1 - joint w P i j * log2 (w i)))).
  - apply sum_ext. intros j Hj. apply sum_ext. intros i Hi.
    unfold source_given_destination. rewrite (S j Hj).
    destruct (Req_dec (joint w P i j) 0) as [E|E].
    { rewrite E. unfold Rdiv. rewrite Rmult_0_l, !xlog2_0. lra. }
    assert (w j <> 0) by (intros E'; apply E; now apply Z).
    assert (w i <> 0) by (intros E'; apply E; unfold joint; rewrite E'; lra).
    assert (H1 := weight_nonneg _ _ _ C i Hi). assert (H2 := weight_nonneg _ _ _ C j Hj). specialize (J i j Hi Hj).
    assert (0 < joint w P i j / w j) by (apply Rdiv_lt_0_compat; lra).
    rewrite !xlog2_nonzero by lra.
    rewrite (log2_div (joint w P i j) (w i * w j)) by (first [lra|apply Rmult_lt_0_compat; lra]).
    rewrite (log2_mult (w i)), (log2_div (joint w P i j / w j)), (log2_div (joint w P i j)), log2_1 by lra. field. lra.
  - rewrite (sum_ext n _ (fun j => w j * sum n (fun i => xlog2 (source_given_destination n w P j i) 1) -
      sum n (fun i => joint w P i j * log2 (w i)))) by (intros; rewrite sum_minus, sum_scale; reflexivity).
    rewrite sum_minus, (sum_exchange n n (fun j i => joint w P i j * log2 (w i))).
    rewrite (sum_ext n (fun i => sum n (fun j => joint w P i j * log2 (w i))) (fun i => xlog2 (w i) 1)).
    + rewrite (sum_ext n (fun j => w j * sum n (fun i => xlog2 (source_given_destination n w P j i) 1))
        (fun j => sum n (fun k => joint w P k j) * sum n (fun i => xlog2 (source_given_destination n w P j i) 1)))
        by (intros j Hj; now rewrite (S j Hj)). lra.
    + intros i Hi. rewrite sum_scale_right. unfold joint. rewrite sum_scale, (row_sum_one _ _ _ C) by assumption.
      destruct (Req_dec (w i) 0) as [->|H0]; [rewrite xlog2_0; lra|].
      rewrite xlog2_nonzero by assumption. replace (w i / 1) with (w i) by field. lra.
Qed.

(* "And vice versa": what the destination tells of the source is what the source tells of the destination. *)
Theorem source_and_destination_tell_the_same_of_each_other : forall n w P,
  markov_chain n w P -> stationary n w P ->
  entropy n w - entropy_of_source_given_destination n w P =
  entropy n w - entropy_of_destination_given_source n w P.
Proof.
  intros n w P C S. rewrite <- mutual_information_is_what_destination_tells_of_source by assumption.
  now apply mutual_information_is_entropy_less_entropy_rate.
Qed.
