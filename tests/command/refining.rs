//! `infoscene refine`: keys, refusals, threads, nets.

use crate::refusals::assert_refused;
use crate::{json, stdout};
use serde_json::Value;

const CUBE: [&str; 4] = ["refine", "lit-cube", "--elements", "60"];

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [CUBE.as_slice(), more].concat()
}

#[test]
fn steps_and_patches_have_their_keys() {
    let answer = json(&CUBE);
    assert_eq!(
        (&answer["oracle"], &answer["scene"], &answer["linear"]),
        (&"gradient".into(), &"lit-cube".into(), &false.into())
    );
    let steps = answer["steps"].as_array().unwrap();
    let count = |step: &Value, key: &str| step[key].as_u64().unwrap();
    // the patches alone come first
    assert_eq!(count(&steps[0], "elements"), 10);
    assert!(count(&steps[steps.len() - 1], "elements") >= 60);
    for step in steps {
        assert!(count(step, "links") <= count(step, "evaluations"));
        for key in ["seconds", "error_estimate", "mutual_information"] {
            assert!(step[key].as_f64().unwrap() >= 0.0, "{key}");
        }
        assert!(step.as_object().unwrap().contains_key("error_bound"));
    }
    let patches = answer["patches"].as_array().unwrap();
    let light = patches
        .iter()
        .find(|patch| patch["name"] == "light")
        .unwrap();
    // it emits 1 and reflects nothing: a quarter of the ceiling's edge, squared
    assert_eq!(
        (&light["radiosity"], &light["area"]),
        (&1.0.into(), &0.0625.into())
    );
    let elements: u64 = patches.iter().map(|patch| count(patch, "elements")).sum();
    assert_eq!(elements, count(&steps[steps.len() - 1], "elements"));
    for patch in patches {
        assert!(patch["irradiance"].as_f64().is_some() && patch["index"].is_u64());
    }
}

#[test]
fn other_goals_are_reached() {
    let last = |arguments: &[&str], key: &str| {
        let answer = json(arguments);
        answer["steps"].as_array().unwrap().last().unwrap()[key]
            .as_f64()
            .unwrap()
    };
    let cube = ["refine", "lit-cube"];
    assert!(last(&[cube.as_slice(), &["--links", "500"]].concat(), "links") >= 500.0);
    let error = [cube.as_slice(), &["--error", "0.15"]].concat();
    assert!(last(&error, "error_estimate") <= 0.15);
    // the estimate is of constants, the bound of what is asked for
    let linear = json(&with(&["--linear"]));
    assert!(linear["steps"][0]["error_estimate"].is_null());
    let steps = linear["steps"].as_array().unwrap();
    assert!(steps.last().unwrap()["error_bound"].as_f64().unwrap() > 0.0);
}

#[test]
fn the_answer_does_not_depend_on_threads_but_for_the_time() {
    let timeless = |threads: &str| {
        let mut answer = json(&with(&["--threads", threads]));
        for step in answer["steps"].as_array_mut().unwrap() {
            step["seconds"] = Value::Null;
        }
        answer.to_string()
    };
    assert_eq!(timeless("1"), timeless("2"));
}

#[test]
fn steps_are_rows_of_a_table() {
    let table = stdout(&CUBE);
    for text in [
        "elements",
        "links",
        "error, bound",
        "unknown",
        "oracle: gradient",
        "(light)",
    ] {
        assert!(table.contains(text), "{text}: {table}");
    }
    let csv = stdout(&with(&["--format", "csv"]));
    assert!(csv.starts_with("elements,links,evaluations,seconds,error_bound,"));
}

#[test]
fn walls_are_drawn_unfolded() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("net.svg");
    let path = path.to_str().unwrap();
    let drawn = |more: &[&str]| {
        stdout(&with(&[&["--figure", path], more].concat()));
        std::fs::read_to_string(path).unwrap()
    };
    let net = drawn(&[]);
    assert!(net.starts_with("<svg"));
    for name in [
        "floor",
        "ceiling",
        "left",
        "right",
        "front",
        "back",
        "radiosity",
    ] {
        assert!(net.contains(name), "{name}");
    }
    assert!(!net.contains("receiver"));
    let [meshed, linked, linear] = [
        ["--mesh"].as_slice(),
        &["--links-of", "floor"],
        &["--linear"],
    ]
    .map(drawn);
    assert!(meshed.len() > net.len() && linear.len() > net.len());
    assert!(linked.contains("receiver"));
}

#[test]
fn what_cannot_be_refined_is_refused() {
    let refused: [(&[&str], &str); 12] = [
        (
            &["refine", "lit-cube"],
            "--elements <N>|--links <N>|--error <REL>",
        ),
        (&with(&["--links", "5"]), "cannot be used with"),
        (&with(&["--oracle", "delphi"]), "gradient"),
        (
            &["refine", "lit-cube", "--elements", "9"],
            "ask for 10 at least",
        ),
        (&["refine", "lit-cube", "--error", "0"], "it must be > 0"),
        (&["refine", "lit-cube", "--error", "NaN"], "it must be > 0"),
        (
            &["refine", "lit-cube", "--error", "0.1", "--linear"],
            "by --elements or --links",
        ),
        (
            &with(&["--reflectance", "floor=0.1:0.2:0.3"]),
            "computed by itself: name one with --channel r, g or b",
        ),
        (
            &with(&["--emittance", "all=0"]),
            "no patch has a positive emittance",
        ),
        (
            &with(&["--reflectance", "floor=1"]),
            "patch 0 reflects all light",
        ),
        (&with(&["--links-of", "floor"]), "--figure"),
        (
            &with(&["--figure", "none/net.svg"]),
            "its folder does not exist",
        ),
    ];
    for (arguments, message) in refused {
        assert_refused(arguments, message);
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("net.svg");
    let unknown = with(&["--figure", path.to_str().unwrap(), "--links-of", "flor"]);
    assert_refused(&unknown, "did you mean \"floor\"?");
    assert!(!path.exists());
}

#[test]
fn light_is_gathered_once_more() {
    let patches = |arguments: &[&str]| json(arguments)["patches"].as_array().unwrap().clone();
    let fine = patches(&["refine", "lit-cube", "--elements", "4000"]);
    let number = |patch: &Value, key: &str| patch[key].as_f64().unwrap();
    for (coarse, fine) in patches(&with(&["--gather"])).iter().zip(&fine) {
        let off = number(coarse, "gathered") / number(fine, "radiosity") - 1.0;
        // the light that is gathered is that of 60 elements, some percent off
        assert!(off.abs() < 0.05, "{coarse} {fine}");
        assert!(coarse["name"] != "light" || coarse["gathered"] == 1.0);
    }
    assert!(fine.iter().all(|patch| patch.get("gathered").is_none()));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("net.svg");
    stdout(&with(&["--gather", "--figure", path.to_str().unwrap()]));
    assert!(std::fs::read_to_string(path).unwrap().contains("radiosity"));
}

#[test]
fn elements_are_cut_for_the_patches_that_matter() {
    let steps = |more: &[&str]| json(&with(more))["steps"].clone();
    let driven = steps(&["--importance", "floor"]);
    let links = |steps: &Value| {
        let last = steps.as_array().unwrap().last().unwrap().clone();
        last["links"].as_u64().unwrap()
    };
    assert_ne!(links(&driven), links(&steps(&[])));
    assert_refused(&with(&["--importance", "flor"]), "did you mean");
    let nothing = with(&["--importance", "floor=0"]);
    assert_refused(&nothing, "no patch has a positive direct importance");
}

#[test]
fn a_patch_in_another_one_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rug.vs3");
    let scene = "T a rug on a floor, and a ceiling\nF 3\n\
                 V 1 0 0 0\nV 2 3 0 0\nV 3 3 3 0\nV 4 0 3 0\n\
                 V 5 1 1 0\nV 6 2 1 0\nV 7 2 2 0\nV 8 1 2 0\n\
                 V 9 0 0 3\nV 10 3 0 3\nV 11 3 3 3\nV 12 0 3 3\n\
                 S 1 1 2 3 4 0 0 0.5 floor\nS 2 5 6 7 8 1 0 0.5 rug\n\
                 S 3 12 11 10 9 0 0 0.5 ceiling\nEnd of data\n";
    std::fs::write(&path, scene).unwrap();
    let light = "all=0,ceiling=1";
    let path = path.to_str().unwrap();
    let question = ["refine", path, "--elements", "9", "--emittance", light];
    assert_refused(&question, "patch 1 lies in patch 0");
}
