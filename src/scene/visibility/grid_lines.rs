//! Random lines in the inside of a box whose faces all carry one grid; their cells are found by
//! bisection.
//!
//! The cells are those of [`Scene::gridded_box`](crate::scene::Scene::gridded_box), in its order.
//!
//! **Not covered**: the cells' polygons, which these lines do without.

use crate::geometry::Slope;
use crate::scene::built_in::boxes::{box_faces, ends_of_cells};
use crate::scene::built_in::rectangle_patch;
use crate::scene::{Chord, SceneError};
use glam::DVec3;

/// The inside of a box with a grid on every face, for local lines.
#[derive(Debug, Clone)]
pub struct GridLines {
    edges: [f64; 3],
    lines: Vec<f64>,
}

/// The axis across each face and those that its columns and rows run along; even faces lie on the
/// lower side of the box.
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
    /// [`SceneError::Patch`] wherever [`Scene::gridded_box`](crate::scene::Scene::gridded_box)
    /// refuses.
    pub fn try_new(edges: [f64; 3], lines: &[f64]) -> Result<Self, SceneError> {
        let ends = ends_of_cells(lines)?;
        // one face a direction, of the narrowest cells, has all that can be wrong
        let narrowest = ends.windows(2).map(|cell| cell[1] - cell[0]);
        let narrowest = narrowest.fold(1.0, f64::min);
        let [x, y, z] = edges.map(|edge| narrowest * edge);
        let faces = box_faces(x * DVec3::X, y * DVec3::Y, z * DVec3::Z);
        for (index, (name, origin, u, v)) in faces.into_iter().enumerate() {
            rectangle_patch(index, name, origin, u, v)?;
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
        let Slope {
            around,
            sine,
            cosine,
        } = Slope::by_cosine([u, v]);
        let (mut origin, mut direction) = ([0.0; 3], [0.0; 3]);
        let inward = if face % 2 == 0 { 1.0 } else { -1.0 };
        origin[axis] = if face % 2 == 0 { 0.0 } else { self.edges[axis] };
        (origin[along], origin[across]) = (s * self.edges[along], t * self.edges[across]);
        direction[axis] = inward * cosine;
        (direction[along], direction[across]) = (sine * around.x, sine * around.y);
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
