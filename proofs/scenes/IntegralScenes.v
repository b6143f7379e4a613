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
