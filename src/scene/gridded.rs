//! The inside of a box whose faces all carry the same grid: as a scene, and for lines that find their cells by bisection.
//!
//! Cells are numbered face by face: floor, ceiling, left, right, front, back; each row by row.
//!
//! **Not covered**: form factors.

use super::{Chord, NamedPatch, Scene, SceneError, built_in};
use glam::DVec3;
use std::f64::consts::TAU;

impl Scene {
    /// The inside of a box, each of its six faces cut by the same relative lines in both directions.
    ///
    /// **Arguments** `edges`: of the box. `lines`: increasing between 0 and 1, which are left out.
    ///
    /// # Errors
    /// [`SceneError::GridLine`] for the lines; [`SceneError::Patch`] unless edges and cells are finite and > 0.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let grid = Scene::gridded_box([1.0, 1.0, 2.0], &[0.25, 0.5])?;
    /// assert_eq!((grid.patches().len(), grid.total_area()), (6 * 9, 10.0));
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn gridded_box(edges: [f64; 3], lines: &[f64]) -> Result<Self, SceneError> {
        let ends = ends_of_cells(lines)?;
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let [x, y, z] = [0, 1, 2].map(|axis| edges[axis] * axes[axis]);
        let mut patches: Vec<NamedPatch> = Vec::with_capacity(6 * (lines.len() + 1).pow(2));
        for (name, origin, u, v) in built_in::box_faces(x, y, z) {
            for (row, across) in ends.windows(2).enumerate() {
                for (column, along) in ends.windows(2).enumerate() {
                    let index = patches.len();
                    // corners from the grid lines themselves, so that neighbours share them exactly
                    let corner = origin + u * along[0] + v * across[0];
                    let (du, dv) = (along[1] - along[0], across[1] - across[0]);
                    let name = format!("{name} {row},{column}");
                    let patch = built_in::rectangle_patch(index, &name, corner, u * du, v * dv)?;
                    patches.push(patch);
                }
            }
        }
        Self::try_new(patches)
    }
}

/// The lines with 0 and 1, if they increase.
fn ends_of_cells(lines: &[f64]) -> Result<Vec<f64>, SceneError> {
    let ends = [&[0.0], lines, &[1.0]].concat();
    // no comparison holds for NaN
    let increases =
        |index: &usize| ends[*index] < ends[index + 1] && ends[index + 1] < ends[index + 2];
    match (0..lines.len()).find(|index| !increases(index)) {
        Some(index) => Err(SceneError::GridLine {
            index,
            position: lines[index],
        }),
        None => Ok(ends),
    }
}

/// The same box for local lines, without its patches.
#[derive(Debug, Clone)]
pub struct GridLines {
    edges: [f64; 3],
    lines: Vec<f64>,
}

/// For each face the axis across it and those that its columns and rows run along; its side of the box is that of its number.
const AXES: [[usize; 3]; 6] = [
    [2, 0, 1],
    [2, 1, 0],
    [0, 1, 2],
    [0, 2, 1],
    [1, 2, 0],
    [1, 0, 2],
];

impl GridLines {
    /// A box with these edges, whose faces all have these relative lines.
    ///
    /// # Errors
    /// [`SceneError::Patch`] for what [`Scene::gridded_box`] refuses.
    pub fn try_new(edges: [f64; 3], lines: &[f64]) -> Result<Self, SceneError> {
        let ends = ends_of_cells(lines)?;
        // one face a direction, of the narrowest cells, has all that can be wrong
        let narrowest = ends.windows(2).map(|cell| cell[1] - cell[0]);
        let narrowest = narrowest.fold(1.0, f64::min);
        let [x, y, z] = edges.map(|edge| narrowest * edge);
        let faces = built_in::box_faces(x * DVec3::X, y * DVec3::Y, z * DVec3::Z);
        for (index, (name, origin, u, v)) in faces.into_iter().enumerate() {
            built_in::rectangle_patch(index, name, origin, u, v)?;
        }
        // squares stay in range in units of a power of two near the size
        let unit = edges
            .iter()
            .copied()
            .fold(0.0, f64::max)
            .log2()
            .round()
            .exp2();
        Ok(Self {
            edges: edges.map(|edge| edge / unit),
            lines: lines.to_vec(),
        })
    }

    /// The areas of the cells, in one unit.
    #[must_use]
    pub fn areas(&self) -> Vec<f64> {
        let ends = [&[0.0], self.lines.as_slice(), &[1.0]].concat();
        let widths: Vec<f64> = ends.windows(2).map(|cell| cell[1] - cell[0]).collect();
        let mut areas = Vec::with_capacity(6 * widths.len().pow(2));
        for [_, along, across] in AXES {
            let face = self.edges[along] * self.edges[across];
            for row in &widths {
                areas.extend(widths.iter().map(|column| face * row * column));
            }
        }
        areas
    }

    /// The chord of a local line; `None` for one that grazes its face.
    ///
    /// **Arguments** five uniform numbers from 0 to 1: three for the point, two for the direction.
    #[must_use]
    pub fn local(&self, [place, s, t, u, v]: [f64; 5]) -> Option<Chord> {
        let areas = AXES.map(|[_, along, across]| self.edges[along] * self.edges[across]);
        let total: f64 = areas.iter().sum();
        let mut left = place * total;
        let mut face = 0;
        while face < 5 && left >= areas[face] {
            left -= areas[face];
            face += 1;
        }
        let [axis, along, across] = AXES[face];
        let (sine, cosine) = (u.sqrt(), (1.0 - u).sqrt());
        let (y, x) = (TAU * v).sin_cos();
        let (mut origin, mut direction) = ([0.0; 3], [0.0; 3]);
        let inward = if face % 2 == 0 { 1.0 } else { -1.0 };
        origin[axis] = if face % 2 == 0 { 0.0 } else { self.edges[axis] };
        (origin[along], origin[across]) = (s * self.edges[along], t * self.edges[across]);
        direction[axis] = inward * cosine;
        (direction[along], direction[across]) = (sine * x, sine * y);
        let (mut distance, mut exit) = (f64::INFINITY, axis);
        for k in 0..3 {
            let end = if direction[k] > 0.0 {
                self.edges[k]
            } else {
                0.0
            };
            let next = (end - origin[k]) / direction[k];
            // a line leaves its own face's plane at 0
            if next < distance && (k != axis || next > 0.0) {
                (distance, exit) = (next, k);
            }
        }
        let arriving = direction[exit].abs();
        if !(distance > 0.0 && distance.is_finite() && cosine > 0.0 && arriving > 0.0) {
            return None;
        }
        let met = AXES.iter().position(|axes| axes[0] == exit)?;
        let met = met + usize::from(direction[exit] > 0.0);
        let point = |k: usize| (origin[k] + distance * direction[k]) / self.edges[k];
        let [_, met_along, met_across] = AXES[met];
        Some(Chord {
            rows: [
                self.cell(face, s, t),
                self.cell(met, point(met_along), point(met_across)),
            ],
            cosines: [cosine, arriving],
            square: distance * distance / total,
        })
    }

    fn cell(&self, face: usize, along: f64, across: f64) -> usize {
        let n = self.lines.len() + 1;
        let [column, row] =
            [along, across].map(|at| self.lines.partition_point(|line| *line <= at));
        (face * n + row) * n + column
    }
}
