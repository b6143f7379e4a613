(* The gain of mutual information between two patches when one of them is divided into two parts (eq. 7, m = 2),
   and the strict form of the log-sum inequality (12) for two terms. *)
From Coq Require Import Reals Lra Lia.
From Infoscene Require Import Sums Information LogSum.
Open Scope R_scope.

(* One term of eq. (7): A/A_T F log2 (F A_T / A_j), with 0 log 0 = 0. *)
Definition information_term (total area_j area form_factor : R) : R :=
  area / total * xlog2 form_factor (area_j / total).

(* The form factor of two parts taken together: the mean of theirs, weighted by their areas. *)
Definition joined_form_factor (area1 form_factor1 area2 form_factor2 : R) : R :=
  (area1 * form_factor1 + area2 * form_factor2) / (area1 + area2).

(* Eq. (7) for two parts: what mutual information between patches i and j gains by the division of i. *)
Definition gain_of_division (total area_j area1 form_factor1 area2 form_factor2 : R) : R :=
  2 * (information_term total area_j area1 form_factor1
       + information_term total area_j area2 form_factor2
       - information_term total area_j (area1 + area2) (joined_form_factor area1 form_factor1 area2 form_factor2)).

(* A product with the factor 0 is 0 whatever its logarithm is. *)
Lemma xlog2_is_product : forall x y, xlog2 x y = x * log2 (x / y).
Proof. intros x y. unfold xlog2. destruct (Req_EM_T x 0) as [-> |]; ring. Qed.

(* Eq. (12) for two terms is strict where the ratios differ. *)
Lemma two_unequal_ratios_lose_when_joined : forall x1 w1 x2 w2,
  0 <= x1 -> 0 < w1 -> 0 <= x2 -> 0 < w2 -> x1 * w2 <> x2 * w1 ->
  xlog2 (x1 + x2) (w1 + w2) < xlog2 x1 w1 + xlog2 x2 w2.
Proof.
  intros x1 w1 x2 w2 Hx1 Hw1 Hx2 Hw2 Hne.
  pose (x := fun k => match k with O => x1 | _ => x2 end).
  pose (w := fun k => match k with O => w1 | _ => w2 end).
  assert (Hx : forall k, (k < 2)%nat -> 0 <= x k) by (intros [| k] _; assumption).
  assert (Hw : forall k, (k < 2)%nat -> 0 <= w k) by (intros [| k] _; simpl; lra).
  assert (Hn : forall k, (k < 2)%nat -> w k = 0 -> x k = 0) by (intros [| k] _; simpl; lra).
  pose proof (log_sum_inequality 2 x w Hx Hw Hn) as Hle.
  pose proof (log_sum_equality 2 x w Hx Hw Hn) as Heq.
  simpl in Hle, Heq. rewrite !Rplus_0_l in Hle, Heq.
  destruct Hle as [| E]; [assumption |]. exfalso. apply Hne.
  symmetry in E. assert (H := proj1 Heq E 0%nat ltac:(lia)). simpl in H. lra.
Qed.

(* ---- terms of eq. (7) ---- *)

(* A term of (7) is a term x log2 (x / w) of the log-sum inequality, with x the flux and w the weight. *)
Lemma information_term_by_flux : forall total area_j area form_factor, 0 < total -> 0 < area_j -> 0 < area ->
  information_term total area_j area form_factor
  = xlog2 (area * form_factor) (area * (area_j / total)) / total.
Proof.
  intros total area_j area f HT Hj HA. unfold information_term. rewrite !xlog2_is_product.
  replace (area * f / (area * (area_j / total))) with (f / (area_j / total)) by (field; lra).
  field. lra.
Qed.

Lemma information_term_dark : forall total area_j area, information_term total area_j area 0 = 0.
Proof. intros. unfold information_term. rewrite xlog2_is_product. ring. Qed.

Lemma information_term_of_nothing : forall total area_j form_factor,
  information_term total area_j 0 form_factor = 0.
Proof. intros. unfold information_term, Rdiv. ring. Qed.

(* Two parts whose form factors differ have strictly more information than the whole. *)
Lemma dividing_unequal_parts_gains : forall total area_j area1 f1 area2 f2,
  0 < total -> 0 < area_j -> 0 < area1 -> 0 < area2 -> 0 <= f1 -> 0 <= f2 -> f1 <> f2 ->
  information_term total area_j (area1 + area2) (joined_form_factor area1 f1 area2 f2)
  < information_term total area_j area1 f1 + information_term total area_j area2 f2.
Proof.
  intros total area_j a1 f1 a2 f2 HT Hj H1 H2 Hf1 Hf2 Hne.
  rewrite !information_term_by_flux by lra. unfold Rdiv. rewrite <- Rmult_plus_distr_r.
  apply Rmult_lt_compat_r; [now apply Rinv_0_lt_compat |].
  replace ((a1 + a2) * joined_form_factor a1 f1 a2 f2) with (a1 * f1 + a2 * f2)
    by (unfold joined_form_factor; field; lra).
  rewrite (Rmult_plus_distr_r a1 a2).
  assert (Hw : 0 < area_j * / total) by (apply Rmult_lt_0_compat; [| apply Rinv_0_lt_compat]; assumption).
  apply two_unequal_ratios_lose_when_joined.
  - now apply Rmult_le_pos; [left |].
  - now apply Rmult_lt_0_compat.
  - now apply Rmult_le_pos; [left |].
  - now apply Rmult_lt_0_compat.
  - intro H. apply Hne. apply Rmult_eq_reg_l with (a1 * a2 * (area_j * / total)).
    + transitivity (a1 * f1 * (a2 * (area_j * / total))); [ring | rewrite H; ring].
    + apply Rgt_not_eq. repeat apply Rmult_lt_0_compat; try assumption. now apply Rinv_0_lt_compat.
Qed.

(* Equal form factors: nothing is gained. *)
Lemma dividing_equal_parts_gains_nothing : forall total area_j area1 area2 f,
  information_term total area_j (area1 + area2) f
  = information_term total area_j area1 f + information_term total area_j area2 f.
Proof. intros. unfold information_term, Rdiv. ring. Qed.

Lemma joined_equal : forall a1 a2 f, 0 < a1 + a2 -> joined_form_factor a1 f a2 f = f.
Proof. intros. unfold joined_form_factor. field. lra. Qed.
