//! Uniform lines through a sphere.

use glam::DVec3;
use std::f64::consts::TAU;

/// A point and the unit direction of a line through the sphere of this radius around the origin;
/// the point is the nearest to the origin.
///
/// ```text
///   direction   uniform on the sphere (z uniform, by Archimedes)
///   point       uniform on the disk across it
/// ```
///
/// For uniform numbers this is the density of lines that motions leave alone: a line meets a flat
/// piece of surface within the sphere in proportion to its area, whatever its place and direction.
///
/// **Arguments** `radius` ≥ 0; four numbers from 0 to 1: two for the direction, two for the point.
///
/// # Source
/// Santaló, *Integral Geometry and Geometric Probability*, 1976, ch. 12.
pub(crate) fn line_through_sphere(radius: f64, [z, turn, square, around]: [f64; 4]) -> [DVec3; 2] {
    debug_assert!(radius >= 0.0, "{radius}");
    debug_assert!((0.0..=1.0).contains(&z) && (0.0..=1.0).contains(&square));
    let z = 2.0 * z - 1.0;
    let (sine, cosine) = (TAU * turn).sin_cos();
    let flat = (1.0 - z * z).sqrt();
    let direction = DVec3::new(flat * cosine, flat * sine, z);
    let (across, up) = direction.any_orthonormal_pair();
    let (sine, cosine) = (TAU * around).sin_cos();
    let point = radius * square.sqrt() * (cosine * across + sine * up);
    [point, direction]
}
