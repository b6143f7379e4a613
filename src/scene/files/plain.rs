//! Scenes that are patches and nothing else: all that Wavefront OBJ and STL can say.

use super::error::NotExpressible;
use crate::scene::Scene;

/// Refuses a scene that has more than patches, each a row of its own.
///
/// # Errors
/// [`NotExpressible`] if polygons only obstruct, a patch lies in another one, or patches are
/// summed.
pub(crate) fn check_plain(scene: &Scene, format: &'static str) -> Result<(), NotExpressible> {
    let not = |what: String| NotExpressible {
        format,
        what,
        mend: "write View3D .vs3",
    };
    let count = scene.patches().len();
    if !scene.obstructions().is_empty() {
        return Err(not("a polygon only obstructs".to_owned()));
    }
    if let Some(part) = (0..count).find(|index| scene.base_of(*index).is_some()) {
        return Err(not(format!("patch {part} lies in another one")));
    }
    if scene.group_count() < count {
        return Err(not("patches are summed into one row".to_owned()));
    }
    Ok(())
}
