(* The mean square cut of section 4.2: for the radiosity l^n, n >= 1, the printed polynomial has exactly one positive root,
   the root lies inside (0, 1), and the L2 error of the two averages is least exactly there. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Stationarity Extremum.
Open Scope R_scope.

(* The L2 error of cutting the patch [0, 1] with radiosity x^n at l, each part replaced by its average. *)
Definition gradient_mean_square_error (n : nat) (l : R) : R :=
  mean_square_error (fun x => x ^ n) 0 1 l.

(* The printed polynomial 2 n l^n - l^(n-1) - ... - l - 1. *)
Definition mean_square_polynomial (n : nat) (l : R) : R :=
  2 * INR n * l ^ n - sum n (fun k => l ^ k).

Lemma power_is_continuous : forall n x, continuous (fun y => y ^ n) x.
Proof.
  intros n x; apply @ex_derive_continuous; auto_derive; exact I.
Qed.

Lemma integral_of_power : forall n u v,
  RInt (fun x => x ^ n) u v = (v ^ (n + 1) - u ^ (n + 1)) / (INR n + 1).
Proof.
  intros n u v; apply is_RInt_unique.
  assert (N : INR n + 1 <> 0) by (pose proof (pos_INR n); lra).
  assert (E : (v ^ (n + 1) - u ^ (n + 1)) / (INR n + 1) = v ^ (n + 1) / (INR n + 1) - u ^ (n + 1) / (INR n + 1))
    by (field; exact N).
  rewrite E.
  apply (is_RInt_derive (V := R_CompleteNormedModule) (fun x => x ^ (n + 1) / (INR n + 1))).
  - intros x _; auto_derive; [exact I|].
    replace (pred (n + 1)) with n by lia; rewrite plus_INR; simpl INR; field; exact N.
  - intros x _; apply power_is_continuous.
Qed.

Lemma geometric_sum : forall n l, 1 - l ^ n = (1 - l) * sum n (fun k => l ^ k).
Proof.
  induction n as [|n IH]; intro l; simpl; [ring|].
  rewrite Rmult_plus_distr_l, <- IH; ring.
Qed.

Lemma geometric_sum_is_positive : forall n l, (1 <= n)%nat -> 0 < l -> 0 < sum n (fun k => l ^ k).
Proof.
  intros n l Hn Hl; destruct n as [|n]; [lia|]; clear Hn.
  induction n as [|n IH]; [simpl; lra|].
  change (0 < sum (S n) (fun k => l ^ k) + l ^ S n); pose proof (pow_lt l (S n) Hl); lra.
Qed.

(* The closed form of the error, from the integral of a power. *)
Theorem gradient_mean_square_error_closed_form : forall n l, 0 < l < 1 ->
  gradient_mean_square_error n l =
  1 / (2 * INR n + 1) - (l ^ (n + 1) / (INR n + 1)) ^ 2 / l - ((1 - l ^ (n + 1)) / (INR n + 1)) ^ 2 / (1 - l).
Proof.
  intros n l Hl; unfold gradient_mean_square_error; pose proof (pos_INR n) as Pn.
  rewrite mean_square_error_closed_form by (try exact Hl; intros x _; apply power_is_continuous).
  rewrite (RInt_ext (fun x => (x ^ n) ^ 2) (fun x => x ^ (2 * n)))
    by (intros x _; rewrite Nat.mul_comm, pow_mult; reflexivity).
  rewrite !integral_of_power, !pow1, !(pow_i (_ + 1)) by lia; rewrite mult_INR; simpl (INR 2).
  field; lra.
Qed.

(* Both averages share the denominator n + 1, so the derivative is a positive factor times the printed polynomial. *)
Theorem derivative_of_gradient_mean_square_error : forall n l, 0 < l < 1 ->
  is_derive (gradient_mean_square_error n) l
    (sum n (fun k => l ^ k) * mean_square_polynomial n l / (INR n + 1) ^ 2).
Proof.
  intros n l Hl; pose proof (pos_INR n) as Pn.
  pose proof (derivative_of_mean_square_error (fun x => x ^ n) 0 1 l) as D.
  assert (C : continuous_between (fun x => x ^ n) 0 1) by (intros x _; apply power_is_continuous).
  specialize (D C Hl).
  replace (sum n (fun k => l ^ k) * mean_square_polynomial n l / (INR n + 1) ^ 2)
    with ((l ^ n - average (fun x => x ^ n) 0 l) ^ 2 - (l ^ n - average (fun x => x ^ n) l 1) ^ 2); [exact D|].
  unfold average, mean_square_polynomial; rewrite !integral_of_power, pow1, (pow_i (n + 1)) by lia.
  rewrite (geometric_sum (n + 1) l); replace (n + 1)%nat with (S n) by lia; simpl (sum (S n) _).
  set (s := sum n (fun k => l ^ k)); simpl (l ^ S n); field; lra.
Qed.

Lemma power_is_strictly_increasing : forall n x y, (1 <= n)%nat -> 0 < x < y -> x ^ n < y ^ n.
Proof.
  intros n x y Hn Hxy; destruct n as [|n]; [lia|]; clear Hn.
  induction n as [|n IH]; [simpl; lra|].
  change (x * x ^ S n < y * y ^ S n).
  apply Rmult_le_0_lt_compat; try lra; apply pow_le; lra.
Qed.

(* Divided by l^n, every term - l^(k-n) of the polynomial rises with l; written without division. *)
Lemma polynomial_over_power_rises : forall n x y, (1 <= n)%nat -> 0 < x < y ->
  mean_square_polynomial n x * y ^ n < mean_square_polynomial n y * x ^ n.
Proof.
  intros n x y Hn Hxy; unfold mean_square_polynomial.
  assert (T : forall k, (k < n)%nat -> y ^ k * x ^ n < x ^ k * y ^ n).
  { intros k Hk; replace n with (k + (n - k))%nat by lia; rewrite !pow_add.
    replace (y ^ k * (x ^ k * x ^ (n - k))) with (x ^ k * y ^ k * x ^ (n - k)) by ring.
    replace (x ^ k * (y ^ k * y ^ (n - k))) with (x ^ k * y ^ k * y ^ (n - k)) by ring.
    apply Rmult_lt_compat_l; [apply Rmult_lt_0_compat; apply pow_lt; lra|].
    apply power_is_strictly_increasing; [lia|exact Hxy]. }
  assert (S : forall m, (1 <= m)%nat -> (m <= n)%nat ->
    sum m (fun k => y ^ k) * x ^ n < sum m (fun k => x ^ k) * y ^ n).
  { induction m as [|m IH]; intros H1 H2; [lia|].
    simpl; rewrite !Rmult_plus_distr_r; pose proof (T m ltac:(lia)).
    destruct m as [|m]; [simpl in *; lra|]; pose proof (IH ltac:(lia) ltac:(lia)); lra. }
  pose proof (S n Hn (le_n n)).
  rewrite !Rmult_minus_distr_r.
  replace (2 * INR n * x ^ n * y ^ n) with (2 * INR n * y ^ n * x ^ n) by ring; lra.
Qed.

Lemma polynomial_positive_after_nonnegative : forall n x y, (1 <= n)%nat -> 0 < x < y ->
  0 <= mean_square_polynomial n x -> 0 < mean_square_polynomial n y.
Proof.
  intros n x y Hn Hxy Hx; pose proof (polynomial_over_power_rises n x y Hn Hxy) as H.
  assert (Px : 0 < x ^ n) by (apply pow_lt; lra); assert (Py : 0 < y ^ n) by (apply pow_lt; lra).
  apply Rmult_lt_reg_r with (x ^ n); [exact Px|].
  pose proof (Rmult_le_pos _ _ Hx (Rlt_le _ _ Py)); lra.
Qed.

Lemma polynomial_negative_before_nonpositive : forall n x y, (1 <= n)%nat -> 0 < x < y ->
  mean_square_polynomial n y <= 0 -> mean_square_polynomial n x < 0.
Proof.
  intros n x y Hn Hxy Hy; destruct (Rlt_le_dec (mean_square_polynomial n x) 0) as [H|H]; [exact H|].
  pose proof (polynomial_positive_after_nonnegative n x y Hn Hxy H); lra.
Qed.

Lemma sum_is_continuous : forall n x, continuity_pt (fun l => sum n (fun k => l ^ k)) x.
Proof.
  induction n as [|n IH]; intro x; simpl.
  - apply continuity_pt_const; intros ? ?; reflexivity.
  - apply continuity_pt_plus; [apply IH|apply derivable_continuous_pt, derivable_pt_pow].
Qed.

Lemma polynomial_is_continuous : forall n, continuity (mean_square_polynomial n).
Proof.
  intros n x; apply continuity_pt_minus; [|apply sum_is_continuous].
  apply continuity_pt_scal, derivable_continuous_pt, derivable_pt_pow.
Qed.

Lemma polynomial_at_0 : forall n, (1 <= n)%nat -> mean_square_polynomial n 0 = -1.
Proof.
  intros n Hn; unfold mean_square_polynomial; rewrite (pow_i n) by lia.
  destruct n as [|n]; [lia|]; clear Hn.
  assert (S : sum (S n) (fun k => 0 ^ k) = 1).
  { induction n as [|n IH]; [simpl; ring|].
    change (sum (S n) (fun k => 0 ^ k) + 0 ^ S n = 1); rewrite IH, pow_i by lia; ring. }
  rewrite S; ring.
Qed.

Lemma polynomial_at_1 : forall n, mean_square_polynomial n 1 = INR n.
Proof.
  intros n; unfold mean_square_polynomial; rewrite pow1.
  replace (sum n (fun k => 1 ^ k)) with (INR n); [ring|].
  induction n as [|n IH]; [reflexivity|]; rewrite S_INR, IH; simpl; rewrite pow1; reflexivity.
Qed.

(* -1 at l = 0 and n at l = 1, so a root lies between; where the polynomial is zero it has left the negative values for good. *)
Theorem printed_polynomial_has_one_positive_root : forall n, (1 <= n)%nat ->
  exists c, 0 < c < 1 /\ mean_square_polynomial n c = 0 /\
    forall x, 0 < x -> mean_square_polynomial n x = 0 -> x = c.
Proof.
  intros n Hn.
  destruct (IVT (mean_square_polynomial n) 0 1 (polynomial_is_continuous n)) as [c [Hc E]]; [lra| | |].
  - rewrite polynomial_at_0 by exact Hn; lra.
  - rewrite polynomial_at_1; apply lt_0_INR; lia.
  - assert (H0 : c <> 0) by (intro Z; rewrite Z, polynomial_at_0 in E by exact Hn; lra).
    assert (H1 : c <> 1).
    { intro Z; rewrite Z, polynomial_at_1 in E; pose proof (lt_0_INR n ltac:(lia)); lra. }
    exists c; split; [lra|split; [exact E|]]; intros x Hx Ex.
    destruct (Rtotal_order x c) as [L|[Q|L]]; [exfalso|exact Q|exfalso].
    + pose proof (polynomial_positive_after_nonnegative n x c Hn ltac:(lra) ltac:(lra)); lra.
    + pose proof (polynomial_positive_after_nonnegative n c x Hn ltac:(lra) ltac:(lra)); lra.
Qed.

(* The derivative of the error has the sign of the polynomial: negative before the root, positive after it. *)
Theorem mean_square_error_falls_then_rises : forall n c, (1 <= n)%nat ->
  0 < c < 1 -> mean_square_polynomial n c = 0 ->
  falls_then_rises (gradient_mean_square_error n) 0 c 1.
Proof.
  intros n c Hn Hc E; pose proof (pos_INR n) as Pn.
  assert (Q : 0 < / (INR n + 1) ^ 2) by (apply Rinv_0_lt_compat, pow_lt; lra).
  apply derivative_negative_then_positive with
    (fun l => sum n (fun k => l ^ k) * mean_square_polynomial n l / (INR n + 1) ^ 2);
    [exact Hc|apply derivative_of_gradient_mean_square_error| |]; intros x Hx;
    pose proof (geometric_sum_is_positive n x Hn ltac:(lra)) as P.
  - pose proof (polynomial_negative_before_nonpositive n x c Hn ltac:(lra) ltac:(lra)) as N.
    replace (_ / _) with (- (sum n (fun k => x ^ k) * - mean_square_polynomial n x * / (INR n + 1) ^ 2))
      by (field; lra).
    apply Ropp_lt_gt_0_contravar; repeat apply Rmult_lt_0_compat; lra.
  - pose proof (polynomial_positive_after_nonnegative n c x Hn ltac:(lra) ltac:(lra)) as N.
    unfold Rdiv; repeat apply Rmult_lt_0_compat; lra.
Qed.

(* The positive root of the printed polynomial is the one and only minimiser of the L2 error. *)
Theorem mean_square_error_is_least_exactly_at_the_root : forall n l, (1 <= n)%nat -> 0 < l ->
  (mean_square_polynomial n l = 0 <-> only_minimiser (gradient_mean_square_error n) 0 1 l).
Proof.
  intros n l Hn Hl; destruct (printed_polynomial_has_one_positive_root n Hn) as [c [Hc [E U]]].
  assert (M : only_minimiser (gradient_mean_square_error n) 0 1 c).
  { apply falls_then_rises_has_one_minimiser; [exact Hc|].
    apply mean_square_error_falls_then_rises; assumption. }
  split; intro H.
  - rewrite (U l Hl H); exact M.
  - rewrite (minimiser_is_unique _ _ _ _ _ H M); exact E.
Qed.

(* For n = 1 the polynomial is 2 l - 1. *)
Theorem mean_square_cut_of_linear_radiosity_is_one_half :
  only_minimiser (gradient_mean_square_error 1) 0 1 (1 / 2).
Proof.
  apply mean_square_error_is_least_exactly_at_the_root; [lia|lra|].
  unfold mean_square_polynomial; simpl; field.
Qed.

(* Where the polynomial is negative the optimal cut lies further on; where it is positive, further back. *)
Theorem mean_square_cut_between_signs : forall n lower upper, (1 <= n)%nat ->
  0 < lower -> upper < 1 -> mean_square_polynomial n lower < 0 -> 0 < mean_square_polynomial n upper ->
  0 < upper ->
  exists l, lower < l < upper /\ only_minimiser (gradient_mean_square_error n) 0 1 l.
Proof.
  intros n lower upper Hn HL HU NL PU U0.
  destruct (printed_polynomial_has_one_positive_root n Hn) as [c [Hc [E U]]].
  exists c; split; [|apply mean_square_error_is_least_exactly_at_the_root; (assumption || lra)].
  destruct (Rle_lt_dec c lower) as [A|A].
  - destruct (Req_dec c lower) as [Q|Q]; [rewrite Q in E; lra|].
    pose proof (polynomial_positive_after_nonnegative n c lower Hn ltac:(lra) ltac:(lra)); lra.
  - destruct (Rle_lt_dec upper c) as [B|B]; [|lra].
    destruct (Req_dec upper c) as [Q|Q]; [rewrite Q in PU; lra|].
    pose proof (polynomial_positive_after_nonnegative n upper c Hn ltac:(lra) ltac:(lra)); lra.
Qed.
