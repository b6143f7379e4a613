(* A function of one cut that first rises and then falls (or the reverse) has exactly one maximiser (minimiser). Used for
   both optimal cuts of section 4.2. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* c is the one and only best point of the open interval (u, v): every other point is strictly worse. *)
Definition only_maximiser (f : R -> R) (u v c : R) : Prop :=
  u < c < v /\ forall x, u < x < v -> x <> c -> f x < f c.

Definition only_minimiser (f : R -> R) (u v c : R) : Prop :=
  u < c < v /\ forall x, u < x < v -> x <> c -> f c < f x.

Definition rises_then_falls (f : R -> R) (u c v : R) : Prop :=
  (forall x y, u < x -> x < y -> y <= c -> f x < f y) /\ (forall x y, c <= x -> x < y -> y < v -> f y < f x).

Definition falls_then_rises (f : R -> R) (u c v : R) : Prop :=
  (forall x y, u < x -> x < y -> y <= c -> f y < f x) /\ (forall x y, c <= x -> x < y -> y < v -> f x < f y).

Lemma mean_value : forall (f f' : R -> R) x y,
  x < y -> (forall z, x <= z <= y -> is_derive f z (f' z)) -> exists z, x < z < y /\ f y - f x = f' z * (y - x).
Proof.
  intros f f' x y Hxy D.
  destruct (MVT_cor2 f f' x y Hxy) as [z [E Hz]].
  - intros z Hz; apply is_derive_Reals, D, Hz.
  - exists z; split; assumption.
Qed.

(* By the mean value theorem on either side of c. *)
Theorem derivative_positive_then_negative : forall (f f' : R -> R) u c v,
  u < c < v -> (forall x, u < x < v -> is_derive f x (f' x)) ->
  (forall x, u < x < c -> 0 < f' x) -> (forall x, c < x < v -> f' x < 0) ->
  rises_then_falls f u c v.
Proof.
  intros f f' u c v Hc D Pos Neg; split; intros x y H1 H2 H3.
  - destruct (mean_value f f' x y) as [z [Hz E]]; [lra|intros; apply D; lra|].
    pose proof (Rmult_lt_0_compat (f' z) (y - x) (Pos z ltac:(lra)) ltac:(lra)); lra.
  - destruct (mean_value f f' x y) as [z [Hz E]]; [lra|intros; apply D; lra|].
    pose proof (Neg z ltac:(lra)).
    pose proof (Rmult_lt_0_compat (- f' z) (y - x) ltac:(lra) ltac:(lra)); lra.
Qed.

Theorem derivative_negative_then_positive : forall (f f' : R -> R) u c v,
  u < c < v -> (forall x, u < x < v -> is_derive f x (f' x)) ->
  (forall x, u < x < c -> f' x < 0) -> (forall x, c < x < v -> 0 < f' x) ->
  falls_then_rises f u c v.
Proof.
  intros f f' u c v Hc D Neg Pos; split; intros x y H1 H2 H3.
  - destruct (mean_value f f' x y) as [z [Hz E]]; [lra|intros; apply D; lra|].
    pose proof (Neg z ltac:(lra)).
    pose proof (Rmult_lt_0_compat (- f' z) (y - x) ltac:(lra) ltac:(lra)); lra.
  - destruct (mean_value f f' x y) as [z [Hz E]]; [lra|intros; apply D; lra|].
    pose proof (Rmult_lt_0_compat (f' z) (y - x) (Pos z ltac:(lra)) ltac:(lra)); lra.
Qed.

Theorem rises_then_falls_has_one_maximiser : forall f u c v,
  u < c < v -> rises_then_falls f u c v -> only_maximiser f u v c.
Proof.
  intros f u c v Hc [Rise Fall]; split; [exact Hc|]; intros x Hx N.
  destruct (Rtotal_order x c) as [L|[E|L]]; [apply Rise|contradiction|apply Fall]; lra.
Qed.

Theorem falls_then_rises_has_one_minimiser : forall f u c v,
  u < c < v -> falls_then_rises f u c v -> only_minimiser f u v c.
Proof.
  intros f u c v Hc [Fall Rise]; split; [exact Hc|]; intros x Hx N.
  destruct (Rtotal_order x c) as [L|[E|L]]; [apply Fall|contradiction|apply Rise]; lra.
Qed.

Lemma maximiser_is_unique : forall f u v c d, only_maximiser f u v c -> only_maximiser f u v d -> c = d.
Proof.
  intros f u v c d [Hc Mc] [Hd Md]; destruct (Req_dec c d) as [E|N]; [exact E|].
  pose proof (Mc d Hd ltac:(auto)); pose proof (Md c Hc N); lra.
Qed.

Lemma minimiser_is_unique : forall f u v c d, only_minimiser f u v c -> only_minimiser f u v d -> c = d.
Proof.
  intros f u v c d [Hc Mc] [Hd Md]; destruct (Req_dec c d) as [E|N]; [exact E|].
  pose proof (Mc d Hd ltac:(auto)); pose proof (Md c Hc N); lra.
Qed.

Lemma maximiser_only_depends_on_values : forall f g u v c,
  (forall x, u < x < v -> f x = g x) -> only_maximiser f u v c -> only_maximiser g u v c.
Proof.
  intros f g u v c E [Hc M]; split; [exact Hc|]; intros x Hx N.
  rewrite <- !E by assumption; apply M; assumption.
Qed.

Lemma shape_only_depends_on_values : forall f g u c v,
  u < c < v -> (forall x, u < x < v -> f x = g x) -> rises_then_falls f u c v -> rises_then_falls g u c v.
Proof.
  intros f g u c v Hc E [Rise Fall]; split; intros x y H1 H2 H3.
  - rewrite <- !E by lra; apply Rise; assumption.
  - rewrite <- !E by lra; apply Fall; assumption.
Qed.
