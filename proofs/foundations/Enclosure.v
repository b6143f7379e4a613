(* Interval arithmetic for concrete inequalities between real numbers: the tactic `interval` of coq-interval, run on
   floating-point numbers made of Coq's own integers (no primitive machine floats or machine integers), so that what it
   proves rests on nothing beyond the axioms of Coq's reals.

   Use:   From Infoscene Require Import Enclosure.
          interval with (i_prec 90).
          interval with (i_prec 60, i_bisect t, i_autodiff t, i_depth 12).
   Give i_prec (bits of precision) on every call. Do not import Interval.Tactic beside it. *)
From Coq Require Import Reals Lra.
From Interval Require Specific_ops Specific_stdz Tactic.

Module Float_on_integers := Specific_ops.SpecificFloat Specific_stdz.StdZRadix2.
Module Enclosure_tactics := Tactic.IntervalTactic Float_on_integers.
Export Enclosure_tactics.

Notation i_prec := Tactic.i_prec (only parsing).
Notation i_bisect := Tactic.i_bisect (only parsing).
Notation i_autodiff := Tactic.i_autodiff (only parsing).
Notation i_taylor := Tactic.i_taylor (only parsing).
Notation i_degree := Tactic.i_degree (only parsing).
Notation i_depth := Tactic.i_depth (only parsing).
Notation i_decimal := Tactic.i_decimal (only parsing).

Open Scope R_scope.

(* An example. `Print Assumptions ln_2_to_eight_digits` lists only the axioms of the reals (not left here: it takes seconds). *)
Example ln_2_to_eight_digits : 69314718 / 10 ^ 8 < ln 2 < 69314719 / 10 ^ 8.
Proof. split; interval with (i_prec 90). Qed.
