(* The discrete form of the paper's Corollary 1: along successive refinements mutual information grows; it is
   bounded by that of any common refinement; and where it is bounded it converges to its least upper bound, which
   is the least upper bound over every discretization that the sequence refines sooner or later. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement StateRefinement Theorem1.
Open Scope R_scope.

Record chain : Type := {
  states : nat;
  weight : nat -> R;
  transition : nat -> nat -> R
}.

Definition information (C : chain) : R := mutual_information (states C) (weight C) (transition C).

(* D is a refinement of C: some parent map makes it one. *)
Definition refined_by (C D : chain) : Prop :=
  exists parent, refines (states C) (states D) parent (weight C) (transition C) (weight D) (transition D).

(* A refinement of one state under the hypotheses of Theorem 1 is one. *)
Theorem state_refinement_is_refinement : forall n s m w P w' P',
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' ->
  refines_state n s m w P w' P' ->
  refined_by {| states := n; weight := w; transition := P |}
             {| states := n - 1 + m; weight := w'; transition := P' |}.
Proof. intros n s m w P w' P' C K C' H. exists (parent_state n s). now apply state_refinement_refines. Qed.

(* A stationary chain refines itself. *)
Theorem refined_by_itself : forall n w P, markov_chain n w P -> stationary n w P ->
  refined_by {| states := n; weight := w; transition := P |} {| states := n; weight := w; transition := P |}.
Proof.
  intros n w P C S. exists (fun k => k).
  assert (J : forall k l, (k < n)%nat -> (l < n)%nat -> 0 <= joint w P k l).
  { intros. apply Rmult_le_pos; [now apply (weight_nonneg _ _ _ C)|now apply (transition_nonneg _ _ _ C)]. }
  split; simpl.
  - auto.
  - exact (weight_nonneg _ _ _ C).
  - exact J.
  - now apply stationary_joint_null.
  - intros i Hi. symmetry. now apply (sum_single n i w).
  - intros i j Hi Hj. unfold block_sum, part_sum. rewrite sum_single by assumption.
    symmetry. now apply (sum_single n j (fun l => joint w P i l)).
Qed.

(* Summing over the parts of the parts. *)
Lemma part_sum_of_part_sums : forall n N p q i f, (forall k, (k < N)%nat -> (q k < n)%nat) ->
  part_sum n p i (fun k => part_sum N q k f) = part_sum N (fun l => p (q l)) i f.
Proof.
  intros n N p q i f H. unfold part_sum.
  transitivity (sum n (fun k => sum N (fun l =>
    if Nat.eqb (q l) k then (if Nat.eqb (p k) i then f l else 0) else 0))).
  - apply sum_ext. intros k _. destruct (Nat.eqb (p k) i); [reflexivity|].
    symmetry. apply sum_zero. intros l _. now destruct (Nat.eqb (q l) k).
  - rewrite sum_exchange. apply sum_ext. intros l Hl.
    apply (sum_single_sym n (q l) (fun k => if Nat.eqb (p k) i then f l else 0)). auto.
Qed.

Lemma block_sum_of_block_sums : forall n N p q i j f, (forall k, (k < N)%nat -> (q k < n)%nat) ->
  block_sum n p i j (fun k l => block_sum N q k l f) = block_sum N (fun x => p (q x)) i j f.
Proof.
  intros n N p q i j f H. unfold block_sum. rewrite <- (part_sum_of_part_sums n N p q) by assumption.
  apply part_sum_ext. intros k _ _.
  transitivity (part_sum N q k (fun x => part_sum n p j (fun l => part_sum N q l (fun y => f x y)))).
  - unfold part_sum at 1. unfold part_sum at 2. unfold part_sum at 3.
    rewrite <- (sum_ext n (fun l => sum N (fun x => if Nat.eqb (q x) k then
      (if Nat.eqb (p l) j then part_sum N q l (fun y => f x y) else 0) else 0))).
    + rewrite sum_exchange. apply sum_ext. intros x _. destruct (Nat.eqb (q x) k); [reflexivity|].
      now apply sum_zero.
    + intros l _. destruct (Nat.eqb (p l) j); [reflexivity|]. apply sum_zero. intros x _.
      now destruct (Nat.eqb (q x) k).
  - apply part_sum_ext. intros x _ _. now apply part_sum_of_part_sums.
Qed.

(* A refinement of a refinement is a refinement: the parent of the parent. *)
Theorem refined_by_transitive : forall C D E, refined_by C D -> refined_by D E -> refined_by C E.
Proof.
  intros C D E [p HC] [q HD]. exists (fun x => p (q x)).
  assert (Hq := parent_below _ _ _ _ _ _ _ HD). split.
  - intros k Hk. apply (parent_below _ _ _ _ _ _ _ HC). auto.
  - exact (refined_weight_nonneg _ _ _ _ _ _ _ HD).
  - exact (refined_joint_nonneg _ _ _ _ _ _ _ HD).
  - exact (refined_joint_null _ _ _ _ _ _ _ HD).
  - intros i Hi. rewrite (weight_of_parts _ _ _ _ _ _ _ HC) by assumption.
    rewrite <- (part_sum_of_part_sums (states D) (states E) p q) by assumption.
    apply sum_ext. intros k Hk. rewrite (weight_of_parts _ _ _ _ _ _ _ HD) by assumption. reflexivity.
  - intros i j Hi Hj. rewrite (joint_of_parts _ _ _ _ _ _ _ HC) by assumption.
    rewrite <- (block_sum_of_block_sums (states D) (states E) p q) by assumption.
    unfold block_sum at 1 2, part_sum at 1 2 3 4. apply sum_ext. intros k Hk.
    destruct (Nat.eqb (p k) i); [|reflexivity]. apply sum_ext. intros l Hl.
    rewrite (joint_of_parts _ _ _ _ _ _ _ HD) by assumption. reflexivity.
Qed.

(* Theorem 1 in these terms; so a common refinement bounds the mutual information of all it refines. *)
Theorem refinement_bounds_information : forall C D, refined_by C D -> information C <= information D.
Proof.
  intros C D [p H]. exact (refinement_of_several_states_never_lowers_mutual_information _ _ _ _ _ _ _ H).
Qed.

(* ---- A sequence of refinements ---- *)

Section Sequence.
Variable U : nat -> chain.
Hypothesis each_refines_the_one_before : forall t, refined_by (U t) (U (S t)).

Theorem information_grows : Un_growing (fun t => information (U t)).
Proof. intros t. now apply refinement_bounds_information. Qed.

Theorem later_refines_earlier : forall t d, refined_by (U t) (U (S d + t)).
Proof.
  intros t. induction d as [|d IH]; simpl in *; [apply each_refines_the_one_before|].
  now apply refined_by_transitive with (1 := IH).
Qed.

(* Where mutual information is bounded it converges, and the limit is its least upper bound. *)
Theorem information_converges_to_least_upper_bound : has_ub (fun t => information (U t)) ->
  exists limit, Un_cv (fun t => information (U t)) limit /\ is_lub (EUn (fun t => information (U t))) limit.
Proof.
  intros B. destruct (completeness _ B (EUn_noempty _)) as [l L]. exists l. split; [|exact L].
  apply Un_cv_crit_lub; [exact information_grows|exact L].
Qed.

(* So it does below a common refinement. *)
Corollary information_converges_below_common_refinement : forall C, (forall t, refined_by (U t) C) ->
  exists limit, limit <= information C /\ Un_cv (fun t => information (U t)) limit /\
    is_lub (EUn (fun t => information (U t))) limit.
Proof.
  intros C H.
  assert (B : is_upper_bound (EUn (fun t => information (U t))) (information C)).
  { intros x [t ->]. now apply refinement_bounds_information. }
  destruct information_converges_to_least_upper_bound as [l [L1 L2]]; [now exists (information C)|].
  exists l. split; [now apply L2|now split].
Qed.

(* Corollary 1: let the sequence be taken from a family of discretizations, each of which it refines sooner or
   later. If its mutual information converges, the limit is the least upper bound over the whole family. *)
Theorem limit_is_least_upper_bound_over_discretizations :
  forall (discretization : chain -> Prop) limit,
  (forall t, discretization (U t)) ->
  (forall C, discretization C -> exists t, refined_by C (U t)) ->
  Un_cv (fun t => information (U t)) limit ->
  is_lub (fun x => exists C, discretization C /\ x = information C) limit.
Proof.
  intros F l HU HF L. split.
  - intros x [C [HC ->]]. destruct (HF C HC) as [t Ht].
    apply Rle_trans with (1 := refinement_bounds_information _ _ Ht).
    exact (growing_ineq _ _ information_grows L t).
  - intros b Hb. destruct (Rle_or_lt l b) as [|Hlt]; [assumption|exfalso].
    destruct (L (l - b) ltac:(lra)) as [t Ht]. specialize (Ht t ltac:(lia)).
    assert (information (U t) <= b) by (apply Hb; exists (U t); auto).
    unfold R_dist in Ht. apply Rabs_def2 in Ht. lra.
Qed.

(* A bound that holds in scenes: where P_ij <= M w_j (a bounded A_T F), no mutual information exceeds log M. *)
Lemma information_at_most_log_of_density : forall n w P M, 0 < M -> markov_chain n w P ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> P i j <= M * w j) -> mutual_information n w P <= log2 M.
Proof.
  intros n w P M HM C H.
  assert (T : sum n (fun i => sum n (fun j => w i * (P i j * log2 M))) = log2 M).
  { rewrite (sum_ext n _ (fun i => w i * log2 M)).
    - rewrite sum_scale_right, (total_weight_one _ _ _ C). lra.
    - intros i Hi. rewrite sum_scale, sum_scale_right, (row_sum_one _ _ _ C) by assumption. lra. }
  rewrite <- T. apply sum_le. intros i Hi. apply sum_le. intros j Hj.
  apply Rmult_le_compat_l; [now apply (weight_nonneg _ _ _ C)|].
  assert (Hp := transition_nonneg _ _ _ C i j Hi Hj). specialize (H i j Hi Hj).
  destruct (Req_dec (P i j) 0) as [->|H0]; [rewrite xlog2_0; lra|].
  rewrite xlog2_nonzero by assumption. apply Rmult_le_compat_l; [exact Hp|].
  assert (Hw : 0 < w j) by (destruct (Rle_or_lt (w j) 0); [nra|assumption]).
  apply log2_le; [apply Rdiv_lt_0_compat; lra|].
  apply (Rmult_le_reg_r (w j)); [exact Hw|]. replace (P i j / w j * w j) with (P i j) by (field; lra). exact H.
Qed.

Corollary information_of_bounded_density_converges : forall M, 0 < M ->
  (forall t, markov_chain (states (U t)) (weight (U t)) (transition (U t))) ->
  (forall t i j, (i < states (U t))%nat -> (j < states (U t))%nat ->
     transition (U t) i j <= M * weight (U t) j) ->
  exists limit, limit <= log2 M /\ Un_cv (fun t => information (U t)) limit /\
    is_lub (EUn (fun t => information (U t))) limit.
Proof.
  intros M HM C H.
  assert (B : is_upper_bound (EUn (fun t => information (U t))) (log2 M)).
  { intros x [t ->]. apply information_at_most_log_of_density; auto. }
  destruct information_converges_to_least_upper_bound as [l [L1 L2]]; [now exists (log2 M)|].
  exists l. split; [now apply L2|now split].
Qed.
End Sequence.
