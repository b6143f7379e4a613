(* Control for "discrete mutual information is always lower than the continuous one" (section 2): the inside of a sphere. Its
   point-to-point form factor is constant, and with a constant form factor both are 0, for any division into patches. *)
From Coq Require Import Reals Lra Lia.
From Infoscene Require Import Sums Information FiniteSums Refinement IntegralChain.
Open Scope R_scope.

(* x and y on a sphere of radius r about the origin; the normals point inwards. With d the distance, both cosines are
   d / (2 r), as (x - y) . x = r^2 - x . y = d^2 / 2. *)
Theorem form_factor_inside_a_sphere_is_constant : forall r x1 x2 x3 y1 y2 y3 : R, 0 < r ->
  x1 ^ 2 + x2 ^ 2 + x3 ^ 2 = r ^ 2 -> y1 ^ 2 + y2 ^ 2 + y3 ^ 2 = r ^ 2 ->
  let d := sqrt ((y1 - x1) ^ 2 + (y2 - x2) ^ 2 + (y3 - x3) ^ 2) in
  let cosine_x := ((y1 - x1) * (- x1 / r) + (y2 - x2) * (- x2 / r) + (y3 - x3) * (- x3 / r)) / d in
  let cosine_y := ((x1 - y1) * (- y1 / r) + (x2 - y2) * (- y2 / r) + (x3 - y3) * (- y3 / r)) / d in
  0 < d -> cosine_x * cosine_y / (PI * d ^ 2) = 1 / (4 * PI * r ^ 2).
Proof.
  intros r x1 x2 x3 y1 y2 y3 Hr Hx Hy d cosine_x cosine_y Hd.
  assert (D : d ^ 2 = (y1 - x1) ^ 2 + (y2 - x2) ^ 2 + (y3 - x3) ^ 2).
  { unfold d. rewrite pow2_sqrt; [reflexivity|]. repeat apply Rplus_le_le_0_compat; apply pow2_ge_0. }
  assert (Cx : cosine_x = d / (2 * r)).
  { unfold cosine_x. replace ((y1 - x1) * (- x1 / r) + (y2 - x2) * (- x2 / r) + (y3 - x3) * (- x3 / r))
      with (d ^ 2 / (2 * r)); [field; lra|].
    apply (Rmult_eq_reg_r (2 * r)); [|lra]. field_simplify; [|lra|lra]. rewrite D. nra. }
  assert (Cy : cosine_y = d / (2 * r)).
  { unfold cosine_y. replace ((x1 - y1) * (- y1 / r) + (x2 - y2) * (- y2 / r) + (x3 - y3) * (- y3 / r))
      with (d ^ 2 / (2 * r)); [field; lra|].
    apply (Rmult_eq_reg_r (2 * r)); [|lra]. field_simplify; [|lra|lra]. rewrite D. nra. }
  rewrite Cx, Cy. pose proof PI_RGT_0. field. repeat split; lra.
Qed.

(* Each F_ij is A_j / A_T = w_j, so every logarithm of (3) is 0; and so is that of (4). *)
Theorem constant_form_factor_loses_nothing :
  forall (point : Type) n (over : nat -> (point -> R) -> R) integrable,
  integrals point n over integrable -> integrable (fun _ => 1) ->
  (forall i, (i < n)%nat -> 0 < over i (fun _ => 1)) -> (0 < n)%nat ->
  let area := fun i => over i (fun _ => 1) in
  let total := sum n area in
  mutual_information n (fun i => area i / total) (fun i j => over i (fun x => over j (fun y => 1 / total)) / area i) = 0 /\
  sum n (fun i => sum n (fun j =>
    over i (fun x => over j (fun y => 1 / total * (1 / total) * log2 (total * (1 / total)))))) = 0.
Proof.
  intros point n over integrable rules I1 HA Hn area total.
  assert (T : 0 < total).
  { apply Rlt_le_trans with (area 0%nat); [now apply HA|].
    unfold total. apply (term_le_sum n area); [|exact Hn]. intros i Hi. left. now apply HA. }
  assert (K : forall i c, (i < n)%nat -> over i (fun _ => c) = c * area i).
  { intros i c Hi. destruct (integral_of_multiple _ _ _ _ rules i c _ Hi I1) as [J E]. unfold area. rewrite <- E.
    symmetry. apply (integral_of_equals _ _ _ _ rules i); [exact Hi| |exact J]. intros. ring. }
  split.
  - apply sum_zero. intros i Hi. apply sum_zero. intros j Hj. assert (Ai := HA i Hi). assert (Aj := HA j Hj).
    fold (area i) in Ai. fold (area j) in Aj. rewrite (K j) by exact Hj. rewrite (K i) by exact Hi.
    replace (1 / total * area j * area i / area i) with (area j / total) by (field; lra).
    assert (0 < area j / total) by now apply Rdiv_lt_0_compat.
    rewrite xlog2_nonzero by lra. replace (area j / total / (area j / total)) with 1 by (field; lra). rewrite log2_1. ring.
  - apply sum_zero. intros i Hi. apply sum_zero. intros j Hj. rewrite (K j) by exact Hj. rewrite (K i) by exact Hi.
    replace (total * (1 / total)) with 1 by (field; lra). rewrite log2_1. ring.
Qed.
