//! Materials that are wrong or missing: a note where light is not asked for, an error where it is,
//! and an answer where `--reflectance` and `--emittance` say what the file does not.

use crate::infoscene;
use crate::refusals::assert_refused;
use assert_cmd::assert::Assert;
use serde_json::Value;
use tempfile::TempDir;

/// Two unit squares at distance 1, facing each other: analytic.
const FORM_FACTOR: f64 = 0.199_824_895_698_387_38;

/// The squares with these lines for materials, and a library beside them.
fn squares(materials: [&str; 2], library: &str) -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
    let [floor, ceiling] = materials;
    let text = format!("{corners}{floor}\nf 1 2 3 4\n{ceiling}\nf 5 8 7 6\n");
    std::fs::write(folder.path().join("room.obj"), text).unwrap();
    std::fs::write(folder.path().join("paint.mtl"), library).unwrap();
    let path = folder.path().join("room.obj");
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

fn answered(arguments: &[&str]) -> (Value, String) {
    let arguments = [arguments, &["--format", "json"]].concat();
    let assertion: Assert = infoscene(&arguments).assert().success();
    let output = assertion.get_output();
    let answer = serde_json::from_slice(&output.stdout).unwrap();
    (answer, String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn geometry_is_answered_whatever_the_materials() {
    for (materials, says) in [
        (["usemtl gold", "usemtl gold"], "there is no material gold"),
        (
            ["mtllib lost.mtl\nusemtl (null)", ""],
            "lost.mtl cannot be read",
        ),
        (["usemtl", ""], "the name of the material is missing"),
        (
            ["mtllib paint.mtl", "usemtl worse"],
            "the reflectance is 1.2",
        ),
        (
            ["mtllib paint.mtl", "usemtl twice"],
            "is defined twice and differently",
        ),
        (
            ["usemtl white\nmtllib paint.mtl", ""],
            "is used before \"mtllib\"",
        ),
    ] {
        let library = "newmtl white\nKd 1\nnewmtl worse\nKd 1.2 0 0\nnewmtl twice\nKd .5\n\
            newmtl twice\nKe 1\nKd .6\n";
        let (folder, room) = squares(materials, library);
        let (answer, notes) = answered(&["form-factor", &room, "--from", "0", "--to", "1"]);
        let value = answer["form_factors"][0]["value"].as_f64().unwrap();
        assert!((value / FORM_FACTOR - 1.0).abs() < 1e-12, "{value}");
        assert!(notes.contains(says), "{notes}");
        let (_, notes) = answered(&["measure", &room, "--open"]);
        assert!(notes.contains(says), "{notes}");
        for out in ["out.vs3", "out.obj"] {
            let out = folder.path().join(out);
            let out = out.to_str().unwrap();
            infoscene(&["convert", &room, out]).assert().success();
            let (again, _) = answered(&["form-factor", out, "--from", "0", "--to", "1"]);
            assert_eq!(again["form_factors"], answer["form_factors"]);
        }
    }
}

/// File, line, patch and condition; the options that mend it, each for what it gives.
#[test]
fn light_is_refused_until_the_materials_are_given() {
    let (_folder, room) = squares(
        ["mtllib paint.mtl\nusemtl bad", "usemtl gold"],
        "newmtl bad\nKd x\n",
    );
    let radiosity = ["radiosity", room.as_str()];
    let half = [&radiosity[..], &["--reflectance", "0=0.5"]].concat();
    assert_refused(&radiosity, "patch 0 (face 0) has no reflectance: ");
    assert_refused(&radiosity, "paint.mtl, line 2: the first channel is \"x\"");
    assert_refused(&half, "patch 1 (face 1) has no reflectance: ");
    assert_refused(&half, "room.obj, line 12: there is no material gold");
    assert_refused(&half, "; --reflectance gives one");
    let reflecting = [&radiosity[..], &["--reflectance", "all=0.5"]].concat();
    assert_refused(&reflecting, "patch 1 (face 1) has no emittance: ");
    assert_refused(&reflecting, "; --emittance gives one");
    let (answer, _) = answered(&[&reflecting[..], &["--emittance", "1=1"]].concat());
    let found = answer["patches"][1]["radiosity"].as_f64().unwrap();
    let exact = 1.0 / (1.0 - 0.25 * FORM_FACTOR * FORM_FACTOR);
    assert!((found / exact - 1.0).abs() < 1e-13, "{found}");
    // importance does not ask what is emitted
    let chain = [
        "--chain",
        "importance",
        "--importance",
        "0",
        "--reflectance",
        "all=0.5",
    ];
    answered(&[&["measure", &room], &chain[..]].concat());
    let chain = ["--chain", "radiosity", "--reflectance", "all=0.5"];
    assert_refused(
        &[&["measure", &room], &chain[..]].concat(),
        "has no emittance",
    );
}

/// B₀ = 1 + R₀ F B₁ and B₁ = R₁ F B₀, with R = 1 on one square or on both; a closed room of white
/// walls has no equilibrium.
#[test]
fn white_paint_shines_as_far_as_light_ends() {
    let (_folder, room) = squares(
        ["mtllib paint.mtl\nusemtl white", ""],
        "newmtl white\nKd 1 1 1\n",
    );
    let (answer, _) = answered(&["radiosity", &room, "--emittance", "0"]);
    let found = answer["patches"][0]["radiosity"].as_f64().unwrap();
    let exact = 1.0 / (1.0 - FORM_FACTOR * FORM_FACTOR);
    assert!((found / exact - 1.0).abs() < 1e-13, "{found}");
    let white = [
        "radiosity",
        "cube:1",
        "--reflectance",
        "all=1",
        "--emittance",
        "0",
    ];
    assert_refused(&white, "patches 0 (floor 0,0), 1 (ceiling 0,0)");
    assert_refused(&white, "let one reflect less than 1");
    let red = [
        "radiosity",
        "cube:1",
        "--reflectance",
        "all=1:0:0",
        "--emittance",
        "0",
    ];
    assert_refused(&red, "channel r: patches 0");
}

/// View3D: an emissivity of 0 is an adiabatic wall, one that cannot be is not known.
#[test]
fn emissivities_do_not_stop_geometry() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("room.vs3");
    let room = path.to_str().unwrap();
    let written = |emit: &str| {
        let text = format!(
            "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nV 6 1 0 1\nV 7 1 1 1\n\
             V 8 0 1 1\nS 1 1 2 3 4 0 0 {emit} floor\nS 2 5 8 7 6 0 0 0.5 ceiling\nEnd of data\n"
        );
        std::fs::write(&path, text).unwrap();
    };
    let light = ["radiosity", room, "--emittance", "1"];
    for (emit, reflectance) in [("0", Some(1.0)), ("1.5", None)] {
        written(emit);
        let (answer, _) = answered(&["form-factor", room, "--from", "0", "--to", "1"]);
        let value = answer["form_factors"][0]["value"].as_f64().unwrap();
        assert!((value / FORM_FACTOR - 1.0).abs() < 1e-12, "{value}");
        let Some(reflectance) = reflectance else {
            assert_refused(
                &light,
                "room.vs3, line 10, patch 0 (S 1, floor): the emissivity is 1.5",
            );
            continue;
        };
        let (answer, _) = answered(&light);
        let [floor, ceiling] = [0, 1].map(|i| answer["patches"][i]["radiosity"].as_f64().unwrap());
        assert!((floor / (reflectance * FORM_FACTOR * ceiling) - 1.0).abs() < 1e-13);
        let exact = 1.0 / (1.0 - 0.5 * reflectance * FORM_FACTOR * FORM_FACTOR);
        assert!((ceiling / exact - 1.0).abs() < 1e-13, "{ceiling}");
    }
}
