(* Where a cut is stationary (sections 3.2 and 4.2). For the mutual information: where the flux lost by one side over the
   weight lost by it is the logarithmic mean of the two flux densities. For the mean square error: where the radiosity at
   the cut is the arithmetic mean of the two averages. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Information.
Open Scope R_scope.

(* The part of eq. (5) that depends on the cut, with flux G and weight W on one side and the totals G0, W0 fixed;
   once with the paper's logarithm, once with the natural one. *)
Definition two_sided_information (G0 W0 G W : R) : R :=
  xlog2 G W + xlog2 (G0 - G) (W0 - W).

Definition two_sided_information_ln (G0 W0 G W : R) : R :=
  G * ln (G / W) + (G0 - G) * ln ((G0 - G) / (W0 - W)).

Definition logarithmic_mean (a b : R) : R :=
  if Req_EM_T a b then a else (a - b) / ln (a / b).

Definition arithmetic_mean (a b : R) : R := (a + b) / 2.

(* For positive shares the two forms differ by the constant factor ln 2. *)
Lemma two_sided_information_in_natural_units : forall G0 W0 G W,
  0 < G < G0 -> two_sided_information G0 W0 G W = two_sided_information_ln G0 W0 G W / ln 2.
Proof.
  intros G0 W0 G W HG; unfold two_sided_information, two_sided_information_ln, xlog2, log2.
  pose proof ln_2_positive.
  destruct (Req_EM_T G 0); [lra|]; destruct (Req_EM_T (G0 - G) 0); [lra|]; field; lra.
Qed.

(* The terms G' - G W'/W of the two sides, from differentiating inside the logarithms, add up to -W' (a - b). *)
Theorem derivative_of_two_sided_information_ln : forall (G W : R -> R) (G0 W0 t G' W' : R),
  0 < G t < G0 -> 0 < W t < W0 -> is_derive G t G' -> is_derive W t W' ->
  let a := G t / W t in
  let b := (G0 - G t) / (W0 - W t) in
  is_derive (fun s => two_sided_information_ln G0 W0 (G s) (W s)) t (G' * ln (a / b) - W' * (a - b)).
Proof.
  intros G W G0 W0 t G' W' HG HW DG DW a b.
  assert (Ha : 0 < a) by (apply Rdiv_lt_0_compat; lra).
  assert (Hb : 0 < b) by (apply Rdiv_lt_0_compat; lra).
  apply is_derive_unique in DG as EG; apply is_derive_unique in DW as EW.
  assert (E : G' * ln (a / b) - W' * (a - b) =
    G' * ln a + G' - a * W' - (G' * ln b + G' - b * W')).
  { rewrite ln_div by assumption; ring. }
  rewrite E; unfold two_sided_information_ln; auto_derive.
  - repeat split; try exact Ha; try exact Hb; try lra; try (exists G'; exact DG); exists W'; exact DW.
  - change (Derive (fun x => G x) t) with (Derive G t); rewrite EG.
    change (Derive (fun x => W x) t) with (Derive W t); rewrite EW.
    change (G t * / W t) with a; change ((G0 + - G t) * / (W0 + - W t)) with b.
    generalize (ln a) (ln b); intros; unfold a, b; field; lra.
Qed.

(* The same in bits: near t both shares stay positive, so the convention at 0 plays no part. *)
Theorem derivative_of_two_sided_information : forall (G W : R -> R) (G0 W0 t G' W' : R),
  0 < G t < G0 -> 0 < W t < W0 -> is_derive G t G' -> is_derive W t W' ->
  let a := G t / W t in
  let b := (G0 - G t) / (W0 - W t) in
  is_derive (fun s => two_sided_information G0 W0 (G s) (W s)) t ((G' * ln (a / b) - W' * (a - b)) / ln 2).
Proof.
  intros G W G0 W0 t G' W' HG HW DG DW a b.
  apply is_derive_ext_loc with (fun s => / ln 2 * two_sided_information_ln G0 W0 (G s) (W s)).
  - assert (C : continuous G t) by (apply @ex_derive_continuous; exists G'; exact DG).
    assert (N : locally (G t) (fun y => 0 < y /\ y < G0)).
    { apply (open_and _ _ (open_gt 0) (open_lt G0)); exact HG. }
    apply C in N; unfold filtermap in N; revert N; apply filter_imp; intros s Hs.
    rewrite two_sided_information_in_natural_units by exact Hs.
    match goal with |- ?x = ?y => change (@eq R x y) end; unfold Rdiv; ring.
  - replace ((G' * ln (a / b) - W' * (a - b)) / ln 2)
      with (/ ln 2 * (G' * ln (a / b) - W' * (a - b))) by (unfold Rdiv; ring).
    apply is_derive_scal; apply derivative_of_two_sided_information_ln; assumption.
Qed.

Lemma ln_of_ratio_nonzero : forall a b, 0 < a -> 0 < b -> a <> b -> ln (a / b) <> 0.
Proof.
  intros a b Ha Hb D E; rewrite ln_div in E by assumption.
  apply D, ln_inv; lra.
Qed.

(* Two different flux densities: the derivative vanishes exactly where G' / W' is their logarithmic mean. *)
Theorem cut_is_stationary_iff_ratio_is_logarithmic_mean : forall (G W : R -> R) (G0 W0 t G' W' : R),
  0 < G t < G0 -> 0 < W t < W0 -> is_derive G t G' -> is_derive W t W' -> W' <> 0 ->
  let a := G t / W t in
  let b := (G0 - G t) / (W0 - W t) in
  a <> b ->
  (is_derive (fun s => two_sided_information G0 W0 (G s) (W s)) t 0 <-> G' / W' = logarithmic_mean a b).
Proof.
  intros G W G0 W0 t G' W' HG HW DG DW NW a b Hab.
  assert (Ha : 0 < a) by (apply Rdiv_lt_0_compat; lra).
  assert (Hb : 0 < b) by (apply Rdiv_lt_0_compat; lra).
  pose proof (ln_of_ratio_nonzero a b Ha Hb Hab) as NL.
  pose proof ln_2_positive as L2.
  pose proof (derivative_of_two_sided_information G W G0 W0 t G' W' HG HW DG DW) as D.
  cbv zeta in D; fold a in D; fold b in D.
  unfold logarithmic_mean; destruct (Req_EM_T a b) as [E|_]; [contradiction|].
  split; intro H.
  - pose proof (is_derive_unique _ _ _ D) as E; rewrite (is_derive_unique _ _ _ H) in E.
    assert (E' : G' * ln (a / b) = W' * (a - b)).
    { apply (f_equal (fun x => x * ln 2)) in E; field_simplify in E; lra. }
    apply Rmult_eq_reg_r with (W' * ln (a / b)); [|apply Rmult_integral_contrapositive; auto].
    field_simplify; [lra|exact NL|exact NW].
  - replace 0 with ((G' * ln (a / b) - W' * (a - b)) / ln 2); [exact D|].
    assert (E' : G' = (a - b) / ln (a / b) * W') by (rewrite <- H; field; exact NW).
    rewrite E'; field; lra.
Qed.

(* Equal flux densities: every cut is stationary. *)
Theorem cut_between_equal_densities_is_stationary : forall (G W : R -> R) (G0 W0 t G' W' : R),
  0 < G t < G0 -> 0 < W t < W0 -> is_derive G t G' -> is_derive W t W' ->
  G t / W t = (G0 - G t) / (W0 - W t) ->
  is_derive (fun s => two_sided_information G0 W0 (G s) (W s)) t 0.
Proof.
  intros G W G0 W0 t G' W' HG HW DG DW E.
  pose proof (derivative_of_two_sided_information G W G0 W0 t G' W' HG HW DG DW) as D; cbv zeta in D.
  assert (Hb : 0 < (G0 - G t) / (W0 - W t)) by (apply Rdiv_lt_0_compat; lra).
  rewrite E in D; pose proof ln_2_positive.
  match type of D with is_derive _ _ ?d => replace 0 with d; [exact D|] end.
  replace ((G0 - G t) / (W0 - W t) / ((G0 - G t) / (W0 - W t))) with 1 by (field; lra).
  rewrite ln_1; field; lra.
Qed.

(* The mean square error of two constants, each the average of the radiosity B on its part of [x0, x1], cut at t. *)
Definition average (B : R -> R) (u v : R) : R := RInt B u v / (v - u).

Definition mean_square_error (B : R -> R) (x0 x1 t : R) : R :=
  RInt (fun x => (B x - average B x0 t) ^ 2) x0 t + RInt (fun x => (B x - average B t x1) ^ 2) t x1.

Definition continuous_between (B : R -> R) (x0 x1 : R) : Prop :=
  forall x, x0 <= x <= x1 -> continuous B x.

Lemma continuous_function_is_integrable : forall B x0 x1 u v,
  continuous_between B x0 x1 -> x0 <= u <= v -> v <= x1 -> ex_RInt B u v.
Proof.
  intros B x0 x1 u v C H1 H2; apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
  intros z; rewrite Rmin_left, Rmax_right by lra; intro Hz; apply C; lra.
Qed.

Lemma square_is_continuous : forall B x0 x1,
  continuous_between B x0 x1 -> continuous_between (fun x => B x ^ 2) x0 x1.
Proof.
  intros B x0 x1 C x Hx.
  apply continuous_ext with (fun x => mult (B x) (B x)); [intro y; change mult with Rmult; simpl; ring|].
  apply (continuous_mult (K := R_AbsRing) B B); apply C; exact Hx.
Qed.

(* Expanding the square: the error of any constant c. *)
Lemma square_error_of_a_constant : forall B u v c,
  ex_RInt B u v -> ex_RInt (fun x => B x ^ 2) u v ->
  RInt (fun x => (B x - c) ^ 2) u v = RInt (fun x => B x ^ 2) u v - 2 * c * RInt B u v + c ^ 2 * (v - u).
Proof.
  intros B u v c E1 E2; apply is_RInt_unique.
  apply is_RInt_ext with (fun x => plus (plus (B x ^ 2) (scal (- (2 * c)) (B x))) (c ^ 2)).
  { intros x _; change plus with Rplus; change scal with Rmult; simpl; ring. }
  replace (RInt (fun x => B x ^ 2) u v - 2 * c * RInt B u v + c ^ 2 * (v - u))
    with (plus (plus (RInt (fun x => B x ^ 2) u v) (scal (- (2 * c)) (RInt B u v))) (scal (v - u) (c ^ 2)))
    by (change plus with Rplus; change scal with Rmult; simpl; ring).
  apply @is_RInt_plus; [apply @is_RInt_plus|apply @is_RInt_const].
  - apply (RInt_correct (V := R_CompleteNormedModule)); exact E2.
  - apply @is_RInt_scal, (RInt_correct (V := R_CompleteNormedModule)); exact E1.
Qed.

(* So the error is the integral of the square minus the square of each integral over its length. *)
Theorem mean_square_error_closed_form : forall B x0 x1 t,
  continuous_between B x0 x1 -> x0 < t < x1 ->
  mean_square_error B x0 x1 t =
  RInt (fun x => B x ^ 2) x0 x1 - RInt B x0 t ^ 2 / (t - x0) - (RInt B x0 x1 - RInt B x0 t) ^ 2 / (x1 - t).
Proof.
  intros B x0 x1 t C Ht; pose proof (square_is_continuous B x0 x1 C) as C2.
  pose proof (continuous_function_is_integrable B x0 x1) as I.
  pose proof (continuous_function_is_integrable (fun x => B x ^ 2) x0 x1) as I2.
  assert (S1 : RInt B x0 t + RInt B t x1 = RInt B x0 x1).
  { apply (RInt_Chasles (V := R_CompleteNormedModule)); apply I; (exact C || lra). }
  assert (S2 : RInt (fun x => B x ^ 2) x0 t + RInt (fun x => B x ^ 2) t x1 = RInt (fun x => B x ^ 2) x0 x1).
  { apply (RInt_Chasles (V := R_CompleteNormedModule)); apply I2; (exact C2 || lra). }
  unfold mean_square_error, average.
  rewrite !square_error_of_a_constant by (first [apply I | apply I2]; (assumption || lra)).
  rewrite <- S1, <- S2; field; lra.
Qed.

Lemma derivative_of_integral : forall B x0 x1 t,
  continuous_between B x0 x1 -> x0 < t < x1 -> is_derive (fun s => RInt B x0 s) t (B t).
Proof.
  intros B x0 x1 t C Ht; apply @is_derive_RInt with x0; [|apply C; lra].
  generalize (open_and _ _ (open_gt x0) (open_lt x1) t Ht); apply filter_imp; intros s Hs.
  apply (RInt_correct (V := R_CompleteNormedModule)).
  apply (continuous_function_is_integrable B x0 x1); (exact C || lra).
Qed.

(* Moving the cut moves the point t from one constant to the other; the averages themselves contribute nothing,
   because each is already the best constant on its part. *)
Theorem derivative_of_mean_square_error : forall B x0 x1 t,
  continuous_between B x0 x1 -> x0 < t < x1 ->
  is_derive (mean_square_error B x0 x1) t
    ((B t - average B x0 t) ^ 2 - (B t - average B t x1) ^ 2).
Proof.
  intros B x0 x1 t C Ht.
  apply is_derive_ext_loc with (fun s =>
    RInt (fun x => B x ^ 2) x0 x1 - RInt B x0 s ^ 2 / (s - x0) - (RInt B x0 x1 - RInt B x0 s) ^ 2 / (x1 - s)).
  - generalize (open_and _ _ (open_gt x0) (open_lt x1) t Ht); apply filter_imp; intros s Hs.
    symmetry; apply mean_square_error_closed_form; assumption.
  - pose proof (derivative_of_integral B x0 x1 t C Ht) as D.
    assert (S1 : RInt B x0 t + RInt B t x1 = RInt B x0 x1).
    { apply (RInt_Chasles (V := R_CompleteNormedModule)); apply (continuous_function_is_integrable B x0 x1);
        (exact C || lra). }
    unfold average; replace (RInt B t x1) with (RInt B x0 x1 - RInt B x0 t) by lra.
    set (S := fun s => RInt B x0 s) in *.
    set (Q := RInt (fun x => B x ^ 2) x0 x1); set (T := RInt B x0 x1).
    change (is_derive (fun s => Q - S s ^ 2 / (s - x0) - (T - S s) ^ 2 / (x1 - s)) t
      ((B t - S t / (t - x0)) ^ 2 - (B t - (T - S t) / (x1 - t)) ^ 2)).
    clearbody S Q T; auto_derive.
    + repeat split; (lra || (exists (B t); exact D)).
    + replace (Derive (fun x => S x) t) with (B t) by (symmetry; apply is_derive_unique; exact D).
      field; lra.
Qed.

(* The derivative is the product (second average - first average) (2 B(t) - sum of the averages). *)
Theorem mean_square_cut_is_stationary_iff_radiosity_is_arithmetic_mean : forall B x0 x1 t,
  continuous_between B x0 x1 -> x0 < t < x1 ->
  (is_derive (mean_square_error B x0 x1) t 0 <->
   average B x0 t = average B t x1 \/ B t = arithmetic_mean (average B x0 t) (average B t x1)).
Proof.
  intros B x0 x1 t C Ht; pose proof (derivative_of_mean_square_error B x0 x1 t C Ht) as D.
  unfold arithmetic_mean; set (a := average B x0 t) in *; set (b := average B t x1) in *.
  replace ((B t - a) ^ 2 - (B t - b) ^ 2) with ((b - a) * (2 * B t - a - b)) in D by ring.
  split.
  - intro H; pose proof (is_derive_unique _ _ _ D) as E; rewrite (is_derive_unique _ _ _ H) in E.
    destruct (Rmult_integral _ _ (eq_sym E)); [left|right]; lra.
  - intro H; replace 0 with ((b - a) * (2 * B t - a - b)); [exact D|].
    destruct H as [H|H]; rewrite H; field.
Qed.
