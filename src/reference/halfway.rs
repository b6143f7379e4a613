//! The exact exchange area of two unit squares past plates half-way between them.
//!
//! ```text
//!   P: z = 0,  Q: z = h, facing,  plates: z = h/2
//!   V(c, d) = measure of the lines from P to Q that cross z = h/2 where x < c and y < d
//!   c ≤ 1/2:  V(c, ·) = ½ E(2c, ·)         E(a, b): exchange area of two facing rectangles a × b
//!   c > 1/2:  V(c, ·) = E(1, ·) − ½ E(2 − 2c, ·)                               likewise for d
//!   hidden by [c, c'] × [d, d']:  V(c', d') − V(c, d') − V(c', d) + V(c, d)
//! ```
//!
//! A line from (x₁, y₁) to (x₂, y₂) crosses the middle at (x₁ + x₂)/2. With x₁ + x₂ < 2c ≤ 1 both
//! ends are below 2c, and the map (x₁, x₂) → (2c − x₂, 2c − x₁) of such ends keeps x₁ − x₂, on
//! which alone the kernel depends, and exchanges the two sides of x₁ + x₂ = 2c: so it is one half
//! of what the strips below 2c exchange.
//!
//! **Not covered**: plates that overlap each other, in the sum of which an overlap counts twice.

use super::Truth;
use super::truth::{BITS, enclosed};
use crate::form_factor::{FormFactorError, RectanglePair};
use crate::geometry::Rectangle;
use crate::numeric::{Interval, Scalar};
use glam::DVec3;
use std::collections::BTreeMap;

/// The exchange area of two unit squares that face each other, past plates half-way between them.
///
/// **Arguments** `height`: distance of the squares, > 0; `plates`: `[[x, x'], [y, y']]` of each in
/// the squares' frame, which reaches from 0 to 1, no two of them overlapping; what lies outside
/// counts as the nearest line of the squares.
/// **Returns** an enclosure with 256 bits.
///
/// # Errors
/// [`FormFactorError::NonPositiveLength`] if the height is not positive; [`FormFactorError`] if it
/// is infinite, or if the value leaves the range of `f64`.
///
/// # Examples
/// ```
/// use infoscene::reference::past_halfway_plates;
/// // a plate over half of the squares hides half of 0.199824895698387…
/// let half = past_halfway_plates(1.0, &[[[0.0, 1.0], [0.5, 1.0]]])?;
/// assert!((2.0 * half.value() - 0.199_824_895_698_387).abs() < 1e-15);
/// # Ok::<(), infoscene::form_factor::FormFactorError>(())
/// ```
pub fn past_halfway_plates(
    height: f64,
    plates: &[[[f64; 2]; 2]],
) -> Result<Truth, FormFactorError> {
    if height.is_nan() || height <= 0.0 {
        return Err(FormFactorError::NonPositiveLength {
            quantity: "the distance of the squares",
            value: height,
        });
    }
    let mut facing = Facing {
        height,
        known: BTreeMap::new(),
    };
    let mut seen = facing.exchange(1.0, 1.0)?;
    for [x, y] in plates {
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let corner = facing.below([x[i], y[j]])?;
            seen = if i == j {
                seen - &corner
            } else {
                seen + &corner
            };
        }
    }
    Ok(Truth::of_enclosure(seen))
}

/// Facing rectangles of all sizes, each computed once.
struct Facing {
    height: f64,
    known: BTreeMap<[u64; 2], Interval>,
}

impl Facing {
    /// The exchange area of two rectangles `width × depth`.
    fn exchange(&mut self, width: f64, depth: f64) -> Result<Interval, FormFactorError> {
        let key = [width, depth].map(f64::to_bits);
        if let Some(known) = self.known.get(&key) {
            return Ok(known.clone());
        }
        let (x, y, z) = (width * DVec3::X, depth * DVec3::Y, self.height * DVec3::Z);
        let floor = Rectangle::try_new(DVec3::ZERO, x, y)?;
        let ceiling = Rectangle::try_new(z, y, x)?;
        let found = enclosed(&RectanglePair::try_new(&floor, &ceiling)?)?;
        self.known.insert(key, found.clone());
        Ok(found)
    }

    /// V of a corner.
    fn below(&mut self, corner: [f64; 2]) -> Result<Interval, FormFactorError> {
        let [x, y] = corner.map(strips);
        let mut sum = Interval::precise(0.0, BITS);
        for (share, width) in &x {
            for (other, depth) in &y {
                if *width > 0.0 && *depth > 0.0 {
                    let exchange = self.exchange(*width, *depth)?;
                    sum = sum.clone() + &(exchange * &sum.constant(share * other));
                }
            }
        }
        Ok(sum)
    }
}

/// The strips whose exchange makes up the lines below c, each with its factor; all are exact: 1 − c
/// from 1/2 to 1, as Sterbenz has it.
fn strips(c: f64) -> Vec<(f64, f64)> {
    let c = c.clamp(0.0, 1.0);
    if c <= 0.5 {
        vec![(0.5, 2.0 * c)]
    } else {
        vec![(1.0, 1.0), (-0.5, 2.0 * (1.0 - c))]
    }
}
