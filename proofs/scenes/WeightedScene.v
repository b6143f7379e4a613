(* The chain behind sections 3.3 to 3.5. Every patch has a brightness X: the constant 1 for visibility, B for
   radiosity, R I for importance. A particle goes from i to j with probability proportional to F_ij X_j. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement.
Open Scope R_scope.

(* n patches with positive areas and non-negative form factors that fulfil A_i F_ij = A_j F_ji. *)
Record scene (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R) : Prop := {
  area_positive : forall i, (i < n)%nat -> 0 < area i;
  form_factor_nonneg : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= form_factor i j;
  form_factor_reciprocity : forall i j, (i < n)%nat -> (j < n)%nat ->
    area i * form_factor i j = area j * form_factor j i
}.

(* In a closed scene every row of form factors sums to one. *)
Definition closed (n : nat) (form_factor : nat -> nat -> R) : Prop :=
  forall i, (i < n)%nat -> sum n (fun j => form_factor i j) = 1.

(* What patch i gathers from all patches. *)
Definition gathered (n : nat) (form_factor : nat -> nat -> R) (brightness : nat -> R) (i : nat) : R :=
  sum n (fun j => form_factor i j * brightness j).

(* The paper's "generalized area" and "generalized form factor"; the weights are the areas, normalised. *)
Definition generalized_area (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R) (brightness : nat -> R)
    (i : nat) : R :=
  area i * brightness i * gathered n form_factor brightness i.

Definition generalized_weight (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R) (brightness : nat -> R)
    (i : nat) : R :=
  generalized_area n area form_factor brightness i / sum n (generalized_area n area form_factor brightness).

Definition generalized_form_factor (n : nat) (form_factor : nat -> nat -> R) (brightness : nat -> R)
    (i j : nat) : R :=
  form_factor i j * brightness j / gathered n form_factor brightness i.

(* A row divided by its sum sums to one. *)
Theorem generalized_rows_sum_to_one : forall n form_factor brightness i,
  gathered n form_factor brightness i <> 0 ->
  sum n (fun j => generalized_form_factor n form_factor brightness i j) = 1.
Proof.
  intros n F X i H. unfold generalized_form_factor, Rdiv. rewrite sum_scale_right.
  fold (gathered n F X i). now apply Rinv_r.
Qed.

(* The denominator cancels: what goes from i to j is A_i F_ij X_i X_j, which is symmetric. *)
Lemma generalized_flux : forall n area form_factor brightness i j,
  gathered n form_factor brightness i <> 0 ->
  generalized_area n area form_factor brightness i * generalized_form_factor n form_factor brightness i j
  = area i * form_factor i j * (brightness i * brightness j).
Proof. intros. unfold generalized_area, generalized_form_factor. now field. Qed.

Lemma generalized_joint : forall n area form_factor brightness i j,
  gathered n form_factor brightness i <> 0 ->
  joint (generalized_weight n area form_factor brightness) (generalized_form_factor n form_factor brightness) i j
  = area i * form_factor i j * (brightness i * brightness j)
    / sum n (generalized_area n area form_factor brightness).
Proof.
  intros. unfold joint, generalized_weight. rewrite <- (generalized_flux n) by assumption. unfold Rdiv. ring.
Qed.

Theorem generalized_chain_is_reciprocal : forall n area form_factor brightness,
  scene n area form_factor ->
  (forall i, (i < n)%nat -> gathered n form_factor brightness i <> 0) ->
  reciprocal n (generalized_weight n area form_factor brightness)
    (generalized_form_factor n form_factor brightness).
Proof.
  intros n A F X S Hg i j Hi Hj. rewrite !generalized_joint by auto.
  rewrite (form_factor_reciprocity _ _ _ S i j) by assumption. unfold Rdiv. ring.
Qed.

(* Reciprocity and rows that sum to one. *)
Theorem generalized_weights_are_stationary : forall n area form_factor brightness,
  scene n area form_factor ->
  (forall i, (i < n)%nat -> gathered n form_factor brightness i <> 0) ->
  stationary n (generalized_weight n area form_factor brightness)
    (generalized_form_factor n form_factor brightness).
Proof.
  intros n A F X S Hg j Hj.
  rewrite (sum_ext n _ (fun i => generalized_weight n A F X j * generalized_form_factor n F X j i)).
  - rewrite sum_scale, generalized_rows_sum_to_one by auto. ring.
  - intros i Hi. now apply generalized_chain_is_reciprocal.
Qed.

Lemma total_generalized_area_positive : forall n area form_factor brightness,
  (0 < n)%nat -> scene n area form_factor ->
  (forall i, (i < n)%nat -> 0 < brightness i) ->
  (forall i, (i < n)%nat -> 0 < gathered n form_factor brightness i) ->
  0 < sum n (generalized_area n area form_factor brightness).
Proof.
  intros n A F X Hn S HX Hg.
  assert (H : forall i, (i < n)%nat -> 0 < generalized_area n A F X i).
  { intros i Hi. unfold generalized_area. repeat apply Rmult_lt_0_compat; auto. now apply (area_positive _ _ _ S). }
  apply Rlt_le_trans with (generalized_area n A F X 0%nat); [auto |].
  apply (term_le_sum n (generalized_area n A F X)); [| assumption]. intros; left; auto.
Qed.

Theorem generalized_chain_is_markov : forall n area form_factor brightness,
  (0 < n)%nat -> scene n area form_factor ->
  (forall i, (i < n)%nat -> 0 < brightness i) ->
  (forall i, (i < n)%nat -> 0 < gathered n form_factor brightness i) ->
  markov_chain n (generalized_weight n area form_factor brightness)
    (generalized_form_factor n form_factor brightness).
Proof.
  intros n A F X Hn S HX Hg.
  pose proof (total_generalized_area_positive n A F X Hn S HX Hg) as HT. constructor.
  - intros i Hi. unfold generalized_weight, generalized_area, Rdiv.
    pose proof (area_positive _ _ _ S i Hi). pose proof (HX i Hi). pose proof (Hg i Hi).
    left. repeat apply Rmult_lt_0_compat; auto. now apply Rinv_0_lt_compat.
  - intros i j Hi Hj. unfold generalized_form_factor, Rdiv.
    apply Rmult_le_pos; [apply Rmult_le_pos |].
    + now apply (form_factor_nonneg _ _ _ S).
    + left; auto.
    + left. apply Rinv_0_lt_compat; auto.
  - unfold generalized_weight, Rdiv. rewrite sum_scale_right. apply Rinv_r. lra.
  - intros i Hi. apply generalized_rows_sum_to_one. apply Rgt_not_eq. exact (Hg i Hi).
Qed.

(* The same brightness k everywhere in a closed scene: the visibility chain, with P_ij = F_ij and w_i = A_i / A_T. *)
Theorem uniform_brightness_is_visibility : forall n area form_factor brightness k,
  closed n form_factor -> k <> 0 -> (forall i, (i < n)%nat -> brightness i = k) ->
  forall i, (i < n)%nat ->
  generalized_weight n area form_factor brightness i = area i / sum n area /\
  (forall j, (j < n)%nat -> generalized_form_factor n form_factor brightness i j = form_factor i j).
Proof.
  intros n A F X k C Hk HX i Hi.
  assert (Hg : forall i, (i < n)%nat -> gathered n F X i = k).
  { intros l Hl. unfold gathered. rewrite (sum_ext n _ (fun j => F l j * k)).
    - rewrite sum_scale_right, C by assumption. ring.
    - intros j Hj. now rewrite HX. }
  assert (HA : forall i, (i < n)%nat -> generalized_area n A F X i = k * k * A i).
  { intros l Hl. unfold generalized_area. rewrite HX, Hg by assumption. ring. }
  split.
  - unfold generalized_weight. rewrite (sum_ext n _ (fun l => k * k * A l)) by assumption.
    rewrite HA, sum_scale by assumption. unfold Rdiv. rewrite Rinv_mult.
    rewrite Rinv_mult. transitivity (k * / k * (k * / k) * (A i * / sum n A)); [ring |].
    rewrite Rinv_r by assumption. ring.
  - intros j Hj. unfold generalized_form_factor. rewrite HX, Hg by assumption. field. assumption.
Qed.
