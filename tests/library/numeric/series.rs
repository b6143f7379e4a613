//! Power series of intervals, of which few terms show the enclosure of the tail.

use infoscene::numeric::Scalar;
use infoscene::numeric::interval::{Direction, Endpoint, Interval};

/// A double that asks for so many bits: series of such ends stop early, and their tails, which all
/// the terms of a double hide below the last bit, stand out.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
struct Coarse<const BITS: u32>(f64);

impl<const BITS: u32> Endpoint for Coarse<BITS> {
    fn constant(&self, value: f64) -> Self {
        Self(value)
    }
    fn with_precision(&self, _bits: u32, _direction: Direction) -> Self {
        *self
    }
    fn bits(&self) -> u32 {
        BITS
    }
    fn negated(&self) -> Self {
        Self(-self.0)
    }
    fn plus(&self, other: &Self, direction: Direction) -> Self {
        Self(self.0.plus(&other.0, direction))
    }
    fn times(&self, other: &Self, direction: Direction) -> Self {
        Self(self.0.times(&other.0, direction))
    }
    fn over(&self, other: &Self, direction: Direction) -> Self {
        Self(self.0.over(&other.0, direction))
    }
    fn root(&self, direction: Direction) -> Self {
        Self(self.0.root(direction))
    }
    fn scaled(&self, power: i32, direction: Direction) -> Self {
        Self(self.0.scaled(power, direction))
    }
    fn exponent(&self) -> i32 {
        self.0.exponent()
    }
    fn to_double(&self, _direction: Direction) -> f64 {
        self.0
    }
    fn is_finite(&self) -> bool {
        self.0.is_finite()
    }
}

/// Compares the functions at a point with those of all terms: they enclose them, are no wider than
/// so many bits allow, and are wider than rounding alone where bits are few.
fn few_terms_enclose_all<const BITS: u32>(x: f64) -> [bool; 4] {
    let few = Interval::point(Coarse::<BITS>(x));
    let all = Interval::point(x);
    let one = (few.constant(1.0), all.constant(1.0));
    let functions = [
        ("ln", few.ln(), all.ln()),
        ("exp", few.exp(), all.exp()),
        ("exp_m1", few.exp_m1(), all.exp_m1()),
        ("atan", few.atan2(&one.0), all.atan2(&one.1)),
    ];
    functions.map(|(name, few, all)| {
        let (lower, upper) = (few.lower().0, few.upper().0);
        let (least, most) = (*all.lower(), *all.upper());
        // the exact value lies in both
        assert!(lower <= most && least <= upper, "{name} {x} {BITS}");
        let contains = lower <= least && most <= upper;
        let width = upper - lower;
        let size = most.abs().max(1.0);
        let allowed = size * (0.5f64.powi(i32::try_from(BITS).unwrap()) + 32.0 * f64::EPSILON);
        assert!(width <= allowed, "{name} {x} {BITS}: {width:e}");
        let is_seen = width > 64.0 * f64::EPSILON * size;
        // where the tail is seen it is far wider than the roundings of all terms
        assert!(contains || !is_seen, "{name} {x} {BITS}");
        is_seen
    })
}

#[test]
fn few_terms_of_a_series_enclose_all() {
    let mut seen = [0; 4];
    for x in [1.003, 1.1, 1.27, 1.9, 0.3, 0.77, 2.0 / 3.0, 5.3, 0.01] {
        for tails in [
            few_terms_enclose_all::<4>(x),
            few_terms_enclose_all::<9>(x),
            few_terms_enclose_all::<17>(x),
            few_terms_enclose_all::<30>(x),
        ] {
            for (seen, is_seen) in seen.iter_mut().zip(tails) {
                *seen += u32::from(is_seen);
            }
        }
    }
    // of 36 each, some are seen; without a tail none would be
    assert!(seen.iter().all(|seen| *seen >= 4), "{seen:?}");
}
