(* Section 3.4: the radiosity chain reverts to the visibility chain. In a closed scene B = k solves the radiosity
   equation exactly when E_i = k (1 - R_i), and it is then the only solution if 0 <= R_i < 1. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement WeightedScene Radiosity.
Open Scope R_scope.

(* Among finitely many numbers one is the greatest. *)
Lemma some_term_is_greatest : forall n f, (0 < n)%nat ->
  exists i, (i < n)%nat /\ forall j, (j < n)%nat -> f j <= f i.
Proof.
  intros n f. induction n as [| n IH]; intros Hn; [lia |].
  destruct (Nat.eq_dec n 0) as [-> | H0].
  - exists 0%nat. split; [lia |]. intros j Hj. replace j with 0%nat by lia. lra.
  - destruct IH as [i [Hi Hmax]]; [lia |]. destruct (Rle_dec (f n) (f i)) as [H | H].
    + exists i. split; [lia |]. intros j Hj. destruct (Nat.eq_dec j n) as [-> |]; [assumption | apply Hmax; lia].
    + exists n. split; [lia |]. intros j Hj. destruct (Nat.eq_dec j n) as [-> |]; [lra |].
      assert (f j <= f i) by (apply Hmax; lia). lra.
Qed.

Section Equation.
Variables (n : nat) (form_factor : nat -> nat -> R) (reflectance : nat -> R).
Hypothesis form_factor_nonneg : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= form_factor i j.
Hypothesis rows_at_most_one : forall i, (i < n)%nat -> sum n (fun j => form_factor i j) <= 1.
Hypothesis reflectance_below_one : forall i, (i < n)%nat -> 0 <= reflectance i < 1.

(* If x_i <= R_i sum_j F_ij x_j for all i, no x_i is positive: the greatest x_i would be at most R_i times itself. *)
Lemma maximum_principle : forall x,
  (forall i, (i < n)%nat -> x i <= reflectance i * sum n (fun j => form_factor i j * x j)) ->
  forall i, (i < n)%nat -> x i <= 0.
Proof.
  intros x H. assert (Hn : forall i, (i < n)%nat -> (0 < n)%nat) by (intros; lia). intros i Hi.
  destruct (some_term_is_greatest n x (Hn i Hi)) as [t [Ht Hmax]].
  apply Rle_trans with (x t); [auto |]. destruct (Rle_dec (x t) 0) as [| Hpos]; [assumption |]. exfalso.
  assert (Hs : sum n (fun j => form_factor t j * x j) <= x t).
  { apply Rle_trans with (sum n (fun j => form_factor t j * x t)).
    - apply sum_le. intros j Hj. apply Rmult_le_compat_l; auto.
    - rewrite sum_scale_right. rewrite <- (Rmult_1_l (x t)) at 2. apply Rmult_le_compat_r; [lra | auto]. }
  destruct (reflectance_below_one t Ht) as [H0 H1].
  assert (reflectance t * sum n (fun j => form_factor t j * x j) <= reflectance t * x t)
    by now apply Rmult_le_compat_l.
  assert (reflectance t * x t < 1 * x t) by (apply Rmult_lt_compat_r; lra).
  specialize (H t Ht). lra.
Qed.

(* The difference of two solutions, in either order, fulfils the inequality. *)
Theorem radiosity_equation_has_at_most_one_solution : forall emittance radiosity radiosity',
  radiosity_equation n form_factor reflectance emittance radiosity ->
  radiosity_equation n form_factor reflectance emittance radiosity' ->
  forall i, (i < n)%nat -> radiosity i = radiosity' i.
Proof.
  intros E B B' H H'.
  assert (D : forall X Y, radiosity_equation n form_factor reflectance E X ->
    radiosity_equation n form_factor reflectance E Y -> forall i, (i < n)%nat -> X i - Y i <= 0).
  { intros X Y HX HY. apply (maximum_principle (fun i => X i - Y i)). intros i Hi. right.
    rewrite (HX i Hi), (HY i Hi) at 1.
    rewrite (sum_ext n (fun j => form_factor i j * (X j - Y j))
      (fun j => form_factor i j * X j - form_factor i j * Y j)) by (intros; ring).
    rewrite sum_minus. ring. }
  intros i Hi. pose proof (D B B' H H' i Hi). pose proof (D B' B H' H i Hi). lra.
Qed.

(* No emittance is negative: no radiosity is below it. *)
Theorem radiosity_is_at_least_emittance : forall emittance radiosity,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall i, (i < n)%nat -> 0 <= emittance i) ->
  forall i, (i < n)%nat -> emittance i <= radiosity i.
Proof.
  intros E B H HE.
  assert (P : forall i, (i < n)%nat -> - B i <= 0).
  { apply (maximum_principle (fun i => - B i)). intros i Hi. rewrite (H i Hi) at 1.
    rewrite (sum_ext n (fun j => form_factor i j * - B j) (fun j => -1 * (form_factor i j * B j))) by (intros; ring).
    rewrite sum_scale. specialize (HE i Hi). lra. }
  intros i Hi. rewrite (H i Hi). rewrite <- (Rplus_0_r (E i)) at 1. apply Rplus_le_compat_l, Rmult_le_pos.
  - now apply reflectance_below_one.
  - apply sum_nonneg. intros j Hj. apply Rmult_le_pos; [auto |]. specialize (P j Hj). lra.
Qed.
End Equation.

(* Rows that sum to one: B = k leaves k = E_i + R_i k. *)
Theorem uniform_radiosity_solves_iff : forall n form_factor reflectance emittance k,
  closed n form_factor ->
  radiosity_equation n form_factor reflectance emittance (fun _ => k) <->
  (forall i, (i < n)%nat -> emittance i = k * (1 - reflectance i)).
Proof.
  intros n F r E k C. split.
  - intros H i Hi. specialize (H i Hi). cbv beta in H. rewrite (sum_scale_right n k (F i)) in H.
    change (sum n (F i)) with (sum n (fun j => F i j)) in H. rewrite C in H by assumption. lra.
  - intros H i Hi. rewrite (sum_scale_right n k (F i)).
    change (sum n (F i)) with (sum n (fun j => F i j)). rewrite C, H by assumption. ring.
Qed.

Theorem uniform_radiosity_is_the_only_solution : forall n area form_factor reflectance emittance k radiosity,
  scene n area form_factor -> closed n form_factor ->
  (forall i, (i < n)%nat -> 0 <= reflectance i < 1) ->
  (forall i, (i < n)%nat -> emittance i = k * (1 - reflectance i)) ->
  radiosity_equation n form_factor reflectance emittance radiosity ->
  forall i, (i < n)%nat -> radiosity i = k.
Proof.
  intros n A F r E k B S C Hr HE HB i Hi.
  apply (radiosity_equation_has_at_most_one_solution n F r) with (emittance := E) (radiosity' := fun _ => k); auto.
  - exact (form_factor_nonneg _ _ _ S).
  - intros l Hl. rewrite C by assumption. lra.
  - now apply uniform_radiosity_solves_iff.
Qed.

(* Then P_ij = F_ij and w_i = A_i / A_T. *)
Theorem radiosity_reverts_to_visibility : forall n area form_factor reflectance emittance k radiosity,
  scene n area form_factor -> closed n form_factor -> k <> 0 ->
  (forall i, (i < n)%nat -> 0 < reflectance i < 1) ->
  (forall i, (i < n)%nat -> emittance i = k * (1 - reflectance i)) ->
  radiosity_equation n form_factor reflectance emittance radiosity ->
  forall i, (i < n)%nat ->
  radiosity_weight n area reflectance emittance radiosity i = area i / sum n area /\
  (forall j, (j < n)%nat -> radiosity_transition form_factor reflectance emittance radiosity i j = form_factor i j).
Proof.
  intros n A F r E k B S C Hk Hr HE HB i Hi.
  assert (Hu : forall i, (i < n)%nat -> B i = k).
  { apply (uniform_radiosity_is_the_only_solution n A F r E k B S C); auto. intros l Hl. specialize (Hr l Hl). lra. }
  assert (Hr0 : forall i, (i < n)%nat -> r i <> 0) by (intros l Hl; specialize (Hr l Hl); lra).
  assert (Hl : forall i, (i < n)%nat -> B i <> E i).
  { intros l Hl H. rewrite Hu, HE in H by assumption. specialize (Hr l Hl).
    assert (k * r l = 0) by lra. apply Rmult_integral in H0. destruct H0; lra. }
  destruct (uniform_brightness_is_visibility n A F B k C Hk Hu i Hi) as [HW HP]. split.
  - now rewrite (radiosity_weight_is_generalized_weight n A F).
  - intros j Hj. rewrite (radiosity_transition_is_generalized_form_factor n F); auto.
Qed.
