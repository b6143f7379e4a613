//! The question for a grid on a box.

use infoscene::exchange::Unheard;
use infoscene::question::{Grid, GridLines, GridSample, QuestionError};
use infoscene::report::{Format, grid_report};
use serde_json::Value;

fn best(cells: u32) -> Grid {
    Grid {
        lines: GridLines::Best { cells },
        ..Grid::default()
    }
}

/// `cube_optimal_3`, `cube_regular_3` of `data/reference/cube_grids.csv`, computed at 50 digits.
#[test]
fn the_grid_of_figure_4_is_found() {
    let answer = best(3).ask(&Unheard).unwrap();
    let error = answer.mutual_information - 1.000_704_996_381_222;
    assert!(error.abs() <= answer.error + f64::EPSILON, "{error:e}");
    let error = answer.regular_mutual_information - 0.994_346_184_970_692_6;
    assert!(
        error.abs() <= answer.regular_error + f64::EPSILON,
        "{error:e}"
    );
    let line = answer.lines[0] - 0.302_574_117_550_565_5;
    assert!(Some(line.abs()) <= answer.line_error, "{line:e}");
}

/// The JSON of a report is the record of its answer, every key and digit of it.
#[test]
fn the_record_of_a_grid_is_its_json() {
    let given = Grid {
        edges: [1.0, 2.0, 3.0],
        lines: GridLines::At(vec![0.25, 0.5]),
        precision: Some(100),
        sample: Some(GridSample {
            lines: 100,
            seed: 3,
        }),
    };
    for question in [best(2), Grid::default(), given] {
        let answer = question.ask(&Unheard).unwrap();
        let json = grid_report(&answer).unwrap().render(Format::Json).unwrap();
        let printed: Value = serde_json::from_str(&json).unwrap();
        assert_eq!(printed, serde_json::to_value(&answer).unwrap());
    }
}

#[test]
fn enclosures_of_many_cells_are_refused() {
    let refused = Grid {
        precision: Some(100),
        lines: GridLines::Regular { cells: 13 },
        ..Grid::default()
    };
    let error = refused.ask(&Unheard).unwrap_err();
    let QuestionError::TooManyCellsToEnclose { bits, cells, most } = error else {
        panic!("{error}");
    };
    assert_eq!([bits, cells, most], [100, 13, 12]);
}
