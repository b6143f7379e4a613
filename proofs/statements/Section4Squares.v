(* Section 4.1, figs. 2 and 3: squares with common edges. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums Corner Curves CutGain CutGainIsPairGain Decimals
  FormFactorIntegral OrthogonalCut OrthogonalCutSmall PairGain ParallelCut PerpendicularSquares.
Open Scope R_scope.

(* ==== Section 4.1, figs. 2 and 3: squares with common edges ==== *)

Theorem words_of_squares : forall x y y' z t w total_area area flux part_area part_flux : R,
  cut_gain total_area area flux part_area part_flux =
    2 / total_area * (xlog2 part_flux part_area + xlog2 (flux - part_flux) (area - part_area) - xlog2 flux area) /\
  exchange_area x z =
    (let S := x ^ 2 + z ^ 2 in
     let T := 1 + S in
     (x * atan (1 / x) + z * atan (1 / z) - sqrt S * atan (1 / sqrt S)
      + 1 / 4 * (ln ((1 + x ^ 2) * (1 + z ^ 2) / T)
                 + x ^ 2 * ln (x ^ 2 * T / ((1 + x ^ 2) * S))
                 + z ^ 2 * ln (z ^ 2 * T / ((1 + z ^ 2) * S)))) / PI) /\
  strip_exchange w = w ^ 2 * exchange_area (1 / w) (1 / w) /\
  orthogonal_exchange t = (strip_exchange t + strip_exchange 1 - strip_exchange (1 - t)) / 2 /\
  parallel_cut_gain t = cut_gain 2 1 (exchange_area 1 1) t (exchange_area t 1) /\
  orthogonal_cut_gain t = cut_gain 2 1 (exchange_area 1 1) t (orthogonal_exchange t) /\
  corner_cut_gain t =
    cut_gain 3 1 (exchange_area 1 1) t (exchange_area t 1) + cut_gain 3 1 (exchange_area 1 1) t (orthogonal_exchange t) /\
  (let r := sqrt (x ^ 2 + (y - y') ^ 2 + z ^ 2) in
   point_to_point_form_factor x y y' z = z / r * (x / r) / (PI * r ^ 2)).
Proof. easy. Qed.

(* The closed form is the form-factor integral: floor point (x, y, 0), wall point (0, y', z). The inner integrals exist. *)
Theorem exchange_area_is_the_form_factor_integral : forall X Z : R, 0 < X -> 0 < Z ->
  is_RInt (fun x => RInt (fun z => RInt (fun y => RInt (fun y' =>
    point_to_point_form_factor x y y' z) 0 1) 0 1) 0 Z) 0 X (exchange_area X Z).
Proof. exact FormFactorIntegral.exchange_area_is_the_form_factor_integral. Qed.

Theorem orthogonal_exchange_is_the_form_factor_integral : forall t : R, 0 < t <= 1 ->
  is_RInt (fun x => RInt (fun z => RInt (fun y => RInt (fun y' =>
    point_to_point_form_factor x y y' z) 0 1) 0 t) 0 1) 0 1 (orthogonal_exchange t).
Proof. exact FormFactorIntegral.orthogonal_exchange_is_the_form_factor_integral. Qed.

Theorem inner_integrals_exist : forall t x Z : R, 0 <= t <= 1 -> 0 < x -> 0 < Z ->
  (forall y z, ex_RInt (fun y' => point_to_point_form_factor x y y' z) 0 1) /\
  (forall z, ex_RInt (fun y => RInt (fun y' => point_to_point_form_factor x y y' z) 0 1) 0 t) /\
  ex_RInt (fun z => RInt (fun y => RInt (fun y' => point_to_point_form_factor x y y' z) 0 1) 0 t) 0 Z.
Proof. exact FormFactorIntegral.inner_integrals_exist. Qed.

Theorem squares_exchange_0_20004 : 0.20004377607 < exchange_area 1 1 < 0.20004377608.
Proof. exact PerpendicularSquares.squares_exchange_0_20004. Qed.

Theorem cut_gain_is_pair_gain_of_two_parts : forall total_area area flux part_area part_flux receiver : R,
  0 < total_area -> 0 < part_area < area -> 0 <= part_flux <= flux -> 0 < receiver ->
  cut_gain total_area area flux part_area part_flux
  = pair_gain 2 (area / total_area) (flux / area) receiver
      (of_two_parts (part_area / total_area) ((area - part_area) / total_area))
      (of_two_parts (part_flux / part_area) ((flux - part_flux) / (area - part_area))).
Proof. exact CutGainIsPairGain.cut_gain_is_pair_gain_of_two_parts. Qed.

(* Fig. 2(a), 2(c): the cut parallel to the common edge. *)
Theorem parallel_cut_has_exactly_one_best_place : exists best : R,
  fig2_parallel_cut_lower < best < fig2_parallel_cut_upper /\
  fig2_parallel_gain_lower < parallel_cut_gain best < fig2_parallel_gain_upper /\
  forall t, 0 <= t <= 1 -> t <> best -> parallel_cut_gain t < parallel_cut_gain best.
Proof. exact ParallelCut.parallel_cut_has_exactly_one_best_place. Qed.

Theorem parallel_cut_is_best_at_40_percent : forall best : R, 0 <= best <= 1 ->
  (forall t, 0 <= t <= 1 -> parallel_cut_gain t <= parallel_cut_gain best) -> 395/1000 < best < 405/1000.
Proof. exact ParallelCut.parallel_cut_is_best_at_40_percent. Qed.

Theorem words_of_curves : forall (gain : R -> R) (best : R),
  rises_to_one_maximum_and_falls_to_0 gain best <->
  gain 0 = 0 /\ gain 1 = 0 /\ 0 < best < 1 /\
  (forall s t, 0 <= s -> s < t -> t <= best -> gain s < gain t) /\
  (forall s t, best <= s -> s < t -> t <= 1 -> gain t < gain s).
Proof. easy. Qed.

Theorem parallel_gain_rises_to_one_maximum_and_falls_to_0 : exists best,
  fig2_parallel_cut_lower < best < fig2_parallel_cut_upper /\
  rises_to_one_maximum_and_falls_to_0 parallel_cut_gain best.
Proof. exact Curves.parallel_gain_rises_to_one_maximum_and_falls_to_0. Qed.

Theorem parallel_cut_in_the_middle_gains : 3 / 100 < parallel_cut_gain (1 / 2).
Proof. exact ParallelCut.parallel_cut_in_the_middle_gains. Qed.

(* Fig. 2(b): the cut orthogonal to the common edge. *)
Theorem proportional_cut_gains_nothing : forall total_area area flux share : R,
  cut_gain total_area area flux (share * area) (share * flux) = 0.
Proof. exact OrthogonalCut.proportional_cut_gains_nothing. Qed.

Theorem mirror_symmetry_makes_the_middle_cut_useless : forall (total_area : R) (flux : R -> R),
  (forall t, 0 <= t <= 1 -> flux t + flux (1 - t) = flux 1) ->
  cut_gain total_area 1 (flux 1) (1/2) (flux (1/2)) = 0.
Proof. exact OrthogonalCut.mirror_symmetry_makes_the_middle_cut_useless. Qed.

Theorem orthogonal_cut_in_the_middle_gains_nothing : orthogonal_cut_gain (1/2) = 0.
Proof. exact OrthogonalCut.orthogonal_cut_in_the_middle_gains_nothing. Qed.

Theorem orthogonal_cut_gains_less_than_7_in_10000 : forall t, 0 <= t <= 1 -> orthogonal_cut_gain t < 7 / 10000.
Proof. exact OrthogonalCutSmall.orthogonal_cut_gains_less_than_7_in_10000. Qed.

Theorem orthogonal_cut_gains_47_times_less_than_the_best_parallel_cut : forall best,
  0 <= best <= 1 -> (forall t, 0 <= t <= 1 -> parallel_cut_gain t <= parallel_cut_gain best) ->
  forall t, 0 <= t <= 1 -> 47 * orthogonal_cut_gain t < parallel_cut_gain best.
Proof. exact OrthogonalCutSmall.orthogonal_cut_gains_47_times_less_than_the_best_parallel_cut. Qed.

(* Fig. 3: the corner. *)
Theorem orthogonal_gain_rises_towards_the_side : forall s t : R,
  7/20 <= s < t -> t <= 9/20 -> orthogonal_cut_gain t < orthogonal_cut_gain s.
Proof. exact OrthogonalCutSmall.orthogonal_gain_rises_towards_the_side. Qed.

Theorem corner_cut_has_exactly_one_best_place : exists best : R,
  fig3_cut_lower < best < fig3_cut_upper /\
  fig3_gain_lower < corner_cut_gain best < fig3_gain_upper /\
  forall t, 0 <= t <= 1 -> t <> best -> corner_cut_gain t < corner_cut_gain best.
Proof. exact Corner.corner_cut_has_exactly_one_best_place. Qed.

Theorem corner_cut_is_best_at_39_percent : forall best : R, 0 <= best <= 1 ->
  (forall t, 0 <= t <= 1 -> corner_cut_gain t <= corner_cut_gain best) -> 385/1000 < best < 395/1000.
Proof. exact Corner.corner_cut_is_best_at_39_percent. Qed.

Theorem corner_gain_rises_to_one_maximum_and_falls_to_0 : exists best,
  fig3_cut_lower < best < fig3_cut_upper /\ rises_to_one_maximum_and_falls_to_0 corner_cut_gain best.
Proof. exact Curves.corner_gain_rises_to_one_maximum_and_falls_to_0. Qed.

Theorem corner_cut_is_nearer_to_the_edge_than_parallel_cut : forall best_corner best_parallel : R,
  0 <= best_corner <= 1 -> (forall t, 0 <= t <= 1 -> corner_cut_gain t <= corner_cut_gain best_corner) ->
  0 <= best_parallel <= 1 -> (forall t, 0 <= t <= 1 -> parallel_cut_gain t <= parallel_cut_gain best_parallel) ->
  best_corner < best_parallel.
Proof. exact Corner.corner_cut_is_nearer_to_the_edge_than_parallel_cut. Qed.
