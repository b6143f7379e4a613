//! Corollary 1, seen: discrete values rise to the continuous one.

use crate::support::rooms::tiled_box;
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::information::{OpenScene, continuous_information, scene_information};
use infoscene::scene::Occlusion;
use infoscene::study::refinement::{patch_sizes_per_edge, refinements};

/// Values rise from below, each above the one before, by gaps that tend to halve as patches do:
/// `I^c − I = c h + o(h)`, so that `2 I(h/2) − I(h)` is nearer to the limit. Both hold from the
/// second quartering on; the flat box needs patches as small as it is flat.
#[test]
fn refinements_rise_to_the_continuous_value() {
    let rows = refinements(true).unwrap();
    let mut pairs = 0;
    for row in &rows {
        assert!(row.gap > row.error + row.continuous_error, "{row:?}");
        let Some(ratio) = row.ratio else { continue };
        pairs += 1;
        assert!(ratio > 1.4 && ratio < 2.3, "{row:?}");
        let extrapolated = row.extrapolated_gap.unwrap().abs();
        assert!(extrapolated < row.gap, "{row:?}");
    }
    assert!(pairs >= 12);
}

/// The κ of rooms of squares is that of the cube, for boxes twice and three times as long, too.
/// `κ(h) = κ + (a + b ln h) h + …`, so that three sizes give κ but for h².
#[test]
fn rate_depends_on_the_edges_alone() {
    let kappa = |size: [f64; 3]| {
        let continuous = continuous_information(&tiled_box(size, 2.0)).unwrap();
        let continuous = continuous.mutual_information.value;
        let values = [2.0, 4.0, 8.0].map(|cells| {
            let room = tiled_box(size, cells);
            let pairs =
                ScenePairs::try_new(&room, 1e-12, Congruence::Shared, Occlusion::Refuse).unwrap();
            let discrete = scene_information(&pairs, OpenScene::Refuse).unwrap();
            (continuous - discrete.mutual_information.value) * patch_sizes_per_edge(&room).unwrap()
        });
        let halved = [0, 1].map(|k| 2.0 * values[k + 1] - values[k]);
        2.0 * halved[1] - halved[0]
    };
    let cube = kappa([1.0; 3]);
    for size in [[1.0, 1.0, 2.0], [1.0, 2.0, 2.0], [1.0, 2.0, 3.0]] {
        let room = kappa(size);
        println!("{size:?} {room} {cube}");
        assert!((room - cube).abs() < 0.01 * cube, "{size:?}: {room} {cube}");
    }
}
