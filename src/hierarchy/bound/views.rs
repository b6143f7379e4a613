//! The leaves of a tree as the patches of a scene see them.

use super::frame::Frame;
use super::leaf::Leaf;
use super::seen::Seen;
use super::sight::{Between, End, Sight};
use super::sources::{Source, outlines};
use crate::hierarchy::{Element, Lighting, Tree, Visibility};
use crate::numeric::parallel_map;
use crate::scene::Scene;
use glam::{DVec2, DVec3};

/// The plane of a patch, and what is above it.
#[derive(Debug, Clone)]
pub(super) struct View {
    pub(super) frame: Frame,
    pub(super) sources: Vec<Source>,
    /// The leaves before which something may stand.
    pub(super) veiled: Vec<Veiled>,
    patch: usize,
}

/// A leaf before which something may stand.
#[derive(Debug, Clone)]
pub(super) struct Veiled {
    pub(super) leaf: usize,
    pub(super) seen: Seen,
    /// Its sources, each with the side on which it is: left, right.
    pub(super) sources: Vec<(usize, [f64; 2])>,
}

/// The leaves, and by patch its view; none for a patch that reflects nothing.
#[derive(Debug, Clone)]
pub(super) struct Views {
    pub(super) leaves: Vec<Leaf>,
    pub(super) sight: Sight,
    views: Vec<Option<View>>,
}

impl Views {
    /// The views of a scene's patches.
    pub(super) fn of(scene: &Scene, tree: &Tree, light: &Lighting, sight: &Sight) -> Self {
        let elements: Vec<&Element> = tree.leaves().map(|leaf| &tree.elements()[leaf]).collect();
        let polygons: Vec<&[DVec3]> = elements.iter().map(|e| e.shape().corners()).collect();
        let leaf = |(element, outline): (&&Element, Vec<DVec3>)| Leaf {
            shape: element.shape().clone(),
            outline,
            centre: element.centre(),
            patch: element.patch(),
        };
        let outlines = outlines(&polygons);
        let leaves: Vec<Leaf> = elements.iter().zip(outlines).map(leaf).collect();
        let views = parallel_map(scene.patches().len(), &|patch| {
            (light.reflectances()[patch] > 0.0).then(|| View::new(scene, patch, &leaves, sight))
        });
        Self {
            leaves,
            views,
            sight: sight.clone(),
        }
    }

    /// The view of a patch; none if it reflects nothing.
    pub(super) fn view(&self, patch: usize) -> Option<&View> {
        self.views[patch].as_ref()
    }

    /// Whether something may stand before a leaf.
    pub(super) fn is_veiled(&self) -> bool {
        let mut views = self.views.iter().flatten();
        views.any(|view| !view.veiled.is_empty())
    }

    /// The irradiance at a point of a patch, for these radiosities of leaves, about.
    pub(super) fn irradiance(&self, patch: usize, point: DVec3, values: &[f64]) -> f64 {
        self.view(patch).map_or(0.0, |view| {
            let (at, shares) = (view.frame.flat(point), self.shares(view, point));
            let terms = view.sources.iter();
            terms
                .map(|source| source.weight(values, 0.0, source.sides(&shares)) * source.factor(at))
                .sum()
        })
    }

    /// What [`Self::irradiance`] may be off at most, as leaves are hidden or not.
    pub(super) fn doubt(&self, patch: usize, point: DVec3, values: &[f64]) -> f64 {
        self.view(patch).map_or(0.0, |view| {
            let at = view.frame.flat(point);
            let veiled = view.veiled.iter();
            let doubtful = veiled.filter(|v| self.between(view, &[point], v) == Between::Perhaps);
            let part = |v: &Veiled| 0.5 * v.seen.factor(at) * values[v.leaf].abs();
            doubtful.map(part).sum()
        })
    }

    /// The parts of the leaves that a point sees, about: a half where it is not known.
    pub(super) fn shares(&self, view: &View, point: DVec3) -> Vec<f64> {
        let mut shares = vec![1.0; self.leaves.len()];
        for veiled in &view.veiled {
            shares[veiled.leaf] = match self.between(view, &[point], veiled) {
                Between::Nothing => 1.0,
                Between::All => 0.0,
                Between::Perhaps => 0.5,
            };
        }
        shares
    }

    /// What stands between points of a view's plane and a leaf.
    pub(super) fn between(&self, view: &View, corners: &[DVec3], veiled: &Veiled) -> Between {
        let leaf = &self.leaves[veiled.leaf];
        let here = End {
            patch: view.patch,
            corners,
            normal: view.frame.normal(),
        };
        self.sight.between([here, End::of(leaf.patch, &leaf.shape)])
    }
}

impl View {
    fn new(scene: &Scene, patch: usize, leaves: &[Leaf], sight: &Sight) -> Self {
        let (shape, noise) = (scene.patches()[patch].shape(), scene.noise_length());
        let frame = Frame::of(shape);
        let base: Vec<DVec2> = shape.corners().iter().map(|c| frame.flat(*c)).collect();
        let seen = || {
            let leaves = leaves.iter().enumerate();
            leaves.filter(|(_, leaf)| *sight.of_patches(patch, leaf.patch) != Visibility::Hidden)
        };
        let sources = Source::all(seen(), &frame, &base, noise);
        let mut of_leaf = vec![Vec::new(); leaves.len()];
        for (index, source) in sources.iter().enumerate() {
            of_leaf[source.left].push((index, [1.0, 0.0]));
            if let Some(right) = source.right {
                of_leaf[right].push((index, [0.0, 1.0]));
            }
        }
        let veiled = seen().filter_map(|(index, leaf)| {
            if *sight.of_patches(patch, leaf.patch) == Visibility::Clear {
                return None;
            }
            Some(Veiled {
                leaf: index,
                seen: Seen::of(&leaf.shape, &leaf.outline, &frame, noise)?,
                sources: of_leaf[index].clone(),
            })
        });
        Self {
            veiled: veiled.collect(),
            frame,
            sources,
            patch,
        }
    }
}
