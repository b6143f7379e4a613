//! The gain of cutting one rectangle in two, as a function of where.
//!
//! A rectangle of area A that exchanges E = A F with another one is cut into parts of
//! areas A₁, A₂ exchanging E₁ + E₂ = E. The gain in bits is
//!
//! ```text
//! U = Σ_k A_k F_k log2 F_k − A F log2 F,   F_k = E_k/A_k.
//! ```
//!
//! The exchange areas are numerical integrals: over parallel edges for rectangles at
//! right angles, over the contours for the inclined squares.

use crate::contour::{Polygon, exchange_area};
use crate::parallel_edges::perpendicular;
use crate::precision::Real;
use crate::quadrature::Level;

/// A scene and the direction of the cut; the place of the cut is relative, in (0, 1).
#[derive(Clone, Copy, Debug)]
pub enum Curve {
    /// Rectangles at right angles with a common edge of length 1, the other of depth
    /// 1: cut parallel to the common edge through a rectangle of the depth given.
    Parallel {
        /// Depth of the rectangle that is cut.
        depth: i32,
    },
    /// Unit squares at right angles, cut at right angles to their common edge.
    Orthogonal,
    /// Three unit squares in a corner, one cut parallel to one of its common edges.
    ThreeSquares,
    /// Unit squares at 60 degrees, cut parallel to their common edge.
    Inclined,
}

impl Curve {
    /// The gain U of the cut at the relative distance `t`.
    pub fn gain(self, t: &Real, level: &Level) -> Real {
        match self {
            Self::ThreeSquares => {
                Self::Parallel { depth: 1 }.gain(t, level) + Self::Orthogonal.gain(t, level)
            }
            _ => {
                let (zero, one) = (Real::int(0), Real::int(1));
                gain(&[self.part(&zero, t, level), self.part(t, &one, level)])
            }
        }
    }

    /// The exchange area of the rectangle before it is cut.
    pub fn whole(self, level: &Level) -> Real {
        self.part(&Real::int(0), &Real::int(1), level).1
    }

    /// Area and exchange area of the part between two relative distances.
    fn part(self, from: &Real, to: &Real, level: &Level) -> (Real, Real) {
        let unit = [Real::int(0), Real::int(1)];
        let share = to - from;
        match self {
            Self::Parallel { depth } => {
                let depth = Real::int(depth);
                let x = [from * &depth, to * &depth];
                (share * depth, perpendicular(&x, &unit, &unit, &unit, level))
            }
            Self::Orthogonal => {
                let y = [from.clone(), to.clone()];
                (share, perpendicular(&unit, &y, &unit, &unit, level))
            }
            Self::Inclined => {
                let cut = horizontal(from, to);
                (share, exchange_area(&cut, &inclined(), level))
            }
            Self::ThreeSquares => panic!("two exchanges, not one"),
        }
    }
}

/// Σ_k E_k log2(E_k/A_k) − E log2(E/A) of the parts' areas and exchange areas.
fn gain(parts: &[(Real, Real)]) -> Real {
    let (mut area, mut exchange, mut gain) = (Real::int(0), Real::int(0), Real::int(0));
    for (a, e) in parts {
        gain += e * (e / a).log2();
        area += a.clone();
        exchange += e.clone();
    }
    gain - &exchange * (&exchange / area).log2()
}

/// The rectangle `[from, to] × [0, 1]` in the plane z = 0, seen from above.
fn horizontal(from: &Real, to: &Real) -> Polygon {
    let (zero, one) = (Real::int(0), Real::int(1));
    let corners = [(from, &zero), (to, &zero), (to, &one), (from, &one)];
    let point = |(x, y): (&Real, &Real)| [x.clone(), y.clone(), Real::int(0)];
    corners.map(point).to_vec()
}

/// The unit square through the y axis at 60 degrees, seen from below.
fn inclined() -> Polygon {
    let corners = [(0, 0), (0, 1), (1, 1), (1, 0)];
    let height = Real::int(3).sqrt().half();
    let point = |(x, y): (i32, i32)| {
        let x = Real::int(x);
        [x.half(), Real::int(y), x * &height]
    };
    corners.map(point).to_vec()
}

/// E₁ + E₂ = E for the cut at t = 3/10 of every kind.
#[test]
fn the_exchange_areas_of_the_parts_add_up() {
    let level = &crate::quadrature::COARSE;
    let (zero, one) = (Real::int(0), Real::int(1));
    let cut = Real::ratio(3, 10);
    let tolerance = Real::decimal("1e-34");
    for curve in [
        Curve::Parallel { depth: 1 },
        Curve::Parallel { depth: 2 },
        Curve::Orthogonal,
        Curve::Inclined,
    ] {
        let exchange = |from, to| curve.part(from, to, level).1;
        let parts = exchange(&zero, &cut) + exchange(&cut, &one);
        let error = (parts - curve.whole(level)).abs();
        assert!(error < tolerance, "{curve:?}: {error}");
    }
}
