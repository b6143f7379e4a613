(* The ratio of the two flux densities for a power-law patch cut at l (section 4.2): it rises strictly with l, and takes every
   value between 0 and p / (p + k) exactly once in (0, 1). *)
From Coq Require Import Reals Lra Ranalysis5.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Extremum LambdaEquation.
Open Scope R_scope.

(* The flux density of the far part over that of the near part. *)
Definition density_ratio (p k l : R) : R :=
  Rpower l k * (1 - Rpower l p) / (1 - Rpower l (p + k)).

Lemma power_between_0_and_1 : forall p l, 0 < p -> 0 < l < 1 -> 0 < Rpower l p < 1.
Proof.
  intros p l Hp Hl; unfold Rpower; split; [apply exp_pos|].
  rewrite <- exp_0; apply exp_increasing.
  assert (ln l < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
  pose proof (Rmult_lt_0_compat p (- ln l) Hp ltac:(lra)); lra.
Qed.

Lemma derivative_of_power : forall p l, 0 < l -> is_derive (fun x => Rpower x p) l (p * Rpower l p / l).
Proof.
  intros p l Hl; unfold Rpower; auto_derive; [exact Hl|field; lra].
Qed.

(* The density ratio is 1 minus this quotient, which falls while l grows. *)
Lemma density_ratio_complement : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  1 - density_ratio p k l = (1 - Rpower l k) / (1 - Rpower l (p + k)).
Proof.
  intros p k l Hp Hk Hl; unfold density_ratio.
  pose proof (power_between_0_and_1 (p + k) l ltac:(lra) Hl) as P.
  rewrite Rpower_plus in *; field; lra.
Qed.

Lemma density_ratio_between_0_and_1 : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  0 < density_ratio p k l < 1.
Proof.
  intros p k l Hp Hk Hl.
  pose proof (power_between_0_and_1 p l Hp Hl); pose proof (power_between_0_and_1 k l Hk Hl).
  pose proof (power_between_0_and_1 (p + k) l ltac:(lra) Hl) as P; split.
  - apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
  - enough (0 < 1 - density_ratio p k l) by lra.
    rewrite density_ratio_complement by assumption; apply Rdiv_lt_0_compat; lra.
Qed.

(* k e^(ps) + p e^(-ks) > k (1 + ps) + p (1 - ks) = k + p, with s = - ln l. *)
Lemma power_inequality : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  (p + k) * Rpower l p < k + p * Rpower l (p + k).
Proof.
  intros p k l Hp Hk Hl.
  assert (L : ln l < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
  pose proof (Rmult_lt_0_compat p (- ln l) Hp ltac:(lra)); pose proof (Rmult_lt_0_compat k (- ln l) Hk ltac:(lra)).
  pose proof (exp_ineq1 (- (p * ln l)) ltac:(lra)) as E1; pose proof (exp_ineq1 (k * ln l) ltac:(lra)) as E2.
  pose proof (Rmult_lt_compat_l k _ _ Hk E1); pose proof (Rmult_lt_compat_l p _ _ Hp E2).
  assert (S : p + k < k * exp (- (p * ln l)) + p * exp (k * ln l)) by lra.
  pose proof (exp_pos (p * ln l)) as P.
  pose proof (Rmult_lt_compat_r _ _ _ P S) as M.
  assert (I : exp (- (p * ln l)) * exp (p * ln l) = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
  rewrite Rpower_plus; unfold Rpower.
  replace ((k * exp (- (p * ln l)) + p * exp (k * ln l)) * exp (p * ln l))
    with (k * (exp (- (p * ln l)) * exp (p * ln l)) + p * (exp (p * ln l) * exp (k * ln l))) in M by ring.
  rewrite I in M; lra.
Qed.

Lemma derivative_of_density_ratio : forall p k l, 0 < p -> 0 < k -> 0 < l < 1 ->
  is_derive (density_ratio p k) l
    (Rpower l k / l * (k + p * Rpower l (p + k) - (p + k) * Rpower l p) / (1 - Rpower l (p + k)) ^ 2).
Proof.
  intros p k l Hp Hk Hl; unfold density_ratio.
  pose proof (power_between_0_and_1 (p + k) l ltac:(lra) Hl) as PK.
  unfold Rpower in *; auto_derive; [repeat split; lra|].
  rewrite !Rmult_plus_distr_r, exp_plus in *; set (u := exp (p * ln l) * exp (k * ln l)) in *.
  pose proof (Rmult_lt_0_compat (1 - u) (1 - u) ltac:(lra) ltac:(lra)).
  unfold u in *; field; repeat split; lra.
Qed.

Lemma density_ratio_rises : forall p k x y, 0 < p -> 0 < k -> 0 < x -> x < y -> y < 1 ->
  density_ratio p k x < density_ratio p k y.
Proof.
  intros p k x y Hp Hk Hx Hxy Hy.
  destruct (mean_value (density_ratio p k) (fun l =>
    Rpower l k / l * (k + p * Rpower l (p + k) - (p + k) * Rpower l p) / (1 - Rpower l (p + k)) ^ 2) x y Hxy)
    as [z [Hz E]]; [intros z Hz; apply derivative_of_density_ratio; lra|].
  pose proof (power_inequality p k z Hp Hk ltac:(lra)).
  pose proof (power_between_0_and_1 (p + k) z ltac:(lra) ltac:(lra)).
  assert (P : 0 < Rpower z k / z * (k + p * Rpower z (p + k) - (p + k) * Rpower z p) / (1 - Rpower z (p + k)) ^ 2).
  { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat|]|apply pow_lt]; try lra.
    apply exp_pos. }
  pose proof (Rmult_lt_0_compat _ (y - x) P ltac:(lra)); lra.
Qed.

(* The ratio is at most l^k, so small near 0; near 1 its complement is at most k / (p + k) + k s, s = - ln l. *)
Lemma density_ratio_takes_every_value_below_its_limit : forall p k y, 0 < p -> 0 < k -> 0 < y < p / (p + k) ->
  exists l, 0 < l < 1 /\ density_ratio p k l = y.
Proof.
  intros p k y Hp Hk Hy.
  assert (Q : p / (p + k) = 1 - k / (p + k)) by (field; lra).
  assert (Q0 : 0 < k / (p + k)) by (apply Rdiv_lt_0_compat; lra).
  assert (Ly : ln y < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (A : exists l1, 0 < l1 < 1 /\ density_ratio p k l1 < y).
  { exists (exp (ln y / k)).
    assert (B : ln y / k < 0).
    { pose proof (Rdiv_lt_0_compat (- ln y) k ltac:(lra) Hk) as B.
      replace (- ln y / k) with (- (ln y / k)) in B by (field; lra); lra. }
    assert (H : 0 < exp (ln y / k) < 1).
    { split; [apply exp_pos|]; rewrite <- exp_0; apply exp_increasing, B. }
    split; [exact H|].
    assert (E : Rpower (exp (ln y / k)) k = y).
    { unfold Rpower; rewrite ln_exp; replace (k * (ln y / k)) with (ln y) by (field; lra); apply exp_ln; lra. }
    pose proof (power_between_0_and_1 p _ Hp H) as P.
    pose proof (power_between_0_and_1 (p + k) _ ltac:(lra) H) as PK.
    unfold density_ratio; rewrite Rpower_plus, E in *; set (r := Rpower (exp (ln y / k)) p) in *.
    apply Rmult_lt_reg_r with (1 - r * y); [lra|].
    replace (y * (1 - r) / (1 - r * y) * (1 - r * y)) with (y * (1 - r)) by (field; lra).
    pose proof (Rmult_lt_0_compat r (1 - y) ltac:(lra) ltac:(lra)).
    apply Rmult_lt_compat_l; lra. }
  assert (B : exists l2, 0 < l2 < 1 /\ y < density_ratio p k l2).
  { set (s := (1 - y - k / (p + k)) / k).
    assert (S : 0 < s) by (apply Rdiv_lt_0_compat; lra).
    exists (exp (- s)).
    assert (H : 0 < exp (- s) < 1) by (split; [apply exp_pos|rewrite <- exp_0; apply exp_increasing; lra]).
    split; [exact H|].
    enough (1 - density_ratio p k (exp (- s)) < 1 - y) by lra.
    rewrite density_ratio_complement by assumption; unfold Rpower; rewrite ln_exp.
    replace (k * - s) with (- (k * s)) by ring; replace ((p + k) * - s) with (- ((p + k) * s)) by ring.
    pose proof (Rmult_lt_0_compat k s Hk S) as KS; pose proof (Rmult_lt_0_compat (p + k) s ltac:(lra) S) as PS.
    pose proof (exp_ineq1 (- (k * s)) ltac:(lra)) as E1.
    pose proof (exp_ineq1 ((p + k) * s) ltac:(lra)) as E2.
    pose proof (one_minus_exp_positive _ PS) as P.
    assert (E3 : (p + k) * s < (1 - exp (- ((p + k) * s))) * (1 + (p + k) * s)).
    { rewrite exp_Ropp in *; set (x := (p + k) * s) in *.
      assert (I : / exp x * (1 + x) < 1).
      { apply Rmult_lt_reg_l with (exp x); [lra|]; rewrite <- Rmult_assoc, Rinv_r by lra; lra. }
      lra. }
    replace (1 - y) with (k / (p + k) + k * s) by (unfold s; field; lra).
    apply Rmult_lt_reg_r with (1 - exp (- ((p + k) * s))); [exact P|].
    replace ((1 - exp (- (k * s))) / (1 - exp (- ((p + k) * s))) * (1 - exp (- ((p + k) * s))))
      with (1 - exp (- (k * s))) by (field; lra).
    apply Rlt_trans with (k / (p + k) * ((p + k) * s)).
    - replace (k / (p + k) * ((p + k) * s)) with (k * s) by (field; lra); lra.
    - apply Rlt_le_trans with (k / (p + k) * ((1 - exp (- ((p + k) * s))) * (1 + (p + k) * s))).
      + apply Rmult_lt_compat_l; assumption.
      + right; field; lra. }
  destruct A as [l1 [H1 A]]; destruct B as [l2 [H2 B]].
  assert (L : l1 < l2).
  { destruct (Rtotal_order l1 l2) as [L|[L|L]]; [exact L|rewrite L in A; lra|].
    pose proof (density_ratio_rises p k l2 l1 Hp Hk ltac:(lra) L ltac:(lra)); lra. }
  destruct (IVT_interv (fun l => density_ratio p k l - y) l1 l2) as [l [Hl E]]; [|lra|lra|lra|exists l; split; lra].
  intros x Hx; apply continuity_pt_minus.
  - eapply derivable_is_continuous, derivative_of_density_ratio; lra.
  - apply continuity_pt_const; intros ? ?; reflexivity.
Qed.
