(* Section 2, convergence: in a reciprocal chain whose states are all joined, one closed walk of odd length is enough for the
   state probabilities to converge to w. Three patches that see each other, as two faces near a convex edge and any third point
   that both see there, make such a walk; two patches that see only each other have none (Convergence.v). *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement Convergence.
Open Scope R_scope.

Lemma positive_sum_has_positive_term : forall n f, 0 < sum n f -> exists i, (i < n)%nat /\ 0 < f i.
Proof.
  induction n as [|n IH]; intros f H; simpl in H; [lra|]. destruct (Rlt_dec 0 (f n)) as [L|L].
  - exists n. split; [lia|exact L].
  - destruct (IH f) as [i [Hi L']]; [lra|]. exists i. split; [lia|exact L'].
Qed.

Section OddWalks.
Variables (n : nat) (w : nat -> R) (P : nat -> nat -> R).
Hypothesis chain : markov_chain n w P.
Hypothesis balanced : reciprocal n w P.
Hypothesis positive : forall i, (i < n)%nat -> 0 < w i.

(* A walk goes back as it came. *)
Lemma step_back : forall i j, (i < n)%nat -> (j < n)%nat -> 0 < P i j -> 0 < P j i.
Proof.
  intros i j Hi Hj H. assert (E := balanced i j Hi Hj). unfold joint in E.
  assert (Pi := positive i Hi). assert (Pj := positive j Hj).
  apply (Rmult_lt_reg_l (w j)); [exact Pj|]. rewrite <- E, Rmult_0_r. now apply Rmult_lt_0_compat.
Qed.

Lemma walk_goes_on : forall k i l j, (i < n)%nat -> (l < n)%nat -> (j < n)%nat ->
  0 < power n P k i l -> 0 < P l j -> 0 < power n P (S k) i j.
Proof.
  intros k i l j Hi Hl Hj H1 H2. simpl.
  apply Rlt_le_trans with (power n P k i l * P l j); [now apply Rmult_lt_0_compat|].
  apply (term_le_sum n (fun l => power n P k i l * P l j)); [|exact Hl]. intros q Hq.
  apply Rmult_le_pos; [now apply (power_nonneg n w P chain)|now apply (transition_nonneg _ _ _ chain)].
Qed.

(* Two walks, one after the other. *)
Lemma walks_join : forall k t i l j, (i < n)%nat -> (l < n)%nat -> (j < n)%nat ->
  0 < power n P k i l -> 0 < power n P t l j -> 0 < power n P (k + t) i j.
Proof.
  intros k t. induction t as [|t IH]; intros i l j Hi Hl Hj H1 H2.
  - simpl in H2. replace (k + 0)%nat with k by lia. destruct (Nat.eqb_spec l j) as [->|]; [exact H1|lra].
  - simpl in H2. assert (Q : exists q, (q < n)%nat /\ 0 < power n P t l q * P q j).
    { exact (positive_sum_has_positive_term n _ H2). }
    destruct Q as [q [Hq Hp]]. replace (k + S t)%nat with (S (k + t)) by lia.
    assert (N1 := power_nonneg n w P chain t l q Hl Hq). assert (N2 := transition_nonneg _ _ _ chain q j Hq Hj).
    apply (walk_goes_on (k + t) i q j); [exact Hi|exact Hq|exact Hj| |nra]. apply (IH i l q); try assumption. nra.
Qed.

Lemma one_step : forall i j, (i < n)%nat -> (j < n)%nat -> 0 < P i j -> 0 < power n P 1 i j.
Proof.
  intros i j Hi Hj H. apply (walk_goes_on 0 i i j); try assumption. simpl. rewrite Nat.eqb_refl. lra.
Qed.

(* To a neighbour and back, any number of times. *)
Lemma even_closed_walk : forall c q, (c < n)%nat -> 0 < power n P (2 * q) c c.
Proof.
  intros c q Hc. induction q as [|q IH]; [simpl; rewrite Nat.eqb_refl; lra|].
  assert (Q : exists l, (l < n)%nat /\ 0 < P c l).
  { apply positive_sum_has_positive_term. assert (E := row_sum_one _ _ _ chain c Hc). cbv beta in E.
    change (fun i => P c i) with (P c) in E. change (fun j => P c j) with (P c) in E. rewrite E. lra. }
  destruct Q as [l [Hl H]]. replace (2 * S q)%nat with (2 * q + (1 + 1))%nat by lia.
  apply (walks_join (2 * q) (1 + 1) c c c); try assumption.
  apply (walks_join 1 1 c l c); try assumption; apply one_step; try assumption. now apply step_back.
Qed.

Lemma bounded_lengths : forall (reaches : nat -> nat -> Prop) m, (forall i, (i < m)%nat -> exists k, reaches i k) ->
  exists K, forall i, (i < m)%nat -> exists k, (k <= K)%nat /\ reaches i k.
Proof.
  intros reaches m. induction m as [|m IH]; intros H; [exists 0%nat; lia|].
  destruct IH as [K B]; [intros; apply H; lia|]. destruct (H m) as [k Hk]; [lia|].
  exists (K + k)%nat. intros i Hi. destruct (Nat.eq_dec i m) as [->|N].
  - exists k. split; [lia|exact Hk].
  - destruct (B i) as [k' [L R]]; [lia|]. exists k'. split; [lia|exact R].
Qed.

(* From every state c is reached in one and the same number of steps: those of odd distance take the odd walk, and all
   wait by going to a neighbour and back. *)
Theorem walk_converges_if_an_odd_walk_closes : forall c, (c < n)%nat ->
  (forall i, (i < n)%nat -> exists k, 0 < power n P k i c) ->
  (exists k, Nat.odd k = true /\ 0 < power n P k c c) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof.
  intros c Hc Joined [o [Ho Odd]]. apply Nat.odd_spec in Ho. destruct Ho as [o' Eo].
  destruct (bounded_lengths (fun i k => 0 < power n P k i c) n Joined) as [K B].
  apply (walk_converges_if_one_state_is_reached_from_all n w P chain (reciprocal_is_stationary n w P chain balanced)
    (2 * (K + o)) c Hc).
  intros i Hi. destruct (B i Hi) as [k [Hk H]]. destruct (Nat.Even_or_Odd k) as [[k' E]|[k' E]].
  - replace (2 * (K + o))%nat with (k + 2 * (K + o - k'))%nat by lia.
    apply (walks_join k _ i c c); try assumption. now apply even_closed_walk.
  - replace (2 * (K + o))%nat with (k + o + 2 * (K + o - k' - o' - 1))%nat by lia.
    apply (walks_join (k + o) _ i c c); try assumption; [|now apply even_closed_walk].
    now apply (walks_join k o i c c).
Qed.

(* Three states that see each other, from one of which all are reached. *)
Theorem walk_converges_if_three_patches_see_each_other : forall c a b, (c < n)%nat -> (a < n)%nat -> (b < n)%nat ->
  0 < P c a -> 0 < P a b -> 0 < P b c ->
  (forall i, (i < n)%nat -> exists k, 0 < power n P k i c) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof.
  intros c a b Hc Ha Hb H1 H2 H3 Joined. apply (walk_converges_if_an_odd_walk_closes c Hc Joined).
  exists 3%nat. split; [reflexivity|]. apply (walk_goes_on 2 c b c); try assumption.
  apply (walk_goes_on 1 c a b); try assumption. now apply one_step.
Qed.
End OddWalks.

(* Control: two patches that see only each other close no odd walk. *)
Theorem two_patches_close_no_odd_walk : forall k, Nat.odd k = true -> power 2 swap_transition k 0 0 = 0.
Proof.
  assert (A : forall q, power 2 swap_transition (2 * q) 0 0 = 1 /\ power 2 swap_transition (2 * q) 0 1 = 0).
  { induction q as [|q [I J]]; [simpl; lra|]. replace (2 * S q)%nat with (S (S (2 * q))) by lia.
    cbn [power sum]. rewrite I, J. unfold swap_transition. simpl. lra. }
  intros k Hk. apply Nat.odd_spec in Hk. destruct Hk as [q ->]. destruct (A q) as [I J].
  replace (2 * q + 1)%nat with (S (2 * q)) by lia. cbn [power sum]. rewrite I, J. unfold swap_transition. simpl. lra.
Qed.
