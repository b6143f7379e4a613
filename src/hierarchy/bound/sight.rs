//! What certainly stands between two polygons, and what certainly does not.
//!
//! A segment from x to y, at the heights a ≥ 0 ≥ b over the plane of a plate, crosses it at p:
//!
//! ```text
//!   p = (a y − b x)/(a − b)
//!   p(Σ λ_i x_i, Σ μ_j y_j) = Σ λ_i μ_j (a_i − b_j) p_ij / Σ λ_i μ_j (a_i − b_j)
//! ```
//!
//! so that all crossings lie in the hull of those between corners. Outside of one edge of a convex
//! plate they pass it; inside of every one they are stopped.
//!
//! **Not covered**: several plates that hide together; rounding.

use crate::form_factor::Plate;
use crate::geometry::{Patch, clipped};
use crate::hierarchy::{HierarchyError, LinkFactors, Visibility};
use crate::scene::{Occlusion, Scene};
use glam::DVec3;

/// What stands between all points of two polygons.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Between {
    /// Nothing.
    Nothing,
    /// Something, wherever one looks.
    All,
    /// Something, perhaps.
    Perhaps,
}

/// A convex polygon, or a point, on a surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct End<'e> {
    pub(super) patch: usize,
    pub(super) corners: &'e [DVec3],
    pub(super) normal: DVec3,
}

impl<'e> End<'e> {
    /// The end on a patch.
    pub(super) fn of(patch: usize, shape: &'e Patch) -> Self {
        Self {
            patch,
            corners: shape.corners(),
            normal: shape.normal(),
        }
    }
}

/// The plates of a scene, and those that may stand between its patches.
#[derive(Debug, Clone)]
pub(super) struct Sight {
    plates: Vec<Plate>,
    /// Row by row.
    pairs: Vec<Visibility>,
    patches: usize,
    noise: f64,
}

impl Sight {
    /// The sight in a scene.
    ///
    /// # Errors
    /// [`HierarchyError::Scene`] if patches overlap.
    pub(super) fn of(scene: &Scene) -> Result<Self, HierarchyError> {
        let factors = LinkFactors::try_new(scene, Occlusion::Exact)?;
        let patches = scene.patches().len();
        let pairs = (0..patches * patches)
            .map(|pair| factors.visibility(pair / patches, pair % patches).clone());
        Ok(Self {
            pairs: pairs.collect(),
            plates: factors.plates().to_vec(),
            patches,
            noise: scene.noise_length(),
        })
    }

    /// What stands between two patches.
    pub(super) fn of_patches(&self, first: usize, second: usize) -> &Visibility {
        &self.pairs[first * self.patches + second]
    }

    /// What stands between two polygons.
    pub(super) fn between(&self, ends: [End<'_>; 2]) -> Between {
        let [first, second] = ends;
        let plates = match self.of_patches(first.patch, second.patch) {
            Visibility::Clear => return Between::Nothing,
            Visibility::Hidden => return Between::All,
            Visibility::Past(plates) => plates,
        };
        let mut found = Between::Nothing;
        for number in plates {
            match self.past(&self.plates[*number as usize], ends) {
                Between::Nothing => {}
                Between::All => return Between::All,
                Between::Perhaps => found = Between::Perhaps,
            }
        }
        found
    }

    fn past(&self, plate: &Plate, ends: [End<'_>; 2]) -> Between {
        for end in ends {
            let height = |corner: &DVec3| (*corner - end.corners[0]).dot(end.normal);
            if plate.corners().iter().all(|c| height(c) <= self.noise) {
                return Between::Nothing;
            }
        }
        let sides = ends.map(|end| [1.0, -1.0].map(|sign| self.on_side(plate, end.corners, sign)));
        let [[above, below], [others_above, others_below]] = sides;
        let ways = [(above, others_below), (below, others_above)];
        let mut places = ways.iter().filter_map(|(x, y)| self.crossed(plate, x, y));
        if places.clone().all(|place| place == Between::Nothing) {
            Between::Nothing
        } else if self.is_between(plate, ends) && places.all(|place| place == Between::All) {
            Between::All
        } else {
            Between::Perhaps
        }
    }

    /// The corners of the part of a polygon on one side of a plate's plane, with their heights.
    fn on_side(&self, plate: &Plate, corners: &[DVec3], sign: f64) -> Vec<(DVec3, f64)> {
        let heights: Vec<f64> = corners.iter().map(|c| sign * plate.height(*c)).collect();
        if heights.iter().all(|height| *height <= self.noise) {
            return Vec::new();
        }
        if let ([corner], [height]) = (corners, heights.as_slice()) {
            return vec![(*corner, *height)];
        }
        let part = clipped(corners, &heights, |a, b, share: f64| a + (b - a) * share);
        let height = |corner: DVec3| (sign * plate.height(corner)).max(0.0);
        part.into_iter().map(|c| (c, height(c))).collect()
    }

    /// Where the segments between two parts cross a plate; none if there are none.
    fn crossed(&self, plate: &Plate, x: &[(DVec3, f64)], y: &[(DVec3, f64)]) -> Option<Between> {
        let mut crossings = Vec::with_capacity(x.len() * y.len());
        for (x, a) in x {
            for (y, b) in y {
                if a + b > 0.0 {
                    crossings.push((*a * *y + *b * *x) / (a + b));
                }
            }
        }
        if crossings.is_empty() {
            return None;
        }
        let corners = plate.corners();
        let mut found = Between::All;
        for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let outward = (*to - *from).cross(plate.normal()).normalize();
            let apart = crossings.iter().map(|p| (*p - *from).dot(outward));
            let [low, high] = apart.fold([f64::MAX, f64::MIN], |[low, high], apart| {
                [low.min(apart), high.max(apart)]
            });
            if low >= -self.noise {
                return Some(Between::Nothing);
            }
            if high > -self.noise {
                found = Between::Perhaps;
            }
        }
        Some(found)
    }

    /// Whether all of the ends are on either side of a plate.
    fn is_between(&self, plate: &Plate, ends: [End<'_>; 2]) -> bool {
        let ranges = ends.map(|end| {
            let heights = end.corners.iter().map(|corner| plate.height(*corner));
            heights.fold([f64::MAX, f64::MIN], |[low, high], height| {
                [low.min(height), high.max(height)]
            })
        });
        let [[low, high], [least, most]] = ranges;
        low.max(least) >= self.noise && high.min(most) <= -self.noise
    }
}
