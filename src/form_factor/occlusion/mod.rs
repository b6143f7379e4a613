//! Form factors of polygons past others that stand in the way.
//!
//! **Not covered**: everything yet but the bounds 0 and the unoccluded value.

use super::{Answer, FormFactorError, Polygon, Route};

/// The polygons that may stand between two others, each blocking from both sides.
#[derive(Debug, Clone, Copy)]
pub struct Occluders<'a> {
    /// The polygons, in any order; those that take nothing away cost time only.
    pub polygons: &'a [&'a Polygon],
    /// The distance up to which corners, edges and planes count as meeting; 0 leaves rounding
    /// alone.
    pub touching: f64,
}

impl Polygon {
    /// The exchange area of the parts of two polygons that see each other past others.
    ///
    /// # Errors
    /// As [`exchange_area`](Self::exchange_area).
    pub fn exchange_area_past(
        &self,
        other: &Self,
        occluders: &Occluders,
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        let mut answer = self.exchange_area(other, tolerance)?;
        if !occluders.polygons.is_empty() {
            let half = 0.5 * answer.exchange.value;
            answer.exchange.value = half;
            answer.exchange.error += half;
            answer.route = Route::Occluded;
        }
        Ok(answer)
    }
}
