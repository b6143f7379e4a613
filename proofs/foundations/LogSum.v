(* The log-sum inequality, the paper's eq. (12), for finite sums of any length and with zeros allowed,
   and when it is an equality. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums.
Open Scope R_scope.

(* ---- One term against its tangent ---- *)

(* ln y < y - 1 except at y = 1. *)
Lemma ln_below_tangent : forall y, 0 < y -> y <> 1 -> ln y < y - 1.
Proof.
  intros y Hy H1.
  assert (ln y <> 0) by (intros E; apply H1; rewrite <- (exp_ln y Hy), E; apply exp_0).
  assert (H2 := exp_ineq1 (ln y) H). rewrite exp_ln in H2 by assumption. lra.
Qed.

(* For a, b >= 0 (a = 0 where b = 0) and a ratio c > 0:
   a log (a/b) - a log c >= (a - b c) / ln 2, with equality only where a = b c.
   It is the tangent of the logarithm at 1, taken at b c / a. *)
Lemma term_above_tangent : forall a b c,
  0 <= a -> 0 <= b -> (b = 0 -> a = 0) -> 0 < c ->
  a * log2 c + (a - b * c) / ln 2 <= xlog2 a b /\
  (a * log2 c + (a - b * c) / ln 2 = xlog2 a b -> a = b * c).
Proof.
  intros a b c Ha Hb Hab Hc. assert (H2 := ln_2_positive).
  destruct (Req_dec a 0) as [->|Ha0].
  - rewrite xlog2_0. assert (0 <= b * c) by (apply Rmult_le_pos; lra).
    replace (0 * log2 c + (0 - b * c) / ln 2) with (- (b * c / ln 2)) by (field; lra).
    split.
    + assert (0 <= b * c / ln 2); [|lra].
      apply Rmult_le_pos; [assumption|left; now apply Rinv_0_lt_compat].
    + intros E. assert (b * c / ln 2 * ln 2 = 0) by (replace (b * c / ln 2) with 0 by lra; lra).
      replace (b * c / ln 2 * ln 2) with (b * c) in H0 by (field; lra). lra.
  - assert (0 < a) by lra.
    assert (0 < b) by (destruct Hb as [|Hb]; [assumption|symmetry in Hb; specialize (Hab Hb); lra]).
    assert (Hbc : 0 < b * c) by now apply Rmult_lt_0_compat.
    assert (Hy : 0 < b * c / a) by now apply Rdiv_lt_0_compat.
    rewrite xlog2_nonzero by assumption.
    assert (E : a * log2 (a / b) - (a * log2 c + (a - b * c) / ln 2) =
                a / ln 2 * ((b * c / a - 1) - ln (b * c / a))).
    { unfold log2. rewrite !ln_quotient, ln_mult by assumption. field. lra. }
    assert (Hk : 0 < a / ln 2) by now apply Rdiv_lt_0_compat.
    destruct (Req_dec (b * c / a) 1) as [H1|H1].
    + rewrite H1, ln_1 in E. split; [nra|]. intros _.
      replace (b * c) with (b * c / a * a) by (field; lra). rewrite H1. lra.
    + assert (H3 := ln_below_tangent _ Hy H1).
      assert (0 < a / ln 2 * ((b * c / a - 1) - ln (b * c / a))) by (apply Rmult_lt_0_compat; lra).
      split; lra.
Qed.

(* ---- Eq. (12) ---- *)

Section LogSum.
Variables (n : nat) (a b : nat -> R).
Hypothesis a_nonneg : forall i, (i < n)%nat -> 0 <= a i.
Hypothesis b_nonneg : forall i, (i < n)%nat -> 0 <= b i.
Hypothesis a_null_with_b : forall i, (i < n)%nat -> b i = 0 -> a i = 0.

(* Either every a is zero, or both sums are positive. *)
Lemma all_null_or_positive_sums :
  (forall i, (i < n)%nat -> a i = 0) \/ (0 < sum n a /\ 0 < sum n b).
Proof.
  destruct (Req_dec (sum n a) 0) as [E|Ea]; [left; now apply sum_nonneg_zero|right].
  assert (0 <= sum n a) by now apply sum_nonneg.
  assert (0 <= sum n b) by now apply sum_nonneg.
  split; [lra|]. destruct (Req_dec (sum n b) 0) as [Eb|]; [|lra].
  exfalso. apply Ea. apply sum_zero. intros i Hi. apply a_null_with_b; [assumption|].
  now apply (sum_nonneg_zero n b).
Qed.

Let c := sum n a / sum n b.

(* The tangents add up to the right-hand side of (12). *)
Lemma tangents_add_up : 0 < sum n a -> 0 < sum n b ->
  sum n (fun i => a i * log2 c + (a i - b i * c) / ln 2) = xlog2 (sum n a) (sum n b).
Proof.
  intros HA HB. rewrite sum_plus, sum_scale_right.
  unfold Rdiv. rewrite sum_scale_right, sum_minus, sum_scale_right.
  rewrite xlog2_nonzero by lra. unfold c.
  assert (H2 := ln_2_positive). field. lra.
Qed.

(* Each term lies above its tangent, and the tangents add up. *)
Theorem log_sum_inequality :
  xlog2 (sum n a) (sum n b) <= sum n (fun i => xlog2 (a i) (b i)).
Proof.
  destruct all_null_or_positive_sums as [E|[HA HB]].
  - rewrite (sum_zero n a E), xlog2_0, sum_zero; [lra|].
    intros i Hi. now rewrite E, xlog2_0.
  - rewrite <- tangents_add_up by assumption. apply sum_le. intros i Hi.
    apply term_above_tangent; auto. now apply Rdiv_lt_0_compat.
Qed.

(* If the sums are equal then so is every term with its tangent, which touches only at a = b c. *)
Theorem log_sum_equality :
  sum n (fun i => xlog2 (a i) (b i)) = xlog2 (sum n a) (sum n b) <->
  (forall i, (i < n)%nat -> a i * sum n b = b i * sum n a).
Proof.
  destruct all_null_or_positive_sums as [E|[HA HB]].
  - rewrite (sum_zero n a E), xlog2_0. split; intros.
    + rewrite E by assumption. lra.
    + apply sum_zero. intros i Hi. now rewrite E, xlog2_0.
  - assert (Hc : 0 < c) by now apply Rdiv_lt_0_compat. split.
    + intros E i Hi. rewrite <- tangents_add_up in E by assumption. symmetry in E.
      assert (Ei := sum_le_eq n _ _ (fun j Hj => proj1 (term_above_tangent (a j) (b j) c
        (a_nonneg j Hj) (b_nonneg j Hj) (a_null_with_b j Hj) Hc)) E i Hi). simpl in Ei.
      apply term_above_tangent in Ei; auto. rewrite Ei. unfold c. field. lra.
    + intros E. rewrite xlog2_nonzero by lra. rewrite <- sum_scale_right.
      apply sum_ext. intros i Hi.
      destruct (Req_dec (a i) 0) as [H0|H0]; [rewrite H0, xlog2_0; lra|].
      rewrite xlog2_nonzero by assumption. do 2 f_equal.
      assert (b i <> 0) by (intros Hb; apply H0; auto).
      apply (Rmult_eq_reg_r (b i * sum n b)); [|apply Rmult_integral_contrapositive_currified; lra].
      replace (a i / b i * (b i * sum n b)) with (a i * sum n b) by (field; assumption).
      rewrite E by assumption. field. lra.
Qed.
End LogSum.

(* The same for double sums: a double sum is one sum. *)
Section DoubleLogSum.
Variables (n m : nat) (a b : nat -> nat -> R).
Hypothesis a_nonneg : forall i j, (i < n)%nat -> (j < m)%nat -> 0 <= a i j.
Hypothesis b_nonneg : forall i j, (i < n)%nat -> (j < m)%nat -> 0 <= b i j.
Hypothesis a_null_with_b : forall i j, (i < n)%nat -> (j < m)%nat -> b i j = 0 -> a i j = 0.

Let double (f : nat -> nat -> R) := sum n (fun i => sum m (fun j => f i j)).

Lemma flat_index : forall p, (p < n * m)%nat -> (p / m < n)%nat /\ (p mod m < m)%nat.
Proof.
  intros p Hp. assert (m <> 0)%nat by (intros ->; lia). split.
  - apply Nat.div_lt_upper_bound; lia.
  - now apply Nat.mod_upper_bound.
Qed.

Theorem log_sum_inequality_of_double_sums :
  xlog2 (double a) (double b) <= double (fun i j => xlog2 (a i j) (b i j)).
Proof.
  unfold double. rewrite <- !sum_flatten.
  apply (log_sum_inequality (n * m)
    (fun p => a (p / m)%nat (p mod m)%nat) (fun p => b (p / m)%nat (p mod m)%nat));
  intros p Hp; apply flat_index in Hp; destruct Hp; auto.
Qed.

Theorem log_sum_equality_of_double_sums :
  double (fun i j => xlog2 (a i j) (b i j)) = xlog2 (double a) (double b) <->
  (forall i j, (i < n)%nat -> (j < m)%nat -> a i j * double b = b i j * double a).
Proof.
  unfold double. rewrite <- !sum_flatten.
  rewrite (log_sum_equality (n * m)
    (fun p => a (p / m)%nat (p mod m)%nat) (fun p => b (p / m)%nat (p mod m)%nat));
  [|intros p Hp; apply flat_index in Hp; destruct Hp; auto ..].
  split; intros E.
  - intros i j Hi Hj. specialize (E (i * m + j)%nat).
    destruct (flat_quotient_and_rest m i j Hj) as [-> ->] in E.
    apply E. nia.
  - intros p Hp. apply flat_index in Hp. destruct Hp. auto.
Qed.
End DoubleLogSum.

(* Control: with negative numbers (2, -1) and (2, -1/2), whose quotients are positive, the left side is -1
   and the right side log2 (2/3) > -1. *)
Theorem log_sum_fails_for_negative_numbers : exists a b : nat -> R,
  (forall i, (i < 2)%nat -> 0 < a i / b i) /\ 0 < sum 2 a / sum 2 b /\
  sum 2 (fun i => xlog2 (a i) (b i)) < xlog2 (sum 2 a) (sum 2 b).
Proof.
  exists (fun i => match i with O => 2 | _ => -1 end),
         (fun i => match i with O => 2 | _ => -(1/2) end).
  split; [|split].
  - intros [|i] _; [lra|]. replace (-1 / -(1/2)) with 2 by field. lra.
  - simpl. apply Rdiv_lt_0_compat; lra.
  - simpl. rewrite !xlog2_nonzero by lra.
    replace (2 / 2) with 1 by field. replace (-1 / -(1/2)) with 2 by field.
    rewrite log2_1, log2_2.
    replace ((0 + 2 + -1) / (0 + 2 + -(1/2))) with (2 / 3) by field.
    assert (log2 (1 / 2) < log2 (2 / 3)) by (apply log2_increasing; lra).
    rewrite (log2_div 1 2), log2_1, log2_2 in H by lra. lra.
Qed.
