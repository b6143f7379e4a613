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
use crate::numeric::{NumericError, Scalar, maximum, root};
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
