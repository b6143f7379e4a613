(* The equation lambda / (1 - exp (- lambda)) = q behind the mutual information cut of section 4.2: for every q > 1 it has
   exactly one positive root, and the root lies between q - 1 and 2 (q - 1). *)
From Coq Require Import Reals Lra Ranalysis5.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Extremum.
Open Scope R_scope.

Lemma derivable_is_continuous : forall (f : R -> R) x d, is_derive f x d -> continuity_pt f x.
Proof.
  intros f x d D; apply derivable_continuous_pt; exists d; apply is_derive_Reals; exact D.
Qed.

(* The transcendental equation of the pencil proof, lambda / (1 - exp (- lambda)) = q: the left side is strictly
   increasing because exp lambda > 1 + lambda, it is less than q at ln q and more than q at q. *)
Definition lambda_quotient (lambda : R) : R := lambda / (1 - exp (- lambda)).

Lemma one_minus_exp_positive : forall x, 0 < x -> 0 < 1 - exp (- x).
Proof.
  intros x Hx; pose proof (exp_increasing (- x) 0 ltac:(lra)); rewrite exp_0 in *; lra.
Qed.

Lemma derivative_of_lambda_quotient : forall x, 0 < x ->
  is_derive lambda_quotient x ((1 - exp (- x) - x * exp (- x)) / (1 - exp (- x)) ^ 2).
Proof.
  intros x Hx; pose proof (one_minus_exp_positive x Hx); unfold lambda_quotient.
  auto_derive; [lra|field; lra].
Qed.

Lemma lambda_quotient_rises : forall x y, 0 < x -> x < y -> lambda_quotient x < lambda_quotient y.
Proof.
  intros x y Hx Hxy.
  destruct (mean_value lambda_quotient (fun z => (1 - exp (- z) - z * exp (- z)) / (1 - exp (- z)) ^ 2) x y Hxy)
    as [z [Hz E]]; [intros z Hz; apply derivative_of_lambda_quotient; lra|].
  assert (P : 0 < (1 - exp (- z) - z * exp (- z)) / (1 - exp (- z)) ^ 2).
  { apply Rdiv_lt_0_compat; [|apply pow_lt, one_minus_exp_positive; lra].
    pose proof (exp_ineq1 z ltac:(lra)); pose proof (exp_pos (- z)).
    assert (Q : exp (- z) * exp z = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
    pose proof (Rmult_lt_compat_l (exp (- z)) (1 + z) (exp z) ltac:(lra) ltac:(lra)); lra. }
  pose proof (Rmult_lt_0_compat _ (y - x) P ltac:(lra)); lra.
Qed.

Theorem lambda_equation_has_one_positive_root : forall q, 1 < q ->
  exists root, ln q < root < q /\ lambda_quotient root = q /\
    forall x, 0 < x -> lambda_quotient x = q -> x = root.
Proof.
  intros q Hq.
  assert (Lq : 0 < ln q) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (Lq' : ln q < q - 1).
  { apply exp_lt_inv; rewrite exp_ln by lra; pose proof (exp_ineq1 (q - 1) ltac:(lra)); lra. }
  assert (A : lambda_quotient (ln q) < q).
  { unfold lambda_quotient; rewrite exp_Ropp, exp_ln by lra.
    replace (ln q / (1 - / q)) with (ln q * (q / (q - 1))) by (field; lra).
    pose proof (Rdiv_lt_0_compat q (q - 1) ltac:(lra) ltac:(lra)) as P.
    pose proof (Rmult_lt_compat_r _ _ _ P Lq') as H.
    replace ((q - 1) * (q / (q - 1))) with q in H by (field; lra); exact H. }
  assert (B : q < lambda_quotient q).
  { pose proof (one_minus_exp_positive q ltac:(lra)) as P; pose proof (exp_pos (- q)).
    unfold lambda_quotient; apply Rmult_lt_reg_r with (1 - exp (- q)); [exact P|].
    replace (q / (1 - exp (- q)) * (1 - exp (- q))) with q by (field; lra).
    pose proof (Rmult_lt_0_compat q (exp (- q)) ltac:(lra) ltac:(lra)); lra. }
  destruct (IVT_interv (fun x => lambda_quotient x - q) (ln q) q) as [r [Hr E]]; [|lra|lra|lra|].
  - intros x Hx; apply continuity_pt_minus.
    + eapply derivable_is_continuous, derivative_of_lambda_quotient; lra.
    + apply continuity_pt_const; intros ? ?; reflexivity.
  - assert (r <> ln q) by (intro Z; rewrite Z in E; lra).
    assert (r <> q) by (intro Z; rewrite Z in E; lra).
    exists r; split; [lra|split; [lra|]]; intros x Hx Ex.
    destruct (Rtotal_order x r) as [L|[Q|L]]; [exfalso|exact Q|exfalso].
    + pose proof (lambda_quotient_rises x r Hx L); lra.
    + pose proof (lambda_quotient_rises r x ltac:(lra) L); lra.
Qed.

(* The bracket of the root used by the solver: q - 1 < lambda < 2 (q - 1), with q = 1 + k / p. *)
Lemma twice_mean_exceeds_chord : forall x, 0 < x -> 0 < x - 2 + (x + 2) * exp (- x).
Proof.
  intros x Hx.
  destruct (mean_value (fun z => z - 2 + (z + 2) * exp (- z)) (fun z => 1 - (1 + z) * exp (- z)) 0 x Hx)
    as [z [Hz E]]; [intros z Hz; auto_derive; [exact I|ring]|].
  rewrite Ropp_0, exp_0 in E.
  pose proof (exp_ineq1 z ltac:(lra)); pose proof (exp_pos (- z)).
  assert (Q : exp (- z) * exp z = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
  pose proof (Rmult_lt_compat_l (exp (- z)) (1 + z) (exp z) ltac:(lra) ltac:(lra)).
  pose proof (Rmult_lt_0_compat (1 - (1 + z) * exp (- z)) (x - 0) ltac:(lra) ltac:(lra)); lra.
Qed.

Theorem lambda_root_bracket : forall q lambda, 0 < lambda -> lambda_quotient lambda = q ->
  q - 1 < lambda < 2 * (q - 1).
Proof.
  intros q x Hx <-; unfold lambda_quotient.
  pose proof (one_minus_exp_positive x Hx) as P; pose proof (twice_mean_exceeds_chord x Hx) as U.
  pose proof (exp_ineq1 x ltac:(lra)); pose proof (exp_pos (- x)).
  assert (Q : exp (- x) * exp x = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
  pose proof (Rmult_lt_compat_l (exp (- x)) (1 + x) (exp x) ltac:(lra) ltac:(lra)).
  assert (E : x / (1 - exp (- x)) * (1 - exp (- x)) = x) by (field; lra).
  split; apply Rmult_lt_reg_r with (1 - exp (- x)); try exact P;
    rewrite ?Rmult_minus_distr_r, ?Rmult_assoc, ?Rmult_minus_distr_r, E; lra.
Qed.
