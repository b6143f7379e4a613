(* Sections 3.1 and 3.2: refinement of states, and the gain of a pair. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums AcrossTheGradientGain ContinuousInformation Corollary1
  Corollary1Control Divisions GainFormula LargestWeight MarkovChains PairGain Refinement StateRefinement
  Theorem1 Theorem1Variants.
Open Scope R_scope.

(* ==== Section 3.1: Theorem 1 ==== *)

Theorem words_of_refinement : forall n s m w P w' P',
  (forall k, substate n s k = match k with O => s | S k' => (n + k')%nat end) /\
  (forall k, parent_state n s k = if (k <? n)%nat then k else s) /\
  (refines_state n s m w P w' P' <->
    (s < n)%nat /\ (1 <= m)%nat /\
    (forall j, (j < n)%nat -> j <> s -> w' j = w j) /\
    (forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j) /\
    (forall k j, (k < m)%nat -> (j < n - 1 + m)%nat ->
       w' (substate n s k) * P' (substate n s k) j = w' j * P' j (substate n s k)) /\
    (forall j, (j < n)%nat -> j <> s -> P j s = sum m (fun k => P' j (substate n s k)))).
Proof.
  split; [easy|split; [easy|split; [intros []|intros [? [? [? [? []]]]]; constructor]]]; auto.
  repeat (split; [assumption|]). assumption.
Qed.

Theorem theorem_1 : forall (n s m : nat) (w : nat -> R) (P : nat -> nat -> R)
    (w' : nat -> R) (P' : nat -> nat -> R),
  (* the chain before: n states, probabilities, stationary weights, reciprocity *)
  (forall i, (i < n)%nat -> 0 <= w i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= P i j) ->
  sum n w = 1 -> (forall i, (i < n)%nat -> sum n (fun j => P i j) = 1) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> w i * P i j = w j * P j i) ->
  (* the chain after: n - 1 + m states *)
  (forall i, (i < n - 1 + m)%nat -> 0 <= w' i) ->
  (forall i j, (i < n - 1 + m)%nat -> (j < n - 1 + m)%nat -> 0 <= P' i j) ->
  sum (n - 1 + m) w' = 1 -> (forall i, (i < n - 1 + m)%nat -> sum (n - 1 + m) (fun j => P' i j) = 1) ->
  (* state s becomes m >= 1 sub-states; nothing changes among the others *)
  (s < n)%nat -> (1 <= m)%nat ->
  (forall j, (j < n)%nat -> j <> s -> w' j = w j) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j) ->
  (* (a) *)
  (forall k j, (k < m)%nat -> (j < n - 1 + m)%nat ->
     w' (substate n s k) * P' (substate n s k) j = w' j * P' j (substate n s k)) ->
  (* (b) *)
  (forall j, (j < n)%nat -> j <> s -> P j s = sum m (fun k => P' j (substate n s k))) ->
  mutual_information n w P <= mutual_information (n - 1 + m) w' P'.
Proof.
  intros n s m w P w' P' H1 H2 H3 H4 K. intros.
  apply refinement_never_lowers_mutual_information with (s := s); [split|exact K|split|split]; assumption.
Qed.

Theorem refinement_never_lowers_mutual_information : forall n s m w P w' P',
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' ->
  refines_state n s m w P w' P' ->
  mutual_information n w P <= mutual_information (n - 1 + m) w' P'.
Proof. exact Theorem1.refinement_never_lowers_mutual_information. Qed.

Theorem refined_state_is_sum_of_substates : forall n s m w P w' P',
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' ->
  refines_state n s m w P w' P' ->
  w s = sum m (fun k => w' (substate n s k)) /\
  w s * P s s =
    sum m (fun k => sum m (fun l => w' (substate n s k) * P' (substate n s k) (substate n s l))).
Proof. exact Theorem1.refined_state_is_sum_of_substates. Qed.

(* When nothing is gained. *)
Theorem refinement_keeps_mutual_information_iff_joints_are_product_shares : forall n s m w P w' P',
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' ->
  refines_state n s m w P w' P' ->
  mutual_information (n - 1 + m) w' P' = mutual_information n w P <->
  (forall x y, (x < n - 1 + m)%nat -> (y < n - 1 + m)%nat ->
     joint w' P' x y * (w (parent_state n s x) * w (parent_state n s y)) =
     w' x * w' y * joint w P (parent_state n s x) (parent_state n s y)).
Proof. exact Theorem1.refinement_keeps_mutual_information_iff_joints_are_product_shares. Qed.

Theorem refinement_keeps_mutual_information_iff_substates_see_alike : forall n s m w P w' P',
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' ->
  refines_state n s m w P w' P' ->
  (forall x, (x < n - 1 + m)%nat -> 0 < w' x) ->
  mutual_information (n - 1 + m) w' P' = mutual_information n w P <->
  (forall k j, (k < m)%nat -> (j < n)%nat -> j <> s -> P' (substate n s k) j = P s j) /\
  (forall k l, (k < m)%nat -> (l < m)%nat ->
     P' (substate n s k) (substate n s l) / w' (substate n s l) = P s s / w s).
Proof. exact Theorem1.refinement_keeps_mutual_information_iff_substates_see_alike. Qed.

(* Several states at once, by a parent map. *)
Theorem words_of_refinement_of_several_states : forall n N parent w P w' P',
  (forall i f, part_sum N parent i f = sum N (fun k => if Nat.eqb (parent k) i then f k else 0)) /\
  (refines n N parent w P w' P' <->
    (forall k, (k < N)%nat -> (parent k < n)%nat) /\
    (forall k, (k < N)%nat -> 0 <= w' k) /\
    (forall k l, (k < N)%nat -> (l < N)%nat -> 0 <= w' k * P' k l) /\
    (forall k l, (k < N)%nat -> (l < N)%nat -> w' l = 0 -> w' k * P' k l = 0) /\
    (forall i, (i < n)%nat -> w i = part_sum N parent i w') /\
    (forall i j, (i < n)%nat -> (j < n)%nat ->
       w i * P i j = part_sum N parent i (fun k => part_sum N parent j (fun l => w' k * P' k l)))).
Proof.
  split; [easy|split; [intros []|intros [? [? [? [? []]]]]; constructor]]; auto.
  repeat (split; [assumption|]). assumption.
Qed.

Theorem refinement_of_several_states_never_lowers_mutual_information : forall n N parent w P w' P',
  refines n N parent w P w' P' -> mutual_information n w P <= mutual_information N w' P'.
Proof. exact Refinement.refinement_of_several_states_never_lowers_mutual_information. Qed.

Theorem several_states_equal_mutual_information : forall n N parent w P w' P',
  refines n N parent w P w' P' ->
  mutual_information N w' P' = mutual_information n w P <->
  (forall k l, (k < N)%nat -> (l < N)%nat ->
     joint w' P' k l * (w (parent k) * w (parent l)) = w' k * w' l * joint w P (parent k) (parent l)).
Proof. exact Refinement.several_states_equal_mutual_information. Qed.

Theorem several_states_equal_transition_ratios : forall n N parent w P w' P',
  refines n N parent w P w' P' -> (forall k, (k < N)%nat -> 0 < w' k) ->
  mutual_information N w' P' = mutual_information n w P <->
  (forall k l, (k < N)%nat -> (l < N)%nat -> P' k l / w' l = P (parent k) (parent l) / w (parent l)).
Proof. exact Refinement.several_states_equal_transition_ratios. Qed.

(* What the hypotheses are needed for. *)
Theorem refinement_of_stationary_chain_never_lowers_mutual_information : forall n s m w P w' P',
  (s < n)%nat -> (1 <= m)%nat ->
  markov_chain n w P -> stationary n w P ->
  markov_chain (n - 1 + m) w' P' -> stationary (n - 1 + m) w' P' ->
  (forall j, (j < n)%nat -> j <> s -> w' j = w j) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j) ->
  mutual_information n w P <= mutual_information (n - 1 + m) w' P'.
Proof. exact Theorem1Variants.refinement_of_stationary_chain_never_lowers_mutual_information. Qed.

Theorem cover_follows_from_rows : forall n s m w P w' P',
  (s < n)%nat -> (1 <= m)%nat -> markov_chain n w P -> markov_chain (n - 1 + m) w' P' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> s -> j <> s -> P' i j = P i j) ->
  forall j, (j < n)%nat -> j <> s -> P j s = sum m (fun k => P' j (substate n s k)).
Proof. exact Theorem1Variants.cover_follows_from_rows. Qed.

Theorem words_of_controls : forall (n i j : nat),
  half i = 1 / 2 /\ half_quarter_quarter i = match i with O => 1 / 2 | _ => 1 / 4 end /\
  stay i j = (if Nat.eqb i j then 1 else 0) /\
  substates_jump_anywhere i j = match i with O => stay 0 j | _ => half_quarter_quarter j end /\
  all_jump_anywhere i j = half_quarter_quarter j /\
  substates_receive_too_much i j = match i, j with O, O => 1 | _, _ => half_quarter_quarter j end /\
  chain_that_stays n = {| states := n; weight := fun _ => 1 / INR n; transition := stay |}.
Proof. easy. Qed.

Theorem refinement_can_raise_mutual_information :
  markov_chain 1 (fun _ => 1) (fun _ _ => 1) /\ reciprocal 1 (fun _ => 1) (fun _ _ => 1) /\
  markov_chain 2 half stay /\ refines_state 1 0 2 (fun _ => 1) (fun _ _ => 1) half stay /\
  mutual_information 1 (fun _ => 1) (fun _ _ => 1) = 0 /\ mutual_information 2 half stay = 1.
Proof. exact Theorem1Variants.refinement_can_raise_mutual_information. Qed.

Theorem without_reciprocity_mutual_information_can_fall :
  markov_chain 3 half_quarter_quarter substates_jump_anywhere /\
  (forall j, (j < 2)%nat -> j <> 1%nat -> half_quarter_quarter j = half j) /\
  (forall i j, (i < 2)%nat -> (j < 2)%nat -> i <> 1%nat -> j <> 1%nat ->
     substates_jump_anywhere i j = stay i j) /\
  (forall j, (j < 2)%nat -> j <> 1%nat ->
     stay j 1 = sum 2 (fun k => substates_jump_anywhere j (substate 2 1 k))) /\
  ~ stationary 3 half_quarter_quarter substates_jump_anywhere /\
  mutual_information 3 half_quarter_quarter substates_jump_anywhere = 1 / 2 /\
  mutual_information 2 half stay = 1.
Proof. exact Theorem1Variants.without_reciprocity_mutual_information_can_fall. Qed.

Theorem without_cover_mutual_information_can_fall :
  markov_chain 3 half_quarter_quarter all_jump_anywhere /\
  reciprocal 3 half_quarter_quarter all_jump_anywhere /\
  (forall j, (j < 2)%nat -> j <> 1%nat -> half_quarter_quarter j = half j) /\
  sum 2 (fun k => all_jump_anywhere 0 (substate 2 1 k)) <> stay 0 1 /\
  mutual_information 3 half_quarter_quarter all_jump_anywhere = 0 /\
  mutual_information 2 half stay = 1.
Proof. exact Theorem1Variants.without_cover_mutual_information_can_fall. Qed.

Theorem without_cover_alone_mutual_information_can_fall :
  reciprocal 3 half_quarter_quarter substates_receive_too_much /\
  (forall j, (j < 2)%nat -> j <> 1%nat -> half_quarter_quarter j = half j) /\
  (forall i j, (i < 2)%nat -> (j < 2)%nat -> i <> 1%nat -> j <> 1%nat ->
     substates_receive_too_much i j = stay i j) /\
  sum 3 half_quarter_quarter = 1 /\
  (forall k, (k < 2)%nat -> sum 3 (substates_receive_too_much (substate 2 1 k)) = 1) /\
  sum 2 (fun k => substates_receive_too_much 0 (substate 2 1 k)) <> stay 0 1 /\
  mutual_information 3 half_quarter_quarter substates_receive_too_much = 1 / 2 /\
  mutual_information 2 half stay = 1.
Proof. exact Theorem1Variants.without_cover_alone_mutual_information_can_fall. Qed.

(* ==== Section 3.1: Corollary 1 ==== *)

Theorem state_refinement_is_refinement : forall n s m w P w' P',
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' ->
  refines_state n s m w P w' P' ->
  refined_by {| states := n; weight := w; transition := P |}
    {| states := n - 1 + m; weight := w'; transition := P' |}.
Proof. exact Corollary1.state_refinement_is_refinement. Qed.

Theorem refined_by_itself : forall n w P, markov_chain n w P -> stationary n w P ->
  refined_by {| states := n; weight := w; transition := P |} {| states := n; weight := w; transition := P |}.
Proof. exact Corollary1.refined_by_itself. Qed.

Theorem refined_by_transitive : forall C D E, refined_by C D -> refined_by D E -> refined_by C E.
Proof. exact Corollary1.refined_by_transitive. Qed.

Theorem refinement_bounds_information : forall C D, refined_by C D -> information C <= information D.
Proof. exact Corollary1.refinement_bounds_information. Qed.

Theorem information_grows : forall U : nat -> chain, (forall t, refined_by (U t) (U (S t))) ->
  forall t, information (U t) <= information (U (S t)).
Proof. exact Corollary1.information_grows. Qed.

Theorem information_converges_to_least_upper_bound : forall U : nat -> chain,
  (forall t, refined_by (U t) (U (S t))) -> has_ub (fun t => information (U t)) ->
  exists limit, Un_cv (fun t => information (U t)) limit /\ is_lub (EUn (fun t => information (U t))) limit.
Proof. exact Corollary1.information_converges_to_least_upper_bound. Qed.

Theorem information_converges_below_common_refinement : forall U : nat -> chain,
  (forall t, refined_by (U t) (U (S t))) -> forall C, (forall t, refined_by (U t) C) ->
  exists limit, limit <= information C /\ Un_cv (fun t => information (U t)) limit /\
    is_lub (EUn (fun t => information (U t))) limit.
Proof. exact Corollary1.information_converges_below_common_refinement. Qed.

Theorem limit_is_least_upper_bound_over_discretizations : forall U : nat -> chain,
  (forall t, refined_by (U t) (U (S t))) ->
  forall (discretization : chain -> Prop) limit,
  (forall t, discretization (U t)) ->
  (forall C, discretization C -> exists t, refined_by C (U t)) ->
  Un_cv (fun t => information (U t)) limit ->
  is_lub (fun x => exists C, discretization C /\ x = information C) limit.
Proof. exact Corollary1.limit_is_least_upper_bound_over_discretizations. Qed.

Theorem information_at_most_log_of_density : forall n w P M, 0 < M -> markov_chain n w P ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> P i j <= M * w j) -> mutual_information n w P <= log2 M.
Proof. exact Corollary1.information_at_most_log_of_density. Qed.

Theorem information_of_bounded_density_converges : forall U : nat -> chain,
  (forall t, refined_by (U t) (U (S t))) -> forall M, 0 < M ->
  (forall t, markov_chain (states (U t)) (weight (U t)) (transition (U t))) ->
  (forall t i j, (i < states (U t))%nat -> (j < states (U t))%nat ->
     transition (U t) i j <= M * weight (U t) j) ->
  exists limit, limit <= log2 M /\ Un_cv (fun t => information (U t)) limit /\
    is_lub (EUn (fun t => information (U t))) limit.
Proof. exact Corollary1.information_of_bounded_density_converges. Qed.

Theorem without_bound_mutual_information_grows_without_limit :
  let U := fun t => chain_that_stays (2 ^ t) in
  (forall t, refined_by (U t) (U (S t))) /\ (forall t, information (U t) = INR t) /\
  ~ has_ub (fun t => information (U t)).
Proof. exact Corollary1Control.without_bound_mutual_information_grows_without_limit. Qed.

(* For a continuous kernel on [0, 1]: the continuous mutual information is the least upper bound over all divisions. *)
Theorem continuous_information_is_least_upper_bound : forall f : R -> R -> R,
  (forall x y, continuity_2d_pt f x y) ->
  (forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> 0 <= f x y) ->
  is_lub (fun x => exists n p, division n p /\ x = information (discretized f n p))
    (RInt (fun x => RInt (fun y => xlog2 (f x y) 1) 0 1) 0 1).
Proof. exact ContinuousInformation.continuous_information_is_least_upper_bound. Qed.

(* ==== Section 3.2: the gain of a pair, eqs. (5) and (6) ==== *)

Theorem words_of_pair_gain : forall n s m weight probability receiver part_weight part_probability f,
  pair_gain m weight probability receiver part_weight part_probability =
    2 * (sum m (fun k => part_weight k * xlog2 (part_probability k) receiver) - weight * xlog2 probability receiver) /\
  pair_gain_without_receiver m weight probability part_weight part_probability =
    2 * (sum m (fun k => part_weight k * xlog2 (part_probability k) 1) - weight * xlog2 probability 1) /\
  sum_others n s f = sum n (fun j => if Nat.eqb j s then 0 else f j).
Proof. easy. Qed.

Theorem gain_of_planar_patch_is_sum_of_pair_gains : forall n s m w P w' P',
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' ->
  refines_state n s m w P w' P' -> P s s = 0 ->
  mutual_information (n - 1 + m) w' P' - mutual_information n w P =
  sum_others n s (fun j =>
    pair_gain m (w s) (P s j) (w j) (fun k => w' (substate n s k)) (fun k => P' (substate n s k) j)).
Proof. exact GainFormula.gain_of_planar_patch_is_sum_of_pair_gains. Qed.

Theorem joint_of_parts_from_reciprocity_and_cover :
  forall m weight probability receiver back part_weight part_probability part_back,
  weight * probability = receiver * back ->
  (forall k, (k < m)%nat -> part_weight k * part_probability k = receiver * part_back k) ->
  back = sum m part_back ->
  sum m (fun k => part_weight k * part_probability k) = weight * probability.
Proof. exact PairGain.joint_of_parts_from_reciprocity_and_cover. Qed.

Theorem receiver_weight_drops_out :
  forall m weight probability receiver part_weight part_probability,
  0 <= probability -> 0 < receiver -> (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m (fun k => part_weight k * part_probability k) = weight * probability ->
  2 * (sum m (fun k => part_weight k * xlog2 (part_probability k) receiver)
       - weight * xlog2 probability receiver) =
  2 * (sum m (fun k => part_weight k * xlog2 (part_probability k) 1) - weight * xlog2 probability 1).
Proof. exact PairGain.receiver_weight_drops_out. Qed.

Theorem pair_gain_nonneg : forall m weight probability receiver part_weight part_probability,
  0 <= receiver -> (forall k, (k < m)%nat -> 0 <= part_weight k) ->
  (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  (receiver = 0 -> weight * probability = 0) ->
  weight = sum m part_weight ->
  sum m (fun k => part_weight k * part_probability k) = weight * probability ->
  0 <= pair_gain m weight probability receiver part_weight part_probability.
Proof. exact PairGain.pair_gain_nonneg. Qed.

Theorem pair_gain_of_regular_subdivision : forall (m : nat) (weight probability receiver : R) (part_probability :
  nat -> R), (1 <= m)%nat -> 0 <= probability -> 0 < receiver -> (forall k, (k < m)%nat -> 0 <= part_probability k)
  -> sum m (fun k => weight / INR m * part_probability k) = weight * probability -> pair_gain m weight probability
  receiver (fun _ => weight / INR m) part_probability = 2 * (weight / INR m * sum m (fun k => xlog2
  (part_probability k) 1) - weight * xlog2 probability 1).
Proof. exact PairGain.pair_gain_of_regular_subdivision. Qed.

Theorem only_nonnull_part_has_m_times_probability :
  forall m weight probability part_probability, (1 <= m)%nat -> 0 < weight ->
  sum m (fun k => weight / INR m * part_probability k) = weight * probability ->
  forall k, (k < m)%nat -> (forall l, (l < m)%nat -> l <> k -> part_probability l = 0) ->
  part_probability k = INR m * probability.
Proof. exact PairGain.only_nonnull_part_has_m_times_probability. Qed.

Theorem regular_gain_at_most : forall m weight probability receiver part_probability,
  (1 <= m)%nat -> 0 < weight -> 0 <= probability -> 0 < receiver ->
  (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m (fun k => weight / INR m * part_probability k) = weight * probability ->
  pair_gain m weight probability receiver (fun _ => weight / INR m) part_probability
    <= 2 * weight * probability * log2 (INR m).
Proof. exact PairGain.regular_gain_at_most. Qed.

Theorem regular_gain_attained : forall m weight probability receiver part_probability,
  (1 <= m)%nat -> 0 < weight -> 0 <= probability -> 0 < receiver ->
  (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m (fun k => weight / INR m * part_probability k) = weight * probability ->
  forall k, (k < m)%nat -> (forall l, (l < m)%nat -> l <> k -> part_probability l = 0) ->
  pair_gain m weight probability receiver (fun _ => weight / INR m) part_probability
    = 2 * weight * probability * log2 (INR m).
Proof. exact PairGain.regular_gain_attained. Qed.

Theorem regular_gain_attained_iff_concentrated :
  forall m weight probability receiver part_probability,
  (1 <= m)%nat -> 0 < weight -> 0 <= probability -> 0 < receiver ->
  (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m (fun k => weight / INR m * part_probability k) = weight * probability ->
  0 < probability ->
  pair_gain m weight probability receiver (fun _ => weight / INR m) part_probability
    = 2 * weight * probability * log2 (INR m) <->
  exists k, (k < m)%nat /\ part_probability k = INR m * probability /\
    forall l, (l < m)%nat -> l <> k -> part_probability l = 0.
Proof. exact PairGain.regular_gain_attained_iff_concentrated. Qed.

Theorem regular_gain_below_where_m_times_probability_exceeds_one :
  forall m weight probability receiver part_probability,
  (1 <= m)%nat -> 0 < weight -> 0 <= probability -> 0 < receiver ->
  (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m (fun k => weight / INR m * part_probability k) = weight * probability ->
  (forall k, (k < m)%nat -> part_probability k <= 1) -> 1 < INR m * probability ->
  pair_gain m weight probability receiver (fun _ => weight / INR m) part_probability
    < 2 * weight * probability * log2 (INR m).
Proof. exact PairGain.regular_gain_below_where_m_times_probability_exceeds_one. Qed.

Theorem regular_gain_at_most_entropy_term :
  forall m weight probability receiver part_probability,
  (1 <= m)%nat -> 0 < weight -> 0 <= probability -> 0 < receiver ->
  (forall k, (k < m)%nat -> 0 <= part_probability k) ->
  sum m (fun k => weight / INR m * part_probability k) = weight * probability ->
  (forall k, (k < m)%nat -> part_probability k <= 1) ->
  pair_gain m weight probability receiver (fun _ => weight / INR m) part_probability
    <= - (2 * weight * xlog2 probability 1).
Proof. exact PairGain.regular_gain_at_most_entropy_term. Qed.

Theorem bound_summed_over_receivers : forall n m weight probability,
  sum n probability = 1 ->
  sum n (fun j => 2 * weight * probability j * log2 (INR m)) = 2 * weight * log2 (INR m).
Proof. exact PairGain.bound_summed_over_receivers. Qed.

Theorem regular_refinement_gains_at_most : forall n s m w P w' P',
  markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1 + m) w' P' ->
  refines_state n s m w P w' P' ->
  (forall k, (k < m)%nat -> w' (substate n s k) = w s / INR m) -> 0 < w s ->
  mutual_information (n - 1 + m) w' P' - mutual_information n w P <= 2 * w s * log2 (INR m).
Proof. exact GainFormula.regular_refinement_gains_at_most. Qed.

(* The heuristic: the state of largest weight has the largest bound. *)
Theorem words_of_the_bound : forall (n m i : nat) (w : nat -> R) (P : nat -> nat -> R),
  bound_on_gain n m w P i = sum n (fun j => 2 * w i * P i j * log2 (INR m)).
Proof. easy. Qed.

Theorem bound_on_gain_is_weight_times_log : forall (n m : nat) (w : nat -> R) (P : nat -> nat -> R) (i : nat),
  markov_chain n w P -> (i < n)%nat -> bound_on_gain n m w P i = 2 * w i * log2 (INR m).
Proof. exact LargestWeight.bound_on_gain_is_weight_times_log. Qed.

Theorem bounds_are_ordered_as_weights : forall (n m : nat) (w : nat -> R) (P : nat -> nat -> R) (i j : nat), (2 <=
  m)%nat -> markov_chain n w P -> (i < n)%nat -> (j < n)%nat -> bound_on_gain n m w P j <= bound_on_gain n m w P i
  <-> w j <= w i.
Proof. exact LargestWeight.bounds_are_ordered_as_weights. Qed.

Theorem largest_bound_iff_largest_weight : forall (n m : nat) (w : nat -> R) (P : nat -> nat -> R) (i : nat), (2 <=
  m)%nat -> markov_chain n w P -> (i < n)%nat -> (forall j, (j < n)%nat -> bound_on_gain n m w P j <= bound_on_gain
  n m w P i) <-> (forall j, (j < n)%nat -> w j <= w i).
Proof. exact LargestWeight.largest_bound_iff_largest_weight. Qed.

Theorem some_state_has_largest_bound : forall (n m : nat) (w : nat -> R) (P : nat -> nat -> R), (2 <= m)%nat ->
  markov_chain n w P -> exists i : nat, (i < n)%nat /\ (forall j, (j < n)%nat -> w j <= w i) /\ (forall j, (j <
  n)%nat -> bound_on_gain n m w P j <= bound_on_gain n m w P i).
Proof. exact LargestWeight.some_state_has_largest_bound. Qed.

Theorem no_regular_refinement_gains_more_than_largest_bound : forall (n s m : nat) (w : nat -> R) (P : nat -> nat ->
  R) (w' : nat -> R) (P' : nat -> nat -> R) (i : nat), markov_chain n w P -> reciprocal n w P -> markov_chain (n - 1
  + m) w' P' -> refines_state n s m w P w' P' -> (forall k, (k < m)%nat -> w' (substate n s k) = w s / INR m) -> 0 <
  w s -> (2 <= m)%nat -> (i < n)%nat -> (forall j, (j < n)%nat -> w j <= w i) -> mutual_information (n - 1 + m) w'
  P' - mutual_information n w P <= bound_on_gain n m w P i.
Proof. exact LargestWeight.no_regular_refinement_gains_more_than_largest_bound. Qed.
