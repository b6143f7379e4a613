(* Section 4.2, a straight cut that leans: across the unit square, it leaves the share a + b x, kept between 0 and 1, of the
   strip at x in the first part. It gains no more than the best cut across the gradient. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information Extremum GradientPatch AcrossTheGradient AcrossTheGradientPower.
Open Scope R_scope.

Definition leaning_cut (a b x : R) : R := Rmin 1 (Rmax 0 (a + b * x)).

Lemma leaning_cut_between : forall a b x, 0 <= leaning_cut a b x <= 1.
Proof.
  intros a b x. unfold leaning_cut. split; [|apply Rmin_l]. apply Rmin_glb; [lra|apply Rmax_l].
Qed.

(* It varies by at most |b| times the way in x. *)
Lemma leaning_cut_varies_little : forall a b x y, Rabs (leaning_cut a b y - leaning_cut a b x) <= Rabs b * Rabs (y - x).
Proof.
  intros a b x y. rewrite <- Rabs_mult. replace (b * (y - x)) with (a + b * y - (a + b * x)) by ring.
  unfold leaning_cut, Rmin, Rmax.
  repeat destruct (Rle_dec _ _); unfold Rabs; repeat destruct (Rcase_abs _); lra.
Qed.

Lemma leaning_cut_continuous : forall a b x, continuous (leaning_cut a b) x.
Proof.
  intros a b x. apply continuity_pt_filterlim, continuity_pt_locally. intros eps.
  assert (0 < Rabs b + 1) by (pose proof (Rabs_pos b); lra).
  assert (D : 0 < eps / (Rabs b + 1)) by (apply Rdiv_lt_0_compat; [apply cond_pos|assumption]).
  exists (mkposreal _ D). intros y Hy. change (Rabs (y - x) < eps / (Rabs b + 1)) in Hy.
  apply Rle_lt_trans with (1 := leaning_cut_varies_little a b x y).
  apply Rle_lt_trans with ((Rabs b + 1) * Rabs (y - x)); [pose proof (Rabs_pos (y - x)); nra|].
  apply (Rmult_lt_compat_l (Rabs b + 1)) in Hy; [|assumption].
  replace ((Rabs b + 1) * (eps / (Rabs b + 1))) with (pos eps) in Hy by (field; lra). exact Hy.
Qed.

Lemma leaning_cut_is_share : forall total B H K n m a b,
  share_of_strips (gradient_flux_density total B K n) (gradient_weight_density total B H n m) (leaning_cut a b).
Proof.
  intros total B H K n m a b. split; [intros; apply leaning_cut_between|].
  assert (P : forall f : R -> R, (forall x, ex_derive f x) -> ex_RInt (fun x => f x * leaning_cut a b x) 0 1).
  { intros f D. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros x _.
    apply (continuous_mult (K := R_AbsRing) f (leaning_cut a b)); [now apply (ex_derive_continuous f)|apply leaning_cut_continuous]. }
  split; apply P; intros x; unfold gradient_flux_density, gradient_weight_density; auto_derive; exact I.
Qed.

Theorem no_leaning_cut_gains_more_than_best_cut : forall total B H K w_j n m best a b,
  0 < total -> 0 < B -> 0 < H -> 0 < K -> 0 < w_j -> (1 <= m)%nat ->
  only_maximiser (cut_objective n m) 0 1 best ->
  gradient_division_gain total B H K w_j n m (leaning_cut a b) <= gradient_patch_gain total B H K w_j n m best.
Proof.
  intros. apply no_division_gains_more_than_best_cut; try assumption. apply leaning_cut_is_share.
Qed.
