//! The regular solids by a road of its own: elementary integrals in the cross-sections through the
//! normal of a point.

use super::{MODERATE, SOLIDS, information};
use glam::DVec3;
use infoscene::geometry::Patch;
use infoscene::scene::Scene;
use std::f64::consts::{E, FRAC_PI_2, LN_2, PI, TAU};

/// Nodes on (0, 1) with what they lack of 1, and weights; the distances from the ends shrink doubly
/// exponentially (Takahasi and Mori, 1974).
fn doubly_exponential(step: f64) -> Vec<[f64; 3]> {
    let steps = (3.2 / step).round() as i32;
    let nodes = (-steps..=steps).map(|k| {
        let t = f64::from(k) * step;
        let u = PI * t.sinh();
        let [node, rest] = [-u, u].map(|u| 1.0 / (1.0 + u.exp()));
        [node, rest, step * PI * t.cosh() * node * rest]
    });
    nodes.collect()
}

/// `∫ sin α cos α ln r dα` over the elevation α from 0 to π/2, where `1/r = max_j (p_j cos α + q_j
/// sin α)`.
///
/// With `p cos α + q sin α = ρ cos u`, `u = α − γ`:
///
/// ```text
///   −∫ sin α cos α ln(ρ cos u) = −½ ln ρ sin²α − ½ cos 2γ (½ cos²u − cos²u ln cos u)
///                                − ½ sin 2γ (½ sin 2u ln cos u + u/2 − ¼ sin 2u)
/// ```
fn section(planes: &[[f64; 2]]) -> f64 {
    let value = |[p, q]: [f64; 2], alpha: f64| p * alpha.cos() + q * alpha.sin();
    // of the two lines that cross at an end the flatter one keeps its digits
    let primitive = |[p, q]: [f64; 2], alpha: f64, crossed: [f64; 2]| {
        let (rho, gamma) = (p.hypot(q), q.atan2(p));
        let nearer = if rho < crossed[0].hypot(crossed[1]) {
            [p, q]
        } else {
            crossed
        };
        let ln = (value(nearer, alpha) / rho).ln();
        let u = alpha - gamma;
        let (square, double) = (u.cos().powi(2), (2.0 * u).sin());
        -0.5 * (rho.ln() * alpha.sin().powi(2)
            + (2.0 * gamma).cos() * (0.5 * square - square * ln)
            + (2.0 * gamma).sin() * (0.5 * double * ln + 0.5 * u - 0.25 * double))
    };
    // the upper envelope of the lines p + q tan α, from the flattest to the steepest, each with the
    // α from which it leads
    let mut lines = planes.to_vec();
    lines.sort_by(|a, b| (a[1], a[0]).partial_cmp(&(b[1], b[0])).unwrap());
    let mut leading: Vec<(f64, [f64; 2])> = Vec::new();
    for line in lines {
        let mut from = 0.0;
        while let Some((since, last)) = leading.last() {
            from = (last[0] - line[0]).max(0.0).atan2(line[1] - last[1]);
            if from > *since {
                break;
            }
            leading.pop();
            from = 0.0;
        }
        leading.push((from, line));
    }
    let mut sum = 0.0;
    for (k, (from, line)) in leading.iter().enumerate() {
        let before = leading[k.saturating_sub(1)].1;
        let (to, after) = leading.get(k + 1).copied().unwrap_or((FRAC_PI_2, *line));
        sum += primitive(*line, to, after) - primitive(*line, *from, before);
    }
    sum
}

/// A point of a wall as the mean of three others, so that what is small keeps its digits.
struct Place {
    corners: [DVec3; 3],
    shares: [f64; 3],
}

impl Place {
    /// The mean of a function that is linear between the corners, where what is 0 but for rounding
    /// is 0.
    fn mean(&self, of: impl Fn(DVec3) -> f64) -> f64 {
        let parts = self.corners.iter().zip(self.shares).map(|(corner, share)| {
            let value = of(*corner);
            if value.abs() < 1e-14 {
                0.0
            } else {
                share * value
            }
        });
        parts.sum()
    }
}

/// `(1/π) ∫∫ cos θ ln r dω` from a point of a wall of a convex room.
fn mean_logarithm(
    place: &Place,
    normal: DVec3,
    walls: &[Patch],
    corners: &[DVec3],
    rule: &[[f64; 3]],
) -> f64 {
    let across = normal.any_orthonormal_vector();
    let up = normal.cross(across);
    // heights over the other walls, whose planes the point is not in
    let others: Vec<(DVec3, f64)> = walls
        .iter()
        .filter(|wall| wall.normal().dot(normal) < 1.0 - 1e-9)
        .map(|wall| {
            (
                wall.normal(),
                place.mean(|point| wall.normal().dot(point - wall.corners()[0])),
            )
        })
        .collect();
    let towards = |corner: &DVec3| {
        let [x, y] = [across, up].map(|axis| place.mean(|point| axis.dot(*corner - point)));
        y.atan2(x)
    };
    let mut turns: Vec<f64> = corners.iter().map(towards).collect();
    turns.sort_by(f64::total_cmp);
    turns.push(turns[0] + TAU);
    let mut sum = 0.0;
    for pair in turns.windows(2).filter(|pair| pair[1] - pair[0] > 1e-14) {
        for [t, _, weight] in rule {
            let turn = pair[0] + t * (pair[1] - pair[0]);
            let out = turn.cos() * across + turn.sin() * up;
            let planes: Vec<[f64; 2]> = others
                .iter()
                .map(|(n, h)| [-n.dot(out) / h, -n.dot(normal) / h])
                .collect();
            sum += weight * (pair[1] - pair[0]) * section(&planes);
        }
    }
    sum / PI
}

/// The closed formula `log2(A_T/(π e)) − 2 E[log2 r]`; by symmetry the mean over a triangle between
/// the middle of a face, the middle of an edge and one of its ends.
fn of_a_regular_solid(scene: &Scene, step: f64) -> f64 {
    let walls: Vec<Patch> = scene
        .patches()
        .iter()
        .map(|patch| patch.shape().clone())
        .collect();
    let mut corners: Vec<DVec3> = Vec::new();
    for corner in walls.iter().flat_map(Patch::corners) {
        if corners.iter().all(|other| other.distance(*corner) > 1e-9) {
            corners.push(*corner);
        }
    }
    let (face, normal) = (walls[0].corners(), walls[0].normal());
    let centre = face.iter().sum::<DVec3>() / face.len() as f64;
    let triangle = [centre, 0.5 * (face[0] + face[1]), face[0]];
    let rule = doubly_exponential(step);
    let mut mean = 0.0;
    for [out, short, v] in &rule {
        for [aside, beside, w] in &rule {
            let place = Place {
                corners: triangle,
                shares: [*short, out * beside, out * aside],
            };
            // twice the area element of the triangle, relative to its area
            mean += 2.0 * v * w * out * mean_logarithm(&place, normal, &walls, &corners, &rule);
        }
    }
    (scene.total_area() / (PI * E)).log2() - 2.0 * mean / LN_2
}

fn assert_agreement(name: &str) {
    let expected = of_a_regular_solid(&Scene::built_in(name).unwrap(), 0.12);
    let found = information(name);
    let off = (found.mutual_information.value - expected).abs();
    assert!(off < MODERATE * expected, "{name}: {expected} {found:?}");
}

/// Halving the step changes less than 1e-12 of the values.
#[test]
fn solids_agree_with_their_cross_sections() {
    SOLIDS[..3].iter().copied().for_each(assert_agreement);
}

#[test]
#[ignore = "seconds: cargo test --release --test library round_solids -- --ignored"]
fn round_solids_agree_with_their_cross_sections() {
    SOLIDS[3..].iter().copied().for_each(assert_agreement);
}
