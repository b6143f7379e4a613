(* Appendix B for all cuts of one patch: patch i reaches from position 0 to [last], is lit by patch j up to the line of
   discontinuity and dark beyond it. The gain falls strictly as the cut moves from the line into the dark part (B.1);
   it rises strictly as the cut moves through a lit part of uniform form factor to the line (B.2). *)
From Coq Require Import Reals Lra.
From Infoscene Require Import Information TwoPartDivision DiscontinuityMeshing.
Open Scope R_scope.

(* Up to position t the patch has area [area t] and sends [flux t] = A F to patch j (both up to a constant). *)
Definition form_factor_between (area flux : R -> R) (s t : R) : R :=
  (flux t - flux s) / (area t - area s).

(* Eq. (7) for the cut at position t. *)
Definition gain_of_cut (total area_j : R) (area flux : R -> R) (last t : R) : R :=
  gain_of_division total area_j
    (area t - area 0) (form_factor_between area flux 0 t)
    (area last - area t) (form_factor_between area flux t last).

(* Area grows along the patch; the cuts may be curved and the patch of any outline. *)
Definition area_grows (area : R -> R) (last : R) : Prop :=
  forall s t, 0 <= s -> s < t -> t <= last -> area s < area t.

Definition dark_beyond (flux : R -> R) (line last : R) : Prop :=
  forall t, line <= t -> t <= last -> flux t = flux line.

Definition lit_uniformly (area flux : R -> R) (line form_factor : R) : Prop :=
  forall t, 0 <= t -> t <= line -> flux t - flux 0 = form_factor * (area t - area 0).

(* ---- B.1 ---- *)

(* A cut at t beyond the line is a division of B.1 with dark area A_d between the line and t. *)
Lemma cut_in_dark_part : forall total area_j area flux line last t,
  area_grows area last -> dark_beyond flux line last -> 0 < line -> line <= t -> t <= last ->
  gain_of_cut total area_j area flux last t
  = gain_in_dark_part total area_j (area line - area 0) (form_factor_between area flux 0 line)
      (area t - area line) (area last - area line - (area t - area line)).
Proof.
  intros total aj area flux line last t Hg Hd H0 Hlt Htl.
  assert (Hl : area 0 < area line) by (apply Hg; lra).
  assert (Ht : area 0 < area t) by (apply Hg; lra).
  unfold gain_of_cut, gain_in_dark_part.
  replace (area line - area 0 + (area t - area line)) with (area t - area 0) by ring.
  replace (area last - area line - (area t - area line)) with (area last - area t) by ring.
  replace (form_factor_between area flux t last) with 0.
  2:{ unfold form_factor_between. rewrite (Hd last), (Hd t) by lra. unfold Rdiv. ring. }
  f_equal. unfold joined_form_factor, form_factor_between. rewrite (Hd t) by lra. field. lra.
Qed.

Theorem gain_falls_beyond_discontinuity : forall total area_j area flux line last s t,
  0 < total -> 0 < area_j -> area_grows area last ->
  0 < line -> flux 0 < flux line -> dark_beyond flux line last ->
  line <= s -> s < t -> t <= last ->
  gain_of_cut total area_j area flux last t < gain_of_cut total area_j area flux last s.
Proof.
  intros total aj area flux line last s t HT Hj Hg H0 Hf Hd Hls Hst Htl.
  assert (Hl : area 0 < area line) by (apply Hg; lra).
  assert (area s < area t) by (apply Hg; lra).
  assert (area line <= area s).
  { destruct (Req_dec line s) as [-> |]; [lra |]. left. apply Hg; lra. }
  assert (area t <= area last).
  { destruct (Req_dec t last) as [-> |]; [lra |]. left. apply Hg; lra. }
  rewrite (cut_in_dark_part total aj area flux line last t), (cut_in_dark_part total aj area flux line last s)
    by (assumption || lra).
  apply gain_falls_with_dark_area; try lra.
  unfold form_factor_between. apply Rdiv_lt_0_compat; lra.
Qed.

(* ---- B.2 ---- *)

Definition information_between (total area_j : R) (area flux : R -> R) (s t : R) : R :=
  information_term total area_j (area t - area s) (form_factor_between area flux s t).

Lemma joined_between : forall area flux r s t,
  area r < area s -> area s < area t ->
  joined_form_factor (area s - area r) (form_factor_between area flux r s)
    (area t - area s) (form_factor_between area flux s t) = form_factor_between area flux r t.
Proof. intros. unfold joined_form_factor, form_factor_between. field. lra. Qed.

Lemma gain_of_cut_by_parts : forall total area_j area flux last t,
  area_grows area last -> 0 < last -> 0 <= t -> t <= last ->
  gain_of_cut total area_j area flux last t
  = 2 * (information_between total area_j area flux 0 t + information_between total area_j area flux t last
         - information_between total area_j area flux 0 last).
Proof.
  intros total aj area flux last t Hg H0 Ht Htl.
  assert (area 0 < area last) by (apply Hg; lra).
  unfold gain_of_cut, gain_of_division. fold (information_between total aj area flux 0 t).
  fold (information_between total aj area flux t last). do 2 f_equal.
  unfold information_between. f_equal; [ring |].
  destruct (Req_dec t 0) as [-> | H1]; [| destruct (Req_dec t last) as [-> | H2]].
  - replace (area 0 - area 0) with 0 by ring. unfold joined_form_factor.
    rewrite Rmult_0_l, !Rplus_0_l. field. lra.
  - replace (area last - area last) with 0 by ring. unfold joined_form_factor.
    rewrite Rmult_0_l, !Rplus_0_r. field. lra.
  - apply joined_between; apply Hg; lra.
Qed.

Lemma form_factor_between_uniform : forall area flux line last form_factor s t,
  area_grows area last -> lit_uniformly area flux line form_factor ->
  0 <= s -> s < t -> t <= line -> line <= last ->
  form_factor_between area flux s t = form_factor.
Proof.
  intros area flux line last f s t Hg Hu Hs Hst Ht Hl.
  assert (area s < area t) by (apply Hg; lra).
  unfold form_factor_between.
  replace (flux t - flux s) with (flux t - flux 0 - (flux s - flux 0)) by ring.
  rewrite !Hu by lra. field. lra.
Qed.

(* From the cut at s to the cut at t, the lit strip between them leaves a part that is partly dark, whose form factor
   is smaller, and joins a part of its own form factor: the first gains, the second loses nothing. *)
Theorem gain_rises_up_to_discontinuity : forall total area_j area flux line last form_factor s t,
  0 < total -> 0 < area_j -> area_grows area last ->
  line < last -> 0 < form_factor -> lit_uniformly area flux line form_factor -> dark_beyond flux line last ->
  0 <= s -> s < t -> t <= line ->
  gain_of_cut total area_j area flux last s < gain_of_cut total area_j area flux last t.
Proof.
  intros total aj area flux line last f s t HT Hj Hg Hl Hf Hu Hd Hs Hst Ht.
  rewrite !gain_of_cut_by_parts by (assumption || lra).
  assert (Hast : area s < area t) by (apply Hg; lra).
  assert (Hatl : area t < area last) by (apply Hg; lra).
  assert (Hal : area line < area last) by (apply Hg; lra).
  assert (Hatline : area t <= area line).
  { destruct (Req_dec t line) as [-> |]; [lra |]. left. apply Hg; lra. }
  (* the form factor of the rest beyond t *)
  assert (Hrest : form_factor_between area flux t last = f * (area line - area t) / (area last - area t)).
  { unfold form_factor_between. rewrite (Hd last) by lra. f_equal.
    replace (flux line - flux t) with (flux line - flux 0 - (flux t - flux 0)) by ring.
    rewrite !Hu by lra. ring. }
  assert (Hstrip : form_factor_between area flux s t = f)
    by (apply (form_factor_between_uniform area flux line last); assumption || lra).
  assert (Hnonneg : 0 <= f * (area line - area t) / (area last - area t)).
  { unfold Rdiv. apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; lra]. }
  assert (Hsmaller : f <> f * (area line - area t) / (area last - area t)).
  { intro H. assert (f * (area last - area t) = f * (area line - area t)).
    { rewrite H at 1. field. lra. }
    apply Rmult_eq_reg_l in H0; lra. }
  (* the strip leaves the rest *)
  assert (Hleave : information_between total aj area flux s last
                   < information_between total aj area flux s t + information_between total aj area flux t last).
  { unfold information_between. rewrite <- (joined_between area flux s t last) by assumption.
    replace (area last - area s) with (area t - area s + (area last - area t)) by ring.
    apply dividing_unequal_parts_gains; rewrite ?Hstrip, ?Hrest; assumption || lra. }
  (* the strip joins the first part *)
  assert (Hjoin : information_between total aj area flux 0 t
                  = information_between total aj area flux 0 s + information_between total aj area flux s t).
  { unfold information_between. rewrite Hstrip.
    rewrite (form_factor_between_uniform area flux line last f 0 t) by (assumption || lra).
    replace (area t - area 0) with (area s - area 0 + (area t - area s)) by ring.
    rewrite dividing_equal_parts_gains_nothing. f_equal.
    destruct (Req_dec s 0) as [-> |].
    - rewrite Rminus_diag_eq, !information_term_of_nothing by reflexivity. reflexivity.
    - now rewrite (form_factor_between_uniform area flux line last f 0 s) by (assumption || lra). }
  lra.
Qed.

(* B.1 and B.2 together: every other cut gains strictly less than the cut along the discontinuity. *)
Theorem discontinuity_is_the_only_best_cut : forall total area_j area flux line last form_factor t,
  0 < total -> 0 < area_j -> area_grows area last ->
  0 < line -> line < last -> 0 < form_factor ->
  lit_uniformly area flux line form_factor -> dark_beyond flux line last ->
  0 <= t -> t <= last -> t <> line ->
  gain_of_cut total area_j area flux last t < gain_of_cut total area_j area flux last line.
Proof.
  intros total aj area flux line last f t HT Hj Hg H0 Hl Hf Hu Hd Ht Htl Hne.
  destruct (Rlt_dec t line).
  - apply (gain_rises_up_to_discontinuity total aj area flux line last f); assumption || lra.
  - assert (area 0 < area line) by (apply Hg; lra).
    assert (0 < f * (area line - area 0)) by (apply Rmult_lt_0_compat; lra).
    pose proof (Hu line ltac:(lra) ltac:(lra)).
    apply (gain_falls_beyond_discontinuity total aj area flux line last); assumption || lra.
Qed.
