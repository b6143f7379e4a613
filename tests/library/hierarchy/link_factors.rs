//! Form factors of links, past what stands between.

use crate::support::furnished::{table, two_boxes, u_room};
use glam::DVec3;
use infoscene::Scene;
use infoscene::form_factor::{Occluders, PointFactor, Polygon, point_form_factor_past};
use infoscene::geometry::Patch;
use infoscene::hierarchy::{Element, LinkFactors, Tree, Visibility};
use infoscene::scene::{NamedPatch, Occlusion};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// An icosahedron with a square plate of two fronts in it.
fn solid_with_a_plate() -> Scene {
    let mut patches = Scene::built_in("icosahedron").unwrap().patches().to_vec();
    let corners = [[-0.4, -0.3], [0.5, -0.3], [0.5, 0.6], [-0.4, 0.6]];
    let corners = corners.map(|[x, y]| DVec3::new(x, y, 0.2 * x + 0.1));
    let plate = Patch::try_new(corners.to_vec()).unwrap();
    patches.push(NamedPatch::new(
        "below".to_owned(),
        plate.clone().reversed(),
    ));
    patches.push(NamedPatch::new("above".to_owned(), plate));
    Scene::try_new(patches).unwrap()
}

fn scenes() -> Vec<(Scene, u64)> {
    let built_in = |name| Scene::built_in(name).unwrap();
    let names = ["shaded-cube", "shaded-cube-low", "lit-wings"];
    let mut scenes: Vec<Scene> = names.map(built_in).to_vec();
    scenes.extend([two_boxes(), table(), u_room(), solid_with_a_plate()]);
    scenes.into_iter().zip(0..).collect()
}

/// A tree whose leaves are some times quartered.
fn tree(scene: &Scene, depth: u32) -> Tree {
    let mut tree = Tree::new(scene.patches().iter().map(NamedPatch::shape));
    for _ in 0..depth {
        for leaf in tree.leaves().collect::<Vec<_>>() {
            tree.quarter(leaf).unwrap();
        }
    }
    tree
}

/// Pairs of different elements at random.
fn pairs(tree: &Tree, seed: u64, count: usize) -> Vec<[&Element; 2]> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut element = || &tree.elements()[random.random_range(0..tree.elements().len())];
    let pairs = std::iter::repeat_with(|| [element(), element()]);
    pairs
        .filter(|[one, other]| one.patch() != other.patch())
        .take(count)
        .collect()
}

/// The points of a rule of degree 2 on a triangle or a parallelogram, all of one weight.
fn points(element: &Element) -> Vec<DVec3> {
    let corners = element.shape().corners();
    let share = match corners.len() {
        3 => 0.5,
        _ => 1.0 / 3f64.sqrt(),
    };
    let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
    corners
        .iter()
        .map(|corner| middle.lerp(*corner, share))
        .collect()
}

/// The surfaces of a scene, each of which may be in the way of all others.
fn polygons(scene: &Scene) -> Vec<Polygon> {
    scene
        .patches()
        .iter()
        .map(|patch| Polygon::new(patch.shape()))
        .collect()
}

/// The residuals of a plane through values at points, `Σ (f − F(x)) (1, x − c)/n`.
fn residuals(plane: &PointFactor, centre: DVec3, values: &[(DVec3, f64)]) -> (f64, DVec3) {
    let share = 1.0 / values.len() as f64;
    let (mut sum, mut moment) = (0.0, DVec3::ZERO);
    for (point, value) in values {
        let rest = value - plane.value - plane.gradient.dot(*point - centre);
        sum += share * rest;
        moment += share * rest * (*point - centre);
    }
    (sum, moment)
}

/// Values at the points of the rule, by the road that has bounds: where something is hidden from
/// one, the link is their best plane.
#[test]
fn a_partial_link_is_the_best_plane_through_exact_factors() {
    let mut partial = 0;
    for (scene, seed) in scenes() {
        let links = LinkFactors::try_new(&scene, Occlusion::Exact).unwrap();
        let (surfaces, touching) = (polygons(&scene), scene.noise_length());
        let all: Vec<&Polygon> = surfaces.iter().collect();
        let tree = tree(&scene, 2);
        let is_simple = |pair: &[&Element; 2]| pair[0].shape().corners().len() < 5;
        for [receiver, source] in pairs(&tree, seed, 120).into_iter().filter(is_simple) {
            let target = Polygon::new(source.shape());
            let see = |point, polygons| {
                let occluders = Occluders { polygons, touching };
                let normal = receiver.shape().normal();
                let seen = point_form_factor_past(point, normal, &target, &occluders).unwrap();
                assert!(seen.error < 1e-12);
                seen.value
            };
            let at = |polygons| {
                points(receiver)
                    .into_iter()
                    .map(move |p| (p, see(p, polygons)))
            };
            let values: Vec<_> = at(&all[..]).collect();
            let is_hidden = at(&[])
                .zip(&values)
                .any(|((_, bare), seen)| bare > seen.1 + 1e-9);
            let link = links.between(receiver, source).unwrap();
            let Some(link) = link else {
                assert!(values.iter().all(|(_, value)| *value < 1e-12));
                continue;
            };
            if is_hidden {
                // values of at most 1 within 1e-12 each, arms of at most a radius
                let (sum, moment) = residuals(&link, receiver.centre(), &values);
                assert!(sum.abs() < 4e-12, "{sum:e}");
                assert!(moment.length() < 4e-12 * receiver.radius(), "{moment}");
                partial += 1;
            }
        }
    }
    assert!(partial > 60, "{partial}");
}

/// Nothing is between elements that are said to be clear, and all of what is said to be hidden is.
#[test]
fn clear_links_lose_nothing_and_hidden_ones_all() {
    let [mut clear, mut hidden, mut open] = [0; 3];
    for (scene, seed) in scenes() {
        let links = LinkFactors::try_new(&scene, Occlusion::Exact).unwrap();
        let (surfaces, touching) = (polygons(&scene), scene.noise_length());
        let polygons: Vec<&Polygon> = surfaces.iter().collect();
        let occluders = Occluders {
            polygons: &polygons,
            touching,
        };
        let tree = tree(&scene, 3);
        for [receiver, source] in pairs(&tree, 10 + seed, 60) {
            let ends = [receiver, source].map(|end| Polygon::new(end.shape()));
            let bare = ends[0].exchange_area(&ends[1], 1e-9).unwrap().exchange;
            if bare.value <= 1e-9 * receiver.shape().area() {
                continue;
            }
            let past = ends[0]
                .exchange_area_past(&ends[1], &occluders, 1e-9)
                .unwrap()
                .exchange;
            let known = links.visibility(receiver.patch(), source.patch());
            let link = links.between_parts(receiver, source, known).unwrap();
            match link.map(|(_, visibility)| visibility) {
                Some(Visibility::Clear) => {
                    assert!((past.value - bare.value).abs() <= past.error + bare.error);
                    clear += 1;
                }
                None => {
                    assert!(past.value <= past.error);
                    hidden += 1;
                }
                Some(between) => {
                    let [own, back] = [[0, 1], [1, 0]].map(|[i, j]| {
                        let ends = [&ends[i], &ends[j]];
                        links.exchange_area(ends, &between, 1e-9).unwrap()
                    });
                    assert!(own.error >= 0.0 && past.error >= 0.0);
                    assert!((past.value - own.value).abs() <= past.error + own.error);
                    assert!((own.value - back.value).abs() <= own.error + back.error);
                    open += 1;
                }
            }
        }
    }
    assert!(
        clear > 60 && hidden > 1 && open > 30,
        "{clear} {hidden} {open}"
    );
}

/// Told what stands between their parents, elements find what they find among all plates.
#[test]
fn parts_inherit_what_stands_between() {
    let mut past = 0;
    for (scene, seed) in scenes() {
        let links = LinkFactors::try_new(&scene, Occlusion::Exact).unwrap();
        let tree = tree(&scene, 2);
        let parent = |element: &Element| &tree.elements()[element.parent().unwrap()];
        let deep = |pair: &[&Element; 2]| pair.iter().all(|end| end.parent().is_some());
        for pair in pairs(&tree, 20 + seed, 400).into_iter().filter(deep) {
            let [receiver, source] = pair;
            let known = links.visibility(receiver.patch(), source.patch());
            let above = links
                .between_parts(parent(receiver), parent(source), known)
                .unwrap();
            let alone = links.between_parts(receiver, source, known).unwrap();
            let Some((_, inherited)) = above else {
                // some of a part is in front only if some of the whole is
                assert!(alone.is_none());
                continue;
            };
            let found = links.between_parts(receiver, source, &inherited).unwrap();
            assert_eq!(found.is_some(), alone.is_some());
            let (Some(found), Some(alone)) = (found, alone) else {
                continue;
            };
            assert_eq!(found.0, alone.0);
            if let (Visibility::Past(some), Visibility::Past(all)) = (&found.1, &inherited) {
                assert!(some.iter().all(|plate| all.contains(plate)));
                past += 1;
            }
        }
    }
    assert!(past > 100, "{past}");
}

/// `Σ_j J_ij = A_i` in a closed room, past the plate in it.
#[test]
fn exact_exchange_areas_of_elements_sum_to_their_area() {
    for name in ["shaded-cube", "lit-wings"] {
        let scene = Scene::built_in(name).unwrap();
        let links = LinkFactors::try_new(&scene, Occlusion::Exact).unwrap();
        let tree = tree(&scene, 1);
        let leaves: Vec<&Element> = tree.leaves().map(|leaf| &tree.elements()[leaf]).collect();
        let polygons: Vec<Polygon> = leaves
            .iter()
            .map(|leaf| Polygon::new(leaf.shape()))
            .collect();
        for i in (0..leaves.len()).step_by(7) {
            let (mut sum, mut error) = (0.0, 1e-14);
            for j in (0..leaves.len()).filter(|j| leaves[*j].patch() != leaves[i].patch()) {
                let known = links.visibility(leaves[i].patch(), leaves[j].patch());
                let ends = [&polygons[i], &polygons[j]];
                let exchange = links.exchange_area(ends, known, 1e-9).unwrap();
                (sum, error) = (sum + exchange.value, error + exchange.error);
            }
            let area = leaves[i].shape().area();
            assert!(
                (sum - area).abs() <= error && error < 1e-8 * area,
                "{sum} {area} {error}"
            );
        }
    }
}

/// A room with a plate in it, and the policies for it.
#[test]
fn what_stands_between_is_refused_or_ignored_as_asked() {
    let scene = Scene::built_in("shaded-cube").unwrap();
    assert!(LinkFactors::try_new(&scene, Occlusion::Refuse).is_err());
    let blind = LinkFactors::try_new(&scene, Occlusion::Ignore).unwrap();
    let links = LinkFactors::try_new(&scene, Occlusion::Exact).unwrap();
    let tree = tree(&scene, 0);
    let number = |name: &str| {
        scene
            .patches()
            .iter()
            .position(|p| p.name() == name)
            .unwrap()
    };
    let [floor, light] = [number("floor"), number("light")].map(|k| &tree.elements()[k]);
    let [bare, seen] =
        [&blind, &links].map(|links| links.between(floor, light).unwrap().unwrap().value);
    assert!(seen < bare);
    assert_eq!(*blind.visibility(0, 1), Visibility::Clear);
}
