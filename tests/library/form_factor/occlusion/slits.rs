//! Bounds where edges of blockers nearly coincide, where pairs are far, and where corners are.
//!
//! ```text
//!   unit squares at distance 1, lines of sight with slope d = x' − x:
//!   J = ∫ k(d) · |{x : x, x + d ∈ [0, 1], x + h1 d > a, x + h2 d < b}| dd
//!   k(d) = atan(1/c)/(π c³),  c² = 1 + d²          both directions along the slit integrated
//! ```

use glam::{DQuat, DVec3};
use infoscene::form_factor::{DEFAULT_TOLERANCE, ExchangeArea, Occluders, Polygon};
use infoscene::geometry::Patch;
use infoscene::numeric::GaussLegendre;
use std::f64::consts::PI;

fn polygon(corners: &[DVec3]) -> Polygon {
    Polygon::new(&Patch::try_new(corners.to_vec()).unwrap())
}

fn past(pair: [&[DVec3]; 2], blockers: &[Vec<DVec3>]) -> ExchangeArea {
    let [first, second] = pair.map(polygon);
    let blockers: Vec<Polygon> = blockers.iter().map(|corners| polygon(corners)).collect();
    let polygons: Vec<&Polygon> = blockers.iter().collect();
    let occluders = Occluders {
        polygons: &polygons,
        touching: 0.0,
    };
    let answer = first.exchange_area_past(&second, &occluders, DEFAULT_TOLERANCE);
    answer.unwrap().exchange
}

fn level(x: [f64; 2], y: [f64; 2], z: f64) -> Vec<DVec3> {
    let around = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
    around.map(|[x, y]| DVec3::new(x, y, z)).to_vec()
}

/// The unit squares at distance 1 that face each other.
fn squares() -> [Vec<DVec3>; 2] {
    let unit = [0.0, 1.0];
    let mut ceiling = level(unit, unit, 1.0);
    ceiling.reverse();
    [level(unit, unit, 0.0), ceiling]
}

/// What the squares exchange past all corners turned.
fn turned(turn: DQuat, blockers: &[Vec<DVec3>]) -> ExchangeArea {
    let turned = |corners: &Vec<DVec3>| corners.iter().map(|c| turn * *c).collect::<Vec<_>>();
    let [floor, ceiling] = squares().each_ref().map(turned);
    let blockers: Vec<Vec<DVec3>> = blockers.iter().map(turned).collect();
    past([&floor, &ceiling], &blockers)
}

fn turns() -> [DQuat; 2] {
    let axis = DVec3::new(0.48, -0.6, 0.64);
    [DQuat::IDENTITY, DQuat::from_axis_angle(axis, 1.1)]
}

/// The exchange area of the squares through a slit: to the right of x = a at the height h1, to the
/// left of x = b at h2.
fn through_slit([a, b]: [f64; 2], [h1, h2]: [f64; 2]) -> f64 {
    let lows = [[0.0, 0.0], [0.0, -1.0], [a, -h1]];
    let highs = [[1.0, 0.0], [1.0, -1.0], [b, -h2]];
    let lines = || lows.iter().chain(&highs);
    let meetings = lines().flat_map(|p| lines().map(|q| (p[0] - q[0]) / (q[1] - p[1])));
    let mut breaks: Vec<f64> = meetings.filter(|d| d.abs() < 1.0).collect();
    breaks.extend([-1.0, 1.0]);
    breaks.sort_by(f64::total_cmp);
    let at = |line: &[f64; 2], d: f64| line[0] + d * line[1];
    let rule = GaussLegendre::with(40);
    let piece = |ends: &[f64]| {
        let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
        let order = |p: &&[f64; 2], q: &&[f64; 2]| at(p, middle).total_cmp(&at(q, middle));
        let (low, high) = (lows.iter().max_by(order), highs.iter().min_by(order));
        let (low, high) = (low.unwrap(), high.unwrap());
        if at(high, middle) <= at(low, middle) {
            return 0.0;
        }
        let nodes = rule.nodes.iter().zip(&rule.weights);
        let terms = nodes.map(|(node, weight)| {
            let d = middle + half * node;
            let c = (1.0 + d * d).sqrt();
            let open = (high[0] - low[0]) + d * (high[1] - low[1]);
            half * weight * open * (1.0 / c).atan() / (PI * c * c * c)
        });
        terms.sum::<f64>()
    };
    breaks.windows(2).map(piece).sum()
}

/// Two plates with a slit between parallel edges, flush and at two heights, as given and turned.
/// The rounding of turned corners, 2 ε each, moves edges of length 5 by as much: 2 · 2ε · 5 · 2.
#[test]
fn slits_between_parallel_edges_let_through_what_they_must() {
    for turn in turns() {
        for heights in [[0.5, 0.5], [0.5, 0.25], [0.5, 0.5 + 1e-9]] {
            for gap in [1e-3, 1e-6, 1e-9, 1e-10] {
                let ends = [0.5, 0.5 + gap];
                let exact = through_slit(ends, heights);
                let blockers = [
                    level([-2.0, ends[0]], [-2.0, 3.0], heights[0]),
                    level([ends[1], 3.0], [-2.0, 3.0], heights[1]),
                ];
                let found = turned(turn, &blockers);
                let allowed = found.error + 40.0 * f64::EPSILON;
                assert!(
                    (found.value - exact).abs() <= allowed,
                    "{gap} {found:?} {exact}"
                );
                assert!(found.error <= 1e-13, "{gap} {heights:?} {found:?}");
            }
        }
    }
}

/// Flush plates whose edges cross at a small angle: what both hide is what one hides and what the
/// part of the other beside it does. Crossings are displaced by ε over the angle, along the edges.
#[test]
fn edges_that_cross_at_a_small_angle_keep_their_digits() {
    for turn in turns() {
        for gap in [1e-3, 1e-6, 1e-9, 1e-10] {
            for angle in [1e-9, 1e-7, 1e-5, 1e-3] {
                let edge = |y: f64| DVec3::new(0.5 + gap + angle * (y - 0.4), y, 0.5);
                let far = [DVec3::new(3.0, -2.0, 0.5), DVec3::new(3.0, 3.0, 0.5)];
                let [left, right] = [
                    level([-2.0, 0.5], [-2.0, 3.0], 0.5),
                    vec![edge(-2.0), far[0], far[1], edge(3.0)],
                ];
                let mut beside = right.clone();
                let y = 0.4 - gap / angle;
                if y > -2.0 {
                    beside[0] = DVec3::new(0.5, -2.0, 0.5);
                    beside.push(DVec3::new(0.5, y, 0.5));
                }
                let [one, other, none] = [vec![left.clone()], vec![beside], vec![]]
                    .map(|blockers| turned(turn, &blockers));
                let exact = one.value + other.value - none.value;
                let found = turned(turn, &[left, right]);
                // corners that are turned, as above, and the corner where the edges cross
                let known = one.error + other.error + none.error + 64.0 * f64::EPSILON;
                let off = (found.value - exact).abs();
                assert!(
                    off <= found.error + known,
                    "{gap} {angle} {found:?} {exact}"
                );
                assert!(found.error <= 1e-13, "{gap} {angle} {found:?}");
            }
        }
    }
}

/// A triangle and its image in a point, past a plate up to that point: half of the lines of sight
/// pass, as lines come in pairs. The bound falls with the size, to 1e-12 of the size squared.
#[test]
fn bounds_of_small_pairs_fall_with_their_size() {
    for shift in [0.0, 0.4] {
        for size in [1e-1, 1e-2, 1e-3] {
            let corners = [[0.0, 0.0], [size, 0.0], [0.1 * size, size]];
            let floor = corners.map(|[x, y]| DVec3::new(x, y, 0.0));
            let mut image = corners.map(|[x, y]| DVec3::new(shift + size - x, size - y, 1.0));
            image.reverse();
            let middle = 0.5 * (shift + size);
            let plate = [[middle, -3.0], [9.0, 0.0], [middle, 3.0]];
            let plate = plate.map(|[x, y]| DVec3::new(x, y, 0.5)).to_vec();
            let whole = past([&floor, &image], &[]);
            let half = past([&floor, &image], &[plate]);
            let off = (half.value - 0.5 * whole.value).abs();
            // corners in the middle are rounded by ε of the shift, over a length of the size
            let rounded = 4.0 * f64::EPSILON * (shift + size) * size * size * size;
            assert!(
                off <= half.error + whole.error + rounded,
                "{size} {half:?} {whole:?}"
            );
            assert!(half.error <= 1e-12 * size * size, "{size} {half:?}");
        }
    }
}

/// A plate that ends far away hides what one does that ends nearby: its corners lose more digits as
/// they are put into the pair's frame, and the bound tells. Past 1e3 it says that nothing is known.
#[test]
fn corners_far_away_are_counted_as_they_are_rounded() {
    let floor = [[0.1, 0.2, 0.05], [1.1, 0.3, -0.05], [0.3, 1.1, 0.15]].map(DVec3::from_array);
    let ceiling = [[0.0, 0.1, 1.1], [0.2, 1.2, 0.9], [1.2, 0.1, 1.05]].map(DVec3::from_array);
    let plate = |far: f64| level([0.5, far], [-far, far], 0.5);
    let near = past([&floor, &ceiling], &[plate(8.0)]);
    assert!(near.error <= 1e-11 * near.value, "{near:?}");
    for far in [1e2, 1e3, 1e5, 1e9] {
        let found = past([&floor, &ceiling], &[plate(far)]);
        let off = (found.value - near.value).abs();
        assert!(off <= found.error + near.error, "{far} {found:?} {near:?}");
    }
}
