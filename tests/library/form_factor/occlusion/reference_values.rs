//! Values of 54 pairs past others, by two independent integrals, against the rules here.

use crate::support::references::{Row, rows};
use infoscene::form_factor::{Occluders, Polygon};
use infoscene::geometry::Patch;
use infoscene::reference::exchange_area_past;
use std::time::Instant;

fn cases() -> Vec<(Row, Vec<Patch>)> {
    let rows = rows("occlusion.csv").into_iter();
    rows.map(|row| {
        let polygons = row.polygons();
        (row, polygons)
    })
    .collect()
}

#[test]
#[ignore]
fn show() {
    for (row, polygons) in cases() {
        let [first, second, blockers @ ..] = polygons.as_slice() else {
            panic!()
        };
        let begun = Instant::now();
        let area = first.area();
        let found = exchange_area_past(first, second, blockers, 1e-13).unwrap();
        let value = row.number("value");
        println!(
            "{:28} {:.15e} {:.15e} rel {:9.2e} est {:9.2e} unc {:9.2e} area {area} {:?}",
            row.id,
            found.value / area,
            value,
            (found.value / area - value) / value,
            found.error / area / value,
            row.number("uncertainty"),
            begun.elapsed()
        );
    }
}
