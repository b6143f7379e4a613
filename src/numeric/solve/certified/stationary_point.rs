//! A stationary point in several variables, with proof that it exists and is the only one nearby.
//!
//! Krawczyk's operator, with C an approximate inverse of the Jacobian of f at the middle m of a box
//! X,
//!
//! ```text
//!   K(X) = m − C f(m) + (1 − C J(X)) (X − m)
//! ```
//!
//! maps X into its inside only if f has exactly one root there, and the root lies in K(X). The
//! Jacobian is enclosed once, in `Interval<f64>`; each further step needs f at one point only.
//!
//! **Not covered**: searching; a point near the root is given.
//!
//! Reference: Moore, Kearfott and Cloud, *Introduction to Interval Analysis*, 2009, ch. 8.

use crate::numeric::{Dual, Interval, NumericError, Scalar};
use nalgebra::DMatrix;

/// A function of several variables with as many values as variables, written once for every number
/// type.
pub trait VectorFunction {
    /// The values at a point; `None` where there are none.
    fn values<S: Scalar>(&self, point: &[S]) -> Option<Vec<S>>;
}

/// Half the width of the box around the given point.
const ROOM: f64 = 1e-12;
/// Steps, each of which adds about as many digits as the Jacobian's box leaves certain.
const STEPS: u32 = 200;

/// The root of a gradient near `near`, a strict local maximum, each coordinate enclosed to about
/// `bits` bits.
///
/// # Errors
/// [`NumericError::NotIsolated`] if the operator does not map the box around `near` into itself, or
/// the Hessian is not shown to be negative definite there.
pub fn certified_stationary_point(
    gradient: &impl VectorFunction,
    near: &[f64],
    bits: u32,
) -> Result<Vec<Interval>, NumericError> {
    let refused = || NumericError::NotIsolated {
        lower: near.first().map_or(f64::NAN, |x| x - ROOM),
        upper: near.last().map_or(f64::NAN, |x| x + ROOM),
    };
    let n = near.len();
    let domain: Vec<Interval<f64>> = near
        .iter()
        .map(|x| Interval::try_new(x - ROOM, x + ROOM).ok_or_else(refused))
        .collect::<Result<_, _>>()?;
    let hessian = hessian(gradient, &domain).ok_or_else(refused)?;
    if !is_negative_definite(&hessian) {
        return Err(refused());
    }
    let middle = DMatrix::from_fn(n, n, |i, j| hessian[i][j].to_f64());
    let inverse = middle.try_inverse().ok_or_else(refused)?;
    // 1 − C J
    let contraction = |i: usize, j: usize| {
        let start = Interval::point(if i == j { 1.0 } else { 0.0 });
        (0..n).fold(start, |sum, k| {
            sum - Interval::point(inverse[(i, k)]) * hessian[k][j]
        })
    };
    let contraction: Vec<Vec<Interval>> = (0..n)
        .map(|i| {
            (0..n)
                .map(|j| Interval::from_doubles(&contraction(i, j), bits))
                .collect()
        })
        .collect();
    let inverse = |i: usize, k: usize| Interval::precise(inverse[(i, k)], bits);
    let mut point: Vec<Interval> = domain
        .iter()
        .map(|x| Interval::from_doubles(x, bits))
        .collect();
    let mut is_proved = false;
    for _ in 0..STEPS {
        let middle: Vec<Interval> = point
            .iter()
            .map(|x| Interval::point(x.midpoint()))
            .collect();
        let values = gradient.values(&middle).ok_or_else(refused)?;
        let image: Vec<Interval> = (0..n)
            .map(|i| {
                let newton = (0..n).fold(middle[i].clone(), |sum, k| {
                    sum - &(inverse(i, k) * &values[k])
                });
                (0..n).fold(newton, |sum, j| {
                    sum + &((point[j].clone() - &middle[j]) * &contraction[i][j])
                })
            })
            .collect();
        is_proved |= point.iter().zip(&image).all(|(x, y)| x.contains_inside(y));
        if !is_proved {
            return Err(refused());
        }
        let narrowed: Vec<Interval> = point
            .iter()
            .zip(&image)
            .map(|(x, y)| x.intersection(y).ok_or_else(refused))
            .collect::<Result<_, _>>()?;
        let shrinks = point
            .iter()
            .zip(&narrowed)
            .any(|(x, y)| y.width() < 0.5 * x.width());
        point = narrowed;
        if !shrinks {
            break;
        }
    }
    Ok(point)
}

/// The Jacobian of the gradient on a box, row by row.
fn hessian(
    gradient: &impl VectorFunction,
    domain: &[Interval<f64>],
) -> Option<Vec<Vec<Interval<f64>>>> {
    let n = domain.len();
    let columns: Vec<Vec<Interval<f64>>> = (0..n)
        .map(|k| {
            let point: Vec<Dual<Interval<f64>>> = domain
                .iter()
                .enumerate()
                .map(|(j, x)| {
                    if j == k {
                        Dual::variable(*x)
                    } else {
                        Dual::constant_like(x)
                    }
                })
                .collect();
            let values = gradient.values(&point)?;
            Some(values.into_iter().map(|value| value.slope).collect())
        })
        .collect::<Option<_>>()?;
    Some(
        (0..n)
            .map(|i| (0..n).map(|k| columns[k][i]).collect())
            .collect(),
    )
}

/// Tells whether all of Gershgorin's circles of `VᵀHV` lie left of 0. V is near the eigenvectors of
/// H, which makes the product nearly diagonal; whatever V is, H is negative definite if the product
/// is.
fn is_negative_definite(hessian: &[Vec<Interval<f64>>]) -> bool {
    let n = hessian.len();
    let middle = DMatrix::from_fn(n, n, |i, k| {
        0.5 * (hessian[i][k].to_f64() + hessian[k][i].to_f64())
    });
    if middle.iter().any(|entry| !entry.is_finite()) {
        return false;
    }
    let vectors = middle.symmetric_eigen().eigenvectors;
    let entry = |i: usize, k: usize| {
        let row = |j: usize| {
            (0..n).fold(hessian[0][0].zero(), |sum, l| {
                sum + hessian[j][l] * Interval::point(vectors[(l, k)])
            })
        };
        (0..n).fold(hessian[0][0].zero(), |sum, j| {
            sum + row(j) * Interval::point(vectors[(j, i)])
        })
    };
    (0..n).all(|i| {
        let others = (0..n).filter(|k| *k != i);
        let radius = others.fold(hessian[0][0].zero(), |sum, k| sum + entry(i, k).abs());
        entry(i, i) + radius < radius.zero()
    })
}
