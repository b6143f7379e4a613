(* Sections 2 and 3.1, eqs. (3) and (4): no division into patches has more mutual information than the continuous scene, whatever
   the surfaces, and occluded or not (the kernel may vanish and jump). It is Jensen's inequality on each pair of patches. Where
   some further division gains anything, the coarser one lies strictly below. Of the integral its rules are used, and that it
   keeps the order of functions. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement IntegralChain.
Open Scope R_scope.

(* F_ij and A_i / A_T of the patches, as integrals of the kernel F(x, y). *)
Definition patch_area {point : Type} (over : nat -> (point -> R) -> R) (i : nat) : R := over i (fun _ => 1).

Definition patch_weight {point : Type} (n : nat) (over : nat -> (point -> R) -> R) (i : nat) : R :=
  patch_area over i / sum n (patch_area over).

Definition patch_form_factor {point : Type} (over : nat -> (point -> R) -> R) (kernel : point -> point -> R) (i j : nat) : R :=
  over i (fun x => over j (kernel x)) / patch_area over i.

(* Eq. (4): 1 / A_T F(x, y) log (A_T F(x, y)), integrated over all pairs of points. *)
Definition information_of_all_points {point : Type} (n : nat) (over : nat -> (point -> R) -> R) (kernel : point -> point -> R) : R :=
  sum n (fun i => sum n (fun j => over i (fun x => over j (fun y =>
    1 / sum n (patch_area over) * xlog2 (kernel x y) (1 / sum n (patch_area over)))))).

(* What must be integrable, and that the integral keeps the order of functions. *)
Record integrable_scene (point : Type) (n : nat) (over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop)
    (kernel : point -> point -> R) : Prop := {
  scene_integrals : integrals point n over integrable;
  integral_keeps_order : forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, f x <= g x) -> over i f <= over i g;
  kernel_nonneg : forall x y, 0 <= kernel x y;
  areas_integrable : integrable (fun _ => 1);
  areas_positive : forall i, (i < n)%nat -> 0 < patch_area over i;
  kernel_integrable : forall x, integrable (kernel x);
  received_integrable : forall j, (j < n)%nat -> integrable (fun x => over j (kernel x));
  logarithms_integrable : forall x,
    integrable (fun y => 1 / sum n (patch_area over) * xlog2 (kernel x y) (1 / sum n (patch_area over)));
  information_integrable : forall j, (j < n)%nat ->
    integrable (fun x => over j (fun y => 1 / sum n (patch_area over) * xlog2 (kernel x y) (1 / sum n (patch_area over))))
}.

Section DiscreteBelowContinuous.
Variables (point : Type) (n : nat) (over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop).
Variable kernel : point -> point -> R.
Hypothesis scene : integrable_scene point n over integrable kernel.
Hypothesis some_patch : (0 < n)%nat.

Let T := sum n (patch_area over).
Let rules := scene_integrals _ _ _ _ _ scene.

Lemma total_area_is_positive : 0 < T.
Proof.
  apply Rlt_le_trans with (patch_area over 0); [now apply (areas_positive _ _ _ _ _ scene)|].
  apply term_le_sum; [|exact some_patch]. intros j Hj. left. now apply (areas_positive _ _ _ _ _ scene).
Qed.

(* The integral of a constant, and of a f + b. *)
Lemma integral_of_affine : forall i a b f, (i < n)%nat -> integrable f ->
  integrable (fun x => a * f x + b) /\ over i (fun x => a * f x + b) = a * over i f + b * patch_area over i.
Proof.
  intros i a b f Hi I. assert (I1 := areas_integrable _ _ _ _ _ scene).
  destruct (integral_of_multiple _ _ _ _ rules i a f Hi I) as [Ia Ea].
  destruct (integral_of_multiple _ _ _ _ rules i b _ Hi I1) as [Ib Eb].
  destruct (integral_of_sum _ _ _ _ rules i _ _ Hi Ia Ib) as [Is Es].
  destruct (integral_of_equals _ _ _ _ rules i (fun x => a * f x + b * 1) (fun x => a * f x + b) Hi) as [I' E'];
    [intros; ring|exact Is|]. split; [exact I'|]. rewrite <- E', Es, Ea, Eb. reflexivity.
Qed.

(* The tangent of x log x at c / T, integrated over a pair of patches. *)
Lemma pair_above_tangent : forall i j c, (i < n)%nat -> (j < n)%nat -> 0 < c ->
  1 / T * (over i (fun x => over j (kernel x)) * log2 c +
    (over i (fun x => over j (kernel x)) - c / T * patch_area over i * patch_area over j) / ln 2)
  <= over i (fun x => over j (fun y => 1 / T * xlog2 (kernel x y) (1 / T))).
Proof.
  intros i j c Hi Hj Hc. assert (HT := total_area_is_positive). assert (L2 := ln_2_positive).
  set (a := 1 / T * (log2 c + / ln 2)). set (b := - (1 / T * (c / T / ln 2))).
  assert (Ij := received_integrable _ _ _ _ _ scene j Hj).
  destruct (integral_of_affine i a (b * patch_area over j) _ Hi Ij) as [I E].
  apply Rle_trans with (over i (fun x => a * over j (kernel x) + b * patch_area over j)).
  - right. rewrite E. unfold a, b. field. lra.
  - apply (integral_keeps_order _ _ _ _ _ scene); [exact Hi|exact I|exact (information_integrable _ _ _ _ _ scene j Hj)|].
    intros x. destruct (integral_of_affine j a b _ Hj (kernel_integrable _ _ _ _ _ scene x)) as [I' E'].
    rewrite <- E'. apply (integral_keeps_order _ _ _ _ _ scene); [exact Hj|exact I'|exact (logarithms_integrable _ _ _ _ _ scene x)|].
    intros y. assert (H1 : 0 < 1 / T) by (apply Rdiv_lt_0_compat; lra).
    destruct (term_above_tangent (kernel x y) (1 / T) c (kernel_nonneg _ _ _ _ _ scene x y)) as [B _]; [lra|lra|exact Hc|].
    apply Rle_trans with (1 / T * (kernel x y * log2 c + (kernel x y - 1 / T * c) / ln 2)).
    + right. unfold a, b. field. lra.
    + apply Rmult_le_compat_l; [lra|exact B].
Qed.

Lemma received_nonneg : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= over i (fun x => over j (kernel x)).
Proof.
  assert (Z : forall i f, (i < n)%nat -> integrable f -> (forall x, 0 <= f x) -> 0 <= over i f).
  { intros i f Hi I H. destruct (integral_of_affine i 0 0 f Hi I) as [I0 E0].
    replace 0 with (over i (fun x => 0 * f x + 0)) by (rewrite E0; ring).
    apply (integral_keeps_order _ _ _ _ _ scene); try assumption. intros x. specialize (H x). lra. }
  intros i j Hi Hj. apply Z; [exact Hi|exact (received_integrable _ _ _ _ _ scene j Hj)|]. intros x.
  apply Z; [exact Hj|exact (kernel_integrable _ _ _ _ _ scene x)|]. exact (kernel_nonneg _ _ _ _ _ scene x).
Qed.

(* Jensen's inequality on one pair. *)
Lemma pair_information_at_most_continuous : forall i j, (i < n)%nat -> (j < n)%nat ->
  patch_weight n over i * xlog2 (patch_form_factor over kernel i j) (patch_weight n over j)
  <= over i (fun x => over j (fun y => 1 / T * xlog2 (kernel x y) (1 / T))).
Proof.
  intros i j Hi Hj. assert (HT := total_area_is_positive). assert (L2 := ln_2_positive).
  assert (Ai := areas_positive _ _ _ _ _ scene i Hi). assert (Aj := areas_positive _ _ _ _ _ scene j Hj).
  assert (N := received_nonneg i j Hi Hj). assert (B := fun c => pair_above_tangent i j c Hi Hj).
  unfold patch_weight, patch_form_factor. fold T.
  set (V := over i (fun x => over j (fun y => 1 / T * xlog2 (kernel x y) (1 / T)))) in *.
  set (J := over i (fun x => over j (kernel x))) in *.
  set (x := patch_area over i) in *. set (y := patch_area over j) in *.
  destruct N as [N|N].
  - (* the tangent at the mean *)
    assert (Hc : 0 < J * T / (x * y)) by (repeat (apply Rdiv_lt_0_compat || apply Rmult_lt_0_compat); lra).
    specialize (B _ Hc).
    assert (HF : 0 < J / x) by (apply Rdiv_lt_0_compat; lra).
    rewrite xlog2_nonzero by lra.
    replace (J / x / (y / T)) with (J * T / (x * y)) by (field; lra).
    replace (J - J * T / (x * y) / T * x * y) with 0 in B by (field; lra).
    replace (x / T * (J / x * log2 (J * T / (x * y)))) with (1 / T * (J * log2 (J * T / (x * y)) + 0 / ln 2)) by (field; lra).
    exact B.
  - (* no light: the tangents near 0 *)
    rewrite <- N. replace (0 / x) with 0 by (field; lra). rewrite xlog2_0, Rmult_0_r. rewrite <- N in B.
    destruct (Rle_dec 0 V) as [|H]; [assumption|exfalso].
    set (c := - V * ln 2 * T * T / (2 * x * y)).
    assert (Hc : 0 < c).
    { unfold c. repeat (apply Rdiv_lt_0_compat || apply Rmult_lt_0_compat); lra. }
    specialize (B c Hc).
    replace (1 / T * (0 * log2 c + (0 - c / T * x * y) / ln 2)) with (V / 2) in B by (unfold c; field; lra). lra.
Qed.

Theorem no_division_has_more_information_than_the_continuous_scene :
  mutual_information n (patch_weight n over) (patch_form_factor over kernel) <= information_of_all_points n over kernel.
Proof.
  unfold mutual_information, information_of_all_points. apply sum_le. intros i Hi. apply sum_le. intros j Hj.
  now apply pair_information_at_most_continuous.
Qed.

(* "Always lower": where some finer division is not a product of the coarse one on each pair of patches, that is where two of
   its parts see two others otherwise than the patches they lie in do, the coarse division lies strictly below. *)
Theorem division_that_can_gain_lies_below_the_continuous_scene : forall coarse parent w P,
  refines coarse n parent w P (patch_weight n over) (patch_form_factor over kernel) ->
  (exists k l, (k < n)%nat /\ (l < n)%nat /\
     joint (patch_weight n over) (patch_form_factor over kernel) k l * (w (parent k) * w (parent l)) <>
     patch_weight n over k * patch_weight n over l * joint w P (parent k) (parent l)) ->
  mutual_information coarse w P < information_of_all_points n over kernel.
Proof.
  intros coarse parent w P R [k [l [Hk [Hl D]]]].
  apply Rlt_le_trans with (2 := no_division_has_more_information_than_the_continuous_scene).
  destruct (refinement_of_several_states_never_lowers_mutual_information coarse n parent w P _ _ R) as [L|E]; [exact L|].
  exfalso. apply D. symmetry in E. now apply (several_states_equal_mutual_information coarse n parent w P _ _ R).
Qed.
End DiscreteBelowContinuous.
