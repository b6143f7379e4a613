(* The parts of a divided patch with all its constants: not only its brightness X, but also what a unit of its area
   receives, q = (B - E) / R or I - V. Then weights and joint probabilities of the parts still add up, so mutual
   information (8) does not fall; but the row of a part sums to one only if that part does receive q. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement WeightedScene DividedScene.
Open Scope R_scope.

Definition constant_area (area brightness received : nat -> R) (i : nat) : R :=
  area i * brightness i * received i.

Definition constant_weight (n : nat) (area brightness received : nat -> R) (i : nat) : R :=
  constant_area area brightness received i / sum n (constant_area area brightness received).

Definition constant_transition (form_factor : nat -> nat -> R) (brightness received : nat -> R) (i j : nat) : R :=
  form_factor i j * brightness j / received i.

Lemma constant_joint : forall n area form_factor brightness received i j, received i <> 0 ->
  joint (constant_weight n area brightness received) (constant_transition form_factor brightness received) i j
  = area i * form_factor i j * (brightness i * brightness j) / sum n (constant_area area brightness received).
Proof.
  intros. unfold joint, constant_weight, constant_area at 1, constant_transition, Rdiv.
  transitivity (area i * form_factor i j * (brightness i * brightness j) * (received i * / received i)
    * / sum n (constant_area area brightness received)); [ring |].
  rewrite Rinv_r by assumption. ring.
Qed.

Lemma constant_transition_row : forall n form_factor brightness received i, received i <> 0 ->
  sum n (fun j => constant_transition form_factor brightness received i j) = 1 <->
  gathered n form_factor brightness i = received i.
Proof.
  intros n F X q i Hq. unfold constant_transition, Rdiv. rewrite sum_scale_right. fold (gathered n F X i).
  split; intro H.
  - apply (Rmult_eq_reg_r (/ q i)); [| now apply Rinv_neq_0_compat]. rewrite Rinv_r; assumption.
  - rewrite H. now apply Rinv_r.
Qed.

Section Parts.
Variables (n N : nat) (parent : nat -> nat).
Variables (area : nat -> R) (form_factor : nat -> nat -> R) (brightness received : nat -> R).
Variables (part_area : nat -> R) (part_form_factor : nat -> nat -> R).
Hypothesis division : divided_scene n N parent area form_factor part_area part_form_factor.
Hypothesis parts_are_a_scene : scene N part_area part_form_factor.
Hypothesis bright : forall i, (i < n)%nat -> 0 < brightness i.
Hypothesis receiving : forall i, (i < n)%nat -> 0 < received i.

Let part_brightness := inherited parent brightness.
Let part_received := inherited parent received.

Lemma constant_area_of_parts : forall i, (i < n)%nat ->
  constant_area area brightness received i
  = part_sum N parent i (constant_area part_area part_brightness part_received).
Proof.
  intros i Hi. unfold constant_area at 1. rewrite (area_of_parts _ _ _ _ _ _ _ division) by assumption.
  rewrite <- !part_sum_scale_right. apply part_sum_ext. intros k _ Ek.
  unfold constant_area, part_brightness, part_received, inherited. now rewrite Ek.
Qed.

Lemma total_constant_area_of_parts :
  sum n (constant_area area brightness received) = sum N (constant_area part_area part_brightness part_received).
Proof.
  rewrite <- (sum_over_parts n N parent) by exact (parent_of_part _ _ _ _ _ _ _ division).
  apply sum_ext. exact constant_area_of_parts.
Qed.

Lemma constant_area_of_part_positive : forall k, (k < N)%nat ->
  0 < constant_area part_area part_brightness part_received k.
Proof.
  intros k Hk. assert (Hi := parent_of_part _ _ _ _ _ _ _ division k Hk).
  unfold constant_area, part_brightness, part_received, inherited.
  repeat apply Rmult_lt_0_compat; auto. now apply (area_positive _ _ _ parts_are_a_scene).
Qed.

Lemma constant_weight_of_part_positive : forall k, (k < N)%nat ->
  0 < constant_weight N part_area part_brightness part_received k.
Proof.
  intros k Hk. apply Rdiv_lt_0_compat; [now apply constant_area_of_part_positive |].
  apply Rlt_le_trans with (1 := constant_area_of_part_positive k Hk).
  apply (term_le_sum N (constant_area part_area part_brightness part_received)); [| assumption].
  intros l Hl. left. now apply constant_area_of_part_positive.
Qed.

(* (a): w_k P_kj = w_j P_jk for all parts. *)
Theorem constant_parts_are_reciprocal :
  reciprocal N (constant_weight N part_area part_brightness part_received)
    (constant_transition part_form_factor part_brightness part_received).
Proof.
  assert (Hq : forall k, (k < N)%nat -> part_received k <> 0).
  { intros k Hk. apply Rgt_not_eq. apply receiving. now apply (parent_of_part _ _ _ _ _ _ _ division). }
  intros k l Hk Hl. rewrite !constant_joint by auto.
  rewrite (form_factor_reciprocity _ _ _ parts_are_a_scene k l) by assumption. unfold Rdiv. ring.
Qed.

(* (b): the parts of patch j cover it, seen from a part k that sees patch j as its own patch does (an undivided
   patch). *)
Theorem constant_parts_cover : forall k j, (k < N)%nat -> (j < n)%nat ->
  part_sum N parent j (part_form_factor k) = form_factor (parent k) j ->
  constant_transition form_factor brightness received (parent k) j
  = part_sum N parent j (constant_transition part_form_factor part_brightness part_received k).
Proof.
  intros k j Hk Hj H. unfold constant_transition at 1. rewrite <- H. unfold Rdiv.
  rewrite <- !part_sum_scale_right. apply part_sum_ext. intros l _ El.
  unfold constant_transition, part_brightness, part_received, inherited. rewrite El. reflexivity.
Qed.

Theorem constant_parts_refine_the_chain :
  refines n N parent
    (constant_weight n area brightness received) (constant_transition form_factor brightness received)
    (constant_weight N part_area part_brightness part_received)
    (constant_transition part_form_factor part_brightness part_received).
Proof.
  constructor.
  - exact (parent_of_part _ _ _ _ _ _ _ division).
  - intros k Hk. left. now apply constant_weight_of_part_positive.
  - intros k l Hk Hl. apply Rmult_le_pos; [left; now apply constant_weight_of_part_positive |].
    assert (Hi := parent_of_part _ _ _ _ _ _ _ division k Hk).
    assert (Hj := parent_of_part _ _ _ _ _ _ _ division l Hl).
    unfold constant_transition, part_brightness, part_received, inherited, Rdiv.
    apply Rmult_le_pos; [apply Rmult_le_pos |].
    + now apply (form_factor_nonneg _ _ _ parts_are_a_scene).
    + left. auto.
    + left. apply Rinv_0_lt_compat. auto.
  - intros k l Hk Hl H. pose proof (constant_weight_of_part_positive l Hl). lra.
  - intros i Hi. unfold constant_weight, Rdiv.
    rewrite part_sum_scale_right, total_constant_area_of_parts. f_equal. now apply constant_area_of_parts.
  - intros i j Hi Hj. rewrite constant_joint by (apply Rgt_not_eq, (receiving i Hi)).
    rewrite <- (exchange_of_parts_with_brightness _ _ _ _ _ brightness _ _ division) by assumption.
    rewrite total_constant_area_of_parts.
    unfold Rdiv, block_sum. rewrite <- part_sum_scale_right. apply part_sum_ext. intros k Hk _.
    rewrite <- part_sum_scale_right. apply part_sum_ext. intros l Hl _.
    rewrite constant_joint; [reflexivity |].
    apply Rgt_not_eq, receiving. now apply (parent_of_part _ _ _ _ _ _ _ division).
Qed.

Theorem constant_parts_never_lower_mutual_information :
  mutual_information n
    (constant_weight n area brightness received) (constant_transition form_factor brightness received)
  <= mutual_information N
       (constant_weight N part_area part_brightness part_received)
       (constant_transition part_form_factor part_brightness part_received).
Proof.
  exact (refinement_of_several_states_never_lowers_mutual_information _ _ _ _ _ _ _ constant_parts_refine_the_chain).
Qed.
End Parts.
