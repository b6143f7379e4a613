//! Lines of discontinuity: where they are, what is beside them, and what cuts along them gain.

use crate::support::rooms::{among, facing, level, patch, polygon, squares};
use glam::{DQuat, DVec3};
use infoscene::discretize::{
    CutMeasure, DiscontinuityLine, Generator, LineKind, OccludedPair, PatchSplit, View,
};
use infoscene::geometry::{Patch, SplitAxis};
use infoscene::scene::Occlusion;

/// The squares with blockers between them.
fn between_squares(blockers: &[Patch]) -> OccludedPair {
    let [floor, ceiling] = [0, 1].map(|k| squares()[k].shape().clone());
    OccludedPair::new(floor, ceiling, blockers.to_vec())
}

/// The lines that run along y, by x, with their kinds.
fn along_y(lines: &[DiscontinuityLine]) -> Vec<(f64, LineKind, f64)> {
    let lines = lines
        .iter()
        .filter(|l| (l.ends[0].x - l.ends[1].x).abs() < 1e-9);
    let mut found: Vec<_> = lines.map(|l| (l.ends[0].x, l.kind(), l.length())).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

/// Similar triangles: lines of the edges x = a at height h and x = u at height 1 are at
/// (a − h u)/(1 − h), and reach as far in y as ends of both edges are seen in one.
#[test]
fn lines_of_a_plate_are_those_of_similar_triangles() {
    let plate = level("plate", [0.3, 0.62], [0.25, 0.55], 0.3, true);
    let lines = between_squares(&[plate.shape().clone()]).lines().unwrap();
    let expected = [0.3 / 0.7, 0.32 / 0.7, 0.62 / 0.7];
    for x in expected {
        let reach: f64 = along_y(&lines)
            .iter()
            .filter(|(at, ..)| (at - x).abs() < 1e-9)
            .map(|(.., length)| length)
            .sum();
        // from the floor's edge to 0.55/0.7
        assert!((reach - 0.55 / 0.7).abs() < 1e-9, "{x}: {reach}");
    }
    assert!(
        along_y(&lines)
            .iter()
            .all(|(at, ..)| expected.iter().any(|x| (at - x).abs() < 1e-9))
    );
    // x = 0.62/0.7 is where the plate comes to an end: all is seen beyond
    let last = along_y(&lines).into_iter().filter(|(at, ..)| *at > 0.8);
    assert!(
        last.map(|(_, kind, _)| kind)
            .all(|kind| kind == LineKind::Lit)
    );
}

/// Away from the lines the form factor is smooth, across each of them it is not: along any segment
/// that crosses none of them a polynomial of degree 12 fits to 1e-9, and does not across a line.
#[test]
fn the_form_factor_bends_on_the_lines_and_nowhere_else() {
    let tilted = patch(&[[0.35, 0.2, 0.25], [0.75, 0.35, 0.45], [0.5, 0.7, 0.35]]);
    let pair = between_squares(&[tilted]);
    let lines = pair.lines().unwrap();
    assert!(lines.len() > 6, "{}", lines.len());
    let mut bends = 0;
    for k in 0..24 {
        let y = (f64::from(k) + 0.5) / 24.0;
        let mut places: Vec<f64> = lines.iter().filter_map(|line| crossing(line, y)).collect();
        places.extend([0.0, 1.0]);
        places.sort_by(f64::total_cmp);
        for pair_of_places in places.windows(2) {
            let [from, to] = [pair_of_places[0], pair_of_places[1]];
            if to - from > 0.01 {
                let off = misfit(&pair, y, [from, to]);
                assert!(off < 1e-8, "{y}: {from} to {to}: {off}");
            }
        }
        for three in places.windows(3) {
            let h = 0.02;
            if three[1] - three[0] > h && three[2] - three[1] > h {
                bends += usize::from(misfit(&pair, y, [three[1] - h, three[1] + h]) > 1e-11);
            }
        }
    }
    assert!(bends > 40, "{bends}");
}

fn crossing(line: &DiscontinuityLine, y: f64) -> Option<f64> {
    let [a, b] = line.ends;
    let share = (y - a.y) / (b.y - a.y);
    (0.0..=1.0)
        .contains(&share)
        .then_some(a.x + (b.x - a.x) * share)
}

/// The largest deviation from the polynomial through the form factors at 13 Chebyshev points.
fn misfit(pair: &OccludedPair, y: f64, [from, to]: [f64; 2]) -> f64 {
    misfit_between(pair, [from, to].map(|x| DVec3::new(x, y, 0.0)))
}

fn misfit_between(pair: &OccludedPair, [from, to]: [DVec3; 2]) -> f64 {
    let seen = |s: f64| pair.seen_from(from.lerp(to, 0.5 + 0.5 * s)).unwrap().value;
    let angle = |k: u32| std::f64::consts::PI * (f64::from(k) + 0.5) / 13.0;
    let nodes: Vec<f64> = (0..13).map(|k| angle(k).cos()).collect();
    let values: Vec<f64> = nodes.iter().map(|s| seen(*s)).collect();
    let fitted = |s: f64| {
        let (mut sum, mut weights) = (0.0, 0.0);
        for (k, (node, value)) in (0u32..).zip(nodes.iter().zip(&values)) {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let weight = sign * angle(k).sin() / (s - node);
            sum += weight * value;
            weights += weight;
        }
        sum / weights
    };
    let between = nodes.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    between
        .map(|s| (fitted(s) - seen(s)).abs())
        .fold(0.0, f64::max)
}

/// With several blockers, too, the form factor bends on each line: a line behind another blocker
/// would be none.
#[test]
fn the_form_factor_bends_on_each_line_of_several_blockers() {
    let blockers = [
        patch(&[[0.35, 0.2, 0.25], [0.75, 0.35, 0.45], [0.5, 0.7, 0.35]]),
        patch(&[[0.1, 0.5, 0.6], [0.6, 0.15, 0.7], [0.4, 0.8, 0.65]]),
        patch(&[[0.3, 0.3, 0.12], [0.5, 0.3, 0.1], [0.4, 0.5, 0.1]]),
    ];
    let pair = between_squares(&blockers);
    let lines = pair.lines().unwrap();
    let h = 0.003;
    let mut bends = 0;
    for (index, line) in lines.iter().enumerate() {
        let middle = line.ends[0].lerp(line.ends[1], 0.513);
        let aside = h * DVec3::Z.cross(line.ends[1] - line.ends[0]).normalize();
        let is_near = |(other, near): (usize, &DiscontinuityLine)| {
            let along = near.ends[1] - near.ends[0];
            let share = (middle - near.ends[0]).dot(along) / along.length_squared();
            let foot = near.ends[0] + along * share.clamp(0.0, 1.0);
            other != index && foot.distance(middle) < 3.0 * h
        };
        if lines.iter().enumerate().any(is_near) {
            continue;
        }
        let off = misfit_between(&pair, [middle - aside, middle + aside]);
        assert!(off > 1e-12, "{off}: {line:?}");
        bends += 1;
    }
    assert!(bends > 20, "{bends} of {}", lines.len());
}

/// A taller wall that stands on the floor in front of a lower one: the contact is a sharp line.
#[test]
fn a_wall_that_hides_all_casts_a_sharp_shadow() {
    let wall = polygon(
        "wall",
        &[
            [0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 1.0, 1.0],
            [0.0, 0.0, 1.0],
        ],
    );
    let screen = [
        [0.4, -9.0, 0.0],
        [0.9, 11.0, 0.0],
        [0.9, 11.0, 9.0],
        [0.4, -9.0, 9.0],
    ];
    let floor = level("floor", [0.0, 1.0], [0.0, 1.0], 0.0, true);
    let pair = OccludedPair::new(
        floor.shape().clone(),
        wall.shape().clone(),
        vec![patch(&screen)],
    );
    let lines = pair.lines().unwrap();
    let [line] = lines.as_slice() else {
        panic!("{lines:?}");
    };
    assert_eq!(line.kind(), LineKind::Sharp);
    assert!(line.generators.contains(&Generator::Contact { blocker: 0 }));
    for end in line.ends {
        assert!(
            (end.x - (0.4 + 0.025 * (end.y + 9.0))).abs() < 1e-9,
            "{end}"
        );
    }
}

/// A table of four coplanar pieces has the lines of one, and none from the middle of it.
#[test]
fn pieces_of_a_blocker_have_the_lines_of_the_whole() {
    let piece = |x, y| level("piece", x, y, 0.3, true).shape().clone();
    let (x, y) = ([0.3, 0.45, 0.62], [0.25, 0.4, 0.55]);
    let pieces = [0, 1].map(|i| [0, 1].map(|j| piece([x[i], x[i + 1]], [y[j], y[j + 1]])));
    let told = |pair: OccludedPair| {
        let mut lines: Vec<String> = pair
            .lines()
            .unwrap()
            .iter()
            .map(|line| {
                let mut ends = line
                    .ends
                    .map(|end| format!("{:.7} {:.7}", end.x.abs(), end.y.abs()));
                ends.sort();
                format!("{ends:?} {:?}", line.kind())
            })
            .collect();
        lines.sort();
        lines
    };
    let whole = told(between_squares(&[piece([0.3, 0.62], [0.25, 0.55])]));
    let parts = told(between_squares(&pieces.concat()));
    assert_eq!(whole, parts);
}

/// Lines turn and move with the scene, and do not depend on the order of blockers.
#[test]
fn lines_move_with_the_scene() {
    let blockers = [
        patch(&[[0.35, 0.2, 0.25], [0.75, 0.35, 0.45], [0.5, 0.7, 0.35]]),
        patch(&[[0.1, 0.5, 0.6], [0.6, 0.55, 0.7], [0.3, 0.9, 0.65]]),
    ];
    let pair = between_squares(&blockers);
    assert!(pair.may_have_curves());
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    let moved = |point: DVec3| turn * point + DVec3::new(3.0, -1.0, 2.0);
    let moved_patch = |patch: &Patch| {
        Patch::try_new(patch.corners().iter().map(|c| moved(*c)).collect()).unwrap()
    };
    let [floor, ceiling] = [0, 1].map(|k| squares()[k].shape().clone());
    let backwards = blockers.iter().rev().map(moved_patch).collect();
    let other = OccludedPair::new(moved_patch(&floor), moved_patch(&ceiling), backwards);
    let told = |lines: Vec<DiscontinuityLine>, map: &dyn Fn(DVec3) -> DVec3| {
        let mut told: Vec<(i64, LineKind)> = lines
            .iter()
            .map(|line| {
                let middle = map(0.5 * (line.ends[0] + line.ends[1]));
                let place = middle.x + 10.0 * middle.y + 100.0 * line.length();
                ((1e6 * place).round() as i64, line.kind())
            })
            .collect();
        told.sort_by_key(|(place, _)| *place);
        told
    };
    let here = told(pair.lines().unwrap(), &|point| point);
    let there = told(other.lines().unwrap(), &|point| {
        turn.inverse() * (point - DVec3::new(3.0, -1.0, 2.0))
    });
    assert_eq!(here.len(), there.len());
    for (a, b) in here.iter().zip(&there) {
        assert!((a.0 - b.0).abs() <= 1 && a.1 == b.1, "{a:?} {b:?}");
    }
}

/// Best cuts of an independent program, on no line, which keep 10 to 35 % of the gain.
#[test]
fn cuts_beside_the_lines_of_a_plate_are_those_of_the_prototype() {
    let plate = level("plate", [0.3, 0.62], [0.25, 0.55], 0.3, true);
    let scene = among(&squares(), &[plate]);
    let pair = OccludedPair::of(&scene, [0, 1], Occlusion::Exact).unwrap();
    let lines = pair.lines().unwrap();
    for (axis, printed) in SplitAxis::ALL.into_iter().zip([0.638_261, 0.545_527]) {
        let split = PatchSplit::try_new(&scene, 0, &[1], axis).unwrap();
        let best = split.best_cut(CutMeasure::Information).unwrap();
        assert!((best - printed).abs() <= 0.5e-6 + 1e-6, "{best}");
        let most = split.gain(&[best]).unwrap();
        let parallel = lines.iter().filter(|line| {
            let [from, to] = line.ends.map(|end| split.position_of(end));
            (from - to).abs() < 1e-9
        });
        let kept: Vec<f64> = parallel
            .map(|line| split.gain(&[split.position_of(line.ends[0])]).unwrap() / most)
            .collect();
        assert!(!kept.is_empty());
        assert!(
            kept.iter().all(|kept| (0.095..0.355).contains(kept)),
            "{kept:?}"
        );
    }
}

/// The quick search finds the gain of the search by derivatives, in any direction.
#[test]
fn highest_gains_are_those_of_best_cuts() {
    let plate = level("plate", [0.3, 0.62], [0.25, 0.55], 0.3, true);
    let scene = among(&squares(), &[plate]);
    for direction in [DVec3::X, DVec3::new(1.0, 2.0, 0.0)] {
        let split = PatchSplit::parallel_to(&scene, 0, &[1], direction, Occlusion::Exact).unwrap();
        let quick = split.highest_gains().unwrap();
        for (measure, quick) in CutMeasure::ALL.into_iter().zip(quick) {
            let best = split.best_cut(measure).unwrap();
            let gain = split.gain_by(measure, &[best]).unwrap();
            assert!(
                (quick / gain - 1.0).abs() <= 1e-5,
                "{direction}: {quick} {gain}"
            );
        }
    }
}

/// A cut along a direction of the patch's edge is that across the axis.
#[test]
fn cuts_along_an_edge_are_those_across_its_axis() {
    let half = level("half", [0.5, 9.0], [-8.0, 9.0], 0.2, true);
    let scene = among(&squares(), &[half]);
    let across = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
    // to the right of +y is +x
    let along = PatchSplit::parallel_to(&scene, 0, &[1], DVec3::Y, Occlusion::Exact).unwrap();
    for measure in CutMeasure::ALL {
        for at in [0.2, 0.45, 0.7] {
            let [a, b] = [&across, &along].map(|split| split.gain_by(measure, &[at]).unwrap());
            assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
        }
    }
    assert!((along.position_of(DVec3::new(0.3, 0.9, 0.0)) - 0.3).abs() < 1e-15);
    assert!(PatchSplit::parallel_to(&scene, 0, &[1], DVec3::Z, Occlusion::Exact).is_err());
}

/// The plane of the source parts what sees it from what does not.
#[test]
fn the_plane_of_the_source_is_a_line() {
    let floor = level("floor", [-1.0, 1.0], [0.0, 1.0], 0.0, true);
    let wall = [
        [0.0, 0.0, 0.2],
        [0.0, 1.0, 0.2],
        [0.0, 1.0, 1.0],
        [0.0, 0.0, 1.0],
    ];
    let wall = facing("wall", wall, true);
    let pair = OccludedPair::new(floor.shape().clone(), wall.shape().clone(), Vec::new());
    let lines = pair.lines().unwrap();
    let [line] = lines.as_slice() else {
        panic!("{lines:?}");
    };
    assert_eq!(line.generators, [Generator::Plane { of: None }]);
    assert!(line.sides.contains(&View::Dark) && line.ends.iter().all(|end| end.x.abs() < 1e-12));
    assert!((line.length() - 1.0).abs() < 1e-12);
}
