//! Bounds on W where nothing is known of it, and on its change beside places where it is.

use super::share::Share;
use crate::form_factor::occlusion::view::setting::Face;
use crate::form_factor::occlusion::view::sight::Sight;

impl Sight<'_> {
    /// A piece of the stretch on which nothing is certain but that `|W| ≤ |v| ∫_P dx/r`, which is
    /// largest in a disc around y: at most `2 √(π A_P)`.
    pub(crate) fn unsettled(&self, width: f64) -> Share {
        Share {
            truncation: self.setting.most * self.along.truncate().length() * width,
            ..Share::default()
        }
    }

    /// A gap in which W is taken as it is beside it: it changes by at most K times the width.
    ///
    /// The integrand `n·(v × (y − x))/r²` changes by at most `3 |v|²/r²` and the lines of the
    /// boundary sweep over at most their speed times their length; r is at least h. Lines that
    /// miss P all along the gap sweep over nothing.
    pub(crate) fn bridge(&self, from: f64, to: f64) -> Share {
        let width = to - from;
        let unsettled = self.unsettled(width);
        if width <= 0.0 {
            return Share::default();
        }
        let height = self.point(from).z.min(self.point(to).z);
        let speed = self.along.length();
        let reach = self.setting.most;
        let lines = (0..self.traces.len()).filter(|line| self.may_meet(*line, [from, to]));
        let swept: f64 = lines.map(|line| self.speed_of(line, [from, to])).sum();
        let change = speed * (swept * reach + 3.0 * speed * reach * reach / height) / height;
        let truncation = (change * width * width).min(unsettled.truncation);
        Share {
            truncation: if truncation.is_nan() {
                unsettled.truncation
            } else {
                truncation
            },
            ..unsettled
        }
    }

    /// Whether a line may meet P somewhere in a range of t: the heights of P's corners over its
    /// plane are linear in t.
    fn may_meet(&self, line: usize, [from, to]: [f64; 2]) -> bool {
        let corners = self.setting.first.iter().flat_map(Face::corners);
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in corners {
            let [start, end] = self.ends_of_height(line, corner);
            for height in [from, to].map(|t| start + t * (end - start)) {
                (least, most) = (least.min(height), most.max(height));
            }
        }
        least <= 0.0 && most >= 0.0
    }

    /// The most that the places of a line in P move by for each unit of t in a range.
    fn speed_of(&self, line: usize, [from, to]: [f64; 2]) -> f64 {
        let trace = &self.traces[line];
        let reach = self.setting.most;
        let height = self.point(from).z.max(self.point(to).z);
        let (change, turn) = match trace.edge {
            Some((_, [_, slope])) => (slope.abs(), 0.0),
            None => {
                let [_, slope] = trace.normal;
                let normal = trace.normal[0] + from * slope;
                let turn = slope.truncate().length();
                let level = normal.z.abs() + (to - from) * slope.z.abs();
                let rise = height * slope.z.abs() + self.along.z.abs() * level;
                (turn * reach + rise, turn)
            }
        };
        // the least slope of the plane in the range
        let (alpha, _) = self.line_at(line, from);
        let slope = alpha.length() - (to - from) * turn;
        if slope > 0.0 {
            change / slope
        } else {
            f64::INFINITY
        }
    }
}
