(* The paper's Theorem 1: when one state of a reciprocal Markov chain is refined into m sub-states that are
   reciprocal (a) and cover it (b), mutual information increases or remains the same; and when it remains. *)
From Coq Require Import Reals Lra Lia Arith Bool.
From Infoscene Require Import Sums Information FiniteSums LogSum Refinement StateRefinement.
Open Scope R_scope.

(* ---- The hypotheses of Theorem 1 ----
   (w, P) is the chain on n states, (w', P') the one on n - 1 + m states in which s is refined. That w_s is the
   sum of the sub-states' weights, and w_s P_ss the sum of their joint probabilities, is not assumed. *)
Record refines_state (n s m : nat)
    (w : nat -> R) (P : nat -> nat -> R) (w' : nat -> R) (P' : nat -> nat -> R) : Prop := {
  state_below : (s < n)%nat;
  some_substate : (1 <= m)%nat;
  (* nothing changes among the other states *)
  other_weight : forall j, (j < n)%nat -> j <> s -> w' j = w j;
  other_transition : forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j;
  (* (a) w'_k P'_kj = w'_j P'_jk for every sub-state k and every refined state j, sub-states included *)
  reciprocity_with_substates : forall k j, (k < m)%nat -> (j < n - 1 + m)%nat ->
    joint w' P' (substate n s k) j = joint w' P' j (substate n s k);
  (* (b) P_js = sum over k of P'_jk *)
  substates_cover : forall j, (j < n)%nat -> j <> s ->
    P j s = sum m (fun k => P' j (substate n s k))
}.

Section Theorem1.
Variables (n s m : nat).
Variables (w : nat -> R) (P : nat -> nat -> R) (w' : nat -> R) (P' : nat -> nat -> R).
Hypothesis coarse : markov_chain n w P.
Hypothesis coarse_reciprocal : reciprocal n w P.
Hypothesis refined : markov_chain (n - 1 + m) w' P'.
Hypothesis refinement : refines_state n s m w P w' P'.

(* w_s P_sj = w_j P_js, which the sub-states cover, and each is reciprocal. *)
Lemma joint_with_other_state : forall j, (j < n)%nat -> j <> s ->
  joint w P s j = sum m (fun k => joint w' P' (substate n s k) j).
Proof.
  destruct refinement as [Hs Hm Hw _ Ha Hb]. intros j Hj Hjs.
  rewrite coarse_reciprocal by assumption. unfold joint at 1.
  rewrite Hb, <- sum_scale by assumption. apply sum_ext. intros k Hk.
  rewrite Ha by lia. unfold joint. now rewrite Hw.
Qed.

(* (a), and the reciprocity that the other states keep. *)
Lemma refined_chain_is_reciprocal : reciprocal (n - 1 + m) w' P'.
Proof.
  destruct refinement as [Hs Hm Hw HP Ha _]. intros x y Hx Hy.
  destruct (refined_label n m s x Hs Hm Hx) as [[Hx1 Hx2]|[k [Hk ->]]]; [|now apply Ha].
  destruct (refined_label n m s y Hs Hm Hy) as [[Hy1 Hy2]|[k [Hk ->]]]; [|symmetry; now apply Ha].
  unfold joint. rewrite !Hw, !HP by assumption. now apply coarse_reciprocal.
Qed.

(* So the paper's hypotheses make (w', P') a refinement by the parent map. *)
Lemma state_refinement_refines : refines n (n - 1 + m) (parent_state n s) w P w' P'.
Proof.
  assert (X := joint_with_other_state). assert (Z := refined_chain_is_reciprocal).
  destruct refinement. apply refined_state_refines; try assumption.
  now apply reciprocal_is_stationary.
Qed.

(* In particular, w_s and w_s P_ss are the sums over the sub-states. *)
Theorem refined_state_is_sum_of_substates :
  w s = sum m (fun k => w' (substate n s k)) /\
  joint w P s s = sum m (fun k => sum m (fun l => joint w' P' (substate n s k) (substate n s l))).
Proof.
  assert (X := joint_with_other_state). destruct refinement. split.
  - now apply (refined_weight_is_sum_of_substates n s m w P w' P').
  - now apply refined_self_joint_is_sum_of_substates.
Qed.

(* Theorem 1. *)
Theorem refinement_never_lowers_mutual_information :
  mutual_information n w P <= mutual_information (n - 1 + m) w' P'.
Proof.
  exact (refinement_of_several_states_never_lowers_mutual_information _ _ _ _ _ _ _
    state_refinement_refines).
Qed.

(* It remains the same exactly when each refined joint probability is the product share of its block:
   J'_xy / (w'_x w'_y) = J_ij / (w_i w_j) for the parents i of x and j of y. *)
Theorem refinement_keeps_mutual_information_iff_joints_are_product_shares :
  mutual_information (n - 1 + m) w' P' = mutual_information n w P <->
  (forall x y, (x < n - 1 + m)%nat -> (y < n - 1 + m)%nat ->
     joint w' P' x y * (w (parent_state n s x) * w (parent_state n s y)) =
     w' x * w' y * joint w P (parent_state n s x) (parent_state n s y)).
Proof.
  exact (several_states_equal_mutual_information _ _ _ _ _ _ _ state_refinement_refines).
Qed.

(* In transition probabilities, for positive weights: P'_kj = P_sj for every sub-state k and other state j, and
   P'_kl / w'_l = P_ss / w_s for sub-states k, l. *)
Theorem refinement_keeps_mutual_information_iff_substates_see_alike :
  (forall x, (x < n - 1 + m)%nat -> 0 < w' x) ->
  mutual_information (n - 1 + m) w' P' = mutual_information n w P <->
  (forall k j, (k < m)%nat -> (j < n)%nat -> j <> s -> P' (substate n s k) j = P s j) /\
  (forall k l, (k < m)%nat -> (l < m)%nat ->
     P' (substate n s k) (substate n s l) / w' (substate n s l) = P s s / w s).
Proof.
  intros Hpos.
  assert (R := state_refinement_refines). assert (Hs := state_below _ _ _ _ _ _ _ refinement).
  rewrite (several_states_equal_transition_ratios _ _ _ _ _ _ _ R Hpos).
  assert (Ws := proj1 refined_state_is_sum_of_substates).
  destruct refinement as [_ Hm Hw HP Ha Hb].
  assert (Hsub : forall k, (k < m)%nat -> (substate n s k < n - 1 + m)%nat)
    by (intros; now apply substate_below).
  assert (Hws : 0 < w s).
  { rewrite Ws.
    apply Rlt_le_trans with (1 := Hpos _ (Hsub 0%nat ltac:(lia))).
    apply (term_le_sum m (fun k => w' (substate n s k))); [|lia]. intros. left. auto. }
  split.
  - intros E. split.
    + intros k j Hk Hj Hjs. assert (Hj' : (j < n - 1 + m)%nat) by lia.
      specialize (E _ j (Hsub k Hk) Hj'). assert (0 < w' j) by now apply Hpos.
      rewrite parent_of_substate, parent_of_other, <- (Hw j) in E by assumption.
      apply (Rmult_eq_reg_r (/ w' j)); [exact E|]. apply Rinv_neq_0_compat. lra.
    + intros k l Hk Hl. specialize (E _ _ (Hsub k Hk) (Hsub l Hl)).
      now rewrite !parent_of_substate in E.
  - intros [Eo Es] x y Hx Hy.
    destruct (refined_label n m s x Hs Hm Hx) as [[Hx1 Hx2]|[k [Hk ->]]];
    destruct (refined_label n m s y Hs Hm Hy) as [[Hy1 Hy2]|[l [Hl ->]]];
    rewrite ?parent_of_substate, ?(parent_of_other n s x), ?(parent_of_other n s y) by assumption.
    + now rewrite Hw, HP.
    + (* from another state to a sub-state: by reciprocity on both sides *)
      assert (H1 := Ha l x Hl Hx). unfold joint in H1. rewrite Eo in H1 by assumption.
      assert (H2 := coarse_reciprocal s x Hs Hx1). unfold joint in H2. rewrite (Hw x) in H1 by assumption.
      assert (H3 := Hpos _ (Hsub l Hl)). assert (H4 := Hpos _ Hx). rewrite Hw in H4 by assumption.
      apply (Rmult_eq_reg_r (w x * w' (substate n s l) * w s));
        [|repeat apply Rmult_integral_contrapositive_currified; lra].
      transitivity (w x * P' x (substate n s l) * w s); [field; lra|]. rewrite <- H1.
      transitivity (w x * P x s * w' (substate n s l)); [|field; lra]. rewrite <- H2. ring.
    + now rewrite Hw, Eo.
    + now apply Es.
Qed.
End Theorem1.
