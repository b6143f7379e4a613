(* Rules for integrals over a part of [0, 1] of a function that is Riemann integrable there, continuous or not. The one that is
   not a mere restatement of Coquelicot: the integral of f from 0 to c takes every value from 0 to its whole as c grows. *)
From Coq Require Import Reals Lra Ranalysis5.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Lemma integrable_below : forall (f : R -> R) c, ex_RInt f 0 1 -> 0 <= c <= 1 -> ex_RInt f 0 c.
Proof. intros f c H Hc. now apply (ex_RInt_Chasles_1 (V := R_CompleteNormedModule) f 0 c 1). Qed.

Lemma integrable_above : forall (f : R -> R) c, ex_RInt f 0 1 -> 0 <= c <= 1 -> ex_RInt f c 1.
Proof. intros f c H Hc. now apply (ex_RInt_Chasles_2 (V := R_CompleteNormedModule) f 0 c 1). Qed.

Lemma integral_split : forall (f : R -> R) c, ex_RInt f 0 1 -> 0 <= c <= 1 -> RInt f 0 1 = RInt f 0 c + RInt f c 1.
Proof.
  intros f c H Hc. symmetry. apply (RInt_Chasles (V := R_CompleteNormedModule) f 0 c 1).
  - now apply integrable_below.
  - now apply integrable_above.
Qed.

Lemma integral_of_difference : forall (f h : R -> R) a b, ex_RInt f a b -> ex_RInt h a b ->
  RInt (fun x => f x - h x) a b = RInt f a b - RInt h a b.
Proof. intros f h a b Hf Hh. exact (RInt_minus (V := R_CompleteNormedModule) f h a b Hf Hh). Qed.

Lemma difference_integrable : forall (f h : R -> R) a b, ex_RInt f a b -> ex_RInt h a b -> ex_RInt (fun x => f x - h x) a b.
Proof. intros f h a b Hf Hh. exact (ex_RInt_minus (V := R_NormedModule) f h a b Hf Hh). Qed.

Lemma riemann_integral_of_multiple : forall k (f : R -> R) a b, ex_RInt f a b -> RInt (fun x => k * f x) a b = k * RInt f a b.
Proof. intros k f a b H. exact (RInt_scal (V := R_CompleteNormedModule) f a b k H). Qed.

Lemma multiple_integrable : forall k (f : R -> R) a b, ex_RInt f a b -> ex_RInt (fun x => k * f x) a b.
Proof. intros k f a b H. exact (ex_RInt_scal (V := R_NormedModule) f a b k H). Qed.

(* The integral of f from 0 to c depends continuously on c, ends included: continue f by 0 beyond [0, 1]. *)
Lemma integral_takes_every_value : forall (f : R -> R) y, ex_RInt f 0 1 -> 0 <= y <= RInt f 0 1 ->
  exists c, 0 <= c <= 1 /\ RInt f 0 c = y.
Proof.
  intros f y H Hy.
  set (F := fun x => if Rle_dec 0 x then if Rle_dec x 1 then f x else 0 else 0).
  assert (inside : forall x, 0 <= x <= 1 -> F x = f x).
  { intros x Hx. unfold F. destruct (Rle_dec 0 x), (Rle_dec x 1); lra. }
  assert (I : ex_RInt F (-1) 2).
  { apply (ex_RInt_Chasles (V := R_NormedModule) F (-1) 0 2); [|apply (ex_RInt_Chasles (V := R_NormedModule) F 0 1 2)].
    - apply (ex_RInt_ext (V := R_NormedModule) (fun _ => 0)); [|apply ex_RInt_const].
      intros x. rewrite Rmin_left, Rmax_right by lra. intros Hx. unfold F. destruct (Rle_dec 0 x); lra.
    - apply (ex_RInt_ext (V := R_NormedModule) f); [|exact H].
      intros x. rewrite Rmin_left, Rmax_right by lra. intros Hx. symmetry. apply inside. lra.
    - apply (ex_RInt_ext (V := R_NormedModule) (fun _ => 0)); [|apply ex_RInt_const].
      intros x. rewrite Rmin_left, Rmax_right by lra. intros Hx. unfold F. destruct (Rle_dec 0 x), (Rle_dec x 1); lra. }
  assert (E : forall c, 0 <= c <= 1 -> RInt F 0 c = RInt f 0 c).
  { intros c Hc. apply (RInt_ext (V := R_CompleteNormedModule)). intros x.
    rewrite Rmin_left, Rmax_right by lra. intros Hx. apply inside. lra. }
  assert (J : forall z, -1 < z < 2 -> ex_RInt F 0 z).
  { intros z Hz. apply (ex_RInt_Chasles (V := R_NormedModule) F 0 (-1) z).
    - apply ex_RInt_swap, (ex_RInt_Chasles_1 (V := R_CompleteNormedModule) F (-1) 0 2); [lra|exact I].
    - apply (ex_RInt_Chasles_1 (V := R_CompleteNormedModule) F (-1) z 2); [lra|exact I]. }
  destruct (f_interv_is_interv (fun c => RInt F 0 c) 0 1 y) as [c [Hc Ec]].
  - lra.
  - rewrite (E 1) by lra. rewrite RInt_point. exact Hy.
  - intros x Hx. apply continuity_pt_filterlim.
    apply (continuous_RInt_1 (V := R_NormedModule) F 0 x (fun c => RInt F 0 c)).
    assert (P : 0 < 1 / 2) by lra. exists (mkposreal _ P). intros z Hz.
    apply (RInt_correct (V := R_CompleteNormedModule)), J.
    change (Rabs (z - x) < 1 / 2) in Hz. apply Rabs_def2 in Hz. lra.
  - exists c. split; [exact Hc|]. rewrite <- E by exact Hc. exact Ec.
Qed.
