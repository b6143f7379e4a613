//! Maxima of functions of high precision, without derivatives given.
//!
//! Two ways: golden-section search, which only compares values and therefore finds
//! a place to half the digits of the values, and Newton's method on central
//! differences of step δ = 2⁻⁶⁰, whose slopes err by δ² ≈ 10⁻³⁶ relatively.

use crate::precision::Real;

/// The place of the maximum of a function with one maximum in `[from, to]`,
/// narrowed down to 10⁻⁴².
pub fn golden_section(mut from: Real, mut to: Real, f: impl Fn(&Real) -> Real) -> Real {
    let golden = (Real::int(5).sqrt() - Real::int(1)).half();
    let inner = |a: &Real, b: &Real| b - (b - a) * &golden;
    let (mut left, mut right) = (inner(&from, &to), inner(&to, &from));
    let (mut at_left, mut at_right) = (f(&left), f(&right));
    let tolerance = Real::decimal("1e-42");
    while &to - &from > tolerance {
        if at_left > at_right {
            to = std::mem::replace(&mut right, left);
            at_right = at_left;
            left = inner(&from, &to);
            at_left = f(&left);
        } else {
            from = std::mem::replace(&mut left, right);
            at_left = at_right;
            right = inner(&to, &from);
            at_right = f(&right);
        }
    }
    (from + to).half()
}

/// A maximum near `start`, by Newton's method in as many variables as `start` has
/// (one or two). Stops after a step below 10⁻¹⁷, whose square, the size of the
/// next one, is beyond all digits compared. Panics unless that happens within eight
/// steps and the matrix of second differences is negative definite at all of them.
pub fn newton(start: &[Real], f: impl Fn(&[Real]) -> Real) -> Vec<Real> {
    let mut place = start.to_vec();
    for _ in 0..8 {
        let step = newton_step(&place, &f);
        let mut largest = Real::int(0);
        for (coordinate, change) in place.iter_mut().zip(&step) {
            *coordinate += change.clone();
            if change.abs() > largest {
                largest = change.abs();
            }
        }
        if largest < Real::decimal("1e-17") {
            return place;
        }
    }
    panic!("Newton's method has not settled at {place:?}");
}

/// One step −H⁻¹g with differences for the gradient g and the matrix H.
fn newton_step(place: &[Real], f: &impl Fn(&[Real]) -> Real) -> Vec<Real> {
    let delta = Real::two_to_minus(60);
    let moved = |shifts: &[i32]| {
        let pairs = place.iter().zip(shifts);
        let there: Vec<Real> = pairs.map(|(x, &k)| x + Real::int(k) * &delta).collect();
        f(&there)
    };
    let centre = f(place);
    let mut slopes = Vec::new();
    let mut bends = Vec::new();
    for k in 0..place.len() {
        let mut shifts = vec![0; place.len()];
        shifts[k] = 1;
        let after = moved(&shifts);
        shifts[k] = -1;
        let before = moved(&shifts);
        slopes.push((&after - &before).half() / &delta);
        let bend = (after + before - &centre - &centre) / delta.squared();
        assert!(!bend.is_above_zero(), "no maximum at {place:?}");
        bends.push(bend);
    }
    match place.len() {
        1 => vec![-(&slopes[0] / &bends[0])],
        2 => {
            let mixed = moved(&[1, 1]) - moved(&[1, -1]) - moved(&[-1, 1]) + moved(&[-1, -1]);
            let mixed = mixed / (Real::int(4) * delta.squared());
            let determinant = &bends[0] * &bends[1] - mixed.squared();
            assert!(determinant.is_above_zero(), "a saddle at {place:?}");
            vec![
                (&mixed * &slopes[1] - &bends[1] * &slopes[0]) / &determinant,
                (&mixed * &slopes[0] - &bends[0] * &slopes[1]) / &determinant,
            ]
        }
        more => panic!("{more} variables"),
    }
}

/// −(x − 1/3)² − x⁴ has its maximum where 4x³ + 2x = 2/3; the function of two
/// variables −x² + xy − y² + x has it at (2/3, 1/3).
#[test]
fn known_maxima_are_found() {
    let third = Real::ratio(1, 3);
    let f = |x: &Real| -((x - &third).squared() + x.powi(4));
    let searched = golden_section(Real::int(0), Real::int(1), f);
    let stepped = newton(&[Real::decimal("0.3")], |x| f(&x[0])).remove(0);
    let slope = Real::int(4) * stepped.powi(3) + Real::int(2) * (&stepped - third);
    assert!(slope.abs() < Real::decimal("1e-33"));
    assert!((searched - stepped).abs() < Real::decimal("1e-33"));
    let two = newton(&[Real::int(0), Real::int(0)], |x| {
        &x[0] * &x[1] + &x[0] - x[0].squared() - x[1].squared()
    });
    assert!((&two[0] - Real::ratio(2, 3)).abs() < Real::decimal("1e-33"));
    assert!((&two[1] - Real::ratio(1, 3)).abs() < Real::decimal("1e-33"));
}
