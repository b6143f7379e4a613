(* Section 4.2, the order of the cuts for every n: the more steeply the irradiance grows, the further out the mutual
   information cut, so for n >= 2 the printed cut lies before the corrected one. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Enclosure Extremum Stationarity MeanSquareCut LambdaEquation DensityRatio InformationCut GradientPatch.
Open Scope R_scope.

Lemma positive_from_zero : forall (f f' : R -> R) x, 0 < x -> f 0 = 0 ->
  (forall z, 0 <= z -> is_derive f z (f' z)) -> (forall z, 0 < z -> 0 < f' z) -> 0 < f x.
Proof.
  intros f f' x Hx Z D P; destruct (mean_value f f' 0 x Hx) as [z [Hz E]]; [intros z Hz; apply D; lra|].
  pose proof (Rmult_lt_0_compat (f' z) (x - 0) (P z ltac:(lra)) ltac:(lra)); lra.
Qed.

Lemma exp_opposite : forall x, exp (- x) * exp x = 1.
Proof. intro x; rewrite <- exp_plus, Rplus_opp_l; apply exp_0. Qed.

(* sinh x > x. *)
Lemma hyperbolic_sine_exceeds_argument : forall x, 0 < x -> 0 < exp x - exp (- x) - 2 * x.
Proof.
  intros x Hx; apply (positive_from_zero (fun z => exp z - exp (- z) - 2 * z) (fun z => exp z + exp (- z) - 2));
    [exact Hx|rewrite Ropp_0; ring|intros z _; auto_derive; [exact I|ring]|].
  intros z Hz; pose proof (exp_ineq1 z ltac:(lra)); pose proof (exp_ineq1 (- z) ltac:(lra)); lra.
Qed.

Lemma third_inequality : forall x, 0 < x -> 0 < 2 * x - 5 + (4 * x + 4) * exp (- x) + exp (- x) * exp (- x).
Proof.
  intros x Hx; apply (positive_from_zero (fun z => 2 * z - 5 + (4 * z + 4) * exp (- z) + exp (- z) * exp (- z))
    (fun z => 2 - 4 * z * exp (- z) - 2 * exp (- z) * exp (- z)));
    [exact Hx|rewrite Ropp_0, exp_0; ring|intros z _; auto_derive; [exact I|ring]|].
  intros z Hz; pose proof (hyperbolic_sine_exceeds_argument z Hz) as S; pose proof (exp_opposite z) as O.
  pose proof (Rmult_lt_0_compat (2 * exp (- z)) _ ltac:(pose proof (exp_pos (- z)); lra) S) as M.
  replace (2 * exp (- z) * (exp z - exp (- z) - 2 * z))
    with (2 * (exp (- z) * exp z) - 4 * z * exp (- z) - 2 * exp (- z) * exp (- z)) in M by ring.
  rewrite O in M; lra.
Qed.

(* With E = l^(-p) - 1 and lambda = - ln (density ratio) the sign of the slope is that of this function, whatever k is. *)
Definition scaled_slope (E lambda : R) : R :=
  ln (1 + E) * lambda_quotient lambda - ln (1 + E * exp lambda).

Definition slope_ratio (E lambda : R) : R :=
  (1 - exp (- lambda) - lambda * exp (- lambda)) / (1 - exp (- lambda)) ^ 2 * (1 + exp (- lambda) / E).

Lemma derivative_of_scaled_slope : forall E x, 0 < E -> 0 < x ->
  is_derive (scaled_slope E) x (E * exp x / (1 + E * exp x) * (ln (1 + E) * slope_ratio E x - 1)).
Proof.
  intros E x HE Hx; pose proof (one_minus_exp_positive x Hx) as P; pose proof (exp_pos x) as Px.
  pose proof (Rmult_lt_0_compat E (exp x) HE Px) as PE.
  unfold scaled_slope, lambda_quotient, slope_ratio; auto_derive; [repeat split; lra|].
  pose proof (exp_ineq1 x ltac:(lra)); rewrite exp_Ropp in *; field; repeat split; lra.
Qed.

Lemma slope_ratio_rises : forall E x y, 2 <= E -> 0 < x -> x < y -> slope_ratio E x < slope_ratio E y.
Proof.
  intros E x y HE Hx Hxy.
  set (d := fun z => exp (- z) / E / (1 - exp (- z)) ^ 3 *
    ((E + exp (- z)) * (z - 2 + (z + 2) * exp (- z)) - (1 - exp (- z) - z * exp (- z)) * (1 - exp (- z)))).
  destruct (mean_value (slope_ratio E) d x y Hxy) as [z [Hz Q]].
  - intros z Hz; pose proof (one_minus_exp_positive z ltac:(lra)) as P; unfold slope_ratio, d.
    auto_derive; [|field; lra].
    pose proof (Rmult_lt_0_compat _ _ P P); repeat split; try lra; intro N; simpl in N; lra.
  - enough (P : 0 < d z) by (pose proof (Rmult_lt_0_compat _ (y - x) P ltac:(lra)); lra).
    pose proof (one_minus_exp_positive z ltac:(lra)) as P; pose proof (exp_pos (- z)) as Pz.
    unfold d; apply Rmult_lt_0_compat.
    + repeat apply Rdiv_lt_0_compat; try lra; apply pow_lt; exact P.
    + pose proof (twice_mean_exceeds_chord z ltac:(lra)) as U; pose proof (third_inequality z ltac:(lra)) as T.
      pose proof (Rmult_le_compat_r _ _ _ (Rlt_le _ _ U) (Rplus_le_compat_r (exp (- z)) _ _ HE)) as M.
      apply Rlt_le_trans with ((2 + exp (- z)) * (z - 2 + (z + 2) * exp (- z))
        - (1 - exp (- z) - z * exp (- z)) * (1 - exp (- z))); [|lra].
      replace (_ - _) with (2 * z - 5 + (4 * z + 4) * exp (- z) + exp (- z) * exp (- z)) by ring; exact T.
Qed.

Lemma lambda_quotient_below : forall x, 0 < x -> lambda_quotient x < 1 + x.
Proof.
  intros x Hx; destruct (lambda_root_bracket _ x Hx eq_refl); lra.
Qed.

(* Its derivative changes sign at most once, from minus to plus, and at 0 it is at most 0: so once it is 0 or more, at a
   positive lambda, it is positive from there on. *)
Lemma scaled_slope_stays_positive : forall E x y, 2 <= E -> 0 < x -> x < y ->
  0 <= scaled_slope E x -> 0 < scaled_slope E y.
Proof.
  intros E x y HE Hx Hxy J.
  assert (T : 0 < ln (1 + E)) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (F : forall z, 0 < E * exp z / (1 + E * exp z)).
  { intro z; pose proof (Rmult_lt_0_compat E (exp z) ltac:(lra) (exp_pos z)); apply Rdiv_lt_0_compat; lra. }
  destruct (Rlt_le_dec 1 (ln (1 + E) * slope_ratio E x)) as [H|H].
  - destruct (mean_value _ _ x y Hxy (fun z Hz => derivative_of_scaled_slope E z ltac:(lra) ltac:(lra)))
      as [z [Hz Q]].
    pose proof (slope_ratio_rises E x z HE Hx (proj1 Hz)) as R.
    pose proof (Rmult_lt_compat_l _ _ _ T R).
    pose proof (Rmult_lt_0_compat _ (ln (1 + E) * slope_ratio E z - 1) (F z) ltac:(lra)) as P.
    pose proof (Rmult_lt_0_compat _ (y - x) P ltac:(lra)); lra.
  - exfalso.
    assert (Fall : forall u v, 0 < u -> u < v -> v <= x -> scaled_slope E v < scaled_slope E u).
    { intros u v Hu Huv Hv.
      destruct (mean_value _ _ u v Huv (fun z Hz => derivative_of_scaled_slope E z ltac:(lra) ltac:(lra)))
        as [z [Hz Q]].
      pose proof (slope_ratio_rises E z x HE ltac:(lra) ltac:(lra)) as R.
      pose proof (Rmult_lt_compat_l _ _ _ T R).
      pose proof (Rmult_lt_0_compat _ (1 - ln (1 + E) * slope_ratio E z) (F z) ltac:(lra)) as P.
      pose proof (Rmult_lt_0_compat _ (v - u) P ltac:(lra)); lra. }
    pose proof (Fall (x / 2) x ltac:(lra) ltac:(lra) ltac:(lra)) as D.
    set (delta := scaled_slope E (x / 2)) in *.
    set (w := Rmin (x / 4) (delta / ln (1 + E))).
    assert (W : 0 < w) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]).
    pose proof (Rmin_l (x / 4) (delta / ln (1 + E))) as W1; pose proof (Rmin_r (x / 4) (delta / ln (1 + E))) as W2.
    fold w in W1, W2.
    pose proof (Fall w (x / 2) W ltac:(lra) ltac:(lra)) as D'; fold delta in D'; unfold scaled_slope in D'.
    pose proof (Rmult_lt_compat_l _ _ _ T (lambda_quotient_below w W)).
    assert (L : ln (1 + E) < ln (1 + E * exp w)).
    { apply ln_increasing; [lra|]; pose proof (exp_ineq1 w ltac:(lra)).
      pose proof (Rmult_lt_compat_l E 1 (exp w) ltac:(lra) ltac:(lra)); lra. }
    pose proof (Rmult_le_compat_l _ _ _ (Rlt_le _ _ T) W2) as M.
    replace (ln (1 + E) * (delta / ln (1 + E))) with delta in M by (field; lra); lra.
Qed.

(* The correspondence: E e^lambda = l^(-(p+k)) - 1. *)
Lemma slope_in_lambda : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  let E := exp (- (p * ln l)) - 1 in
  let lambda := - ln (density_ratio p k l) in
  0 < E /\ 0 < lambda /\ 1 + E * exp lambda = exp (- ((p + k) * ln l)) /\
  scaled_slope E lambda = power_law_slope p k l * (- (p * ln l) / (1 - density_ratio p k l)).
Proof.
  intros p k l Hp Hk Hl E lambda.
  assert (L : ln l < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
  pose proof (Rmult_lt_0_compat p (- ln l) Hp ltac:(lra)) as PL.
  pose proof (density_ratio_between_0_and_1 p k l Hp Hk Hl) as Y.
  pose proof (power_between_0_and_1 p l Hp Hl) as P; pose proof (power_between_0_and_1 k l Hk Hl) as K.
  pose proof (power_between_0_and_1 (p + k) l ltac:(lra) Hl) as PK.
  assert (HE : 0 < E) by (unfold E; pose proof (exp_ineq1 (- (p * ln l)) ltac:(lra)); lra).
  assert (HL : 0 < lambda).
  { unfold lambda; enough (ln (density_ratio p k l) < 0) by lra; rewrite <- ln_1; apply ln_increasing; lra. }
  assert (EE : 1 + E * exp lambda = exp (- ((p + k) * ln l))).
  { unfold E, lambda; rewrite exp_Ropp with (x := ln _), exp_ln by lra; unfold density_ratio.
    unfold Rpower in *; rewrite !exp_Ropp; rewrite Rmult_plus_distr_r, exp_plus in *; field; repeat split; lra. }
  split; [exact HE|split; [exact HL|split; [exact EE|]]].
  unfold scaled_slope; rewrite EE, ln_exp.
  replace (1 + E) with (exp (- (p * ln l))) by (unfold E; ring); rewrite ln_exp.
  unfold lambda_quotient, power_law_slope; replace (exp (- lambda)) with (density_ratio p k l)
    by (unfold lambda; rewrite Ropp_involutive, exp_ln; lra).
  fold lambda; field; lra.
Qed.

Lemma slope_sign_in_lambda : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  0 < - (p * ln l) / (1 - density_ratio p k l).
Proof.
  intros p k l Hp Hk Hl; assert (L : ln l < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
  pose proof (Rmult_lt_0_compat p (- ln l) Hp ltac:(lra)).
  pose proof (density_ratio_between_0_and_1 p k l Hp Hk Hl); apply Rdiv_lt_0_compat; lra.
Qed.

(* At l = 3^(-1/p), that is E = 2, the slope is negative for k = p (there lambda = ln 4), hence for every k <= p. *)
Lemma scaled_slope_negative_at_two : forall x, 0 < x -> x <= ln 4 -> scaled_slope 2 x < 0.
Proof.
  assert (N : scaled_slope 2 (ln 4) < 0).
  { unfold scaled_slope, lambda_quotient; rewrite exp_Ropp, exp_ln by lra; interval with (i_prec 60). }
  intros x Hx Hx4; destruct (Rlt_le_dec (scaled_slope 2 x) 0) as [H|H]; [exact H|exfalso].
  destruct (Req_dec x (ln 4)) as [Q|Q]; [rewrite Q in H; lra|].
  pose proof (scaled_slope_stays_positive 2 x (ln 4) ltac:(lra) Hx ltac:(lra) H); lra.
Qed.

Lemma slope_zero_at_optimal_cut : forall p k c, 0 < p -> 0 < k -> only_maximiser (power_law_gain p k) 0 1 c ->
  0 < c < 1 /\ power_law_slope p k c = 0 /\
  (forall l, 0 < l < 1 -> 0 < power_law_slope p k l -> l < c) /\ (forall l, 0 < l < 1 -> power_law_slope p k l < 0 -> c < l).
Proof.
  intros p k c Hp Hk M.
  destruct (power_law_gain_rises_then_falls p k Hp Hk) as [d [Hd [Ed [_ N]]]].
  rewrite (maximiser_is_unique _ _ _ _ _ M N); clear c M.
  destruct (power_law_slope_changes_sign_once p k Hp Hk) as [c [Hc [Ec [Pos Neg]]]].
  assert (Q : d = c).
  { destruct (Rtotal_order c d) as [L|[Q|L]]; [|symmetry; exact Q|]; exfalso.
    - pose proof (Neg d ltac:(lra)); lra.
    - pose proof (Pos d ltac:(lra)); lra. }
  subst d; repeat split; try lra; intros l Hl H.
  - destruct (Rtotal_order l c) as [L|[Q|L]]; [exact L|rewrite Q in H; lra|pose proof (Neg l ltac:(lra)); lra].
  - destruct (Rtotal_order c l) as [L|[Q|L]]; [exact L|rewrite <- Q in H; lra|pose proof (Pos l ltac:(lra)); lra].
Qed.

(* The optimal cut for k1 <= p has l^p < 1/3, so E > 2 there; for k2 > k1 lambda is larger, and the slope still positive. *)
Theorem steeper_irradiance_moves_the_cut_outward : forall p k1 k2 c1 c2, 0 < p -> 0 < k1 <= p -> k1 < k2 ->
  only_maximiser (power_law_gain p k1) 0 1 c1 -> only_maximiser (power_law_gain p k2) 0 1 c2 -> c1 < c2.
Proof.
  intros p k1 k2 c1 c2 Hp Hk1 Hk2 M1 M2.
  destruct (slope_zero_at_optimal_cut p k1 c1 Hp ltac:(lra) M1) as [Hc1 [E1 [_ Neg1]]].
  destruct (slope_zero_at_optimal_cut p k2 c2 Hp ltac:(lra) M2) as [Hc2 [_ [Pos2 _]]].
  apply Pos2; [exact Hc1|].
  assert (L3 : 0 < ln 3) by (rewrite <- ln_1; apply ln_increasing; lra).
  (* c1 < 3^(-1/p) *)
  assert (B : c1 < exp (- (ln 3 / p))).
  { pose proof (Rdiv_lt_0_compat (ln 3) p L3 Hp) as L3p.
    assert (H : 0 < exp (- (ln 3 / p)) < 1) by (split; [apply exp_pos|rewrite <- exp_0; apply exp_increasing; lra]).
    apply Neg1; [exact H|].
    destruct (slope_in_lambda p k1 _ Hp ltac:(lra) H) as [_ [PL [EE S]]].
    pose proof (slope_sign_in_lambda p k1 _ Hp ltac:(lra) H) as F.
    set (lambda := - ln (density_ratio p k1 (exp (- (ln 3 / p))))) in *.
    rewrite !ln_exp in *.
    replace (exp (- (p * - (ln 3 / p))) - 1) with 2 in *
      by (replace (- (p * - (ln 3 / p))) with (ln 3) by (field; lra); rewrite exp_ln; lra).
    assert (N : scaled_slope 2 lambda < 0).
    { apply scaled_slope_negative_at_two; [exact PL|].
      apply Rnot_lt_le; intro G; apply exp_increasing in G; rewrite exp_ln in G by lra.
      assert (U : exp (- ((p + k1) * - (ln 3 / p))) <= exp (2 * ln 3)).
      { apply Rnot_lt_le; intro V; apply exp_lt_inv in V.
        replace (- ((p + k1) * - (ln 3 / p))) with (ln 3 + k1 / p * ln 3) in V by (field; lra).
        assert (k1 / p <= 1) by (apply Rmult_le_reg_r with p; [exact Hp|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra).
        pose proof (Rmult_le_compat_r (ln 3) (k1 / p) 1 ltac:(lra) ltac:(lra)); lra. }
      replace (exp (2 * ln 3)) with 9 in U; [lra|].
      replace (2 * ln 3) with (ln 3 + ln 3) by ring; rewrite exp_plus, exp_ln; lra. }
    destruct (Rlt_le_dec (power_law_slope p k1 (exp (- (ln 3 / p)))) 0) as [G|G]; [exact G|exfalso].
    pose proof (Rmult_le_pos _ _ G (Rlt_le _ _ F)); lra. }
  destruct (slope_in_lambda p k1 c1 Hp ltac:(lra) Hc1) as [PE [PL1 [EE1 S1]]].
  destruct (slope_in_lambda p k2 c1 Hp ltac:(lra) Hc1) as [_ [PL2 [EE2 S2]]].
  pose proof (slope_sign_in_lambda p k2 c1 Hp ltac:(lra) Hc1) as F2.
  set (E := exp (- (p * ln c1)) - 1) in *.
  set (lambda1 := - ln (density_ratio p k1 c1)) in *; set (lambda2 := - ln (density_ratio p k2 c1)) in *.
  assert (HE : 2 <= E).
  { assert (V : ln c1 < - (ln 3 / p)) by (rewrite <- (ln_exp (- (ln 3 / p))); apply ln_increasing; lra).
    pose proof (Rmult_lt_compat_l p _ _ Hp V) as V'.
    replace (p * - (ln 3 / p)) with (- ln 3) in V' by (field; lra).
    assert (W : exp (ln 3) < exp (- (p * ln c1))) by (apply exp_increasing; lra).
    rewrite exp_ln in W by lra; unfold E; lra. }
  assert (L12 : lambda1 < lambda2).
  { apply exp_lt_inv, Rmult_lt_reg_l with E; [exact PE|].
    assert (L : ln c1 < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
    pose proof (Rmult_lt_compat_r (- ln c1) k1 k2 ltac:(lra) Hk2).
    assert (W : exp (- ((p + k1) * ln c1)) < exp (- ((p + k2) * ln c1))) by (apply exp_increasing; lra).
    lra. }
  rewrite E1, Rmult_0_l in S1.
  pose proof (scaled_slope_stays_positive E lambda1 lambda2 HE PL1 L12 ltac:(lra)) as P.
  rewrite S2 in P; destruct (Rlt_le_dec 0 (power_law_slope p k2 c1)) as [G|G]; [exact G|exfalso].
  pose proof (Rmult_le_compat_r _ _ _ (Rlt_le _ _ F2) G); lra.
Qed.

(* In the paper's setting p = n + 1; the printed expression has k = 1 and the corrected one k = n. *)
Theorem printed_cut_lies_before_corrected_cut : forall n printed corrected, (2 <= n)%nat ->
  only_maximiser (printed_objective n) 0 1 printed -> only_maximiser (corrected_objective n) 0 1 corrected ->
  printed < corrected.
Proof.
  intros n c1 c2 Hn M1 M2; pose proof (le_INR 2 n Hn) as N; simpl INR in N.
  apply (steeper_irradiance_moves_the_cut_outward (INR n + 1) (INR 1) (INR n)); try (simpl INR; lra).
  - apply maximiser_only_depends_on_values with (printed_objective n); [|exact M1]; intros x Hx.
    rewrite printed_objective_has_irradiance_exponent_1; symmetry; apply cut_objective_is_power_law_gain; [lia|exact Hx].
  - apply maximiser_only_depends_on_values with (corrected_objective n); [|exact M2]; intros x Hx.
    rewrite corrected_objective_has_irradiance_exponent_n; symmetry; apply cut_objective_is_power_law_gain; [lia|exact Hx].
Qed.
