(* Fig. 2(b): "orthogonal splitting leads to only a small gain in mutual information": wherever the floor is cut orthogonally to
   the common edge, the gain stays below 0.0007, while the best parallel cut gains more than 0.033, over 47 times as much. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information Enclosure CutGain PerpendicularSquares ParallelCut OrthogonalCut SideFlux
  Decimals.
Open Scope R_scope.

Definition orthogonal_information (t : R) : R := split_information side_flux t - side_flux 1 * ln (side_flux 1).

Lemma orthogonal_cut_gain_in_closed_form t : 0 < t < 1 ->
  orthogonal_cut_gain t = 1 / (PI * ln 2) * orthogonal_information t.
Proof.
  intros H. unfold orthogonal_cut_gain. rewrite <- strip_exchange_1, strip_exchange_closed_form, <- side_flux_1 by lra.
  rewrite (orthogonal_exchange_closed_form t H). pose proof PI_RGT_0. destruct (side_flux_inside t H).
  rewrite gain_of_split_information by lra.
  assert (0 < ln 2) by (rewrite <- ln_1; apply ln_increasing; lra). unfold orthogonal_information. field. lra.
Qed.

Lemma orthogonal_information_small_inside t : 1/50 <= t <= 1/2 -> orthogonal_information t < 1495/1000000.
Proof.
  intros H. unfold orthogonal_information, split_information, mean_below, mean_above. rewrite side_flux_mirrored, side_flux_1.
  unfold_side. interval with (i_prec 30, i_bisect t, i_taylor t, i_degree 4, i_depth 14).
Qed.

(* Nearer to the side the slope is at least -3/200, so the gain cannot exceed its value at 1/50 by more than 3/200 * 1/50. *)
Lemma orthogonal_information_small_near_side t : 0 < t < 1/50 -> orthogonal_information t < 1495/1000000.
Proof.
  intros H.
  assert (E : orthogonal_information (1/50) < 119/100000).
  { unfold orthogonal_information, split_information, mean_below, mean_above. rewrite side_flux_mirrored, side_flux_1.
    unfold_side. interval with (i_prec 50). }
  destruct (MVT_cor2 (split_information side_flux) (gain_slope side_flux side_density) t (1/50)) as [c [Hc Hin]]; [lra| |].
  - intros c Hc. apply is_derive_Reals. destruct (side_flux_inside c); [lra|].
    apply split_information_slope; [lra | assumption | assumption | apply side_flux_slope; lra].
  - pose proof (orthogonal_slope_near_side c). unfold orthogonal_information in *. nra.
Qed.

Lemma orthogonal_cut_gain_at_0 : orthogonal_cut_gain 0 = 0.
Proof.
  unfold orthogonal_cut_gain, orthogonal_exchange, cut_gain. rewrite strip_exchange_0.
  replace ((0 + strip_exchange 1 - strip_exchange (1 - 0)) / 2) with 0 by (replace (1 - 0) with 1 by ring; field).
  rewrite !Rminus_0_r, xlog2_0. ring.
Qed.

Lemma orthogonal_cut_gain_mirrored t : orthogonal_cut_gain (1 - t) = orthogonal_cut_gain t.
Proof.
  unfold orthogonal_cut_gain, cut_gain. rewrite <- orthogonal_exchange_1.
  pose proof (orthogonal_exchange_mirrored t) as E.
  replace (orthogonal_exchange 1 - orthogonal_exchange (1 - t)) with (orthogonal_exchange t) by lra.
  replace (orthogonal_exchange 1 - orthogonal_exchange t) with (orthogonal_exchange (1 - t)) by lra.
  replace (1 - (1 - t)) with t by ring. ring.
Qed.

Theorem orthogonal_cut_gains_less_than_7_in_10000 t : 0 <= t <= 1 -> orthogonal_cut_gain t < 7 / 10000.
Proof.
  intros H.
  assert (half : forall s, 0 <= s <= 1/2 -> orthogonal_cut_gain s < 7 / 10000).
  { intros s Hs. destruct (Req_dec s 0) as [->|N]; [rewrite orthogonal_cut_gain_at_0; lra|].
    rewrite orthogonal_cut_gain_in_closed_form by lra.
    assert (I : orthogonal_information s < 1495/1000000).
    { destruct (Rle_lt_dec (1/50) s); [apply orthogonal_information_small_inside | apply orthogonal_information_small_near_side]; lra. }
    assert (L : 0 < 1 / (PI * ln 2) < 460/1000) by (split; interval with (i_prec 40)).
    destruct (Rle_lt_dec (orthogonal_information s) 0); nra. }
  destruct (Rle_lt_dec t (1/2)); [apply half; lra|]. rewrite <- orthogonal_cut_gain_mirrored. apply half. lra.
Qed.

Theorem orthogonal_cut_gains_47_times_less_than_the_best_parallel_cut : forall best,
  0 <= best <= 1 -> (forall t, 0 <= t <= 1 -> parallel_cut_gain t <= parallel_cut_gain best) ->
  forall t, 0 <= t <= 1 -> 47 * orthogonal_cut_gain t < parallel_cut_gain best.
Proof.
  intros best Hb M t H. destruct parallel_cut_has_exactly_one_best_place as [m [[Lm Um] [[V _] _]]].
  assert (Hm : 0 <= m <= 1) by (unfold fig2_parallel_cut_lower, fig2_parallel_cut_upper in *; lra).
  pose proof (M m Hm). pose proof (orthogonal_cut_gains_less_than_7_in_10000 t H). unfold fig2_parallel_gain_lower in V. lra.
Qed.

(* The "small gradient" which the paper gives as the reason why the best place in the corner (fig. 3) lies nearer to the edge:
   around 40% the gain of an orthogonal cut rises towards the side. *)
Theorem orthogonal_gain_rises_towards_the_side s t : 7/20 <= s < t -> t <= 9/20 -> orthogonal_cut_gain t < orthogonal_cut_gain s.
Proof.
  intros Hs Ht. rewrite !orthogonal_cut_gain_in_closed_form by lra.
  assert (L : 0 < 1 / (PI * ln 2)) by interval with (i_prec 40). apply Rmult_lt_compat_l; trivial.
  unfold orthogonal_information.
  cut (split_information side_flux t < split_information side_flux s); [lra|].
  apply (negative_slope_decreases (split_information side_flux) (gain_slope side_flux side_density)); [lra| |].
  - intros x Hx. destruct (side_flux_inside x); [lra|].
    apply split_information_slope; trivial; [lra | apply side_flux_slope; lra].
  - intros x Hx. assert (B : 7/20 <= x <= 9/20) by lra. clear Hx.
    unfold gain_slope, mean_below, mean_above. rewrite side_flux_mirrored.
    unfold_side. interval with (i_prec 30, i_bisect x, i_taylor x, i_degree 4, i_depth 14).
Qed.
