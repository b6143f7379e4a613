//! Coloured light: each channel by itself, beside the means; grey scenes know nothing of it.

use crate::refusals::assert_refused;
use crate::{json, stdout};
use serde_json::Value;

/// A box of 2 × 3 × 1 with a red floor and walls, one white wall, and a ceiling that shines.
const ROOM: [&str; 6] = [
    "radiosity",
    "box:2,3,1",
    "--reflectance",
    "all=0.9:0.1:0.1,3=0.8,1=0",
    "--emittance",
    "1=3",
];

/// The light of the red floor in each channel, and its mean: solved apart by another program.
const FLOOR: [f64; 3] = [2.292_796_207_14, 0.160_239_145_045, 0.160_239_145_045];
const MEAN: f64 = 0.871_091_499_077_319_3;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn channels_are_solved_by_themselves() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let corners = "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 1\nv 0 3 1\nv 2 3 1\nv 2 0 1\n";
    let faces = "usemtl red\nf 1 2 3 4\nf 1 5 8 2\nf 3 7 6 4\nf 1 4 6 5\nusemtl white\nf 2 8 7 3\n\
        usemtl light\nf 5 6 7 8\n";
    std::fs::write(path("room.obj"), format!("mtllib r.mtl\n{corners}{faces}")).unwrap();
    std::fs::write(
        path("r.mtl"),
        "newmtl red\nKd .9 .1 .1\nnewmtl white\nKd .8\nnewmtl light\nKe 3\n",
    )
    .unwrap();
    let room = path("room.obj");
    let answer = json(&["radiosity", &room, "--importance", "0"]);
    let floor = &answer["patches"][0];
    assert!(
        (number(&floor["radiosity"]) / MEAN - 1.0).abs() < 1e-13,
        "{floor}"
    );
    for (channel, exact) in ["r", "g", "b"].into_iter().zip(FLOOR) {
        let light = &floor["channels"][channel];
        assert!(
            (number(&light["radiosity"]) / exact - 1.0).abs() < 1e-11,
            "{light}"
        );
        for key in ["irradiance", "importance", "form_factor_error"] {
            assert!(number(&light[key]) > 0.0, "{light}");
        }
        let solution = &answer["channels"][channel];
        for key in ["residual", "iterations", "relative_error"] {
            assert!(number(&solution[key]) > 0.0, "{solution}");
        }
        // 6 squares of light, 3 each
        assert!((number(&solution["power"]["absorbed"]) - 18.0).abs() < 1e-12);
    }
    // written and read, in three channels
    stdout(&["convert", &room, &path("other.obj")]);
    let other = json(&["radiosity", &path("other.obj"), "--importance", "0"]);
    assert_eq!(other["patches"], answer["patches"]);
    // tables and lists have them, too
    assert!(stdout(&["radiosity", &room]).contains("radiosity g"));
    let csv = stdout(&["radiosity", &room, "--format", "csv"]);
    let head = csv.lines().next().unwrap();
    for key in [
        "radiosity_r",
        "irradiance_g",
        "importance_b",
        "form_factor_error_r",
    ] {
        assert!(head.split(',').any(|column| column == key), "{head}");
    }
}

/// The mean of one material for all channels is not their light: `--reflectance` takes both.
#[test]
fn colours_are_given_in_words() {
    let answer = json(&ROOM);
    let floor = &answer["patches"][0];
    assert!((number(&floor["channels"]["g"]["radiosity"]) / FLOOR[1] - 1.0).abs() < 1e-11);
    let red = json(&[
        "radiosity",
        "two-squares",
        "--emittance",
        "0=1:0:0",
        "--reflectance",
        "1=1",
    ]);
    let second = &red["patches"][1];
    // F of unit squares with a common edge, Howell C-14
    assert!((number(&second["channels"]["r"]["radiosity"]) - 0.200_043_776_075_4).abs() < 1e-12);
    assert_eq!(second["channels"]["b"]["radiosity"], 0.0);
    assert!((3.0 * number(&second["radiosity"]) - 0.200_043_776_075_4).abs() < 1e-12);
}

#[test]
fn grey_scenes_have_no_channels() {
    let mut grey = ROOM;
    grey[3] = "all=0.9:0.9:0.9,1=0";
    let answer = json(&grey);
    assert!(answer.get("channels").is_none());
    assert!(answer["patches"][0].get("channels").is_none());
    grey[3] = "all=0.9,1=0";
    assert_eq!(json(&grey), answer);
}

/// Each channel has its own chain, which is that of the grey scene of this channel.
#[test]
fn chains_of_coloured_light_say_which_channel() {
    let chain = |reflectance: &str, more: &[&str]| {
        let measure = [
            "measure",
            "box:2,3,1",
            "--chain",
            "radiosity",
            "--emittance",
            "1=3",
        ];
        let more = [&measure[..], &["--reflectance", reflectance], more].concat();
        json(&more)
    };
    for (channel, reflectance) in [("r", "0.9"), ("b", "0.1")] {
        let coloured = chain(ROOM[3], &["--channel", channel]);
        assert_eq!(coloured["channel"], channel);
        let grey = chain(&format!("all={reflectance},3=0.8,1=0"), &[]);
        assert!(grey.get("channel").is_none());
        assert_eq!(coloured["mutual_information"], grey["mutual_information"]);
    }
    let chain = [
        "--chain",
        "radiosity",
        "--emittance",
        "1=3",
        "--reflectance",
        ROOM[3],
    ];
    for question in [
        &["measure", "box:2,3,1"][..],
        &["split", "box:2,3,1", "--patch", "0"],
    ] {
        let refused = [question, &chain].concat();
        assert_refused(&refused, "is coloured");
        assert_refused(&refused, "--channel r, g or b");
        assert_refused(
            &[question, &["--channel", "r"]].concat(),
            "add --chain radiosity",
        );
        let answer = json(&[question, &chain, &["--channel", "g"]].concat());
        assert_eq!(answer["channel"], "g");
    }
    // a lamp without green makes no green chain
    let red = [
        "--chain",
        "radiosity",
        "--emittance",
        "1=3:0:0",
        "--channel",
        "g",
    ];
    let dark = [&["measure", "cube:1"], &red[..]].concat();
    assert_refused(&dark, "channel g: no patch has a positive emittance");
    // importance has the colour of what reflects alone
    let looked = [
        "--chain",
        "importance",
        "--importance",
        "0",
        "--reflectance",
        "all=0.5",
    ];
    json(
        &[
            &["measure", "cube:1", "--emittance", "0=1:0:0"],
            &looked[..],
        ]
        .concat(),
    );
}
