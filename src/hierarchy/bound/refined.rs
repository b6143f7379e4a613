//! Radiosities on a finer mesh, gathered once more: nearer to the solution than what is judged.
//!
//! ```text
//!   B̃ = E + R K B_h  at the centres of leaves and of their parts
//! ```
//!
//! Nothing of the bound rests on how good they are.

use super::views::Views;
use crate::hierarchy::{Element, HierarchyError, Lighting, Tree};
use crate::numeric::{parallel_map, real};

/// The leaves of the finer mesh per leaf, at most.
const PER_LEAF: usize = 4;
/// Leaves of the finer mesh, about, unless there are more to begin with.
const ENOUGH: usize = 1200;
/// The part of the leaves that are cut in a round.
const SHARE: f64 = 0.25;

/// The number of times that lights are cut where something may stand before them, so that parts of
/// them are certainly seen; and the parts, at most.
const LIGHT_CUTS: usize = 2;
const MOST_OF_LIGHTS: usize = 64;

/// A finer mesh with its radiosities.
#[derive(Debug, Clone)]
pub(super) struct Refined {
    pub(super) tree: Tree,
    /// By leaf of the finer mesh.
    pub(super) values: Vec<f64>,
    /// By leaf of the finer mesh, the leaf of the tree in which it lies.
    pub(super) origins: Vec<usize>,
}

/// What is known of an element of the finer mesh.
#[derive(Debug, Clone, Copy)]
struct Known {
    origin: usize,
    value: f64,
    /// `A (B̃ − b)²`, b of the element that it was cut from.
    change: f64,
}

impl Refined {
    /// The finer mesh for these radiosities of the leaves.
    ///
    /// # Errors
    /// [`HierarchyError::Element`].
    pub(super) fn of(
        views: &Views,
        tree: &Tree,
        light: &Lighting,
        values: &[f64],
    ) -> Result<Self, HierarchyError> {
        let mut fine = tree.clone();
        let mut known: Vec<Option<Known>> = vec![None; tree.elements().len()];
        let leaves: Vec<usize> = tree.leaves().collect();
        let first = parallel_map(leaves.len(), &|origin| {
            let at = &tree.elements()[leaves[origin]];
            let value = gathered(views, light, values, at);
            // how much it changes over the leaf is not known yet: by its size and brightness
            let reflectance = light.reflectances()[at.patch()];
            let change = reflectance * at.shape().area() * (value * at.radius()).powi(2);
            Known {
                origin,
                value,
                change,
            }
        });
        for (element, first) in leaves.into_iter().zip(first) {
            known[element] = Some(first);
        }
        let most = (PER_LEAF * tree.leaf_count()).min(ENOUGH.max(tree.leaf_count() * 3 / 2));
        while fine.leaf_count() + 3 <= most {
            let mut leaves: Vec<usize> = fine.leaves().collect();
            let change = |element: &usize| known[*element].map_or(0.0, |known| known.change);
            leaves.retain(|element| change(element) > 0.0);
            leaves.sort_by(|a, b| change(b).total_cmp(&change(a)));
            let room = real(most - fine.leaf_count()) / 3.0;
            let count = (1.0 + SHARE * real(leaves.len())).min(room);
            let chosen: Vec<usize> = leaves
                .iter()
                .enumerate()
                .take_while(|(k, _)| real(*k) < count)
                .map(|(_, e)| *e)
                .collect();
            if chosen.is_empty() {
                break;
            }
            cut(views, light, values, &mut fine, &mut known, &chosen)?;
        }
        if views.is_veiled() {
            cut_lights(views, light, values, &mut fine, &mut known)?;
        }
        let known = |element: usize| known[element];
        Ok(Self {
            values: fine
                .leaves()
                .filter_map(known)
                .map(|known| known.value)
                .collect(),
            origins: fine
                .leaves()
                .filter_map(known)
                .map(|known| known.origin)
                .collect(),
            tree: fine,
        })
    }
}

/// `E + R K B_h` at the centre of an element.
fn gathered(views: &Views, light: &Lighting, values: &[f64], element: &Element) -> f64 {
    let patch = element.patch();
    let received = views.irradiance(patch, element.centre(), values);
    light.emittances()[patch] + light.reflectances()[patch] * received
}

/// Cuts leaves of the finer mesh, and gathers at the centres of their parts.
fn cut(
    views: &Views,
    light: &Lighting,
    values: &[f64],
    fine: &mut Tree,
    known: &mut Vec<Option<Known>>,
    chosen: &[usize],
) -> Result<(), HierarchyError> {
    let first = fine.elements().len();
    for element in chosen {
        fine.quarter(*element)?;
    }
    let parts = &fine.elements()[first..];
    let gathered = parallel_map(parts.len(), &|index| {
        let part = &parts[index];
        let before = known[part.parent()?]?;
        let value = gathered(views, light, values, part);
        Some(Known {
            value,
            change: part.shape().area() * (value - before.value).powi(2),
            ..before
        })
    });
    known.extend(gathered);
    Ok(())
}

/// Cuts lights that reflect nothing.
fn cut_lights(
    views: &Views,
    light: &Lighting,
    values: &[f64],
    fine: &mut Tree,
    known: &mut Vec<Option<Known>>,
) -> Result<(), HierarchyError> {
    for _ in 0..LIGHT_CUTS {
        let emits = |leaf: &usize| {
            let patch = fine.elements()[*leaf].patch();
            light.reflectance(patch) <= 0.0 && light.emittance(patch) > 0.0
        };
        let lights: Vec<usize> = fine.leaves().filter(emits).collect();
        if 4 * lights.len() > MOST_OF_LIGHTS {
            break;
        }
        cut(views, light, values, fine, known, &lights)?;
    }
    Ok(())
}
