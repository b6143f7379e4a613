//! Ranges of a line: disjoint, in order.

/// Disjoint closed ranges of a line, in order.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Ranges(Vec<[f64; 2]>);

impl Ranges {
    /// The union of ranges; those that meet within `noise` become one.
    pub(super) fn union(mut ranges: Vec<[f64; 2]>, noise: f64) -> Self {
        ranges.retain(|[from, to]| to - from > noise);
        ranges.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut joined: Vec<[f64; 2]> = Vec::with_capacity(ranges.len());
        for [from, to] in ranges {
            match joined.last_mut() {
                Some(last) if from <= last[1] + noise => last[1] = last[1].max(to),
                _ => joined.push([from, to]),
            }
        }
        Self(joined)
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.0.iter().copied()
    }

    /// The part that lies in other ranges, too.
    pub(super) fn within(&self, others: &Self, noise: f64) -> Self {
        let pairs = self.iter().flat_map(|[from, to]| {
            let others = others.iter();
            others.map(move |[start, end]| [from.max(start), to.min(end)])
        });
        Self::union(pairs.collect(), noise)
    }

    /// The part outside of other ranges.
    pub(super) fn without(&self, others: &Self, noise: f64) -> Self {
        let mut left = Vec::new();
        for [from, to] in self.iter() {
            let mut start = from;
            for [low, high] in others.iter() {
                if high > start && low < to {
                    left.push([start, low.min(to)]);
                    start = start.max(high);
                }
            }
            left.push([start, to]);
        }
        left.retain(|[from, to]| to - from > noise);
        Self(left)
    }

    /// The ranges, cut at places.
    pub(super) fn cut_at(&self, places: &[f64], noise: f64) -> Vec<[f64; 2]> {
        let mut places = places.to_vec();
        places.sort_by(f64::total_cmp);
        let mut pieces = Vec::new();
        for [from, to] in self.iter() {
            let mut start = from;
            for place in &places {
                if *place > start + noise && *place < to - noise {
                    pieces.push([start, *place]);
                    start = *place;
                }
            }
            pieces.push([start, to]);
        }
        pieces
    }
}

#[cfg(test)]
mod tests {
    use super::Ranges;

    #[test]
    fn ranges_are_joined_and_taken_apart() {
        let all = Ranges::union(vec![[3.0, 4.0], [0.0, 1.0], [0.5, 2.0], [6.0, 6.0]], 1e-9);
        assert_eq!(all, Ranges(vec![[0.0, 2.0], [3.0, 4.0]]));
        let other = Ranges::union(vec![[1.5, 3.5]], 1e-9);
        let within = all.within(&other, 1e-9);
        assert_eq!(within, Ranges(vec![[1.5, 2.0], [3.0, 3.5]]));
        let without = all.without(&other, 1e-9);
        assert_eq!(without, Ranges(vec![[0.0, 1.5], [3.5, 4.0]]));
        let inner = Ranges::union(vec![[0.5, 1.0]], 1e-9);
        let split = Ranges(vec![[0.0, 0.5], [1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(all.without(&inner, 1e-9), split);
        assert_eq!(all.cut_at(&[3.5, 1.0], 1e-9).len(), 4);
    }
}
