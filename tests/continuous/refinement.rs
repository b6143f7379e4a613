//! Corollary 1, seen: discrete values rise to the continuous one.

use infoscene::study::refinement::refinements;

/// From below, each above the one before, by gaps that tend to halve as patches do: `I^c − I = c h + o(h)`, so that
/// `2 I(h/2) − I(h)` is nearer to the limit. Both hold from the second quartering on; the flat box needs patches as small as it is flat.
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
