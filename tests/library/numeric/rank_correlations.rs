//! Rank correlations against values by hand.

use infoscene::numeric::rank_correlation;

/// Without ties `1 − 6 Σ d²/(n (n² − 1))`: ranks 0 1 2 3 4 and 1 0 4 2 3 have Σ d² = 8.
#[test]
fn ranks_without_ties_have_the_value_of_their_differences() {
    let pairs = [
        [1.0, 0.2],
        [2.0, -7.0],
        [30.0, 9.0],
        [40.0, 1.0],
        [41.0, 1.5],
    ];
    let found = rank_correlation(&pairs, 0.0).unwrap();
    // products of halves are exact, a root and a quotient are not
    assert!((found - (1.0 - 6.0 * 8.0 / 120.0)).abs() < 1e-15);
}

/// Ranks 0, 1½, 1½, 3 against 0, 1, 2, 3: 4.5/√(4.5 · 5).
#[test]
fn tied_values_share_their_mean_rank() {
    let pairs = [[1.0, 1.0], [2.0, 2.0], [2.0 + 1e-10, 3.0], [5.0, 4.0]];
    let found = rank_correlation(&pairs, 1e-9).unwrap();
    assert!((found - 0.9_f64.sqrt()).abs() < 1e-15);
    assert_eq!(rank_correlation(&pairs, 0.0), Some(1.0));
}

#[test]
fn without_different_values_there_is_none() {
    assert_eq!(rank_correlation(&[[1.0, 2.0], [1.0, 3.0]], 0.0), None);
    assert_eq!(rank_correlation(&[], 0.0), None);
}
