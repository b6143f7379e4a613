//! Streets of blocks whose facades are cut into facets, and what makes them difficult.

use super::furnished::standing;
use super::rooms::{facing, level};
use infoscene::scene::NamedPatch;

/// Blocks that stand in rows on both sides of roads.
#[derive(Debug, Clone, Copy)]
pub struct Street {
    pub rows: u32,
    pub blocks: u32,
    /// Facets of a facade, along it and up.
    pub facets: [u32; 2],
    /// Between two blocks of a row.
    pub gap: f64,
    /// How far every third block stands back.
    pub back: f64,
}

/// The width and the depth of a block, and the width of a road.
const WIDTH: f64 = 12.0;
const DEPTH: f64 = 8.0;
const ROAD: f64 = 16.0;
const HEIGHTS: [f64; 5] = [8.0, 14.0, 11.0, 18.0, 9.0];

impl Street {
    /// The facades, roofs and roads, all fronts outward.
    pub fn patches(&self) -> Vec<NamedPatch> {
        let mut patches = Vec::new();
        for row in 0..self.rows {
            let near = f64::from(row) * (DEPTH + ROAD);
            for block in 0..self.blocks {
                let left = f64::from(block) * (WIDTH + self.gap);
                let back = f64::from((block + row) % 3) * self.back;
                let [x, y] = [[left, left + WIDTH], [near + back, near + back + DEPTH]];
                let height = HEIGHTS[((3 * block + 2 * row) % 5) as usize];
                patches.extend(self.block(x, y, height));
                if row + 1 < self.rows {
                    let end = near + DEPTH + ROAD;
                    let x = [left, left + WIDTH + self.gap];
                    patches.push(level(
                        "road",
                        x,
                        [near + DEPTH + 2.0 * self.back, end],
                        0.0,
                        true,
                    ));
                }
            }
        }
        patches
    }

    /// A block without a bottom, its sides in facets.
    fn block(&self, x: [f64; 2], y: [f64; 2], height: f64) -> Vec<NamedPatch> {
        let faces = standing("facade", x, y, [0.0, height]);
        let (roof, sides) = faces.split_last().expect("five faces");
        let facets = sides.iter().flat_map(|side| cut(side, self.facets));
        facets.chain([roof.clone()]).collect()
    }
}

/// A parallelogram in facets, along its first edge and along its last.
pub fn cut(side: &NamedPatch, [across, up]: [u32; 2]) -> Vec<NamedPatch> {
    let corners = side.shape().corners();
    let (origin, u) = (corners[0], corners[1] - corners[0]);
    let v = corners[corners.len() - 1] - corners[0];
    let at = |i: u32, j: u32| {
        let [s, t] = [
            f64::from(i) / f64::from(across),
            f64::from(j) / f64::from(up),
        ];
        (origin + s * u + t * v).to_array()
    };
    let cells = (0..across).flat_map(|i| (0..up).map(move |j| (i, j)));
    let cell = |(i, j): (u32, u32)| {
        let around = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        facing(side.name(), around, true)
    };
    cells.map(cell).collect()
}
