(* Section 3.5, importances and reflectances constant along each patch: as for radiosity, with brightness R I. Rows sum
   to one, the weights are stationary and reciprocal, and for V_i = k (1/R_i - 1) the chain reverts to visibility.
   The importance equation is the radiosity equation for B = R I and E = R V. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement WeightedScene Radiosity UniformRadiosity.
Open Scope R_scope.

(* I_i = V_i + sum_j R_j F_ij I_j. *)
Definition importance_equation (n : nat) (form_factor : nat -> nat -> R)
    (reflectance initial_importance importance : nat -> R) : Prop :=
  forall i, (i < n)%nat ->
    importance i = initial_importance i + sum n (fun j => reflectance j * form_factor i j * importance j).

(* A_i R_i I_i (I_i - V_i), before normalisation. *)
Definition importance_area (area reflectance initial_importance importance : nat -> R) (i : nat) : R :=
  area i * (reflectance i * importance i) * (importance i - initial_importance i).

Definition importance_weight (n : nat) (area reflectance initial_importance importance : nat -> R) (i : nat) : R :=
  importance_area area reflectance initial_importance importance i
  / sum n (importance_area area reflectance initial_importance importance).

(* R_j F_ij I_j / (I_i - V_i). *)
Definition importance_transition (form_factor : nat -> nat -> R)
    (reflectance initial_importance importance : nat -> R) (i j : nat) : R :=
  reflectance j * form_factor i j * importance j / (importance i - initial_importance i).

Definition reflected_importance (reflectance importance : nat -> R) (i : nat) : R := reflectance i * importance i.

Section Importance.
Variables (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance initial_importance importance : nat -> R.
Hypothesis equation : importance_equation n form_factor reflectance initial_importance importance.

(* The importance equation solved for what is gathered. *)
Lemma gathered_importance : forall i, (i < n)%nat ->
  gathered n form_factor (reflected_importance reflectance importance) i = importance i - initial_importance i.
Proof.
  intros i Hi. rewrite (equation i Hi). unfold gathered, reflected_importance.
  rewrite (sum_ext n _ (fun j => reflectance j * form_factor i j * importance j)) by (intros; ring). ring.
Qed.

(* So the chain is the one of WeightedScene.v with brightness R I. *)
Lemma importance_area_is_generalized_area : forall i, (i < n)%nat ->
  importance_area area reflectance initial_importance importance i
  = generalized_area n area form_factor (reflected_importance reflectance importance) i.
Proof. intros i Hi. unfold importance_area, generalized_area. now rewrite gathered_importance. Qed.

Lemma importance_weight_is_generalized_weight : forall i, (i < n)%nat ->
  importance_weight n area reflectance initial_importance importance i
  = generalized_weight n area form_factor (reflected_importance reflectance importance) i.
Proof.
  intros i Hi. unfold importance_weight, generalized_weight.
  rewrite importance_area_is_generalized_area by assumption.
  now rewrite (sum_ext n _ _ importance_area_is_generalized_area).
Qed.

Lemma importance_transition_is_generalized_form_factor : forall i j, (i < n)%nat ->
  importance_transition form_factor reflectance initial_importance importance i j
  = generalized_form_factor n form_factor (reflected_importance reflectance importance) i j.
Proof.
  intros i j Hi. unfold importance_transition, generalized_form_factor.
  rewrite gathered_importance by assumption. unfold reflected_importance, Rdiv. ring.
Qed.

Hypothesis important : forall i, (i < n)%nat -> importance i <> initial_importance i.

Lemma gathered_importance_nonzero : forall i, (i < n)%nat ->
  gathered n form_factor (reflected_importance reflectance importance) i <> 0.
Proof. intros i Hi. rewrite gathered_importance by assumption. assert (H := important i Hi). lra. Qed.

Theorem importance_rows_sum_to_one : forall i, (i < n)%nat ->
  sum n (fun j => importance_transition form_factor reflectance initial_importance importance i j) = 1.
Proof.
  intros i Hi.
  rewrite (sum_ext n _ (fun j =>
    generalized_form_factor n form_factor (reflected_importance reflectance importance) i j)).
  - now apply generalized_rows_sum_to_one, gathered_importance_nonzero.
  - intros j _. now apply importance_transition_is_generalized_form_factor.
Qed.

Hypothesis patches : scene n area form_factor.

(* For the weights as printed, without normalisation. *)
Theorem importance_reciprocity : forall i j, (i < n)%nat -> (j < n)%nat ->
  importance_area area reflectance initial_importance importance i
    * importance_transition form_factor reflectance initial_importance importance i j
  = importance_area area reflectance initial_importance importance j
      * importance_transition form_factor reflectance initial_importance importance j i.
Proof.
  intros i j Hi Hj.
  rewrite !importance_area_is_generalized_area, !importance_transition_is_generalized_form_factor by assumption.
  rewrite !generalized_flux by now apply gathered_importance_nonzero.
  rewrite (form_factor_reciprocity _ _ _ patches i j) by assumption. ring.
Qed.

Theorem importance_chain_is_reciprocal :
  reciprocal n (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance).
Proof.
  intros i j Hi Hj. unfold joint, importance_weight, Rdiv.
  pose proof (importance_reciprocity i j Hi Hj) as H.
  rewrite Rmult_assoc, (Rmult_comm (/ _)), <- Rmult_assoc, H. ring.
Qed.

Theorem importance_weights_are_stationary :
  stationary n (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance).
Proof.
  intros j Hj.
  rewrite (sum_ext n _ (fun i => importance_weight n area reflectance initial_importance importance j
    * importance_transition form_factor reflectance initial_importance importance j i)).
  - rewrite sum_scale, importance_rows_sum_to_one by assumption. ring.
  - intros i Hi. now apply importance_chain_is_reciprocal.
Qed.
End Importance.

(* ---- With the signs that importance has ---- *)

(* A solved scene: R_i > 0, V_i >= 0, and every patch sees some important one: I_i > V_i. *)
Record importance_solution (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R)
    (reflectance initial_importance importance : nat -> R) : Prop := {
  importance_patches : scene n area form_factor;
  importance_solves : importance_equation n form_factor reflectance initial_importance importance;
  importance_reflectance_positive : forall i, (i < n)%nat -> 0 < reflectance i;
  initial_importance_nonneg : forall i, (i < n)%nat -> 0 <= initial_importance i;
  gathers_importance : forall i, (i < n)%nat -> initial_importance i < importance i
}.

Section Signs.
Variables (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance initial_importance importance : nat -> R.
Hypothesis solution : importance_solution n area form_factor reflectance initial_importance importance.

Let brightness := reflected_importance reflectance importance.

Lemma reflected_importance_positive : forall i, (i < n)%nat -> 0 < brightness i.
Proof.
  intros i Hi. assert (H := gathers_importance _ _ _ _ _ _ solution i Hi).
  assert (H0 := initial_importance_nonneg _ _ _ _ _ _ solution i Hi).
  apply Rmult_lt_0_compat; [now apply (importance_reflectance_positive _ _ _ _ _ _ solution) | lra].
Qed.

Lemma importance_differs : forall i, (i < n)%nat -> importance i <> initial_importance i.
Proof. intros i Hi. assert (H := gathers_importance _ _ _ _ _ _ solution i Hi). lra. Qed.

Lemma gathered_importance_positive : forall i, (i < n)%nat -> 0 < gathered n form_factor brightness i.
Proof.
  intros i Hi. unfold brightness. rewrite (gathered_importance n form_factor reflectance initial_importance)
    by (exact (importance_solves _ _ _ _ _ _ solution) || assumption).
  assert (H := gathers_importance _ _ _ _ _ _ solution i Hi). lra.
Qed.

Lemma importance_chain_is_generalized_chain :
  (forall i, (i < n)%nat -> importance_weight n area reflectance initial_importance importance i
     = generalized_weight n area form_factor brightness i) /\
  (forall i j, (i < n)%nat -> importance_transition form_factor reflectance initial_importance importance i j
     = generalized_form_factor n form_factor brightness i j).
Proof.
  assert (H := importance_solves _ _ _ _ _ _ solution). split; intros.
  - now apply importance_weight_is_generalized_weight.
  - now apply importance_transition_is_generalized_form_factor.
Qed.

Theorem importance_chain_is_markov : (0 < n)%nat ->
  markov_chain n (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance).
Proof.
  intros Hn. destruct importance_chain_is_generalized_chain as [EW EP].
  destruct (generalized_chain_is_markov n area form_factor brightness Hn (importance_patches _ _ _ _ _ _ solution)
    reflected_importance_positive gathered_importance_positive) as [H1 H2 H3 H4]. constructor.
  - intros i Hi. rewrite EW by assumption. auto.
  - intros i j Hi Hj. rewrite EP by assumption. auto.
  - now rewrite (sum_ext n _ _ EW).
  - intros i Hi. rewrite (sum_ext n _ (fun j => generalized_form_factor n form_factor brightness i j)); auto.
Qed.
End Signs.

(* ---- Reversion to visibility ---- *)

(* Multiply the importance equation by R_i. *)
Lemma reflected_importance_solves_radiosity_equation : forall n form_factor reflectance initial_importance importance,
  importance_equation n form_factor reflectance initial_importance importance ->
  radiosity_equation n form_factor reflectance (reflected_importance reflectance initial_importance)
    (reflected_importance reflectance importance).
Proof.
  intros n F r V I H i Hi. unfold reflected_importance. rewrite (H i Hi) at 1.
  rewrite (sum_ext n _ (fun j => F i j * (r j * I j))) by (intros; ring). ring.
Qed.

(* In a closed scene I = k / R, that is R I = k, solves the importance equation exactly when V_i = k (1/R_i - 1). *)
Theorem uniform_reflected_importance_solves_iff : forall n form_factor reflectance initial_importance k,
  closed n form_factor -> (forall i, (i < n)%nat -> reflectance i <> 0) ->
  importance_equation n form_factor reflectance initial_importance (fun i => k / reflectance i) <->
  (forall i, (i < n)%nat -> initial_importance i = k * (1 / reflectance i - 1)).
Proof.
  intros n F r V k C Hr.
  assert (E : forall i, (i < n)%nat -> sum n (fun j => r j * F i j * (k / r j)) = k).
  { intros i Hi. rewrite (sum_ext n _ (fun j => F i j * k)).
    - rewrite sum_scale_right, C by assumption. ring.
    - intros j Hj. field. auto. }
  split; intros H i Hi; specialize (H i Hi); cbv beta in *; assert (Hri := Hr i Hi).
  - rewrite E in H by assumption. replace (k * (1 / r i - 1)) with (k / r i - k) by (field; assumption). lra.
  - rewrite E, H by assumption. field. assumption.
Qed.

Theorem uniform_reflected_importance_is_the_only_solution :
  forall n area form_factor reflectance initial_importance k importance,
  scene n area form_factor -> closed n form_factor ->
  (forall i, (i < n)%nat -> 0 < reflectance i < 1) ->
  (forall i, (i < n)%nat -> initial_importance i = k * (1 / reflectance i - 1)) ->
  importance_equation n form_factor reflectance initial_importance importance ->
  forall i, (i < n)%nat -> reflectance i * importance i = k.
Proof.
  intros n A F r V k I S C Hr HV HI i Hi.
  apply (uniform_radiosity_is_the_only_solution n A F r (reflected_importance r V) k (reflected_importance r I) S C);
    auto.
  - intros l Hl. specialize (Hr l Hl). lra.
  - intros l Hl. unfold reflected_importance. rewrite HV by assumption. specialize (Hr l Hl). field. lra.
  - now apply reflected_importance_solves_radiosity_equation.
Qed.

(* Then P_ij = F_ij and w_i = A_i / A_T. *)
Theorem importance_reverts_to_visibility : forall n area form_factor reflectance initial_importance k importance,
  scene n area form_factor -> closed n form_factor -> k <> 0 ->
  (forall i, (i < n)%nat -> 0 < reflectance i < 1) ->
  (forall i, (i < n)%nat -> initial_importance i = k * (1 / reflectance i - 1)) ->
  importance_equation n form_factor reflectance initial_importance importance ->
  forall i, (i < n)%nat ->
  importance_weight n area reflectance initial_importance importance i = area i / sum n area /\
  (forall j, (j < n)%nat ->
     importance_transition form_factor reflectance initial_importance importance i j = form_factor i j).
Proof.
  intros n A F r V k I S C Hk Hr HV HI i Hi.
  pose proof (uniform_reflected_importance_is_the_only_solution n A F r V k I S C Hr HV HI) as Hu.
  destruct (uniform_brightness_is_visibility n A F (reflected_importance r I) k C Hk Hu i Hi) as [HW HP]. split.
  - now rewrite (importance_weight_is_generalized_weight n A F).
  - intros j Hj. rewrite (importance_transition_is_generalized_form_factor n F); auto.
Qed.
