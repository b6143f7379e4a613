//! What a scene, a tree and radiosities must be for a bound.

use super::leaf::Leaf;
use crate::exchange::{Closure, Congruence, ScenePairs};
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::hierarchy::{HierarchyError, Lighting, Tree};
use crate::scene::{Occlusion, Scene};
use glam::DVec3;

/// Checks that a scene has a bound, and tells whether it is closed.
///
/// # Errors
/// [`HierarchyError::WrongCount`], [`HierarchyError::Scene`], [`HierarchyError::Exchange`].
pub(super) fn is_closed(
    scene: &Scene,
    tree: &Tree,
    light: &Lighting,
) -> Result<bool, HierarchyError> {
    let patches = scene.patches().len();
    check_count("patches of the tree", tree.patches(), patches)?;
    check_count("reflectances", light.reflectances().len(), patches)?;
    for patch in 0..patches {
        scene.whole_patch(patch)?;
    }
    let pairs = ScenePairs::try_new(
        scene,
        DEFAULT_TOLERANCE,
        Congruence::Shared,
        Occlusion::Exact,
    )?;
    Ok(Closure::of(&pairs)?.is_closed())
}

/// Checks a number of things.
///
/// # Errors
/// [`HierarchyError::WrongCount`].
pub(super) fn check_count(
    what: &'static str,
    found: usize,
    expected: usize,
) -> Result<(), HierarchyError> {
    if found == expected {
        return Ok(());
    }
    Err(HierarchyError::WrongCount {
        what,
        found,
        expected,
    })
}

/// Checks gradients of radiosities: as many as leaves, and finite.
///
/// # Errors
/// [`HierarchyError::WrongCount`]; [`HierarchyError::WrongGradient`].
pub(super) fn check_gradients(gradients: &[DVec3], leaves: usize) -> Result<(), HierarchyError> {
    check_count("gradients", gradients.len(), leaves)?;
    let mut numbered = gradients.iter().copied().enumerate();
    match numbered.find(|(_, gradient)| !gradient.is_finite()) {
        Some((leaf, gradient)) => Err(HierarchyError::WrongGradient { leaf, gradient }),
        None => Ok(()),
    }
}

/// Checks radiosities: finite, and what is emitted where nothing is reflected.
///
/// # Errors
/// [`HierarchyError::WrongRadiosity`].
pub(super) fn check_radiosities(
    leaves: &[Leaf],
    light: &Lighting,
    values: &[f64],
) -> Result<(), HierarchyError> {
    for (leaf, value) in values.iter().copied().enumerate() {
        let patch = leaves[leaf].patch;
        let emitted = light.emittances()[patch];
        let is_dark = light.reflectances()[patch] <= 0.0;
        if !value.is_finite() || (is_dark && (value - emitted).abs() > 0.0) {
            let expected = is_dark.then_some(emitted);
            return Err(HierarchyError::WrongRadiosity {
                leaf,
                value,
                expected,
            });
        }
    }
    Ok(())
}
