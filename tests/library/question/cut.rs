//! The questions for the cuts across a gradient.

use infoscene::exchange::Unheard;
use infoscene::question::{Cut, Cuts, IrradianceExponent, QuestionError};
use infoscene::report::{Format, cut_report, cuts_report};
use serde_json::Value;

/// `mi42_n1_l` of `data/reference/section_4_2.csv`, computed at 80 digits.
const LINEAR: &str = "0.482761524917779580189774170892";

/// Two decimal numbers of the same length compare as their texts do.
#[test]
fn an_enclosed_cut_has_every_certified_digit() {
    let linear = Cut {
        precision: Some(200),
        ..Cut::default()
    };
    let answer = serde_json::to_value(linear.ask(&Unheard).unwrap()).unwrap();
    let ends = &answer["enclosures"]["mutual_information_cut"];
    let [lower, upper] = ["lower", "upper"].map(|end| ends[end].as_str().unwrap());
    assert!(lower.len() > 50, "{lower}");
    assert_eq!(&lower[..50], &upper[..50]);
    // the reference is rounded in its last digit
    assert!(lower.starts_with(&LINEAR[..LINEAR.len() - 2]), "{lower}");
}

/// The JSON of a report is the record of its answer, every key and digit of it.
#[test]
fn the_records_of_cuts_are_their_json() {
    let cuts = Cuts {
        exponents: vec![2.0, 1.0],
        irradiance: vec![
            IrradianceExponent::Fixed(1.0),
            IrradianceExponent::OfRadiosity,
        ],
        precision: Some(80),
    };
    let answer = cuts.ask(&Unheard).unwrap();
    let json = cuts_report(&answer).unwrap().render(Format::Json).unwrap();
    let printed: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(printed, serde_json::to_value(&answer).unwrap());

    let one = &answer.cuts[3];
    let json = cut_report(one).unwrap().render(Format::Json).unwrap();
    let printed: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(printed, serde_json::to_value(one).unwrap());
    assert_eq!([one.exponent, one.irradiance_exponent], [1.0, 1.0]);
}

#[test]
fn cuts_rise_by_the_exponent_of_the_radiosity() {
    let cuts = Cuts {
        exponents: vec![3.0, 1.0, 2.0],
        irradiance: vec![
            IrradianceExponent::Fixed(1.0),
            IrradianceExponent::OfRadiosity,
        ],
        precision: None,
    };
    let answer = cuts.ask(&Unheard).unwrap();
    let exponents = |index: usize| -> Vec<[f64; 2]> {
        let rising = answer.rising(index).into_iter();
        rising
            .map(|cut| [cut.exponent, cut.irradiance_exponent])
            .collect()
    };
    assert_eq!(exponents(0), [[1.0, 1.0], [2.0, 1.0], [3.0, 1.0]]);
    assert_eq!(exponents(1), [[1.0, 1.0], [2.0, 2.0], [3.0, 3.0]]);
}

#[test]
fn more_cuts_than_anybody_reads_are_refused() {
    let many = Cuts {
        exponents: vec![1.0; 10_001],
        ..Cuts::default()
    };
    let error = many.ask(&Unheard).unwrap_err();
    let QuestionError::TooManyPairsOfExponents { pairs, most } = error else {
        panic!("{error}");
    };
    assert_eq!([pairs, most], [10_001, 10_000]);
}
