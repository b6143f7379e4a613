(* Fig. 2(b): two perpendicular unit squares with a common edge, the floor cut orthogonally to that edge. A cut in the middle
   gains exactly nothing. (That no such cut gains much: OrthogonalCutSmall.v.)
   The exchange of a part of the floor with the whole wall is obtained from the closed form of PerpendicularSquares.v by
   additivity and symmetry (lemma `exchange_of_a_part_by_additivity`); that it is the form-factor integral is proved in
   FormFactorIntegral.v. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information Enclosure CutGain PerpendicularSquares.
Open Scope R_scope.

(* Whatever the scene: a cut whose parts exchange in proportion to their areas gains nothing (all three logarithms are equal). *)
Theorem proportional_cut_gains_nothing (total_area area flux share : R) :
  cut_gain total_area area flux (share * area) (share * flux) = 0.
Proof.
  unfold cut_gain.
  replace (flux - share * flux) with ((1 - share) * flux) by ring.
  replace (area - share * area) with ((1 - share) * area) by ring.
  rewrite !xlog2_scale. ring.
Qed.

(* If the two sides of a unit square are mirror images (what the part [0, t] exchanges and what [0, 1 - t] exchanges add up to
   the whole), then a cut in the middle gains nothing. *)
Theorem mirror_symmetry_makes_the_middle_cut_useless (total_area : R) (flux : R -> R) :
  (forall t, 0 <= t <= 1 -> flux t + flux (1 - t) = flux 1) ->
  cut_gain total_area 1 (flux 1) (1/2) (flux (1/2)) = 0.
Proof.
  intros H. pose proof (H (1/2)) as E. replace (1 - 1/2) with (1/2) in E by field.
  replace (flux (1/2)) with (1/2 * flux 1) by lra. replace (1/2) with (1/2 * 1) at 1 by ring.
  apply proportional_cut_gains_nothing.
Qed.

(* Two perpendicular rectangles of depth 1 whose common edge has length w: exchange scales with the square of lengths. *)
Definition strip_exchange (w : R) : R := w ^ 2 * exchange_area (1 / w) (1 / w).

(* The part [0, t] of the floor and the whole wall, t measured along the common edge. *)
Definition orthogonal_exchange (t : R) : R := (strip_exchange t + strip_exchange 1 - strip_exchange (1 - t)) / 2.

(* Why: divide floor and wall at t into a near and a far part. Parts that face each other exchange strip_exchange of their
   width; the two crossed pairs exchange equally, being images of each other when floor and wall change places. *)
Lemma exchange_of_a_part_by_additivity (t near_near near_far far_near far_far : R) :
  near_near = strip_exchange t -> far_far = strip_exchange (1 - t) ->
  near_near + near_far + far_near + far_far = strip_exchange 1 ->
  near_far = far_near ->
  near_near + near_far = orthogonal_exchange t.
Proof. intros. unfold orthogonal_exchange. lra. Qed.

Definition orthogonal_cut_gain (t : R) : R := cut_gain 2 1 (exchange_area 1 1) t (orthogonal_exchange t).

Lemma strip_exchange_0 : strip_exchange 0 = 0.
Proof. unfold strip_exchange. ring. Qed.

Lemma strip_exchange_1 : strip_exchange 1 = exchange_area 1 1.
Proof. unfold strip_exchange. replace (1 / 1) with 1 by field. ring. Qed.

Lemma orthogonal_exchange_1 : orthogonal_exchange 1 = exchange_area 1 1.
Proof.
  unfold orthogonal_exchange. replace (1 - 1) with 0 by ring. rewrite strip_exchange_0, strip_exchange_1. field.
Qed.

Lemma orthogonal_exchange_mirrored (t : R) : orthogonal_exchange t + orthogonal_exchange (1 - t) = orthogonal_exchange 1.
Proof.
  unfold orthogonal_exchange. replace (1 - (1 - t)) with t by ring. replace (1 - 1) with 0 by ring.
  rewrite strip_exchange_0. field.
Qed.

Theorem orthogonal_cut_in_the_middle_gains_nothing : orthogonal_cut_gain (1/2) = 0.
Proof.
  unfold orthogonal_cut_gain. rewrite <- orthogonal_exchange_1.
  apply mirror_symmetry_makes_the_middle_cut_useless. intros t _. apply orthogonal_exchange_mirrored.
Qed.

(* PI times the exchange of a strip, and its first two derivatives in its width. *)
Definition strip_flux (w : R) : R :=
  2 * w * atan w - sqrt 2 * w * atan (w / sqrt 2)
  - 1 / 4 * (w ^ 2 * ln (squared_ratio w)) + 1 / 2 * ln ((w ^ 2 + 2) / (2 * (1 + w ^ 2))).
Definition strip_density (w : R) : R := 2 * atan w - sqrt 2 * atan (w / sqrt 2) - w / 2 * ln (squared_ratio w).
Definition strip_density_slope (w : R) : R := - (1 / 2) * ln (squared_ratio w).

Lemma strip_exchange_closed_form (w : R) : 0 < w -> strip_exchange w = strip_flux w / PI.
Proof.
  intros H. unfold strip_exchange, exchange_area, strip_flux, squared_ratio. cbv zeta.
  assert (0 < w ^ 2) by nra. assert (P2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (S2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  replace (sqrt ((1 / w) ^ 2 + (1 / w) ^ 2)) with (sqrt 2 / w).
  2: { symmetry. apply sqrt_lem_1; [nra | apply Rlt_le; now apply Rdiv_lt_0_compat |].
       replace (sqrt 2 / w * (sqrt 2 / w)) with (sqrt 2 * sqrt 2 / (w * w)) by (field; lra). rewrite S2. field. lra. }
  replace (1 / (1 / w)) with w by (field; lra). replace (1 / (sqrt 2 / w)) with (w / sqrt 2) by (field; lra).
  replace ((1 / w) ^ 2 * (1 + ((1 / w) ^ 2 + (1 / w) ^ 2)) / ((1 + (1 / w) ^ 2) * ((1 / w) ^ 2 + (1 / w) ^ 2)))
    with ((w ^ 2 + 2) / (2 * (1 + w ^ 2))) by (field; repeat split; nra).
  replace ((1 + (1 / w) ^ 2) * (1 + (1 / w) ^ 2) / (1 + ((1 / w) ^ 2 + (1 / w) ^ 2)))
    with (/ (w ^ 2 * (2 + w ^ 2) / (1 + w ^ 2) ^ 2)) by (field; repeat split; nra).
  rewrite ln_Rinv by (apply Rdiv_lt_0_compat; nra).
  field. split; [apply PI_neq0 | lra].
Qed.

Lemma strip_flux_slope (w : R) : 0 < w -> is_derive strip_flux w (strip_density w).
Proof.
  intros H. pose proof (squared_ratio_slope w H) as Hl.
  assert (0 < w ^ 2) by nra. assert (P2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (S2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (Ha : is_derive (fun w => 2 * w * atan w - sqrt 2 * w * atan (w / sqrt 2)) w
     (2 * atan w - sqrt 2 * atan (w / sqrt 2) + 2 * w / (1 + w ^ 2) - 2 * w / (2 + w ^ 2))).
  { auto_derive; [trivial|]. replace (w * / sqrt 2) with (w / sqrt 2) by reflexivity.
    generalize (atan (w / sqrt 2)) (atan w). intros A B. set (s := sqrt 2) in *.
    replace (2 * w / (2 + w ^ 2)) with (s * s * w / (s * s + w ^ 2)) by (now rewrite S2).
    field. repeat split; nra. }
  assert (Hq : is_derive (fun w => w ^ 2) w (2 * w)) by (auto_derive; trivial; ring).
  assert (Hc : is_derive (fun w => 1 / 2 * ln ((w ^ 2 + 2) / (2 * (1 + w ^ 2)))) w (w / (w ^ 2 + 2) - w / (1 + w ^ 2))).
  { auto_derive.
    - replace (w * (w * 1)) with (w ^ 2) by ring. repeat split; trivial; [nra|]. apply Rdiv_lt_0_compat; nra.
    - field. repeat split; nra. }
  eapply slope_by_formula.
  { refine (slope_of_sum _ _ _ _ _ (slope_of_difference _ _ _ _ _ Ha _) Hc).
    apply is_derive_scal. exact (slope_of_product _ _ _ _ _ Hq Hl). }
  unfold strip_density. field. repeat split; nra.
Qed.

Lemma strip_density_has_slope (w : R) : 0 < w -> is_derive strip_density w (strip_density_slope w).
Proof.
  intros H. pose proof (squared_ratio_slope w H) as Hl.
  assert (0 < w ^ 2) by nra. assert (P2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (S2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (Ha : is_derive (fun w => 2 * atan w - sqrt 2 * atan (w / sqrt 2)) w (2 / (1 + w ^ 2) - 2 / (2 + w ^ 2))).
  { auto_derive; [trivial|]. set (s := sqrt 2) in *.
    replace (2 / (2 + w ^ 2)) with (s * s / (s * s + w ^ 2)) by (now rewrite S2).
    field. repeat split; nra. }
  assert (Hq : is_derive (fun w => w / 2) w (1 / 2)) by (auto_derive; trivial; field).
  eapply slope_by_formula.
  { exact (slope_of_difference _ _ _ _ _ Ha (slope_of_product _ _ _ _ _ Hq Hl)). }
  unfold strip_density_slope. field. repeat split; nra.
Qed.
