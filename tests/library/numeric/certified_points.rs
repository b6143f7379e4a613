//! Certified stationary points in several variables against functions whose maximum is known
//! beforehand.

use infoscene::numeric::{NumericError, Scalar, VectorFunction, certified_stationary_point};
use proptest::prelude::*;

/// Precision of the enclosures.
const BITS: u32 = 128;
/// Their width: a root of size one is found to a few units of 2⁻¹²⁸ = 3e-39, times condition.
const WIDTH: f64 = 1e-33;

/// The gradient of `Σ_i −c_i (x_i − m_i)² − q (x_i − m_i)⁴ + k Σ_{i<j} (x_i − m_i)(x_j − m_j)`,
/// with its root at m = thirds.
struct Hill {
    thirds: Vec<i16>,
    curvatures: Vec<f64>,
    quartic: f64,
    coupling: f64,
}

impl VectorFunction for Hill {
    fn values<S: Scalar>(&self, point: &[S]) -> Option<Vec<S>> {
        let aside: Vec<S> = point
            .iter()
            .zip(&self.thirds)
            .map(|(x, third)| x.clone() - &(x.constant((*third).into()) / &x.constant(3.0)))
            .collect();
        let slope = |i: usize| {
            let x = &aside[i];
            let start = -(x.constant(2.0 * self.curvatures[i]) * x)
                - &(x.square() * x * &x.constant(4.0 * self.quartic));
            let others = aside.iter().enumerate().filter(|(j, _)| *j != i);
            others.fold(start, |sum, (_, other)| {
                sum + &(other.clone() * &x.constant(self.coupling))
            })
        };
        Some((0..aside.len()).map(slope).collect())
    }
}

impl Hill {
    fn near(&self) -> Vec<f64> {
        self.thirds
            .iter()
            .map(|third| f64::from(*third) / 3.0)
            .collect()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.div_ceil(8)))]

    /// Concave quadratics and quartics in two and three variables, coupled less than their
    /// curvatures: the known maximum, also from a point 1e-13 aside.
    #[test]
    fn known_stationary_points_are_enclosed(
        thirds in proptest::collection::vec(-6..6i16, 2..4),
        curvatures in proptest::collection::vec(1.0..4.0f64, 3),
        quartic in prop_oneof![Just(0.0), 0.0..5.0f64],
        coupling in -0.9..0.9f64,
        aside in -1e-13..1e-13f64,
    ) {
        let hill = Hill { thirds, curvatures, quartic, coupling };
        let near: Vec<f64> = hill.near().iter().map(|x| x + aside).collect();
        let point = certified_stationary_point(&hill, &near, BITS).unwrap();
        prop_assert_eq!(point.len(), near.len());
        for (x, third) in point.iter().zip(&hill.thirds) {
            prop_assert!((x.constant(3.0) * x).contains(&x.constant((*third).into())));
            prop_assert!(x.width() <= WIDTH, "{:e}", x.width());
        }
    }
}

/// Saddles, minima, points too far off and points that are none are refused.
#[test]
fn only_maxima_nearby_are_certified() {
    let hill = |curvatures: [f64; 2], coupling| Hill {
        thirds: vec![1, 2],
        curvatures: curvatures.to_vec(),
        quartic: 1.0,
        coupling,
    };
    let is_refused = |hill: &Hill, near: &[f64]| {
        let result = certified_stationary_point(hill, near, BITS);
        matches!(result, Err(NumericError::NotIsolated { .. }))
    };
    let maximum = hill([1.0, 1.0], 0.5);
    let near = maximum.near();
    assert!(!is_refused(&maximum, &near));
    assert!(is_refused(&hill([1.0, -1.0], 0.5), &near), "a saddle");
    assert!(
        is_refused(&hill([1.0, 1.0], 3.0), &near),
        "a coupled saddle"
    );
    assert!(is_refused(&hill([-1.0, -1.0], 0.5), &near), "a minimum");
    assert!(is_refused(&hill([0.0, 0.0], 0.0), &near), "flat");
    for aside in [1e-11, 1e-6, 0.1, f64::NAN, f64::INFINITY] {
        assert!(is_refused(&maximum, &[near[0] + aside, near[1]]), "{aside}");
    }
    // the box of 1e-12 about a coordinate of 1e6 has no room between doubles
    let far = Hill {
        thirds: vec![3000, 3001],
        ..hill([1.0, 1.0], 0.5)
    };
    assert!(!is_refused(&far, &far.near()), "a thousand");
}

/// A negative definite Hessian that is not diagonally dominant, and one that is not negative
/// definite.
#[test]
fn strong_coupling_of_three_variables_is_told_from_a_saddle() {
    let hill = |coupling| Hill {
        thirds: vec![0, 1, 2],
        curvatures: vec![1.0; 3],
        quartic: 0.0,
        coupling,
    };
    // −2 on the diagonal and −1.5 beside it: eigenvalues −0.5, −0.5, −5
    let strong = hill(-1.5);
    let point = certified_stationary_point(&strong, &strong.near(), BITS).unwrap();
    for (x, third) in point.iter().zip([0.0, 1.0, 2.0]) {
        assert!((x.constant(3.0) * x).contains(&x.constant(third)));
    }
    // −2.5 beside it: 0.5, 0.5, −7
    let saddle = hill(-2.5);
    let refusal = certified_stationary_point(&saddle, &saddle.near(), BITS).unwrap_err();
    assert!(matches!(refusal, NumericError::NotIsolated { .. }));
}
