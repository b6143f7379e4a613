//! The slow reference against values from outside, and against enclosures of rectangles.

use crate::support::polygon_pairs::Family;
use crate::support::references::rows;
use infoscene::form_factor::reference;
use infoscene::geometry::Patch;
use infoscene::numeric::{Interval, Scalar};

/// Every corner of the families is planar exactly: the sixfold volume of a corner and the first three is 0 in 512 bits.
#[test]
fn families_are_planar_exactly() {
    for family in Family::ALL {
        for number in 0..300 {
            for patch in family.pair(number) {
                let corners: Vec<[Interval; 3]> = patch
                    .corners()
                    .iter()
                    .map(|c| c.to_array().map(|x| Interval::precise(x, 512)))
                    .collect();
                let arm = |k: usize| -> [Interval; 3] {
                    std::array::from_fn(|i| corners[k][i].clone() - &corners[0][i])
                };
                let volume = |a: [Interval; 3], b: [Interval; 3], c: [Interval; 3]| {
                    let minor = |i: usize, j: usize| a[i].clone() * &b[j] - &(a[j].clone() * &b[i]);
                    minor(1, 2) * &c[0] + &(minor(2, 0) * &c[1]) + &(minor(0, 1) * &c[2])
                };
                for k in 3..corners.len() {
                    let volume = volume(arm(1), arm(2), arm(k));
                    assert!(volume.is_zero(), "{family:?} {number}: {patch:?}");
                }
            }
        }
    }
}

/// Every row of the file, whose corners are decimals: rounding them moves a value by some ε.
#[test]
fn the_reference_agrees_with_thirty_digits() {
    for row in rows("form_factors.csv") {
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

/// Prints the exchange area of every pair in a file, whose lines are `P=[["x", "y", "z"], …];Q=…` in decimals.
#[test]
#[ignore = "prints values: INFOSCENE_PAIRS=file cargo test --release --test polygons print -- --ignored --nocapture"]
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
