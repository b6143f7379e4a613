//! Boundaries by the lines that their sides are on, each with the range in which it is one.

use super::covers::Segment;
use smallvec::SmallVec;

/// A boundary, and the range of t in which it is one.
#[derive(Debug, Clone)]
pub(crate) struct Arrangement {
    pub segments: Vec<Segment>,
    pub range: [f64; 2],
}

impl Arrangement {
    /// The arrangement in this range at most.
    pub(crate) fn within(&self, [from, to]: [f64; 2]) -> Self {
        Self {
            segments: self.segments.clone(),
            range: [self.range[0].max(from), self.range[1].min(to)],
        }
    }

    /// Whether each corner at which a side ends is one at which a side begins.
    pub(crate) fn is_closed_by_name(&self) -> bool {
        let name = |line: usize, other: usize| [line.min(other), line.max(other)];
        let named = |which: fn(&Segment) -> usize| {
            let names = self.segments.iter().map(|s| name(s.line, which(s)));
            let mut names: SmallVec<[[usize; 2]; 16]> = names.collect();
            names.sort_unstable();
            names
        };
        named(|segment| segment.from) == named(|segment| segment.to)
    }
}
