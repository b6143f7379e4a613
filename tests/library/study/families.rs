//! The families of random pairs.

use infoscene::numeric::{Interval, Scalar};
use infoscene::study::form_factors::families::Family;

/// Every corner of the families is planar exactly: the sixfold volume of a corner and the first
/// three is 0 in 512 bits.
#[test]
fn families_are_planar_exactly() {
    for family in Family::ALL {
        for number in 0..300 {
            for patch in family.pair(number).unwrap() {
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
