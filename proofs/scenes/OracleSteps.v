(* Section 5, the three steps of the oracle as inequalities: what step 1 discards gains little, step 2 picks the patch of the
   larger bound, and step 1 is the power oracle up to the factor B_i / R_i. For step 3 see GradientOfAnyParts.v. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums LogSum PairGain LargestWeight WeightedScene Radiosity PotentialGain.
Open Scope R_scope.

(* B_i B_j A_i F_ij: half the bound on the gain of the pair, for two parts and before normalisation. *)
Definition potential (area form_factor radiosity_i radiosity_j : R) : R :=
  radiosity_i * radiosity_j * area * form_factor.

(* B_j R_i A_j F_ji: what patch i reflects of the power that it receives from j, but for pi. *)
Definition reflected_power (reflectance area_j form_factor_ji radiosity_j : R) : R :=
  radiosity_j * reflectance * area_j * form_factor_ji.

(* The gain (5) of the normalised chain of constant radiosity when i is divided into m equal parts; total is the sum of all
   generalized areas. *)
Definition radiosity_gain (m : nat) (total area form_factor : R) (part_form_factor : nat -> R)
    (reflectance emittance radiosity_i radiosity_j : R) : R :=
  pair_gain_without_receiver m
    (area * radiosity_i * ((radiosity_i - emittance) / reflectance) / total)
    (reflectance * form_factor * radiosity_j / (radiosity_i - emittance))
    (fun _ => area / INR m * radiosity_i * ((radiosity_i - emittance) / reflectance) / total)
    (fun k => reflectance * part_form_factor k * radiosity_j / (radiosity_i - emittance)).

(* Step 1: a pair whose potential does not exceed the threshold gains at most 2 threshold log2 m / total. *)
Theorem discarded_pair_gains_little :
  forall m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j threshold,
  (1 <= m)%nat -> 0 < total -> 0 < area -> 0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_i -> 0 < radiosity_j ->
  0 <= form_factor -> (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => area / INR m * part_form_factor k) = area * form_factor ->
  potential area form_factor radiosity_i radiosity_j <= threshold ->
  radiosity_gain m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j
  <= 2 * threshold * log2 (INR m) / total.
Proof.
  intros m T A F f r E Bi Bj e Hm HT HA Hr HE HBi HBj HF Hf H He. unfold radiosity_gain.
  apply (Rmult_le_reg_l T); [exact HT|].
  rewrite (normalized_constant_radiosity_pair_gain m T A F (fun _ => A / INR m) f r E Bi Bj) by (assumption || lra).
  rewrite <- (constant_radiosity_pair_gain m A F (fun _ => A / INR m) f r E Bi Bj) by assumption.
  apply Rle_trans with (1 := regular_constant_radiosity_gain_at_most m A F f r E Bi Bj Hm HA Hr HE HBi HBj HF Hf H).
  replace (T * (2 * e * log2 (INR m) / T)) with (2 * e * log2 (INR m)) by (field; lra).
  assert (0 <= log2 (INR m)).
  { rewrite <- log2_1. apply log2_le; [lra|]. change 1 with (INR 1). now apply le_INR. }
  unfold potential in He. apply Rmult_le_compat_r; [assumption|]. lra.
Qed.

(* Where one part sees all that the patch sees of j, that is what it gains. *)
Theorem potential_gain_is_attained :
  forall m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j k,
  (1 <= m)%nat -> 0 < total -> 0 < area -> 0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_i -> 0 < radiosity_j ->
  0 <= form_factor -> (forall l, (l < m)%nat -> 0 <= part_form_factor l) ->
  sum m (fun l => area / INR m * part_form_factor l) = area * form_factor ->
  (k < m)%nat -> (forall l, (l < m)%nat -> l <> k -> part_form_factor l = 0) ->
  radiosity_gain m total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j
  = 2 * potential area form_factor radiosity_i radiosity_j * log2 (INR m) / total.
Proof.
  intros m T A F f r E Bi Bj k Hm HT HA Hr HE HBi HBj HF Hf H Hk Hz. unfold radiosity_gain.
  apply (Rmult_eq_reg_l T); [|lra].
  rewrite (normalized_constant_radiosity_pair_gain m T A F (fun _ => A / INR m) f r E Bi Bj) by (assumption || lra).
  assert (G := regular_visibility_gain_attained m 1 A 1 F f k Hm Rlt_0_1 HA Rlt_0_1 HF Hf H Hk Hz).
  rewrite visibility_pair_gain_without_areas in G by (assumption || lra).
  replace (A / 1) with A in G by field. rewrite (sum_ext m _ (fun l => A / INR m * xlog2 (f l) 1)) in G
    by (intros; unfold Rdiv; rewrite Rinv_1; ring).
  replace (2 * Bi * Bj * (sum m (fun l => A / INR m * xlog2 (f l) 1) - A * xlog2 F 1))
    with (Bi * Bj * (2 * (sum m (fun l => A / INR m * xlog2 (f l) 1) - A * xlog2 F 1))) by ring.
  rewrite G. unfold potential. field. lra.
Qed.

(* Control: less cannot be promised. Halves of which one sees nothing of j gain exactly that. *)
Theorem discarded_pair_may_gain_all_of_it : exists total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j,
  0 < total /\ 0 < area /\ 0 < reflectance /\ emittance < radiosity_i /\ 0 < radiosity_i /\ 0 < radiosity_j /\
  0 < form_factor /\ (forall k, (k < 2)%nat -> 0 <= part_form_factor k) /\
  sum 2 (fun k => area / INR 2 * part_form_factor k) = area * form_factor /\
  radiosity_gain 2 total area form_factor part_form_factor reflectance emittance radiosity_i radiosity_j
  = 2 * potential area form_factor radiosity_i radiosity_j * log2 (INR 2) / total.
Proof.
  exists 1, 1, (1 / 2), (fun k => match k with O => 1 | _ => 0 end), (1 / 2), 1, 2, 1.
  do 7 (split; [lra|]). split; [intros [|k] _; lra|]. split; [simpl; lra|].
  unfold radiosity_gain, potential, pair_gain_without_receiver. simpl.
  replace (1 / 2 * 0 * 1 / (2 - 1)) with 0 by field. rewrite xlog2_0.
  replace (1 / 2 * 1 * 1 / (2 - 1)) with (1 / 2) by field.
  replace (1 / 2 * (1 / 2) * 1 / (2 - 1)) with (1 / 4) by field. rewrite !xlog2_nonzero by lra.
  replace (1 / 2 / 1) with (/ 2) by field. replace (1 / 4 / 1) with (/ (2 * 2)) by field. replace (1 + 1) with 2 by ring.
  assert (forall x, 0 < x -> log2 (/ x) = - log2 x) as I.
  { intros x Hx. replace (/ x) with (1 / x) by (field; lra). rewrite log2_div, log2_1 by lra. ring. }
  rewrite !I, log2_mult, log2_2 by lra. field.
Qed.

(* ---- Step 2 ---- *)

(* The pair's own potential is the same for both of its patches: it cannot decide between them. *)
Theorem potential_is_the_same_for_both : forall n area form_factor radiosity i j,
  scene n area form_factor -> (i < n)%nat -> (j < n)%nat ->
  potential (area i) (form_factor i j) (radiosity i) (radiosity j) = potential (area j) (form_factor j i) (radiosity j) (radiosity i).
Proof.
  intros n A F B i j S Hi Hj. unfold potential. assert (H := form_factor_reciprocity _ _ _ S i j Hi Hj).
  replace (B i * B j * A i * F i j) with (B i * B j * (A i * F i j)) by ring. rewrite H. ring.
Qed.

(* Over all partners the bounds of a patch sum to 2 log2 m times its generalized area, and are ordered as those. *)
Theorem larger_generalized_area_has_larger_bound : forall n m area form_factor reflectance emittance radiosity i l,
  (2 <= m)%nat -> radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall j, (j < n)%nat -> reflectance j <> 0) -> (i < n)%nat -> (l < n)%nat ->
  (sum n (fun j => 2 * potential (area i) (form_factor i j) (radiosity i) (radiosity j) * log2 (INR m)) <=
   sum n (fun j => 2 * potential (area l) (form_factor l j) (radiosity l) (radiosity j) * log2 (INR m)) <->
   radiosity_area area reflectance emittance radiosity i <= radiosity_area area reflectance emittance radiosity l).
Proof.
  intros n m A F r E B i l Hm H Hr Hi Hl. assert (L := log2_of_two_or_more_parts m Hm).
  assert (X : forall i, (i < n)%nat ->
    sum n (fun j => 2 * potential (A i) (F i j) (B i) (B j) * log2 (INR m)) = 2 * radiosity_area A r E B i * log2 (INR m)).
  { intros k Hk. unfold radiosity_area. rewrite <- (constant_radiosity_bound_summed_over_patches n m A F r E B k H Hr Hk).
    apply sum_ext. intros j _. unfold potential. ring. }
  rewrite !X by assumption. split; intros G.
  - apply (Rmult_le_reg_r (2 * log2 (INR m))); lra.
  - apply (Rmult_le_compat_r (2 * log2 (INR m))) in G; lra.
Qed.

(* Control: the order of the bounds is not that of the gains. A patch of twice the area gains nothing where its halves have
   equal form factors, the other all of its bound. *)
Theorem larger_bound_may_gain_less :
  radiosity_gain 2 3 2 (1 / 2) (fun _ => 1 / 2) (1 / 2) 1 2 1 <
  radiosity_gain 2 3 1 (1 / 2) (fun k => match k with O => 1 | _ => 0 end) (1 / 2) 1 2 1 /\
  potential 1 (1 / 2) 2 1 < potential 2 (1 / 2) 2 1.
Proof.
  assert (forall x, 0 < x -> log2 (/ x) = - log2 x) as I.
  { intros x Hx. replace (/ x) with (1 / x) by (field; lra). rewrite log2_div, log2_1 by lra. ring. }
  split; [|unfold potential; lra]. unfold radiosity_gain, pair_gain_without_receiver. simpl. replace (1 + 1) with 2 by ring.
  replace (1 / 2 * 0 * 1 / (2 - 1)) with 0 by field. rewrite xlog2_0.
  replace (1 / 2 * 1 * 1 / (2 - 1)) with (1 / 2) by field.
  replace (1 / 2 * (1 / 2) * 1 / (2 - 1)) with (1 / 4) by field. rewrite !xlog2_nonzero by lra.
  replace (1 / 2 / 1) with (/ 2) by field. replace (1 / 4 / 1) with (/ (2 * 2)) by field.
  rewrite !I, log2_mult, log2_2 by lra. lra.
Qed.

(* ---- The analogy with the power oracle ---- *)

(* The potential is B_i / R_i times what i reflects of the power from j: both thresholds are on the same exchange A_i F_ij. *)
Theorem potential_is_reflected_power_times_brightness_over_reflectance :
  forall n area form_factor reflectance radiosity i j,
  scene n area form_factor -> (i < n)%nat -> (j < n)%nat -> reflectance i <> 0 ->
  potential (area i) (form_factor i j) (radiosity i) (radiosity j) =
  radiosity i / reflectance i * reflected_power (reflectance i) (area j) (form_factor j i) (radiosity j).
Proof.
  intros n A F r B i j S Hi Hj Hr. rewrite (potential_is_the_same_for_both n A F B i j S Hi Hj).
  unfold potential, reflected_power. field. exact Hr.
Qed.

(* Control: analogous, not equal. A bright patch that reflects less power than a dark one may have the larger potential, so
   that no two thresholds pick the same pairs. Both have area 1 and reflectance 1/2. *)
Theorem reflected_power_and_potential_may_order_pairs_otherwise : exists form_factor form_factor' radiosity radiosity' source,
  0 < form_factor < 1 /\ 0 < form_factor' < 1 /\ 0 < radiosity /\ 0 < radiosity' /\ 0 < source /\
  reflected_power (1 / 2) 1 form_factor source < reflected_power (1 / 2) 1 form_factor' source /\
  potential 1 form_factor' radiosity' source < potential 1 form_factor radiosity source.
Proof. exists (1 / 4), (1 / 2), 4, 1, 1. unfold potential, reflected_power. repeat split; lra. Qed.
