(* The divisions of ContinuousInformation.v are what the paper has in mind: if the kernel is symmetric and its
   integral over y is one, they are reciprocal Markov chains. The order of integration has to be exchanged for it. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums Refinement Corollary1 DoubleIntegral Divisions
  ContinuousInformation.
Open Scope R_scope.

Lemma transposed_continuous : forall f, continuous_in_both f -> continuous_in_both (fun y x => f x y).
Proof.
  intros f H y x eps. destruct (H x y eps) as [d D]. exists d. intros u v Hu Hv. now apply D.
Qed.

(* k-th break point of [a, b] in n equal pieces. *)
Definition equal_breaks (a b : R) (n : nat) (k : nat) : R := a + INR k * ((b - a) / INR n).

Lemma equal_breaks_step : forall a b n k,
  equal_breaks a b n (S k) - equal_breaks a b n k = (b - a) / INR n.
Proof. intros. unfold equal_breaks. rewrite S_INR. lra. Qed.

Lemma equal_breaks_within : forall a b n k, a <= b -> (0 < n)%nat -> (k <= n)%nat ->
  a <= equal_breaks a b n k <= b.
Proof.
  intros a b n k Hab Hn Hk. assert (N : 0 < INR n) by now apply lt_0_INR.
  assert (H : 0 <= (b - a) / INR n)
    by (apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat]).
  assert (K := pos_INR k). assert (K1 := le_INR _ _ Hk).
  assert (E : INR n * ((b - a) / INR n) = b - a) by (field; lra). unfold equal_breaks. nra.
Qed.

(* In a fine grid both iterated integrals are area times value in each cell, at points near each other. *)
Theorem order_of_integration : forall f, continuous_in_both f -> forall a b c d, a <= b -> c <= d ->
  double_integral f a b c d = double_integral (fun y x => f x y) c d a b.
Proof.
  intros f Hf a b c d Hab Hcd. assert (Ht := transposed_continuous f Hf).
  apply Rminus_diag_uniq. set (difference := double_integral f a b c d - _).
  enough (B : forall eps, 0 < eps -> Rabs difference <= (b - a) * (d - c) * eps).
  { set (A := (b - a) * (d - c)) in *. assert (HA : 0 <= A) by (apply Rmult_le_pos; lra).
    destruct (Req_dec difference 0) as [|H]; [assumption|exfalso].
    assert (HD := Rabs_pos_lt _ H).
    assert (He : 0 < Rabs difference / (2 * (A + 1))) by (apply Rdiv_lt_0_compat; lra).
    specialize (B _ He).
    assert (E : (A + 1) * (Rabs difference / (2 * (A + 1))) = Rabs difference / 2) by (field; lra). nra. }
  intros eps Heps.
  destruct (uniform_continuity_2d f a b c d (fun x y _ _ => Hf x y) (mkposreal eps Heps)) as [delta U].
  simpl in U. assert (Hd := cond_pos delta).
  (* enough pieces that both kinds are shorter than delta *)
  destruct (archimed_cor1 (delta / (b - a + (d - c) + 1)) ltac:(apply Rdiv_lt_0_compat; lra)) as [n [Hn Hn0]].
  assert (N : 0 < INR n) by now apply lt_0_INR.
  assert (Hn' : (b - a + (d - c) + 1) / INR n < delta).
  { apply (Rmult_lt_compat_l (b - a + (d - c) + 1)) in Hn; [|lra].
    replace ((b - a + (d - c) + 1) * (delta / (b - a + (d - c) + 1))) with (pos delta) in Hn by (field; lra).
    exact Hn. }
  assert (Hi : 0 < / INR n) by now apply Rinv_0_lt_compat.
  assert (Wx0 : 0 <= (b - a) / INR n) by (apply Rmult_le_pos; lra).
  assert (Wy0 : 0 <= (d - c) / INR n) by (apply Rmult_le_pos; lra).
  assert (Split : (b - a + (d - c) + 1) / INR n = (b - a) / INR n + (d - c) / INR n + / INR n) by (field; lra).
  set (p := equal_breaks a b n). set (q := equal_breaks c d n).
  assert (Sp : forall k, p (S k) - p k = (b - a) / INR n) by (intros; apply equal_breaks_step).
  assert (Sq : forall k, q (S k) - q k = (d - c) / INR n) by (intros; apply equal_breaks_step).
  assert (Ep : p 0%nat = a /\ p n = b) by (unfold p, equal_breaks; split; [simpl; lra|field; lra]).
  assert (Eq : q 0%nat = c /\ q n = d) by (unfold q, equal_breaks; split; [simpl; lra|field; lra]).
  assert (C1 := double_integral_over_cells f Hf p n q n (fun l => ltac:(specialize (Sq l); lra))).
  assert (C2 := double_integral_over_cells _ Ht q n p n (fun l => ltac:(specialize (Sp l); lra))).
  destruct Ep as [Ep1 Ep2]. destruct Eq as [Eq1 Eq2]. rewrite Ep1, Ep2, Eq1, Eq2 in C1, C2.
  rewrite sum_exchange in C2.
  set (cell := (b - a) / INR n * ((d - c) / INR n) * eps).
  assert (T : forall k l, (k < n)%nat -> (l < n)%nat -> - cell <=
    double_integral f (p k) (p (S k)) (q l) (q (S l)) -
    double_integral (fun y x => f x y) (q l) (q (S l)) (p k) (p (S k)) <= cell).
  { intros k l Hk Hl. assert (Pk := Sp k). assert (Ql := Sq l).
    destruct (double_integral_is_area_times_value f Hf (p k) (p (S k)) (q l) (q (S l)))
      as [x [y [Hx [Hy ->]]]]; try lra.
    destruct (double_integral_is_area_times_value _ Ht (q l) (q (S l)) (p k) (p (S k)))
      as [v [u [Hv [Hu ->]]]]; try lra.
    rewrite Pk, Ql.
    assert (B1 := equal_breaks_within a b n k Hab Hn0 ltac:(lia)).
    assert (B2 := equal_breaks_within a b n (S k) Hab Hn0 ltac:(lia)).
    assert (B3 := equal_breaks_within c d n l Hcd Hn0 ltac:(lia)).
    assert (B4 := equal_breaks_within c d n (S l) Hcd Hn0 ltac:(lia)).
    fold p in B1, B2. fold q in B3, B4.
    assert (E : Rabs (f x y - f u v) < eps) by (apply U; try lra; apply Rabs_def1; lra).
    apply Rabs_def2 in E. assert (0 <= (b - a) / INR n * ((d - c) / INR n)) by now apply Rmult_le_pos.
    unfold cell. split; nra. }
  assert (constant_sum : forall m (r : R), sum m (fun _ => r) = INR m * r).
  { induction m as [|m IH]; intros r; [simpl; lra|]. cbn [sum]. rewrite IH, S_INR. lra. }
  assert (A : sum n (fun _ => sum n (fun _ => cell)) = (b - a) * (d - c) * eps).
  { rewrite !constant_sum. unfold cell. field. lra. }
  unfold difference. rewrite C1, C2, <- sum_minus.
  rewrite (sum_ext n _ (fun k => sum n (fun l => double_integral f (p k) (p (S k)) (q l) (q (S l)) -
    double_integral (fun y x => f x y) (q l) (q (S l)) (p k) (p (S k))))) by (intros; symmetry; apply sum_minus).
  apply Rabs_le. rewrite <- A. split.
  - rewrite !constant_sum. replace (- (INR n * (INR n * cell))) with (INR n * (INR n * - cell)) by ring.
    rewrite <- !constant_sum. apply sum_le. intros k Hk. apply sum_le. intros l Hl. now apply T.
  - apply sum_le. intros k Hk. apply sum_le. intros l Hl. now apply T.
Qed.

Section Kernel.
Variable f : R -> R -> R.
Hypothesis f_continuous : continuous_in_both f.
Hypothesis f_nonneg : forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> 0 <= f x y.
(* The transition probabilities from each point sum to one, and the kernel is reciprocal (all weights are equal). *)
Hypothesis f_sums_to_one : forall x, 0 <= x <= 1 -> RInt (fun y => f x y) 0 1 = 1.
Hypothesis f_symmetric : forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> f x y = f y x.

Variables (n : nat) (p : nat -> R).
Hypothesis p_divides : division n p.
Hypothesis no_empty_interval : forall k, (k < n)%nat -> p k < p (S k).

Let C := discretized f n p.

Theorem discretized_is_markov_chain : markov_chain (states C) (weight C) (transition C).
Proof.
  split; unfold C; simpl.
  - intros k _. assert (H := breaks_grow _ _ p_divides k). lra.
  - intros k l Hk Hl. destruct (exchange_value f f_continuous n p p_divides k l Hk Hl)
      as [x [y [[Hx _] [[Hy _] ->]]]].
    assert (H1 := no_empty_interval k Hk). assert (H2 := breaks_grow _ _ p_divides l).
    apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; lra].
    repeat apply Rmult_le_pos; try lra. now apply f_nonneg.
  - now apply lengths_sum_to_one.
  - intros k Hk. assert (H1 := no_empty_interval k Hk). unfold Rdiv. rewrite sum_scale_right.
    assert (E := double_integral_over_cells f f_continuous
      (fun r => p (k + r)%nat) 1 p n (breaks_grow _ _ p_divides)).
    simpl in E. rewrite Nat.add_0_r, Nat.add_1_r, (first_break _ _ p_divides), (last_break _ _ p_divides) in E.
    rewrite Rplus_0_l in E. rewrite <- E. unfold double_integral.
    assert (B1 := breaks_between n p p_divides k ltac:(lia)).
    assert (B2 := breaks_between n p p_divides (S k) ltac:(lia)).
    rewrite (RInt_ext _ (fun _ => 1)).
    + rewrite (RInt_const (V := R_CompleteNormedModule)). unfold scal. simpl. unfold mult. simpl. field. lra.
    + intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply f_sums_to_one. lra.
Qed.

Theorem discretized_is_reciprocal : reciprocal (states C) (weight C) (transition C).
Proof.
  intros k l Hk Hl. unfold C in *. rewrite !joint_of_discretized by assumption.
  simpl in Hk, Hl.
  assert (B1 := breaks_between n p p_divides k ltac:(lia)).
  assert (B2 := breaks_between n p p_divides (S k) ltac:(lia)).
  assert (B3 := breaks_between n p p_divides l ltac:(lia)).
  assert (B4 := breaks_between n p p_divides (S l) ltac:(lia)).
  assert (H1 := breaks_grow _ _ p_divides k). assert (H2 := breaks_grow _ _ p_divides l).
  rewrite order_of_integration by assumption. unfold double_integral. apply RInt_ext. intros y Hy.
  rewrite Rmin_left, Rmax_right in Hy by lra. apply RInt_ext. intros x Hx.
  rewrite Rmin_left, Rmax_right in Hx by lra. apply f_symmetric; lra.
Qed.
End Kernel.

(* The hypotheses can be met by a kernel that is not constant: 1 + (2x - 1)(2y - 1). *)
Definition tilted_kernel (x y : R) : R := 1 + (2 * x - 1) * (2 * y - 1).

Theorem tilted_kernel_fulfils_hypotheses : continuous_in_both tilted_kernel /\
  (forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> 0 <= tilted_kernel x y) /\
  (forall x, 0 <= x <= 1 -> RInt (fun y => tilted_kernel x y) 0 1 = 1) /\
  (forall x y, tilted_kernel x y = tilted_kernel y x) /\
  tilted_kernel 1 1 = 2 /\ tilted_kernel 1 0 = 0.
Proof.
  unfold tilted_kernel. repeat split.
  - intros x y. repeat first [apply continuity_2d_pt_plus | apply continuity_2d_pt_minus |
      apply continuity_2d_pt_mult | apply continuity_2d_pt_const | apply continuity_2d_pt_id1 |
      apply continuity_2d_pt_id2].
  - intros x y Hx Hy. nra.
  - intros x _. pose (F := fun y => y + (2 * x - 1) * (y * y - y)).
    assert (H : is_RInt (fun y => 1 + (2 * x - 1) * (2 * y - 1)) 0 1 (minus (F 1) (F 0))).
    { apply (is_RInt_derive F); intros y _; unfold F.
      - auto_derive; [exact I|ring].
      - apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I. }
    rewrite (is_RInt_unique _ _ _ _ H). unfold minus, plus, opp, F. simpl. ring.
  - intros x y. ring.
  - ring.
  - ring.
Qed.
