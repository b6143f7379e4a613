(* Section 3.4, radiosities and reflectances constant along each patch: with B_j in the numerator of P_ij (the paper
   prints B_i) rows sum to one, and the printed weights are stationary and reciprocal. Section 5: the sum over j. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement WeightedScene.
Open Scope R_scope.

(* B_i = E_i + R_i sum_j F_ij B_j. *)
Definition radiosity_equation (n : nat) (form_factor : nat -> nat -> R)
    (reflectance emittance radiosity : nat -> R) : Prop :=
  forall i, (i < n)%nat ->
    radiosity i = emittance i + reflectance i * sum n (fun j => form_factor i j * radiosity j).

(* A_i B_i (B_i - E_i) / R_i, before normalisation. *)
Definition radiosity_area (area reflectance emittance radiosity : nat -> R) (i : nat) : R :=
  area i * radiosity i * ((radiosity i - emittance i) / reflectance i).

Definition radiosity_weight (n : nat) (area reflectance emittance radiosity : nat -> R) (i : nat) : R :=
  radiosity_area area reflectance emittance radiosity i / sum n (radiosity_area area reflectance emittance radiosity).

(* R_i F_ij B_j / (B_i - E_i). *)
Definition radiosity_transition (form_factor : nat -> nat -> R) (reflectance emittance radiosity : nat -> R)
    (i j : nat) : R :=
  reflectance i * form_factor i j * radiosity j / (radiosity i - emittance i).

(* As printed: R_i F_ij B_i / (B_i - E_i). *)
Definition printed_radiosity_transition (form_factor : nat -> nat -> R) (reflectance emittance radiosity : nat -> R)
    (i j : nat) : R :=
  reflectance i * form_factor i j * radiosity i / (radiosity i - emittance i).

Section Radiosity.
Variables (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance emittance radiosity : nat -> R.
Hypothesis equation : radiosity_equation n form_factor reflectance emittance radiosity.
Hypothesis reflecting : forall i, (i < n)%nat -> reflectance i <> 0.
Hypothesis lit : forall i, (i < n)%nat -> radiosity i <> emittance i.

(* The radiosity equation solved for what is gathered. *)
Lemma gathered_radiosity : forall i, (i < n)%nat ->
  gathered n form_factor radiosity i = (radiosity i - emittance i) / reflectance i.
Proof.
  intros i Hi. assert (H := equation i Hi). fold (gathered n form_factor radiosity i) in H.
  assert (Hr := reflecting i Hi).
  replace (radiosity i - emittance i) with (reflectance i * gathered n form_factor radiosity i) by lra.
  field. assumption.
Qed.

Lemma gathered_radiosity_nonzero : forall i, (i < n)%nat -> gathered n form_factor radiosity i <> 0.
Proof.
  intros i Hi H. apply (lit i Hi). rewrite (equation i Hi). fold (gathered n form_factor radiosity i).
  rewrite H. ring.
Qed.

(* So the chain is the one of WeightedScene.v with brightness B. *)
Lemma radiosity_area_is_generalized_area : forall i, (i < n)%nat ->
  radiosity_area area reflectance emittance radiosity i = generalized_area n area form_factor radiosity i.
Proof. intros i Hi. unfold radiosity_area, generalized_area. now rewrite gathered_radiosity. Qed.

Lemma radiosity_weight_is_generalized_weight : forall i, (i < n)%nat ->
  radiosity_weight n area reflectance emittance radiosity i = generalized_weight n area form_factor radiosity i.
Proof.
  intros i Hi. unfold radiosity_weight, generalized_weight.
  rewrite radiosity_area_is_generalized_area by assumption.
  now rewrite (sum_ext n _ _ radiosity_area_is_generalized_area).
Qed.

Lemma radiosity_transition_is_generalized_form_factor : forall i j, (i < n)%nat ->
  radiosity_transition form_factor reflectance emittance radiosity i j
  = generalized_form_factor n form_factor radiosity i j.
Proof.
  intros i j Hi. unfold radiosity_transition, generalized_form_factor. rewrite gathered_radiosity by assumption.
  assert (H1 := reflecting i Hi). assert (H2 := lit i Hi). field. lra.
Qed.

Theorem radiosity_rows_sum_to_one : forall i, (i < n)%nat ->
  sum n (fun j => radiosity_transition form_factor reflectance emittance radiosity i j) = 1.
Proof.
  intros i Hi. rewrite (sum_ext n _ (fun j => generalized_form_factor n form_factor radiosity i j)).
  - now apply generalized_rows_sum_to_one, gathered_radiosity_nonzero.
  - intros j _. now apply radiosity_transition_is_generalized_form_factor.
Qed.

(* As printed, the row of i sums to one only if i gathers what it would if all patches were as bright as itself. *)
Theorem printed_radiosity_row_sums_to_one_iff : forall i, (i < n)%nat ->
  sum n (fun j => printed_radiosity_transition form_factor reflectance emittance radiosity i j) = 1 <->
  sum n (fun j => form_factor i j * radiosity j) = radiosity i * sum n (fun j => form_factor i j).
Proof.
  intros i Hi. assert (H1 := reflecting i Hi). assert (H2 := lit i Hi). assert (H := equation i Hi).
  rewrite (sum_ext n _ (fun j => reflectance i * radiosity i / (radiosity i - emittance i) * form_factor i j))
    by (intros; unfold printed_radiosity_transition, Rdiv; ring).
  rewrite sum_scale. set (g := sum n (fun j => form_factor i j * radiosity j)) in *.
  set (f := sum n (fun j => form_factor i j)). replace (radiosity i - emittance i) with (reflectance i * g) by lra.
  assert (Hg : g <> 0) by (intro E; apply H2; rewrite H, E; ring).
  replace (reflectance i * radiosity i / (reflectance i * g) * f) with (radiosity i * f / g) by (field; auto).
  split; intro E.
  - apply (Rmult_eq_reg_r (/ g)); [| now apply Rinv_neq_0_compat].
    rewrite Rinv_r by assumption. symmetry. exact E.
  - rewrite <- E. now apply Rinv_r.
Qed.

(* Section 5: sum over j of B_i B_j A_i F_ij = A_i B_i (B_i - E_i) / R_i. *)
Theorem sum_of_potential_gains_is_generalized_area : forall i, (i < n)%nat ->
  sum n (fun j => radiosity i * radiosity j * area i * form_factor i j)
  = area i * radiosity i * ((radiosity i - emittance i) / reflectance i).
Proof.
  intros i Hi. rewrite <- gathered_radiosity by assumption. unfold gathered. rewrite <- sum_scale.
  apply sum_ext. intros j _. ring.
Qed.

Hypothesis patches : scene n area form_factor.

(* w_i P_ij is A_i F_ij B_i B_j, over the sum of the weights. *)
Lemma radiosity_joint : forall i j, (i < n)%nat -> (j < n)%nat ->
  joint (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity) i j
  = joint (generalized_weight n area form_factor radiosity) (generalized_form_factor n form_factor radiosity) i j.
Proof.
  intros i j Hi Hj. unfold joint.
  now rewrite radiosity_weight_is_generalized_weight, radiosity_transition_is_generalized_form_factor.
Qed.

(* Also for the weights as printed, without normalisation. *)
Theorem radiosity_reciprocity : forall i j, (i < n)%nat -> (j < n)%nat ->
  radiosity_area area reflectance emittance radiosity i
    * radiosity_transition form_factor reflectance emittance radiosity i j
  = radiosity_area area reflectance emittance radiosity j
      * radiosity_transition form_factor reflectance emittance radiosity j i.
Proof.
  intros i j Hi Hj.
  rewrite !radiosity_area_is_generalized_area, !radiosity_transition_is_generalized_form_factor by assumption.
  rewrite !generalized_flux by now apply gathered_radiosity_nonzero.
  rewrite (form_factor_reciprocity _ _ _ patches i j) by assumption. ring.
Qed.

Theorem radiosity_chain_is_reciprocal :
  reciprocal n (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity).
Proof.
  intros i j Hi Hj. rewrite !radiosity_joint by assumption.
  exact (generalized_chain_is_reciprocal n area form_factor radiosity patches gathered_radiosity_nonzero i j Hi Hj).
Qed.

Theorem radiosity_weights_are_stationary :
  stationary n (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity).
Proof.
  intros j Hj. rewrite radiosity_weight_is_generalized_weight by assumption.
  rewrite (sum_ext n _ (fun i => joint (generalized_weight n area form_factor radiosity)
    (generalized_form_factor n form_factor radiosity) i j)) by (intros; now apply radiosity_joint).
  exact (generalized_weights_are_stationary n area form_factor radiosity patches gathered_radiosity_nonzero j Hj).
Qed.
End Radiosity.

(* ---- With the signs that light has ---- *)

(* A solved scene: R_i > 0, E_i >= 0, and every patch reflects some light: B_i > E_i. *)
Record radiosity_solution (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R)
    (reflectance emittance radiosity : nat -> R) : Prop := {
  radiosity_patches : scene n area form_factor;
  radiosity_solves : radiosity_equation n form_factor reflectance emittance radiosity;
  positive_reflectance : forall i, (i < n)%nat -> 0 < reflectance i;
  emittance_nonneg : forall i, (i < n)%nat -> 0 <= emittance i;
  reflects_light : forall i, (i < n)%nat -> emittance i < radiosity i
}.

Section Signs.
Variables (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance emittance radiosity : nat -> R.
Hypothesis solution : radiosity_solution n area form_factor reflectance emittance radiosity.

Lemma reflectance_nonzero : forall i, (i < n)%nat -> reflectance i <> 0.
Proof. intros i Hi. assert (H := positive_reflectance _ _ _ _ _ _ solution i Hi). lra. Qed.

Lemma radiosity_differs_from_emittance : forall i, (i < n)%nat -> radiosity i <> emittance i.
Proof. intros i Hi. assert (H := reflects_light _ _ _ _ _ _ solution i Hi). lra. Qed.

Lemma radiosity_positive : forall i, (i < n)%nat -> 0 < radiosity i.
Proof.
  intros i Hi. assert (H := reflects_light _ _ _ _ _ _ solution i Hi).
  assert (H0 := emittance_nonneg _ _ _ _ _ _ solution i Hi). lra.
Qed.

Lemma gathered_radiosity_positive : forall i, (i < n)%nat -> 0 < gathered n form_factor radiosity i.
Proof.
  intros i Hi. rewrite (gathered_radiosity n form_factor reflectance emittance radiosity
    (radiosity_solves _ _ _ _ _ _ solution) reflectance_nonzero i Hi).
  assert (H := reflects_light _ _ _ _ _ _ solution i Hi).
  apply Rdiv_lt_0_compat; [lra | now apply (positive_reflectance _ _ _ _ _ _ solution)].
Qed.

(* The weights and transitions of this section are those of WeightedScene.v. *)
Lemma radiosity_chain_is_generalized_chain :
  (forall i, (i < n)%nat -> radiosity_weight n area reflectance emittance radiosity i
     = generalized_weight n area form_factor radiosity i) /\
  (forall i j, (i < n)%nat -> radiosity_transition form_factor reflectance emittance radiosity i j
     = generalized_form_factor n form_factor radiosity i j).
Proof.
  destruct solution. split; intros; [apply radiosity_weight_is_generalized_weight |
    apply radiosity_transition_is_generalized_form_factor];
    auto using reflectance_nonzero, radiosity_differs_from_emittance.
Qed.

Theorem radiosity_chain_is_markov : (0 < n)%nat ->
  markov_chain n (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity).
Proof.
  intros Hn. destruct radiosity_chain_is_generalized_chain as [EW EP].
  destruct (generalized_chain_is_markov n area form_factor radiosity Hn (radiosity_patches _ _ _ _ _ _ solution)
    radiosity_positive gathered_radiosity_positive) as [H1 H2 H3 H4]. constructor.
  - intros i Hi. rewrite EW by assumption. auto.
  - intros i j Hi Hj. rewrite EP by assumption. auto.
  - now rewrite (sum_ext n _ _ EW).
  - intros i Hi. rewrite (sum_ext n _ (fun j => generalized_form_factor n form_factor radiosity i j)); auto.
Qed.
End Signs.

(* ---- As printed, with B_i: a counterexample ----
   Two patches of area 1 that see only each other, R = 1/2, E = (1, 0): B = (4/3, 2/3). *)
Definition two_patch_form_factor (i j : nat) : R := if Nat.eqb i j then 0 else 1.
Definition two_patch_emittance (i : nat) : R := match i with O => 1 | _ => 0 end.
Definition two_patch_radiosity (i : nat) : R := match i with O => 4 / 3 | _ => 2 / 3 end.

Theorem printed_radiosity_rows_do_not_sum_to_one :
  scene 2 (fun _ => 1) two_patch_form_factor /\ closed 2 two_patch_form_factor /\
  radiosity_equation 2 two_patch_form_factor (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity /\
  (forall i, (i < 2)%nat -> two_patch_emittance i < two_patch_radiosity i) /\
  sum 2 (fun j => printed_radiosity_transition two_patch_form_factor (fun _ => 1 / 2)
                    two_patch_emittance two_patch_radiosity 0 j) = 2 /\
  sum 2 (fun j => printed_radiosity_transition two_patch_form_factor (fun _ => 1 / 2)
                    two_patch_emittance two_patch_radiosity 1 j) = 1 / 2.
Proof.
  split; [constructor |]; [intros; lra | | |].
  - intros i j _ _. unfold two_patch_form_factor. destruct (Nat.eqb i j); lra.
  - intros i j _ _. unfold two_patch_form_factor. rewrite (Nat.eqb_sym j i). lra.
  - split; [| split; [| split; [| split]]].
    + intros [| [| i]] Hi; [.. | lia]; simpl; unfold two_patch_form_factor; simpl; lra.
    + intros [| [| i]] Hi; [.. | lia]; simpl; unfold two_patch_form_factor; simpl; lra.
    + intros [| [| i]] Hi; [.. | lia]; simpl; lra.
    + simpl. unfold printed_radiosity_transition, two_patch_form_factor. simpl. field.
    + simpl. unfold printed_radiosity_transition, two_patch_form_factor. simpl. field.
Qed.

(* Nor are the printed weights and transitions reciprocal there: 16/9 against 4/9. *)
Theorem printed_radiosity_transitions_are_not_reciprocal :
  radiosity_area (fun _ => 1) (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity 0
    * printed_radiosity_transition two_patch_form_factor (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity 0 1
  <> radiosity_area (fun _ => 1) (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity 1
    * printed_radiosity_transition two_patch_form_factor (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity 1 0.
Proof. unfold radiosity_area, printed_radiosity_transition, two_patch_form_factor. simpl. lra. Qed.
