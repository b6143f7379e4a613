//! The keys that scripts rely on: those of the JSON, and numbers that read back exactly.

use crate::{json, stdout};
use infoscene::claims::registry;
use infoscene::discretize::GradientCut;

fn assert_keys(record: &serde_json::Value, keys: &[&str]) {
    for key in keys {
        assert!(record.get(key).is_some(), "no key {key} in {record}");
    }
}

#[test]
fn reproduce_writes_every_claim_with_its_keys() {
    let answer = json(&["reproduce"]);
    let claims = answer["claims"].as_array().unwrap();
    assert_eq!(claims.len(), registry().unwrap().len());
    let keys = [
        "id", "place", "quantity", "printed", "decimals", "computed", "lower", "upper", "evidence",
        "verdict", "note",
    ];
    for claim in claims {
        assert_keys(claim, &keys);
    }
    let cut = claims
        .iter()
        .find(|claim| claim["id"] == "fig2-parallel-cut")
        .unwrap();
    assert_eq!(
        (cut["printed"].as_f64(), cut["decimals"].as_u64()),
        (Some(0.4), Some(2))
    );
    assert_eq!(
        (&cut["evidence"], &cut["verdict"]),
        (&"proof".into(), &"confirmed".into())
    );
    // 25 digits by an independent method: data/reference/splits.csv
    assert!((cut["computed"].as_f64().unwrap() - 0.399_201_026_045_385_2).abs() <= 1e-14);
    for end in ["lower", "upper"] {
        let bound = cut[end].as_str().unwrap();
        assert!(
            bound.starts_with("0.399201026045385125211245596") && bound.len() > 50,
            "{bound}"
        );
    }
    // a theorem stands in full beside its claim
    let theorem = &cut["proof"][0];
    assert_keys(
        theorem,
        &["name", "says", "variables", "hypotheses", "conclusion"],
    );
    assert_eq!(theorem["name"], "parallel_cut_is_best_at_40_percent");
    let table = stdout(&["reproduce", "fig2-parallel-cut"]);
    assert!(
        table.contains("theorem parallel_cut_is_best_at_40_percent"),
        "{table}"
    );
    // what is not enclosed has no bounds
    for claim in claims {
        let is_enclosed = claim["evidence"] == "enclosure";
        assert!(!is_enclosed || claim["lower"].is_string(), "{claim}");
    }
    // long enough for a longtable, the grids of figs. 4 and 5 left out for time
    let ids: Vec<String> = registry()
        .unwrap()
        .into_iter()
        .map(|claim| claim.id)
        .collect();
    let quick = ids
        .iter()
        .map(String::as_str)
        .filter(|id| !id.starts_with("fig"));
    let arguments = ["reproduce", "--format", "latex"].into_iter().chain(quick);
    let latex = stdout(&arguments.collect::<Vec<_>>());
    assert!(latex.contains("\\begin{longtable}") && latex.is_ascii());
}

#[test]
fn reproduce_takes_ids_and_keeps_paper_order() {
    let answer = json(&["reproduce", "fig3-cut", "fig2-parallel-cut"]);
    let ids: Vec<&str> = answer["claims"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| c["id"].as_str().unwrap())
        .collect();
    assert_eq!(ids, ["fig2-parallel-cut", "fig3-cut"]);
}

/// More bits, more digits: 700 bits leave more than 200 certain.
#[test]
fn precision_narrows_enclosures() {
    let answer = json(&["reproduce", "s42-mean-square-cut-2", "--precision", "700"]);
    let claim = &answer["claims"][0];
    let [lower, upper] = ["lower", "upper"].map(|end| claim[end].as_str().unwrap());
    assert_eq!(lower[..200], upper[..200]);
    // (1 + √17)/8 to 50 digits: the positive root of 4l² − l − 1
    assert!(lower.starts_with("0.64038820320220756872767623199675962814339990317170"));
}

#[test]
fn cuts_and_splits_are_enclosed_on_request() {
    let cut = json(&["cut", "--exponent", "2", "--precision", "128"]);
    let bounds = &cut["enclosures"]["mutual_information_cut"];
    // data/reference/section_4_2.csv
    for end in ["lower", "upper"] {
        let bound = bounds[end].as_str().unwrap();
        assert!(bound.starts_with("0.60749115012597432910565543104"));
    }
    assert!(
        json(&["cut", "--exponent", "2"])
            .get("enclosures")
            .is_none()
    );
    let split = json(&["split", "two-squares", "--patch", "0", "--precision", "128"]);
    let enclosures = &split["enclosures"];
    assert_eq!(
        enclosures["certificate"],
        "the only maximum, and the only stationary point"
    );
    let bound = enclosures["position"]["lower"].as_str().unwrap();
    assert!(bound.starts_with("0.3992010260453851252112455968"));
}

#[test]
fn split_finds_the_cuts_of_figures_2_and_3() {
    let two = json(&["split", "two-squares", "--patch", "0", "--axis", "u"]);
    assert_keys(
        &two,
        &[
            "patch",
            "axis",
            "position",
            "gain",
            "gain_at_middle",
            "maximum_gain",
        ],
    );
    assert!((two["position"].as_f64().unwrap() - 0.399_201_026_045_385_2).abs() <= 1e-14);
    let three = json(&["split", "three-squares", "--patch", "0"]);
    assert_eq!(three["axis"], "u");
    assert!((three["position"].as_f64().unwrap() - 0.393_580_461_894_795).abs() <= 1e-14);
    let one = json(&[
        "split",
        "three-squares",
        "--patch",
        "0",
        "--against",
        "1",
        "--axis",
        "u",
    ]);
    assert!((one["position"].as_f64().unwrap() - 0.399_201_026_045_385_2).abs() <= 1e-14);
    let parts = json(&["split", "two-squares", "--patch", "0", "--parts", "5"]);
    assert_eq!(parts["positions"].as_array().unwrap().len(), 4);
}

/// Every patch of the cubes of figs. 4 and 5 can be cut, along either axis.
#[test]
fn split_serves_every_patch_of_a_cube() {
    for (cells, patches) in [(1, 6), (3, 54)] {
        let scene = format!("cube:{cells}");
        for patch in (0..patches).step_by(cells) {
            for axis in ["u", "v"] {
                let patch = patch.to_string();
                let answer = json(&["split", &scene, "--patch", &patch, "--axis", axis]);
                let (gain, most) = (
                    answer["gain"].as_f64().unwrap(),
                    answer["maximum_gain"].as_f64().unwrap(),
                );
                assert!(
                    gain > 0.0 && gain <= most,
                    "{scene} {patch} {axis}: {answer}"
                );
            }
        }
    }
}

#[test]
fn cut_writes_numbers_that_read_back_exactly() {
    let answer = json(&["cut", "--exponent", "3", "--irradiance-exponent", "3"]);
    let cut = GradientCut::try_new(3.0, 3.0).unwrap();
    let [information, square] = [
        cut.mutual_information_cut().unwrap(),
        cut.mean_square_cut().unwrap(),
    ];
    for (key, value) in [
        ("exponent", 3.0),
        ("irradiance_exponent", 3.0),
        ("mutual_information_cut", information.position),
        ("mutual_information_complement", information.complement),
        ("mean_square_cut", square.position),
        ("mean_square_complement", square.complement),
    ] {
        assert_eq!(answer[key].as_f64(), Some(value), "{key}");
    }
}

#[test]
fn curves_are_lists_of_points() {
    let answer = json(&["curve", "fig2-curve"]);
    let points = answer["points"].as_array().unwrap();
    assert_eq!(points.len(), 99);
    let middle = points.iter().find(|point| point["x"] == 0.4).unwrap();
    // data/reference/splits.csv, curve_perp_par_t4
    assert!((middle["y"].as_f64().unwrap() / 0.033_270_868_242_393_25 - 1.0).abs() < 1e-13);
}

#[test]
fn every_format_is_written() {
    let markdown = stdout(&["reproduce", "fig2-parallel-cut", "--format", "markdown"]);
    assert!(markdown.starts_with("| id | paper says |"));
    let csv = stdout(&["reproduce", "fig2-parallel-cut", "--format", "csv"]);
    assert!(csv.starts_with("id,place,quantity,printed,decimals,computed"));
    assert_eq!(
        csv::Reader::from_reader(csv.as_bytes()).records().count(),
        1
    );
    let short = stdout(&["reproduce", "fig2-parallel-cut", "--format", "latex"]);
    assert!(
        short.contains("\\begin{tabular}{lp{0.4\\linewidth}r@{.}lrll}"),
        "{short}"
    );
    assert!(stdout(&["reproduce", "fig2-parallel-cut"]).contains("0.399201026045"));
    for shell in ["bash", "zsh", "fish"] {
        assert!(stdout(&["completions", shell]).contains("infoscene"));
    }
    assert!(stdout(&["man"]).contains(".TH infoscene"));
}
