//! The slow reference: exchange areas of any two planar polygons to 20 digits and more.
//!
//! ```text
//!   A F = 1/π ∫∫ du dv h(v) k(u) Σ ± G(s_i(u) − t_j(v); c(u, v)),   G(z; c) = z·atan(z/c)/(2c³)
//! ```
//!
//! Both polygons are cut into strips along the line where their planes meet (`section`); two strips
//! exchange a closed form, and there remains a twofold integral over v and u (`strips`, `strip`), by
//! Gauss rules on parts that shrink towards the singular points (`panels`). No contour, no logarithm
//! and no solid angle occurs: nothing is shared with the fast routes. Every pass is repeated finer
//! and with the two polygons' parts exchanged; the difference is the error *estimate*, which is no
//! bound.
//!
//! **Not covered**: occlusion; corners are taken exactly as given, and off-plane corners by their
//! projection.

pub(crate) mod panels;
pub(crate) mod section;
pub(crate) mod singularities;
pub(crate) mod strip;
pub(crate) mod strips;

use super::fixed_float::FixedFloat;
use crate::form_factor::FormFactorError;
use crate::geometry::Patch;
use crate::numeric::power_of_two_near;
use glam::DVec3;
use panels::Fineness;
use section::Section;
use strip::Pass;

/// Words of the significand: 256 bits, of which a far pair of slivers leaves half.
const WORDS: usize = 4;
type Number = FixedFloat<WORDS>;

/// An exchange area with many digits.
#[derive(Debug, Clone, Copy)]
pub struct Reference {
    value: Number,
    estimate: f64,
}

impl Reference {
    /// The exchange area, to the nearest double or the next.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.value.to_f64()
    }

    /// Estimate of the relative error: how much the last two passes differ. No bound.
    #[must_use]
    pub const fn estimate(&self) -> f64 {
        self.estimate
    }

    /// `value − exchange area`, with the digits of the reference.
    #[must_use]
    pub fn error_of(&self, value: f64) -> f64 {
        (Number::new(value) - self.value).to_f64()
    }

    /// The value as a sum of doubles, largest first, exact to 1e-60.
    #[must_use]
    pub fn doubles(&self) -> [f64; 4] {
        let mut rest = self.value;
        std::array::from_fn(|_| {
            let part = rest.to_f64();
            rest = rest - Number::new(part);
            part
        })
    }

    /// `digits` significant decimal digits, rounded.
    #[must_use]
    pub fn decimal(&self, digits: usize) -> String {
        decimal(self.value, digits)
    }
}

/// The scientific notation of a number ≥ 0.
fn decimal(value: Number, digits: usize) -> String {
    if value.is_zero() {
        return "0".into();
    }
    let ten = Number::new(10.0);
    let mut exponent = 0;
    let mut rest = value;
    while rest >= ten {
        rest = rest / ten;
        exponent += 1;
    }
    while rest < Number::new(1.0) {
        rest = rest * ten;
        exponent -= 1;
    }
    let mut half = Number::new(5.0);
    for _ in 0..digits {
        half = half / ten;
    }
    rest = rest + half;
    if rest >= ten {
        rest = rest / ten;
        exponent += 1;
    }
    let mut text = String::new();
    for k in 0..digits {
        let digit = rest.to_f64().floor();
        let digit = if Number::new(digit) > rest {
            digit - 1.0
        } else {
            digit
        };
        text.push_str(&format!("{digit:.0}"));
        if k == 0 && digits > 1 {
            text.push('.');
        }
        rest = (rest - Number::new(digit)) * ten;
    }
    format!("{text}e{exponent}")
}

/// Passes before giving up.
const MOST_PASSES: usize = 6;

/// The exchange area of two patches, corners exact, to about `relative` of itself; 0 if one is
/// behind the plane of the other or in it.
///
/// **Arguments** `relative`: wanted relative error, 1e-30 … 1e-3.
/// **Accuracy**: the estimate returned is usually far above the error; it may exceed `relative` if
/// six passes do not reach that.
///
/// # Errors
/// [`FormFactorError::OutOfRange`] if the value leaves the range of `f64`.
pub fn exchange_area(
    first: &Patch,
    second: &Patch,
    relative: f64,
) -> Result<Reference, FormFactorError> {
    let corners = [first.corners(), second.corners()];
    let power = scale(corners.concat());
    let [p, q] = corners
        .map(|corners| -> Vec<DVec3> { corners.iter().map(|c| *c * power.recip()).collect() });
    let nothing = Reference {
        value: Number::ZERO,
        estimate: 0.0,
    };
    let (Some(direct), Some(swapped)) = (Section::<WORDS>::new(&p, &q), Section::new(&q, &p))
    else {
        return Ok(nothing);
    };
    let sections = [direct, swapped];
    let rough = rough_value(&sections[0]);
    let mut last = Number::ZERO;
    let mut estimate = f64::INFINITY;
    for k in 0..MOST_PASSES {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_possible_wrap,
            reason = "below 6"
        )]
        let finer = 10f64.powi(-(k as i32) - 1);
        let pass = Pass {
            allowed: rough * relative * finer,
            fineness: Fineness {
                longest: 20 + 2 * k,
                spare: 1 + k,
            },
        };
        let value = sections[k % 2].integral(&pass);
        estimate = ((value - last).abs() / value.abs()).to_f64();
        last = value;
        if k > 0 && estimate <= relative {
            break;
        }
    }
    let unit = Number::new(power);
    let value = last * unit.square();
    let double = value.to_f64();
    if double.is_finite() && double > 0.0 {
        Ok(Reference { value, estimate })
    } else {
        Err(FormFactorError::OutOfRange { value: double })
    }
}

/// A power of two near the size of the pair.
fn scale(corners: Vec<DVec3>) -> f64 {
    let origin = corners[0];
    let size = corners
        .iter()
        .map(|c| (*c - origin).abs().max_element())
        .fold(0.0, f64::max);
    power_of_two_near(size)
}

/// The value to a factor of three or so, from above.
fn rough_value(section: &Section<WORDS>) -> f64 {
    // F ≤ 1 both ways
    let areas = [&section.inner, &section.outer].map(|slabs| {
        let areas = slabs.iter().map(|slab| slab.area().to_f64());
        areas.sum::<f64>()
    });
    let mut rough = areas[0].min(areas[1]);
    loop {
        let pass = Pass {
            allowed: 1e-3 * rough,
            fineness: Fineness {
                longest: 12,
                spare: 0,
            },
        };
        let value = section.integral(&pass).to_f64();
        if value > 0.3 * rough || rough < f64::MIN_POSITIVE {
            return rough;
        }
        rough = value.max(1e-2 * rough);
    }
}
