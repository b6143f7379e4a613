//! Priorities against values from elsewhere.

use crate::hierarchy::lit_rooms::{furnace, lighting, priorities, refined, start};
use glam::DVec3;
use infoscene::form_factor::{LogMeans, point_form_factor};
use infoscene::geometry::{Patch, centroid, quartered};
use infoscene::hierarchy::OracleName;
use infoscene::scene::{NamedPatch, Scene};
use std::f64::consts::LN_2;

/// Form factors from the centres of a patch's quarters to another, with the quarters' areas.
fn factors(scene: &Scene, from: usize, to: usize) -> Vec<(f64, f64)> {
    let [from, to] = [from, to].map(|index| scene.patches()[index].shape());
    let quarters = quartered(from).unwrap();
    let factor = |at| point_form_factor(at, from.normal(), to).unwrap();
    let quarters = quarters.iter();
    quarters.map(|q| (q.area(), factor(centroid(q)))).collect()
}

/// `Σ_k A_k F_k log2 F_k − A F log2 F`, as printed.
fn printed(parts: &[(f64, f64)]) -> f64 {
    let (area, flux) = parts
        .iter()
        .fold((0.0, 0.0), |(area, flux), (a, f)| (area + a, flux + a * f));
    let terms = parts.iter().map(|(a, f)| a * f * f.log2());
    terms.sum::<f64>() - flux * (flux / area).log2()
}

/// §5's ΔI, and eq. (5), which in uniform light is the same; the form factors of the parts to the
/// five other faces sum to 1.
#[test]
fn information_is_that_of_the_printed_formula() {
    let scene = Scene::built_in("cube:1").unwrap();
    let room = start(&scene, &furnace(&scene));
    for name in [OracleName::Information, OracleName::Chain] {
        for (face, priority) in priorities(&room, name).into_iter().enumerate() {
            let others = (0..6).filter(|other| *other != face);
            let sum: f64 = others
                .map(|other| printed(&factors(&scene, face, other)))
                .sum();
            // the light is known to the residual of a round, 1e-4, but is even: to rounding
            assert!((priority / (2.0 * sum) - 1.0).abs() < 1e-12, "{name}");
        }
    }
}

/// Two parallel unit squares, 4 apart and 4 aside, where the kernel is nearly linear: their loss in
/// closed form, times the radiosities.
#[test]
fn losses_are_those_of_the_closed_form() {
    let square = |origin: DVec3, u: DVec3, v: DVec3| {
        let corners = vec![origin, origin + u, origin + u + v, origin + v];
        NamedPatch::new("square".to_owned(), Patch::try_new(corners).unwrap())
    };
    let (x, y) = (DVec3::X, DVec3::Y);
    let aside = DVec3::new(4.0, 0.0, 4.0);
    let scene = Scene::try_new(vec![square(DVec3::ZERO, x, y), square(aside, y, x)]).unwrap();
    let room = start(&scene, &furnace(&scene));
    let [floor, ceiling] = [0, 1].map(|patch| scene.patches()[patch].shape());
    let means = LogMeans::of(floor, ceiling).unwrap();
    let exchange = means.exchange.value;
    let loss = (means.kernel(1.0).value - exchange * exchange.ln()) / LN_2;
    let light = &room.solution().radiosity;
    for priority in priorities(&room, OracleName::Losses) {
        // two points each way miss 0.34 % of it, as six do by a program of its own
        let expected = 2.0 * light[0] * light[1] * loss;
        assert!(
            (priority / expected - 1.0).abs() < 0.005,
            "{priority} {expected}"
        );
    }
}

/// On a fine mesh radiosity is linear on an element: the residual at Gauss points is that of the
/// gradient, and the means of four parts, at ± 1/4 of its sides, vary by √(3/4) of it.
#[test]
fn residual_and_gather_are_the_gradient_on_fine_meshes() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let room = refined(&scene, &lighting(&scene), OracleName::Area, 300);
    let gradient = priorities(&room, OracleName::Gradient);
    for (name, expected) in [
        (OracleName::Residual, 1.0),
        (OracleName::Gather, 0.75_f64.sqrt()),
    ] {
        let mut ratios: Vec<f64> = priorities(&room, name)
            .iter()
            .zip(&gradient)
            .map(|(priority, gradient)| priority / gradient)
            .collect();
        ratios.sort_by(f64::total_cmp);
        // elements are 1/8 wide: quadratic terms are a tenth or two of the linear ones, and
        // add by squares
        let median = ratios[ratios.len() / 2] / expected;
        assert!((median - 1.0).abs() < 0.05, "{name}: {median}");
    }
}

/// Two parallel unit squares 40 apart, where the kernel k is even to 1e-3, and a plate half-way
/// that hides the points `x = x′ = ½ − √3/6` from each other: one pair of points in four. What is
/// lost is `k ¾ log2 4/3`, where nothing is lost without the plate.
#[test]
fn losses_see_what_stands_between_points() {
    let square = |corners: [[f64; 3]; 4]| {
        let corners = corners.map(DVec3::from_array).to_vec();
        NamedPatch::new("square".to_owned(), Patch::try_new(corners).unwrap())
    };
    let far = 40.0;
    let floor = square([
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ]);
    let ceiling = square([
        [0.0, 0.0, far],
        [0.0, 1.0, far],
        [1.0, 1.0, far],
        [1.0, 0.0, far],
    ]);
    let [low, high, z] = [-1.0, 0.35, 0.5 * far];
    let plate = square([[low, low, z], [high, low, z], [high, 2.0, z], [low, 2.0, z]]);
    let open = Scene::try_new(vec![floor, ceiling]).unwrap();
    let shaded = open.clone().with_obstructions(vec![plate]);
    let [unhindered, found] = [&open, &shaded].map(|scene| {
        let room = start(scene, &furnace(scene));
        let [one, other] = [0, 1].map(|patch| room.solution().radiosity[patch]);
        priorities(&room, OracleName::Losses)[0] / (2.0 * one * other)
    });
    let kernel = 1.0 / (std::f64::consts::PI * far * far);
    let expected = 0.75 * kernel * (4.0_f64 / 3.0).log2();
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    assert!(unhindered < 1e-5 * expected, "{unhindered}");
}
