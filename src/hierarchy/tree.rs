//! A tree of elements: the patches of a scene, and what they are cut into.
//!
//! The roots are the patches, in order. The children of an element stand together, after all that
//! was there before them; they have its normal and, together, its area. Leaves carry the solution.
//!
//! **Not covered**: patches that lie in another one.

use super::HierarchyError;
use crate::geometry::{CutLines, GeometryError, Patch, SplitAxis, centroid, is_inside, quartered};
use crate::numeric::real;
use glam::DVec3;
use std::f64::consts::TAU;
use std::ops::Range;

/// The ratio of sides beyond which a quadrilateral is halved first: its halves are nearer to
/// squares than itself.
const ELONGATED: f64 = std::f64::consts::SQRT_2;

/// A planar piece of one patch.
#[derive(Debug, Clone)]
pub struct Element {
    shape: Patch,
    centre: DVec3,
    radius: f64,
    patch: usize,
    parent: Option<usize>,
    children: Range<usize>,
}

impl Element {
    fn new(shape: Patch, patch: usize, parent: Option<usize>) -> Self {
        let centre = centroid(&shape);
        let distances = shape.corners().iter().map(|c| c.distance(centre));
        Self {
            radius: distances.fold(0.0, f64::max),
            shape,
            centre,
            patch,
            parent,
            children: 0..0,
        }
    }

    /// The polygon.
    #[must_use]
    pub const fn shape(&self) -> &Patch {
        &self.shape
    }

    /// The centre of gravity.
    #[must_use]
    pub const fn centre(&self) -> DVec3 {
        self.centre
    }

    /// The distance from the centre to the farthest corner.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The patch of which it is a piece.
    #[must_use]
    pub const fn patch(&self) -> usize {
        self.patch
    }

    /// The element of which it is a piece, if any.
    #[must_use]
    pub const fn parent(&self) -> Option<usize> {
        self.parent
    }

    /// The elements that it was cut into; none for a leaf.
    #[must_use]
    pub fn children(&self) -> Range<usize> {
        self.children.clone()
    }

    /// The norm in L2 of `g·(x − c)` over the element, c its centre: exact for triangles and
    /// parallelograms, near it for other convex polygons.
    ///
    /// ```text
    ///   ∫ (g·(x − c))² dx = A/12 Σ_v (g·(v − c))²        v: corners
    /// ```
    #[must_use]
    pub fn norm_of_linear(&self, gradient: DVec3) -> f64 {
        let corners = self.shape.corners().iter();
        let squares = corners.map(|corner| gradient.dot(*corner - self.centre).powi(2));
        (self.shape.area() / 12.0 * squares.sum::<f64>()).sqrt()
    }

    /// Points, one towards each corner, over which the mean of a quadratic is that over the
    /// element: exact for triangles and parallelograms, near it for other convex polygons.
    ///
    /// ```text
    ///   x = c + s (v − c),   s² = (2 + cos(2π/n))/6        v: the n corners
    /// ```
    ///
    /// In a rectangle they are the 2 × 2 Gauss points.
    pub fn gauss_points(&self) -> impl Iterator<Item = DVec3> + '_ {
        let corners = self.shape.corners();
        let share = ((2.0 + (TAU / real(corners.len())).cos()) / 6.0).sqrt();
        corners
            .iter()
            .map(move |corner| self.centre + (*corner - self.centre) * share)
    }

    /// Is it a leaf, which carries the solution?
    #[must_use]
    pub fn is_leaf(&self) -> bool {
        self.children.is_empty()
    }
}

/// The elements of a scene's patches.
#[derive(Debug, Clone)]
pub struct Tree {
    elements: Vec<Element>,
    patches: usize,
    leaves: usize,
}

impl Tree {
    /// The tree of patches that are not cut yet.
    #[must_use]
    pub fn new<'p>(patches: impl IntoIterator<Item = &'p Patch>) -> Self {
        let patches = patches.into_iter().enumerate();
        let roots = patches.map(|(patch, shape)| Element::new(shape.clone(), patch, None));
        let elements: Vec<Element> = roots.collect();
        Self {
            patches: elements.len(),
            leaves: elements.len(),
            elements,
        }
    }

    /// All elements: the patches, then pieces, each after what it is a piece of.
    #[must_use]
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// The number of patches, which are the first elements.
    #[must_use]
    pub const fn patches(&self) -> usize {
        self.patches
    }

    /// The number of leaves.
    #[must_use]
    pub const fn leaf_count(&self) -> usize {
        self.leaves
    }

    /// The leaves, as indices of elements, in their order.
    pub fn leaves(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.elements.len()).filter(|index| self.elements[*index].is_leaf())
    }

    /// Cuts a leaf into parts of its kind ([`quartered`]), or an elongated quadrilateral into
    /// halves across its length.
    ///
    /// # Errors
    /// [`HierarchyError::Element`] if a part is too small for `f64`.
    pub fn quarter(&mut self, element: usize) -> Result<Range<usize>, HierarchyError> {
        let shape = self.elements[element].shape();
        let parts = match long_side(shape.corners()) {
            Some(side) => halved(shape, side),
            None => quartered(shape),
        };
        let parts = parts.map_err(|source| HierarchyError::Element { element, source })?;
        Ok(self.cut(element, parts))
    }

    /// Cuts a leaf in two across an axis, at a relative position ([`CutLines`]); a concave polygon
    /// into more.
    ///
    /// # Errors
    /// [`HierarchyError::Element`] if the position is not between 0 and 1, or a part is too small
    /// for `f64`.
    pub fn bisect(
        &mut self,
        element: usize,
        axis: SplitAxis,
        position: f64,
    ) -> Result<Range<usize>, HierarchyError> {
        let parts = CutLines::try_new(self.elements[element].shape(), axis).and_then(|lines| {
            let mut parts = lines.part(0.0, position)?;
            parts.extend(lines.part(position, 1.0)?);
            Ok(parts)
        });
        let parts = parts.map_err(|source| HierarchyError::Element { element, source })?;
        Ok(self.cut(element, parts))
    }

    /// The leaf of a patch inside which a point of its plane lies; none outside, and on outlines.
    #[must_use]
    pub fn leaf_at(&self, patch: usize, point: DVec3) -> Option<usize> {
        let contains = |index: usize| is_inside(point, self.elements[index].shape());
        let mut at = Some(patch).filter(|patch| contains(*patch))?;
        while !self.elements[at].is_leaf() {
            let mut children = self.elements[at].children();
            at = children.find(|child| contains(*child))?;
        }
        Some(at)
    }

    /// Cuts a leaf into these parts, which make it up.
    pub(super) fn cut(&mut self, element: usize, parts: Vec<Patch>) -> Range<usize> {
        debug_assert!(self.elements[element].is_leaf(), "cut once only");
        let first = self.elements.len();
        let patch = self.elements[element].patch;
        self.leaves += parts.len() - 1;
        for part in parts {
            let part = Element::new(part, patch, Some(element));
            self.elements.push(part);
        }
        let children = first..self.elements.len();
        self.elements[element].children = children.clone();
        children
    }
}

/// The first of the two long sides of a convex quadrilateral, if it is elongated.
fn long_side(corners: &[DVec3]) -> Option<usize> {
    let [a, b, c, d] = *corners else { return None };
    let lengths = [a.distance(b) + c.distance(d), b.distance(c) + d.distance(a)];
    if lengths[0] > ELONGATED * lengths[1] {
        return Some(0);
    }
    (lengths[1] > ELONGATED * lengths[0]).then_some(1)
}

/// The halves of a quadrilateral, cut between the middles of a side and of the opposite one.
fn halved(shape: &Patch, side: usize) -> Result<Vec<Patch>, GeometryError> {
    let corner = |k: usize| shape.corners()[(side + k) % 4];
    let middles = [0, 2].map(|k| 0.5 * corner(k) + 0.5 * corner(k + 1));
    let parts = [
        vec![corner(0), middles[0], middles[1], corner(3)],
        vec![middles[0], corner(1), corner(2), middles[1]],
    ];
    let part = |corners| Patch::within(corners, shape.resolution());
    parts.into_iter().map(part).collect()
}
