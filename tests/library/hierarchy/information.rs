//! The mutual information of the chain that links describe.

use infoscene::chain::brightness_chain;
use infoscene::hierarchy::{Factors, Goal, Lighting, OracleName, Refinement, link_information};
use infoscene::information::mutual_information;
use infoscene::scene::{Channel, Occlusion, Scene};

fn refined<'s>(scene: &'s Scene, lighting: Lighting, elements: usize) -> Refinement<'s> {
    let mut refinement =
        Refinement::try_new(scene, lighting, Occlusion::Exact, Factors::OfPoints).unwrap();
    let oracle = OracleName::default().oracle(None).unwrap();
    let goal = Goal::Elements(elements);
    refinement.refine(&*oracle, goal, &mut |_| {}).unwrap();
    refinement
}

fn information(refinement: &Refinement<'_>, radiosity: &[f64]) -> Option<f64> {
    let (tree, links) = (refinement.tree(), refinement.links());
    link_information(tree, links, refinement.lighting(), radiosity)
}

/// The joint probabilities of all pairs of leaves, pair by pair: `F_ij A_y/A_j · A_x B_x B_y` for
/// the link of the elements i and j around the leaves x and y.
fn joint(refinement: &Refinement<'_>) -> Vec<Vec<f64>> {
    let (tree, lighting) = (refinement.tree(), refinement.lighting());
    let radiosity = &refinement.solution().radiosity;
    let area = |element: usize| tree.elements()[element].shape().area();
    let around = |leaf: usize| {
        std::iter::successors(Some(leaf), |element| tree.elements()[*element].parent())
            .collect::<Vec<_>>()
    };
    let leaves: Vec<usize> = tree.leaves().collect();
    let light = |x: usize, y: usize| {
        let mut sum = 0.0;
        for receiver in around(x) {
            for link in refinement.links().of(receiver) {
                if around(y).contains(&(link.source as usize)) {
                    sum += link.value * area(y) / area(link.source as usize);
                }
            }
        }
        sum * area(x) * radiosity[x] * radiosity[y]
    };
    let is_black = |leaf: usize| lighting.reflectance(tree.elements()[leaf].patch()) == 0.0;
    let entry = |x: usize, y: usize| {
        if is_black(x) {
            light(y, x)
        } else {
            light(x, y)
        }
    };
    let rows = leaves.iter();
    rows.map(|x| leaves.iter().map(|y| entry(*x, *y)).collect())
        .collect()
}

/// `I = Σ p(x, y) log2 [p(x, y)/(p(x) p(y))]`, over all pairs.
fn information_of(joint: &[Vec<f64>]) -> f64 {
    let whole: f64 = joint.iter().flatten().sum();
    let columns = 0..joint.len();
    let columns: Vec<f64> = columns
        .map(|y| joint.iter().map(|row| row[y]).sum::<f64>() / whole)
        .collect();
    let mut sum = 0.0;
    for row in joint {
        let of_row = row.iter().sum::<f64>() / whole;
        for (p, of_column) in row.iter().zip(&columns) {
            let p = p / whole;
            if p > 0.0 {
                sum += p * (p / (of_row * of_column)).log2();
            }
        }
    }
    sum
}

#[test]
fn blocks_of_links_have_the_information_of_all_their_pairs_of_leaves() {
    // the cube's light is black, the hall's walls are all grey
    for name in ["lit-cube", "lit-hall"] {
        let scene = Scene::built_in(name).unwrap();
        let materials = 0..scene.patches().len();
        let lamp = |patch: usize| scene.patches()[patch].name() == "light";
        let (reflectances, emittances) = materials
            .map(|patch| if lamp(patch) { (0.0, 1.0) } else { (0.5, 0.0) })
            .unzip();
        let lighting = Lighting::try_new(reflectances, emittances).unwrap();
        let refinement = refined(&scene, lighting, 60);
        // some links are of elements that are cut
        let tree = refinement.tree();
        let is_coarse = |element: u32| !tree.elements()[element as usize].is_leaf();
        let links = refinement.links().all();
        assert!(links.iter().any(|link| is_coarse(link.source)));
        let found = information(&refinement, &refinement.solution().radiosity).unwrap();
        let slow = information_of(&joint(&refinement));
        // some 5000 terms of both signs below 3 bits, each of some roundings
        assert!((found - slow).abs() < 1e-11, "{name}: {found} {slow}");
    }
}

/// Two patches that see but each other tell which of them sent the light: 1 bit, whatever their
/// brightness.
#[test]
fn two_patches_have_one_bit() {
    let scene = Scene::built_in("two-squares").unwrap();
    for emittances in [vec![1.0, 1.0], vec![1.0, 0.0]] {
        let lighting = Lighting::try_new(vec![0.5, 0.5], emittances).unwrap();
        let refinement =
            Refinement::try_new(&scene, lighting, Occlusion::Exact, Factors::OfPoints).unwrap();
        let found = information(&refinement, &refinement.solution().radiosity).unwrap();
        // four logarithms
        assert!((found - 1.0).abs() < 1e-14, "{found}");
    }
}

#[test]
fn without_light_there_is_no_information() {
    let scene = Scene::built_in("two-squares").unwrap();
    let lighting = Lighting::try_new(vec![0.5, 0.5], vec![1.0, 0.0]).unwrap();
    let refinement =
        Refinement::try_new(&scene, lighting, Occlusion::Exact, Factors::OfPoints).unwrap();
    assert_eq!(information(&refinement, &[0.0, 0.0]), None);
}

/// Of exact factors and leaves alone, the chain of the patches' exchange areas.
#[test]
fn exact_links_have_the_information_of_the_chain() {
    for name in ["lit-cube", "lit-hall"] {
        let scene = Scene::built_in(name).unwrap();
        let lighting = Lighting::of(&scene, Channel::Green).unwrap();
        let refinement =
            Refinement::try_new(&scene, lighting, Occlusion::Exact, Factors::Exact).unwrap();
        let radiosity = &refinement.solution().radiosity;
        let chain = brightness_chain(&scene.exchange_areas().unwrap(), radiosity).unwrap();
        let found = information(&refinement, radiosity).unwrap();
        // form factors are right to 1e-12 or so, relative to less than 3 bits
        let expected = mutual_information(&chain);
        assert!(
            (found - expected).abs() < 1e-10,
            "{name}: {found} {expected}"
        );
    }
}
