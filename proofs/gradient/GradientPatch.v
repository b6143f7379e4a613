(* Section 4.2: the objective of the mutual information cut derived from eq. (5) and section 3.4, for the radiosity B x^n
   and an irradiance H x^m on the patch. The printed expression is m = 1; an irradiance that grows as the radiosity
   (no emission, constant reflectivity) is m = n. Each objective has exactly one maximiser in (0, 1), for every n. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Information Stationarity Extremum MeanSquareCut DensityRatio InformationCut.
Open Scope R_scope.

(* Eq. (5) for two sub-patches, with weights w1, w2, w and transition probabilities P1, P2, P to a patch of weight w_j. *)
Definition gain_of_two_parts (w1 P1 w2 P2 w P w_j : R) : R :=
  2 * (w1 * xlog2 P1 w_j + w2 * xlog2 P2 w_j - w * xlog2 P w_j).

(* Section 3.4 on the strip [u, v] of the patch, irradiance (B - E) / R = H x^m; the factor K stands for the constant
   form factor times the integral of the constant B_j; `total` normalises the weights. *)
Definition gradient_strip_weight (total B H : R) (n m : nat) (u v : R) : R :=
  RInt (fun x => B * x ^ n * (H * x ^ m)) u v / total.

Definition gradient_strip_flux (total B K : R) (n : nat) (u v : R) : R :=
  RInt (fun x => K * (B * x ^ n)) u v / total.

Definition gradient_strip_transition (total B H K : R) (n m : nat) (u v : R) : R :=
  gradient_strip_flux total B K n u v / gradient_strip_weight total B H n m u v.

Definition gradient_patch_gain (total B H K w_j : R) (n m : nat) (l : R) : R :=
  gain_of_two_parts
    (gradient_strip_weight total B H n m 0 l) (gradient_strip_transition total B H K n m 0 l)
    (gradient_strip_weight total B H n m l 1) (gradient_strip_transition total B H K n m l 1)
    (gradient_strip_weight total B H n m 0 1) (gradient_strip_transition total B H K n m 0 1) w_j.

(* The gain per unit of flux for the irradiance x^m. *)
Definition cut_objective (n m : nat) (l : R) : R :=
  INR m * l ^ (n + 1) * log2 (1 / l) + (1 - l ^ (n + 1)) * log2 ((1 - l ^ (n + 1)) / (1 - l ^ (n + m + 1))).

(* The expression as printed. *)
Definition printed_objective (n : nat) (l : R) : R :=
  l ^ (n + 1) * log2 (1 / l) + (1 - l ^ (n + 1)) * log2 ((1 - l ^ (n + 1)) / (1 - l ^ (n + 2))).

(* The expression for an irradiance that grows as the radiosity. *)
Definition corrected_objective (n : nat) (l : R) : R :=
  INR n * l ^ (n + 1) * log2 (1 / l) + (1 - l ^ (n + 1)) * log2 ((1 - l ^ (n + 1)) / (1 - l ^ (2 * n + 1))).

Lemma printed_objective_has_irradiance_exponent_1 : forall n l, printed_objective n l = cut_objective n 1 l.
Proof.
  intros n l; unfold printed_objective, cut_objective.
  replace (n + 1 + 1)%nat with (n + 2)%nat by lia; simpl (INR 1); ring.
Qed.

Lemma corrected_objective_has_irradiance_exponent_n : forall n l, corrected_objective n l = cut_objective n n l.
Proof.
  intros n l; unfold corrected_objective, cut_objective.
  replace (n + n + 1)%nat with (2 * n + 1)%nat by lia; reflexivity.
Qed.

(* For n = 1 the two expressions are the same. *)
Theorem printed_and_corrected_agree_for_linear_radiosity : forall l, corrected_objective 1 l = printed_objective 1 l.
Proof.
  intro l; rewrite printed_objective_has_irradiance_exponent_1; apply corrected_objective_has_irradiance_exponent_n.
Qed.

(* Coquelicot states an equation of integrals in a normed module; read it in R. *)
Ltac real_equation := match goal with |- ?a = ?b => change (@eq R a b) end.

Lemma integral_of_multiple_of_power : forall c n u v,
  RInt (fun x => c * x ^ n) u v = c * (v ^ (n + 1) - u ^ (n + 1)) / (INR n + 1).
Proof.
  intros c n u v.
  transitivity (c * RInt (fun x => x ^ n) u v).
  - apply (RInt_scal (V := R_CompleteNormedModule)), ex_RInt_continuous; intros x _; apply power_is_continuous.
  - rewrite integral_of_power; real_equation; unfold Rdiv; ring.
Qed.

Lemma gradient_strip_weight_value : forall total B H n m u v,
  gradient_strip_weight total B H n m u v =
  B * H / (INR (n + m) + 1) / total * (v ^ (n + m + 1) - u ^ (n + m + 1)).
Proof.
  intros total B H n m u v; unfold gradient_strip_weight.
  rewrite (RInt_ext (fun x => B * x ^ n * (H * x ^ m)) (fun x => B * H * x ^ (n + m)))
    by (intros x _; rewrite pow_add; real_equation; ring).
  rewrite integral_of_multiple_of_power; unfold Rdiv; ring.
Qed.

Lemma gradient_strip_flux_value : forall total B K n u v,
  gradient_strip_flux total B K n u v = K * B / (INR n + 1) / total * (v ^ (n + 1) - u ^ (n + 1)).
Proof.
  intros total B K n u v; unfold gradient_strip_flux.
  rewrite (RInt_ext (fun x => K * (B * x ^ n)) (fun x => K * B * x ^ n))
    by (intros x _; real_equation; ring).
  rewrite integral_of_multiple_of_power; unfold Rdiv; ring.
Qed.

Lemma power_in_unit_interval : forall n l, (1 <= n)%nat -> 0 < l < 1 -> 0 < l ^ n < 1.
Proof.
  intros n l Hn Hl; split; [apply pow_lt; lra|].
  rewrite <- (pow1 n); apply power_is_strictly_increasing; assumption.
Qed.

(* With flux shares p1 + p2 = 1 and weight shares a1 + a2 = 1, eq. (5) is twice the flux times the gain per unit of flux:
   the logarithms of the total flux, the total weight and w_j cancel. *)
Theorem gain_depends_on_shares_only : forall flux weight w_j p1 a1,
  0 < flux -> 0 < weight -> 0 < w_j -> 0 < p1 < 1 -> 0 < a1 < 1 ->
  gain_of_two_parts (weight * a1) (flux * p1 / (weight * a1))
    (weight * (1 - a1)) (flux * (1 - p1) / (weight * (1 - a1))) weight (flux / weight) w_j =
  2 * flux * two_sided_information 1 1 p1 a1.
Proof.
  intros flux weight w_j p1 a1 Hf Hw Hj Hp Ha.
  pose proof ln_2_positive as L2.
  assert (X : forall x y, 0 < x -> 0 < y -> xlog2 x y = x * (ln x - ln y) / ln 2).
  { intros x y Hx Hy; unfold xlog2, log2; destruct (Req_EM_T x 0); [lra|].
    rewrite ln_div by assumption; field; lra. }
  pose proof (Rmult_lt_0_compat _ _ Hf (proj1 Hp)) as F1; pose proof (Rmult_lt_0_compat flux (1 - p1) Hf ltac:(lra)) as F2.
  pose proof (Rmult_lt_0_compat _ _ Hw (proj1 Ha)) as W1; pose proof (Rmult_lt_0_compat weight (1 - a1) Hw ltac:(lra)) as W2.
  unfold gain_of_two_parts, two_sided_information.
  rewrite !X by (try lra; apply Rdiv_lt_0_compat; lra).
  rewrite !ln_div by lra; rewrite !ln_mult by lra; field; repeat split; lra.
Qed.

(* Flux shares l^(n+1) and weight shares l^(n+m+1) come from the integrals of section 3.4. *)
Theorem gain_of_gradient_patch : forall total B H K w_j n m l,
  0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> 0 < l < 1 ->
  gradient_patch_gain total B H K w_j n m l = 2 * gradient_strip_flux total B K n 0 1 * cut_objective n m l.
Proof.
  intros total B H K w_j n m l Ht HB HH HK Hj Hl; unfold gradient_patch_gain, gradient_strip_transition.
  rewrite !gradient_strip_weight_value, !gradient_strip_flux_value, !pow1, !(pow_i (_ + 1)) by lia; rewrite !Rminus_0_r, !Rmult_1_r.
  pose proof (pos_INR n); pose proof (pos_INR (n + m)).
  assert (F : 0 < K * B / (INR n + 1) / total)
    by (repeat apply Rdiv_lt_0_compat; try lra; apply Rmult_lt_0_compat; assumption).
  assert (W : 0 < B * H / (INR (n + m) + 1) / total)
    by (repeat apply Rdiv_lt_0_compat; try lra; apply Rmult_lt_0_compat; assumption).
  pose proof (power_in_unit_interval (n + 1) l ltac:(lia) Hl) as P.
  pose proof (power_in_unit_interval (n + m + 1) l ltac:(lia) Hl) as A.
  rewrite gain_depends_on_shares_only by assumption; f_equal.
  unfold two_sided_information, cut_objective, xlog2.
  destruct (Req_EM_T (l ^ (n + 1)) 0); [lra|]; destruct (Req_EM_T (1 - l ^ (n + 1)) 0); [lra|]; f_equal.
  replace (n + m + 1)%nat with (m + (n + 1))%nat by lia; rewrite (pow_add l m (n + 1)).
  pose proof (pow_lt l m (proj1 Hl)).
  replace (l ^ (n + 1) / (l ^ m * l ^ (n + 1))) with (/ l ^ m) by (field; lra).
  pose proof ln_2_positive; unfold log2; rewrite ln_Rinv by lra; replace (1 / l) with (/ l) by (field; lra).
  rewrite ln_Rinv by lra; rewrite <- (Rpower_pow m l) by lra; unfold Rpower; rewrite ln_exp; field; lra.
Qed.

(* Whole exponents are the case p = n + 1, k = m of the real ones. *)
Lemma cut_objective_is_power_law_gain : forall n m l, (1 <= m)%nat -> 0 < l < 1 ->
  power_law_gain (INR n + 1) (INR m) l = cut_objective n m l.
Proof.
  intros n m l Hm Hl; pose proof (pos_INR n); pose proof (lt_0_INR m ltac:(lia)).
  rewrite power_law_gain_closed_form by lra; unfold cut_objective.
  assert (E1 : INR n + 1 = INR (n + 1)) by (rewrite plus_INR; reflexivity).
  assert (E2 : INR n + 1 + INR m = INR (n + m + 1)) by (rewrite !plus_INR; simpl; ring).
  rewrite E2, E1, !Rpower_pow by lra; reflexivity.
Qed.

Theorem cut_objective_rises_then_falls : forall n m, (1 <= m)%nat ->
  exists c, 0 < c < 1 /\ rises_then_falls (cut_objective n m) 0 c 1 /\ only_maximiser (cut_objective n m) 0 1 c.
Proof.
  intros n m Hm; pose proof (pos_INR n); pose proof (lt_0_INR m ltac:(lia)).
  destruct (power_law_gain_rises_then_falls (INR n + 1) (INR m)) as [c [Hc [_ [S _]]]]; [lra|lra|].
  assert (S' : rises_then_falls (cut_objective n m) 0 c 1).
  { apply shape_only_depends_on_values with (power_law_gain (INR n + 1) (INR m)); [exact Hc| |exact S].
    intros x Hx; apply cut_objective_is_power_law_gain; assumption. }
  exists c; split; [exact Hc|split; [exact S'|]]; apply rises_then_falls_has_one_maximiser; assumption.
Qed.

(* The printed expression, for every n. *)
Theorem printed_objective_rises_then_falls : forall n,
  exists c, 0 < c < 1 /\ rises_then_falls (printed_objective n) 0 c 1 /\ only_maximiser (printed_objective n) 0 1 c.
Proof.
  intro n; destruct (cut_objective_rises_then_falls n 1 (le_n 1)) as [c [Hc [S _]]].
  assert (S' : rises_then_falls (printed_objective n) 0 c 1).
  { apply shape_only_depends_on_values with (cut_objective n 1); [exact Hc| |exact S].
    intros x _; symmetry; apply printed_objective_has_irradiance_exponent_1. }
  exists c; split; [exact Hc|split; [exact S'|]]; apply rises_then_falls_has_one_maximiser; assumption.
Qed.

(* The corrected one, for every n >= 1. *)
Theorem corrected_objective_rises_then_falls : forall n, (1 <= n)%nat ->
  exists c, 0 < c < 1 /\ rises_then_falls (corrected_objective n) 0 c 1 /\ only_maximiser (corrected_objective n) 0 1 c.
Proof.
  intros n Hn; destruct (cut_objective_rises_then_falls n n Hn) as [c [Hc [S _]]].
  assert (S' : rises_then_falls (corrected_objective n) 0 c 1).
  { apply shape_only_depends_on_values with (cut_objective n n); [exact Hc| |exact S].
    intros x _; symmetry; apply corrected_objective_has_irradiance_exponent_n. }
  exists c; split; [exact Hc|split; [exact S'|]]; apply rises_then_falls_has_one_maximiser; assumption.
Qed.

(* Negative control: where the irradiance is constant no cut gains anything. *)
Theorem constant_irradiance_gains_nothing : forall n l, 0 < l < 1 -> cut_objective n 0 l = 0.
Proof.
  intros n l Hl; unfold cut_objective; rewrite Nat.add_0_r.
  pose proof (power_in_unit_interval (n + 1) l ltac:(lia) Hl).
  replace ((1 - l ^ (n + 1)) / (1 - l ^ (n + 1))) with 1 by (field; lra).
  unfold log2; rewrite ln_1; simpl; unfold Rdiv; ring.
Qed.

(* The slope of the gain at whole exponents, used for the decimals. *)
Definition cut_ratio (n m : nat) (l : R) : R := l ^ m * (1 - l ^ (n + 1)) / (1 - l ^ (n + m + 1)).

Definition cut_slope (n m : nat) (l : R) : R :=
  - ln (cut_ratio n m l) - INR (n + m + 1) / INR (n + 1) * (1 - cut_ratio n m l).

Lemma cut_slope_is_power_law_slope : forall n m l, 0 < l -> power_law_slope (INR n + 1) (INR m) l = cut_slope n m l.
Proof.
  intros n m l Hl; unfold power_law_slope, cut_slope, density_ratio, cut_ratio.
  assert (E1 : INR n + 1 = INR (n + 1)) by (rewrite plus_INR; reflexivity).
  assert (E2 : INR n + 1 + INR m = INR (n + m + 1)) by (rewrite !plus_INR; simpl; ring).
  rewrite E2, E1, !Rpower_pow by lra; reflexivity.
Qed.

Theorem information_cut_between_slopes : forall n m lower upper, (1 <= m)%nat ->
  0 < lower < 1 -> 0 < upper < 1 -> 0 < cut_slope n m lower -> cut_slope n m upper < 0 ->
  exists l, lower < l < upper /\ only_maximiser (cut_objective n m) 0 1 l.
Proof.
  intros n m lower upper Hm HL HU PL NU; pose proof (pos_INR n); pose proof (lt_0_INR m ltac:(lia)).
  rewrite <- cut_slope_is_power_law_slope in PL by lra; rewrite <- cut_slope_is_power_law_slope in NU by lra.
  destruct (information_cut_between_signs (INR n + 1) (INR m) lower upper) as [l [Hl M]]; try lra.
  exists l; split; [exact Hl|]; apply maximiser_only_depends_on_values with (power_law_gain (INR n + 1) (INR m)).
  - intros x Hx; apply cut_objective_is_power_law_gain; assumption.
  - exact M.
Qed.
