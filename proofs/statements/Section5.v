(* Section 5: towards an oracle for subdivision. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums Corollary1 GradientRaisesGain PairGain PotentialGain
  Radiosity.
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
