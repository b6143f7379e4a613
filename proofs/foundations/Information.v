(* The paper's logarithm, in base 2, with the convention 0 log 0 = 0; the term every entropy is a sum of; their rules. *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

Definition log2 (x : R) : R := ln x / ln 2.

(* x log2 (x / y), which is 0 where x = 0. *)
Definition xlog2 (x y : R) : R :=
  if Req_EM_T x 0 then 0 else x * log2 (x / y).

(* ---- Rules ---- *)

Lemma ln_2_positive : 0 < ln 2.
Proof. rewrite <- ln_1. apply ln_increasing; lra. Qed.

Lemma log2_1 : log2 1 = 0.
Proof. unfold log2. rewrite ln_1. lra. Qed.

Lemma log2_2 : log2 2 = 1.
Proof. unfold log2. assert (H := ln_2_positive). field. lra. Qed.

Lemma log2_mult : forall x y, 0 < x -> 0 < y -> log2 (x * y) = log2 x + log2 y.
Proof. intros. unfold log2. rewrite ln_mult by assumption. lra. Qed.

Lemma ln_quotient : forall x y, 0 < x -> 0 < y -> ln (x / y) = ln x - ln y.
Proof.
  intros. unfold Rdiv. rewrite ln_mult, ln_Rinv; auto with real.
Qed.

Lemma log2_div : forall x y, 0 < x -> 0 < y -> log2 (x / y) = log2 x - log2 y.
Proof.
  intros. unfold log2. rewrite ln_quotient by assumption. lra.
Qed.

Lemma log2_increasing : forall x y, 0 < x -> x < y -> log2 x < log2 y.
Proof.
  intros. unfold log2, Rdiv. apply Rmult_lt_compat_r.
  - apply Rinv_0_lt_compat, ln_2_positive.
  - now apply ln_increasing.
Qed.

Lemma log2_le : forall x y, 0 < x -> x <= y -> log2 x <= log2 y.
Proof.
  intros x y Hx [H|<-]; [left; now apply log2_increasing|right; reflexivity].
Qed.

Lemma xlog2_0 : forall y, xlog2 0 y = 0.
Proof. intros. unfold xlog2. destruct (Req_EM_T 0 0); lra. Qed.

Lemma xlog2_nonzero : forall x y, x <> 0 -> xlog2 x y = x * log2 (x / y).
Proof. intros. unfold xlog2. destruct (Req_EM_T x 0); lra. Qed.

(* A common factor of the two arguments comes out of xlog2. *)
Lemma xlog2_scale : forall c x y, xlog2 (c * x) (c * y) = c * xlog2 x y.
Proof.
  intros c x y.
  destruct (Req_dec c 0) as [->|Hc]; [rewrite Rmult_0_l, xlog2_0; lra|].
  destruct (Req_dec x 0) as [->|Hx]; [rewrite Rmult_0_r, !xlog2_0; lra|].
  rewrite !xlog2_nonzero by (try apply Rmult_integral_contrapositive_currified; assumption).
  replace (c * x / (c * y)) with (x / y); [lra|].
  unfold Rdiv. destruct (Req_dec y 0) as [->|Hy].
  - rewrite Rmult_0_r, Rinv_0. lra.
  - field. auto.
Qed.
