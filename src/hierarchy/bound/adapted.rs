//! Cells that are small where the residual costs most, and the norms that they give.
//!
//! A fluctuation counts by its square over the damping of its cell, which small cells raise near
//! edges. So the cells that bring most of the energy are cut, and measured again.
//!
//! Where something may stand between cells, large ones are hardly coupled, and the least damped of
//! them decides how much of the error spreads. There half of the cuts go to large cells with little
//! damping, whose parts see others for certain.

use super::cells::{Cells, LeafPart};
use super::dark::Dark;
use super::minorant::{Couplings, Energy, Minorant, Split};
use super::piece::Integrals;
use super::sight::Sight;
use super::task::{FUNCTIONS, Measured};
use crate::hierarchy::{Element, HierarchyError, Lighting, Tree};
use crate::numeric::real;

/// Cells of about one size, to begin with.
const EVEN: usize = 160;
/// Cells in the end, about.
const BUDGET: usize = 400;
/// Cells in the end where something may stand between them and a patch reflects much: the damping
/// is at least 1/R − 1, and what is hidden counts where that is little.
const HIDDEN_BUDGET: usize = 800;
/// The reflectance from which on a patch reflects much.
const MUCH: f64 = 0.8;
/// The factor by which their number grows in a round, at most.
const GROWTH: f64 = 1.35;

/// The functions on pieces: the leaves in which these lie, and their elements.
pub(super) type Measure<'m> = dyn Fn(&[(usize, &Element)]) -> Vec<[Measured; FUNCTIONS]> + 'm;

/// The cells, their pieces and the operator.
#[derive(Debug, Clone)]
pub(super) struct Adapted {
    cells: Cells,
    pieces: Vec<LeafPart>,
    minorant: Minorant,
}

impl Adapted {
    /// The cells for functions of which the first is what costs, and all of them on the pieces.
    ///
    /// # Errors
    /// [`HierarchyError::Element`]; [`HierarchyError::NotDamped`].
    pub(super) fn try_new(
        tree: &Tree,
        light: &Lighting,
        sight: &Sight,
        measure: &Measure<'_>,
    ) -> Result<(Self, Vec<[Measured; FUNCTIONS]>), HierarchyError> {
        let reflectances = light.reflectances();
        let dark = Dark::of(tree, reflectances)?;
        let reflects_much = reflectances.iter().any(|reflectance| *reflectance > MUCH);
        let budget = if sight.can_be_hidden() && reflects_much {
            HIDDEN_BUDGET
        } else {
            BUDGET
        };
        let mut cells = Cells::new(tree, reflectances);
        cells.cut_largest(EVEN)?;
        let mut known: Vec<Option<[Measured; FUNCTIONS]>> = Vec::new();
        loop {
            let pieces = cells.pieces();
            known.resize(cells.element_count(), None);
            let open = pieces.iter().filter(|piece| known[piece.element].is_none());
            let open: Vec<LeafPart> = open.copied().collect();
            let elements: Vec<_> = open
                .iter()
                .map(|p| (p.leaf, cells.element(p.element)))
                .collect();
            for (piece, measured) in open.iter().zip(measure(&elements)) {
                known[piece.element] = Some(measured);
            }
            let measured = pieces.iter().filter_map(|piece| known[piece.element]);
            let measured: Vec<_> = measured.collect();
            let couplings = Couplings::of(&cells.cells(), reflectances, &dark, sight);
            if couplings.damping.len() >= budget {
                let adapted = Self {
                    cells,
                    pieces,
                    minorant: Minorant::try_new(couplings)?,
                };
                return Ok((adapted, measured));
            }
            let mut energy = vec![0.0; couplings.damping.len()];
            for (piece, measured) in pieces.iter().zip(&measured) {
                energy[piece.cell] += measured[0].known.second / couplings.damping[piece.cell];
            }
            let mut chosen = worst(&energy, budget);
            if sight.can_be_hidden() {
                let weak = worst(&weakness(&cells, &couplings), budget);
                chosen = merged(&chosen, &weak);
            }
            cells.cut(&chosen)?;
        }
    }

    /// The operator.
    pub(super) const fn minorant(&self) -> &Minorant {
        &self.minorant
    }

    /// The pieces.
    pub(super) fn pieces(&self) -> &[LeafPart] {
        &self.pieces
    }

    /// The pieces' leaves and elements.
    pub(super) fn elements(&self) -> Vec<(usize, &Element)> {
        let of = |piece: &LeafPart| (piece.leaf, self.cells.element(piece.element));
        self.pieces.iter().map(of).collect()
    }

    /// The energy of a function that was measured, and whose integral may be known, with a bound on
    /// its error.
    ///
    /// The inverse has no negative entry, so that bounds on the means of the rest do for them.
    pub(super) fn energy(&self, measured: &[Measured], total: Option<[f64; 2]>) -> Energy {
        let known = self.sums(measured.iter().map(|part| part.known));
        let found: f64 = known.iter().map(|sum| sum.first).sum();
        let known = Split::new(&known, self.minorant.areas());
        let rest = self.sums(measured.iter().map(|part| part.rest));
        let rest = Split {
            totals: rest.iter().map(|sum| sum.first).collect(),
            fluctuations: rest.iter().map(|sum| sum.second).collect(),
        };
        let apart = self.minorant.norm(&rest);
        let most: f64 = rest.totals.iter().sum();
        debug_assert!(
            total.is_none_or(|[total, error]| (total - found).abs() <= most + 2.0 * error),
            "parts that add up to {found}, not {total:?}"
        );
        let of_rest = total.map(|[total, error]| (total - found).abs() + error);
        let rest = of_rest.map_or(apart, |total| {
            apart.min(self.minorant.norm_beside_mean(&rest, total))
        });
        Energy {
            known: self.minorant.norm(&known),
            rest,
            split: known,
        }
    }

    /// Sums of integrals over pieces, by cell.
    fn sums(&self, integrals: impl Iterator<Item = Integrals>) -> Vec<Integrals> {
        let mut sums = vec![Integrals::default(); self.minorant.areas().len()];
        for (part, integral) in self.pieces.iter().zip(integrals) {
            sums[part.cell].add(&integral);
        }
        sums
    }
}

/// How far cells are from being damped: their areas over the squares of their damping.
fn weakness(cells: &Cells, couplings: &Couplings) -> Vec<f64> {
    let cells = cells.cells().into_iter().zip(&couplings.damping);
    cells
        .map(|(cell, damping)| cell.shape().area() / (damping * damping))
        .collect()
}

/// As many as there are in the first ranking, half of them the first of each.
fn merged(first: &[usize], second: &[usize]) -> Vec<usize> {
    let mut chosen = first[..first.len().div_ceil(2)].to_vec();
    for place in second {
        if chosen.len() < first.len() && !chosen.contains(place) {
            chosen.push(*place);
        }
    }
    chosen
}

/// The cells with the largest values: so many that cutting them is a round.
fn worst(values: &[f64], budget: usize) -> Vec<usize> {
    let count = real(values.len());
    let more = (count * GROWTH).min(real(budget)) - count;
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    // a cut leaves three more
    let chosen = order.into_iter().enumerate();
    let chosen = chosen.take_while(|(place, _)| 3.0 * real(*place) < more);
    chosen.map(|(_, cell)| cell).collect()
}
