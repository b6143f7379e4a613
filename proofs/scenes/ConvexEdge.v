(* Section 2, convergence: near a convex edge two faces and a third point face each other, so that the three close a walk of odd
   length (OddWalks.v) where nothing stands between them. The edge passes through the origin; the faces have the inner normals n
   and m there, and the third point, z with the inner normal r, faces the origin from inside the wedge. *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

(* Point p with the normal n has point q in front of it. *)
Definition has_in_front (p1 p2 p3 n1 n2 n3 q1 q2 q3 : R) : Prop :=
  0 < (q1 - p1) * n1 + (q2 - p2) * n2 + (q3 - p3) * n3.

(* x lies on the first face and y on the second, each in front of the other face; drawn towards the edge by a factor t, they
   and z have each other in front. *)
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
Proof.
  intros n1 n2 n3 m1 m2 m3 r1 r2 r3 x1 x2 x3 y1 y2 y3 z1 z2 z3 Xn Xm Ym Yn Zn Zm Zr. unfold has_in_front in *.
  set (c := (0 - z1) * r1 + (0 - z2) * r2 + (0 - z3) * r3) in *.
  set (a := x1 * r1 + x2 * r2 + x3 * r3). set (b := y1 * r1 + y2 * r2 + y3 * r3).
  assert (S : 0 < Rabs a + Rabs b + 1) by (pose proof (Rabs_pos a); pose proof (Rabs_pos b); lra).
  exists (c / (2 * (Rabs a + Rabs b + 1))). split; [apply Rdiv_lt_0_compat; lra|]. intros t [Ht Hn].
  assert (K : t * (Rabs a + Rabs b + 1) <= c / 2).
  { apply (Rmult_le_compat_r (Rabs a + Rabs b + 1)) in Hn; [|lra].
    replace (c / (2 * (Rabs a + Rabs b + 1)) * (Rabs a + Rabs b + 1)) with (c / 2) in Hn by (field; lra). exact Hn. }
  assert (B : forall u, Rabs u <= Rabs a + Rabs b + 1 -> 0 < t * u + c).
  { intros u Hu. assert (- Rabs u <= u) by (pose proof (Rle_abs (- u)) as L; rewrite Rabs_Ropp in L; lra).
    assert (t * (- (Rabs a + Rabs b + 1)) <= t * u) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Ba := B a ltac:(pose proof (Rabs_pos b); lra)). assert (Bb := B b ltac:(pose proof (Rabs_pos a); lra)).
  assert (Q1 := Rmult_lt_0_compat _ _ Ht Yn). assert (Q2 := Rmult_lt_0_compat _ _ Ht Xm).
  assert (E1 : t * (x1 * n1 + x2 * n2 + x3 * n3) = 0) by (rewrite Xn; ring).
  assert (E2 : t * (y1 * m1 + y2 * m2 + y3 * m3) = 0) by (rewrite Ym; ring).
  unfold a, b, c in *. repeat split; lra.
Qed.

(* Control: at an edge that is not convex no point of one face has one of the other in front. *)
Theorem points_at_another_edge_do_not_face_each_other : forall n1 n2 n3 x1 x2 x3 y1 y2 y3,
  x1 * n1 + x2 * n2 + x3 * n3 = 0 -> y1 * n1 + y2 * n2 + y3 * n3 <= 0 -> ~ has_in_front x1 x2 x3 n1 n2 n3 y1 y2 y3.
Proof. intros. unfold has_in_front. lra. Qed.
