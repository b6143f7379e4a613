//! The slow reference against values from outside, and against enclosures of rectangles.

use crate::support::breadth::some_of;
use crate::support::references::rows;
use glam::DVec3;
use infoscene::form_factor::RectanglePair;
use infoscene::geometry::{Patch, Rectangle};
use infoscene::numeric::{Interval, Scalar};
use infoscene::reference::exchange as reference;

/// Every row of the file, whose corners are decimals: rounding them moves a value by some ε.
#[test]
fn the_reference_agrees_with_thirty_digits() {
    for row in some_of(rows("form_factors.csv")) {
        let polygons = row.polygons();
        let found = reference::exchange_area(&polygons[0], &polygons[1], 1e-15).unwrap();
        let exact = row.number("exchange_area");
        assert!(
            found.error_of(exact).abs() <= 4.0 * f64::EPSILON * exact,
            "{}",
            row.id
        );
        assert!(found.estimate() <= 1e-15, "{}", row.id);
    }
}

/// The reference, as an interval of no width.
fn as_interval(found: &reference::Reference, like: &Interval) -> Interval {
    let parts = found.doubles();
    parts
        .iter()
        .fold(like.zero(), |sum, part| sum + &like.constant(*part))
}

/// The enclosure of the closed form with 384 bits contains the reference widened by its estimate,
/// and is itself far narrower.
#[test]
#[ignore = "seconds: \
            cargo test --release --test library the_reference_agrees -- --ignored"]
fn the_reference_agrees_with_enclosures_of_stiff_rectangles() {
    let rectangle = |origin: [f64; 3], u: DVec3, v: DVec3| {
        Rectangle::try_new(DVec3::from_array(origin), u, v).unwrap()
    };
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let thin = 2f64.powi(-30);
    let floor = |width: f64, depth: f64| rectangle([0.0; 3], width * x, depth * y);
    let pairs = [
        // facing, of aspect 2³⁰, 2⁻³⁰ apart, 2²⁰ apart
        (floor(1.0, thin), rectangle([0.25, 0.5, 1.0], y, x)),
        (
            floor(1.0 / thin, 1.0),
            rectangle([0.0, 0.0, 1.0], y, x / thin),
        ),
        (floor(1.0, 1.0), rectangle([0.0, 0.0, 1e-3], y, x)),
        (floor(1.0, 1.0), rectangle([0.5, 0.25, thin], y, x)),
        (floor(1.0, 1.0), rectangle([3.0, 7.0, 1_048_576.0], y, x)),
        // with an edge in common, of aspect 2³⁰
        (floor(1.0, 1.0), rectangle([0.0; 3], y, z * thin)),
        (floor(thin, 1.0), rectangle([0.0; 3], y, z)),
        (floor(thin, 1.0), rectangle([0.0; 3], y, z * thin)),
        // with a corner in common, nearly with an edge in common, beyond it
        (floor(1.0, 1.0), rectangle([0.0, 1.0, 0.0], y, z)),
        (floor(1.0, 1.0), rectangle([-thin, 0.0, 0.0], y, z)),
        (floor(1.0, 1.0), rectangle([0.5, 0.0, 0.0], y, z)),
    ];
    let like = Interval::precise(0.0, 384);
    for (first, second) in pairs {
        let enclosure = RectanglePair::try_new(&first, &second)
            .unwrap()
            .lifted(&like);
        let enclosure = enclosure.exchange_value().unwrap();
        let patches = [
            Patch::try_from(&first).unwrap(),
            Patch::try_from(&second).unwrap(),
        ];
        for [first, second] in [[0, 1], [1, 0]] {
            let found = reference::exchange_area(&patches[first], &patches[second], 1e-17).unwrap();
            let value = found.value();
            assert!(
                found.estimate() <= 1e-17,
                "{patches:?}: {:e}",
                found.estimate()
            );
            assert!(enclosure.width() <= 1e-30 * value, "{patches:?}");
            let difference = (as_interval(&found, &like) - &enclosure).abs().to_f64();
            assert!(
                difference <= found.estimate() * value,
                "{patches:?}: {difference:e} of {value:e}, estimate {:e}",
                found.estimate()
            );
        }
    }
}

/// Twenty digits and more are there for the asking: the tetrahedron cut off a cube's corner has F =
/// 1/√3 from leg to base, by symmetry.
#[test]
fn the_reference_gives_the_digits_asked_for() {
    let patch = |corners: [DVec3; 3]| Patch::try_new(corners.to_vec()).unwrap();
    let leg = patch([DVec3::ZERO, DVec3::X, DVec3::Y]);
    let base = patch([DVec3::X, DVec3::Z, DVec3::Y]);
    let like = Interval::precise(1.0, 256);
    let exact = like.constant(0.5) / &like.constant(3.0).sqrt();
    for digits in some_of([3, 6, 12, 24, 18]) {
        let relative = 10f64.powi(-digits);
        let found = reference::exchange_area(&leg, &base, relative).unwrap();
        let difference = (as_interval(&found, &like) - &exact).abs().to_f64();
        assert!(found.estimate() <= relative, "{digits}");
        assert!(
            difference <= found.estimate() * found.value(),
            "{digits}: {difference:e}"
        );
    }
}

/// Behind, or in one plane: exactly nothing.
#[test]
fn the_reference_is_zero_where_nothing_is_seen() {
    let patch =
        |corners: [[f64; 3]; 3]| Patch::try_new(corners.map(DVec3::from_array).to_vec()).unwrap();
    let floor = patch([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let nothing = [
        patch([[2.0, 0.1, 0.0], [3.0, 0.3, 0.0], [2.0, 1.0, 0.0]]),
        patch([[0.0, 0.0, -1.0], [0.0, 1.0, -1.0], [1.0, 0.0, -1.0]]),
        patch([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]]),
        patch([[0.0, 0.0, -0.5], [0.0, 1.0, -0.1], [1.0, 0.0, 0.0]]),
    ];
    for other in nothing {
        let found = reference::exchange_area(&floor, &other, 1e-15).unwrap();
        assert_eq!(found.value(), 0.0, "{other:?}");
        assert_eq!(found.decimal(20), "0");
    }
}

/// Prints the exchange area of every pair in a file, whose lines are `P=[["x", "y", "z"], …];Q=…`
/// in decimals.
#[test]
#[ignore = "prints values: \
            INFOSCENE_PAIRS=file \
            cargo test --release --test library print_the_exchange -- --ignored --nocapture"]
fn print_the_exchange_areas_of_a_file() {
    let file = std::env::var("INFOSCENE_PAIRS").unwrap();
    for line in std::fs::read_to_string(file).unwrap().lines() {
        let polygons: Vec<Patch> = crate::support::references::polygons(line);
        match reference::exchange_area(&polygons[0], &polygons[1], 1e-18) {
            Ok(found) => println!("{} ± {:.0e} relative", found.decimal(25), found.estimate()),
            Err(error) => println!("{error}"),
        }
    }
}
