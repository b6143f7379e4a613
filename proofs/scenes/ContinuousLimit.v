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
Lemma mean_at_least : forall i j a, (i < n)%nat -> (j < n)%nat ->
  (forall x y, patch x = i -> patch y = j -> a <= T * kernel x y) -> a <= mean i j.
Proof.
  intros i j a Hi Hj H. assert (HT := total_positive).
  assert (Ai := areas_positive _ _ _ _ _ scene i Hi). assert (Aj := areas_positive _ _ _ _ _ scene j Hj).
  assert (Ij := received_integrable _ _ _ _ _ scene j Hj).
  destruct (integral_of_constant i (a / T * patch_area over j) Hi) as [Ia Ea].
  assert (L : over i (fun _ => a / T * patch_area over j) <= over i (fun x => over j (kernel x))).
  { apply order_on_patch; try assumption. intros x Hx. assert (Ik := kernel_integrable _ _ _ _ _ scene x).
    destruct (integral_of_constant j (a / T) Hj) as [Ib <-]. apply order_on_patch; try assumption. intros y Hy.
    specialize (H x y Hx Hy). apply (Rmult_le_reg_r T); [exact HT|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  rewrite Ea in L. unfold mean. set (J := over i (fun x => over j (kernel x))) in *.
  set (p := patch_area over i) in *. set (q := patch_area over j) in *.
  assert (0 < p * q) by now apply Rmult_lt_0_compat.
  apply (Rmult_le_reg_r (p * q)); [assumption|]. replace (T * J / (p * q) * (p * q)) with (T * J) by (field; lra).
  apply (Rmult_le_compat_l T) in L; [|lra]. replace (T * (a / T * q * p)) with (a * (p * q)) in L by (field; lra). exact L.
Qed.

Lemma mean_at_most : forall i j b, (i < n)%nat -> (j < n)%nat ->
  (forall x y, patch x = i -> patch y = j -> T * kernel x y <= b) -> mean i j <= b.
Proof.
  intros i j b Hi Hj H. assert (HT := total_positive).
  assert (Ai := areas_positive _ _ _ _ _ scene i Hi). assert (Aj := areas_positive _ _ _ _ _ scene j Hj).
  assert (Ij := received_integrable _ _ _ _ _ scene j Hj).
  destruct (integral_of_constant i (b / T * patch_area over j) Hi) as [Ib Eb].
  assert (U : over i (fun x => over j (kernel x)) <= over i (fun _ => b / T * patch_area over j)).
  { apply order_on_patch; try assumption. intros x Hx. assert (Ik := kernel_integrable _ _ _ _ _ scene x).
    destruct (integral_of_constant j (b / T) Hj) as [Ia <-]. apply order_on_patch; try assumption. intros y Hy.
    specialize (H x y Hx Hy). apply (Rmult_le_reg_r T); [exact HT|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  rewrite Eb in U. unfold mean. set (J := over i (fun x => over j (kernel x))) in *.
  set (p := patch_area over i) in *. set (q := patch_area over j) in *.
  assert (0 < p * q) by now apply Rmult_lt_0_compat.
  apply (Rmult_le_reg_r (p * q)); [assumption|]. replace (T * J / (p * q) * (p * q)) with (T * J) by (field; lra).
  apply (Rmult_le_compat_l T) in U; [|lra]. replace (T * (b / T * q * p)) with (b * (p * q)) in U by (field; lra). exact U.
Qed.

(* A pair on which A_T F varies little loses little. *)
Lemma nearly_constant_pair_loses_little : forall e i j, (i < n)%nat -> (j < n)%nat -> nearly_constant_pair T kernel patch e i j ->
  information_of_pair n over kernel i j <= w i * xlog2 (patch_form_factor over kernel i j) (w j) + e * (w i * w j).
Proof.
  intros e i j Hi Hj [a [b [Ha [H V]]]]. assert (HT := total_positive).
  assert (M : a <= mean i j <= b)
    by (split; [apply mean_at_least|apply mean_at_most]; try assumption; intros; now apply H). rewrite discrete_term by assumption.
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

(* "Always lower": it is enough that two parts k and k' of one patch see a third part l unequally, one everywhere less
   than the other. *)
Theorem division_of_an_unevenly_seen_patch_lies_below : forall coarse parent wc Pc k k' l a b,
  refines coarse n parent wc Pc (patch_weight n over) (patch_form_factor over kernel) ->
  (k < n)%nat -> (k' < n)%nat -> (l < n)%nat -> parent k = parent k' -> a < b ->
  (forall x y, patch x = k -> patch y = l -> T * kernel x y <= a) ->
  (forall x y, patch x = k' -> patch y = l -> b <= T * kernel x y) ->
  mutual_information coarse wc Pc < information_of_all_points n over kernel.
Proof.
  intros coarse parent wc Pc k k' l a b R Hk Hk' Hl E Hab Ha Hb. fold w in R.
  apply (division_that_can_gain_lies_below_the_continuous_scene point n over integrable kernel scene some_patch coarse parent wc Pc R).
  assert (HT := total_positive).
  assert (J : forall p q, (p < n)%nat -> (q < n)%nat -> joint w (patch_form_factor over kernel) p q = w p * w q * mean p q).
  { intros p q Hp Hq. assert (Ap := areas_positive _ _ _ _ _ scene p Hp). assert (Aq := areas_positive _ _ _ _ _ scene q Hq).
    unfold joint, w, patch_weight, patch_form_factor, mean. fold T. field. lra. }
  assert (W : forall p, (p < n)%nat -> 0 < wc (parent p)).
  { intros p Hp. rewrite (weight_of_parts _ _ _ _ _ _ _ R) by now apply (parent_below _ _ _ _ _ _ _ R).
    apply Rlt_le_trans with (1 := weights_positive p Hp). unfold part_sum.
    replace (w p) with (if Nat.eqb (parent p) (parent p) then w p else 0) by now rewrite Nat.eqb_refl.
    apply (term_le_sum n (fun q => if Nat.eqb (parent q) (parent p) then w q else 0)); [|assumption].
    intros q Hq. destruct (Nat.eqb (parent q) (parent p)); [|lra]. left. now apply weights_positive. }
  assert (Wk := W k Hk). assert (Wl := W l Hl).
  assert (wk := weights_positive k Hk). assert (wk' := weights_positive k' Hk'). assert (wl := weights_positive l Hl).
  assert (M := mean_at_most k l a Hk Hl Ha). assert (M' := mean_at_least k' l b Hk' Hl Hb).
  change (patch_weight n over) with w.
  set (C := wc (parent k) * wc (parent l)). set (G := joint wc Pc (parent k) (parent l)).
  assert (0 < C) by now apply Rmult_lt_0_compat.
  destruct (Req_dec (joint w (patch_form_factor over kernel) k l * C) (w k * w l * G)) as [Q|N].
  - exists k', l. split; [exact Hk'|]. split; [exact Hl|]. rewrite <- E. fold C G. rewrite J in Q |- * by assumption. intros Q'.
    assert (mean k l * C = G).
    { apply (Rmult_eq_reg_l (w k * w l)); [lra|]. apply Rmult_integral_contrapositive_currified; lra. }
    assert (mean k' l * C = G).
    { apply (Rmult_eq_reg_l (w k' * w l)); [lra|]. apply Rmult_integral_contrapositive_currified; lra. }
    assert (mean k l * C < mean k' l * C) by (apply Rmult_lt_compat_r; lra). lra.
  - exists k, l. split; [exact Hk|]. split; [exact Hl|exact N].
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

(* Eq. (4): where what the theorem above leaves open tends to 0 along a sequence of divisions, so does what they lose. *)
Theorem discrete_information_of_a_scene_tends_to_continuous :
  forall (point : Type) (patches : nat -> nat) (over : nat -> nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop)
    (kernel : point -> point -> R) (patch : nat -> point -> nat) continuous (e : nat -> R) (uneven : nat -> nat -> nat -> bool),
  (forall d, (0 < patches d)%nat) ->
  (forall d, integrable_scene point (patches d) (over d) integrable kernel) ->
  (forall d i f g, (i < patches d)%nat -> integrable f -> integrable g -> (forall x, patch d x = i -> f x <= g x) ->
    over d i f <= over d i g) ->
  (forall d, information_of_all_points (patches d) (over d) kernel = continuous) ->
  (forall d, 0 <= e d) ->
  (forall d i j, (i < patches d)%nat -> (j < patches d)%nat -> uneven d i j = false ->
    nearly_constant_pair (sum (patches d) (patch_area (over d))) kernel (patch d) (e d) i j) ->
  Un_cv (fun d => e d + sum (patches d) (fun i => sum (patches d) (fun j => if uneven d i j then
    information_of_pair (patches d) (over d) kernel i j +
    exp (-1) / ln 2 * (patch_weight (patches d) (over d) i * patch_weight (patches d) (over d) j) else 0))) 0 ->
  Un_cv (fun d => mutual_information (patches d) (patch_weight (patches d) (over d)) (patch_form_factor (over d) kernel))
    continuous.
Proof.
  intros point patches over integrable kernel patch Ic e uneven Hn S O C He G L eps Heps.
  destruct (L eps Heps) as [N HN]. exists N. intros d Hd. specialize (HN d Hd). unfold R_dist in *.
  assert (U := no_division_has_more_information_than_the_continuous_scene point _ _ integrable kernel (S d) (Hn d)).
  assert (B := division_loses_little_beyond_its_uneven_pairs point _ _ integrable kernel (patch d) (S d) (Hn d) (O d)
    (e d) (uneven d) (He d) (G d)).
  rewrite (C d) in U, B. rewrite Rminus_0_r in HN. apply Rle_lt_trans with (2 := HN).
  rewrite Rabs_left1 by lra. apply Rle_trans with (2 := Rle_abs _). lra.
Qed.

(* ---- Controls ---- *)

(* An integral that does not keep order: a division may have more than all points. *)
Theorem without_order_a_division_may_have_more :
  let over := fun (_ : nat) (f : bool -> R) => 2 * f true - f false in
  let kernel := fun x y : bool => (if x then 1 else 1 / 2) * (if y then 1 else 1 / 2) in
  integrals bool 1 over (fun _ => True) /\ (forall x y, 0 <= kernel x y) /\ 0 < patch_area over 0 /\
  information_of_all_points 1 over kernel < mutual_information 1 (patch_weight 1 over) (patch_form_factor over kernel).
Proof.
  intros over kernel. split; [|split; [|split]].
  - split; unfold over; intros; split; trivial; try ring. rewrite !H0. ring.
  - intros [] []; unfold kernel; lra.
  - unfold patch_area, over. lra.
  - unfold information_of_all_points, mutual_information, patch_weight, patch_form_factor, patch_area, over, kernel. simpl.
    replace ((2 * (2 * (1 * 1) - 1 * (1 / 2)) - (2 * (1 / 2 * 1) - 1 / 2 * (1 / 2))) / (2 * 1 - 1)) with (9 / 4) by field.
    replace ((2 * 1 - 1) / (0 + (2 * 1 - 1))) with 1 by field. replace (1 / (0 + (2 * 1 - 1))) with 1 by field.
    replace (1 * 1) with 1 by ring. replace (1 * (1 / 2)) with (1 / 2) by ring. replace (1 / 2 * 1) with (1 / 2) by ring.
    replace (1 / 2 * (1 / 2)) with (1 / 4) by field.
    rewrite !xlog2_nonzero by lra. replace (1 / 1) with 1 by field. replace (1 / 2 / 1) with (/ 2) by field.
    replace (1 / 4 / 1) with (/ (2 * 2)) by field. replace (9 / 4 / 1) with (9 / 4) by field. rewrite log2_1.
    assert (forall x, 0 < x -> log2 (/ x) = - log2 x) as I.
    { intros x Hx. replace (/ x) with (1 / x) by (field; lra). rewrite log2_div, log2_1 by lra. ring. }
    rewrite !I, log2_mult, log2_2 by lra. assert (log2 2 < log2 (9 / 4)) by (apply log2_increasing; lra).
    rewrite log2_2 in H. lra.
Qed.

(* The hypotheses can be met by a kernel that is not constant: two points that see only each other have one bit, which their
   division into two patches has as well. *)
Theorem two_points_fulfil_hypotheses :
  let over := fun (i : nat) (f : bool -> R) => if Nat.eqb i 0 then f true else f false in
  let patch := fun x : bool => if x then 0%nat else 1%nat in
  let kernel := fun x y : bool => if Bool.eqb x y then 0 else 1 in
  integrable_scene bool 2 over (fun _ => True) kernel /\
  (forall i f g, (i < 2)%nat -> (forall x, patch x = i -> f x <= g x) -> over i f <= over i g) /\
  (forall i j, (i < 2)%nat -> (j < 2)%nat -> nearly_constant_pair (sum 2 (patch_area over)) kernel patch 0 i j) /\
  information_of_all_points 2 over kernel = 1 /\
  mutual_information 2 (patch_weight 2 over) (patch_form_factor over kernel) = 1.
Proof.
  intros over patch kernel.
  assert (O : forall i f g, (i < 2)%nat -> (forall x, patch x = i -> f x <= g x) -> over i f <= over i g).
  { intros [|[|i]] f g Hi H; [| |lia]; unfold over; simpl; apply H; reflexivity. }
  split; [|split; [exact O|split; [|split]]].
  - split; trivial.
    + split; unfold over; intros i; intros; split; trivial; destruct (Nat.eqb i 0); try ring; apply H0.
    + intros i f g Hi _ _ H. apply O; [exact Hi|]. intros x _. apply H.
    + intros x y. unfold kernel. destruct (Bool.eqb x y); lra.
    + intros [|[|i]] Hi; [| |lia]; unfold patch_area, over; simpl; lra.
  - intros [|[|i]] [|[|j]] Hi Hj; try lia; unfold nearly_constant_pair, patch_area, over; simpl.
    + exists 0, 0. split; [lra|]. split; [intros [] []; unfold patch, kernel; simpl; intros; try discriminate; lra|].
      intros s t Hs Ht. replace s with t by lra. lra.
    + exists 2, 2. split; [lra|]. split; [intros [] []; unfold patch, kernel; simpl; intros; try discriminate; lra|].
      intros s t Hs Ht. replace s with t by lra. lra.
    + exists 2, 2. split; [lra|]. split; [intros [] []; unfold patch, kernel; simpl; intros; try discriminate; lra|].
      intros s t Hs Ht. replace s with t by lra. lra.
    + exists 0, 0. split; [lra|]. split; [intros [] []; unfold patch, kernel; simpl; intros; try discriminate; lra|].
      intros s t Hs Ht. replace s with t by lra. lra.
  - unfold information_of_all_points, patch_area, over, kernel. simpl. rewrite !xlog2_0, !xlog2_nonzero by lra.
    replace (1 / (1 / (0 + 1 + 1))) with 2 by field. rewrite log2_2. field.
  - unfold mutual_information, patch_weight, patch_form_factor, patch_area, over, kernel. simpl.
    replace (0 / 1) with 0 by field. rewrite !xlog2_0, !xlog2_nonzero by lra.
    replace (1 / 1 / (1 / (0 + 1 + 1))) with 2 by field. rewrite log2_2. field.
Qed.
