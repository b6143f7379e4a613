//! Accuracy promises: the tolerances that callers and tests rely on, each with its reason.
//!
//! A number is here because (a) a bound was derived, (b) a named test measures it, or (c) the paper
//! prints that many digits (those come with the claims, as data). Constants that only steer a
//! search stand with the code that searches.

/// Relative error of [`divergence_kernel`](super::divergence_kernel): (a) at |x| = 1/4 the plain
/// form cancels (1+x)·ln(1+x) against x, a factor 9 on 2 ε; the series form stays below. Measured
/// by `divergence_kernel_keeps_its_digits`.
pub const DIVERGENCE_KERNEL: f64 = 24.0 * f64::EPSILON;

/// Deviation from a plane, relative to a patch's diameter, up to which it counts as planar: (a) the
/// input's own rounding is 1e-16 of its coordinates, a file of twelve decimals gives 1e-12.
pub const PLANARITY: f64 = 1e-12;

/// Heights between which corners of one plane lie, per length by which a coordinate is off: (a) a
/// corner is off by √3 times that, the corners of one plane lie between twice that, and a plane
/// that is not the best one doubles it.
pub const BEND: f64 = 4.0 * SQRT_3;

/// The distance at which the diagonals of four corners of one plane pass each other, per length by
/// which a coordinate is off: (a) at most twice what a corner is off by.
pub const QUADRILATERAL_BEND: f64 = 2.0 * SQRT_3;

/// The square root of 3: a corner whose three coordinates are off by 1 is off by so much.
pub const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// The largest resolution, relative to the width of what it is to resolve: (a) surfaces that count
/// as touching reach into each other by [`RESOLVED_NOISE`] resolutions at most, which is less than
/// the width then.
pub const RESOLVED: f64 = 1.0 / 20.0;

/// The length below which touching cannot be told from penetrating, in resolutions: (a) true
/// corners lie within δ = √3 resolutions, those that were put into a plane within twice that; a
/// plane put through three of many leaves the others by up to 6 δ if all errors conspire, and by
/// 2 δ as rounding goes, and depths add 2 δ. Held by `rounded_rooms_are_rooms`.
pub const RESOLVED_NOISE: f64 = 8.0 * SQRT_3;

/// Deviation from a common axis or plane, relative to the largest coordinate, up to which two
/// rectangles count as aligned: (a) a rotated corner carries three roundings of ε each, twice
/// over for a difference, and the frame another two.
pub const ALIGNMENT: f64 = 16.0 * f64::EPSILON;

/// The factor of ε in the running bound of the rectangle closed forms: (a) each term takes at most
/// 22 roundings of ε/2, function values counted with theirs (`form_factor::parallel`,
/// `perpendicular`), and the sum 8 more (`form_factor::exchange`). Held by
/// `parallel_bound_is_never_below_the_error` and `perpendicular_bound_is_never_below_the_error`.
pub const RECTANGLE_TERMS: f64 = 15.0;

/// Relative asymmetry that a joint matrix built from weights and transition probabilities may have
/// before it counts as irreversible: (a) w, P and their product carry half an ε each, 3 ε over both
/// sides; five times that for weights and probabilities that were themselves computed.
pub const RECIPROCITY: f64 = 16.0 * f64::EPSILON;

/// Absolute error of an optimal position on a scale of 1: (b) `cuts_agree_with_their_references`
/// and the reference tests of the splits hold it.
pub const POSITION: f64 = 1e-14;

/// Relative error of a gain at well separated form factors: (b) held by the reference tests of the
/// splits and of §4.2.
pub const GAIN: f64 = 1e-13;

/// Absolute error of an optimal position where parts are computed as polygons, on a scale of 1, if
/// the gain is well curved: (b) held by `turned_scenes_of_the_paper_have_the_papers_cuts`.
pub const POLYGON_POSITION: f64 = 1e-12;

/// Relative error of a gain there, at well separated form factors: (b) held by the same test.
pub const POLYGON_GAIN: f64 = 1e-12;

/// Absolute error of an optimal position where something stands between, on a scale of 1, if the
/// gain is well curved: (b) held by `a_cut_behind_a_half_plane_is_that_of_the_reference`.
pub const OCCLUDED_POSITION: f64 = 1e-6;

/// Relative error of a gain there: (b) held by the same test.
pub const OCCLUDED_GAIN: f64 = 1e-9;

/// Relative error of the mutual information of a grid on a cube: (b) held by
/// `regular_grids_agree_with_29_digits`.
pub const GRID_INFORMATION: f64 = 1e-13;

/// Deviation of an identity between sums of entropies of at most 10 bits each: (a) some hundred
/// terms of ε each, relative to 10.
pub const IDENTITY: f64 = 1e-12;

/// Deviation of row sums and of additivity of rectangle exchange areas near to each other: (a) a
/// hundred terms with the bound [`RECTANGLE_TERMS`].
pub const CLOSURE: f64 = 1e-12;

/// Bound on a gain that vanishes by symmetry, in bits: (a) the square of 64 ε, the relative
/// difference of two equal form factors computed apart.
pub const VANISHING_GAIN: f64 = 1e-27;

/// Absolute error of a gain in bits where entries below 1e-290 of the sum take part: (a) such an
/// entry enters with at most itself times the logarithm of the smallest double, and products of it
/// may be lost.
pub const TINY_GAIN: f64 = 1e-280;

/// Rounding of a scene's mutual information I, times 2 + I bits: (a) the kernel's 24 ε on terms ≥
/// 0; 2 ε of `Σ J |log2(J/q)|` ≤ I + 1.07 for the argument of the kernel; areas within 4 ε change q
/// by 12 ε and the sum by `Σ |q − J|` ≤ 2 of that over ln 2. Measured by
/// `information_errors_are_bounds`.
pub const INFORMATION: f64 = 32.0 * f64::EPSILON;

/// Depth, relative to the largest coordinate of a scene, up to which a patch that enters the solid
/// between two others counts as touching it: (a) a corner that was rotated and shifted carries at
/// most six roundings of ε/2 of up to √3 times the largest coordinate, 6 ε, and the depth of two
/// bodies changes by at most twice that; a plane put through three corners far apart leaves the
/// others at up to 5 times it, on either side, 60 ε, and heights take 4 ε. Held by
/// `rotated_rooms_have_no_blocker`.
pub const TOUCHING: f64 = 64.0 * f64::EPSILON;

/// Largest apparent depth of a patch in the solid between two others if corners deviate from their
/// planes by 1: (a) a quadrilateral with one corner off by δ shows a deviation of δ/4 on each side
/// of its mean plane, and the depth of two bodies changes by at most 2 δ.
pub const DEPTH_PER_DEVIATION: f64 = 8.0;

/// Relative error bound of radiosities for the exchange areas as given, stiff scenes included: (b)
/// a few ε, measured by `stiff_scenes_keep_their_digits`.
pub const RADIOSITY: f64 = 1e-14;

/// Part of a face that may be left open by the patches that cover it: (a) corners read from twelve
/// decimals are off by 1e-12 of the diameter, and a face of many patches has some hundred of them
/// around it.
pub const COVERED: f64 = 1e-10;

/// Most that a corrected estimate from samples may subtract for cells not met, in standard errors,
/// if an interval is to be given: (b) a fifth of it is missing yet, measured by
/// `a_fifth_is_missing_of_what_is_taken_off`, and a bias of a fifth of the standard error leaves
/// 94.5 % of the 95 % covered.
pub const UNSEEN: f64 = 1.0;
