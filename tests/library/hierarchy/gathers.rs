//! The last gather.

use super::{lit, refined};
use infoscene::hierarchy::OracleName;
use infoscene::reference::BoxRadiosity;
use infoscene::scene::{Channel, Scene};

/// Against a road of its own, light that is gathered once more is at most a fifth as far off as the
/// means of the mesh, in the mean square over points between centres and corners of leaves.
#[test]
fn the_last_gather_is_far_better_than_the_mesh() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let exact = BoxRadiosity::try_new(&scene, Channel::Green, 4).unwrap();
    let room = refined(lit(&scene, 1.0), OracleName::Gradient, 100);
    let elements = room.tree().elements();
    let (mut of_mesh, mut of_gather) = (0.0, 0.0);
    for leaf in room.tree().leaves().step_by(4) {
        let element = &elements[leaf];
        if room.lighting().is_light(element.patch()) {
            continue;
        }
        let point = 0.6 * element.centre() + 0.4 * element.shape().corners()[0];
        let truth = exact.radiosity(element.patch(), point).value;
        let area = element.shape().area();
        of_mesh += area * (room.solution().radiosity[leaf] - truth).powi(2);
        of_gather += area * (room.gathered(leaf, point).unwrap() - truth).powi(2);
    }
    let ratio = (of_gather / of_mesh).sqrt();
    assert!(ratio < 0.2, "{ratio}");
    // the control: the reference is not the gather itself
    assert!(of_gather > 0.0);
}
