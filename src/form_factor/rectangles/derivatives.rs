//! First and second derivatives of the rectangle forms at their sixteen corners: how an exchange
//! area changes as edges move.
//!
//! ```text
//!   parallel        2π A F = Σ ± G(u, v)
//!     p² = u² + z²,  q² = v² + z²,  α = atan(v/p),  β = atan(u/q)
//!     G_u = (u v/p) α + q β    G_uu = z² v α/p³    G_uv = (u/p) α + (v/q) β   (G_v, G_vv likewise)
//!   perpendicular   2π A F = −Σ ± G(x, z, v),  s² = x² + z², r² = s² + v², α = atan(v/s)
//!     H = (v/s) α − ½ ln r²,  K = (v/s) α/s²
//!     G_x = x H      G_xx = H − x² K     G_xz = −x z K     G_xv = (x/s) α     (by z likewise)
//!     G_v = s α + ½ v ln r²              G_vv = ½ ln r²
//! ```
//!
//! up to functions that the differences in the other coordinates cancel. Where an edge is the same
//! line for both rectangles (v = 0) its derivative by v is infinite, but v does not change; on the
//! line in which two planes meet (s = 0) nothing depends on x or z.
//!
//! **Not covered**: the cancellation in the sums; exchange areas themselves come from
//! [`parallel`](super::parallel) and [`perpendicular`](super::perpendicular), which take one
//! difference in closed form.

use super::corner_sum::Sign;
use crate::geometry::Offsets;
use crate::numeric::Scalar;
use std::array::from_fn;

/// Corners of a pair: two ends of each of four sides.
const CORNERS: usize = 16;

/// Derivatives of an exchange area by the eight numbers that place the edges: first those named by
/// the form, then the four differences of ends along the (second) common axis, lower ends first.
#[derive(Debug, Clone)]
pub(crate) struct EdgeSlopes<S> {
    /// First derivatives.
    pub first: [S; 8],
    /// Σ |term| of these.
    pub magnitude: [S; 8],
    /// Second derivatives.
    pub second: [[S; 8]; 8],
}

/// The sign of end i of the first side and end k of the second, in a second difference.
fn sign(i: usize, k: usize) -> Sign {
    if i == k { Sign::Minus } else { Sign::Plus }
}

/// The `k`-th difference of ends.
fn difference<S: Scalar>(offsets: &Offsets<S>, k: usize) -> &S {
    offsets.difference(k / 2, k % 2)
}

impl<S: Scalar> EdgeSlopes<S> {
    fn new(like: &S) -> Self {
        let zero = || from_fn(|_| like.zero());
        Self {
            first: zero(),
            magnitude: zero(),
            second: from_fn(|_| zero()),
        }
    }

    fn add(&mut self, sign: Sign, at: usize, term: &S) {
        let signed = if sign == Sign::Plus {
            term.clone()
        } else {
            -term.clone()
        };
        self.first[at] = self.first[at].clone() + &signed;
        if S::TRACKS_ROUNDING {
            self.magnitude[at] = self.magnitude[at].clone() + &term.abs();
        }
    }

    /// `at` names the smaller index first.
    fn add_second(&mut self, sign: Sign, at: [usize; 2], term: &S) {
        let entry = &mut self.second[at[0]][at[1]];
        *entry = match sign {
            Sign::Plus => entry.clone() + term,
            Sign::Minus => entry.clone() - term,
        };
    }

    /// Divided by 2π and signed; the other half of the second derivatives filled in.
    fn finished(mut self, sign: Sign) -> Self {
        let two_pi = self.first[0].pi() * &self.first[0].constant(2.0);
        let factor = match sign {
            Sign::Plus => two_pi.constant(1.0) / &two_pi,
            Sign::Minus => two_pi.constant(-1.0) / &two_pi,
        };
        let positive = factor.abs();
        for i in 0..8 {
            self.first[i] = self.first[i].clone() * &factor;
            self.magnitude[i] = self.magnitude[i].clone() * &positive;
            for k in i..8 {
                self.second[i][k] = self.second[i][k].clone() * &factor;
                self.second[k][i] = self.second[i][k].clone();
            }
        }
        self
    }

    /// The derivatives for parallel rectangles: by the four differences along one axis, then by
    /// those along the other.
    pub(crate) fn parallel([us, vs]: [&Offsets<S>; 2], distance: &S) -> Self {
        let u: [S; CORNERS] = from_fn(|c| difference(us, c / 4).clone());
        let v: [S; CORNERS] = from_fn(|c| difference(vs, c % 4).clone());
        let mut terms = None;
        let (out, z) = (&mut terms, distance.clone());
        S::vectorised(
            #[inline(always)]
            move || {
                let (u, v, z) = (u, v, z);
                let z2 = z.square();
                let mut columns: [[S; CORNERS]; 5] = from_fn(|_| from_fn(|_| z2.clone()));
                for c in 0..CORNERS {
                    let (p2, q2) = (u[c].square() + &z2, v[c].square() + &z2);
                    let (p, q) = (p2.sqrt(), q2.sqrt());
                    let (along, across) = (v[c].atan2(&p) / &p, u[c].atan2(&q) / &q);
                    let (v_along, u_across) = (v[c].clone() * &along, u[c].clone() * &across);
                    columns[0][c] = u[c].clone() * &v_along + &(q2.clone() * &across);
                    columns[1][c] = v[c].clone() * &u_across + &(p2.clone() * &along);
                    columns[2][c] = v_along * &z2 / &p2;
                    columns[3][c] = u_across * &z2 / &q2;
                    columns[4][c] = u[c].clone() * &along + &(v[c].clone() * &across);
                }
                *out = Some(columns);
            },
        );
        let mut sum = Self::new(distance);
        let Some([g_u, g_v, g_uu, g_vv, g_uv]) = terms else {
            return sum;
        };
        for c in 0..CORNERS {
            let (a, b) = (c / 4, c % 4);
            let sign = sign(a / 2, a % 2).times(sign(b / 2, b % 2));
            sum.add(sign, a, &g_u[c]);
            sum.add(sign, 4 + b, &g_v[c]);
            sum.add_second(sign, [a, a], &g_uu[c]);
            sum.add_second(sign, [4 + b, 4 + b], &g_vv[c]);
            sum.add_second(sign, [a, 4 + b], &g_uv[c]);
        }
        sum.finished(Sign::Plus)
    }

    /// The derivatives for perpendicular rectangles: by both ends of either depth, the lower first,
    /// then by the differences of widths.
    pub(crate) fn perpendicular(depths: [[&S; 2]; 2], widths: &Offsets<S>) -> Self {
        let like = depths[0][1];
        let x: [S; CORNERS] = from_fn(|c| depths[0][c / 8].clone());
        let z: [S; CORNERS] = from_fn(|c| depths[1][c / 4 % 2].clone());
        let v: [S; CORNERS] = from_fn(|c| difference(widths, c % 4).clone());
        let mut terms = None;
        let (out, half) = (&mut terms, like.constant(0.5));
        S::vectorised(
            #[inline(always)]
            move || {
                let (x, z, v, half) = (x, z, v, half);
                let mut columns: [[S; CORNERS]; 5] = from_fn(|_| from_fn(|_| half.clone()));
                for c in 0..CORNERS {
                    let s2 = x[c].square() + &z[c].square();
                    let s = s2.sqrt();
                    let angle = v[c].atan2(&s);
                    let log = (s2.clone() + &v[c].square()).ln() * &half;
                    let steep = v[c].clone() * &angle / &s;
                    columns[0][c] = steep.clone() - &log;
                    columns[1][c] = steep / &s2;
                    columns[2][c] = angle.clone() / &s;
                    columns[3][c] = s * &angle + &(v[c].clone() * &log);
                    columns[4][c] = log;
                }
                *out = Some(columns);
            },
        );
        let mut sum = Self::new(like);
        let Some([h, k, slant, g_v, log]) = terms else {
            return sum;
        };
        let signs = [Sign::Minus, Sign::Plus];
        for c in 0..CORNERS {
            let (i, j, b) = (c / 8, c / 4 % 2, c % 4);
            let [x, z] = [depths[0][i], depths[1][j]];
            let sign = signs[i].times(signs[j]).times(sign(b / 2, b % 2));
            let on_the_line = x.is_zero() && z.is_zero();
            if !difference(widths, b).is_zero() {
                sum.add(sign, 4 + b, &g_v[c]);
                sum.add_second(sign, [4 + b, 4 + b], &log[c]);
                if !on_the_line {
                    sum.add_second(sign, [i, 4 + b], &(x.clone() * &slant[c]));
                    sum.add_second(sign, [2 + j, 4 + b], &(z.clone() * &slant[c]));
                }
            }
            if !on_the_line {
                sum.add(sign, i, &(x.clone() * &h[c]));
                sum.add(sign, 2 + j, &(z.clone() * &h[c]));
                let rest = |square: S| h[c].clone() - &(square * &k[c]);
                sum.add_second(sign, [i, i], &rest(x.square()));
                sum.add_second(sign, [2 + j, 2 + j], &rest(z.square()));
                sum.add_second(sign, [i, 2 + j], &-(x.clone() * z * &k[c]));
            }
        }
        sum.finished(Sign::Minus)
    }
}
