(* Integrals of a continuous function of two variables over rectangles: they add up over the cells of a grid, and
   over each cell they are its area times a value of the function. The tools of ContinuousInformation.v. *)
From Coq Require Import Reals Lra Lia Arith.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums.
Open Scope R_scope.

Definition continuous_in_both (f : R -> R -> R) : Prop := forall x y, continuity_2d_pt f x y.

(* The integral over x in [a, b] and y in [c, d]. *)
Definition double_integral (f : R -> R -> R) (a b c d : R) : R :=
  RInt (fun x => RInt (fun y => f x y) c d) a b.

(* ---- One variable ---- *)

Lemma continuous_integrable : forall (g : R -> R) a b, (forall x, continuous g x) -> ex_RInt g a b.
Proof. intros. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto. Qed.

(* The mean value: an integral is the length times a value. *)
Lemma integral_is_length_times_value : forall (g : R -> R) a b, (forall x, continuous g x) -> a <= b ->
  exists x, a <= x <= b /\ RInt g a b = (b - a) * g x.
Proof.
  intros g a b H Hab.
  assert (D : forall x, is_derive (fun t => RInt g a t) x (g x)).
  { intros x. apply (is_derive_RInt g (fun t => RInt g a t) a x); [|apply H].
    exists (mkposreal 1 Rlt_0_1). intros t _.
    apply (RInt_correct (V := R_CompleteNormedModule)). now apply continuous_integrable. }
  destruct (MVT_gen (fun t => RInt g a t) a b g) as [x [Hx E]].
  - intros. apply D.
  - intros x _. apply derivable_continuous_pt. exists (g x). apply is_derive_Reals, D.
  - rewrite Rmin_left, Rmax_right in Hx by assumption. exists x. split; [exact Hx|].
    rewrite (RInt_point (V := R_CompleteNormedModule) a g) in E. unfold zero in E. simpl in E. lra.
Qed.

(* An integral is the sum over the intervals between break points p 0, ..., p n. *)
Lemma integral_over_intervals : forall (g : R -> R) p n, (forall x, continuous g x) ->
  RInt g (p 0%nat) (p n) = sum n (fun k => RInt g (p k) (p (S k))).
Proof.
  intros g p n H. induction n as [|n IH]; simpl.
  - apply (RInt_point (V := R_CompleteNormedModule)).
  - rewrite <- IH. symmetry.
    apply (RInt_Chasles (V := R_CompleteNormedModule)); now apply continuous_integrable.
Qed.

Lemma sum_continuous : forall n (g : nat -> R -> R), (forall k x, continuous (g k) x) ->
  forall x, continuous (fun x => sum n (fun k => g k x)) x.
Proof.
  intros n g H x. induction n as [|n IH]; simpl.
  - apply continuous_const.
  - now apply (continuous_plus (fun x => sum n (fun k => g k x)) (g n)).
Qed.

Lemma riemann_integral_of_sum : forall n (g : nat -> R -> R) a b, (forall k x, continuous (g k) x) ->
  RInt (fun x => sum n (fun k => g k x)) a b = sum n (fun k => RInt (g k) a b).
Proof.
  intros n g a b H. induction n as [|n IH]; simpl.
  - rewrite (RInt_const (V := R_CompleteNormedModule)). apply Rmult_0_r.
  - rewrite <- IH.
    apply (RInt_plus (V := R_CompleteNormedModule) (fun x => sum n (fun k => g k x)) (g n));
    apply continuous_integrable; [now apply sum_continuous|apply H].
Qed.

(* ---- Two variables ---- *)

Section TwoVariables.
Variable f : R -> R -> R.
Hypothesis f_continuous : continuous_in_both f.

Lemma section_continuous : forall x y, continuous (fun y => f x y) y.
Proof.
  intros x y. apply continuity_pt_filterlim, continuity_pt_locally. intros eps.
  destruct (f_continuous x y eps) as [d D]. exists d. intros v Hv. apply D; [|exact Hv].
  rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. apply cond_pos.
Qed.

(* x -> integral of f(x, .) is continuous, since f is uniformly so near the segment. *)
Lemma inner_integral_continuous : forall c d x, c <= d ->
  continuous (fun x => RInt (fun y => f x y) c d) x.
Proof.
  intros c d x Hcd. apply continuity_pt_filterlim, continuity_pt_locally. intros eps.
  assert (Heta : 0 < eps / (d - c + 1)) by (apply Rdiv_lt_0_compat; [apply cond_pos|lra]).
  destruct (uniform_continuity_2d_1d' f c d x (fun y _ => f_continuous x y) (mkposreal _ Heta)) as [delta D].
  exists delta. intros v Hv. simpl in D.
  assert (Ev := continuous_integrable (fun y => f v y) c d (section_continuous v)).
  assert (Ex := continuous_integrable (fun y => f x y) c d (section_continuous x)).
  assert (E : RInt (fun y => f v y - f x y) c d = RInt (fun y => f v y) c d - RInt (fun y => f x y) c d)
    by exact (RInt_minus (V := R_CompleteNormedModule) _ _ c d Ev Ex).
  rewrite <- E. apply Rle_lt_trans with ((d - c) * (eps / (d - c + 1))).
  - apply abs_RInt_le_const; [exact Hcd| |].
    + exact (ex_RInt_minus (V := R_NormedModule) _ _ c d Ev Ex).
    + intros y Hy. left. apply Rabs_def2 in Hv. unfold minus, plus, opp in Hv. simpl in Hv.
      assert (0 < delta) by apply cond_pos.
      apply (D y x y v); try lra. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
  - assert (0 < eps) by apply cond_pos.
    apply Rlt_le_trans with ((d - c + 1) * (eps / (d - c + 1))); [|right; field; lra].
    apply Rmult_lt_compat_r; lra.
Qed.

(* Over a rectangle the integral is the area times a value. *)
Lemma double_integral_is_area_times_value : forall a b c d, a <= b -> c <= d ->
  exists x y, a <= x <= b /\ c <= y <= d /\ double_integral f a b c d = (b - a) * (d - c) * f x y.
Proof.
  intros a b c d Hab Hcd.
  destruct (integral_is_length_times_value (fun x => RInt (fun y => f x y) c d) a b) as [x [Hx Ex]];
    [intros; now apply inner_integral_continuous|exact Hab|].
  destruct (integral_is_length_times_value (fun y => f x y) c d) as [y [Hy Ey]];
    [apply section_continuous|exact Hcd|].
  exists x, y. split; [exact Hx|split; [exact Hy|]]. unfold double_integral. rewrite Ex, Ey. ring.
Qed.

(* The cells of a grid with break points p 0 <= ... and q 0 <= ... add up. *)
Lemma double_integral_over_cells : forall p n q m, (forall l, q l <= q (S l)) ->
  double_integral f (p 0%nat) (p n) (q 0%nat) (q m) =
  sum n (fun k => sum m (fun l => double_integral f (p k) (p (S k)) (q l) (q (S l)))).
Proof.
  intros p n q m Hq. unfold double_integral.
  rewrite (RInt_ext _ (fun x => sum m (fun l => RInt (fun y => f x y) (q l) (q (S l))))).
  2: { intros x _. apply (integral_over_intervals (fun y => f x y)). apply section_continuous. }
  assert (C : forall l x, continuous (fun x => RInt (fun y => f x y) (q l) (q (S l))) x)
    by (intros; now apply inner_integral_continuous).
  rewrite (integral_over_intervals _ p n) by now apply sum_continuous.
  apply sum_ext. intros k _. now apply riemann_integral_of_sum.
Qed.
End TwoVariables.
