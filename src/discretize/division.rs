//! The regular division, which the others are compared with.

/// The positions `1/m, 2/m, …` of the regular division into m `parts`.
#[must_use]
pub fn regular_positions(parts: u32) -> Vec<f64> {
    (1..parts)
        .map(|k| f64::from(k) / f64::from(parts))
        .collect()
}
