//! The view that an oracle has of a refinement, and what it may ask beyond it.
//!
//! Links hold the form factors of centres. What a view computes anew, form factors of other points
//! and of whole parts, is counted ([`Asked`]): it is the price of an oracle.
//!
//! ```text
//!   H(x) = Σ_j F_j(x) B_j          j: sources of the links of a leaf and of all elements around it
//! ```

use super::HierarchyError;
use super::lighting::Lighting;
use super::link::{Link, Links};
use super::link_factor::{LinkFactors, Visibility};
use super::solution::{Mode, Solution, System};
use super::tree::{Element, Tree};
use crate::form_factor::Polygon;
use crate::geometry::{Patch, quartered};
use glam::DVec3;
use std::sync::atomic::{AtomicU64, Ordering};

/// The relative error of form factors between whole parts.
const PAIR_TOLERANCE: f64 = 1e-6;

/// The residual to which other equilibria on the same links are solved.
const REDUCTION: f64 = 1e-6;

/// The form factors that were computed beyond those of links.
#[derive(Debug, Default)]
pub(super) struct Asked {
    points: AtomicU64,
    pairs: AtomicU64,
}

impl Asked {
    /// The cost so far.
    pub(super) fn cost(&self) -> OracleCost {
        OracleCost {
            points: self.points.load(Ordering::Relaxed),
            pairs: self.pairs.load(Ordering::Relaxed),
        }
    }
}

/// The form factors that an oracle asked for, beyond those of links.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OracleCost {
    /// Form factors from a point to an element, and kernels between two points.
    pub points: u64,
    /// Integrals over a pair of polygons.
    pub pairs: u64,
}

/// The mesh, the links and the light that an oracle looks at.
#[derive(Debug, Clone, Copy)]
pub struct View<'v> {
    /// The mesh.
    pub tree: &'v Tree,
    /// The links.
    pub links: &'v Links,
    /// The materials.
    pub lighting: &'v Lighting,
    /// The light.
    pub solution: &'v Solution,
    pub(super) mode: Mode,
    pub(super) factors: &'v LinkFactors<'v>,
    pub(super) asked: &'v Asked,
}

impl<'v> View<'v> {
    /// An element.
    #[must_use]
    pub fn element(&self, index: usize) -> &'v Element {
        &self.tree.elements()[index]
    }

    /// The mean radiosity of an element.
    #[must_use]
    pub fn radiosity(&self, index: usize) -> f64 {
        self.solution.radiosity[index]
    }

    /// The reflectance of an element.
    #[must_use]
    pub fn reflectance(&self, index: usize) -> f64 {
        self.lighting.reflectance(self.element(index).patch())
    }

    /// The emittance of an element.
    #[must_use]
    pub fn emittance(&self, index: usize) -> f64 {
        self.lighting.emittance(self.element(index).patch())
    }

    /// An element, then all elements around it, up to its patch.
    pub fn path(&self, index: usize) -> impl Iterator<Item = usize> + 'v {
        let view = *self;
        std::iter::successors(Some(index), move |at| view.element(*at).parent())
    }

    /// The links through which an element receives: its own, then those of elements around it.
    pub fn links_of(&self, index: usize) -> impl Iterator<Item = &'v Link> + 'v {
        let links = self.links;
        self.path(index).flat_map(|at| links.of(at))
    }

    /// The same links, each with what stands between its ends.
    pub(super) fn sights_of(
        &self,
        index: usize,
    ) -> impl Iterator<Item = (&'v Link, &'v Visibility)> + 'v {
        let links = self.links;
        self.path(index)
            .flat_map(|at| links.of(at).iter().zip(links.sights_of(at)))
    }

    /// The form factor from an element's centre to the source of one of its links, as the link
    /// knows it.
    #[must_use]
    pub fn at_centre(&self, index: usize, link: &Link) -> f64 {
        let from = self.element(link.receiver as usize).centre();
        link.at(self.element(index).centre() - from)
    }

    /// The form factors from a point of an element to the sources of its links, in their order.
    ///
    /// # Errors
    /// [`HierarchyError::FormFactor`].
    pub fn factors_at(&self, index: usize, point: DVec3) -> Result<Vec<f64>, HierarchyError> {
        let normal = self.element(index).shape().normal();
        let factors = self.sights_of(index).map(|(link, sight)| {
            let source = self.element(link.source as usize);
            self.factors.from_point(point, normal, source, sight)
        });
        let factors: Vec<f64> = factors.collect::<Result<_, _>>()?;
        self.count_points(factors.len());
        Ok(factors)
    }

    /// The irradiance of a point of an element, `Σ_j F_j(x) B_j`.
    ///
    /// # Errors
    /// [`HierarchyError::FormFactor`].
    pub fn received_at(&self, index: usize, point: DVec3) -> Result<f64, HierarchyError> {
        let factors = self.factors_at(index, point)?;
        Ok(self.gathered(index, &factors))
    }

    /// The mean form factors from a part of an element to the sources of its links, in their order.
    ///
    /// # Errors
    /// [`HierarchyError::FormFactor`].
    pub fn mean_factors(&self, index: usize, part: &Patch) -> Result<Vec<f64>, HierarchyError> {
        let receiver = Polygon::new(part);
        let factors = self.sights_of(index).map(|(link, sight)| {
            let source = Polygon::new(self.element(link.source as usize).shape());
            let ends = [&receiver, &source];
            let exchange = self.factors.exchange_area(ends, sight, PAIR_TOLERANCE)?;
            Ok(exchange.value / part.area())
        });
        let factors: Vec<f64> = factors.collect::<Result<_, HierarchyError>>()?;
        self.count_pairs(factors.len());
        Ok(factors)
    }

    /// The irradiance that these form factors to the sources of an element's links bring.
    #[must_use]
    pub fn gathered(&self, index: usize, factors: &[f64]) -> f64 {
        let links = self.links_of(index).zip(factors);
        links
            .map(|(link, factor)| factor * self.radiosity(link.source as usize))
            .sum()
    }

    /// The parts of an element, were it cut ([`quartered`]).
    ///
    /// # Errors
    /// [`HierarchyError::Element`] if a part is too small for `f64`.
    pub fn quarters(&self, index: usize) -> Result<Vec<Patch>, HierarchyError> {
        let parts = quartered(self.element(index).shape());
        parts.map_err(|source| HierarchyError::Element {
            element: index,
            source,
        })
    }

    /// The equilibrium of other light on the same mesh and links.
    ///
    /// # Errors
    /// [`HierarchyError::NotConverged`].
    pub fn equilibrium(&self, lighting: &Lighting) -> Result<Solution, HierarchyError> {
        let system = System::new(self.tree, self.links, lighting, self.mode);
        system.solve(&vec![0.0; self.tree.elements().len()], REDUCTION)
    }

    /// Counts form factors of points.
    pub(super) fn count_points(&self, count: usize) {
        self.asked.points.fetch_add(count as u64, Ordering::Relaxed);
    }

    /// Counts integrals over pairs.
    pub(super) fn count_pairs(&self, count: usize) {
        self.asked.pairs.fetch_add(count as u64, Ordering::Relaxed);
    }
}
