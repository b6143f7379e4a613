(* x log x, with 0 log 0 = 0, is continuous at every x, zero included. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information LogSum.
Open Scope R_scope.

Lemma xlogx_closed_form : forall x, xlog2 x 1 = x * (ln x / ln 2).
Proof.
  intros x. destruct (Req_dec x 0) as [->|H]; [rewrite xlog2_0; lra|].
  rewrite xlog2_nonzero by assumption. unfold log2. now replace (x / 1) with x by field.
Qed.

(* Near 0: |x ln x| < 2 sqrt x, because ln (1 / sqrt x) < 1 / sqrt x. *)
Lemma xlogx_small : forall x, 0 < x < 1 -> Rabs (x * ln x) < 2 * sqrt x.
Proof.
  intros x [H0 H1]. set (s := sqrt x). assert (Hs : 0 < s) by now apply sqrt_lt_R0.
  assert (E : x = s * s) by (symmetry; apply sqrt_sqrt; lra).
  assert (Hs1 : s < 1) by nra.
  rewrite E, ln_mult by assumption.
  assert (Hl : ln s < 0) by (rewrite <- ln_1; now apply ln_increasing).
  assert (Hi : 1 < / s) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra).
  assert (T : ln (/ s) < / s - 1) by (apply ln_below_tangent; lra). rewrite ln_Rinv in T by assumption.
  assert (S1 : s * / s = 1) by (apply Rinv_r; lra).
  assert (T2 : s * - ln s < 1) by nra.
  rewrite Rabs_left by nra. nra.
Qed.

Lemma ln_of_nonpositive : forall t, t <= 0 -> ln t = 0.
Proof. intros t H. unfold ln. destruct (Rlt_dec 0 t); [exfalso; lra|reflexivity]. Qed.

Lemma xlogx_continuous : forall x, continuity_pt (fun x => xlog2 x 1) x.
Proof.
  intros x. apply continuity_pt_ext with (fun x => x * (ln x / ln 2)).
  { intros t. symmetry. apply xlogx_closed_form. }
  destruct (Rtotal_order x 0) as [H|[->|H]].
  - apply continuity_pt_ext_loc with (fun _ => 0); [|apply continuity_pt_const; now intros ? ?].
    assert (Hx : 0 < - x) by lra. exists (mkposreal _ Hx). intros t Ht.
    apply Rabs_def2 in Ht. unfold minus, plus, opp in Ht. simpl in Ht.
    rewrite ln_of_nonpositive by lra. lra.
  - apply continuity_pt_locally. intros eps. assert (He := cond_pos eps). assert (H2 := ln_2_positive).
    pose (k := eps * ln 2 / 2). assert (Hk : 0 < k) by (unfold k; nra).
    assert (Hd : 0 < Rmin 1 (k * k)) by (apply Rmin_pos; nra).
    exists (mkposreal _ Hd). intros t Ht. apply Rabs_def2 in Ht. unfold minus, plus, opp in Ht. simpl in Ht.
    assert (Hm1 := Rmin_l 1 (k * k)). assert (Hm2 := Rmin_r 1 (k * k)).
    rewrite Rmult_0_l, Rminus_0_r. destruct (Rle_or_lt t 0) as [Ht0|Ht0].
    + rewrite (ln_of_nonpositive t) by lra.
      replace (t * (0 / ln 2)) with 0 by (field; lra). now rewrite Rabs_R0.
    + replace (t * (ln t / ln 2)) with (t * ln t * / ln 2) by (field; lra).
      rewrite Rabs_mult, (Rabs_right (/ ln 2)) by (left; now apply Rinv_0_lt_compat).
      apply (Rmult_lt_reg_r (ln 2)); [exact H2|].
      rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      apply Rlt_le_trans with (1 := xlogx_small t ltac:(lra)).
      assert (sqrt t <= k); [|unfold k in *; lra].
      rewrite <- (sqrt_square k) by lra. apply sqrt_le_1_alt. lra.
  - apply continuity_pt_mult; [apply derivable_continuous_pt, derivable_pt_id|].
    apply continuity_pt_mult; [|apply continuity_pt_const; now intros ? ?].
    apply derivable_continuous_pt. exists (/ x). now apply derivable_pt_lim_ln.
Qed.
