(* Sections 2, 3.4 and 3.5 with integrals, continued: radiosity and importance as the brightness of IntegralChain.v, their
   reversion to visibility, and the stationary density of the continuous visibility chain. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement IntegralChain.
Open Scope R_scope.

Section IntegralScenes.
Variables (point : Type) (n : nat) (over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop).
Variable form_factor : point -> point -> R.
Hypothesis rules : integrals point n over integrable.

(* The diffuse equation, solved for what reaches a point: brightness B. *)
Theorem radiosity_received_with_integrals : forall reflectance emittance radiosity,
  (forall x, reflectance x <> 0) ->
  (forall x, radiosity x = emittance x + reflectance x * sum n (fun j => over j (fun y => form_factor x y * radiosity y))) ->
  forall x, (radiosity x - emittance x) / reflectance x = sum n (fun j => over j (fun y => form_factor x y * radiosity y)).
Proof. intros r E B Hr H x. rewrite (H x) at 1. field. apply Hr. Qed.

(* The equation of importance: brightness R I. *)
Theorem importance_received_with_integrals : forall reflectance initial_importance importance,
  (forall x, integrable (fun y => reflectance y * form_factor x y * importance y)) ->
  (forall x, importance x =
     initial_importance x + sum n (fun j => over j (fun y => reflectance y * form_factor x y * importance y))) ->
  forall x, importance x - initial_importance x =
    sum n (fun j => over j (fun y => form_factor x y * (reflectance y * importance y))).
Proof.
  intros r V I Hint H x. rewrite (H x). transitivity (sum n (fun j => over j (fun y => r y * form_factor x y * I y))); [ring|].
  apply sum_ext. intros j Hj. apply (integral_of_equals _ _ _ _ rules j); [exact Hj| |apply Hint]. intros y. ring.
Qed.

(* In a closed scene a constant radiosity solves the equation exactly when E = k (1 - R) ... *)
Theorem constant_radiosity_solves_with_integrals_iff : forall k reflectance emittance,
  (forall x, integrable (form_factor x)) -> (forall x, sum n (fun j => over j (form_factor x)) = 1) ->
  (forall x : point, k = emittance x + reflectance x * sum n (fun j => over j (fun y => form_factor x y * k))) <->
  (forall x, emittance x = k * (1 - reflectance x)).
Proof.
  intros k r E HF HC.
  assert (G : forall x, sum n (fun j => over j (fun y => form_factor x y * k)) = k).
  { intros x. rewrite (sum_ext n _ (fun j => k * over j (form_factor x))).
    - rewrite sum_scale, HC. ring.
    - intros j Hj. destruct (integral_of_multiple _ _ _ _ rules j k (form_factor x) Hj (HF x)) as [I E']. rewrite <- E'.
      symmetry. apply (integral_of_equals _ _ _ _ rules j); [exact Hj| |exact I]. intros y. ring. }
  split; intros H x; specialize (H x); rewrite G in *; lra.
Qed.

(* ... and the chain of a constant brightness is the visibility chain: the mean form factor, and the relative area. *)
Theorem constant_brightness_with_integrals_is_visibility : forall k, k <> 0 ->
  (forall x, integrable (form_factor x)) -> integrable (fun _ => 1) ->
  (forall j, (j < n)%nat -> integrable (fun x => over j (form_factor x))) ->
  (forall i, (i < n)%nat -> over i (fun _ => 1) <> 0) ->
  forall i, (i < n)%nat ->
  integral_weight n over (fun _ => k) (fun _ => k) i = over i (fun _ => 1) / sum n (fun j => over j (fun _ => 1)) /\
  forall j, (j < n)%nat ->
    integral_transition over form_factor (fun _ => k) (fun _ => k) i j =
    over i (fun x => over j (form_factor x)) / over i (fun _ => 1).
Proof.
  intros k Hk HF H1 HFF HA i Hi.
  assert (A : forall j, (j < n)%nat -> integral_area over (fun _ => k) (fun _ => k) j = k * k * over j (fun _ => 1)).
  { intros j Hj. destruct (integral_of_multiple _ _ _ _ rules j (k * k) _ Hj H1) as [I E]. rewrite <- E. unfold integral_area.
    symmetry. apply (integral_of_equals _ _ _ _ rules j); [exact Hj| |exact I]. intros y. ring. }
  split.
  - unfold integral_weight. rewrite A by exact Hi.
    rewrite (sum_ext n _ (fun j => k * k * over j (fun _ => 1))) by (intros; now apply A). rewrite sum_scale.
    destruct (Req_dec (sum n (fun j => over j (fun _ => 1))) 0) as [Z|N].
    + rewrite Z, Rmult_0_r. unfold Rdiv. rewrite Rinv_0. ring.
    + field. split; assumption.
  - intros j Hj. unfold integral_transition. rewrite A by exact Hi.
    replace (integral_exchange over form_factor (fun _ => k) i j) with (k * k * over i (fun x => over j (form_factor x))).
    + field. split; [now apply HA|exact Hk].
    + destruct (integral_of_multiple _ _ _ _ rules i (k * k) _ Hi (HFF j Hj)) as [I E]. rewrite <- E.
      apply (integral_of_equals _ _ _ _ rules i); [exact Hi| |exact I]. intros x.
      destruct (integral_of_multiple _ _ _ _ rules j (k * k) _ Hj (HF x)) as [I' E']. rewrite <- E'.
      apply (integral_of_equals _ _ _ _ rules j); [exact Hj| |exact I']. intros y. ring.
Qed.

(* In a closed scene R I = k solves the equation of importance exactly when V = k (1 / R - 1). *)
Theorem uniform_reflected_importance_solves_with_integrals_iff : forall k reflectance initial_importance,
  (forall x, integrable (form_factor x)) -> (forall x, sum n (fun j => over j (form_factor x)) = 1) ->
  (forall x : point, reflectance x <> 0) ->
  (forall x, k / reflectance x = initial_importance x +
     sum n (fun j => over j (fun y => reflectance y * form_factor x y * (k / reflectance y)))) <->
  (forall x, initial_importance x = k * (1 / reflectance x - 1)).
Proof.
  intros k r V HF HC Hr.
  assert (G : forall x, sum n (fun j => over j (fun y => r y * form_factor x y * (k / r y))) = k).
  { intros x. rewrite (sum_ext n _ (fun j => k * over j (form_factor x))).
    - rewrite sum_scale, HC. ring.
    - intros j Hj. destruct (integral_of_multiple _ _ _ _ rules j k (form_factor x) Hj (HF x)) as [I E']. rewrite <- E'.
      symmetry. apply (integral_of_equals _ _ _ _ rules j); [exact Hj| |exact I]. intros y. field. apply Hr. }
  split; intros H x; specialize (H x); rewrite G in *.
  - replace (k * (1 / r x - 1)) with (k / r x - k) by (field; apply Hr). lra.
  - rewrite H. field. apply Hr.
Qed.

(* There is one bounded solution at most, where no more than a share rho < 1 is reflected: what two of them differ by is at
   most rho times as much, and so on. *)
Theorem bounded_radiosity_with_integrals_is_unique : forall rho bound reflectance emittance radiosity radiosity',
  (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, f x <= g x) -> over i f <= over i g) ->
  (forall x y, 0 <= form_factor x y) -> (forall x, integrable (form_factor x)) ->
  (forall x, sum n (fun j => over j (form_factor x)) <= 1) -> rho < 1 -> (forall x, 0 <= reflectance x <= rho) ->
  (forall x, integrable (fun y => form_factor x y * radiosity y)) ->
  (forall x, integrable (fun y => form_factor x y * radiosity' y)) ->
  (forall x, Rabs (radiosity x) <= bound) -> (forall x, Rabs (radiosity' x) <= bound) ->
  (forall x, radiosity x = emittance x + reflectance x * sum n (fun j => over j (fun y => form_factor x y * radiosity y))) ->
  (forall x, radiosity' x = emittance x + reflectance x * sum n (fun j => over j (fun y => form_factor x y * radiosity' y))) ->
  forall x : point, radiosity x = radiosity' x.
Proof.
  intros rho b r E B B' order F0 HF HC Hrho Hr IB IB' Bb Bb' HB HB' x0.
  assert (Rp : 0 <= rho) by (specialize (Hr x0); lra).
  set (d := fun x => B x - B' x).
  assert (step : forall M, 0 <= M -> (forall x, Rabs (d x) <= M) -> forall x, Rabs (d x) <= rho * M).
  { intros M HM Hd x.
    assert (part : forall j, (j < n)%nat -> - (M * over j (form_factor x)) <=
      over j (fun y => form_factor x y * B y) - over j (fun y => form_factor x y * B' y) <= M * over j (form_factor x)).
    { intros j Hj. destruct (integral_of_multiple _ _ _ _ rules j M _ Hj (HF x)) as [IM EM]. rewrite <- EM.
      destruct (integral_of_sum _ _ _ _ rules j _ _ Hj (IB' x) IM) as [I1 E1].
      destruct (integral_of_sum _ _ _ _ rules j _ _ Hj (IB x) IM) as [I2 E2].
      assert (L1 := order j _ _ Hj (IB x) I1). assert (L2 := order j _ _ Hj (IB' x) I2). rewrite E1 in L1. rewrite E2 in L2.
      assert (D : forall y, - M <= d y <= M).
      { intros y. specialize (Hd y). assert (L := Rle_abs (- d y)). rewrite Rabs_Ropp in L. assert (L' := Rle_abs (d y)). lra. }
      unfold d in D.
      split.
      - apply Rplus_le_reg_r with (over j (fun y => M * form_factor x y)).
        cut (over j (fun y => form_factor x y * B' y) <= over j (fun y => form_factor x y * B y) + over j (fun y => M * form_factor x y)); [lra|].
        apply L2. intros y. specialize (D y). specialize (F0 x y).
        assert (form_factor x y * (B' y - B y) <= form_factor x y * M) by (apply Rmult_le_compat_l; lra). lra.
      - cut (over j (fun y => form_factor x y * B y) <= over j (fun y => form_factor x y * B' y) + over j (fun y => M * form_factor x y)); [lra|].
        apply L1. intros y. specialize (D y). specialize (F0 x y).
        assert (form_factor x y * (B y - B' y) <= form_factor x y * M) by (apply Rmult_le_compat_l; lra). lra. }
    set (s := sum n (fun j => over j (fun y => form_factor x y * B y)) - sum n (fun j => over j (fun y => form_factor x y * B' y))).
    assert (S : - M <= s <= M).
    { assert (C0 : M * sum n (fun j => over j (form_factor x)) <= M) by (rewrite <- (Rmult_1_r M) at 2; apply Rmult_le_compat_l; auto).
      rewrite <- sum_scale in C0.
      assert (U : sum n (fun j => over j (fun y => form_factor x y * B y)) <=
        sum n (fun j => over j (fun y => form_factor x y * B' y) + M * over j (form_factor x)))
        by (apply sum_le; intros j Hj; specialize (part j Hj); lra).
      assert (L : sum n (fun j => over j (fun y => form_factor x y * B' y)) <=
        sum n (fun j => over j (fun y => form_factor x y * B y) + M * over j (form_factor x)))
        by (apply sum_le; intros j Hj; specialize (part j Hj); lra).
      rewrite sum_plus in U, L. unfold s. lra. }
    assert (Ed : d x = r x * s) by (unfold d, s; rewrite (HB x), (HB' x); ring).
    rewrite Ed, Rabs_mult, (Rabs_pos_eq (r x)) by (specialize (Hr x); lra). specialize (Hr x).
    apply Rmult_le_compat; [lra|apply Rabs_pos|lra|]. now apply Rabs_le. }
  assert (b0 : 0 <= b) by (apply Rle_trans with (1 := Rabs_pos (B x0)); apply Bb).
  assert (all : forall k x, Rabs (d x) <= rho ^ k * (2 * b)).
  { induction k as [|k IH]; intros x.
    - unfold d. simpl. specialize (Bb x). specialize (Bb' x).
      assert (T := Rabs_triang (B x) (- B' x)). rewrite Rabs_Ropp in T. unfold Rminus. lra.
    - simpl. rewrite Rmult_assoc. apply step; [|exact IH]. apply Rmult_le_pos; [now apply pow_le|lra]. }
  destruct (Req_dec (d x0) 0) as [Z|N]; [unfold d in Z; lra|exfalso].
  assert (P := Rabs_pos_lt _ N).
  destruct (pow_lt_1_zero rho ltac:(rewrite Rabs_pos_eq; assumption) (Rabs (d x0) / (2 * b + 1))) as [K HK];
    [apply Rdiv_lt_0_compat; lra|].
  specialize (HK K (Nat.le_refl K)). rewrite Rabs_pos_eq in HK by now apply pow_le. specialize (all K x0).
  assert (Q : 0 <= rho ^ K) by now apply pow_le.
  apply (Rmult_lt_compat_r (2 * b + 1)) in HK; [|lra]. unfold Rdiv in HK. rewrite Rmult_assoc, Rinv_l in HK by lra. lra.
Qed.

(* So is importance, whose R I solves such an equation. *)
Theorem bounded_importance_with_integrals_is_unique : forall rho bound reflectance initial_importance importance importance',
  (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, f x <= g x) -> over i f <= over i g) ->
  (forall x y, 0 <= form_factor x y) -> (forall x, integrable (form_factor x)) ->
  (forall x, sum n (fun j => over j (form_factor x)) <= 1) -> rho < 1 -> (forall x, 0 <= reflectance x <= rho) ->
  (forall x, integrable (fun y => reflectance y * form_factor x y * importance y)) ->
  (forall x, integrable (fun y => reflectance y * form_factor x y * importance' y)) ->
  (forall x, Rabs (reflectance x * importance x) <= bound) -> (forall x, Rabs (reflectance x * importance' x) <= bound) ->
  (forall x, importance x =
     initial_importance x + sum n (fun j => over j (fun y => reflectance y * form_factor x y * importance y))) ->
  (forall x, importance' x =
     initial_importance x + sum n (fun j => over j (fun y => reflectance y * form_factor x y * importance' y))) ->
  forall x : point, importance x = importance' x.
Proof.
  intros rho b r V I I' order F0 HF HC Hrho Hr II II' Ib Ib' HI HI' x.
  destruct (Nat.eq_dec n 0) as [Z|N0]; [rewrite (HI x), (HI' x), Z; reflexivity|].
  assert (integrable_reflected : forall u, (forall x, integrable (fun y => r y * form_factor x y * u y)) ->
    forall x, integrable (fun y => form_factor x y * (r y * u y))).
  { intros u Hu z. apply (integral_of_equals _ _ _ _ rules 0 (fun y => r y * form_factor z y * u y)); [lia| |apply Hu].
    intros y. ring. }
  assert (reflected : forall u, (forall x, integrable (fun y => r y * form_factor x y * u y)) ->
    (forall x, u x = V x + sum n (fun j => over j (fun y => r y * form_factor x y * u y))) ->
    forall x, r x * u x = r x * V x + r x * sum n (fun j => over j (fun y => form_factor x y * (r y * u y)))).
  { intros u Hu Eu z. assert (E := importance_received_with_integrals r V u Hu Eu z). rewrite <- E. ring. }
  assert (U := bounded_radiosity_with_integrals_is_unique rho b r (fun x => r x * V x) (fun x => r x * I x) (fun x => r x * I' x)
    order F0 HF HC Hrho Hr (integrable_reflected I II) (integrable_reflected I' II') Ib Ib' (reflected I II HI) (reflected I' II' HI')).
  assert (E := importance_received_with_integrals r V I II HI x). assert (E' := importance_received_with_integrals r V I' II' HI' x).
  assert (S : sum n (fun j => over j (fun y => form_factor x y * (r y * I y))) =
    sum n (fun j => over j (fun y => form_factor x y * (r y * I' y)))).
  { apply sum_ext. intros j Hj. apply (integral_of_equals _ _ _ _ rules j); [exact Hj| |exact (integrable_reflected I II x)].
    intros y. now rewrite U. }
  lra.
Qed.

(* Section 2: the chain of infinitesimal areas of a closed scene has the stationary density 1 / A_T. *)
Theorem continuous_visibility_has_constant_density : forall total,
  (forall x y, form_factor x y = form_factor y x) ->
  (forall x, integrable (form_factor x)) -> (forall x, sum n (fun j => over j (form_factor x)) = 1) ->
  forall y, sum n (fun i => over i (fun x => 1 / total * form_factor x y)) = 1 / total.
Proof.
  intros total HS HF HC y. rewrite (sum_ext n _ (fun i => 1 / total * over i (form_factor y))).
  - rewrite sum_scale, HC. ring.
  - intros i Hi. destruct (integral_of_multiple _ _ _ _ rules i (1 / total) _ Hi (HF y)) as [I E]. rewrite <- E.
    symmetry. apply (integral_of_equals _ _ _ _ rules i); [exact Hi| |exact I]. intros x. now rewrite HS.
Qed.
End IntegralScenes.

(* The rules can be met: sums over finitely many elements of area A_k, each in one patch, obey them. *)
Theorem sums_over_elements_are_integrals : forall (n N : nat) (patch : nat -> nat) (area : nat -> R),
  integrals nat n (fun i f => part_sum N patch i (fun k => area k * f k)) (fun _ => True).
Proof.
  intros n N patch area. constructor.
  - intros i f g _ _ _. split; [exact I|]. unfold part_sum. rewrite <- sum_plus. apply sum_ext. intros k _.
    destruct (Nat.eqb (patch k) i); ring.
  - intros i c f _ _. split; [exact I|]. unfold part_sum. rewrite <- sum_scale. apply sum_ext. intros k _.
    destruct (Nat.eqb (patch k) i); ring.
  - intros i f g _ E _. split; [exact I|]. apply part_sum_ext. intros k _ _. now rewrite E.
Qed.
