(* Section 5: towards an oracle for subdivision. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums Corollary1 GradientOfAnyParts GradientRaisesGain OracleSteps
  PairGain PotentialGain Radiosity WeightedScene.
Open Scope R_scope.

(* ==== Section 5: towards an oracle ==== *)

Theorem sum_of_potential_gains_is_generalized_area : forall n area form_factor reflectance emittance radiosity,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall i, (i < n)%nat -> reflectance i <> 0) ->
  forall i, (i < n)%nat ->
  sum n (fun j => radiosity i * radiosity j * area i * form_factor i j)
  = area i * radiosity i * ((radiosity i - emittance i) / reflectance i).
Proof. exact Radiosity.sum_of_potential_gains_is_generalized_area. Qed.

Theorem constant_radiosity_pair_gain :
  forall m area_i form_factor part_area part_form_factor reflectance emittance radiosity_i radiosity_j,
  0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_j -> 0 <= form_factor ->
  (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => part_area k * part_form_factor k) = area_i * form_factor ->
  pair_gain_without_receiver m
    (area_i * radiosity_i * ((radiosity_i - emittance) / reflectance))
    (reflectance * form_factor * radiosity_j / (radiosity_i - emittance))
    (fun k => part_area k * radiosity_i * ((radiosity_i - emittance) / reflectance))
    (fun k => reflectance * part_form_factor k * radiosity_j / (radiosity_i - emittance))
  = 2 * radiosity_i * radiosity_j
      * (sum m (fun k => part_area k * xlog2 (part_form_factor k) 1) - area_i * xlog2 form_factor 1).
Proof. exact PotentialGain.constant_radiosity_pair_gain. Qed.

Theorem normalized_constant_radiosity_pair_gain :
  forall m total area_i form_factor part_area part_form_factor reflectance emittance radiosity_i radiosity_j,
  total <> 0 ->
  0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_j -> 0 <= form_factor ->
  (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => part_area k * part_form_factor k) = area_i * form_factor ->
  total * pair_gain_without_receiver m
    (area_i * radiosity_i * ((radiosity_i - emittance) / reflectance) / total)
    (reflectance * form_factor * radiosity_j / (radiosity_i - emittance))
    (fun k => part_area k * radiosity_i * ((radiosity_i - emittance) / reflectance) / total)
    (fun k => reflectance * part_form_factor k * radiosity_j / (radiosity_i - emittance))
  = 2 * radiosity_i * radiosity_j
      * (sum m (fun k => part_area k * xlog2 (part_form_factor k) 1) - area_i * xlog2 form_factor 1).
Proof. exact PotentialGain.normalized_constant_radiosity_pair_gain. Qed.

Theorem regular_constant_radiosity_gain_at_most :
  forall m area_i form_factor part_form_factor reflectance emittance radiosity_i radiosity_j,
  (1 <= m)%nat -> 0 < area_i -> 0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_i -> 0 < radiosity_j ->
  0 <= form_factor -> (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => area_i / INR m * part_form_factor k) = area_i * form_factor ->
  pair_gain_without_receiver m
    (area_i * radiosity_i * ((radiosity_i - emittance) / reflectance))
    (reflectance * form_factor * radiosity_j / (radiosity_i - emittance))
    (fun _ => area_i / INR m * radiosity_i * ((radiosity_i - emittance) / reflectance))
    (fun k => reflectance * part_form_factor k * radiosity_j / (radiosity_i - emittance))
  <= 2 * radiosity_i * radiosity_j * area_i * form_factor * log2 (INR m).
Proof. exact PotentialGain.regular_constant_radiosity_gain_at_most. Qed.

Theorem constant_radiosity_bound_summed_over_patches :
  forall n m area form_factor reflectance emittance radiosity i,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall l, (l < n)%nat -> reflectance l <> 0) -> (i < n)%nat ->
  sum n (fun j => 2 * radiosity i * radiosity j * area i * form_factor i j * log2 (INR m))
  = 2 * (area i * radiosity i * ((radiosity i - emittance i) / reflectance i)) * log2 (INR m).
Proof. exact PotentialGain.constant_radiosity_bound_summed_over_patches. Qed.

(* "The larger the gradient the larger the increase." *)
Theorem words_of_gradient_gain : forall (weight F receiver g : R) (n m i : nat) (w : nat -> R) (P : nat -> nat -> R),
  gain_of_halves weight F receiver g =
    pair_gain 2 weight F receiver (fun _ => weight / 2) (fun k => match k with O => F * (1 + g) | _ => F * (1 - g) end) /\
  gradient_information g = xlog2 (1 + g) 1 + xlog2 (1 - g) 1.
Proof. easy. Qed.

Theorem gradient_information_rises : forall g h : R, 0 <= g -> g < h -> h <= 1 -> gradient_information g <
  gradient_information h.
Proof. exact GradientRaisesGain.gradient_information_rises. Qed.

Theorem gain_of_halves_depends_on_gradient : forall weight F receiver g : R, 0 < F -> 0 < receiver -> 0 <= g <= 1 ->
  gain_of_halves weight F receiver g = weight * F * gradient_information g.
Proof. exact GradientRaisesGain.gain_of_halves_depends_on_gradient. Qed.

Theorem larger_gradient_gains_more : forall weight F receiver g h : R, 0 < weight -> 0 < F -> 0 < receiver -> 0 <= g
  -> g < h -> h <= 1 -> gain_of_halves weight F receiver g < gain_of_halves weight F receiver h.
Proof. exact GradientRaisesGain.larger_gradient_gains_more. Qed.

Theorem no_gradient_gains_nothing : forall weight F receiver : R, 0 < F -> 0 < receiver -> gain_of_halves weight F
  receiver 0 = 0.
Proof. exact GradientRaisesGain.no_gradient_gains_nothing. Qed.

Theorem full_gradient_gains_the_bound : forall weight F receiver : R, 0 < F -> 0 < receiver -> gain_of_halves weight
  F receiver 1 = 2 * weight * F * log2 2.
Proof. exact GradientRaisesGain.full_gradient_gains_the_bound. Qed.

Theorem words_of_gradient_of_parts : forall m weight probability part_weight part_probability,
  relative_gradient m weight probability part_weight part_probability =
  sum m (fun k => part_weight k * Rabs (part_probability k - probability)) / (weight * probability).
Proof. easy. Qed.

Theorem gradient_of_halves : forall weight F g, 0 < weight -> 0 < F -> 0 <= g ->
  relative_gradient 2 weight F (fun _ => weight / 2) (fun k => match k with O => F * (1 + g) | _ => F * (1 - g) end) = g.
Proof. exact GradientOfAnyParts.gradient_of_halves. Qed.

Theorem larger_gradient_of_any_parts_gains_more :
  forall m weight F receiver part_weight direction s t,
  0 < weight -> 0 < F -> 0 < receiver -> (forall k, (k < m)%nat -> 0 <= part_weight k) -> sum m part_weight = weight ->
  sum m (fun k => part_weight k * direction k) = 0 ->
  (exists k, (k < m)%nat /\ 0 < part_weight k /\ direction k <> 0) ->
  0 <= s -> s < t -> (forall k, (k < m)%nat -> 0 <= 1 + t * direction k) ->
  pair_gain m weight F receiver part_weight (fun k => F * (1 + s * direction k))
  < pair_gain m weight F receiver part_weight (fun k => F * (1 + t * direction k)).
Proof. exact GradientOfAnyParts.larger_gradient_of_any_parts_gains_more. Qed.

Theorem larger_gradient_of_other_parts_may_gain_less : exists v q v' q' : nat -> R,
  (forall k, (k < 2)%nat -> 0 < v k /\ 0 < q k /\ 0 < v' k /\ 0 < q' k) /\
  sum 2 v = 1 /\ sum 2 v' = 1 /\ sum 2 (fun k => v k * q k) = 1 /\ sum 2 (fun k => v' k * q' k) = 1 /\
  relative_gradient 2 1 1 v' q' < relative_gradient 2 1 1 v q /\
  pair_gain 2 1 1 1 v q < pair_gain 2 1 1 1 v' q'.
Proof. exact GradientOfAnyParts.larger_gradient_of_other_parts_may_gain_less. Qed.

(* The oracle, step 1: what it discards gains little. *)
Theorem words_of_oracle : forall m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j,
  potential area form_factor radiosity_i radiosity_j = radiosity_i * radiosity_j * area * form_factor /\
  reflected_power reflectance area form_factor radiosity_j = radiosity_j * reflectance * area * form_factor /\
  radiosity_gain m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j =
    pair_gain_without_receiver m
      (area * radiosity_i * ((radiosity_i - emittance) / reflectance) / total)
      (reflectance * form_factor * radiosity_j / (radiosity_i - emittance))
      (fun _ => area / INR m * radiosity_i * ((radiosity_i - emittance) / reflectance) / total)
      (fun k => reflectance * part_form_factor k * radiosity_j / (radiosity_i - emittance)).
Proof. easy. Qed.

Theorem discarded_pair_gains_little :
  forall m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j threshold,
  (1 <= m)%nat -> 0 < total -> 0 < area -> 0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_i -> 0 < radiosity_j ->
  0 <= form_factor -> (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => area / INR m * part_form_factor k) = area * form_factor ->
  potential area form_factor radiosity_i radiosity_j <= threshold ->
  radiosity_gain m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j
  <= 2 * threshold * log2 (INR m) / total.
Proof. exact OracleSteps.discarded_pair_gains_little. Qed.

Theorem potential_gain_is_attained :
  forall m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j k,
  (1 <= m)%nat -> 0 < total -> 0 < area -> 0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_i -> 0 < radiosity_j ->
  0 <= form_factor -> (forall l, (l < m)%nat -> 0 <= part_form_factor l) ->
  sum m (fun l => area / INR m * part_form_factor l) = area * form_factor ->
  (k < m)%nat -> (forall l, (l < m)%nat -> l <> k -> part_form_factor l = 0) ->
  radiosity_gain m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j
  = 2 * potential area form_factor radiosity_i radiosity_j * log2 (INR m) / total.
Proof. exact OracleSteps.potential_gain_is_attained. Qed.

Theorem discarded_pair_may_gain_all_of_it :
  exists total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j,
  0 < total /\ 0 < area /\ 0 < reflectance /\ emittance < radiosity_i /\ 0 < radiosity_i /\ 0 < radiosity_j /\
  0 < form_factor /\ (forall k, (k < 2)%nat -> 0 <= part_form_factor k) /\
  sum 2 (fun k => area / INR 2 * part_form_factor k) = area * form_factor /\
  radiosity_gain 2 total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j
  = 2 * potential area form_factor radiosity_i radiosity_j * log2 (INR 2) / total.
Proof. exact OracleSteps.discarded_pair_may_gain_all_of_it. Qed.

(* Step 2: the patch of larger generalized area has the larger bound. *)
Theorem potential_is_the_same_for_both : forall n area form_factor radiosity i j,
  scene n area form_factor -> (i < n)%nat -> (j < n)%nat ->
  potential (area i) (form_factor i j) (radiosity i) (radiosity j) =
  potential (area j) (form_factor j i) (radiosity j) (radiosity i).
Proof. exact OracleSteps.potential_is_the_same_for_both. Qed.

Theorem larger_generalized_area_has_larger_bound : forall n m area form_factor reflectance emittance radiosity i l,
  (2 <= m)%nat -> radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall j, (j < n)%nat -> reflectance j <> 0) -> (i < n)%nat -> (l < n)%nat ->
  (sum n (fun j => 2 * potential (area i) (form_factor i j) (radiosity i) (radiosity j) * log2 (INR m)) <=
   sum n (fun j => 2 * potential (area l) (form_factor l j) (radiosity l) (radiosity j) * log2 (INR m)) <->
   radiosity_area area reflectance emittance radiosity i <= radiosity_area area reflectance emittance radiosity l).
Proof. exact OracleSteps.larger_generalized_area_has_larger_bound. Qed.

Theorem larger_bound_may_gain_less :
  radiosity_gain 2 3 2 (1 / 2) (fun _ => 1 / 2) (1 / 2) 1 2 1 <
  radiosity_gain 2 3 1 (1 / 2) (fun k => match k with O => 1 | _ => 0 end) (1 / 2) 1 2 1 /\
  potential 1 (1 / 2) 2 1 < potential 2 (1 / 2) 2 1.
Proof. exact OracleSteps.larger_bound_may_gain_less. Qed.

(* Step 3: a gradient guarantees a gain. *)
Theorem pair_gain_is_at_least_squared_gradient : forall m weight probability receiver part_weight part_probability,
  0 < weight -> 0 < probability -> 0 < receiver ->
  (forall k, (k < m)%nat -> 0 <= part_weight k) -> (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m part_weight = weight -> sum m (fun k => part_weight k * part_probability k) = weight * probability ->
  weight * probability * relative_gradient m weight probability part_weight part_probability ^ 2 / ln 2
  <= pair_gain m weight probability receiver part_weight part_probability.
Proof. exact GradientOfAnyParts.pair_gain_is_at_least_squared_gradient. Qed.

(* Step 1 beside the power oracle. *)
Theorem potential_is_reflected_power_times_brightness_over_reflectance :
  forall n area form_factor reflectance radiosity i j,
  scene n area form_factor -> (i < n)%nat -> (j < n)%nat -> reflectance i <> 0 ->
  potential (area i) (form_factor i j) (radiosity i) (radiosity j) =
  radiosity i / reflectance i * reflected_power (reflectance i) (area j) (form_factor j i) (radiosity j).
Proof. exact OracleSteps.potential_is_reflected_power_times_brightness_over_reflectance. Qed.

Theorem reflected_power_and_potential_may_order_pairs_otherwise :
  exists form_factor form_factor' radiosity radiosity' source,
  0 < form_factor < 1 /\ 0 < form_factor' < 1 /\ 0 < radiosity /\ 0 < radiosity' /\ 0 < source /\
  reflected_power (1 / 2) 1 form_factor source < reflected_power (1 / 2) 1 form_factor' source /\
  potential 1 form_factor' radiosity' source < potential 1 form_factor radiosity source.
Proof. exact OracleSteps.reflected_power_and_potential_may_order_pairs_otherwise. Qed.
