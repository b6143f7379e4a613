//! The symmetries of a frame: its axes exchanged and reflected.
//!
//! ```text
//!   (g y)_i = ± y_(axes i),    8 signs and 6 orders
//! ```

/// A symmetry: for each axis of the image the one that it was, and whether it is reflected.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Symmetry {
    pub(crate) axes: [usize; 3],
    pub(crate) reflected: [bool; 3],
}

/// Number of symmetries.
pub(crate) const SYMMETRIES: usize = 48;

impl Symmetry {
    /// All symmetries, the identity first.
    pub(crate) fn all() -> [Self; SYMMETRIES] {
        const ORDERS: [[usize; 3]; 6] = [
            [0, 1, 2],
            [1, 2, 0],
            [2, 0, 1],
            [0, 2, 1],
            [2, 1, 0],
            [1, 0, 2],
        ];
        std::array::from_fn(|k| Self {
            axes: ORDERS[k / 8],
            reflected: [0, 1, 2].map(|axis| k >> axis & 1 == 1),
        })
    }

    /// Whether the symmetry is a reflection, which turns fronts into backs.
    pub(crate) fn is_reflection(&self) -> bool {
        let [a, b, _] = self.axes;
        let is_odd = (a + 1) % 3 != b;
        let signs = self
            .reflected
            .iter()
            .filter(|reflected| **reflected)
            .count();
        is_odd != (signs % 2 == 1)
    }
}
