//! The global maximum of a function on an open interval, with proof.
//!
//! Inside, every root of the derivative is found ([`certified_roots`]). Next to the two ends, where
//! `t ln t` and divisions by zero live, the objective itself excludes a maximum: by the sign of
//! its derivative in an analytic form, or by an upper bound on its values, which then leaves only
//! the neighbourhood of the maximum to be searched.
//!
//! **Not covered**: several variables; maxima at the ends themselves.

use super::roots::{IntervalFunction, certified_roots, sign_on};
use crate::numeric::{Dual, Interval, NumericError, Scalar, maximum};
use std::cmp::Ordering;
use std::fmt::{self, Display, Formatter};

/// One of the ends of the interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EndPoint {
    /// The lower one.
    Lower,
    /// The upper one.
    Upper,
}

/// A function to be maximised, written once for every number type.
pub trait Maximand {
    /// The value at `x`; `None` where there is none.
    fn value<S: Scalar>(&self, x: &S) -> Option<S>;
    /// The derivative at `x`.
    fn slope<S: Scalar>(&self, x: &S) -> Option<S>;
    /// The derivative on a box, and the second derivative there, as narrow as can be had quickly.
    fn slope_on_box(&self, domain: &Interval<f64>) -> Option<Dual<Interval<f64>>> {
        self.slope(&Dual::variable(*domain))
    }
    /// The derivative at `distance` from an end, in a form that holds down to distance 0.
    fn slope_near<S: Scalar>(&self, _end: EndPoint, _distance: &S) -> Option<S> {
        None
    }
    /// An upper bound on the values at all points of a box; `None` if there is no better way than
    /// to evaluate.
    fn bound_on(&self, _domain: &Interval<f64>) -> Option<f64> {
        None
    }
}

/// The statement proved about a maximum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Certificate {
    /// The maximiser is the only one in the open interval.
    Unique {
        /// Whether the maximiser is the only stationary point, too. `None`: the derivative is not
        /// known everywhere.
        is_only_stationary_point: Option<bool>,
    },
    /// The maximum is proved, and attained at one of this many points, which their enclosures
    /// cannot tell apart.
    Several {
        /// The number of these points.
        maximisers: usize,
    },
    /// The maximum is not proved.
    Unknown {
        /// Why.
        reason: String,
    },
}

impl Display for Certificate {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unique {
                is_only_stationary_point: Some(true),
            } => write!(f, "the only maximum, and the only stationary point"),
            Self::Unique { .. } => write!(f, "the only highest point"),
            Self::Several { maximisers } => write!(
                f,
                "the maximum, attained at one or more of {maximisers} points equally high as far \
                 as enclosed"
            ),
            Self::Unknown { reason } => write!(f, "not proved to be the highest: {reason}"),
        }
    }
}

/// A maximum with the enclosures of its position and value.
#[derive(Debug, Clone, PartialEq)]
pub struct CertifiedMaximum {
    /// An enclosure of the maximiser if it is [`Certificate::Unique`]; of several, of the first of
    /// the points that may be it.
    pub position: Interval,
    /// Contains the maximum.
    pub value: Interval,
    /// The statement proved.
    pub certificate: Certificate,
    /// The number of evaluations of the derivative on an interval.
    pub evaluations: u64,
}

struct Slope<'o, O>(&'o O);

impl<O: Maximand> IntervalFunction for Slope<'_, O> {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        self.0.slope(x)
    }

    fn on_box(&self, domain: &Interval<f64>) -> Option<Dual<Interval<f64>>> {
        self.0.slope_on_box(domain)
    }
}

struct SlopeNear<'o, O>(&'o O, EndPoint);

impl<O: Maximand> IntervalFunction for SlopeNear<'_, O> {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        self.0.slope_near(self.1, x)
    }
}

/// The global maximum of `objective` in the open interval `range`, enclosed to about `bits` bits.
///
/// # Errors
/// [`NumericError::EmptyInterval`]; [`NumericError::NoInteriorMaximum`] if the derivative has no
/// root at which it falls, [`NumericError::NotIsolated`] if none is found and something is
/// undecided.
pub fn certified_maximum(
    objective: &impl Maximand,
    (lower, upper): (f64, f64),
    bits: u32,
) -> Result<CertifiedMaximum, NumericError> {
    if !(lower.is_finite() && upper.is_finite() && lower < upper) {
        return Err(NumericError::EmptyInterval { lower, upper });
    }
    let region = Region::of(objective, lower, upper);
    let found = certified_roots(&Slope(objective), (region.from, region.to), bits);
    let mut best: Option<(Interval, Interval)> = None;
    let mut maximisers = 0;
    let mut without_value = None;
    for root in found.roots.iter().filter(|root| !root.rises) {
        let Some(value) = objective.value(&root.enclosure) else {
            without_value = Some(root.enclosure.to_f64());
            continue;
        };
        let highest = best.as_ref().map(|(_, highest)| highest);
        match highest.map(|highest| value.partial_cmp(highest)) {
            Some(Some(Ordering::Less)) => {}
            Some(None | Some(Ordering::Equal)) => {
                // the larger of the two, wherever it is
                best = best.map(|(position, highest)| (position, highest.larger_of(&value)));
                maximisers += 1;
            }
            None | Some(Some(Ordering::Greater)) => {
                best = Some((root.enclosure.clone(), value));
                maximisers = 1;
            }
        }
    }
    let Some((position, value)) = best else {
        let undecided = found.undecided.first();
        return Err(undecided.map_or(
            NumericError::NoInteriorMaximum { lower, upper },
            |(lower, upper)| NumericError::NotIsolated {
                lower: *lower,
                upper: *upper,
            },
        ));
    };
    let certificate = if let Some((from, to)) = found.undecided.first() {
        let reason = format!("nothing could be decided between {from} and {to}");
        Certificate::Unknown { reason }
    } else if let Some(position) = without_value {
        let reason = format!("the objective has no value at the stationary point {position}");
        Certificate::Unknown { reason }
    } else if region.exclusion == Exclusion::None {
        let reason = "nothing is known next to the ends".to_owned();
        Certificate::Unknown { reason }
    } else if maximisers > 1 {
        Certificate::Several { maximisers }
    } else {
        let by_slope = region.exclusion == Exclusion::BySlope;
        let is_only_stationary_point = by_slope.then_some(found.roots.len() == 1);
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

/// Why no maximum lies outside the region that is searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Exclusion {
    /// The function rises from the lower end up to the region, and falls from there to the upper
    /// end.
    BySlope,
    /// The function's values there are lower than one inside.
    ByBound,
    /// No reason found.
    None,
}

/// The part of the interval in which roots of the derivative are searched.
struct Region {
    from: f64,
    to: f64,
    exclusion: Exclusion,
}

/// Largest and smallest k of the boxes next to an end, 2^−k of the interval.
const END_POWERS: std::ops::RangeInclusive<i32> = 4..=40;
/// Boxes up to this share of the interval are excluded by bounds.
const NARROWEST_BOUNDED: f64 = 1.0 / 512.0;
/// Scanned pieces in which a first maximum is looked for.
const PIECES: u32 = 32;

impl Region {
    fn of(objective: &impl Maximand, lower: f64, upper: f64) -> Self {
        let length = upper - lower;
        let end_box = |end: EndPoint| {
            END_POWERS
                .map(|power| length * 2f64.powi(-power))
                .find(|distance| {
                    let rises = Interval::try_new(0.0, *distance)
                        .and_then(|domain| sign_on(&SlopeNear(objective, end), &domain));
                    rises == Some(end == EndPoint::Lower)
                })
        };
        if let Some((before, after)) = end_box(EndPoint::Lower).zip(end_box(EndPoint::Upper)) {
            // no gap to the end boxes
            return Self {
                from: (lower + before).next_down(),
                to: (upper - after).next_up(),
                exclusion: Exclusion::BySlope,
            };
        }
        Self::bounded(objective, lower, upper).unwrap_or_else(|| {
            let margin = length * 2f64.powi(-*END_POWERS.end());
            Self {
                from: lower + margin,
                to: upper - margin,
                exclusion: Exclusion::None,
            }
        })
    }

    /// The maxima that remain when boxes are dropped whose bound is lower than the value at some
    /// maximum.
    fn bounded(objective: &impl Maximand, lower: f64, upper: f64) -> Option<Self> {
        let slope = |x: f64| objective.slope(&x).unwrap_or(f64::NAN);
        let value = |x: f64| objective.value(&x).unwrap_or(f64::NAN);
        let piece = (upper - lower) / f64::from(PIECES);
        let highest = (1..PIECES)
            .map(|k| lower + piece * f64::from(k))
            .filter(|x| value(*x).is_finite())
            .max_by(|a, b| value(*a).total_cmp(&value(*b)))?;
        let guess = maximum(value, slope, (highest - piece, highest + piece), 2).ok()?;
        let guess = guess.position;
        let level = *objective.value(&Interval::point(guess))?.lower();
        let mut boxes = vec![Interval::try_new(lower, upper)?];
        let mut left: Option<Interval<f64>> = None;
        while let Some(domain) = boxes.pop() {
            if objective.bound_on(&domain)? < level {
                continue;
            }
            match domain.halves() {
                Some(halves) if domain.width() > NARROWEST_BOUNDED * (upper - lower) => {
                    boxes.extend(halves);
                }
                _ => left = Some(left.map_or(domain, |left| left.hull(&domain))),
            }
        }
        let left = left?;
        // an end that is left may have higher values next to it than any stationary point
        let is_inside = *left.lower() > lower && *left.upper() < upper;
        Some(Self {
            from: *left.lower(),
            to: *left.upper(),
            exclusion: if is_inside {
                Exclusion::ByBound
            } else {
                Exclusion::None
            },
        })
    }
}
