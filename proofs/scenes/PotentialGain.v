(* Sections 3.3 and 5, the gain of a patch pair for visibility (7) and for constant radiosity, and the most a regular
   subdivision can gain: 2 A_i / A_T F_ij log2 m, and 2 B_i B_j A_i F_ij log2 m; summed over all j. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums LogSum PairGain WeightedScene Radiosity.
Open Scope R_scope.

(* ---- Visibility ---- *)

(* (7), first line: (5) with w = A / A_T and P = F. *)
Definition visibility_pair_gain (m : nat) (total area_i area_j form_factor : R)
    (part_area part_form_factor : nat -> R) : R :=
  2 * (sum m (fun k => part_area k / total * xlog2 (part_form_factor k) (area_j / total))
       - area_i / total * xlog2 form_factor (area_j / total)).

(* (7), second line: A_T and A_j drop out of the logarithms, as sum_k A_ik F_ikj = A_i F_ij. *)
Theorem visibility_pair_gain_without_areas : forall m total area_i area_j form_factor part_area part_form_factor,
  0 < total -> 0 < area_j -> 0 <= form_factor ->
  (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => part_area k * part_form_factor k) = area_i * form_factor ->
  visibility_pair_gain m total area_i area_j form_factor part_area part_form_factor
  = 2 * (sum m (fun k => part_area k / total * xlog2 (part_form_factor k) 1)
         - area_i / total * xlog2 form_factor 1).
Proof.
  intros m T Ai Aj F a f HT Hj HF Hf H.
  apply (receiver_weight_drops_out m (Ai / T) F (Aj / T) (fun k => a k / T) f); auto.
  - now apply Rdiv_lt_0_compat.
  - rewrite (sum_ext m _ (fun k => a k * f k * / T)) by (intros; unfold Rdiv; ring).
    rewrite sum_scale_right, H. unfold Rdiv. ring.
Qed.

(* (6) for visibility, parts of equal area: no gain above 2 A_i / A_T F_ij log2 m ... *)
Theorem regular_visibility_gain_at_most : forall m total area_i area_j form_factor part_form_factor,
  (1 <= m)%nat -> 0 < total -> 0 < area_i -> 0 < area_j -> 0 <= form_factor ->
  (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => area_i / INR m * part_form_factor k) = area_i * form_factor ->
  visibility_pair_gain m total area_i area_j form_factor (fun _ => area_i / INR m) part_form_factor
  <= 2 * (area_i / total) * form_factor * log2 (INR m).
Proof.
  intros m T Ai Aj F f Hm HT HA Hj HF Hf H.
  assert (HT' : / T <> 0) by (apply Rinv_neq_0_compat; lra).
  replace (visibility_pair_gain m T Ai Aj F (fun _ => Ai / INR m) f) with (regular_gain m (Ai / T) F (Aj / T) f).
  - apply regular_gain_at_most; auto using Rdiv_lt_0_compat.
    rewrite (sum_ext m _ (fun k => Ai / INR m * f k * / T)) by (intros; unfold Rdiv; ring).
    rewrite sum_scale_right, H. unfold Rdiv. ring.
  - unfold regular_gain, pair_gain, visibility_pair_gain. do 2 f_equal. apply sum_ext. intros. unfold Rdiv. ring.
Qed.

(* ... and exactly that where one part has all of the form factor. *)
Theorem regular_visibility_gain_attained : forall m total area_i area_j form_factor part_form_factor k,
  (1 <= m)%nat -> 0 < total -> 0 < area_i -> 0 < area_j -> 0 <= form_factor ->
  (forall l, (l < m)%nat -> 0 <= part_form_factor l) ->
  sum m (fun l => area_i / INR m * part_form_factor l) = area_i * form_factor ->
  (k < m)%nat -> (forall l, (l < m)%nat -> l <> k -> part_form_factor l = 0) ->
  visibility_pair_gain m total area_i area_j form_factor (fun _ => area_i / INR m) part_form_factor
  = 2 * (area_i / total) * form_factor * log2 (INR m).
Proof.
  intros m T Ai Aj F f k Hm HT HA Hj HF Hf H Hk Hz.
  replace (visibility_pair_gain m T Ai Aj F (fun _ => Ai / INR m) f) with (regular_gain m (Ai / T) F (Aj / T) f).
  - apply regular_gain_attained with (k := k); auto using Rdiv_lt_0_compat.
    rewrite (sum_ext m _ (fun l => Ai / INR m * f l * / T)) by (intros; unfold Rdiv; ring).
    rewrite sum_scale_right, H. unfold Rdiv. ring.
  - unfold regular_gain, pair_gain, visibility_pair_gain. do 2 f_equal. apply sum_ext. intros. unfold Rdiv. ring.
Qed.

(* Over all j the form factors sum to one. *)
Theorem visibility_bound_summed_over_patches : forall n m area form_factor i,
  closed n form_factor -> (i < n)%nat ->
  sum n (fun j => 2 * (area i / sum n area) * form_factor i j * log2 (INR m))
  = 2 * (area i / sum n area) * log2 (INR m).
Proof. intros n m A F i C Hi. now apply bound_summed_over_receivers, C. Qed.

(* ---- Constant radiosity (section 5) ---- *)

(* x log x of a multiple c x of x: the logarithm of c separates. *)
Lemma xlog2_of_multiple : forall c x, 0 < c -> 0 <= x -> xlog2 (c * x) 1 = c * xlog2 x 1 + c * x * log2 c.
Proof.
  intros c x Hc Hx. destruct (Req_dec x 0) as [-> | H]; [rewrite Rmult_0_r, xlog2_0; ring |].
  rewrite !xlog2_nonzero by (try apply Rmult_integral_contrapositive_currified; lra).
  unfold Rdiv. rewrite Rinv_1, !Rmult_1_r, log2_mult by lra. ring.
Qed.

(* (5) with w = A B (B - E) / R and P = R_i F_ij B_j / (B_i - E_i), B, E and R being the same on all parts of i:
   what multiplies F_ij in P_ij drops out of the logarithms. *)
Theorem constant_radiosity_pair_gain :
  forall m area_i form_factor part_area part_form_factor reflectance emittance radiosity_i radiosity_j,
  0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_j -> 0 <= form_factor ->
  (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => part_area k * part_form_factor k) = area_i * form_factor ->
  pair_gain_without_receiver m
    (area_i * radiosity_i * ((radiosity_i - emittance) / reflectance))
    (reflectance * form_factor * radiosity_j / (radiosity_i - emittance))
    (fun k => part_area k * radiosity_i * ((radiosity_i - emittance) / reflectance))
    (fun k => reflectance * part_form_factor k * radiosity_j / (radiosity_i - emittance))
  = 2 * radiosity_i * radiosity_j
      * (sum m (fun k => part_area k * xlog2 (part_form_factor k) 1) - area_i * xlog2 form_factor 1).
Proof.
  intros m Ai F a f r E Bi Bj Hr HE Hj HF Hf H. unfold pair_gain_without_receiver.
  set (c := r * Bj / (Bi - E)). assert (Hc : 0 < c).
  { apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat | lra]. }
  assert (T : forall A x, 0 <= x -> A * Bi * ((Bi - E) / r) * xlog2 (r * x * Bj / (Bi - E)) 1
    = Bi * Bj * (A * xlog2 x 1) + Bi * Bj * log2 c * (A * x)).
  { intros A x Hx. replace (r * x * Bj / (Bi - E)) with (c * x) by (unfold c; field; lra).
    rewrite xlog2_of_multiple by assumption.
    transitivity (A * Bi * ((Bi - E) / r * c) * (xlog2 x 1 + x * log2 c)); [ring |].
    replace ((Bi - E) / r * c) with Bj by (unfold c; field; lra). ring. }
  rewrite T by assumption.
  rewrite (sum_ext m _ (fun k => Bi * Bj * (a k * xlog2 (f k) 1) + Bi * Bj * log2 c * (a k * f k))) by auto.
  rewrite sum_plus, !sum_scale, H. ring.
Qed.

(* With the weights normalised, as those of a Markov chain are: divided by the total of the generalized areas. So the
   printed expression is the total times the gain. *)
Theorem normalized_constant_radiosity_pair_gain :
  forall m total area_i form_factor part_area part_form_factor reflectance emittance radiosity_i radiosity_j,
  total <> 0 ->
  0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_j -> 0 <= form_factor ->
  (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => part_area k * part_form_factor k) = area_i * form_factor ->
  total * pair_gain_without_receiver m
    (area_i * radiosity_i * ((radiosity_i - emittance) / reflectance) / total)
    (reflectance * form_factor * radiosity_j / (radiosity_i - emittance))
    (fun k => part_area k * radiosity_i * ((radiosity_i - emittance) / reflectance) / total)
    (fun k => reflectance * part_form_factor k * radiosity_j / (radiosity_i - emittance))
  = 2 * radiosity_i * radiosity_j
      * (sum m (fun k => part_area k * xlog2 (part_form_factor k) 1) - area_i * xlog2 form_factor 1).
Proof.
  intros m T Ai F a f r E Bi Bj HT Hr HE Hj HF Hf H.
  rewrite <- (constant_radiosity_pair_gain m Ai F a f r E Bi Bj) by assumption. unfold pair_gain_without_receiver.
  rewrite (sum_ext m (fun k => a k * Bi * ((Bi - E) / r) / T * xlog2 (r * f k * Bj / (Bi - E)) 1)
    (fun k => / T * (a k * Bi * ((Bi - E) / r) * xlog2 (r * f k * Bj / (Bi - E)) 1)))
    by (intros; unfold Rdiv; ring).
  rewrite sum_scale. field. repeat split; try assumption; lra.
Qed.

(* Regular subdivision: at most 2 B_i B_j A_i F_ij log2 m. *)
Theorem regular_constant_radiosity_gain_at_most :
  forall m area_i form_factor part_form_factor reflectance emittance radiosity_i radiosity_j,
  (1 <= m)%nat -> 0 < area_i -> 0 < reflectance -> emittance < radiosity_i -> 0 < radiosity_i -> 0 < radiosity_j ->
  0 <= form_factor -> (forall k, (k < m)%nat -> 0 <= part_form_factor k) ->
  sum m (fun k => area_i / INR m * part_form_factor k) = area_i * form_factor ->
  pair_gain_without_receiver m
    (area_i * radiosity_i * ((radiosity_i - emittance) / reflectance))
    (reflectance * form_factor * radiosity_j / (radiosity_i - emittance))
    (fun _ => area_i / INR m * radiosity_i * ((radiosity_i - emittance) / reflectance))
    (fun k => reflectance * part_form_factor k * radiosity_j / (radiosity_i - emittance))
  <= 2 * radiosity_i * radiosity_j * area_i * form_factor * log2 (INR m).
Proof.
  intros m Ai F f r E Bi Bj Hm HA Hr HE HBi HBj HF Hf H.
  rewrite (constant_radiosity_pair_gain m Ai F (fun _ => Ai / INR m) f r E Bi Bj) by assumption.
  assert (G := regular_visibility_gain_at_most m 1 Ai 1 F f Hm Rlt_0_1 HA Rlt_0_1 HF Hf H).
  rewrite visibility_pair_gain_without_areas in G by (assumption || lra).
  replace (Ai / 1) with Ai in G by field. rewrite (sum_ext m _ (fun k => Ai / INR m * xlog2 (f k) 1)) in G
    by (intros; unfold Rdiv; rewrite Rinv_1; ring).
  set (d := sum m (fun k => Ai / INR m * xlog2 (f k) 1) - Ai * xlog2 F 1) in *.
  assert (0 < Bi * Bj) by now apply Rmult_lt_0_compat.
  apply Rle_trans with (Bi * Bj * (2 * d)); [right; ring |].
  apply Rle_trans with (Bi * Bj * (2 * Ai * F * log2 (INR m))); [apply Rmult_le_compat_l; lra | right; ring].
Qed.

(* Summed over j: 2 log2 m times the generalized area of the patch. *)
Theorem constant_radiosity_bound_summed_over_patches :
  forall n m area form_factor reflectance emittance radiosity i,
  radiosity_equation n form_factor reflectance emittance radiosity ->
  (forall l, (l < n)%nat -> reflectance l <> 0) -> (i < n)%nat ->
  sum n (fun j => 2 * radiosity i * radiosity j * area i * form_factor i j * log2 (INR m))
  = 2 * (area i * radiosity i * ((radiosity i - emittance i) / reflectance i)) * log2 (INR m).
Proof.
  intros n m A F r E B i H Hr Hi.
  rewrite <- (sum_of_potential_gains_is_generalized_area n A F r E B H Hr i Hi), <- sum_scale, <- sum_scale_right.
  apply sum_ext. intros j _. ring.
Qed.
