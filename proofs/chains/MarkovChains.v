(* Section 2, the words: a Markov chain on the states 0 .. n-1 is a weight for each state and a transition probability
   for each pair; its mutual information (8), reciprocity and stationarity. *)
From Coq Require Import Reals Lra.
From Infoscene Require Import Sums Information FiniteSums.
Open Scope R_scope.

(* The paper's eq. (8): sum over i, j of w_i P_ij log (P_ij / w_j). *)
Definition mutual_information (n : nat) (weight : nat -> R) (transition : nat -> nat -> R) : R :=
  sum n (fun i => sum n (fun j => weight i * xlog2 (transition i j) (weight j))).

(* The probability w_i P_ij of being in i now and in j next. *)
Definition joint (weight : nat -> R) (transition : nat -> nat -> R) (i j : nat) : R :=
  weight i * transition i j.

(* Probabilities are not negative, the weights sum to one, and so does each row. *)
Record markov_chain (n : nat) (weight : nat -> R) (transition : nat -> nat -> R) : Prop := {
  weight_nonneg : forall i, (i < n)%nat -> 0 <= weight i;
  transition_nonneg : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= transition i j;
  total_weight_one : sum n weight = 1;
  row_sum_one : forall i, (i < n)%nat -> sum n (fun j => transition i j) = 1
}.

(* w_i P_ij = w_j P_ji. *)
Definition reciprocal (n : nat) (weight : nat -> R) (transition : nat -> nat -> R) : Prop :=
  forall i j, (i < n)%nat -> (j < n)%nat -> joint weight transition i j = joint weight transition j i.

(* w_j = sum over i of w_i P_ij. *)
Definition stationary (n : nat) (weight : nat -> R) (transition : nat -> nat -> R) : Prop :=
  forall j, (j < n)%nat -> sum n (fun i => joint weight transition i j) = weight j.

(* Reciprocity and rows that sum to one give stationarity. *)
Lemma reciprocal_is_stationary : forall n w P,
  markov_chain n w P -> reciprocal n w P -> stationary n w P.
Proof.
  intros n w P C H j Hj. rewrite (sum_ext n _ (fun i => w j * P j i)).
  - rewrite sum_scale, (row_sum_one _ _ _ C) by assumption. lra.
  - intros i Hi. now apply H.
Qed.

(* Eq. (8) in joint probabilities: J_ij log (J_ij / (w_i w_j)). *)
Lemma mutual_information_of_joint : forall n w P,
  mutual_information n w P = sum n (fun i => sum n (fun j => xlog2 (joint w P i j) (w i * w j))).
Proof.
  intros. apply sum_ext. intros i _. apply sum_ext. intros j _. unfold joint. now rewrite xlog2_scale.
Qed.
