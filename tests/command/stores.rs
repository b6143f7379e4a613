//! `form-factor --store` and `store check`.

use super::{infoscene, json};
use std::fs;

fn failure(arguments: &[&str]) -> (Option<i32>, String) {
    let output = infoscene(arguments).output().unwrap();
    let text = String::from_utf8(output.stderr).unwrap();
    (output.status.code(), text)
}

#[test]
fn a_store_is_filled_in_shares_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("store");
    let store = path.to_str().unwrap();
    let part = json(&["form-factor", "cube:5", "--store", store, "--shard", "2/2"]);
    assert_eq!((&part["tiles"], &part["written"]), (&6.into(), &3.into()));
    let (status, text) = failure(&["form-factor", "cube:5", "--store", store]);
    assert!(
        status == Some(2) && text.contains("--resume goes on with it"),
        "{text}"
    );
    let unfinished = infoscene(&["store", "check", store, "--format", "json"])
        .output()
        .unwrap();
    assert_eq!(unfinished.status.code(), Some(1));
    let state: serde_json::Value = serde_json::from_slice(&unfinished.stdout).unwrap();
    assert_eq!(
        (&state["missing"], &state["least_sum"]),
        (&3.into(), &serde_json::Value::Null)
    );
    let rest = json(&["form-factor", "cube:5", "--store", store, "--resume"]);
    assert_eq!((&rest["found"], &rest["written"]), (&3.into(), &3.into()));
    let state = json(&["store", "check", store]);
    assert_eq!(
        (&state["rows"], &state["missing"], &state["broken"]),
        (&150.into(), &0.into(), &0.into())
    );
    let metadata = fs::read_to_string(path.join("form_factors/zarr.json")).unwrap();
    let metadata: serde_json::Value = serde_json::from_str(&metadata).unwrap();
    assert_eq!(
        (&metadata["zarr_format"], &metadata["shape"][1]),
        (&3.into(), &150.into())
    );
}

/// What is asked of a store is what is asked of the scene; a store that is not whole, or of another
/// scene, is refused with the mend.
#[test]
fn a_store_answers() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("store");
    let store = path.to_str().unwrap();
    let measure = ["measure", "cube:5", "--store", store];
    let (status, text) = failure(&measure);
    assert!(status == Some(2) && text.contains("is no store"), "{text}");
    json(&["form-factor", "cube:5", "--store", store, "--shard", "1/2"]);
    let (status, text) = failure(&measure);
    let mend = "fill it first, with form-factor --store and --resume";
    assert!(status == Some(2) && text.contains(mend), "{text}");
    json(&["form-factor", "cube:5", "--store", store, "--resume"]);
    let [over, held] = [&measure[..], &measure[..2]].map(json);
    let number = |answer: &serde_json::Value, key: &str| answer[key].as_f64().unwrap();
    let key = "mutual_information";
    let error = |answer| number(answer, "mutual_information_error");
    let off = (number(&over, key) - number(&held, key)).abs();
    assert!(off <= error(&over) + error(&held), "{off}");
    // faces of 25 patches see those of the five others
    assert_eq!(over["plan"]["stored"], 15 * 25 * 25);
    let light = [
        "--reflectance",
        "all=0.75",
        "--emittance",
        "all=1",
        "--store",
        store,
    ];
    // even light makes the radiosity chain the visibility chain (§3.4)
    let even = json(&[&measure[..2], &["--chain", "radiosity"], &light].concat());
    let off = (number(&even, key) - number(&held, key)).abs();
    assert!(off <= error(&even) + error(&held) && off < 1e-12, "{off}");
    let radiosity = json(&[&["radiosity", "cube:5"][..], &light].concat());
    for patch in radiosity["patches"].as_array().unwrap() {
        // a furnace: E/(1 − R)
        assert!((number(patch, "radiosity") - 4.0).abs() < 1e-10);
    }
    for (arguments, words) in [
        (
            vec!["measure", "cube:6", "--store", store],
            "holds another matrix",
        ),
        (
            vec!["measure", "cube:5", "--store", store, "--tolerance", "1e-9"],
            "tolerance",
        ),
        (
            vec!["measure", "cube:5", "--store", store, "--sample", "9"],
            "cannot be used with",
        ),
        (vec!["radiosity", "cube:5", "--resume"], "--store"),
    ] {
        let (status, text) = failure(&arguments);
        assert!(
            status == Some(2) && text.contains(words),
            "{arguments:?}: {text}"
        );
    }
}

#[test]
fn wrong_stores_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().to_str().unwrap();
    for (arguments, words) in [
        (
            vec!["form-factor", "cube:1", "--store", path, "--from", "0"],
            "cannot be used with",
        ),
        (vec!["form-factor", "cube:1", "--shard", "1/2"], "--store"),
        (
            vec!["form-factor", "cube:1", "--store", path, "--shard", "0/2"],
            "K/N",
        ),
        (vec!["store", "check", path], "is no store"),
    ] {
        let (status, text) = failure(&arguments);
        assert!(
            status == Some(2) && text.contains(words),
            "{arguments:?}: {text}"
        );
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}
