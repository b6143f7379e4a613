//! Bad input: a message that names the mend, exit status 2, and nothing written.

use crate::infoscene;

pub(crate) fn assert_refused(arguments: &[&str], message: &str) {
    let assertion = infoscene(arguments).assert().code(2);
    let output = assertion.get_output();
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.stdout.is_empty(), "{arguments:?} wrote something");
    assert!(error.contains(message), "{arguments:?} says: {error}");
}

#[test]
fn bad_arguments_are_refused() {
    assert_refused(&["reproduce", "fig9"], "there is no claim \"fig9\"");
    assert_refused(
        &["reproduce", "fig2-paralel-cut"],
        "the nearest is \"fig2-parallel-cut\"",
    );
    assert_refused(&["curve", "theorem-1"], "these have one: fig1-dark-part");
    for exponent in ["0", "-1", "NaN", "inf"] {
        assert_refused(&["cut", "--exponent", exponent], "it must be > 0");
        let both = ["cut", "--exponent", "1", "--irradiance-exponent", exponent];
        assert_refused(&both, "it must be > 0");
    }
    assert_refused(&["cut", "--exponent", "one"], "invalid value");
    assert_refused(&["cut"], "--exponent");
    let of_first = |scene, more: &[&str], says| {
        assert_refused(&[&["split", scene, "--patch", "0"], more].concat(), says);
    };
    of_first("sphere", &[], "two-squares, three-squares, cube:N");
    assert_refused(&["split", "cube:1", "--patch", "6"], "patches 0 to 5");
    of_first("cube:1", &["--against", "0"], "against itself");
    of_first("cube:2", &["--against", "1"], "exchanges nothing");
    of_first("two-squares", &["--parts", "1"], "2..=64");
    of_first("two-squares", &["--against", "7"], "no patch 7");
    assert_refused(
        &["reproduce", "theorem-1", "--printed"],
        "none of the claims named",
    );
    assert_refused(&["reproduce", "--threads", "0"], "1..");
    let twice = ["split", "cube:1", "--patch", "0", "--against", "1,1"];
    assert_refused(&twice, "named twice");
    assert_refused(&["fuzz", "--cases", "0"], "1..");
    assert_refused(&["fuzz", "--states", "1"], "2..=64");
    assert_refused(&["fuzz", "--cases", "-3"], "unexpected argument");
    assert_refused(&["study", "astrology"], "stability");
    assert_refused(&["frobnicate"], "unrecognized subcommand");
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
        "the scene has patches 0 to 1\n",
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
