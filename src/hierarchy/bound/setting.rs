//! A scene and its leaves, made ready for residuals.

use super::adjoint::DiscreteOperator;
use super::leaf::Leaf;
use super::piece::Piece;
use super::sight::{End, Sight};
use super::task::{FUNCTIONS, Measured, Task};
use super::views::Views;
use crate::form_factor::{DEFAULT_TOLERANCE, ExchangeArea};
use crate::geometry::convex_pieces;
use crate::hierarchy::{Element, HierarchyError, Lighting, Visibility};
use crate::numeric::{compensated_sum, parallel_map};
use crate::scene::Scene;
use nalgebra::DMatrix;
use std::array::from_fn;

/// The parts of residuals that their remainders may be about: of the radiosities', and of adjoint
/// ones, which count by their product with it.
const REMAINDERS: [f64; FUNCTIONS] = [0.15, 0.3, 0.3, 0.3];
/// The roughness that a function has at least, per deviation of its values.
const LEVEL: f64 = 0.02;

/// A scene and its leaves.
#[derive(Debug, Clone)]
pub(super) struct Setting {
    pub(super) light: Lighting,
    pub(super) operator: DiscreteOperator,
    views: Views,
    /// The exchange area of each leaf with all dark patches; known in a closed scene.
    taken: Option<Vec<ExchangeArea>>,
    noise: f64,
}

impl Setting {
    /// The setting of a scene's leaves in their views.
    ///
    /// # Errors
    /// [`HierarchyError::Pair`].
    pub(super) fn try_new(
        scene: &Scene,
        views: Views,
        light: &Lighting,
        is_closed: bool,
    ) -> Result<Self, HierarchyError> {
        let mut setting = Self {
            light: light.clone(),
            operator: discrete(&views, light),
            views,
            taken: None,
            noise: scene.noise_length(),
        };
        if is_closed {
            setting.taken = Some(setting.taken()?);
        }
        Ok(setting)
    }

    /// What stands between patches.
    pub(super) const fn sight(&self) -> &Sight {
        &self.views.sight
    }

    /// The height up to which a point counts as in a plane.
    pub(super) const fn noise(&self) -> f64 {
        self.noise
    }

    /// The leaves as patches see them.
    pub(super) const fn views(&self) -> &Views {
        &self.views
    }

    /// The leaves.
    pub(super) fn leaves(&self) -> &[Leaf] {
        &self.views.leaves
    }

    pub(super) fn reflectance(&self, leaf: usize) -> f64 {
        self.light.reflectances()[self.leaves()[leaf].patch]
    }

    pub(super) fn area(&self, leaf: usize) -> f64 {
        self.leaves()[leaf].shape.area()
    }

    /// The remainders that are allowed of functions, in the root mean square.
    pub(super) fn allowed(
        &self,
        values: [&[f64]; FUNCTIONS],
        constants: [&[f64]; FUNCTIONS],
    ) -> [f64; FUNCTIONS] {
        from_fn(|k| REMAINDERS[k] * self.roughness(values[k], constants[k]))
    }

    /// The functions `c + K b` on pieces of leaves, for values b and constants c by leaf.
    pub(super) fn measured(
        &self,
        pieces: &[(usize, &Element)],
        values: [&[f64]; FUNCTIONS],
        constants: [&[f64]; FUNCTIONS],
        allowed: [f64; FUNCTIONS],
    ) -> Vec<[Measured; FUNCTIONS]> {
        parallel_map(pieces.len(), &|index| {
            let (leaf, element) = pieces[index];
            let Some(view) = self.views.view(element.patch()) else {
                return Default::default();
            };
            let references = self.references(element, values);
            let task = Task {
                views: &self.views,
                view,
                values,
                references,
                allowed,
                noise: self.noise,
            };
            let constants = from_fn(|k| constants[k][leaf] + references[k]);
            let mut sums = [Measured::default(); FUNCTIONS];
            let shape = element.shape();
            for corners in convex_pieces(shape.corners(), shape.normal()) {
                let piece = Piece::new(
                    corners
                        .iter()
                        .map(|corner| view.frame.flat(*corner))
                        .collect(),
                );
                for (sum, measured) in sums.iter_mut().zip(task.measured(&piece, constants)) {
                    sum.add(&measured);
                }
            }
            sums
        })
    }

    /// `∫ b²` of values by leaf.
    pub(super) fn square(&self, values: &[f64]) -> f64 {
        self.product(values, values)
    }

    /// `∫ g b` of values by leaf.
    pub(super) fn product(&self, weights: &[f64], values: &[f64]) -> f64 {
        let leaves = weights.iter().zip(values).enumerate();
        leaves.map(|(leaf, (g, b))| self.area(leaf) * g * b).sum()
    }

    /// `(E − b)/R` by leaf, 0 where nothing is reflected.
    pub(super) fn constants(&self, values: &[f64]) -> Vec<f64> {
        let constant = |(leaf, value): (usize, &f64)| {
            let emitted = self.light.emittances()[self.leaves()[leaf].patch];
            let reflectance = self.reflectance(leaf);
            if reflectance > 0.0 {
                (emitted - value) / reflectance
            } else {
                0.0
            }
        };
        values.iter().enumerate().map(constant).collect()
    }

    /// `g − ψ/R` by leaf, 0 where nothing is reflected.
    pub(super) fn adjoint_constants(&self, goal: &[f64], adjoint: &[f64]) -> Vec<f64> {
        let leaves = goal.iter().zip(adjoint).enumerate();
        let constant = |(leaf, (goal, adjoint)): (usize, (&f64, &f64))| {
            let reflectance = self.reflectance(leaf);
            if reflectance > 0.0 {
                goal - adjoint / reflectance
            } else {
                0.0
            }
        };
        leaves.map(constant).collect()
    }

    /// Does the error of a patch count in the mean: does it reflect, and emit nothing? If all that
    /// reflect emit, all count.
    pub(super) fn is_unlit(&self, patch: usize) -> bool {
        let (reflectances, emittances) = (self.light.reflectances(), self.light.emittances());
        let is_dark = |patch: usize| emittances[patch] <= 0.0;
        let all_emit = (0..emittances.len()).all(|p| reflectances[p] <= 0.0 || !is_dark(p));
        reflectances[patch] > 0.0 && (all_emit || is_dark(patch))
    }

    /// 1 on leaves that count in the mean, 0 on others.
    pub(super) fn unlit(&self) -> Vec<f64> {
        let of = |leaf: &Leaf| if self.is_unlit(leaf.patch) { 1.0 } else { 0.0 };
        self.leaves().iter().map(of).collect()
    }

    /// Values near those that an element sees nearby; 0 in an open scene, whose form factors do
    /// not add up to 1.
    fn references(&self, element: &Element, values: [&[f64]; FUNCTIONS]) -> [f64; FUNCTIONS] {
        if self.taken.is_none() {
            return [0.0; FUNCTIONS];
        }
        let area = element.shape().area();
        let (mut sums, mut weights) = ([0.0; FUNCTIONS], 0.0);
        for (index, leaf) in self.leaves().iter().enumerate() {
            if leaf.patch == element.patch() || !self.is_unlit(leaf.patch) {
                continue;
            }
            let square = leaf.centre.distance_squared(element.centre()) + area;
            let weight = self.area(index) / (square * square * square);
            for (sum, values) in sums.iter_mut().zip(values) {
                *sum += weight * values[index];
            }
            weights += weight;
        }
        sums.map(|sum| if weights > 0.0 { sum / weights } else { 0.0 })
    }

    /// About how large a residual is, in the root mean square.
    ///
    /// A function whose values over the scene deviate by σ, smooth over faces of a sixth of the
    /// area, deviates by σ √(6 A_i/A) over a leaf; from what the residual should be, by its value
    /// at the centre.
    fn roughness(&self, values: &[f64], constants: &[f64]) -> f64 {
        let received = self.operator.irradiance(values);
        let counted = |leaf: &usize| self.is_unlit(self.leaves()[*leaf].patch);
        let leaves: Vec<usize> = (0..self.leaves().len()).filter(counted).collect();
        let total: f64 = leaves.iter().map(|leaf| self.area(*leaf)).sum();
        let share = |leaf: usize| self.area(leaf) / total;
        let mean = |of: &dyn Fn(usize) -> f64| -> f64 {
            leaves.iter().map(|leaf| share(*leaf) * of(*leaf)).sum()
        };
        let [level, value] = [mean(&|leaf| received[leaf]), mean(&|leaf| values[leaf])];
        let square = mean(&|leaf| {
            let smooth = 6.0 * share(leaf) * (received[leaf] - level).powi(2);
            let centre = (constants[leaf] + received[leaf]).powi(2);
            smooth + centre + (LEVEL * (values[leaf] - value)).powi(2)
        });
        square
            .sqrt()
            .max(f64::EPSILON * value.abs())
            .max(f64::MIN_POSITIVE)
    }

    /// `∫ (c + K b)` over all that reflects, with a bound on its error; known in a closed scene.
    ///
    /// ```text
    ///   ∫ K b = Σ_j b_j (A_j − Σ_black A_j F_jz)
    /// ```
    pub(super) fn total(&self, values: &[f64], constants: &[f64]) -> Option<[f64; 2]> {
        let taken = self.taken.as_ref()?;
        let leaves = values.iter().zip(constants).zip(taken).enumerate();
        let terms = leaves.flat_map(|(leaf, ((value, constant), taken))| {
            let area = self.area(leaf);
            let own = if self.reflectance(leaf) > 0.0 {
                *constant
            } else {
                0.0
            };
            [area * own, area * value, -value * taken.value]
        });
        let terms: Vec<f64> = terms.collect();
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        let errors = values.iter().zip(taken);
        let error: f64 = errors.map(|(value, taken)| value.abs() * taken.error).sum();
        Some([compensated_sum(terms), error + 1e-13 * size])
    }

    /// By leaf, its exchange area with all that reflects nothing.
    fn taken(&self) -> Result<Vec<ExchangeArea>, HierarchyError> {
        let mut taken = vec![ExchangeArea::NOTHING; self.leaves().len()];
        let black = (0..taken.len()).filter(|leaf| self.reflectance(*leaf) <= 0.0);
        for first in black {
            for (second, sum) in taken.iter_mut().enumerate() {
                let exchange = self.exchange_area(first, second)?;
                sum.value += exchange.value;
                sum.error += exchange.error;
            }
        }
        Ok(taken)
    }

    /// The exchange area of two leaves.
    fn exchange_area(&self, first: usize, second: usize) -> Result<ExchangeArea, HierarchyError> {
        let leaves = [first, second].map(|leaf| &self.leaves()[leaf]);
        let polygons = leaves.map(|leaf| &leaf.polygon);
        let ends = leaves.map(|leaf| End::of(leaf.patch, &leaf.shape));
        let exchange = match self.sight().between(ends) {
            Visibility::Hidden => return Ok(ExchangeArea::NOTHING),
            Visibility::Past(plates) => self.sight().exchange_area(polygons, &plates),
            Visibility::Clear => polygons[0]
                .exchange_area(polygons[1], DEFAULT_TOLERANCE)
                .map(|answer| answer.exchange),
        };
        exchange.map_err(|source| HierarchyError::Pair {
            first,
            second,
            source,
        })
    }
}

/// The operator of point factors from the centres of leaves.
fn discrete(views: &Views, light: &Lighting) -> DiscreteOperator {
    let n = views.leaves.len();
    let rows = parallel_map(n, &|index| -> Vec<f64> {
        let mut row = vec![0.0; n];
        let leaf = &views.leaves[index];
        if let Some(view) = views.view(leaf.patch) {
            let centre = view.frame.flat(leaf.centre);
            let shares = views.shares(view, leaf.centre);
            for source in &view.sources {
                let (factor, [left, right]) = (source.factor(centre), source.sides(&shares));
                row[source.left] += left * factor;
                if let Some(other) = source.right {
                    row[other] -= right * factor;
                }
            }
        }
        row
    });
    let factors = DMatrix::from_fn(n, n, |i, j| rows[i][j]);
    let areas = views.leaves.iter().map(|leaf| leaf.shape.area()).collect();
    let reflectances = views
        .leaves
        .iter()
        .map(|leaf| light.reflectances()[leaf.patch]);
    DiscreteOperator::new(factors, areas, &reflectances.collect::<Vec<f64>>())
}
