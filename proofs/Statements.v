(* Every theorem that README.md lists, stated again so that it can be read without the files that prove it, in the order of
   the paper: open a section in the folder statements.

     Section2.v              Section 2: an information-theoretic framework
     Section3Refinement.v    Sections 3.1 and 3.2: refinement of states, and the gain of a pair
     Section3Visibility.v    Section 3.3, visibility, and what sections 3.3 to 3.5 share
     Section3Radiosity.v     Section 3.4: radiosity
     Section3Importance.v    Section 3.5: importance
     Section4Squares.v       Section 4.1, figs. 2 and 3: squares with common edges
     Section4Gradient.v      Section 4.2: mutual information and mean square error
     Section5.v              Section 5: towards an oracle for subdivision
     Appendices.v            Appendices A and B: eqs. (9) to (14)

   The theorems named words_of_... say what the words of the others mean. "Proof. exact File.name." is the proof in File.v;
   what each theorem rests on is printed by proofs/check.

   n states are numbered 0 .. n-1. [sum n f] is f 0 + ... + f (n-1), [INR m] the number m as a real, [RInt f a b] the
   integral of f from a to b, [is_RInt f a b v] "it exists and is v", [is_derive f x d] "f has the derivative d at x",
   [Un_cv] convergence of a sequence, [is_lub] "is the least upper bound of". *)
From Infoscene Require Export Section2 Section3Refinement Section3Visibility Section3Radiosity
  Section3Importance Section4Squares Section4Gradient Section5 Appendices.
