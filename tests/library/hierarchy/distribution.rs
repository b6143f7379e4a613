//! What ranks would hold and send if tree and links were shared out among them: the counts behind
//! the plan in `hierarchy`.

use super::refined;
use infoscene::hierarchy::{Factors, Lighting, Link, OracleName, Refinement, Visibility};
use infoscene::scene::{Channel, Occlusion, Scene};
use std::collections::BTreeSet;

/// The counts of one mesh on so many ranks, of which each has consecutive patches with their trees,
/// and the links that these receive by.
struct Shares {
    /// The most and the mean of links that a rank has.
    links: [usize; 2],
    /// The most and the mean of elements of others that a rank's links read.
    read: [usize; 2],
}

/// The rank of each patch: so many links come before it that ranks have about equally many.
fn ranks_of(room: &Refinement<'_>, ranks: usize) -> Vec<usize> {
    let (tree, links) = (room.tree(), room.links());
    let mut of_patch = vec![0; tree.patches()];
    for (index, element) in tree.elements().iter().enumerate() {
        of_patch[element.patch()] += links.of(index).len();
    }
    let mut before = 0;
    let rank = |count: &usize| {
        let rank = (before + count / 2) * ranks / links.count().max(1);
        before += count;
        rank.min(ranks - 1)
    };
    of_patch.iter().map(rank).collect()
}

fn shares(room: &Refinement<'_>, ranks: usize) -> Shares {
    let of_patch = ranks_of(room, ranks);
    let elements = room.tree().elements();
    let rank = |element: u32| of_patch[elements[element as usize].patch()];
    let (mut held, mut read) = (vec![0; ranks], vec![BTreeSet::new(); ranks]);
    for link in room.links().all() {
        let own = rank(link.receiver);
        held[own] += 1;
        if rank(link.source) != own {
            read[own].insert(link.source);
        }
    }
    let read: Vec<usize> = read.iter().map(BTreeSet::len).collect();
    let summary = |counts: &[usize]| {
        let most = counts.iter().copied().max().unwrap();
        [most, counts.iter().sum::<usize>() / counts.len()]
    };
    Shares {
        links: summary(&held),
        read: summary(&read),
    }
}

/// All links are held once, one rank reads nothing of others, and no rank reads more than all
/// elements.
#[test]
#[ignore = "prints counts, a minute: cargo test --release --test library distribution -- --ignored \
            --nocapture"]
fn counts_of_a_distribution() {
    println!(
        "a link {} bytes, what it knows of what is in the way {} more",
        size_of::<Link>(),
        size_of::<Visibility>()
    );
    for (name, subdivide) in [("lit-cube", 2), ("cornell-box-blocks", 2)] {
        let scene = Scene::built_in(name).unwrap();
        let (scene, _) = scene.subdivided(subdivide).unwrap();
        let lighting = Lighting::of(&scene, Channel::Green).unwrap();
        for elements in [1_000, 4_000, 16_000] {
            let light = lighting.clone();
            let factors = Factors::OfPoints;
            let room = Refinement::try_new(&scene, light, Occlusion::Exact, factors).unwrap();
            let room = refined(room, OracleName::Gradient, elements);
            let (tree, links) = (room.tree(), room.links().count());
            println!(
                "{name}: {} patches, {} elements, {links} links, {} a patch, {:.1} a leaf",
                tree.patches(),
                tree.elements().len(),
                links / tree.patches(),
                links as f64 / tree.leaf_count() as f64
            );
            for ranks in [1, 4, 16] {
                let shares = shares(&room, ranks);
                assert_eq!(shares.links[1], links / ranks);
                assert!(shares.read[0] <= tree.elements().len());
                assert!(ranks > 1 || shares.read == [0, 0]);
                println!(
                    "  {ranks} ranks: at most {} links, mean {}; at most {} elements of others, mean {}",
                    shares.links[0], shares.links[1], shares.read[0], shares.read[1]
                );
            }
        }
    }
}
