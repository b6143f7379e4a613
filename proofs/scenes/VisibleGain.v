(* Eq. (7) in full: dividing a planar patch of a closed scene adds to the mutual information (3) the sum over the other
   patches of the pair gains (7). *)
From Coq Require Import Reals Lra Lia Arith.
From Infoscene Require Import Sums Information FiniteSums Refinement StateRefinement Theorem1 PairGain GainFormula
  WeightedScene DividedScene Visibility PotentialGain.
Open Scope R_scope.

Theorem gain_of_visible_patch_is_sum_of_pair_gains :
  forall n s m area form_factor part_area part_form_factor,
  scene n area form_factor -> closed n form_factor ->
  scene (n - 1 + m) part_area part_form_factor -> closed (n - 1 + m) part_form_factor ->
  divided_patch n s m area form_factor part_area part_form_factor ->
  form_factor s s = 0 ->
  mutual_information (n - 1 + m) (fun k => part_area k / sum (n - 1 + m) part_area) part_form_factor
  - mutual_information n (fun i => area i / sum n area) form_factor =
  sum_others n s (fun j => visibility_pair_gain m (sum n area) (area s) (area j) (form_factor s j)
    (fun k => part_area (substate n s k)) (fun k => part_form_factor (substate n s k) j)).
Proof.
  intros n s m A F a G S C S' C' D HF.
  assert (R := dividing_a_visible_patch_fulfils_hypotheses_of_theorem_1 n s m A F a G S C S' C' D).
  assert (Hs := patch_below _ _ _ _ _ _ _ D). assert (Hm := some_subpatch _ _ _ _ _ _ _ D).
  assert (T : sum (n - 1 + m) a = sum n A).
  { destruct D as [_ _ Ha HA _ _ _]. destruct m as [|q]; [lia|]. replace (n - 1 + Datatypes.S q)%nat with (n + q)%nat by lia.
    rewrite (sum_others_and_substates n q s), (sum_others_and_state n s), HA by assumption. f_equal.
    now apply sum_others_ext. }
  change (mutual_information (n - 1 + m) (relative_area (n - 1 + m) a) G - mutual_information n (relative_area n A) F =
    sum_others n s (fun j => visibility_pair_gain m (sum n A) (A s) (A j) (F s j)
      (fun k => a (substate n s k)) (fun k => G (substate n s k) j))).
  rewrite (gain_of_planar_patch_is_sum_of_pair_gains n s m (relative_area n A) F (relative_area (n - 1 + m) a) G).
  - apply sum_others_ext. intros j Hj Hjs. unfold pair_gain, visibility_pair_gain, relative_area. now rewrite T.
  - apply visibility_chain_is_markov; try assumption. lia.
  - now apply visibility_chain_is_reciprocal.
  - apply visibility_chain_is_markov; try assumption. lia.
  - exact R.
  - exact HF.
Qed.
