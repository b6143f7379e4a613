(* Dividing patches of a scene refines its chain: for visibility, radiosity and importance alike (WeightedScene.v), the
   parts of a patch keep its brightness, share its area and its exchange of light with the others. So the hypotheses of
   Theorem 1 are fulfilled and mutual information does not fall. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement StateRefinement Theorem1 WeightedScene.
Open Scope R_scope.

(* Any patches divided at once: the N parts k have parents, areas a_k and form factors G_kl among themselves;
   A_i = sum of a_k, and A_i F_ij = sum of a_k G_kl, over the parts k of i and l of j. *)
Record divided_scene (n N : nat) (parent : nat -> nat)
    (area : nat -> R) (form_factor : nat -> nat -> R)
    (part_area : nat -> R) (part_form_factor : nat -> nat -> R) : Prop := {
  parent_of_part : forall k, (k < N)%nat -> (parent k < n)%nat;
  area_of_parts : forall i, (i < n)%nat -> area i = part_sum N parent i part_area;
  exchange_of_parts : forall i j, (i < n)%nat -> (j < n)%nat ->
    area i * form_factor i j = block_sum N parent i j (fun k l => part_area k * part_form_factor k l)
}.

(* A part is as bright as the patch it lies in. *)
Definition inherited (parent : nat -> nat) (brightness : nat -> R) (k : nat) : R := brightness (parent k).

Section Divided.
Variables (n N : nat) (parent : nat -> nat).
Variables (area : nat -> R) (form_factor : nat -> nat -> R) (brightness : nat -> R).
Variables (part_area : nat -> R) (part_form_factor : nat -> nat -> R).
Hypothesis division : divided_scene n N parent area form_factor part_area part_form_factor.

Let part_brightness := inherited parent brightness.

Lemma exchange_of_parts_with_brightness : forall i j, (i < n)%nat -> (j < n)%nat ->
  block_sum N parent i j (fun k l => part_area k * part_form_factor k l * (part_brightness k * part_brightness l))
  = area i * form_factor i j * (brightness i * brightness j).
Proof.
  intros i j Hi Hj. rewrite (exchange_of_parts _ _ _ _ _ _ _ division) by assumption.
  unfold block_sum. rewrite <- part_sum_scale_right. apply part_sum_ext. intros k _ Ek.
  rewrite <- part_sum_scale_right. apply part_sum_ext. intros l _ El.
  unfold part_brightness, inherited. now rewrite Ek, El.
Qed.

(* The generalized areas of the parts add up: sum over all patches what the parts exchange with them. *)
Lemma generalized_area_of_parts : forall i, (i < n)%nat ->
  generalized_area n area form_factor brightness i
  = part_sum N parent i (generalized_area N part_area part_form_factor part_brightness).
Proof.
  intros i Hi. unfold generalized_area at 1, gathered. rewrite <- sum_scale.
  rewrite (sum_ext n _ (fun j => part_sum N parent i (fun k => part_sum N parent j (fun l =>
    part_area k * part_form_factor k l * (part_brightness k * part_brightness l))))).
  - rewrite sum_part_sum. apply part_sum_ext. intros k _ _.
    rewrite sum_over_parts by exact (parent_of_part _ _ _ _ _ _ _ division).
    unfold generalized_area, gathered. rewrite <- sum_scale. apply sum_ext. intros l _. ring.
  - intros j Hj. pose proof (exchange_of_parts_with_brightness i j Hi Hj) as H. unfold block_sum in H.
    rewrite H. ring.
Qed.

Lemma total_generalized_area_of_parts :
  sum n (generalized_area n area form_factor brightness)
  = sum N (generalized_area N part_area part_form_factor part_brightness).
Proof.
  rewrite <- (sum_over_parts n N parent) by exact (parent_of_part _ _ _ _ _ _ _ division).
  apply sum_ext. exact generalized_area_of_parts.
Qed.

Hypothesis parts_are_a_scene : scene N part_area part_form_factor.
Hypothesis some_part : (0 < N)%nat.
Hypothesis bright : forall i, (i < n)%nat -> 0 < brightness i.
Hypothesis patches_gather : forall i, (i < n)%nat -> 0 < gathered n form_factor brightness i.
Hypothesis parts_gather : forall k, (k < N)%nat -> 0 < gathered N part_form_factor part_brightness k.

Lemma parts_are_bright : forall k, (k < N)%nat -> 0 < part_brightness k.
Proof. intros k Hk. apply bright. now apply (parent_of_part _ _ _ _ _ _ _ division). Qed.

Theorem divided_chain_is_markov :
  markov_chain N (generalized_weight N part_area part_form_factor part_brightness)
    (generalized_form_factor N part_form_factor part_brightness).
Proof. apply generalized_chain_is_markov; auto using parts_are_bright. Qed.

Theorem divided_chain_is_reciprocal :
  reciprocal N (generalized_weight N part_area part_form_factor part_brightness)
    (generalized_form_factor N part_form_factor part_brightness).
Proof.
  apply generalized_chain_is_reciprocal; [assumption |]. intros k Hk. apply Rgt_not_eq. exact (parts_gather k Hk).
Qed.

Theorem dividing_patches_refines_the_chain :
  refines n N parent
    (generalized_weight n area form_factor brightness) (generalized_form_factor n form_factor brightness)
    (generalized_weight N part_area part_form_factor part_brightness)
    (generalized_form_factor N part_form_factor part_brightness).
Proof.
  assert (Hne : forall k, (k < N)%nat -> gathered N part_form_factor part_brightness k <> 0).
  { intros k Hk. apply Rgt_not_eq. exact (parts_gather k Hk). }
  pose proof divided_chain_is_markov as M. pose proof divided_chain_is_reciprocal as R.
  assert (J : forall k l, (k < N)%nat -> (l < N)%nat ->
    0 <= joint (generalized_weight N part_area part_form_factor part_brightness)
           (generalized_form_factor N part_form_factor part_brightness) k l).
  { intros k l Hk Hl. apply Rmult_le_pos;
      [now apply (weight_nonneg _ _ _ M) | now apply (transition_nonneg _ _ _ M)]. }
  constructor.
  - exact (parent_of_part _ _ _ _ _ _ _ division).
  - exact (weight_nonneg _ _ _ M).
  - exact J.
  - now apply stationary_joint_null, reciprocal_is_stationary.
  - intros i Hi. unfold generalized_weight, Rdiv.
    rewrite part_sum_scale_right, total_generalized_area_of_parts. f_equal. now apply generalized_area_of_parts.
  - intros i j Hi Hj. rewrite generalized_joint by (apply Rgt_not_eq, (patches_gather i Hi)).
    rewrite <- exchange_of_parts_with_brightness, total_generalized_area_of_parts by assumption.
    unfold Rdiv, block_sum. rewrite <- part_sum_scale_right. apply part_sum_ext. intros k Hk _.
    rewrite <- part_sum_scale_right. apply part_sum_ext. intros l Hl _.
    rewrite generalized_joint by auto. reflexivity.
Qed.

(* So mutual information does not fall, whichever patches are divided. *)
Theorem dividing_patches_never_lowers_mutual_information :
  mutual_information n
    (generalized_weight n area form_factor brightness) (generalized_form_factor n form_factor brightness)
  <= mutual_information N
       (generalized_weight N part_area part_form_factor part_brightness)
       (generalized_form_factor N part_form_factor part_brightness).
Proof.
  exact (refinement_of_several_states_never_lowers_mutual_information _ _ _ _ _ _ _ dividing_patches_refines_the_chain).
Qed.
End Divided.

(* ---- One patch s divided into m parts, as in Theorem 1 ----
   The labels are those of StateRefinement.v. The other patches stay as they are. *)
Record divided_patch (n s m : nat)
    (area : nat -> R) (form_factor : nat -> nat -> R)
    (part_area : nat -> R) (part_form_factor : nat -> nat -> R) : Prop := {
  patch_below : (s < n)%nat;
  some_subpatch : (1 <= m)%nat;
  other_area : forall j, (j < n)%nat -> j <> s -> part_area j = area j;
  area_of_subpatches : area s = sum m (fun k => part_area (substate n s k));
  other_form_factor : forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s ->
    part_form_factor i j = form_factor i j;
  (* what j sends to s is what it sends to the parts *)
  form_factors_to_subpatches : forall j, (j < n)%nat -> j <> s ->
    form_factor j s = sum m (fun k => part_form_factor j (substate n s k));
  (* what s sends to itself: nothing, on both sides, if it is planar *)
  exchange_within_patch : area s * form_factor s s
    = sum m (fun k => sum m (fun l => part_area (substate n s k) * part_form_factor (substate n s k) (substate n s l)))
}.

(* By reciprocity, also what the parts send to j adds up. *)
Lemma divided_patch_is_divided_scene : forall n s m area form_factor part_area part_form_factor,
  scene n area form_factor -> scene (n - 1 + m) part_area part_form_factor ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  divided_scene n (n - 1 + m) (parent_state n s) area form_factor part_area part_form_factor.
Proof.
  intros n s m A F a G S S' [Hs Hm Ha HA HF HFs Hss].
  destruct m as [| q]; [lia |]. replace (n - 1 + Datatypes.S q)%nat with (n + q)%nat in * by lia.
  assert (Ha' : forall j, (j < n)%nat -> j <> s -> forall k, (k < Datatypes.S q)%nat ->
    a j * G j (substate n s k) = a (substate n s k) * G (substate n s k) j).
  { intros j Hj Hjs k Hk. apply (form_factor_reciprocity _ _ _ S'); [lia |].
    replace (n + q)%nat with (n - 1 + Datatypes.S q)%nat by lia. now apply substate_below. }
  constructor.
  - intros k Hk. unfold parent_state. destruct (Nat.ltb_spec k n); assumption.
  - intros i Hi. destruct (Nat.eq_dec i s) as [-> | His].
    + now rewrite part_sum_of_refined_state.
    + rewrite part_sum_of_other_state by assumption. now rewrite Ha.
  - intros i j Hi Hj. unfold block_sum. destruct (Nat.eq_dec i s) as [-> | His], (Nat.eq_dec j s) as [-> | Hjs].
    + rewrite part_sum_of_refined_state, Hss by assumption. apply sum_ext. intros k _.
      now rewrite part_sum_of_refined_state.
    + rewrite part_sum_of_refined_state by assumption.
      rewrite (form_factor_reciprocity _ _ _ S), HFs, <- sum_scale by assumption.
      apply sum_ext. intros k Hk. rewrite part_sum_of_other_state, <- (Ha' j) by assumption. now rewrite Ha.
    + rewrite part_sum_of_other_state, part_sum_of_refined_state by assumption.
      now rewrite sum_scale, HFs, Ha.
    + rewrite !part_sum_of_other_state by assumption. now rewrite Ha, HF.
Qed.

(* The hypotheses of Theorem 1, (a) and (b) included. *)
Theorem dividing_a_patch_fulfils_hypotheses_of_theorem_1 :
  forall n s m area form_factor brightness part_area part_form_factor,
  scene n area form_factor -> scene (n - 1 + m) part_area part_form_factor ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  (forall i, (i < n)%nat -> 0 < brightness i) ->
  (forall i, (i < n)%nat -> 0 < gathered n form_factor brightness i) ->
  (forall k, (k < n - 1 + m)%nat ->
     0 < gathered (n - 1 + m) part_form_factor (inherited (parent_state n s) brightness) k) ->
  refines_state n s m
    (generalized_weight n area form_factor brightness) (generalized_form_factor n form_factor brightness)
    (generalized_weight (n - 1 + m) part_area part_form_factor (inherited (parent_state n s) brightness))
    (generalized_form_factor (n - 1 + m) part_form_factor (inherited (parent_state n s) brightness)).
Proof.
  intros n s m A F X a G S S' D HX Hg Hg'.
  pose proof (divided_patch_is_divided_scene _ _ _ _ _ _ _ S S' D) as DS.
  pose proof (total_generalized_area_of_parts _ _ _ _ _ X _ _ DS) as HT.
  set (X' := inherited (parent_state n s) X) in *.
  destruct D as [Hs Hm Ha HA HF HFs Hss].
  assert (HX' : forall j, (j < n)%nat -> X' j = X j).
  { intros j Hj. unfold X', inherited. now rewrite parent_of_other. }
  assert (HXs : forall k, X' (substate n s k) = X s).
  { intros k. unfold X', inherited. now rewrite parent_of_substate. }
  (* the other patches gather what they did *)
  assert (Hgo : forall j, (j < n)%nat -> j <> s -> gathered (n - 1 + m) G X' j = gathered n F X j).
  { intros j Hj Hjs. unfold gathered. destruct m as [| q]; [lia |].
    replace (n - 1 + Datatypes.S q)%nat with (n + q)%nat by lia.
    rewrite (sum_others_and_substates n q s), (sum_others_and_state n s) by assumption. f_equal.
    - apply sum_others_ext. intros i Hi His. now rewrite HX', HF.
    - rewrite HFs, <- sum_scale_right by assumption. apply sum_ext. intros k _. now rewrite HXs. }
  constructor; try assumption.
  - intros j Hj Hjs. unfold generalized_weight. rewrite HT. unfold generalized_area at 1 3.
    now rewrite Ha, HX', Hgo.
  - intros i j Hi Hj His Hjs. unfold generalized_form_factor. now rewrite Hgo, HX', HF.
  - intros k j Hk Hj. apply generalized_chain_is_reciprocal; auto using substate_below.
    intros l Hl. apply Rgt_not_eq. exact (Hg' l Hl).
  - intros j Hj Hjs. unfold generalized_form_factor. rewrite Hgo by assumption.
    rewrite HFs by assumption. unfold Rdiv. rewrite <- !sum_scale_right.
    apply sum_ext. intros k _. now rewrite HXs.
Qed.
