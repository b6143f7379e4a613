//! The grouping of a scene's patches: obstructions, parts of a base, rows.
//!
//! ```text
//!   A'_b = A_b − Σ_p A_p ,   A'_b F'_bj = A_b F_bj − Σ_p A_p F_pj     p: the parts in the base b
//!   A_g = Σ_i A'_i ,         A_g F_gh = Σ_i Σ_j A'_i F'_ij            i, j: the patches of g and h
//! ```
//!
//! A part lies in the plane of its base, faces the same way and is inside it; the base counts
//! without its parts (additivity). The shape of a base stays whole: what is left of it need not be
//! a simple polygon. Patches of one row exchange with each other what the row exchanges with
//! itself, `F_gg`. A row has the name of its first patch, and a material only if all its patches
//! have the same one.
//!
//! In a View3D file, a surface with a `base` becomes a part of it, and surfaces with one `cmb`
//! become one row of every answer, what they exchange among themselves on its diagonal. A row may
//! also be without a patch: a face without area keeps its number and exchanges nothing. The error
//! bounds of base and parts, and of all pairs of a row, add up. A plan and its counts are about
//! pairs of patches, before they are summed into rows.
//!
//! **Not covered**: whether two parts of one base overlap ([`Scene::check_overlap`]).
//!
//! # Source
//! View3D 3.3 manual, §4.1 (*subsurfaces*, their bases, which may be subsurfaces), §4.2 (*surface
//! combination*) and §5.2 (the columns `base` and `cmb`). It has the same restrictions, and two
//! more, which are not needed here: a base comes before its parts, and a row's first surface before
//! the others. It does not say which emissivity a combined surface has, and the program combines
//! areas and exchange areas only.

use super::{NamedPatch, PatchMaterial, Scene, SceneError};
use crate::geometry::{NotContained, check_contained};
use crate::numeric::tolerance;
use crate::scene::visibility::surfaces::Prepared;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::hash::Hash;

/// A row without a patch, such as a face without area: it keeps its number among the rows, has an
/// area of 0 and exchanges nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct EmptyRow {
    /// The number of the row, among all.
    pub row: usize,
    /// The name of the row.
    pub name: String,
    /// The material of the face.
    pub material: PatchMaterial,
}

impl Scene {
    /// Adds polygons that only obstruct, in place of those before: they are no patches and have no
    /// row.
    #[must_use]
    pub fn with_obstructions(self, obstructions: Vec<NamedPatch>) -> Self {
        Self {
            obstructions,
            prepared: Prepared::default(),
            ..self
        }
    }

    /// Makes patch `part` lie in patch `base`.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::BaseCycle`] if the base lies in the part;
    /// [`SceneError::PartOffPlane`] beyond [`PLANARITY`](crate::numeric::tolerance::PLANARITY) of
    /// the base's diameter, or the noise of a resolution; [`SceneError::PartFacesAway`];
    /// [`SceneError::PartOutside`];
    /// [`SceneError::NothingLeft`] if the parts leave no area to the base.
    pub fn with_base(mut self, part: usize, base: usize) -> Result<Self, SceneError> {
        self.lay(part, base)?;
        Ok(self)
    }

    /// Makes patch `part` lie in patch `base`, if it can.
    pub(crate) fn lay(&mut self, part: usize, base: usize) -> Result<(), SceneError> {
        self.check(part)?;
        self.check(base)?;
        let mut above = Some(base);
        while let Some(index) = above {
            if index == part {
                return Err(SceneError::BaseCycle { part, base });
            }
            above = self.bases[index];
        }
        let [inner, outer] = [part, base].map(|patch| &self.patches[patch].shape);
        check_contained(inner, outer, self.part_noise())
            .map_err(|reason| refusal(part, base, reason))?;
        let before = self.bases[part].replace(base);
        let left = self.net_area(base);
        // the rounding of the areas themselves
        let nothing = 8.0 * f64::EPSILON * self.patches[base].shape.area();
        if left <= nothing {
            self.bases[part] = before;
            return Err(SceneError::NothingLeft { base, left });
        }
        Ok(())
    }

    /// The distance by which a part may leave its base for all that the coordinates say.
    pub(crate) fn part_noise(&self) -> f64 {
        tolerance::RESOLVED_NOISE * self.resolution
    }

    /// Sums patches with equal labels into one row; rows without a patch are dropped.
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
        self.empty_rows.clear();
        Ok(self)
    }

    /// Adds rows without a patch, in place of those before: the other rows move up.
    ///
    /// # Errors
    /// [`SceneError::EmptyRowOutOfOrder`] unless their numbers increase and leave none out.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::{EmptyRow, PatchMaterial, Scene};
    /// let (name, material) = ("sliver".to_owned(), PatchMaterial::BLACK);
    /// let squares = Scene::built_in("two-squares")?;
    /// let squares = squares.with_empty_rows(vec![EmptyRow { row: 1, name, material }])?;
    /// assert_eq!(squares.row_areas(), [1.0, 0.0, 1.0]);
    /// assert_eq!(squares.patches().len(), 2);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn with_empty_rows(mut self, rows: Vec<EmptyRow>) -> Result<Self, SceneError> {
        let old: Vec<usize> = self.empty_rows.iter().map(|empty| empty.row).collect();
        let with_patches = self.group_count() - old.len();
        let mut numbers = Vec::with_capacity(with_patches);
        let mut next = 0;
        for empty in &rows {
            let last = with_patches + rows.len() - 1;
            if empty.row < next || empty.row > last {
                let row = empty.row;
                return Err(SceneError::EmptyRowOutOfOrder { row, last });
            }
            numbers.extend(next..empty.row);
            next = empty.row + 1;
        }
        numbers.extend(next..with_patches + rows.len());
        for group in &mut self.groups {
            *group = numbers[*group - old.partition_point(|row| row < group)];
        }
        self.empty_rows = rows;
        Ok(self)
    }

    /// The rows without a patch, in order.
    #[must_use]
    pub fn empty_rows(&self) -> &[EmptyRow] {
        &self.empty_rows
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

    /// The row that this patch is summed into: rows are numbered from 0 in the order of their first
    /// patches.
    #[must_use]
    pub fn group_of(&self, index: usize) -> usize {
        self.groups[index]
    }

    /// The number of rows: that of the patches unless some are summed or rows have none.
    #[must_use]
    pub fn group_count(&self) -> usize {
        let empty = self.empty_rows.iter().map(|empty| &empty.row);
        let last = self.groups.iter().chain(empty).max();
        last.map_or(0, |last| last + 1)
    }

    /// The first patch that is not the first of its row, if any patches are summed.
    pub(crate) fn first_summed(&self) -> Option<usize> {
        let mut is_seen = vec![false; self.group_count()];
        let mut groups = self.groups.iter();
        groups.position(|group| std::mem::replace(&mut is_seen[*group], true))
    }

    /// The one patch that a row is.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::RowWithoutPatch`];
    /// [`SceneError::NotAPatchOfItsOwn`] if several are summed.
    pub fn patch_of_row(&self, row: usize) -> Result<usize, SceneError> {
        let last = self.group_count() - 1;
        let mut patches = self.patches_of_group(row);
        match (patches.next(), patches.next()) {
            (Some(patch), None) => Ok(patch),
            (Some(_), Some(_)) => {
                let (index, what) = (row, "is summed of several");
                Err(SceneError::NotAPatchOfItsOwn { index, what })
            }
            (None, _) => Err(match self.empty_row(row) {
                Some(EmptyRow { name, .. }) => SceneError::RowWithoutPatch {
                    row,
                    name: name.clone(),
                },
                None => SceneError::NoSuchPatch { index: row, last },
            }),
        }
    }

    /// The row with this number, if it has no patch.
    pub(super) fn empty_row(&self, row: usize) -> Option<&EmptyRow> {
        let place = self
            .empty_rows
            .binary_search_by_key(&row, |empty| empty.row);
        place.ok().map(|place| &self.empty_rows[place])
    }

    /// The patches of a row, in order; the first one names it.
    pub fn patches_of_group(&self, group: usize) -> impl Iterator<Item = usize> {
        let groups = self.groups.iter().enumerate();
        groups.filter_map(move |(patch, row)| (*row == group).then_some(patch))
    }

    /// The patches of some rows, in order.
    pub(crate) fn patches_of_groups(&self, groups: &[usize]) -> impl Iterator<Item = usize> {
        let groups: HashSet<usize> = groups.iter().copied().collect();
        let patches = self.groups.iter().enumerate();
        patches.filter_map(move |(patch, row)| groups.contains(row).then_some(patch))
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

    /// The name of each row, in order: its own if it has no patch, else that of its first patch.
    #[must_use]
    pub fn group_names(&self) -> Vec<&str> {
        let mut names = vec![""; self.group_count()];
        for (patch, group) in self.patches.iter().zip(&self.groups).rev() {
            names[*group] = patch.name();
        }
        for empty in &self.empty_rows {
            names[empty.row] = &empty.name;
        }
        names
    }

    /// The rows that have this name, or a patch that is a piece of something that has it, in order.
    #[must_use]
    pub fn groups_named(&self, name: &str) -> Vec<usize> {
        let mut rows: Vec<usize> = Vec::new();
        for (patch, group) in self.patches.iter().zip(&self.groups) {
            if patch.name == name || patch.wholes.iter().any(|whole| whole == name) {
                rows.push(*group);
            }
        }
        let empty = self.empty_rows.iter().filter(|empty| empty.name == name);
        rows.extend(empty.map(|empty| empty.row));
        rows.sort_unstable();
        rows.dedup();
        rows
    }

    /// The names of patches and of what they are pieces of, each once, in alphabetical order.
    pub(crate) fn known_names(&self) -> BTreeSet<&str> {
        let own = self.patches.iter().map(|patch| patch.name.as_str());
        let wholes = self.patches.iter().flat_map(|patch| patch.wholes.iter());
        let empty = self.empty_rows.iter().map(|empty| empty.name.as_str());
        own.chain(wholes.map(String::as_str)).chain(empty).collect()
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

/// The refusal of a part that does not lie in its base.
const fn refusal(part: usize, base: usize, reason: NotContained) -> SceneError {
    match reason {
        NotContained::OffPlane { deviation, allowed } => SceneError::PartOffPlane {
            part,
            base,
            deviation,
            allowed,
        },
        NotContained::FacesAway => SceneError::PartFacesAway { part, base },
        NotContained::ReachesOut => SceneError::PartOutside { part, base },
    }
}
