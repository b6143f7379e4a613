(* The closed form used for fig. 2 and fig. 3 is the form-factor integral: for a floor and a wall that meet at right angles in a
   common edge of length 1, the integral of cos cos' / (PI r^2) over floor and wall is exchange_area X Z; and for the part
   [0, t] of a unit floor, t measured along the edge, and the whole unit wall it is orthogonal_exchange t. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import CutGain PerpendicularSquares OrthogonalCut DepthIntegral.
Open Scope R_scope.

(* The edge is the y-axis. The floor point is (x, y, 0) with normal along z, the wall point (0, y', z) with normal along x; so
   the cosines are z / r and x / r. *)
Definition distance_between (x y y' z : R) : R := sqrt (x ^ 2 + (y - y') ^ 2 + z ^ 2).
Definition point_to_point_form_factor (x y y' z : R) : R :=
  let r := distance_between x y y' z in (z / r) * (x / r) / (PI * r ^ 2).

(* Floor of depth X, of which the part 0 <= y <= t is taken; wall of height Z, 0 <= y' <= 1. *)
Definition over_wall_width (x y z : R) : R := RInt (fun y' => point_to_point_form_factor x y y' z) 0 1.
Definition over_widths (t x z : R) : R := RInt (fun y => over_wall_width x y z) 0 t.
Definition over_height (t Z x : R) : R := RInt (fun z => over_widths t x z) 0 Z.

(* An antiderivative of 1 / (u + v^2)^2, and one of that; s^2 = u. *)
Definition integrated_once (u v : R) : R := v / (2 * u * (u + v ^ 2)) + atan (v / sqrt u) / (2 * (sqrt u * u)).
Definition integrated_twice (u v : R) : R := v * atan (v / sqrt u) / (2 * (sqrt u * u)).

Lemma once_slope (u v : R) : 0 < u -> is_derive (integrated_once u) v (1 / (u + v ^ 2) ^ 2).
Proof.
  intros H. assert (Hs : sqrt u * sqrt u = u) by (apply sqrt_sqrt; lra). assert (Hp : 0 < sqrt u) by (now apply sqrt_lt_R0).
  assert (0 < u + v ^ 2) by nra. unfold integrated_once. auto_derive.
  - repeat split; nra.
  - set (s := sqrt u) in *. rewrite <- Hs in *. field. repeat split; nra.
Qed.

Lemma twice_slope (u v : R) : 0 < u -> is_derive (integrated_twice u) v (integrated_once u v).
Proof.
  intros H. assert (Hs : sqrt u * sqrt u = u) by (apply sqrt_sqrt; lra). assert (Hp : 0 < sqrt u) by (now apply sqrt_lt_R0).
  assert (0 < u + v ^ 2) by nra. unfold integrated_twice, integrated_once. auto_derive.
  - repeat split; nra.
  - set (s := sqrt u) in *. change (v * / s) with (v / s). generalize (atan (v / s)). intros A.
    rewrite <- Hs in *. field. repeat split; nra.
Qed.

Lemma shifted_slope (g : R -> R) (g' a y : R) : is_derive g (y - a) g' -> is_derive (fun y => g (y - a)) y g'.
Proof.
  intros H. eapply slope_by_formula.
  { apply (is_derive_comp g (fun y => y - a) y g' 1); [exact H | auto_derive; trivial; ring]. }
  unfold scal; simpl; unfold mult; simpl; ring.
Qed.

(* Over the width of the wall. *)
Lemma integral_over_wall_width (x y z : R) : 0 < x ->
  is_RInt (fun y' => point_to_point_form_factor x y y' z) 0 1
    (x * z / PI * (integrated_once (x ^ 2 + z ^ 2) y - integrated_once (x ^ 2 + z ^ 2) (y - 1))).
Proof.
  intros Hx. assert (P : 0 < x ^ 2 + z ^ 2) by nra. set (u := x ^ 2 + z ^ 2) in *. pose proof PI_RGT_0.
  apply (integral_of_equal_functions (fun y' => x * z / PI * (1 / (u + (y - y') ^ 2) ^ 2))); [lra| |].
  { intros y' _. unfold point_to_point_form_factor, distance_between. cbv zeta.
    replace (x ^ 2 + (y - y') ^ 2 + z ^ 2) with (u + (y - y') ^ 2) by (unfold u; ring).
    assert (Q : 0 < u + (y - y') ^ 2) by (pose proof (pow2_ge_0 (y - y')); lra).
    assert (S : sqrt (u + (y - y') ^ 2) * sqrt (u + (y - y') ^ 2) = u + (y - y') ^ 2) by (apply sqrt_sqrt; lra).
    assert (0 < sqrt (u + (y - y') ^ 2)) by (now apply sqrt_lt_R0).
    set (r := sqrt (u + (y - y') ^ 2)) in *. rewrite <- S. field. lra. }
  replace (x * z / PI * (integrated_once u y - integrated_once u (y - 1)))
    with (- (x * z / PI) * integrated_once u (y - 1) - - (x * z / PI) * integrated_once u (y - 0)) by (rewrite Rminus_0_r; ring).
  apply (integral_by_antiderivative (fun y' => - (x * z / PI) * integrated_once u (y - y'))); [lra| |].
  - intros y' _. pose proof (pow2_ge_0 (y - y')). eapply slope_by_formula.
    { apply is_derive_scal. apply (is_derive_comp (integrated_once u) (fun y' => y - y') y' (1 / (u + (y - y') ^ 2) ^ 2) (- 1));
        [apply once_slope; exact P | auto_derive; trivial; ring]. }
    unfold scal; simpl; unfold mult; simpl. field. nra.
  - intros y' _. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. pose proof (pow2_ge_0 (y - y')). simpl in *. nra.
Qed.

(* Over the part [0, t] of the floor as well: the kernels of three strips, as in lemma exchange_of_a_part_by_additivity. *)
Lemma integral_over_widths (t x z : R) : 0 <= t -> 0 < x ->
  is_RInt (fun y => over_wall_width x y z) 0 t
    (/ (2 * PI) * (depth_kernel t x z + depth_kernel 1 x z - depth_kernel (1 - t) x z)).
Proof.
  intros Ht Hx. assert (P : 0 < x ^ 2 + z ^ 2) by nra.
  apply (integral_of_equal_functions (fun y => x * z / PI * (integrated_once (x ^ 2 + z ^ 2) y - integrated_once (x ^ 2 + z ^ 2) (y - 1)))); [lra| |].
  { intros y _. symmetry. apply is_RInt_unique. now apply integral_over_wall_width. }
  set (u := x ^ 2 + z ^ 2) in *. pose proof PI_RGT_0. assert (0 < sqrt u) by (now apply sqrt_lt_R0).
  replace (/ (2 * PI) * (depth_kernel t x z + depth_kernel 1 x z - depth_kernel (1 - t) x z))
    with (x * z / PI * (integrated_twice u t - integrated_twice u (t - 1)) - x * z / PI * (integrated_twice u 0 - integrated_twice u (0 - 1))).
  2: { unfold integrated_twice, depth_kernel. fold u.
       replace ((t - 1) / sqrt u) with (- ((1 - t) / sqrt u)) by (field; lra).
       replace ((0 - 1) / sqrt u) with (- (1 / sqrt u)) by (field; lra).
       rewrite !atan_opp. field. lra. }
  apply (integral_by_antiderivative (fun y => x * z / PI * (integrated_twice u y - integrated_twice u (y - 1)))); [lra| |].
  - intros y _. apply is_derive_scal. apply slope_of_difference; [|apply shifted_slope]; apply twice_slope; exact P.
  - intros y _. apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply is_derive_scal.
    apply slope_of_difference; [|apply shifted_slope]; apply once_slope; exact P.
Qed.

Lemma depth_kernel_of_no_width (x z : R) : depth_kernel 0 x z = 0.
Proof. unfold depth_kernel, Rdiv. ring. Qed.

Lemma integral_over_height_exists (w x Z : R) : 0 <= w -> 0 < x -> 0 < Z -> ex_RInt (depth_kernel w x) 0 Z.
Proof.
  intros Hw Hx HZ. destruct (Req_dec w 0) as [->|N].
  - apply (ex_RInt_ext (fun _ => 0)); [intros z _; now rewrite depth_kernel_of_no_width | apply ex_RInt_const].
  - eexists. apply integral_over_height; lra.
Qed.

Lemma over_height_of_part (t x Z : R) : 0 <= t <= 1 -> 0 < x -> 0 < Z ->
  is_RInt (fun z => over_widths t x z) 0 Z
    (/ (2 * PI) * (RInt (depth_kernel t x) 0 Z + RInt (depth_kernel 1 x) 0 Z - RInt (depth_kernel (1 - t) x) 0 Z)).
Proof.
  intros Ht Hx HZ.
  apply (integral_of_equal_functions (fun z => / (2 * PI) * (depth_kernel t x z + depth_kernel 1 x z - depth_kernel (1 - t) x z))); [lra| |].
  { intros z _. symmetry. apply is_RInt_unique. apply integral_over_widths; lra. }
  apply (is_RInt_scal (V := R_NormedModule)). apply (is_RInt_minus (V := R_NormedModule)).
  - apply (is_RInt_plus (V := R_NormedModule)); apply (RInt_correct (V := R_CompleteNormedModule)), integral_over_height_exists; lra.
  - apply (RInt_correct (V := R_CompleteNormedModule)), integral_over_height_exists; lra.
Qed.

(* The inner integrals exist at every x > 0 (the points of the edge itself, x = 0, have measure zero and do not matter). *)
Theorem inner_integrals_exist (t x Z : R) : 0 <= t <= 1 -> 0 < x -> 0 < Z ->
  (forall y z, ex_RInt (fun y' => point_to_point_form_factor x y y' z) 0 1) /\
  (forall z, ex_RInt (fun y => RInt (fun y' => point_to_point_form_factor x y y' z) 0 1) 0 t) /\
  ex_RInt (fun z => RInt (fun y => RInt (fun y' => point_to_point_form_factor x y y' z) 0 1) 0 t) 0 Z.
Proof.
  intros Ht Hx HZ. repeat split.
  - intros y z. eexists. now apply integral_over_wall_width.
  - intros z. eexists. apply integral_over_widths; lra.
  - eexists. apply (over_height_of_part t x Z); lra.
Qed.

(* The exchange of a strip of width w >= 0, as an integral over the depths. *)
Lemma strip_integral (w X Z : R) : 0 < w -> 0 < X -> 0 < Z ->
  is_RInt (fun x => RInt (depth_kernel w x) 0 Z) 0 X (w ^ 2 * exchange_area (X / w) (Z / w) * PI).
Proof. intros Hw HX HZ. rewrite <- depths_give_closed_form by assumption. now apply integral_over_depths. Qed.

Lemma strip_integral_of_no_width (X Z : R) : 0 < X -> 0 < Z -> is_RInt (fun x => RInt (depth_kernel 0 x) 0 Z) 0 X 0.
Proof.
  intros HX HZ.
  apply (integral_of_equal_functions (fun _ => 0)); [lra| |].
  - intros x _. symmetry. apply is_RInt_unique. apply (integral_of_equal_functions (fun _ => 0)); [lra| |].
    + intros z _. now rewrite depth_kernel_of_no_width.
    + evar_last; [apply (is_RInt_const (V := R_NormedModule)) | unfold scal; simpl; unfold mult; simpl; ring].
  - evar_last; [apply (is_RInt_const (V := R_NormedModule)) | unfold scal; simpl; unfold mult; simpl; ring].
Qed.

Lemma integral_over_part (t X Z below all above : R) : 0 <= t <= 1 -> 0 < X -> 0 < Z ->
  is_RInt (fun x => RInt (depth_kernel t x) 0 Z) 0 X below ->
  is_RInt (fun x => RInt (depth_kernel 1 x) 0 Z) 0 X all ->
  is_RInt (fun x => RInt (depth_kernel (1 - t) x) 0 Z) 0 X above ->
  is_RInt (over_height t Z) 0 X (/ (2 * PI) * (below + all - above)).
Proof.
  intros Ht HX HZ Hb Ha Hc.
  apply (integral_of_equal_functions (fun x => / (2 * PI) *
    (RInt (depth_kernel t x) 0 Z + RInt (depth_kernel 1 x) 0 Z - RInt (depth_kernel (1 - t) x) 0 Z))); [lra| |].
  { intros x Hx. symmetry. apply is_RInt_unique. apply over_height_of_part; lra. }
  apply (is_RInt_scal (V := R_NormedModule)). apply (is_RInt_minus (V := R_NormedModule)); trivial.
  now apply (is_RInt_plus (V := R_NormedModule)).
Qed.

(* The closed form (Howell, C-14) is the form-factor integral. *)
Theorem exchange_area_is_the_form_factor_integral (X Z : R) : 0 < X -> 0 < Z ->
  is_RInt (fun x => RInt (fun z => RInt (fun y => RInt (fun y' =>
    point_to_point_form_factor x y y' z) 0 1) 0 1) 0 Z) 0 X (exchange_area X Z).
Proof.
  intros HX HZ. change (is_RInt (over_height 1 Z) 0 X (exchange_area X Z)).
  assert (E : is_RInt (fun x => RInt (depth_kernel 1 x) 0 Z) 0 X (exchange_area X Z * PI)).
  { evar_last; [apply strip_integral; lra|]. unfold Rdiv. rewrite Rinv_1, !Rmult_1_r. ring. }
  replace (exchange_area X Z) with (/ (2 * PI) * (exchange_area X Z * PI + exchange_area X Z * PI - 0))
    by (field; apply PI_neq0).
  apply integral_over_part; trivial; [lra|]. rewrite Rminus_diag_eq by reflexivity. apply strip_integral_of_no_width; lra.
Qed.

Theorem orthogonal_exchange_is_the_form_factor_integral (t : R) : 0 < t <= 1 ->
  is_RInt (fun x => RInt (fun z => RInt (fun y => RInt (fun y' =>
    point_to_point_form_factor x y y' z) 0 1) 0 t) 0 1) 0 1 (orthogonal_exchange t).
Proof.
  intros Ht. change (is_RInt (over_height t 1) 0 1 (orthogonal_exchange t)).
  replace (orthogonal_exchange t)
    with (/ (2 * PI) * (strip_exchange t * PI + strip_exchange 1 * PI - strip_exchange (1 - t) * PI))
    by (unfold orthogonal_exchange; field; apply PI_neq0).
  unfold strip_exchange. apply integral_over_part; try lra; try (apply strip_integral; lra).
  destruct (Req_dec t 1) as [->|N]; [|apply strip_integral; lra].
  replace (1 - 1) with 0 by ring. rewrite pow_i by lia. rewrite !Rmult_0_l. apply strip_integral_of_no_width; lra.
Qed.
