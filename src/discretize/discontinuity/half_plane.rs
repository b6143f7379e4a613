//! A penumbra in closed form: parallel unit squares, and a half-plane between them.
//!
//! Floor `z = 0` and ceiling `z = 1` over the unit square, facing each other; the half-plane
//! `x > c` at height h hides the rest. A point x of the floor sees the ceiling up to
//! `u*(x) = (c − (1 − h) x)/h`, cut off at 0 and 1: all of it before the lit line, nothing beyond
//! the umbra line,
//!
//! ```text
//!   lit line  (c − h)/(1 − h)        umbra line  c/(1 − h)
//! ```
//!
//! and part of it in the penumbra between them. Two strips exchange `H″(x − u)/π dx du`, with
//!
//! ```text
//!   H(w) = p atan(1/p) + √2 w atan(w/√2) − w atan w + ½ ln((1 + w²)/(2 + w²)),   p² = 1 + w²
//!   H′(w) = (w/p) atan(1/p) + √2 atan(w/√2) − atan w
//! ```
//!
//! the corner function of [`parallel`](crate::form_factor::rectangles::parallel) for sides from 0
//! to 1 along y. What the floor before t and the ceiling exchange is then, with l the lit line,
//!
//! ```text
//!   πG(t) = H(1) − H(0) + H(t) − H(1 − t)                             up to the lit line
//!   πG(t) = H(1) − H(0) + H(t) − (1 − h) H(1 − l) − h H((t − c)/h)    in the penumbra
//!   πG′(t) = H′(t) + H′(1 − t),    H′(t) − H′((t − c)/h)
//! ```
//!
//! and constant beyond the umbra line.
//!
//! **Not covered**: half-planes whose lines leave the floor, `h ≥ c` or `h ≥ 1 − c`.

use crate::discretize::error::DiscretizeError;
use crate::discretize::measure::CutMeasure;
use crate::numeric::{
    CertifiedMaximum, Dual, EndPoint, Interval, Maximand, Scalar, certified_maximum, maximum,
};

/// Two parallel unit squares at distance 1 with a half-plane between them, whose penumbra lies on
/// the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfPlaneShadow {
    edge: f64,
    height: f64,
}

/// The parts of the floor, by what they see of the ceiling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Zone {
    Lit,
    Penumbra,
    Umbra,
}

/// The share of the penumbra that is left out beside its lines where cuts are enclosed.
const MARGIN: f64 = 1.0 / 64.0;

impl HalfPlaneShadow {
    /// The squares with the half-plane `x > edge` at a height between them.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless `0 < height < min(edge, 1 − edge)`.
    ///
    /// # Examples
    /// ```
    /// use infoscene::discretize::{CutMeasure, HalfPlaneShadow};
    /// let shadow = HalfPlaneShadow::try_new(0.5, 0.2)?;
    /// assert!((shadow.umbra_line(&1.0) - 0.625).abs() < 1e-15);
    /// // an independent program printed 0.568324: on neither line
    /// let best = shadow.best_cut(CutMeasure::Information)?;
    /// assert!((best - 0.568_324).abs() < 0.5e-6);
    /// # Ok::<(), infoscene::discretize::DiscretizeError>(())
    /// ```
    pub fn try_new(edge: f64, height: f64) -> Result<Self, DiscretizeError> {
        if height > 0.0 && height < edge && height < 1.0 - edge {
            return Ok(Self { edge, height });
        }
        let condition = "above 0 and below the distance of the edge from both ends of the floor";
        Err(DiscretizeError::out_of_range(
            "the height of the half-plane",
            height,
            condition,
        ))
    }

    /// The position up to which all of the ceiling is seen.
    ///
    /// **Arguments** `like`: a number of the type and precision wanted.
    #[must_use]
    pub fn lit_line<S: Scalar>(&self, like: &S) -> S {
        (self.lifted_edge(like) - &self.lifted_height(like)) / &self.rest(like)
    }

    /// The position from which on nothing of the ceiling is seen.
    ///
    /// **Arguments** `like`: a number of the type and precision wanted.
    #[must_use]
    pub fn umbra_line<S: Scalar>(&self, like: &S) -> S {
        self.lifted_edge(like) / &self.rest(like)
    }

    /// The exchange area of the floor and the ceiling.
    ///
    /// **Arguments** `like`: a number of the type and precision wanted.
    #[must_use]
    pub fn exchange_area<S: Scalar>(&self, like: &S) -> S {
        self.flux(Zone::Penumbra, &self.umbra_line(like))
    }

    /// The gain of a cut at `position`: over intervals an enclosure, edge and height counting as
    /// exact.
    ///
    /// **Returns** for [`CutMeasure::Information`] bits, with A_T = 2.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless `0 < position < 1`, and, over intervals, wholly on
    /// one side of either line.
    pub fn gain<S: Scalar>(&self, measure: CutMeasure, position: &S) -> Result<S, DiscretizeError> {
        let zone = self.zone(position)?;
        Ok(self.gain_in(zone, measure, position))
    }

    /// The gains of the cuts along the lit and the umbra line.
    ///
    /// **Arguments** `like`: a number of the type and precision wanted; over intervals enclosures.
    #[must_use]
    pub fn gains_on_lines<S: Scalar>(&self, measure: CutMeasure, like: &S) -> [S; 2] {
        // the forms of both zones agree there
        let lines = [self.lit_line(like), self.umbra_line(like)];
        lines.map(|line| self.gain_in(Zone::Penumbra, measure, &line))
    }

    /// The best cut of all, by the root of the derivative.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if no interior maximum is found.
    pub fn best_cut(&self, measure: CutMeasure) -> Result<f64, DiscretizeError> {
        let zone = |t: f64| self.zone(&t).unwrap_or(Zone::Umbra);
        let gain = |t: f64| self.gain_in(zone(t), measure, &t);
        let slope = |t: f64| self.slope_in(zone(t), measure, &t);
        Ok(maximum(gain, slope, (0.0, 1.0), 64)?.position)
    }

    /// The best cut through the penumbra, farther from both lines than a 64th of its width,
    /// enclosed to about `bits` bits, with what is proved about it. Next to the umbra line, where a
    /// part is nearly dark, the derivative is not enclosed.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if the gain has no maximum there, or it cannot be isolated.
    pub fn certified_cut(
        &self,
        measure: CutMeasure,
        bits: u32,
    ) -> Result<CertifiedMaximum, DiscretizeError> {
        let shadow = *self;
        let [lit, umbra] = [self.lit_line(&1.0), self.umbra_line(&1.0)];
        let margin = MARGIN * (umbra - lit);
        let (from, to) = (lit + margin, umbra - margin);
        let ends = [from, to];
        let cut = PenumbraCut {
            shadow,
            measure,
            ends,
        };
        Ok(certified_maximum(&cut, (from, to), bits)?)
    }

    fn zone<S: Scalar>(&self, position: &S) -> Result<Zone, DiscretizeError> {
        let refused = |condition| {
            let value = position.to_f64();
            DiscretizeError::out_of_range("the cut", value, condition)
        };
        if !(*position > position.zero() && *position < position.constant(1.0)) {
            return Err(refused("inside (0, 1)"));
        }
        let [lit, umbra] = [self.lit_line(position), self.umbra_line(position)];
        if *position < lit {
            Ok(Zone::Lit)
        } else if *position >= umbra {
            Ok(Zone::Umbra)
        } else if *position >= lit && *position < umbra {
            Ok(Zone::Penumbra)
        } else {
            Err(refused("wholly on one side of each line"))
        }
    }

    /// The flux before a position, by the form of a zone.
    fn flux<S: Scalar>(&self, zone: Zone, position: &S) -> S {
        let one = position.constant(1.0);
        let ends = potential(&one) - &potential(&one.zero());
        let own = match zone {
            Zone::Lit => potential(position) - &potential(&(one - position)),
            Zone::Penumbra => {
                let height = self.lifted_height(position);
                let beyond = one - &self.lit_line(position);
                potential(position)
                    - &(self.rest(position) * &potential(&beyond))
                    - &(height * &potential(&self.across(position)))
            }
            Zone::Umbra => return self.exchange_area(position),
        };
        (ends + &own) / &position.pi()
    }

    /// The derivative of the flux, by the form of a zone.
    fn flux_rate<S: Scalar>(&self, zone: Zone, position: &S) -> S {
        let rate = match zone {
            Zone::Lit => slope(position) + &slope(&(position.constant(1.0) - position)),
            Zone::Penumbra => slope(position) - &slope(&self.across(position)),
            Zone::Umbra => return position.zero(),
        };
        rate / &position.pi()
    }

    fn gain_in<S: Scalar>(&self, zone: Zone, measure: CutMeasure, position: &S) -> S {
        let whole = self.exchange_area(position);
        let before = self.flux(zone, position);
        let after = whole.clone() - &before;
        let parts = [
            [before, position.clone()],
            [after, position.constant(1.0) - position],
        ];
        measure.gain(&whole, &parts)
    }

    fn slope_in<S: Scalar>(&self, zone: Zone, measure: CutMeasure, position: &S) -> S {
        let one = position.constant(1.0);
        let flux = self.flux(zone, position);
        let after = (self.exchange_area(position) - &flux) / &(one.clone() - position);
        let rate = self.flux_rate(zone, position);
        measure.slope(&rate, &one, &(flux / position), &after)
    }

    /// `(t − c)/h`.
    fn across<S: Scalar>(&self, position: &S) -> S {
        (position.clone() - &self.lifted_edge(position)) / &self.lifted_height(position)
    }

    fn lifted_edge<S: Scalar>(&self, like: &S) -> S {
        like.constant(self.edge)
    }

    fn lifted_height<S: Scalar>(&self, like: &S) -> S {
        like.constant(self.height)
    }

    /// `1 − h`.
    fn rest<S: Scalar>(&self, like: &S) -> S {
        like.constant(1.0) - &self.lifted_height(like)
    }
}

/// `H(w)`, even in w.
fn potential<S: Scalar>(w: &S) -> S {
    let (one, two) = (w.constant(1.0), w.constant(2.0));
    let (square, root) = (w.square(), two.sqrt());
    let p = (square.clone() + &one).sqrt();
    let logarithm = ((square.clone() + &one) / &(square + &two)).ln();
    p.clone() * &one.atan2(&p) + &(root.clone() * w * &w.atan2(&root)) - &(w.atan2(&one) * w)
        + &(logarithm / &two)
}

/// `H′(w)`, odd in w.
fn slope<S: Scalar>(w: &S) -> S {
    let one = w.constant(1.0);
    let (p, root) = ((w.square() + &one).sqrt(), w.constant(2.0).sqrt());
    w.clone() / &p * &one.atan2(&p) + &(root.clone() * &w.atan2(&root)) - &w.atan2(&one)
}

/// The gain of a cut through the penumbra, by its form, which is analytic beyond the lines, too.
struct PenumbraCut {
    shadow: HalfPlaneShadow,
    measure: CutMeasure,
    ends: [f64; 2],
}

impl Maximand for PenumbraCut {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        Some(self.shadow.gain_in(Zone::Penumbra, self.measure, x))
    }

    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        Some(self.shadow.slope_in(Zone::Penumbra, self.measure, x))
    }

    fn slope_near<S: Scalar>(&self, end: EndPoint, distance: &S) -> Option<S> {
        let [from, to] = self.ends.map(|end| distance.constant(end));
        let at = match end {
            EndPoint::Lower => from + distance,
            EndPoint::Upper => to - distance,
        };
        self.slope(&at)
    }

    /// Encloses the slope on a box X with middle m by
    ///
    /// ```text
    ///   G′(X) ⊂ G′(m) + G″(X) (X − m),    G(X) ⊂ G(m) + G′(X) (X − m)
    /// ```
    ///
    /// which next to the umbra line, where little is left of the flux, is narrower than forms of X.
    fn slope_on_box(&self, domain: &Interval<f64>) -> Option<Dual<Interval<f64>>> {
        let (shadow, zone) = (self.shadow, Zone::Penumbra);
        let middle = Interval::point(domain.midpoint());
        let aside = *domain - middle;
        let wide = shadow.flux_rate(zone, &Dual::variable(*domain));
        let value = shadow.flux_rate(zone, &middle) + wide.slope * aside;
        let rate = Dual {
            value,
            slope: wide.slope,
        };
        let one = Interval::point(1.0);
        let moved = value * aside;
        let at_middle = shadow.flux(zone, &middle);
        let part = |value, slope| Dual { value, slope };
        let whole = shadow.exchange_area(&middle);
        let before = part(at_middle + moved, value) / part(*domain, one);
        let after = part(whole - at_middle - moved, -value) / part(one - *domain, -one);
        let area_rate = Dual::constant_like(&one);
        Some(self.measure.slope(&rate, &area_rate, &before, &after))
    }
}
