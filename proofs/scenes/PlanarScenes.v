(* Section 2, "always lower": where two points of a patch are seen from a third one unequally, and the kernel is continuous there,
   the mutual information of the division lies strictly below the continuous one. From a planar patch it is always so where it is
   seen in full (PlanarKernel.v). What is left to geometry is that there are such points, and divisions into small patches. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement IntegralChain DiscreteBelowContinuous ContinuousLimit PlanarKernel.
Open Scope R_scope.

(* The kernel is continuous in both points at x and y: no shadow line passes there. *)
Definition continuous_at_pair {point : Type} (distance kernel : point -> point -> R) (x y : point) : Prop :=
  forall e, 0 < e -> exists d, 0 < d /\
    forall u v, distance u x < d -> distance v y < d -> Rabs (kernel u v - kernel x y) < e.

(* A division can be divided further so that a part of one patch lies as near to x as one likes, another of the same patch to x',
   and a third part to y, with eq. (4) the same. *)
Definition divided_near {point : Type} (distance kernel : point -> point -> R) (continuous : R) (coarse : nat) (w : nat -> R)
    (P : nat -> nat -> R) (x x' y : point) : Prop :=
  forall d, 0 < d -> exists n over integrable (patch : point -> nat) parent k k' l, (0 < n)%nat /\
    integrable_scene point n over integrable kernel /\
    (forall i f g, (i < n)%nat -> integrable f -> integrable g -> (forall z, patch z = i -> f z <= g z) -> over i f <= over i g) /\
    refines coarse n parent w P (patch_weight n over) (patch_form_factor over kernel) /\
    information_of_all_points n over kernel = continuous /\
    (k < n)%nat /\ (k' < n)%nat /\ (l < n)%nat /\ parent k = parent k' /\
    (forall u, patch u = k -> distance u x < d) /\ (forall u, patch u = k' -> distance u x' < d) /\
    (forall v, patch v = l -> distance v y < d).

Theorem division_with_an_unevenly_seen_point_lies_below :
  forall (point : Type) (distance kernel : point -> point -> R) continuous coarse w P x x' y,
  divided_near distance kernel continuous coarse w P x x' y ->
  continuous_at_pair distance kernel x y -> continuous_at_pair distance kernel x' y -> kernel x y <> kernel x' y ->
  mutual_information coarse w P < continuous.
Proof.
  intros point distance kernel Ic coarse w P.
  assert (less : forall x x' y, divided_near distance kernel Ic coarse w P x x' y ->
    continuous_at_pair distance kernel x y -> continuous_at_pair distance kernel x' y -> kernel x y < kernel x' y ->
    mutual_information coarse w P < Ic).
  { intros x x' y D C C' L. set (e := (kernel x' y - kernel x y) / 3). assert (He : 0 < e) by (unfold e; lra).
    destruct (C e He) as [d1 [H1 B1]]. destruct (C' e He) as [d2 [H2 B2]].
    destruct (D (Rmin d1 d2)) as [n [over [integrable [patch [parent [k [k' [l [Hn [S [O [R [I [Hk [Hk' [Hl [E [Nk [Nk' Nl]]]]]]]]]]]]]]]]]]];
      [now apply Rmin_glb_lt|].
    assert (T := total_area_is_positive point n over integrable kernel S Hn). set (A := sum n (patch_area over)) in *.
    assert (m1 := Rmin_l d1 d2). assert (m2 := Rmin_r d1 d2). rewrite <- I.
    apply (division_of_an_unevenly_seen_patch_lies_below point n over integrable kernel patch S Hn O coarse parent w P k k' l
      (A * (kernel x y + e)) (A * (kernel x' y - e)) R Hk Hk' Hl E).
    - apply Rmult_lt_compat_l; [exact T|]. unfold e. lra.
    - intros u v Hu Hv. specialize (Nk u Hu). specialize (Nl v Hv). fold A. apply Rmult_le_compat_l; [lra|].
      assert (B := B1 u v ltac:(lra) ltac:(lra)). apply Rabs_def2 in B. lra.
    - intros u v Hu Hv. specialize (Nk' u Hu). specialize (Nl v Hv). fold A. apply Rmult_le_compat_l; [lra|].
      assert (B := B2 u v ltac:(lra) ltac:(lra)). apply Rabs_def2 in B. lra. }
  intros x x' y D C C' N. destruct (Rdichotomy _ _ N) as [L|G]; [now apply (less x x' y)|].
  apply (less x' x y); try assumption. intros d Hd.
  destruct (D d Hd) as [n [over [integrable [patch [parent [k [k' [l [Hn [S [O [R [I [Hk [Hk' [Hl [E [Nk [Nk' Nl]]]]]]]]]]]]]]]]]]].
  exists n, over, integrable, patch, parent, k', k, l.
  exact (conj Hn (conj S (conj O (conj R (conj I (conj Hk' (conj Hk (conj Hl (conj (eq_sym E) (conj Nk' (conj Nk Nl))))))))))).
Qed.

(* Five equidistant points of a line on a planar patch that y sees in full: two of them it sees unequally. *)
Theorem division_of_a_planar_patch_lies_below :
  forall (point : Type) (distance kernel : point -> point -> R) continuous coarse w P (p : nat -> point) y
    x1 x2 x3 n1 n2 n3 y1 y2 y3 m1 m2 m3 s1 s2 s3,
  s1 * n1 + s2 * n2 + s3 * n3 = 0 -> 0 < s1 ^ 2 + s2 ^ 2 + s3 ^ 2 ->
  (forall k, (k <= 4)%nat -> kernel (p k) y =
     point_form_factor (x1 + INR k * s1) (x2 + INR k * s2) (x3 + INR k * s3) n1 n2 n3 y1 y2 y3 m1 m2 m3) ->
  kernel (p 0%nat) y <> 0 ->
  (forall k, (k <= 4)%nat -> continuous_at_pair distance kernel (p k) y) ->
  (forall k, (k <= 4)%nat -> divided_near distance kernel continuous coarse w P (p 0%nat) (p k) y) ->
  mutual_information coarse w P < continuous.
Proof.
  intros point distance kernel Ic coarse w P p y x1 x2 x3 n1 n2 n3 y1 y2 y3 m1 m2 m3 s1 s2 s3 Hs HD HK N C D.
  assert (some : exists k, (k <= 4)%nat /\ kernel (p 0%nat) y <> kernel (p k) y).
  { destruct (Req_dec (kernel (p 1%nat) y) (kernel (p 0%nat) y)) as [E1|N1]; [|exists 1%nat; split; [lia|auto]].
    destruct (Req_dec (kernel (p 2%nat) y) (kernel (p 0%nat) y)) as [E2|N2]; [|exists 2%nat; split; [lia|auto]].
    destruct (Req_dec (kernel (p 3%nat) y) (kernel (p 0%nat) y)) as [E3|N3]; [|exists 3%nat; split; [lia|auto]].
    destruct (Req_dec (kernel (p 4%nat) y) (kernel (p 0%nat) y)) as [E4|N4]; [|exists 4%nat; split; [lia|auto]].
    exfalso. apply N.
    apply (form_factor_of_a_planar_patch_is_not_constant x1 x2 x3 n1 n2 n3 y1 y2 y3 m1 m2 m3 s1 s2 s3); [exact Hs|exact HD|].
    intros k Hk.
    assert (K0 := HK 0%nat ltac:(lia)). assert (K1 := HK 1%nat ltac:(lia)). assert (K2 := HK 2%nat ltac:(lia)).
    assert (K3 := HK 3%nat ltac:(lia)). assert (K4 := HK 4%nat ltac:(lia)).
    replace (INR 0) with 0 in K0 by reflexivity. replace (INR 1) with 1 in K1 by reflexivity.
    replace (INR 2) with 2 in K2 by (simpl; ring). replace (INR 3) with 3 in K3 by (simpl; ring).
    replace (INR 4) with 4 in K4 by (simpl; ring).
    destruct Hk as [-> | [-> | [-> | [-> | ->]]]]; congruence. }
  destruct some as [k [Hk Nk]].
  exact (division_with_an_unevenly_seen_point_lies_below point distance kernel Ic coarse w P (p 0%nat) (p k) y
    (D k Hk) (C 0%nat ltac:(lia)) (C k Hk) Nk).
Qed.

(* The hypotheses can be met: two points that see only each other, in one patch. *)
Theorem two_points_in_one_patch_fulfil_hypotheses :
  let distance := fun x y : bool => if Bool.eqb x y then 0 else 1 in
  let kernel := fun x y : bool => if Bool.eqb x y then 0 else 1 in
  divided_near distance kernel 1 1 (fun _ => 1) (fun _ _ => 1) true false true /\
  continuous_at_pair distance kernel true true /\ continuous_at_pair distance kernel false true /\
  kernel true true <> kernel false true.
Proof.
  intros distance kernel. destruct two_points_fulfil_hypotheses as [S [O [_ [I _]]]].
  assert (C : forall x, continuous_at_pair distance kernel x true).
  { intros x e He. exists 1. split; [lra|]. intros u v Hu Hv.
    assert (E : forall a b : bool, distance a b < 1 -> a = b) by (intros [] []; unfold distance; simpl; intros; trivial; lra).
    rewrite (E _ _ Hu), (E _ _ Hv), Rminus_diag_eq, Rabs_R0 by reflexivity. exact He. }
  split; [|split; [apply C|split; [apply C|unfold kernel; simpl; lra]]].
  intros d Hd.
  exists 2%nat, (fun (i : nat) (f : bool -> R) => if Nat.eqb i 0 then f true else f false), (fun _ => True),
    (fun x : bool => if x then 0%nat else 1%nat), (fun _ => 0%nat), 0%nat, 1%nat, 0%nat.
  split; [lia|]. split; [exact S|]. split; [intros i f g Hi _ _; now apply O|]. split; [|split; [exact I|]].
  - assert (W : forall i, (i < 2)%nat ->
      patch_weight 2 (fun (i : nat) (f : bool -> R) => if Nat.eqb i 0 then f true else f false) i = 1 / 2).
    { intros [|[|i]] Hi; [| |lia]; unfold patch_weight, patch_area; simpl; field. }
    constructor.
    + intros; lia.
    + intros k Hk. rewrite (W k Hk). lra.
    + intros k l Hk Hl. unfold joint. rewrite (W k Hk).
      destruct k as [|[|k]]; [| |lia]; destruct l as [|[|l]]; try lia; unfold patch_form_factor, patch_area, kernel; simpl; lra.
    + intros k l Hk Hl Z. rewrite (W l Hl) in Z. lra.
    + intros i Hi. unfold part_sum. destruct i; [|lia]. simpl. rewrite !W by lia. field.
    + intros i j Hi Hj. destruct i; [|lia]. destruct j; [|lia]. unfold block_sum, part_sum, joint. simpl. rewrite !W by lia.
      unfold patch_form_factor, patch_area, kernel. simpl. field.
  - repeat (split; [lia || reflexivity|]). unfold distance.
    split; [|split]; intros []; simpl; intros; try discriminate; assumption.
Qed.
