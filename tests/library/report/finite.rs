//! The promise that no answer carries NaN or infinity.

use infoscene::exchange::Unheard;
use infoscene::form_factor::{Answer, ExchangeArea, Route};
use infoscene::question::{FormFactorRecord, FormFactors, MatrixEntries, MatrixLine, PatchRecord};
use infoscene::report::{
    Format, MatrixFormat, MatrixWriter, Report, ReportError, Table, json_text, write_form_factors,
};
use infoscene::scene::Scene;
use serde::Serialize;
use std::collections::BTreeMap;

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

type Spoil = fn(&mut Record);

#[test]
fn a_number_that_is_not_finite_is_named_by_its_full_key() {
    let whole = Report::one(Table::default(), &Record::new()).unwrap();
    let text = whole.render(Format::Json).unwrap();
    assert!(text.contains("\"relative_error\": null"), "{text}");
    let spoilt: [(&str, Spoil); 7] = [
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
        row_sum: None,
        row_sum_error: None,
    };
    let record = |value| FormFactorRecord {
        from: 0,
        to: 1,
        value,
        resolution_error: 0.0,
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
            write_form_factors(&patches, values(last), (0.0, &plan), format, Vec::new())
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
    let question = FormFactors {
        scene: "two-squares".into(),
        matrix: true,
        ..FormFactors::default()
    };
    let answer = question.ask(&Unheard).unwrap();
    let matrix = answer.matrix().unwrap();
    let exchange = |value| Answer {
        exchange: ExchangeArea { value, error: 0.0 },
        route: Route::Coplanar,
    };
    let answers = [exchange(0.5), exchange(f64::NAN)];
    let line = MatrixLine::new(1, &answers, &[[1.0, 0.0]; 2]);
    for format in [
        MatrixFormat::Npy,
        MatrixFormat::Coordinates,
        MatrixFormat::Array,
        MatrixFormat::Triplets,
        MatrixFormat::View3d,
    ] {
        let begun = MatrixWriter::begin(Vec::new(), format, MatrixEntries::FormFactors, &matrix);
        assert_eq!(refused_key(begun.unwrap().line(&line)), "matrix[1][1]");
    }
}

/// A campaign whose first case is a counterexample has seen no gain: null, and not 0.
#[cfg(feature = "proptest")]
#[test]
fn a_campaign_without_a_case_has_no_smallest_gain() {
    use infoscene::question::FuzzAnswer;
    use infoscene::report::fuzz_report;
    use infoscene::study::gain::fuzz::Findings;
    let report = fuzz_report(&FuzzAnswer::new(1, Findings::default(), 1.0)).unwrap();
    let text = report.render(Format::Json).unwrap();
    let answer: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(answer["minimum_gain"].is_null(), "{text}");
    let one = Findings {
        cases: 1,
        ..Findings::default()
    };
    let endless = fuzz_report(&FuzzAnswer::new(1, one, 0.0));
    assert_eq!(refused_key(endless), "cases_per_second");
}
