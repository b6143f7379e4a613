//! Parts between two relative positions.

use super::GeometryError;

/// Refuses what is not a part.
///
/// # Errors
/// [`GeometryError::PositionOutOfRange`] unless `0 ≤ from < to ≤ 1`.
pub(crate) fn check_part(from: f64, to: f64) -> Result<(), GeometryError> {
    for (position, lower, upper) in [(from, 0.0, 1.0), (to, from, 1.0)] {
        if !(lower..=upper).contains(&position) || to <= from {
            return Err(GeometryError::PositionOutOfRange {
                position,
                lower,
                upper,
            });
        }
    }
    Ok(())
}
