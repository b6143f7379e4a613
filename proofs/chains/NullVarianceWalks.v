(* Random walks for x_i = s_i + sum_j T_ij x_j: the walk goes from i to j with probability P_ij, multiplies its weight by
   T_ij / P_ij, and adds weight times s on every state. With P_ij = T_ij x_j / (x_i - s_i) what it has added and what it
   may still expect, weight times x - s, always sum to the same number, and the expectation tends to 0: no variance.
   Sections 3.4 and 3.5 for radiosity (T_ij = R_i F_ij) and importance (T_ij = R_j F_ij). *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums FiniteSums.
Open Scope R_scope.

(* The weight of the walk path 0, path 1, ... on its state k. *)
Fixpoint walk_weight (start : R) (transfer P : nat -> nat -> R) (path : nat -> nat) (k : nat) : R :=
  match k with
  | O => start
  | S l => walk_weight start transfer P path l * (transfer (path l) (path (S l)) / P (path l) (path (S l)))
  end.

(* What the walk has added after K steps. *)
Definition walk_score (start : R) (transfer P : nat -> nat -> R) (source : nat -> R) (path : nat -> nat) (K : nat) : R :=
  sum (S K) (fun k => walk_weight start transfer P path k * source (path k)).

(* What it may still expect to add. *)
Definition walk_rest (start : R) (transfer P : nat -> nat -> R) (source solution : nat -> R) (path : nat -> nat)
    (K : nat) : R :=
  walk_weight start transfer P path K * (solution (path K) - source (path K)).

(* T_ij x_j / (x_i - s_i). *)
Definition null_variance_transition (transfer : nat -> nat -> R) (source solution : nat -> R) (i j : nat) : R :=
  transfer i j * solution j / (solution i - source i).

(* 1 - s/x, the part of what is left that a state leaves over. *)
Definition share_left (source solution : nat -> R) (path : nat -> nat) (k : nat) : R :=
  1 - source (path k) / solution (path k).

(* ---- One walk ---- *)
Section OneWalk.
Variables (transfer : nat -> nat -> R) (source solution : nat -> R) (start : R) (path : nat -> nat).
Local Notation P := (null_variance_transition transfer source solution).
Local Notation W := (walk_weight start transfer P path).

Lemma possible_step : forall i j, 0 < P i j -> transfer i j <> 0 /\ solution j <> 0 /\ solution i - source i <> 0.
Proof.
  intros i j H. unfold null_variance_transition, Rdiv in H. repeat split; intro Z; rewrite Z in H.
  - rewrite !Rmult_0_l in H. lra.
  - rewrite Rmult_0_r, Rmult_0_l in H. lra.
  - rewrite Rinv_0, Rmult_0_r in H. lra.
Qed.

(* A step hands on exactly what was left: W_{k+1} x_{k+1} = W_k (x_k - s_k). *)
Lemma step_keeps_what_is_left : forall k, 0 < P (path k) (path (S k)) ->
  W (S k) * solution (path (S k)) = W k * (solution (path k) - source (path k)).
Proof.
  intros k H. destruct (possible_step _ _ H) as [HT [HX HD]]. simpl. unfold null_variance_transition. field. auto.
Qed.

Theorem score_and_rest_are_constant : forall K, (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_score start transfer P source path K + walk_rest start transfer P source solution path K
  = start * solution (path 0%nat).
Proof.
  unfold walk_score, walk_rest. induction K as [|K IH]; intros H.
  - simpl. ring.
  - rewrite <- IH by auto. assert (E := step_keeps_what_is_left K (H K (Nat.lt_succ_diag_r K))).
    change (sum (S (S K)) (fun k => W k * source (path k)))
      with (sum (S K) (fun k => W k * source (path k)) + W (S K) * source (path (S K))). lra.
Qed.

Theorem rest_is_product : forall K, solution (path 0%nat) <> 0 ->
  (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_rest start transfer P source solution path K
  = start * solution (path 0%nat) * prod_f_R0 (share_left source solution path) K.
Proof.
  unfold walk_rest. intros K H0. induction K as [|K IH]; intros H.
  - simpl. unfold share_left. field. assumption.
  - assert (HK := H K (Nat.lt_succ_diag_r K)). destruct (possible_step _ _ HK) as [_ [HX _]].
    simpl prod_f_R0. rewrite <- Rmult_assoc, <- IH, <- (step_keeps_what_is_left K) by auto. unfold share_left.
    field. assumption.
Qed.

(* A walk without end finds start x_0 exactly when the product vanishes. *)
Theorem score_converges_iff_product_vanishes : start * solution (path 0%nat) <> 0 ->
  (forall k, 0 < P (path k) (path (S k))) ->
  Un_cv (walk_score start transfer P source path) (start * solution (path 0%nat)) <->
  Un_cv (prod_f_R0 (share_left source solution path)) 0.
Proof.
  intros H0 H. set (a := start * solution (path 0%nat)) in *.
  assert (HX : solution (path 0%nat) <> 0) by (intro Z; apply H0; unfold a; rewrite Z; ring).
  assert (E : forall K, walk_score start transfer P source path K - a
    = - (a * prod_f_R0 (share_left source solution path) K)).
  { intros K. unfold a. rewrite <- rest_is_product, <- (score_and_rest_are_constant K) by auto. ring. }
  assert (Ha : 0 < Rabs a) by now apply Rabs_pos_lt.
  split; intros C eps Heps.
  - destruct (C (Rabs a * eps)) as [N HN]; [now apply Rmult_lt_0_compat|]. exists N. intros K HK. specialize (HN K HK).
    unfold R_dist in *. rewrite E, Rabs_Ropp, Rabs_mult in HN. rewrite Rminus_0_r.
    now apply Rmult_lt_reg_l with (Rabs a).
  - destruct (C (eps / Rabs a)) as [N HN]; [now apply Rdiv_lt_0_compat|]. exists N. intros K HK. specialize (HN K HK).
    unfold R_dist in *. rewrite E, Rabs_Ropp, Rabs_mult. rewrite Rminus_0_r in HN.
    apply Rmult_lt_compat_l with (r := Rabs a) in HN; [|assumption].
    replace (Rabs a * (eps / Rabs a)) with eps in HN by (field; lra). assumption.
Qed.
End OneWalk.

(* No other probabilities do: already after one step from i to j, Q_ij must be P_ij. *)
Theorem null_variance_step_iff : forall (transfer : nat -> nat -> R) (source solution : nat -> R) i j Q,
  Q <> 0 -> solution i <> source i ->
  source i + transfer i j / Q * solution j = solution i <-> Q = null_variance_transition transfer source solution i j.
Proof.
  intros T s x i j Q HQ HD. unfold null_variance_transition. split; intros H.
  - replace (T i j * x j) with (Q * (x i - s i)); [field; lra|].
    replace (x i - s i) with (T i j / Q * x j) by lra. field. assumption.
  - rewrite H in HQ |- *. assert (T i j <> 0 /\ x j <> 0) as [H1 H2].
    { split; intro Z; apply HQ; rewrite Z; field; lra. }
    field. repeat split; lra.
Qed.

(* ---- With the signs that light has ---- *)

Record transport (n : nat) (transfer : nat -> nat -> R) (source solution : nat -> R) : Prop := {
  transport_solves : forall i, (i < n)%nat -> solution i = source i + sum n (fun j => transfer i j * solution j);
  transfer_nonneg : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= transfer i j;
  source_nonneg : forall i, (i < n)%nat -> 0 <= source i;
  source_below_solution : forall i, (i < n)%nat -> source i < solution i
}.

Section Transport.
Variables (n : nat) (transfer : nat -> nat -> R) (source solution : nat -> R).
Hypothesis solved : transport n transfer source solution.
Local Notation P := (null_variance_transition transfer source solution).

Lemma solution_positive : forall i, (i < n)%nat -> 0 < solution i.
Proof.
  intros i Hi. assert (H0 := source_nonneg _ _ _ _ solved i Hi). assert (H := source_below_solution _ _ _ _ solved i Hi).
  lra.
Qed.

Lemma share_bounds : forall i, (i < n)%nat -> 0 <= 1 - source i / solution i <= 1.
Proof.
  intros i Hi. assert (HX := solution_positive i Hi). assert (H0 := source_nonneg _ _ _ _ solved i Hi).
  assert (H := source_below_solution _ _ _ _ solved i Hi).
  assert (0 <= source i / solution i) by (apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]).
  assert (source i / solution i < 1) by (apply Rmult_lt_reg_r with (solution i); [lra|]; field_simplify; lra). lra.
Qed.

Lemma product_bounds : forall path K, (forall k, (k <= K)%nat -> (path k < n)%nat) ->
  0 <= prod_f_R0 (share_left source solution path) K <= 1.
Proof.
  intros path K. induction K as [|K IH]; intros H.
  - apply (share_bounds (path 0%nat)). auto.
  - destruct IH as [L U]; [auto|]. destruct (share_bounds (path (S K))) as [l u]; [auto|]. simpl. split.
    + now apply Rmult_le_pos.
    + rewrite <- (Rmult_1_l 1). now apply Rmult_le_compat.
Qed.

Lemma product_falls : forall path, (forall k, (path k < n)%nat) -> forall K d,
  prod_f_R0 (share_left source solution path) (K + d) <= prod_f_R0 (share_left source solution path) K.
Proof.
  intros path H K. induction d as [|d IH]; [rewrite Nat.add_0_r; lra|]. rewrite Nat.add_succ_r. simpl.
  destruct (product_bounds path (K + d)) as [L _]; [auto|]. destruct (share_bounds (path (S (K + d)))) as [_ u]; [auto|].
  apply Rle_trans with (2 := IH). rewrite <- (Rmult_1_r (prod_f_R0 _ _)) at 2. now apply Rmult_le_compat_l.
Qed.

(* Of finitely many states with a source one has the least share s / x. *)
Lemma least_source_share : exists e, 0 < e <= 1 /\
  forall i, (i < n)%nat -> 0 < source i -> e <= source i / solution i.
Proof.
  assert (H : forall m, (m <= n)%nat -> exists e, 0 < e <= 1 /\
    forall i, (i < m)%nat -> 0 < source i -> e <= source i / solution i).
  { induction m as [|m IH]; intros Hm; [exists 1; split; [lra|intros; lia]|].
    destruct IH as [e [He Hl]]; [lia|]. destruct (Rlt_dec 0 (source m)) as [Hs|Hs].
    - assert (0 < source m / solution m) by (apply Rdiv_lt_0_compat; [assumption|apply solution_positive; lia]).
      exists (Rmin e (source m / solution m)). split.
      + split; [now apply Rmin_glb_lt|]. apply Rle_trans with e; [apply Rmin_l|lra].
      + intros i Hi Hp. destruct (Nat.eq_dec i m) as [->|]; [apply Rmin_r|].
        apply Rle_trans with e; [apply Rmin_l|]. apply Hl; [lia|assumption].
    - exists e. split; [assumption|]. intros i Hi Hp. destruct (Nat.eq_dec i m) as [->|]; [contradiction|].
      apply Hl; [lia|assumption]. }
  exact (H n (le_n n)).
Qed.

(* A walk that comes to states with a source again and again finds start x_0. *)
Theorem score_converges_if_sources_are_met_again : forall start path,
  (forall k, (path k < n)%nat) -> (forall k, 0 < P (path k) (path (S k))) ->
  (forall m, exists k, (m <= k)%nat /\ 0 < source (path k)) ->
  Un_cv (walk_score start transfer P source path) (start * solution (path 0%nat)).
Proof.
  intros start path Hn H Hs. assert (HX := solution_positive _ (Hn 0%nat)).
  assert (C : Un_cv (prod_f_R0 (share_left source solution path)) 0).
  { destruct least_source_share as [e [He Hl]].
    assert (D : forall q, exists K, prod_f_R0 (share_left source solution path) K <= (1 - e) ^ q).
    { induction q as [|q [K HK]].
      - exists 0%nat. simpl. apply (share_bounds (path 0%nat)). auto.
      - destruct (Hs (S K)) as [k [Hk Hp]]. exists k. destruct k as [|k]; [lia|]. simpl.
        assert (F := product_falls path Hn K (k - K)). replace (K + (k - K))%nat with k in F by lia.
        destruct (product_bounds path k) as [L _]; [auto|]. destruct (share_bounds (path (S k))) as [l _]; [auto|].
        specialize (Hl (path (S k)) (Hn (S k)) Hp). rewrite (Rmult_comm (1 - e)). apply Rmult_le_compat;
          unfold share_left in *; lra. }
    intros eps Heps. destruct (pow_lt_1_zero (1 - e)) with (y := eps) as [q Hq];
      [rewrite Rabs_pos_eq; lra|assumption|].
    specialize (Hq q (le_n q)). rewrite Rabs_pos_eq in Hq by (apply pow_le; lra).
    destruct (D q) as [K HK]. exists K. intros k Hk. unfold R_dist. rewrite Rminus_0_r.
    assert (F := product_falls path Hn K (k - K)). replace (K + (k - K))%nat with k in F by lia.
    destruct (product_bounds path k) as [L _]; [auto|]. rewrite Rabs_pos_eq by assumption. lra. }
  destruct (Req_dec start 0) as [->|Z].
  - intros eps Heps. exists 0%nat. intros K _.
    assert (E := score_and_rest_are_constant transfer source solution 0 path K (fun k _ => H k)).
    rewrite rest_is_product in E by (auto; lra).
    replace (walk_score 0 transfer P source path K) with (0 * solution (path 0%nat)) by lra.
    now rewrite R_dist_eq.
  - apply score_converges_iff_product_vanishes; auto. apply Rmult_integral_contrapositive_currified; [assumption|lra].
Qed.
End Transport.
