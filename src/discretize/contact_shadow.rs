//! A patch with a contact shadow: the part beyond a line is simply dark (fig. 1, appendix B).
//!
//! The floor of two perpendicular unit squares sees the wall up to the discontinuity line `d`
//! (distance from the common edge) and nothing beyond it. The cut at t then gains
//!
//! ```text
//!   ΔI(t) = 2/A_T · D( G(min(t,d)), G(d) − G(min(t,d)) ‖ t, 1 − t )
//! ```
//!
//! Appendix B.1: among the cuts `t ≥ d` (one part totally dark) the line itself is best. Appendix
//! B.2: so it is among the cuts `t ≤ d` where the point-to-point form factor is constant; where it
//! is not, another cut wins as `d` nears the far edge.
//!
//! **Not covered**: penumbrae; shadows whose outline is not parallel to the edge.

use super::error::DiscretizeError;
use super::stationarity::stationarity;
use crate::form_factor::RectanglePair;
use crate::geometry::SplitAxis;
use crate::information::{divergence, relative_entropy};
use crate::numeric::{
    CertifiedMaximum, Interval, Maximand, NumericError, Scalar, certified_maximum, maximum, root,
};
use crate::scene::Scene;

/// Two unit squares with a common edge, the first dark beyond a line parallel to it.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactShadow {
    pair: RectanglePair,
    line: f64,
}

impl ContactShadow {
    /// The scene with its discontinuity line at a relative distance from the common edge.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless `0 < line < 1`.
    pub fn try_new(line: f64) -> Result<Self, DiscretizeError> {
        if !(line > 0.0 && line < 1.0) {
            let (parameter, condition) = ("the discontinuity line", "inside (0, 1)");
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value: line,
                condition,
            });
        }
        let scene = Scene::built_in("two-squares")?;
        let pair = RectanglePair::try_new(&scene.rectangle(0)?, &scene.rectangle(1)?)?;
        Ok(Self { pair, line })
    }

    /// The gain of a cut at `position`, in bits (A_T = 2); over intervals an enclosure, the line
    /// counting as exact.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless `0 < position < 1`.
    pub fn gain<S: Scalar>(&self, position: &S) -> Result<S, DiscretizeError> {
        let (zero, one) = (position.zero(), position.constant(1.0));
        if !(*position > zero && *position < one) {
            let (parameter, condition) = ("the cut", "inside (0, 1)");
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value: position.to_f64(),
                condition,
            });
        }
        let pair = self.pair.lifted(position);
        let exchange = |from: &S, to: &S| {
            Ok::<S, DiscretizeError>(pair.part(SplitAxis::U, from, to)?.exchange_value()?)
        };
        let line = position.constant(self.line);
        let (near, beyond) = if *position < line {
            (exchange(&zero, position)?, exchange(position, &line)?)
        } else if *position >= line {
            (exchange(&zero, &line)?, zero)
        } else {
            let (parameter, condition) = ("the cut", "wholly on one side of the line");
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value: position.to_f64(),
                condition,
            });
        };
        let flux = near.clone() + &beyond;
        let parts = [[near, position.clone()], [beyond, one.clone() - position]];
        Ok(relative_entropy(&flux, &one, &parts))
    }

    /// The exchange area of the floor, up to the line, and the wall.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if it leaves `f64`'s range.
    pub fn exchange_area(&self) -> Result<f64, DiscretizeError> {
        self.exchange(0.0, self.line)
    }

    /// The gain of a cut if every lit point received the same flux: flux proportional to lit area.
    ///
    /// **Arguments** `position` inside `(0, 1)`.
    #[must_use]
    pub fn uniform_gain(&self, position: f64) -> f64 {
        debug_assert!(position > 0.0 && position < 1.0, "{position}");
        let near = position.min(self.line);
        divergence(&[near, self.line - near], &[position, 1.0 - position])
    }

    /// The best cut through the lit part, short of the line; `None` if the gain grows all the way.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if the derivative is not finite.
    pub fn best_lit_cut(&self) -> Result<Option<f64>, DiscretizeError> {
        let exchange = |from, to| self.exchange(from, to).unwrap_or(f64::NAN);
        let derivative = |t: f64| {
            let rate = self
                .pair
                .strip_exchange(SplitAxis::U, &t)
                .unwrap_or(f64::NAN);
            let (before, after) = (exchange(0.0, t) / t, exchange(t, self.line) / (1.0 - t));
            stationarity(&rate, &1.0, &before, &after)
        };
        let gain = |t: f64| self.gain(&t).unwrap_or(f64::NAN);
        match maximum(gain, derivative, (0.0, self.line), 32) {
            Ok(found) => Ok(Some(found.position)),
            Err(NumericError::NoInteriorMaximum { .. }) => Ok(None),
            Err(error) => Err(error.into()),
        }
    }

    /// The best cut through the lit part, short of the line, enclosed to about `bits` bits, with
    /// what is proved about it.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if the gain has no maximum there, or it cannot be isolated.
    pub fn certified_lit_cut(&self, bits: u32) -> Result<CertifiedMaximum, DiscretizeError> {
        Ok(certified_maximum(self, (0.0, self.line), bits)?)
    }

    /// The line beyond which a cut through the lit part gains more than the line itself: the limit
    /// of appendix B.2 for perpendicular squares.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if the two gains do not cross between 1/2 and 1.
    pub fn limit_of_the_discontinuity_line() -> Result<f64, DiscretizeError> {
        let advantage = |line: f64| -> Result<f64, DiscretizeError> {
            let shadow = Self::try_new(line)?;
            let at_line = shadow.gain(&line)?;
            Ok(match shadow.best_lit_cut()? {
                Some(cut) => at_line - shadow.gain(&cut)?,
                None => at_line,
            })
        };
        Ok(root(|line| advantage(line).unwrap_or(f64::NAN), 0.5, 0.99)?.position)
    }

    fn exchange(&self, from: f64, to: f64) -> Result<f64, DiscretizeError> {
        Ok(self
            .pair
            .part(SplitAxis::U, &from, &to)?
            .exchange_area()?
            .value)
    }
}

/// The gain of a cut through the lit part.
impl Maximand for ContactShadow {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        self.gain(x).ok()
    }

    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        let pair = self.pair.lifted(x);
        let (zero, one, line) = (x.zero(), x.constant(1.0), x.constant(self.line));
        let part = |from: &S, to: &S| {
            pair.part(SplitAxis::U, from, to)
                .ok()?
                .exchange_value()
                .ok()
        };
        let rate = pair.strip_exchange(SplitAxis::U, x).ok()?;
        let before = part(&zero, x)? / x;
        let after = part(x, &line)? / &(one.clone() - x);
        let nats = stationarity(&rate, &one, &before, &after);
        Some(nats / &x.constant(2.0).ln())
    }

    /// The gain is a sum of `w x ln x`, `x = G/(w G_d)` for the part before the cut and the one
    /// after it. Both fluxes are monotone in the cut; next to the common edge a strip's form factor
    /// is below 1/2.
    fn bound_on(&self, domain: &Interval<f64>) -> Option<f64> {
        let point = |x: f64| Interval::point(x);
        let (from, to) = (point(*domain.lower()), point(*domain.upper()));
        let pair = self.pair.lifted(&from);
        let line = point(self.line);
        let part = |from: &Interval<f64>, to: &Interval<f64>| {
            if from.lower() < to.upper() {
                pair.part(SplitAxis::U, from, to)
                    .ok()?
                    .exchange_value()
                    .ok()
            } else {
                Some(point(0.0))
            }
        };
        let (zero, one) = (point(0.0), point(1.0));
        let whole = part(&zero, &line)?;
        let near = part(&zero, &from)?.hull(&part(&zero, &to)?);
        let beyond = part(&to, &line)?.hull(&part(&from, &line)?);
        // the mean form factor of [0, t] falls with t
        let mean = (part(&zero, &to)? / to).hull(&if *from.lower() > 0.0 {
            part(&zero, &from)? / from
        } else {
            point(0.5)
        });
        let rest = one - *domain;
        let nats = near * (mean / whole).ln() + rest * whole * (beyond / (rest * whole)).x_ln_x();
        Some(*(nats / domain.constant(2.0).ln()).upper())
    }
}
