//! Values from an independent evaluation.

use infoscene::information::continuous_information;
use infoscene::scene::Scene;

#[test]
fn known_values_are_met() {
    for (scene, exact) in [
        (Scene::built_in("cube:1").unwrap(), 1.610_473_346_468_777_7),
        (
            Scene::inside_of_box(1.0, 1.0, 2.0).unwrap(),
            1.796_996_907_794_523,
        ),
    ] {
        let start = std::time::Instant::now();
        let found = continuous_information(&scene).unwrap();
        println!(
            "{} {:e} {:e} {:?}",
            found.mutual_information,
            found.mutual_information - exact,
            found.error,
            start.elapsed()
        );
    }
    for z in [1e-3, 1e3] {
        let start = std::time::Instant::now();
        let found = continuous_information(&Scene::inside_of_box(1.0, 1.0, z).unwrap()).unwrap();
        println!(
            "{} {:e} {:?}",
            found.mutual_information,
            found.error,
            start.elapsed()
        );
    }
}
