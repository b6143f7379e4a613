(* Sections 3.4 and 3.5, discrete case: the transition probabilities are those of null variance. Gathering: every walk from
   a patch finds its radiosity. Shooting: every walk finds the same sum of A_i V_i B_i, for V = 1 on one patch and 0
   elsewhere the power of that patch. The walks are those of NullVarianceWalks.v and WalkMeans.v. *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement WeightedScene Radiosity Importance
  NullVarianceWalks WalkMeans.
Open Scope R_scope.

(* ---- Section 3.4: gathering, T_ij = R_i F_ij ---- *)

Definition gathering_transfer (form_factor : nat -> nat -> R) (reflectance : nat -> R) (i j : nat) : R :=
  reflectance i * form_factor i j.

Section Gathering.
Variables (form_factor : nat -> nat -> R) (reflectance emittance radiosity : nat -> R).
Local Notation T := (gathering_transfer form_factor reflectance).
Local Notation P := (radiosity_transition form_factor reflectance emittance radiosity).

Theorem gathering_walk_adds_up_to_radiosity : forall path K,
  (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_score 1 T P emittance path K + walk_rest 1 T P emittance radiosity path K = radiosity (path 0%nat).
Proof.
  intros path K H. rewrite <- (Rmult_1_l (radiosity (path 0%nat))).
  exact (score_and_rest_are_constant T emittance radiosity 1 path K H).
Qed.

Theorem gathering_rest_is_product : forall path K, radiosity (path 0%nat) <> 0 ->
  (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_rest 1 T P emittance radiosity path K
  = radiosity (path 0%nat) * prod_f_R0 (share_left emittance radiosity path) K.
Proof.
  intros path K H0 H. rewrite <- (Rmult_1_l (radiosity (path 0%nat))).
  exact (rest_is_product T emittance radiosity 1 path K H0 H).
Qed.

Theorem gathering_walk_finds_radiosity_iff : forall path, radiosity (path 0%nat) <> 0 ->
  (forall k, 0 < P (path k) (path (S k))) ->
  Un_cv (walk_score 1 T P emittance path) (radiosity (path 0%nat)) <->
  Un_cv (prod_f_R0 (share_left emittance radiosity path)) 0.
Proof.
  intros path H0 H. rewrite <- (Rmult_1_l (radiosity (path 0%nat))).
  apply (score_converges_iff_product_vanishes T emittance radiosity 1 path); [now rewrite Rmult_1_l|exact H].
Qed.

(* Probabilities other than P_ij fail after one step. *)
Theorem null_variance_gathering_step_iff : forall i j Q, Q <> 0 -> radiosity i <> emittance i ->
  emittance i + reflectance i * form_factor i j / Q * radiosity j = radiosity i <-> Q = P i j.
Proof. exact (null_variance_step_iff T emittance radiosity). Qed.

Variables (n : nat) (area : nat -> R).
Hypothesis solution : radiosity_solution n area form_factor reflectance emittance radiosity.

Lemma gathering_transport : transport n T emittance radiosity.
Proof.
  destruct solution as [S H Hr HE HB]. constructor; auto.
  - intros i Hi. rewrite (H i Hi) at 1. f_equal. rewrite <- sum_scale. apply sum_ext. intros. unfold gathering_transfer.
    ring.
  - intros i j Hi Hj. apply Rmult_le_pos; [left; auto|now apply (form_factor_nonneg _ _ _ S)].
Qed.

(* A walk takes the steps that have a form factor. *)
Theorem gathering_step_is_possible_iff : forall i j, (i < n)%nat -> (j < n)%nat -> 0 < P i j <-> 0 < form_factor i j.
Proof.
  intros i j Hi Hj. assert (HB := radiosity_positive _ _ _ _ _ _ solution j Hj).
  destruct solution as [S _ Hr _ HE]. specialize (Hr i Hi). specialize (HE i Hi).
  assert (HF := form_factor_nonneg _ _ _ S i j Hi Hj). unfold radiosity_transition. split; intros H.
  - destruct HF as [|Z]; [assumption|]. rewrite <- Z in H. unfold Rdiv in H. rewrite Rmult_0_r, !Rmult_0_l in H. lra.
  - apply Rdiv_lt_0_compat; [|lra]. now repeat apply Rmult_lt_0_compat.
Qed.

Theorem gathering_walk_that_meets_lamps_again_finds_radiosity : forall path,
  (forall k, (path k < n)%nat) -> (forall k, 0 < P (path k) (path (S k))) ->
  (forall m, exists k, (m <= k)%nat /\ 0 < emittance (path k)) ->
  Un_cv (walk_score 1 T P emittance path) (radiosity (path 0%nat)).
Proof.
  intros path Hn H Hs. rewrite <- (Rmult_1_l (radiosity (path 0%nat))).
  exact (score_converges_if_sources_are_met_again n T emittance radiosity gathering_transport 1 path Hn H Hs).
Qed.

Theorem gathering_walks_have_no_variance : forall K i, (i < n)%nat ->
  walk_mean n P K i (fun path =>
    walk_score 1 T P emittance path K + walk_rest 1 T P emittance radiosity path K) = radiosity i /\
  walk_mean n P K i (fun path =>
    (walk_score 1 T P emittance path K + walk_rest 1 T P emittance radiosity path K - radiosity i) ^ 2) = 0.
Proof.
  intros K i Hi. rewrite <- (Rmult_1_l (radiosity i)).
  exact (score_and_rest_have_no_variance n T emittance radiosity gathering_transport K i 1 Hi).
Qed.

Theorem gathering_mean_square_falls_geometrically : forall rho bound,
  (forall i, (i < n)%nat -> sum n (fun j => form_factor i j) <= 1) ->
  (forall i, (i < n)%nat -> reflectance i <= rho) -> (forall i, (i < n)%nat -> radiosity i <= bound) ->
  forall K i, (i < n)%nat ->
  walk_mean n P K i (fun path => (walk_score 1 T P emittance path K - radiosity i) ^ 2)
  <= radiosity i * bound * rho ^ S K.
Proof.
  intros rho bound HF Hr Hb K i Hi.
  assert (R0 := positive_reflectance _ _ _ _ _ _ solution). assert (Sc := radiosity_patches _ _ _ _ _ _ solution).
  assert (0 <= rho) by (specialize (R0 i Hi); specialize (Hr i Hi); lra).
  assert (HT : forall l, (l < n)%nat -> sum n (fun j => T l j) <= rho).
  { intros l Hl. unfold gathering_transfer. rewrite sum_scale, <- (Rmult_1_r rho). apply Rmult_le_compat; auto.
    - left. auto.
    - apply sum_nonneg. intros j Hj. now apply (form_factor_nonneg _ _ _ Sc). }
  assert (G := mean_square_of_score_falls_geometrically n T emittance radiosity gathering_transport rho bound H HT Hb
    K i 1 Hi Rle_0_1). replace (1 ^ 2) with 1 in G by ring. rewrite !Rmult_1_l in G. exact G.
Qed.
End Gathering.

(* ---- Section 3.5: shooting, T_ij = R_j F_ij ---- *)

Definition shooting_transfer (form_factor : nat -> nat -> R) (reflectance : nat -> R) (i j : nat) : R :=
  reflectance j * form_factor i j.

(* The sum of A_i E_i I_i, what every walk finds. *)
Definition emitted_importance (n : nat) (area emittance importance : nat -> R) : R :=
  sum n (fun i => area i * emittance i * importance i).

(* A walk starts on i with probability A_i E_i I_i over that sum ... *)
Definition shooting_start (n : nat) (area emittance importance : nat -> R) (i : nat) : R :=
  area i * emittance i * importance i / emitted_importance n area emittance importance.

(* ... and with the weight A_i E_i over its probability. *)
Definition shooting_weight (n : nat) (area emittance importance : nat -> R) (i : nat) : R :=
  emitted_importance n area emittance importance / importance i.

Theorem shooting_starts_are_probabilities : forall n area emittance importance,
  emitted_importance n area emittance importance <> 0 ->
  sum n (shooting_start n area emittance importance) = 1 /\
  forall i, shooting_start n area emittance importance i <> 0 ->
    area i * emittance i / shooting_start n area emittance importance i
    = shooting_weight n area emittance importance i.
Proof.
  intros n A E I H. unfold shooting_start, shooting_weight, Rdiv. split.
  - rewrite sum_scale_right. fold (emitted_importance n A E I). now apply Rinv_r.
  - intros i Hq. assert (A i <> 0 /\ E i <> 0 /\ I i <> 0) as [H1 [H2 H3]].
    { repeat split; intro Z; apply Hq; rewrite Z; ring. }
    field. auto.
Qed.

(* Radiosity and importance are adjoint: by reciprocity the sum of A E I is that of A V B. *)
Theorem emitted_importance_is_received_power : forall n area form_factor reflectance emittance radiosity
    initial_importance importance,
  scene n area form_factor ->
  radiosity_equation n form_factor reflectance emittance radiosity ->
  importance_equation n form_factor reflectance initial_importance importance ->
  emitted_importance n area emittance importance = sum n (fun i => area i * initial_importance i * radiosity i).
Proof.
  intros n A F r E B V I S HB HI. unfold emitted_importance.
  assert (L : sum n (fun i => A i * E i * I i) = sum n (fun i => A i * B i * I i)
    - sum n (fun i => sum n (fun j => A i * F i j * (r i * I i * B j)))).
  { rewrite <- sum_minus. apply sum_ext. intros i Hi.
    rewrite (sum_ext n _ (fun j => A i * r i * I i * (F i j * B j))) by (intros; ring).
    rewrite sum_scale, (HB i Hi) at 1. ring. }
  assert (U : sum n (fun i => A i * V i * B i) = sum n (fun i => A i * B i * I i)
    - sum n (fun i => sum n (fun j => A i * F i j * (B i * (r j * I j))))).
  { rewrite <- sum_minus. apply sum_ext. intros i Hi.
    rewrite (sum_ext n _ (fun j => A i * B i * (r j * F i j * I j))) by (intros; ring).
    rewrite sum_scale, (HI i Hi) at 1. ring. }
  rewrite L, U, (sum_exchange n n (fun i j => A i * F i j * (B i * (r j * I j)))). f_equal.
  apply sum_ext. intros i Hi. apply sum_ext. intros j Hj. rewrite (form_factor_reciprocity _ _ _ S i j) by assumption.
  ring.
Qed.

Theorem emitted_importance_of_one_patch_is_its_power : forall n area form_factor reflectance emittance radiosity
    importance patch, (patch < n)%nat ->
  scene n area form_factor ->
  radiosity_equation n form_factor reflectance emittance radiosity ->
  importance_equation n form_factor reflectance (fun i => if Nat.eqb i patch then 1 else 0) importance ->
  emitted_importance n area emittance importance = area patch * radiosity patch.
Proof.
  intros n A F r E B I k Hk S HB HI.
  rewrite (emitted_importance_is_received_power n A F r E B _ I S HB HI).
  rewrite <- (sum_single n k (fun i => A i * B i) Hk). apply sum_ext. intros i _. destruct (Nat.eqb i k); ring.
Qed.

Section Shooting.
Variables (n : nat) (area : nat -> R) (form_factor : nat -> nat -> R).
Variables reflectance emittance initial_importance importance : nat -> R.
Local Notation T := (shooting_transfer form_factor reflectance).
Local Notation P := (importance_transition form_factor reflectance initial_importance importance).
Local Notation total := (emitted_importance n area emittance importance).
Local Notation start := (shooting_weight n area emittance importance).

Lemma start_times_importance : forall i, importance i <> 0 -> start i * importance i = total.
Proof. intros i H. unfold shooting_weight. field. assumption. Qed.

Theorem shooting_walk_adds_up_to_total : forall path K, importance (path 0%nat) <> 0 ->
  (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_score (start (path 0%nat)) T P initial_importance path K
    + walk_rest (start (path 0%nat)) T P initial_importance importance path K = total.
Proof.
  intros path K H0 H. rewrite <- (start_times_importance _ H0).
  exact (score_and_rest_are_constant T initial_importance importance _ path K H).
Qed.

Theorem shooting_rest_is_product : forall path K, importance (path 0%nat) <> 0 ->
  (forall k, (k < K)%nat -> 0 < P (path k) (path (S k))) ->
  walk_rest (start (path 0%nat)) T P initial_importance importance path K
  = total * prod_f_R0 (share_left initial_importance importance path) K.
Proof.
  intros path K H0 H. rewrite <- (start_times_importance _ H0).
  exact (rest_is_product T initial_importance importance _ path K H0 H).
Qed.

Theorem shooting_walk_finds_total_iff : forall path, total <> 0 -> importance (path 0%nat) <> 0 ->
  (forall k, 0 < P (path k) (path (S k))) ->
  Un_cv (walk_score (start (path 0%nat)) T P initial_importance path) total <->
  Un_cv (prod_f_R0 (share_left initial_importance importance path)) 0.
Proof.
  intros path HT H0 H. rewrite <- (start_times_importance _ H0).
  apply (score_converges_iff_product_vanishes T initial_importance importance _ path); [|exact H].
  now rewrite start_times_importance.
Qed.

Theorem null_variance_shooting_step_iff : forall i j Q, Q <> 0 -> importance i <> initial_importance i ->
  initial_importance i + reflectance j * form_factor i j / Q * importance j = importance i <-> Q = P i j.
Proof. exact (null_variance_step_iff T initial_importance importance). Qed.

Hypothesis solution : importance_solution n area form_factor reflectance initial_importance importance.

Lemma shooting_transport : transport n T initial_importance importance.
Proof.
  destruct solution as [S H Hr HV HI]. constructor; auto.
  intros i j Hi Hj. apply Rmult_le_pos; [left; auto|now apply (form_factor_nonneg _ _ _ S)].
Qed.

Lemma importance_positive : forall i, (i < n)%nat -> 0 < importance i.
Proof. exact (solution_positive n T initial_importance importance shooting_transport). Qed.

Theorem shooting_step_is_possible_iff : forall i j, (i < n)%nat -> (j < n)%nat -> 0 < P i j <-> 0 < form_factor i j.
Proof.
  intros i j Hi Hj. assert (HI := importance_positive j Hj).
  destruct solution as [S _ Hr _ HG]. specialize (Hr j Hj). specialize (HG i Hi).
  assert (HF := form_factor_nonneg _ _ _ S i j Hi Hj). unfold importance_transition. split; intros H.
  - destruct HF as [|Z]; [assumption|]. rewrite <- Z in H. unfold Rdiv in H. rewrite Rmult_0_r, !Rmult_0_l in H. lra.
  - apply Rdiv_lt_0_compat; [|lra]. now repeat apply Rmult_lt_0_compat.
Qed.

Theorem shooting_walk_that_meets_sources_again_finds_total : forall path,
  (forall k, (path k < n)%nat) -> (forall k, 0 < P (path k) (path (S k))) ->
  (forall m, exists k, (m <= k)%nat /\ 0 < initial_importance (path k)) ->
  Un_cv (walk_score (start (path 0%nat)) T P initial_importance path) total.
Proof.
  intros path Hn H Hs. assert (HI := importance_positive _ (Hn 0%nat)).
  rewrite <- (start_times_importance (path 0%nat)) by lra.
  exact (score_converges_if_sources_are_met_again n T initial_importance importance shooting_transport _ path Hn H Hs).
Qed.

(* The mean over starts and walks. *)
Theorem shooting_walks_have_no_variance : forall K, total <> 0 ->
  sum n (fun i => shooting_start n area emittance importance i * walk_mean n P K i (fun path =>
    walk_score (start i) T P initial_importance path K
      + walk_rest (start i) T P initial_importance importance path K)) = total /\
  sum n (fun i => shooting_start n area emittance importance i * walk_mean n P K i (fun path =>
    (walk_score (start i) T P initial_importance path K
      + walk_rest (start i) T P initial_importance importance path K - total) ^ 2)) = 0.
Proof.
  intros K HT. assert (V : forall i, (i < n)%nat -> start i * importance i = total).
  { intros i Hi. assert (H := importance_positive i Hi). apply start_times_importance. lra. }
  assert (M : forall i, (i < n)%nat -> _) by exact (fun i Hi =>
    score_and_rest_have_no_variance n T initial_importance importance shooting_transport K i (start i) Hi).
  split.
  - rewrite (sum_ext n _ (fun i => shooting_start n area emittance importance i * total)).
    + rewrite sum_scale_right. destruct (shooting_starts_are_probabilities n area emittance importance HT) as [E _].
      transitivity (1 * total); [f_equal; exact E|ring].
    + intros i Hi. f_equal. transitivity (start i * importance i); [exact (proj1 (M i Hi))|exact (V i Hi)].
  - apply sum_zero. intros i Hi. assert (E := proj2 (M i Hi)). rewrite (V i Hi) in E.
    transitivity (shooting_start n area emittance importance i * 0); [f_equal; exact E|ring].
Qed.

Theorem shooting_mean_square_falls_geometrically : forall rho bound,
  (forall i, (i < n)%nat -> 0 <= emittance i) -> 0 < total ->
  (forall i, (i < n)%nat -> sum n (fun j => form_factor i j) <= 1) ->
  (forall i, (i < n)%nat -> reflectance i <= rho) -> (forall i, (i < n)%nat -> importance i <= bound) ->
  forall K,
  sum n (fun i => shooting_start n area emittance importance i * walk_mean n P K i (fun path =>
    (walk_score (start i) T P initial_importance path K - total) ^ 2))
  <= total * sum n (fun i => area i * emittance i) * bound * rho ^ S K.
Proof.
  intros rho bound HE HT HF Hr Hb K. assert (R0 := importance_reflectance_positive _ _ _ _ _ _ solution).
  assert (Sc := importance_patches _ _ _ _ _ _ solution).
  apply Rle_trans with (sum n (fun i => area i * emittance i * (total * bound * rho ^ S K))).
  - apply sum_le. intros i Hi. assert (HI := importance_positive i Hi). assert (HA := area_positive _ _ _ Sc i Hi).
    assert (V : start i * importance i = total) by (apply start_times_importance; lra).
    assert (H0 : 0 <= start i) by (unfold shooting_weight; left; now apply Rdiv_lt_0_compat).
    assert (Hrho : 0 <= rho) by (specialize (R0 i Hi); specialize (Hr i Hi); lra).
    assert (Q : 0 <= shooting_start n area emittance importance i).
    { unfold shooting_start. apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat].
      repeat apply Rmult_le_pos; try lra. auto. }
    replace (area i * emittance i * (total * bound * rho ^ S K))
      with (shooting_start n area emittance importance i * (start i ^ 2 * importance i * bound * rho ^ S K)).
    + assert (HR : forall l, (l < n)%nat -> sum n (fun j => T l j) <= rho).
      { intros l Hl. unfold shooting_transfer. apply Rle_trans with (sum n (fun j => rho * form_factor l j)).
        - apply sum_le. intros j Hj. apply Rmult_le_compat_r; [now apply (form_factor_nonneg _ _ _ Sc)|auto].
        - rewrite sum_scale. apply Rle_trans with (rho * 1); [apply Rmult_le_compat_l; auto|lra]. }
      assert (G := mean_square_of_score_falls_geometrically n T initial_importance importance shooting_transport rho bound
        Hrho HR Hb K i (start i) Hi H0).
      rewrite V in G. apply Rmult_le_compat_l; [assumption|exact G].
    + unfold shooting_start, shooting_weight. field. split; lra.
  - rewrite sum_scale_right. right. ring.
Qed.
End Shooting.

(* All hypotheses can be met together: two patches that see only each other, R = 1/2, E = V = (1, 0), and the walk to and
   fro, which meets the first patch again and again. *)
Definition to_and_fro (k : nat) : nat := if Nat.even k then 0%nat else 1%nat.

Theorem walk_to_and_fro_fulfils_hypotheses :
  radiosity_solution 2 (fun _ => 1) two_patch_form_factor (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity /\
  importance_solution 2 (fun _ => 1) two_patch_form_factor (fun _ => 1 / 2) two_patch_emittance two_patch_radiosity /\
  0 < emitted_importance 2 (fun _ => 1) two_patch_emittance two_patch_radiosity /\
  (forall k, (to_and_fro k < 2)%nat /\ 0 < two_patch_form_factor (to_and_fro k) (to_and_fro (S k))) /\
  (forall m, exists k, (m <= k)%nat /\ 0 < two_patch_emittance (to_and_fro k)).
Proof.
  destruct printed_radiosity_rows_do_not_sum_to_one as [S [_ [H [HE _]]]].
  split; [|split; [|split; [|split]]].
  - constructor; auto; [intros; lra|]. intros [|i] _; simpl; lra.
  - constructor; auto; [|intros; lra|].
    + intros i Hi. rewrite (H i Hi) at 1. rewrite <- sum_scale. f_equal. apply sum_ext. intros. ring.
    + intros [|i] _; simpl; lra.
  - unfold emitted_importance. simpl. lra.
  - intros k. unfold to_and_fro. rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even k); simpl; split; try lia;
      unfold two_patch_form_factor; simpl; lra.
  - intros m. exists (2 * m)%nat. split; [lia|]. unfold to_and_fro. rewrite Nat.even_mul. simpl. lra.
Qed.
