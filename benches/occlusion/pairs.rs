//! Pairs of the families, of a file of values, and with nothing between them.

use crate::{fastest, textbook_seconds};
use glam::DVec3;
use infoscene::form_factor::{DEFAULT_TOLERANCE, ExchangeArea, Occluders, Polygon};
use infoscene::geometry::Patch;
use infoscene::study::form_factors::occluded::{OccludedFamily, OccludedPair};
use serde_json::Value;
use std::hint::black_box;
use std::time::Instant;

/// The pair, then what is in the way.
pub(crate) struct Pair(Vec<Polygon>);

impl Pair {
    /// The pair, moved; none if a polygon of it is then too small for its corners to be planar.
    fn of(case: &OccludedPair, map: impl Fn(DVec3) -> DVec3) -> Option<Self> {
        let moved = |patch: &Patch| {
            let corners = patch.corners().iter().map(|corner| map(*corner));
            let patch = Patch::try_new(corners.collect()).ok()?;
            Some(Polygon::new(&patch))
        };
        let polygons = case.pair.iter().chain(&case.blockers).map(moved);
        polygons.collect::<Option<_>>().map(Self)
    }

    /// The exchange area past the others, all that a call takes included.
    fn past(&self) -> ExchangeArea {
        let polygons: Vec<&Polygon> = self.0[2..].iter().collect();
        let occluders = Occluders {
            polygons: &polygons,
            touching: 0.0,
        };
        let answer = self.0[0].exchange_area_past(&self.0[1], &occluders, DEFAULT_TOLERANCE);
        answer.unwrap().exchange
    }

    /// The same over the points of the first of these polygons and along the edges of the other.
    fn over(&self, [first, second]: [usize; 2]) -> ExchangeArea {
        let polygons: Vec<&Polygon> = self.0[2..].iter().collect();
        let occluders = Occluders {
            polygons: &polygons,
            touching: 0.0,
        };
        let [first, second] = [first, second].map(|end| &self.0[end]);
        let answer = first.exchange_area_past_over(second, &occluders, DEFAULT_TOLERANCE);
        answer.unwrap().exchange
    }

    fn bare(&self) -> ExchangeArea {
        let answer = self.0[0].exchange_area(&self.0[1], DEFAULT_TOLERANCE);
        answer.unwrap().exchange
    }

    /// The fastest of some calls, in seconds: of at least two, and of as many as fill a while.
    fn seconds(&self) -> f64 {
        let start = Instant::now();
        let mut least = f64::INFINITY;
        for run in 0..20 {
            if run > 1 && start.elapsed().as_secs_f64() > 0.02 {
                break;
            }
            least = least.min(fastest(1, 1, || {
                black_box(black_box(self).past());
            }));
        }
        least
    }
}

/// A family with the times aimed at, in multiples of the textbook's.
pub(crate) struct Family {
    pub(crate) name: &'static str,
    family: OccludedFamily,
    /// The number of blockers, if only cases with so many are taken.
    blockers: Option<usize>,
    median: Option<f64>,
    nine_in_ten: Option<f64>,
    /// The most pairs that are taken.
    pub(crate) most: usize,
}

impl Family {
    /// Every family, those that have a limit first.
    pub(crate) fn all() -> Vec<Self> {
        use OccludedFamily::{ClosePlate, Many, One, TwoOverlapping, WallOnBoth, WallOnFirst};
        let of = |family: OccludedFamily, median: Option<f64>| Self {
            name: family.name(),
            family,
            blockers: None,
            median,
            nine_in_ten: None,
            // pairs with many blockers take a thousand times as long as others
            most: if family == Many { 20 } else { 100 },
        };
        let mut all = vec![
            Self {
                nine_in_ten: Some(330.0),
                ..of(One, Some(110.0))
            },
            of(WallOnFirst, Some(80.0)),
            of(WallOnBoth, Some(80.0)),
            of(ClosePlate, Some(80.0)),
            of(TwoOverlapping, Some(550.0)),
            Self {
                name: "eight blockers",
                blockers: Some(8),
                ..of(Many, Some(14_000.0))
            },
        ];
        let limited: Vec<OccludedFamily> = all.iter().map(|family| family.family).collect();
        let others = OccludedFamily::ALL.into_iter();
        let others = others.filter(|family| *family == Many || !limited.contains(family));
        all.extend(others.map(|family| of(family, None)));
        all
    }

    /// So many of its pairs; each has the same value within the bounds when it is moved to another
    /// octant, and by the integral over either polygon.
    pub(crate) fn checked_pairs(&self, count: usize) -> Vec<Pair> {
        let cases = (0..).map(|number| self.family.case(number).unwrap());
        let is_taken =
            |case: &OccludedPair| self.blockers.is_none_or(|many| case.blockers.len() == many);
        let checked = |case: OccludedPair| {
            let pair = Pair::of(&case, |corner| corner).unwrap();
            let found = pair.past();
            let bare = pair.bare();
            let allowed = bare.error + found.error;
            assert!(found.value >= 0.0 && found.value <= bare.value + allowed);
            let moved = Pair::of(&case, |corner| corner - DVec3::splat(8.0));
            let others = [pair.over([0, 1]), pair.over([1, 0])].into_iter();
            for other in others.chain(moved.map(|moved| moved.past())) {
                let off = (other.value - found.value).abs();
                assert!(
                    off <= other.error + found.error,
                    "{}: {found:?} {other:?} {case:?}",
                    self.name
                );
            }
            pair
        };
        cases.filter(is_taken).take(count).map(checked).collect()
    }

    /// Prints the times of the pairs beside the limits.
    pub(crate) fn print(&self, pairs: &[Pair]) {
        let before = textbook_seconds();
        let mut times: Vec<f64> = pairs.iter().map(Pair::seconds).collect();
        let textbook = before.min(textbook_seconds());
        times.sort_by(f64::total_cmp);
        let [median, most] = [times.len() / 2, times.len() * 9 / 10].map(|k| times[k] / textbook);
        let missed = pairs.iter().map(Pair::past);
        let missed = missed.filter(|found| found.error > DEFAULT_TOLERANCE * found.value);
        println!(
            "{:26} median {median:7.1} {:14} nine in ten {most:8.1} {:14} × the textbook's {:.3} µs; \
             {} of {} bounds miss the tolerance",
            self.name,
            beside(self.median),
            beside(self.nine_in_ten),
            textbook * 1e6,
            missed.count(),
            times.len()
        );
    }
}

fn beside(limit: Option<f64>) -> String {
    limit.map_or_else(String::new, |limit| format!("(limit {limit})"))
}

/// The name of the line of pairs with blockers beside them.
pub(crate) const ASIDE: &str = "none in the shaft";

/// Pairs with blockers that are not between them, against the same pairs without.
pub(crate) fn aside(count: usize, is_test: bool) {
    for (blockers, family) in [(1, OccludedFamily::One), (8, OccludedFamily::Many)] {
        let cases = (0..).map(|number| family.case(number).unwrap());
        let cases = cases.filter(|case| case.blockers.len() == blockers);
        let pairs: Vec<Pair> = cases
            .take(count)
            .map(|mut case| {
                for blocker in &mut case.blockers {
                    let corners = blocker.corners().iter().map(|c| *c + 16.0 * DVec3::X);
                    *blocker = Patch::try_new(corners.collect()).unwrap();
                }
                Pair::of(&case, |corner| corner).unwrap()
            })
            .collect();
        for pair in &pairs {
            let (past, bare) = (pair.past(), pair.bare());
            assert!((past.value - bare.value).abs() <= past.error + bare.error);
        }
        if is_test {
            continue;
        }
        let more = |pair: &Pair| {
            let seconds = |call: &dyn Fn() -> ExchangeArea| {
                fastest(20, 50, || {
                    black_box(call());
                })
            };
            100.0
                * (seconds(&|| black_box(pair).past()) / seconds(&|| black_box(pair).bare()) - 1.0)
        };
        let mut more: Vec<f64> = pairs.iter().map(more).collect();
        more.sort_by(f64::total_cmp);
        println!(
            "{ASIDE}, {blockers} beside it: median {:+.1} % of the pair without (limit 5 %), nine in \
             ten {:+.1} %",
            more[more.len() / 2],
            more[more.len() * 9 / 10]
        );
    }
}

/// The pairs of the file of values, each within its bound; errors and bounds in a line.
pub(crate) fn checked_reference() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/data/reference/occlusion.json");
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let (mut worst, mut ratios) = (0.0_f64, Vec::new());
    for case in file["cases"].as_array().unwrap() {
        let polygon = |corners: &Value| {
            let corners: Vec<[f64; 3]> = serde_json::from_value(corners.clone()).unwrap();
            let corners = corners.into_iter().map(DVec3::from_array).collect();
            Polygon::new(&Patch::try_new(corners).unwrap())
        };
        let ends = [&case["P"], &case["Q"]];
        let blockers = case["blockers"].as_array().unwrap();
        let pair = Pair(ends.into_iter().chain(blockers).map(polygon).collect());
        let value: f64 = case["value"].as_str().unwrap().parse().unwrap();
        let exact = value * pair.0[0].area();
        let found = pair.past();
        let off = (found.value - exact).abs();
        let known = (case["uncertainty"].as_f64().unwrap() + 4.0 * f64::EPSILON) * exact;
        assert!(
            off <= found.error + known,
            "{}: {found:?}, not {exact}",
            case["id"]
        );
        worst = worst.max((off - known).max(0.0) / exact);
        ratios.push(found.error / off.max(8.0 * f64::EPSILON * exact));
    }
    ratios.sort_by(f64::total_cmp);
    format!(
        "reference values: {} within their bounds; past the uncertainty they are off by {worst:.1e} \
         at most; median bound / max(error, 8 ε) {:.0} (limit 1000)",
        ratios.len(),
        ratios[ratios.len() / 2]
    )
}
