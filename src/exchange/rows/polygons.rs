//! The polygons of rows, prepared for the evaluation of pairs.

use crate::form_factor::Polygon;
use crate::scene::NamedPatch;
use std::collections::HashMap;

/// The polygons that pairs are evaluated of: all, or those that a selection needs.
#[derive(Debug, Clone)]
pub(crate) struct Polygons {
    ready: Vec<Polygon>,
    /// The place of each polygon among those that are ready, unless all are.
    places: Option<HashMap<usize, usize>>,
}

impl Polygons {
    pub(crate) fn of(shapes: &[NamedPatch], needed: Option<Vec<usize>>) -> Self {
        let polygon = |patch: &NamedPatch| Polygon::new(patch.shape());
        let Some(mut needed) = needed else {
            let ready = shapes.iter().map(polygon).collect();
            let places = None;
            return Self { ready, places };
        };
        needed.sort_unstable();
        needed.dedup();
        Self {
            ready: needed
                .iter()
                .map(|index| polygon(&shapes[*index]))
                .collect(),
            places: Some(needed.into_iter().zip(0..).collect()),
        }
    }

    /// A polygon, if it is ready.
    pub(crate) fn get(&self, polygon: usize) -> Option<&Polygon> {
        let place = match &self.places {
            None => polygon,
            Some(places) => *places.get(&polygon)?,
        };
        self.ready.get(place)
    }
}
