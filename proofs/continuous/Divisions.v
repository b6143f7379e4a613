(* Divisions of [0, 1] into intervals, and the halving of every interval. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums FiniteSums.
Open Scope R_scope.

(* Break points p 0 = 0 <= p 1 <= ... <= p n = 1 (what comes after p n plays no part, but must not decrease). *)
Record division (n : nat) (p : nat -> R) : Prop := {
  first_break : p 0%nat = 0;
  last_break : p n = 1;
  breaks_grow : forall k, p k <= p (S k)
}.

(* Every interval halved. *)
Definition halved (p : nat -> R) (k : nat) : R :=
  if Nat.eqb (k mod 2) 0 then p (k / 2)%nat else (p (k / 2)%nat + p (S (k / 2))) / 2.

Lemma breaks_between : forall n p, division n p -> forall k, (k <= n)%nat -> 0 <= p k <= 1.
Proof.
  intros n p D.
  assert (M : forall j d, p j <= p (d + j)%nat).
  { intros j. induction d as [|d IH]; simpl; [lra|].
    apply Rle_trans with (1 := IH). apply (breaks_grow _ _ D). }
  intros k Hk. split.
  - rewrite <- (first_break _ _ D). replace k with (k + 0)%nat by lia. apply M.
  - rewrite <- (last_break _ _ D). replace n with (n - k + k)%nat by lia. apply M.
Qed.

Lemma lengths_sum_to_one : forall n p, division n p -> sum n (fun k => p (S k) - p k) = 1.
Proof.
  intros n p D. assert (E : forall m, sum m (fun k => p (S k) - p k) = p m - p 0%nat).
  { induction m as [|m IH]; simpl; lra. }
  rewrite E, (first_break _ _ D), (last_break _ _ D). lra.
Qed.

Lemma half_index : forall k r, (r < 2)%nat -> ((k * 2 + r) / 2)%nat = k /\ ((k * 2 + r) mod 2)%nat = r.
Proof. intros. now apply flat_quotient_and_rest. Qed.

Lemma halved_even : forall p k, halved p (k * 2) = p k.
Proof.
  intros p k. unfold halved. destruct (half_index k 0 ltac:(lia)) as [A B]. rewrite Nat.add_0_r in A, B.
  now rewrite A, B.
Qed.

Lemma halved_odd : forall p k, halved p (S (k * 2)) = (p k + p (S k)) / 2.
Proof.
  intros p k. unfold halved. destruct (half_index k 1 ltac:(lia)) as [A B].
  replace (S (k * 2)) with (k * 2 + 1)%nat by lia. now rewrite A, B.
Qed.

Lemma even_or_odd : forall j, exists k, j = (k * 2)%nat \/ j = S (k * 2).
Proof.
  intros j. exists (j / 2)%nat. assert (H := Nat.div_mod j 2). assert (H2 := Nat.mod_upper_bound j 2). lia.
Qed.

Lemma halved_length : forall p k,
  halved p (S (k * 2)) - halved p (k * 2) = (p (S k) - p k) / 2 /\
  halved p (S (S (k * 2))) - halved p (S (k * 2)) = (p (S k) - p k) / 2.
Proof.
  intros p k. replace (S (S (k * 2))) with (S k * 2)%nat by lia.
  rewrite halved_odd, !halved_even. split; lra.
Qed.

Lemma halved_division : forall n p, division n p -> division (n * 2) (halved p).
Proof.
  intros n p D. split.
  - apply (eq_trans (halved_even p 0)), (first_break _ _ D).
  - rewrite halved_even. apply (last_break _ _ D).
  - intros j. destruct (even_or_odd j) as [k [-> | ->]]; destruct (halved_length p k);
    assert (H1 := breaks_grow _ _ D k); lra.
Qed.

(* The parts of interval i are its two halves. *)
Lemma part_sum_of_halves : forall n i g, (i < n)%nat ->
  part_sum (n * 2) (fun k => (k / 2)%nat) i g = sum 2 (fun r => g (i * 2 + r)%nat).
Proof.
  intros n i g Hi. unfold part_sum.
  transitivity (sum n (fun k => sum 2 (fun r => if Nat.eqb k i then g (k * 2 + r)%nat else 0))).
  - rewrite <- (sum_flatten n 2 (fun k r => if Nat.eqb k i then g (k * 2 + r)%nat else 0)).
    apply sum_ext. intros j _. rewrite (Nat.mul_comm (j / 2) 2), <- Nat.div_mod by lia. reflexivity.
  - rewrite <- (sum_single n i (fun k => sum 2 (fun r => g (k * 2 + r)%nat)) Hi).
    apply sum_ext. intros k _. destruct (Nat.eqb k i); [reflexivity|]. simpl. lra.
Qed.
