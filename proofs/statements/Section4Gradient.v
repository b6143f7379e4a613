(* Section 4.2: mutual information and mean square error. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums AcrossTheGradient AcrossTheGradientGain
  AcrossTheGradientPower Corollary1 CutDecimals CutOrder CutsCompared Decimals DensityRatio Extremum
  GradientPatch InformationCut IntegralsOverParts LambdaEquation LeaningCut MeanSquareCut OnlyBestCutIsBest
  OnlyStraightCutsAreBest Stationarity StripBeatsStraightCuts.
Open Scope R_scope.

(* ==== Section 4.2: where a cut is stationary ==== *)

Theorem words_of_cuts : forall (f : R -> R) (u v c G0 W0 G W a b : R),
  (only_maximiser f u v c <-> u < c < v /\ forall x, u < x < v -> x <> c -> f x < f c) /\
  (only_minimiser f u v c <-> u < c < v /\ forall x, u < x < v -> x <> c -> f c < f x) /\
  (rises_then_falls f u c v <->
    (forall x y, u < x -> x < y -> y <= c -> f x < f y) /\ (forall x y, c <= x -> x < y -> y < v -> f y < f x)) /\
  (falls_then_rises f u c v <->
    (forall x y, u < x -> x < y -> y <= c -> f y < f x) /\ (forall x y, c <= x -> x < y -> y < v -> f x < f y)) /\
  two_sided_information G0 W0 G W = xlog2 G W + xlog2 (G0 - G) (W0 - W) /\
  logarithmic_mean a b = (if Req_EM_T a b then a else (a - b) / ln (a / b)) /\
  arithmetic_mean a b = (a + b) / 2.
Proof. easy. Qed.

Theorem derivative_of_two_sided_information : forall (G W : R -> R) (G0 W0 t G' W' : R),
  0 < G t < G0 -> 0 < W t < W0 -> is_derive G t G' -> is_derive W t W' ->
  let a := G t / W t in
  let b := (G0 - G t) / (W0 - W t) in
  is_derive (fun s => two_sided_information G0 W0 (G s) (W s)) t ((G' * ln (a / b) - W' * (a - b)) / ln 2).
Proof. exact Stationarity.derivative_of_two_sided_information. Qed.

Theorem cut_is_stationary_iff_ratio_is_logarithmic_mean : forall (G W : R -> R) (G0 W0 t G' W' : R),
  0 < G t < G0 -> 0 < W t < W0 -> is_derive G t G' -> is_derive W t W' -> W' <> 0 ->
  let a := G t / W t in
  let b := (G0 - G t) / (W0 - W t) in
  a <> b ->
  (is_derive (fun s => two_sided_information G0 W0 (G s) (W s)) t 0 <-> G' / W' = logarithmic_mean a b).
Proof. exact Stationarity.cut_is_stationary_iff_ratio_is_logarithmic_mean. Qed.

Theorem cut_between_equal_densities_is_stationary : forall (G W : R -> R) (G0 W0 t G' W' : R),
  0 < G t < G0 -> 0 < W t < W0 -> is_derive G t G' -> is_derive W t W' ->
  G t / W t = (G0 - G t) / (W0 - W t) ->
  is_derive (fun s => two_sided_information G0 W0 (G s) (W s)) t 0.
Proof. exact Stationarity.cut_between_equal_densities_is_stationary. Qed.

(* ==== Section 4.2: the information cut ==== *)

Theorem words_of_gradient_patch : forall (total B H K w_j w1 P1 w2 P2 w P p k l lambda : R) (n m : nat),
  gain_of_two_parts w1 P1 w2 P2 w P w_j = 2 * (w1 * xlog2 P1 w_j + w2 * xlog2 P2 w_j - w * xlog2 P w_j) /\
  (let weight := fun u v => RInt (fun x => B * x ^ n * (H * x ^ m)) u v / total in
   let flux := fun u v => RInt (fun x => K * (B * x ^ n)) u v / total in
   gradient_strip_flux total B K n 0 1 = flux 0 1 /\
   gradient_patch_gain total B H K w_j n m l =
     gain_of_two_parts (weight 0 l) (flux 0 l / weight 0 l) (weight l 1) (flux l 1 / weight l 1)
       (weight 0 1) (flux 0 1 / weight 0 1) w_j) /\
  cut_objective n m l =
    INR m * l ^ (n + 1) * log2 (1 / l) + (1 - l ^ (n + 1)) * log2 ((1 - l ^ (n + 1)) / (1 - l ^ (n + m + 1))) /\
  printed_objective n l =
    l ^ (n + 1) * log2 (1 / l) + (1 - l ^ (n + 1)) * log2 ((1 - l ^ (n + 1)) / (1 - l ^ (n + 2))) /\
  corrected_objective n l =
    INR n * l ^ (n + 1) * log2 (1 / l) + (1 - l ^ (n + 1)) * log2 ((1 - l ^ (n + 1)) / (1 - l ^ (2 * n + 1))) /\
  power_law_gain p k l = two_sided_information 1 1 (Rpower l p) (Rpower l (p + k)) /\
  density_ratio p k l = Rpower l k * (1 - Rpower l p) / (1 - Rpower l (p + k)) /\
  power_law_slope p k l = - ln (density_ratio p k l) - (p + k) / p * (1 - density_ratio p k l) /\
  lambda_quotient lambda = lambda / (1 - exp (- lambda)).
Proof. repeat split. Qed.

Theorem gain_depends_on_shares_only : forall flux weight w_j p1 a1,
  0 < flux -> 0 < weight -> 0 < w_j -> 0 < p1 < 1 -> 0 < a1 < 1 ->
  gain_of_two_parts (weight * a1) (flux * p1 / (weight * a1))
    (weight * (1 - a1)) (flux * (1 - p1) / (weight * (1 - a1))) weight (flux / weight) w_j =
  2 * flux * two_sided_information 1 1 p1 a1.
Proof. exact GradientPatch.gain_depends_on_shares_only. Qed.

Theorem gain_of_gradient_patch : forall total B H K w_j n m l,
  0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> 0 < l < 1 ->
  gradient_patch_gain total B H K w_j n m l = 2 * gradient_strip_flux total B K n 0 1 * cut_objective n m l.
Proof. exact GradientPatch.gain_of_gradient_patch. Qed.

Theorem printed_objective_has_irradiance_exponent_1 : forall n l, printed_objective n l = cut_objective n 1 l.
Proof. exact GradientPatch.printed_objective_has_irradiance_exponent_1. Qed.

Theorem corrected_objective_has_irradiance_exponent_n : forall n l, corrected_objective n l = cut_objective n n l.
Proof. exact GradientPatch.corrected_objective_has_irradiance_exponent_n. Qed.

Theorem printed_and_corrected_agree_for_linear_radiosity : forall l, corrected_objective 1 l = printed_objective 1 l.
Proof. exact GradientPatch.printed_and_corrected_agree_for_linear_radiosity. Qed.

Theorem constant_irradiance_gains_nothing : forall n l, 0 < l < 1 -> cut_objective n 0 l = 0.
Proof. exact GradientPatch.constant_irradiance_gains_nothing. Qed.

Theorem lambda_equation_has_one_positive_root : forall q, 1 < q ->
  exists root, ln q < root < q /\ lambda_quotient root = q /\
    forall x, 0 < x -> lambda_quotient x = q -> x = root.
Proof. exact LambdaEquation.lambda_equation_has_one_positive_root. Qed.

Theorem lambda_root_bracket : forall q lambda, 0 < lambda -> lambda_quotient lambda = q ->
  q - 1 < lambda < 2 * (q - 1).
Proof. exact LambdaEquation.lambda_root_bracket. Qed.

Theorem power_law_gain_closed_form : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  power_law_gain p k l =
  k * Rpower l p * log2 (1 / l) + (1 - Rpower l p) * log2 ((1 - Rpower l p) / (1 - Rpower l (p + k))).
Proof. exact InformationCut.power_law_gain_closed_form. Qed.

Theorem derivative_of_power_law_gain : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  is_derive (power_law_gain p k) l (p * Rpower l p / l / ln 2 * power_law_slope p k l).
Proof. exact InformationCut.derivative_of_power_law_gain. Qed.

Theorem power_law_slope_changes_sign_once : forall p k, 0 < p -> 0 < k ->
  exists c, 0 < c < 1 /\ power_law_slope p k c = 0 /\
    (forall l, 0 < l < c -> 0 < power_law_slope p k l) /\ (forall l, c < l < 1 -> power_law_slope p k l < 0).
Proof. exact InformationCut.power_law_slope_changes_sign_once. Qed.

Theorem power_law_gain_rises_then_falls : forall p k, 0 < p -> 0 < k ->
  exists c, 0 < c < 1 /\ power_law_slope p k c = 0 /\
    rises_then_falls (power_law_gain p k) 0 c 1 /\ only_maximiser (power_law_gain p k) 0 1 c.
Proof. exact InformationCut.power_law_gain_rises_then_falls. Qed.

Theorem optimal_cut_solves_density_equation : forall p k root c, 0 < p -> 0 < k ->
  0 < root -> lambda_quotient root = 1 + k / p -> 0 < c < 1 ->
  (only_maximiser (power_law_gain p k) 0 1 c <-> density_ratio p k c = exp (- root)).
Proof. exact InformationCut.optimal_cut_solves_density_equation. Qed.

Theorem printed_objective_rises_then_falls : forall n,
  exists c, 0 < c < 1 /\ rises_then_falls (printed_objective n) 0 c 1 /\ only_maximiser (printed_objective n) 0 1 c.
Proof. exact GradientPatch.printed_objective_rises_then_falls. Qed.

Theorem corrected_objective_rises_then_falls : forall n, (1 <= n)%nat ->
  exists c, 0 < c < 1 /\ rises_then_falls (corrected_objective n) 0 c 1 /\ only_maximiser (corrected_objective n) 0 1 c.
Proof. exact GradientPatch.corrected_objective_rises_then_falls. Qed.

(* Perpendicular to the gradient: divisions of any shape, given by the share s x of the strip at x. *)
Theorem words_of_divisions_of_any_shape : forall (g v s : R -> R) (w_j a b c x total B H K : R) (n m : nat),
  (share_of_strips g v s <->
    (forall x, 0 <= x <= 1 -> 0 <= s x <= 1) /\ ex_RInt (fun x => g x * s x) 0 1 /\ ex_RInt (fun x => v x * s x) 0 1) /\
  divided_flux g s = RInt (fun x => g x * s x) 0 1 /\ divided_weight v s = RInt (fun x => v x * s x) 0 1 /\
  division_information g v s =
    two_sided_information (RInt g 0 1) (RInt v 0 1) (divided_flux g s) (divided_weight v s) /\
  straight_cut_information g v c = two_sided_information (RInt g 0 1) (RInt v 0 1) (RInt g 0 c) (RInt v 0 c) /\
  (let rest := fun x => 1 - s x in
   division_gain g v w_j s =
     gain_of_two_parts (divided_weight v s) (divided_flux g s / divided_weight v s)
       (divided_weight v rest) (divided_flux g rest / divided_weight v rest)
       (RInt v 0 1) (RInt g 0 1 / RInt v 0 1) w_j) /\
  before c x = (if Rle_dec x c then 1 else 0) /\ leaning_cut a b x = Rmin 1 (Rmax 0 (a + b * x)) /\
  (is_straight_cut_at g c s <-> RInt (fun x => g x - g x * s x) 0 c = 0 /\ RInt (fun x => g x * s x) c 1 = 0) /\
  gradient_flux_density total B K n x = / total * (K * (B * x ^ n)) /\
  gradient_weight_density total B H n m x = / total * (B * x ^ n * (H * x ^ m)) /\
  gradient_division_gain total B H K w_j n m s =
    division_gain (gradient_flux_density total B K n) (gradient_weight_density total B H n m) w_j s.
Proof. easy. Qed.

Theorem integral_takes_every_value : forall (f : R -> R) (y : R), ex_RInt f 0 1 -> 0 <= y <= RInt f 0 1 -> exists c
  : R, 0 <= c <= 1 /\ RInt f 0 c = y.
Proof. exact IntegralsOverParts.integral_takes_every_value. Qed.

Theorem part_before_straight_cut_has_least_weight : forall flux_density weight_density ratio : R -> R, ex_RInt
  flux_density 0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0
  <= x <= 1 -> weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x <= y -> y <= 1 -> ratio
  x <= ratio y) -> forall (s : R -> R) (c : R), share_of_strips flux_density weight_density s -> 0 <= c <= 1 -> RInt
  flux_density 0 c = divided_flux flux_density s -> RInt weight_density 0 c <= divided_weight weight_density s.
Proof. exact AcrossTheGradient.part_before_straight_cut_has_least_weight. Qed.

Theorem some_straight_cut_gains_at_least_as_much : forall flux_density weight_density ratio : R -> R, ex_RInt
  flux_density 0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0
  <= x <= 1 -> weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x <= y -> y <= 1 -> ratio
  x <= ratio y) -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> forall s : R -> R, share_of_strips flux_density
  weight_density s -> exists c : R, 0 <= c <= 1 /\ division_information flux_density weight_density s <=
  straight_cut_information flux_density weight_density c.
Proof. exact AcrossTheGradient.some_straight_cut_gains_at_least_as_much. Qed.

Theorem best_straight_cut_is_best_division : forall flux_density weight_density ratio : R -> R, ex_RInt flux_density
  0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0 <= x <= 1 ->
  weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x <= y -> y <= 1 -> ratio x <= ratio y)
  -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> forall best : R, (forall c, 0 <= c <= 1 -> straight_cut_information
  flux_density weight_density c <= straight_cut_information flux_density weight_density best) -> forall s : R -> R,
  share_of_strips flux_density weight_density s -> division_information flux_density weight_density s <=
  straight_cut_information flux_density weight_density best.
Proof. exact AcrossTheGradient.best_straight_cut_is_best_division. Qed.

Theorem division_gain_nonneg : forall (flux_density weight_density ratio : R -> R) (w_j : R), ex_RInt flux_density 0
  1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0 <= x <= 1 ->
  weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x <= y -> y <= 1 -> ratio x <= ratio y)
  -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> 0 < w_j -> forall s : R -> R, share_of_strips flux_density
  weight_density s -> 0 <= division_gain flux_density weight_density w_j s.
Proof. exact AcrossTheGradientGain.division_gain_nonneg. Qed.

Theorem division_gain_symmetric : forall (flux_density weight_density ratio : R -> R) (w_j : R), ex_RInt
  flux_density 0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0
  <= x <= 1 -> weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x <= y -> y <= 1 -> ratio
  x <= ratio y) -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> 0 < w_j -> forall s : R -> R, share_of_strips
  flux_density weight_density s -> division_gain flux_density weight_density w_j (fun x => 1 - s x) = division_gain
  flux_density weight_density w_j s.
Proof. exact AcrossTheGradientGain.division_gain_symmetric. Qed.

Theorem no_division_gains_more_than_straight_cuts : forall (flux_density weight_density ratio : R -> R) (w_j : R),
  ex_RInt flux_density 0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) ->
  (forall x, 0 <= x <= 1 -> weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x <= y -> y
  <= 1 -> ratio x <= ratio y) -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> 0 < w_j -> forall s : R -> R,
  share_of_strips flux_density weight_density s -> exists c : R, 0 <= c <= 1 /\ share_of_strips flux_density
  weight_density (before c) /\ division_gain flux_density weight_density w_j s <= division_gain flux_density
  weight_density w_j (before c).
Proof. exact AcrossTheGradientGain.no_division_gains_more_than_straight_cuts. Qed.

Theorem cut_along_gradient_gains_nothing : forall (flux_density weight_density ratio : R -> R) (w_j : R), ex_RInt
  flux_density 0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0
  <= x <= 1 -> weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x <= y -> y <= 1 -> ratio
  x <= ratio y) -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> 0 < w_j -> forall k : R, 0 <= k <= 1 -> division_gain
  flux_density weight_density w_j (fun _ => k) = 0.
Proof. exact AcrossTheGradientGain.cut_along_gradient_gains_nothing. Qed.

Theorem cut_at_edge_gains_nothing : forall (flux_density weight_density ratio : R -> R) (w_j : R), ex_RInt
  flux_density 0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0
  <= x <= 1 -> weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x <= y -> y <= 1 -> ratio
  x <= ratio y) -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> 0 < w_j -> forall e : R, e = 0 \/ e = 1 -> division_gain
  flux_density weight_density w_j (before e) = 0.
Proof. exact AcrossTheGradientGain.cut_at_edge_gains_nothing. Qed.

Theorem without_gradient_no_division_gains : forall (flux_density : R -> R) (k w_j : R) (s : R -> R), ex_RInt
  flux_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> 0 < k -> 0 < w_j -> share_of_strips
  flux_density (fun x => k * flux_density x) s -> division_gain flux_density (fun x => k * flux_density x) w_j s =
  0.
Proof. exact AcrossTheGradientGain.without_gradient_no_division_gains. Qed.

Theorem straight_cut_has_gradient_patch_gain : forall (total B H K w_j : R) (n m : nat) (c : R), 0 <= c <= 1 ->
  gradient_division_gain total B H K w_j n m (before c) = gradient_patch_gain total B H K w_j n m c.
Proof. exact AcrossTheGradientPower.straight_cut_has_gradient_patch_gain. Qed.

Theorem no_division_gains_more_than_best_cut : forall (total B H K w_j : R) (n m : nat), 0 < total -> 0 < B -> 0 < H
  -> 0 < K -> 0 < w_j -> forall (best : R) (s : R -> R), (1 <= m)%nat -> only_maximiser (cut_objective n m) 0 1 best
  -> share_of_strips (gradient_flux_density total B K n) (gradient_weight_density total B H n m) s ->
  gradient_division_gain total B H K w_j n m s <= gradient_patch_gain total B H K w_j n m best.
Proof. exact AcrossTheGradientPower.no_division_gains_more_than_best_cut. Qed.

Theorem no_division_gains_more_than_printed_cut : forall (total B H K w_j : R) (n : nat) (best : R) (s : R -> R), 0
  < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> only_maximiser (printed_objective n) 0 1 best -> share_of_strips
  (gradient_flux_density total B K n) (gradient_weight_density total B H n 1) s -> gradient_division_gain total B H
  K w_j n 1 s <= gradient_patch_gain total B H K w_j n 1 best.
Proof. exact AcrossTheGradientPower.no_division_gains_more_than_printed_cut. Qed.

Theorem no_division_gains_more_than_corrected_cut : forall (total B H K w_j : R) (n : nat) (best : R) (s : R -> R),
  (1 <= n)%nat -> 0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> only_maximiser (corrected_objective n) 0 1 best
  -> share_of_strips (gradient_flux_density total B K n) (gradient_weight_density total B H n n) s ->
  gradient_division_gain total B H K w_j n n s <= gradient_patch_gain total B H K w_j n n best.
Proof. exact AcrossTheGradientPower.no_division_gains_more_than_corrected_cut. Qed.

Theorem no_leaning_cut_gains_more_than_best_cut : forall total B H K w_j n m best a b,
  0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> (1 <= m)%nat ->
  only_maximiser (cut_objective n m) 0 1 best ->
  gradient_division_gain total B H K w_j n m (leaning_cut a b) <= gradient_patch_gain total B H K w_j n m best.
Proof. exact LeaningCut.no_leaning_cut_gains_more_than_best_cut. Qed.

Theorem only_straight_cuts_can_be_best : forall (flux_density weight_density ratio : R -> R) (w_j : R), ex_RInt
  flux_density 0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0
  <= x <= 1 -> weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x < y -> y <= 1 -> ratio x
  < ratio y) -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> 0 < w_j -> forall s : R -> R, share_of_strips flux_density
  weight_density s -> (exists c, 0 <= c <= 1 /\ (is_straight_cut_at flux_density c s \/ is_straight_cut_at
  flux_density c (fun x => 1 - s x))) \/ (exists c, 0 <= c <= 1 /\ division_gain flux_density weight_density w_j s <
  division_gain flux_density weight_density w_j (before c)).
Proof. exact OnlyStraightCutsAreBest.only_straight_cuts_can_be_best. Qed.

Theorem straight_cut_gains_alike : forall (flux_density weight_density ratio : R -> R) (w_j : R), ex_RInt
  flux_density 0 1 -> ex_RInt weight_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> (forall x, 0
  <= x <= 1 -> weight_density x = ratio x * flux_density x) -> (forall x y : R, 0 <= x -> x < y -> y <= 1 -> ratio x
  < ratio y) -> (forall x, 0 < x <= 1 -> 0 < ratio x) -> 0 < w_j -> forall (s : R -> R) (c : R), share_of_strips
  flux_density weight_density s -> 0 <= c <= 1 -> is_straight_cut_at flux_density c s -> division_gain flux_density
  weight_density w_j s = division_gain flux_density weight_density w_j (before c).
Proof. exact OnlyStraightCutsAreBest.straight_cut_gains_alike. Qed.

Theorem division_as_good_as_best_cut_is_that_cut : forall (total B H K w_j : R) (n m : nat) (best : R) (s : R -> R),
  0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> (1 <= m)%nat -> only_maximiser (cut_objective n m) 0 1 best ->
  share_of_strips (gradient_flux_density total B K n) (gradient_weight_density total B H n m) s ->
  gradient_division_gain total B H K w_j n m s = gradient_patch_gain total B H K w_j n m best -> is_straight_cut_at
  (gradient_flux_density total B K n) best s \/ is_straight_cut_at (gradient_flux_density total B K n) best (fun x
  => 1 - s x).
Proof. exact OnlyBestCutIsBest.division_as_good_as_best_cut_is_that_cut. Qed.

(* Where the ratio does not rise from edge to edge, a strip can beat every straight cut. *)
Theorem words_of_the_strip : forall x : R,
  even_flux x = 1 /\ heavy_middle_weight x = 1 + 2 * in_middle x /\
  in_middle x = (if Rle_dec x (1 / 4) then 0 else if Rle_dec x (3 / 4) then 1 else 0).
Proof. easy. Qed.

Theorem strip_beats_every_straight_cut : share_of_strips even_flux heavy_middle_weight in_middle /\ (forall c, 0 <=
  c <= 1 -> straight_cut_information even_flux heavy_middle_weight c < division_information even_flux
  heavy_middle_weight in_middle).
Proof. exact StripBeatsStraightCuts.strip_beats_every_straight_cut. Qed.

(* The numbers, to thirty decimals: Decimals.v. *)
Theorem information_cut_printed_1_enclosed : exists l,
  information_cut_printed_1_lower < l < information_cut_printed_1_upper /\ only_maximiser (printed_objective 1) 0 1 l.
Proof. exact CutDecimals.information_cut_printed_1_enclosed. Qed.

Theorem information_cut_printed_2_enclosed : exists l,
  information_cut_printed_2_lower < l < information_cut_printed_2_upper /\ only_maximiser (printed_objective 2) 0 1 l.
Proof. exact CutDecimals.information_cut_printed_2_enclosed. Qed.

Theorem information_cut_printed_3_enclosed : exists l,
  information_cut_printed_3_lower < l < information_cut_printed_3_upper /\ only_maximiser (printed_objective 3) 0 1 l.
Proof. exact CutDecimals.information_cut_printed_3_enclosed. Qed.

Theorem information_cut_printed_4_enclosed : exists l,
  information_cut_printed_4_lower < l < information_cut_printed_4_upper /\ only_maximiser (printed_objective 4) 0 1 l.
Proof. exact CutDecimals.information_cut_printed_4_enclosed. Qed.

Theorem information_cut_corrected_1_enclosed : exists l,
  information_cut_corrected_1_lower < l < information_cut_corrected_1_upper /\ only_maximiser (corrected_objective 1) 0 1 l.
Proof. exact CutDecimals.information_cut_corrected_1_enclosed. Qed.

Theorem information_cut_corrected_2_enclosed : exists l,
  information_cut_corrected_2_lower < l < information_cut_corrected_2_upper /\ only_maximiser (corrected_objective 2) 0 1 l.
Proof. exact CutDecimals.information_cut_corrected_2_enclosed. Qed.

Theorem information_cut_corrected_3_enclosed : exists l,
  information_cut_corrected_3_lower < l < information_cut_corrected_3_upper /\ only_maximiser (corrected_objective 3) 0 1 l.
Proof. exact CutDecimals.information_cut_corrected_3_enclosed. Qed.

Theorem information_cut_corrected_4_enclosed : exists l,
  information_cut_corrected_4_lower < l < information_cut_corrected_4_upper /\ only_maximiser (corrected_objective 4) 0 1 l.
Proof. exact CutDecimals.information_cut_corrected_4_enclosed. Qed.

Theorem paper_information_cuts_are_rounded_maximisers : forall l1 l2 l3 l4,
  only_maximiser (printed_objective 1) 0 1 l1 -> only_maximiser (printed_objective 2) 0 1 l2 ->
  only_maximiser (printed_objective 3) 0 1 l3 -> only_maximiser (printed_objective 4) 0 1 l4 ->
  Rabs (l1 - 48 / 100) < 5 / 1000 /\ Rabs (l2 - 61 / 100) < 5 / 1000 /\
  Rabs (l3 - 68 / 100) < 5 / 1000 /\ Rabs (l4 - 74 / 100) < 5 / 1000.
Proof. exact CutDecimals.paper_information_cuts_are_rounded_maximisers. Qed.

Theorem corrected_information_cuts_round_to_62_70_76 : forall l2 l3 l4,
  only_maximiser (corrected_objective 2) 0 1 l2 ->
  only_maximiser (corrected_objective 3) 0 1 l3 -> only_maximiser (corrected_objective 4) 0 1 l4 ->
  Rabs (l2 - 62 / 100) < 5 / 1000 /\ Rabs (l3 - 70 / 100) < 5 / 1000 /\ Rabs (l4 - 76 / 100) < 5 / 1000.
Proof. exact CutDecimals.corrected_information_cuts_round_to_62_70_76. Qed.

(* ==== Section 4.2: the mean square cut ==== *)

Theorem words_of_mean_square_error : forall (B : R -> R) (n : nat) (x0 x1 t l : R),
  average B x0 x1 = RInt B x0 x1 / (x1 - x0) /\
  mean_square_error B x0 x1 t =
    RInt (fun x => (B x - average B x0 t) ^ 2) x0 t + RInt (fun x => (B x - average B t x1) ^ 2) t x1 /\
  (continuous_between B x0 x1 <-> forall x, x0 <= x <= x1 -> continuous B x) /\
  gradient_mean_square_error n l = mean_square_error (fun x => x ^ n) 0 1 l /\
  mean_square_polynomial n l = 2 * INR n * l ^ n - sum n (fun k => l ^ k).
Proof. easy. Qed.

Theorem mean_square_error_closed_form : forall B x0 x1 t,
  continuous_between B x0 x1 -> x0 < t < x1 ->
  mean_square_error B x0 x1 t =
  RInt (fun x => B x ^ 2) x0 x1 - RInt B x0 t ^ 2 / (t - x0) - (RInt B x0 x1 - RInt B x0 t) ^ 2 / (x1 - t).
Proof. exact Stationarity.mean_square_error_closed_form. Qed.

Theorem derivative_of_mean_square_error : forall B x0 x1 t,
  continuous_between B x0 x1 -> x0 < t < x1 ->
  is_derive (mean_square_error B x0 x1) t
    ((B t - average B x0 t) ^ 2 - (B t - average B t x1) ^ 2).
Proof. exact Stationarity.derivative_of_mean_square_error. Qed.

Theorem mean_square_cut_is_stationary_iff_radiosity_is_arithmetic_mean : forall B x0 x1 t,
  continuous_between B x0 x1 -> x0 < t < x1 ->
  (is_derive (mean_square_error B x0 x1) t 0 <->
   average B x0 t = average B t x1 \/ B t = arithmetic_mean (average B x0 t) (average B t x1)).
Proof. exact Stationarity.mean_square_cut_is_stationary_iff_radiosity_is_arithmetic_mean. Qed.

Theorem gradient_mean_square_error_closed_form : forall n l, 0 < l < 1 ->
  gradient_mean_square_error n l =
  1 / (2 * INR n + 1) - (l ^ (n + 1) / (INR n + 1)) ^ 2 / l - ((1 - l ^ (n + 1)) / (INR n + 1)) ^ 2 / (1 - l).
Proof. exact MeanSquareCut.gradient_mean_square_error_closed_form. Qed.

Theorem derivative_of_gradient_mean_square_error : forall n l, 0 < l < 1 ->
  is_derive (gradient_mean_square_error n) l
    (sum n (fun k => l ^ k) * mean_square_polynomial n l / (INR n + 1) ^ 2).
Proof. exact MeanSquareCut.derivative_of_gradient_mean_square_error. Qed.

Theorem printed_polynomial_has_one_positive_root : forall n, (1 <= n)%nat ->
  exists c, 0 < c < 1 /\ mean_square_polynomial n c = 0 /\
    forall x, 0 < x -> mean_square_polynomial n x = 0 -> x = c.
Proof. exact MeanSquareCut.printed_polynomial_has_one_positive_root. Qed.

Theorem mean_square_error_falls_then_rises : forall n c, (1 <= n)%nat ->
  0 < c < 1 -> mean_square_polynomial n c = 0 ->
  falls_then_rises (gradient_mean_square_error n) 0 c 1.
Proof. exact MeanSquareCut.mean_square_error_falls_then_rises. Qed.

Theorem mean_square_error_is_least_exactly_at_the_root : forall n l, (1 <= n)%nat -> 0 < l ->
  (mean_square_polynomial n l = 0 <-> only_minimiser (gradient_mean_square_error n) 0 1 l).
Proof. exact MeanSquareCut.mean_square_error_is_least_exactly_at_the_root. Qed.

Theorem mean_square_cut_of_linear_radiosity_is_one_half :
  only_minimiser (gradient_mean_square_error 1) 0 1 (1 / 2).
Proof. exact MeanSquareCut.mean_square_cut_of_linear_radiosity_is_one_half. Qed.

Theorem mean_square_cut_1_enclosed : exists l,
  mean_square_cut_1_lower < l < mean_square_cut_1_upper /\ only_minimiser (gradient_mean_square_error 1) 0 1 l.
Proof. exact CutDecimals.mean_square_cut_1_enclosed. Qed.

Theorem mean_square_cut_2_enclosed : exists l,
  mean_square_cut_2_lower < l < mean_square_cut_2_upper /\ only_minimiser (gradient_mean_square_error 2) 0 1 l.
Proof. exact CutDecimals.mean_square_cut_2_enclosed. Qed.

Theorem mean_square_cut_3_enclosed : exists l,
  mean_square_cut_3_lower < l < mean_square_cut_3_upper /\ only_minimiser (gradient_mean_square_error 3) 0 1 l.
Proof. exact CutDecimals.mean_square_cut_3_enclosed. Qed.

Theorem mean_square_cut_4_enclosed : exists l,
  mean_square_cut_4_lower < l < mean_square_cut_4_upper /\ only_minimiser (gradient_mean_square_error 4) 0 1 l.
Proof. exact CutDecimals.mean_square_cut_4_enclosed. Qed.

Theorem paper_mean_square_cuts_are_rounded_minimisers : forall l1 l2 l3 l4,
  only_minimiser (gradient_mean_square_error 1) 0 1 l1 -> only_minimiser (gradient_mean_square_error 2) 0 1 l2 ->
  only_minimiser (gradient_mean_square_error 3) 0 1 l3 -> only_minimiser (gradient_mean_square_error 4) 0 1 l4 ->
  l1 = 1 / 2 /\ Rabs (l2 - 64 / 100) < 5 / 1000 /\
  Rabs (l3 - 72 / 100) < 5 / 1000 /\ Rabs (l4 - 77 / 100) < 5 / 1000.
Proof. exact CutDecimals.paper_mean_square_cuts_are_rounded_minimisers. Qed.

(* ==== Section 4.2: the cuts compared ==== *)

Theorem steeper_irradiance_moves_the_cut_outward : forall p k1 k2 c1 c2, 0 < p -> 0 < k1 <= p -> k1 < k2 ->
  only_maximiser (power_law_gain p k1) 0 1 c1 -> only_maximiser (power_law_gain p k2) 0 1 c2 -> c1 < c2.
Proof. exact CutOrder.steeper_irradiance_moves_the_cut_outward. Qed.

Theorem printed_cut_lies_before_corrected_cut : forall n printed corrected, (2 <= n)%nat ->
  only_maximiser (printed_objective n) 0 1 printed -> only_maximiser (corrected_objective n) 0 1 corrected ->
  printed < corrected.
Proof. exact CutOrder.printed_cut_lies_before_corrected_cut. Qed.

Theorem corrected_cut_lies_before_mean_square_cut : forall n corrected mean_square, (1 <= n)%nat ->
  only_maximiser (corrected_objective n) 0 1 corrected ->
  only_minimiser (gradient_mean_square_error n) 0 1 mean_square ->
  corrected < mean_square.
Proof. exact CutsCompared.corrected_cut_lies_before_mean_square_cut. Qed.

Theorem corrected_cut_is_nearer_to_mean_square_cut : forall n printed corrected mean_square,
  (2 <= n)%nat ->
  only_maximiser (printed_objective n) 0 1 printed ->
  only_maximiser (corrected_objective n) 0 1 corrected ->
  only_minimiser (gradient_mean_square_error n) 0 1 mean_square ->
  printed < corrected < mean_square /\ Rabs (corrected - mean_square) < Rabs (printed - mean_square).
Proof. exact CutsCompared.corrected_cut_is_nearer_to_mean_square_cut. Qed.

Theorem printed_cuts_lie_within_36_thousandths_of_mean_square_cuts : forall n information_cut mean_square_cut,
  (1 <= n <= 4)%nat -> only_maximiser (printed_objective n) 0 1 information_cut ->
  only_minimiser (gradient_mean_square_error n) 0 1 mean_square_cut ->
  Rabs (information_cut - mean_square_cut) < 36 / 1000.
Proof. exact CutDecimals.printed_cuts_lie_within_36_thousandths_of_mean_square_cuts. Qed.

Theorem corrected_cuts_lie_within_19_thousandths_of_mean_square_cuts : forall n information_cut mean_square_cut,
  (1 <= n <= 4)%nat -> only_maximiser (corrected_objective n) 0 1 information_cut ->
  only_minimiser (gradient_mean_square_error n) 0 1 mean_square_cut ->
  Rabs (information_cut - mean_square_cut) < 19 / 1000.
Proof. exact CutDecimals.corrected_cuts_lie_within_19_thousandths_of_mean_square_cuts. Qed.
