(* The exchange of two perpendicular rectangles with a common edge of length w, as an integral over the two depths:
   integrated over both widths, the kernel at distances x and z from the edge is x z w atan(w/s) / s^3 with s^2 = x^2 + z^2
   (FormFactorIntegral.v); integrated over x and z it gives w^2 PI exchange_area (X/w) (Z/w), the closed form. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import CutGain PerpendicularSquares.
Open Scope R_scope.

Lemma integral_by_antiderivative (F f : R -> R) (a b : R) : a <= b ->
  (forall x, a <= x <= b -> is_derive F x (f x)) -> (forall x, a <= x <= b -> continuous f x) ->
  is_RInt f a b (F b - F a).
Proof.
  intros H D C. apply (is_RInt_derive F f a b); intros x; rewrite Rmin_left, Rmax_right by assumption; auto.
Qed.

Lemma integral_of_equal_functions (f g : R -> R) (a b l : R) : a <= b ->
  (forall x, a < x < b -> f x = g x) -> is_RInt f a b l -> is_RInt g a b l.
Proof. intros H E. apply is_RInt_ext. intros x. rewrite Rmin_left, Rmax_right by assumption. apply E. Qed.

(* A function depth_potential of u = x^2 + z^2 with 4 x z depth_potential''(u) = x z w atan(w/s) / s^3. *)
Definition depth_potential (w u : R) : R :=
  1 / 4 * (u * ln ((w ^ 2 + u) / u) - w ^ 2 * ln (w ^ 2 + u)) - w * (sqrt u * atan (w / sqrt u)).
Definition depth_potential' (w u : R) : R := 1 / 4 * ln ((w ^ 2 + u) / u) - w * atan (w / sqrt u) / (2 * sqrt u).
Definition depth_potential'' (w u : R) : R := w * atan (w / sqrt u) / (4 * (sqrt u * u)).

Lemma depth_potential_slope (w u : R) : 0 < w -> 0 < u -> is_derive (depth_potential w) u (depth_potential' w u).
Proof.
  intros Hw H. assert (Hs : sqrt u * sqrt u = u) by (apply sqrt_sqrt; lra). assert (Hp : 0 < sqrt u) by (now apply sqrt_lt_R0).
  assert (0 < w ^ 2) by nra. unfold depth_potential, depth_potential'. auto_derive.
  - assert (0 < (w ^ 2 + u) * / u) by (apply Rdiv_lt_0_compat; lra). simpl in *. repeat split; try lra.
  - set (s := sqrt u) in *. change (w * / s) with (w / s). change ((w * (w * 1) + u) * / u) with ((w ^ 2 + u) / u).
    generalize (ln ((w ^ 2 + u) / u)) (ln (w * (w * 1) + u)) (atan (w / s)). intros L1 L2 A.
    rewrite <- Hs. field. repeat split; nra.
Qed.

Lemma depth_potential'_slope (w u : R) : 0 < w -> 0 < u -> is_derive (depth_potential' w) u (depth_potential'' w u).
Proof.
  intros Hw H. assert (Hs : sqrt u * sqrt u = u) by (apply sqrt_sqrt; lra). assert (Hp : 0 < sqrt u) by (now apply sqrt_lt_R0).
  assert (0 < w ^ 2) by nra. unfold depth_potential', depth_potential''. auto_derive.
  - assert (0 < (w ^ 2 + u) * / u) by (apply Rdiv_lt_0_compat; lra). simpl in *. repeat split; try lra.
  - set (s := sqrt u) in *. change (w * / s) with (w / s).
    generalize (atan (w / s)). intros A.
    rewrite <- Hs. field. repeat split; nra.
Qed.

(* Over z, for fixed x > 0. *)
Definition depth_kernel (w x z : R) : R :=
  x * z * (w * atan (w / sqrt (x ^ 2 + z ^ 2)) / (sqrt (x ^ 2 + z ^ 2) * (x ^ 2 + z ^ 2))).

Lemma integral_over_height (w x Z : R) : 0 < w -> 0 < x -> 0 < Z ->
  is_RInt (depth_kernel w x) 0 Z (2 * x * depth_potential' w (x ^ 2 + Z ^ 2) - 2 * x * depth_potential' w (x ^ 2)).
Proof.
  intros Hw Hx HZ.
  replace (2 * x * depth_potential' w (x ^ 2)) with (2 * x * depth_potential' w (x ^ 2 + 0 ^ 2)) by (f_equal; f_equal; ring).
  apply (integral_by_antiderivative (fun z => 2 * x * depth_potential' w (x ^ 2 + z ^ 2))); [lra| |].
  - intros z Hz. assert (P : 0 < x ^ 2 + z ^ 2) by nra. eapply slope_by_formula.
    + apply is_derive_scal. apply (is_derive_comp (depth_potential' w) (fun z => x ^ 2 + z ^ 2)); [apply depth_potential'_slope; assumption|].
      auto_derive; [trivial | reflexivity].
    + unfold depth_kernel, depth_potential'', scal; simpl; unfold mult; simpl.
      replace (x * (x * 1) + z * (z * 1)) with (x ^ 2 + z ^ 2) by ring.
      assert (0 < sqrt (x ^ 2 + z ^ 2)) by (now apply sqrt_lt_R0).
      set (u := x ^ 2 + z ^ 2) in *. field. lra.
  - intros z Hz. assert (P : 0 < x ^ 2 + z ^ 2) by nra. apply (ex_derive_continuous (V := R_NormedModule)).
    assert (0 < sqrt (x ^ 2 + z ^ 2)) by (now apply sqrt_lt_R0).
    unfold depth_kernel. auto_derive. replace (x * (x * 1) + z * (z * 1)) with (x ^ 2 + z ^ 2) by ring.
    repeat split; nra.
Qed.

(* x ln (x^2), continued by 0, is continuous and is (but for a polynomial) the derivative of x^2 ln (x^2), also at 0. *)
Lemma x_log_bound (x : R) : Rabs x <= 1 -> Rabs (x * ln (x ^ 2)) <= 4 * sqrt (Rabs x).
Proof.
  intros H. destruct (Req_dec x 0) as [->|N].
  { rewrite Rmult_0_l, Rabs_R0. pose proof (sqrt_pos 0). lra. }
  assert (P : 0 < Rabs x) by (now apply Rabs_pos_lt). rewrite Rabs_mult.
  set (r := sqrt (Rabs x)). assert (Hr : r * r = Rabs x) by (apply sqrt_sqrt; lra).
  assert (Pr : 0 < r) by (now apply sqrt_lt_R0).
  replace (ln (x ^ 2)) with (4 * ln r).
  2: { replace (x ^ 2) with (Rabs x * Rabs x) by (rewrite <- Rabs_mult, Rabs_right; nra).
       rewrite <- Hr, !ln_mult by nra. ring. }
  assert (r <= 1) by (apply Rnot_lt_le; intro; nra).
  assert (L0 : ln r <= 0).
  { destruct (Req_dec r 1) as [->|]; [rewrite ln_1; lra|]. rewrite <- ln_1. apply Rlt_le, ln_increasing; lra. }
  assert (L1 : - ln r <= / r - 1).
  { rewrite <- ln_Rinv by assumption. pose proof (exp_ineq1_le (ln (/ r))) as X. rewrite exp_ln in X; [lra|].
    now apply Rinv_0_lt_compat. }
  rewrite (Rabs_left1 (4 * ln r)) by lra. rewrite <- Hr.
  assert (r * / r = 1) by (apply Rinv_r; lra). nra.
Qed.

Lemma x_log_continuous (x : R) : continuous (fun x => x * ln (x ^ 2)) x.
Proof.
  destruct (Req_dec x 0) as [->|N].
  - apply continuity_pt_filterlim. intros eps He. exists (Rmin 1 ((eps / 5) ^ 2)). split.
    + apply Rmin_glb_lt; nra.
    + intros y [_ Hy]. simpl in *. unfold R_dist in *. rewrite Rminus_0_r in Hy. rewrite Rmult_0_l, Rminus_0_r.
      replace (y * (y * 1)) with (y ^ 2) by ring.
      assert (H1 : Rabs y < 1) by (eapply Rlt_le_trans; [exact Hy | apply Rmin_l]).
      assert (H2 : Rabs y < (eps / 5) ^ 2) by (eapply Rlt_le_trans; [exact Hy | apply Rmin_r]).
      assert (H3 : sqrt (Rabs y) <= eps / 5).
      { rewrite <- (sqrt_pow2 (eps / 5)) by lra. apply sqrt_le_1_alt. lra. }
      pose proof (x_log_bound y). lra.
  - apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. nra.
Qed.

Lemma x2_log_slope (x : R) : is_derive (fun x => x ^ 2 * ln (x ^ 2)) x (2 * (x * ln (x ^ 2)) + 2 * x).
Proof.
  destruct (Req_dec x 0) as [->|N].
  - apply is_derive_Reals. intros eps He.
    destruct (proj2 (continuity_pt_filterlim _ _) (x_log_continuous 0) eps He) as [d [Hd Hc]].
    exists (mkposreal d Hd). intros h Hh Hhd. simpl in Hhd.
    specialize (Hc h). simpl in Hc. unfold R_dist in Hc. rewrite Rmult_0_l, !Rminus_0_r in Hc.
    replace (((0 + h) ^ 2 * ln ((0 + h) ^ 2) - 0 ^ 2 * ln (0 ^ 2)) / h - (2 * (0 * ln (0 ^ 2)) + 2 * 0))
      with (h * ln (h * (h * 1))).
    2: { replace ((0 + h) ^ 2) with (h * (h * 1)) by ring. replace (0 ^ 2) with 0 by ring. field. exact Hh. }
    apply Hc. split; [split; [exact I | intro; apply Hh; now symmetry] | exact Hhd].
  - assert (0 < x ^ 2) by nra. auto_derive; [nra|].
    replace (ln (x * (x * 1))) with (ln (x ^ 2)) by (f_equal; ring). field. nra.
Qed.

(* Over x: for u = x^2 the function depth_potential and its slope are continued to x = 0. *)
Definition at_edge (w x : R) : R :=
  1 / 4 * ((x ^ 2 - w ^ 2) * ln (w ^ 2 + x ^ 2)) - 1 / 4 * (x ^ 2 * ln (x ^ 2)) - w * (x * (PI / 2 - atan (x / w))).
Definition at_edge' (w x : R) : R :=
  1 / 2 * (x * ln (w ^ 2 + x ^ 2)) - 1 / 2 * (x * ln (x ^ 2)) - w * (PI / 2 - atan (x / w)).

Lemma at_edge_is_depth_potential (w x : R) : 0 < w -> 0 < x -> at_edge w x = depth_potential w (x ^ 2) /\ at_edge' w x = 2 * x * depth_potential' w (x ^ 2).
Proof.
  intros Hw Hx. unfold at_edge, at_edge', depth_potential, depth_potential'. rewrite sqrt_pow2 by lra.
  assert (E : atan (w / x) = PI / 2 - atan (x / w)).
  { replace (w / x) with (/ (x / w)) by (field; lra). apply atan_inv. now apply Rdiv_lt_0_compat. }
  rewrite E, ln_div by nra. split; field; lra.
Qed.

Lemma at_edge_slope (w x : R) : 0 < w -> is_derive (at_edge w) x (at_edge' w x).
Proof.
  intros Hw. assert (0 < w ^ 2) by nra. assert (0 <= x ^ 2) by nra.
  assert (A : is_derive (fun x => 1 / 4 * ((x ^ 2 - w ^ 2) * ln (w ^ 2 + x ^ 2))) x
                (1 / 2 * (x * ln (w ^ 2 + x ^ 2)) + x * (x ^ 2 - w ^ 2) / (2 * (w ^ 2 + x ^ 2)))).
  { auto_derive; [nra|]. replace (w * (w * 1) + x * (x * 1)) with (w ^ 2 + x ^ 2) by ring. field. nra. }
  assert (B : is_derive (fun x => 1 / 4 * (x ^ 2 * ln (x ^ 2))) x (1 / 4 * (2 * (x * ln (x ^ 2)) + 2 * x))).
  { apply is_derive_scal. apply x2_log_slope. }
  assert (C : is_derive (fun x => w * (x * (PI / 2 - atan (x / w)))) x
                (w * (PI / 2 - atan (x / w)) - w ^ 2 * x / (w ^ 2 + x ^ 2))).
  { auto_derive; [trivial|]. change (x * / w) with (x / w). generalize (atan (x / w)). intros T. field. split; nra. }
  unfold at_edge. eapply slope_by_formula.
  { exact (slope_of_difference _ _ _ _ _ (slope_of_difference _ _ _ _ _ A B) C). }
  unfold at_edge'. field. nra.
Qed.

Lemma at_edge'_continuous (w x : R) : 0 < w -> continuous (at_edge' w) x.
Proof.
  intros Hw. assert (0 < w ^ 2) by nra. unfold at_edge'.
  apply (continuous_minus (V := R_NormedModule) (fun x => 1 / 2 * (x * ln (w ^ 2 + x ^ 2)) - 1 / 2 * (x * ln (x ^ 2)))).
  - apply (continuous_minus (V := R_NormedModule)).
    + apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. nra.
    + apply (continuous_scal_r (V := R_NormedModule) (1 / 2)). apply x_log_continuous.
  - apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. trivial.
Qed.

Lemma integral_over_depths (w X Z : R) : 0 < w -> 0 < X -> 0 < Z ->
  is_RInt (fun x => RInt (depth_kernel w x) 0 Z) 0 X
    (depth_potential w (X ^ 2 + Z ^ 2) - depth_potential w (X ^ 2) - depth_potential w (Z ^ 2) - 1 / 4 * (w ^ 2 * ln (w ^ 2))).
Proof.
  intros Hw HX HZ.
  apply (integral_of_equal_functions (fun x => 2 * x * depth_potential' w (x ^ 2 + Z ^ 2) - at_edge' w x)); [lra| |].
  { intros x Hx. symmetry.
    rewrite (proj2 (at_edge_is_depth_potential w x Hw (proj1 Hx))). apply is_RInt_unique. apply integral_over_height; lra. }
  replace (depth_potential w (X ^ 2 + Z ^ 2) - depth_potential w (X ^ 2) - depth_potential w (Z ^ 2) - 1 / 4 * (w ^ 2 * ln (w ^ 2)))
    with ((depth_potential w (X ^ 2 + Z ^ 2) - at_edge w X) - (depth_potential w (0 ^ 2 + Z ^ 2) - at_edge w 0)).
  2: { rewrite (proj1 (at_edge_is_depth_potential w X Hw HX)). unfold at_edge.
       replace (0 ^ 2 + Z ^ 2) with (Z ^ 2) by ring. replace (w ^ 2 + 0 ^ 2) with (w ^ 2) by ring. ring. }
  apply (integral_by_antiderivative (fun x => depth_potential w (x ^ 2 + Z ^ 2) - at_edge w x)); [lra| |].
  - intros x Hx. apply slope_of_difference; [|now apply at_edge_slope].
    assert (P : 0 < x ^ 2 + Z ^ 2) by nra. eapply slope_by_formula.
    + apply (is_derive_comp (depth_potential w) (fun x => x ^ 2 + Z ^ 2)); [apply depth_potential_slope; assumption|]. auto_derive; [trivial | reflexivity].
    + unfold scal; simpl; unfold mult; simpl. ring.
  - intros x Hx. apply (continuous_minus (V := R_NormedModule) (fun x => 2 * x * depth_potential' w (x ^ 2 + Z ^ 2))).
    + apply (ex_derive_continuous (V := R_NormedModule)). assert (P : 0 < x ^ 2 + Z ^ 2) by nra.
      eexists. apply (slope_of_product (fun x => 2 * x) (fun x => depth_potential' w (x ^ 2 + Z ^ 2)) x 2).
      * auto_derive; [trivial | ring].
      * apply (is_derive_comp (depth_potential' w) (fun x => x ^ 2 + Z ^ 2)); [apply depth_potential'_slope; assumption|].
        auto_derive; [trivial | reflexivity].
    + now apply at_edge'_continuous.
Qed.

(* The value is the closed form. *)
Lemma depths_give_closed_form (w X Z : R) : 0 < w -> 0 < X -> 0 < Z ->
  depth_potential w (X ^ 2 + Z ^ 2) - depth_potential w (X ^ 2) - depth_potential w (Z ^ 2) - 1 / 4 * (w ^ 2 * ln (w ^ 2))
  = w ^ 2 * exchange_area (X / w) (Z / w) * PI.
Proof.
  intros Hw HX HZ. unfold exchange_area, depth_potential. cbv zeta.
  assert (W2 : 0 < w ^ 2) by nra. assert (X2 : 0 < X ^ 2) by nra. assert (Z2 : 0 < Z ^ 2) by nra.
  rewrite !sqrt_pow2 by lra.
  assert (S : sqrt ((X / w) ^ 2 + (Z / w) ^ 2) = sqrt (X ^ 2 + Z ^ 2) / w).
  { replace ((X / w) ^ 2 + (Z / w) ^ 2) with ((X ^ 2 + Z ^ 2) / w ^ 2) by (field; lra).
    rewrite sqrt_div_alt, sqrt_pow2 by lra. reflexivity. }
  rewrite S. assert (P : 0 < sqrt (X ^ 2 + Z ^ 2)) by (apply sqrt_lt_R0; lra).
  replace (1 / (X / w)) with (w / X) by (field; lra). replace (1 / (Z / w)) with (w / Z) by (field; lra).
  replace (1 / (sqrt (X ^ 2 + Z ^ 2) / w)) with (w / sqrt (X ^ 2 + Z ^ 2)) by (field; lra).
  replace ((1 + (X / w) ^ 2) * (1 + (Z / w) ^ 2) / (1 + ((X / w) ^ 2 + (Z / w) ^ 2)))
    with ((w ^ 2 + X ^ 2) * (w ^ 2 + Z ^ 2) / (w ^ 2 * (w ^ 2 + (X ^ 2 + Z ^ 2)))) by (field; repeat split; nra).
  replace ((X / w) ^ 2 * (1 + ((X / w) ^ 2 + (Z / w) ^ 2)) / ((1 + (X / w) ^ 2) * ((X / w) ^ 2 + (Z / w) ^ 2)))
    with (X ^ 2 * (w ^ 2 + (X ^ 2 + Z ^ 2)) / ((w ^ 2 + X ^ 2) * (X ^ 2 + Z ^ 2))) by (field; repeat split; nra).
  replace ((Z / w) ^ 2 * (1 + ((X / w) ^ 2 + (Z / w) ^ 2)) / ((1 + (Z / w) ^ 2) * ((X / w) ^ 2 + (Z / w) ^ 2)))
    with (Z ^ 2 * (w ^ 2 + (X ^ 2 + Z ^ 2)) / ((w ^ 2 + Z ^ 2) * (X ^ 2 + Z ^ 2))) by (field; repeat split; nra).
  rewrite !ln_div, !ln_mult by (try apply Rmult_lt_0_compat; lra).
  set (s := sqrt (X ^ 2 + Z ^ 2)) in *.
  generalize (ln (w ^ 2)) (ln (X ^ 2)) (ln (Z ^ 2)) (ln (X ^ 2 + Z ^ 2)) (ln (w ^ 2 + X ^ 2)) (ln (w ^ 2 + Z ^ 2))
    (ln (w ^ 2 + (X ^ 2 + Z ^ 2))) (atan (w / X)) (atan (w / Z)) (atan (w / s)).
  intros. field. split; [lra | apply PI_neq0].
Qed.
