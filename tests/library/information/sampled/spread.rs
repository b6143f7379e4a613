//! Standard errors are the spread over seeds.

use super::{scene, slabs};
use crate::support::breadth::some_of;
use crate::support::rooms::{L, prism};
use infoscene::information::{LineKind, LineSample};
use infoscene::scene::Scene;

const SEEDS: u64 = 200;

/// Wilson and Hilferty: the quantile of χ² with k degrees of freedom at z standard deviations of a
/// normal.
fn chi_square(freedom: f64, z: f64) -> f64 {
    let part = 2.0 / (9.0 * freedom);
    freedom * (1.0 - part + z * part.sqrt()).powi(3)
}

/// `Σ (Î − mean)² / se²` is χ² with 199 degrees of freedom; 4.5 standard deviations, 7e-6 both
/// sides together, and 5 % of the standard error for what it is itself off by. That tells a factor
/// √2.
fn assert_spread(values: &[(f64, f64)], what: &str) {
    let n = values.len() as f64;
    let mean = values.iter().map(|(value, _)| value).sum::<f64>() / n;
    let squares: f64 = values.iter().map(|(value, _)| (value - mean).powi(2)).sum();
    let variance = values.iter().map(|(_, error)| error * error).sum::<f64>() / n;
    let found = squares / variance;
    let (low, high) = (
        chi_square(n - 1.0, -4.5) * 0.9,
        chi_square(n - 1.0, 4.5) * 1.1,
    );
    println!("{what}: {found} between {low} and {high}");
    assert!((low..high).contains(&found), "{what}: {found}");
}

fn samples(scene: &Scene, kind: LineKind, lines: u32) -> Vec<LineSample> {
    let draw = |seed| LineSample::draw(scene, kind, lines, seed).unwrap();
    (0..SEEDS).map(draw).collect()
}

#[test]
fn standard_errors_are_the_spread_over_seeds() {
    let concave = prism(&L);
    for (name, scene, kind, lines) in some_of([
        ("cube:2", scene("cube:2", 0), LineKind::Local, 4000),
        (
            "tetrahedron",
            scene("tetrahedron", 1),
            LineKind::Local,
            4000,
        ),
        ("box", scene("box:1,1,2", 1), LineKind::Global, 8000),
        ("slabs", slabs(12), LineKind::Global, 1000),
        ("L", concave, LineKind::Global, 3000),
    ]) {
        let samples = samples(&scene, kind, lines);
        let discrete = samples
            .iter()
            .map(|s| (s.counts.corrected(), s.counts.standard_error()));
        assert_spread(&discrete.collect::<Vec<_>>(), name);
        let plain = samples
            .iter()
            .map(|s| (s.counts.plug_in(), s.counts.standard_error()));
        assert_spread(&plain.collect::<Vec<_>>(), name);
        let continuous = samples
            .iter()
            .map(|s| (s.chords.mutual_information, s.chords.standard_error));
        assert_spread(&continuous.collect::<Vec<_>>(), name);
    }
}
