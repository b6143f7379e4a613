(* The heuristic of section 3.2: the state of largest weight is the one whose regular subdivision has the largest bound
   on the gain, eq. (6) summed over j. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums Refinement StateRefinement Theorem1 PairGain GainFormula.
Open Scope R_scope.

(* The sum over j of the bounds (6), for state i divided regularly into m. *)
Definition bound_on_gain (n m : nat) (w : nat -> R) (P : nat -> nat -> R) (i : nat) : R :=
  sum n (fun j => 2 * w i * P i j * log2 (INR m)).

Theorem bound_on_gain_is_weight_times_log : forall n m w P i, markov_chain n w P -> (i < n)%nat ->
  bound_on_gain n m w P i = 2 * w i * log2 (INR m).
Proof. intros n m w P i C Hi. apply bound_summed_over_receivers. now apply (row_sum_one _ _ _ C). Qed.

Lemma log2_of_two_or_more_parts : forall m, (2 <= m)%nat -> 0 < log2 (INR m).
Proof.
  intros m Hm. rewrite <- log2_1. apply log2_increasing; [lra|]. change 1 with (INR 1). apply lt_INR. lia.
Qed.

(* For m >= 2 the bounds are ordered as the weights. *)
Theorem bounds_are_ordered_as_weights : forall n m w P i j, (2 <= m)%nat -> markov_chain n w P ->
  (i < n)%nat -> (j < n)%nat -> (bound_on_gain n m w P j <= bound_on_gain n m w P i <-> w j <= w i).
Proof.
  intros n m w P i j Hm C Hi Hj. rewrite !bound_on_gain_is_weight_times_log by assumption.
  assert (L := log2_of_two_or_more_parts m Hm). split; intros H.
  - apply (Rmult_le_reg_r (2 * log2 (INR m))); lra.
  - apply (Rmult_le_compat_r (2 * log2 (INR m))) in H; lra.
Qed.

(* So the state to pick "lacking any other knowledge" is one of maximum w, and only such a one. *)
Theorem largest_bound_iff_largest_weight : forall n m w P i, (2 <= m)%nat -> markov_chain n w P -> (i < n)%nat ->
  ((forall j, (j < n)%nat -> bound_on_gain n m w P j <= bound_on_gain n m w P i) <->
   (forall j, (j < n)%nat -> w j <= w i)).
Proof.
  intros n m w P i Hm C Hi. split; intros H j Hj; specialize (H j Hj);
    now apply (bounds_are_ordered_as_weights n m w P i j Hm C Hi Hj).
Qed.

(* There always is a state of maximum weight. *)
Theorem some_state_has_largest_bound : forall n m w P, (2 <= m)%nat -> markov_chain n w P ->
  exists i, (i < n)%nat /\ (forall j, (j < n)%nat -> w j <= w i) /\
    (forall j, (j < n)%nat -> bound_on_gain n m w P j <= bound_on_gain n m w P i).
Proof.
  intros n m w P Hm C.
  assert (n <> 0)%nat by (intros ->; pose proof (total_weight_one _ _ _ C); simpl in *; lra).
  assert (M : exists i, (i < n)%nat /\ forall j, (j < n)%nat -> w j <= w i).
  { clear - H. induction n as [|n IH]; [lia|]. destruct (Nat.eq_dec n 0) as [->|N].
    - exists 0%nat. split; [lia|]. intros j Hj. replace j with 0%nat by lia. lra.
    - destruct IH as [i [Hi M]]; [exact N|]. destruct (Rle_dec (w n) (w i)) as [L|L].
      + exists i. split; [lia|]. intros j Hj. destruct (Nat.eq_dec j n) as [->|]; [exact L|apply M; lia].
      + exists n. split; [lia|]. intros j Hj. destruct (Nat.eq_dec j n) as [->|]; [lra|].
        assert (w j <= w i) by (apply M; lia). lra. }
  destruct M as [i [Hi M]]. exists i. split; [exact Hi|]. split; [exact M|].
  now apply largest_bound_iff_largest_weight.
Qed.

(* No regular refinement, of whichever state, gains more than the bound of a state of maximum weight. *)
Theorem no_regular_refinement_gains_more_than_largest_bound : forall n s m w P w' P' i,
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' -> refines_state n s m w P w' P' ->
  (forall k, (k < m)%nat -> w' (substate n s k) = w s / INR m) -> 0 < w s -> (2 <= m)%nat -> (i < n)%nat ->
  (forall j, (j < n)%nat -> w j <= w i) ->
  mutual_information (n - 1 + m) w' P' - mutual_information n w P <= bound_on_gain n m w P i.
Proof.
  intros n s m w P w' P' i C K C' R E Hs Hm Hi M.
  apply Rle_trans with (1 := regular_refinement_gains_at_most n s m w P w' P' C K C' R E Hs).
  assert (Hsn := state_below _ _ _ _ _ _ _ R).
  rewrite <- (bound_on_gain_is_weight_times_log n m w P s C Hsn).
  apply largest_bound_iff_largest_weight; assumption.
Qed.
