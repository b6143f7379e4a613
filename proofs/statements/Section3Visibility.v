(* Section 3.3, visibility, and what sections 3.3 to 3.5 share. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums DividedScene IntegralChain IntegralScenes MarkovChains
  PotentialGain StateRefinement Theorem1 Visibility VisibleGain WeightedScene.
Open Scope R_scope.

(* ==== Sections 3.3 to 3.5: what they share. Each patch has a brightness: 1, or B, or R I ==== *)

Theorem words_of_brightness : forall n area form_factor brightness i j,
  gathered n form_factor brightness i = sum n (fun l => form_factor i l * brightness l) /\
  generalized_area n area form_factor brightness i = area i * brightness i * gathered n form_factor brightness i /\
  generalized_weight n area form_factor brightness i =
    generalized_area n area form_factor brightness i / sum n (generalized_area n area form_factor brightness) /\
  generalized_form_factor n form_factor brightness i j =
    form_factor i j * brightness j / gathered n form_factor brightness i.
Proof. easy. Qed.

Theorem generalized_chain_is_markov : forall n area form_factor brightness,
  (0 < n)%nat -> scene n area form_factor ->
  (forall i, (i < n)%nat -> 0 < brightness i) ->
  (forall i, (i < n)%nat -> 0 < gathered n form_factor brightness i) ->
  markov_chain n (generalized_weight n area form_factor brightness) (generalized_form_factor n form_factor brightness).
Proof. exact WeightedScene.generalized_chain_is_markov. Qed.

Theorem generalized_chain_is_reciprocal : forall n area form_factor brightness,
  scene n area form_factor -> (forall i, (i < n)%nat -> gathered n form_factor brightness i <> 0) ->
  reciprocal n (generalized_weight n area form_factor brightness) (generalized_form_factor n form_factor brightness).
Proof. exact WeightedScene.generalized_chain_is_reciprocal. Qed.

Theorem uniform_brightness_is_visibility : forall n area form_factor brightness k,
  closed n form_factor -> k <> 0 -> (forall i, (i < n)%nat -> brightness i = k) ->
  forall i, (i < n)%nat ->
  generalized_weight n area form_factor brightness i = area i / sum n area /\
  (forall j, (j < n)%nat -> generalized_form_factor n form_factor brightness i j = form_factor i j).
Proof. exact WeightedScene.uniform_brightness_is_visibility. Qed.

Theorem words_of_divided_scenes : forall n N s m parent area form_factor part_area part_form_factor,
  (divided_scene n N parent area form_factor part_area part_form_factor <->
    (forall k, (k < N)%nat -> (parent k < n)%nat) /\
    (forall i, (i < n)%nat -> area i = part_sum N parent i part_area) /\
    (forall i j, (i < n)%nat -> (j < n)%nat -> area i * form_factor i j =
       part_sum N parent i (fun k => part_sum N parent j (fun l => part_area k * part_form_factor k l)))) /\
  (divided_patch n s m area form_factor part_area part_form_factor <->
    (s < n)%nat /\ (1 <= m)%nat /\
    (forall j, (j < n)%nat -> j <> s -> part_area j = area j) /\
    area s = sum m (fun k => part_area (substate n s k)) /\
    (forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> part_form_factor i j = form_factor i j) /\
    (forall j, (j < n)%nat -> j <> s -> form_factor j s = sum m (fun k => part_form_factor j (substate n s k))) /\
    area s * form_factor s s = sum m (fun k => sum m (fun l =>
      part_area (substate n s k) * part_form_factor (substate n s k) (substate n s l)))) /\
  (forall property k, inherited parent property k = property (parent k)).
Proof.
  split; [split; [intros []|intros [? []]; constructor]; auto|].
  split; [split; [intros []|intros [? [? [? [? [? []]]]]]; constructor]; auto|easy].
  repeat (split; [assumption|]). assumption.
Qed.

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
Proof. exact DividedScene.dividing_a_patch_fulfils_hypotheses_of_theorem_1. Qed.

Theorem dividing_patches_never_lowers_mutual_information :
  forall n N parent area form_factor brightness part_area part_form_factor,
  divided_scene n N parent area form_factor part_area part_form_factor ->
  scene N part_area part_form_factor -> (0 < N)%nat ->
  (forall i, (i < n)%nat -> 0 < brightness i) ->
  (forall i, (i < n)%nat -> 0 < gathered n form_factor brightness i) ->
  (forall k, (k < N)%nat -> 0 < gathered N part_form_factor (inherited parent brightness) k) ->
  mutual_information n (generalized_weight n area form_factor brightness)
    (generalized_form_factor n form_factor brightness)
  <= mutual_information N (generalized_weight N part_area part_form_factor (inherited parent brightness))
       (generalized_form_factor N part_form_factor (inherited parent brightness)).
Proof. exact DividedScene.dividing_patches_never_lowers_mutual_information. Qed.

(* With integrals over patches, of which only the rules are used: sums, constant factors, exchange of the order. *)
Theorem sums_over_elements_are_integrals : forall (n N : nat) (patch : nat -> nat) (area : nat -> R),
  integrals nat n (fun i f => part_sum N patch i (fun k => area k * f k)) (fun _ => True).
Proof. exact IntegralScenes.sums_over_elements_are_integrals. Qed.

Theorem integral_rows_sum_to_one :
  forall point n over integrable form_factor brightness received,
  integrals point n over integrable -> exchange_kernel point n over integrable form_factor brightness ->
  (forall x, received x = sum n (fun j => over j (fun y => form_factor x y * brightness y))) ->
  forall i, (i < n)%nat -> integral_area over brightness received i <> 0 ->
  sum n (fun j => integral_transition over form_factor brightness received i j) = 1.
Proof. exact IntegralChain.integral_rows_sum_to_one. Qed.

Theorem integral_chain_is_reciprocal :
  forall point n over integrable form_factor brightness received,
  integrals point n over integrable -> exchange_kernel point n over integrable form_factor brightness ->
  (forall i, (i < n)%nat -> integral_area over brightness received i <> 0) ->
  reciprocal n (integral_weight n over brightness received) (integral_transition over form_factor brightness received).
Proof. exact IntegralChain.integral_chain_is_reciprocal. Qed.

Theorem integral_weights_are_stationary :
  forall point n over integrable form_factor brightness received,
  integrals point n over integrable -> exchange_kernel point n over integrable form_factor brightness ->
  (forall x, received x = sum n (fun j => over j (fun y => form_factor x y * brightness y))) ->
  (forall i, (i < n)%nat -> integral_area over brightness received i <> 0) ->
  stationary n (integral_area over brightness received) (integral_transition over form_factor brightness received) /\
  stationary n (integral_weight n over brightness received) (integral_transition over form_factor brightness received).
Proof. exact IntegralChain.integral_weights_are_stationary. Qed.

Theorem integral_chain_is_markov :
  forall point n over integrable form_factor brightness received,
  integrals point n over integrable -> exchange_kernel point n over integrable form_factor brightness ->
  (forall x, received x = sum n (fun j => over j (fun y => form_factor x y * brightness y))) ->
  (0 < n)%nat ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= integral_exchange over form_factor brightness i j) ->
  (forall i, (i < n)%nat -> 0 < integral_area over brightness received i) ->
  markov_chain n (integral_weight n over brightness received) (integral_transition over form_factor brightness received).
Proof. exact IntegralChain.integral_chain_is_markov. Qed.

Theorem dividing_a_patch_with_integrals_fulfils_hypotheses_of_theorem_1 :
  forall point n s m over part_over integrable form_factor brightness received,
  (s < n)%nat -> (1 <= m)%nat ->
  integrals point (n - 1 + m) part_over integrable ->
  exchange_kernel point (n - 1 + m) part_over integrable form_factor brightness ->
  (forall j f, (j < n)%nat -> j <> s -> part_over j f = over j f) ->
  (forall f, over s f = sum m (fun k => part_over (substate n s k) f)) ->
  (forall j, (j < n - 1 + m)%nat -> integral_area part_over brightness received j <> 0) ->
  refines_state n s m
    (integral_weight n over brightness received) (integral_transition over form_factor brightness received)
    (integral_weight (n - 1 + m) part_over brightness received)
    (integral_transition part_over form_factor brightness received).
Proof. exact IntegralChain.dividing_a_patch_with_integrals_fulfils_hypotheses_of_theorem_1. Qed.

Theorem constant_brightness_with_integrals_is_visibility : forall point n over integrable form_factor,
  integrals point n over integrable ->
  forall k, k <> 0 ->
  (forall x, integrable (form_factor x)) -> integrable (fun _ => 1) ->
  (forall j, (j < n)%nat -> integrable (fun x => over j (form_factor x))) ->
  (forall i, (i < n)%nat -> over i (fun _ => 1) <> 0) ->
  forall i, (i < n)%nat ->
  integral_weight n over (fun _ => k) (fun _ => k) i = over i (fun _ => 1) / sum n (fun j => over j (fun _ => 1)) /\
  forall j, (j < n)%nat ->
    integral_transition over form_factor (fun _ => k) (fun _ => k) i j =
    over i (fun x => over j (form_factor x)) / over i (fun _ => 1).
Proof. exact IntegralScenes.constant_brightness_with_integrals_is_visibility. Qed.

(* ==== Section 3.3: visibility ==== *)

Theorem dividing_a_visible_patch_fulfils_hypotheses_of_theorem_1 :
  forall n s m area form_factor part_area part_form_factor,
  scene n area form_factor -> closed n form_factor ->
  scene (n - 1 + m) part_area part_form_factor -> closed (n - 1 + m) part_form_factor ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  refines_state n s m
    (fun i => area i / sum n area) form_factor
    (fun k => part_area k / sum (n - 1 + m) part_area) part_form_factor.
Proof. exact Visibility.dividing_a_visible_patch_fulfils_hypotheses_of_theorem_1. Qed.

Theorem dividing_visible_patches_never_lowers_mutual_information :
  forall n N parent area form_factor part_area part_form_factor,
  (0 < N)%nat ->
  scene n area form_factor -> closed n form_factor ->
  scene N part_area part_form_factor -> closed N part_form_factor ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  mutual_information n (fun i => area i / sum n area) form_factor
  <= mutual_information N (fun k => part_area k / sum N part_area) part_form_factor.
Proof. exact Visibility.dividing_visible_patches_never_lowers_mutual_information. Qed.

Theorem words_of_visibility_gain : forall m total area_i area_j form_factor part_area part_form_factor,
  visibility_pair_gain m total area_i area_j form_factor part_area part_form_factor =
  2 * (sum m (fun k => part_area k / total * xlog2 (part_form_factor k) (area_j / total))
       - area_i / total * xlog2 form_factor (area_j / total)).
Proof. easy. Qed.

Theorem gain_of_visible_patch_is_sum_of_pair_gains :
  forall n s m area form_factor part_area part_form_factor,
  scene n area form_factor -> closed n form_factor ->
  scene (n - 1 + m) part_area part_form_factor -> closed (n - 1 + m) part_form_factor ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  form_factor s s = 0 ->
  mutual_information (n - 1 + m) (fun k => part_area k / sum (n - 1 + m) part_area) part_form_factor
  - mutual_information n (fun i => area i / sum n area) form_factor =
  sum_others n s (fun j => visibility_pair_gain m (sum n area) (area s) (area j) (form_factor s j)
    (fun k => part_area (substate n s k)) (fun k => part_form_factor (substate n s k) j)).
Proof. exact VisibleGain.gain_of_visible_patch_is_sum_of_pair_gains. Qed.

Theorem visibility_pair_gain_without_areas :
  forall m total area_i area_j form_factor part_area part_form_factor,
  0 < total -> 0 < area_j -> 0 <= form_factor ->
  (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => part_area k * part_form_factor k) = area_i * form_factor ->
  2 * (sum m (fun k => part_area k / total * xlog2 (part_form_factor k) (area_j / total))
       - area_i / total * xlog2 form_factor (area_j / total))
  = 2 * (sum m (fun k => part_area k / total * xlog2 (part_form_factor k) 1)
         - area_i / total * xlog2 form_factor 1).
Proof. exact PotentialGain.visibility_pair_gain_without_areas. Qed.

Theorem regular_visibility_gain_at_most : forall m total area_i area_j form_factor part_form_factor,
  (1 <= m)%nat -> 0 < total -> 0 < area_i -> 0 < area_j -> 0 <= form_factor ->
  (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => area_i / INR m * part_form_factor k) = area_i * form_factor ->
  visibility_pair_gain m total area_i area_j form_factor (fun _ => area_i / INR m) part_form_factor
  <= 2 * (area_i / total) * form_factor * log2 (INR m).
Proof. exact PotentialGain.regular_visibility_gain_at_most. Qed.

Theorem regular_visibility_gain_attained : forall m total area_i area_j form_factor part_form_factor k,
  (1 <= m)%nat -> 0 < total -> 0 < area_i -> 0 < area_j -> 0 <= form_factor ->
  (forall l, (l < m)%nat -> 0 <= part_form_factor l) ->
  sum m (fun l => area_i / INR m * part_form_factor l) = area_i * form_factor ->
  (k < m)%nat -> (forall l, (l < m)%nat -> l <> k -> part_form_factor l = 0) ->
  visibility_pair_gain m total area_i area_j form_factor (fun _ => area_i / INR m) part_form_factor
  = 2 * (area_i / total) * form_factor * log2 (INR m).
Proof. exact PotentialGain.regular_visibility_gain_attained. Qed.

Theorem visibility_bound_summed_over_patches : forall n m area form_factor i,
  closed n form_factor -> (i < n)%nat ->
  sum n (fun j => 2 * (area i / sum n area) * form_factor i j * log2 (INR m))
  = 2 * (area i / sum n area) * log2 (INR m).
Proof. exact PotentialGain.visibility_bound_summed_over_patches. Qed.
