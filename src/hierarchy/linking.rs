//! The refinement of links: each as coarse as its error allows.
//!
//! ```text
//!   error of link (i, j) ≈ ω_i R_i F_ij √A_i (B_j (h_i/d)² + σ_j h_j/d)  ≤  ε
//! ```
//!
//! with the sizes h, the distance d of the centres, the deviation σ_j of the leaves of j from their
//! mean B_j, and the weight ω_i of the receiver towards a goal, 1 without one. The first term is
//! what the linear function misses over the receiver, the second what the mean misses of the
//! source; the side with the larger one is cut, as far as the mesh is.
//!
//! Of exact factors both links of a pair are made together, so that they are reciprocal: it is cut
//! where either of them asks for it.
//!
//! **Not covered**: a bound. The error is an estimate that ranks links.

use super::HierarchyError;
use super::lighting::Lighting;
use super::link::{Link, Links};
use super::link_factor::{LinkFactors, Visibility};
use super::tree::{Element, Tree};
use crate::form_factor::{DEFAULT_TOLERANCE, PointFactor, Polygon};
use crate::numeric::try_parallel_map;
use std::f64::consts::{PI, SQRT_2};
use std::sync::OnceLock;

/// Links that one task refines.
const BLOCK: usize = 256;

/// The form factors that links have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum Factors {
    /// Those of points, with their gradients: fast, and right to second order.
    #[default]
    OfPoints,
    /// Exact means over the receivers, the same exchange area for both directions: energy is
    /// conserved to rounding.
    Exact,
}

/// The judgement of links on a mesh with its light.
pub(super) struct Linking<'s> {
    pub(super) tree: &'s Tree,
    pub(super) lighting: &'s Lighting,
    pub(super) factors: &'s LinkFactors<'s>,
    /// The polygons of elements, if factors are exact; prepared when first asked for.
    pub(super) polygons: Option<&'s [OnceLock<Polygon>]>,
    /// The mean radiosity of each element.
    pub(super) radiosity: &'s [f64],
    /// The deviations of its leaves.
    pub(super) deviations: &'s [f64],
    /// What errors count by at each receiver; none if they count alike.
    pub(super) weights: Option<&'s [f64]>,
    /// The error that a link may have.
    pub(super) tolerance: f64,
}

/// The links of one task, and how many form factors it took to find them.
#[derive(Debug, Default)]
pub(super) struct Linked {
    pub(super) links: Vec<Link>,
    /// Empty if nothing stands in the way anywhere.
    pub(super) sights: Vec<Visibility>,
    pub(super) evaluations: u64,
}

/// The form factors of a pair of elements: from the receiver, and of exact ones, from the source.
struct Pair {
    ends: [usize; 2],
    factors: [Option<PointFactor>; 2],
    sight: Visibility,
}

impl Linking<'_> {
    /// The links between patches, before any is refined.
    pub(super) fn between_patches(&self) -> Result<Linked, HierarchyError> {
        let mut linked = Linked::default();
        let patches = self.tree.patches();
        for receiver in 0..patches {
            let first = if self.is_exact() { receiver + 1 } else { 0 };
            for source in (first..patches).filter(|source| *source != receiver) {
                if let Some(pair) = self.pair([receiver, source], None, &mut linked.evaluations)? {
                    self.keep(pair, &mut linked);
                }
            }
        }
        Ok(linked)
    }

    /// Refines links until each is within the tolerance, or ends in leaves.
    pub(super) fn refined(&self, links: &Links) -> Result<Linked, HierarchyError> {
        let tasks = links.count().div_ceil(BLOCK);
        let parts = try_parallel_map(tasks, &|task| {
            let mut part = Linked::default();
            for index in task * BLOCK..(task * BLOCK + BLOCK).min(links.count()) {
                let link = links.all()[index];
                // of exact links, one of two stands for both
                if !self.is_exact() || link.receiver < link.source {
                    self.refine(self.known(link, links, index), &mut part)?;
                }
            }
            Ok::<_, HierarchyError>(part)
        })?;
        let mut whole = Linked::default();
        for part in parts {
            whole.links.extend(part.links);
            whole.sights.extend(part.sights);
            whole.evaluations += part.evaluations;
        }
        Ok(whole)
    }
}

impl Linking<'_> {
    const fn is_exact(&self) -> bool {
        self.polygons.is_some()
    }

    /// The pair of a link that is there.
    fn known(&self, link: Link, links: &Links, index: usize) -> Pair {
        let ends = [link.receiver as usize, link.source as usize];
        let back = self.is_exact().then(|| {
            let mut back = links.of(ends[1]).iter();
            back.find(|back| back.source == link.receiver)
        });
        Pair {
            ends,
            factors: [Some(link.factor()), back.flatten().map(Link::factor)],
            sight: links.sight(index).clone(),
        }
    }

    fn refine(&self, pair: Pair, linked: &mut Linked) -> Result<(), HierarchyError> {
        let Some(side) = self.side_to_cut(&pair) else {
            self.keep(pair, linked);
            return Ok(());
        };
        for child in self.tree.elements()[pair.ends[side]].children() {
            let mut ends = pair.ends;
            ends[side] = child;
            if let Some(part) = self.pair(ends, Some(&pair.sight), &mut linked.evaluations)? {
                self.refine(part, linked)?;
            }
        }
        Ok(())
    }

    fn keep(&self, pair: Pair, linked: &mut Linked) {
        let [receiver, source] = pair.ends;
        for (factor, [to, from]) in pair
            .factors
            .iter()
            .zip([[receiver, source], [source, receiver]])
        {
            if let Some(factor) = factor {
                linked.links.push(Link::new(to, from, *factor));
                if self.factors.can_be_hidden() {
                    linked.sights.push(pair.sight.clone());
                }
            }
        }
    }

    /// The form factors of a pair, if light can go from one end to the other and back into the
    /// room; `around` is what is known of elements around them, none for patches.
    fn pair(
        &self,
        ends: [usize; 2],
        around: Option<&Visibility>,
        evaluations: &mut u64,
    ) -> Result<Option<Pair>, HierarchyError> {
        let [receiver, source] = ends.map(|index| &self.tree.elements()[index]);
        let is_dark = |element: &Element| self.lighting.reflectance(element.patch()) <= 0.0;
        if is_dark(receiver) && (!self.is_exact() || is_dark(source)) {
            return Ok(None);
        }
        let of_patches = self.factors.visibility(receiver.patch(), source.patch());
        let around = around.unwrap_or(of_patches);
        let Some((factor, sight)) = self.factors.between_parts(receiver, source, around)? else {
            return Ok(None);
        };
        *evaluations += 1;
        let factors = match self.polygons {
            None => [Some(factor), None],
            Some(polygons) => {
                let [one, other] = ends.map(|index| polygon(polygons, self.tree, index));
                let exchange =
                    self.factors
                        .exchange_area([one, other], &sight, DEFAULT_TOLERANCE)?;
                let back = self.factors.between_parts(source, receiver, &sight)?;
                let back = back.map_or(PointFactor::NOTHING, |(factor, _)| factor);
                let mean = |element: &Element, factor: PointFactor| PointFactor {
                    value: exchange.value / element.shape().area(),
                    ..factor
                };
                [Some(mean(receiver, factor)), Some(mean(source, back))]
            }
        };
        Ok(Some(Pair {
            ends,
            factors,
            sight,
        }))
    }

    /// The end to be cut, 0 for the receiver and 1 for the source, if the error is too large and
    /// the mesh is finer there.
    fn side_to_cut(&self, pair: &Pair) -> Option<usize> {
        let [i, j] = pair.ends;
        let there = self.errors([i, j], pair.factors[0]);
        let back = self.errors([j, i], pair.factors[1]);
        if there[0] + there[1] <= self.tolerance && back[0] + back[1] <= self.tolerance {
            return None;
        }
        let errors = [there[0].max(back[1]), there[1].max(back[0])];
        let can_cut = pair
            .ends
            .map(|index| !self.tree.elements()[index].is_leaf());
        let larger = usize::from(errors[1] > errors[0]);
        [larger, 1 - larger]
            .into_iter()
            .find(|side| can_cut[*side] && errors[*side] > 0.5 * self.tolerance)
    }

    /// What a link misses over its receiver, and of its source.
    fn errors(&self, [i, j]: [usize; 2], factor: Option<PointFactor>) -> [f64; 2] {
        let Some(factor) = factor else {
            return [0.0; 2];
        };
        let [receiver, source] = [i, j].map(|index| &self.tree.elements()[index]);
        let distance = receiver.centre().distance(source.centre());
        let [far, near] = [receiver, source].map(|element| SQRT_2 * element.radius() / distance);
        let reflectance = self.lighting.reflectance(receiver.patch());
        let weight = self.weights.map_or(1.0, |weights| weights[i]);
        let seen = largest(factor, source, distance);
        let scale = weight * reflectance * seen * receiver.shape().area().sqrt();
        [
            scale * self.radiosity[j] * far * far,
            scale * self.deviations[j] * near,
        ]
    }
}

/// The polygon of an element.
fn polygon<'p>(polygons: &'p [OnceLock<Polygon>], tree: &Tree, index: usize) -> &'p Polygon {
    polygons[index].get_or_init(|| Polygon::new(tree.elements()[index].shape()))
}

/// The factor of a link; where the centre sees nothing, what other points may see at most.
fn largest(factor: PointFactor, source: &Element, distance: f64) -> f64 {
    if factor.value > 0.0 {
        return factor.value;
    }
    (source.shape().area() / (PI * distance * distance)).min(1.0)
}
