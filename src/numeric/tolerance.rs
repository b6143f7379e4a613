//! The one table of tolerances, with a line of reason each.
//!
//! A number is here because (a) a bound was derived, (b) a named test measures it, or
//! (c) the paper prints that many digits (those come with the claims, as data).

/// Relative error of [`divergence_kernel`](super::divergence_kernel): (a) at |x| = 1/4 the plain
/// form cancels (1+x)·ln(1+x) against x, a factor 9 on 2 ε; the series form stays below. Measured by
/// `divergence_kernel_keeps_its_digits`.
pub const DIVERGENCE_KERNEL: f64 = 24.0 * f64::EPSILON;

/// Two maxima nearer than this in relative height count as one: (a) gains carry relative errors
/// of some hundred ε when the parts' form factors differ in the third digit.
pub const EQUAL_MAXIMA: f64 = 1e-12;

/// Sweeps of the coordinate maximisation: (b) 16 parts of two unit squares take 400, measured by
/// `sixteen_parts_come_to_rest`; more means that the function has a ridge.
pub const COORDINATE_SWEEPS: u32 = 4000;

/// Movement below which a sweep counts as at rest: (a) two units in the last place of 1.
pub const COORDINATE_AT_REST: f64 = 2.0 * f64::EPSILON;

/// Deviation from a plane, relative to a patch's diameter, up to which it counts as planar: the
/// input's own rounding is 1e-16 of its coordinates, a file of twelve decimals gives 1e-12.
pub const PLANARITY: f64 = 1e-12;

/// Deviation from a common axis or plane, relative to the largest coordinate, up to which two
/// rectangles count as aligned: (a) a rotated corner carries three roundings of ε each, twice
/// over for a difference, and the frame another two.
pub const ALIGNMENT: f64 = 16.0 * f64::EPSILON;

/// The factor of ε in the running bound of the rectangle closed forms: (a) each term takes at most
/// eight roundings of ε/2 and two function values within one ulp, conditions ≤ 1 by the forms
/// chosen (`form_factor::exchange`), and the sum at most twenty additions.
pub const RECTANGLE_TERMS: f64 = 16.0;

/// Relative asymmetry that a joint matrix built from weights and transition probabilities may
/// have before it counts as irreversible: (a) a quotient and a product, each half an ε, on
/// either side, and the square of that for chains read from sixteen printed digits.
pub const RECIPROCITY: f64 = 16.0 * f64::EPSILON;
