(* Section 4.2, "the maximum increase in mutual information results when splitting patch i perpendicular to the gradient":
   of all divisions of a patch into two parts of any shape, some straight cut across the gradient gains at least as much. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information LogSum Stationarity IntegralsOverParts.
Open Scope R_scope.

(* ---- The two ends of the range of weights, for a given flux ---- *)

(* For a given flux the information is a convex function of the weight, by the log-sum inequality (12): between
   two weights it is at most the larger of its two values at the ends. *)
Lemma term_below_chord : forall G low high t, 0 <= G -> 0 <= low <= high -> (low = 0 -> G = 0) -> 0 <= t <= 1 ->
  xlog2 G (t * low + (1 - t) * high) <= t * xlog2 G low + (1 - t) * xlog2 G high.
Proof.
  intros G low high t HG Hl H0 Ht.
  set (b := fun i : nat => match i with O => t * low | _ => (1 - t) * high end).
  set (a := fun i : nat => match i with O => t * G | _ => (1 - t) * G end).
  assert (L : xlog2 (sum 2 a) (sum 2 b) <= sum 2 (fun i => xlog2 (a i) (b i))).
  { apply log_sum_inequality; intros [|i] _; unfold a, b; try (apply Rmult_le_pos; lra).
    - intros E. apply Rmult_integral in E. destruct E as [->|E]; [lra|rewrite H0 by exact E; lra].
    - intros E. apply Rmult_integral in E. destruct E as [->|E]; [lra|rewrite H0 by lra; lra]. }
  unfold a, b in L; simpl in L. rewrite !xlog2_scale, !Rplus_0_l in L.
  now replace (t * G + (1 - t) * G) with G in L by ring.
Qed.

Lemma information_between_two_weights : forall G0 W0 G W low high,
  0 <= G <= G0 -> 0 <= low -> low <= W <= high -> high <= W0 ->
  (low = 0 -> G = 0) -> (high = W0 -> G = G0) ->
  two_sided_information G0 W0 G W <= two_sided_information G0 W0 G low \/
  two_sided_information G0 W0 G W <= two_sided_information G0 W0 G high.
Proof.
  intros G0 W0 G W low high HG Hl HW Hh Zl Zh.
  destruct (Req_dec low high) as [E|N]; [left; replace W with low by lra; lra|].
  set (t := (high - W) / (high - low)).
  assert (Ht : 0 <= t <= 1).
  { unfold t. split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
    apply (Rmult_le_reg_r (high - low)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (EW : W = t * low + (1 - t) * high) by (unfold t; field; lra).
  assert (C1 := term_below_chord G low high t ltac:(lra) ltac:(lra) Zl Ht).
  assert (C2 := term_below_chord (G0 - G) (W0 - high) (W0 - low) (1 - t) ltac:(lra) ltac:(lra)
    ltac:(intros Z; rewrite Zh; lra) ltac:(lra)).
  replace ((1 - t) * (W0 - high) + (1 - (1 - t)) * (W0 - low)) with (W0 - W) in C2 by (rewrite EW; ring).
  rewrite <- EW in C1. unfold two_sided_information.
  destruct (Rle_dec (xlog2 G low + xlog2 (G0 - G) (W0 - low)) (xlog2 G high + xlog2 (G0 - G) (W0 - high))); [right|left]; nra.
Qed.

(* ---- A patch whose weight density over flux density rises from one edge to the other ---- *)

Section AcrossTheGradient.
(* Flux and weight of the strip at x are flux_density x and weight_density x; the ratio of the two is [ratio]. *)
Variables (flux_density weight_density ratio : R -> R).
Hypothesis flux_density_integrable : ex_RInt flux_density 0 1.
Hypothesis weight_density_integrable : ex_RInt weight_density 0 1.
Hypothesis flux_density_nonneg : forall x, 0 <= x <= 1 -> 0 <= flux_density x.
Hypothesis weight_is_ratio_times_flux : forall x, 0 <= x <= 1 -> weight_density x = ratio x * flux_density x.
Hypothesis ratio_increasing : forall x y, 0 <= x -> x <= y -> y <= 1 -> ratio x <= ratio y.
Hypothesis ratio_positive : forall x, 0 < x <= 1 -> 0 < ratio x.

Definition total_flux : R := RInt flux_density 0 1.
Definition total_weight : R := RInt weight_density 0 1.

(* A division into two parts of any shape: a share s x of the strip at x lies in the first part. *)
Definition share_of_strips (s : R -> R) : Prop :=
  (forall x, 0 <= x <= 1 -> 0 <= s x <= 1) /\
  ex_RInt (fun x => flux_density x * s x) 0 1 /\ ex_RInt (fun x => weight_density x * s x) 0 1.

Definition divided_flux (s : R -> R) : R := RInt (fun x => flux_density x * s x) 0 1.
Definition divided_weight (s : R -> R) : R := RInt (fun x => weight_density x * s x) 0 1.

(* The part of the gain (5) that depends on the division; for a straight cut at c and for any division. *)
Definition straight_cut_information (c : R) : R :=
  two_sided_information total_flux total_weight (RInt flux_density 0 c) (RInt weight_density 0 c).
Definition division_information (s : R -> R) : R :=
  two_sided_information total_flux total_weight (divided_flux s) (divided_weight s).

Lemma ratio_at_edge_nonneg : forall x, 0 < x <= 1 -> 0 <= ratio x.
Proof. intros x Hx. left. now apply ratio_positive. Qed.

(* The share left to the second part. *)
Lemma complement_is_share : forall s, share_of_strips s ->
  share_of_strips (fun x => 1 - s x) /\
  divided_flux (fun x => 1 - s x) = total_flux - divided_flux s /\
  divided_weight (fun x => 1 - s x) = total_weight - divided_weight s.
Proof.
  intros s [Hs [Hf Hw]].
  assert (E : forall f : R -> R, (fun x => f x * (1 - s x)) = (fun x => f x - f x * s x)).
  { intros f. apply FunctionalExtensionality.functional_extensionality. intros x. ring. }
  split; [split; [|split]|split].
  - intros x Hx. specialize (Hs x Hx). lra.
  - rewrite E. now apply difference_integrable.
  - rewrite E. now apply difference_integrable.
  - unfold divided_flux. rewrite E. now apply integral_of_difference.
  - unfold divided_weight. rewrite E. now apply integral_of_difference.
Qed.

Lemma divided_flux_between : forall s, share_of_strips s -> 0 <= divided_flux s <= total_flux.
Proof.
  intros s [Hs [Hf Hw]]. unfold divided_flux, total_flux. split.
  - apply RInt_ge_0; [lra|exact Hf|]. intros x Hx. apply Rmult_le_pos; [apply flux_density_nonneg|apply Hs]; lra.
  - apply RInt_le; [lra|exact Hf|assumption|]. intros x Hx.
    assert (0 <= flux_density x) by (apply flux_density_nonneg; lra). specialize (Hs x ltac:(lra)). nra.
Qed.

(* Of all parts with the same flux, the one before a straight cut has the least weight: what it has in exchange for
   the strips beyond the cut has a smaller ratio of weight to flux. (The argument of Neyman and Pearson.) *)
Theorem part_before_straight_cut_has_least_weight : forall s c, share_of_strips s -> 0 <= c <= 1 ->
  RInt flux_density 0 c = divided_flux s -> RInt weight_density 0 c <= divided_weight s.
Proof.
  intros s c [Hs [Hf Hw]] Hc EG. unfold divided_flux, divided_weight in *.
  rewrite (integral_split _ c Hf Hc) in EG. rewrite (integral_split _ c Hw Hc).
  assert (before : RInt weight_density 0 c - RInt (fun x => weight_density x * s x) 0 c <=
    ratio c * (RInt flux_density 0 c - RInt (fun x => flux_density x * s x) 0 c)).
  { assert (I1 := integrable_below _ c flux_density_integrable Hc). assert (I2 := integrable_below _ c Hf Hc).
    assert (I3 := integrable_below _ c weight_density_integrable Hc). assert (I4 := integrable_below _ c Hw Hc).
    rewrite <- (integral_of_difference _ _ 0 c I3 I4), <- (integral_of_difference _ _ 0 c I1 I2).
    assert (I5 := difference_integrable _ _ _ _ I1 I2). assert (I6 := difference_integrable _ _ _ _ I3 I4).
    rewrite <- (riemann_integral_of_multiple (ratio c) _ 0 c I5).
    apply RInt_le; [lra|exact I6|now apply multiple_integrable|].
    intros x Hx. rewrite weight_is_ratio_times_flux by lra.
    assert (F := flux_density_nonneg x ltac:(lra)). assert (S := Hs x ltac:(lra)).
    assert (Q := ratio_increasing x c ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (0 <= flux_density x * (1 - s x)) by (apply Rmult_le_pos; lra).
    pose proof (Rmult_le_compat_r _ _ _ H Q). lra. }
  assert (behind : ratio c * RInt (fun x => flux_density x * s x) c 1 <= RInt (fun x => weight_density x * s x) c 1).
  { rewrite <- (riemann_integral_of_multiple (ratio c) _ c 1 (integrable_above _ c Hf Hc)).
    apply RInt_le; [lra|apply multiple_integrable; apply integrable_above; assumption|apply integrable_above; assumption|].
    intros x Hx. rewrite weight_is_ratio_times_flux by lra.
    assert (F := flux_density_nonneg x ltac:(lra)). assert (S := Hs x ltac:(lra)).
    assert (Q := ratio_increasing c x ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (0 <= flux_density x * s x) by (apply Rmult_le_pos; lra).
    pose proof (Rmult_le_compat_r _ _ _ H Q). lra. }
  replace (RInt flux_density 0 c - RInt (fun x => flux_density x * s x) 0 c)
    with (RInt (fun x => flux_density x * s x) c 1) in before by lra. lra.
Qed.

(* Where there is flux there is weight. *)
Lemma weight_before_cut_positive : forall c, 0 <= c <= 1 -> 0 < RInt flux_density 0 c -> 0 < RInt weight_density 0 c.
Proof.
  intros c Hc Hg.
  assert (Hf := integral_split _ c flux_density_integrable Hc).
  assert (0 <= RInt flux_density c 1).
  { apply RInt_ge_0; [lra|now apply integrable_above|]. intros. apply flux_density_nonneg. lra. }
  destruct (integral_takes_every_value flux_density (RInt flux_density 0 c / 2) flux_density_integrable) as [e [He Ee]]; [lra|].
  assert (Hmono : forall (f : R -> R) a b, 0 <= a <= b -> b <= 1 -> ex_RInt f 0 1 ->
    ex_RInt f a b /\ RInt f 0 b = RInt f 0 a + RInt f a b).
  { intros f a b Ha Hb I. assert (Ib : ex_RInt f 0 b) by (apply integrable_below; [exact I|lra]).
    split; [now apply (ex_RInt_Chasles_2 (V := R_CompleteNormedModule) f 0 a b); [lra|]|].
    symmetry. apply (RInt_Chasles (V := R_CompleteNormedModule) f 0 a b).
    - apply integrable_below; [exact I|lra].
    - now apply (ex_RInt_Chasles_2 (V := R_CompleteNormedModule) f 0 a b); [lra|]. }
  assert (e < c).
  { destruct (Rlt_dec e c) as [|N]; [assumption|exfalso].
    destruct (Hmono flux_density c e ltac:(lra) ltac:(lra) flux_density_integrable) as [I E].
    assert (0 <= RInt flux_density c e); [|lra].
    apply RInt_ge_0; [lra|exact I|]. intros. apply flux_density_nonneg. lra. }
  assert (0 < e).
  { destruct (Req_dec e 0) as [->|]; [|lra]. rewrite RInt_point in Ee. change (0 = RInt flux_density 0 c / 2) in Ee. lra. }
  destruct (Hmono flux_density e c ltac:(lra) ltac:(lra) flux_density_integrable) as [If Ef].
  destruct (Hmono weight_density e c ltac:(lra) ltac:(lra) weight_density_integrable) as [Iw Ew].
  assert (0 <= RInt weight_density 0 e).
  { apply RInt_ge_0; [lra|apply integrable_below; [assumption|lra]|]. intros x Hx.
    rewrite weight_is_ratio_times_flux by lra.
    apply Rmult_le_pos; [apply ratio_at_edge_nonneg|apply flux_density_nonneg]; lra. }
  assert (ratio e * RInt flux_density e c <= RInt weight_density e c).
  { rewrite <- (riemann_integral_of_multiple (ratio e) _ e c If).
    apply RInt_le; [lra|now apply multiple_integrable|exact Iw|]. intros x Hx.
    rewrite weight_is_ratio_times_flux by lra. apply Rmult_le_compat_r; [apply flux_density_nonneg; lra|].
    apply ratio_increasing; lra. }
  assert (0 < ratio e * RInt flux_density e c) by (apply Rmult_lt_0_compat; [apply ratio_positive|]; lra).
  lra.
Qed.

Lemma weight_before_cut_nonneg : forall c, 0 <= c <= 1 -> 0 <= RInt weight_density 0 c.
Proof.
  intros c Hc. apply RInt_ge_0; [lra|now apply integrable_below|]. intros x Hx.
  rewrite weight_is_ratio_times_flux by lra.
  apply Rmult_le_pos; [apply ratio_at_edge_nonneg|apply flux_density_nonneg]; lra.
Qed.

(* The paper's claim: for every division there is a straight cut across the gradient that gains at least as much.
   With the flux of the first part given, its weight lies between that of a part before a straight cut and that
   of a part behind one; the information is largest at one of these two ends. *)
Theorem some_straight_cut_gains_at_least_as_much : forall s, share_of_strips s ->
  exists c, 0 <= c <= 1 /\ division_information s <= straight_cut_information c.
Proof.
  intros s Hs. destruct (complement_is_share s Hs) as [Hs' [Ef Ew]].
  assert (Hb := divided_flux_between s Hs). assert (Hb' := divided_flux_between _ Hs').
  destruct (integral_takes_every_value flux_density (divided_flux s) flux_density_integrable Hb) as [c [Hc Ec]].
  destruct (integral_takes_every_value flux_density _ flux_density_integrable Hb') as [d [Hd Ed]].
  assert (low := part_before_straight_cut_has_least_weight s c Hs Hc Ec).
  assert (high := part_before_straight_cut_has_least_weight _ d Hs' Hd Ed).
  rewrite Ef in Ed. rewrite Ew in high.
  destruct (information_between_two_weights total_flux total_weight (divided_flux s) (divided_weight s)
    (RInt weight_density 0 c) (total_weight - RInt weight_density 0 d)) as [L|L].
  - exact Hb.
  - now apply weight_before_cut_nonneg.
  - lra.
  - assert (0 <= RInt weight_density 0 d) by now apply weight_before_cut_nonneg. lra.
  - intros Z. destruct (Rlt_dec 0 (RInt flux_density 0 c)) as [P|]; [|lra].
    pose proof (weight_before_cut_positive c Hc P). lra.
  - intros Z. destruct (Rlt_dec 0 (RInt flux_density 0 d)) as [P|]; [|lra].
    pose proof (weight_before_cut_positive d Hd P). lra.
  - exists c. split; [exact Hc|]. unfold straight_cut_information. now rewrite Ec.
  - exists d. split; [exact Hd|]. unfold straight_cut_information, division_information. rewrite Ed.
    apply Rle_trans with (1 := L). unfold two_sided_information.
    replace (total_flux - (total_flux - divided_flux s)) with (divided_flux s) by ring.
    replace (total_weight - (total_weight - RInt weight_density 0 d)) with (RInt weight_density 0 d)
      by (set (W := RInt weight_density 0 d); clearbody W; simpl in W; lra).
    lra.
Qed.

(* So a cut that is best among the straight ones is best among all divisions. *)
Theorem best_straight_cut_is_best_division : forall best,
  (forall c, 0 <= c <= 1 -> straight_cut_information c <= straight_cut_information best) ->
  forall s, share_of_strips s -> division_information s <= straight_cut_information best.
Proof.
  intros best B s Hs. destruct (some_straight_cut_gains_at_least_as_much s Hs) as [c [Hc L]].
  apply Rle_trans with (1 := L). now apply B.
Qed.
End AcrossTheGradient.
