(* Two perpendicular rectangles with a common edge: the closed form of what they exchange (Howell, C-14) as a definition, and
   for the unit wall its first two derivatives in the depth of the floor. That the closed form is the form-factor integral is
   proved in FormFactorIntegral.v. Used for fig. 2 and fig. 3. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information Enclosure CutGain.
Open Scope R_scope.

(* A_1 F_12 of two perpendicular rectangles with a common edge of length 1, of depth x and of depth z. *)
Definition exchange_area (x z : R) : R :=
  let S := x ^ 2 + z ^ 2 in
  let T := 1 + S in
  (x * atan (1 / x) + z * atan (1 / z) - sqrt S * atan (1 / sqrt S)
   + 1 / 4 * (ln ((1 + x ^ 2) * (1 + z ^ 2) / T)
              + x ^ 2 * ln (x ^ 2 * T / ((1 + x ^ 2) * S))
              + z ^ 2 * ln (z ^ 2 * T / ((1 + z ^ 2) * S)))) / PI.

(* The unit floor is cut at distance t from the common edge; both squares have area 1, so the scene has area 2. *)
Definition parallel_cut_gain (t : R) : R := cut_gain 2 1 (exchange_area 1 1) t (exchange_area t 1).

(* PI times the exchange of the part [0, t] with the wall, and its first two derivatives. *)
Definition squared_ratio (t : R) : R := t ^ 2 * (2 + t ^ 2) / (1 + t ^ 2) ^ 2.
Definition floor_flux (t : R) : R :=
  t * atan (1 / t) + PI / 4 - sqrt (1 + t ^ 2) * atan (1 / sqrt (1 + t ^ 2)) + t ^ 2 / 4 * ln (squared_ratio t).
Definition floor_density (t : R) : R :=
  atan (1 / t) - t / sqrt (1 + t ^ 2) * atan (1 / sqrt (1 + t ^ 2)) + t / 2 * ln (squared_ratio t).
Definition floor_density_slope (t : R) : R :=
  1 / 2 * ln (squared_ratio t) - atan (1 / sqrt (1 + t ^ 2)) / (sqrt (1 + t ^ 2) * (1 + t ^ 2)).

Lemma squared_ratio_between_0_and_1 (t : R) : 0 < t -> 0 < squared_ratio t < 1.
Proof.
  intros H. unfold squared_ratio. split.
  - apply Rdiv_lt_0_compat; nra.
  - apply (Rmult_lt_reg_r ((1 + t ^ 2) ^ 2)); [nra|]. field_simplify; nra.
Qed.

(* The form factor of the two unit squares, 0.20004. *)
Lemma squares_exchange_0_20004 : 0.20004377607 < exchange_area 1 1 < 0.20004377608.
Proof. unfold exchange_area; cbv zeta; split; interval with (i_prec 90). Qed.

(* With z = 1 two of the three logarithms cancel. *)
Lemma exchange_area_closed_form (t : R) : 0 < t -> exchange_area t 1 = floor_flux t / PI.
Proof.
  intros H. unfold exchange_area, floor_flux, squared_ratio. cbv zeta.
  assert (0 < t ^ 2) by nra.
  replace (t ^ 2 + 1 ^ 2) with (1 + t ^ 2) by ring.
  replace (1 / 1) with 1 by field. rewrite atan_1.
  assert (E : ln (1 ^ 2 * (1 + (1 + t ^ 2)) / ((1 + 1 ^ 2) * (1 + t ^ 2)))
              = - ln ((1 + t ^ 2) * (1 + 1 ^ 2) / (1 + (1 + t ^ 2)))).
  { rewrite <- ln_Rinv by (apply Rdiv_lt_0_compat; nra). f_equal. field. split; nra. }
  rewrite E.
  replace (t ^ 2 * (1 + (1 + t ^ 2)) / ((1 + t ^ 2) * (1 + t ^ 2))) with (t ^ 2 * (2 + t ^ 2) / (1 + t ^ 2) ^ 2)
    by (field; nra).
  field. apply PI_neq0.
Qed.

(* Derivatives. With s = sqrt (1 + t^2), s^2 is replaced by 1 + t^2 and the rational parts cancel. *)
Lemma squared_ratio_slope (t : R) : 0 < t ->
  is_derive (fun t => ln (squared_ratio t)) t (2 / t + 2 * t / (2 + t ^ 2) - 4 * t / (1 + t ^ 2)).
Proof.
  intros H. pose proof (squared_ratio_between_0_and_1 t H) as Hr. unfold squared_ratio in *.
  assert (0 < t ^ 2) by nra.
  auto_derive.
  - replace ((1 + t * (t * 1)) * ((1 + t * (t * 1)) * 1)) with ((1 + t ^ 2) ^ 2) by ring.
    replace (t * (t * 1)) with (t ^ 2) by ring. split; [nra | split; [exact (proj1 Hr) | trivial]].
  - field. repeat split; nra.
Qed.

Lemma slant_slope (t : R) :
  is_derive (fun t => sqrt (1 + t ^ 2) * atan (1 / sqrt (1 + t ^ 2))) t
            (t / sqrt (1 + t ^ 2) * atan (1 / sqrt (1 + t ^ 2)) - t / (2 + t ^ 2)).
Proof.
  assert (Hs : sqrt (1 + t ^ 2) * sqrt (1 + t ^ 2) = 1 + t ^ 2) by (apply sqrt_sqrt; nra).
  assert (Hp : 0 < sqrt (1 + t ^ 2)) by (apply sqrt_lt_R0; nra).
  auto_derive; [replace (t * (t * 1)) with (t ^ 2) by ring; repeat split; trivial; nra|].
  replace (1 + t * (t * 1)) with (1 + t ^ 2) by ring.
  set (s := sqrt (1 + t ^ 2)) in *. 
  replace (1 * / s) with (1 / s) by (unfold Rdiv; ring).
  generalize (atan (1 / s)); intros A.
  replace (2 + t ^ 2) with (s * s + 1) by lra.
  field. repeat split; nra.
Qed.

Lemma over_slant_slope (t : R) : 0 < t ->
  is_derive (fun t => t / sqrt (1 + t ^ 2) * atan (1 / sqrt (1 + t ^ 2))) t
            (atan (1 / sqrt (1 + t ^ 2)) / (sqrt (1 + t ^ 2) * (1 + t ^ 2)) - t ^ 2 / ((1 + t ^ 2) * (2 + t ^ 2))).
Proof.
  intros H. assert (Hs : sqrt (1 + t ^ 2) * sqrt (1 + t ^ 2) = 1 + t ^ 2) by (apply sqrt_sqrt; nra).
  assert (Hp : 0 < sqrt (1 + t ^ 2)) by (apply sqrt_lt_R0; nra).
  auto_derive; [replace (t * (t * 1)) with (t ^ 2) by ring; repeat split; trivial; nra|].
  replace (1 + t * (t * 1)) with (1 + t ^ 2) by ring.
  set (s := sqrt (1 + t ^ 2)) in *.
  replace (1 * / s) with (1 / s) by (unfold Rdiv; ring).
  generalize (atan (1 / s)); intros A.
  transitivity (A * (1 / s - t ^ 2 / (s * (s * s))) - t ^ 2 / (s * s) / (s * s + 1)).
  - field. repeat split; nra.
  - replace (t ^ 2) with (s * s - 1) by lra. field. repeat split; nra.
Qed.

Lemma floor_flux_slope (t : R) : 0 < t -> is_derive floor_flux t (floor_density t).
Proof.
  intros H. pose proof (squared_ratio_slope t H) as Hl. pose proof (slant_slope t) as Hs.
  assert (Ha : is_derive (fun t => t * atan (1 / t) + PI / 4) t (atan (1 / t) - t / (1 + t ^ 2))).
  { auto_derive; [lra|]. replace (1 * / t) with (1 / t) by (field; lra). field. split; nra. }
  assert (Hq : is_derive (fun t => t ^ 2 / 4) t (t / 2)) by (auto_derive; trivial; field).
  eapply slope_by_formula.
  { exact (slope_of_sum _ _ _ _ _ (slope_of_difference _ _ _ _ _ Ha Hs) (slope_of_product _ _ _ _ _ Hq Hl)). }
  unfold floor_density. field. assert (0 < sqrt (1 + t ^ 2)) by (apply sqrt_lt_R0; nra). repeat split; nra.
Qed.

Lemma floor_density_has_slope (t : R) : 0 < t -> is_derive floor_density t (floor_density_slope t).
Proof.
  intros H. pose proof (squared_ratio_slope t H) as Hl. pose proof (over_slant_slope t H) as Hs.
  assert (Ha : is_derive (fun t => atan (1 / t)) t (- 1 / (1 + t ^ 2))) by (auto_derive; [lra | field; split; nra]).
  assert (Hq : is_derive (fun t => t / 2) t (1 / 2)) by (auto_derive; trivial; field).
  eapply slope_by_formula.
  { exact (slope_of_sum _ _ _ _ _ (slope_of_difference _ _ _ _ _ Ha Hs) (slope_of_product _ _ _ _ _ Hq Hl)). }
  unfold floor_density_slope. field. assert (0 < sqrt (1 + t ^ 2)) by (apply sqrt_lt_R0; nra). repeat split; nra.
Qed.
