//! Reciprocal, square root and arc tangent.
//!
//! ```text
//!   1/x:   y ← y + y (1 − x y)            from a double, the digits double with each step
//!   1/√x:  y ← y + y (1 − x y²)/2
//!   atan(y/x) = atan c + atan r,  c = i/512,  r = (y − c x)/(x + c y),  |r| ≤ 2⁻¹⁰
//!   atan r = r − r³/3 + r⁵/5 − …
//! ```

use super::{FixedFloat, WORD, minus_with_borrow, product};
use std::any::Any;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// Entries of the table of arc tangents per unit.
const STEPS: u32 = 512;

/// Tables that depend on the precision only.
struct Tables<const N: usize> {
    /// Values of atan(i/512) for i up to 512.
    atan: Vec<FixedFloat<N>>,
    /// 1/3, 1/5, … as fixed point fractions.
    series: Vec<[u64; N]>,
}

thread_local! {
    static TABLES: RefCell<HashMap<usize, Rc<dyn Any>>> = RefCell::default();
}

/// Returns the value of `make` for N words, made once per thread and kept in `cache`.
pub(crate) fn kept<T: 'static>(
    cache: &'static std::thread::LocalKey<RefCell<HashMap<usize, Rc<dyn Any>>>>,
    key: usize,
    make: impl FnOnce() -> T,
) -> Rc<T> {
    let found = cache.with_borrow(|cache| cache.get(&key).cloned());
    if let Some(found) = found.and_then(|any| any.downcast::<T>().ok()) {
        return found;
    }
    let made = Rc::new(make());
    cache.with_borrow_mut(|cache| cache.insert(key, made.clone()));
    made
}

impl<const N: usize> Tables<N> {
    fn kept() -> Rc<Self> {
        kept(&TABLES, N, Self::new)
    }

    fn new() -> Self {
        let one = FixedFloat::<N>::new(1.0);
        // 20 bits with each term
        let bits = u32::try_from(N).unwrap_or(0) * WORD;
        let series: Vec<_> = (1..bits / 20 + 3)
            .map(|k| (one / FixedFloat::new(f64::from(2 * k + 1))).fraction())
            .collect();
        // atan((i+1)/K) − atan(i/K) = atan((1/K)/(1 + i(i+1)/K²)) = atan(K/(K² + i(i+1)))
        let whole = |value: u32| FixedFloat::new(f64::from(value));
        let mut atan = vec![FixedFloat::ZERO];
        for i in 0..STEPS {
            let step = whole(STEPS) / whole(STEPS * STEPS + i * (i + 1));
            let angle = atan[i as usize] + by_series(step, &series);
            atan.push(angle);
        }
        Self { atan, series }
    }
}

/// The arc tangent of r for |r| ≤ 2⁻⁹ (the table's first steps lose a bit per term, which the two
/// spare terms make up for).
///
/// With q = r² as a fixed point fraction it is `r − r q (1/3 − q (1/5 − …))`, every bracket in (0,
/// 1): no number needs its exponent moved.
fn by_series<const N: usize>(r: FixedFloat<N>, series: &[[u64; N]]) -> FixedFloat<N> {
    let square = r.square().fraction();
    let bracket = series.iter().rev().copied();
    let bracket = bracket.reduce(|bracket, term| fixed_minus(term, fixed_times(square, bracket)));
    let bracket = bracket.unwrap_or([0; N]);
    r - r * FixedFloat::of_fraction(fixed_times(square, bracket))
}

/// The upper half of the product: of fractions in [0, 1) again the product.
fn fixed_times<const N: usize>(a: [u64; N], b: [u64; N]) -> [u64; N] {
    product(&a, &b).1
}

/// The difference of fractions, a ≥ b.
fn fixed_minus<const N: usize>(mut a: [u64; N], b: [u64; N]) -> [u64; N] {
    let mut borrow = false;
    for k in 0..N {
        (a[k], borrow) = minus_with_borrow(a[k], b[k], borrow);
    }
    a
}

impl<const N: usize> FixedFloat<N> {
    /// π.
    #[must_use]
    pub fn pi() -> Self {
        Tables::kept().atan[STEPS as usize].scaled(2)
    }

    /// The significand as a double in [1/2, 1), and how often the bits of a double must be doubled.
    fn seed(&self) -> (f64, u32) {
        let magnitude = self.abs().scaled(-self.exponent).to_f64();
        let bits = u32::try_from(N).unwrap_or(0) * WORD;
        (magnitude, (bits.div_ceil(50)).ilog2() + 1)
    }

    /// `1/x`, x ≠ 0.
    #[must_use]
    pub fn reciprocal(self) -> Self {
        self.reciprocal_by_steps(self.seed().1)
    }

    /// `1/x` to half the digits at least.
    pub(crate) fn half_reciprocal(self) -> Self {
        self.reciprocal_by_steps(self.seed().1 - 1)
    }

    fn reciprocal_by_steps(self, steps: u32) -> Self {
        if self.is_zero() {
            return Self::ZERO;
        }
        let (magnitude, _) = self.seed();
        let x = self.abs().scaled(-self.exponent);
        let one = Self::new(1.0);
        let mut y = Self::new(1.0 / magnitude);
        for _ in 0..steps {
            y = y + y * (one - x * y);
        }
        let y = y.scaled(-self.exponent);
        if self.is_negative { -y } else { y }
    }

    /// `√x`, x ≥ 0; zero of a negative number.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if !self.is_positive() {
            return Self::ZERO;
        }
        let (magnitude, steps) = self.seed();
        // an even power of two is taken out
        let odd = self.exponent.rem_euclid(2);
        let power = self.exponent - odd;
        let x = self.scaled(-power);
        let seed = if odd == 1 { 2.0 * magnitude } else { magnitude };
        let one = Self::new(1.0);
        let mut y = Self::new(1.0 / seed.sqrt());
        // the last step is the correction of the root
        for _ in 1..steps {
            y = y + (y * (one - x * y.square())).scaled(-1);
        }
        let root = x * y;
        let root = root + (y * (x - root.square())).scaled(-1);
        root.scaled(power / 2)
    }

    /// `atan(y/x)` for x > 0.
    #[must_use]
    pub fn atan_of_ratio(y: Self, x: Self) -> Self {
        if y.is_negative() {
            return -Self::atan_of_ratio(-y, x);
        }
        let tables = Tables::kept();
        let at = |y: Self, x: Self| {
            let ratio = y.scaled(-x.exponent).to_f64() / x.scaled(-x.exponent).to_f64();
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "from 0 to 512"
            )]
            let i = (ratio * f64::from(STEPS)).round() as usize;
            #[allow(clippy::cast_precision_loss, reason = "from 0 to 512")]
            let c = Self::new(i as f64 / f64::from(STEPS));
            let r = if i == 0 {
                y / x
            } else {
                (y - c * x) / (x + c * y)
            };
            tables.atan[i] + by_series(r, &tables.series)
        };
        if y > x {
            tables.atan[STEPS as usize].scaled(1) - at(x, y)
        } else {
            at(y, x)
        }
    }
}
