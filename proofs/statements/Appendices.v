(* Appendices A and B: eqs. (9) to (14). *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums AnyDivision Blocks DiscontinuityCuts
  DiscontinuityMeshing GainFormula LogSum MarkovChains PairGain StateRefinement Theorem1 TwoPartDivision.
Open Scope R_scope.

(* ==== Appendix A: eqs. (9) to (12) ==== *)

Theorem refined_mutual_information_is_sum_of_four_blocks : forall (n s m : nat) (w' : nat -> R) (P' : nat -> nat ->
  R), (s < n)%nat -> (1 <= m)%nat -> mutual_information (n - 1 + m) w' P' = sum_others n s (fun i => sum_others n s
  (fun j => w' i * xlog2 (P' i j) (w' j))) + sum_others n s (fun i => sum m (fun k => w' i * xlog2 (P' i (substate n
  s k)) (w' (substate n s k)))) + sum m (fun k => sum_others n s (fun j => w' (substate n s k) * xlog2 (P' (substate
  n s k) j) (w' j))) + sum m (fun k => sum m (fun l => w' (substate n s k) * xlog2 (P' (substate n s k) (substate n
  s l)) (w' (substate n s l)))).
Proof. exact Blocks.refined_mutual_information_is_sum_of_four_blocks. Qed.

Theorem refined_mutual_information_with_last_state_refined : forall (n m : nat) (w' : nat -> R) (P' : nat -> nat ->
  R), (1 <= n)%nat -> (1 <= m)%nat -> mutual_information (n - 1 + m) w' P' = sum (n - 1) (fun i => sum (n - 1) (fun
  j => w' i * xlog2 (P' i j) (w' j))) + sum (n - 1) (fun i => sum m (fun k => w' i * xlog2 (P' i (n - 1 + k)%nat)
  (w' (n - 1 + k)%nat))) + sum m (fun k => sum (n - 1) (fun j => w' (n - 1 + k)%nat * xlog2 (P' (n - 1 + k)%nat j)
  (w' j))) + sum m (fun k => sum m (fun l => w' (n - 1 + k)%nat * xlog2 (P' (n - 1 + k)%nat (n - 1 + l)%nat) (w' (n
  - 1 + l)%nat))).
Proof. exact Blocks.refined_mutual_information_with_last_state_refined. Qed.

Theorem mutual_information_of_upper_triangle : forall n w P, reciprocal n w P ->
  mutual_information n w P =
  2 * sum n (fun j => sum j (fun i => w i * xlog2 (P i j) (w j))) +
  sum n (fun i => w i * xlog2 (P i i) (w i)).
Proof. exact GainFormula.mutual_information_of_upper_triangle. Qed.

Theorem gain_is_pair_gains_and_self_gain : forall n s m w P w' P',
  reciprocal n w P -> refines_state n s m w P w' P' ->
  mutual_information (n - 1 + m) w' P' - mutual_information n w P =
  sum_others n s (fun j =>
    pair_gain m (w s) (P s j) (w j) (fun k => w' (substate n s k)) (fun k => P' (substate n s k) j)) +
  (sum m (fun k => sum m (fun l => w' (substate n s k) *
     xlog2 (P' (substate n s k) (substate n s l)) (w' (substate n s l)))) - w s * xlog2 (P s s) (w s)).
Proof. exact GainFormula.gain_is_pair_gains_and_self_gain. Qed.

Theorem log_sum_inequality : forall (n : nat) (a b : nat -> R),
  (forall i, (i < n)%nat -> 0 <= a i) -> (forall i, (i < n)%nat -> 0 <= b i) ->
  (forall i, (i < n)%nat -> b i = 0 -> a i = 0) ->
  xlog2 (sum n a) (sum n b) <= sum n (fun i => xlog2 (a i) (b i)).
Proof. exact LogSum.log_sum_inequality. Qed.

Theorem log_sum_equality : forall (n : nat) (a b : nat -> R),
  (forall i, (i < n)%nat -> 0 <= a i) -> (forall i, (i < n)%nat -> 0 <= b i) ->
  (forall i, (i < n)%nat -> b i = 0 -> a i = 0) ->
  sum n (fun i => xlog2 (a i) (b i)) = xlog2 (sum n a) (sum n b) <->
  (forall i, (i < n)%nat -> a i * sum n b = b i * sum n a).
Proof. exact LogSum.log_sum_equality. Qed.

Theorem log_sum_inequality_of_double_sums : forall (n m : nat) (a b : nat -> nat -> R),
  (forall i j, (i < n)%nat -> (j < m)%nat -> 0 <= a i j) ->
  (forall i j, (i < n)%nat -> (j < m)%nat -> 0 <= b i j) ->
  (forall i j, (i < n)%nat -> (j < m)%nat -> b i j = 0 -> a i j = 0) ->
  xlog2 (sum n (fun i => sum m (fun j => a i j))) (sum n (fun i => sum m (fun j => b i j)))
  <= sum n (fun i => sum m (fun j => xlog2 (a i j) (b i j))).
Proof. exact LogSum.log_sum_inequality_of_double_sums. Qed.

Theorem log_sum_equality_of_double_sums : forall (n m : nat) (a b : nat -> nat -> R),
  (forall i j, (i < n)%nat -> (j < m)%nat -> 0 <= a i j) ->
  (forall i j, (i < n)%nat -> (j < m)%nat -> 0 <= b i j) ->
  (forall i j, (i < n)%nat -> (j < m)%nat -> b i j = 0 -> a i j = 0) ->
  sum n (fun i => sum m (fun j => xlog2 (a i j) (b i j))) =
  xlog2 (sum n (fun i => sum m (fun j => a i j))) (sum n (fun i => sum m (fun j => b i j))) <->
  (forall i j, (i < n)%nat -> (j < m)%nat ->
     a i j * sum n (fun k => sum m (fun l => b k l)) = b i j * sum n (fun k => sum m (fun l => a k l))).
Proof. exact LogSum.log_sum_equality_of_double_sums. Qed.

Theorem log_sum_fails_for_negative_numbers : exists a b : nat -> R,
  (forall i, (i < 2)%nat -> 0 < a i / b i) /\ 0 < sum 2 a / sum 2 b /\
  sum 2 (fun i => xlog2 (a i) (b i)) < xlog2 (sum 2 a) (sum 2 b).
Proof. exact LogSum.log_sum_fails_for_negative_numbers. Qed.

(* ==== Appendix B: discontinuity meshing, eqs. (13) and (14) ==== *)

Theorem words_of_discontinuities : forall total area_j area_a f_a area_c f_c area_d f_d area_b area1 f1 area2 f2,
  information_term total area_j area1 f1 = area1 / total * xlog2 f1 (area_j / total) /\
  joined_form_factor area1 f1 area2 f2 = (area1 * f1 + area2 * f2) / (area1 + area2) /\
  gain_of_division total area_j area1 f1 area2 f2 =
    2 * (information_term total area_j area1 f1 + information_term total area_j area2 f2
         - information_term total area_j (area1 + area2) (joined_form_factor area1 f1 area2 f2)) /\
  gain_in_dark_part total area_j area_c f_c area_d area_b =
    gain_of_division total area_j (area_c + area_d) (joined_form_factor area_c f_c area_d 0) area_b 0 /\
  gain_in_lit_part total area_j area_a f_a area_d f_d area_c =
    gain_of_division total area_j area_a f_a (area_d + area_c) (joined_form_factor area_d f_d area_c 0) /\
  gain_of_discontinuity total area_j area_a f_a area_d f_d area_c =
    gain_of_division total area_j (area_a + area_d) (joined_form_factor area_a f_a area_d f_d) area_c 0 /\
  right_side_of_14 total area_j area_a f_a area_d f_d area_c =
    2 * (information_term total area_j area_a f_a
         + area_d / total * f_d * log2 (area_d * f_d / area_j * total / area_d)
         - information_term total area_j (area_a + (area_d + area_c))
             (joined_form_factor area_a f_a (area_d + area_c) (joined_form_factor area_d f_d area_c 0))).
Proof. easy. Qed.

Theorem dividing_unequal_parts_gains : forall total area_j area1 f1 area2 f2 : R,
  0 < total -> 0 < area_j -> 0 < area1 -> 0 < area2 -> 0 <= f1 -> 0 <= f2 -> f1 <> f2 ->
  information_term total area_j (area1 + area2) (joined_form_factor area1 f1 area2 f2) <
  information_term total area_j area1 f1 + information_term total area_j area2 f2.
Proof. exact TwoPartDivision.dividing_unequal_parts_gains. Qed.

(* B.1: one part all dark. Eq. (13), last line, with F_jc = A_c F_cj / A_j. *)
Theorem equation_13 : forall total area_j area_c form_factor_c area_d area_b,
  0 < total -> 0 < area_j -> 0 < area_c -> 0 <= area_d ->
  gain_of_division total area_j
    (area_c + area_d) (joined_form_factor area_c form_factor_c area_d 0) area_b 0
  = 2 * (area_c / total * form_factor_c
           * log2 (area_c * form_factor_c / area_j * total / (area_c + area_d))
         - information_term total area_j (area_c + area_d + area_b)
             (joined_form_factor (area_c + area_d) (joined_form_factor area_c form_factor_c area_d 0) area_b 0)).
Proof. exact DiscontinuityMeshing.equation_13. Qed.

Theorem gain_in_dark_part_is_flux_times_log_of_area :
  forall total area_j area_c form_factor_c area_d area_b,
  0 < total -> 0 < area_j -> 0 < area_c -> 0 < form_factor_c -> 0 <= area_d -> 0 <= area_b ->
  gain_in_dark_part total area_j area_c form_factor_c area_d area_b
  = 2 * (area_c * form_factor_c / total) * log2 ((area_c + area_d + area_b) / (area_c + area_d)).
Proof. exact DiscontinuityMeshing.gain_in_dark_part_is_flux_times_log_of_area. Qed.

Theorem gain_falls_with_dark_area : forall total area_j area_c form_factor_c dark area_d area_d',
  0 < total -> 0 < area_j -> 0 < area_c -> 0 < form_factor_c ->
  0 <= area_d -> area_d < area_d' -> area_d' <= dark ->
  gain_in_dark_part total area_j area_c form_factor_c area_d' (dark - area_d')
  < gain_in_dark_part total area_j area_c form_factor_c area_d (dark - area_d).
Proof. exact DiscontinuityMeshing.gain_falls_with_dark_area. Qed.

Theorem discontinuity_is_best_in_dark_part : forall total area_j area_c form_factor_c area_d area_b,
  0 < total -> 0 < area_j -> 0 < area_c -> 0 < form_factor_c -> 0 < area_d -> 0 <= area_b ->
  gain_in_dark_part total area_j area_c form_factor_c area_d area_b
  < gain_in_dark_part total area_j area_c form_factor_c 0 (area_d + area_b).
Proof. exact DiscontinuityMeshing.discontinuity_is_best_in_dark_part. Qed.

Theorem words_of_cuts_at_a_position : forall total area_j area flux last s t,
  form_factor_between area flux s t = (flux t - flux s) / (area t - area s) /\
  gain_of_cut total area_j area flux last t =
    gain_of_division total area_j (area t - area 0) (form_factor_between area flux 0 t)
      (area last - area t) (form_factor_between area flux t last).
Proof. easy. Qed.

Theorem gain_falls_beyond_discontinuity : forall total area_j area flux line last s t,
  0 < total -> 0 < area_j ->
  (forall a b, 0 <= a -> a < b -> b <= last -> area a < area b) ->
  0 < line -> flux 0 < flux line -> (forall b, line <= b -> b <= last -> flux b = flux line) ->
  line <= s -> s < t -> t <= last ->
  gain_of_cut total area_j area flux last t < gain_of_cut total area_j area flux last s.
Proof. exact DiscontinuityCuts.gain_falls_beyond_discontinuity. Qed.

(* B.2: one part all lit. The middle of (14), and its right side. *)
Theorem gain_in_lit_part_is_middle_of_14 : forall total area_j area_a f_a area_d f_d area_c,
  0 < total -> 0 < area_j -> 0 < area_d + area_c ->
  gain_in_lit_part total area_j area_a f_a area_d f_d area_c
  = 2 * (information_term total area_j area_a f_a
         + area_d / total * f_d * log2 (area_d * f_d / area_j * total / (area_d + area_c))
         - information_term total area_j (area_a + (area_d + area_c))
             (joined_form_factor area_a f_a (area_d + area_c) (joined_form_factor area_d f_d area_c 0))).
Proof. exact DiscontinuityMeshing.gain_in_lit_part_is_middle_of_14. Qed.

Theorem equation_14 : forall total area_j area_a form_factor_a area_d form_factor_d area_c,
  0 < total -> 0 < area_j -> 0 <= area_d -> 0 <= form_factor_d -> 0 <= area_c -> 0 < area_d + area_c ->
  gain_of_division total area_j
    area_a form_factor_a (area_d + area_c) (joined_form_factor area_d form_factor_d area_c 0)
  <= 2 * (information_term total area_j area_a form_factor_a
          + area_d / total * form_factor_d * log2 (area_d * form_factor_d / area_j * total / area_d)
          - information_term total area_j (area_a + (area_d + area_c))
              (joined_form_factor area_a form_factor_a
                 (area_d + area_c) (joined_form_factor area_d form_factor_d area_c 0))).
Proof. exact DiscontinuityMeshing.equation_14. Qed.

Theorem equation_14_strict : forall total area_j area_a form_factor_a area_d form_factor_d area_c,
  0 < total -> 0 < area_j -> 0 < area_d -> 0 < form_factor_d -> 0 < area_c ->
  gain_in_lit_part total area_j area_a form_factor_a area_d form_factor_d area_c
  < right_side_of_14 total area_j area_a form_factor_a area_d form_factor_d area_c.
Proof. exact DiscontinuityMeshing.equation_14_strict. Qed.

Theorem right_side_of_14_is_gain_of_discontinuity :
  forall total area_j area_a area_d form_factor area_c,
  0 < total -> 0 < area_j -> 0 < area_a -> 0 < area_d -> 0 <= area_c ->
  right_side_of_14 total area_j area_a form_factor area_d form_factor area_c
  = gain_of_division total area_j
      (area_a + area_d) (joined_form_factor area_a form_factor area_d form_factor) area_c 0.
Proof. exact DiscontinuityMeshing.right_side_of_14_is_gain_of_discontinuity. Qed.

Theorem discontinuity_is_best_in_lit_part : forall total area_j area_a area_d form_factor area_c,
  0 < total -> 0 < area_j -> 0 < area_a -> 0 < area_d -> 0 < form_factor -> 0 < area_c ->
  gain_in_lit_part total area_j area_a form_factor area_d form_factor area_c
  < gain_of_discontinuity total area_j area_a form_factor area_d form_factor area_c.
Proof. exact DiscontinuityMeshing.discontinuity_is_best_in_lit_part. Qed.

Theorem gain_rises_up_to_discontinuity : forall total area_j area flux line last form_factor s t,
  0 < total -> 0 < area_j ->
  (forall a b, 0 <= a -> a < b -> b <= last -> area a < area b) ->
  line < last -> 0 < form_factor ->
  (forall b, 0 <= b -> b <= line -> flux b - flux 0 = form_factor * (area b - area 0)) ->
  (forall b, line <= b -> b <= last -> flux b = flux line) ->
  0 <= s -> s < t -> t <= line ->
  gain_of_cut total area_j area flux last s < gain_of_cut total area_j area flux last t.
Proof. exact DiscontinuityCuts.gain_rises_up_to_discontinuity. Qed.

(* Form factors that differ: the hypothesis of B.2 is needed. *)
Theorem right_side_of_14_exceeds_discontinuity_if_form_factors_differ :
  forall total area_j area_a form_factor_a area_d form_factor_d area_c,
  0 < total -> 0 < area_j -> 0 < area_a -> 0 < area_d -> 0 <= area_c ->
  0 <= form_factor_a -> 0 <= form_factor_d -> form_factor_a <> form_factor_d ->
  gain_of_discontinuity total area_j area_a form_factor_a area_d form_factor_d area_c
  < right_side_of_14 total area_j area_a form_factor_a area_d form_factor_d area_c.
Proof. exact DiscontinuityMeshing.right_side_of_14_exceeds_discontinuity_if_form_factors_differ. Qed.

Theorem discontinuity_is_not_best_if_form_factors_differ :
  gain_of_discontinuity 32 16 1 (7/8) 7 (1/56) 8 < gain_in_lit_part 32 16 1 (7/8) 7 (1/56) 8.
Proof. exact DiscontinuityMeshing.discontinuity_is_not_best_if_form_factors_differ. Qed.

(* B.1 and B.2 together. *)
Theorem discontinuity_is_the_only_best_cut : forall total area_j area flux line last form_factor t,
  0 < total -> 0 < area_j ->
  (forall a b, 0 <= a -> a < b -> b <= last -> area a < area b) ->
  0 < line -> line < last -> 0 < form_factor ->
  (forall b, 0 <= b -> b <= line -> flux b - flux 0 = form_factor * (area b - area 0)) ->
  (forall b, line <= b -> b <= last -> flux b = flux line) ->
  0 <= t -> t <= last -> t <> line ->
  gain_of_cut total area_j area flux last t < gain_of_cut total area_j area flux last line.
Proof. exact DiscontinuityCuts.discontinuity_is_the_only_best_cut. Qed.

(* Any division into two parts, each with a lit and a dark area. *)
Theorem discontinuity_is_best_of_all_divisions :
  forall total area_j form_factor lit1 dark1 lit2 dark2,
  0 < total -> 0 < area_j -> 0 < form_factor ->
  0 <= lit1 -> 0 <= dark1 -> 0 <= lit2 -> 0 <= dark2 -> 0 < lit1 + dark1 -> 0 < lit2 + dark2 -> 0 < lit1 + lit2 ->
  gain_of_division total area_j
    (lit1 + dark1) (joined_form_factor lit1 form_factor dark1 0)
    (lit2 + dark2) (joined_form_factor lit2 form_factor dark2 0)
  <= gain_of_division total area_j (lit1 + lit2) form_factor (dark1 + dark2) 0 /\
  ((0 < lit1 /\ 0 < dark1) \/ (0 < lit2 /\ 0 < dark2) ->
   gain_of_division total area_j
     (lit1 + dark1) (joined_form_factor lit1 form_factor dark1 0)
     (lit2 + dark2) (joined_form_factor lit2 form_factor dark2 0)
   < gain_of_division total area_j (lit1 + lit2) form_factor (dark1 + dark2) 0).
Proof. exact AnyDivision.discontinuity_is_best_of_all_divisions. Qed.
