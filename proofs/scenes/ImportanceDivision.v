(* Section 3.5, dividing a patch of constant importance and reflectance: the hypotheses of Theorem 1 hold when the
   importance equation holds on the parts; with the printed constants I_i, V_i, R_i kept, (a) and (b) hold and mutual
   information does not fall, but the row of a part sums to one only if the equation holds on it. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement StateRefinement Theorem1 WeightedScene
  DividedScene ConstantParts Importance.
Open Scope R_scope.

(* ---- The importance equation holds on the parts ----
   The parts have the reflectance and importance of their patch; their initial importance is what the equation
   leaves. For importance that varies: PiecewiseScenes.v. *)
Section Solved.
Variables (n s m : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance initial_importance importance : nat -> R.
Variables (part_area : nat -> R) (part_form_factor : nat -> nat -> R).
Variable part_initial_importance : nat -> R.
Hypothesis patches : importance_solution n area form_factor reflectance initial_importance importance.
Hypothesis parts : importance_solution (n - 1 + m) part_area part_form_factor (inherited (parent_state n s) reflectance)
  part_initial_importance (inherited (parent_state n s) importance).
Hypothesis division : divided_patch n s m area form_factor part_area part_form_factor.

Theorem dividing_a_patch_of_constant_importance_fulfils_hypotheses_of_theorem_1 :
  refines_state n s m
    (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance)
    (importance_weight (n - 1 + m) part_area (inherited (parent_state n s) reflectance)
       part_initial_importance (inherited (parent_state n s) importance))
    (importance_transition part_form_factor (inherited (parent_state n s) reflectance)
       part_initial_importance (inherited (parent_state n s) importance)).
Proof.
  destruct (importance_chain_is_generalized_chain _ _ _ _ _ _ patches) as [EW EP].
  destruct (importance_chain_is_generalized_chain _ _ _ _ _ _ parts) as [EW' EP'].
  assert (Hsub : forall k, (k < m)%nat -> (substate n s k < n - 1 + m)%nat).
  { intros k Hk. apply substate_below; [exact (patch_below _ _ _ _ _ _ _ division) | assumption]. }
  assert (Hm := some_subpatch _ _ _ _ _ _ _ division).
  destruct (dividing_a_patch_fulfils_hypotheses_of_theorem_1 n s m area form_factor
    (reflected_importance reflectance importance) part_area
    part_form_factor (importance_patches _ _ _ _ _ _ patches) (importance_patches _ _ _ _ _ _ parts) division
    (reflected_importance_positive _ _ _ _ _ _ patches) (gathered_importance_positive _ _ _ _ _ _ patches)
    (gathered_importance_positive _ _ _ _ _ _ parts)) as [H1 H2 H3 H4 H5 H6].
  constructor; try assumption.
  - intros j Hj Hjs. rewrite EW', EW by lia. auto.
  - intros i j Hi Hj His Hjs. rewrite EP', EP by lia. auto.
  - intros k j Hk Hj. unfold joint. rewrite !EW', !EP' by auto. apply H5; assumption.
  - intros j Hj Hjs. rewrite EP, H6 by assumption. apply sum_ext. intros k Hk. rewrite EP' by lia. reflexivity.
Qed.

Theorem dividing_a_patch_of_constant_importance_never_lowers_mutual_information :
  mutual_information n
    (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance)
  <= mutual_information (n - 1 + m)
       (importance_weight (n - 1 + m) part_area (inherited (parent_state n s) reflectance) part_initial_importance
          (inherited (parent_state n s) importance))
       (importance_transition part_form_factor (inherited (parent_state n s) reflectance) part_initial_importance
          (inherited (parent_state n s) importance)).
Proof.
  assert (Hs := patch_below _ _ _ _ _ _ _ division). assert (Hm := some_subpatch _ _ _ _ _ _ _ division).
  apply refinement_never_lowers_mutual_information with (s := s).
  - apply importance_chain_is_markov with (form_factor := form_factor); [assumption | lia].
  - destruct patches. apply importance_chain_is_reciprocal; auto.
    apply (importance_differs _ _ _ _ _ _ patches).
  - apply importance_chain_is_markov with (form_factor := part_form_factor); [assumption | lia].
  - exact dividing_a_patch_of_constant_importance_fulfils_hypotheses_of_theorem_1.
Qed.
End Solved.

(* ---- As printed: the parts keep I_i, V_i and R_i ---- *)

(* I_i - V_i, what the patch gathers on average. *)
Definition received_importance (initial_importance importance : nat -> R) (i : nat) : R :=
  importance i - initial_importance i.

Lemma importance_weight_is_constant_weight : forall n area reflectance initial_importance importance i,
  importance_weight n area reflectance initial_importance importance i
  = constant_weight n area (reflected_importance reflectance importance)
      (received_importance initial_importance importance) i.
Proof. reflexivity. Qed.

Lemma importance_transition_is_constant_transition : forall form_factor reflectance initial_importance importance i j,
  importance_transition form_factor reflectance initial_importance importance i j
  = constant_transition form_factor (reflected_importance reflectance importance)
      (received_importance initial_importance importance) i j.
Proof.
  intros. unfold importance_transition, constant_transition, received_importance, reflected_importance, Rdiv. ring.
Qed.

Section Printed.
Variables (n N : nat) (parent : nat -> nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance initial_importance importance : nat -> R.
Variables (part_area : nat -> R) (part_form_factor : nat -> nat -> R).
Hypothesis patches : importance_solution n area form_factor reflectance initial_importance importance.
Hypothesis parts : scene N part_area part_form_factor.
Hypothesis division : divided_scene n N parent area form_factor part_area part_form_factor.

Let part_weight := importance_weight N part_area
  (inherited parent reflectance) (inherited parent initial_importance) (inherited parent importance).
Let part_transition := importance_transition part_form_factor
  (inherited parent reflectance) (inherited parent initial_importance) (inherited parent importance).
Let x := reflected_importance reflectance importance.
Let q := received_importance initial_importance importance.

Lemma received_importance_positive : forall i, (i < n)%nat -> 0 < q i.
Proof.
  intros i Hi. assert (H := gathers_importance _ _ _ _ _ _ patches i Hi).
  unfold q, received_importance. lra.
Qed.

Lemma part_importance_transition_is_constant : forall k l,
  part_transition k l = constant_transition part_form_factor (inherited parent x) (inherited parent q) k l.
Proof. intros. apply importance_transition_is_constant_transition. Qed.

(* (a) *)
Theorem printed_importance_parts_are_reciprocal : reciprocal N part_weight part_transition.
Proof.
  intros k l Hk Hl. unfold joint. rewrite !part_importance_transition_is_constant.
  apply (constant_parts_are_reciprocal n N parent area form_factor x q part_area part_form_factor
    division parts received_importance_positive); assumption.
Qed.

(* (b) *)
Theorem printed_importance_parts_cover : forall k j, (k < N)%nat -> (j < n)%nat ->
  part_sum N parent j (part_form_factor k) = form_factor (parent k) j ->
  importance_transition form_factor reflectance initial_importance importance (parent k) j
  = part_sum N parent j (part_transition k).
Proof.
  intros k j Hk Hj H. rewrite importance_transition_is_constant_transition. fold x. fold q.
  rewrite (constant_parts_cover n N parent form_factor x q part_form_factor k j Hk Hj H).
  apply part_sum_ext. intros l _ _. symmetry. apply part_importance_transition_is_constant.
Qed.

Theorem printed_importance_parts_refine_the_chain :
  refines n N parent (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance) part_weight part_transition.
Proof.
  destruct (constant_parts_refine_the_chain n N parent area form_factor x q part_area part_form_factor
    division parts (reflected_importance_positive _ _ _ _ _ _ patches) received_importance_positive)
    as [H1 H2 H3 H4 H5 H6].
  constructor; try assumption.
  - intros k l Hk Hl. unfold joint. rewrite part_importance_transition_is_constant. now apply H3.
  - intros k l Hk Hl. unfold joint. rewrite part_importance_transition_is_constant. now apply H4.
  - intros i j Hi Hj. unfold joint at 1. rewrite importance_transition_is_constant_transition.
    etransitivity; [exact (H6 i j Hi Hj) |]. unfold block_sum. apply part_sum_ext. intros k Hk _.
    apply part_sum_ext. intros l Hl _. unfold joint. now rewrite part_importance_transition_is_constant.
Qed.

Theorem printed_importance_parts_never_lower_mutual_information :
  mutual_information n (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance)
  <= mutual_information N part_weight part_transition.
Proof.
  exact (refinement_of_several_states_never_lowers_mutual_information _ _ _ _ _ _ _
    printed_importance_parts_refine_the_chain).
Qed.

(* The row of a part sums to one exactly when the importance equation holds on that part. *)
Theorem printed_importance_part_row_sums_to_one_iff : forall k, (k < N)%nat ->
  sum N (part_transition k) = 1 <->
  inherited parent importance k = inherited parent initial_importance k
    + sum N (fun l => inherited parent reflectance l * part_form_factor k l * inherited parent importance l).
Proof.
  intros k Hk. assert (Hi := parent_of_part _ _ _ _ _ _ _ division k Hk).
  rewrite (sum_ext N _ (fun l => constant_transition part_form_factor (inherited parent x)
    (inherited parent q) k l)) by (intros; apply part_importance_transition_is_constant).
  rewrite constant_transition_row by (apply Rgt_not_eq, (received_importance_positive _ Hi)).
  rewrite (sum_ext N (fun l => inherited parent reflectance l * part_form_factor k l * inherited parent importance l)
    (fun l => part_form_factor k l * inherited parent x l))
    by (intros; unfold inherited, x, reflected_importance; ring).
  fold (gathered N part_form_factor (inherited parent x) k).
  unfold q, received_importance, inherited at 2 3 4. split; intro H; lra.
Qed.
End Printed.
