//! Random meshes of a lit room, with their light and their chain.
//!
//! Leaves are drawn at random and cut in quarters, the light's, too. The form factors between all
//! leaves are exact, so that neither links nor an oracle have a share in the error.

use super::rooms::Room;
use crate::chain::{ChainError, Refinement, ReversibleChain, brightness_chain};
use crate::hierarchy::Tree;
use crate::scene::{NamedPatch, Scene};
use crate::study::StudyError;
use crate::transport::RadiositySystem;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::ops::RangeInclusive;

/// The elements of a random mesh.
const ELEMENTS: RangeInclusive<usize> = 60..=100;

/// The largest share of cuts that fall on the light at will.
const MOST_ON_LIGHT: f64 = 0.5;

/// The leaves that are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Draw {
    /// All elements with equal probability.
    Alike,
    /// Elements of the light with a probability of their own in each mesh, up to one half together;
    /// the others among each other alike.
    LightAtWill,
}

/// A mesh with the radiosities of its leaves.
pub(super) struct RandomMesh {
    pub(super) tree: Tree,
    /// The radiosity of each element; 0 of those that are cut.
    pub(super) radiosity: Vec<f64>,
    /// Whether each leaf is a part of a light, in their order.
    pub(super) is_light: Vec<bool>,
    /// The chain of radiosity on the leaves.
    pub(super) chain: ReversibleChain,
    /// The chain of visibility on the leaves.
    pub(super) visibility: ReversibleChain,
}

impl RandomMesh {
    /// The mesh of a room with this seed.
    pub(super) fn try_new(room: &Room, draw: Draw, seed: u64) -> Result<Self, StudyError> {
        let tree = random_tree(room, draw, seed)?;
        let leaves: Vec<usize> = tree.leaves().collect();
        let patches = leaves.iter().map(|leaf| tree.elements()[*leaf].patch());
        let patches: Vec<usize> = patches.collect();
        let faces = leaves.iter().map(|leaf| {
            let shape = tree.elements()[*leaf].shape().clone();
            NamedPatch::new(leaf.to_string(), shape)
        });
        let exchange = Scene::try_new(faces.collect())?.exchange_areas()?;
        let of_leaves = |value: &dyn Fn(usize) -> f64| -> Vec<f64> {
            patches.iter().map(|patch| value(*patch)).collect()
        };
        let lighting = &room.lighting;
        let reflectances = of_leaves(&|patch| lighting.reflectance(patch));
        let system = RadiositySystem::with_reflectances(&exchange, reflectances)?;
        let solution = system.radiosity(&of_leaves(&|patch| lighting.emittance(patch)))?;
        let mut radiosity = vec![0.0; tree.elements().len()];
        for (leaf, value) in leaves.iter().zip(&solution.values) {
            radiosity[*leaf] = *value;
        }
        Ok(Self {
            chain: brightness_chain(&exchange, &solution.values)?,
            visibility: brightness_chain(&exchange, &vec![1.0; leaves.len()])?,
            is_light: patches.iter().map(|p| lighting.is_light(*p)).collect(),
            radiosity,
            tree,
        })
    }

    /// A chain on the leaves whose states of the light are merged into one, the first.
    pub(super) fn merged(&self, chain: &ReversibleChain) -> Result<ReversibleChain, ChainError> {
        let mut last = 0;
        let parents = self.is_light.iter().map(|is_light| {
            last += usize::from(!is_light);
            if *is_light { 0 } else { last }
        });
        let merged = Refinement::coarsening(chain.clone(), parents.collect())?;
        Ok(merged.coarse().clone())
    }
}

fn random_tree(room: &Room, draw: Draw, seed: u64) -> Result<Tree, StudyError> {
    let mut tree = Tree::new(room.scene.patches().iter().map(NamedPatch::shape));
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let elements = random.random_range(ELEMENTS);
    let on_light = random.random_range(0.0..MOST_ON_LIGHT);
    while tree.leaf_count() < elements {
        let is_lit = |leaf: &usize| room.lighting.is_light(tree.elements()[*leaf].patch());
        let drawn: Vec<usize> = match draw {
            Draw::Alike => tree.leaves().collect(),
            Draw::LightAtWill => {
                let is_light = random.random_bool(on_light);
                let leaves = tree.leaves();
                leaves.filter(|leaf| is_lit(leaf) == is_light).collect()
            }
        };
        tree.quarter(drawn[random.random_range(0..drawn.len())])?;
    }
    Ok(tree)
}
