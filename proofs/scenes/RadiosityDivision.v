(* Sections 3.4 and 5, dividing a patch of constant radiosity and reflectance: the hypotheses of Theorem 1 hold when the
   radiosity equation holds on the parts; with the printed constants B_i, E_i, R_i kept, (a) and (b) hold and mutual
   information does not fall, but the rows of the parts need not sum to one. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement StateRefinement Theorem1 WeightedScene
  DividedScene ConstantParts Radiosity.
Open Scope R_scope.

(* ---- The radiosity equation holds on the parts ----
   The parts have the radiosity of their patch; their reflectance and emittance may be their own (with the reflectance
   of the patch, the emittance follows from what each part gathers). For radiosity that varies: PiecewiseScenes.v. *)
Section Solved.
Variables (n s m : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance emittance radiosity : nat -> R.
Variables (part_area : nat -> R) (part_form_factor : nat -> nat -> R).
Variables part_reflectance part_emittance : nat -> R.
Hypothesis patches : radiosity_solution n area form_factor reflectance emittance radiosity.
Hypothesis parts : radiosity_solution (n - 1 + m) part_area part_form_factor part_reflectance part_emittance
  (inherited (parent_state n s) radiosity).
Hypothesis division : divided_patch n s m area form_factor part_area part_form_factor.

Theorem dividing_a_patch_of_constant_radiosity_fulfils_hypotheses_of_theorem_1 :
  refines_state n s m
    (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity)
    (radiosity_weight (n - 1 + m) part_area part_reflectance part_emittance (inherited (parent_state n s) radiosity))
    (radiosity_transition part_form_factor part_reflectance part_emittance (inherited (parent_state n s) radiosity)).
Proof.
  destruct (radiosity_chain_is_generalized_chain _ _ _ _ _ _ patches) as [EW EP].
  destruct (radiosity_chain_is_generalized_chain _ _ _ _ _ _ parts) as [EW' EP'].
  assert (Hsub : forall k, (k < m)%nat -> (substate n s k < n - 1 + m)%nat).
  { intros k Hk. apply substate_below; [exact (patch_below _ _ _ _ _ _ _ division) | assumption]. }
  assert (Hm := some_subpatch _ _ _ _ _ _ _ division).
  destruct (dividing_a_patch_fulfils_hypotheses_of_theorem_1 n s m area form_factor radiosity part_area
    part_form_factor (radiosity_patches _ _ _ _ _ _ patches) (radiosity_patches _ _ _ _ _ _ parts) division
    (radiosity_positive _ _ _ _ _ _ patches) (gathered_radiosity_positive _ _ _ _ _ _ patches)
    (gathered_radiosity_positive _ _ _ _ _ _ parts)) as [H1 H2 H3 H4 H5 H6].
  constructor; try assumption.
  - intros j Hj Hjs. rewrite EW', EW by lia. auto.
  - intros i j Hi Hj His Hjs. rewrite EP', EP by lia. auto.
  - intros k j Hk Hj. unfold joint. rewrite !EW', !EP' by auto. apply H5; assumption.
  - intros j Hj Hjs. rewrite EP, H6 by assumption. apply sum_ext. intros k Hk. rewrite EP' by lia. reflexivity.
Qed.

Theorem dividing_a_patch_of_constant_radiosity_never_lowers_mutual_information :
  mutual_information n
    (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity)
  <= mutual_information (n - 1 + m)
       (radiosity_weight (n - 1 + m) part_area part_reflectance part_emittance
          (inherited (parent_state n s) radiosity))
       (radiosity_transition part_form_factor part_reflectance part_emittance
          (inherited (parent_state n s) radiosity)).
Proof.
  assert (Hs := patch_below _ _ _ _ _ _ _ division). assert (Hm := some_subpatch _ _ _ _ _ _ _ division).
  apply refinement_never_lowers_mutual_information with (s := s).
  - apply radiosity_chain_is_markov with (form_factor := form_factor); [assumption | lia].
  - destruct patches. apply radiosity_chain_is_reciprocal; auto;
      [apply (reflectance_nonzero _ _ _ _ _ _ patches) | apply (radiosity_differs_from_emittance _ _ _ _ _ _ patches)].
  - apply radiosity_chain_is_markov with (form_factor := part_form_factor); [assumption | lia].
  - exact dividing_a_patch_of_constant_radiosity_fulfils_hypotheses_of_theorem_1.
Qed.
End Solved.

(* ---- As printed: the parts keep B_i, E_i and R_i ---- *)

(* (B_i - E_i) / R_i, what the patch receives on average. *)
Definition received_radiosity (reflectance emittance radiosity : nat -> R) (i : nat) : R :=
  (radiosity i - emittance i) / reflectance i.

Lemma radiosity_weight_is_constant_weight : forall n area reflectance emittance radiosity i,
  radiosity_weight n area reflectance emittance radiosity i
  = constant_weight n area radiosity (received_radiosity reflectance emittance radiosity) i.
Proof. reflexivity. Qed.

Lemma radiosity_transition_is_constant_transition : forall form_factor reflectance emittance radiosity i j,
  reflectance i <> 0 -> radiosity i <> emittance i ->
  radiosity_transition form_factor reflectance emittance radiosity i j
  = constant_transition form_factor radiosity (received_radiosity reflectance emittance radiosity) i j.
Proof.
  intros. unfold radiosity_transition, constant_transition, received_radiosity. field. lra.
Qed.

Section Printed.
Variables (n N : nat) (parent : nat -> nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance emittance radiosity : nat -> R.
Variables (part_area : nat -> R) (part_form_factor : nat -> nat -> R).
Hypothesis patches : radiosity_solution n area form_factor reflectance emittance radiosity.
Hypothesis parts : scene N part_area part_form_factor.
Hypothesis division : divided_scene n N parent area form_factor part_area part_form_factor.

Let part_weight := radiosity_weight N part_area
  (inherited parent reflectance) (inherited parent emittance) (inherited parent radiosity).
Let part_transition := radiosity_transition part_form_factor
  (inherited parent reflectance) (inherited parent emittance) (inherited parent radiosity).
Let q := received_radiosity reflectance emittance radiosity.

Lemma received_radiosity_positive : forall i, (i < n)%nat -> 0 < q i.
Proof.
  intros i Hi. assert (H := reflects_light _ _ _ _ _ _ patches i Hi). apply Rdiv_lt_0_compat; [lra |].
  now apply (positive_reflectance _ _ _ _ _ _ patches).
Qed.

Lemma part_transition_is_constant : forall k l, (k < N)%nat ->
  part_transition k l = constant_transition part_form_factor (inherited parent radiosity) (inherited parent q) k l.
Proof.
  intros k l Hk. assert (Hi := parent_of_part _ _ _ _ _ _ _ division k Hk).
  apply radiosity_transition_is_constant_transition.
  - apply (reflectance_nonzero _ _ _ _ _ _ patches _ Hi).
  - apply (radiosity_differs_from_emittance _ _ _ _ _ _ patches _ Hi).
Qed.

Lemma patch_transition_is_constant : forall i j, (i < n)%nat ->
  radiosity_transition form_factor reflectance emittance radiosity i j
  = constant_transition form_factor radiosity q i j.
Proof.
  intros i j Hi. apply radiosity_transition_is_constant_transition.
  - apply (reflectance_nonzero _ _ _ _ _ _ patches _ Hi).
  - apply (radiosity_differs_from_emittance _ _ _ _ _ _ patches _ Hi).
Qed.

(* (a) *)
Theorem printed_parts_are_reciprocal : reciprocal N part_weight part_transition.
Proof.
  intros k l Hk Hl. unfold joint. rewrite !part_transition_is_constant by assumption.
  apply (constant_parts_are_reciprocal n N parent area form_factor radiosity q part_area part_form_factor
    division parts received_radiosity_positive); assumption.
Qed.

(* (b) *)
Theorem printed_parts_cover : forall k j, (k < N)%nat -> (j < n)%nat ->
  part_sum N parent j (part_form_factor k) = form_factor (parent k) j ->
  radiosity_transition form_factor reflectance emittance radiosity (parent k) j
  = part_sum N parent j (part_transition k).
Proof.
  intros k j Hk Hj H. assert (Hi := parent_of_part _ _ _ _ _ _ _ division k Hk).
  rewrite patch_transition_is_constant by assumption.
  rewrite (constant_parts_cover n N parent form_factor radiosity q part_form_factor k j Hk Hj H).
  apply part_sum_ext. intros l _ _. symmetry. now apply part_transition_is_constant.
Qed.

Theorem printed_parts_refine_the_radiosity_chain :
  refines n N parent (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity) part_weight part_transition.
Proof.
  destruct (constant_parts_refine_the_chain n N parent area form_factor radiosity q part_area part_form_factor
    division parts (radiosity_positive _ _ _ _ _ _ patches) received_radiosity_positive) as [H1 H2 H3 H4 H5 H6].
  constructor; try assumption.
  - intros k l Hk Hl. unfold joint. rewrite part_transition_is_constant by assumption. now apply H3.
  - intros k l Hk Hl. unfold joint. rewrite part_transition_is_constant by assumption. now apply H4.
  - intros i j Hi Hj. unfold joint at 1. rewrite patch_transition_is_constant by assumption.
    etransitivity; [exact (H6 i j Hi Hj) |]. unfold block_sum. apply part_sum_ext. intros k Hk _.
    apply part_sum_ext. intros l Hl _. unfold joint. now rewrite part_transition_is_constant.
Qed.

Theorem printed_parts_never_lower_mutual_information :
  mutual_information n (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity)
  <= mutual_information N part_weight part_transition.
Proof.
  exact (refinement_of_several_states_never_lowers_mutual_information _ _ _ _ _ _ _
    printed_parts_refine_the_radiosity_chain).
Qed.

(* The row of a part sums to one exactly when the radiosity equation holds on that part. *)
Theorem printed_part_row_sums_to_one_iff : forall k, (k < N)%nat ->
  sum N (part_transition k) = 1 <->
  inherited parent radiosity k = inherited parent emittance k
    + inherited parent reflectance k * sum N (fun l => part_form_factor k l * inherited parent radiosity l).
Proof.
  intros k Hk. assert (Hi := parent_of_part _ _ _ _ _ _ _ division k Hk).
  rewrite (sum_ext N _ (fun l => constant_transition part_form_factor (inherited parent radiosity)
    (inherited parent q) k l)) by (intros; now apply part_transition_is_constant).
  rewrite constant_transition_row by (apply Rgt_not_eq, (received_radiosity_positive _ Hi)).
  fold (gathered N part_form_factor (inherited parent radiosity) k).
  set (g := gathered N part_form_factor (inherited parent radiosity) k).
  unfold q, received_radiosity, inherited.
  assert (Hr := positive_reflectance _ _ _ _ _ _ patches _ Hi). split; intro H.
  - rewrite H. field. lra.
  - apply (Rmult_eq_reg_l (reflectance (parent k))); [| lra].
    transitivity (radiosity (parent k) - emittance (parent k)).
    + lra.
    + field. lra.
Qed.
End Printed.

(* An example where it does not: of patch 0, one half sees patch 1 and the other half is dark.
   A = (2, 1), R = 1/2, E = (3/2, 1), B = (2, 2): the rows of the halves sum to 2 and to 0. *)
Definition half_dark_area (i : nat) : R := match i with O => 2 | _ => 1 end.
Definition half_dark_form_factor (i j : nat) : R :=
  match i, j with 0%nat, 1%nat => 1 / 2 | 1%nat, 0%nat => 1 | _, _ => 0 end.
Definition half_dark_part_form_factor (i j : nat) : R :=
  match i, j with 0%nat, 1%nat => 1 | 1%nat, 0%nat => 1 | _, _ => 0 end.
Definition half_dark_emittance (i : nat) : R := match i with O => 3 / 2 | _ => 1 end.

Theorem printed_parts_need_not_be_a_markov_chain :
  radiosity_solution 2 half_dark_area half_dark_form_factor (fun _ => 1 / 2) half_dark_emittance (fun _ => 2) /\
  scene 3 (fun _ => 1) half_dark_part_form_factor /\
  divided_patch 2 0 2 half_dark_area half_dark_form_factor (fun _ => 1) half_dark_part_form_factor /\
  sum 3 (radiosity_transition half_dark_part_form_factor (fun _ => 1 / 2)
           (inherited (parent_state 2 0) half_dark_emittance) (fun _ => 2) 0%nat) = 2 /\
  sum 3 (radiosity_transition half_dark_part_form_factor (fun _ => 1 / 2)
           (inherited (parent_state 2 0) half_dark_emittance) (fun _ => 2) 2%nat) = 0.
Proof.
  split; [| split; [| split; [| split]]].
  - constructor; [constructor | ..].
    + intros [| i] _; simpl; lra.
    + intros [| [| i]] [| [| j]] _ _; simpl; lra.
    + intros [| [| i]] [| [| j]] Hi Hj; simpl; try lra; lia.
    + intros [| [| i]] Hi; simpl; try lra; lia.
    + intros; lra.
    + intros [| i] _; simpl; lra.
    + intros [| i] _; simpl; lra.
  - constructor.
    + intros; lra.
    + intros [| [| i]] [| [| j]] _ _; simpl; lra.
    + intros [| [| i]] [| [| j]] Hi Hj; simpl; lra.
  - constructor; try lia.
    + intros [| j] _ H; simpl; [lia | reflexivity].
    + simpl. lra.
    + intros [| [| i]] [| [| j]] Hi Hj H1 H2; simpl; try lia; reflexivity.
    + intros [| [| j]] Hj H; simpl; try lia; lra.
    + simpl. lra.
  - unfold radiosity_transition, inherited, parent_state. simpl. field.
  - unfold radiosity_transition, inherited, parent_state. simpl. field.
Qed.
