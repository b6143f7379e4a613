//! Exchange areas and mutual information of scenes of rectangles, enclosed.

use crate::claims::ClaimError;
use crate::form_factor::RectanglePair;
use crate::information::relative_entropy;
use crate::numeric::{Interval, Scalar};
use crate::scene::Scene;

/// Exchange areas of a patch with every patch, and the product of their areas.
pub(crate) fn exchange_row(
    scene: &Scene,
    patch: usize,
    like: &Interval,
) -> Result<Vec<[Interval; 2]>, ClaimError> {
    let from = scene.rectangle(patch)?;
    let pair = |index: usize| {
        let to = scene.rectangle(index)?;
        let exchange = if index == patch {
            like.zero()
        } else {
            RectanglePair::try_new(&from, &to)?
                .lifted(like)
                .exchange_value()?
        };
        let areas = like.constant(from.area()) * &like.constant(to.area());
        Ok([exchange, areas])
    };
    (0..scene.patches().len()).map(pair).collect()
}

/// Exchange areas of all ordered pairs of patches, and the product of their areas.
pub(crate) fn exchanges(
    scene: &Scene,
    like: &Interval,
) -> Result<Vec<Vec<[Interval; 2]>>, ClaimError> {
    let rows = (0..scene.patches().len()).map(|patch| exchange_row(scene, patch, like));
    rows.collect()
}

/// Mutual information of a closed scene, eq. (3).
pub(crate) fn enclosed_information(scene: &Scene, like: &Interval) -> Result<Interval, ClaimError> {
    let total = like.constant(scene.total_area());
    let pairs = exchanges(scene, like)?.concat();
    Ok(relative_entropy(&total, &total.square(), &pairs) / &total)
}
