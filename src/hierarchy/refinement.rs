//! Refinement: cut, link, solve, and again.
//!
//! Each round cuts the leaves that an oracle puts first, refines the links to what the larger mesh
//! needs, and solves anew from the light of the round before. Mesh and links are decided
//! separately.

use super::HierarchyError;
use super::black::black_irradiance;
use super::division::{Bisection, Division};
use super::exchange::deviations;
use super::lighting::Lighting;
use super::link::Links;
use super::link_factor::LinkFactors;
use super::linking::{Factors, Linking};
use super::oracle::Oracle;
use super::solution::{Mode, Solution, System};
use super::tree::Tree;
use super::view::{Asked, OracleCost, View};
use crate::exchange::{Closure, Congruence, ScenePairs};
use crate::form_factor::{DEFAULT_TOLERANCE, Polygon};
use crate::numeric::real;
use crate::scene::{Occlusion, Scene};
use std::collections::BinaryHeap;
use std::ops::Range;
use std::sync::OnceLock;

/// The error of a link over that of the whole, for so many elements.
const LINK_ERROR: f64 = 1.0 / 300.0;
/// The growth of a mesh in a round, as a fraction.
const GROWTH: [usize; 2] = [3, 2];
/// The elements of a mesh at most: with their links, some gigabytes.
const MOST_ELEMENTS: usize = 1 << 22;
/// The residuals to which a round, and the last solution, are solved.
const OF_A_ROUND: f64 = 1e-4;
const OF_THE_LAST: f64 = 1e-12;

/// The end of a refinement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Goal {
    /// So many elements, give or take the parts of one.
    Elements(usize),
    /// So many links at least.
    Links(usize),
    /// An estimated relative error of at most this.
    Error(f64),
}

/// A mesh with its links and its light, to be refined.
#[derive(Debug)]
pub struct Refinement<'s> {
    factors: LinkFactors<'s>,
    lighting: Lighting,
    mode: Mode,
    tree: Tree,
    links: Links,
    solution: Solution,
    evaluations: u64,
    division: Division,
    asked: Asked,
    /// Of exact factors, the polygons of elements.
    polygons: Vec<OnceLock<Polygon>>,
}

impl<'s> Refinement<'s> {
    /// The mesh of a scene's patches, linked and lit.
    ///
    /// # Errors
    /// [`HierarchyError::PatchInPatch`]; the refusals of the scene and of its light.
    pub fn try_new(
        scene: &'s Scene,
        lighting: Lighting,
        occlusion: Occlusion,
        factors: Factors,
    ) -> Result<Self, HierarchyError> {
        let patches = scene.patches().iter();
        for patch in 0..patches.len() {
            if let Some(base) = scene.base_of(patch) {
                return Err(HierarchyError::PatchInPatch { patch, base });
            }
        }
        let pairs = ScenePairs::try_new(scene, DEFAULT_TOLERANCE, Congruence::Shared, occlusion)?;
        let mode = Mode {
            factors,
            is_closed: Closure::of(&pairs)?.is_closed(),
        };
        let mut refinement = Self {
            factors: LinkFactors::try_new(scene, occlusion)?,
            tree: Tree::new(patches.map(|patch| patch.shape())),
            links: Links::default(),
            solution: Solution::dark(&lighting),
            lighting,
            mode,
            evaluations: 0,
            division: Division::default(),
            asked: Asked::default(),
            polygons: Vec::new(),
        };
        refinement.relink(None)?;
        refinement.solve(OF_A_ROUND)?;
        Ok(refinement)
    }

    /// The same, whose elements are cut in another way.
    #[must_use]
    pub const fn with_division(mut self, division: Division) -> Self {
        self.division = division;
        self
    }

    /// The mesh.
    #[must_use]
    pub const fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The links.
    #[must_use]
    pub const fn links(&self) -> &Links {
        &self.links
    }

    /// The light.
    #[must_use]
    pub const fn solution(&self) -> &Solution {
        &self.solution
    }

    /// The form factors between elements.
    #[must_use]
    pub const fn factors(&self) -> &LinkFactors<'s> {
        &self.factors
    }

    /// The materials.
    #[must_use]
    pub const fn lighting(&self) -> &Lighting {
        &self.lighting
    }

    /// The form factors of links that were computed so far.
    #[must_use]
    pub const fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// The form factors that oracles, and the search for cuts, asked for beyond those of links.
    #[must_use]
    pub fn oracle_cost(&self) -> OracleCost {
        self.asked.cost()
    }

    /// Refines until the goal is reached, and tells of each round.
    ///
    /// # Errors
    /// [`HierarchyError::FewerThanPatches`], [`HierarchyError::TooManyElements`]; the refusals of
    /// elements and of the light.
    pub fn refine(
        &mut self,
        oracle: &dyn Oracle,
        goal: Goal,
        told: &mut dyn FnMut(&Self),
    ) -> Result<(), HierarchyError> {
        self.check(goal)?;
        while !self.has_reached(goal) {
            let before = self.tree.leaf_count();
            let grown = (before * GROWTH[0]).div_ceil(GROWTH[1]);
            let most = match goal {
                Goal::Elements(elements) => elements.min(grown),
                Goal::Links(_) | Goal::Error(_) => grown,
            };
            if most > MOST_ELEMENTS {
                return Err(HierarchyError::TooManyElements {
                    most: MOST_ELEMENTS,
                });
            }
            self.cut(oracle, most)?;
            if self.tree.leaf_count() == before {
                break;
            }
            let weights = oracle.link_weights(&self.view())?;
            self.relink(weights.as_deref())?;
            self.solve(OF_A_ROUND)?;
            told(self);
        }
        self.solve(OF_THE_LAST)?;
        let black = black_irradiance(
            &self.tree,
            &self.links,
            &self.lighting,
            &self.factors,
            &self.solution.radiosity,
        )?;
        for (patch, irradiance) in black.into_iter().enumerate() {
            if self.lighting.reflectance(patch) <= 0.0 {
                self.solution.received.irradiance[patch] = irradiance;
            }
        }
        Ok(())
    }

    /// Refuses a number of elements that no mesh has.
    fn check(&self, goal: Goal) -> Result<(), HierarchyError> {
        let (patches, most) = (self.tree.patches(), MOST_ELEMENTS);
        match goal {
            Goal::Elements(elements) if elements < patches => {
                Err(HierarchyError::FewerThanPatches { elements, patches })
            }
            Goal::Elements(elements) if elements > most => {
                Err(HierarchyError::TooManyElements { most })
            }
            _ => Ok(()),
        }
    }

    fn has_reached(&self, goal: Goal) -> bool {
        match goal {
            Goal::Elements(elements) => self.tree.leaf_count() >= elements,
            Goal::Links(links) => self.links.count() >= links,
            Goal::Error(error) => self.error_estimate() <= error,
        }
    }

    /// An estimate of `‖B − B_h‖/‖B‖` over all that is not light, for constants on the leaves: what
    /// a radiosity with the gradients found differs from its means.
    #[must_use]
    pub fn error_estimate(&self) -> f64 {
        let elements = self.tree.elements().iter().enumerate();
        let leaves = elements.filter(|(_, e)| e.is_leaf() && !self.lighting.is_light(e.patch()));
        let squares = leaves.map(|(leaf, element)| {
            let slope = self.solution.gradient(&self.tree, &self.lighting, leaf);
            element.norm_of_linear(slope).powi(2)
        });
        let (error, norm) = (squares.sum::<f64>().sqrt(), self.norm());
        // where all that is there is light, nothing is to be measured
        if norm > 0.0 { error / norm } else { 0.0 }
    }

    /// Cuts the leaves that come first until there are so many.
    fn cut(&mut self, oracle: &dyn Oracle, elements: usize) -> Result<(), HierarchyError> {
        let view = self.view();
        let can_gain = |leaf: &usize| {
            let patch = view.element(*leaf).patch();
            let is_ranked = oracle.cuts_lights() && view.lighting.is_light(patch);
            is_ranked || view.lighting.reflectance(patch) > 0.0
        };
        let leaves: Vec<usize> = self.tree.leaves().filter(can_gain).collect();
        let priorities = oracle.priorities(&view, &leaves)?;
        let ranked = leaves.into_iter().zip(priorities);
        let ranked = ranked.filter(|(_, priority)| *priority > 0.0);
        let mut heap: BinaryHeap<Ranked> = ranked
            .map(|(leaf, p)| Ranked { priority: p, leaf })
            .collect();
        while self.tree.leaf_count() < elements {
            let Some(first) = heap.pop() else { break };
            let children = self.divide(first.leaf)?;
            let whole = self.tree.elements()[first.leaf].shape().area();
            for leaf in children {
                let share = self.tree.elements()[leaf].shape().area() / whole;
                heap.push(Ranked {
                    priority: first.priority * share,
                    leaf,
                });
            }
        }
        self.guess();
        Ok(())
    }

    fn divide(&mut self, leaf: usize) -> Result<Range<usize>, HierarchyError> {
        let Division::Bisection(criterion) = self.division else {
            return self.tree.quarter(leaf);
        };
        let Bisection { axis, position } = criterion.cut(&self.view(), leaf)?;
        self.tree.bisect(leaf, axis, position)
    }

    /// Gives new elements the light that the old ones expect of them.
    fn guess(&mut self) {
        let elements = self.tree.elements();
        let (light, radiosity) = (&mut self.solution.received, &mut self.solution.radiosity);
        for index in radiosity.len()..elements.len() {
            let element = &elements[index];
            let Some(parent) = element.parent() else {
                continue;
            };
            let (slope, patch) = (light.gradient[parent], element.patch());
            let above = slope.dot(element.centre() - elements[parent].centre());
            light.irradiance.push(light.irradiance[parent] + above);
            light.gradient.push(slope);
            let reflected = self.lighting.reflectance(patch) * above;
            radiosity.push((radiosity[parent] + reflected).max(0.0));
        }
    }

    /// Makes the links that the mesh needs, from those that there are; errors count by `weights`.
    fn relink(&mut self, weights: Option<&[f64]>) -> Result<(), HierarchyError> {
        let elements = self.tree.elements().len();
        let is_exact = self.mode.factors == Factors::Exact;
        if is_exact {
            self.polygons.resize_with(elements, OnceLock::new);
        }
        let linking = Linking {
            tree: &self.tree,
            lighting: &self.lighting,
            factors: &self.factors,
            polygons: is_exact.then_some(self.polygons.as_slice()),
            radiosity: &self.solution.radiosity,
            deviations: &deviations(&self.tree, &self.solution.radiosity),
            weights,
            tolerance: LINK_ERROR * self.norm() / real(self.tree.leaf_count()).powf(0.75),
        };
        let linked = match self.links.count() {
            0 => linking.between_patches()?,
            _ => linking.refined(&self.links)?,
        };
        self.links = Links::new(linked.links, linked.sights, elements);
        self.evaluations += linked.evaluations;
        Ok(())
    }

    fn solve(&mut self, reduction: f64) -> Result<(), HierarchyError> {
        let system = System::new(&self.tree, &self.links, &self.lighting, self.mode);
        self.solution = system.solve(&self.solution.radiosity, reduction)?;
        Ok(())
    }

    /// The norm of the radiosity over all that is not light.
    fn norm(&self) -> f64 {
        let elements = self.tree.elements().iter().enumerate();
        let leaves = elements.filter(|(_, e)| e.is_leaf() && !self.lighting.is_light(e.patch()));
        let squares = leaves.map(|(i, e)| e.shape().area() * self.solution.radiosity[i].powi(2));
        squares.sum::<f64>().sqrt()
    }

    /// What an oracle sees now.
    #[must_use]
    pub const fn view(&self) -> View<'_> {
        View {
            tree: &self.tree,
            links: &self.links,
            lighting: &self.lighting,
            solution: &self.solution,
            mode: self.mode,
            factors: &self.factors,
            asked: &self.asked,
        }
    }
}

/// A leaf with its priority; of equal ones, the leaf that comes first.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ranked {
    priority: f64,
    leaf: usize,
}

impl Eq for Ranked {}

impl PartialOrd for Ranked {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ranked {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        let by_priority = self.priority.total_cmp(&other.priority);
        by_priority.then(other.leaf.cmp(&self.leaf))
    }
}
