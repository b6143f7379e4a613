(* Section 4.1 and appendix B for any division into two parts, each with a lit and a dark area of any size and outline: where
   the lit area is uniform, none gains more than the division along the discontinuity, and only that one gains as much. *)
From Coq Require Import Reals Lra.
From Infoscene Require Import Sums Information TwoPartDivision DiscontinuityMeshing.
Open Scope R_scope.

(* Dark area in a part lowers its term: the flux stays, the area it is spread over grows. *)
Lemma dark_area_lowers_term : forall total area_j lit form_factor dark,
  0 < total -> 0 < area_j -> 0 <= lit -> 0 < form_factor -> 0 <= dark -> 0 < lit + dark ->
  information_term total area_j (lit + dark) (joined_form_factor lit form_factor dark 0)
  <= information_term total area_j lit form_factor /\
  (0 < lit -> 0 < dark ->
   information_term total area_j (lit + dark) (joined_form_factor lit form_factor dark 0)
   < information_term total area_j lit form_factor).
Proof.
  intros total aj l f d HT Hj Hl Hf Hd H. rewrite term_of_partly_dark by assumption.
  destruct (Req_dec l 0) as [->|N].
  { rewrite information_term_of_nothing. split; [right; unfold Rdiv; ring|lra]. }
  assert (P : 0 < l) by lra.
  replace (information_term total aj l f) with (l / total * f * log2 (l * f / aj * total / l)).
  - assert (Q : 0 < l / total * f) by (apply Rmult_lt_0_compat; [now apply Rdiv_lt_0_compat|assumption]).
    assert (X : 0 < l * f / aj * total) by (repeat apply Rmult_lt_0_compat; try assumption; now apply Rinv_0_lt_compat).
    rewrite !log2_div by lra. split.
    + apply Rmult_le_compat_l; [lra|]. assert (log2 l <= log2 (l + d)) by (apply log2_le; lra). lra.
    + intros _ Hd'. apply Rmult_lt_compat_l; [lra|]. assert (log2 l < log2 (l + d)) by (apply log2_increasing; lra). lra.
  - replace (information_term total aj l f) with (information_term total aj (l + 0) (joined_form_factor l f 0 0)).
    + rewrite term_of_partly_dark by lra. now rewrite Rplus_0_r.
    + unfold joined_form_factor. replace (l + 0) with l by ring. f_equal. field. lra.
Qed.

(* Two parts with lit areas a1, a2 and dark areas d1, d2, in either of which anything may be missing. *)
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
Proof.
  intros total aj f l1 d1 l2 d2 HT Hj Hf H1 D1 H2 D2 P1 P2 PL. unfold gain_of_division.
  replace (l1 + d1 + (l2 + d2)) with (l1 + l2 + (d1 + d2)) by ring.
  replace (joined_form_factor (l1 + d1) (joined_form_factor l1 f d1 0) (l2 + d2) (joined_form_factor l2 f d2 0))
    with (joined_form_factor (l1 + l2) f (d1 + d2) 0) by (unfold joined_form_factor; field; lra).
  rewrite information_term_dark, (dividing_equal_parts_gains_nothing total aj l1 l2 f).
  destruct (dark_area_lowers_term total aj l1 f d1) as [L1 S1]; try assumption.
  destruct (dark_area_lowers_term total aj l2 f d2) as [L2 S2]; try assumption.
  split; [lra|]. intros [[A B]|[A B]]; [specialize (S1 A B)|specialize (S2 A B)]; lra.
Qed.
