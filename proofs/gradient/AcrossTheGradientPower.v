(* Section 4.2, the patch of the paper: radiosity B x^n and irradiance H x^m, m >= 1. Of all divisions into two parts, of
   whatever shape, none gains more than the best cut of GradientPatch.v across the gradient. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information LogSum Stationarity Extremum MeanSquareCut DensityRatio InformationCut GradientPatch
  IntegralsOverParts AcrossTheGradient AcrossTheGradientGain.
Open Scope R_scope.

(* Flux and weight of the strip at x, as in GradientPatch.v: total normalises, K is the form factor times the integral of B_j. *)
Definition gradient_flux_density (total B K : R) (n : nat) (x : R) : R := / total * (K * (B * x ^ n)).
Definition gradient_weight_density (total B H : R) (n m : nat) (x : R) : R := / total * (B * x ^ n * (H * x ^ m)).

(* Gain (5) of the division in which the first part takes the share s x of the strip at x. *)
Definition gradient_division_gain (total B H K w_j : R) (n m : nat) : (R -> R) -> R :=
  division_gain (gradient_flux_density total B K n) (gradient_weight_density total B H n m) w_j.

Section Power.
Variables (total B H K w_j : R) (n m : nat).
Hypothesis total_positive : 0 < total.
Hypothesis B_positive : 0 < B.
Hypothesis H_positive : 0 < H.
Hypothesis K_positive : 0 < K.
Hypothesis receiver_weight_positive : 0 < w_j.

Local Notation g := (gradient_flux_density total B K n).
Local Notation w := (gradient_weight_density total B H n m).
(* Weight over flux: the irradiance over K, which rises with x. *)
Local Notation ratio := (fun x : R => H / K * x ^ m).

Lemma power_integrable : forall c k a b, ex_RInt (fun x => c * x ^ k) a b.
Proof. intros c k a b. apply multiple_integrable, (ex_RInt_continuous (V := R_CompleteNormedModule)).
  intros x _. apply power_is_continuous. Qed.

Lemma flux_density_form : forall x, g x = / total * K * B * x ^ n.
Proof. intros x. unfold gradient_flux_density. ring. Qed.

Lemma weight_density_form : forall x, w x = / total * B * H * x ^ (n + m).
Proof. intros x. unfold gradient_weight_density. rewrite pow_add. ring. Qed.

Lemma gradient_flux_integrable : forall a b, ex_RInt g a b.
Proof.
  intros a b. apply (ex_RInt_ext (V := R_NormedModule) (fun x => / total * K * B * x ^ n)); [|apply power_integrable].
  intros x _. symmetry. apply flux_density_form.
Qed.

Lemma gradient_weight_integrable : forall a b, ex_RInt w a b.
Proof.
  intros a b. apply (ex_RInt_ext (V := R_NormedModule) (fun x => / total * B * H * x ^ (n + m))); [|apply power_integrable].
  intros x _. symmetry. apply weight_density_form.
Qed.

Lemma constant_positive : 0 < / total.
Proof. now apply Rinv_0_lt_compat. Qed.

Lemma gradient_flux_nonneg : forall x, 0 <= x <= 1 -> 0 <= g x.
Proof.
  intros x Hx. unfold gradient_flux_density. assert (C := constant_positive).
  assert (0 <= x ^ n) by (apply pow_le; lra). repeat apply Rmult_le_pos; lra.
Qed.

Lemma gradient_weight_is_ratio_times_flux : forall x, 0 <= x <= 1 -> w x = ratio x * g x.
Proof. intros x _. unfold gradient_weight_density, gradient_flux_density. field. lra. Qed.

Lemma gradient_ratio_increasing : forall x y, 0 <= x -> x <= y -> y <= 1 -> ratio x <= ratio y.
Proof.
  intros x y Hx Hxy Hy. apply Rmult_le_compat_l; [left; now apply Rdiv_lt_0_compat|].
  apply pow_incr. lra.
Qed.

Lemma gradient_ratio_positive : forall x, 0 < x <= 1 -> 0 < ratio x.
Proof.
  intros x Hx. apply Rmult_lt_0_compat; [now apply Rdiv_lt_0_compat|]. apply pow_lt. lra.
Qed.

(* For a straight cut it is the gain of GradientPatch.v. *)
Theorem straight_cut_has_gradient_patch_gain : forall c, 0 <= c <= 1 ->
  gradient_division_gain total B H K w_j n m (before c) = gradient_patch_gain total B H K w_j n m c.
Proof.
  intros c Hc. unfold gradient_division_gain, division_gain. cbv zeta.
  destruct (complement_is_share g w (gradient_flux_integrable 0 1) (gradient_weight_integrable 0 1) (before c)
    (straight_cut_is_share g w (gradient_flux_integrable 0 1) (gradient_weight_integrable 0 1) c Hc)) as [_ [Ef Ew]].
  rewrite Ef, Ew. unfold divided_flux, divided_weight, total_flux, total_weight.
  rewrite (proj2 (integral_before g c (gradient_flux_integrable 0 1) Hc)).
  rewrite (proj2 (integral_before w c (gradient_weight_integrable 0 1) Hc)).
  rewrite (integral_split g c (gradient_flux_integrable 0 1) Hc), (integral_split w c (gradient_weight_integrable 0 1) Hc).
  replace (RInt g 0 c + RInt g c 1 - RInt g 0 c) with (RInt g c 1)
    by (set (X := RInt g 0 c); set (Y := RInt g c 1); clearbody X Y; simpl in X, Y; lra).
  replace (RInt w 0 c + RInt w c 1 - RInt w 0 c) with (RInt w c 1)
    by (set (X := RInt w 0 c); set (Y := RInt w c 1); clearbody X Y; simpl in X, Y; lra).
  rewrite <- (integral_split g c (gradient_flux_integrable 0 1) Hc), <- (integral_split w c (gradient_weight_integrable 0 1) Hc).
  assert (Fl : forall a b, RInt g a b = gradient_strip_flux total B K n a b).
  { intros a b. unfold gradient_strip_flux, Rdiv. rewrite Rmult_comm.
    apply (riemann_integral_of_multiple (/ total) (fun x => K * (B * x ^ n))), multiple_integrable, power_integrable. }
  assert (We : forall a b, RInt w a b = gradient_strip_weight total B H n m a b).
  { intros a b. unfold gradient_strip_weight, Rdiv. rewrite Rmult_comm.
    apply (riemann_integral_of_multiple (/ total) (fun x => B * x ^ n * (H * x ^ m))).
    apply (ex_RInt_ext (V := R_NormedModule) (fun x => B * H * x ^ (n + m))); [|apply power_integrable].
    intros x _. rewrite pow_add. simpl. ring. }
  rewrite !Fl, !We. reflexivity.
Qed.

(* The best cut l of the objective of 4.2 is the best of all divisions. *)
Theorem no_division_gains_more_than_best_cut : forall best s, (1 <= m)%nat ->
  only_maximiser (cut_objective n m) 0 1 best ->
  share_of_strips (gradient_flux_density total B K n) (gradient_weight_density total B H n m) s ->
  gradient_division_gain total B H K w_j n m s <= gradient_patch_gain total B H K w_j n m best.
Proof.
  intros best s Hm [Hb Best] Hs.
  assert (NN : 0 <= gradient_patch_gain total B H K w_j n m best).
  { rewrite <- straight_cut_has_gradient_patch_gain by lra.
    apply (division_gain_nonneg g w ratio w_j (gradient_flux_integrable 0 1) (gradient_weight_integrable 0 1)
      gradient_flux_nonneg gradient_weight_is_ratio_times_flux gradient_ratio_increasing gradient_ratio_positive
      receiver_weight_positive).
    apply straight_cut_is_share; try apply gradient_flux_integrable; try apply gradient_weight_integrable. lra. }
  destruct (no_division_gains_more_than_straight_cuts g w ratio w_j (gradient_flux_integrable 0 1)
    (gradient_weight_integrable 0 1) gradient_flux_nonneg gradient_weight_is_ratio_times_flux
    gradient_ratio_increasing gradient_ratio_positive receiver_weight_positive s Hs) as [c [Hc [Sc L]]].
  apply Rle_trans with (1 := L).
  change (gradient_division_gain total B H K w_j n m (before c) <= gradient_patch_gain total B H K w_j n m best).
  assert (edges := cut_at_edge_gains_nothing g w ratio w_j (gradient_flux_integrable 0 1) (gradient_weight_integrable 0 1)
    gradient_flux_nonneg gradient_weight_is_ratio_times_flux gradient_ratio_increasing gradient_ratio_positive
    receiver_weight_positive).
  destruct (Req_dec c 0) as [E0|E0]; [|destruct (Req_dec c 1) as [E1|E1]].
  - unfold gradient_division_gain. rewrite edges by auto. exact NN.
  - unfold gradient_division_gain. rewrite edges by auto. exact NN.
  - rewrite straight_cut_has_gradient_patch_gain by exact Hc.
    rewrite !gain_of_gradient_patch by (assumption || lra).
    destruct (Req_dec c best) as [->|N]; [lra|].
    apply Rmult_le_compat_l; [|left; apply Best; [lra|exact N]].
    assert (0 <= gradient_strip_flux total B K n 0 1); [|lra].
    unfold gradient_strip_flux. apply Rmult_le_pos; [|left; apply constant_positive].
    apply RInt_ge_0; [lra|apply multiple_integrable, power_integrable|]. intros x Hx.
    assert (0 <= x ^ n) by (apply pow_le; lra). repeat apply Rmult_le_pos; lra.
Qed.
End Power.

(* The printed expression (irradiance x) and the one for an irradiance that grows as the radiosity (x^n). *)
Theorem no_division_gains_more_than_printed_cut : forall total B H K w_j n best s,
  0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> only_maximiser (printed_objective n) 0 1 best ->
  share_of_strips (gradient_flux_density total B K n) (gradient_weight_density total B H n 1) s ->
  gradient_division_gain total B H K w_j n 1 s <= gradient_patch_gain total B H K w_j n 1 best.
Proof.
  intros total B H K w_j n best s Ht HB HH HK Hj Best Hs. apply no_division_gains_more_than_best_cut; try assumption; [lia|].
  apply maximiser_only_depends_on_values with (printed_objective n); [|exact Best].
  intros x _. apply printed_objective_has_irradiance_exponent_1.
Qed.

Theorem no_division_gains_more_than_corrected_cut : forall total B H K w_j n best s, (1 <= n)%nat ->
  0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> only_maximiser (corrected_objective n) 0 1 best ->
  share_of_strips (gradient_flux_density total B K n) (gradient_weight_density total B H n n) s ->
  gradient_division_gain total B H K w_j n n s <= gradient_patch_gain total B H K w_j n n best.
Proof.
  intros total B H K w_j n best s Hn Ht HB HH HK Hj Best Hs. apply no_division_gains_more_than_best_cut; try assumption.
  apply maximiser_only_depends_on_values with (corrected_objective n); [|exact Best].
  intros x _. apply corrected_objective_has_irradiance_exponent_n.
Qed.
