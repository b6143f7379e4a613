//! Two promises: no scene gets numbers that overlap or occlusion makes wrong, and no answer carries
//! NaN or infinity.

use crate::support::rooms::level;
use infoscene::chain::{ChainError, continuous_chain, open_visibility_chain, visibility_chain};
use infoscene::discretize::{DiscretizeError, PatchSplit};
use infoscene::exchange::{Congruence, ExchangeError, ScenePairs, Unheard};
use infoscene::geometry::SplitAxis;
use infoscene::information::{
    LineKind, LineSample, chord_information, continuous_information, pair_losses,
};
use infoscene::question::{FormFactorRecord, PatchRecord};
use infoscene::report::{
    Format, Report, ReportError, Table, json_text, write_form_factors, write_npy_row,
};
use infoscene::scene::{NamedPatch, Obstacle, Occlusion, Scene, SceneError};
use serde::Serialize;
use std::collections::BTreeMap;

fn of_exchange(error: ExchangeError) -> SceneError {
    match error {
        ExchangeError::Scene(error) => error,
        other => panic!("the scene is not to blame: {other}"),
    }
}

fn of_chain(error: ChainError) -> SceneError {
    match error {
        ChainError::Scene(error) => error,
        ChainError::Exchange(error) => of_exchange(error),
        other => panic!("the scene is not to blame: {other}"),
    }
}

fn of_split(error: DiscretizeError) -> SceneError {
    match error {
        DiscretizeError::Scene(error) => error,
        DiscretizeError::Exchange(error) => of_exchange(error),
        other => panic!("the scene is not to blame: {other}"),
    }
}

fn pairs(scene: &Scene, occlusion: Occlusion) -> Result<ScenePairs<'static>, SceneError> {
    ScenePairs::try_new(scene, 1e-9, Congruence::Shared, occlusion).map_err(of_exchange)
}

fn split(scene: &Scene, against: &[usize], occlusion: Occlusion) -> Result<(), SceneError> {
    let split = PatchSplit::with_occlusion(scene, 0, against, SplitAxis::U, occlusion);
    split.map(|_| ()).map_err(of_split)
}

type Door = fn(&Scene) -> Result<(), SceneError>;

/// Every way from a scene to what its patches exchange.
const DOORS: [(&str, Door); 8] = [
    ("pairs", |scene| {
        pairs(scene, Occlusion::default()).map(|_| ())
    }),
    ("exchange areas", |scene| {
        scene.exchange_areas().map(|_| ()).map_err(of_exchange)
    }),
    ("visibility chain", |scene| {
        visibility_chain(scene).map(|_| ()).map_err(of_chain)
    }),
    ("open visibility chain", |scene| {
        open_visibility_chain(scene).map(|_| ()).map_err(of_chain)
    }),
    ("continuous chain", |scene| {
        let chain = continuous_chain(scene, |_, _| 1.0, 1e-3);
        chain.map(|_| ()).map_err(of_chain)
    }),
    ("continuous information", |scene| {
        continuous_information(scene).map(|_| ()).map_err(of_chain)
    }),
    ("losses of pairs", |scene| {
        pair_losses(scene, &Unheard).map(|_| ()).map_err(of_chain)
    }),
    ("split", |scene| {
        let others: Vec<usize> = (1..scene.patches().len()).collect();
        let split = PatchSplit::try_new(scene, 0, &others, SplitAxis::U);
        split.map(|_| ()).map_err(of_split)
    }),
];

/// A room that is convex inside, whose corners do not tell that a shelf hangs in it.
fn room_with_shelf(x: [f64; 2], z: f64) -> Scene {
    let shelf = level("shelf", x, [0.4, 0.6], z, true);
    Scene::built_in("cube:1")
        .unwrap()
        .with_obstructions(vec![shelf])
}

/// A room whose walls have the right corners and areas, but the middle of the floor lies on another
/// patch: a gap and an overlap.
fn room_with_overlap() -> Scene {
    let mut patches = Scene::built_in("cube:3").unwrap().patches().to_vec();
    patches[4] = NamedPatch::new("rug".to_owned(), patches[0].shape().clone());
    Scene::try_new(patches).unwrap()
}

#[test]
fn every_door_refuses_a_blocked_scene_by_name() {
    let scene = room_with_shelf([0.4, 0.6], 0.5);
    for (name, door) in DOORS {
        let refusal = door(&scene).unwrap_err();
        let SceneError::MayBeBlocked {
            obstacle, name: by, ..
        } = &refusal
        else {
            panic!("{name}: {refusal}");
        };
        assert_eq!(
            (*obstacle, by.as_str()),
            (Obstacle::Obstruction(0), "shelf"),
            "{name}"
        );
        let without = scene.clone().with_obstructions(Vec::new());
        assert_eq!(door(&without), Ok(()), "{name}");
    }
}

#[test]
fn every_door_refuses_overlapping_patches_by_name() {
    let scene = room_with_overlap();
    let sampled = |scene: &Scene| {
        let sample = LineSample::draw(scene, LineKind::Local, 100, 1);
        sample.map(|_| ()).map_err(of_chain)
    };
    let chords = |scene: &Scene| {
        let found = chord_information(scene, 100, 1);
        found.map(|_| ()).map_err(of_chain)
    };
    let ignoring: [(&str, Door); 4] = [
        ("sampled lines", sampled),
        ("chords", chords),
        ("pairs that ignore occlusion", |scene| {
            pairs(scene, Occlusion::Ignore).map(|_| ())
        }),
        ("split that ignores occlusion", |scene| {
            split(scene, &[20], Occlusion::Ignore)
        }),
    ];
    for (name, door) in DOORS.into_iter().chain(ignoring) {
        let refusal = door(&scene).unwrap_err();
        let SceneError::Overlap {
            first: 0,
            second: 4,
            names,
        } = &refusal
        else {
            panic!("{name}: {refusal}");
        };
        assert_eq!(names[1], "rug", "{name}");
    }
}

#[test]
fn ignored_occlusion_gives_the_values_of_the_empty_room() {
    let scene = room_with_shelf([0.4, 0.6], 0.5);
    let empty = Scene::built_in("cube:1").unwrap();
    let found = pairs(&scene, Occlusion::Ignore).unwrap();
    let expected = pairs(&empty, Occlusion::Refuse).unwrap();
    assert_eq!(
        found.row_pair(0, 5).unwrap(),
        expected.row_pair(0, 5).unwrap()
    );
    assert_eq!(split(&scene, &[1, 2, 3, 4, 5], Occlusion::Ignore), Ok(()));
}

/// Floor and wall x = 0 span the half x + z ≤ 1 of the cube; the shelf hangs in the other half.
#[test]
fn what_is_not_hidden_is_admitted() {
    let scene = room_with_shelf([0.85, 0.95], 0.9);
    let on = |axis: usize, level: f64| {
        let lies = |patch: &NamedPatch| {
            let mut corners = patch.shape().corners().iter();
            corners.all(|corner| corner[axis] == level)
        };
        scene.patches().iter().position(lies).unwrap()
    };
    let (floor, ceiling, wall) = (on(2, 0.0), on(2, 1.0), on(0, 0.0));
    let rows = |from, to| scene.check_rows_unblocked(from, to);
    assert_eq!(rows(Some(floor), Some(wall)), Ok(()));
    for (from, to) in [
        (Some(floor), Some(ceiling)),
        (Some(floor), None),
        (None, Some(floor)),
        (None, None),
    ] {
        let refusal = rows(from, to).unwrap_err();
        assert!(
            matches!(refusal, SceneError::MayBeBlocked { .. }),
            "{refusal}"
        );
    }
    let refusal = rows(Some(floor), Some(6)).unwrap_err();
    assert_eq!(refusal, SceneError::NoSuchPatch { index: 6, last: 5 });
    let cut = |other| PatchSplit::try_new(&scene, floor, &[other], SplitAxis::U);
    assert!(cut(wall).is_ok());
    let refusal = of_split(cut(ceiling).unwrap_err());
    assert!(
        matches!(refusal, SceneError::MayBeBlocked { .. }),
        "{refusal}"
    );
}

#[derive(Serialize)]
struct Row {
    name: &'static str,
    relative_error: Option<f64>,
}

#[derive(Serialize)]
enum Grade {
    Bound(f64),
    Between { low: f64, high: f32 },
    Both(f64, f64),
}

#[derive(Serialize)]
struct Record {
    rows: Vec<Row>,
    curve: Vec<[f64; 2]>,
    by_name: BTreeMap<String, f64>,
    grades: Vec<Grade>,
}

impl Record {
    fn new() -> Self {
        let row = |relative_error| Row {
            name: "row",
            relative_error,
        };
        Self {
            rows: [Some(0.5), None, Some(0.25), None].map(row).into(),
            curve: vec![[0.0, 1.0], [2.0, 3.0]],
            by_name: BTreeMap::from([("x".to_owned(), 1.0)]),
            grades: vec![
                Grade::Bound(1.0),
                Grade::Between {
                    low: 0.0,
                    high: 1.0,
                },
                Grade::Both(0.0, 1.0),
            ],
        }
    }
}

fn refused_key<T: std::fmt::Debug>(answer: Result<T, ReportError>) -> String {
    match answer.unwrap_err() {
        ReportError::NotFinite { key } => key,
        other => panic!("{other}"),
    }
}

#[test]
fn a_number_that_is_not_finite_is_named_by_its_full_key() {
    let whole = Report::one(Table::default(), &Record::new()).unwrap();
    let text = whole.render(Format::Json).unwrap();
    assert!(text.contains("\"relative_error\": null"), "{text}");
    let spoilt: [(&str, fn(&mut Record)); 7] = [
        ("rows[3].relative_error", |record| {
            record.rows[3].relative_error = Some(f64::NAN);
        }),
        ("rows[0].relative_error", |record| {
            record.rows[0].relative_error = Some(f64::INFINITY);
        }),
        ("curve[1][0]", |record| {
            record.curve[1][0] = f64::NEG_INFINITY
        }),
        ("by_name.x", |record| {
            record.by_name.insert("x".to_owned(), f64::NAN);
        }),
        ("grades[0].Bound", |record| {
            record.grades[0] = Grade::Bound(f64::NAN)
        }),
        ("grades[1].Between.high", |record| {
            record.grades[1] = Grade::Between {
                low: 0.0,
                high: f32::INFINITY,
            };
        }),
        ("grades[2].Both[1]", |record| {
            record.grades[2] = Grade::Both(0.0, f64::NAN)
        }),
    ];
    for (key, spoil) in spoilt {
        let mut record = Record::new();
        spoil(&mut record);
        assert_eq!(refused_key(Report::one(Table::default(), &record)), key);
        assert_eq!(refused_key(json_text(&record)), key);
        let summarised = whole.clone().summarised(&record);
        assert_eq!(refused_key(summarised), key);
        let list = [Record::new(), record];
        let listed = Report::list(Table::default(), "answers", &list);
        assert_eq!(refused_key(listed), format!("answers[1].{key}"));
    }
}

#[test]
fn form_factors_that_are_not_finite_are_named_in_every_format() {
    let scene = Scene::built_in("cube:1").unwrap();
    let plan = scene.exchange_areas().unwrap().summary().plan.clone();
    let patch = |index, area| PatchRecord {
        index,
        name: "wall".to_owned(),
        area,
    };
    let record = |value| FormFactorRecord {
        from: 0,
        to: 1,
        value,
        error: 0.0,
        route: "none",
    };
    // more than a table shows
    let values = |last| (0..1500).map(|_| 0.5).chain([last]).map(record);
    for format in [
        Format::Json,
        Format::Csv,
        Format::Table,
        Format::Markdown,
        Format::Latex,
    ] {
        let write = |area, last| {
            let patches = [patch(0, 1.0), patch(1, area)];
            write_form_factors(&patches, values(last), &plan, format, Vec::new())
        };
        write(1.0, 0.5).unwrap();
        assert_eq!(
            refused_key(write(1.0, f64::NAN)),
            "form_factors[1500].value"
        );
        assert_eq!(refused_key(write(f64::NAN, 0.5)), "patches[1].area");
    }
}

#[test]
fn a_matrix_with_nan_is_refused() {
    let written = write_npy_row(Vec::new(), 2, [0.5, f64::NAN]);
    assert_eq!(refused_key(written), "matrix[2][1]");
}

/// A campaign whose first case is a counterexample has seen no gain: null, and not 0.
#[cfg(feature = "proptest")]
#[test]
fn a_campaign_without_a_case_has_no_smallest_gain() {
    use infoscene::report::fuzz_report;
    use infoscene::study::gain::fuzz::{Campaign, Findings};
    let campaign = Campaign {
        cases: 1,
        seed: 1,
        states: 2,
        sabotage: None,
    };
    let report = fuzz_report(campaign, &Findings::default(), 1.0).unwrap();
    let text = report.render(Format::Json).unwrap();
    let answer: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(answer["minimum_gain"].is_null(), "{text}");
    let endless = fuzz_report(
        campaign,
        &Findings {
            cases: 1,
            ..Findings::default()
        },
        0.0,
    );
    assert_eq!(refused_key(endless), "cases_per_second");
}
