//! The global maximum of a function on an open interval, with proof.
//!
//! Inside, every root of the derivative is found ([`certified_roots`]). Next to the two ends, where
//! `t ln t` and divisions by zero live, the objective speaks for itself: by the sign of its derivative in an analytic
//! form, or by an upper bound on its values.
//!
//! **Not covered**: several variables; maxima at the ends themselves.

use super::certified_roots::{Function, certified_roots, sign_on};
use super::interval::Interval;
use super::{NumericError, Scalar};

/// One of the ends of the interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The lower one.
    Lower,
    /// The upper one.
    Upper,
}

/// A function to be maximised, written once for every number type.
pub trait Objective {
    /// The value at `x`; `None` where there is none.
    fn value<S: Scalar>(&self, x: &S) -> Option<S>;
    /// The derivative at `x`.
    fn slope<S: Scalar>(&self, x: &S) -> Option<S>;
    /// The derivative at `distance` from an end, in a form that holds down to distance 0.
    fn slope_near<S: Scalar>(&self, _end: End, _distance: &S) -> Option<S> {
        None
    }
    /// An upper bound on the values at all distances up to `distance` from an end.
    fn bound_near(&self, _end: End, _distance: &Interval<f64>) -> Option<Interval<f64>> {
        None
    }
}

/// What is proved about a maximum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Certificate {
    /// The maximiser is the only one in the open interval.
    Unique {
        /// Is it the only stationary point, too? `None`: the derivative's sign next to the ends is not known.
        is_only_stationary_point: Option<bool>,
    },
    /// The maximum is proved, and attained at one of this many points, which their enclosures cannot tell apart.
    Several {
        /// How many.
        maximisers: usize,
    },
    /// Not proved.
    Unknown {
        /// Why.
        reason: String,
    },
}

/// A maximum with the enclosures of its position and value.
#[derive(Debug, Clone, PartialEq)]
pub struct CertifiedMaximum {
    /// Contains the maximiser.
    pub position: Interval,
    /// Contains the maximum.
    pub value: Interval,
    /// What is proved.
    pub certificate: Certificate,
    /// How often the derivative was evaluated on an interval.
    pub evaluations: u64,
}

struct Slope<'o, O>(&'o O);

impl<O: Objective> Function for Slope<'_, O> {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        self.0.slope(x)
    }
}

struct SlopeNear<'o, O>(&'o O, End);

impl<O: Objective> Function for SlopeNear<'_, O> {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        self.0.slope_near(self.1, x)
    }
}

/// Largest and smallest k of the end boxes, 2^−k of the interval.
const END_POWERS: std::ops::RangeInclusive<i32> = 4..=40;

/// The global maximum of `objective` in the open interval `range`, enclosed to about `bits` bits.
///
/// # Errors
/// [`NumericError::EmptyInterval`]; [`NumericError::NoInteriorMaximum`] if no root of the derivative is found at
/// which it falls.
pub fn certified_maximum(
    objective: &impl Objective,
    (lower, upper): (f64, f64),
    bits: u32,
) -> Result<CertifiedMaximum, NumericError> {
    if !(lower.is_finite() && upper.is_finite() && lower < upper) {
        return Err(NumericError::EmptyInterval { lower, upper });
    }
    let ends = [End::Lower, End::Upper].map(|end| EndBox::of(objective, end, upper - lower));
    // no gap to the end boxes
    let from = (lower + ends[0].distance).next_down();
    let to = (upper - ends[1].distance).next_up();
    let found = certified_roots(&Slope(objective), (from, to), bits);
    let mut best: Option<(Interval, Interval)> = None;
    let mut maximisers = 0;
    for root in found.roots.iter().filter(|root| !root.rises) {
        let Some(value) = objective.value(&root.enclosure) else {
            continue;
        };
        match &best {
            Some((_, highest)) if value < *highest => {}
            Some((_, highest)) if value > *highest => {
                best = Some((root.enclosure.clone(), value));
                maximisers = 1;
            }
            Some((position, highest)) => {
                // the larger of the two, wherever it is
                let larger = highest.larger_of(&value);
                best = Some((position.clone(), larger));
                maximisers += 1;
            }
            None => {
                best = Some((root.enclosure.clone(), value));
                maximisers = 1;
            }
        }
    }
    let Some((position, value)) = best else {
        return Err(NumericError::NoInteriorMaximum { lower, upper });
    };
    let (at_least, _) = value.to_doubles();
    let exclusion = |end: &EndBox| match &end.exclusion {
        Exclusion::BySlope => true,
        Exclusion::ByBound(bound) => *bound < at_least,
        Exclusion::None => false,
    };
    let certificate = if let Some((from, to)) = found.undecided.first() {
        let reason = format!("nothing could be decided between {from} and {to}");
        Certificate::Unknown { reason }
    } else if let Some(end) = ends.iter().find(|end| !exclusion(end)) {
        let reason = format!("next to the {} nothing is known", end.name());
        Certificate::Unknown { reason }
    } else if maximisers > 1 {
        Certificate::Several { maximisers }
    } else {
        let by_slope = ends
            .iter()
            .all(|end| matches!(end.exclusion, Exclusion::BySlope));
        let is_only_stationary_point = by_slope.then(|| found.roots.len() == 1);
        Certificate::Unique {
            is_only_stationary_point,
        }
    };
    Ok(CertifiedMaximum {
        position,
        value,
        certificate,
        evaluations: found.evaluations,
    })
}

/// Why no maximum lies next to an end.
enum Exclusion {
    /// The function rises away from the end.
    BySlope,
    /// Values there stay below this number.
    ByBound(f64),
    /// No reason found.
    None,
}

/// The numbers next to an end that are left out of the search.
struct EndBox {
    end: End,
    distance: f64,
    exclusion: Exclusion,
}

impl EndBox {
    /// The widest box in which the derivative points away from the end; else one with a bound.
    fn of(objective: &impl Objective, end: End, length: f64) -> Self {
        let distance = |power: i32| length * 2f64.powi(-power);
        let up_to = |distance: f64| Interval::try_new(0.0, distance);
        let away = END_POWERS.map(distance).find(|distance| {
            let rises = up_to(*distance)
                .and_then(|domain| sign_on(&SlopeNear(objective, end), &domain));
            rises == Some(end == End::Lower)
        });
        if let Some(distance) = away {
            return Self {
                end,
                distance,
                exclusion: Exclusion::BySlope,
            };
        }
        let distance = distance(BOUNDED_POWER);
        let bound = up_to(distance).and_then(|domain| objective.bound_near(end, &domain));
        Self {
            end,
            distance,
            exclusion: bound.map_or(Exclusion::None, |bound| {
                Exclusion::ByBound(*bound.upper())
            }),
        }
    }

    const fn name(&self) -> &'static str {
        match self.end {
            End::Lower => "lower end",
            End::Upper => "upper end",
        }
    }
}

/// The width of an end box that is left out by a bound, as a power of two of the interval.
const BOUNDED_POWER: i32 = 8;
