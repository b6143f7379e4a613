(* Section 4.2, the same in the gain (5): every division of a patch into two parts gains at most what some straight cut
   across the gradient gains; for radiosity B x^n and irradiance H x^m, at most what the best cut of GradientPatch.v gains. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information LogSum Stationarity Extremum MeanSquareCut DensityRatio InformationCut GradientPatch
  IntegralsOverParts AcrossTheGradient.
Open Scope R_scope.

(* Gain (5) when the first part takes the share s x of the strip at x, and the second the rest. *)
Definition division_gain (flux_density weight_density : R -> R) (w_j : R) (s : R -> R) : R :=
  let flux := divided_flux flux_density in
  let weight := divided_weight weight_density in
  let rest := fun x => 1 - s x in
  gain_of_two_parts (weight s) (flux s / weight s) (weight rest) (flux rest / weight rest)
    (total_weight weight_density) (total_flux flux_density / total_weight weight_density) w_j.

(* The straight cut at c: the first part is all that lies before c. *)
Definition before (c x : R) : R := if Rle_dec x c then 1 else 0.

(* w_j drops out: with flux F and weight W, W (F/W) log (F/W / w_j) = F log (F/W) - F log w_j. *)
Lemma part_term : forall F W w_j, 0 <= F -> 0 <= W -> (W = 0 -> F = 0) -> 0 < w_j ->
  W * xlog2 (F / W) w_j = xlog2 F W - F * log2 w_j.
Proof.
  intros F W w_j HF HW Z Hj. destruct (Req_dec W 0) as [->|N].
  - rewrite Z by reflexivity. rewrite xlog2_0. lra.
  - destruct (Req_dec F 0) as [->|NF].
    + unfold Rdiv. rewrite Rmult_0_l, !xlog2_0. lra.
    + assert (0 < F / W) by (apply Rdiv_lt_0_compat; lra).
      rewrite !xlog2_nonzero by lra. rewrite (log2_div (F / W)) by lra. field. lra.
Qed.

Lemma gain_of_two_parts_is_information : forall F0 W0 F W w_j,
  0 <= F <= F0 -> 0 <= W <= W0 -> (W = 0 -> F = 0) -> (W = W0 -> F = F0) -> 0 < w_j ->
  gain_of_two_parts W (F / W) (W0 - W) ((F0 - F) / (W0 - W)) W0 (F0 / W0) w_j =
  2 * (two_sided_information F0 W0 F W - xlog2 F0 W0).
Proof.
  intros F0 W0 F W w_j HF HW Z1 Z2 Hj. unfold gain_of_two_parts, two_sided_information.
  rewrite (part_term F W), (part_term (F0 - F) (W0 - W)), (part_term F0 W0); try lra; try assumption;
    intros E; try specialize (Z2 ltac:(lra)); try specialize (Z1 ltac:(lra)); lra.
Qed.

(* The information of two parts is not below that of the undivided patch: the log-sum inequality (12). *)
Lemma information_of_parts_at_least_whole : forall F0 W0 F W,
  0 <= F <= F0 -> 0 <= W <= W0 -> (W = 0 -> F = 0) -> (W = W0 -> F = F0) ->
  xlog2 F0 W0 <= two_sided_information F0 W0 F W.
Proof.
  intros F0 W0 F W HF HW Z1 Z2.
  assert (L := log_sum_inequality 2 (fun i => match i with O => F | _ => F0 - F end)
    (fun i => match i with O => W | _ => W0 - W end)).
  simpl in L. rewrite !Rplus_0_l in L. unfold two_sided_information.
  replace (F + (F0 - F)) with F0 in L by ring. replace (W + (W0 - W)) with W0 in L by ring.
  apply L; intros [|i] _; try lra; intros E; try specialize (Z2 ltac:(lra)); try specialize (Z1 ltac:(lra)); lra.
Qed.

Lemma integral_before : forall (f : R -> R) c, ex_RInt f 0 1 -> 0 <= c <= 1 ->
  ex_RInt (fun x => f x * before c x) 0 1 /\ RInt (fun x => f x * before c x) 0 1 = RInt f 0 c.
Proof.
  intros f c H Hc.
  assert (E1 : forall x, 0 < x < c -> f x = f x * before c x).
  { intros x Hx. unfold before. destruct (Rle_dec x c); lra. }
  assert (E2 : forall x, c < x < 1 -> 0 = f x * before c x).
  { intros x Hx. unfold before. destruct (Rle_dec x c); lra. }
  assert (I1 : ex_RInt (fun x => f x * before c x) 0 c).
  { apply (ex_RInt_ext (V := R_NormedModule) f); [|now apply integrable_below].
    intros x. rewrite Rmin_left, Rmax_right by lra. apply E1. }
  assert (I2 : ex_RInt (fun x => f x * before c x) c 1).
  { apply (ex_RInt_ext (V := R_NormedModule) (fun _ => 0)); [|apply ex_RInt_const].
    intros x. rewrite Rmin_left, Rmax_right by lra. apply E2. }
  assert (I : ex_RInt (fun x => f x * before c x) 0 1) by now apply (ex_RInt_Chasles (V := R_NormedModule) _ 0 c 1).
  split; [exact I|]. rewrite (integral_split _ c I Hc).
  rewrite <- (RInt_ext (V := R_CompleteNormedModule) f (fun x => f x * before c x) 0 c)
    by (intros x; rewrite Rmin_left, Rmax_right by lra; apply E1).
  rewrite <- (RInt_ext (V := R_CompleteNormedModule) (fun _ => 0) (fun x => f x * before c x) c 1)
    by (intros x; rewrite Rmin_left, Rmax_right by lra; apply E2).
  rewrite (RInt_const (V := R_CompleteNormedModule)). change (RInt f 0 c + (1 - c) * 0 = RInt f 0 c). ring.
Qed.

Section Gain.
Variables (flux_density weight_density ratio : R -> R) (w_j : R).
Hypothesis flux_density_integrable : ex_RInt flux_density 0 1.
Hypothesis weight_density_integrable : ex_RInt weight_density 0 1.
Hypothesis flux_density_nonneg : forall x, 0 <= x <= 1 -> 0 <= flux_density x.
Hypothesis weight_is_ratio_times_flux : forall x, 0 <= x <= 1 -> weight_density x = ratio x * flux_density x.
Hypothesis ratio_increasing : forall x y, 0 <= x -> x <= y -> y <= 1 -> ratio x <= ratio y.
Hypothesis ratio_positive : forall x, 0 < x <= 1 -> 0 < ratio x.
Hypothesis receiver_weight_positive : 0 < w_j.

Local Notation is_share := (share_of_strips flux_density weight_density).
Local Notation gain := (division_gain flux_density weight_density w_j).

Lemma straight_cut_is_share : forall c, 0 <= c <= 1 -> is_share (before c).
Proof.
  intros c Hc. split; [|split]; try now apply integral_before.
  intros x _. unfold before. destruct (Rle_dec x c); lra.
Qed.

Lemma part_without_weight_has_no_flux : forall s, is_share s ->
  0 <= divided_weight weight_density s /\
  (divided_weight weight_density s = 0 -> divided_flux flux_density s = 0).
Proof.
  intros s Hs. assert (B := divided_flux_between flux_density weight_density
    flux_density_integrable flux_density_nonneg s Hs).
  destruct (integral_takes_every_value flux_density _ flux_density_integrable B) as [c [Hc Ec]].
  assert (L := part_before_straight_cut_has_least_weight flux_density weight_density ratio flux_density_integrable
    weight_density_integrable flux_density_nonneg weight_is_ratio_times_flux ratio_increasing s c Hs Hc Ec).
  assert (N := weight_before_cut_nonneg flux_density weight_density ratio weight_density_integrable
    flux_density_nonneg weight_is_ratio_times_flux ratio_positive c Hc).
  split; [lra|]. intros Z. destruct (Rlt_dec 0 (RInt flux_density 0 c)) as [P|]; [|lra].
  pose proof (weight_before_cut_positive flux_density weight_density ratio flux_density_integrable
    weight_density_integrable flux_density_nonneg weight_is_ratio_times_flux ratio_increasing ratio_positive c Hc P). lra.
Qed.

Lemma shares_in_range : forall s, is_share s ->
  let F := divided_flux flux_density s in let W := divided_weight weight_density s in
  let F0 := total_flux flux_density in let W0 := total_weight weight_density in
  0 <= F <= F0 /\ 0 <= W <= W0 /\ (W = 0 -> F = 0) /\ (W = W0 -> F = F0).
Proof.
  intros s Hs. cbv zeta.
  destruct (complement_is_share flux_density weight_density flux_density_integrable weight_density_integrable s Hs)
    as [Hs' [Ef Ew]].
  destruct (part_without_weight_has_no_flux s Hs) as [N Z].
  destruct (part_without_weight_has_no_flux _ Hs') as [N' Z']. rewrite Ef, Ew in *.
  assert (B := divided_flux_between flux_density weight_density flux_density_integrable flux_density_nonneg s Hs).
  split; [exact B|]. split; [lra|]. split; [exact Z|]. intros E.
  specialize (Z' ltac:(lra)). lra.
Qed.

Lemma division_gain_is_information : forall s, is_share s ->
  gain s = 2 * (division_information flux_density weight_density s -
                xlog2 (total_flux flux_density) (total_weight weight_density)).
Proof.
  intros s Hs. destruct (shares_in_range s Hs) as [H1 [H2 [H3 H4]]].
  destruct (complement_is_share flux_density weight_density flux_density_integrable weight_density_integrable s Hs)
    as [_ [Ef Ew]].
  unfold division_gain. cbv zeta. rewrite Ef, Ew. now apply gain_of_two_parts_is_information.
Qed.

Lemma straight_cut_divides : forall c, 0 <= c <= 1 ->
  division_information flux_density weight_density (before c) = straight_cut_information flux_density weight_density c.
Proof.
  intros c Hc. unfold division_information, straight_cut_information, divided_flux, divided_weight.
  rewrite (proj2 (integral_before flux_density c flux_density_integrable Hc)).
  now rewrite (proj2 (integral_before weight_density c weight_density_integrable Hc)).
Qed.

(* No division gains less than nothing. *)
Theorem division_gain_nonneg : forall s, is_share s -> 0 <= gain s.
Proof.
  intros s Hs. rewrite division_gain_is_information by exact Hs.
  destruct (shares_in_range s Hs) as [H1 [H2 [H3 H4]]].
  pose proof (information_of_parts_at_least_whole _ _ _ _ H1 H2 H3 H4). unfold division_information. lra.
Qed.

(* It does not matter which part is called the first. *)
Theorem division_gain_symmetric : forall s, is_share s -> gain (fun x => 1 - s x) = gain s.
Proof.
  intros s Hs.
  destruct (complement_is_share flux_density weight_density flux_density_integrable weight_density_integrable s Hs)
    as [Hs' [Ef Ew]].
  rewrite (division_gain_is_information s Hs), (division_gain_is_information _ Hs').
  unfold division_information, two_sided_information. rewrite Ef, Ew.
  set (F := divided_flux flux_density s). set (W := divided_weight weight_density s).
  replace (total_flux flux_density - (total_flux flux_density - F)) with F by ring.
  replace (total_weight weight_density - (total_weight weight_density - W)) with W by ring. ring.
Qed.

(* A cut at either edge divides nothing. *)
Theorem cut_at_edge_gains_nothing : forall e, e = 0 \/ e = 1 -> gain (before e) = 0.
Proof.
  intros e He. assert (Hc : 0 <= e <= 1) by lra.
  rewrite (division_gain_is_information (before e)), straight_cut_divides by (try apply straight_cut_is_share; exact Hc).
  unfold straight_cut_information, two_sided_information. destruct He as [->| ->].
  - rewrite !RInt_point. change zero with 0. rewrite xlog2_0, !Rminus_0_r. ring.
  - fold (total_flux flux_density) (total_weight weight_density).
    replace (total_flux flux_density - total_flux flux_density) with 0 by ring. rewrite xlog2_0. ring.
Qed.

(* The claim of section 4.2 in the gain (5). *)
Theorem no_division_gains_more_than_straight_cuts : forall s, is_share s ->
  exists c, 0 <= c <= 1 /\ is_share (before c) /\ gain s <= gain (before c).
Proof.
  intros s Hs. destruct (some_straight_cut_gains_at_least_as_much flux_density weight_density ratio
    flux_density_integrable weight_density_integrable flux_density_nonneg weight_is_ratio_times_flux
    ratio_increasing ratio_positive s Hs) as [c [Hc L]].
  exists c. split; [exact Hc|]. split; [now apply straight_cut_is_share|].
  rewrite !division_gain_is_information by (try apply straight_cut_is_share; assumption).
  rewrite straight_cut_divides by exact Hc. lra.
Qed.

(* Control: a cut along the gradient takes the same share of every strip, and gains nothing. *)
Theorem cut_along_gradient_gains_nothing : forall k, 0 <= k <= 1 -> gain (fun _ => k) = 0.
Proof.
  intros k Hk.
  assert (E : forall f : R -> R, (fun x => f x * k) = (fun x => k * f x)).
  { intros f. apply FunctionalExtensionality.functional_extensionality. intros x. ring. }
  assert (Hs : is_share (fun _ => k)).
  { split; [intros; exact Hk|]. rewrite !E. split; now apply multiple_integrable. }
  rewrite division_gain_is_information by exact Hs. unfold division_information, two_sided_information.
  unfold divided_flux, divided_weight. rewrite !E.
  rewrite (riemann_integral_of_multiple k flux_density 0 1 flux_density_integrable).
  rewrite (riemann_integral_of_multiple k weight_density 0 1 weight_density_integrable).
  fold (total_flux flux_density) (total_weight weight_density).
  replace (total_flux flux_density - k * total_flux flux_density) with ((1 - k) * total_flux flux_density) by ring.
  replace (total_weight weight_density - k * total_weight weight_density) with ((1 - k) * total_weight weight_density) by ring.
  rewrite !xlog2_scale. ring.
Qed.
End Gain.

(* Control: where weight is everywhere the same multiple of flux (no gradient), no division gains anything. *)
Theorem without_gradient_no_division_gains : forall (flux_density : R -> R) k w_j s,
  ex_RInt flux_density 0 1 -> (forall x, 0 <= x <= 1 -> 0 <= flux_density x) -> 0 < k -> 0 < w_j ->
  share_of_strips flux_density (fun x => k * flux_density x) s ->
  division_gain flux_density (fun x => k * flux_density x) w_j s = 0.
Proof.
  intros f k w_j s If Pf Hk Hj Hs.
  assert (Iw : ex_RInt (fun x => k * f x) 0 1) by now apply multiple_integrable.
  rewrite (division_gain_is_information f (fun x => k * f x) (fun _ => k)); try assumption; try (intros; lra).
  assert (W : divided_weight (fun x => k * f x) s = k * divided_flux f s).
  { unfold divided_weight, divided_flux. rewrite <- (riemann_integral_of_multiple k _ 0 1 (proj1 (proj2 Hs))).
    f_equal. apply FunctionalExtensionality.functional_extensionality. intros x. ring. }
  assert (W0 : total_weight (fun x => k * f x) = k * total_flux f) by (apply riemann_integral_of_multiple; exact If).
  unfold division_information, two_sided_information. rewrite W, W0.
  assert (X : forall F, xlog2 F (k * F) = F * log2 (1 / k)).
  { intros F. destruct (Req_dec F 0) as [->|N]; [rewrite xlog2_0; ring|]. rewrite xlog2_nonzero by exact N.
    do 2 f_equal. field. lra. }
  replace (k * total_flux f - k * divided_flux f s) with (k * (total_flux f - divided_flux f s)) by ring.
  rewrite !X. ring.
Qed.
