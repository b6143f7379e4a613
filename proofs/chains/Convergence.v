(* Section 2, "the probabilities of finding the particle in each state i converge to a stationary distribution after a number
   of steps": proved for every finite chain of which some power P^k has all entries positive (one positive column is
   enough), from any initial distribution, at a geometric rate; and a chain of two states that does not converge. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement.
Open Scope R_scope.

(* The distribution after one step, and after t steps. *)
Definition step (n : nat) (P : nat -> nat -> R) (p : nat -> R) (j : nat) : R := sum n (fun i => p i * P i j).

Fixpoint after_steps (n : nat) (P : nat -> nat -> R) (t : nat) (p : nat -> R) : nat -> R :=
  match t with
  | O => p
  | S t' => step n P (after_steps n P t' p)
  end.

(* The matrix power P^k. *)
Fixpoint power (n : nat) (P : nat -> nat -> R) (k : nat) (i j : nat) : R :=
  match k with
  | O => if Nat.eqb i j then 1 else 0
  | S k' => sum n (fun l => power n P k' i l * P l j)
  end.

Definition distribution (n : nat) (p : nat -> R) : Prop :=
  (forall i, (i < n)%nat -> 0 <= p i) /\ sum n p = 1.

(* The distance of p from w: sum of |p_i - w_i|. *)
Definition l1_distance (n : nat) (p w : nat -> R) : R := sum n (fun i => Rabs (p i - w i)).

Lemma sum_abs : forall n f, Rabs (sum n f) <= sum n (fun i => Rabs (f i)).
Proof.
  induction n as [|n IH]; intros f; simpl; [rewrite Rabs_R0; lra|].
  apply Rle_trans with (1 := Rabs_triang _ _). specialize (IH f). lra.
Qed.

Section Convergence.
Variables (n : nat) (w : nat -> R) (P : nat -> nat -> R).
Hypothesis chain : markov_chain n w P.
Hypothesis weights_stationary : stationary n w P.

Lemma power_nonneg : forall k i j, (i < n)%nat -> (j < n)%nat -> 0 <= power n P k i j.
Proof.
  induction k as [|k IH]; intros i j Hi Hj; simpl; [destruct (Nat.eqb i j); lra|].
  apply sum_nonneg. intros l Hl. apply Rmult_le_pos; [now apply IH|now apply (transition_nonneg _ _ _ chain)].
Qed.

Lemma power_row_sum : forall k i, (i < n)%nat -> sum n (fun j => power n P k i j) = 1.
Proof.
  induction k as [|k IH]; intros i Hi; simpl.
  - now apply (sum_single_sym n i (fun _ => 1)).
  - rewrite sum_exchange. rewrite <- (IH i Hi). apply sum_ext. intros l Hl.
    rewrite sum_scale, (row_sum_one _ _ _ chain) by assumption. lra.
Qed.

(* k steps are one step of P^k. *)
Lemma steps_are_power : forall k p j, (j < n)%nat ->
  after_steps n P k p j = sum n (fun i => p i * power n P k i j).
Proof.
  induction k as [|k IH]; intros p j Hj; simpl.
  - rewrite <- (sum_single n j p Hj). apply sum_ext. intros i _. destruct (Nat.eqb i j); lra.
  - unfold step. rewrite (sum_ext n _ (fun l => sum n (fun i => p i * power n P k i l * P l j))).
    + rewrite sum_exchange. apply sum_ext. intros i _. rewrite <- sum_scale. apply sum_ext. intros l _. ring.
    + intros l Hl. rewrite IH by exact Hl. now rewrite <- sum_scale_right.
Qed.

Lemma steps_add : forall k t p, after_steps n P (k + t) p = after_steps n P k (after_steps n P t p).
Proof. induction k as [|k IH]; intros; simpl; [reflexivity|now rewrite IH]. Qed.

Lemma step_keeps_total : forall p, sum n (step n P p) = sum n p.
Proof.
  intros p. unfold step. rewrite sum_exchange. apply sum_ext. intros i Hi.
  rewrite sum_scale, (row_sum_one _ _ _ chain) by assumption. lra.
Qed.

Lemma steps_keep_total : forall t p, sum n (after_steps n P t p) = sum n p.
Proof. induction t as [|t IH]; intros; simpl; [reflexivity|now rewrite step_keeps_total]. Qed.

(* w is unchanged by P^k. *)
Lemma stationary_under_power : forall k j, (j < n)%nat -> sum n (fun i => w i * power n P k i j) = w j.
Proof.
  intros k j Hj. rewrite <- steps_are_power by exact Hj. revert j Hj.
  induction k as [|k IH]; intros j Hj; simpl; [reflexivity|].
  unfold step. rewrite <- (weights_stationary j Hj). apply sum_ext. intros i Hi. now rewrite IH.
Qed.

(* Doeblin's contraction: if column c of P^k is at least delta everywhere, k steps multiply the distance from w by at
   most 1 - delta. As the differences p_i - w_i add up to 0, delta may be taken off that column. *)
Lemma steps_contract : forall k c delta p, (c < n)%nat -> 0 <= delta ->
  (forall i, (i < n)%nat -> delta <= power n P k i c) -> sum n p = 1 ->
  l1_distance n (after_steps n P k p) w <= (1 - delta) * l1_distance n p w.
Proof.
  intros k c delta p Hc Hd Hcol Hp.
  set (Q := fun i j => power n P k i j - (if Nat.eqb j c then delta else 0)).
  assert (HQ : forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= Q i j).
  { intros i j Hi Hj. unfold Q. destruct (Nat.eqb_spec j c) as [->|].
    - specialize (Hcol i Hi). lra.
    - assert (H := power_nonneg k i j Hi Hj). lra. }
  assert (E : forall j, (j < n)%nat -> after_steps n P k p j - w j = sum n (fun i => (p i - w i) * Q i j)).
  { intros j Hj. rewrite steps_are_power by exact Hj. rewrite <- (stationary_under_power k j Hj) at 1.
    rewrite <- sum_minus.
    transitivity (sum n (fun i => (p i - w i) * power n P k i j) -
      sum n (fun i => (p i - w i) * (if Nat.eqb j c then delta else 0))).
    - assert (T : sum n (fun i => p i - w i) = 0) by (rewrite sum_minus, Hp, (total_weight_one _ _ _ chain); ring).
      rewrite sum_scale_right, T, Rmult_0_l, Rminus_0_r. apply sum_ext. intros. ring.
    - rewrite <- sum_minus. apply sum_ext. intros. unfold Q. ring. }
  unfold l1_distance at 1.
  apply Rle_trans with (sum n (fun j => sum n (fun i => Rabs (p i - w i) * Q i j))).
  - apply sum_le. intros j Hj. rewrite E by exact Hj. apply Rle_trans with (1 := sum_abs _ _).
    right. apply sum_ext. intros i Hi. rewrite Rabs_mult, (Rabs_pos_eq (Q i j)) by now apply HQ. reflexivity.
  - right. rewrite sum_exchange. unfold l1_distance. rewrite <- sum_scale. apply sum_ext. intros i Hi.
    rewrite sum_scale. unfold Q. rewrite sum_minus, power_row_sum by exact Hi.
    rewrite (sum_single n c (fun _ => delta) Hc). ring.
Qed.

Lemma some_state : (0 < n)%nat.
Proof. assert (T := total_weight_one _ _ _ chain). destruct n; [simpl in T; lra|lia]. Qed.

(* No step takes the distribution further from w. *)
Lemma steps_never_recede : forall t p, sum n p = 1 -> l1_distance n (after_steps n P t p) w <= l1_distance n p w.
Proof.
  intros t p Hp. rewrite <- (Rmult_1_l (l1_distance n p w)). replace 1 with (1 - 0) by ring.
  apply (steps_contract t 0 0); [exact some_state|lra| |exact Hp].
  intros. apply power_nonneg; [assumption|exact some_state].
Qed.

Lemma l1_distance_nonneg : forall p, 0 <= l1_distance n p w.
Proof. intros. apply sum_nonneg. intros. apply Rabs_pos. Qed.

(* After q times k steps the distance is multiplied by at most (1 - delta)^q. *)
Theorem l1_distance_falls_geometrically : forall k c delta, (c < n)%nat -> 0 <= delta ->
  (forall i, (i < n)%nat -> delta <= power n P k i c) ->
  forall p q, sum n p = 1 -> l1_distance n (after_steps n P (q * k) p) w <= (1 - delta) ^ q * l1_distance n p w.
Proof.
  intros k c delta Hc Hd Hcol p q Hp. induction q as [|q IH]; [simpl; lra|].
  replace (S q * k)%nat with (k + q * k)%nat by lia. rewrite steps_add.
  assert (T : sum n (after_steps n P (q * k) p) = 1) by now rewrite steps_keep_total.
  apply Rle_trans with (1 := steps_contract k c delta _ Hc Hd Hcol T).
  simpl. rewrite Rmult_assoc. apply Rmult_le_compat_l; [|exact IH].
  assert (power n P k c c <= 1).
  { rewrite <- (power_row_sum k c Hc). apply (term_le_sum n (fun j => power n P k c j)); [|exact Hc].
    intros. now apply power_nonneg. }
  specialize (Hcol c Hc). lra.
Qed.

(* Finitely many positive numbers have a positive lower bound. *)
Lemma positive_lower_bound : forall m (f : nat -> R), (forall i, (i < m)%nat -> 0 < f i) ->
  exists delta, 0 < delta /\ forall i, (i < m)%nat -> delta <= f i.
Proof.
  induction m as [|m IH]; intros f H; [exists 1; split; [lra|lia]|].
  destruct (IH f) as [d [Hd L]]; [auto with arith|]. exists (Rmin d (f m)).
  split; [apply Rmin_glb_lt; auto|]. intros i Hi. destruct (Nat.eq_dec i m) as [->|]; [apply Rmin_r|].
  apply Rle_trans with (1 := Rmin_l _ _). apply L. lia.
Qed.

(* If after k steps some state c can be reached from every state, the walk converges to w. *)
Theorem walk_converges_if_one_state_is_reached_from_all : forall k c, (c < n)%nat ->
  (forall i, (i < n)%nat -> 0 < power n P k i c) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof.
  intros k c Hc Hcol p [_ Hp] j Hj eps Heps.
  destruct (positive_lower_bound n (fun i => power n P k i c) Hcol) as [delta [Hd L]].
  assert (power n P k c c <= 1).
  { rewrite <- (power_row_sum k c Hc). apply (term_le_sum n (fun l => power n P k c l)); [|exact Hc].
    intros. now apply power_nonneg. }
  assert (delta <= 1) by (specialize (L c Hc); cbv beta in L; lra).
  assert (D := l1_distance_nonneg p).
  destruct (pow_lt_1_zero (1 - delta)) with (y := eps / (l1_distance n p w + 1)) as [q Hq].
  { rewrite Rabs_pos_eq; lra. }
  { apply Rdiv_lt_0_compat; lra. }
  specialize (Hq q (le_n q)). rewrite Rabs_pos_eq in Hq by (apply pow_le; lra).
  exists (q * k)%nat. intros t Ht. unfold R_dist.
  apply Rle_lt_trans with (l1_distance n (after_steps n P t p) w).
  { apply (term_le_sum n (fun i => Rabs (after_steps n P t p i - w i))); [|exact Hj]. intros. apply Rabs_pos. }
  replace t with ((t - q * k) + q * k)%nat by lia. rewrite steps_add.
  assert (T : sum n (after_steps n P (q * k) p) = 1) by now rewrite steps_keep_total.
  apply Rle_lt_trans with (1 := steps_never_recede _ _ T).
  apply Rle_lt_trans with (1 := l1_distance_falls_geometrically k c delta Hc (Rlt_le _ _ Hd) L p q Hp).
  apply Rlt_le_trans with (eps / (l1_distance n p w + 1) * (l1_distance n p w + 1)); [|right; field; lra].
  assert (0 <= (1 - delta) ^ q) by (apply pow_le; lra).
  assert ((1 - delta) ^ q * (l1_distance n p w + 1) < eps / (l1_distance n p w + 1) * (l1_distance n p w + 1))
    by (apply Rmult_lt_compat_r; lra). lra.
Qed.

(* In particular if all entries of P^k are positive. *)
Theorem walk_converges_to_stationary_distribution : forall k,
  (forall i j, (i < n)%nat -> (j < n)%nat -> 0 < power n P k i j) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof.
  intros k H. apply (walk_converges_if_one_state_is_reached_from_all k 0 some_state). intros.
  apply H; [assumption|exact some_state].
Qed.

(* It is enough that any two states, equal or not, have a state in between: then P^2 has no zero entry. So it is in a closed
   room whose faces are divided in any way: any two patches see some patch of a third face. *)
Theorem walk_converges_if_any_two_patches_see_a_third :
  (forall i j, (i < n)%nat -> (j < n)%nat -> exists l, (l < n)%nat /\ 0 < P i l /\ 0 < P l j) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof.
  intros See. apply (walk_converges_to_stationary_distribution 2). intros i j Hi Hj.
  assert (E1 : forall l, (l < n)%nat -> power n P 1 i l = P i l).
  { intros l Hl. simpl. rewrite <- (sum_single_sym n i (fun a => P a l) Hi). apply sum_ext. intros a _.
    destruct (Nat.eqb i a); lra. }
  destruct (See i j Hi Hj) as [l [Hl [A B]]]. change (0 < sum n (fun a => power n P 1 i a * P a j)).
  apply Rlt_le_trans with (power n P 1 i l * P l j).
  - rewrite E1 by exact Hl. now apply Rmult_lt_0_compat.
  - apply (term_le_sum n (fun a => power n P 1 i a * P a j)); [|exact Hl]. intros a Ha.
    apply Rmult_le_pos; [now apply power_nonneg|now apply (transition_nonneg _ _ _ chain)].
Qed.

(* In particular three or more patches that all see each other, such as the six undivided sides of an empty room. *)
Theorem walk_converges_if_three_or_more_patches_see_each_other : (3 <= n)%nat ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < P i j) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof.
  intros Hn See. apply walk_converges_if_any_two_patches_see_a_third. intros i j Hi Hj.
  assert (M : exists l, (l < n)%nat /\ l <> i /\ l <> j).
  { destruct (Nat.eq_dec i 0), (Nat.eq_dec j 0), (Nat.eq_dec i 1), (Nat.eq_dec j 1); subst;
      try (exists 0%nat; lia); try (exists 1%nat; lia); exists 2%nat; lia. }
  destruct M as [l [Hl [N1 N2]]]. exists l. repeat split; auto.
Qed.
End Convergence.

(* ---- Control: two patches that see only each other ---- *)

Definition swap_weight (i : nat) : R := 1 / 2.
Definition swap_transition (i j : nat) : R := if Nat.eqb i j then 0 else 1.

Theorem swap_chain_is_reciprocal_markov_chain :
  markov_chain 2 swap_weight swap_transition /\ reciprocal 2 swap_weight swap_transition.
Proof.
  split.
  - split.
    + intros. unfold swap_weight. lra.
    + intros i j _ _. unfold swap_transition. destruct (Nat.eqb i j); lra.
    + unfold swap_weight. simpl. lra.
    + intros [|[|i]] Hi; [| |lia]; unfold swap_transition; simpl; lra.
  - intros i j _ _. unfold joint, swap_weight, swap_transition. now rewrite Nat.eqb_sym.
Qed.

Lemma swap_step : forall q, step 2 swap_transition q 0%nat = q 1%nat /\ step 2 swap_transition q 1%nat = q 0%nat.
Proof. intros q. unfold step, swap_transition. simpl. split; ring. Qed.

(* A particle that starts on one patch is there after every even number of steps, and not after an odd one. *)
Theorem walk_between_two_patches_does_not_converge :
  let p := fun i : nat => match i with O => 1 | _ => 0 end in
  distribution 2 p /\ ~ exists l, Un_cv (fun t => after_steps 2 swap_transition t p 0%nat) l.
Proof.
  cbv zeta. set (p := fun i : nat => match i with O => 1 | _ => 0 end). split.
  - split; [intros [|i] _; unfold p; lra|simpl; unfold p; lra].
  - assert (E : forall t, after_steps 2 swap_transition (2 * t) p 0%nat = 1 /\ after_steps 2 swap_transition (2 * t) p 1%nat = 0).
    { induction t as [|t [I0 I1]]; [split; reflexivity|].
      replace (2 * S t)%nat with (S (S (2 * t))) by lia. cbn [after_steps].
      now rewrite !(proj1 (swap_step _)), !(proj2 (swap_step _)), (proj1 (swap_step _)), I0, I1. }
    intros [l H]. destruct (H (1 / 2)) as [N HN]; [lra|].
    assert (A := HN (2 * N)%nat ltac:(lia)). assert (B := HN (S (2 * N)) ltac:(lia)).
    destruct (E N) as [E0 E1]. unfold R_dist in A, B. rewrite E0 in A.
    cbn [after_steps] in B. rewrite (proj1 (swap_step _)), E1 in B.
    apply Rabs_def2 in A. apply Rabs_def2 in B. lra.
Qed.
