(* The gain in mutual information of one cut through a patch, as a function of where the cut lies (paper (5), (7), with two
   parts), its derivative, and a criterion for it to have exactly one maximum. The tools of fig. 2 and fig. 3. *)
From Coq Require Import Reals Lra Ranalysis5.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information.
Open Scope R_scope.

(* Paper (7) with two parts: a patch of the given area exchanges `flux` (= A_i F_ij) with another patch j; it is cut into a part
   of area `part_area`, which exchanges `part_flux`, and the rest. *)
Definition cut_gain (total_area area flux part_area part_flux : R) : R :=
  2 / total_area *
  (xlog2 part_flux part_area + xlog2 (flux - part_flux) (area - part_area) - xlog2 flux area).

(* A unit square is cut at t; F t is what the part [0, t] exchanges. The exchange per area on either side of the cut: *)
Definition mean_below (F : R -> R) (t : R) : R := F t / t.
Definition mean_above (F : R -> R) (t : R) : R := (F 1 - F t) / (1 - t).

(* The gain without its constants, in natural logarithms. *)
Definition split_information (F : R -> R) (t : R) : R :=
  F t * ln (mean_below F t) + (F 1 - F t) * ln (mean_above F t).

(* Its first two derivatives, where f = F' and f' = F''. *)
Definition gain_slope (F f : R -> R) (t : R) : R :=
  f t * ln (mean_below F t / mean_above F t) - (mean_below F t - mean_above F t).
Definition gain_bend (F f f' : R -> R) (t : R) : R :=
  f' t * ln (mean_below F t / mean_above F t)
  + (f t - mean_below F t) ^ 2 / (t * mean_below F t)
  + (mean_above F t - f t) ^ 2 / ((1 - t) * mean_above F t).

(* Sum, difference and product rules, in the plain operations of the reals. *)
Lemma slope_of_sum (g h : R -> R) (t g' h' : R) :
  is_derive g t g' -> is_derive h t h' -> is_derive (fun x => g x + h x) t (g' + h').
Proof. intros G H. exact (is_derive_plus g h t g' h' G H). Qed.

Lemma slope_of_difference (g h : R -> R) (t g' h' : R) :
  is_derive g t g' -> is_derive h t h' -> is_derive (fun x => g x - h x) t (g' - h').
Proof. intros G H. exact (is_derive_minus g h t g' h' G H). Qed.

Lemma slope_of_product (g h : R -> R) (t g' h' : R) :
  is_derive g t g' -> is_derive h t h' -> is_derive (fun x => g x * h x) t (g' * h t + g t * h').
Proof.
  intros G H. apply is_derive_Reals. apply is_derive_Reals in G. apply is_derive_Reals in H.
  exact (derivable_pt_lim_mult g h t g' h' G H).
Qed.

Lemma slope_by_formula (g : R -> R) (t a b : R) : is_derive g t a -> a = b -> is_derive g t b.
Proof. intros H E. now rewrite <- E. Qed.

Section One_cut.
Variables F f f' : R -> R.
Variable t : R.
Hypothesis inside : 0 < t < 1.
Hypothesis flux_below : 0 < F t.
Hypothesis flux_above : F t < F 1.

Lemma means_positive : 0 < mean_below F t /\ 0 < mean_above F t.
Proof. unfold mean_below, mean_above; split; apply Rdiv_lt_0_compat; lra. Qed.

Lemma mean_below_slope : is_derive F t (f t) -> is_derive (mean_below F) t ((f t - mean_below F t) / t).
Proof.
  intros H. unfold mean_below. auto_derive.
  - split. { now exists (f t). } lra.
  - change (fun x : R => F x) with F. rewrite (is_derive_unique _ _ _ H). field; lra.
Qed.

Lemma mean_above_slope : is_derive F t (f t) -> is_derive (mean_above F) t ((mean_above F t - f t) / (1 - t)).
Proof.
  intros H. unfold mean_above. auto_derive.
  - split. { now exists (f t). } lra.
  - change (fun x : R => F x) with F. rewrite (is_derive_unique _ _ _ H). field; lra.
Qed.

Lemma split_information_slope : is_derive F t (f t) -> is_derive (split_information F) t (gain_slope F f t).
Proof.
  intros H. destruct means_positive as [pa pb]. pose proof (mean_below_slope H) as Ha. pose proof (mean_above_slope H) as Hb.
  unfold split_information, gain_slope. auto_derive.
  - repeat split; trivial; [now exists (f t) | eexists; exact Ha | now exists (f t) | eexists; exact Hb].
  - change (fun x : R => F x) with F.
    change (fun x : R => mean_below F x) with (mean_below F). change (fun x : R => mean_above F x) with (mean_above F).
    rewrite (is_derive_unique _ _ _ H), (is_derive_unique _ _ _ Ha), (is_derive_unique _ _ _ Hb).
    rewrite ln_div by assumption. unfold mean_below, mean_above in *. field. lra.
Qed.

Lemma gain_slope_slope :
  is_derive F t (f t) -> is_derive f t (f' t) -> is_derive (gain_slope F f) t (gain_bend F f f' t).
Proof.
  intros H H'. destruct means_positive as [pa pb]. pose proof (mean_below_slope H) as Ha. pose proof (mean_above_slope H) as Hb.
  unfold gain_slope, gain_bend. auto_derive.
  - repeat split; trivial; try (now exists (f' t)); try (eexists; exact Ha); try (eexists; exact Hb); try lra.
    now apply Rdiv_lt_0_compat.
  - change (fun x : R => f x) with f.
    change (fun x : R => mean_below F x) with (mean_below F). change (fun x : R => mean_above F x) with (mean_above F).
    rewrite (is_derive_unique _ _ _ H'), (is_derive_unique _ _ _ Ha), (is_derive_unique _ _ _ Hb).
    change (mean_below F t * / mean_above F t) with (mean_below F t / mean_above F t).
    generalize (ln (mean_below F t / mean_above F t)); intros L. field. lra.
Qed.

(* The gain is the split information up to constants. *)
Lemma gain_of_split_information (total_area c : R) : total_area <> 0 -> 0 < c ->
  cut_gain total_area 1 (F 1 / c) t (F t / c)
  = 2 / (total_area * c * ln 2) * (split_information F t - F 1 * ln (F 1)).
Proof.
  intros HA Hc. destruct means_positive as [pa pb].
  assert (0 < ln 2) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (0 < F t / c) by (apply Rdiv_lt_0_compat; lra).
  assert (0 < (F 1 - F t) / c) by (apply Rdiv_lt_0_compat; lra).
  assert (0 < F 1 / c) by (apply Rdiv_lt_0_compat; lra).
  unfold cut_gain, xlog2, log2, split_information.
  replace (F 1 / c - F t / c) with ((F 1 - F t) / c) by (field; lra).
  repeat (destruct (Req_EM_T _ 0); [lra|]).
  replace (F t / c / t) with (mean_below F t / c) by (unfold mean_below; field; lra).
  replace ((F 1 - F t) / c / (1 - t)) with (mean_above F t / c) by (unfold mean_above; field; lra).
  replace (F 1 / c / 1) with (F 1 / c) by (field; lra).
  rewrite !ln_div by lra. field. lra.
Qed.
End One_cut.

(* A function whose derivative is negative on a closed interval is strictly decreasing there; and increasing likewise. *)
Lemma negative_slope_decreases (f f' : R -> R) (a b : R) : a < b ->
  (forall t, a <= t <= b -> is_derive f t (f' t)) -> (forall t, a < t < b -> f' t < 0) -> f b < f a.
Proof.
  intros Hab Hd Hn. destruct (MVT_cor2 f f' a b Hab) as [c [Hc Hin]].
  - intros c Hc. apply is_derive_Reals. now apply Hd.
  - specialize (Hn c Hin). nra.
Qed.

Lemma positive_slope_increases (f f' : R -> R) (a b : R) : a < b ->
  (forall t, a <= t <= b -> is_derive f t (f' t)) -> (forall t, a < t < b -> 0 < f' t) -> f a < f b.
Proof.
  intros Hab Hd Hn. destruct (MVT_cor2 f f' a b Hab) as [c [Hc Hin]].
  - intros c Hc. apply is_derive_Reals. now apply Hd.
  - specialize (Hn c Hin). nra.
Qed.

(* Exactly one maximum on (0, 1): the slope is positive up to l, negative from r on, strictly decreasing on [l, r], and changes
   sign between p and q. Idea: the slope has one zero m, between p and q, so the function rises up to m and falls after it. *)
Theorem slope_with_one_sign_change_gives_unique_maximum (U slope bend : R -> R) (l p q r : R) :
  0 < l -> l <= p -> p < q -> q <= r -> r < 1 ->
  (forall t, 0 < t < 1 -> is_derive U t (slope t)) ->
  (forall t, 0 < t <= l -> 0 < slope t) ->
  (forall t, r <= t < 1 -> slope t < 0) ->
  (forall t, l <= t <= r -> is_derive slope t (bend t)) ->
  (forall t, l <= t <= r -> bend t < 0) ->
  0 < slope p -> slope q < 0 ->
  exists m, p < m < q /\ slope m = 0 /\
    (forall t, 0 < t < m -> 0 < slope t) /\ (forall t, m < t < 1 -> slope t < 0) /\
    (forall t, 0 < t < 1 -> t <> m -> U t < U m).
Proof.
  intros H0 Hlp Hpq Hqr Hr HU Hl Hrt Hd Hb Hp Hq.
  assert (dec : forall s t, l <= s -> s < t -> t <= r -> slope t < slope s).
  { intros s t Hs Hst Ht. apply (negative_slope_decreases slope bend); trivial.
    - intros x Hx. apply Hd. lra.
    - intros x Hx. apply Hb. lra. }
  assert (cont : forall x, p <= x <= q -> continuity_pt (fun y => - slope y) x).
  { intros x Hx. apply continuity_pt_opp. apply derivable_continuous_pt. exists (bend x). apply is_derive_Reals. apply Hd. lra. }
  destruct (IVT_interv (fun y => - slope y) p q cont Hpq) as [m [Hm Hm0]]; try lra.
  assert (slope m = 0) as Sm by lra.
  assert (p < m < q) as Hin.
  { split.
    - destruct (Rle_lt_or_eq_dec p m) as [|E]; trivial; try lra. subst m. lra.
    - destruct (Rle_lt_or_eq_dec m q) as [|E]; trivial; try lra. subst m. lra. }
  assert (below : forall t, 0 < t < m -> 0 < slope t).
  { intros t Ht. destruct (Rle_lt_dec t l) as [L|L]; [apply Hl; lra|]. specialize (dec t m). lra. }
  assert (above : forall t, m < t < 1 -> slope t < 0).
  { intros t Ht. destruct (Rle_lt_dec r t) as [L|L]; [apply Hrt; lra|]. specialize (dec m t). lra. }
  exists m. repeat (split; trivial; try lra).
  intros t Ht Hne. destruct (Rtotal_order t m) as [L|[L|L]]; try lra.
  - apply (positive_slope_increases U slope); trivial.
    + intros x Hx. apply HU. lra.
    + intros x Hx. apply below. lra.
  - apply (negative_slope_decreases U slope); trivial.
    + intros x Hx. apply HU. lra.
    + intros x Hx. apply above. lra.
Qed.
