(* Eq. (9): the mutual information of the refined chain is the sum of four blocks. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums Refinement StateRefinement GainFormula.
Open Scope R_scope.

(* A double sum over the refined states, by blocks: other to other, other to sub-state, sub-state to other, and
   sub-state to sub-state. It holds for any labels of the other states and needs no hypothesis on the chain. *)
Theorem refined_mutual_information_is_sum_of_four_blocks : forall n s m w' P', (s < n)%nat -> (1 <= m)%nat ->
  mutual_information (n - 1 + m) w' P' =
    sum_others n s (fun i => sum_others n s (fun j => w' i * xlog2 (P' i j) (w' j))) +
    sum_others n s (fun i => sum m (fun k => w' i * xlog2 (P' i (substate n s k)) (w' (substate n s k)))) +
    sum m (fun k => sum_others n s (fun j => w' (substate n s k) * xlog2 (P' (substate n s k) j) (w' j))) +
    sum m (fun k => sum m (fun l =>
      w' (substate n s k) * xlog2 (P' (substate n s k) (substate n s l)) (w' (substate n s l)))).
Proof.
  intros n s m w' P' Hs Hm. destruct m as [|q]; [lia|]. unfold mutual_information.
  replace (n - 1 + S q)%nat with (n + q)%nat by lia.
  rewrite (sum_others_and_substates n q s) by exact Hs.
  rewrite (sum_others_ext n s _ (fun i => sum_others n s (fun j => w' i * xlog2 (P' i j) (w' j)) +
    sum (S q) (fun k => w' i * xlog2 (P' i (substate n s k)) (w' (substate n s k)))))
    by (intros; now apply sum_others_and_substates).
  rewrite (sum_ext (S q) _ (fun k => sum_others n s (fun j => w' (substate n s k) * xlog2 (P' (substate n s k) j) (w' j)) +
    sum (S q) (fun l => w' (substate n s k) * xlog2 (P' (substate n s k) (substate n s l)) (w' (substate n s l)))))
    by (intros; now apply sum_others_and_substates).
  rewrite sum_others_plus, sum_plus. lra.
Qed.

(* The paper refines the last of n states; sums over the others then are sums over i < n - 1. *)
Theorem refined_mutual_information_with_last_state_refined : forall n m w' P', (1 <= n)%nat -> (1 <= m)%nat ->
  mutual_information (n - 1 + m) w' P' =
    sum (n - 1) (fun i => sum (n - 1) (fun j => w' i * xlog2 (P' i j) (w' j))) +
    sum (n - 1) (fun i => sum m (fun k => w' i * xlog2 (P' i (n - 1 + k)%nat) (w' (n - 1 + k)%nat))) +
    sum m (fun k => sum (n - 1) (fun j => w' (n - 1 + k)%nat * xlog2 (P' (n - 1 + k)%nat j) (w' j))) +
    sum m (fun k => sum m (fun l =>
      w' (n - 1 + k)%nat * xlog2 (P' (n - 1 + k)%nat (n - 1 + l)%nat) (w' (n - 1 + l)%nat))).
Proof.
  intros n m w' P' Hn Hm. unfold mutual_information. rewrite sum_append.
  rewrite (sum_ext (n - 1) _ (fun i => sum (n - 1) (fun j => w' i * xlog2 (P' i j) (w' j)) +
    sum m (fun k => w' i * xlog2 (P' i (n - 1 + k)%nat) (w' (n - 1 + k)%nat)))) by (intros; apply sum_append).
  rewrite (sum_ext m _ (fun k => sum (n - 1) (fun j => w' (n - 1 + k)%nat * xlog2 (P' (n - 1 + k)%nat j) (w' j)) +
    sum m (fun l => w' (n - 1 + k)%nat * xlog2 (P' (n - 1 + k)%nat (n - 1 + l)%nat) (w' (n - 1 + l)%nat))))
    by (intros; apply sum_append).
  rewrite !sum_plus. lra.
Qed.
