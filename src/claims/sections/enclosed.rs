//! Exchange areas and mutual information of scenes of rectangles, enclosed.

use crate::claims::ClaimError;
use crate::form_factor::RectanglePair;
use crate::geometry::Rectangle;
use crate::information::relative_entropy;
use crate::numeric::{Interval, Scalar};
use crate::scene::Scene;

/// Exchange areas of all ordered pairs of patches, and the product of their areas.
pub(crate) fn exchanges(
    scene: &Scene,
    like: &Interval,
) -> Result<Vec<Vec<[Interval; 2]>>, ClaimError> {
    let rectangles = (0..scene.patches().len())
        .map(|index| scene.rectangle(index))
        .collect::<Result<Vec<_>, _>>()?;
    let pair = |a: &Rectangle, b: &Rectangle| {
        let exchange = if a == b {
            like.zero()
        } else {
            RectanglePair::try_new(a, b)?
                .lifted(like)
                .exchange_value()?
        };
        let areas = like.constant(a.area()) * &like.constant(b.area());
        Ok([exchange, areas])
    };
    let row = |a| rectangles.iter().map(|b| pair(a, b)).collect();
    rectangles.iter().map(row).collect()
}

/// Mutual information of a closed scene, eq. (3).
pub(crate) fn enclosed_information(scene: &Scene, like: &Interval) -> Result<Interval, ClaimError> {
    let total = like.constant(scene.total_area());
    let pairs = exchanges(scene, like)?.concat();
    Ok(relative_entropy(&total, &total.square(), &pairs) / &total)
}
