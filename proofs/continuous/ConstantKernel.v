(* Control for "discrete mutual information is always lower than the continuous one" (section 2): where every point sees every
   other alike, as inside a sphere, the kernel is constant, and both are 0 however the domain is divided. *)
From Coq Require Import Reals Lra Lia Arith.
From Coquelicot Require Import Coquelicot.
From Infoscene Require Import Sums Information FiniteSums Refinement Corollary1 DoubleIntegral Divisions ContinuousInformation.
Open Scope R_scope.

Lemma xlog2_equal_arguments : forall x, xlog2 x x = 0.
Proof.
  intros x. destruct (Req_dec x 0) as [->|H]; [apply xlog2_0|]. rewrite xlog2_nonzero by exact H.
  unfold Rdiv. rewrite Rinv_r, log2_1 by exact H. ring.
Qed.

Theorem constant_kernel_loses_nothing : forall n p, division n p ->
  information (discretized (fun _ _ => 1) n p) = 0 /\
  RInt (fun x => RInt (fun y => xlog2 1 1) 0 1) 0 1 = 0.
Proof.
  intros n p D. split.
  - unfold information, mutual_information, discretized, double_integral. cbn [states weight transition].
    apply sum_zero. intros i _. apply sum_zero. intros j _.
    destruct (Req_dec (p (S i) - p i) 0) as [->|H]; [ring|].
    rewrite (RInt_ext _ (fun _ => p (S j) - p j)).
    + rewrite RInt_const. unfold scal. simpl. unfold mult. simpl.
      replace ((p (S i) - p i) * (p (S j) - p j) / (p (S i) - p i)) with (p (S j) - p j) by (field; exact H).
      rewrite xlog2_equal_arguments. ring.
    + intros x _. rewrite RInt_const. unfold scal. simpl. unfold mult. simpl. ring.
  - rewrite (RInt_ext _ (fun _ => 0)).
    + rewrite RInt_const. unfold scal. simpl. unfold mult. simpl. ring.
    + intros x _. rewrite xlog2_equal_arguments, RInt_const. unfold scal. simpl. unfold mult. simpl. ring.
Qed.
