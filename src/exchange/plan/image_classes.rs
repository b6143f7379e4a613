//! The classes of congruent translates and mirror images that occur, found on all threads.

use super::images::{Images, Key};
use super::{Representative, Source};
use crate::scene::NamedPatch;
use rayon::prelude::*;
use std::collections::HashMap;

/// Most classes: so many, and so many per polygon.
const MOST_CLASSES: [usize; 2] = [1 << 16, 64];

/// The first pair of each class.
type FirstPairs = HashMap<Key, [u32; 2]>;

/// The classes of congruent pairs of polygons that repeat.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ImageClasses {
    images: Images,
    /// The place of each class among the representatives.
    places: HashMap<Key, u32>,
    /// The first pair of each class, in the order of the scene.
    pub(crate) representatives: Vec<[usize; 2]>,
}

impl ImageClasses {
    /// The classes of those pairs that are wanted; none if hardly two pairs are in one.
    ///
    /// **Arguments** `uncovered`: the polygons whose frame is sought.
    pub(crate) fn of(
        patches: &[NamedPatch],
        uncovered: &[usize],
        is_wanted: impl Fn(usize, usize) -> bool + Sync,
    ) -> Option<Self> {
        let images = Images::of(patches, uncovered)?;
        let n = patches.len();
        let most = MOST_CLASSES[0].max(MOST_CLASSES[1] * n).min(n * n / 4);
        let of_row = |found: Option<FirstPairs>, one: usize| {
            let mut found = found?;
            for other in one + 1..n {
                if let Some(key) = images.key(one, other)
                    && is_wanted(one, other)
                {
                    let pair = [one, other].map(|k| u32::try_from(k).unwrap_or(u32::MAX));
                    let first = found.entry(key).or_insert(pair);
                    *first = pair.min(*first);
                }
            }
            (found.len() <= most).then_some(found)
        };
        let empty = || Some(FirstPairs::new());
        let rows = (0..n).into_par_iter().fold(empty, of_row);
        let found = rows.reduce(empty, |one, other| merged(one?, other?, most))?;
        let mut pairs: Vec<(Key, [u32; 2])> = found.into_iter().collect();
        pairs.sort_unstable_by_key(|(_, pair)| *pair);
        let places = pairs
            .iter()
            .zip(0u32..)
            .map(|((key, _), place)| (*key, place));
        Some(Self {
            places: places.collect(),
            representatives: pairs
                .iter()
                .map(|(_, pair)| pair.map(|k| k as usize))
                .collect(),
            images,
        })
    }

    /// The place of a pair's class among the representatives.
    pub(crate) fn place(&self, first: usize, second: usize) -> Option<usize> {
        let key = self.images.key(first, second)?;
        self.places.get(&key).map(|place| *place as usize)
    }

    pub(crate) fn representative(&self, class: usize) -> Option<Representative> {
        let pair = *self.representatives.get(class)?;
        Some(Representative {
            pair,
            source: Source::Image(pair.map(|polygon| self.images.models[polygon].clone())),
            spread: self.images.spread,
        })
    }
}

/// The first pair of each class of either; none if there are too many.
fn merged(one: FirstPairs, other: FirstPairs, most: usize) -> Option<FirstPairs> {
    let (mut larger, smaller) = if one.len() < other.len() {
        (other, one)
    } else {
        (one, other)
    };
    for (key, pair) in smaller {
        let first = larger.entry(key).or_insert(pair);
        *first = pair.min(*first);
    }
    (larger.len() <= most).then_some(larger)
}
