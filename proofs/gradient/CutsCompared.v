(* Section 4.2, the order of the cuts for every n, continued: the corrected mutual information cut lies before the mean square
   cut for every n >= 1. So for every n >= 2 it is nearer to the mean square cut than the printed one. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Enclosure Extremum Stationarity MeanSquareCut LambdaEquation DensityRatio InformationCut GradientPatch CutOrder.
Open Scope R_scope.

Lemma logarithm_above_its_pade_bound : forall l, 0 < l < 1 -> 2 * (1 - l) / (1 + l) < - ln l.
Proof.
  intros l Hl.
  destruct (mean_value (fun x => - ln x - 2 * (1 - x) / (1 + x)) (fun x => - ((1 - x) ^ 2 / (x * (1 + x) ^ 2))) l 1)
    as [z [Hz E]]; [lra|intros z Hz; auto_derive; [lra|field; lra]|].
  rewrite ln_1 in E.
  assert (P : 0 < (1 - z) ^ 2 / (z * (1 + z) ^ 2)).
  { apply Rdiv_lt_0_compat; [apply pow_lt; lra|apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]]. }
  pose proof (Rmult_lt_0_compat _ (1 - l) P ltac:(lra)); lra.
Qed.

(* At the mean square cut l the radiosity v = l^n satisfies 2 n v (1 - l) = 1 - v, because (1 - l) times the polynomial is
   2 n v (1 - l) - (1 - v). *)
Lemma radiosity_at_mean_square_cut : forall n l, (1 <= n)%nat -> 0 < l < 1 -> mean_square_polynomial n l = 0 ->
  2 * INR n * l ^ n * (1 - l) = 1 - l ^ n.
Proof.
  intros n l Hn Hl E; rewrite (geometric_sum n l); unfold mean_square_polynomial in E.
  replace (sum n (fun k => l ^ k)) with (2 * INR n * l ^ n) by lra; ring.
Qed.

Lemma radiosity_at_mean_square_cut_at_most_one_half : forall n l, (1 <= n)%nat -> 0 < l < 1 ->
  mean_square_polynomial n l = 0 -> l ^ n <= 1 / 2.
Proof.
  intros n l Hn Hl E; unfold mean_square_polynomial in E.
  assert (S : forall m, sum m (fun k => l ^ k) <= INR m).
  { induction m as [|m IH]; [simpl; lra|]; rewrite S_INR; simpl.
    assert (l ^ m <= 1) by (rewrite <- (pow1 m); apply pow_incr; lra); lra. }
  pose proof (S n); pose proof (lt_0_INR n ltac:(lia)) as N.
  apply Rmult_le_reg_l with (2 * INR n); lra.
Qed.

(* Eliminating n = ln v / ln l with the logarithm bound leaves an inequality between v and l alone. *)
Lemma radiosity_and_mean_square_cut : forall n l, (1 <= n)%nat -> 0 < l < 1 -> mean_square_polynomial n l = 0 ->
  1 - l ^ n < (1 + l) * (l ^ n * - ln (l ^ n)).
Proof.
  intros n l Hn Hl E; rewrite <- (radiosity_at_mean_square_cut n l Hn Hl E).
  pose proof (lt_0_INR n ltac:(lia)) as N; pose proof (pow_lt l n (proj1 Hl)) as V.
  assert (Q : ln (l ^ n) = INR n * ln l) by (rewrite <- Rpower_pow by lra; unfold Rpower; apply ln_exp).
  rewrite Q.
  pose proof (Rmult_lt_compat_l ((1 + l) * (l ^ n * INR n)) _ _
    ltac:(repeat apply Rmult_lt_0_compat; lra) (logarithm_above_its_pade_bound l Hl)) as M.
  replace ((1 + l) * (l ^ n * INR n) * (2 * (1 - l) / (1 + l))) with (2 * INR n * l ^ n * (1 - l)) in M by (field; lra).
  lra.
Qed.

Lemma radiosity_at_mean_square_cut_above_28_percent : forall n l, (1 <= n)%nat -> 0 < l < 1 ->
  mean_square_polynomial n l = 0 -> 28 / 100 < l ^ n.
Proof.
  intros n l Hn Hl E; pose proof (radiosity_and_mean_square_cut n l Hn Hl E) as R.
  pose proof (pow_lt l n (proj1 Hl)) as V; set (v := l ^ n) in *.
  apply Rnot_le_lt; intro G.
  assert (P : 0 < v * - ln v).
  { apply Rmult_lt_0_compat; [exact V|]; enough (ln v < 0) by lra; rewrite <- ln_1; apply ln_increasing; lra. }
  pose proof (Rmult_lt_compat_r _ (1 + l) 2 P ltac:(lra)) as R2.
  assert (B : 0 < 1 - 28 / 100 + 2 * (28 / 100) * ln (28 / 100)) by interval with (i_prec 50).
  destruct (Req_dec v (28 / 100)) as [Q|Q]; [rewrite Q in *; lra|].
  destruct (mean_value (fun x => 1 - x + 2 * x * ln x) (fun x => 1 + 2 * ln x) v (28 / 100)) as [z [Hz M]];
    [lra|intros z Hz; auto_derive; [lra|field; lra]|].
  assert (L : 1 + 2 * ln z < 0).
  { assert (ln z < ln (28 / 100)) by (apply ln_increasing; lra).
    assert (ln (28 / 100) < - (1 / 2)) by interval with (i_prec 50); lra. }
  pose proof (Rmult_lt_0_compat (- (1 + 2 * ln z)) (28 / 100 - v) ltac:(lra) ltac:(lra)); lra.
Qed.

(* Minus the slope of the corrected gain at the mean square cut, as a function of v = l^n and l: n is eliminated once more. *)
Definition slope_deficit (v l : R) : R :=
  ln (v * (1 - v * l) / (1 - v * v * l)) + 2 * (1 - v * l) * (1 - v) / ((1 + v - 2 * (v * l)) * (1 - v * v * l)).

Lemma slope_at_mean_square_cut : forall n l, (1 <= n)%nat -> 0 < l < 1 -> mean_square_polynomial n l = 0 ->
  cut_slope n n l = - slope_deficit (l ^ n) l.
Proof.
  intros n l Hn Hl E; pose proof (radiosity_at_mean_square_cut n l Hn Hl E) as R.
  pose proof (lt_0_INR n ltac:(lia)) as N.
  pose proof (power_in_unit_interval n l Hn Hl) as V; pose proof (power_in_unit_interval (n + 1) l ltac:(lia) Hl) as V1.
  unfold cut_slope, cut_ratio, slope_deficit.
  replace (l ^ (n + n + 1)) with (l ^ n * l ^ n * l) by (rewrite !pow_add; ring).
  replace (l ^ (n + 1)) with (l ^ n * l) in * by (rewrite pow_add; ring).
  set (v := l ^ n) in *.
  assert (A : 0 < 1 - v * v * l).
  { pose proof (Rmult_lt_0_compat v (1 - v * l) ltac:(lra) ltac:(lra)); lra. }
  assert (C : 0 < 1 + v - 2 * (v * l)).
  { pose proof (Rmult_lt_0_compat v (1 - l) ltac:(lra) ltac:(lra)); lra. }
  assert (Q : INR (n + n + 1) / INR (n + 1) = 2 * (1 - v * l) / (1 + v - 2 * (v * l))).
  { rewrite !plus_INR; simpl (INR 1).
    apply Rmult_eq_reg_r with ((INR n + 1) * (1 + v - 2 * (v * l))); [|apply Rmult_integral_contrapositive; lra].
    field_simplify; [|lra|lra]; lra. }
  rewrite Q; field; lra.
Qed.

(* It rises with l ... *)
Definition slope_deficit_rise (v l : R) : R :=
  v * (1 - v) / ((1 - v * v * l) * (1 - v * l)) *
  (2 * (1 - v * l) / (1 + v - 2 * (v * l)) * ((1 - v) / (1 + v - 2 * (v * l)) + v * (1 - v * l) / (1 - v * v * l)) - 1).

Lemma derivative_of_slope_deficit : forall v l, 0 < v < 1 -> 0 < l < 1 ->
  is_derive (slope_deficit v) l (slope_deficit_rise v l).
Proof.
  intros v l Hv Hl; unfold slope_deficit, slope_deficit_rise.
  pose proof (Rmult_lt_0_compat v (1 - l) ltac:(lra) ltac:(lra)) as A.
  pose proof (Rmult_lt_0_compat v (1 - v * l) ltac:(lra) ltac:(lra)) as B.
  assert (C : 0 < v * (1 - v * l) / (1 - v * v * l)) by (apply Rdiv_lt_0_compat; lra).
  assert (D : 0 < (1 + v - 2 * (v * l)) * (1 - v * v * l)) by (apply Rmult_lt_0_compat; lra).
  auto_derive; [repeat split; (exact C || lra)|field; repeat split; lra].
Qed.

Lemma slope_deficit_rise_is_positive : forall v l, 28 / 100 <= v <= 1 / 2 -> 44 / 100 <= l <= 1 ->
  0 < slope_deficit_rise v l.
Proof.
  intros v l Hv Hl; unfold slope_deficit_rise.
  interval with (i_prec 40, i_bisect v, i_bisect l, i_depth 14).
Qed.

(* ... and is already positive at the least l that the inequality between v and l admits. *)
Definition least_cut (v : R) : R := (1 - v) / (v * - ln v) - 1.

Lemma least_cut_bound : forall v, 28 / 100 <= v <= 1 / 2 -> 44 / 100 <= least_cut v.
Proof. intros v Hv; unfold least_cut; interval with (i_prec 40, i_bisect v, i_depth 12). Qed.

Lemma slope_deficit_positive_at_least_cut : forall v, 28 / 100 <= v <= 1 / 2 -> 0 < slope_deficit v (least_cut v).
Proof.
  intros v Hv; unfold slope_deficit, least_cut; interval with (i_prec 40, i_bisect v, i_autodiff v, i_depth 14).
Qed.

Lemma slope_negative_at_mean_square_cut : forall n l, (1 <= n)%nat -> 0 < l < 1 -> mean_square_polynomial n l = 0 ->
  cut_slope n n l < 0.
Proof.
  intros n l Hn Hl E; rewrite slope_at_mean_square_cut by assumption.
  pose proof (radiosity_at_mean_square_cut_at_most_one_half n l Hn Hl E).
  pose proof (radiosity_at_mean_square_cut_above_28_percent n l Hn Hl E).
  pose proof (radiosity_and_mean_square_cut n l Hn Hl E) as R.
  set (v := l ^ n) in *; assert (Hv : 28 / 100 <= v <= 1 / 2) by lra.
  pose proof (least_cut_bound v Hv); pose proof (slope_deficit_positive_at_least_cut v Hv).
  assert (P : 0 < v * - ln v).
  { apply Rmult_lt_0_compat; [lra|]; enough (ln v < 0) by lra; rewrite <- ln_1; apply ln_increasing; lra. }
  assert (L : least_cut v < l).
  { unfold least_cut; enough ((1 - v) / (v * - ln v) < 1 + l) by lra.
    apply Rmult_lt_reg_r with (v * - ln v); [exact P|].
    replace ((1 - v) / (v * - ln v) * (v * - ln v)) with (1 - v)
      by (unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra).
    exact R. }
  destruct (mean_value (slope_deficit v) (slope_deficit_rise v) (least_cut v) l L) as [z [Hz M]].
  - intros z Hz; apply derivative_of_slope_deficit; lra.
  - pose proof (slope_deficit_rise_is_positive v z Hv ltac:(lra)) as D.
    pose proof (Rmult_lt_0_compat _ (l - least_cut v) D ltac:(lra)); lra.
Qed.

(* The slope of the corrected gain is negative at the mean square cut: the corrected cut lies before it. *)
Theorem corrected_cut_lies_before_mean_square_cut : forall n corrected mean_square, (1 <= n)%nat ->
  only_maximiser (corrected_objective n) 0 1 corrected ->
  only_minimiser (gradient_mean_square_error n) 0 1 mean_square ->
  corrected < mean_square.
Proof.
  intros n c m Hn C M; pose proof (lt_0_INR n ltac:(lia)) as N.
  pose proof (proj1 M) as Hm.
  apply mean_square_error_is_least_exactly_at_the_root in M; [|exact Hn|lra].
  pose proof (slope_negative_at_mean_square_cut n m Hn Hm M) as S.
  rewrite <- cut_slope_is_power_law_slope in S by lra.
  apply (slope_zero_at_optimal_cut (INR n + 1) (INR n)); [lra|lra| |exact Hm|exact S].
  apply maximiser_only_depends_on_values with (corrected_objective n); [|exact C]; intros x Hx.
  rewrite corrected_objective_has_irradiance_exponent_n; symmetry; apply cut_objective_is_power_law_gain; [lia|exact Hx].
Qed.

(* By the order printed < corrected < mean square. *)
Theorem corrected_cut_is_nearer_to_mean_square_cut : forall n printed corrected mean_square,
  (2 <= n)%nat ->
  only_maximiser (printed_objective n) 0 1 printed ->
  only_maximiser (corrected_objective n) 0 1 corrected ->
  only_minimiser (gradient_mean_square_error n) 0 1 mean_square ->
  printed < corrected < mean_square /\ Rabs (corrected - mean_square) < Rabs (printed - mean_square).
Proof.
  intros n p c m Hn P C M.
  pose proof (printed_cut_lies_before_corrected_cut n p c Hn P C).
  pose proof (corrected_cut_lies_before_mean_square_cut n c m ltac:(lia) C M).
  split; [lra|]; rewrite !Rabs_left by lra; lra.
Qed.
