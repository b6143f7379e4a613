//! The command prints what questions answer.

use super::{infoscene, stdout};
use infoscene::exchange::Unheard;
use infoscene::question::{FormFactors, Measure, Radiosity, Sample, Split};
use serde::Serialize;

/// The command prints the record of an answer, every digit of it.
fn is_printed(arguments: &[&str], answer: &impl Serialize) {
    let mut arguments = arguments.to_vec();
    arguments.extend(["--format", "json"]);
    let record = serde_json::to_string_pretty(answer).unwrap() + "\n";
    assert_eq!(stdout(&arguments), record, "{arguments:?}");
}

#[test]
fn the_record_of_an_answer_is_what_the_command_prints() {
    let measure = Measure {
        scene: "cube:2".into(),
        continuous: true,
        pairs: true,
        ..Measure::default()
    };
    let measured = measure.ask(&Unheard).unwrap();
    is_printed(&["measure", "cube:2", "--continuous", "--pairs"], &measured);
    let form_factors = FormFactors {
        scene: "three-squares".into(),
        ..FormFactors::default()
    };
    let found = form_factors.ask(&Unheard).unwrap();
    is_printed(&["form-factor", "three-squares"], &found);
    let radiosity = Radiosity {
        scene: "cornell-box".into(),
        ..Radiosity::default()
    };
    let light = radiosity.ask(&Unheard).unwrap();
    is_printed(&["radiosity", "cornell-box"], &light);
    let split = Split {
        scene: "two-squares".into(),
        precision: Some(80),
        ..Split::default()
    };
    let cut = split.ask(&Unheard).unwrap();
    let arguments = ["split", "two-squares", "--patch", "0", "--precision", "80"];
    is_printed(&arguments, &cut);
    let sample = Sample {
        scene: "cube:1".into(),
        lines: 1000,
        exact: true,
        ..Sample::default()
    };
    let sampled = sample.ask(&Unheard).unwrap();
    is_printed(&["measure", "cube:1", "--sample", "1000"], &sampled);
    is_printed(
        &["sample", "cube:1", "--lines", "1000", "--exact"],
        &sampled,
    );
}

#[test]
fn refusals_of_questions_name_the_option_that_mends_them() {
    let refused: [(&[&str], &str); 4] = [
        (
            &["measure", "cube:1", "--sample", "100", "--unoccluded"],
            ": leave out --unoccluded\n",
        ),
        (
            &["measure", "cube:1", "--emittance", "0"],
            ": add --chain radiosity or --chain importance\n",
        ),
        (
            &["form-factor", "cube:60"],
            ": choose with --from or --to, --matrix writes all\n",
        ),
        (
            &[
                "split",
                "two-squares",
                "--patch",
                "0",
                "--precision",
                "80",
                "--parts",
                "3",
            ],
            "; leave out --parts\n",
        ),
    ];
    for (arguments, mend) in refused {
        let failed = infoscene(arguments).assert().code(2);
        let message = String::from_utf8_lossy(&failed.get_output().stderr).into_owned();
        assert!(message.ends_with(mend), "{message}");
    }
}
