//! How the patches of a scene belong together: obstructions, parts of a base, rows.
//!
//! ```text
//!   A'_b = A_b − Σ_p A_p ,   A'_b F'_bj = A_b F_bj − Σ_p A_p F_pj       p: the parts that lie in the base b
//!   A_g = Σ_i A'_i ,         A_g F_gh = Σ_i Σ_j A'_i F'_ij               i, j: the patches of the rows g and h
//! ```
//!
//! A part lies in the plane of its base, faces the same way and is inside it; the base counts without its parts
//! (additivity). The shape of a base stays whole: what is left of it need not be a simple polygon. Patches of one row exchange with
//! each other what the row exchanges with itself, `F_gg`. A row is called as its first patch is, and has a material only if all
//! its patches have the same one.
//!
//! **Not covered**: whether two parts of one base overlap ([`Scene::check_overlap`]).
//!
//! # Source
//! View3D 3.3 manual, §4.1 (*subsurfaces*, their bases, which may be subsurfaces), §4.2 (*surface combination*) and §5.2 (the columns
//! `base` and `cmb`). It has the same restrictions, and two more, which are not needed here: a base comes before its parts, and
//! a row's first surface before the others. It does not say which emissivity a combined surface has, and the program combines areas
//! and exchange areas only.

use super::{Material, NamedPatch, Scene, SceneError};
use crate::geometry::Patch;
use crate::numeric::tolerance;
use glam::DVec2;
use std::collections::HashMap;
use std::hash::Hash;

impl Scene {
    /// The same scene with polygons that only obstruct: they are no patches and have no row.
    #[must_use]
    pub fn with_obstructions(self, obstructions: Vec<NamedPatch>) -> Self {
        Self {
            obstructions,
            ..self
        }
    }

    /// The same scene in which patch `part` lies in patch `base`.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::BaseCycle`] if the base lies in the part;
    /// [`SceneError::PartOffPlane`] beyond [`tolerance::PLANARITY`] of the base's diameter;
    /// [`SceneError::PartFacesAway`]; [`SceneError::PartOutside`]; [`SceneError::NothingLeft`] if the parts leave no
    /// area to the base.
    pub fn with_base(mut self, part: usize, base: usize) -> Result<Self, SceneError> {
        self.check(part)?;
        self.check(base)?;
        let mut above = Some(base);
        while let Some(index) = above {
            if index == part {
                return Err(SceneError::BaseCycle { part, base });
            }
            above = self.bases[index];
        }
        check_inside(
            (part, &self.patches[part].shape),
            (base, &self.patches[base].shape),
        )?;
        self.bases[part] = Some(base);
        let left = self.net_area(base);
        // the rounding of the areas themselves
        let nothing = 8.0 * f64::EPSILON * self.patches[base].shape.area();
        if left <= nothing {
            return Err(SceneError::NothingLeft { base, left });
        }
        Ok(self)
    }

    /// The same scene in which patches with equal labels are summed into one row.
    ///
    /// # Errors
    /// [`SceneError::LabelCount`] unless there is one label for each patch.
    pub fn with_groups<L: Eq + Hash>(mut self, labels: &[L]) -> Result<Self, SceneError> {
        if labels.len() != self.patches.len() {
            return Err(SceneError::LabelCount {
                labels: labels.len(),
                patches: self.patches.len(),
            });
        }
        let mut rows = HashMap::new();
        for (group, label) in self.groups.iter_mut().zip(labels) {
            let next = rows.len();
            *group = *rows.entry(label).or_insert(next);
        }
        Ok(self)
    }

    /// The polygons that only obstruct.
    #[must_use]
    pub fn obstructions(&self) -> &[NamedPatch] {
        &self.obstructions
    }

    /// The patch that this one lies in.
    #[must_use]
    pub fn base_of(&self, index: usize) -> Option<usize> {
        self.bases[index]
    }

    /// The patch that this one lies in, in the end: itself if it lies in none.
    #[must_use]
    pub fn root_of(&self, index: usize) -> usize {
        let mut root = index;
        while let Some(base) = self.bases[root] {
            root = base;
        }
        root
    }

    /// The patches that lie directly in this one, in order.
    pub fn parts_of(&self, index: usize) -> impl Iterator<Item = usize> {
        let bases = self.bases.iter().enumerate();
        bases.filter_map(move |(part, base)| (*base == Some(index)).then_some(part))
    }

    /// The row that this patch is summed into: rows are numbered from 0 in the order of their first patches.
    #[must_use]
    pub fn group_of(&self, index: usize) -> usize {
        self.groups[index]
    }

    /// The number of rows: that of the patches unless some are summed.
    #[must_use]
    pub fn group_count(&self) -> usize {
        self.groups.iter().max().map_or(0, |last| last + 1)
    }

    /// The patches of a row, in order; the first one names it.
    pub fn patches_of_group(&self, group: usize) -> impl Iterator<Item = usize> {
        let groups = self.groups.iter().enumerate();
        groups.filter_map(move |(patch, row)| (*row == group).then_some(patch))
    }

    /// The area of each row, without what lies in it and is of another row.
    #[must_use]
    pub fn row_areas(&self) -> Vec<f64> {
        let mut areas = vec![0.0; self.group_count()];
        for (index, patch) in self.patches.iter().enumerate() {
            let area = patch.shape().area();
            areas[self.groups[index]] += area;
            if let Some(base) = self.bases[index] {
                areas[self.groups[base]] -= area;
            }
        }
        areas
    }

    /// The name of each row, in order: that of its first patch.
    #[must_use]
    pub fn group_names(&self) -> Vec<&str> {
        let mut names = Vec::new();
        for (patch, group) in self.patches.iter().zip(&self.groups) {
            if *group == names.len() {
                names.push(patch.name());
            }
        }
        names
    }

    /// The material that all patches of a row have; reflected power of different ones is not that of any single one.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::MixedRow`] with the first two that differ.
    pub fn group_material(&self, group: usize) -> Result<Material, SceneError> {
        let last = self.group_count() - 1;
        let mut patches = self.patches_of_group(group);
        let no_row = SceneError::NoSuchPatch { index: group, last };
        let first = patches.next().ok_or(no_row)?;
        let material = self.patches[first].material;
        match patches.find(|patch| self.patches[*patch].material != material) {
            None => Ok(material),
            Some(second) => Err(SceneError::MixedRow {
                first,
                second,
                names: [first, second].map(|patch| self.patches[patch].name.clone()),
            }),
        }
    }

    /// The area of a patch without what lies in it, in squared units of length.
    #[must_use]
    pub fn net_area(&self, index: usize) -> f64 {
        let parts: f64 = self
            .parts_of(index)
            .map(|part| self.patches[part].shape.area())
            .sum();
        self.patches[index].shape.area() - parts
    }
}

/// Does the first polygon lie in the second, facing the same way?
pub(super) fn check_inside(
    (part, inner): (usize, &Patch),
    (base, outer): (usize, &Patch),
) -> Result<(), SceneError> {
    let origin = outer.corners()[0];
    let diameter = outer
        .corners()
        .iter()
        .map(|corner| corner.distance(origin))
        .fold(0.0, f64::max);
    let allowed = tolerance::PLANARITY * diameter;
    let normal = outer.normal();
    let deviation = distance_from_plane(inner, outer);
    if deviation > allowed {
        return Err(SceneError::PartOffPlane {
            part,
            base,
            deviation,
            allowed,
        });
    }
    if inner.normal().dot(normal) < 0.0 {
        return Err(SceneError::PartFacesAway { part, base });
    }
    let across = normal.any_orthonormal_vector();
    let up = normal.cross(across);
    // in units of the diameter, so that products stay in range
    let flat = |patch: &Patch| -> Vec<DVec2> {
        let corners = patch.corners().iter();
        let corners = corners.map(|corner| (*corner - origin) / diameter);
        corners
            .map(|c| DVec2::new(c.dot(across), c.dot(up)))
            .collect()
    };
    let allowed = tolerance::PLANARITY;
    let (inner, outer) = (flat(inner), flat(outer));
    let leaves = edges(&inner).any(|(a, b)| {
        [a, 0.5 * (a + b)]
            .into_iter()
            .any(|point| depth(point, &outer) < -allowed)
            || edges(&outer).any(|(c, d)| cross_properly((a, b), (c, d), allowed))
    });
    let swallows = outer.iter().any(|corner| depth(*corner, &inner) > allowed);
    if leaves || swallows {
        return Err(SceneError::PartOutside { part, base });
    }
    Ok(())
}

/// How far the first polygon reaches from the plane of the second.
pub(super) fn distance_from_plane(inner: &Patch, outer: &Patch) -> f64 {
    let heights = inner.corners().iter();
    heights
        .map(|corner| (*corner - outer.corners()[0]).dot(outer.normal()).abs())
        .fold(0.0, f64::max)
}

fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

/// The distance of a point from the outline, > 0 inside and < 0 outside.
fn depth(point: DVec2, polygon: &[DVec2]) -> f64 {
    let distance = edges(polygon).map(|(a, b)| {
        let along = b - a;
        let t = ((point - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        point.distance(a + along * t)
    });
    let distance = distance.fold(f64::INFINITY, f64::min);
    // a ray to the right crosses the outline of a polygon that holds the point an odd number of times
    let crossings = edges(polygon)
        .filter(|(a, b)| (a.y > point.y) != (b.y > point.y))
        .filter(|(a, b)| point.x < a.x + (point.y - a.y) * (b.x - a.x) / (b.y - a.y))
        .count();
    if crossings % 2 == 1 {
        distance
    } else {
        -distance
    }
}

/// Do two segments cross, each with both ends farther than `allowed` from the line of the other?
fn cross_properly((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2), allowed: f64) -> bool {
    let height = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p) / (q - p).length();
    let parts = |s: f64, t: f64| s.abs() > allowed && t.abs() > allowed && (s > 0.0) != (t > 0.0);
    parts(height(a, b, c), height(a, b, d)) && parts(height(c, d, a), height(c, d, b))
}
