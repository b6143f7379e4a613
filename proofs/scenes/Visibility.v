(* Sections 2 and 3.3, the visibility chain of a closed scene: w_i = A_i / A_T and P_ij = F_ij. It is a stationary,
   reciprocal Markov chain, dividing patches fulfils the hypotheses of Theorem 1, and I = H_p - H_s, eqs. (1) to (3). *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement MutualInformation StateRefinement Theorem1
  WeightedScene DividedScene.
Open Scope R_scope.

Definition relative_area (n : nat) (area : nat -> R) (i : nat) : R := area i / sum n area.

(* ---- Visibility ---- *)

Section Visibility.
Variables (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Hypothesis some_patch : (0 < n)%nat.
Hypothesis patches : scene n area form_factor.
Hypothesis closed_scene : closed n form_factor.

Lemma total_area_positive : 0 < sum n area.
Proof.
  apply Rlt_le_trans with (area 0%nat); [now apply (area_positive _ _ _ patches) |].
  apply term_le_sum; [| assumption]. intros j Hj. left. now apply (area_positive _ _ _ patches).
Qed.

Theorem visibility_chain_is_markov : markov_chain n (relative_area n area) form_factor.
Proof.
  assert (HT := total_area_positive). constructor.
  - intros i Hi. left. apply Rdiv_lt_0_compat; [now apply (area_positive _ _ _ patches) | assumption].
  - exact (form_factor_nonneg _ _ _ patches).
  - unfold relative_area, Rdiv. rewrite sum_scale_right. apply Rinv_r. lra.
  - exact closed_scene.
Qed.

(* The reciprocity of form factors, divided by A_T. *)
Theorem visibility_chain_is_reciprocal : reciprocal n (relative_area n area) form_factor.
Proof.
  intros i j Hi Hj. unfold joint, relative_area, Rdiv.
  transitivity (area i * form_factor i j * / sum n area); [ring |].
  rewrite (form_factor_reciprocity _ _ _ patches i j) by assumption. ring.
Qed.

Theorem relative_areas_are_stationary : stationary n (relative_area n area) form_factor.
Proof. exact (reciprocal_is_stationary n _ _ visibility_chain_is_markov visibility_chain_is_reciprocal). Qed.

(* (3): the double sum of A_i F_ij / A_T log (F_ij A_T / A_j), with 0 log 0 = 0, is (1) minus (2). *)
Theorem visibility_information_is_entropy_less_entropy_rate :
  sum n (fun i => sum n (fun j =>
    area i / sum n area * (form_factor i j * log2 (form_factor i j * sum n area / area j))))
  = entropy n (relative_area n area) - entropy_rate n (relative_area n area) form_factor.
Proof.
  assert (HT := total_area_positive).
  rewrite <- (mutual_information_is_entropy_less_entropy_rate n (relative_area n area) form_factor
    visibility_chain_is_markov relative_areas_are_stationary).
  apply sum_ext. intros i Hi. apply sum_ext. intros j Hj. assert (HA := area_positive _ _ _ patches j Hj).
  unfold relative_area. f_equal. destruct (Req_dec (form_factor i j) 0) as [-> | H]; [rewrite xlog2_0; ring |].
  rewrite xlog2_nonzero by assumption. do 2 f_equal. field. lra.
Qed.

(* The chain of WeightedScene.v, with brightness 1. *)
Lemma gathered_one : forall i, (i < n)%nat -> gathered n form_factor (fun _ => 1) i = 1.
Proof.
  intros i Hi. unfold gathered. rewrite sum_scale_right, Rmult_1_r. now apply closed_scene.
Qed.

Lemma visibility_is_brightness_one : forall i, (i < n)%nat ->
  generalized_weight n area form_factor (fun _ => 1) i = relative_area n area i /\
  (forall j, (j < n)%nat -> generalized_form_factor n form_factor (fun _ => 1) i j = form_factor i j).
Proof.
  apply (uniform_brightness_is_visibility n area form_factor (fun _ => 1) 1 closed_scene); auto.
Qed.
End Visibility.

(* ---- Dividing patches ---- *)

(* One patch s divided into m parts: the hypotheses of Theorem 1. *)
Theorem dividing_a_visible_patch_fulfils_hypotheses_of_theorem_1 :
  forall n s m area form_factor part_area part_form_factor,
  scene n area form_factor -> closed n form_factor ->
  scene (n - 1 + m) part_area part_form_factor -> closed (n - 1 + m) part_form_factor ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  refines_state n s m (relative_area n area) form_factor (relative_area (n - 1 + m) part_area) part_form_factor.
Proof.
  intros n s m A F a G S C S' C' D.
  assert (EW := fun i Hi => proj1 (visibility_is_brightness_one n A F C i Hi)).
  assert (EW' := fun i Hi => proj1 (visibility_is_brightness_one (n - 1 + m) a G C' i Hi)).
  assert (Hsub : forall k, (k < m)%nat -> (substate n s k < n - 1 + m)%nat).
  { intros k Hk. apply substate_below; [exact (patch_below _ _ _ _ _ _ _ D) | assumption]. }
  assert (Hm := some_subpatch _ _ _ _ _ _ _ D).
  destruct (dividing_a_patch_fulfils_hypotheses_of_theorem_1 n s m A F (fun _ => 1) a G S S' D) as [H1 H2 H3 H4 H5 H6].
  - intros; lra.
  - intros i Hi. rewrite gathered_one by assumption. lra.
  - intros k Hk. change (inherited (parent_state n s) (fun _ => 1)) with (fun _ : nat => 1).
    rewrite gathered_one by assumption. lra.
  - change (inherited (parent_state n s) (fun _ => 1)) with (fun _ : nat => 1) in *.
    constructor; try assumption.
    + intros j Hj Hjs. rewrite <- EW, <- EW' by lia. auto.
    + exact (other_form_factor _ _ _ _ _ _ _ D).
    + intros k j Hk Hj. apply visibility_chain_is_reciprocal; auto.
    + exact (form_factors_to_subpatches _ _ _ _ _ _ _ D).
Qed.

(* Any patches divided at once. *)
Theorem dividing_visible_patches_never_lowers_mutual_information :
  forall n N parent area form_factor part_area part_form_factor,
  (0 < N)%nat ->
  scene n area form_factor -> closed n form_factor ->
  scene N part_area part_form_factor -> closed N part_form_factor ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  mutual_information n (relative_area n area) form_factor
  <= mutual_information N (relative_area N part_area) part_form_factor.
Proof.
  intros n N parent A F a G HN S C S' C' D.
  assert (E : forall p A F, scene p A F -> closed p F ->
    mutual_information p (generalized_weight p A F (fun _ => 1)) (generalized_form_factor p F (fun _ => 1))
    = mutual_information p (relative_area p A) F).
  { intros p A0 F0 S0 C0. apply sum_ext. intros i Hi. apply sum_ext. intros j Hj.
    destruct (visibility_is_brightness_one p A0 F0 C0 i Hi) as [-> H]. rewrite H by assumption.
    now destruct (visibility_is_brightness_one p A0 F0 C0 j Hj) as [-> _]. }
  rewrite <- (E n A F S C), <- (E N a G S' C').
  apply (dividing_patches_never_lowers_mutual_information n N parent A F (fun _ => 1) a G D S' HN).
  - intros; lra.
  - intros i Hi. rewrite gathered_one by assumption. lra.
  - intros k Hk. change (inherited parent (fun _ => 1)) with (fun _ : nat => 1).
    rewrite gathered_one by assumption. lra.
Qed.
