//! The division of a range into parts on each of which a Gauss rule is right to the digits asked
//! for.
//!
//! ```text
//!   a rule of n points errs by about M ρ^(−2n)
//!       ρ = a + √(a² − 1),  a = (|z − lower| + |z − upper|)/(upper − lower)
//! ```
//!
//! for the singularity z with the smallest ρ, where M is the size of the part's integral. A part
//! whose rule would be long is bisected; towards a singularity on the range the parts shrink until
//! M is below the error allowed. This is an estimate: the size and the constant are taken for
//! granted, and tested by a second pass.

/// A part of a range, as distances from its start, with the points of its rule.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Panel {
    pub ends: [f64; 2],
    pub order: usize,
}

/// The fineness with which a pass divides.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fineness {
    /// Longest rule.
    pub longest: usize,
    /// Points more than the estimate asks for.
    pub spare: usize,
}

/// The parts of `[0, 1]`; `size` bounds the integral over a part, and an error of `allowed` is of
/// no account in each.
pub(crate) fn panels(
    singularities: &[(f64, f64)],
    size: impl Fn(f64, f64) -> f64,
    allowed: f64,
    fineness: Fineness,
) -> Vec<Panel> {
    let mut found = Vec::new();
    let mut open = vec![[0.0, 1.0]];
    while let Some([lower, upper]) = open.pop() {
        let (ratio, nearest) = singularities
            .iter()
            .map(|z| (bernstein(lower, upper, *z), z.0))
            .fold((f64::INFINITY, lower), |worst, next| {
                if next.0 < worst.0 { next } else { worst }
            });
        let excess = (size(lower, upper) / allowed).max(1.0).ln();
        let points = excess / (2.0 * ratio.ln().max(1e-9));
        #[allow(clippy::cast_precision_loss, reason = "below 100")]
        let longest = fineness.longest as f64;
        // the quarter beside a singular end: the rest then has ρ = 3
        let place = match (nearest - lower) / (upper - lower) {
            x if x < 0.125 => 0.25,
            x if x > 0.875 => 0.75,
            _ => 0.5,
        };
        let middle = lower + place * (upper - lower);
        if points > longest && lower < middle && middle < upper {
            open.push([middle, upper]);
            open.push([lower, middle]);
        } else {
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "between 0 and the longest rule"
            )]
            let order = points.min(longest).ceil() as usize + fineness.spare;
            found.push(Panel {
                ends: [lower, upper],
                order,
            });
        }
    }
    found
}

/// ρ of the ellipse with foci at the ends that passes through z.
fn bernstein(lower: f64, upper: f64, (at, off): (f64, f64)) -> f64 {
    let focal = (at - lower).hypot(off) + (at - upper).hypot(off);
    let a = (focal / (upper - lower)).max(1.0);
    a + ((a - 1.0) * (a + 1.0)).sqrt()
}
