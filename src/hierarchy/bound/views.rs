//! The leaves of a tree as the patches of a scene see them.

use super::frame::Frame;
use super::leaf::Leaf;
use super::seen::Seen;
use super::sight::{End, Sight};
use super::sources::{Source, outlines};
use crate::form_factor::{FormFactorError, Polygon};
use crate::geometry::{Patch, quartered};
use crate::hierarchy::{Element, Lighting, Tree, Visibility};
use crate::numeric::parallel_map;
use crate::scene::Scene;
use glam::{DVec2, DVec3};
use smallvec::SmallVec;

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
    /// What may stand between it and the patch.
    pub(super) plates: SmallVec<[u32; 4]>,
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
            polygon: Polygon::new(element.shape()),
            parts: match sight.can_be_hidden() {
                true => parts(element.shape()),
                false => Vec::new(),
            },
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

    /// What [`Self::irradiance`] may be off at most, as leaves are seen in part.
    ///
    /// # Errors
    /// As [`Sight::bounded_form_factor`].
    pub(super) fn doubt(
        &self,
        patch: usize,
        point: DVec3,
        values: &[f64],
    ) -> Result<f64, FormFactorError> {
        let Some(view) = self.view(patch) else {
            return Ok(0.0);
        };
        let here = [point, view.frame.normal()];
        let mut sum = 0.0;
        for veiled in &view.veiled {
            if let Visibility::Past(plates) = self.between(view, &[point], veiled) {
                let leaf = &self.leaves[veiled.leaf];
                let about = self.sight.form_factor(here, &leaf.shape, &plates);
                let found = self
                    .sight
                    .bounded_form_factor(here, &leaf.polygon, &plates)?;
                sum += values[veiled.leaf].abs() * ((about - found.value).abs() + found.error);
            }
        }
        Ok(sum)
    }

    /// The shares of the leaves' form factors that a point sees, about.
    pub(super) fn shares(&self, view: &View, point: DVec3) -> Vec<f64> {
        let here = [point, view.frame.normal()];
        let mut shares = vec![1.0; self.leaves.len()];
        for veiled in &view.veiled {
            shares[veiled.leaf] = match self.between(view, &[point], veiled) {
                Visibility::Clear => 1.0,
                Visibility::Hidden => 0.0,
                Visibility::Past(plates) => {
                    let shape = &self.leaves[veiled.leaf].shape;
                    let whole = veiled.seen.factor(view.frame.flat(point));
                    let part = self.sight.form_factor(here, shape, &plates);
                    if whole > 0.0 { part / whole } else { 0.0 }
                }
            };
        }
        shares
    }

    /// What stands between points of a view's plane and a leaf.
    pub(super) fn between(&self, view: &View, corners: &[DVec3], veiled: &Veiled) -> Visibility {
        let leaf = &self.leaves[veiled.leaf];
        let there = End::of(leaf.patch, &leaf.shape);
        self.narrowed(view, corners, there, &veiled.plates)
    }

    /// What stands between points of a view's plane and a polygon, if nothing but these plates
    /// does.
    pub(super) fn narrowed(
        &self,
        view: &View,
        corners: &[DVec3],
        there: End<'_>,
        plates: &[u32],
    ) -> Visibility {
        let here = End {
            patch: view.patch,
            corners,
            normal: view.frame.normal(),
        };
        self.sight.narrowed(plates, [here, there])
    }
}

/// The quarters of a shape's quarters, as far as it can be cut.
fn parts(shape: &Patch) -> Vec<Patch> {
    let quarters = |shape: &Patch| quartered(shape).unwrap_or_else(|_| vec![shape.clone()]);
    quarters(shape).iter().flat_map(quarters).collect()
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
            let Visibility::Past(plates) = sight.of_patches(patch, leaf.patch) else {
                return None;
            };
            Some(Veiled {
                leaf: index,
                plates: plates.clone(),
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
