(* Fig. 2(a), 2(c): two perpendicular unit squares with a common edge, the floor cut parallel to that edge. The gain in mutual
   information has exactly one maximum on [0, 1], at 0.399201026... (the paper: "at a 40% relative distance from the edge").
   The exchange areas are those of PerpendicularSquares.v, which are form-factor integrals by FormFactorIntegral.v. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information Enclosure CutGain PerpendicularSquares Decimals.
Open Scope R_scope.

Ltac unfold_gain :=
  unfold gain_slope, gain_bend, split_information, mean_below, mean_above,
    floor_flux, floor_density, floor_density_slope, squared_ratio.

(* The exchange density falls with the distance from the common edge: both terms of its derivative are negative. *)
Lemma floor_density_decreases s t : 0 < s < t -> floor_density t < floor_density s.
Proof.
  intros H. apply (negative_slope_decreases floor_density floor_density_slope); [lra| |].
  - intros x Hx. apply floor_density_has_slope. lra.
  - intros x Hx. unfold floor_density_slope.
    assert (ln (squared_ratio x) < 0).
    { rewrite <- ln_1. pose proof (squared_ratio_between_0_and_1 x). apply ln_increasing; lra. }
    assert (0 < sqrt (1 + x ^ 2)) by (apply sqrt_lt_R0; nra).
    assert (0 < atan (1 / sqrt (1 + x ^ 2)) / (sqrt (1 + x ^ 2) * (1 + x ^ 2))).
    { apply Rdiv_lt_0_compat; [|nra]. rewrite <- atan_0. apply atan_increasing. apply Rdiv_lt_0_compat; lra. }
    lra.
Qed.

Lemma floor_density_positive t : 0 < t <= 1 -> 1/5 < floor_density t.
Proof.
  intros H. assert (1/5 < floor_density 1) by (unfold floor_density, squared_ratio; interval with (i_prec 40)).
  destruct (Req_dec t 1) as [->|N]; trivial. pose proof (floor_density_decreases t 1). lra.
Qed.

Lemma floor_flux_increases s t : 0 < s < t -> t <= 1 -> floor_flux s < floor_flux t.
Proof.
  intros H Ht. apply (positive_slope_increases floor_flux floor_density); [lra| |].
  - intros x Hx. apply floor_flux_slope. lra.
  - intros x Hx. pose proof (floor_density_positive x). lra.
Qed.

(* The mean over [0, t] is at least the density at t (it falls) ... *)
Lemma mean_below_at_least_density t : 0 < t -> floor_density t <= mean_below floor_flux t.
Proof.
  intros H. unfold mean_below. apply (Rmult_le_reg_r t); trivial.
  replace (floor_flux t / t * t) with (floor_flux t) by (field; lra).
  unfold floor_density, floor_flux.
  assert (ln (squared_ratio t) < 0).
  { rewrite <- ln_1. pose proof (squared_ratio_between_0_and_1 t H). apply ln_increasing; lra. }
  assert (Hs : sqrt (1 + t ^ 2) * sqrt (1 + t ^ 2) = 1 + t ^ 2) by (apply sqrt_sqrt; nra).
  assert (H1 : 1 < sqrt (1 + t ^ 2)) by (rewrite <- sqrt_1 at 1; apply sqrt_lt_1; nra).
  set (s := sqrt (1 + t ^ 2)) in *.
  assert (Hi : 1 / s < 1) by (apply (Rmult_lt_reg_r s); [lra|]; field_simplify; lra).
  assert (Ha : atan (1 / s) < PI / 4) by (rewrite <- atan_1; now apply atan_increasing).
  assert (Hb : 0 < atan (1 / s)) by (rewrite <- atan_0; apply atan_increasing; apply Rdiv_lt_0_compat; lra).
  assert (E : t / s * atan (1 / s) * t = s * atan (1 / s) - 1 / s * atan (1 / s)).
  { replace (t / s * atan (1 / s) * t) with ((s * s - 1) / s * atan (1 / s)); [field; lra|].
    rewrite Hs. field. lra. }
  assert (0 < 1 / s) by (apply Rdiv_lt_0_compat; lra).
  nra.
Qed.

(* ... and at most PI / 2, the density at the common edge. *)
Lemma mean_below_at_most_right_angle t : 0 < t <= 1 -> mean_below floor_flux t <= PI / 2.
Proof.
  intros H. unfold mean_below. apply (Rmult_le_reg_r t); [lra|].
  replace (floor_flux t / t * t) with (floor_flux t) by (field; lra). unfold floor_flux.
  assert (ln (squared_ratio t) < 0).
  { rewrite <- ln_1. pose proof (squared_ratio_between_0_and_1 t). apply ln_increasing; lra. }
  assert (atan (1 / t) < PI / 2) by apply atan_bound.
  assert (PI / 4 < sqrt (1 + t ^ 2) * atan (1 / sqrt (1 + t ^ 2))).
  { replace (PI / 4) with (sqrt (1 + 0 ^ 2) * atan (1 / sqrt (1 + 0 ^ 2))).
    2: { replace (1 + 0 ^ 2) with 1 by ring. rewrite sqrt_1. replace (1 / 1) with 1 by field. rewrite atan_1. field. }
    apply (positive_slope_increases (fun t => sqrt (1 + t ^ 2) * atan (1 / sqrt (1 + t ^ 2)))
      (fun t => t / sqrt (1 + t ^ 2) * atan (1 / sqrt (1 + t ^ 2)) - t / (2 + t ^ 2))); [lra| |].
    - intros x _. apply slant_slope.
    - intros x Hx. assert (0 <= x <= 1) by lra.
      assert (0 < atan (1 / sqrt (1 + x ^ 2)) / sqrt (1 + x ^ 2) - 1 / (2 + x ^ 2))
        by (interval with (i_prec 30, i_bisect x, i_depth 8)).
      replace (x / sqrt (1 + x ^ 2) * atan (1 / sqrt (1 + x ^ 2)) - x / (2 + x ^ 2))
        with (x * (atan (1 / sqrt (1 + x ^ 2)) / sqrt (1 + x ^ 2) - 1 / (2 + x ^ 2))).
      2: { assert (0 < sqrt (1 + x ^ 2)) by (apply sqrt_lt_R0; nra). field. split; nra. }
      nra. }
  nra.
Qed.

Lemma floor_flux_inside t : 0 < t < 1 -> 0 < floor_flux t < floor_flux 1.
Proof.
  intros H. split; [|apply floor_flux_increases; lra].
  pose proof (mean_below_at_least_density t). pose proof (floor_density_positive t). unfold mean_below in *.
  replace (floor_flux t) with (floor_flux t / t * t) by (field; lra). apply Rmult_lt_0_compat; lra.
Qed.

(* The slope near the edge: density and both means lie in boxes on which it is positive. *)
Lemma slope_positive_near_edge t : 0 < t <= 1/20 -> 1/50 < gain_slope floor_flux floor_density t.
Proof.
  intros H. unfold gain_slope.
  assert (A0 : 134/100 <= floor_density (1/20)) by (unfold floor_density, squared_ratio; interval with (i_prec 40)).
  assert (floor_density (1/20) <= floor_density t).
  { destruct (Req_dec t (1/20)) as [->|N]; [lra|]. pose proof (floor_density_decreases t (1/20)). lra. }
  pose proof (mean_below_at_least_density t) as A1. pose proof (mean_below_at_most_right_angle t) as A2.
  assert (P2 : PI / 2 <= 158/100) by interval with (i_prec 40).
  assert (F1 : 628/1000 <= floor_flux 1 <= 629/1000) by (unfold floor_flux, squared_ratio; interval with (i_prec 40)).
  assert (F2 : floor_flux (1/20) <= 73/1000) by (unfold floor_flux, squared_ratio; interval with (i_prec 40)).
  pose proof (floor_flux_inside t).
  assert (floor_flux t <= floor_flux (1/20)).
  { destruct (Req_dec t (1/20)) as [->|N]; [lra|]. pose proof (floor_flux_increases t (1/20)). lra. }
  assert (B : 555/1000 <= mean_above floor_flux t <= 663/1000).
  { unfold mean_above. split.
    - apply (Rmult_le_reg_r (1 - t)); [lra|]. field_simplify; [nra|lra].
    - apply (Rmult_le_reg_r (1 - t)); [lra|]. field_simplify; [nra|lra]. }
  assert (A : 134/100 <= mean_below floor_flux t <= 158/100) by lra.
  assert (D : 134/100 <= floor_density t) by lra.
  generalize dependent (mean_above floor_flux t). intros b B. generalize dependent (mean_below floor_flux t). intros a A1 A2 A.
  apply Rlt_le_trans with (134/100 * ln (a / b) - (a - b)).
  - interval with (i_prec 40, i_bisect a, i_bisect b, i_depth 14).
  - assert (0 < ln (a / b)) by interval with (i_prec 40). nra.
Qed.

Lemma slope_negative_near_far_edge t : 9/10 <= t < 1 -> gain_slope floor_flux floor_density t < -1/50.
Proof.
  intros H. unfold gain_slope.
  assert (Dens : forall x, 9/10 <= x <= 1 -> 206/1000 <= floor_density x <= 247/1000).
  { intros x Hx.
    assert (A0 : floor_density (9/10) <= 247/1000) by (unfold floor_density, squared_ratio; interval with (i_prec 40)).
    assert (A1 : 206/1000 <= floor_density 1) by (unfold floor_density, squared_ratio; interval with (i_prec 40)).
    assert (floor_density 1 <= floor_density x).
    { destruct (Req_dec x 1) as [->|N]; [lra|]. pose proof (floor_density_decreases x 1). lra. }
    assert (floor_density x <= floor_density (9/10)).
    { destruct (Req_dec x (9/10)) as [->|N]; [lra|]. pose proof (floor_density_decreases (9/10) x). lra. }
    lra. }
  assert (F1 : 628/1000 <= floor_flux 1 <= 629/1000) by (unfold floor_flux, squared_ratio; interval with (i_prec 40)).
  assert (F2 : 605/1000 <= floor_flux (9/10)) by (unfold floor_flux, squared_ratio; interval with (i_prec 40)).
  assert (floor_flux (9/10) <= floor_flux t).
  { destruct (Req_dec t (9/10)) as [->|N]; [lra|]. pose proof (floor_flux_increases (9/10) t). lra. }
  pose proof (floor_flux_inside t).
  assert (A : 605/1000 <= mean_below floor_flux t <= 700/1000).
  { unfold mean_below. split.
    - apply (Rmult_le_reg_r t); [lra|]. field_simplify; [nra|lra].
    - apply (Rmult_le_reg_r t); [lra|]. field_simplify; [nra|lra]. }
  assert (B : 206/1000 <= mean_above floor_flux t <= 247/1000).
  { destruct (MVT_cor2 floor_flux floor_density t 1) as [c [Hc Hin]]; [lra| |].
    - intros c Hc. apply is_derive_Reals. apply floor_flux_slope. lra.
    - replace (mean_above floor_flux t) with (floor_density c); [apply Dens; lra|].
      unfold mean_above. rewrite Hc. field. lra. }
  pose proof (Dens t) as D. assert (G : 206/1000 <= floor_density t <= 247/1000) by lra. clear D.
  generalize dependent (mean_above floor_flux t). intros b B. generalize dependent (mean_below floor_flux t). intros a A.
  generalize dependent (floor_density t). intros g G.
  interval with (i_prec 40, i_bisect a, i_bisect b, i_depth 14).
Qed.

(* In between, interval arithmetic: the sign of the slope away from the maximum, and its own slope near the maximum. *)
Lemma slope_positive_left t : 1/20 <= t <= 7/20 -> 1/50 < gain_slope floor_flux floor_density t.
Proof. intros H. unfold_gain. interval with (i_prec 30, i_bisect t, i_taylor t, i_degree 3, i_depth 14). Qed.

Lemma slope_negative_right t : 9/20 <= t <= 9/10 -> gain_slope floor_flux floor_density t < -1/50.
Proof. intros H. unfold_gain. interval with (i_prec 30, i_bisect t, i_taylor t, i_degree 3, i_depth 14). Qed.

Lemma bend_negative t : 7/20 <= t <= 9/20 ->
  gain_bend floor_flux floor_density floor_density_slope t < -1/2.
Proof. intros H. unfold_gain. interval with (i_prec 30, i_bisect t, i_taylor t, i_degree 3, i_depth 14). Qed.

Lemma parallel_slope_positive t : 0 < t <= 7/20 -> 1/50 < gain_slope floor_flux floor_density t.
Proof. intros H. destruct (Rle_lt_dec t (1/20)); [apply slope_positive_near_edge | apply slope_positive_left]; lra. Qed.

Lemma parallel_slope_negative t : 9/20 <= t < 1 -> gain_slope floor_flux floor_density t < -1/50.
Proof. intros H. destruct (Rle_lt_dec t (9/10)); [apply slope_negative_right | apply slope_negative_near_far_edge]; lra. Qed.

Lemma slope_at_lower_end : 0 < gain_slope floor_flux floor_density fig2_parallel_cut_lower.
Proof. unfold fig2_parallel_cut_lower. unfold_gain. interval with (i_prec 122). Qed.

Lemma slope_at_upper_end : gain_slope floor_flux floor_density fig2_parallel_cut_upper < 0.
Proof. unfold fig2_parallel_cut_upper. unfold_gain. interval with (i_prec 122). Qed.

Lemma parallel_cut_gain_in_closed_form t : 0 < t < 1 ->
  parallel_cut_gain t = 1 / (PI * ln 2) * (split_information floor_flux t - floor_flux 1 * ln (floor_flux 1)).
Proof.
  intros H. unfold parallel_cut_gain. rewrite !exchange_area_closed_form by lra.
  pose proof PI_RGT_0. destruct (floor_flux_inside t H).
  rewrite gain_of_split_information by lra.
  assert (0 < ln 2) by (rewrite <- ln_1; apply ln_increasing; lra). f_equal. field. lra.
Qed.

(* A cut along either edge of the floor gains nothing. *)
Lemma exchange_area_0 : exchange_area 0 1 = 0.
Proof.
  unfold exchange_area. cbv zeta. replace (0 ^ 2 + 1 ^ 2) with 1 by ring. rewrite sqrt_1.
  replace ((1 + 0 ^ 2) * (1 + 1 ^ 2) / (1 + 1)) with 1 by field.
  replace (1 ^ 2 * (1 + 1) / ((1 + 1 ^ 2) * 1)) with 1 by field. rewrite ln_1.
  replace (0 ^ 2) with 0 by ring. field. apply PI_neq0.
Qed.

Lemma parallel_cut_gain_at_0 : parallel_cut_gain 0 = 0.
Proof.
  unfold parallel_cut_gain, cut_gain. rewrite exchange_area_0, !Rminus_0_r.
  replace (xlog2 0 0) with 0; [ring|]. unfold xlog2. destruct (Req_EM_T 0 0); lra.
Qed.

Lemma parallel_cut_gain_at_1 : parallel_cut_gain 1 = 0.
Proof.
  unfold parallel_cut_gain, cut_gain. set (whole := exchange_area 1 1).
  replace (whole - whole) with 0 by ring. replace (1 - 1) with 0 by ring.
  replace (xlog2 0 0) with 0; [ring|]. unfold xlog2. destruct (Req_EM_T 0 0); lra.
Qed.

(* The theorem. Idea: the slope of the gain is positive up to 7/20, negative from 9/20 on and strictly decreasing in between,
   so the gain rises up to the zero of the slope and falls after it. *)
Theorem parallel_cut_has_exactly_one_best_place :
  exists best : R,
    fig2_parallel_cut_lower < best < fig2_parallel_cut_upper /\
    fig2_parallel_gain_lower < parallel_cut_gain best < fig2_parallel_gain_upper /\
    forall t, 0 <= t <= 1 -> t <> best -> parallel_cut_gain t < parallel_cut_gain best.
Proof.
  destruct (slope_with_one_sign_change_gives_unique_maximum (split_information floor_flux)
    (gain_slope floor_flux floor_density) (gain_bend floor_flux floor_density floor_density_slope)
    (7/20) fig2_parallel_cut_lower fig2_parallel_cut_upper (9/20)) as [m [Hm [_ [_ [_ Hmax]]]]];
    try (unfold fig2_parallel_cut_lower, fig2_parallel_cut_upper; lra).
  - intros t H. destruct (floor_flux_inside t H). apply split_information_slope; trivial. apply floor_flux_slope. lra.
  - intros t H. pose proof (parallel_slope_positive t). lra.
  - intros t H. pose proof (parallel_slope_negative t). lra.
  - intros t H. destruct (floor_flux_inside t); [lra|].
    apply gain_slope_slope; trivial; [lra | apply floor_flux_slope; lra | apply floor_density_has_slope; lra].
  - intros t H. pose proof (bend_negative t H). lra.
  - exact slope_at_lower_end.
  - exact slope_at_upper_end.
  - assert (Hm' : 0 < m < 1) by (unfold fig2_parallel_cut_lower, fig2_parallel_cut_upper in Hm; lra).
    assert (V : fig2_parallel_gain_lower < parallel_cut_gain m < fig2_parallel_gain_upper).
    { rewrite parallel_cut_gain_in_closed_form by assumption. unfold fig2_parallel_cut_lower, fig2_parallel_cut_upper in Hm.
      unfold fig2_parallel_gain_lower, fig2_parallel_gain_upper. unfold_gain. split; interval with (i_prec 100). }
    assert (P : 0 < parallel_cut_gain m) by (unfold fig2_parallel_gain_lower in V; lra).
    exists m. split; [exact Hm | split; [exact V |]].
    intros t Ht Hne.
    destruct (Req_dec t 0) as [->|N0]; [rewrite parallel_cut_gain_at_0; exact P|].
    destruct (Req_dec t 1) as [->|N1]; [rewrite parallel_cut_gain_at_1; exact P|].
    rewrite !parallel_cut_gain_in_closed_form by lra.
    assert (L : 0 < 1 / (PI * ln 2)).
    { pose proof PI_RGT_0. assert (0 < ln 2) by (rewrite <- ln_1; apply ln_increasing; lra).
      apply Rdiv_lt_0_compat; [lra | now apply Rmult_lt_0_compat]. }
    apply Rmult_lt_compat_l; trivial. specialize (Hmax t). lra.
Qed.

(* "At a 40% relative distance": any best place rounds to 40%. *)
Theorem parallel_cut_is_best_at_40_percent best : 0 <= best <= 1 ->
  (forall t, 0 <= t <= 1 -> parallel_cut_gain t <= parallel_cut_gain best) -> 395/1000 < best < 405/1000.
Proof.
  intros Hb H. destruct parallel_cut_has_exactly_one_best_place as [m [Hm [_ Hmax]]].
  unfold fig2_parallel_cut_lower, fig2_parallel_cut_upper in Hm.
  destruct (Req_dec best m) as [->|N]; [lra|]. specialize (H m). specialize (Hmax best). lra.
Qed.

(* Negative control for the orthogonal cut: without mirror symmetry a cut in the middle does gain. *)
Lemma parallel_cut_in_the_middle_gains : 3/100 < parallel_cut_gain (1/2).
Proof.
  rewrite parallel_cut_gain_in_closed_form by lra. unfold_gain. interval with (i_prec 50).
Qed.
