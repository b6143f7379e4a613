//! The bound where something stands between patches, against a finer solution gathered once more.

use super::solver::room;
use crate::hierarchy::lit_rooms::{lighting, refined};
use infoscene::hierarchy::{ErrorBound, OracleName, Refinement};
use std::time::Instant;

/// A finer solution at points of its leaves, with the areas that they stand for.
struct Truth {
    points: Vec<(usize, glam::DVec3, f64, f64)>,
}

impl Truth {
    /// The light gathered once more over all that is no light.
    fn of(fine: &Refinement<'_>) -> Self {
        let mut points = Vec::new();
        for leaf in fine.tree().leaves() {
            let element = &fine.tree().elements()[leaf];
            if fine.lighting().is_light(element.patch()) {
                continue;
            }
            let area = element.shape().area() / element.shape().corners().len() as f64;
            for point in element.gauss_points() {
                let value = fine.gathered(leaf, point).unwrap();
                points.push((element.patch(), point, area, value));
            }
        }
        Self { points }
    }

    /// `‖B − B_h‖` over all that is no light, for constants.
    fn error(&self, room: &Refinement<'_>) -> f64 {
        let squares = self.points.iter().map(|(patch, point, area, value)| {
            let leaf = room.tree().leaf_at(*patch, *point).unwrap();
            area * (value - room.solution().radiosity[leaf]).powi(2)
        });
        squares.sum::<f64>().sqrt()
    }
}

/// `‖B − B_h‖ ≤ bound` past plates, a table and blocks; the table is printed.
#[test]
#[ignore = "minutes: cargo test --release --test library hidden_from -- --ignored --nocapture"]
fn meshes_of_rooms_with_patches_hidden_from_each_other_are_bounded() {
    let only = std::env::var("ROOM").ok();
    for name in [
        "shaded-cube",
        "lit-wings",
        "lit-table",
        "cornell-box-blocks",
    ] {
        if only.as_ref().is_some_and(|only| only != name) {
            continue;
        }
        for reflectance in [None, Some(0.5), Some(0.9), Some(0.95)] {
            let scene = room(name, reflectance);
            let lighting = lighting(&scene);
            let fine = refined(&scene, &lighting, OracleName::Gradient, 2000);
            let truth = Truth::of(&fine);
            for elements in [100, 300] {
                let room = refined(&scene, &lighting, OracleName::Gradient, elements);
                let leaves = room.tree().leaves();
                let values: Vec<f64> = leaves.map(|leaf| room.solution().radiosity[leaf]).collect();
                let start = Instant::now();
                let bound = ErrorBound::try_new(&scene, room.tree(), &lighting, &values).unwrap();
                let seconds = start.elapsed().as_secs_f64();
                let error = truth.error(&room);
                let ratio = bound.absolute / error;
                println!(
                    "{name} R={reflectance:?} {elements}: {error:.3e}, bound/error {ratio:.3}, \
                     {seconds:.2} s"
                );
                assert!(ratio >= 1.0, "{name} {elements}: {ratio}");
            }
        }
    }
}
