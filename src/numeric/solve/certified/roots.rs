//! All roots of a function in an interval, with proof: none is missed, and each is the only one in
//! its enclosure.
//!
//! Boxes that cannot contain a root are discarded by the mean value form; on the others Newton's
//! operator
//!
//! ```text
//!   N(X) = m − f(m)/f′(X)
//! ```
//!
//! decides: `N(X)` inside X means exactly one root, and it lies in `N(X)`; an empty intersection
//! means none. The search runs in `Interval<f64>`, the enclosures found are then tightened by the
//! same operator at the precision asked for.
//!
//! **Not covered**: multiple roots; they stay undecided and are reported as such.
//!
//! Reference: Moore, Kearfott and Cloud, *Introduction to Interval Analysis*, 2009, ch. 8.

use crate::numeric::{Dual, Interval, Scalar};

/// A function of one real variable, written once for every number type.
pub trait IntervalFunction {
    /// The value at `x`, over intervals an enclosure of all values; `None` where there is none.
    fn value<S: Scalar>(&self, x: &S) -> Option<S>;

    /// All values and derivatives on a box, as narrow as can be had quickly.
    fn on_box(&self, domain: &Interval<f64>) -> Option<Dual<Interval<f64>>> {
        self.value(&Dual::variable(*domain))
    }
}

/// A root that is proved to exist and to be the only one in its enclosure.
#[derive(Debug, Clone, PartialEq)]
pub struct CertifiedRoot {
    /// Contains the root.
    pub enclosure: Interval,
    /// Whether the function rises through the root (else it falls).
    pub rises: bool,
}

/// All roots in an interval.
#[derive(Debug, Clone, PartialEq)]
pub struct CertifiedRoots {
    /// The roots, increasing.
    pub roots: Vec<CertifiedRoot>,
    /// Boxes in which nothing could be decided; none, if the roots are all.
    pub undecided: Vec<(f64, f64)>,
    /// The number of evaluations of the function on an interval.
    pub evaluations: u64,
}

/// Boxes narrower than this share of the whole are not divided further.
const NARROWEST: f64 = 1e-9;
/// Evaluations after which the search gives up.
const MOST_EVALUATIONS: u64 = 20_000;
/// Newton steps, each of which about doubles the digits.
const TIGHTENINGS: u32 = 64;

/// All roots of `function` between two numbers, each enclosed to about `bits` bits.
///
/// # Examples
/// ```
/// use infoscene::numeric::{IntervalFunction, Scalar, certified_roots};
/// struct SquareLessTwo;
/// impl IntervalFunction for SquareLessTwo {
///     fn value<S: Scalar>(&self, x: &S) -> Option<S> {
///         Some(x.square() - &x.constant(2.0))
///     }
/// }
/// let found = certified_roots(&SquareLessTwo, (-1.0, 2.0), 128);
/// assert!(found.undecided.is_empty() && found.roots.len() == 1);
/// let bounds = found.roots[0].enclosure.to_decimal(30).unwrap();
/// assert!(bounds.lower.starts_with("1.41421356237309504880168872420"));
/// ```
pub fn certified_roots(
    function: &impl IntervalFunction,
    (lower, upper): (f64, f64),
    bits: u32,
) -> CertifiedRoots {
    let mut search = Search {
        function,
        range: (lower, upper),
        found: Vec::new(),
        undecided: Vec::new(),
        evaluations: 0,
    };
    search.run();
    let mut roots = Vec::new();
    for root in std::mem::take(&mut search.found) {
        let rises = root.slope > root.slope.zero();
        match search.tightened(&root.enclosure, bits) {
            Some(enclosure) => roots.push(CertifiedRoot { enclosure, rises }),
            None => search.undecided.push(root.enclosure.to_doubles()),
        }
    }
    roots.sort_by(|a, b| a.enclosure.to_f64().total_cmp(&b.enclosure.to_f64()));
    // enclosures that touch might hold the same root twice
    for pair in roots.windows(2) {
        if let Some(shared) = pair[0].enclosure.intersection(&pair[1].enclosure) {
            search.undecided.push(shared.to_doubles());
        }
    }
    CertifiedRoots {
        roots,
        undecided: search.undecided,
        evaluations: search.evaluations,
    }
}

/// A box in which a root was found.
struct Found {
    /// The root is the only one here.
    domain: Interval<f64>,
    enclosure: Interval<f64>,
    slope: Interval<f64>,
}

struct Search<'f, F> {
    function: &'f F,
    range: (f64, f64),
    found: Vec<Found>,
    undecided: Vec<(f64, f64)>,
    evaluations: u64,
}

/// The outcome of the test of a box.
enum Outcome {
    /// No root in it.
    Nothing,
    /// One root in it, in this enclosure; the slope does not vanish.
    Unique(Interval<f64>, Interval<f64>),
    /// The box has at most one root, in this part of it, perhaps on its border.
    AtMostOne(Interval<f64>),
    /// Nothing known.
    Open,
}

impl<F: IntervalFunction> Search<'_, F> {
    fn run(&mut self) {
        let (lower, upper) = self.range;
        let Some(whole) = Interval::try_new(lower, upper) else {
            return;
        };
        let narrowest = NARROWEST * whole.width();
        let mut boxes = vec![whole];
        while let Some(domain) = boxes.pop() {
            let rest = match self.outcome(&domain) {
                Outcome::Nothing => continue,
                Outcome::Unique(enclosure, slope) => {
                    self.record(domain, enclosure, slope);
                    continue;
                }
                Outcome::AtMostOne(rest) => {
                    // a root on the border is seen from a box with room on either side
                    if let Some(wider) = self.widened(&domain, narrowest)
                        && let Outcome::Unique(enclosure, slope) = self.outcome(&wider)
                    {
                        self.record(wider, enclosure, slope);
                        continue;
                    }
                    if rest.width() < 0.5 * domain.width() && self.evaluations < MOST_EVALUATIONS {
                        boxes.push(rest);
                        continue;
                    }
                    rest
                }
                Outcome::Open => domain,
            };
            match rest.halves() {
                Some(halves) if rest.width() > narrowest && self.evaluations < MOST_EVALUATIONS => {
                    boxes.extend(halves);
                }
                _ => self.undecided.push(rest.to_doubles()),
            }
        }
    }

    /// The interval with room of half its width on either side; of `least` about a box that is
    /// hardly more than a point.
    fn widened(&self, domain: &Interval<f64>, least: f64) -> Option<Interval<f64>> {
        let room = least.max(0.5 * domain.width());
        let lower = (domain.lower() - room).max(self.range.0);
        let upper = (domain.upper() + room).min(self.range.1);
        Interval::try_new(lower, upper)
    }

    fn record(&mut self, domain: Interval<f64>, enclosure: Interval<f64>, slope: Interval<f64>) {
        // two boxes with one root each have the same one if either contains the other's
        let is_known =
            |other: &Found| other.domain.contains(&enclosure) || domain.contains(&other.enclosure);
        if !self.found.iter().any(is_known) {
            self.found.push(Found {
                domain,
                enclosure,
                slope,
            });
        }
    }

    fn outcome(&mut self, domain: &Interval<f64>) -> Outcome {
        self.evaluations += 1;
        let Some(Dual { value, slope }) = self.function.on_box(domain) else {
            return Outcome::Open;
        };
        if !value.contains_zero() {
            return Outcome::Nothing;
        }
        let middle = Interval::point(domain.midpoint());
        self.evaluations += 1;
        let Some(at_middle) = self.function.value(&middle) else {
            return Outcome::Open;
        };
        if !slope.is_bounded() {
            return Outcome::Open;
        }
        if !(at_middle + slope * (*domain - middle)).contains_zero() {
            return Outcome::Nothing;
        }
        if slope.contains_zero() {
            return Outcome::Open;
        }
        let newton = middle - at_middle / slope;
        match newton.intersection(domain) {
            None => Outcome::Nothing,
            Some(rest) if domain.contains_inside(&newton) => Outcome::Unique(rest, slope),
            Some(rest) => Outcome::AtMostOne(rest),
        }
    }

    /// The enclosure in doubles: on a wide box [`IntervalFunction::on_box`] may know the slope
    /// where plain evaluation does not.
    fn tightened_on_boxes(&mut self, enclosure: Interval<f64>) -> Interval<f64> {
        let mut domain = enclosure;
        for _ in 0..TIGHTENINGS {
            let (Outcome::Unique(rest, _) | Outcome::AtMostOne(rest)) = self.outcome(&domain)
            else {
                break;
            };
            let shrinks = rest.width() < 0.5 * domain.width();
            domain = rest;
            if !shrinks {
                break;
            }
        }
        domain
    }

    /// The enclosure at more bits, as narrow as the function's own rounding lets it become.
    fn tightened(&mut self, enclosure: &Interval<f64>, bits: u32) -> Option<Interval> {
        let mut domain = Interval::from_doubles(&self.tightened_on_boxes(*enclosure), bits);
        for _ in 0..TIGHTENINGS {
            let slope = self.function.value(&Dual::variable(domain.clone()))?.slope;
            if !slope.is_bounded() || slope.contains_zero() {
                return None;
            }
            let middle = Interval::point(domain.midpoint());
            self.evaluations += 2;
            let at_middle = self.function.value(&middle)?;
            // the root lies in both; an empty intersection would contradict its existence
            let newton = (middle - &(at_middle / &slope)).intersection(&domain)?;
            let shrinks = newton.width() < 0.5 * domain.width();
            domain = newton;
            if !shrinks || domain.is_point() {
                break;
            }
        }
        Some(domain)
    }
}

/// Tells whether the function keeps one sign on the whole interval: `Some(true)` if it is positive.
pub(crate) fn sign_on(function: &impl IntervalFunction, domain: &Interval<f64>) -> Option<bool> {
    let value = function.value(domain)?;
    let zero = value.zero();
    if value > zero {
        Some(true)
    } else if value < zero {
        Some(false)
    } else {
        None
    }
}
