//! Lines along which the form factor from a point of a plane bends, and the cells between them.
//!
//! ```text
//!   plane through a vertex v and an edge (a, b):   m = (a − v) × (b − v)
//!   on the plane of P:                             m·(x − v) = 0
//! ```
//!
//! A line is kept where the line of sight from x through v meets the edge inside it.

use crate::geometry::{ClippedCorner, Patch, clip};
use glam::{DVec2, DVec3};

/// Corners within this, relative to the plane's coordinates, are on a line: cells are not cut
/// there.
const ON_A_LINE: f64 = 1e-12;

/// Coordinates in the plane of a polygon.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chart {
    origin: DVec3,
    across: DVec3,
    up: DVec3,
    normal: DVec3,
    size: f64,
}

impl Chart {
    pub(super) fn of(patch: &Patch) -> Self {
        let corners = patch.corners();
        let across = (corners[1] - corners[0]).normalize();
        let reach = corners.iter().map(|c| c.distance(corners[0]));
        Self {
            origin: corners[0],
            across,
            up: patch.normal().cross(across),
            normal: patch.normal(),
            size: reach.fold(0.0, f64::max),
        }
    }

    pub(super) fn point(&self, at: DVec2) -> DVec3 {
        self.origin + at.x * self.across + at.y * self.up
    }

    pub(super) fn flat(&self, point: DVec3) -> DVec2 {
        let from = point - self.origin;
        DVec2::new(from.dot(self.across), from.dot(self.up))
    }

    fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.normal)
    }

    /// The line in which a plane through `point` meets this one; `None` if they are parallel.
    fn line(&self, normal: DVec3, point: DVec3) -> Option<Line> {
        let direction = DVec2::new(normal.dot(self.across), normal.dot(self.up));
        let length = direction.length();
        (length > 1e-12 * normal.length()).then(|| Line {
            normal: direction / length,
            offset: normal.dot(self.origin - point) / length,
            sight: None,
        })
    }
}

/// `{ x : normal·x + offset = 0 }`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    normal: DVec2,
    offset: f64,
    /// The vertex and the edge that are seen in one.
    sight: Option<[DVec3; 3]>,
}

impl Line {
    fn height(&self, at: DVec2) -> f64 {
        self.normal.dot(at) + self.offset
    }
}

/// The lines of discontinuity of a receiver, first in the list, and its blockers.
pub(super) fn cuts(chart: &Chart, scene: &[&[DVec3]], normal: DVec3) -> (Chart, Vec<Line>) {
    let noise = ON_A_LINE * chart.size;
    let in_front = |outline: &[DVec3], height: &dyn Fn(DVec3) -> f64| -> Vec<DVec3> {
        let heights = outline.iter().map(|corner| height(*corner));
        let heights: Vec<f64> = heights
            .map(|height| if height.abs() <= noise { 0.0 } else { height })
            .collect();
        let mut kept = Vec::new();
        clip(&heights, |corner| {
            kept.push(match corner {
                ClippedCorner::Kept(i) => outline[i],
                ClippedCorner::Crossing { edge, share } => {
                    outline[edge[0]].lerp(outline[edge[1]], share)
                }
            });
        });
        kept
    };
    let before = |corner: DVec3| (corner - scene[0][0]).dot(normal);
    let mut lines: Vec<Line> = Vec::new();
    let mut outlines: Vec<Vec<DVec3>> = Vec::new();
    for (index, outline) in scene.iter().enumerate() {
        let seen = in_front(outline, &|corner| chart.height(corner));
        let seen = if index == 0 {
            seen
        } else {
            in_front(&seen, &before)
        };
        if seen.len() < 3 {
            continue;
        }
        let arms = outline.windows(2);
        let plane: DVec3 = arms
            .map(|pair| (pair[0] - outline[0]).cross(pair[1] - outline[0]))
            .sum();
        lines.extend(chart.line(plane, outline[0]));
        outlines.push(seen);
    }
    for (i, outline) in outlines.iter().enumerate() {
        for (j, other) in outlines.iter().enumerate() {
            if i == j {
                continue;
            }
            let next = other.iter().cycle().skip(1);
            for (a, b) in other.iter().zip(next) {
                lines.extend(outline.iter().filter_map(|vertex| {
                    let normal = (*a - *vertex).cross(*b - *vertex);
                    let is_plane = normal.length() > noise * a.distance(*b);
                    let line = is_plane.then(|| chart.line(normal, *vertex))??;
                    Some(Line {
                        sight: Some([*vertex, *a, *b]),
                        ..line
                    })
                }));
            }
        }
    }
    (*chart, lines)
}

/// Does the line of sight from a point of this part of the line meet the edge inside it?
fn is_seen(chart: &Chart, line: &Line, ends: [DVec2; 2]) -> bool {
    let Some([vertex, a, b]) = line.sight else {
        return true;
    };
    let normal = (a - vertex).cross(b - vertex);
    let sides = ends.map(|end| {
        let sight = chart.point(end) - vertex;
        [a, b].map(|corner| normal.dot(sight.cross(corner - vertex)))
    });
    let apart = |side: [f64; 2]| side[0] * side[1] <= 0.0;
    let turns = |k: usize| sides[0][k] * sides[1][k] <= 0.0;
    sides.into_iter().any(apart) || turns(0) || turns(1)
}

/// The convex cells into which lines cut a convex polygon, each line where it matters.
pub(super) fn cells(outline: Vec<DVec2>, (chart, lines): &(Chart, Vec<Line>)) -> Vec<Vec<DVec2>> {
    let whole = outline.clone();
    let mut cells = vec![outline];
    for line in lines {
        let crossings = crossings(&whole, line, 0.0);
        let [from, to] = crossings.as_slice() else {
            continue;
        };
        if !is_seen(chart, line, [*from, *to]) {
            continue;
        }
        cells = cells
            .iter()
            .flat_map(|cell| divided(cell, line, ON_A_LINE * chart.size))
            .collect();
    }
    cells
}

fn heights(cell: &[DVec2], line: &Line, noise: f64) -> Vec<f64> {
    let heights = cell.iter().map(|corner| line.height(*corner));
    heights
        .map(|height| if height.abs() <= noise { 0.0 } else { height })
        .collect()
}

/// The points in which a line enters and leaves a convex cell.
fn crossings(cell: &[DVec2], line: &Line, noise: f64) -> Vec<DVec2> {
    let heights = heights(cell, line, noise);
    let mut found = Vec::new();
    clip(&heights, |corner| match corner {
        ClippedCorner::Crossing { edge, share } => {
            found.push(cell[edge[0]].lerp(cell[edge[1]], share));
        }
        ClippedCorner::Kept(i) if heights[i] <= 0.0 => found.push(cell[i]),
        ClippedCorner::Kept(_) => {}
    });
    found
}

fn divided(cell: &[DVec2], line: &Line, noise: f64) -> Vec<Vec<DVec2>> {
    let above = heights(cell, line, noise);
    let is_cut = above.iter().any(|h| *h > 0.0) && above.iter().any(|h| *h < 0.0);
    if !is_cut {
        return vec![cell.to_vec()];
    }
    let below: Vec<f64> = above.iter().map(|height| -height).collect();
    let part = |heights: &[f64]| {
        let mut part = Vec::new();
        clip(heights, |corner| {
            part.push(match corner {
                ClippedCorner::Kept(i) => cell[i],
                ClippedCorner::Crossing { edge, share } => cell[edge[0]].lerp(cell[edge[1]], share),
            });
        });
        part
    };
    vec![part(&above), part(&below)]
}
