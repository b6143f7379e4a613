//! Integrals over an interval, with known singularities near it or at its ends.
//!
//! The interval is cut at the singularities inside and then halved until each
//! panel either has a singularity exactly at an end, where the tanh-sinh rule
//! converges whatever its kind, or keeps at least half its length away from every
//! singularity of the complex plane, where Gauss-Legendre converges geometrically
//! (by ρ⁻²ᴺ, ρ ≥ 2.4). Tanh-sinh is the trapezoidal rule with step h in t after
//! x = 1/(1 + exp(−π sinh t)).
//!
//! Two levels of both rules exist, and a recomputed number is only trusted where
//! the two agree.

use crate::precision::Real;
use std::sync::LazyLock;

/// A rule on (0, 1): nodes and weights.
type Rule = Vec<(Real, Real)>;

/// A Gauss-Legendre and a tanh-sinh rule of matched precision.
pub struct Level {
    smooth: Rule,
    singular: Rule,
}

/// Good to 38 digits in the tests of this module.
pub static COARSE: LazyLock<Level> = LazyLock::new(|| Level::new(52, 26));
/// Good to 48 digits there.
pub static FINE: LazyLock<Level> = LazyLock::new(|| Level::new(68, 34));

/// A place where the integrand, continued to complex arguments, is not smooth:
/// `at ± i height`, in units of the variable of integration.
pub struct Singularity {
    /// Real part.
    pub at: Real,
    /// Imaginary part, at least 0.
    pub height: Real,
}

/// A piece of an interval, and whether an end of it is singular.
struct Panel {
    from: Real,
    to: Real,
    singular: bool,
}

impl Level {
    /// Gauss-Legendre with `nodes` nodes, tanh-sinh with step 1/`per_unit`.
    fn new(nodes: i32, per_unit: i32) -> Self {
        Self {
            smooth: gauss_legendre(nodes),
            singular: tanh_sinh(per_unit),
        }
    }

    /// Calls `visit(x, w)` for the nodes of a rule for ∫ f over `[from, to]`.
    pub fn visit(
        &self,
        from: &Real,
        to: &Real,
        singularities: &[Singularity],
        mut visit: impl FnMut(&Real, &Real),
    ) {
        for panel in panels(from, to, singularities) {
            let length = &panel.to - &panel.from;
            let rule = if panel.singular {
                &self.singular
            } else {
                &self.smooth
            };
            for (node, weight) in rule {
                visit(&(&panel.from + &length * node), &(&length * weight));
            }
        }
    }
}

/// Newton's method on the Legendre polynomial, from the usual cosine guesses.
fn gauss_legendre(count: i32) -> Rule {
    let mut rule = Rule::new();
    for k in 0..count {
        let angle = std::f64::consts::PI * (f64::from(k) + 0.75) / (f64::from(count) + 0.5);
        let mut x = Real::double(angle.cos());
        let mut slope = Real::int(1);
        for _ in 0..6 {
            let (value, derivative) = legendre(count, &x);
            x = &x - value / &derivative;
            slope = derivative;
        }
        // On (−1, 1) the weight is 2/((1 − x²) P'²); on (0, 1) half of it.
        let weight = Real::int(1) / ((Real::int(1) - x.squared()) * slope.squared());
        rule.push(((x + Real::int(1)).half(), weight));
    }
    rule
}

/// The Legendre polynomial of the given degree and its derivative.
fn legendre(degree: i32, x: &Real) -> (Real, Real) {
    let (mut before, mut last) = (Real::int(1), x.clone());
    for k in 2..=degree {
        let next = (Real::int(2 * k - 1) * x * &last - Real::int(k - 1) * &before) / Real::int(k);
        before = std::mem::replace(&mut last, next);
    }
    let derivative = Real::int(degree) * (x * &last - before) / (x.squared() - Real::int(1));
    (last, derivative)
}

/// The tanh-sinh rule with step 1/`per_unit`, to weights of about 10⁻⁷⁵.
fn tanh_sinh(per_unit: i32) -> Rule {
    let one = Real::int(1);
    let step = Real::ratio(1, per_unit);
    let mut rule = Rule::new();
    for k in -(per_unit * 48 / 10)..=(per_unit * 48 / 10) {
        let growth = (Real::int(k) * &step).exp();
        let sinh = (&growth - &one / &growth).half();
        let cosh = (&growth + &one / &growth).half();
        let q = (-(Real::pi() * sinh)).exp();
        let x = &one / (&one + &q);
        let weight = &step * Real::pi() * cosh * q * x.squared();
        rule.push((x, weight));
    }
    rule
}

/// Cuts `[from, to]` as the module description says.
fn panels(from: &Real, to: &Real, singularities: &[Singularity]) -> Vec<Panel> {
    let mut cuts = vec![from.clone(), to.clone()];
    for singularity in singularities {
        if &singularity.at > from && &singularity.at < to {
            cuts.push(singularity.at.clone());
        }
    }
    cuts.sort_by(|a, b| a.partial_cmp(b).unwrap());
    cuts.dedup();
    let mut done = Vec::new();
    for pair in cuts.windows(2) {
        refine(&pair[0], &pair[1], singularities, &mut done);
    }
    done
}

/// Halves a panel until it is far enough from every singularity.
fn refine(from: &Real, to: &Real, singularities: &[Singularity], done: &mut Vec<Panel>) {
    let length = to - from;
    let mut singular = false;
    for Singularity { at, height } in singularities {
        let gap = if at < from {
            from - at
        } else if at > to {
            at - to
        } else {
            Real::int(0)
        };
        let away = gap.squared() + height.squared();
        if away.is_zero() {
            singular = true;
        } else if away < length.half().squared() {
            let middle = (from + to).half();
            refine(from, &middle, singularities, done);
            refine(&middle, to, singularities, done);
            return;
        }
    }
    done.push(Panel {
        from: from.clone(),
        to: to.clone(),
        singular,
    });
}

/// Three integrals with known values: a smooth one, one with a logarithm at an end
/// and one with a pole at the small distance 10⁻⁶ from the interval,
/// ∫₀¹ dx/(x² + d²) = atan(1/d)/d.
#[test]
fn both_levels_integrate_known_functions() {
    let (zero, one) = (Real::int(0), Real::int(1));
    let distance = Real::decimal("1e-6");
    let at_zero = |height: &Real| {
        [Singularity {
            at: Real::int(0),
            height: height.clone(),
        }]
    };
    for (level, tolerance) in [(&COARSE, "1e-38"), (&FINE, "1e-48")] {
        let tolerance = Real::decimal(tolerance);
        let mut sums = vec![Real::int(0); 3];
        level.visit(&zero, &one, &[], |x, w| sums[0] += w * x.exp());
        level.visit(&zero, &one, &at_zero(&zero), |x, w| sums[1] += w * x.ln());
        level.visit(&zero, &one, &at_zero(&distance), |x, w| {
            sums[2] += w * &distance / (x.squared() + distance.squared());
        });
        let known = [one.exp() - &one, Real::int(-1), (&one / &distance).atan()];
        for (sum, known) in sums.iter().zip(&known) {
            let error = (sum - known).abs();
            assert!(error < tolerance, "{sum} is not {known}: {error}");
        }
    }
}
