(* Sections 3.4 and 3.5 as the paper writes them, with integrals over the patches: "due to the additivity of the integral".
   A brightness X (B for radiosity, R I for importance) that varies from point to point, F(x, y) symmetric, and what
   reaches a point, received x = sum over the patches j of the integral of F(x, y) X(y) over j, which the diffuse equation
   says is (B - E) / R, or I - V. Of the integral nothing is used but its rules: sums, constant factors, and exchange of the
   order; so the proofs hold for whatever surfaces and whatever integral obey them. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement StateRefinement Theorem1.
Open Scope R_scope.

(* [over i f] is the integral of f over patch i, for the functions f that are integrable. *)
Record integrals (point : Type) (n : nat) (over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop) : Prop := {
  integral_of_sum : forall i f g, (i < n)%nat -> integrable f -> integrable g ->
    integrable (fun x => f x + g x) /\ over i (fun x => f x + g x) = over i f + over i g;
  integral_of_multiple : forall i c f, (i < n)%nat -> integrable f ->
    integrable (fun x => c * f x) /\ over i (fun x => c * f x) = c * over i f;
  integral_of_equals : forall i f g, (i < n)%nat -> (forall x, f x = g x) -> integrable f ->
    integrable g /\ over i f = over i g
}.

(* A kernel F(x, y) X(x) X(y) may be integrated over the patches one variable after the other, in either order. *)
Record exchange_kernel (point : Type) (n : nat) (over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop)
    (form_factor : point -> point -> R) (brightness : point -> R) : Prop := {
  kernel_symmetric : forall x y, form_factor x y = form_factor y x;
  kernel_inner : forall x, integrable (fun y => form_factor x y * brightness y);
  kernel_outer : forall j, (j < n)%nat ->
    integrable (fun x => brightness x * over j (fun y => form_factor x y * brightness y));
  kernel_order : forall i j, (i < n)%nat -> (j < n)%nat ->
    over i (fun x => over j (fun y => form_factor x y * brightness x * brightness y)) =
    over j (fun y => over i (fun x => form_factor x y * brightness x * brightness y))
}.

(* The double integral of F(x, y) X(x) X(y) over patches i and j. *)
Definition integral_exchange {point : Type} (over : nat -> (point -> R) -> R) (form_factor : point -> point -> R)
    (brightness : point -> R) (i j : nat) : R :=
  over i (fun x => over j (fun y => form_factor x y * brightness x * brightness y)).

(* The integral of X received over patch i, the paper's w_i before normalisation. *)
Definition integral_area {point : Type} (over : nat -> (point -> R) -> R) (brightness received : point -> R) (i : nat) : R :=
  over i (fun x => brightness x * received x).

Definition integral_weight {point : Type} (n : nat) (over : nat -> (point -> R) -> R) (brightness received : point -> R)
    (i : nat) : R :=
  integral_area over brightness received i / sum n (integral_area over brightness received).

(* The paper's P_ij. *)
Definition integral_transition {point : Type} (over : nat -> (point -> R) -> R) (form_factor : point -> point -> R)
    (brightness received : point -> R) (i j : nat) : R :=
  integral_exchange over form_factor brightness i j / integral_area over brightness received i.

Section IntegralChain.
Variables (point : Type) (n : nat) (over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop).
Variables (form_factor : point -> point -> R) (brightness received : point -> R).
Hypothesis rules : integrals point n over integrable.
Hypothesis kernel : exchange_kernel point n over integrable form_factor brightness.
(* The diffuse equation. *)
Hypothesis equation : forall x, received x = sum n (fun j => over j (fun y => form_factor x y * brightness y)).

Local Notation J := (integral_exchange over form_factor brightness).
Local Notation A := (integral_area over brightness received).

Lemma integral_of_finite_sum : forall i m f, (i < n)%nat -> (0 < m)%nat -> (forall k, (k < m)%nat -> integrable (f k)) ->
  integrable (fun x => sum m (fun k => f k x)) /\ over i (fun x => sum m (fun k => f k x)) = sum m (fun k => over i (f k)).
Proof.
  intros i m f Hi Hm Hf. induction m as [|m IH]; [lia|]. destruct (Nat.eq_dec m 0) as [->|N].
  - simpl. destruct (integral_of_equals _ _ _ _ rules i (f 0%nat) (fun x => 0 + f 0%nat x) Hi) as [I E]; auto.
    + intros. ring.
    + split; [exact I|]. rewrite <- E. ring.
  - simpl. destruct IH as [I E]; [lia|auto|].
    destruct (integral_of_sum _ _ _ _ rules i (fun x => sum m (fun k => f k x)) (f m) Hi I) as [I' E']; [auto|].
    split; [exact I'|]. now rewrite E', E.
Qed.

(* X(x) leaves the inner integral. *)
Lemma constant_factor_leaves : forall i j, (i < n)%nat -> (j < n)%nat ->
  over i (fun x => brightness x * over j (fun y => form_factor x y * brightness y)) = J i j.
Proof.
  intros i j Hi Hj. apply (integral_of_equals _ _ _ _ rules i); [exact Hi| |now apply (kernel_outer _ _ _ _ _ _ kernel)].
  intros x. assert (I := kernel_inner _ _ _ _ _ _ kernel x).
  destruct (integral_of_multiple _ _ _ _ rules j (brightness x) _ Hj I) as [I' E]. rewrite <- E.
  apply (integral_of_equals _ _ _ _ rules j); [exact Hj| |exact I']. intros y. ring.
Qed.

(* "The additivity of the integral over its domain": what leaves i for all patches is the integral of X received over i. *)
Lemma exchange_row_sum : forall i, (i < n)%nat -> sum n (fun j => J i j) = A i.
Proof.
  intros i Hi. rewrite (sum_ext n _ (fun j => over i (fun x => brightness x *
    over j (fun y => form_factor x y * brightness y)))) by (intros; symmetry; now apply constant_factor_leaves).
  destruct (integral_of_finite_sum i n (fun j x => brightness x * over j (fun y => form_factor x y * brightness y)) Hi)
    as [I E]; [lia| |].
  - intros. now apply (kernel_outer _ _ _ _ _ _ kernel).
  - rewrite <- E. apply (integral_of_equals _ _ _ _ rules i); [exact Hi| |exact I].
    intros x. rewrite equation, <- sum_scale. reflexivity.
Qed.

Lemma exchange_symmetric : forall i j, (i < n)%nat -> (j < n)%nat -> J i j = J j i.
Proof.
  intros i j Hi Hj. unfold integral_exchange at 1. rewrite (kernel_order _ _ _ _ _ _ kernel) by assumption.
  rewrite <- (constant_factor_leaves j i) by assumption. symmetry.
  apply (integral_of_equals _ _ _ _ rules j); [exact Hj| |now apply (kernel_outer _ _ _ _ _ _ kernel)].
  intros x. assert (I := kernel_inner _ _ _ _ _ _ kernel x).
  destruct (integral_of_multiple _ _ _ _ rules i (brightness x) _ Hi I) as [I' E]. rewrite <- E.
  apply (integral_of_equals _ _ _ _ rules i); [exact Hi| |exact I']. intros y.
  rewrite (kernel_symmetric _ _ _ _ _ _ kernel x y). ring.
Qed.

Theorem integral_rows_sum_to_one : forall i, (i < n)%nat -> integral_area over brightness received i <> 0 ->
  sum n (fun j => integral_transition over form_factor brightness received i j) = 1.
Proof.
  intros i Hi H. unfold integral_transition, Rdiv. rewrite sum_scale_right.
  rewrite exchange_row_sum by assumption. now apply Rinv_r.
Qed.

Theorem integral_chain_is_reciprocal : (forall i, (i < n)%nat -> integral_area over brightness received i <> 0) ->
  reciprocal n (integral_weight n over brightness received) (integral_transition over form_factor brightness received).
Proof.
  intros H i j Hi Hj. unfold joint, integral_weight, integral_transition.
  assert (E : forall a b, (a < n)%nat -> A a / sum n A * (J a b / A a) = J a b * / sum n A).
  { intros a b Ha. specialize (H a Ha). unfold Rdiv.
    replace (A a * / sum n A * (J a b * / A a)) with (A a * / A a * (J a b * / sum n A)) by ring.
    rewrite Rinv_r by assumption. ring. }
  rewrite !E, (exchange_symmetric i j) by assumption. reflexivity.
Qed.

(* The weights as the paper gives them, without their normalising factor, are stationary too. *)
Theorem integral_weights_are_stationary : (forall i, (i < n)%nat -> integral_area over brightness received i <> 0) ->
  stationary n (integral_area over brightness received) (integral_transition over form_factor brightness received) /\
  stationary n (integral_weight n over brightness received) (integral_transition over form_factor brightness received).
Proof.
  intros H.
  assert (S : stationary n (integral_area over brightness received)
    (integral_transition over form_factor brightness received)).
  { intros j Hj. rewrite <- (exchange_row_sum j Hj). apply sum_ext. intros i Hi. unfold joint, integral_transition.
    rewrite (exchange_symmetric j i) by assumption. specialize (H i Hi). field. exact H. }
  split; [exact S|]. intros j Hj. unfold joint, integral_weight, Rdiv.
  rewrite (sum_ext n _ (fun i => integral_area over brightness received i *
    integral_transition over form_factor brightness received i j * / sum n (integral_area over brightness received)))
    by (intros; ring).
  rewrite sum_scale_right. f_equal. exact (S j Hj).
Qed.

Theorem integral_chain_is_markov : (0 < n)%nat ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= integral_exchange over form_factor brightness i j) ->
  (forall i, (i < n)%nat -> 0 < integral_area over brightness received i) ->
  markov_chain n (integral_weight n over brightness received) (integral_transition over form_factor brightness received).
Proof.
  intros Hn HJ HA. assert (T : 0 < sum n (integral_area over brightness received)).
  { apply Rlt_le_trans with (1 := HA 0%nat Hn). apply term_le_sum; [|exact Hn]. intros. left. now apply HA. }
  constructor.
  - intros i Hi. left. apply Rdiv_lt_0_compat; auto.
  - intros i j Hi Hj. apply Rmult_le_pos; [now apply HJ|]. left. now apply Rinv_0_lt_compat, HA.
  - unfold integral_weight, Rdiv. rewrite sum_scale_right. apply Rinv_r. lra.
  - intros i Hi. apply integral_rows_sum_to_one; [exact Hi|]. specialize (HA i Hi). lra.
Qed.
End IntegralChain.

(* ---- Dividing a patch ----
   The integral over patch s is the sum of the integrals over its parts, the others stay as they are: the hypotheses of
   Theorem 1, "due to the additivity of the integrand". *)
Section Dividing.
Variables (point : Type) (n s m : nat) (over part_over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop).
Variables (form_factor : point -> point -> R) (brightness received : point -> R).
Hypothesis patch_below : (s < n)%nat.
Hypothesis some_part : (1 <= m)%nat.
Hypothesis rules : integrals point (n - 1 + m) part_over integrable.
Hypothesis kernel : exchange_kernel point (n - 1 + m) part_over integrable form_factor brightness.
Hypothesis other_patches : forall j f, (j < n)%nat -> j <> s -> part_over j f = over j f.
Hypothesis divided_patch : forall f, over s f = sum m (fun k => part_over (substate n s k) f).
Hypothesis equation : forall x, received x = sum n (fun j => over j (fun y => form_factor x y * brightness y)).

(* The diffuse equation, summed over the parts. *)
Lemma equation_with_parts : forall x,
  received x = sum (n - 1 + m) (fun j => part_over j (fun y => form_factor x y * brightness y)).
Proof.
  intros x. rewrite equation. destruct m as [|q]; [lia|]. replace (n - 1 + S q)%nat with (n + q)%nat by lia.
  rewrite (sum_others_and_substates n q s), (sum_others_and_state n s), divided_patch by assumption. f_equal.
  apply sum_others_ext. intros. symmetry. now apply other_patches.
Qed.

Lemma area_of_other : forall j, (j < n)%nat -> j <> s ->
  integral_area part_over brightness received j = integral_area over brightness received j.
Proof. intros. now apply other_patches. Qed.

Lemma total_integral_area : sum (n - 1 + m) (integral_area part_over brightness received) =
  sum n (integral_area over brightness received).
Proof.
  destruct m as [|q]; [lia|]. replace (n - 1 + S q)%nat with (n + q)%nat by lia.
  rewrite (sum_others_and_substates n q s), (sum_others_and_state n s) by assumption. f_equal.
  - apply sum_others_ext. intros. now apply area_of_other.
  - symmetry. apply divided_patch.
Qed.

Lemma inner_integrable : forall k i, (k < n - 1 + m)%nat -> (i < n - 1 + m)%nat ->
  integrable (fun x => part_over k (fun y => form_factor x y * brightness x * brightness y)).
Proof.
  intros k i Hk Hi. apply (integral_of_equals _ _ _ _ rules i
    (fun x => brightness x * part_over k (fun y => form_factor x y * brightness y))); [exact Hi| |
    now apply (kernel_outer _ _ _ _ _ _ kernel)].
  intros x. assert (I := kernel_inner _ _ _ _ _ _ kernel x).
  destruct (integral_of_multiple _ _ _ _ rules k (brightness x) _ Hk I) as [I' E]. rewrite <- E.
  apply (integral_of_equals _ _ _ _ rules k); [exact Hk| |exact I']. intros y. ring.
Qed.

Theorem dividing_a_patch_with_integrals_fulfils_hypotheses_of_theorem_1 :
  (forall j, (j < n - 1 + m)%nat -> integral_area part_over brightness received j <> 0) ->
  refines_state n s m
    (integral_weight n over brightness received) (integral_transition over form_factor brightness received)
    (integral_weight (n - 1 + m) part_over brightness received)
    (integral_transition part_over form_factor brightness received).
Proof.
  intros HA. constructor; try assumption.
  - intros j Hj Hjs. unfold integral_weight. now rewrite total_integral_area, area_of_other.
  - intros i j Hi Hj His Hjs. unfold integral_transition, integral_exchange. rewrite area_of_other by assumption. f_equal.
    rewrite <- (other_patches i (fun x => over j _)) by assumption. symmetry.
    apply (integral_of_equals _ _ _ _ rules i); [lia| |].
    + intros x. symmetry. now apply other_patches.
    + apply (integral_of_equals _ _ _ _ rules i
        (fun x => part_over j (fun y => form_factor x y * brightness x * brightness y))); [lia| |].
      * intros x. now apply other_patches.
      * apply (inner_integrable j i); lia.
  - intros k j Hk Hj. apply (integral_chain_is_reciprocal point (n - 1 + m) part_over integrable); auto.
    apply substate_below; assumption.
  - intros j Hj Hjs. unfold integral_transition, Rdiv. rewrite sum_scale_right, area_of_other by assumption. f_equal.
    unfold integral_exchange. rewrite <- (other_patches j (fun x => over s _)) by assumption.
    assert (I : forall k, (k < m)%nat ->
      integrable (fun x => part_over (substate n s k) (fun y => form_factor x y * brightness x * brightness y))).
    { intros k Hk. apply (inner_integrable (substate n s k) j); [now apply substate_below|lia]. }
    destruct (integral_of_finite_sum point (n - 1 + m) part_over integrable rules j m
      (fun k x => part_over (substate n s k) (fun y => form_factor x y * brightness x * brightness y))) as [I' E];
      [lia|lia|exact I|].
    rewrite <- E. symmetry. apply (integral_of_equals _ _ _ _ rules j); [lia| |exact I'].
    intros x. symmetry. apply divided_patch.
Qed.

End Dividing.
