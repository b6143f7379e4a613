(* Sections 3.4 and 3.5: the transition probabilities with integrals extend the discrete ones. Where brightness and what a
   point receives are constant on each patch, the integrals of IntegralChain.v are the discrete P_ij and w_i with the mean
   form factors F_ij = (double integral of F over i and j) / A_i, for which the discrete equation holds. Beside the rules of
   integrals it is used that an integral over a patch depends on the values on that patch alone. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement WeightedScene Radiosity Importance IntegralChain
  IntegralScenes.
Open Scope R_scope.

(* Integrable functions that agree on patch i have the same integral over it. *)
Definition integrals_are_local {point : Type} (n : nat) (over : nat -> (point -> R) -> R)
    (integrable : (point -> R) -> Prop) (patch : point -> nat) : Prop :=
  forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, patch x = i -> f x = g x) -> over i f = over i g.

(* A_i, and F_ij. *)
Definition integral_of_one {point : Type} (over : nat -> (point -> R) -> R) (i : nat) : R := over i (fun _ => 1).

Definition mean_form_factor {point : Type} (over : nat -> (point -> R) -> R) (form_factor : point -> point -> R)
    (i j : nat) : R :=
  over i (fun x => over j (form_factor x)) / integral_of_one over i.

(* The mean form factors exist. *)
Record integrable_form_factor (point : Type) (n : nat) (over : nat -> (point -> R) -> R)
    (integrable : (point -> R) -> Prop) (form_factor : point -> point -> R) : Prop := {
  one_integrable : integrable (fun _ => 1);
  form_factor_integrable : forall x, integrable (form_factor x);
  form_factors_integrable : forall j, (j < n)%nat -> integrable (fun x => over j (form_factor x));
  area_not_zero : forall i, (i < n)%nat -> integral_of_one over i <> 0
}.

Section ConstantOnPatches.
Variables (point : Type) (n : nat) (over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop).
Variables (form_factor : point -> point -> R) (patch : point -> nat).
Hypothesis rules : integrals point n over integrable.
Hypothesis local : integrals_are_local n over integrable patch.
Hypothesis means : integrable_form_factor point n over integrable form_factor.
Local Notation A := (integral_of_one over).
Local Notation F := (mean_form_factor over form_factor).

Lemma mean_form_factor_times_area : forall i j, (i < n)%nat ->
  A i * F i j = over i (fun x => over j (form_factor x)).
Proof.
  intros i j Hi. unfold mean_form_factor. field. exact (area_not_zero _ _ _ _ _ means i Hi).
Qed.

Section Brightness.
Variables brightness received : nat -> R.
Hypothesis kernel : exchange_kernel point n over integrable form_factor (fun x => brightness (patch x)).
Hypothesis equation : forall x,
  received (patch x) = sum n (fun j => over j (fun y => form_factor x y * brightness (patch y))).

(* A constant leaves the integral over its patch. *)
Lemma brightness_leaves : forall x j, (j < n)%nat ->
  over j (fun y => form_factor x y * brightness (patch y)) = brightness j * over j (form_factor x).
Proof.
  intros x j Hj. assert (I := form_factor_integrable _ _ _ _ _ means x).
  destruct (integral_of_multiple _ _ _ _ rules j (brightness j) _ Hj I) as [I' E]. rewrite <- E.
  apply local; [exact Hj|exact (kernel_inner _ _ _ _ _ _ kernel x)|exact I'|]. intros y <-. ring.
Qed.

Lemma exchange_of_constants : forall i j, (i < n)%nat -> (j < n)%nat ->
  integral_exchange over form_factor (fun x => brightness (patch x)) i j = A i * F i j * (brightness i * brightness j).
Proof.
  intros i j Hi Hj. rewrite mean_form_factor_times_area by assumption.
  rewrite <- (constant_factor_leaves point n over integrable form_factor _ rules kernel i j Hi Hj).
  destruct (integral_of_multiple _ _ _ _ rules i (brightness i * brightness j) _ Hi
    (form_factors_integrable _ _ _ _ _ means j Hj)) as [I E].
  rewrite Rmult_comm, <- E. apply local; [exact Hi|now apply (kernel_outer _ _ _ _ _ _ kernel)|exact I|].
  intros x <-. rewrite brightness_leaves by assumption. ring.
Qed.

(* The diffuse equation, integrated over patch i. *)
Lemma received_on_patches : forall i, (i < n)%nat -> received i = gathered n F brightness i.
Proof.
  intros i Hi. assert (HA := area_not_zero _ _ _ _ _ means i Hi).
  apply Rmult_eq_reg_l with (A i); [|exact HA]. unfold gathered. rewrite <- sum_scale.
  rewrite (sum_ext n _ (fun j => over i (fun x => brightness j * over j (form_factor x)))).
  - assert (I : forall j, (j < n)%nat -> integrable (fun x => brightness j * over j (form_factor x))).
    { intros j Hj. exact (proj1 (integral_of_multiple _ _ _ _ rules i (brightness j) _ Hi
        (form_factors_integrable _ _ _ _ _ means j Hj))). }
    destruct (integral_of_finite_sum point n over integrable rules i n (fun j x => brightness j * over j (form_factor x))
      Hi ltac:(lia) I) as [I' E]. rewrite <- E.
    destruct (integral_of_multiple _ _ _ _ rules i (received i) _ Hi (one_integrable _ _ _ _ _ means)) as [I1 E1].
    unfold integral_of_one. rewrite Rmult_comm, <- E1. apply local; [exact Hi|exact I1|exact I'|].
    intros x <-. rewrite Rmult_1_r, equation. apply sum_ext. intros j Hj. now apply brightness_leaves.
  - intros j Hj. rewrite <- Rmult_assoc, mean_form_factor_times_area, Rmult_comm by assumption. symmetry.
    exact (proj2 (integral_of_multiple _ _ _ _ rules i (brightness j) _ Hi
      (form_factors_integrable _ _ _ _ _ means j Hj))).
Qed.

Lemma area_of_constants : forall i, (i < n)%nat ->
  integral_area over (fun x => brightness (patch x)) (fun x => received (patch x)) i = A i * brightness i * received i.
Proof.
  intros i Hi.
  rewrite <- (exchange_row_sum point n over integrable form_factor _ _ rules kernel equation i Hi).
  rewrite received_on_patches by assumption. unfold gathered. rewrite <- sum_scale. apply sum_ext. intros j Hj.
  rewrite exchange_of_constants by assumption. ring.
Qed.

Lemma transition_of_constants : forall i j, (i < n)%nat -> (j < n)%nat -> brightness i <> 0 -> received i <> 0 ->
  integral_transition over form_factor (fun x => brightness (patch x)) (fun x => received (patch x)) i j
  = F i j * brightness j / received i.
Proof.
  intros i j Hi Hj HB HR. unfold integral_transition. rewrite exchange_of_constants, area_of_constants by assumption.
  field. repeat split; try assumption. exact (area_not_zero _ _ _ _ _ means i Hi).
Qed.
End Brightness.

(* Section 3.4: B, E and R constant on each patch. *)
Theorem radiosity_with_integrals_extends_discrete : forall reflectance emittance radiosity : nat -> R,
  exchange_kernel point n over integrable form_factor (fun x => radiosity (patch x)) ->
  (forall x, reflectance (patch x) <> 0) ->
  (forall x, radiosity (patch x) = emittance (patch x)
     + reflectance (patch x) * sum n (fun j => over j (fun y => form_factor x y * radiosity (patch y)))) ->
  let received := fun x => (radiosity (patch x) - emittance (patch x)) / reflectance (patch x) in
  (forall i, (i < n)%nat -> integral_weight n over (fun x => radiosity (patch x)) received i
     = radiosity_weight n (integral_of_one over) reflectance emittance radiosity i) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> reflectance i <> 0 -> radiosity i <> 0 -> radiosity i <> emittance i ->
     integral_transition over form_factor (fun x => radiosity (patch x)) received i j
     = radiosity_transition (mean_form_factor over form_factor) reflectance emittance radiosity i j) /\
  ((forall i, (i < n)%nat -> reflectance i <> 0) ->
     radiosity_equation n (mean_form_factor over form_factor) reflectance emittance radiosity).
Proof.
  intros r E B K Hr H received. set (q := fun i => (B i - E i) / r i).
  assert (Hq : forall x, q (patch x) = sum n (fun j => over j (fun y => form_factor x y * B (patch y)))).
  { intros x. unfold q. rewrite (H x) at 1. field. apply Hr. }
  assert (HA := area_of_constants B q K Hq). split; [|split].
  - intros i Hi. unfold integral_weight, radiosity_weight. f_equal; [now apply HA|]. apply sum_ext. exact HA.
  - intros i j Hi Hj Hri HB HE. transitivity (F i j * B j / q i).
    + apply (transition_of_constants B q K Hq i j Hi Hj HB). unfold q. apply Rmult_integral_contrapositive_currified;
        [lra|now apply Rinv_neq_0_compat].
    + unfold q, radiosity_transition. field. lra.
  - intros Hrn i Hi. assert (G := received_on_patches B q K Hq i Hi). unfold gathered in G. rewrite <- G. unfold q.
    field. auto.
Qed.

(* Section 3.5: I, V and R constant on each patch. *)
Theorem importance_with_integrals_extends_discrete : forall reflectance initial_importance importance : nat -> R,
  exchange_kernel point n over integrable form_factor (fun x => reflectance (patch x) * importance (patch x)) ->
  (forall x, importance (patch x) = initial_importance (patch x)
     + sum n (fun j => over j (fun y => form_factor x y * (reflectance (patch y) * importance (patch y))))) ->
  let brightness := fun x => reflectance (patch x) * importance (patch x) in
  let received := fun x => importance (patch x) - initial_importance (patch x) in
  (forall i, (i < n)%nat -> integral_weight n over brightness received i
     = importance_weight n (integral_of_one over) reflectance initial_importance importance i) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> reflectance i * importance i <> 0 -> importance i <> initial_importance i ->
     integral_transition over form_factor brightness received i j
     = importance_transition (mean_form_factor over form_factor) reflectance initial_importance importance i j) /\
  importance_equation n (mean_form_factor over form_factor) reflectance initial_importance importance.
Proof.
  intros r V I K H brightness received. set (b := fun i => r i * I i). set (q := fun i => I i - V i).
  assert (Hq : forall x, q (patch x) = sum n (fun j => over j (fun y => form_factor x y * b (patch y)))).
  { intros x. unfold q. rewrite (H x). unfold b. ring. }
  assert (HA := area_of_constants b q K Hq). split; [|split].
  - intros i Hi. unfold integral_weight, importance_weight. f_equal; [now apply HA|]. apply sum_ext. exact HA.
  - intros i j Hi Hj HB HV. transitivity (F i j * b j / q i).
    + apply (transition_of_constants b q K Hq i j Hi Hj HB). unfold q. lra.
    + unfold b, q, importance_transition. field. lra.
  - intros i Hi. assert (G := received_on_patches b q K Hq i Hi). unfold gathered, q, b in G.
    rewrite (sum_ext n _ (fun j => F i j * (r j * I j))) by (intros; ring). lra.
Qed.
End ConstantOnPatches.

(* Sums over elements, each in one patch, are local. *)
Theorem sums_over_elements_are_local : forall (n N : nat) (patch : nat -> nat) (area : nat -> R),
  integrals_are_local n (fun i f => part_sum N patch i (fun k => area k * f k)) (fun _ => True) patch.
Proof. intros n N patch area i f g _ _ _ H. apply part_sum_ext. intros k _ Hk. now rewrite (H k Hk). Qed.

(* All hypotheses can be met together: two patches that see only each other, of one element each, R = 1/2, E = (1, 0). *)
Definition two_patch_of (x : nat) : nat := match x with O => O | _ => 1%nat end.

Theorem constants_on_two_patches_fulfil_hypotheses :
  let over := fun i f => part_sum 2 two_patch_of i (fun k => 1 * f k) in
  let integrable := fun _ : nat -> R => True in
  let kernel := fun x y => two_patch_form_factor (two_patch_of x) (two_patch_of y) in
  integrals nat 2 over integrable /\ integrals_are_local 2 over integrable two_patch_of /\
  integrable_form_factor nat 2 over integrable kernel /\
  exchange_kernel nat 2 over integrable kernel (fun x => two_patch_radiosity (two_patch_of x)) /\
  (forall x, two_patch_radiosity (two_patch_of x) = two_patch_emittance (two_patch_of x)
     + 1 / 2 * sum 2 (fun j => over j (fun y => kernel x y * two_patch_radiosity (two_patch_of y)))).
Proof.
  intros over integrable kernel. split; [|split; [|split; [|split]]].
  - exact (sums_over_elements_are_integrals 2 2 two_patch_of (fun _ => 1)).
  - exact (sums_over_elements_are_local 2 2 two_patch_of (fun _ => 1)).
  - constructor; try easy. intros i Hi. unfold integral_of_one, over.
    destruct i as [|[|]]; [| |lia]; unfold part_sum; simpl; lra.
  - constructor; try easy.
    + intros x y. unfold kernel, two_patch_form_factor. now rewrite Nat.eqb_sym.
    + intros i j Hi Hj. unfold over, part_sum, kernel. destruct i as [|[|]]; [| |lia]; destruct j as [|[|]]; try lia; simpl;
        unfold two_patch_form_factor; simpl; ring.
  - intros x. unfold over, part_sum, kernel, two_patch_form_factor. destruct x; simpl; lra.
Qed.
