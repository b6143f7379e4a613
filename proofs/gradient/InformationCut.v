(* The mutual information cut of section 4.2 for a power-law patch: with flux share l^p and weight share l^(p+k) on one side
   of the cut l, p > 0 and k > 0 real, the gain rises up to exactly one cut inside (0, 1) and falls after it. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Information Stationarity Extremum LambdaEquation DensityRatio.
Open Scope R_scope.

(* The gain per unit of flux, xlog2 p1 w1 + xlog2 p2 w2 with shares p1 + p2 = 1 and w1 + w2 = 1. *)
Definition power_law_gain (p k l : R) : R :=
  two_sided_information 1 1 (Rpower l p) (Rpower l (p + k)).

(* The derivative of the gain, up to a positive factor. *)
Definition power_law_slope (p k l : R) : R :=
  - ln (density_ratio p k l) - (p + k) / p * (1 - density_ratio p k l).

(* In the form of the paper; k = 1 is the printed expression. *)
Theorem power_law_gain_closed_form : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  power_law_gain p k l =
  k * Rpower l p * log2 (1 / l) + (1 - Rpower l p) * log2 ((1 - Rpower l p) / (1 - Rpower l (p + k))).
Proof.
  intros p k l Hp Hk Hl; unfold power_law_gain, two_sided_information, xlog2.
  pose proof (power_between_0_and_1 p l Hp Hl) as P; pose proof (power_between_0_and_1 k l Hk Hl) as K.
  destruct (Req_EM_T (Rpower l p) 0); [lra|]; destruct (Req_EM_T (1 - Rpower l p) 0); [lra|].
  f_equal; rewrite Rpower_plus; replace (Rpower l p / (Rpower l p * Rpower l k)) with (/ Rpower l k) by (field; lra).
  pose proof ln_2_positive; unfold log2; rewrite ln_Rinv by lra; unfold Rdiv at 3; rewrite Rmult_1_l, ln_Rinv by lra.
  replace (ln (Rpower l k)) with (k * ln l) by (unfold Rpower; rewrite ln_exp; reflexivity); field; lra.
Qed.

(* Stationarity.v with G = l^p and W = l^(p+k): W' / G' is (p + k) / p times the inverse of the near density. *)
Theorem derivative_of_power_law_gain : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  is_derive (power_law_gain p k) l (p * Rpower l p / l / ln 2 * power_law_slope p k l).
Proof.
  intros p k l Hp Hk Hl.
  pose proof (power_between_0_and_1 p l Hp Hl) as P; pose proof (power_between_0_and_1 k l Hk Hl) as K.
  pose proof (power_between_0_and_1 (p + k) l ltac:(lra) Hl) as PK.
  pose proof (density_ratio_between_0_and_1 p k l Hp Hk Hl) as Y.
  pose proof (derivative_of_two_sided_information (fun x => Rpower x p) (fun x => Rpower x (p + k)) 1 1 l
    _ _ P PK (derivative_of_power p l ltac:(lra)) (derivative_of_power (p + k) l ltac:(lra))) as D.
  cbv beta zeta in D.
  assert (E : Rpower l p / Rpower l (p + k) / ((1 - Rpower l p) / (1 - Rpower l (p + k))) = / density_ratio p k l).
  { unfold density_ratio; rewrite Rpower_plus in *; field; lra. }
  rewrite E, ln_Rinv in D by lra.
  pose proof ln_2_positive as L2.
  match type of D with is_derive _ _ ?d => replace (p * Rpower l p / l / ln 2 * power_law_slope p k l) with d; [exact D|] end.
  unfold power_law_slope; generalize (ln (density_ratio p k l)); intro s.
  unfold density_ratio; rewrite Rpower_plus in *; field; repeat split; lra.
Qed.

(* With lambda = - ln (density ratio) the slope is positive while lambda is above its root, and lambda falls while l grows. *)
Theorem power_law_slope_changes_sign_once : forall p k, 0 < p -> 0 < k ->
  exists c, 0 < c < 1 /\ power_law_slope p k c = 0 /\
    (forall l, 0 < l < c -> 0 < power_law_slope p k l) /\ (forall l, c < l < 1 -> power_law_slope p k l < 0).
Proof.
  intros p k Hp Hk; set (q := (p + k) / p).
  assert (Hq : 1 < q).
  { unfold q; replace ((p + k) / p) with (1 + k / p) by (field; lra).
    pose proof (Rdiv_lt_0_compat k p Hk Hp); lra. }
  destruct (lambda_equation_has_one_positive_root q Hq) as [r [Hr [Er _]]].
  assert (Lq : 0 < ln q) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (S : forall l, 0 < l < 1 -> power_law_slope p k l =
    (lambda_quotient (- ln (density_ratio p k l)) - q) * (1 - density_ratio p k l)
    /\ 0 < - ln (density_ratio p k l)).
  { intros l Hl; pose proof (density_ratio_between_0_and_1 p k l Hp Hk Hl) as Y.
    unfold power_law_slope, lambda_quotient; fold q; rewrite Ropp_involutive, exp_ln by lra.
    split; [field; lra|].
    enough (ln (density_ratio p k l) < 0) by lra; rewrite <- ln_1; apply ln_increasing; lra. }
  destruct (density_ratio_takes_every_value_below_its_limit p k (exp (- r)) Hp Hk) as [c [Hc Ec]].
  { split; [apply exp_pos|]; apply Rlt_le_trans with (exp (- ln q)); [apply exp_increasing; lra|].
    rewrite exp_Ropp, exp_ln by lra; unfold q; right; field; lra. }
  exists c; split; [exact Hc|]; split; [|split; intros l Hl].
  - destruct (S c Hc) as [E _]; rewrite E, Ec, ln_exp, Ropp_involutive, Er; ring.
  - destruct (S l ltac:(lra)) as [E P]; rewrite E.
    pose proof (density_ratio_between_0_and_1 p k l Hp Hk ltac:(lra)) as Y.
    pose proof (density_ratio_rises p k l c Hp Hk ltac:(lra) ltac:(lra) ltac:(lra)) as M; rewrite Ec in M.
    assert (L : ln (density_ratio p k l) < - r) by (rewrite <- (ln_exp (- r)); apply ln_increasing; lra).
    pose proof (lambda_quotient_rises r (- ln (density_ratio p k l)) ltac:(lra) ltac:(lra)).
    apply Rmult_lt_0_compat; lra.
  - destruct (S l ltac:(lra)) as [E P]; rewrite E.
    pose proof (density_ratio_between_0_and_1 p k l Hp Hk ltac:(lra)) as Y.
    pose proof (density_ratio_rises p k c l Hp Hk ltac:(lra) ltac:(lra) ltac:(lra)) as M; rewrite Ec in M.
    assert (L : - r < ln (density_ratio p k l)).
    { rewrite <- (ln_exp (- r)); apply ln_increasing; [apply exp_pos|lra]. }
    pose proof (lambda_quotient_rises (- ln (density_ratio p k l)) r P ltac:(lra)).
    pose proof (Rmult_lt_0_compat (q - lambda_quotient (- ln (density_ratio p k l))) (1 - density_ratio p k l)
      ltac:(lra) ltac:(lra)); lra.
Qed.

(* The gain strictly rises up to one cut and strictly falls after it; that cut is its one and only maximiser. *)
Theorem power_law_gain_rises_then_falls : forall p k, 0 < p -> 0 < k ->
  exists c, 0 < c < 1 /\ power_law_slope p k c = 0 /\
    rises_then_falls (power_law_gain p k) 0 c 1 /\ only_maximiser (power_law_gain p k) 0 1 c.
Proof.
  intros p k Hp Hk; destruct (power_law_slope_changes_sign_once p k Hp Hk) as [c [Hc [E [Pos Neg]]]].
  assert (F : forall l, 0 < l < 1 -> 0 < p * Rpower l p / l / ln 2).
  { intros l Hl; pose proof (exp_pos (p * ln l)); pose proof ln_2_positive.
    repeat apply Rdiv_lt_0_compat; try lra; apply Rmult_lt_0_compat; assumption. }
  assert (H : rises_then_falls (power_law_gain p k) 0 c 1).
  { apply derivative_positive_then_negative with (fun l => p * Rpower l p / l / ln 2 * power_law_slope p k l);
      [exact Hc|intros; apply derivative_of_power_law_gain; assumption| |]; intros l Hl; pose proof (F l ltac:(lra)) as P.
    - apply Rmult_lt_0_compat; [exact P|apply Pos; lra].
    - pose proof (Neg l Hl); pose proof (Rmult_lt_0_compat _ (- power_law_slope p k l) P ltac:(lra)); lra. }
  exists c; repeat split; try apply H; try lra.
  apply rises_then_falls_has_one_maximiser; assumption.
Qed.

(* Where the slope is positive the optimal cut lies further on; where it is negative, further back. *)
Theorem information_cut_between_signs : forall p k lower upper, 0 < p -> 0 < k ->
  0 < lower < 1 -> 0 < upper < 1 -> 0 < power_law_slope p k lower -> power_law_slope p k upper < 0 ->
  exists l, lower < l < upper /\ only_maximiser (power_law_gain p k) 0 1 l.
Proof.
  intros p k lower upper Hp Hk HL HU PL NU.
  destruct (power_law_slope_changes_sign_once p k Hp Hk) as [c [Hc [E [Pos Neg]]]].
  destruct (power_law_gain_rises_then_falls p k Hp Hk) as [d [Hd [Ed [_ M]]]].
  assert (c = d).
  { destruct (Rtotal_order c d) as [L|[Q|L]]; [|exact Q|]; exfalso.
    - pose proof (Neg d ltac:(lra)); lra.
    - pose proof (Pos d ltac:(lra)); lra. }
  subst d; exists c; split; [|exact M]; split.
  - destruct (Rtotal_order lower c) as [L|[Q|L]]; [exact L|rewrite Q in PL; lra|].
    pose proof (Neg lower ltac:(lra)); lra.
  - destruct (Rtotal_order c upper) as [L|[Q|L]]; [exact L|rewrite <- Q in NU; lra|].
    pose proof (Pos upper ltac:(lra)); lra.
Qed.

(* The two steps of the solver: first the root lambda, then the cut whose density ratio is exp (- lambda). *)
Theorem optimal_cut_solves_density_equation : forall p k root c, 0 < p -> 0 < k ->
  0 < root -> lambda_quotient root = 1 + k / p -> 0 < c < 1 ->
  (only_maximiser (power_law_gain p k) 0 1 c <-> density_ratio p k c = exp (- root)).
Proof.
  intros p k r c Hp Hk Hr Er Hc.
  destruct (power_law_gain_rises_then_falls p k Hp Hk) as [d [Hd [Ed [_ M]]]].
  assert (D : density_ratio p k d = exp (- r)).
  { pose proof (density_ratio_between_0_and_1 p k d Hp Hk Hd) as Y.
    assert (P : ln (density_ratio p k d) < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
    unfold power_law_slope in Ed; set (x := - ln (density_ratio p k d)) in *.
    assert (E : exp (- x) = density_ratio p k d) by (unfold x; rewrite Ropp_involutive; apply exp_ln; lra).
    assert (Q : lambda_quotient x = 1 + k / p).
    { unfold lambda_quotient; rewrite E.
      replace x with ((p + k) / p * (1 - density_ratio p k d)) by lra; field; lra. }
    rewrite <- E; f_equal; f_equal.
    destruct (Rtotal_order x r) as [L|[L|L]]; [exfalso|exact L|exfalso].
    - pose proof (lambda_quotient_rises x r ltac:(unfold x; lra) L); lra.
    - pose proof (lambda_quotient_rises r x Hr L); lra. }
  split; intro H.
  - rewrite (maximiser_is_unique _ _ _ _ _ H M); exact D.
  - replace c with d; [exact M|]; rewrite <- D in H.
    destruct (Rtotal_order c d) as [L|[L|L]]; [exfalso|symmetry; exact L|exfalso].
    + pose proof (density_ratio_rises p k c d Hp Hk ltac:(lra) L ltac:(lra)); lra.
    + pose proof (density_ratio_rises p k d c Hp Hk ltac:(lra) L ltac:(lra)); lra.
Qed.
