(* What a part of the floor exchanges with a wall that stands along its side, as a function of the width of the part: signs,
   derivatives, and bounds on the slope of the gain of an orthogonal cut. Used by OrthogonalCutSmall.v (fig. 2(b)) and Corner.v
   (fig. 3). *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information Enclosure CutGain PerpendicularSquares OrthogonalCut.
Open Scope R_scope.

(* PI times orthogonal_exchange, and its first two derivatives. *)
Definition side_flux (t : R) : R := (strip_flux t + strip_flux 1 - strip_flux (1 - t)) / 2.
Definition side_density (t : R) : R := (strip_density t + strip_density (1 - t)) / 2.
Definition side_density_slope (t : R) : R := (strip_density_slope t - strip_density_slope (1 - t)) / 2.

Lemma strip_flux_0 : strip_flux 0 = 0.
Proof.
  unfold strip_flux. replace ((0 ^ 2 + 2) / (2 * (1 + 0 ^ 2))) with 1 by field. rewrite ln_1. ring.
Qed.

Lemma side_flux_1 : side_flux 1 = strip_flux 1.
Proof. unfold side_flux. replace (1 - 1) with 0 by ring. rewrite strip_flux_0. field. Qed.

Lemma side_flux_mirrored (t : R) : side_flux 1 - side_flux t = side_flux (1 - t).
Proof. rewrite side_flux_1. unfold side_flux. replace (1 - (1 - t)) with t by ring. field. Qed.

Lemma side_density_mirrored (t : R) : side_density (1 - t) = side_density t.
Proof. unfold side_density. replace (1 - (1 - t)) with t by ring. field. Qed.

Lemma orthogonal_exchange_closed_form (t : R) : 0 < t < 1 -> orthogonal_exchange t = side_flux t / PI.
Proof.
  intros H. unfold orthogonal_exchange, side_flux. rewrite !strip_exchange_closed_form by lra. field. apply PI_neq0.
Qed.

Lemma mirror_slope (g : R -> R) (t g' : R) : is_derive g (1 - t) g' -> is_derive (fun x => g (1 - x)) t (- g').
Proof.
  intros H. eapply slope_by_formula.
  { apply (is_derive_comp g (fun x => 1 - x) t g' (- 1)); [exact H|]. auto_derive; trivial; ring. }
  unfold scal; simpl; unfold mult; simpl; ring.
Qed.

Lemma side_flux_slope (t : R) : 0 < t < 1 -> is_derive side_flux t (side_density t).
Proof.
  intros H. pose proof (strip_flux_slope t) as A. pose proof (mirror_slope strip_flux t _ (strip_flux_slope (1 - t) ltac:(lra))) as B.
  unfold side_flux, side_density. eapply slope_by_formula.
  { apply (slope_of_product (fun x => strip_flux x + strip_flux 1 - strip_flux (1 - x)) (fun _ => / 2)).
    - apply slope_of_difference; [|exact B]. apply slope_of_sum; [apply A; lra | exact (is_derive_const _ _)].
    - exact (is_derive_const _ _). }
  unfold zero; simpl. field.
Qed.

Lemma side_density_has_slope (t : R) : 0 < t < 1 -> is_derive side_density t (side_density_slope t).
Proof.
  intros H. pose proof (strip_density_has_slope t) as A.
  pose proof (mirror_slope strip_density t _ (strip_density_has_slope (1 - t) ltac:(lra))) as B.
  unfold side_density, side_density_slope. eapply slope_by_formula.
  { apply (slope_of_product (fun x => strip_density x + strip_density (1 - x)) (fun _ => / 2)).
    - apply slope_of_sum; [apply A; lra | exact B].
    - exact (is_derive_const _ _). }
  unfold zero; simpl. field.
Qed.

(* The density of a strip is positive and grows with its width. *)
Lemma strip_density_increases (v w : R) : 0 < v < w -> strip_density v < strip_density w.
Proof.
  intros H. apply (positive_slope_increases strip_density strip_density_slope); [lra| |].
  - intros x Hx. apply strip_density_has_slope. lra.
  - intros x Hx. unfold strip_density_slope.
    assert (ln (squared_ratio x) < 0); [|lra].
    rewrite <- ln_1. pose proof (squared_ratio_between_0_and_1 x). apply ln_increasing; lra.
Qed.

Lemma arctangents_above_quarter (w : R) : 0 < w <= 1 -> w / 4 < 2 * atan w - sqrt 2 * atan (w / sqrt 2).
Proof.
  intros H. assert (P2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (S2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (E : 2 * atan 0 - sqrt 2 * atan (0 / sqrt 2) - 0 / 4 = 0).
  { replace (0 / sqrt 2) with 0 by (field; lra). rewrite atan_0. field. }
  cut (2 * atan 0 - sqrt 2 * atan (0 / sqrt 2) - 0 / 4 < 2 * atan w - sqrt 2 * atan (w / sqrt 2) - w / 4); [lra|].
  apply (positive_slope_increases (fun w => 2 * atan w - sqrt 2 * atan (w / sqrt 2) - w / 4)
           (fun w => 2 / (1 + w ^ 2) - 2 / (2 + w ^ 2) - 1 / 4)); [lra| |].
  - intros x _. auto_derive; [trivial|]. set (s := sqrt 2) in *.
    replace (2 / (2 + x ^ 2)) with (s * s / (s * s + x ^ 2)) by (now rewrite S2). field. repeat split; nra.
  - intros x Hx. assert (0 <= x <= 1) by lra. interval with (i_prec 30, i_bisect x, i_depth 8).
Qed.

Lemma strip_density_positive (w : R) : 0 < w <= 1 -> 0 < strip_density w.
Proof.
  intros H. pose proof (arctangents_above_quarter w H). unfold strip_density.
  assert (ln (squared_ratio w) < 0).
  { rewrite <- ln_1. pose proof (squared_ratio_between_0_and_1 w). apply ln_increasing; lra. }
  nra.
Qed.

Lemma last_logarithm_bounds (w : R) : 0 < w -> - w ^ 2 / 2 <= ln ((w ^ 2 + 2) / (2 * (1 + w ^ 2))) <= 0.
Proof.
  intros H. assert (0 < w ^ 2) by nra. split.
  - assert (L : ln (2 * (1 + w ^ 2) / (w ^ 2 + 2)) <= w ^ 2 / 2).
    { apply Rle_trans with (2 * (1 + w ^ 2) / (w ^ 2 + 2) - 1).
      - pose proof (exp_ineq1_le (ln (2 * (1 + w ^ 2) / (w ^ 2 + 2)))) as X. rewrite exp_ln in X; [lra|].
        apply Rdiv_lt_0_compat; nra.
      - apply (Rmult_le_reg_r (w ^ 2 + 2)); [nra|]. field_simplify; nra. }
    replace ((w ^ 2 + 2) / (2 * (1 + w ^ 2))) with (/ (2 * (1 + w ^ 2) / (w ^ 2 + 2))) by (field; split; nra).
    rewrite ln_Rinv by (apply Rdiv_lt_0_compat; nra). lra.
  - rewrite <- ln_1. apply Rlt_le, ln_increasing; [apply Rdiv_lt_0_compat; nra|].
    apply (Rmult_lt_reg_r (2 * (1 + w ^ 2))); [nra|]. field_simplify; nra.
Qed.

(* The exchange of a strip is positive, and at most its width times the density at its full width. *)
Lemma strip_flux_bounds (w : R) : 0 < w <= 1 -> 0 < strip_flux w <= w * strip_density w.
Proof.
  intros H. pose proof (arctangents_above_quarter w H). pose proof (last_logarithm_bounds w).
  assert (ln (squared_ratio w) < 0).
  { rewrite <- ln_1. pose proof (squared_ratio_between_0_and_1 w). apply ln_increasing; lra. }
  unfold strip_density, strip_flux. generalize dependent (ln (squared_ratio w)). intros L HL.
  generalize dependent (ln ((w ^ 2 + 2) / (2 * (1 + w ^ 2)))). intros M HM.
  split; nra.
Qed.

Lemma side_flux_positive (t : R) : 0 < t < 1 -> 0 < side_flux t.
Proof.
  intros H. unfold side_flux. pose proof (strip_flux_bounds t).
  assert (strip_flux (1 - t) < strip_flux 1); [|lra].
  apply (positive_slope_increases strip_flux strip_density); [lra| |].
  - intros x Hx. apply strip_flux_slope. lra.
  - intros x Hx. apply strip_density_positive. lra.
Qed.

Lemma side_flux_inside (t : R) : 0 < t < 1 -> 0 < side_flux t < side_flux 1.
Proof.
  intros H. split; [now apply side_flux_positive|]. pose proof (side_flux_positive (1 - t)). pose proof (side_flux_mirrored t). lra.
Qed.

(* Mirroring the cut reverses the slope of the gain. *)
Lemma orthogonal_slope_mirrored (t : R) : 0 < t < 1 ->
  gain_slope side_flux side_density (1 - t) = - gain_slope side_flux side_density t.
Proof.
  intros H. unfold gain_slope, mean_below, mean_above. rewrite side_density_mirrored, !side_flux_mirrored.
  replace (1 - (1 - t)) with t by ring. pose proof (side_flux_positive t H). pose proof (side_flux_positive (1 - t)).
  assert (A : 0 < side_flux t / t) by (apply Rdiv_lt_0_compat; lra).
  assert (B : 0 < side_flux (1 - t) / (1 - t)) by (apply Rdiv_lt_0_compat; lra).
  rewrite (ln_div _ _ A B), (ln_div _ _ B A). ring.
Qed.

Ltac unfold_side :=
  unfold side_flux, side_density, side_density_slope, strip_flux, strip_density, strip_density_slope, squared_ratio.

(* Near the side: density and both means lie in boxes on which the slope is hardly negative. *)
Lemma orthogonal_slope_near_side (t : R) : 0 < t <= 1/50 -> -3/200 <= gain_slope side_flux side_density t.
Proof.
  intros H. unfold gain_slope.
  assert (D0 : 0 < strip_density t <= 122/1000).
  { split; [apply strip_density_positive; lra|].
    assert (strip_density (1/50) <= 122/1000) by (unfold_side; interval with (i_prec 40)).
    destruct (Req_dec t (1/50)) as [->|N]; [lra|]. pose proof (strip_density_increases t (1/50)). lra. }
  assert (D1 : forall x, 49/50 <= x <= 1 -> 836/1000 <= strip_density x <= 845/1000).
  { intros x Hx. unfold_side. split; interval with (i_prec 40, i_bisect x, i_depth 8). }
  assert (Q : 418/1000 <= side_density t <= 484/1000) by (unfold side_density; pose proof (D1 (1 - t)); lra).
  assert (F1 : 628/1000 <= side_flux 1 <= 629/1000) by (rewrite side_flux_1; unfold_side; split; interval with (i_prec 40)).
  assert (A : 418/1000 <= mean_below side_flux t <= 484/1000).
  { destruct (MVT_cor2 strip_flux strip_density (1 - t) 1) as [c [Hc Hin]]; [lra| |].
    - intros c Hc. apply is_derive_Reals. apply strip_flux_slope. lra.
    - pose proof (strip_flux_bounds t ltac:(lra)) as S. pose proof (D1 c ltac:(lra)) as Dc.
      assert (E : mean_below side_flux t = (strip_flux t / t + strip_density c) / 2).
      { unfold mean_below, side_flux. replace (strip_flux t + strip_flux 1 - strip_flux (1 - t))
          with (strip_flux t + strip_density c * (1 - (1 - t))) by lra. field. lra. }
      assert (0 <= strip_flux t / t <= strip_density t).
      { split; [apply Rlt_le, Rdiv_lt_0_compat; lra|]. apply (Rmult_le_reg_r t); [lra|].
        replace (strip_flux t / t * t) with (strip_flux t) by (field; lra). lra. }
      rewrite E. lra. }
  assert (B : 618/1000 <= mean_above side_flux t <= 642/1000).
  { unfold mean_below in A. assert (T : 0 < side_flux t <= 10/1000).
    { split; [apply side_flux_positive; lra|]. replace (side_flux t) with (side_flux t / t * t) by (field; lra). nra. }
    unfold mean_above. split; (apply (Rmult_le_reg_r (1 - t)); [lra|]; field_simplify; [nra|lra]). }
  clear D0 D1 F1. generalize dependent (mean_above side_flux t). intros b B.
  generalize dependent (mean_below side_flux t). intros a A. generalize dependent (side_density t). intros q Q.
  interval with (i_prec 40, i_bisect a, i_bisect b, i_bisect q, i_depth 14).
Qed.

Lemma orthogonal_slope_middle (t : R) : 1/50 <= t <= 11/20 -> -3/200 <= gain_slope side_flux side_density t.
Proof.
  intros H. unfold gain_slope, mean_below, mean_above. rewrite side_flux_mirrored.
  unfold_side. interval with (i_prec 30, i_bisect t, i_taylor t, i_degree 4, i_depth 14).
Qed.

Lemma orthogonal_slope_hardly_negative (t : R) : 0 < t <= 11/20 -> -3/200 <= gain_slope side_flux side_density t.
Proof. intros H. destruct (Rle_lt_dec t (1/50)); [apply orthogonal_slope_near_side | apply orthogonal_slope_middle]; lra. Qed.

Lemma orthogonal_slope_hardly_positive (t : R) : 9/20 <= t < 1 -> gain_slope side_flux side_density t <= 3/200.
Proof.
  intros H. pose proof (orthogonal_slope_mirrored (1 - t)) as E. replace (1 - (1 - t)) with t in E by ring.
  pose proof (orthogonal_slope_hardly_negative (1 - t)). lra.
Qed.
