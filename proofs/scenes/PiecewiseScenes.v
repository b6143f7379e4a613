(* Sections 3.4 and 3.5 for radiosities (importances) that vary over a patch: patches are made of many small elements on
   which the radiosity (importance) equation holds, and the paper's integrals are sums over elements. Patches and parts
   of patches, whatever they are made of, then fulfil the hypotheses of Theorem 1. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement WeightedScene Radiosity Importance Corollary1
  Grouping.
Open Scope R_scope.

(* The weight of a patch: the sum over its elements of A B (B - E) / R, before normalisation. *)
Definition patch_radiosity_area (N : nat) (patch : nat -> nat) (area reflectance emittance radiosity : nat -> R)
    (i : nat) : R :=
  part_sum N patch i (fun k => area k * radiosity k * ((radiosity k - emittance k) / reflectance k)).

(* P_ij: the sum over elements k of i and l of j of A_k F_kl B_k B_l, over the weight. *)
Definition patch_radiosity_transition (N : nat) (patch : nat -> nat) (area : nat -> R) (form_factor : nat -> nat -> R)
    (reflectance emittance radiosity : nat -> R) (i j : nat) : R :=
  block_sum N patch i j (fun k l => area k * form_factor k l * (radiosity k * radiosity l))
  / patch_radiosity_area N patch area reflectance emittance radiosity i.

Section Radiosity.
Variables (N : nat) (area : nat -> R) (form_factor : nat -> nat -> R) (reflectance emittance radiosity : nat -> R).
Hypothesis some_element : (0 < N)%nat.
Hypothesis elements : radiosity_solution N area form_factor reflectance emittance radiosity.

Let w := radiosity_weight N area reflectance emittance radiosity.
Let P := radiosity_transition form_factor reflectance emittance radiosity.
Let total := sum N (radiosity_area area reflectance emittance radiosity).

Lemma radiosity_total_positive : 0 < total.
Proof.
  unfold total. destruct elements as [S H H1 H2 H3].
  rewrite (sum_ext N _ _ (radiosity_area_is_generalized_area N area form_factor reflectance emittance radiosity H
    (reflectance_nonzero _ _ _ _ _ _ elements))).
  apply total_generalized_area_positive; auto.
  - exact (radiosity_positive _ _ _ _ _ _ elements).
  - exact (gathered_radiosity_positive _ _ _ _ _ _ elements).
Qed.

Lemma radiosity_weight_positive : forall k, (k < N)%nat -> 0 < w k.
Proof.
  intros k Hk. apply Rdiv_lt_0_compat; [| exact radiosity_total_positive].
  unfold radiosity_area. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat |].
  - exact (area_positive _ _ _ (radiosity_patches _ _ _ _ _ _ elements) k Hk).
  - exact (radiosity_positive _ _ _ _ _ _ elements k Hk).
  - assert (H := reflects_light _ _ _ _ _ _ elements k Hk).
    apply Rdiv_lt_0_compat; [lra | exact (positive_reflectance _ _ _ _ _ _ elements k Hk)].
Qed.

Lemma elements_are_reciprocal : reciprocal N w P.
Proof.
  destruct elements as [S H _ _ _]. apply radiosity_chain_is_reciprocal; auto;
    [exact (reflectance_nonzero _ _ _ _ _ _ elements) | exact (radiosity_differs_from_emittance _ _ _ _ _ _ elements)].
Qed.

(* The paper's w_i and P_ij are those of the grouped chain; its normalising factor is the sum over all elements. *)
Theorem patch_radiosity_weight_is_grouped : forall patch i,
  patch_radiosity_area N patch area reflectance emittance radiosity i / total = grouped_weight N patch w i.
Proof. intros. unfold patch_radiosity_area, Rdiv at 1. now rewrite <- part_sum_scale_right. Qed.

Theorem patch_radiosity_transition_is_grouped : forall patch i j,
  patch_radiosity_transition N patch area form_factor reflectance emittance radiosity i j
  = grouped_transition N patch w P i j.
Proof.
  intros patch i j. assert (HT := radiosity_total_positive).
  unfold patch_radiosity_transition, grouped_transition. rewrite <- patch_radiosity_weight_is_grouped.
  replace (block_sum N patch i j (joint w P))
    with (block_sum N patch i j (fun k l => area k * form_factor k l * (radiosity k * radiosity l)) / total).
  - set (b := block_sum N patch i j _). set (a := patch_radiosity_area _ _ _ _ _ _ _).
    unfold Rdiv. rewrite Rinv_mult, Rinv_inv. transitivity (b * / a * (total * / total)); [| ring].
    rewrite Rinv_r by lra. ring.
  - unfold block_sum, Rdiv. rewrite <- part_sum_scale_right. apply part_sum_ext. intros k Hk _.
    rewrite <- part_sum_scale_right. apply part_sum_ext. intros l Hl _.
    destruct elements as [S H _ _ _]. unfold w, P.
    assert (Hr := reflectance_nonzero _ _ _ _ _ _ elements).
    assert (Hd := radiosity_differs_from_emittance _ _ _ _ _ _ elements).
    rewrite (radiosity_joint N area form_factor reflectance emittance radiosity H Hr Hd k l Hk Hl).
    rewrite generalized_joint by now apply (gathered_radiosity_nonzero N form_factor reflectance emittance radiosity).
    unfold Rdiv, total. now rewrite (sum_ext N _ _ (radiosity_area_is_generalized_area N area form_factor reflectance
      emittance radiosity H Hr)).
Qed.

(* Rows sum to one, weights are reciprocal, and any finer parts refine the patches. *)
Theorem patch_radiosity_chain_is_markov_and_reciprocal : forall n patch, groups n N patch ->
  markov_chain n (grouped_weight N patch w) (grouped_transition N patch w P) /\
  reciprocal n (grouped_weight N patch w) (grouped_transition N patch w P).
Proof.
  intros n patch G. split.
  - apply grouped_chain_is_markov; [assumption | | exact radiosity_weight_positive].
    now apply (radiosity_chain_is_markov N area form_factor).
  - apply grouped_chain_is_reciprocal; [assumption | exact elements_are_reciprocal | exact radiosity_weight_positive].
Qed.

Theorem parts_refine_patches_of_varying_radiosity : forall n m part patch, groups m N part -> groups n m patch ->
  refines n m patch
    (grouped_weight N (fun k => patch (part k)) w) (grouped_transition N (fun k => patch (part k)) w P)
    (grouped_weight N part w) (grouped_transition N part w P).
Proof.
  intros n m part patch Gm Gn. apply finer_grouping_refines_coarser; try assumption.
  - now apply (radiosity_chain_is_markov N area form_factor).
  - exact elements_are_reciprocal.
  - exact radiosity_weight_positive.
Qed.
End Radiosity.

(* ---- Importance: radiosity with B = R I and E = R V ---- *)

Theorem importance_solution_is_radiosity_solution : forall n area form_factor reflectance initial_importance importance,
  importance_solution n area form_factor reflectance initial_importance importance ->
  radiosity_solution n area form_factor reflectance
    (reflected_importance reflectance initial_importance) (reflected_importance reflectance importance).
Proof.
  intros n A F r V I [S H Hr HV HI]. constructor; auto.
  - now apply reflected_importance_solves_radiosity_equation.
  - intros i Hi. apply Rmult_le_pos; [left; auto | auto].
  - intros i Hi. apply Rmult_lt_compat_l; auto.
Qed.

(* R_i cancels from (R_i I_i - R_i V_i) / R_i. *)
Theorem importance_area_is_radiosity_area : forall area reflectance initial_importance importance i,
  reflectance i <> 0 ->
  importance_area area reflectance initial_importance importance i
  = radiosity_area area reflectance
      (reflected_importance reflectance initial_importance) (reflected_importance reflectance importance) i.
Proof. intros. unfold importance_area, radiosity_area, reflected_importance. field. assumption. Qed.

Theorem importance_transition_is_radiosity_transition :
  forall form_factor reflectance initial_importance importance i j, reflectance i <> 0 ->
  importance i <> initial_importance i ->
  importance_transition form_factor reflectance initial_importance importance i j
  = radiosity_transition form_factor reflectance
      (reflected_importance reflectance initial_importance) (reflected_importance reflectance importance) i j.
Proof.
  intros F r V I i j Hr Hd. unfold importance_transition, radiosity_transition, reflected_importance.
  field. repeat split; try lra. rewrite <- Rmult_minus_distr_l. apply Rmult_integral_contrapositive_currified; lra.
Qed.

(* Sums over elements of A R I (I - V), and of A_k F_kl R_k R_l I_k I_l. *)
Definition patch_importance_area (N : nat) (patch : nat -> nat)
    (area reflectance initial_importance importance : nat -> R) (i : nat) : R :=
  part_sum N patch i (fun k => area k * (reflectance k * importance k) * (importance k - initial_importance k)).

Definition patch_importance_transition (N : nat) (patch : nat -> nat) (area : nat -> R) (form_factor : nat -> nat -> R)
    (reflectance initial_importance importance : nat -> R) (i j : nat) : R :=
  block_sum N patch i j
    (fun k l => form_factor k l * (area k * (reflectance k * reflectance l) * (importance k * importance l)))
  / patch_importance_area N patch area reflectance initial_importance importance i.

Section Importance.
Variables (N : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance initial_importance importance : nat -> R.
Hypothesis some_element : (0 < N)%nat.
Hypothesis elements : importance_solution N area form_factor reflectance initial_importance importance.

Lemma element_reflectance_nonzero : forall k, (k < N)%nat -> reflectance k <> 0.
Proof. intros k Hk. apply Rgt_not_eq. exact (importance_reflectance_positive _ _ _ _ _ _ elements k Hk). Qed.

Let w := importance_weight N area reflectance initial_importance importance.
Let P := importance_transition form_factor reflectance initial_importance importance.
Let total := sum N (importance_area area reflectance initial_importance importance).

Lemma importance_weight_positive : forall k, (k < N)%nat -> 0 < w k.
Proof.
  intros k Hk.
  assert (H := radiosity_weight_positive N area form_factor reflectance _ _ some_element
    (importance_solution_is_radiosity_solution _ _ _ _ _ _ elements) k Hk).
  unfold radiosity_weight in H.
  rewrite <- (sum_ext N _ _ (fun l Hl => importance_area_is_radiosity_area area reflectance
    initial_importance importance l (element_reflectance_nonzero l Hl))) in H.
  rewrite <- importance_area_is_radiosity_area in H by now apply element_reflectance_nonzero. exact H.
Qed.

Lemma importance_elements_are_reciprocal : reciprocal N w P.
Proof.
  apply (importance_chain_is_reciprocal N area form_factor).
  - exact (importance_solves _ _ _ _ _ _ elements).
  - exact (importance_differs _ _ _ _ _ _ elements).
  - exact (importance_patches _ _ _ _ _ _ elements).
Qed.

Lemma importance_total_nonzero : total <> 0.
Proof.
  intro E. assert (H := importance_weight_positive 0%nat some_element). unfold w, importance_weight in H.
  fold total in H. rewrite E in H. unfold Rdiv in H. rewrite Rinv_0 in H. lra.
Qed.

Theorem patch_importance_weight_is_grouped : forall patch i,
  patch_importance_area N patch area reflectance initial_importance importance i / total = grouped_weight N patch w i.
Proof. intros. unfold patch_importance_area, Rdiv. now rewrite <- part_sum_scale_right. Qed.

Theorem patch_importance_transition_is_grouped : forall patch i j,
  patch_importance_transition N patch area form_factor reflectance initial_importance importance i j
  = grouped_transition N patch w P i j.
Proof.
  intros patch i j. assert (HT := importance_total_nonzero).
  unfold patch_importance_transition, grouped_transition. rewrite <- patch_importance_weight_is_grouped.
  replace (block_sum N patch i j (joint w P)) with (block_sum N patch i j (fun k l =>
    form_factor k l * (area k * (reflectance k * reflectance l) * (importance k * importance l))) / total).
  - set (b := block_sum N patch i j _). set (a := patch_importance_area _ _ _ _ _ _ _).
    unfold Rdiv. rewrite Rinv_mult, Rinv_inv. transitivity (b * / a * (total * / total)); [| ring].
    rewrite Rinv_r by assumption. ring.
  - unfold block_sum, Rdiv. rewrite <- part_sum_scale_right. apply part_sum_ext. intros k Hk _.
    rewrite <- part_sum_scale_right. apply part_sum_ext. intros l Hl _.
    assert (Hd := importance_differs _ _ _ _ _ _ elements k Hk).
    unfold joint, w, P, importance_weight, importance_transition. fold total. unfold importance_area. field. lra.
Qed.

Theorem patch_importance_chain_is_markov_and_reciprocal : forall n patch, groups n N patch ->
  markov_chain n (grouped_weight N patch w) (grouped_transition N patch w P) /\
  reciprocal n (grouped_weight N patch w) (grouped_transition N patch w P).
Proof.
  intros n patch G. split.
  - apply grouped_chain_is_markov; [assumption | | exact importance_weight_positive].
    now apply (importance_chain_is_markov N area form_factor).
  - apply grouped_chain_is_reciprocal; [assumption | | exact importance_weight_positive].
    exact importance_elements_are_reciprocal.
Qed.

Theorem parts_refine_patches_of_varying_importance : forall n m part patch, groups m N part -> groups n m patch ->
  refines n m patch
    (grouped_weight N (fun k => patch (part k)) w) (grouped_transition N (fun k => patch (part k)) w P)
    (grouped_weight N part w) (grouped_transition N part w P).
Proof.
  intros n m part patch Gm Gn. apply finer_grouping_refines_coarser; try assumption.
  - now apply (importance_chain_is_markov N area form_factor).
  - exact importance_elements_are_reciprocal.
  - exact importance_weight_positive.
Qed.
End Importance.
