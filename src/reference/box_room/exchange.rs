//! The exchange of all cells of a box: a product with values at the crossings of its lines.

use super::grid::{FACES, Grid};
use crate::numeric::parallel_map;

/// G between the crossings of every two faces.
#[derive(Debug)]
pub(super) struct Exchange {
    pairs: Vec<([usize; 2], Vec<f64>)>,
}

impl Exchange {
    pub(super) fn new(grid: &Grid) -> Self {
        let pairs = (0..FACES).flat_map(|f| (f + 1..FACES).map(move |g| [f, g]));
        let pairs: Vec<[usize; 2]> = pairs.collect();
        let nodes: Vec<_> = (0..FACES).map(|face| grid.nodes(face)).collect();
        let table = |pair: usize| {
            let [f, g] = pairs[pair];
            let rows = nodes[f].iter();
            let values = rows.flat_map(|p| nodes[g].iter().map(|q| grid.potential([f, g], *p, *q)));
            ([f, g], values.collect())
        };
        Self {
            pairs: parallel_map(pairs.len(), &table),
        }
    }

    /// The power that arrives at each cell, by faces, from cells with these radiosities.
    pub(super) fn received(&self, grid: &Grid, radiosity: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let faces = radiosity.iter().enumerate();
        let sent: Vec<_> = faces
            .map(|(face, cells)| grid.to_nodes(face, cells))
            .collect();
        let products = parallel_map(self.pairs.len(), &|pair| {
            let ([f, g], table) = &self.pairs[pair];
            let [mut at_f, mut at_g] = [*f, *g].map(|face| vec![0.0; sent[face].len()]);
            for ((row, out), own) in table.chunks(sent[*g].len()).zip(&mut at_f).zip(&sent[*f]) {
                for ((value, its), back) in row.iter().zip(&sent[*g]).zip(&mut at_g) {
                    *out += value * its;
                    *back += value * own;
                }
            }
            [(*f, at_f), (*g, at_g)]
        });
        let mut received: Vec<_> = sent.iter().map(|nodes| vec![0.0; nodes.len()]).collect();
        for (face, part) in products.into_iter().flatten() {
            for (sum, value) in received[face].iter_mut().zip(part) {
                *sum += value;
            }
        }
        let faces = received.iter().enumerate();
        faces
            .map(|(face, nodes)| grid.to_cells(face, nodes))
            .collect()
    }
}
