//! Stiff rooms: nearly white, nearly apart, thirty orders of magnitude.

use infoscene::numeric::tolerance;
use infoscene::study::light::stability::transport_stability;
use infoscene::study::light::stability::{exact_radiosities, stiff_scenes, worst_error};
use infoscene::transport::RadiositySystem;

/// Against enclosures of 256 bits that share no formula: each radiosity to rounding, and the bound
/// no lower than the error.
#[test]
fn stiff_scenes_keep_their_digits() {
    for scene in stiff_scenes().unwrap() {
        let exact = exact_radiosities(&scene, 256).unwrap();
        let room = RadiositySystem::of_matrix(&scene.exchange, scene.reflectances.clone()).unwrap();
        let found = room.radiosity(&scene.emittances).unwrap();
        let error = worst_error(&found.values, &exact);
        let name = &scene.name;
        assert!(
            error <= found.relative_error,
            "{name}: {error:e} > {:e}",
            found.relative_error
        );
        assert!(
            found.relative_error < tolerance::RADIOSITY,
            "{name}: {:e}",
            found.relative_error
        );
    }
}

/// Negative control: the usual solvers lose what the scenes are stiff by.
#[test]
fn other_solvers_lose_digits_there() {
    let rows = transport_stability(0).unwrap();
    let worst = |method: &str| {
        let rows = rows.iter().filter(|row| row.method == method);
        rows.map(|row| row.relative_error.unwrap())
            .fold(0.0, f64::max)
    };
    assert!(worst("elimination") > 1e-2);
    assert!(worst("bounces") > 0.5);
    assert!(worst("chosen") < tolerance::RADIOSITY);
}

/// The judge itself, against a room that is solved by hand: two patches that see only each other.
#[test]
fn the_judge_knows_two_patches() {
    let scene = infoscene::study::light::stability::StiffScene {
        name: "two".to_owned(),
        exchange: nalgebra::dmatrix![0.0, 1.0; 1.0, 0.0],
        reflectances: vec![0.5, 0.75],
        emittances: vec![1.0, 0.0],
    };
    // B_1 = 1/(1 − 3/8), B_2 = 3/4 B_1
    let exact = exact_radiosities(&scene, 256).unwrap();
    assert!(worst_error(&[1.6, 1.2], &exact) < f64::EPSILON);
    assert!(worst_error(&[1.6, 1.2 + 1e-12], &exact) > 1e-13);
}
