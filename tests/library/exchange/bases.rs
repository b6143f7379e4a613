//! Exchange areas of bases without what lies in them.

use super::rows::held;
use crate::support::rooms::mapped;
use glam::{DQuat, DVec3};
use infoscene::exchange::ExchangeAreas;
use infoscene::form_factor::Route;
use infoscene::geometry::Patch;
use infoscene::scene::{NamedPatch, Scene};

fn polygon(name: &str, corners: &[(f64, f64)], z: f64) -> NamedPatch {
    let corners = corners.iter().map(|(x, y)| DVec3::new(*x, *y, z));
    NamedPatch::new(name.to_owned(), Patch::try_new(corners.collect()).unwrap())
}

pub fn square(name: &str, low: f64, high: f64, z: f64) -> NamedPatch {
    let corners = [(low, low), (high, low), (high, high), (low, high)];
    polygon(name, &corners, z)
}

/// The inside of a unit cube but its floor.
fn walls() -> Vec<NamedPatch> {
    Scene::built_in("cube:1").unwrap().patches()[1..].to_vec()
}

fn with_walls(floor: Vec<NamedPatch>) -> Scene {
    Scene::try_new([floor, walls()].concat()).unwrap()
}

fn turned(scene: &Scene) -> Scene {
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    mapped(scene, |corner| turn * corner)
}

/// Rows of both scenes by number: what each exchanges is the same within both bounds, and the
/// bounds are small.
fn assert_same(one: &ExchangeAreas, other: &ExchangeAreas, most: f64) {
    let n = one.rows();
    assert_eq!(n, other.rows());
    for i in 0..n {
        let off = (one.areas()[i] - other.areas()[i]).abs();
        assert!(
            off <= one.area_bounds()[i] + other.area_bounds()[i],
            "{i}: {off}"
        );
        for j in 0..n {
            let [a, b] = [one, other].map(|areas| areas.get(i, j).exchange);
            let bounds = a.error + b.error;
            assert!((a.value - b.value).abs() <= bounds, "{i} {j}: {a:?} {b:?}");
            assert!(bounds <= most, "{i} {j}: {bounds}");
        }
    }
}

/// The floor less its middle cell is a ring: two concave polygons by hand, summed.
#[test]
fn a_base_counts_without_its_part() {
    let (a, b) = (1.0 / 3.0, 2.0 / 3.0);
    let whole = || vec![square("floor", 0.0, 1.0, 0.0), square("mat", a, b, 0.0)];
    let left = [(0.0, 0.0), (a, 0.0), (a, a), (a, b), (a, 1.0), (0.0, 1.0)];
    let left = polygon("left", &left, 0.0);
    let right = [
        (a, 0.0),
        (1.0, 0.0),
        (1.0, 1.0),
        (a, 1.0),
        (a, b),
        (b, b),
        (b, a),
        (a, a),
    ];
    let right = polygon("right", &right, 0.0);
    let base = with_walls(whole()).with_base(1, 0).unwrap();
    let cut = with_walls(vec![left, square("mat", a, b, 0.0), right]);
    let rows = [0, 1, 0, 2, 3, 4, 5, 6];
    let cut_rows = cut.clone().with_groups(&rows).unwrap();
    assert_same(&held(&base), &held(&cut_rows), 1e-13);
    let turned_base = turned(&base).with_base(1, 0).unwrap();
    let turned_cut = turned(&cut).with_groups(&rows).unwrap();
    assert_same(&held(&turned_base), &held(&turned_cut), 1e-11);
    assert_same(&held(&turned_base), &held(&base), 1e-11);
    // differences reach the tolerance, too
    assert_eq!(held(&turned_base).summary().unreached, 0);
    assert_eq!(turned_base.blocker(), None);
    assert_eq!(turned_base.overlap(), None);
}

/// A part of a part, against rings of rectangles by hand; the middle ring is a base and a part.
#[test]
fn bases_may_be_nested() {
    let lines: [f64; 3] = [0.0, 0.25, 0.375];
    let names = ["floor", "mat", "tile"];
    let squares = names.iter().zip(lines);
    let squares = squares.map(|(name, low)| square(name, low, 1.0 - low, 0.0));
    let nested = with_walls(squares.collect());
    let nested = nested.with_base(2, 1).unwrap().with_base(1, 0).unwrap();
    let (mut patches, mut rows) = (Vec::new(), Vec::new());
    for ring in 0..2 {
        let (out, inn) = (lines[ring], lines[ring + 1]);
        for [x, y] in [
            [(out, 1.0 - out), (out, inn)],
            [(out, 1.0 - out), (1.0 - inn, 1.0 - out)],
            [(out, inn), (inn, 1.0 - inn)],
            [(1.0 - inn, 1.0 - out), (inn, 1.0 - inn)],
        ] {
            let corners = [(x.0, y.0), (x.1, y.0), (x.1, y.1), (x.0, y.1)];
            patches.push(polygon(names[ring], &corners, 0.0));
            rows.push(ring);
        }
    }
    patches.push(square("tile", 0.375, 0.625, 0.0));
    rows.extend(2..8);
    let cut = with_walls(patches).with_groups(&rows).unwrap();
    assert_eq!(cut.group_names(), nested.group_names());
    assert_same(&held(&nested), &held(&cut), 1e-13);
    assert_eq!(nested.overlap(), None);
}

/// A strip of this width is left of the floor: as a patch of its own it exchanges what the
/// difference says, within its bound.
#[test]
fn what_cancels_keeps_an_honest_bound() {
    let widths = [1e-3, 1e-6, 1e-9, 1e-12].into_iter();
    for width in widths.chain((2..40).map(|k| f64::from(k) * 1e-15)) {
        let edge = 1.0 - width;
        let strip = |low, high| {
            let corners = [(low, 0.0), (high, 0.0), (high, 1.0), (low, 1.0)];
            polygon("strip", &corners, 0.0)
        };
        let floor = vec![square("floor", 0.0, 1.0, 0.0), strip(0.0, edge)];
        let base = held(&with_walls(floor).with_base(1, 0).unwrap());
        let cut = held(&with_walls(vec![strip(edge, 1.0), strip(0.0, edge)]));
        for wall in 2..7 {
            let [left, alone] = [&base, &cut].map(|areas| areas.get(0, wall).exchange);
            let off = (left.value - alone.value).abs();
            assert!(off <= left.error + alone.error, "{width} {wall}: {off}");
            assert!((0.0..=base.areas()[0]).contains(&left.value));
            assert!(left.error < 2e-14, "{width} {wall}: {}", left.error);
        }
    }
}

/// The area of such a strip, turned, so that its corners are rounded: 1e-16 whatever its width.
#[test]
fn areas_that_cancel_keep_an_honest_bound() {
    for width in [1e-3, 1e-6, 1e-9] {
        let part = [
            (0.0, 0.0),
            (1.0 - width, 0.0),
            (1.0 - width, 1.0),
            (0.0, 1.0),
        ];
        let patches = vec![square("floor", 0.0, 1.0, 0.0), polygon("mat", &part, 0.0)];
        let base = turned(&Scene::try_new(patches).unwrap())
            .with_base(1, 0)
            .unwrap();
        let base = held(&base);
        let (off, bound) = (base.areas()[0] - width, base.area_bounds()[0]);
        assert!(
            off.abs() <= bound && bound < 2e-15,
            "{width}: {off} {bound}"
        );
    }
}

/// All that is left of the floor lies behind the wall: it exchanges 0, and rounding makes it
/// neither negative nor certain.
#[test]
fn what_cancels_to_its_bound_is_never_negative() {
    for (step, place) in (1..20).map(|step| (step, f64::from(step) / 20.0)) {
        let from = 0.9 * place;
        let part = [(from, 0.0), (1.0, 0.0), (1.0, 1.0), (from, 1.0)];
        let wall = [(0.2, 0.0), (0.9, 0.0), (0.9, 0.5), (0.3, 0.75)];
        let wall = wall.map(|(y, z)| DVec3::new(place, y, z));
        let wall = Patch::try_new(wall.to_vec()).unwrap();
        let floor = vec![square("floor", 0.0, 1.0, 0.0), polygon("mat", &part, 0.0)];
        let wall = NamedPatch::new("wall".to_owned(), wall);
        let scene = Scene::try_new([floor, vec![wall]].concat()).unwrap();
        let base = held(&turned(&scene).with_base(1, 0).unwrap());
        let left = base.get(0, 2).exchange;
        assert!(
            0.0 <= left.value && left.value <= left.error,
            "{step}: {left:?}"
        );
        assert!(left.error < 1e-12 && base.get(1, 2).exchange.value > 1e-3);
    }
}

/// Off the plane by what is accepted: the base lacks the part's projection, and the bound covers
/// the difference; the part hides nothing of its base, and is hidden by nothing of it.
#[test]
fn a_part_may_lie_off_the_plane_within_rounding() {
    let scene = |height: f64| {
        let lid = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        let lid = polygon("lid", &lid, 0.125);
        let patches = vec![
            square("floor", 0.0, 1.0, 0.0),
            square("mat", 0.25, 0.5, height),
            lid,
        ];
        Scene::try_new(patches).unwrap().with_base(1, 0).unwrap()
    };
    let flat = held(&scene(0.0));
    for height in [9e-13, -9e-13] {
        let off = scene(height);
        assert_eq!(off.blocker(), None);
        let off = held(&off);
        let [a, b] = [&flat, &off].map(|areas| areas.get(0, 2).exchange);
        assert!((a.value - b.value).abs() <= a.error + b.error);
        assert!(b.error < 1e-11);
        let route = off.get(0, 1).route;
        assert_eq!(
            (off.get(0, 1).exchange.value, route),
            (0.0, Route::Coplanar)
        );
    }
}

#[test]
fn parts_that_overlap_are_refused_by_name() {
    let at = |name, low, high| square(name, low, high, 0.0);
    let patches = vec![
        at("floor", 0.0, 1.0),
        at("mat", 0.1, 0.6),
        at("rug", 0.5, 0.9),
    ];
    let scene = Scene::try_new(patches).unwrap();
    let scene = scene.with_base(1, 0).unwrap().with_base(2, 0).unwrap();
    let refusal = scene.check_overlap().unwrap_err().to_string();
    assert!(
        refusal.contains("(mat)") && refusal.contains("(rug)"),
        "{refusal}"
    );
    let scene = Scene::try_new(vec![at("floor", 0.0, 1.0), at("mat", 0.1, 0.6)]).unwrap();
    assert_eq!(scene.overlap(), Some((0, 1)));
    assert_eq!(scene.with_base(1, 0).unwrap().overlap(), None);
}
