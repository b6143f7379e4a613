(* Section 4.2, the patch of the paper (radiosity B x^n, irradiance H x^m, m >= 1): a division into two parts of any shape that
   gains as much as the best cut across the gradient is that cut, up to strips of no area. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information LogSum Stationarity Extremum GradientPatch IntegralsOverParts
  AcrossTheGradient AcrossTheGradientGain AcrossTheGradientPower OnlyStraightCutsAreBest.
Open Scope R_scope.

(* By OnlyStraightCutsAreBest.v it is a straight cut somewhere, and the gain of straight cuts has only one maximiser. *)
Theorem division_as_good_as_best_cut_is_that_cut : forall total B H K w_j n m best s,
  0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> (1 <= m)%nat ->
  only_maximiser (cut_objective n m) 0 1 best ->
  share_of_strips (gradient_flux_density total B K n) (gradient_weight_density total B H n m) s ->
  gradient_division_gain total B H K w_j n m s = gradient_patch_gain total B H K w_j n m best ->
  is_straight_cut_at (gradient_flux_density total B K n) best s \/
  is_straight_cut_at (gradient_flux_density total B K n) best (fun x => 1 - s x).
Proof.
  intros total B H K w_j n m best s Ht HB HH HK Hj Hm Best Hs E.
  set (g := gradient_flux_density total B K n) in *. set (w := gradient_weight_density total B H n m) in *.
  set (ratio := fun x : R => H / K * x ^ m).
  assert (Ig : ex_RInt g 0 1) by apply gradient_flux_integrable.
  assert (Iw : ex_RInt w 0 1) by apply gradient_weight_integrable.
  assert (Pg : forall x, 0 <= x <= 1 -> 0 <= g x) by (apply gradient_flux_nonneg; assumption).
  assert (Wr : forall x, 0 <= x <= 1 -> w x = ratio x * g x) by (apply gradient_weight_is_ratio_times_flux; assumption).
  assert (Rp : forall x, 0 < x <= 1 -> 0 < ratio x) by (apply gradient_ratio_positive; assumption).
  assert (Ri : forall x y, 0 <= x -> x <= y -> y <= 1 -> ratio x <= ratio y) by (apply gradient_ratio_increasing; assumption).
  assert (Rs : forall x y, 0 <= x -> x < y -> y <= 1 -> ratio x < ratio y).
  { intros x y Hx Hxy Hy. unfold ratio. apply Rmult_lt_compat_l; [now apply Rdiv_lt_0_compat|].
    destruct m as [|q]; [lia|]. simpl. assert (0 < y ^ q) by (apply pow_lt; lra).
    assert (x ^ q <= y ^ q) by (apply pow_incr; lra). assert (0 <= x ^ q) by (apply pow_le; lra). nra. }
  destruct (Best) as [Hb Top].
  assert (bound : forall c, 0 <= c <= 1 -> gradient_division_gain total B H K w_j n m (before c) <=
    gradient_patch_gain total B H K w_j n m best).
  { intros c Hc. apply no_division_gains_more_than_best_cut; try assumption.
    now apply straight_cut_is_share. }
  (* the flux is positive, so a smaller objective is a smaller gain *)
  assert (Fp : 0 < gradient_strip_flux total B K n 0 1).
  { rewrite gradient_strip_flux_value, pow1, pow_i by lia. rewrite Rminus_0_r, Rmult_1_r.
    pose proof (pos_INR n). repeat apply Rdiv_lt_0_compat; try lra. now apply Rmult_lt_0_compat. }
  assert (worse : forall c, 0 < c < 1 -> c <> best ->
    gradient_patch_gain total B H K w_j n m c < gradient_patch_gain total B H K w_j n m best).
  { intros c Hc N. rewrite !gain_of_gradient_patch by assumption. specialize (Top c Hc N).
    apply Rmult_lt_compat_l; lra. }
  assert (positive : 0 < gradient_patch_gain total B H K w_j n m best).
  { apply Rle_lt_trans with (gradient_patch_gain total B H K w_j n m (best / 2)); [|apply worse; lra].
    rewrite <- straight_cut_has_gradient_patch_gain by (assumption || lra).
    apply (division_gain_nonneg g w ratio w_j Ig Iw Pg Wr Ri Rp Hj). apply straight_cut_is_share; (assumption || lra). }
  assert (there : forall c r, 0 <= c <= 1 -> share_of_strips g w r -> is_straight_cut_at g c r ->
    gradient_division_gain total B H K w_j n m r = gradient_patch_gain total B H K w_j n m best -> c = best).
  { intros c r Hc Hr St Er.
    assert (A := straight_cut_gains_alike g w ratio w_j Ig Iw Pg Wr Rs Rp Hj r c Hr Hc St).
    fold (gradient_division_gain total B H K w_j n m r) in A. unfold gradient_division_gain in Er. fold g w in Er.
    rewrite A in Er.
    destruct (Req_dec c 0) as [E0|E0]; [|destruct (Req_dec c 1) as [E1|E1]].
    - rewrite (cut_at_edge_gains_nothing g w ratio w_j Ig Iw Pg Wr Ri Rp Hj c) in Er by auto. lra.
    - rewrite (cut_at_edge_gains_nothing g w ratio w_j Ig Iw Pg Wr Ri Rp Hj c) in Er by auto. lra.
    - destruct (Req_dec c best) as [|N]; [assumption|exfalso].
      assert (X := straight_cut_has_gradient_patch_gain total B H K w_j n m c Hc).
      unfold gradient_division_gain in X. fold g w in X. rewrite X in Er.
      assert (Y := worse c ltac:(lra) N). lra. }
  destruct (only_straight_cuts_can_be_best g w ratio w_j Ig Iw Pg Wr Rs Rp Hj s Hs) as [[c [Hc [St|St]]]|[c [Hc L]]].
  - left. now rewrite <- (there c s Hc Hs St E).
  - right. destruct (complement_is_share g w Ig Iw s Hs) as [Hs' _].
    rewrite <- (there c _ Hc Hs' St); [exact St|]. rewrite <- E.
    exact (division_gain_symmetric g w ratio w_j Ig Iw Pg Wr Ri Rp Hj s Hs).
  - exfalso. assert (X := bound c Hc). unfold gradient_division_gain in X, E. fold g w in X, E. lra.
Qed.
