//! Links: the light that one element receives from another.
//!
//! ```text
//!   H(x) = Σ_j (F_ij + ∇F_ij·(x − c_i)) B_j          c_i: the centre of the receiver
//! ```
//!
//! A link stands at the coarsest element for which it is good enough; what elements receive goes
//! down to their children.

use super::link_factor::Visibility;
use crate::form_factor::PointFactor;
use glam::{DVec3, Vec3};
use std::ops::Range;

/// The form factor from a receiver to a source, linear about the receiver's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// The element that receives.
    pub receiver: u32,
    /// The element from which the light comes.
    pub source: u32,
    /// The form factor from the receiver's centre, or its mean over the receiver.
    pub value: f64,
    /// The gradient of the form factor at the centre, in the receiver's plane.
    pub gradient: Vec3,
}

impl Link {
    /// The link of a receiver to a source.
    pub(super) fn new(receiver: usize, source: usize, factor: PointFactor) -> Self {
        let index = |element: usize| {
            u32::try_from(element)
                .unwrap_or_else(|_| unreachable!("elements fill no memory so large"))
        };
        Self {
            receiver: index(receiver),
            source: index(source),
            value: factor.value,
            gradient: factor.gradient.as_vec3(),
        }
    }

    /// The form factor with its gradient.
    #[must_use]
    pub fn factor(&self) -> PointFactor {
        PointFactor {
            value: self.value,
            gradient: self.gradient.as_dvec3(),
        }
    }

    /// The form factor at an offset from the receiver's centre.
    #[must_use]
    pub fn at(&self, offset: DVec3) -> f64 {
        self.value + self.gradient.as_dvec3().dot(offset)
    }
}

/// The links of a tree, by receivers.
#[derive(Debug, Clone, Default)]
pub struct Links {
    links: Vec<Link>,
    /// What each link knows of what stands between; empty if nothing does anywhere.
    sights: Vec<Visibility>,
    /// The links of element i are those from `starts[i]` to `starts[i + 1]`.
    starts: Vec<usize>,
}

impl Links {
    /// Sorts links by their receivers; those of one receiver stay in order.
    pub(super) fn new(links: Vec<Link>, sights: Vec<Visibility>, elements: usize) -> Self {
        let mut starts = vec![0; elements + 1];
        for link in &links {
            starts[link.receiver as usize + 1] += 1;
        }
        for element in 0..elements {
            starts[element + 1] += starts[element];
        }
        let mut order: Vec<usize> = (0..links.len()).collect();
        order.sort_by_key(|link| links[*link].receiver);
        Self {
            sights: order
                .iter()
                .filter_map(|k| sights.get(*k).cloned())
                .collect(),
            links: order.into_iter().map(|k| links[k]).collect(),
            starts,
        }
    }

    /// The links through which an element itself receives, not those of elements around it; none
    /// yet for an element that is newer than they are.
    #[must_use]
    pub fn of(&self, element: usize) -> &[Link] {
        match self.starts.get(element..element + 2) {
            Some([start, end]) => &self.links[*start..*end],
            _ => &[],
        }
    }

    /// What is known of the space between the ends of links of an element, in their order.
    pub(super) fn sights_of(&self, element: usize) -> impl Iterator<Item = &Visibility> {
        self.range(element).map(|link| self.sight(link))
    }

    /// The links of an element; none of one that was cut out since.
    fn range(&self, element: usize) -> Range<usize> {
        let ends = self.starts.get(element..element + 2);
        ends.map_or(0..0, |ends| ends[0]..ends[1])
    }

    /// What is known of the space between the ends of a link.
    pub(super) fn sight(&self, link: usize) -> &Visibility {
        self.sights.get(link).unwrap_or(&Visibility::Clear)
    }

    /// All links, by receivers, each with what is known of the space between its ends.
    pub(super) fn with_sights(&self) -> impl Iterator<Item = (&Link, &Visibility)> {
        let links = self.links.iter().enumerate();
        links.map(|(index, link)| (link, self.sight(index)))
    }

    /// The number of links.
    #[must_use]
    pub fn count(&self) -> usize {
        self.links.len()
    }

    /// All links, by receivers.
    #[must_use]
    pub fn all(&self) -> &[Link] {
        &self.links
    }
}
