//! Ways to talk `proofs/check` round, each on a small project that is sound without it: one file
//! of the library, one of statements, one decimal.
//!
//! Those that are seen in the text are tried without Coq. Those that only Coq sees, and the second
//! line of defence behind the words, are ignored unless asked for.

use crate::folder;
use std::fs;
use std::path::Path;
use std::process::Command;

const LIBRARY: &str = "From Coq Require Import Reals Lra.
Open Scope R_scope.
Definition half (x : R) : R := x / 2.
Theorem two_halves : forall x, half x + half x = x.
Proof. intros. unfold half. lra. Qed.
";

const STATEMENTS: &str = "From Coq Require Import Reals.
From Infoscene Require Import Halves.
Open Scope R_scope.

Theorem two_halves : forall x, half x + half x = x.
Proof. exact Halves.two_halves. Qed.
";

const COLLECTION: &str = "From Infoscene Require Export One.\n";

/// A notation under which `let _ := @name in …`, by which all theorems are asked for, names none.
const SWALLOW: &str = "Notation \"'let' '_' ':=' x 'in' y\" := y \
                       (at level 200, x at level 200, y at level 200).\n";

/// The library with a false theorem, by a function that never ends.
const FALSE_LIBRARY: &str = "From Coq Require Import Reals Lra.
Open Scope R_scope.
Unset Guard Checking.
Fixpoint endless (n : nat) : 1 = 2 := endless n.
Set Guard Checking.
Theorem one_is_two : 1 = 2.
Proof. exact (endless 0). Qed.
";

const FALSE_STATEMENTS: &str = "From Coq Require Import Reals.
From Infoscene Require Import Halves.
Open Scope R_scope.

Theorem two_halves : 1 = 2.
Proof. exact Halves.one_is_two. Qed.
";

/// A sound project in which some files say something else.
struct Project {
    root: tempfile::TempDir,
}

impl Project {
    fn with(changes: &[(&str, &str)]) -> Self {
        let root = tempfile::tempdir().unwrap();
        let project = Self { root };
        for own in ["check", "words.awk"] {
            let name = format!("proofs/{own}");
            project.write(&name, &fs::read_to_string(folder(&name)).unwrap());
        }
        let decimals = "name,lower,upper,theorem\nx,0.4,0.6,two_halves\n";
        project.write("data/proved_decimals.csv", decimals);
        project.write("proofs/gain/Halves.v", LIBRARY);
        project.write("proofs/statements/One.v", STATEMENTS);
        project.write("proofs/Statements.v", COLLECTION);
        assert!(project.check(&["--write-decimals"]).is_ok());
        for (name, text) in changes {
            project.write(&format!("proofs/{name}"), text);
        }
        project
    }

    fn path(&self) -> &Path {
        self.root.path()
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// What the check prints, of both streams, as success or failure.
    fn check(&self, arguments: &[&str]) -> Result<String, String> {
        let check = self.path().join("proofs/check");
        let done = Command::new("bash")
            .arg(check)
            .args(arguments)
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&done.stdout) + String::from_utf8_lossy(&done.stderr);
        if done.status.success() {
            Ok(said.into_owned())
        } else {
            Err(said.into_owned())
        }
    }

    /// The project with the reading of words switched off: what Coq itself then shows.
    fn unread(&self) -> &Self {
        self.write("proofs/words.awk", "BEGIN { exit 0 }\n");
        self
    }
}

/// Asserts that a project is refused from its text alone, for a reason.
fn refused(changes: &[(&str, &str)], reason: &str) {
    let said = Project::with(changes).check(&["--words"]);
    let said = said.expect_err("the cheat passes");
    assert!(said.contains(reason), "{said}");
}

/// A line in front of the statements' first theorem.
fn before_the_theorem(line: &str) -> String {
    STATEMENTS.replace("\nTheorem", &format!("\n{line}\nTheorem"))
}

#[test]
fn a_sound_project_passes() {
    let said = Project::with(&[]).check(&["--words"]).unwrap();
    assert!(said.contains("1 theorems are stated"), "{said}");
}

#[test]
fn a_notation_that_swallows_the_theorems_is_refused() {
    let statements = format!("{STATEMENTS}{SWALLOW}");
    refused(&[("statements/One.v", &statements)], "Notation in a file");
    let collection = format!("{COLLECTION}{SWALLOW}");
    refused(
        &[("Statements.v", &collection)],
        "a collection holds one Require Export",
    );
    let library = format!("{LIBRARY}{SWALLOW}");
    refused(&[("gain/Halves.v", &library)], "Notation is not among");
}

#[test]
fn a_notation_that_changes_a_statement_is_refused() {
    for line in [
        "Local Notation half := (fun _ : R => 7).",
        "Infix \"+\" := Rminus.",
        "#[local] Notation half := Rabs.",
        "Local Open Scope nat_scope.",
        "Delimit Scope nat_scope with R.",
        "Ltac anything := exact True.",
        "Definition half (x : R) := x.",
        "Arguments half {x}.",
        "Set Implicit Arguments.",
        "Coercion INR : nat >-> R.",
    ] {
        refused(
            &[("statements/One.v", &before_the_theorem(line))],
            "in a file of statements",
        );
    }
    for word in ["Declare", "Unset"] {
        let line = format!("{word} Scope other.");
        refused(&[("statements/One.v", &before_the_theorem(&line))], word);
    }
    let library = LIBRARY.replace(
        "Theorem",
        "Notation \"x = y\" := (x = x \\/ x = y).\nTheorem",
    );
    refused(&[("gain/Halves.v", &library)], "Notation is not among");
    let library = LIBRARY.replace("Theorem", "Local Notation half := Rabs.\nTheorem");
    refused(&[("gain/Halves.v", &library)], "outside a section");
}

/// What a definition can bring along.
#[test]
fn a_notation_or_a_coercion_inside_a_definition_is_refused() {
    let notation = "Fixpoint f (n : nat) : nat := n where \"x = y\" := (x = x).\n";
    let library = format!("{LIBRARY}{notation}");
    refused(&[("gain/Halves.v", &library)], "a notation behind where");
    let library = format!("{LIBRARY}Record r := {{ f :> nat }}.\n");
    refused(&[("gain/Halves.v", &library)], "a coercion");
}

#[test]
fn a_second_theorem_on_a_line_is_refused() {
    let second = "Qed. Theorem other : 1 = 1. Proof. reflexivity. Qed.";
    let statements = STATEMENTS.replace("Qed.", second);
    refused(
        &[("statements/One.v", &statements)],
        "does not begin its line",
    );
}

#[test]
fn a_statement_made_by_a_tactic_is_refused() {
    let statements = STATEMENTS.replace("forall x, half x + half x = x", "ltac:(exact True)");
    refused(&[("statements/One.v", &statements)], "ltac");
}

#[test]
fn a_command_inside_a_proof_is_refused() {
    let command = "Proof. Unset Guard Checking. exact";
    let statements = STATEMENTS.replace("Proof. exact", command);
    refused(&[("statements/One.v", &statements)], "Unset");
    let command = "Proof. Local Notation half := Rabs. exact";
    let statements = STATEMENTS.replace("Proof. exact", command);
    refused(&[("statements/One.v", &statements)], "Local in a proof");
    let hidden = STATEMENTS.replace("Proof. exact", "Proof. idtac... Set Printing All. exact");
    refused(&[("statements/One.v", &hidden)], "a sentence could hide");
}

#[test]
fn an_assumption_is_refused() {
    for (line, reason) in [
        ("Axiom false : 1 = 2.", "Axiom"),
        ("Parameter false : 1 = 2.", "Parameter"),
        ("Variable false : 1 = 2.", "Variable outside a section"),
        ("Declare Module M : T.", "Declare"),
        ("Primitive int := #int63_type.", "Primitive"),
        ("Load \"elsewhere\".", "Load is not among"),
        (
            "Redirect \"all_theorems\" Print Assumptions half.",
            "Redirect",
        ),
    ] {
        refused(&[("gain/Halves.v", &format!("{LIBRARY}{line}\n"))], reason);
    }
    let library = LIBRARY.replace("lra. Qed.", "lra. Admitted.");
    refused(&[("gain/Halves.v", &library)], "Admitted");
    let library = LIBRARY.replace("Proof. intros. unfold half. lra. Qed.", "");
    refused(&[("gain/Halves.v", &library)], "two_halves has no proof");
}

#[test]
fn names_of_axioms_and_names_given_twice_are_refused() {
    let library = "Definition classic : Prop := True.\n";
    refused(
        &[("gain/Other.v", library)],
        "classic is the name of an axiom",
    );
    refused(&[("gain/Classical_Prop.v", "")], "like that of an axiom");
    let library = "Definition half : Prop := True.\n";
    refused(&[("gain/Other.v", library)], "defined twice: half");
    refused(&[("chains/Halves.v", "")], "two files are named Halves.v");
}

#[test]
fn a_file_of_statements_that_is_not_collected_is_refused() {
    refused(&[("statements/Two.v", "")], "does not name every file");
}

/// With the words unread, Coq's own answer still gives each cheat away.
#[test]
#[ignore = "needs Coq, half a minute: cargo test --test proofs -- --ignored"]
fn what_coq_prints_gives_cheats_away() {
    let sound = Project::with(&[]);
    let said = sound.check(&["--each"]).unwrap();
    assert!(
        said.contains("ok  two_halves: ClassicalDedekindReals.sig_forall_dec"),
        "{said}"
    );

    let swallowed = format!("{FALSE_STATEMENTS}{SWALLOW}");
    let project = Project::with(&[
        ("gain/Halves.v", FALSE_LIBRARY),
        ("statements/One.v", &swallowed),
    ]);
    for arguments in [&[][..], &["--each"]] {
        let said = project.unread().check(arguments).unwrap_err();
        assert!(said.contains("BAD two_halves"), "{said}");
    }

    // A function that never ends, named like the axiom of the excluded middle.
    let named = FALSE_LIBRARY.replace("endless", "classic");
    let named_statements = FALSE_STATEMENTS.replace("Halves.", "Classical_Prop.");
    let named_statements = named_statements.replace("Import Halves", "Import Classical_Prop");
    let project = Project::with(&[
        ("gain/Classical_Prop.v", &named),
        ("statements/One.v", &named_statements),
    ]);
    let said = project.unread().check(&[]).unwrap_err();
    assert!(said.contains("BAD two_halves"), "{said}");
}

#[test]
#[ignore = "needs Coq, half a minute: cargo test --test proofs -- --ignored"]
fn an_empty_list_of_assumptions_is_a_failure() {
    let nothing = [
        (
            "gain/Halves.v",
            "Theorem nothing : True.\nProof. exact I. Qed.\n",
        ),
        (
            "statements/One.v",
            "From Infoscene Require Import Halves.\n\nTheorem two_halves : True.\n\
             Proof. exact Halves.nothing. Qed.\n",
        ),
    ];
    let said = Project::with(&nothing).check(&[]).unwrap_err();
    assert!(said.contains("Closed under the global context"), "{said}");
}

#[test]
#[ignore = "needs Coq, half a minute: cargo test --test proofs -- --ignored"]
fn a_name_of_a_library_is_not_defined_again() {
    let library = LIBRARY.replace("half", "ln");
    let statements = STATEMENTS.replace("half", "ln");
    let project = Project::with(&[
        ("gain/Halves.v", &library),
        ("statements/One.v", &statements),
    ]);
    let said = project.check(&[]).unwrap_err();
    assert!(
        said.contains("a name of a library is defined again"),
        "{said}"
    );
}
