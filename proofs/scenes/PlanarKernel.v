(* Section 2, "always lower": between planar patches the point-to-point form factor is never constant where the two see each
   other, so that the sphere (Sphere.v) is an exception. Along a line in the plane of x the squared distance is a quadratic
   polynomial and the product of the cosines' numerators at most a linear one: were the form factor the same at five equidistant
   points, a polynomial of degree 4 would be linear there. *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

(* F(x, y) for points x and y with normals n and m that see each other: the product of the two cosines over pi times the
   squared distance. *)
Definition point_form_factor (x1 x2 x3 n1 n2 n3 y1 y2 y3 m1 m2 m3 : R) : R :=
  ((y1 - x1) * n1 + (y2 - x2) * n2 + (y3 - x3) * n3) * ((x1 - y1) * m1 + (x2 - y2) * m2 + (x3 - y3) * m3)
  / (PI * ((y1 - x1) ^ 2 + (y2 - x2) ^ 2 + (y3 - x3) ^ 2) ^ 2).

Theorem form_factor_of_a_planar_patch_is_not_constant :
  forall x1 x2 x3 n1 n2 n3 y1 y2 y3 m1 m2 m3 s1 s2 s3 c,
  s1 * n1 + s2 * n2 + s3 * n3 = 0 -> 0 < s1 ^ 2 + s2 ^ 2 + s3 ^ 2 ->
  (forall k, k = 0 \/ k = 1 \/ k = 2 \/ k = 3 \/ k = 4 ->
     point_form_factor (x1 + k * s1) (x2 + k * s2) (x3 + k * s3) n1 n2 n3 y1 y2 y3 m1 m2 m3 = c) ->
  c = 0.
Proof.
  intros x1 x2 x3 n1 n2 n3 y1 y2 y3 m1 m2 m3 s1 s2 s3 c Hs HD H.
  destruct (Req_dec c 0) as [|Hc]; [assumption|exfalso].
  set (h := (y1 - x1) * n1 + (y2 - x2) * n2 + (y3 - x3) * n3).
  set (L := (x1 - y1) * m1 + (x2 - y2) * m2 + (x3 - y3) * m3).
  set (b := s1 * m1 + s2 * m2 + s3 * m3).
  set (A := (y1 - x1) ^ 2 + (y2 - x2) ^ 2 + (y3 - x3) ^ 2).
  set (B := -2 * ((y1 - x1) * s1 + (y2 - x2) * s2 + (y3 - x3) * s3)).
  set (D := s1 ^ 2 + s2 ^ 2 + s3 ^ 2) in *.
  assert (P := PI_RGT_0).
  assert (E : forall k, k = 0 \/ k = 1 \/ k = 2 \/ k = 3 \/ k = 4 ->
    h * (L + k * b) = c * PI * (A + k * B + k ^ 2 * D) ^ 2).
  { intros k Hk. specialize (H k Hk). unfold point_form_factor in H.
    replace ((y1 - (x1 + k * s1)) * n1 + (y2 - (x2 + k * s2)) * n2 + (y3 - (x3 + k * s3)) * n3) with h in H
      by (unfold h; replace ((y1 - (x1 + k * s1)) * n1 + (y2 - (x2 + k * s2)) * n2 + (y3 - (x3 + k * s3)) * n3)
        with ((y1 - x1) * n1 + (y2 - x2) * n2 + (y3 - x3) * n3 - k * (s1 * n1 + s2 * n2 + s3 * n3)) by ring; rewrite Hs; ring).
    replace ((x1 + k * s1 - y1) * m1 + (x2 + k * s2 - y2) * m2 + (x3 + k * s3 - y3) * m3) with (L + k * b) in H
      by (unfold L, b; ring).
    replace ((y1 - (x1 + k * s1)) ^ 2 + (y2 - (x2 + k * s2)) ^ 2 + (y3 - (x3 + k * s3)) ^ 2) with (A + k * B + k ^ 2 * D) in H
      by (unfold A, B, D; ring).
    set (q := A + k * B + k ^ 2 * D) in *.
    destruct (Req_dec q 0) as [Z|N].
    - exfalso. apply Hc. rewrite <- H, Z. unfold Rdiv. replace (PI * 0 ^ 2) with 0 by ring. rewrite Rinv_0. ring.
    - rewrite <- H. field. split; [exact N|lra]. }
  assert (E0 := E 0 ltac:(tauto)). assert (E1 := E 1 ltac:(tauto)). assert (E2 := E 2 ltac:(tauto)).
  assert (E3 := E 3 ltac:(tauto)). assert (E4 := E 4 ltac:(tauto)).
  assert (S : c * PI * (24 * D ^ 2) = 0).
  { transitivity (c * PI * (A + 0 * B + 0 ^ 2 * D) ^ 2 - 4 * (c * PI * (A + 1 * B + 1 ^ 2 * D) ^ 2)
      + 6 * (c * PI * (A + 2 * B + 2 ^ 2 * D) ^ 2) - 4 * (c * PI * (A + 3 * B + 3 ^ 2 * D) ^ 2)
      + c * PI * (A + 4 * B + 4 ^ 2 * D) ^ 2); [ring|]. rewrite <- E0, <- E1, <- E2, <- E3, <- E4. ring. }
  assert (0 < D ^ 2) by now apply pow_lt.
  apply Rmult_integral in S. destruct S as [S|S]; [|lra]. apply Rmult_integral in S. destruct S; lra.
Qed.
