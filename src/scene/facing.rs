//! Pairs of planes whose patches exchange nothing.
//!
//! ```text
//!   h is in front of g   ⇔   some corner of h has n_g · (x − o_g) > 16 ε · extent
//! ```
//!
//! If h is not in front of g, or g not in front of h, no patch of one exchanges anything with a
//! patch of the other: all their pairs are left out, and none of them is evaluated. Heights up to
//! [`tolerance::ALIGNMENT`](crate::numeric::tolerance::ALIGNMENT) of the largest coordinate are
//! rounding of the input.
//!
//! **Not covered**: more than [`MOST_PLANES`] planes; then only pairs in one plane are left out
//! here.

use super::NamedPatch;
use super::planes::Planes;
use glam::DVec3;

/// Largest number of planes of which all pairs are compared: the table takes their square in bytes.
const MOST_PLANES: usize = 2048;

/// Whether the patches of two planes can exchange anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(
    clippy::enum_variant_names,
    reason = "the term of computer graphics is back-facing"
)]
pub(super) enum Facing {
    /// They may be visible from each other; each pair decides for itself.
    Visible,
    /// Nothing is exchanged: both lie in one plane.
    Coplanar,
    /// Nothing is exchanged: one lies behind the other.
    BackFacing,
}

/// The planes of a scene, and which of them face each other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FacingPlanes {
    planes: Planes,
    /// `table[g · planes + h]`; empty beyond [`MOST_PLANES`].
    table: Vec<Facing>,
}

impl FacingPlanes {
    /// Compares the planes of patches; a patch whose root is another one lies in that one, and in
    /// its plane.
    pub(super) fn of(patches: &[NamedPatch], roots: &[usize]) -> Self {
        let planes = Planes::of(patches, roots);
        let table = if planes.count() <= MOST_PLANES {
            // what lies in a patch is in front of nothing that the patch is not in front of
            let corners = |patch: usize| {
                let is_whole = roots[patch] == patch;
                if is_whole {
                    patches[patch].shape().corners()
                } else {
                    &[]
                }
            };
            compare(&planes, corners)
        } else {
            Vec::new()
        };
        Self { planes, table }
    }

    /// Number of planes.
    pub(super) const fn count(&self) -> usize {
        self.planes.count()
    }

    /// The plane of a patch.
    pub(super) fn of_patch(&self, patch: usize) -> usize {
        self.planes.of_patch(patch)
    }

    /// Is it known which planes face each other?
    pub(super) const fn are_compared(&self) -> bool {
        !self.table.is_empty()
    }

    /// Whether two planes can exchange anything.
    pub(super) fn facing(&self, first: usize, second: usize) -> Facing {
        if first == second {
            Facing::Coplanar
        } else if self.table.is_empty() {
            Facing::Visible
        } else {
            self.table[first * self.count() + second]
        }
    }

    /// Numbers of pairs left out: in one plane, behind each other.
    pub(super) fn pairs_left_out(&self) -> [usize; 2] {
        let mut left_out = [0, 0];
        for first in 0..self.count() {
            let patches = self.planes.patches(first).len();
            left_out[0] += patches * (patches - 1) / 2;
            if !self.are_compared() {
                continue;
            }
            for second in first + 1..self.count() {
                let pairs = patches * self.planes.patches(second).len();
                match self.facing(first, second) {
                    Facing::Visible => {}
                    Facing::Coplanar => left_out[0] += pairs,
                    Facing::BackFacing => left_out[1] += pairs,
                }
            }
        }
        left_out
    }
}

/// Compares each plane with each other one.
fn compare<'p>(planes: &Planes, corners: impl Fn(usize) -> &'p [DVec3]) -> Vec<Facing> {
    let count = planes.count();
    // is something of `other` above, or more than rounding off, the plane?
    let any = |plane: usize, other: usize, is: fn(f64) -> f64| {
        let mut all = planes
            .patches(other)
            .iter()
            .flat_map(|patch| corners(*patch));
        all.any(|corner| is(planes.height(plane, *corner)) > planes.noise())
    };
    let in_front: Vec<bool> = (0..count * count)
        .map(|pair| any(pair / count, pair % count, |height| height))
        .collect();
    let facing = |pair: usize| {
        let (first, second) = (pair / count, pair % count);
        if in_front[pair] && in_front[second * count + first] {
            Facing::Visible
        } else if any(first.min(second), first.max(second), f64::abs) {
            Facing::BackFacing
        } else {
            Facing::Coplanar
        }
    };
    (0..count * count).map(facing).collect()
}
