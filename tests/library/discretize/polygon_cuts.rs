//! Cuts of polygons: strips against areas, best cuts against scans, and where the search meets
//! kinks.

use glam::DVec3;
use infoscene::discretize::{PatchSplit, regular_positions};
use infoscene::form_factor::Polygon;
use infoscene::geometry::{CutLines, Patch, SplitAxis};
use infoscene::information::divergence;
use infoscene::numeric::{GaussLegendre, tolerance};
use infoscene::scene::{NamedPatch, Scene};

fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// The rectangle of depth `1 − from` and width 1 in the plane z = 0.
fn floor(from: f64) -> [DVec3; 4] {
    [
        at(from, 0.0, 0.0),
        at(1.0, 0.0, 0.0),
        at(1.0, 1.0, 0.0),
        at(from, 1.0, 0.0),
    ]
}

/// The rectangle in the plane x = `x` that faces the floor, of this width, from one height to
/// another.
fn wall(x: f64, width: f64, [low, high]: [f64; 2]) -> [DVec3; 4] {
    [
        at(x, 0.0, low),
        at(x, width, low),
        at(x, width, high),
        at(x, 0.0, high),
    ]
}

fn scene(outlines: &[&[DVec3]]) -> Scene {
    let patches = outlines
        .iter()
        .map(|corners| NamedPatch::new(String::new(), Patch::try_new(corners.to_vec()).unwrap()));
    Scene::try_new(patches.collect()).unwrap()
}

fn exchange(first: &[DVec3], second: &[DVec3]) -> f64 {
    let [first, second] =
        [first, second].map(|corners| Polygon::new(&Patch::try_new(corners.to_vec()).unwrap()));
    first.exchange_area(&second, 1e-13).unwrap().exchange.value
}

/// A rotation by the angle of the triangle 3-4-5 about each of two axes.
fn turned(point: &DVec3) -> DVec3 {
    let DVec3 { x, y, z } = *point;
    let (x, y) = (0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y);
    at(x, 0.8 * y - 0.6 * z, 0.6 * y + 0.8 * z)
}

/// Triangles that touch in a corner, face each other, stand on an edge, or lie beside.
fn triangles() -> Vec<[[DVec3; 3]; 2]> {
    let floor = [at(0.0, 0.0, 0.0), at(1.0, 0.1, 0.0), at(0.2, 1.3, 0.0)];
    vec![
        [
            floor,
            [at(0.0, 0.0, 0.0), at(0.2, 1.3, 0.0), at(-0.3, 0.4, 1.1)],
        ],
        [
            floor,
            [at(0.0, 0.0, 0.0), at(0.4, 1.3, 0.8), at(-0.7, 0.1, 0.9)],
        ],
        [
            floor,
            [at(0.1, 0.0, 0.7), at(0.4, 1.0, 0.8), at(0.9, 0.1, 0.9)],
        ],
        [
            floor,
            [at(-0.5, 0.0, 0.1), at(-0.4, 1.0, 0.2), at(-0.6, 0.1, 0.9)],
        ],
    ]
}

/// The triangle cut by the line parallel to v0 → v2 at t, by hand: the quadrangle at v0 and the
/// triangle at v1.
fn by_hand([a, b, c]: [DVec3; 3], t: f64) -> [Vec<DVec3>; 2] {
    let (near, far) = (a + (b - a) * t, c + (b - c) * t);
    [vec![a, near, far, c], vec![near, b, far]]
}

/// `∫ r dt` over `[from, to]` is what the part between exchanges.
#[test]
fn strips_are_derivatives_of_exchange_areas() {
    let rule = GaussLegendre::with(24);
    let mut checked = 0;
    for [floor, other] in triangles() {
        // where the other's plane crosses the floor, r has kinks that no Gauss rule sees
        let plane = Patch::try_new(other.to_vec()).unwrap();
        let heights = floor.map(|c| (c - other[0]).dot(plane.normal()));
        if heights.iter().any(|h| *h < -1e-12) {
            continue;
        }
        checked += 1;
        let lines = CutLines::try_new(&Patch::try_new(floor.to_vec()).unwrap(), SplitAxis::U);
        let lines = lines.unwrap();
        let [surface, seen] =
            [floor, other].map(|c| Polygon::new(&Patch::try_new(c.to_vec()).unwrap()));
        let strip = |t: f64| {
            let chords = lines.chords(t).into_iter();
            let lit = chords.map(|chord| surface.segment_exchange(chord, &seen));
            lit.sum::<f64>() * lines.breadth()
        };
        for [from, to] in [[0.3, 0.5], [0.5, 0.7]] {
            let nodes = rule.nodes.iter().zip(&rule.weights);
            let half = 0.5 * (to - from);
            let sum: f64 = nodes
                .map(|(x, w)| half * w * strip(0.5 * (from + to) + half * x))
                .sum();
            let [_, beyond_from] = by_hand(floor, from);
            let [_, beyond_to] = by_hand(floor, to);
            let part = exchange(&beyond_from, &other) - exchange(&beyond_to, &other);
            // two exchange areas within 1e-13 of themselves
            let whole = exchange(&floor, &other);
            assert!((sum - part).abs() <= 2e-13 * whole, "{sum} {part} {whole}");
        }
    }
    assert!(checked >= 2, "{checked} pairs are smooth");
}

/// The best cut of a triangle is higher than all cuts by hand, and there the difference quotient
/// vanishes.
#[test]
fn best_cuts_of_triangles_beat_a_scan() {
    for turn in [false, true] {
        for pair in triangles() {
            let [floor, other] = pair.map(|c| if turn { c.each_ref().map(turned) } else { c });
            let scene = scene(&[&floor, &other]);
            let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
            let gain = |t: f64| {
                let fluxes = by_hand(floor, t).map(|part| exchange(&part, &other));
                let shares = [1.0 - (1.0 - t).powi(2), (1.0 - t).powi(2)];
                2.0 / scene.total_area() * divergence(&fluxes, &shares)
            };
            let best = split.best(2).unwrap();
            let position = best.positions[0];
            let most = gain(position);
            assert!(
                (best.gain - most).abs() <= tolerance::POLYGON_GAIN * most,
                "{best:?} {most}"
            );
            for k in 1..25 {
                assert!(gain(f64::from(k) / 25.0) <= most * (1.0 + 1e-12));
            }
            // fourth order: the error is h⁴ of a fifth derivative; rounding 1e-13/h
            let h = 1e-3;
            let slope = (8.0 * (gain(position + h) - gain(position - h))
                - (gain(position + 2.0 * h) - gain(position - 2.0 * h)))
                / (12.0 * h);
            assert!(slope.abs() <= 1e-9, "{slope:e} at {position}");
            assert!(best.residual <= 1e-13, "{best:?}");
        }
    }
}

/// A floor of depth `behind + 1` under a unit wall; `behind` of it lies behind the wall's plane.
fn floor_behind(behind: f64, place: fn(&DVec3) -> DVec3) -> Scene {
    let (floor, wall) = (floor(-behind), wall(0.0, 1.0, [0.0, 1.0]));
    scene(&[&floor.each_ref().map(place), &wall.each_ref().map(place)])
}

/// The dark part is cut off exactly: J log2(whole/lit), and the next cut is that of two unit
/// squares. With three quarters dark this is twice what equal parts can gain: eqs. (6), (7) bound
/// regular divisions only.
#[test]
fn dark_parts_are_cut_off_at_the_plane() {
    // data/reference: form factor of two squares, fig. 2's cut and gain
    let (flux, cut, gain) = (
        0.200_043_776_075_403,
        0.399_201_026_045_385_2,
        0.033_270_958_672_548_35,
    );
    for (behind, place) in [
        (1.0, (|p| *p) as fn(&DVec3) -> DVec3),
        (1.0, turned),
        (3.0, |p| *p),
        (3.0, turned),
    ] {
        let scene = floor_behind(behind, place);
        let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
        let depth = behind + 1.0;
        let best = split.best(2).unwrap();
        assert!(
            (best.positions[0] - behind / depth).abs() <= 1e-15,
            "{best:?}"
        );
        let dark = 2.0 / scene.total_area() * flux * depth.log2();
        assert!((best.gain - dark).abs() <= 1e-11 * dark, "{best:?} {dark}");
        assert!(best.residual <= 1e-12, "{best:?}");
        let three = split.best(3).unwrap();
        let expected = [behind / depth, (behind + cut) / depth];
        for (found, expected) in three.positions.iter().zip(expected) {
            assert!(
                (found - expected).abs() <= tolerance::POLYGON_POSITION,
                "{three:?}"
            );
        }
        let both = dark + 2.0 / scene.total_area() * gain;
        assert!(
            (three.gain - both).abs() <= 1e-11 * both,
            "{three:?} {both}"
        );
        let ratio = best.gain / split.maximum_gain(2).unwrap();
        assert!((ratio - depth.log2()).abs() <= 1e-11, "{ratio}");
    }
}

/// A wall that hovers over the middle of the floor: no jump at its plane, and the best cut lies
/// beyond it.
#[test]
fn cuts_pass_the_plane_of_a_hovering_wall() {
    let (floor, wall) = (floor(0.0), wall(0.2, 1.0, [0.5, 1.5]));
    let mut positions = Vec::new();
    for place in [(|p| *p) as fn(&DVec3) -> DVec3, turned] {
        let scene = scene(&[&floor.each_ref().map(place), &wall.each_ref().map(place)]);
        let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
        let best = split.best(2).unwrap();
        for k in 1..200 {
            let t = f64::from(k) / 200.0;
            assert!(
                split.gain(&[t]).unwrap() <= best.gain * (1.0 + 1e-11),
                "{t} {best:?}"
            );
        }
        for parts in 3..=4 {
            let more = split.best(parts).unwrap();
            assert!(more.gain > split.gain(&regular_positions(parts)).unwrap());
            assert!(more.residual <= 1e-10, "{more:?}");
        }
        positions.push(best.positions[0]);
    }
    assert!(
        (positions[0] - positions[1]).abs() <= tolerance::POLYGON_POSITION,
        "{positions:?}"
    );
}

/// An L under a wall: the cut along its inner edge gives two rectangles.
#[test]
fn an_l_is_cut_along_its_inner_edge() {
    let l = [
        at(0.0, 0.0, 0.0),
        at(2.0, 0.0, 0.0),
        at(2.0, 1.0, 0.0),
        at(1.0, 1.0, 0.0),
        at(1.0, 2.0, 0.0),
        at(0.0, 2.0, 0.0),
    ];
    let wall = wall(0.0, 2.0, [0.0, 1.0]);
    let scene = scene(&[&l, &wall]);
    let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
    let near = [l[0], at(1.0, 0.0, 0.0), l[4], l[5]];
    let far = [at(1.0, 0.0, 0.0), l[1], l[2], l[3]];
    let fluxes = [near, far].map(|part| exchange(&part, &wall));
    let expected = 2.0 / scene.total_area() * divergence(&fluxes, &[2.0, 1.0]);
    let gain = split.gain(&[0.5]).unwrap();
    assert!(
        (gain - expected).abs() <= 1e-12 * expected,
        "{gain} {expected}"
    );
    let best = split.best(2).unwrap();
    for k in 1..100 {
        assert!(split.gain(&[f64::from(k) / 100.0]).unwrap() <= best.gain * (1.0 + 1e-11));
    }
}

/// No axes start at a straight corner; enclosures are for aligned rectangles.
#[test]
fn what_has_no_axes_or_no_closed_form_is_refused() {
    let bar = [
        at(0.5, 0.0, 0.0),
        at(1.0, 0.0, 0.0),
        at(1.0, 1.0, 0.0),
        at(0.0, 0.0, 0.0),
    ];
    let [[_, wall], ..] = triangles()[..] else {
        panic!("no triangles");
    };
    let straight = PatchSplit::try_new(&scene(&[&bar, &wall]), 0, &[1], SplitAxis::U).unwrap_err();
    assert!(
        straight.to_string().contains("at another corner"),
        "{straight}"
    );
    let [floor, wall] = triangles()[0];
    let split = PatchSplit::try_new(&scene(&[&floor, &wall]), 0, &[1], SplitAxis::U).unwrap();
    let refusal = split.certified_best(64).unwrap_err();
    assert!(
        refusal.to_string().contains("three common axes"),
        "{refusal}"
    );
}
