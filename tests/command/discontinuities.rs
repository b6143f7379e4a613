//! `infoscene discontinuities`: keys, figures, refusals.

use crate::refusals::assert_refused;
use crate::{json, stdout};

const HALF_PLANE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/half-plane.vs3");
const TILTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/tilted.vs3");

#[test]
fn lines_of_discontinuity_have_their_keys() {
    let answer = json(&[
        "discontinuities",
        HALF_PLANE,
        "--patch",
        "floor",
        "--from",
        "ceiling",
    ]);
    assert_eq!((&answer["patch"], &answer["from"]), (&0.into(), &1.into()));
    assert_eq!(answer["may_have_curves"], false);
    let lines = answer["lines"].as_array().unwrap();
    assert_eq!(lines.len(), 2);
    // c/(1 − h), and the whole percents of an independent program
    let umbra = lines.iter().find(|line| line["kind"] == "umbra").unwrap();
    let x = umbra["ends"][0][0].as_f64().unwrap();
    assert!((x - 0.625).abs() < 1e-12);
    assert_eq!((100.0 * umbra["kept"].as_f64().unwrap()).round(), 92.0);
    for key in ["gain", "square_gain", "square_kept"] {
        assert!(umbra[key].as_f64().unwrap() > 0.0, "{key}");
    }
    assert!(umbra["sides"].as_array().unwrap().contains(&"dark".into()));
    let made_by = umbra["made_by"][0].as_str().unwrap();
    assert!(made_by.contains("of half-plane"), "{made_by}");
    // six decimals of the same prototype
    let best = &answer["best"][0];
    assert_eq!(best["axis"], "u");
    for (key, printed) in [("position", 0.568_324), ("square_position", 0.510_320)] {
        assert!(
            (best[key].as_f64().unwrap() - printed).abs() <= 1.5e-6,
            "{key}"
        );
    }
}

#[test]
fn lines_of_discontinuity_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let [map, gain] = ["map.svg", "gain.svg"].map(path);
    let figures = ["--figure", &map, "--gain-u", &gain];
    let question = ["discontinuities", HALF_PLANE, "--patch", "0", "--from", "1"];
    let table = stdout(&[question.as_slice(), &figures].concat());
    assert!(
        table.contains("umbra") && table.contains("best cut across u"),
        "{table}"
    );
    for (path, name) in [
        (map, "line of discontinuity: umbra"),
        (gain, "share of the best"),
    ] {
        let text = std::fs::read_to_string(path).unwrap();
        assert!(text.starts_with("<svg") && text.contains(name));
    }
}

#[test]
fn a_patch_has_no_lines_against_itself_or_without_occlusion() {
    let question = ["discontinuities", TILTED, "--patch", "0", "--from"];
    assert_refused(&[question.as_slice(), &["0"]].concat(), "against itself");
    let bare = json(&[question.as_slice(), &["1", "--unoccluded"]].concat());
    assert!(bare["lines"].as_array().unwrap().is_empty());
    assert_refused(&[question.as_slice(), &["nothing"]].concat(), "nothing");
}
