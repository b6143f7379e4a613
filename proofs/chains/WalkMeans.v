(* Random walks, continued from NullVarianceWalks.v: the mean over all walks of K steps. The score together with what is
   left has the mean start x_i and no variance; the mean square of what the score alone is off by falls geometrically. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums FiniteSums NullVarianceWalks.
Open Scope R_scope.

(* The first K steps are possible. *)
Definition possible_walk (n : nat) (P : nat -> nat -> R) (path : nat -> nat) (K : nat) : Prop :=
  (forall k, (k <= K)%nat -> (path k < n)%nat) /\ (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))).

Definition prepended (i : nat) (path : nat -> nat) (k : nat) : nat := match k with O => i | S l => path l end.

(* The mean of f over all walks of K steps from i; beyond its K steps a walk stays where it is. *)
Fixpoint walk_mean (n : nat) (P : nat -> nat -> R) (K i : nat) (f : (nat -> nat) -> R) : R :=
  match K with
  | O => f (fun _ => i)
  | S L => sum n (fun j => P i j * walk_mean n P L j (fun path => f (prepended i path)))
  end.

Section WalkMeans.
Variables (n : nat) (transfer : nat -> nat -> R) (source solution : nat -> R).
Hypothesis solved : transport n transfer source solution.
Local Notation P := (null_variance_transition transfer source solution).

Lemma null_variance_transition_nonneg : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= P i j.
Proof.
  intros i j Hi Hj. unfold null_variance_transition. assert (HX := solution_positive _ _ _ _ solved j Hj).
  assert (HT := transfer_nonneg _ _ _ _ solved i j Hi Hj). assert (H := source_below_solution _ _ _ _ solved i Hi).
  apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; lra].
Qed.

Lemma null_transition_has_no_transfer : forall i j, (i < n)%nat -> (j < n)%nat -> P i j = 0 -> transfer i j = 0.
Proof.
  intros i j Hi Hj E. assert (HX := solution_positive _ _ _ _ solved j Hj).
  assert (H := source_below_solution _ _ _ _ solved i Hi).
  assert (Z : transfer i j * solution j = P i j * (solution i - source i))
    by (unfold null_variance_transition; field; lra).
  rewrite E, Rmult_0_l in Z. destruct (Rmult_integral _ _ Z); [assumption|lra].
Qed.

Theorem null_variance_rows_sum_to_one : forall i, (i < n)%nat -> sum n (fun j => P i j) = 1.
Proof.
  intros i Hi. unfold null_variance_transition, Rdiv. rewrite sum_scale_right.
  assert (E := transport_solves _ _ _ _ solved i Hi). assert (H := source_below_solution _ _ _ _ solved i Hi).
  replace (sum n (fun j => transfer i j * solution j)) with (solution i - source i) by lra. apply Rinv_r. lra.
Qed.

Lemma walk_mean_le : forall K i f g, (i < n)%nat ->
  (forall path, path 0%nat = i -> possible_walk n P path K -> f path <= g path) ->
  walk_mean n P K i f <= walk_mean n P K i g.
Proof.
  induction K as [|K IH]; intros i f g Hi H; simpl.
  - apply H; [reflexivity|]. split; [auto|intros; lia].
  - apply sum_le. intros j Hj. destruct (Req_dec (P i j) 0) as [->|Z]; [lra|].
    apply Rmult_le_compat_l; [now apply null_variance_transition_nonneg|]. apply IH; [assumption|].
    intros path H0 [Hn HP]. apply H; [reflexivity|]. split.
    + intros [|k] Hk; simpl; [assumption|]. apply Hn. lia.
    + intros [|k] Hk; simpl.
      * rewrite H0. destruct (null_variance_transition_nonneg i j Hi Hj); [assumption|congruence].
      * apply HP. lia.
Qed.

Lemma walk_mean_ext : forall K i f g, (i < n)%nat ->
  (forall path, path 0%nat = i -> possible_walk n P path K -> f path = g path) ->
  walk_mean n P K i f = walk_mean n P K i g.
Proof. intros K i f g Hi H. apply Rle_antisym; apply walk_mean_le; auto; intros path H0 HP; rewrite H; auto; lra. Qed.

Lemma walk_mean_scale : forall K i c f, walk_mean n P K i (fun path => c * f path) = c * walk_mean n P K i f.
Proof.
  induction K as [|K IH]; intros i c f; simpl; [reflexivity|].
  rewrite <- sum_scale. apply sum_ext. intros j Hj. rewrite (IH j c (fun path => f (prepended i path))). ring.
Qed.

Lemma walk_mean_constant : forall K i c, (i < n)%nat -> walk_mean n P K i (fun _ => c) = c.
Proof.
  induction K as [|K IH]; intros i c Hi; simpl; [reflexivity|].
  rewrite (sum_ext n _ (fun j => P i j * c)) by (intros; now rewrite IH).
  rewrite sum_scale_right, null_variance_rows_sum_to_one by assumption. ring.
Qed.

Lemma weight_of_prepended : forall start i path k,
  walk_weight start transfer P (prepended i path) (S k)
  = walk_weight (start * (transfer i (path 0%nat) / P i (path 0%nat))) transfer P path k.
Proof.
  intros start i path. induction k as [|k IH]; [reflexivity|].
  change (walk_weight start transfer P (prepended i path) (S (S k))) with
    (walk_weight start transfer P (prepended i path) (S k) *
     (transfer (path k) (path (S k)) / P (path k) (path (S k)))). now rewrite IH.
Qed.

(* The mean of weight times y after K steps is T^K y, whatever the probabilities are: the walk is not biased. *)
Fixpoint transported (K : nat) (y : nat -> R) (i : nat) : R :=
  match K with O => y i | S L => sum n (fun j => transfer i j * transported L y j) end.

Lemma mean_weight : forall K i start y, (i < n)%nat ->
  walk_mean n P K i (fun path => walk_weight start transfer P path K * y (path K)) = start * transported K y i.
Proof.
  induction K as [|K IH]; intros i start y Hi; [reflexivity|].
  change (sum n (fun j => P i j * walk_mean n P K j (fun path =>
      walk_weight start transfer P (prepended i path) (S K) * y (path K)))
    = start * sum n (fun j => transfer i j * transported K y j)).
  rewrite <- sum_scale. apply sum_ext. intros j Hj.
  rewrite (walk_mean_ext K j _ (fun path =>
    walk_weight (start * (transfer i j / P i j)) transfer P path K * y (path K)) Hj).
  - rewrite IH by assumption. destruct (Req_dec (P i j) 0) as [Z|Z].
    + rewrite Z, (null_transition_has_no_transfer i j Hi Hj Z). ring.
    + field. assumption.
  - intros path H0 _. now rewrite weight_of_prepended, H0.
Qed.

Lemma transported_at_most : forall rho bound, 0 <= rho -> 0 <= bound ->
  (forall i, (i < n)%nat -> sum n (fun j => transfer i j) <= rho) ->
  forall y, (forall i, (i < n)%nat -> y i <= bound) ->
  forall K i, (i < n)%nat -> transported K y i <= rho ^ K * bound.
Proof.
  intros rho bound Hr Hb HT y Hy. induction K as [|K IH]; intros i Hi; simpl; [rewrite Rmult_1_l; auto|].
  apply Rle_trans with (sum n (fun j => transfer i j * (rho ^ K * bound))).
  - apply sum_le. intros j Hj. apply Rmult_le_compat_l; [now apply (transfer_nonneg _ _ _ _ solved)|auto].
  - rewrite sum_scale_right, Rmult_assoc. apply Rmult_le_compat_r; [|auto].
    apply Rmult_le_pos; [now apply pow_le|assumption].
Qed.

Theorem score_and_rest_have_no_variance : forall K i start, (i < n)%nat ->
  walk_mean n P K i (fun path => walk_score start transfer P source path K
    + walk_rest start transfer P source solution path K) = start * solution i /\
  walk_mean n P K i (fun path => (walk_score start transfer P source path K
    + walk_rest start transfer P source solution path K - start * solution i) ^ 2) = 0.
Proof.
  intros K i start Hi. split.
  - rewrite (walk_mean_ext K i _ (fun _ => start * solution i) Hi); [now apply walk_mean_constant|].
    intros path <- [_ H]. now apply score_and_rest_are_constant.
  - rewrite (walk_mean_ext K i _ (fun _ => 0) Hi); [now apply walk_mean_constant|].
    intros path <- [_ H]. rewrite score_and_rest_are_constant by assumption. ring.
Qed.

(* Rows of T at most rho < 1: the mean square of what the score is off by after K steps falls as rho^K. *)
Theorem mean_square_of_score_falls_geometrically : forall rho bound, 0 <= rho ->
  (forall i, (i < n)%nat -> sum n (fun j => transfer i j) <= rho) ->
  (forall i, (i < n)%nat -> solution i <= bound) ->
  forall K i start, (i < n)%nat -> 0 <= start ->
  walk_mean n P K i (fun path => (walk_score start transfer P source path K - start * solution i) ^ 2)
  <= start ^ 2 * solution i * bound * rho ^ S K.
Proof.
  intros rho bound Hr HT Hb K i start Hi Hs. assert (HX := solution_positive _ _ _ _ solved i Hi).
  assert (HB : 0 <= bound) by (specialize (Hb i Hi); lra).
  apply Rle_trans with (walk_mean n P K i (fun path => start * solution i *
    (walk_weight start transfer P path K * (solution (path K) - source (path K))))).
  - apply walk_mean_le; [assumption|]. intros path H0 [Hn HP].
    assert (E := score_and_rest_are_constant transfer source solution start path K HP).
    assert (F : solution (path 0%nat) <> 0) by (rewrite H0; lra).
    assert (G := rest_is_product transfer source solution start path K F HP). rewrite H0 in E, G.
    unfold walk_rest in *. set (rest := walk_weight start transfer P path K * _) in *.
    replace (walk_score start transfer P source path K - start * solution i) with (- rest) by lra.
    destruct (product_bounds _ _ _ _ solved path K Hn) as [L U]. set (p := prod_f_R0 _ K) in *.
    assert (A : 0 <= start * solution i) by (apply Rmult_le_pos; lra).
    replace ((- rest) ^ 2) with (rest * rest) by ring. apply Rmult_le_compat_r.
    + rewrite G. now apply Rmult_le_pos.
    + rewrite G. rewrite <- (Rmult_1_r (start * solution i)) at 2. now apply Rmult_le_compat_l.
  - rewrite walk_mean_scale, (mean_weight K i start (fun l => solution l - source l)) by assumption.
    assert (T : transported K (fun l => solution l - source l) i <= rho ^ K * (rho * bound)).
    { apply transported_at_most; auto; [now apply Rmult_le_pos|]. intros l Hl.
      assert (E := transport_solves _ _ _ _ solved l Hl).
      assert (sum n (fun j => transfer l j * solution j) <= sum n (fun j => transfer l j * bound)).
      { apply sum_le. intros j Hj. apply Rmult_le_compat_l; [now apply (transfer_nonneg _ _ _ _ solved)|auto]. }
      rewrite sum_scale_right in H.
      assert (sum n (transfer l) * bound <= rho * bound) by (apply Rmult_le_compat_r; [|apply HT]; assumption). lra. }
    replace (start ^ 2 * solution i * bound * rho ^ S K)
      with (start * solution i * start * (rho ^ K * (rho * bound))) by (simpl; ring).
    rewrite <- Rmult_assoc. apply Rmult_le_compat_l; [|exact T]. repeat apply Rmult_le_pos; lra.
Qed.
End WalkMeans.
