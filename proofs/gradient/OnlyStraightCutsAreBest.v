(* Section 4.2, the equality case: where weight over flux rises strictly along the gradient, a division that is not a straight
   cut across it (up to strips without flux) gains strictly less than some straight cut. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information LogSum Stationarity GradientPatch IntegralsOverParts
  AcrossTheGradient AcrossTheGradientGain.
Open Scope R_scope.

(* Strictly between two weights the information is strictly below the larger of its two values at the ends. *)
Lemma term_strictly_below_chord : forall G low high t, 0 < G -> 0 < low < high -> 0 < t < 1 ->
  xlog2 G (t * low + (1 - t) * high) < t * xlog2 G low + (1 - t) * xlog2 G high.
Proof.
  intros G low high t HG Hl Ht.
  set (a := fun i : nat => match i with O => t * G | _ => (1 - t) * G end).
  set (b := fun i : nat => match i with O => t * low | _ => (1 - t) * high end).
  assert (A : forall i, (i < 2)%nat -> 0 <= a i) by (intros [|i] _; apply Rmult_le_pos; lra).
  assert (B : forall i, (i < 2)%nat -> 0 < b i) by (intros [|i] _; apply Rmult_lt_0_compat; lra).
  assert (B' : forall i, (i < 2)%nat -> 0 <= b i) by (intros; left; auto).
  assert (Z : forall i, (i < 2)%nat -> b i = 0 -> a i = 0) by (intros i Hi E; specialize (B i Hi); lra).
  assert (L := log_sum_inequality 2 a b A B' Z). assert (Q := log_sum_equality 2 a b A B' Z).
  assert (Ea : sum 2 a = G) by (simpl; ring).
  assert (Eb : sum 2 b = t * low + (1 - t) * high) by (simpl; ring).
  assert (Es : sum 2 (fun i => xlog2 (a i) (b i)) = t * xlog2 G low + (1 - t) * xlog2 G high)
    by (unfold a, b; simpl; rewrite !xlog2_scale; ring).
  rewrite Ea, Eb, Es in *. destruct L as [L|L]; [exact L|exfalso].
  symmetry in L. assert (X := proj1 Q L 0%nat ltac:(auto)). unfold a, b in X.
  assert (0 < t * (1 - t) * G * (high - low)) by (repeat apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma information_strictly_between_two_weights : forall G0 W0 G W low high,
  0 < G <= G0 -> 0 < low -> low < W < high -> high <= W0 -> (high = W0 -> G = G0) ->
  two_sided_information G0 W0 G W < two_sided_information G0 W0 G low \/
  two_sided_information G0 W0 G W < two_sided_information G0 W0 G high.
Proof.
  intros G0 W0 G W low high HG Hl HW Hh Zh.
  set (t := (high - W) / (high - low)).
  assert (Ht : 0 < t < 1).
  { unfold t. split; [apply Rdiv_lt_0_compat; lra|].
    apply (Rmult_lt_reg_r (high - low)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (EW : W = t * low + (1 - t) * high) by (unfold t; field; lra).
  assert (C1 := term_strictly_below_chord G low high t ltac:(lra) ltac:(lra) Ht).
  assert (C2 := term_below_chord (G0 - G) (W0 - high) (W0 - low) (1 - t) ltac:(lra) ltac:(lra)
    ltac:(intros Z; rewrite Zh; lra) ltac:(lra)).
  replace ((1 - t) * (W0 - high) + (1 - (1 - t)) * (W0 - low)) with (W0 - W) in C2 by (rewrite EW; ring).
  rewrite <- EW in C1. unfold two_sided_information.
  destruct (Rle_dec (xlog2 G low + xlog2 (G0 - G) (W0 - low)) (xlog2 G high + xlog2 (G0 - G) (W0 - high))); [right|left]; nra.
Qed.

Section Strict.
Variables (flux_density weight_density ratio : R -> R) (w_j : R).
Hypothesis flux_density_integrable : ex_RInt flux_density 0 1.
Hypothesis weight_density_integrable : ex_RInt weight_density 0 1.
Hypothesis flux_density_nonneg : forall x, 0 <= x <= 1 -> 0 <= flux_density x.
Hypothesis weight_is_ratio_times_flux : forall x, 0 <= x <= 1 -> weight_density x = ratio x * flux_density x.
Hypothesis ratio_strictly_increasing : forall x y, 0 <= x -> x < y -> y <= 1 -> ratio x < ratio y.
Hypothesis ratio_positive : forall x, 0 < x <= 1 -> 0 < ratio x.
Hypothesis receiver_weight_positive : 0 < w_j.

Lemma ratio_increasing_too : forall x y, 0 <= x -> x <= y -> y <= 1 -> ratio x <= ratio y.
Proof. intros x y Hx [L|<-] Hy; [left; now apply ratio_strictly_increasing|right; reflexivity]. Qed.

Local Notation is_share := (share_of_strips flux_density weight_density).

(* The first part has all the flux before c and none of the flux beyond. *)
Definition is_straight_cut_at (c : R) (s : R -> R) : Prop :=
  RInt (fun x => flux_density x - flux_density x * s x) 0 c = 0 /\ RInt (fun x => flux_density x * s x) c 1 = 0.

(* Only a part before a straight cut has the least weight: otherwise the part would miss some flux before c, even
   before some e < c, and have it beyond c instead, at a ratio larger by ratio c - ratio e or more. *)
Lemma least_weight_only_before_straight_cut : forall s c, is_share s -> 0 <= c <= 1 ->
  RInt flux_density 0 c = divided_flux flux_density s ->
  divided_weight weight_density s <= RInt weight_density 0 c -> is_straight_cut_at c s.
Proof.
  intros s c [Hs [Hf Hw]] Hc EG EW. unfold divided_flux, divided_weight in *.
  set (h := fun x => flux_density x - flux_density x * s x).
  set (v := fun x => weight_density x - weight_density x * s x).
  assert (Ih : ex_RInt h 0 1) by now apply difference_integrable.
  assert (Iv : ex_RInt v 0 1) by now apply difference_integrable.
  assert (Ph : forall x, 0 <= x <= 1 -> 0 <= h x).
  { intros x Hx. unfold h. assert (F := flux_density_nonneg x Hx). specialize (Hs x Hx). nra. }
  assert (Vh : forall x, 0 <= x <= 1 -> v x = ratio x * h x).
  { intros x Hx. unfold v, h. rewrite weight_is_ratio_times_flux by exact Hx. ring. }
  assert (Eh : RInt h 0 c = RInt (fun x => flux_density x * s x) c 1).
  { unfold h. rewrite integral_of_difference by (now apply integrable_below).
    rewrite (integral_split _ c Hf Hc) in EG. lra. }
  assert (Ev : RInt (fun x => weight_density x * s x) c 1 <= RInt v 0 c).
  { unfold v. rewrite integral_of_difference by (now apply integrable_below).
    rewrite (integral_split _ c Hw Hc) in EW. lra. }
  assert (behind : ratio c * RInt (fun x => flux_density x * s x) c 1 <= RInt (fun x => weight_density x * s x) c 1).
  { rewrite <- (riemann_integral_of_multiple (ratio c) _ c 1 (integrable_above _ c Hf Hc)).
    apply RInt_le; [lra|apply multiple_integrable; now apply integrable_above|now apply integrable_above|].
    intros x Hx. rewrite weight_is_ratio_times_flux by lra.
    assert (F := flux_density_nonneg x ltac:(lra)). assert (S := Hs x ltac:(lra)).
    assert (Q := ratio_increasing_too c x ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (0 <= flux_density x * s x) by (apply Rmult_le_pos; lra).
    pose proof (Rmult_le_compat_r _ _ _ H Q). lra. }
  assert (sub : forall (f : R -> R) a b, 0 <= a <= b -> b <= 1 -> ex_RInt f 0 1 ->
    ex_RInt f a b /\ RInt f 0 b = RInt f 0 a + RInt f a b).
  { intros f a b Ha Hb I. assert (Ib : ex_RInt f 0 b) by (apply integrable_below; [exact I|lra]).
    split; [now apply (ex_RInt_Chasles_2 (V := R_CompleteNormedModule) f 0 a b); [lra|]|].
    symmetry. apply (RInt_Chasles (V := R_CompleteNormedModule) f 0 a b).
    - apply integrable_below; [exact I|lra].
    - now apply (ex_RInt_Chasles_2 (V := R_CompleteNormedModule) f 0 a b); [lra|]. }
  assert (pos : forall a b, 0 <= a <= b -> b <= 1 -> 0 <= RInt h a b).
  { intros a b Ha Hb. apply RInt_ge_0; [lra|now apply (sub h a b)|]. intros. apply Ph. lra. }
  assert (Z : RInt h 0 c = 0).
  { destruct (Req_dec (RInt h 0 c) 0) as [|N]; [assumption|exfalso].
    assert (Hp := pos 0 c ltac:(lra) ltac:(lra)).
    assert (Hp' := pos c 1 ltac:(lra) ltac:(lra)). assert (T := integral_split h c Ih Hc).
    destruct (integral_takes_every_value h (RInt h 0 c / 2) Ih) as [e [He Ee]]; [lra|].
    assert (e < c).
    { destruct (Rlt_dec e c) as [|M]; [assumption|exfalso].
      destruct (sub h c e ltac:(lra) ltac:(lra) Ih) as [_ E]. assert (X := pos c e ltac:(lra) ltac:(lra)). lra. }
    destruct (sub h e c ltac:(lra) ltac:(lra) Ih) as [Ihe Ehe].
    destruct (sub v e c ltac:(lra) ltac:(lra) Iv) as [Ive Eve].
    assert (Ih0 := integrable_below h e Ih ltac:(lra)). assert (Iv0 := integrable_below v e Iv ltac:(lra)).
    assert (V1 : RInt v 0 e <= ratio e * RInt h 0 e).
    { rewrite <- (riemann_integral_of_multiple (ratio e) h 0 e Ih0).
      apply RInt_le; [lra|exact Iv0|now apply multiple_integrable|]. intros x Hx. rewrite Vh by lra.
      apply Rmult_le_compat_r; [apply Ph; lra|apply ratio_increasing_too; lra]. }
    assert (V2 : RInt v e c <= ratio c * RInt h e c).
    { rewrite <- (riemann_integral_of_multiple (ratio c) h e c Ihe).
      apply RInt_le; [lra|exact Ive|now apply multiple_integrable|]. intros x Hx. rewrite Vh by lra.
      apply Rmult_le_compat_r; [apply Ph; lra|apply ratio_increasing_too; lra]. }
    assert (Q := ratio_strictly_increasing e c ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (0 < (ratio c - ratio e) * RInt h 0 e) by (apply Rmult_lt_0_compat; lra).
    rewrite <- Eh in behind. rewrite Ehe in behind. lra. }
  split; [exact Z|]. lra.
Qed.

Lemma divided_weight_at_most : forall s, is_share s ->
  divided_weight weight_density s <= ratio 1 * divided_flux flux_density s.
Proof.
  intros s [Hs [Hf Hw]]. unfold divided_flux, divided_weight.
  rewrite <- (riemann_integral_of_multiple (ratio 1) _ 0 1 Hf).
  apply RInt_le; [lra|exact Hw|now apply multiple_integrable|]. intros x Hx.
  rewrite weight_is_ratio_times_flux by lra.
  assert (F := flux_density_nonneg x ltac:(lra)). assert (S := Hs x ltac:(lra)).
  assert (Q := ratio_increasing_too x 1 ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (0 <= flux_density x * s x) by (apply Rmult_le_pos; lra).
  pose proof (Rmult_le_compat_r _ _ _ H Q). lra.
Qed.

(* A division that is not a straight cut, with one part or the other in front, gains strictly less than a straight cut. *)
Theorem only_straight_cuts_can_be_best : forall s, is_share s ->
  (exists c, 0 <= c <= 1 /\ (is_straight_cut_at c s \/ is_straight_cut_at c (fun x => 1 - s x))) \/
  (exists c, 0 <= c <= 1 /\
    division_gain flux_density weight_density w_j s < division_gain flux_density weight_density w_j (before c)).
Proof.
  intros s Hs.
  destruct (complement_is_share flux_density weight_density flux_density_integrable weight_density_integrable s Hs)
    as [Hs' [Ef Ew]].
  assert (between := divided_flux_between flux_density weight_density flux_density_integrable flux_density_nonneg).
  assert (least := part_before_straight_cut_has_least_weight flux_density weight_density ratio flux_density_integrable
    weight_density_integrable flux_density_nonneg weight_is_ratio_times_flux ratio_increasing_too).
  assert (some := weight_before_cut_nonneg flux_density weight_density ratio weight_density_integrable
    flux_density_nonneg weight_is_ratio_times_flux ratio_positive).
  assert (more := weight_before_cut_positive flux_density weight_density ratio flux_density_integrable
    weight_density_integrable flux_density_nonneg weight_is_ratio_times_flux ratio_increasing_too ratio_positive).
  destruct (integral_takes_every_value flux_density _ flux_density_integrable (between s Hs)) as [c [Hc Ec]].
  destruct (integral_takes_every_value flux_density _ flux_density_integrable (between _ Hs')) as [d [Hd Ed]].
  assert (low := least s c Hs Hc Ec). assert (high := least _ d Hs' Hd Ed).
  destruct low as [low|low].
  2: { left. exists c. split; [exact Hc|]. left. apply least_weight_only_before_straight_cut; try assumption. lra. }
  destruct high as [high|high].
  2: { left. exists d. split; [exact Hd|]. right. apply least_weight_only_before_straight_cut; try assumption. lra. }
  right. rewrite Ew in high. rewrite Ef in Ed.
  assert (B := between s Hs). assert (Sc := some c Hc). assert (Sd := some d Hd).
  assert (M := divided_weight_at_most s Hs).
  assert (FP : 0 < divided_flux flux_density s).
  { destruct (Req_dec (divided_flux flux_density s) 0) as [E|]; [rewrite E in M|]; lra. }
  assert (gains : forall e, 0 <= e <= 1 ->
    division_information flux_density weight_density s < straight_cut_information flux_density weight_density e ->
    exists c, 0 <= c <= 1 /\
      division_gain flux_density weight_density w_j s < division_gain flux_density weight_density w_j (before c)).
  { intros e He L. exists e. split; [exact He|].
    assert (I := division_gain_is_information flux_density weight_density ratio w_j flux_density_integrable
      weight_density_integrable flux_density_nonneg weight_is_ratio_times_flux ratio_increasing_too ratio_positive
      receiver_weight_positive).
    rewrite (I s Hs), (I (before e)) by now apply straight_cut_is_share.
    rewrite (straight_cut_divides flux_density weight_density flux_density_integrable weight_density_integrable) by exact He.
    lra. }
  destruct (information_strictly_between_two_weights (total_flux flux_density) (total_weight weight_density)
    (divided_flux flux_density s) (divided_weight weight_density s)
    (RInt weight_density 0 c) (total_weight weight_density - RInt weight_density 0 d)) as [L|L].
  - lra.
  - apply more; [exact Hc|lra].
  - lra.
  - lra.
  - intros Z. destruct (Rlt_dec 0 (RInt flux_density 0 d)) as [P|]; [|lra].
    pose proof (more d Hd P). lra.
  - apply (gains c Hc). unfold straight_cut_information. now rewrite Ec.
  - apply (gains d Hd). unfold straight_cut_information, division_information. rewrite Ed.
    apply Rlt_le_trans with (1 := L). unfold two_sided_information.
    replace (total_flux flux_density - (total_flux flux_density - divided_flux flux_density s))
      with (divided_flux flux_density s) by ring.
    replace (total_weight weight_density - (total_weight weight_density - RInt weight_density 0 d))
      with (RInt weight_density 0 d)
      by (set (W := RInt weight_density 0 d); clearbody W; simpl in W; lra).
    lra.
Qed.

(* A division that is a straight cut up to strips without flux gains what the cut gains. *)
Theorem straight_cut_gains_alike : forall s c, is_share s -> 0 <= c <= 1 -> is_straight_cut_at c s ->
  division_gain flux_density weight_density w_j s = division_gain flux_density weight_density w_j (before c).
Proof.
  intros s c Hs Hc [Z1 Z2]. destruct (Hs) as [Sh [Hf Hw]].
  assert (If := integrable_below _ c flux_density_integrable Hc). assert (Iw := integrable_below _ c weight_density_integrable Hc).
  assert (Ifs := integrable_below _ c Hf Hc). assert (Iws := integrable_below _ c Hw Hc).
  assert (F : divided_flux flux_density s = RInt flux_density 0 c).
  { unfold divided_flux. rewrite (integral_split _ c Hf Hc), Z2.
    rewrite (integral_of_difference _ _ 0 c If Ifs) in Z1. lra. }
  assert (W : divided_weight weight_density s = RInt weight_density 0 c).
  { apply Rle_antisym.
    - unfold divided_weight. rewrite (integral_split _ c Hw Hc).
      assert (A : RInt (fun x => weight_density x * s x) 0 c <= RInt weight_density 0 c).
      { apply RInt_le; [lra|exact Iws|exact Iw|]. intros x Hx. rewrite weight_is_ratio_times_flux by lra.
        assert (0 <= ratio x * flux_density x)
          by (apply Rmult_le_pos; [left; apply ratio_positive|apply flux_density_nonneg]; lra).
        specialize (Sh x ltac:(lra)). nra. }
      assert (B : RInt (fun x => weight_density x * s x) c 1 <= ratio 1 * RInt (fun x => flux_density x * s x) c 1).
      { rewrite <- (riemann_integral_of_multiple (ratio 1) _ c 1 (integrable_above _ c Hf Hc)).
        apply RInt_le; [lra|now apply integrable_above|apply multiple_integrable; now apply integrable_above|].
        intros x Hx. rewrite weight_is_ratio_times_flux by lra.
        assert (0 <= flux_density x * s x) by (apply Rmult_le_pos; [apply flux_density_nonneg|apply Sh]; lra).
        pose proof (Rmult_le_compat_r _ _ _ H (ratio_increasing_too x 1 ltac:(lra) ltac:(lra) ltac:(lra))). lra. }
      rewrite Z2, Rmult_0_r in B. lra.
    - apply (part_before_straight_cut_has_least_weight flux_density weight_density ratio flux_density_integrable
        weight_density_integrable flux_density_nonneg weight_is_ratio_times_flux ratio_increasing_too s c Hs Hc).
      now rewrite F. }
  assert (I := division_gain_is_information flux_density weight_density ratio w_j flux_density_integrable
    weight_density_integrable flux_density_nonneg weight_is_ratio_times_flux ratio_increasing_too ratio_positive
    receiver_weight_positive).
  rewrite (I s Hs), (I (before c)) by now apply straight_cut_is_share.
  rewrite (straight_cut_divides flux_density weight_density flux_density_integrable weight_density_integrable) by exact Hc.
  unfold division_information, straight_cut_information. now rewrite F, W.
Qed.
End Strict.
