# What a Coq file of this folder may say. Reads a file without comments and with strings emptied; prints every sentence that
# it may not hold, with its line, and exits 1 if there is one. With names=yes it also prints each name that the file adds.
#
#   awk -v file=NAME -v kind=library|statements|collection [-v names=yes] -f words.awk
#
# What is not listed here is refused, so that a command of Coq that nobody thought of is refused as well. What changes the
# meaning of a text elsewhere (notations, scopes, flags, implicit arguments) is not listed, nor is what assumes.

function refuse(why) { print "check: " file ", line " line ": " why; bad = 1 }

# The words of a sentence, in word[1 .. count]; letters, digits, underscore and prime belong to a word.
function split_words(text,   plain) {
  plain = text
  gsub(/[^A-Za-z0-9_\047]+/, " ", plain)
  sub(/^ /, "", plain)
  count = split(plain, word, " ")
}

# A sentence between Proof and Qed: tactics, which begin with a small letter behind bullets, braces and selectors.
function tactic(text) {
  gsub(/^([-+*{} \t]|[0-9, -]+:|all:)+/, "", text)
  if (text == "Qed" || text == "Defined") {
    if (text == "Defined" && kind != "library") refuse("Defined")
    inside = 0
    return
  }
  if (text != "" && text !~ /^[a-z(\[]/) refuse(word[1] " in a proof")
}

# A sentence outside proofs.
function command(text,   first, rest) {
  first = text; sub(/[^A-Za-z_#].*$/, "", first)
  rest = substr(text, length(first) + 1)
  if (awaited != "" && text != "Proof") { refuse(awaited " has no proof"); awaited = "" }
  if (text ~ /(^|[^A-Za-z0-9_\047])ltac *:/ && first != "Ltac") refuse("ltac in what is stated")
  if (kind == "collection") {
    if (text !~ /^From Infoscene Require Export [A-Za-z0-9_ ]+$/) refuse("a collection holds one Require Export: " first)
    return
  }
  if (text ~ /:>/) refuse("a coercion")
  if (text ~ /(^|[^A-Za-z0-9_\047])where *"/) refuse("a notation behind where")
  if (text == "Proof") { if (awaited == "") refuse("Proof of nothing"); awaited = ""; inside = 1; return }
  if (text == "Open Scope R_scope") return
  if (first ~ /^(Theorem|Lemma|Corollary|Example)$/ && kind == "library") { define(first, text); awaited = word[2]; return }
  if (first == "Theorem") {
    if (rest !~ /^ [a-z][A-Za-z0-9_\047]* *:/) refuse("a theorem is stated as Theorem name : ...")
    awaited = word[2]
    return
  }
  if (kind == "statements") {
    if (text ~ /^From Coq Require Import Reals$/ || text ~ /^From Coquelicot Require Import Coquelicot$/) return
    if (text ~ /^From Infoscene Require Import [A-Za-z0-9_ ]+$/) return
    refuse(first " in a file of statements")
    return
  }
  if (first ~ /^(Definition|Fixpoint|Record)$/) {
    define(first, text)
    if (first == "Definition" && text !~ /:=/) awaited = word[2]
    return
  }
  if (first == "Ltac") return
  if (first == "Section") { depth++; return }
  if (first == "End") { if (depth == 0) refuse("End of nothing"); depth--; return }
  if (first ~ /^(Variable|Variables|Hypothesis|Hypotheses|Let)$/) {
    if (depth == 0) refuse(first " outside a section")
    return
  }
  if (text ~ /^Local Notation [A-Za-z0-9_\047]+ :=/) {       # forgotten where the section ends
    if (depth == 0) refuse("Local Notation outside a section")
    return
  }
  # A shorter name for the same thing, and interval arithmetic applied to a kind of number.
  if (text ~ /^Notation [A-Za-z0-9_]+ := [A-Za-z0-9_.]+ \(only parsing\)$/ && word[2] == word[4]) return
  if (text ~ /^Module [A-Za-z0-9_]+ := [A-Za-z0-9_. ]+$/) return
  if (text ~ /^From (Coq|Coquelicot|Interval|Infoscene) Require (Import )?[A-Za-z0-9_. ]+$/) return
  if (text ~ /^From Infoscene Require Export [A-Za-z0-9_ ]+$/) return
  if (text ~ /^Export Enclosure_tactics$/) return
  refuse((first == "" ? substr(text, 1, 20) : first) " is not among the commands of this folder")
}

# The names that a sentence adds: its own and, of a record, its fields.
function define(first, text,   fields, k, number, list) {
  if (word[2] in reserved) refuse(word[2] " is the name of an axiom")
  if (names == "yes") print word[2], (first ~ /^(Theorem|Lemma|Corollary|Example)$/ ? "proved" : "defined")
  if (first != "Record") return
  fields = text
  sub(/^[^{]*{/, "", fields)
  number = split(fields, list, ";")
  for (k = 1; k <= number; k++) {
    sub(/^[ \t]+/, "", list[k])
    sub(/[^A-Za-z0-9_\047].*$/, "", list[k])
    if (list[k] in reserved) refuse(list[k] " is the name of an axiom")
    if (names == "yes") print list[k], "defined"
  }
}

function sentence(text,   k) {
  gsub(/[ \t]+/, " ", text); sub(/^ /, "", text); sub(/ $/, "", text)
  if (text == "") return
  split_words(text)
  for (k = 1; k <= count; k++) if (word[k] in never) refuse(word[k])
  if (inside) tactic(text); else command(text)
}

BEGIN {
  number = split("Admitted admit Admit give_up Abort Axiom Axioms Parameter Parameters Conjecture Conjectures" \
    " bypass_check Unset Declare Redirect Primitive Register", list, " ")
  for (k = 1; k <= number; k++) never[list[k]] = 1
  number = split("sig_not_dec sig_forall_dec functional_extensionality_dep classic", list, " ")
  for (k = 1; k <= number; k++) reserved[list[k]] = 1
  if (file ~ /(^|\/)(ClassicalDedekindReals|FunctionalExtensionality|Classical_Prop)[.]v$/)
    refuse("the file is named like that of an axiom")
}

{
  line = NR
  if ($0 ~ /[.][.][.]/ || $0 ~ /\r/) refuse("... or a carriage return, behind which a sentence could hide")
  rest = " " $0 " "
  while (match(rest, /[^.][.][ \t]/)) {                       # the end of a sentence, not the .. of a list
    sentence(held substr(rest, 1, RSTART))
    held = ""
    rest = substr(rest, RSTART + RLENGTH - 1)
  }
  held = held rest
}

END {
  sub(/[ \t]+$/, "", held)
  if (held !~ /^[ \t]*$/) refuse("an unfinished sentence")
  if (awaited != "") refuse(awaited " has no proof")
  if (inside) refuse("a proof has no end")
  if (depth > 0) refuse("a section has no end")
  exit bad
}
