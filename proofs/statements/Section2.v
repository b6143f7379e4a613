(* Section 2: an information-theoretic framework. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums ConstantKernel ContinuousChain ContinuousInformation
  ContinuousLimit Convergence ConvexEdge Corollary1 DiscreteBelowContinuous Divisions DoubleIntegral IntegralChain
  IntegralScenes MarkovChains MutualInformation OddWalks PlanarKernel PlanarScenes Refinement SourceAndDestination Sphere Visibility WeightedScene.
Open Scope R_scope.

(* ==== The words used below ==== *)

Theorem words_of_sums : forall (n : nat) (f : nat -> R), sum 0 f = 0 /\ sum (S n) f = sum n f + f n.
Proof. easy. Qed.

Theorem words_of_logarithms : forall x y : R,
  log2 x = ln x / ln 2 /\ xlog2 0 y = 0 /\ (x <> 0 -> xlog2 x y = x * log2 (x / y)).
Proof. split; [reflexivity|split; [apply xlog2_0|apply xlog2_nonzero]]. Qed.

Theorem words_of_markov_chains : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R),
  mutual_information n w P = sum n (fun i => sum n (fun j => w i * xlog2 (P i j) (w j))) /\
  entropy n w = - sum n (fun i => xlog2 (w i) 1) /\
  entropy_rate n w P = - sum n (fun i => sum n (fun j => w i * xlog2 (P i j) 1)) /\
  (markov_chain n w P <->
    (forall i, (i < n)%nat -> 0 <= w i) /\ (forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= P i j) /\
    sum n w = 1 /\ (forall i, (i < n)%nat -> sum n (fun j => P i j) = 1)) /\
  (reciprocal n w P <-> forall i j, (i < n)%nat -> (j < n)%nat -> w i * P i j = w j * P j i) /\
  (stationary n w P <-> forall j, (j < n)%nat -> sum n (fun i => w i * P i j) = w j).
Proof. split; [|split; [|split; [|split; [split; [intros []|intros [? [? []]]; constructor]|]]]]; try easy; auto. Qed.

Theorem words_of_scenes : forall (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R),
  (scene n area form_factor <->
    (forall i, (i < n)%nat -> 0 < area i) /\ (forall i j, (i < n)%nat -> (j < n)%nat -> 0 <= form_factor i j) /\
    (forall i j, (i < n)%nat -> (j < n)%nat -> area i * form_factor i j = area j * form_factor j i)) /\
  (closed n form_factor <-> forall i, (i < n)%nat -> sum n (fun j => form_factor i j) = 1).
Proof. split; [split; [intros []|intros [? []]; constructor]|]; try easy; auto. Qed.

(* ==== Section 2: an information-theoretic framework ==== *)

(* Convergence to the stationary distribution: where some power of P is positive; a control where it fails. *)
Theorem words_of_steps : forall (n t i j : nat) (P : nat -> nat -> R) (p w : nat -> R),
  after_steps n P 0 p = p /\ after_steps n P (S t) p j = sum n (fun l => after_steps n P t p l * P l j) /\
  power n P 0 i j = (if Nat.eqb i j then 1 else 0) /\ power n P (S t) i j = sum n (fun l => power n P t i l * P l j) /\
  (distribution n p <-> (forall l, (l < n)%nat -> 0 <= p l) /\ sum n p = 1) /\
  l1_distance n p w = sum n (fun l => Rabs (p l - w l)) /\
  swap_weight i = 1 / 2 /\ swap_transition i j = (if Nat.eqb i j then 0 else 1).
Proof. easy. Qed.

Theorem l1_distance_falls_geometrically : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R), markov_chain n w P
  -> stationary n w P -> forall (k c : nat) (delta : R), (c < n)%nat -> 0 <= delta -> (forall i, (i < n)%nat ->
  delta <= power n P k i c) -> forall (p : nat -> R) (q : nat), sum n p = 1 -> l1_distance n (after_steps n P (q *
  k) p) w <= (1 - delta) ^ q * l1_distance n p w.
Proof. exact Convergence.l1_distance_falls_geometrically. Qed.

Theorem walk_converges_if_one_state_is_reached_from_all : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R),
  markov_chain n w P -> stationary n w P -> forall k c : nat, (c < n)%nat -> (forall i, (i < n)%nat -> 0 < power n P
  k i c) -> forall p : nat -> R, distribution n p -> forall j : nat, (j < n)%nat -> Un_cv (fun t => after_steps n P
  t p j) (w j).
Proof. exact Convergence.walk_converges_if_one_state_is_reached_from_all. Qed.

Theorem walk_converges_to_stationary_distribution : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R),
  markov_chain n w P -> stationary n w P -> forall k : nat, (forall i j : nat, (i < n)%nat -> (j < n)%nat -> 0 <
  power n P k i j) -> forall p : nat -> R, distribution n p -> forall j : nat, (j < n)%nat -> Un_cv (fun t =>
  after_steps n P t p j) (w j).
Proof. exact Convergence.walk_converges_to_stationary_distribution. Qed.

Theorem walk_converges_if_any_two_patches_see_a_third :
  forall (n : nat) (w : nat -> R) (P : nat -> nat -> R),
  markov_chain n w P -> stationary n w P ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> exists l, (l < n)%nat /\ 0 < P i l /\ 0 < P l j) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof. exact Convergence.walk_converges_if_any_two_patches_see_a_third. Qed.

Theorem walk_converges_if_three_or_more_patches_see_each_other : forall (n : nat) (w : nat -> R) (P : nat -> nat ->
  R), markov_chain n w P -> stationary n w P -> (3 <= n)%nat -> (forall i j : nat, (i < n)%nat -> (j < n)%nat -> i
  <> j -> 0 < P i j) -> forall p : nat -> R, distribution n p -> forall j : nat, (j < n)%nat -> Un_cv (fun t =>
  after_steps n P t p j) (w j).
Proof. exact Convergence.walk_converges_if_three_or_more_patches_see_each_other. Qed.

Theorem swap_chain_is_reciprocal_markov_chain : markov_chain 2 swap_weight swap_transition /\ reciprocal 2
  swap_weight swap_transition.
Proof. exact Convergence.swap_chain_is_reciprocal_markov_chain. Qed.

Theorem walk_between_two_patches_does_not_converge : let p := fun i => match i with | 0%nat => 1 | S _ => 0 end in
  distribution 2 p /\ ~ (exists l, Un_cv (fun t => after_steps 2 swap_transition t p 0) l).
Proof. exact Convergence.walk_between_two_patches_does_not_converge. Qed.

(* One closed walk of odd length is enough. *)
Theorem walk_converges_if_an_odd_walk_closes : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R), markov_chain n w P ->
  reciprocal n w P -> (forall i, (i < n)%nat -> 0 < w i) -> forall c, (c < n)%nat ->
  (forall i, (i < n)%nat -> exists k, 0 < power n P k i c) ->
  (exists k, Nat.odd k = true /\ 0 < power n P k c c) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof. exact OddWalks.walk_converges_if_an_odd_walk_closes. Qed.

Theorem walk_converges_if_three_patches_see_each_other : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R),
  markov_chain n w P -> reciprocal n w P -> (forall i, (i < n)%nat -> 0 < w i) ->
  forall c a b, (c < n)%nat -> (a < n)%nat -> (b < n)%nat -> 0 < P c a -> 0 < P a b -> 0 < P b c ->
  (forall i, (i < n)%nat -> exists k, 0 < power n P k i c) ->
  forall p, distribution n p -> forall j, (j < n)%nat -> Un_cv (fun t => after_steps n P t p j) (w j).
Proof. exact OddWalks.walk_converges_if_three_patches_see_each_other. Qed.

Theorem two_patches_close_no_odd_walk : forall k, Nat.odd k = true -> power 2 swap_transition k 0 0 = 0.
Proof. exact OddWalks.two_patches_close_no_odd_walk. Qed.

(* Three such patches are there near a convex edge, which passes through the origin. *)
Theorem words_of_points_in_front : forall p1 p2 p3 n1 n2 n3 q1 q2 q3,
  has_in_front p1 p2 p3 n1 n2 n3 q1 q2 q3 <-> 0 < (q1 - p1) * n1 + (q2 - p2) * n2 + (q3 - p3) * n3.
Proof. easy. Qed.

Theorem points_near_a_convex_edge_face_each_other :
  forall n1 n2 n3 m1 m2 m3 r1 r2 r3 x1 x2 x3 y1 y2 y3 z1 z2 z3,
  x1 * n1 + x2 * n2 + x3 * n3 = 0 -> 0 < x1 * m1 + x2 * m2 + x3 * m3 ->
  y1 * m1 + y2 * m2 + y3 * m3 = 0 -> 0 < y1 * n1 + y2 * n2 + y3 * n3 ->
  0 < z1 * n1 + z2 * n2 + z3 * n3 -> 0 < z1 * m1 + z2 * m2 + z3 * m3 -> has_in_front z1 z2 z3 r1 r2 r3 0 0 0 ->
  exists near, 0 < near /\ forall t, 0 < t <= near ->
    has_in_front (t * x1) (t * x2) (t * x3) n1 n2 n3 (t * y1) (t * y2) (t * y3) /\
    has_in_front (t * y1) (t * y2) (t * y3) m1 m2 m3 (t * x1) (t * x2) (t * x3) /\
    has_in_front (t * x1) (t * x2) (t * x3) n1 n2 n3 z1 z2 z3 /\ has_in_front z1 z2 z3 r1 r2 r3 (t * x1) (t * x2) (t * x3) /\
    has_in_front (t * y1) (t * y2) (t * y3) m1 m2 m3 z1 z2 z3 /\ has_in_front z1 z2 z3 r1 r2 r3 (t * y1) (t * y2) (t * y3).
Proof. exact ConvexEdge.points_near_a_convex_edge_face_each_other. Qed.

Theorem points_at_another_edge_do_not_face_each_other : forall n1 n2 n3 x1 x2 x3 y1 y2 y3,
  x1 * n1 + x2 * n2 + x3 * n3 = 0 -> y1 * n1 + y2 * n2 + y3 * n3 <= 0 -> ~ has_in_front x1 x2 x3 n1 n2 n3 y1 y2 y3.
Proof. exact ConvexEdge.points_at_another_edge_do_not_face_each_other. Qed.

(* The visibility chain: w_i = A_i / A_T and P_ij = F_ij. *)
Theorem visibility_chain_is_markov : forall n area form_factor,
  (0 < n)%nat -> scene n area form_factor -> closed n form_factor ->
  markov_chain n (fun i => area i / sum n area) form_factor.
Proof. exact Visibility.visibility_chain_is_markov. Qed.

Theorem visibility_chain_is_reciprocal : forall n area form_factor,
  scene n area form_factor -> reciprocal n (fun i => area i / sum n area) form_factor.
Proof. exact Visibility.visibility_chain_is_reciprocal. Qed.

Theorem relative_areas_are_stationary : forall n area form_factor,
  (0 < n)%nat -> scene n area form_factor -> closed n form_factor ->
  stationary n (fun i => area i / sum n area) form_factor.
Proof. exact Visibility.relative_areas_are_stationary. Qed.

Theorem words_of_integrals :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable form_factor brightness received i j,
  (integrals point n over integrable <->
    (forall i f g, (i < n)%nat -> integrable f -> integrable g ->
       integrable (fun x => f x + g x) /\ over i (fun x => f x + g x) = over i f + over i g) /\
    (forall i c f, (i < n)%nat -> integrable f ->
       integrable (fun x => c * f x) /\ over i (fun x => c * f x) = c * over i f) /\
    (forall i f g, (i < n)%nat -> (forall x, f x = g x) -> integrable f -> integrable g /\ over i f = over i g)) /\
  (exchange_kernel point n over integrable form_factor brightness <->
    (forall x y, form_factor x y = form_factor y x) /\
    (forall x, integrable (fun y => form_factor x y * brightness y)) /\
    (forall j, (j < n)%nat -> integrable (fun x => brightness x * over j (fun y => form_factor x y * brightness y))) /\
    (forall i j, (i < n)%nat -> (j < n)%nat ->
       over i (fun x => over j (fun y => form_factor x y * brightness x * brightness y)) =
       over j (fun y => over i (fun x => form_factor x y * brightness x * brightness y)))) /\
  integral_exchange over form_factor brightness i j =
    over i (fun x => over j (fun y => form_factor x y * brightness x * brightness y)) /\
  integral_area over brightness received i = over i (fun x => brightness x * received x) /\
  integral_weight n over brightness received i =
    integral_area over brightness received i / sum n (integral_area over brightness received) /\
  integral_transition over form_factor brightness received i j =
    integral_exchange over form_factor brightness i j / integral_area over brightness received i.
Proof.
  intros. split; [split; [intros []|intros [? []]; constructor]; auto|].
  split; [split; [intros []|intros [? [? []]]; constructor]; auto|easy].
Qed.

Theorem continuous_visibility_has_constant_density : forall point n over integrable form_factor,
  integrals point n over integrable ->
  forall total,
  (forall x y, form_factor x y = form_factor y x) ->
  (forall x, integrable (form_factor x)) -> (forall x, sum n (fun j => over j (form_factor x)) = 1) ->
  forall y, sum n (fun i => over i (fun x => 1 / total * form_factor x y)) = 1 / total.
Proof. exact IntegralScenes.continuous_visibility_has_constant_density. Qed.

(* Mutual information, eqs. (1) to (3). *)
Theorem mutual_information_is_entropy_less_entropy_rate : forall n w P,
  markov_chain n w P -> stationary n w P ->
  sum n (fun i => sum n (fun j => w i * xlog2 (P i j) (w j))) =
  - sum n (fun i => xlog2 (w i) 1) - - sum n (fun i => sum n (fun j => w i * xlog2 (P i j) 1)).
Proof. exact MutualInformation.mutual_information_is_entropy_less_entropy_rate. Qed.

Theorem visibility_information_is_entropy_less_entropy_rate : forall n area form_factor,
  (0 < n)%nat -> scene n area form_factor -> closed n form_factor ->
  sum n (fun i => sum n (fun j =>
    area i / sum n area * (form_factor i j * log2 (form_factor i j * sum n area / area j))))
  = entropy n (fun i => area i / sum n area) - entropy_rate n (fun i => area i / sum n area) form_factor.
Proof. exact Visibility.visibility_information_is_entropy_less_entropy_rate. Qed.

Theorem mutual_information_nonneg : forall n w P,
  markov_chain n w P -> stationary n w P -> 0 <= mutual_information n w P.
Proof. exact MutualInformation.mutual_information_nonneg. Qed.

Theorem mutual_information_at_most_entropy : forall n w P,
  markov_chain n w P -> stationary n w P -> mutual_information n w P <= entropy n w.
Proof. exact MutualInformation.mutual_information_at_most_entropy. Qed.

(* "The amount of information that the destination patch conveys about the source patch, and vice versa." *)
Theorem words_of_source_and_destination : forall (n : nat) (w : nat -> R) (P J : nat -> nat -> R) (first second : nat -> R) (i j : nat),
  source_given_destination n w P j i = w i * P i j / sum n (fun k => w k * P k j) /\
  entropy_of_destination_given_source n w P = entropy_rate n w P /\
  entropy_of_source_given_destination n w P =
    - sum n (fun j => sum n (fun k => w k * P k j) * sum n (fun i => xlog2 (source_given_destination n w P j i) 1)) /\
  information_about n first second J = sum n (fun i => sum n (fun j => xlog2 (J i j) (first i * second j))).
Proof. easy. Qed.

Theorem information_is_symmetric : forall (n : nat) (first second : nat -> R) (J : nat -> nat -> R),
  information_about n first second J = information_about n second first (fun j i : nat => J i j).
Proof. exact SourceAndDestination.information_is_symmetric. Qed.

Theorem mutual_information_is_information_about : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R),
  mutual_information n w P = information_about n w w (joint w P).
Proof. exact SourceAndDestination.mutual_information_is_information_about. Qed.

Theorem reciprocal_chain_runs_backwards_alike : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R), markov_chain
  n w P -> reciprocal n w P -> forall i j : nat, (i < n)%nat -> (j < n)%nat -> w j <> 0 -> source_given_destination
  n w P j i = P j i.
Proof. exact SourceAndDestination.reciprocal_chain_runs_backwards_alike. Qed.

Theorem conditional_entropies_agree_for_reciprocal_chain : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R),
  markov_chain n w P -> reciprocal n w P -> entropy_of_source_given_destination n w P =
  entropy_of_destination_given_source n w P.
Proof. exact SourceAndDestination.conditional_entropies_agree_for_reciprocal_chain. Qed.

Theorem mutual_information_is_what_destination_tells_of_source : forall (n : nat) (w : nat -> R) (P : nat -> nat ->
  R), markov_chain n w P -> stationary n w P -> mutual_information n w P = entropy n w -
  entropy_of_source_given_destination n w P.
Proof. exact SourceAndDestination.mutual_information_is_what_destination_tells_of_source. Qed.

Theorem source_and_destination_tell_the_same_of_each_other : forall (n : nat) (w : nat -> R) (P : nat -> nat -> R),
  markov_chain n w P -> stationary n w P -> entropy n w - entropy_of_source_given_destination n w P = entropy n w -
  entropy_of_destination_given_source n w P.
Proof. exact SourceAndDestination.source_and_destination_tell_the_same_of_each_other. Qed.

(* Eq. (4) with A_T = 1, for a kernel f continuous on the plane: intervals of [0, 1] in place of patches. *)
Theorem words_of_discretizations : forall (C D : chain) (f : R -> R -> R) (n : nat) (p : nat -> R),
  information C = mutual_information (states C) (weight C) (transition C) /\
  (refined_by C D <->
    exists parent, refines (states C) (states D) parent (weight C) (transition C) (weight D) (transition D)) /\
  (division n p <-> p 0%nat = 0 /\ p n = 1 /\ forall k, p k <= p (S k)) /\
  states (discretized f n p) = n /\
  (forall k, weight (discretized f n p) k = p (S k) - p k) /\
  (forall k l, transition (discretized f n p) k l =
     RInt (fun x => RInt (fun y => f x y) (p l) (p (S l))) (p k) (p (S k)) / (p (S k) - p k)).
Proof. split; [easy|split; [easy|split; [split; [intros []|intros [? []]; constructor]|]]]; auto. Qed.

Theorem discretized_is_markov_chain : forall f : R -> R -> R,
  (forall x y, continuity_2d_pt f x y) ->
  (forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> 0 <= f x y) ->
  (forall x, 0 <= x <= 1 -> RInt (fun y => f x y) 0 1 = 1) ->
  forall n p, division n p -> (forall k, (k < n)%nat -> p k < p (S k)) ->
  let C := discretized f n p in markov_chain (states C) (weight C) (transition C).
Proof. exact ContinuousChain.discretized_is_markov_chain. Qed.

Theorem discretized_is_reciprocal : forall f : R -> R -> R,
  (forall x y, continuity_2d_pt f x y) ->
  (forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> f x y = f y x) ->
  forall n p, division n p ->
  let C := discretized f n p in reciprocal (states C) (weight C) (transition C).
Proof. exact ContinuousChain.discretized_is_reciprocal. Qed.

Theorem order_of_integration : forall f : R -> R -> R, (forall x y, continuity_2d_pt f x y) ->
  forall a b c d, a <= b -> c <= d ->
  RInt (fun x => RInt (fun y => f x y) c d) a b = RInt (fun y => RInt (fun x => f x y) a b) c d.
Proof. exact ContinuousChain.order_of_integration. Qed.

Theorem discrete_information_tends_to_continuous : forall f : R -> R -> R,
  (forall x y, continuity_2d_pt f x y) ->
  forall eps, 0 < eps -> exists delta, 0 < delta /\ forall n p, division n p ->
  (forall k, (k < n)%nat -> p (S k) - p k < delta) ->
  Rabs (information (discretized f n p) -
    RInt (fun x => RInt (fun y => xlog2 (f x y) 1) 0 1) 0 1) <= eps.
Proof. exact ContinuousInformation.discrete_information_tends_to_continuous. Qed.

Theorem discrete_information_at_most_continuous : forall f : R -> R -> R,
  (forall x y, continuity_2d_pt f x y) ->
  (forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> 0 <= f x y) ->
  forall n p, division n p ->
  information (discretized f n p) <= RInt (fun x => RInt (fun y => xlog2 (f x y) 1) 0 1) 0 1.
Proof. exact ContinuousInformation.discrete_information_at_most_continuous. Qed.

(* Any surfaces, any occluders: of the integral its rules are used, and that it keeps the order of functions. *)
Theorem words_of_continuous_scenes :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable (kernel : point -> point -> R) i j,
  patch_area over i = over i (fun _ => 1) /\
  patch_weight n over i = over i (fun _ => 1) / sum n (fun k => over k (fun _ => 1)) /\
  patch_form_factor over kernel i j = over i (fun x => over j (fun y => kernel x y)) / over i (fun _ => 1) /\
  information_of_all_points n over kernel =
    sum n (fun i => sum n (fun j => over i (fun x => over j (fun y =>
      1 / sum n (patch_area over) * xlog2 (kernel x y) (1 / sum n (patch_area over)))))) /\
  (integrable_scene point n over integrable kernel <->
    integrals point n over integrable /\
    (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, f x <= g x) -> over i f <= over i g) /\
    (forall x y, 0 <= kernel x y) /\
    integrable (fun _ => 1) /\
    (forall i, (i < n)%nat -> 0 < patch_area over i) /\
    (forall x, integrable (kernel x)) /\
    (forall j, (j < n)%nat -> integrable (fun x => over j (kernel x))) /\
    (forall x, integrable (fun y => 1 / sum n (patch_area over) * xlog2 (kernel x y) (1 / sum n (patch_area over)))) /\
    (forall j, (j < n)%nat -> integrable (fun x => over j (fun y =>
      1 / sum n (patch_area over) * xlog2 (kernel x y) (1 / sum n (patch_area over)))))).
Proof.
  intros. do 4 (split; [reflexivity|]). split; [intros []; do 8 (split; [assumption|]); assumption|].
  intros [? [? [? [? [? [? [? []]]]]]]]; constructor; assumption.
Qed.

Theorem no_division_has_more_information_than_the_continuous_scene :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable (kernel : point -> point -> R),
  integrable_scene point n over integrable kernel -> (0 < n)%nat ->
  mutual_information n (patch_weight n over) (patch_form_factor over kernel) <= information_of_all_points n over kernel.
Proof. exact DiscreteBelowContinuous.no_division_has_more_information_than_the_continuous_scene. Qed.

Theorem division_that_can_gain_lies_below_the_continuous_scene :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable (kernel : point -> point -> R),
  integrable_scene point n over integrable kernel -> (0 < n)%nat -> forall coarse parent w P,
  refines coarse n parent w P (patch_weight n over) (patch_form_factor over kernel) ->
  (exists k l, (k < n)%nat /\ (l < n)%nat /\
     joint (patch_weight n over) (patch_form_factor over kernel) k l * (w (parent k) * w (parent l)) <>
     patch_weight n over k * patch_weight n over l * joint w P (parent k) (parent l)) ->
  mutual_information coarse w P < information_of_all_points n over kernel.
Proof. exact DiscreteBelowContinuous.division_that_can_gain_lies_below_the_continuous_scene. Qed.

(* And it is the least upper bound: a pair of patches on which A_T F(x, y) varies little loses little, any other at most what
   it has. Shadow lines and common edges are left to the others, which finer patches make as few as one likes. *)
Theorem words_of_nearly_constant_pairs :
  forall (point : Type) n (over : nat -> (point -> R) -> R) (kernel : point -> point -> R) (patch : point -> nat) total e i j,
  (nearly_constant_pair total kernel patch e i j <-> exists a b, 0 <= a /\
    (forall x y, patch x = i -> patch y = j -> a <= total * kernel x y <= b) /\
    (forall s t, a <= s <= b -> a <= t <= b -> xlog2 s 1 - xlog2 t 1 <= e)) /\
  information_of_pair n over kernel i j = over i (fun x => over j (fun y =>
    1 / sum n (patch_area over) * xlog2 (kernel x y) (1 / sum n (patch_area over)))) /\
  information_of_all_points n over kernel = sum n (fun i => sum n (fun j => information_of_pair n over kernel i j)).
Proof. easy. Qed.

Theorem division_loses_little_beyond_its_uneven_pairs :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable (kernel : point -> point -> R) (patch : point -> nat),
  integrable_scene point n over integrable kernel -> (0 < n)%nat ->
  (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, patch x = i -> f x <= g x) -> over i f <= over i g) ->
  forall e (uneven : nat -> nat -> bool), 0 <= e ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> uneven i j = false ->
    nearly_constant_pair (sum n (patch_area over)) kernel patch e i j) ->
  information_of_all_points n over kernel <=
  mutual_information n (patch_weight n over) (patch_form_factor over kernel) + e +
  sum n (fun i => sum n (fun j => if uneven i j then
    information_of_pair n over kernel i j + exp (-1) / ln 2 * (patch_weight n over i * patch_weight n over j) else 0)).
Proof. exact ContinuousLimit.division_loses_little_beyond_its_uneven_pairs. Qed.

Theorem continuous_information_of_a_scene_is_least_upper_bound :
  forall (point division : Type) (patches : division -> nat) (over : division -> nat -> (point -> R) -> R)
    (integrable : (point -> R) -> Prop) (kernel : point -> point -> R) (patch : division -> point -> nat) continuous,
  (forall d, (0 < patches d)%nat) ->
  (forall d, integrable_scene point (patches d) (over d) integrable kernel) ->
  (forall d i f g, (i < patches d)%nat -> integrable f -> integrable g -> (forall x, patch d x = i -> f x <= g x) ->
    over d i f <= over d i g) ->
  (forall d, information_of_all_points (patches d) (over d) kernel = continuous) ->
  (forall delta, 0 < delta -> exists d e (uneven : nat -> nat -> bool), 0 <= e /\
    (forall i j, (i < patches d)%nat -> (j < patches d)%nat -> uneven i j = false ->
      nearly_constant_pair (sum (patches d) (patch_area (over d))) kernel (patch d) e i j) /\
    e + sum (patches d) (fun i => sum (patches d) (fun j => if uneven i j then
      information_of_pair (patches d) (over d) kernel i j +
      exp (-1) / ln 2 * (patch_weight (patches d) (over d) i * patch_weight (patches d) (over d) j) else 0)) <= delta) ->
  is_lub (fun v => exists d, v = mutual_information (patches d) (patch_weight (patches d) (over d)) (patch_form_factor (over d) kernel))
    continuous.
Proof. exact ContinuousLimit.continuous_information_of_a_scene_is_least_upper_bound. Qed.

Theorem discrete_information_of_a_scene_tends_to_continuous :
  forall (point : Type) (patches : nat -> nat) (over : nat -> nat -> (point -> R) -> R) (integrable : (point -> R) -> Prop)
    (kernel : point -> point -> R) (patch : nat -> point -> nat) continuous (e : nat -> R) (uneven : nat -> nat -> nat -> bool),
  (forall d, (0 < patches d)%nat) ->
  (forall d, integrable_scene point (patches d) (over d) integrable kernel) ->
  (forall d i f g, (i < patches d)%nat -> integrable f -> integrable g -> (forall x, patch d x = i -> f x <= g x) ->
    over d i f <= over d i g) ->
  (forall d, information_of_all_points (patches d) (over d) kernel = continuous) ->
  (forall d, 0 <= e d) ->
  (forall d i j, (i < patches d)%nat -> (j < patches d)%nat -> uneven d i j = false ->
    nearly_constant_pair (sum (patches d) (patch_area (over d))) kernel (patch d) (e d) i j) ->
  Un_cv (fun d => e d + sum (patches d) (fun i => sum (patches d) (fun j => if uneven d i j then
    information_of_pair (patches d) (over d) kernel i j +
    exp (-1) / ln 2 * (patch_weight (patches d) (over d) i * patch_weight (patches d) (over d) j) else 0))) 0 ->
  Un_cv (fun d => mutual_information (patches d) (patch_weight (patches d) (over d)) (patch_form_factor (over d) kernel))
    continuous.
Proof. exact ContinuousLimit.discrete_information_of_a_scene_tends_to_continuous. Qed.

(* An integral that does not keep order; and a scene that fulfils all hypotheses. *)
Theorem without_order_a_division_may_have_more :
  let over := fun (_ : nat) (f : bool -> R) => 2 * f true - f false in
  let kernel := fun x y : bool => (if x then 1 else 1 / 2) * (if y then 1 else 1 / 2) in
  integrals bool 1 over (fun _ => True) /\ (forall x y, 0 <= kernel x y) /\ 0 < patch_area over 0 /\
  information_of_all_points 1 over kernel < mutual_information 1 (patch_weight 1 over) (patch_form_factor over kernel).
Proof. exact ContinuousLimit.without_order_a_division_may_have_more. Qed.

Theorem two_points_fulfil_hypotheses :
  let over := fun (i : nat) (f : bool -> R) => if Nat.eqb i 0 then f true else f false in
  let patch := fun x : bool => if x then 0%nat else 1%nat in
  let kernel := fun x y : bool => if Bool.eqb x y then 0 else 1 in
  integrable_scene bool 2 over (fun _ => True) kernel /\
  (forall i f g, (i < 2)%nat -> (forall x, patch x = i -> f x <= g x) -> over i f <= over i g) /\
  (forall i j, (i < 2)%nat -> (j < 2)%nat -> nearly_constant_pair (sum 2 (patch_area over)) kernel patch 0 i j) /\
  information_of_all_points 2 over kernel = 1 /\
  mutual_information 2 (patch_weight 2 over) (patch_form_factor over kernel) = 1.
Proof. exact ContinuousLimit.two_points_fulfil_hypotheses. Qed.

Theorem division_of_an_unevenly_seen_patch_lies_below :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable (kernel : point -> point -> R) (patch : point -> nat),
  integrable_scene point n over integrable kernel -> (0 < n)%nat ->
  (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall x, patch x = i -> f x <= g x) -> over i f <= over i g) ->
  forall coarse parent w P k k' l a b,
  refines coarse n parent w P (patch_weight n over) (patch_form_factor over kernel) ->
  (k < n)%nat -> (k' < n)%nat -> (l < n)%nat -> parent k = parent k' -> a < b ->
  (forall x y, patch x = k -> patch y = l -> sum n (patch_area over) * kernel x y <= a) ->
  (forall x y, patch x = k' -> patch y = l -> b <= sum n (patch_area over) * kernel x y) ->
  mutual_information coarse w P < information_of_all_points n over kernel.
Proof. exact ContinuousLimit.division_of_an_unevenly_seen_patch_lies_below. Qed.

(* Planar patches: the points x + k s, k = 0 to 4, lie in the plane of x, and only 0 is the same form factor to y for all. *)
Theorem form_factor_of_a_planar_patch_is_not_constant :
  forall x1 x2 x3 n1 n2 n3 y1 y2 y3 m1 m2 m3 s1 s2 s3 c,
  s1 * n1 + s2 * n2 + s3 * n3 = 0 -> 0 < s1 ^ 2 + s2 ^ 2 + s3 ^ 2 ->
  (forall k, k = 0 \/ k = 1 \/ k = 2 \/ k = 3 \/ k = 4 ->
     let x1 := x1 + k * s1 in let x2 := x2 + k * s2 in let x3 := x3 + k * s3 in
     ((y1 - x1) * n1 + (y2 - x2) * n2 + (y3 - x3) * n3) * ((x1 - y1) * m1 + (x2 - y2) * m2 + (x3 - y3) * m3)
     / (PI * ((y1 - x1) ^ 2 + (y2 - x2) ^ 2 + (y3 - x3) ^ 2) ^ 2) = c) ->
  c = 0.
Proof. exact PlanarKernel.form_factor_of_a_planar_patch_is_not_constant. Qed.

(* Where y sees two points of a patch unequally, and no shadow line passes there; so five points of a planar patch. *)
Theorem words_of_unevenly_seen_points :
  forall (point : Type) (distance kernel : point -> point -> R) continuous coarse w P x x' y,
  (continuous_at_pair distance kernel x y <-> forall e, 0 < e -> exists d, 0 < d /\
    forall u v, distance u x < d -> distance v y < d -> Rabs (kernel u v - kernel x y) < e) /\
  (divided_near distance kernel continuous coarse w P x x' y <->
    forall d, 0 < d -> exists n over integrable (patch : point -> nat) parent k k' l, (0 < n)%nat /\
    integrable_scene point n over integrable kernel /\
    (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall z, patch z = i -> f z <= g z) -> over i f <= over i g) /\
    refines coarse n parent w P (patch_weight n over) (patch_form_factor over kernel) /\
    information_of_all_points n over kernel = continuous /\
    (k < n)%nat /\ (k' < n)%nat /\ (l < n)%nat /\ parent k = parent k' /\
    (forall u, patch u = k -> distance u x < d) /\ (forall u, patch u = k' -> distance u x' < d) /\
    (forall v, patch v = l -> distance v y < d)).
Proof. easy. Qed.

Theorem division_with_an_unevenly_seen_point_lies_below :
  forall (point : Type) (distance kernel : point -> point -> R) continuous coarse w P x x' y,
  divided_near distance kernel continuous coarse w P x x' y ->
  continuous_at_pair distance kernel x y -> continuous_at_pair distance kernel x' y -> kernel x y <> kernel x' y ->
  mutual_information coarse w P < continuous.
Proof. exact PlanarScenes.division_with_an_unevenly_seen_point_lies_below. Qed.

Theorem division_of_a_planar_patch_lies_below :
  forall (point : Type) (distance kernel : point -> point -> R) continuous coarse w P (p : nat -> point) y
    x1 x2 x3 n1 n2 n3 y1 y2 y3 m1 m2 m3 s1 s2 s3,
  s1 * n1 + s2 * n2 + s3 * n3 = 0 -> 0 < s1 ^ 2 + s2 ^ 2 + s3 ^ 2 ->
  (forall k, (k <= 4)%nat -> kernel (p k) y =
     let x1 := x1 + INR k * s1 in let x2 := x2 + INR k * s2 in let x3 := x3 + INR k * s3 in
     ((y1 - x1) * n1 + (y2 - x2) * n2 + (y3 - x3) * n3) * ((x1 - y1) * m1 + (x2 - y2) * m2 + (x3 - y3) * m3)
     / (PI * ((y1 - x1) ^ 2 + (y2 - x2) ^ 2 + (y3 - x3) ^ 2) ^ 2)) ->
  kernel (p 0%nat) y <> 0 ->
  (forall k, (k <= 4)%nat -> continuous_at_pair distance kernel (p k) y) ->
  (forall k, (k <= 4)%nat -> divided_near distance kernel continuous coarse w P (p 0%nat) (p k) y) ->
  mutual_information coarse w P < continuous.
Proof. exact PlanarScenes.division_of_a_planar_patch_lies_below. Qed.

Theorem two_points_in_one_patch_fulfil_hypotheses :
  let distance := fun x y : bool => if Bool.eqb x y then 0 else 1 in
  let kernel := fun x y : bool => if Bool.eqb x y then 0 else 1 in
  divided_near distance kernel 1 1 (fun _ => 1) (fun _ _ => 1) true false true /\
  continuous_at_pair distance kernel true true /\ continuous_at_pair distance kernel false true /\
  kernel true true <> kernel false true.
Proof. exact PlanarScenes.two_points_in_one_patch_fulfil_hypotheses. Qed.

(* "Always lower" than the continuous one is too much: a constant kernel, as inside a sphere, loses nothing. *)
Theorem constant_kernel_loses_nothing : forall n p, division n p ->
  information (discretized (fun _ _ => 1) n p) = 0 /\
  RInt (fun x => RInt (fun y => xlog2 1 1) 0 1) 0 1 = 0.
Proof. exact ConstantKernel.constant_kernel_loses_nothing. Qed.

Theorem constant_form_factor_loses_nothing :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable,
  integrals point n over integrable -> integrable (fun _ => 1) ->
  (forall i, (i < n)%nat -> 0 < over i (fun _ => 1)) -> (0 < n)%nat ->
  let area := fun i => over i (fun _ => 1) in
  let total := sum n area in
  mutual_information n (fun i => area i / total) (fun i j => over i (fun x => over j (fun y => 1 / total)) / area i) = 0 /\
  sum n (fun i => sum n (fun j =>
    over i (fun x => over j (fun y => 1 / total * (1 / total) * log2 (total * (1 / total)))))) = 0.
Proof. exact Sphere.constant_form_factor_loses_nothing. Qed.

Theorem form_factor_inside_a_sphere_is_constant : forall r x1 x2 x3 y1 y2 y3 : R, 0 < r ->
  x1 ^ 2 + x2 ^ 2 + x3 ^ 2 = r ^ 2 -> y1 ^ 2 + y2 ^ 2 + y3 ^ 2 = r ^ 2 ->
  let d := sqrt ((y1 - x1) ^ 2 + (y2 - x2) ^ 2 + (y3 - x3) ^ 2) in
  let cosine_x := ((y1 - x1) * (- x1 / r) + (y2 - x2) * (- x2 / r) + (y3 - x3) * (- x3 / r)) / d in
  let cosine_y := ((x1 - y1) * (- y1 / r) + (x2 - y2) * (- y2 / r) + (x3 - y3) * (- y3 / r)) / d in
  0 < d -> cosine_x * cosine_y / (PI * d ^ 2) = 1 / (4 * PI * r ^ 2).
Proof. exact Sphere.form_factor_inside_a_sphere_is_constant. Qed.

Theorem tilted_kernel_fulfils_hypotheses : continuous_in_both tilted_kernel /\
  (forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> 0 <= tilted_kernel x y) /\
  (forall x, 0 <= x <= 1 -> RInt (fun y => tilted_kernel x y) 0 1 = 1) /\
  (forall x y, tilted_kernel x y = tilted_kernel y x) /\
  tilted_kernel 1 1 = 2 /\ tilted_kernel 1 0 = 0.
Proof. exact ContinuousChain.tilted_kernel_fulfils_hypotheses. Qed.
