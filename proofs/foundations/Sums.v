(* Finite sums: [sum n f] is f 0 + f 1 + ... + f (n-1). *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

Fixpoint sum (n : nat) (f : nat -> R) : R :=
  match n with
  | O => 0
  | S k => sum k f + f k
  end.
