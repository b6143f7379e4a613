//! The bound over the true error.

use super::rooms::{MIXED, Room};
use super::truth::{Exchange, Truth, uniform};
use infoscene::hierarchy::ErrorBound;
use std::time::Instant;

/// `‖B − B_h‖ ≤ bound ≤ 4 ‖B − B_h‖` up to R = 0.95, in three rooms; the table is printed.
#[test]
#[ignore = "a table: cargo test --release --test library effectivity -- --ignored --nocapture"]
fn bounds_are_a_few_times_the_error() {
    let fine: f64 = std::env::var("INFOSCENE_FINE").map_or(16.0, |n| n.parse().unwrap());
    let coarse: f64 = std::env::var("INFOSCENE_COARSE").map_or(0.125, |n| n.parse().unwrap());
    for (number, room) in Room::all().iter().enumerate() {
        let truth = Truth::of(&uniform(&room.scene, 1.0 / fine));
        for size in [0.25, 0.125, 1.0 / 16.0] {
            if size < coarse {
                continue;
            }
            let tree = uniform(&room.scene, size);
            let exchange = Exchange::of(&tree);
            let cases = [0.3, 0.5, 0.7, 0.9, 0.95, 0.99].map(|r| [r; 6]);
            for faces in cases.into_iter().chain([MIXED]) {
                let light = room.lit(faces);
                let values = exchange.solved(&light);
                let points = truth.solved(&light);
                let [error, norm] = truth.error(&points, &tree, &light, &values);
                let start = Instant::now();
                let bound = ErrorBound::try_new(&room.scene, &tree, &light, &values).unwrap();
                let ratio = bound.absolute / error;
                assert!(ratio >= 1.0, "S{} {faces:?}: {ratio}", number + 1);
                assert!(
                    ratio <= 4.0 || faces[0] > 0.95,
                    "S{} {faces:?}: {ratio}",
                    number + 1
                );
                println!(
                    "S{} n={} R={} true={:.5} rel={:.4} bound={:.5} ratio={:.3} rel ratio {:.3} t={:.2}",
                    number + 1,
                    values.len(),
                    faces[0],
                    error,
                    error / norm,
                    bound.absolute,
                    ratio,
                    bound.relative / (error / norm),
                    start.elapsed().as_secs_f64()
                );
            }
        }
    }
}
