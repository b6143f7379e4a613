//! The linear parts of radiosities on leaves.
//!
//! On the finer mesh `B_h = b + δ`, with means b and `δ = g·(x − c)`, c the centre of a leaf. With
//! `e = B − B̃` and B̃ − b constant on leaves,
//!
//! ```text
//!   ‖B − B_h‖² = ‖B̃ − b‖² + ‖δ‖² + 2 ⟨B̃ − b, e⟩ − 2 ⟨δ, e⟩ + ‖e‖²
//!   e = R f + R K e,    ⟨δ, e⟩ = ⟨R δ, f⟩ + ⟨K R δ, e⟩
//!   |⟨K R δ, e⟩| ≤ ‖K R δ‖ ‖e‖ ≤ ‖R δ‖ ‖e‖                 ‖K‖ ≤ 1: symmetric, no row above 1
//! ```
//!
//! What is known of f is quadratic on parts of pieces, of which `∫ x f` is exact; of the rest ρ,
//! `|⟨R δ, ρ⟩| ≤ Σ_pieces ‖R δ‖ ‖ρ‖`.

use super::jet::Jet;
use super::judged::Judged;
use super::piece::Piece;
use crate::geometry::convex_pieces;
use crate::hierarchy::Element;
use glam::{DVec2, DVec3};

/// The linear parts of radiosities, and their products with the residual.
#[derive(Debug, Clone, Default)]
pub(super) struct Slopes {
    /// `‖δ‖²` by leaf of the finer mesh.
    pub(super) squares: Vec<f64>,
    /// `⟨R δ, f⟩` by leaf of the finer mesh, as far as f is known.
    pub(super) products: Vec<f64>,
    /// A bound on `|⟨R δ, ρ⟩|`.
    doubt: f64,
    /// `‖R δ‖`.
    reflected: f64,
}

impl Slopes {
    /// The linear parts with these gradients by leaf of the finer mesh.
    pub(super) fn of(judged: &Judged, gradients: &[DVec3]) -> Self {
        let setting = &judged.setting;
        let count = setting.leaves().len();
        let mut slopes = Self {
            squares: vec![0.0; count],
            products: vec![0.0; count],
            ..Self::default()
        };
        let mut reflected = 0.0;
        let pieces = judged.adapted.elements();
        for ((leaf, element), residual) in pieces.into_iter().zip(&judged.residual) {
            let Some(view) = setting.views().view(element.patch()) else {
                continue;
            };
            let (frame, at) = (&view.frame, &setting.leaves()[leaf]);
            let gradient = frame.turned(gradients[leaf]).truncate();
            let centre = frame.flat(at.centre);
            let flat = |corner: DVec3| frame.flat(corner);
            let square = square(element, gradient, centre, &flat);
            let reflectance = setting.reflectance(leaf);
            let known = &residual.known;
            let product = gradient.dot(known.moment - known.first * centre);
            slopes.squares[leaf] += square;
            slopes.products[leaf] += reflectance * product;
            slopes.doubt += reflectance * (square * residual.rest.second).sqrt();
            reflected += reflectance * reflectance * square;
        }
        slopes.reflected = reflected.sqrt();
        slopes
    }

    /// `‖δ‖²`.
    pub(super) fn square(&self) -> f64 {
        self.squares.iter().sum()
    }

    /// `‖δ‖² − 2 ⟨δ, R f⟩`, as far as f is known.
    pub(super) fn shown(&self) -> f64 {
        self.square() - 2.0 * self.products.iter().sum::<f64>()
    }

    /// A lower bound on `⟨δ, e⟩`, from a bound on ‖e‖.
    pub(super) fn least_product(&self, error: f64) -> f64 {
        self.products.iter().sum::<f64>() - self.doubt - self.reflected * error
    }
}

/// `∫ (g·(x − c))²` over an element.
fn square(element: &Element, gradient: DVec2, centre: DVec2, flat: &dyn Fn(DVec3) -> DVec2) -> f64 {
    let shape = element.shape();
    let pieces = convex_pieces(shape.corners(), shape.normal()).into_iter();
    let squares = pieces.map(|corners| {
        let piece = Piece::new(corners.iter().map(|corner| flat(*corner)).collect());
        let linear = Jet {
            value: gradient.dot(piece.centre - centre),
            gradient,
            ..Jet::default()
        };
        let [integrals] = piece.integrals(&[linear]);
        integrals.second
    });
    squares.sum()
}
