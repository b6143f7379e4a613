(* Refinement of any number of states at once: when every refined state has a parent, and weights and joint
   probabilities of the coarse chain are sums over the parts, mutual information does not fall; and when it
   stays the same. This is the general statement behind the paper's Theorem 1 (see Theorem1.v). *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums LogSum.
From Infoscene Require Export MarkovChains.
Open Scope R_scope.

(* ---- Refinement by a parent map ---- *)

(* Every refined state k < N lies in the coarse state parent k < n; the refined chain has no negative
   probabilities and no joint probability where there is no weight; coarse weights and coarse joint
   probabilities are the sums over the parts. *)
Record refines (n N : nat) (parent : nat -> nat)
    (w : nat -> R) (P : nat -> nat -> R) (w' : nat -> R) (P' : nat -> nat -> R) : Prop := {
  parent_below : forall k, (k < N)%nat -> (parent k < n)%nat;
  refined_weight_nonneg : forall k, (k < N)%nat -> 0 <= w' k;
  refined_joint_nonneg : forall k l, (k < N)%nat -> (l < N)%nat -> 0 <= joint w' P' k l;
  refined_joint_null : forall k l, (k < N)%nat -> (l < N)%nat -> w' l = 0 -> joint w' P' k l = 0;
  weight_of_parts : forall i, (i < n)%nat -> w i = part_sum N parent i w';
  joint_of_parts : forall i j, (i < n)%nat -> (j < n)%nat ->
    joint w P i j = block_sum N parent i j (joint w' P')
}.

(* The joint-null condition holds when the refined chain is stationary, so in particular when it is reciprocal. *)
Lemma stationary_joint_null : forall N w P,
  (forall k l, (k < N)%nat -> (l < N)%nat -> 0 <= joint w P k l) -> stationary N w P ->
  forall k l, (k < N)%nat -> (l < N)%nat -> w l = 0 -> joint w P k l = 0.
Proof.
  intros N w P J S k l Hk Hl E.
  apply (sum_nonneg_zero N (fun k => joint w P k l)); auto.
  rewrite S by assumption. exact E.
Qed.

Section Refinement.
Variables (n N : nat) (parent : nat -> nat).
Variables (w : nat -> R) (P : nat -> nat -> R) (w' : nat -> R) (P' : nat -> nat -> R).
Hypothesis refinement : refines n N parent w P w' P'.

Let J := joint w P.
Let J' := joint w' P'.
Let in_block (i j k l : nat) := (Nat.eqb (parent k) i && Nat.eqb (parent l) j)%bool.

(* What the parts of i and of j contribute to the refined mutual information. *)
Definition block_information (i j : nat) : R :=
  block_sum N parent i j (fun k l => xlog2 (joint w' P' k l) (w' k * w' l)).

(* The log-sum inequality in one block, and its equality case. *)
Lemma block_log_sum : forall i j, (i < n)%nat -> (j < n)%nat ->
  xlog2 (J i j) (w i * w j) <= block_information i j /\
  (block_information i j = xlog2 (J i j) (w i * w j) <->
   forall k l, (k < N)%nat -> (l < N)%nat -> parent k = i -> parent l = j ->
     J' k l * (w i * w j) = w' k * w' l * J i j).
Proof.
  intros i j Hi Hj.
  pose (a := fun k l => if in_block i j k l then J' k l else 0).
  pose (b := fun k l => if in_block i j k l then w' k * w' l else 0).
  assert (EJ : J i j = sum N (fun k => sum N (fun l => a k l))).
  { unfold J. rewrite (joint_of_parts _ _ _ _ _ _ _ refinement), block_sum_masked by assumption. reflexivity. }
  assert (Ew : w i * w j = sum N (fun k => sum N (fun l => b k l))).
  { rewrite !(weight_of_parts _ _ _ _ _ _ _ refinement), <- block_sum_product, block_sum_masked by assumption.
    reflexivity. }
  assert (EI : block_information i j = sum N (fun k => sum N (fun l => xlog2 (a k l) (b k l)))).
  { unfold block_information. rewrite block_sum_masked. apply sum_ext. intros k _.
    apply sum_ext. intros l _. unfold a, b, in_block, J'. destruct (_ && _)%bool; [reflexivity|].
    now rewrite xlog2_0. }
  assert (Ha : forall k l, (k < N)%nat -> (l < N)%nat -> 0 <= a k l).
  { intros k l Hk Hl. unfold a. destruct (in_block i j k l); [|lra].
    now apply (refined_joint_nonneg _ _ _ _ _ _ _ refinement). }
  assert (Hb : forall k l, (k < N)%nat -> (l < N)%nat -> 0 <= b k l).
  { intros k l Hk Hl. unfold b. destruct (in_block i j k l); [|lra].
    apply Rmult_le_pos; now apply (refined_weight_nonneg _ _ _ _ _ _ _ refinement). }
  assert (Hab : forall k l, (k < N)%nat -> (l < N)%nat -> b k l = 0 -> a k l = 0).
  { intros k l Hk Hl. unfold a, b. destruct (in_block i j k l); [|auto]. intros E.
    apply Rmult_integral in E. destruct E as [E|E].
    - unfold J', joint. rewrite E. lra.
    - now apply (refined_joint_null _ _ _ _ _ _ _ refinement). }
  rewrite EJ, Ew, EI. split.
  - now apply log_sum_inequality_of_double_sums.
  - rewrite (log_sum_equality_of_double_sums N N a b) by assumption. unfold a at 1, b at 2. split.
    + intros E k l Hk Hl Ek El. specialize (E k l Hk Hl). unfold in_block in E.
      now rewrite Ek, El, !Nat.eqb_refl in E.
    + intros E k l Hk Hl. unfold in_block.
      destruct (Nat.eqb_spec (parent k) i), (Nat.eqb_spec (parent l) j); simpl; try lra.
      now apply E.
Qed.

(* The refined mutual information is the sum of its blocks. *)
Lemma mutual_information_of_blocks :
  mutual_information N w' P' = sum n (fun i => sum n (fun j => block_information i j)).
Proof.
  rewrite mutual_information_of_joint. symmetry. apply sum_over_blocks.
  exact (parent_below _ _ _ _ _ _ _ refinement).
Qed.

(* Theorem 1 for several states at once: add up the blocks. *)
Theorem refinement_of_several_states_never_lowers_mutual_information :
  mutual_information n w P <= mutual_information N w' P'.
Proof.
  rewrite mutual_information_of_blocks, mutual_information_of_joint.
  apply sum_le. intros i Hi. apply sum_le. intros j Hj. now apply block_log_sum.
Qed.

(* Nothing is gained exactly when each joint probability is the product share of its block:
   J'_kl / (w'_k w'_l) = J_ij / (w_i w_j) for the parents i of k and j of l. *)
Theorem several_states_equal_mutual_information :
  mutual_information N w' P' = mutual_information n w P <->
  (forall k l, (k < N)%nat -> (l < N)%nat ->
     joint w' P' k l * (w (parent k) * w (parent l)) =
     w' k * w' l * joint w P (parent k) (parent l)).
Proof.
  rewrite mutual_information_of_blocks, mutual_information_of_joint. split.
  - intros E k l Hk Hl.
    assert (Hi := parent_below _ _ _ _ _ _ _ refinement k Hk). assert (Hj := parent_below _ _ _ _ _ _ _ refinement l Hl).
    symmetry in E.
    assert (Ei := sum_le_eq n _ _ (fun i Hi => sum_le n _ _ (fun j Hj =>
      proj1 (block_log_sum i j Hi Hj))) E _ Hi). simpl in Ei.
    assert (Ej := sum_le_eq n _ _ (fun j Hj => proj1 (block_log_sum _ j Hi Hj)) Ei _ Hj). simpl in Ej.
    symmetry in Ej.
    now apply (proj1 (proj2 (block_log_sum (parent k) (parent l) Hi Hj)) Ej).
  - intros E. apply sum_ext. intros i Hi. apply sum_ext. intros j Hj.
    apply (block_log_sum i j Hi Hj). intros k l Hk Hl <- <-. now apply E.
Qed.

(* The same in transition probabilities, for positive weights: P'_kl / w'_l = P_ij / w_j. *)
Corollary several_states_equal_transition_ratios :
  (forall k, (k < N)%nat -> 0 < w' k) ->
  mutual_information N w' P' = mutual_information n w P <->
  (forall k l, (k < N)%nat -> (l < N)%nat ->
     P' k l / w' l = P (parent k) (parent l) / w (parent l)).
Proof.
  intros Hw. rewrite several_states_equal_mutual_information.
  assert (Hp : forall k, (k < N)%nat -> 0 < w (parent k)).
  { intros k Hk. rewrite (weight_of_parts _ _ _ _ _ _ _ refinement) by now apply (parent_below _ _ _ _ _ _ _ refinement).
    apply Rlt_le_trans with (1 := Hw k Hk). unfold part_sum.
    replace (w' k) with (if Nat.eqb (parent k) (parent k) then w' k else 0) by now rewrite Nat.eqb_refl.
    apply (term_le_sum N (fun l => if Nat.eqb (parent l) (parent k) then w' l else 0)); [|assumption].
    intros l Hl. destruct (Nat.eqb (parent l) (parent k)); [|lra]. left. now apply Hw. }
  split; intros E k l Hk Hl; specialize (E k l Hk Hl);
    assert (H1 := Hw k Hk); assert (H2 := Hw l Hl);
    assert (H3 := Hp k Hk); assert (H4 := Hp l Hl); unfold joint in *.
  - apply (Rmult_eq_reg_r (w' k * w' l * (w (parent k) * w (parent l)))).
    + transitivity (w' k * P' k l * (w (parent k) * w (parent l))); [field; lra|]. rewrite E. field. lra.
    + repeat apply Rmult_integral_contrapositive_currified; lra.
  - transitivity (P' k l / w' l * (w' k * w' l * (w (parent k) * w (parent l)))); [field; lra|].
    rewrite E. field. lra.
Qed.
End Refinement.
