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
//! plate they pass it; inside of every one they are stopped. Of what is between, the form factor
//! from a point and the mean over a polygon are known
//! ([`exchange_area_past`](Polygon::exchange_area_past)).
//!
//! **Not covered**: several plates that hide together; rounding.

use crate::form_factor::{
    ExchangeArea, FormFactorError, Occluders, Plate, PointView, Polygon, point_form_factor_past,
};
use crate::geometry::{Patch, clipped};
use crate::hierarchy::link_factor::{Place, Plates};
use crate::hierarchy::{HierarchyError, LinkFactors, Visibility};
use crate::numeric::Bounded;
use crate::scene::{Occlusion, Scene};
use glam::DVec3;
use smallvec::SmallVec;

/// The relative tolerance of exchange areas past plates.
const TOLERANCE: f64 = 1e-4;

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
    /// None if nothing stands between patches.
    plates: Option<Plates>,
    noise: f64,
}

impl Sight {
    /// The sight in a scene.
    ///
    /// # Errors
    /// [`HierarchyError::Scene`] if patches overlap.
    pub(super) fn of(scene: &Scene) -> Result<Self, HierarchyError> {
        Ok(Self {
            plates: LinkFactors::try_new(scene, Occlusion::Exact)?.into_plates(),
            noise: scene.noise_length(),
        })
    }

    /// Whether something may stand between some patches.
    pub(super) const fn can_be_hidden(&self) -> bool {
        self.plates.is_some()
    }

    /// What stands between two patches.
    pub(super) fn of_patches(&self, first: usize, second: usize) -> &Visibility {
        let plates = self.plates.as_ref();
        plates.map_or(&Visibility::Clear, |plates| {
            plates.of_patches(first, second)
        })
    }

    /// What stands between two polygons.
    pub(super) fn between(&self, ends: [End<'_>; 2]) -> Visibility {
        let [first, second] = ends;
        match self.of_patches(first.patch, second.patch) {
            Visibility::Past(plates) => self.narrowed(plates, ends),
            known => known.clone(),
        }
    }

    /// The visibility between two polygons past these plates, if no others are in the way.
    pub(super) fn narrowed(&self, plates: &[u32], ends: [End<'_>; 2]) -> Visibility {
        let Some(all) = &self.plates else {
            return Visibility::Clear;
        };
        Visibility::past(plates, |number| self.place(all.plate(number), ends))
    }

    /// The form factor from a point of a surface with this normal to what plates leave of a shape,
    /// about.
    pub(super) fn form_factor(
        &self,
        [point, normal]: [DVec3; 2],
        shape: &Patch,
        between: &[u32],
    ) -> f64 {
        let view = PointView {
            point,
            normal,
            touching: self.noise,
        };
        let plates = self.plates.as_ref();
        plates.map_or(0.0, |plates| plates.form_factor(view, shape, between))
    }

    /// The form factor from a point of a surface with this normal to what plates leave of a
    /// polygon.
    ///
    /// # Errors
    /// As [`point_form_factor_past`].
    pub(super) fn bounded_form_factor(
        &self,
        [point, normal]: [DVec3; 2],
        polygon: &Polygon,
        between: &[u32],
    ) -> Result<Bounded, FormFactorError> {
        let polygons = self.polygons(between);
        let occluders = Occluders {
            polygons: &polygons,
            touching: self.noise,
        };
        point_form_factor_past(point, normal, polygon, &occluders)
    }

    /// The exchange area of two polygons past plates.
    ///
    /// # Errors
    /// As [`Polygon::exchange_area_past`].
    pub(super) fn exchange_area(
        &self,
        [one, other]: [&Polygon; 2],
        between: &[u32],
    ) -> Result<ExchangeArea, FormFactorError> {
        let polygons = self.polygons(between);
        let occluders = Occluders {
            polygons: &polygons,
            touching: self.noise,
        };
        Ok(one
            .exchange_area_past(other, &occluders, TOLERANCE)?
            .exchange)
    }

    fn polygons(&self, between: &[u32]) -> SmallVec<[&Polygon; 8]> {
        let plates = self.plates.as_ref();
        plates.map_or_else(SmallVec::new, |plates| plates.polygons(between))
    }

    fn place(&self, plate: &Plate, ends: [End<'_>; 2]) -> Place {
        for end in ends {
            let height = |corner: &DVec3| (*corner - end.corners[0]).dot(end.normal);
            if plate.corners().iter().all(|c| height(c) <= self.noise) {
                return Place::Aside;
            }
        }
        let sides = ends.map(|end| [1.0, -1.0].map(|sign| self.on_side(plate, end.corners, sign)));
        let [[above, below], [others_above, others_below]] = sides;
        let ways = [(above, others_below), (below, others_above)];
        let mut places = ways.iter().filter_map(|(x, y)| self.crossed(plate, x, y));
        if places.clone().all(|place| place == Place::Aside) {
            Place::Aside
        } else if self.is_between(plate, ends) && places.all(|place| place == Place::Across) {
            Place::Across
        } else {
            Place::Between
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
    fn crossed(&self, plate: &Plate, x: &[(DVec3, f64)], y: &[(DVec3, f64)]) -> Option<Place> {
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
        let mut found = Place::Across;
        for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let outward = (*to - *from).cross(plate.normal()).normalize();
            let apart = crossings.iter().map(|p| (*p - *from).dot(outward));
            let [low, high] = apart.fold([f64::MAX, f64::MIN], |[low, high], apart| {
                [low.min(apart), high.max(apart)]
            });
            if low >= -self.noise {
                return Some(Place::Aside);
            }
            if high > -self.noise {
                found = Place::Between;
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
