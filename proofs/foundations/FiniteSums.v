(* Rules for the finite sums of Sums.v: order, linearity, exchange of two sums, a double sum as one sum,
   and a sum taken part by part when every index k has a parent. Nothing here is particular to the paper. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums.
Open Scope R_scope.

Lemma sum_ext : forall n f g,
  (forall i, (i < n)%nat -> f i = g i) -> sum n f = sum n g.
Proof.
  induction n as [|n IH]; intros f g H; simpl; [reflexivity|].
  rewrite (IH f g), (H n); auto with arith.
Qed.

Lemma sum_plus : forall n f g, sum n (fun i => f i + g i) = sum n f + sum n g.
Proof. induction n as [|n IH]; intros; simpl; [lra|rewrite IH; lra]. Qed.

Lemma sum_minus : forall n f g, sum n (fun i => f i - g i) = sum n f - sum n g.
Proof. induction n as [|n IH]; intros; simpl; [lra|rewrite IH; lra]. Qed.

Lemma sum_scale : forall n c f, sum n (fun i => c * f i) = c * sum n f.
Proof. induction n as [|n IH]; intros; simpl; [lra|rewrite IH; lra]. Qed.

Lemma sum_scale_right : forall n c f, sum n (fun i => f i * c) = sum n f * c.
Proof. induction n as [|n IH]; intros; simpl; [lra|rewrite IH; lra]. Qed.

Lemma sum_zero : forall n f, (forall i, (i < n)%nat -> f i = 0) -> sum n f = 0.
Proof.
  induction n as [|n IH]; intros f H; simpl; [reflexivity|].
  rewrite IH, (H n); auto with arith; lra.
Qed.

Lemma sum_le : forall n f g,
  (forall i, (i < n)%nat -> f i <= g i) -> sum n f <= sum n g.
Proof.
  induction n as [|n IH]; intros f g H; simpl; [lra|].
  assert (sum n f <= sum n g) by auto with arith.
  assert (f n <= g n) by auto with arith. lra.
Qed.

Lemma sum_nonneg : forall n f, (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= sum n f.
Proof.
  intros n f H. rewrite <- (sum_zero n (fun _ => 0)) by auto. now apply sum_le.
Qed.

(* Two sums, one below the other term by term, are equal only if their terms are. *)
Lemma sum_le_eq : forall n f g,
  (forall i, (i < n)%nat -> f i <= g i) -> sum n f = sum n g ->
  forall i, (i < n)%nat -> f i = g i.
Proof.
  induction n as [|n IH]; intros f g H E i Hi; [lia|]. simpl in E.
  assert (sum n f <= sum n g) by (apply sum_le; auto with arith).
  assert (f n <= g n) by auto with arith.
  destruct (Nat.eq_dec i n) as [->|]; [lra|].
  apply IH; [auto with arith|lra|lia].
Qed.

Lemma sum_nonneg_zero : forall n f,
  (forall i, (i < n)%nat -> 0 <= f i) -> sum n f = 0 ->
  forall i, (i < n)%nat -> f i = 0.
Proof.
  intros n f H E i Hi. symmetry.
  apply (sum_le_eq n (fun _ => 0) f); auto.
  rewrite E. now apply sum_zero.
Qed.

Lemma term_le_sum : forall n f i,
  (forall j, (j < n)%nat -> 0 <= f j) -> (i < n)%nat -> f i <= sum n f.
Proof.
  induction n as [|n IH]; intros f i H Hi; [lia|]. simpl.
  assert (0 <= f n) by auto with arith.
  destruct (Nat.eq_dec i n) as [->|].
  - assert (0 <= sum n f) by (apply sum_nonneg; auto with arith). lra.
  - assert (f i <= sum n f) by (apply IH; [auto with arith|lia]). lra.
Qed.

Lemma sum_exchange : forall n m f,
  sum n (fun i => sum m (fun j => f i j)) = sum m (fun j => sum n (fun i => f i j)).
Proof.
  induction n as [|n IH]; intros; simpl.
  - symmetry. now apply sum_zero.
  - now rewrite IH, <- sum_plus.
Qed.

Lemma sum_single : forall n i f,
  (i < n)%nat -> sum n (fun j => if Nat.eqb j i then f j else 0) = f i.
Proof.
  induction n as [|n IH]; intros i f Hi; [lia|]. simpl.
  destruct (Nat.eqb_spec n i) as [->|].
  - rewrite sum_zero; [lra|]. intros j Hj. destruct (Nat.eqb_spec j i); [lia|reflexivity].
  - rewrite IH by lia. lra.
Qed.

Lemma sum_single_sym : forall n i f,
  (i < n)%nat -> sum n (fun j => if Nat.eqb i j then f j else 0) = f i.
Proof.
  intros n i f Hi. rewrite <- (sum_single n i f Hi).
  apply sum_ext. intros. now rewrite Nat.eqb_sym.
Qed.

Lemma sum_append : forall n m f,
  sum (n + m) f = sum n f + sum m (fun k => f (n + k)%nat).
Proof.
  induction m as [|m IH]; intros; simpl.
  - rewrite Nat.add_0_r. lra.
  - rewrite Nat.add_succ_r. simpl. rewrite IH. lra.
Qed.

Lemma sum_first : forall n f, sum (S n) f = f 0%nat + sum n (fun k => f (S k)).
Proof. intros. change (S n) with (1 + n)%nat. rewrite sum_append. simpl. lra. Qed.

Lemma flat_quotient_and_rest : forall m i j, (j < m)%nat ->
  ((i * m + j) / m)%nat = i /\ ((i * m + j) mod m)%nat = j.
Proof.
  intros m i j Hj. rewrite Nat.div_add_l, Nat.div_small, Nat.add_0_r by lia.
  split; [reflexivity|]. rewrite (Nat.add_comm (i * m) j), Nat.mod_add by lia.
  now apply Nat.mod_small.
Qed.

(* A double sum is one sum over n m indices. *)
Lemma sum_flatten : forall n m f,
  sum (n * m) (fun p => f (p / m)%nat (p mod m)%nat) =
  sum n (fun i => sum m (fun j => f i j)).
Proof.
  intros n m f. destruct (Nat.eq_dec m 0) as [->|Hm].
  - rewrite Nat.mul_0_r. simpl. symmetry. now apply sum_zero.
  - induction n as [|n IH]; [reflexivity|].
    replace (S n * m)%nat with (n * m + m)%nat by lia.
    rewrite sum_append, IH. simpl. f_equal. apply sum_ext. intros j Hj.
    now destruct (flat_quotient_and_rest m n j Hj) as [-> ->].
Qed.

(* ---- Sums over the parts of a state ---- *)

(* The sum of f over those k < N whose parent is i. *)
Definition part_sum (N : nat) (parent : nat -> nat) (i : nat) (f : nat -> R) : R :=
  sum N (fun k => if Nat.eqb (parent k) i then f k else 0).

(* The sum of f over the pairs k, l < N with k a part of i and l a part of j. *)
Definition block_sum (N : nat) (parent : nat -> nat) (i j : nat) (f : nat -> nat -> R) : R :=
  part_sum N parent i (fun k => part_sum N parent j (fun l => f k l)).

Lemma part_sum_ext : forall N parent i f g,
  (forall k, (k < N)%nat -> parent k = i -> f k = g k) ->
  part_sum N parent i f = part_sum N parent i g.
Proof.
  intros N parent i f g H. apply sum_ext. intros k Hk.
  destruct (Nat.eqb_spec (parent k) i); auto.
Qed.

Lemma part_sum_scale : forall N parent i c f,
  part_sum N parent i (fun k => c * f k) = c * part_sum N parent i f.
Proof.
  intros. unfold part_sum. rewrite <- sum_scale. apply sum_ext. intros k _.
  destruct (Nat.eqb (parent k) i); lra.
Qed.

Lemma part_sum_scale_right : forall N parent i c f,
  part_sum N parent i (fun k => f k * c) = part_sum N parent i f * c.
Proof.
  intros. unfold part_sum. rewrite <- sum_scale_right. apply sum_ext. intros k _.
  destruct (Nat.eqb (parent k) i); lra.
Qed.

Lemma block_sum_product : forall N parent i j f g,
  block_sum N parent i j (fun k l => f k * g l) =
  part_sum N parent i f * part_sum N parent j g.
Proof.
  intros. unfold block_sum. rewrite <- part_sum_scale_right.
  apply part_sum_ext. intros. apply part_sum_scale.
Qed.

(* The block sum as one double sum with a condition on the pair. *)
Lemma block_sum_masked : forall N parent i j f,
  block_sum N parent i j f =
  sum N (fun k => sum N (fun l =>
    if (Nat.eqb (parent k) i && Nat.eqb (parent l) j)%bool then f k l else 0)).
Proof.
  intros. unfold block_sum, part_sum. apply sum_ext. intros k _.
  destruct (Nat.eqb (parent k) i); simpl; [reflexivity|].
  symmetry. now apply sum_zero.
Qed.

(* Summing within the parts and then over the parents sums everything once. *)
Lemma sum_over_parts : forall n N parent f,
  (forall k, (k < N)%nat -> (parent k < n)%nat) ->
  sum n (fun i => part_sum N parent i f) = sum N f.
Proof.
  intros n N parent f H. unfold part_sum. rewrite sum_exchange.
  apply sum_ext. intros k Hk. apply (sum_single_sym n (parent k) (fun _ => f k)). auto.
Qed.

Lemma sum_part_sum : forall m N parent i f,
  sum m (fun j => part_sum N parent i (fun k => f j k)) =
  part_sum N parent i (fun k => sum m (fun j => f j k)).
Proof.
  intros. unfold part_sum. rewrite sum_exchange. apply sum_ext. intros k _.
  destruct (Nat.eqb (parent k) i); [reflexivity|]. now apply sum_zero.
Qed.

Lemma sum_over_blocks : forall n N parent f,
  (forall k, (k < N)%nat -> (parent k < n)%nat) ->
  sum n (fun i => sum n (fun j => block_sum N parent i j f)) =
  sum N (fun k => sum N (fun l => f k l)).
Proof.
  intros n N parent f H. rewrite <- (sum_over_parts n N parent) by assumption.
  apply sum_ext. intros i _. unfold block_sum. rewrite sum_part_sum.
  apply part_sum_ext. intros. now apply sum_over_parts.
Qed.
