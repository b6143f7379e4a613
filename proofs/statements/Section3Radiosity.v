(* Section 3.4: radiosity. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums ConstantOnPatches DividedScene Grouping IntegralChain
  IntegralScenes MarkovChains NullVariance NullVarianceWalks PiecewiseScenes Radiosity RadiosityDivision Refinement
  StateRefinement Theorem1 UniformRadiosity WalkMeans WeightedScene.
Open Scope R_scope.

(* ==== Section 3.4: radiosity ==== *)

(* With integrals: brightness B, and the diffuse equation solved for what reaches a point. *)
Theorem radiosity_received_with_integrals : forall (point : Type) n (over : nat -> (point -> R) -> R) form_factor
    reflectance emittance radiosity,
  (forall x, reflectance x <> 0) ->
  (forall x, radiosity x = emittance x + reflectance x * sum n (fun j => over j (fun y => form_factor x y * radiosity y))) ->
  forall x, (radiosity x - emittance x) / reflectance x = sum n (fun j => over j (fun y => form_factor x y * radiosity y)).
Proof. exact IntegralScenes.radiosity_received_with_integrals. Qed.

Theorem constant_radiosity_solves_with_integrals_iff : forall point n over integrable form_factor,
  integrals point n over integrable ->
  forall k reflectance emittance,
  (forall x, integrable (form_factor x)) -> (forall x, sum n (fun j => over j (form_factor x)) = 1) ->
  (forall x : point, k = emittance x + reflectance x * sum n (fun j => over j (fun y => form_factor x y * k))) <->
  (forall x, emittance x = k * (1 - reflectance x)).
Proof. exact IntegralScenes.constant_radiosity_solves_with_integrals_iff. Qed.

Theorem bounded_radiosity_with_integrals_is_unique : forall (point : Type) n over integrable form_factor,
  integrals point n over integrable ->
  forall rho bound reflectance emittance radiosity radiosity',
  (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, f x <= g x) -> over i f <= over i g) ->
  (forall x y, 0 <= form_factor x y) -> (forall x, integrable (form_factor x)) ->
  (forall x, sum n (fun j => over j (form_factor x)) <= 1) -> rho < 1 -> (forall x, 0 <= reflectance x <= rho) ->
  (forall x, integrable (fun y => form_factor x y * radiosity y)) ->
  (forall x, integrable (fun y => form_factor x y * radiosity' y)) ->
  (forall x, Rabs (radiosity x) <= bound) -> (forall x, Rabs (radiosity' x) <= bound) ->
  (forall x, radiosity x = emittance x + reflectance x * sum n (fun j => over j (fun y => form_factor x y * radiosity y))) ->
  (forall x, radiosity' x = emittance x + reflectance x * sum n (fun j => over j (fun y => form_factor x y * radiosity' y))) ->
  forall x : point, radiosity x = radiosity' x.
Proof. exact IntegralScenes.bounded_radiosity_with_integrals_is_unique. Qed.

(* Radiosities and reflectivities constant along each patch. *)
Theorem words_of_radiosity : forall n area form_factor reflectance emittance radiosity,
  (radiosity_equation n form_factor reflectance emittance radiosity <-> forall i, (i < n)%nat ->
    radiosity i = emittance i + reflectance i * sum n (fun j => form_factor i j * radiosity j)) /\
  (forall i, radiosity_area area reflectance emittance radiosity i =
    area i * radiosity i * ((radiosity i - emittance i) / reflectance i)) /\
  (forall i, radiosity_weight n area reflectance emittance radiosity i =
    radiosity_area area reflectance emittance radiosity i / sum n (radiosity_area area reflectance emittance radiosity)) /\
  (forall i j, radiosity_transition form_factor reflectance emittance radiosity i j =
    reflectance i * form_factor i j * radiosity j / (radiosity i - emittance i)) /\
  (forall i j, printed_radiosity_transition form_factor reflectance emittance radiosity i j =
    reflectance i * form_factor i j * radiosity i / (radiosity i - emittance i)) /\
  (radiosity_solution n area form_factor reflectance emittance radiosity <->
    scene n area form_factor /\ radiosity_equation n form_factor reflectance emittance radiosity /\
    (forall i, (i < n)%nat -> 0 < reflectance i) /\ (forall i, (i < n)%nat -> 0 <= emittance i) /\
    (forall i, (i < n)%nat -> emittance i < radiosity i)).
Proof. repeat (split; [easy|]). split; [intros []|intros [? [? [? []]]]; constructor]; auto. Qed.

Theorem radiosity_rows_sum_to_one : forall n form_factor reflectance emittance radiosity,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall i, (i < n)%nat -> reflectance i <> 0) ->
  (forall i, (i < n)%nat -> radiosity i <> emittance i) ->
  forall i, (i < n)%nat ->
  sum n (fun j => reflectance i * form_factor i j * radiosity j / (radiosity i - emittance i)) = 1.
Proof. exact Radiosity.radiosity_rows_sum_to_one. Qed.

Theorem radiosity_reciprocity : forall n area form_factor reflectance emittance radiosity,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall i, (i < n)%nat -> reflectance i <> 0) ->
  (forall i, (i < n)%nat -> radiosity i <> emittance i) ->
  scene n area form_factor ->
  forall i j, (i < n)%nat -> (j < n)%nat ->
  area i * radiosity i * ((radiosity i - emittance i) / reflectance i)
    * (reflectance i * form_factor i j * radiosity j / (radiosity i - emittance i))
  = area j * radiosity j * ((radiosity j - emittance j) / reflectance j)
    * (reflectance j * form_factor j i * radiosity i / (radiosity j - emittance j)).
Proof. exact Radiosity.radiosity_reciprocity. Qed.

Theorem radiosity_chain_is_reciprocal : forall n area form_factor reflectance emittance radiosity,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall i, (i < n)%nat -> reflectance i <> 0) ->
  (forall i, (i < n)%nat -> radiosity i <> emittance i) ->
  scene n area form_factor ->
  reciprocal n (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity).
Proof. exact Radiosity.radiosity_chain_is_reciprocal. Qed.

Theorem radiosity_weights_are_stationary : forall n area form_factor reflectance emittance radiosity,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall i, (i < n)%nat -> reflectance i <> 0) ->
  (forall i, (i < n)%nat -> radiosity i <> emittance i) ->
  scene n area form_factor ->
  stationary n (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity).
Proof. exact Radiosity.radiosity_weights_are_stationary. Qed.

Theorem radiosity_chain_is_markov : forall n area form_factor reflectance emittance radiosity,
  radiosity_solution n area form_factor reflectance emittance radiosity -> (0 < n)%nat ->
  markov_chain n (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity).
Proof. exact Radiosity.radiosity_chain_is_markov. Qed.

(* B, E and R constant on each patch: the integrals are the discrete formulas, with the mean form factors. *)
Theorem words_of_constants_on_patches :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable (patch : point -> nat) form_factor i j,
  (integrals_are_local n over integrable patch <-> forall i f g, (i < n)%nat -> integrable f -> integrable g ->
    (forall x, patch x = i -> f x = g x) -> over i f = over i g) /\
  integral_of_one over i = over i (fun _ => 1) /\
  mean_form_factor over form_factor i j = over i (fun x => over j (form_factor x)) / over i (fun _ => 1) /\
  (integrable_form_factor point n over integrable form_factor <->
    integrable (fun _ => 1) /\ (forall x, integrable (form_factor x)) /\
    (forall j, (j < n)%nat -> integrable (fun x => over j (form_factor x))) /\
    (forall i, (i < n)%nat -> over i (fun _ => 1) <> 0)).
Proof. repeat (split; [easy|]). split; [intros []|intros [? [? []]]; constructor]; auto. Qed.

Theorem radiosity_with_integrals_extends_discrete : forall point n over integrable form_factor patch,
  integrals point n over integrable ->
  integrals_are_local n over integrable patch ->
  integrable_form_factor point n over integrable form_factor ->
  forall reflectance emittance radiosity : nat -> R,
  exchange_kernel point n over integrable form_factor (fun x => radiosity (patch x)) ->
  (forall x, reflectance (patch x) <> 0) ->
  (forall x, radiosity (patch x) = emittance (patch x)
     + reflectance (patch x) * sum n (fun j => over j (fun y => form_factor x y * radiosity (patch y)))) ->
  let received := fun x => (radiosity (patch x) - emittance (patch x)) / reflectance (patch x) in
  let mean := mean_form_factor over form_factor in
  (forall i, (i < n)%nat -> integral_weight n over (fun x => radiosity (patch x)) received i
     = radiosity_weight n (integral_of_one over) reflectance emittance radiosity i) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> reflectance i <> 0 -> radiosity i <> 0 -> radiosity i <> emittance i ->
     integral_transition over form_factor (fun x => radiosity (patch x)) received i j
     = reflectance i * mean i j * radiosity j / (radiosity i - emittance i)) /\
  ((forall i, (i < n)%nat -> reflectance i <> 0) -> radiosity_equation n mean reflectance emittance radiosity).
Proof. exact ConstantOnPatches.radiosity_with_integrals_extends_discrete. Qed.

Theorem sums_over_elements_are_local : forall (n N : nat) (patch : nat -> nat) (area : nat -> R),
  integrals_are_local n (fun i f => part_sum N patch i (fun k => area k * f k)) (fun _ => True) patch.
Proof. exact ConstantOnPatches.sums_over_elements_are_local. Qed.

Theorem constants_on_two_patches_fulfil_hypotheses :
  let patch := fun x => match x with O => O | _ => 1%nat end in
  let over := fun i f => part_sum 2 patch i (fun k => 1 * f k) in
  let integrable := fun _ : nat -> R => True in
  let form_factor := fun x y => if Nat.eqb (patch x) (patch y) then 0 else 1 in
  let emittance := fun i => match i with O => 1 | _ => 0 end in
  let radiosity := fun i => match i with O => 4 / 3 | _ => 2 / 3 end in
  integrals nat 2 over integrable /\ integrals_are_local 2 over integrable patch /\
  integrable_form_factor nat 2 over integrable form_factor /\
  exchange_kernel nat 2 over integrable form_factor (fun x => radiosity (patch x)) /\
  (forall x, radiosity (patch x) = emittance (patch x)
     + 1 / 2 * sum 2 (fun j => over j (fun y => form_factor x y * radiosity (patch y)))).
Proof. exact ConstantOnPatches.constants_on_two_patches_fulfil_hypotheses. Qed.

(* Null variance. A walk gathers: it goes from i to j with probability P_ij, multiplies its weight by R_i F_ij / P_ij and
   adds weight times E. The theorems hold for each walk that is possible, not for the mean of many only. *)
Theorem words_of_walks : forall start transfer P source solution path n k i f,
  walk_weight start transfer P path 0 = start /\
  walk_weight start transfer P path (S k) =
    walk_weight start transfer P path k * (transfer (path k) (path (S k)) / P (path k) (path (S k))) /\
  walk_score start transfer P source path k = sum (S k) (fun l => walk_weight start transfer P path l * source (path l)) /\
  walk_rest start transfer P source solution path k =
    walk_weight start transfer P path k * (solution (path k) - source (path k)) /\
  share_left source solution path k = 1 - source (path k) / solution (path k) /\
  walk_mean n P 0 i f = f (fun _ => i) /\
  walk_mean n P (S k) i f = sum n (fun j => P i j *
    walk_mean n P k j (fun path => f (fun l => match l with O => i | S m => path m end))).
Proof. easy. Qed.

Theorem gathering_step_is_possible_iff : forall form_factor reflectance emittance radiosity n area,
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  forall i j, (i < n)%nat -> (j < n)%nat ->
  0 < radiosity_transition form_factor reflectance emittance radiosity i j <-> 0 < form_factor i j.
Proof. exact NullVariance.gathering_step_is_possible_iff. Qed.

Theorem gathering_walk_adds_up_to_radiosity : forall form_factor reflectance emittance radiosity,
  let T := fun i j => reflectance i * form_factor i j in
  let P := radiosity_transition form_factor reflectance emittance radiosity in
  forall path K, (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_score 1 T P emittance path K + walk_rest 1 T P emittance radiosity path K = radiosity (path 0%nat).
Proof. exact NullVariance.gathering_walk_adds_up_to_radiosity. Qed.

Theorem gathering_rest_is_product : forall form_factor reflectance emittance radiosity,
  let T := fun i j => reflectance i * form_factor i j in
  let P := radiosity_transition form_factor reflectance emittance radiosity in
  forall path K, radiosity (path 0%nat) <> 0 -> (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_rest 1 T P emittance radiosity path K
  = radiosity (path 0%nat) * prod_f_R0 (fun k => 1 - emittance (path k) / radiosity (path k)) K.
Proof. exact NullVariance.gathering_rest_is_product. Qed.

Theorem gathering_walk_finds_radiosity_iff : forall form_factor reflectance emittance radiosity,
  let T := fun i j => reflectance i * form_factor i j in
  let P := radiosity_transition form_factor reflectance emittance radiosity in
  forall path, radiosity (path 0%nat) <> 0 -> (forall k, 0 < P (path k) (path (S k))) ->
  Un_cv (walk_score 1 T P emittance path) (radiosity (path 0%nat)) <->
  Un_cv (prod_f_R0 (fun k => 1 - emittance (path k) / radiosity (path k))) 0.
Proof. exact NullVariance.gathering_walk_finds_radiosity_iff. Qed.

Theorem gathering_walk_that_meets_lamps_again_finds_radiosity :
  forall form_factor reflectance emittance radiosity n area,
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  let T := fun i j => reflectance i * form_factor i j in
  let P := radiosity_transition form_factor reflectance emittance radiosity in
  forall path, (forall k, (path k < n)%nat) -> (forall k, 0 < P (path k) (path (S k))) ->
  (forall m, exists k, (m <= k)%nat /\ 0 < emittance (path k)) ->
  Un_cv (walk_score 1 T P emittance path) (radiosity (path 0%nat)).
Proof. exact NullVariance.gathering_walk_that_meets_lamps_again_finds_radiosity. Qed.

Theorem gathering_walks_have_no_variance : forall form_factor reflectance emittance radiosity n area,
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  let T := fun i j => reflectance i * form_factor i j in
  let P := radiosity_transition form_factor reflectance emittance radiosity in
  forall K i, (i < n)%nat ->
  walk_mean n P K i (fun path =>
    walk_score 1 T P emittance path K + walk_rest 1 T P emittance radiosity path K) = radiosity i /\
  walk_mean n P K i (fun path =>
    (walk_score 1 T P emittance path K + walk_rest 1 T P emittance radiosity path K - radiosity i) ^ 2) = 0.
Proof. exact NullVariance.gathering_walks_have_no_variance. Qed.

Theorem gathering_mean_square_falls_geometrically : forall form_factor reflectance emittance radiosity n area,
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  let T := fun i j => reflectance i * form_factor i j in
  let P := radiosity_transition form_factor reflectance emittance radiosity in
  forall rho bound, (forall i, (i < n)%nat -> sum n (fun j => form_factor i j) <= 1) ->
  (forall i, (i < n)%nat -> reflectance i <= rho) -> (forall i, (i < n)%nat -> radiosity i <= bound) ->
  forall K i, (i < n)%nat ->
  walk_mean n P K i (fun path => (walk_score 1 T P emittance path K - radiosity i) ^ 2)
  <= radiosity i * bound * rho ^ S K.
Proof. exact NullVariance.gathering_mean_square_falls_geometrically. Qed.

Theorem null_variance_gathering_step_iff : forall (form_factor : nat -> nat -> R)
    (reflectance emittance radiosity : nat -> R) i j Q,
  Q <> 0 -> radiosity i <> emittance i ->
  emittance i + reflectance i * form_factor i j / Q * radiosity j = radiosity i <->
  Q = reflectance i * form_factor i j * radiosity j / (radiosity i - emittance i).
Proof. exact NullVariance.null_variance_gathering_step_iff. Qed.

(* The transition probabilities as printed, with B_i in the numerator, are none. *)
Theorem words_of_radiosity_examples : forall (i j : nat),
  two_patch_form_factor i j = (if Nat.eqb i j then 0 else 1) /\
  two_patch_emittance i = match i with O => 1 | _ => 0 end /\
  two_patch_radiosity i = match i with O => 4 / 3 | _ => 2 / 3 end /\
  half_dark_area i = match i with O => 2 | _ => 1 end /\
  half_dark_form_factor i j = match i, j with 0%nat, 1%nat => 1 / 2 | 1%nat, 0%nat => 1 | _, _ => 0 end /\
  half_dark_part_form_factor i j = match i, j with 0%nat, 1%nat => 1 | 1%nat, 0%nat => 1 | _, _ => 0 end /\
  half_dark_emittance i = match i with O => 3 / 2 | _ => 1 end.
Proof. easy. Qed.

Theorem printed_radiosity_row_sums_to_one_iff : forall n form_factor reflectance emittance radiosity,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall i, (i < n)%nat -> reflectance i <> 0) ->
  (forall i, (i < n)%nat -> radiosity i <> emittance i) ->
  forall i, (i < n)%nat ->
  sum n (fun j => reflectance i * form_factor i j * radiosity i / (radiosity i - emittance i)) = 1 <->
  sum n (fun j => form_factor i j * radiosity j) = radiosity i * sum n (fun j => form_factor i j).
Proof. exact Radiosity.printed_radiosity_row_sums_to_one_iff. Qed.

Theorem printed_radiosity_rows_do_not_sum_to_one :
  let form_factor := fun i j => if Nat.eqb i j then 0 else 1 in
  let emittance := fun i => match i with O => 1 | _ => 0 end in
  let radiosity := fun i => match i with O => 4 / 3 | _ => 2 / 3 end in
  scene 2 (fun _ => 1) form_factor /\ closed 2 form_factor /\
  radiosity_equation 2 form_factor (fun _ => 1 / 2) emittance radiosity /\
  (forall i, (i < 2)%nat -> emittance i < radiosity i) /\
  sum 2 (printed_radiosity_transition form_factor (fun _ => 1 / 2) emittance radiosity 0) = 2 /\
  sum 2 (printed_radiosity_transition form_factor (fun _ => 1 / 2) emittance radiosity 1) = 1 / 2.
Proof. exact Radiosity.printed_radiosity_rows_do_not_sum_to_one. Qed.

Theorem printed_radiosity_transitions_are_not_reciprocal :
  radiosity_area (fun _ => 1) (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity 0
    * printed_radiosity_transition two_patch_form_factor (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity 0 1
  <> radiosity_area (fun _ => 1) (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity 1
    * printed_radiosity_transition two_patch_form_factor (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity 1 0.
Proof. exact Radiosity.printed_radiosity_transitions_are_not_reciprocal. Qed.

(* Reversion to visibility. *)
Theorem radiosity_equation_has_at_most_one_solution : forall n form_factor reflectance,
  (forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= form_factor i j) ->
  (forall i, (i < n)%nat -> sum n (fun j => form_factor i j) <= 1) ->
  (forall i, (i < n)%nat -> 0 <= reflectance i < 1) ->
  forall emittance radiosity radiosity',
  radiosity_equation n form_factor reflectance emittance radiosity ->
  radiosity_equation n form_factor reflectance emittance radiosity' ->
  forall i, (i < n)%nat -> radiosity i = radiosity' i.
Proof. exact UniformRadiosity.radiosity_equation_has_at_most_one_solution. Qed.

Theorem radiosity_is_at_least_emittance : forall n form_factor reflectance,
  (forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= form_factor i j) ->
  (forall i, (i < n)%nat -> sum n (fun j => form_factor i j) <= 1) ->
  (forall i, (i < n)%nat -> 0 <= reflectance i < 1) ->
  forall emittance radiosity,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall i, (i < n)%nat -> 0 <= emittance i) ->
  forall i, (i < n)%nat -> emittance i <= radiosity i.
Proof. exact UniformRadiosity.radiosity_is_at_least_emittance. Qed.

Theorem uniform_radiosity_solves_iff : forall n form_factor reflectance emittance k,
  closed n form_factor ->
  radiosity_equation n form_factor reflectance emittance (fun _ => k) <->
  (forall i, (i < n)%nat -> emittance i = k * (1 - reflectance i)).
Proof. exact UniformRadiosity.uniform_radiosity_solves_iff. Qed.

Theorem uniform_radiosity_is_the_only_solution :
  forall n area form_factor reflectance emittance k radiosity,
  scene n area form_factor -> closed n form_factor ->
  (forall i, (i < n)%nat -> 0 <= reflectance i < 1) ->
  (forall i, (i < n)%nat -> emittance i = k * (1 - reflectance i)) ->
  radiosity_equation n form_factor reflectance emittance radiosity ->
  forall i, (i < n)%nat -> radiosity i = k.
Proof. exact UniformRadiosity.uniform_radiosity_is_the_only_solution. Qed.

Theorem radiosity_reverts_to_visibility : forall n area form_factor reflectance emittance k radiosity,
  scene n area form_factor -> closed n form_factor -> k <> 0 ->
  (forall i, (i < n)%nat -> 0 < reflectance i < 1) ->
  (forall i, (i < n)%nat -> emittance i = k * (1 - reflectance i)) ->
  radiosity_equation n form_factor reflectance emittance radiosity ->
  forall i, (i < n)%nat ->
  radiosity_weight n area reflectance emittance radiosity i = area i / sum n area /\
  (forall j, (j < n)%nat -> radiosity_transition form_factor reflectance emittance radiosity i j = form_factor i j).
Proof. exact UniformRadiosity.radiosity_reverts_to_visibility. Qed.

(* The hypotheses of Theorem 1, where the radiosity equation holds on the parts. *)
Theorem dividing_a_patch_of_constant_radiosity_fulfils_hypotheses_of_theorem_1 :
  forall n s m area form_factor reflectance emittance radiosity
    part_area part_form_factor part_reflectance part_emittance,
  let part_radiosity := inherited (parent_state n s) radiosity in
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  radiosity_solution (n - 1 + m) part_area part_form_factor part_reflectance part_emittance part_radiosity ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  refines_state n s m
    (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity)
    (radiosity_weight (n - 1 + m) part_area part_reflectance part_emittance part_radiosity)
    (radiosity_transition part_form_factor part_reflectance part_emittance part_radiosity).
Proof. exact RadiosityDivision.dividing_a_patch_of_constant_radiosity_fulfils_hypotheses_of_theorem_1. Qed.

Theorem dividing_a_patch_of_constant_radiosity_never_lowers_mutual_information :
  forall n s m area form_factor reflectance emittance radiosity
    part_area part_form_factor part_reflectance part_emittance,
  let part_radiosity := inherited (parent_state n s) radiosity in
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  radiosity_solution (n - 1 + m) part_area part_form_factor part_reflectance part_emittance part_radiosity ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  mutual_information n
    (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity)
  <= mutual_information (n - 1 + m)
       (radiosity_weight (n - 1 + m) part_area part_reflectance part_emittance part_radiosity)
       (radiosity_transition part_form_factor part_reflectance part_emittance part_radiosity).
Proof. exact RadiosityDivision.dividing_a_patch_of_constant_radiosity_never_lowers_mutual_information. Qed.

(* The parts keep B_i, E_i and R_i, as printed: (a), (b) and no loss, but rows need not sum to one. *)
Theorem printed_parts_are_reciprocal :
  forall n N parent area form_factor reflectance emittance radiosity part_area part_form_factor,
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  scene N part_area part_form_factor ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  reciprocal N
    (radiosity_weight N part_area
       (inherited parent reflectance) (inherited parent emittance) (inherited parent radiosity))
    (radiosity_transition part_form_factor
       (inherited parent reflectance) (inherited parent emittance) (inherited parent radiosity)).
Proof. exact RadiosityDivision.printed_parts_are_reciprocal. Qed.

Theorem printed_parts_cover :
  forall n N parent area form_factor reflectance emittance radiosity part_area part_form_factor,
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  forall k j, (k < N)%nat -> (j < n)%nat ->
  part_sum N parent j (part_form_factor k) = form_factor (parent k) j ->
  radiosity_transition form_factor reflectance emittance radiosity (parent k) j
  = part_sum N parent j (radiosity_transition part_form_factor
      (inherited parent reflectance) (inherited parent emittance) (inherited parent radiosity) k).
Proof. exact RadiosityDivision.printed_parts_cover. Qed.

Theorem printed_parts_never_lower_mutual_information :
  forall n N parent area form_factor reflectance emittance radiosity part_area part_form_factor,
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  scene N part_area part_form_factor ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  mutual_information n (radiosity_weight n area reflectance emittance radiosity)
    (radiosity_transition form_factor reflectance emittance radiosity)
  <= mutual_information N
       (radiosity_weight N part_area
          (inherited parent reflectance) (inherited parent emittance) (inherited parent radiosity))
       (radiosity_transition part_form_factor
          (inherited parent reflectance) (inherited parent emittance) (inherited parent radiosity)).
Proof. exact RadiosityDivision.printed_parts_never_lower_mutual_information. Qed.

Theorem printed_part_row_sums_to_one_iff :
  forall n N parent area form_factor reflectance emittance radiosity part_area part_form_factor,
  radiosity_solution n area form_factor reflectance emittance radiosity ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  forall k, (k < N)%nat ->
  sum N (radiosity_transition part_form_factor
    (inherited parent reflectance) (inherited parent emittance) (inherited parent radiosity) k) = 1 <->
  radiosity (parent k) = emittance (parent k)
    + reflectance (parent k) * sum N (fun l => part_form_factor k l * radiosity (parent l)).
Proof. exact RadiosityDivision.printed_part_row_sums_to_one_iff. Qed.

Theorem printed_parts_need_not_be_a_markov_chain :
  radiosity_solution 2 half_dark_area half_dark_form_factor (fun _ => 1 / 2) half_dark_emittance (fun _ => 2) /\
  scene 3 (fun _ => 1) half_dark_part_form_factor /\
  divided_patch 2 0 2 half_dark_area half_dark_form_factor (fun _ => 1) half_dark_part_form_factor /\
  sum 3 (radiosity_transition half_dark_part_form_factor (fun _ => 1 / 2)
           (inherited (parent_state 2 0) half_dark_emittance) (fun _ => 2) 0%nat) = 2 /\
  sum 3 (radiosity_transition half_dark_part_form_factor (fun _ => 1 / 2)
           (inherited (parent_state 2 0) half_dark_emittance) (fun _ => 2) 2%nat) = 0.
Proof. exact RadiosityDivision.printed_parts_need_not_be_a_markov_chain. Qed.

(* Radiosity that varies over a patch of many elements: the paper's P_ij and w_i with sums for integrals. *)
Theorem words_of_grouping : forall n N group w P i j,
  grouped_weight N group w i = part_sum N group i w /\
  grouped_transition N group w P i j =
    part_sum N group i (fun k => part_sum N group j (fun l => w k * P k l)) / grouped_weight N group w i /\
  (groups n N group <->
    (forall k, (k < N)%nat -> (group k < n)%nat) /\ (forall g, (g < n)%nat -> exists k, (k < N)%nat /\ group k = g)).
Proof. easy. Qed.

Theorem grouped_chain_is_markov : forall n N group w P,
  groups n N group -> markov_chain N w P -> (forall k, (k < N)%nat -> 0 < w k) ->
  markov_chain n (grouped_weight N group w) (grouped_transition N group w P).
Proof. exact Grouping.grouped_chain_is_markov. Qed.

Theorem grouped_chain_is_reciprocal : forall n N group w P,
  groups n N group -> reciprocal N w P -> (forall k, (k < N)%nat -> 0 < w k) ->
  reciprocal n (grouped_weight N group w) (grouped_transition N group w P).
Proof. exact Grouping.grouped_chain_is_reciprocal. Qed.

Theorem finer_grouping_refines_coarser : forall n m N part patch w P,
  groups m N part -> groups n m patch ->
  markov_chain N w P -> reciprocal N w P -> (forall k, (k < N)%nat -> 0 < w k) ->
  refines n m patch
    (grouped_weight N (fun k => patch (part k)) w) (grouped_transition N (fun k => patch (part k)) w P)
    (grouped_weight N part w) (grouped_transition N part w P).
Proof. exact Grouping.finer_grouping_refines_coarser. Qed.

Theorem patch_radiosity_weight_is_grouped : forall N area reflectance emittance radiosity patch i,
  part_sum N patch i (fun k => area k * radiosity k * ((radiosity k - emittance k) / reflectance k))
  / sum N (fun k => area k * radiosity k * ((radiosity k - emittance k) / reflectance k))
  = grouped_weight N patch (radiosity_weight N area reflectance emittance radiosity) i.
Proof. exact PiecewiseScenes.patch_radiosity_weight_is_grouped. Qed.

Theorem patch_radiosity_transition_is_grouped : forall N area form_factor reflectance emittance radiosity,
  (0 < N)%nat -> radiosity_solution N area form_factor reflectance emittance radiosity ->
  forall patch i j,
  block_sum N patch i j (fun k l => area k * form_factor k l * (radiosity k * radiosity l))
  / part_sum N patch i (fun k => area k * radiosity k * ((radiosity k - emittance k) / reflectance k))
  = grouped_transition N patch (radiosity_weight N area reflectance emittance radiosity)
      (radiosity_transition form_factor reflectance emittance radiosity) i j.
Proof. exact PiecewiseScenes.patch_radiosity_transition_is_grouped. Qed.

Theorem patch_radiosity_chain_is_markov_and_reciprocal :
  forall N area form_factor reflectance emittance radiosity,
  (0 < N)%nat -> radiosity_solution N area form_factor reflectance emittance radiosity ->
  let w := radiosity_weight N area reflectance emittance radiosity in
  let P := radiosity_transition form_factor reflectance emittance radiosity in
  forall n patch, groups n N patch ->
  markov_chain n (grouped_weight N patch w) (grouped_transition N patch w P) /\
  reciprocal n (grouped_weight N patch w) (grouped_transition N patch w P).
Proof. exact PiecewiseScenes.patch_radiosity_chain_is_markov_and_reciprocal. Qed.

Theorem parts_refine_patches_of_varying_radiosity :
  forall N area form_factor reflectance emittance radiosity,
  (0 < N)%nat -> radiosity_solution N area form_factor reflectance emittance radiosity ->
  let w := radiosity_weight N area reflectance emittance radiosity in
  let P := radiosity_transition form_factor reflectance emittance radiosity in
  forall n m part patch, groups m N part -> groups n m patch ->
  refines n m patch
    (grouped_weight N (fun k => patch (part k)) w) (grouped_transition N (fun k => patch (part k)) w P)
    (grouped_weight N part w) (grouped_transition N part w P).
Proof. exact PiecewiseScenes.parts_refine_patches_of_varying_radiosity. Qed.
