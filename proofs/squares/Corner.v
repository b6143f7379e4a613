(* Fig. 3: three unit squares in a corner, one of them cut parallel to one of its common edges. The cut is parallel to the edge
   with one wall and orthogonal to the edge with the other; both gains count. There is exactly one best place on [0, 1], at
   0.393580461... (the paper: "at a distance 39% from the edge"). Exchange areas as for fig. 2. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information Enclosure CutGain PerpendicularSquares ParallelCut OrthogonalCut SideFlux
  Decimals.
Open Scope R_scope.

(* The scene has area 3. The part [0, t] of the cut square exchanges exchange_area t 1 with the wall at the edge from which t is
   measured, and orthogonal_exchange t with the wall along the side. *)
Definition corner_cut_gain (t : R) : R :=
  cut_gain 3 1 (exchange_area 1 1) t (exchange_area t 1) + cut_gain 3 1 (exchange_area 1 1) t (orthogonal_exchange t).

Definition corner_information (t : R) : R := split_information floor_flux t + split_information side_flux t.
Definition corner_slope (t : R) : R := gain_slope floor_flux floor_density t + gain_slope side_flux side_density t.
Definition corner_bend (t : R) : R :=
  gain_bend floor_flux floor_density floor_density_slope t + gain_bend side_flux side_density side_density_slope t.

Lemma orthogonal_bend_small t : 7/20 <= t <= 9/20 -> gain_bend side_flux side_density side_density_slope t < 1/2.
Proof.
  intros H. unfold gain_bend, mean_below, mean_above. rewrite side_flux_mirrored.
  unfold_side. interval with (i_prec 30, i_bisect t, i_taylor t, i_degree 3, i_depth 14).
Qed.

Lemma corner_slope_at_lower_end : 0 < corner_slope fig3_cut_lower.
Proof.
  unfold corner_slope, gain_slope, mean_below, mean_above. rewrite side_flux_mirrored. unfold fig3_cut_lower.
  unfold_gain. unfold_side. interval with (i_prec 120).
Qed.

Lemma corner_slope_at_upper_end : corner_slope fig3_cut_upper < 0.
Proof.
  unfold corner_slope, gain_slope, mean_below, mean_above. rewrite side_flux_mirrored. unfold fig3_cut_upper.
  unfold_gain. unfold_side. interval with (i_prec 120).
Qed.

Lemma corner_cut_gain_in_closed_form t : 0 < t < 1 ->
  corner_cut_gain t =
  2 / (3 * PI * ln 2) * (corner_information t - (floor_flux 1 * ln (floor_flux 1) + side_flux 1 * ln (side_flux 1))).
Proof.
  intros H. pose proof PI_RGT_0. destruct (floor_flux_inside t H), (side_flux_inside t H).
  assert (0 < ln 2) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (E : exchange_area 1 1 = side_flux 1 / PI).
  { rewrite <- strip_exchange_1, strip_exchange_closed_form, side_flux_1 by lra. reflexivity. }
  unfold corner_cut_gain. rewrite (orthogonal_exchange_closed_form t H).
  rewrite E at 2. rewrite !exchange_area_closed_form by lra.
  rewrite !gain_of_split_information by lra. unfold corner_information. field. lra.
Qed.

(* A cut along an edge of the square gains nothing. *)
Lemma corner_cut_gain_at_0 : corner_cut_gain 0 = 0.
Proof.
  unfold corner_cut_gain. rewrite exchange_area_0.
  replace (orthogonal_exchange 0) with 0.
  2: { unfold orthogonal_exchange. rewrite strip_exchange_0. replace (1 - 0) with 1 by ring. field. }
  unfold cut_gain. rewrite !Rminus_0_r, xlog2_0. ring.
Qed.

Lemma corner_cut_gain_at_1 : corner_cut_gain 1 = 0.
Proof.
  unfold corner_cut_gain. rewrite orthogonal_exchange_1. unfold cut_gain. set (whole := exchange_area 1 1).
  replace (whole - whole) with 0 by ring. replace (1 - 1) with 0 by ring. rewrite xlog2_0. ring.
Qed.

(* The theorem. Idea: the slope of the orthogonal gain is so small that the slope of the sum has the sign of the parallel one
   up to 7/20 and from 9/20 on, and in between the sum of the slopes strictly decreases. *)
Theorem corner_cut_has_exactly_one_best_place :
  exists best : R,
    fig3_cut_lower < best < fig3_cut_upper /\
    fig3_gain_lower < corner_cut_gain best < fig3_gain_upper /\
    forall t, 0 <= t <= 1 -> t <> best -> corner_cut_gain t < corner_cut_gain best.
Proof.
  destruct (slope_with_one_sign_change_gives_unique_maximum corner_information corner_slope corner_bend
    (7/20) fig3_cut_lower fig3_cut_upper (9/20)) as [m [Hm [_ [_ [_ Hmax]]]]];
    try (unfold fig3_cut_lower, fig3_cut_upper; lra).
  - intros t H. destruct (floor_flux_inside t H), (side_flux_inside t H).
    apply slope_of_sum; apply split_information_slope; trivial; [apply floor_flux_slope; lra | now apply side_flux_slope].
  - intros t H. pose proof (parallel_slope_positive t H). pose proof (orthogonal_slope_hardly_negative t).
    unfold corner_slope. lra.
  - intros t H. pose proof (parallel_slope_negative t H). pose proof (orthogonal_slope_hardly_positive t H).
    unfold corner_slope. lra.
  - intros t H. destruct (floor_flux_inside t), (side_flux_inside t); try lra.
    apply slope_of_sum; apply gain_slope_slope; trivial; try lra.
    + apply floor_flux_slope. lra.
    + apply floor_density_has_slope. lra.
    + apply side_flux_slope. lra.
    + apply side_density_has_slope. lra.
  - intros t H. pose proof (bend_negative t H). pose proof (orthogonal_bend_small t H). unfold corner_bend. lra.
  - exact corner_slope_at_lower_end.
  - exact corner_slope_at_upper_end.
  - assert (Hm' : 0 < m < 1) by (unfold fig3_cut_lower, fig3_cut_upper in Hm; lra).
    assert (V : fig3_gain_lower < corner_cut_gain m < fig3_gain_upper).
    { rewrite corner_cut_gain_in_closed_form by assumption. unfold fig3_cut_lower, fig3_cut_upper in Hm.
      unfold fig3_gain_lower, fig3_gain_upper, corner_information, split_information, mean_below, mean_above.
      rewrite side_flux_mirrored, side_flux_1. clear Hmax Hm'. unfold_gain. unfold_side. split; interval with (i_prec 100). }
    assert (P : 0 < corner_cut_gain m) by (unfold fig3_gain_lower in V; lra).
    exists m. split; [exact Hm | split; [exact V |]].
    intros t Ht Hne.
    destruct (Req_dec t 0) as [->|N0]; [rewrite corner_cut_gain_at_0; exact P|].
    destruct (Req_dec t 1) as [->|N1]; [rewrite corner_cut_gain_at_1; exact P|].
    rewrite !corner_cut_gain_in_closed_form by lra.
    assert (L : 0 < 2 / (3 * PI * ln 2)).
    { pose proof PI_RGT_0. assert (0 < ln 2) by (rewrite <- ln_1; apply ln_increasing; lra). apply Rdiv_lt_0_compat; nra. }
    apply Rmult_lt_compat_l; trivial. specialize (Hmax t). lra.
Qed.

(* "At a distance 39% from the edge", and nearer to it than in fig. 2. *)
Theorem corner_cut_is_best_at_39_percent best : 0 <= best <= 1 ->
  (forall t, 0 <= t <= 1 -> corner_cut_gain t <= corner_cut_gain best) -> 385/1000 < best < 395/1000.
Proof.
  intros Hb H. destruct corner_cut_has_exactly_one_best_place as [m [Hm [_ Hmax]]].
  unfold fig3_cut_lower, fig3_cut_upper in Hm.
  destruct (Req_dec best m) as [->|N]; [lra|]. specialize (H m). specialize (Hmax best). lra.
Qed.

Corollary corner_cut_is_nearer_to_the_edge_than_parallel_cut best_corner best_parallel :
  0 <= best_corner <= 1 -> (forall t, 0 <= t <= 1 -> corner_cut_gain t <= corner_cut_gain best_corner) ->
  0 <= best_parallel <= 1 -> (forall t, 0 <= t <= 1 -> parallel_cut_gain t <= parallel_cut_gain best_parallel) ->
  best_corner < best_parallel.
Proof.
  intros Hc Gc Hp Gp. pose proof (corner_cut_is_best_at_39_percent best_corner Hc Gc).
  pose proof (parallel_cut_is_best_at_40_percent best_parallel Hp Gp). lra.
Qed.
