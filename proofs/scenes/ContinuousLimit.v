(* Eq. (4) and Corollary 1 for scenes whose kernel jumps at shadow lines and has no bound at common edges. On a pair of patches
   on which A_T F(x, y) varies little, little is lost; on any other at most what the pair has, and a little. So where the other
   pairs can be made to have as little as one likes, the continuous mutual information is the least upper bound. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement IntegralChain DiscreteBelowContinuous.
Open Scope R_scope.

(* On patches i and j, A_T F(x, y) stays where x log x varies by at most e. *)
Definition nearly_constant_pair {point : Type} (total : R) (kernel : point -> point -> R) (patch : point -> nat) (e : R)
    (i j : nat) : Prop :=
  exists a b, 0 <= a /\
    (forall x y, patch x = i -> patch y = j -> a <= total * kernel x y <= b) /\
    (forall s t, a <= s <= b -> a <= t <= b -> xlog2 s 1 - xlog2 t 1 <= e).

(* What a pair of patches has of eq. (4). *)
Definition information_of_pair {point : Type} (n : nat) (over : nat -> (point -> R) -> R) (kernel : point -> point -> R)
    (i j : nat) : R :=
  over i (fun x => over j (fun y => 1 / sum n (patch_area over) * xlog2 (kernel x y) (1 / sum n (patch_area over)))).

(* x log x is nowhere below - 1 / (e ln 2): its tangent at 1 / e is horizontal. *)
Lemma x_log_x_at_least : forall t, 0 <= t -> - (exp (-1) / ln 2) <= xlog2 t 1.
Proof.
  intros t Ht. assert (L2 := ln_2_positive). assert (E := exp_pos (-1)).
  destruct (term_above_tangent t 1 (exp (-1))) as [B _]; [exact Ht|lra|lra|exact E|].
  unfold log2 in B. rewrite ln_exp in B.
  replace (t * (-1 / ln 2) + (t - 1 * exp (-1)) / ln 2) with (- (exp (-1) / ln 2)) in B by (field; lra). exact B.
Qed.

Section ContinuousLimit.
Variables (point : Type) (n : nat) (over : nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop).
Variables (kernel : point -> point -> R) (patch : point -> nat).
Hypothesis scene : integrable_scene point n over integrable kernel.
Hypothesis some_patch : (0 < n)%nat.
(* The integral over a patch keeps the order that functions have on it. *)
Hypothesis order_on_patch : forall i f g, (i < n)%nat -> integrable f -> integrable g ->
  (forall x, patch x = i -> f x <= g x) -> over i f <= over i g.

Let T := sum n (patch_area over).
Let w := patch_weight n over.
Let rules := scene_integrals _ _ _ _ _ scene.

Lemma total_positive : 0 < T.
Proof. exact (total_area_is_positive point n over integrable kernel scene some_patch). Qed.

Lemma integral_of_constant : forall i c, (i < n)%nat -> integrable (fun _ => c) /\ over i (fun _ => c) = c * patch_area over i.
Proof.
  intros i c Hi. destruct (integral_of_multiple _ _ _ _ rules i c _ Hi (areas_integrable _ _ _ _ _ scene)) as [I E].
  destruct (integral_of_equals _ _ _ _ rules i (fun _ => c * 1) (fun _ => c) Hi) as [I' E']; [intros; ring|exact I|].
  split; [exact I'|]. rewrite <- E', E. reflexivity.
Qed.

Lemma kernel_times_total : forall x y, 1 / T * xlog2 (kernel x y) (1 / T) = 1 / T * (1 / T) * xlog2 (T * kernel x y) 1.
Proof.
  intros x y. assert (HT := total_positive). rewrite (Rmult_assoc (1 / T)), <- (xlog2_scale (1 / T) (T * kernel x y)).
  replace (1 / T * (T * kernel x y)) with (kernel x y) by (field; lra). now rewrite Rmult_1_r.
Qed.

Let mean (i j : nat) : R := T * over i (fun x => over j (kernel x)) / (patch_area over i * patch_area over j).

(* The term of eq. (3) is w_i w_j c log c, c the mean of A_T F. *)
Lemma discrete_term : forall i j, (i < n)%nat -> (j < n)%nat ->
  w i * xlog2 (patch_form_factor over kernel i j) (w j) = w i * w j * xlog2 (mean i j) 1.
Proof.
  intros i j Hi Hj. assert (HT := total_positive).
  assert (Ai := areas_positive _ _ _ _ _ scene i Hi). assert (Aj := areas_positive _ _ _ _ _ scene j Hj).
  rewrite Rmult_assoc, <- (xlog2_scale (w j) (mean i j)), Rmult_1_r.
  f_equal. f_equal. unfold w, patch_weight, patch_form_factor, mean. fold T. field. lra.
Qed.

Lemma weights_positive : forall i, (i < n)%nat -> 0 < w i.
Proof.
  intros i Hi. unfold w, patch_weight. apply Rdiv_lt_0_compat; [now apply (areas_positive _ _ _ _ _ scene)|exact total_positive].
Qed.

Lemma mean_nonneg : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= mean i j.
Proof.
  intros i j Hi Hj. assert (HT := total_positive).
  assert (Ai := areas_positive _ _ _ _ _ scene i Hi). assert (Aj := areas_positive _ _ _ _ _ scene j Hj).
  assert (N := received_nonneg point n over integrable kernel scene i j Hi Hj).
  unfold mean. apply Rmult_le_pos; [apply Rmult_le_pos; lra|]. left. apply Rinv_0_lt_compat. now apply Rmult_lt_0_compat.
Qed.

(* Bounds on a pair are bounds on its mean. *)
Lemma mean_between : forall i j a b, (i < n)%nat -> (j < n)%nat ->
  (forall x y, patch x = i -> patch y = j -> a <= T * kernel x y <= b) -> a <= mean i j <= b.
Proof.
  intros i j a b Hi Hj H. assert (HT := total_positive).
  assert (Ai := areas_positive _ _ _ _ _ scene i Hi). assert (Aj := areas_positive _ _ _ _ _ scene j Hj).
  assert (Ij := received_integrable _ _ _ _ _ scene j Hj).
  assert (Hx : forall x, patch x = i -> a / T * patch_area over j <= over j (kernel x) <= b / T * patch_area over j).
  { intros x Hxi. assert (Ik := kernel_integrable _ _ _ _ _ scene x).
    destruct (integral_of_constant j (a / T) Hj) as [Ia <-]. destruct (integral_of_constant j (b / T) Hj) as [Ib <-].
    split; apply order_on_patch; try assumption; intros y Hy; destruct (H x y Hxi Hy);
      apply (Rmult_le_reg_r T); try exact HT; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  destruct (integral_of_constant i (a / T * patch_area over j) Hi) as [Ia Ea].
  destruct (integral_of_constant i (b / T * patch_area over j) Hi) as [Ib Eb].
  assert (L : over i (fun _ => a / T * patch_area over j) <= over i (fun x => over j (kernel x)))
    by (apply order_on_patch; try assumption; intros x Hxi; now apply Hx).
  assert (U : over i (fun x => over j (kernel x)) <= over i (fun _ => b / T * patch_area over j))
    by (apply order_on_patch; try assumption; intros x Hxi; now apply Hx).
  rewrite Ea in L. rewrite Eb in U. unfold mean. set (J := over i (fun x => over j (kernel x))) in *.
  set (p := patch_area over i) in *. set (q := patch_area over j) in *.
  assert (0 < p * q) by now apply Rmult_lt_0_compat.
  assert (K : T * J / (p * q) * (p * q) = T * J) by (field; lra).
  split; apply (Rmult_le_reg_r (p * q)); try assumption; rewrite K.
  - apply (Rmult_le_compat_l T) in L; [|lra]. replace (T * (a / T * q * p)) with (a * (p * q)) in L by (field; lra). exact L.
  - apply (Rmult_le_compat_l T) in U; [|lra]. replace (T * (b / T * q * p)) with (b * (p * q)) in U by (field; lra). exact U.
Qed.

(* A pair on which A_T F varies little loses little. *)
Lemma nearly_constant_pair_loses_little : forall e i j, (i < n)%nat -> (j < n)%nat -> nearly_constant_pair T kernel patch e i j ->
  information_of_pair n over kernel i j <= w i * xlog2 (patch_form_factor over kernel i j) (w j) + e * (w i * w j).
Proof.
  intros e i j Hi Hj [a [b [Ha [H V]]]]. assert (HT := total_positive).
  assert (M := mean_between i j a b Hi Hj H). rewrite discrete_term by assumption.
  set (s := 1 / T * (1 / T) * (xlog2 (mean i j) 1 + e)).
  destruct (integral_of_constant j s Hj) as [Is Es]. destruct (integral_of_constant i (s * patch_area over j) Hi) as [It Et].
  apply Rle_trans with (over i (fun _ => s * patch_area over j)).
  - apply order_on_patch; [exact Hi|exact (information_integrable _ _ _ _ _ scene j Hj)|exact It|]. intros x Hx. rewrite <- Es.
    apply order_on_patch; [exact Hj|exact (logarithms_integrable _ _ _ _ _ scene x)|exact Is|]. intros y Hy.
    fold T. rewrite kernel_times_total. unfold s. apply Rmult_le_compat_l.
    + assert (0 < 1 / T) by (apply Rdiv_lt_0_compat; lra). left. now apply Rmult_lt_0_compat.
    + specialize (V (T * kernel x y) (mean i j) (H x y Hx Hy) M). lra.
  - right. rewrite Et. unfold s, w, patch_weight. fold T. field. lra.
Qed.

(* And any pair at most what it has, and the little by which x log x may be negative. *)
Lemma any_pair_loses_at_most : forall i j, (i < n)%nat -> (j < n)%nat ->
  information_of_pair n over kernel i j <=
  w i * xlog2 (patch_form_factor over kernel i j) (w j) + (information_of_pair n over kernel i j + exp (-1) / ln 2 * (w i * w j)).
Proof.
  intros i j Hi Hj. rewrite discrete_term by assumption.
  assert (B := x_log_x_at_least (mean i j) (mean_nonneg i j Hi Hj)).
  assert (0 < w i * w j) by (apply Rmult_lt_0_compat; now apply weights_positive).
  assert (w i * w j * - (exp (-1) / ln 2) <= w i * w j * xlog2 (mean i j) 1) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* What a division loses: at most e, and what the pairs have that are not nearly constant. *)
Theorem division_loses_little_beyond_its_uneven_pairs : forall e (uneven : nat -> nat -> bool), 0 <= e ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> uneven i j = false -> nearly_constant_pair T kernel patch e i j) ->
  information_of_all_points n over kernel <=
  mutual_information n (patch_weight n over) (patch_form_factor over kernel) + e +
  sum n (fun i => sum n (fun j => if uneven i j then
    information_of_pair n over kernel i j + exp (-1) / ln 2 * (patch_weight n over i * patch_weight n over j) else 0)).
Proof.
  intros e uneven He H. fold w.
  set (rest := fun i j => if uneven i j then information_of_pair n over kernel i j + exp (-1) / ln 2 * (w i * w j) else 0).
  change (sum n (fun i => sum n (fun j => information_of_pair n over kernel i j)) <=
    mutual_information n w (patch_form_factor over kernel) + e + sum n (fun i => sum n (fun j => rest i j))).
  assert (W : sum n (fun i => sum n (fun j => e * (w i * w j))) = e).
  { assert (O : sum n w = 1).
    { unfold w, patch_weight. fold T. unfold Rdiv. rewrite sum_scale_right. fold T. apply Rinv_r. assert (HT := total_positive). lra. }
    rewrite (sum_ext n _ (fun i => e * w i)).
    - rewrite sum_scale, O. ring.
    - intros i _. rewrite sum_scale. rewrite (sum_scale n (w i) w), O. ring. }
  rewrite <- W at 1. unfold mutual_information. rewrite <- !sum_plus. apply sum_le. intros i Hi. rewrite <- !sum_plus.
  apply sum_le. intros j Hj. unfold rest. destruct (uneven i j) eqn:E.
  - assert (B := any_pair_loses_at_most i j Hi Hj).
    assert (0 < w i * w j) by (apply Rmult_lt_0_compat; now apply weights_positive).
    assert (0 <= e * (w i * w j)) by (apply Rmult_le_pos; lra). lra.
  - assert (B := nearly_constant_pair_loses_little e i j Hi Hj (H i j Hi Hj E)). lra.
Qed.
End ContinuousLimit.

(* Corollary 1. A family of divisions of one scene, which all have the same eq. (4); whatever delta > 0, some of them loses at
   most delta by the theorem above. *)
Theorem continuous_information_of_a_scene_is_least_upper_bound :
  forall (point division : Type) (patches : division -> nat) (over : division -> nat -> (point -> R) -> R)
    (integrable : (point -> R) -> Prop) (kernel : point -> point -> R) (patch : division -> point -> nat) continuous,
  (forall d, (0 < patches d)%nat) ->
  (forall d, integrable_scene point (patches d) (over d) integrable kernel) ->
  (forall d i f g, (i < patches d)%nat -> integrable f -> integrable g -> (forall x, patch d x = i -> f x <= g x) ->
    over d i f <= over d i g) ->
  (forall d, information_of_all_points (patches d) (over d) kernel = continuous) ->
  (forall delta, 0 < delta -> exists d e (uneven : nat -> nat -> bool), 0 <= e /\
    (forall i j, (i < patches d)%nat -> (j < patches d)%nat -> uneven i j = false ->
      nearly_constant_pair (sum (patches d) (patch_area (over d))) kernel (patch d) e i j) /\
    e + sum (patches d) (fun i => sum (patches d) (fun j => if uneven i j then
      information_of_pair (patches d) (over d) kernel i j +
      exp (-1) / ln 2 * (patch_weight (patches d) (over d) i * patch_weight (patches d) (over d) j) else 0)) <= delta) ->
  is_lub (fun v => exists d, v = mutual_information (patches d) (patch_weight (patches d) (over d)) (patch_form_factor (over d) kernel))
    continuous.
Proof.
  intros point division patches over integrable kernel patch Ic Hn S O C D. split.
  - intros v [d ->]. rewrite <- (C d).
    exact (no_division_has_more_information_than_the_continuous_scene point _ _ integrable kernel (S d) (Hn d)).
  - intros u Hu. destruct (Rle_dec Ic u) as [|N]; [assumption|exfalso].
    destruct (D ((Ic - u) / 2)) as [d [e [uneven [He [G B]]]]]; [lra|].
    assert (L := division_loses_little_beyond_its_uneven_pairs point _ _ integrable kernel (patch d) (S d) (Hn d) (O d) e uneven He G).
    rewrite (C d) in L.
    assert (U : mutual_information (patches d) (patch_weight (patches d) (over d)) (patch_form_factor (over d) kernel) <= u)
      by (apply Hu; now exists d). lra.
Qed.
