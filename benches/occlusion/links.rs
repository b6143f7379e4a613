//! Links of hierarchical radiosity: the mean time of a form factor by what stands between.

use crate::{fastest, textbook_seconds};
use infoscene::hierarchy::{Element, LinkFactors, Tree, Visibility};
use infoscene::scene::{NamedPatch, Occlusion, Scene};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::hint::black_box;

/// The name of these lines.
pub(crate) const NAME: &str = "links";

const SCENES: [&str; 5] = [
    "lit-cube",
    "shaded-cube",
    "shaded-cube-low",
    "lit-wings",
    "room",
];

/// Times the links of some scenes, or checks that they are what their pairs are.
pub(crate) fn print(room: &Scene, is_test: bool) {
    let textbook = textbook_seconds();
    for name in SCENES {
        let built_in = Scene::built_in(name);
        let scene = built_in.as_ref().unwrap_or(room);
        let mut tree = Tree::new(scene.patches().iter().map(NamedPatch::shape));
        for _ in 0..3 {
            for leaf in tree.leaves().collect::<Vec<_>>() {
                tree.quarter(leaf).unwrap();
            }
        }
        let links = LinkFactors::try_new(scene, Occlusion::Exact).unwrap();
        let found = sorted(&links, &tree, if is_test { 50 } else { 4000 });
        if is_test {
            continue;
        }
        let all: Vec<_> = found.iter().flatten().copied().collect();
        let [clear, past, hidden] = &found;
        for (kind, pairs) in [
            ("all", &all),
            ("clear", clear),
            ("past", past),
            ("none", hidden),
        ] {
            let run = || {
                for [to, from] in pairs {
                    black_box(links.between(to, from)).unwrap();
                }
            };
            let count = u32::try_from(pairs.len()).unwrap().max(1);
            let seconds = fastest(10, 1, run) / f64::from(count);
            println!(
                "{NAME}, {name}: {kind}, {} pairs, {:.0} ns, {:.2} × textbook",
                pairs.len(),
                seconds * 1e9,
                seconds / textbook
            );
        }
    }
}

/// Random pairs of elements with links that are clear, past something, or none.
fn sorted<'t>(links: &LinkFactors, tree: &'t Tree, count: usize) -> [Vec<[&'t Element; 2]>; 3] {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let elements = tree.elements();
    let mut found = [const { Vec::new() }; 3];
    while found.iter().map(Vec::len).sum::<usize>() < count {
        let [to, from] = [(); 2].map(|()| &elements[random.random_range(0..elements.len())]);
        let known = links.visibility(to.patch(), from.patch());
        let kind = match links.between_parts(to, from, known).unwrap() {
            Some((link, visibility)) => {
                assert!((0.0..=1.0).contains(&link.value));
                usize::from(visibility != Visibility::Clear)
            }
            None => 2,
        };
        found[kind].push([to, from]);
    }
    found
}
