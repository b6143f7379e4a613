(* Section 3.5: importance. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums ConstantOnPatches DividedScene Grouping Importance
  ImportanceDivision IntegralChain IntegralScenes MarkovChains NullVariance NullVarianceWalks PiecewiseScenes Radiosity
  Refinement StateRefinement Theorem1 WalkMeans WeightedScene.
Open Scope R_scope.

(* ==== Section 3.5: importance ==== *)

(* With integrals: brightness R I. *)
Theorem importance_received_with_integrals : forall point n over integrable form_factor,
  integrals point n over integrable ->
  forall reflectance initial_importance importance,
  (forall x, integrable (fun y => reflectance y * form_factor x y * importance y)) ->
  (forall x, importance x =
     initial_importance x + sum n (fun j => over j (fun y => reflectance y * form_factor x y * importance y))) ->
  forall x, importance x - initial_importance x =
    sum n (fun j => over j (fun y => form_factor x y * (reflectance y * importance y))).
Proof. exact IntegralScenes.importance_received_with_integrals. Qed.

Theorem uniform_reflected_importance_solves_with_integrals_iff : forall (point : Type) n over integrable form_factor,
  integrals point n over integrable ->
  forall k reflectance initial_importance,
  (forall x, integrable (form_factor x)) -> (forall x, sum n (fun j => over j (form_factor x)) = 1) ->
  (forall x : point, reflectance x <> 0) ->
  (forall x, k / reflectance x = initial_importance x +
     sum n (fun j => over j (fun y => reflectance y * form_factor x y * (k / reflectance y)))) <->
  (forall x, initial_importance x = k * (1 / reflectance x - 1)).
Proof. exact IntegralScenes.uniform_reflected_importance_solves_with_integrals_iff. Qed.

Theorem bounded_importance_with_integrals_is_unique : forall (point : Type) n over integrable form_factor,
  integrals point n over integrable ->
  forall rho bound reflectance initial_importance importance importance',
  (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, f x <= g x) -> over i f <= over i g) ->
  (forall x y, 0 <= form_factor x y) -> (forall x, integrable (form_factor x)) ->
  (forall x, sum n (fun j => over j (form_factor x)) <= 1) -> rho < 1 -> (forall x, 0 <= reflectance x <= rho) ->
  (forall x, integrable (fun y => reflectance y * form_factor x y * importance y)) ->
  (forall x, integrable (fun y => reflectance y * form_factor x y * importance' y)) ->
  (forall x, Rabs (reflectance x * importance x) <= bound) -> (forall x, Rabs (reflectance x * importance' x) <= bound) ->
  (forall x, importance x =
     initial_importance x + sum n (fun j => over j (fun y => reflectance y * form_factor x y * importance y))) ->
  (forall x, importance' x =
     initial_importance x + sum n (fun j => over j (fun y => reflectance y * form_factor x y * importance' y))) ->
  forall x : point, importance x = importance' x.
Proof. exact IntegralScenes.bounded_importance_with_integrals_is_unique. Qed.

(* Importances and reflectivities constant along each patch. *)
Theorem words_of_importance : forall n area form_factor reflectance initial_importance importance,
  (importance_equation n form_factor reflectance initial_importance importance <-> forall i, (i < n)%nat ->
    importance i = initial_importance i + sum n (fun j => reflectance j * form_factor i j * importance j)) /\
  (forall i, importance_area area reflectance initial_importance importance i =
    area i * (reflectance i * importance i) * (importance i - initial_importance i)) /\
  (forall i, importance_weight n area reflectance initial_importance importance i =
    importance_area area reflectance initial_importance importance i /
    sum n (importance_area area reflectance initial_importance importance)) /\
  (forall i j, importance_transition form_factor reflectance initial_importance importance i j =
    reflectance j * form_factor i j * importance j / (importance i - initial_importance i)) /\
  (importance_solution n area form_factor reflectance initial_importance importance <->
    scene n area form_factor /\ importance_equation n form_factor reflectance initial_importance importance /\
    (forall i, (i < n)%nat -> 0 < reflectance i) /\ (forall i, (i < n)%nat -> 0 <= initial_importance i) /\
    (forall i, (i < n)%nat -> initial_importance i < importance i)).
Proof. repeat (split; [easy|]). split; [intros []|intros [? [? [? []]]]; constructor]; auto. Qed.

Theorem importance_rows_sum_to_one : forall n form_factor reflectance initial_importance importance,
  importance_equation n form_factor reflectance initial_importance importance ->
  (forall i, (i < n)%nat -> importance i <> initial_importance i) ->
  forall i, (i < n)%nat ->
  sum n (fun j => reflectance j * form_factor i j * importance j / (importance i - initial_importance i)) = 1.
Proof. exact Importance.importance_rows_sum_to_one. Qed.

Theorem importance_reciprocity : forall n area form_factor reflectance initial_importance importance,
  importance_equation n form_factor reflectance initial_importance importance ->
  (forall i, (i < n)%nat -> importance i <> initial_importance i) ->
  scene n area form_factor ->
  forall i j, (i < n)%nat -> (j < n)%nat ->
  area i * (reflectance i * importance i) * (importance i - initial_importance i)
    * (reflectance j * form_factor i j * importance j / (importance i - initial_importance i))
  = area j * (reflectance j * importance j) * (importance j - initial_importance j)
    * (reflectance i * form_factor j i * importance i / (importance j - initial_importance j)).
Proof. exact Importance.importance_reciprocity. Qed.

Theorem importance_chain_is_reciprocal : forall n area form_factor reflectance initial_importance importance,
  importance_equation n form_factor reflectance initial_importance importance ->
  (forall i, (i < n)%nat -> importance i <> initial_importance i) ->
  scene n area form_factor ->
  reciprocal n (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance).
Proof. exact Importance.importance_chain_is_reciprocal. Qed.

Theorem importance_weights_are_stationary :
  forall n area form_factor reflectance initial_importance importance,
  importance_equation n form_factor reflectance initial_importance importance ->
  (forall i, (i < n)%nat -> importance i <> initial_importance i) ->
  scene n area form_factor ->
  stationary n (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance).
Proof. exact Importance.importance_weights_are_stationary. Qed.

Theorem importance_chain_is_markov : forall n area form_factor reflectance initial_importance importance,
  importance_solution n area form_factor reflectance initial_importance importance -> (0 < n)%nat ->
  markov_chain n (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance).
Proof. exact Importance.importance_chain_is_markov. Qed.

(* I, V and R constant on each patch: the integrals are the discrete formulas, with the mean form factors. *)
Theorem importance_with_integrals_extends_discrete : forall point n over integrable form_factor patch,
  integrals point n over integrable ->
  integrals_are_local n over integrable patch ->
  integrable_form_factor point n over integrable form_factor ->
  forall reflectance initial_importance importance : nat -> R,
  exchange_kernel point n over integrable form_factor (fun x => reflectance (patch x) * importance (patch x)) ->
  (forall x, importance (patch x) = initial_importance (patch x)
     + sum n (fun j => over j (fun y => form_factor x y * (reflectance (patch y) * importance (patch y))))) ->
  let brightness := fun x => reflectance (patch x) * importance (patch x) in
  let received := fun x => importance (patch x) - initial_importance (patch x) in
  let mean := mean_form_factor over form_factor in
  (forall i, (i < n)%nat -> integral_weight n over brightness received i
     = importance_weight n (integral_of_one over) reflectance initial_importance importance i) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> reflectance i * importance i <> 0 -> importance i <> initial_importance i ->
     integral_transition over form_factor brightness received i j
     = reflectance j * mean i j * importance j / (importance i - initial_importance i)) /\
  importance_equation n mean reflectance initial_importance importance.
Proof. exact ConstantOnPatches.importance_with_integrals_extends_discrete. Qed.

(* Null variance. A walk shoots: it starts on i with probability A_i E_i I_i over the sum of all, with the weight A_i E_i
   over that probability, goes from i to j with probability P_ij, multiplies its weight by R_j F_ij / P_ij and adds weight
   times V. For V = 1 on one patch and 0 elsewhere it finds the power of that patch. *)
Theorem words_of_shooting : forall n area emittance importance i,
  emitted_importance n area emittance importance = sum n (fun l => area l * emittance l * importance l) /\
  shooting_start n area emittance importance i =
    area i * emittance i * importance i / emitted_importance n area emittance importance /\
  shooting_weight n area emittance importance i = emitted_importance n area emittance importance / importance i.
Proof. easy. Qed.

Theorem shooting_starts_are_probabilities : forall n area emittance importance,
  emitted_importance n area emittance importance <> 0 ->
  sum n (shooting_start n area emittance importance) = 1 /\
  forall i, shooting_start n area emittance importance i <> 0 ->
    area i * emittance i / shooting_start n area emittance importance i
    = shooting_weight n area emittance importance i.
Proof. exact NullVariance.shooting_starts_are_probabilities. Qed.

Theorem emitted_importance_is_received_power : forall n area form_factor reflectance emittance radiosity
    initial_importance importance,
  scene n area form_factor ->
  radiosity_equation n form_factor reflectance emittance radiosity ->
  importance_equation n form_factor reflectance initial_importance importance ->
  sum n (fun i => area i * emittance i * importance i) = sum n (fun i => area i * initial_importance i * radiosity i).
Proof. exact NullVariance.emitted_importance_is_received_power. Qed.

Theorem emitted_importance_of_one_patch_is_its_power : forall n area form_factor reflectance emittance radiosity
    importance patch, (patch < n)%nat ->
  scene n area form_factor ->
  radiosity_equation n form_factor reflectance emittance radiosity ->
  importance_equation n form_factor reflectance (fun i => if Nat.eqb i patch then 1 else 0) importance ->
  sum n (fun i => area i * emittance i * importance i) = area patch * radiosity patch.
Proof. exact NullVariance.emitted_importance_of_one_patch_is_its_power. Qed.

Theorem shooting_step_is_possible_iff : forall n area form_factor reflectance initial_importance importance,
  importance_solution n area form_factor reflectance initial_importance importance ->
  forall i j, (i < n)%nat -> (j < n)%nat ->
  0 < importance_transition form_factor reflectance initial_importance importance i j <-> 0 < form_factor i j.
Proof. exact NullVariance.shooting_step_is_possible_iff. Qed.

Theorem shooting_walk_adds_up_to_total :
  forall n area form_factor reflectance emittance initial_importance importance,
  let T := fun i j => reflectance j * form_factor i j in
  let P := importance_transition form_factor reflectance initial_importance importance in
  let total := emitted_importance n area emittance importance in
  forall path K, importance (path 0%nat) <> 0 -> (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_score (total / importance (path 0%nat)) T P initial_importance path K
    + walk_rest (total / importance (path 0%nat)) T P initial_importance importance path K = total.
Proof. exact NullVariance.shooting_walk_adds_up_to_total. Qed.

Theorem shooting_rest_is_product :
  forall n area form_factor reflectance emittance initial_importance importance,
  let T := fun i j => reflectance j * form_factor i j in
  let P := importance_transition form_factor reflectance initial_importance importance in
  let total := emitted_importance n area emittance importance in
  forall path K, importance (path 0%nat) <> 0 -> (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_rest (total / importance (path 0%nat)) T P initial_importance importance path K
  = total * prod_f_R0 (fun k => 1 - initial_importance (path k) / importance (path k)) K.
Proof. exact NullVariance.shooting_rest_is_product. Qed.

Theorem shooting_walk_finds_total_iff :
  forall n area form_factor reflectance emittance initial_importance importance,
  let T := fun i j => reflectance j * form_factor i j in
  let P := importance_transition form_factor reflectance initial_importance importance in
  let total := emitted_importance n area emittance importance in
  forall path, total <> 0 -> importance (path 0%nat) <> 0 -> (forall k, 0 < P (path k) (path (S k))) ->
  Un_cv (walk_score (total / importance (path 0%nat)) T P initial_importance path) total <->
  Un_cv (prod_f_R0 (fun k => 1 - initial_importance (path k) / importance (path k))) 0.
Proof. exact NullVariance.shooting_walk_finds_total_iff. Qed.

Theorem shooting_walk_that_meets_sources_again_finds_total :
  forall n area form_factor reflectance emittance initial_importance importance,
  importance_solution n area form_factor reflectance initial_importance importance ->
  let T := fun i j => reflectance j * form_factor i j in
  let P := importance_transition form_factor reflectance initial_importance importance in
  let total := emitted_importance n area emittance importance in
  forall path, (forall k, (path k < n)%nat) -> (forall k, 0 < P (path k) (path (S k))) ->
  (forall m, exists k, (m <= k)%nat /\ 0 < initial_importance (path k)) ->
  Un_cv (walk_score (total / importance (path 0%nat)) T P initial_importance path) total.
Proof. exact NullVariance.shooting_walk_that_meets_sources_again_finds_total. Qed.

(* The mean over starts and walks. *)
Theorem shooting_walks_have_no_variance :
  forall n area form_factor reflectance emittance initial_importance importance,
  importance_solution n area form_factor reflectance initial_importance importance ->
  let T := fun i j => reflectance j * form_factor i j in
  let P := importance_transition form_factor reflectance initial_importance importance in
  let total := emitted_importance n area emittance importance in
  forall K, total <> 0 ->
  sum n (fun i => shooting_start n area emittance importance i * walk_mean n P K i (fun path =>
    walk_score (total / importance i) T P initial_importance path K
      + walk_rest (total / importance i) T P initial_importance importance path K)) = total /\
  sum n (fun i => shooting_start n area emittance importance i * walk_mean n P K i (fun path =>
    (walk_score (total / importance i) T P initial_importance path K
      + walk_rest (total / importance i) T P initial_importance importance path K - total) ^ 2)) = 0.
Proof. exact NullVariance.shooting_walks_have_no_variance. Qed.

Theorem shooting_mean_square_falls_geometrically :
  forall n area form_factor reflectance emittance initial_importance importance,
  importance_solution n area form_factor reflectance initial_importance importance ->
  let T := fun i j => reflectance j * form_factor i j in
  let P := importance_transition form_factor reflectance initial_importance importance in
  let total := emitted_importance n area emittance importance in
  forall rho bound, (forall i, (i < n)%nat -> 0 <= emittance i) -> 0 < total ->
  (forall i, (i < n)%nat -> sum n (fun j => form_factor i j) <= 1) ->
  (forall i, (i < n)%nat -> reflectance i <= rho) -> (forall i, (i < n)%nat -> importance i <= bound) ->
  forall K,
  sum n (fun i => shooting_start n area emittance importance i * walk_mean n P K i (fun path =>
    (walk_score (total / importance i) T P initial_importance path K - total) ^ 2))
  <= total * sum n (fun i => area i * emittance i) * bound * rho ^ S K.
Proof. exact NullVariance.shooting_mean_square_falls_geometrically. Qed.

Theorem null_variance_shooting_step_iff : forall (form_factor : nat -> nat -> R)
    (reflectance initial_importance importance : nat -> R) i j Q,
  Q <> 0 -> importance i <> initial_importance i ->
  initial_importance i + reflectance j * form_factor i j / Q * importance j = importance i <->
  Q = reflectance j * form_factor i j * importance j / (importance i - initial_importance i).
Proof. exact NullVariance.null_variance_shooting_step_iff. Qed.

(* What the walks need can be met, here and in section 3.4. *)
Theorem walk_to_and_fro_fulfils_hypotheses :
  let form_factor := fun i j => if Nat.eqb i j then 0 else 1 in
  let source := fun i => match i with O => 1 | _ => 0 end in
  let solution := fun i => match i with O => 4 / 3 | _ => 2 / 3 end in
  let path := fun k => if Nat.even k then 0%nat else 1%nat in
  radiosity_solution 2 (fun _ => 1) form_factor (fun _ => 1 / 2) source solution /\
  importance_solution 2 (fun _ => 1) form_factor (fun _ => 1 / 2) source solution /\
  0 < emitted_importance 2 (fun _ => 1) source solution /\
  (forall k, (path k < 2)%nat /\ 0 < form_factor (path k) (path (S k))) /\
  (forall m, exists k, (m <= k)%nat /\ 0 < source (path k)).
Proof. exact NullVariance.walk_to_and_fro_fulfils_hypotheses. Qed.

(* Reversion to visibility. *)
Theorem uniform_reflected_importance_solves_iff : forall n form_factor reflectance initial_importance k,
  closed n form_factor -> (forall i, (i < n)%nat -> reflectance i <> 0) ->
  importance_equation n form_factor reflectance initial_importance (fun i => k / reflectance i) <->
  (forall i, (i < n)%nat -> initial_importance i = k * (1 / reflectance i - 1)).
Proof. exact Importance.uniform_reflected_importance_solves_iff. Qed.

Theorem uniform_reflected_importance_is_the_only_solution :
  forall n area form_factor reflectance initial_importance k importance,
  scene n area form_factor -> closed n form_factor ->
  (forall i, (i < n)%nat -> 0 < reflectance i < 1) ->
  (forall i, (i < n)%nat -> initial_importance i = k * (1 / reflectance i - 1)) ->
  importance_equation n form_factor reflectance initial_importance importance ->
  forall i, (i < n)%nat -> reflectance i * importance i = k.
Proof. exact Importance.uniform_reflected_importance_is_the_only_solution. Qed.

Theorem importance_reverts_to_visibility :
  forall n area form_factor reflectance initial_importance k importance,
  scene n area form_factor -> closed n form_factor -> k <> 0 ->
  (forall i, (i < n)%nat -> 0 < reflectance i < 1) ->
  (forall i, (i < n)%nat -> initial_importance i = k * (1 / reflectance i - 1)) ->
  importance_equation n form_factor reflectance initial_importance importance ->
  forall i, (i < n)%nat ->
  importance_weight n area reflectance initial_importance importance i = area i / sum n area /\
  (forall j, (j < n)%nat ->
     importance_transition form_factor reflectance initial_importance importance i j = form_factor i j).
Proof. exact Importance.importance_reverts_to_visibility. Qed.

(* The importance equation is the radiosity equation for B = R I and E = R V. *)
Theorem importance_solution_is_radiosity_solution :
  forall n area form_factor reflectance initial_importance importance,
  importance_solution n area form_factor reflectance initial_importance importance ->
  radiosity_solution n area form_factor reflectance
    (fun i => reflectance i * initial_importance i) (fun i => reflectance i * importance i).
Proof. exact PiecewiseScenes.importance_solution_is_radiosity_solution. Qed.

Theorem importance_area_is_radiosity_area : forall area reflectance initial_importance importance i,
  reflectance i <> 0 ->
  importance_area area reflectance initial_importance importance i =
  radiosity_area area reflectance
    (fun i => reflectance i * initial_importance i) (fun i => reflectance i * importance i) i.
Proof. exact PiecewiseScenes.importance_area_is_radiosity_area. Qed.

Theorem importance_transition_is_radiosity_transition :
  forall form_factor reflectance initial_importance importance i j,
  reflectance i <> 0 -> importance i <> initial_importance i ->
  importance_transition form_factor reflectance initial_importance importance i j =
  radiosity_transition form_factor reflectance
    (fun i => reflectance i * initial_importance i) (fun i => reflectance i * importance i) i j.
Proof. exact PiecewiseScenes.importance_transition_is_radiosity_transition. Qed.

(* The hypotheses of Theorem 1. *)
Theorem dividing_a_patch_of_constant_importance_fulfils_hypotheses_of_theorem_1 :
  forall n s m area form_factor reflectance initial_importance importance
    part_area part_form_factor part_initial_importance,
  let part_reflectance := inherited (parent_state n s) reflectance in
  let part_importance := inherited (parent_state n s) importance in
  importance_solution n area form_factor reflectance initial_importance importance ->
  importance_solution (n - 1 + m) part_area part_form_factor part_reflectance
    part_initial_importance part_importance ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  refines_state n s m
    (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance)
    (importance_weight (n - 1 + m) part_area part_reflectance part_initial_importance part_importance)
    (importance_transition part_form_factor part_reflectance part_initial_importance part_importance).
Proof. exact ImportanceDivision.dividing_a_patch_of_constant_importance_fulfils_hypotheses_of_theorem_1. Qed.

Theorem dividing_a_patch_of_constant_importance_never_lowers_mutual_information :
  forall n s m area form_factor reflectance initial_importance importance
    part_area part_form_factor part_initial_importance,
  let part_reflectance := inherited (parent_state n s) reflectance in
  let part_importance := inherited (parent_state n s) importance in
  importance_solution n area form_factor reflectance initial_importance importance ->
  importance_solution (n - 1 + m) part_area part_form_factor part_reflectance
    part_initial_importance part_importance ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  mutual_information n
    (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance)
  <= mutual_information (n - 1 + m)
       (importance_weight (n - 1 + m) part_area part_reflectance part_initial_importance part_importance)
       (importance_transition part_form_factor part_reflectance part_initial_importance part_importance).
Proof. exact ImportanceDivision.dividing_a_patch_of_constant_importance_never_lowers_mutual_information. Qed.

Theorem printed_importance_parts_are_reciprocal :
  forall n N parent area form_factor reflectance initial_importance importance part_area part_form_factor,
  importance_solution n area form_factor reflectance initial_importance importance ->
  scene N part_area part_form_factor ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  reciprocal N
    (importance_weight N part_area
       (inherited parent reflectance) (inherited parent initial_importance) (inherited parent importance))
    (importance_transition part_form_factor
       (inherited parent reflectance) (inherited parent initial_importance) (inherited parent importance)).
Proof. exact ImportanceDivision.printed_importance_parts_are_reciprocal. Qed.

Theorem printed_importance_parts_cover :
  forall n N parent form_factor reflectance initial_importance importance part_form_factor k j,
  (k < N)%nat -> (j < n)%nat ->
  part_sum N parent j (part_form_factor k) = form_factor (parent k) j ->
  importance_transition form_factor reflectance initial_importance importance (parent k) j
  = part_sum N parent j (importance_transition part_form_factor
      (inherited parent reflectance) (inherited parent initial_importance) (inherited parent importance) k).
Proof. exact ImportanceDivision.printed_importance_parts_cover. Qed.

Theorem printed_importance_parts_never_lower_mutual_information :
  forall n N parent area form_factor reflectance initial_importance importance part_area part_form_factor,
  importance_solution n area form_factor reflectance initial_importance importance ->
  scene N part_area part_form_factor ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  mutual_information n (importance_weight n area reflectance initial_importance importance)
    (importance_transition form_factor reflectance initial_importance importance)
  <= mutual_information N
       (importance_weight N part_area
          (inherited parent reflectance) (inherited parent initial_importance) (inherited parent importance))
       (importance_transition part_form_factor
          (inherited parent reflectance) (inherited parent initial_importance) (inherited parent importance)).
Proof. exact ImportanceDivision.printed_importance_parts_never_lower_mutual_information. Qed.

Theorem printed_importance_part_row_sums_to_one_iff :
  forall n N parent area form_factor reflectance initial_importance importance part_area part_form_factor,
  importance_solution n area form_factor reflectance initial_importance importance ->
  divided_scene n N parent area form_factor part_area part_form_factor ->
  forall k, (k < N)%nat ->
  sum N (importance_transition part_form_factor
    (inherited parent reflectance) (inherited parent initial_importance) (inherited parent importance) k) = 1 <->
  importance (parent k) = initial_importance (parent k)
    + sum N (fun l => reflectance (parent l) * part_form_factor k l * importance (parent l)).
Proof. exact ImportanceDivision.printed_importance_part_row_sums_to_one_iff. Qed.

Theorem patch_importance_weight_is_grouped : forall N area reflectance initial_importance importance patch i,
  part_sum N patch i (fun k => area k * (reflectance k * importance k) * (importance k - initial_importance k))
  / sum N (fun k => area k * (reflectance k * importance k) * (importance k - initial_importance k))
  = grouped_weight N patch (importance_weight N area reflectance initial_importance importance) i.
Proof. exact PiecewiseScenes.patch_importance_weight_is_grouped. Qed.

Theorem patch_importance_transition_is_grouped :
  forall N area form_factor reflectance initial_importance importance,
  (0 < N)%nat -> importance_solution N area form_factor reflectance initial_importance importance ->
  forall patch i j,
  block_sum N patch i j
    (fun k l => form_factor k l * (area k * (reflectance k * reflectance l) * (importance k * importance l)))
  / part_sum N patch i (fun k => area k * (reflectance k * importance k) * (importance k - initial_importance k))
  = grouped_transition N patch (importance_weight N area reflectance initial_importance importance)
      (importance_transition form_factor reflectance initial_importance importance) i j.
Proof. exact PiecewiseScenes.patch_importance_transition_is_grouped. Qed.

Theorem patch_importance_chain_is_markov_and_reciprocal :
  forall N area form_factor reflectance initial_importance importance,
  (0 < N)%nat -> importance_solution N area form_factor reflectance initial_importance importance ->
  let w := importance_weight N area reflectance initial_importance importance in
  let P := importance_transition form_factor reflectance initial_importance importance in
  forall n patch, groups n N patch ->
  markov_chain n (grouped_weight N patch w) (grouped_transition N patch w P) /\
  reciprocal n (grouped_weight N patch w) (grouped_transition N patch w P).
Proof. exact PiecewiseScenes.patch_importance_chain_is_markov_and_reciprocal. Qed.

Theorem parts_refine_patches_of_varying_importance :
  forall N area form_factor reflectance initial_importance importance,
  (0 < N)%nat -> importance_solution N area form_factor reflectance initial_importance importance ->
  let w := importance_weight N area reflectance initial_importance importance in
  let P := importance_transition form_factor reflectance initial_importance importance in
  forall n m part patch, groups m N part -> groups n m patch ->
  refines n m patch
    (grouped_weight N (fun k => patch (part k)) w) (grouped_transition N (fun k => patch (part k)) w P)
    (grouped_weight N part w) (grouped_transition N part w P).
Proof. exact PiecewiseScenes.parts_refine_patches_of_varying_importance. Qed.
