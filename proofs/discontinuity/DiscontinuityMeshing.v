(* Appendix B of the paper: of the divisions of a partly occluded patch, the one along the discontinuity between light
   and dark gains the most mutual information: always when one part is all dark (B.1, eq. 13), and when one part is all
   lit (B.2, eq. 14) if the form factor is the same all over the lit part. Both are strict. *)
From Coq Require Import Reals Lra.
From Infoscene Require Import Information LogSum TwoPartDivision.
Open Scope R_scope.

(* B.1. Part a = c + d of patch i has a lit part c and a dark part d; part b is all dark. *)
Definition gain_in_dark_part (total area_j area_c form_factor_c area_d area_b : R) : R :=
  gain_of_division total area_j
    (area_c + area_d) (joined_form_factor area_c form_factor_c area_d 0)
    area_b 0.

(* B.2. Part a is all lit; part b = d + c has a lit part d and a dark part c. *)
Definition gain_in_lit_part (total area_j area_a form_factor_a area_d form_factor_d area_c : R) : R :=
  gain_of_division total area_j
    area_a form_factor_a
    (area_d + area_c) (joined_form_factor area_d form_factor_d area_c 0).

(* The division along the discontinuity: the lit part a + d, and the dark part c. *)
Definition gain_of_discontinuity (total area_j area_a form_factor_a area_d form_factor_d area_c : R) : R :=
  gain_of_division total area_j
    (area_a + area_d) (joined_form_factor area_a form_factor_a area_d form_factor_d)
    area_c 0.

(* The right side of (14), with F_jd = A_d F_dj / A_j; A_T need not be 1. *)
Definition right_side_of_14 (total area_j area_a form_factor_a area_d form_factor_d area_c : R) : R :=
  2 * (information_term total area_j area_a form_factor_a
       + area_d / total * form_factor_d * log2 (area_d * form_factor_d / area_j * total / area_d)
       - information_term total area_j (area_a + (area_d + area_c))
           (joined_form_factor area_a form_factor_a
              (area_d + area_c) (joined_form_factor area_d form_factor_d area_c 0))).

Lemma joined_with_dark : forall a f d, 0 < a + d -> (a + d) * joined_form_factor a f d 0 = a * f.
Proof. intros. unfold joined_form_factor. field. lra. Qed.

(* A part of which only the area [lit] sends light: its term, by its flux lit * f. *)
Lemma term_of_partly_dark : forall total area_j lit f dark,
  0 < total -> 0 < area_j -> 0 < lit + dark ->
  information_term total area_j (lit + dark) (joined_form_factor lit f dark 0)
  = lit / total * f * log2 (lit * f / area_j * total / (lit + dark)).
Proof.
  intros total aj l f d HT Hj H. rewrite information_term_by_flux, joined_with_dark, xlog2_is_product by assumption.
  replace (l * f / ((l + d) * (aj / total))) with (l * f / aj * total / (l + d)) by (field; lra).
  field. lra.
Qed.

(* ---- B.1 ---- *)

(* The last line of (13), for any A_T, with F_jc = A_c F_cj / A_j. *)
Theorem equation_13 : forall total area_j area_c form_factor_c area_d area_b,
  0 < total -> 0 < area_j -> 0 < area_c -> 0 <= area_d ->
  gain_in_dark_part total area_j area_c form_factor_c area_d area_b
  = 2 * (area_c / total * form_factor_c
           * log2 (area_c * form_factor_c / area_j * total / (area_c + area_d))
         - information_term total area_j (area_c + area_d + area_b)
             (joined_form_factor (area_c + area_d) (joined_form_factor area_c form_factor_c area_d 0) area_b 0)).
Proof.
  intros. unfold gain_in_dark_part, gain_of_division. rewrite information_term_dark.
  rewrite (term_of_partly_dark total area_j area_c) by lra. ring.
Qed.

(* The same in closed form: twice the flux, times the logarithm of the whole area over the area of a. *)
Theorem gain_in_dark_part_is_flux_times_log_of_area : forall total area_j area_c form_factor_c area_d area_b,
  0 < total -> 0 < area_j -> 0 < area_c -> 0 < form_factor_c -> 0 <= area_d -> 0 <= area_b ->
  gain_in_dark_part total area_j area_c form_factor_c area_d area_b
  = 2 * (area_c * form_factor_c / total) * log2 ((area_c + area_d + area_b) / (area_c + area_d)).
Proof.
  intros total aj ac f ad ab HT Hj Hc Hf Hd Hb. rewrite equation_13 by assumption.
  replace (joined_form_factor (ac + ad) (joined_form_factor ac f ad 0) ab 0)
    with (joined_form_factor ac f (ad + ab) 0) by (unfold joined_form_factor; field; lra).
  replace (ac + ad + ab) with (ac + (ad + ab)) by ring.
  rewrite term_of_partly_dark by lra.
  assert (Hx : 0 < ac * f / aj * total) by (repeat apply Rmult_lt_0_compat; try assumption; now apply Rinv_0_lt_compat).
  rewrite !log2_div by lra. field. lra.
Qed.

(* A larger a has a smaller logarithm: the gain falls strictly as dark area moves from b to a. *)
Theorem gain_falls_with_dark_area : forall total area_j area_c form_factor_c dark area_d area_d',
  0 < total -> 0 < area_j -> 0 < area_c -> 0 < form_factor_c ->
  0 <= area_d -> area_d < area_d' -> area_d' <= dark ->
  gain_in_dark_part total area_j area_c form_factor_c area_d' (dark - area_d')
  < gain_in_dark_part total area_j area_c form_factor_c area_d (dark - area_d).
Proof.
  intros total aj ac f dark d d' HT Hj Hc Hf Hd Hdd Hd'.
  rewrite !gain_in_dark_part_is_flux_times_log_of_area by lra.
  apply Rmult_lt_compat_l.
  - repeat apply Rmult_lt_0_compat; try lra. now apply Rinv_0_lt_compat.
  - replace (ac + d + (dark - d)) with (ac + dark) by ring.
    replace (ac + d' + (dark - d')) with (ac + dark) by ring.
    apply log2_increasing; [apply Rdiv_lt_0_compat; lra |].
    apply Rmult_lt_compat_l; [lra |]. apply Rinv_lt_contravar; [| lra].
    apply Rmult_lt_0_compat; lra.
Qed.

(* Hence A_d = 0, the cut along the discontinuity, is the only best of the divisions with an all dark part. *)
Theorem discontinuity_is_best_in_dark_part : forall total area_j area_c form_factor_c area_d area_b,
  0 < total -> 0 < area_j -> 0 < area_c -> 0 < form_factor_c -> 0 < area_d -> 0 <= area_b ->
  gain_in_dark_part total area_j area_c form_factor_c area_d area_b
  < gain_in_dark_part total area_j area_c form_factor_c 0 (area_d + area_b).
Proof.
  intros total aj ac f d b HT Hj Hc Hf Hd Hb.
  pose proof (gain_falls_with_dark_area total aj ac f (d + b) 0 d) as H.
  replace (d + b - d) with b in H by ring. replace (d + b - 0) with (d + b) in H by ring.
  apply H; lra.
Qed.

(* ---- B.2 ---- *)

(* The middle of (14): the gain, with the flux of the lit part d spread over all of b. *)
Theorem gain_in_lit_part_is_middle_of_14 : forall total area_j area_a f_a area_d f_d area_c,
  0 < total -> 0 < area_j -> 0 < area_d + area_c ->
  gain_in_lit_part total area_j area_a f_a area_d f_d area_c
  = 2 * (information_term total area_j area_a f_a
         + area_d / total * f_d * log2 (area_d * f_d / area_j * total / (area_d + area_c))
         - information_term total area_j (area_a + (area_d + area_c))
             (joined_form_factor area_a f_a (area_d + area_c) (joined_form_factor area_d f_d area_c 0))).
Proof.
  intros. unfold gain_in_lit_part, gain_of_division.
  rewrite (term_of_partly_dark total area_j area_d) by assumption. reflexivity.
Qed.

(* (14): adding the dark area A_c to the divisor lowers the logarithm, strictly if there is dark area and flux. *)
Theorem equation_14_strict : forall total area_j area_a form_factor_a area_d form_factor_d area_c,
  0 < total -> 0 < area_j -> 0 < area_d -> 0 < form_factor_d -> 0 < area_c ->
  gain_in_lit_part total area_j area_a form_factor_a area_d form_factor_d area_c
  < right_side_of_14 total area_j area_a form_factor_a area_d form_factor_d area_c.
Proof.
  intros total aj a fa d fd c HT Hj Hd Hf Hc. rewrite gain_in_lit_part_is_middle_of_14 by lra. unfold right_side_of_14.
  apply Rmult_lt_compat_l; [lra |]. apply Rplus_lt_compat_r, Rplus_lt_compat_l, Rmult_lt_compat_l.
  - repeat apply Rmult_lt_0_compat; try assumption. now apply Rinv_0_lt_compat.
  - assert (0 < d * fd / aj * total)
      by (repeat apply Rmult_lt_0_compat; try assumption; now apply Rinv_0_lt_compat).
    apply log2_increasing; [apply Rdiv_lt_0_compat; lra |].
    apply Rmult_lt_compat_l; [assumption |]. apply Rinv_lt_contravar; [| lra]. apply Rmult_lt_0_compat; lra.
Qed.

Theorem equation_14 : forall total area_j area_a form_factor_a area_d form_factor_d area_c,
  0 < total -> 0 < area_j -> 0 <= area_d -> 0 <= form_factor_d -> 0 <= area_c -> 0 < area_d + area_c ->
  gain_in_lit_part total area_j area_a form_factor_a area_d form_factor_d area_c
  <= right_side_of_14 total area_j area_a form_factor_a area_d form_factor_d area_c.
Proof.
  intros total aj a fa d fd c HT Hj Hd Hf Hc Hdc.
  destruct (Req_dec d 0) as [-> |], (Req_dec fd 0) as [-> |], (Req_dec c 0) as [-> |];
    try (left; apply equation_14_strict; lra);
    rewrite gain_in_lit_part_is_middle_of_14 by lra; unfold right_side_of_14; right;
    rewrite ?Rplus_0_r; unfold Rdiv; ring.
Qed.

Lemma right_side_of_14_by_terms : forall total area_j area_a f_a area_d f_d area_c,
  0 < total -> 0 < area_j -> 0 < area_d ->
  right_side_of_14 total area_j area_a f_a area_d f_d area_c
  = 2 * (information_term total area_j area_a f_a + information_term total area_j area_d f_d
         - information_term total area_j (area_a + (area_d + area_c))
             (joined_form_factor area_a f_a (area_d + area_c) (joined_form_factor area_d f_d area_c 0))).
Proof.
  intros total aj a fa d fd c HT Hj Hd. unfold right_side_of_14. do 2 f_equal. f_equal.
  unfold information_term. rewrite xlog2_is_product.
  replace (d * fd / aj * total / d) with (fd / (aj / total)) by (field; lra). ring.
Qed.

Lemma gain_of_discontinuity_by_terms : forall total area_j area_a f_a area_d f_d area_c,
  0 < area_a -> 0 < area_d -> 0 <= area_c ->
  gain_of_discontinuity total area_j area_a f_a area_d f_d area_c
  = 2 * (information_term total area_j (area_a + area_d) (joined_form_factor area_a f_a area_d f_d)
         - information_term total area_j (area_a + (area_d + area_c))
             (joined_form_factor area_a f_a (area_d + area_c) (joined_form_factor area_d f_d area_c 0))).
Proof.
  intros total aj a fa d fd c Ha Hd Hc. unfold gain_of_discontinuity, gain_of_division.
  rewrite information_term_dark.
  replace (joined_form_factor (a + d) (joined_form_factor a fa d fd) c 0)
    with (joined_form_factor a fa (d + c) (joined_form_factor d fd c 0)) by (unfold joined_form_factor; field; lra).
  replace (a + d + c) with (a + (d + c)) by ring. ring.
Qed.

(* The paper's hypothesis F_aj = F_dj: cutting the lit part gains nothing, so the right side is the gain of the
   discontinuity. *)
Theorem right_side_of_14_is_gain_of_discontinuity : forall total area_j area_a area_d form_factor area_c,
  0 < total -> 0 < area_j -> 0 < area_a -> 0 < area_d -> 0 <= area_c ->
  right_side_of_14 total area_j area_a form_factor area_d form_factor area_c
  = gain_of_discontinuity total area_j area_a form_factor area_d form_factor area_c.
Proof.
  intros total aj a d f c HT Hj Ha Hd Hc.
  rewrite right_side_of_14_by_terms, gain_of_discontinuity_by_terms by assumption.
  rewrite (joined_equal a d) by lra.
  rewrite (dividing_equal_parts_gains_nothing total aj a d f). ring.
Qed.

Theorem discontinuity_is_best_in_lit_part : forall total area_j area_a area_d form_factor area_c,
  0 < total -> 0 < area_j -> 0 < area_a -> 0 < area_d -> 0 < form_factor -> 0 < area_c ->
  gain_in_lit_part total area_j area_a form_factor area_d form_factor area_c
  < gain_of_discontinuity total area_j area_a form_factor area_d form_factor area_c.
Proof.
  intros. rewrite <- right_side_of_14_is_gain_of_discontinuity by lra. apply equation_14_strict; assumption.
Qed.

(* Negative control. Without that hypothesis the right side is always above the discontinuity's gain (by what a cut of
   the lit part would gain) ... *)
Theorem right_side_of_14_exceeds_discontinuity_if_form_factors_differ :
  forall total area_j area_a form_factor_a area_d form_factor_d area_c,
  0 < total -> 0 < area_j -> 0 < area_a -> 0 < area_d -> 0 <= area_c ->
  0 <= form_factor_a -> 0 <= form_factor_d -> form_factor_a <> form_factor_d ->
  gain_of_discontinuity total area_j area_a form_factor_a area_d form_factor_d area_c
  < right_side_of_14 total area_j area_a form_factor_a area_d form_factor_d area_c.
Proof.
  intros total aj a fa d fd c HT Hj Ha Hd Hc Hfa Hfd Hne.
  rewrite right_side_of_14_by_terms, gain_of_discontinuity_by_terms by assumption.
  pose proof (dividing_unequal_parts_gains total aj a fa d fd HT Hj Ha Hd Hfa Hfd Hne). lra.
Qed.

(* ... and a cut in the lit part can gain more than the discontinuity: areas 1, 7 and 8, form factors 7/8 and 1/56. *)
Theorem discontinuity_is_not_best_if_form_factors_differ :
  gain_of_discontinuity 32 16 1 (7/8) 7 (1/56) 8 < gain_in_lit_part 32 16 1 (7/8) 7 (1/56) 8.
Proof.
  rewrite gain_of_discontinuity_by_terms, gain_in_lit_part_is_middle_of_14 by lra.
  apply Rmult_lt_compat_l; [lra |]. apply Rplus_lt_compat_r.
  unfold information_term. rewrite !xlog2_is_product. unfold joined_form_factor.
  replace ((1 * (7 / 8) + 7 * (1 / 56)) / (1 + 7) / (16 / 32)) with (/ 2 * / 2) by field.
  replace (7 / 8 / (16 / 32)) with (7 / 4) by field.
  replace (7 * (1 / 56) / 16 * 32 / (7 + 8)) with (1 / 60) by field.
  assert (H7 : log2 1 < log2 (7 / 4)) by (apply log2_increasing; lra).
  assert (H60 : log2 (/ 2 * / 2 * (/ 2 * / 2) * (/ 2 * / 2)) < log2 (1 / 60)) by (apply log2_increasing; lra).
  assert (H2 : log2 (/ 2) = -1).
  { replace (/ 2) with (1 / 2) by field. rewrite log2_div, log2_1, log2_2; lra. }
  rewrite log2_1 in H7. rewrite !log2_mult, H2 in H60 by lra. rewrite log2_mult, H2 by lra.
  lra.
Qed.
