(* Fig. 2(c) and fig. 3(b), the curves: the gain is 0 for a cut at either edge, rises strictly up to its only maximum and
   falls strictly after it. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information PairGain CutGain CutGainIsPairGain PerpendicularSquares ParallelCut OrthogonalCut
  SideFlux Corner Decimals.
Open Scope R_scope.

Definition rises_to_one_maximum_and_falls_to_0 (gain : R -> R) (best : R) : Prop :=
  gain 0 = 0 /\ gain 1 = 0 /\ 0 < best < 1 /\
  (forall s t, 0 <= s -> s < t -> t <= best -> gain s < gain t) /\
  (forall s t, best <= s -> s < t -> t <= 1 -> gain t < gain s).

(* No cut loses: (5) is not negative. *)
Lemma cut_gain_nonneg : forall total_area area flux part_area part_flux,
  0 < total_area -> 0 < part_area < area -> 0 <= part_flux <= flux ->
  0 <= cut_gain total_area area flux part_area part_flux.
Proof.
  intros T A J a j HT HA HJ. rewrite (cut_gain_is_pair_gain_of_two_parts T A J a j 1) by (assumption || lra).
  assert (Q : forall x y, 0 <= x -> 0 < y -> 0 <= x / y).
  { intros x y Hx Hy. apply Rmult_le_pos; [exact Hx|left; now apply Rinv_0_lt_compat]. }
  apply pair_gain_nonneg; try lra.
  - intros [|k] _; apply Q; lra.
  - intros [|k] _; apply Q; lra.
  - simpl. field. lra.
  - simpl. field. lra.
Qed.

(* The slope is positive before the maximum and negative after it; at the edges the gain is the least possible. *)
Lemma curve_from_slopes : forall (gain U slope : R -> R) c K m, 0 < c -> 0 < m < 1 ->
  gain 0 = 0 -> gain 1 = 0 -> (forall t, 0 < t < 1 -> 0 <= gain t) ->
  (forall t, 0 < t < 1 -> gain t = c * (U t - K)) -> (forall t, 0 < t < 1 -> is_derive U t (slope t)) ->
  (forall t, 0 < t < m -> 0 < slope t) -> (forall t, m < t < 1 -> slope t < 0) ->
  rises_to_one_maximum_and_falls_to_0 gain m.
Proof.
  intros gain U slope c K m Hc Hm G0 G1 Gp GU D Sp Sn.
  assert (up : forall s t, 0 < s -> s < t -> t <= m -> gain s < gain t).
  { intros s t Hs Hst Ht. rewrite !GU by lra. apply Rmult_lt_compat_l; [exact Hc|].
    assert (U s < U t); [|lra]. apply (positive_slope_increases U slope); [exact Hst| |]; intros x Hx; [apply D|apply Sp]; lra. }
  assert (down : forall s t, m <= s -> s < t -> t < 1 -> gain t < gain s).
  { intros s t Hs Hst Ht. rewrite !GU by lra. apply Rmult_lt_compat_l; [exact Hc|].
    assert (U t < U s); [|lra]. apply (negative_slope_decreases U slope); [exact Hst| |]; intros x Hx; [apply D|apply Sn]; lra. }
  repeat split; try assumption; try lra.
  - intros s t Hs Hst Ht. destruct (Req_dec s 0) as [->|N]; [|apply up; lra].
    rewrite G0. apply Rle_lt_trans with (gain (t / 2)); [apply Gp; lra|apply up; lra].
  - intros s t Hs Hst Ht. destruct (Req_dec t 1) as [->|N]; [|apply down; lra].
    rewrite G1. apply Rle_lt_trans with (gain ((s + 1) / 2)); [apply Gp; lra|apply down; lra].
Qed.

Lemma parallel_flux_between : forall t, 0 < t < 1 -> 0 <= exchange_area t 1 <= exchange_area 1 1.
Proof.
  intros t H. rewrite !exchange_area_closed_form by lra. destruct (floor_flux_inside t H). pose proof PI_RGT_0.
  split; [left; now apply Rdiv_lt_0_compat|]. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|lra].
Qed.

Theorem parallel_gain_rises_to_one_maximum_and_falls_to_0 : exists best,
  fig2_parallel_cut_lower < best < fig2_parallel_cut_upper /\
  rises_to_one_maximum_and_falls_to_0 parallel_cut_gain best.
Proof.
  destruct (slope_with_one_sign_change_gives_unique_maximum (split_information floor_flux)
    (gain_slope floor_flux floor_density) (gain_bend floor_flux floor_density floor_density_slope)
    (7/20) fig2_parallel_cut_lower fig2_parallel_cut_upper (9/20)) as [m [Hm [_ [Sp [Sn _]]]]];
    try (unfold fig2_parallel_cut_lower, fig2_parallel_cut_upper; lra).
  - intros t H. destruct (floor_flux_inside t H). apply split_information_slope; trivial. apply floor_flux_slope. lra.
  - intros t H. pose proof (parallel_slope_positive t). lra.
  - intros t H. pose proof (parallel_slope_negative t). lra.
  - intros t H. destruct (floor_flux_inside t); [lra|].
    apply gain_slope_slope; trivial; [lra | apply floor_flux_slope; lra | apply floor_density_has_slope; lra].
  - intros t H. pose proof (bend_negative t H). lra.
  - exact slope_at_lower_end.
  - exact slope_at_upper_end.
  - exists m. split; [exact Hm|]. unfold fig2_parallel_cut_lower, fig2_parallel_cut_upper in Hm.
    apply (curve_from_slopes parallel_cut_gain (split_information floor_flux) (gain_slope floor_flux floor_density)
      (1 / (PI * ln 2)) (floor_flux 1 * ln (floor_flux 1))); trivial; try lra.
    + pose proof PI_RGT_0. pose proof ln_2_positive. apply Rdiv_lt_0_compat; [lra|now apply Rmult_lt_0_compat].
    + exact parallel_cut_gain_at_0.
    + exact parallel_cut_gain_at_1.
    + intros t H. apply cut_gain_nonneg; [lra|lra|now apply parallel_flux_between].
    + exact parallel_cut_gain_in_closed_form.
    + intros t H. destruct (floor_flux_inside t H). apply split_information_slope; trivial. apply floor_flux_slope. lra.
Qed.

Theorem corner_gain_rises_to_one_maximum_and_falls_to_0 : exists best,
  fig3_cut_lower < best < fig3_cut_upper /\ rises_to_one_maximum_and_falls_to_0 corner_cut_gain best.
Proof.
  destruct (slope_with_one_sign_change_gives_unique_maximum corner_information corner_slope corner_bend
    (7/20) fig3_cut_lower fig3_cut_upper (9/20)) as [m [Hm [_ [Sp [Sn _]]]]];
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
  - exists m. split; [exact Hm|]. unfold fig3_cut_lower, fig3_cut_upper in Hm.
    eapply (curve_from_slopes corner_cut_gain corner_information corner_slope (2 / (3 * PI * ln 2))); trivial; try lra.
    + pose proof PI_RGT_0. pose proof ln_2_positive. apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra.
    + exact corner_cut_gain_at_0.
    + exact corner_cut_gain_at_1.
    + intros t H. unfold corner_cut_gain.
      assert (0 <= cut_gain 3 1 (exchange_area 1 1) t (exchange_area t 1)).
      { apply cut_gain_nonneg; [lra|lra|now apply parallel_flux_between]. }
      assert (0 <= cut_gain 3 1 (exchange_area 1 1) t (orthogonal_exchange t)); [|lra].
      apply cut_gain_nonneg; [lra|lra|]. rewrite (orthogonal_exchange_closed_form t H).
      rewrite <- strip_exchange_1, strip_exchange_closed_form, <- side_flux_1 by lra. destruct (side_flux_inside t H). pose proof PI_RGT_0.
      split; [left; now apply Rdiv_lt_0_compat|]. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|lra].
    + exact corner_cut_gain_in_closed_form.
    + intros t H. destruct (floor_flux_inside t H), (side_flux_inside t H).
      apply slope_of_sum; apply split_information_slope; trivial; [apply floor_flux_slope; lra | now apply side_flux_slope].
Qed.
