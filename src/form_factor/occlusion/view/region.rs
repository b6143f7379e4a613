//! Regions of P's plane, as intersections of half-planes beside lines of sight.

/// One side of a line: `sign · (α·ξ − c) ≥ 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HalfPlane {
    pub line: usize,
    pub sign: f64,
}

/// A convex face, seen from y.
#[derive(Debug, Clone)]
pub(crate) struct Cone {
    pub corners: Vec<usize>,
    /// The half-planes of the sides from each corner to the next.
    pub sides: Vec<HalfPlane>,
}

/// The intersection of cones and half-planes.
#[derive(Debug, Clone, Default)]
pub(crate) struct Region {
    pub cones: Vec<Cone>,
    pub halves: Vec<HalfPlane>,
}

impl Region {
    pub(crate) fn sides(&self) -> impl Iterator<Item = &HalfPlane> {
        self.cones
            .iter()
            .flat_map(|cone| &cone.sides)
            .chain(&self.halves)
    }

    /// Whether two sides leave nothing of the region but a piece of a line.
    pub(crate) fn is_flat(&self) -> bool {
        let mut sides = self.sides();
        sides.any(|side| {
            self.sides()
                .any(|o| o.line == side.line && o.sign * side.sign < 0.0)
        })
    }

    /// Whether a line is one of those around the region, and which side of it that is on.
    pub(crate) fn side_of(&self, line: usize) -> Option<f64> {
        self.sides()
            .find(|half| half.line == line)
            .map(|half| half.sign)
    }
}
