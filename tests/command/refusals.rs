//! Bad input: a message that names the mend, exit status 2, and nothing written.

use crate::infoscene;

pub(crate) fn assert_refused(arguments: &[&str], message: &str) {
    let assertion = infoscene(arguments).assert().code(2);
    let output = assertion.get_output();
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.stdout.is_empty(), "{arguments:?} wrote something");
    assert!(error.contains(message), "{arguments:?} says: {error}");
}

/// Each line of arguments, separated by blanks, is refused with this message.
fn assert_all_refused(cases: &[(&str, &str)]) {
    for (line, message) in cases {
        let arguments: Vec<&str> = line.split(' ').collect();
        assert_refused(&arguments, message);
    }
}

#[test]
fn unknown_commands_and_studies_are_refused() {
    assert_all_refused(&[
        ("frobnicate", "unrecognized subcommand"),
        ("study astrology", "stability"),
    ]);
}

#[test]
fn unknown_claims_are_refused_with_the_nearest() {
    assert_all_refused(&[
        ("reproduce fig9", "there is no claim \"fig9\""),
        (
            "reproduce fig2-paralel-cut",
            "the nearest is \"fig2-parallel-cut\"",
        ),
    ]);
}

#[test]
fn claims_without_a_curve_or_a_number_are_refused() {
    assert_all_refused(&[
        ("curve theorem-1", "these have one: fig1-dark-part"),
        ("reproduce theorem-1 --printed", "none of the claims named"),
    ]);
}

#[test]
fn exponents_that_are_not_positive_are_refused() {
    for exponent in ["0", "-1", "NaN", "inf"] {
        assert_refused(&["cut", "--exponent", exponent], "it must be > 0");
        let both = ["cut", "--exponent", "1", "--irradiance-exponent", exponent];
        assert_refused(&both, "it must be > 0");
    }
    assert_all_refused(&[
        ("cut --exponent one", "invalid value"),
        ("cut", "--exponent"),
    ]);
}

#[test]
fn patches_that_cannot_be_split_or_judged_against_are_refused() {
    assert_all_refused(&[
        (
            "split sphere --patch 0",
            "two-squares, three-squares, cube:N",
        ),
        ("split cube:1 --patch 6", "index from 0 to 5"),
        ("split cube:1 --patch 0 --against 0", "against itself"),
        ("split cube:2 --patch 0 --against 1", "exchanges nothing"),
        ("split two-squares --patch 0 --against 7", "no patch \"7\""),
        ("split cube:1 --patch 0 --against 1,1", "named twice"),
    ]);
}

#[test]
fn counts_out_of_range_are_refused() {
    assert_all_refused(&[
        ("split two-squares --patch 0 --parts 1", "2..=64"),
        ("reproduce --threads 0", "1.."),
    ]);
}

#[test]
#[cfg(feature = "proptest")]
fn counts_of_cases_out_of_range_are_refused() {
    assert_all_refused(&[
        ("fuzz --cases 0", "1.."),
        ("fuzz --states 1", "2..=64"),
        ("fuzz --cases -3", "unexpected argument"),
    ]);
}

/// The library names the condition, the command the option that mends it; where none does, none is
/// named.
#[test]
fn a_refusal_names_the_option_that_mends_it() {
    assert_refused(
        &["reproduce", "fig9"],
        "; `infoscene reproduce` shows all ids\n",
    );
    let enclosed = ["split", "octahedron", "--patch", "0", "--precision", "128"];
    assert_refused(
        &enclosed,
        "or do without an enclosure; leave out --precision\n",
    );
    assert_refused(
        &["split", "two-squares", "--patch", "2"],
        "give its index from 0 to 1, or say all\n",
    );
}

#[test]
fn an_output_folder_that_is_not_there_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("missing").join("table.md");
    assert_refused(
        &["reproduce", "--output", path.to_str().unwrap()],
        "its folder does not exist",
    );
    let folder_itself = folder.path().to_str().unwrap();
    assert_refused(&["reproduce", "--output", folder_itself], "it is a folder");
    assert_eq!(
        folder.path().read_dir().unwrap().count(),
        0,
        "something was left behind"
    );
}

#[test]
fn an_output_file_is_replaced_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("table.json");
    std::fs::write(&path, "old").unwrap();
    let arguments = [
        "reproduce",
        "fig2-parallel-cut",
        "--format",
        "json",
        "--output",
        path.to_str().unwrap(),
    ];
    infoscene(&arguments).assert().success().stdout("");
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok());
    // links are followed, modes are kept
    #[cfg(unix)]
    {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let link = folder.path().join("link.json");
        symlink(&path, &link).unwrap();
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o600)).unwrap();
        let arguments = [
            "reproduce",
            "fig2-parallel-cut",
            "--format",
            "json",
            "--output",
            link.to_str().unwrap(),
        ];
        infoscene(&arguments).assert().success();
        assert!(link.symlink_metadata().unwrap().is_symlink());
        assert_eq!(path.metadata().unwrap().permissions().mode() & 0o777, 0o600);
        std::fs::remove_file(link).unwrap();
        infoscene(&["cut", "--exponent", "1", "--output", "/dev/null"])
            .assert()
            .success();
    }
    // a run that fails leaves it alone
    infoscene(&["cut", "--exponent", "0", "--output", path.to_str().unwrap()])
        .assert()
        .code(2);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
    assert_eq!(folder.path().read_dir().unwrap().count(), 1);
}
