//! The balance of energy on meshes that are refined.

use super::{lit, refined};
use infoscene::hierarchy::{Factors, Goal, HierarchyError, Lighting, OracleName, Refinement};
use infoscene::scene::{Channel, Occlusion, Scene};

/// A closed room of one material: `B = E/(1 − R)` everywhere, on any mesh and by any factors.
#[test]
fn furnaces_are_uniform() {
    for name in ["lit-cube", "lit-wings", "shaded-cube", "lit-table"] {
        let scene = Scene::built_in(name).unwrap();
        let patches = scene.patches().len();
        for factors in [Factors::OfPoints, Factors::Exact] {
            let furnace = Lighting::try_new(vec![0.75; patches], vec![1.0; patches]).unwrap();
            let room = Refinement::try_new(&scene, furnace, Occlusion::Exact, factors).unwrap();
            let room = refined(room, OracleName::Area, 4 * patches);
            assert!(room.tree().leaf_count() >= 4 * patches);
            for leaf in room.tree().leaves() {
                let off = (room.solution().radiosity[leaf] / 4.0 - 1.0).abs();
                // the residual that is solved to, over 1 − R, and square roots of areas of leaves
                assert!(off < 1e-10, "{name}, {factors:?}: {off:e}");
            }
        }
    }
}

/// One reflectance everywhere: mean `B = mean E/(1 − R)`, whatever the geometry, if no energy is
/// lost; links of points lose some.
#[test]
fn exact_factors_lose_no_energy() {
    for name in ["lit-cube", "shaded-cube"] {
        let scene = Scene::built_in(name).unwrap();
        let patches = scene.patches().len();
        let emittances: Vec<f64> = (0..patches).map(|p| f64::from(u8::from(p == 1))).collect();
        let loss = |factors| {
            let light = Lighting::try_new(vec![0.6; patches], emittances.clone()).unwrap();
            let room = Refinement::try_new(&scene, light, Occlusion::Exact, factors).unwrap();
            let room = refined(room, OracleName::Gradient, 60);
            let elements = room.tree().elements();
            let (mut reflected, mut emitted) = (0.0, 0.0);
            for leaf in room.tree().leaves() {
                let area = elements[leaf].shape().area();
                reflected += area * room.solution().radiosity[leaf];
                emitted += area * room.lighting().emittance(elements[leaf].patch());
            }
            (reflected * 0.4 / emitted - 1.0).abs()
        };
        assert!(
            loss(Factors::Exact) < 1e-12,
            "{name}: {:e}",
            loss(Factors::Exact)
        );
        // the control: points do lose some
        assert!(loss(Factors::OfPoints) > 1e-6, "{name}");
    }
}

/// What is emitted is absorbed: by walls, and by lights and an opening that reflect nothing.
#[test]
fn what_is_emitted_is_absorbed() {
    for name in ["lit-cube", "cornell-box", "cornell-box-blocks"] {
        let scene = Scene::built_in(name).unwrap();
        let lighting = Lighting::of(&scene, Channel::Green).unwrap();
        for (factors, elements, allowed) in [
            (Factors::Exact, 60, 1e-11),
            // points are right to second order
            (Factors::OfPoints, 400, 0.02),
        ] {
            let light = lighting.clone();
            let room = Refinement::try_new(&scene, light, Occlusion::Exact, factors).unwrap();
            let room = refined(room, OracleName::Gradient, elements);
            let (mut absorbed, mut emitted) = (0.0, 0.0);
            for leaf in room.tree().leaves() {
                let element = &room.tree().elements()[leaf];
                let (area, patch) = (element.shape().area(), element.patch());
                let irradiance = room.solution().received.irradiance[leaf];
                absorbed += area * (1.0 - lighting.reflectance(patch)) * irradiance;
                emitted += area * lighting.emittance(patch);
            }
            let off = (absorbed / emitted - 1.0).abs();
            assert!(off < allowed, "{name}, {factors:?}: {off:e}");
        }
    }
}

/// A mesh, its links and its light are the same for one thread and for many.
#[test]
fn threads_change_nothing() {
    let mesh = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| {
            let scene = Scene::built_in("shaded-cube").unwrap();
            let room = refined(lit(&scene, 1.0), OracleName::Gradient, 200);
            let bits = room.solution().radiosity.iter().map(|b| b.to_bits());
            (room.links().count(), bits.collect::<Vec<_>>())
        })
    };
    assert_eq!(mesh(1), mesh(3));
}

/// Refusals say what is wrong.
#[test]
fn what_cannot_be_solved_is_refused() {
    assert!(matches!(
        Lighting::try_new(vec![0.5, 1.0], vec![1.0, 0.0]),
        Err(HierarchyError::Mirror { patch: 1 })
    ));
    let dark = Lighting::try_new(vec![0.5; 2], vec![0.0; 2]).unwrap_err();
    assert!(
        dark.to_string()
            .contains("no patch has a positive emittance")
    );
    let scene = Scene::built_in("lit-cube").unwrap();
    let oracle = OracleName::Gradient.oracle(None).unwrap();
    let mut room = lit(&scene, 1.0);
    assert_eq!(
        room.refine(&*oracle, Goal::Elements(5), &mut |_| ()),
        Err(HierarchyError::FewerThanPatches {
            elements: 5,
            patches: scene.patches().len()
        })
    );
    let most = room.refine(&*oracle, Goal::Elements(1 << 40), &mut |_| ());
    assert!(matches!(most, Err(HierarchyError::TooManyElements { .. })));
}
