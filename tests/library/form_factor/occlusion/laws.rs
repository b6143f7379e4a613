//! Laws of exchange areas past others, on families of random pairs.
//!
//! Some cases of each family run by default; `INFOSCENE_COUNT=10000 cargo test --release --test
//! library occlusion::laws -- --ignored` takes as many as are asked for, `INFOSCENE_FAMILY=Box` of
//! one family alone.

use glam::{DQuat, DVec3};
use infoscene::form_factor::{DEFAULT_TOLERANCE, ExchangeArea, Occluders, Polygon, Route};
use infoscene::geometry::{GeometryError, Patch};
use infoscene::reference::exchange_area_past;
use infoscene::study::form_factors::occluded::{OccludedFamily, OccludedPair};
use std::num::NonZero;
use std::panic::catch_unwind;

/// A pair and its blockers, with what the two exchange.
type Known = (Vec<Patch>, ExchangeArea);

thread_local! {
    /// The last exchange areas: all laws ask for that of the case itself.
    static KNOWN: std::cell::RefCell<std::collections::VecDeque<Known>> =
        const { std::cell::RefCell::new(std::collections::VecDeque::new()) };
}

fn exchange(pair: [&Patch; 2], blockers: &[Patch]) -> ExchangeArea {
    let asked: Vec<Patch> = pair.into_iter().chain(blockers).cloned().collect();
    let is_asked = |known: &&Known| known.0 == asked;
    if let Some(found) = KNOWN.with_borrow(|known| known.iter().find(is_asked).map(|known| known.1))
    {
        return found;
    }
    let found = computed(pair, blockers);
    KNOWN.with_borrow_mut(|known| {
        known.truncate(7);
        known.push_front((asked, found));
    });
    found
}

fn computed([first, second]: [&Patch; 2], blockers: &[Patch]) -> ExchangeArea {
    let blockers: Vec<Polygon> = blockers.iter().map(Polygon::new).collect();
    let polygons: Vec<&Polygon> = blockers.iter().collect();
    let occluders = Occluders {
        polygons: &polygons,
        touching: 0.0,
    };
    let [first, second] = [first, second].map(Polygon::new);
    let answer = first.exchange_area_past(&second, &occluders, DEFAULT_TOLERANCE);
    answer.unwrap().exchange
}

fn of(case: &OccludedPair) -> ExchangeArea {
    exchange([&case.pair[0], &case.pair[1]], &case.blockers)
}

/// `|a − b| ≤ errors + allowed`.
fn agree(a: ExchangeArea, b: ExchangeArea, allowed: f64) -> bool {
    (a.value - b.value).abs() <= a.error + b.error + allowed
}

/// `J_PQ = J_QP`, to the last bit.
fn reciprocity(case: &OccludedPair) -> Result<(), String> {
    let (there, back) = (
        of(case),
        exchange([&case.pair[1], &case.pair[0]], &case.blockers),
    );
    is_met(there == back, &format!("{there:?}, and back {back:?}"))
}

/// `0 ≤ J past all ≤ … ≤ J past one ≤ J past none`, within the bounds.
fn monotony(case: &OccludedPair) -> Result<(), String> {
    let pair = [&case.pair[0], &case.pair[1]];
    let mut before = exchange(pair, &[]);
    for count in 1..=case.blockers.len() {
        let after = exchange(pair, &case.blockers[..count]);
        let is_less = after.value <= before.value + before.error + after.error;
        let message = format!("{after:?} past {count} after {before:?}");
        is_met(is_less && after.value >= 0.0, &message)?;
        before = after;
    }
    Ok(())
}

/// The order of blockers changes nothing.
fn order(case: &OccludedPair) -> Result<(), String> {
    let mut turned = case.clone();
    turned.blockers.reverse();
    same(of(case), of(&turned), 0.0)
}

/// A blocker cut in two hides as much.
fn division(case: &OccludedPair) -> Result<(), String> {
    let mut divided = case.clone();
    divided.blockers = case.blockers.iter().flat_map(halves).collect();
    same(of(case), of(&divided), 0.0)
}

/// A polygon as two: at a diagonal, or from a corner to the middle of a side, which is exact.
fn halves(blocker: &Patch) -> Vec<Patch> {
    let patch = |corners: &[DVec3]| Patch::try_new(corners.to_vec()).unwrap();
    match *blocker.corners() {
        [a, b, c] => {
            let middle = 0.5 * (b + c);
            vec![patch(&[a, b, middle]), patch(&[a, middle, c])]
        }
        [a, b, c, d] => vec![patch(&[a, b, c]), patch(&[a, c, d])],
        // a hook, cut from its inner corner
        [a, b, c, d, e, f] => vec![patch(&[a, b, c, d]), patch(&[a, d, e, f])],
        _ => vec![blocker.clone()],
    }
}

fn moved(case: &OccludedPair, map: impl Fn(DVec3) -> DVec3) -> Result<OccludedPair, GeometryError> {
    let moved = |patch: &Patch| {
        let corners = patch.corners().iter().map(|corner| map(*corner));
        Patch::try_new(corners.collect())
    };
    let [first, second] = case.pair.each_ref().map(moved);
    let blockers: Result<_, _> = case.blockers.iter().map(moved).collect();
    Ok(OccludedPair {
        pair: [first?, second?],
        blockers: blockers?,
    })
}

/// Exact moves change nothing: the axes in turn, a shift, a power of two.
fn moves(case: &OccludedPair) -> Result<(), String> {
    let turned = moved(case, |corner| {
        4.0 * DVec3::new(corner.y, corner.z, corner.x) + DVec3::new(2.0, -1.0, 3.0)
    });
    let turned = turned.map_err(|error| error.to_string())?;
    let mut found = of(&turned);
    (found.value, found.error) = (found.value / 16.0, found.error / 16.0);
    same(of(case), found, 0.0)
}

/// Any rotation changes what the rounding of the corners does: a corner moved by 4 ε moves the
/// outline's shadow by as much, over P of an outline below 8, magnified by Q's distance over the
/// gap of a close plate's edge never, as the shadow's edge stays: 64 ε.
fn rotations(case: &OccludedPair) -> Result<(), String> {
    let turn = DQuat::from_axis_angle(DVec3::new(0.48, -0.6, 0.64), 1.1);
    let mut triangles = case.clone();
    triangles.blockers = case.blockers.iter().flat_map(halves).collect();
    // the corners of a tiny quadrilateral are in no plane once they are rounded
    let turned = moved(case, |corner| turn * corner)
        .or_else(|_| moved(&triangles, |corner| turn * corner))
        .map_err(|error| error.to_string())?;
    same(of(case), of(&turned), 64.0 * f64::EPSILON)
}

/// The rule over the area finds the same, within its estimate.
fn second_road(case: &OccludedPair) -> Result<(), String> {
    let slow = exchange_area_past(&case.pair[0], &case.pair[1], &case.blockers, 1e-9).unwrap();
    let fast = of(case);
    let is_same = (slow.value - fast.value).abs() <= 2.0 * slow.error + fast.error + 1e-14;
    is_met(is_same, &format!("{fast:?}, and over the area {slow:?}"))
}

fn same(one: ExchangeArea, other: ExchangeArea, allowed: f64) -> Result<(), String> {
    is_met(
        agree(one, other, allowed),
        &format!("{one:?} and {other:?}"),
    )
}

fn is_met(is_met: bool, message: &str) -> Result<(), String> {
    if is_met {
        Ok(())
    } else {
        Err(message.to_owned())
    }
}

type Law = (&'static str, fn(&OccludedPair) -> Result<(), String>);

const LAWS: [Law; 6] = [
    ("reciprocity", reciprocity),
    ("monotony", monotony),
    ("order", order),
    ("division", division),
    ("moves", moves),
    ("rotations", rotations),
];

/// The faults of some laws on so many cases of each family.
fn faults(laws: &[Law], count: u64) -> Vec<String> {
    let threads = std::thread::available_parallelism().map_or(1, NonZero::get) as u64;
    let check = |part: u64| {
        let mut faults = Vec::new();
        for family in families() {
            for number in (part..count).step_by(threads as usize) {
                let case = family.case(number).unwrap();
                for (name, law) in laws {
                    // a panic is a fault of this case, and no end to the others
                    let found = catch_unwind(|| law(&case));
                    let found = found.unwrap_or_else(|_| Err("a panic".to_owned()));
                    if let Err(fault) = found {
                        faults.push(format!("{family:?} {number}, {name}: {fault}"));
                    }
                }
            }
        }
        faults
    };
    let check = &check;
    let mut found: Vec<String> = std::thread::scope(|scope| {
        let parts: Vec<_> = (0..threads)
            .map(|part| scope.spawn(move || check(part)))
            .collect();
        parts
            .into_iter()
            .flat_map(|part| part.join().unwrap())
            .collect()
    });
    found.sort();
    found
}

/// All families, or the one that `INFOSCENE_FAMILY` names.
fn families() -> Vec<OccludedFamily> {
    let asked = std::env::var("INFOSCENE_FAMILY").ok();
    let is_asked = |family: &OccludedFamily| {
        let name = format!("{family:?}");
        asked.as_ref().is_none_or(|asked| *asked == name)
    };
    OccludedFamily::ALL.into_iter().filter(is_asked).collect()
}

fn count(default: u64) -> u64 {
    let given = std::env::var("INFOSCENE_COUNT").ok();
    given.and_then(|text| text.parse().ok()).unwrap_or(default)
}

#[test]
fn laws_hold_past_others() {
    let faults = faults(&LAWS, 2);
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
}

#[test]
#[ignore = "hours: \
            INFOSCENE_COUNT=10000 cargo test --release --test library all_occluded -- --ignored"]
fn all_occluded_pairs_keep_the_laws() {
    let faults = faults(&LAWS, count(50));
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
}

#[test]
#[ignore = "half a minute: cargo test --test library second_road_meets_a_pair -- --ignored"]
fn the_second_road_meets_a_pair_of_each_family() {
    let faults = faults(&[("second road", second_road)], 1);
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
}

#[test]
#[ignore = "hours: INFOSCENE_COUNT=200 cargo test --release --test library all_second -- --ignored"]
fn all_second_roads_meet() {
    let faults = faults(&[("second road", second_road)], count(5));
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
}

/// Squares one above the other, past a plate that hides each from all of the other.
#[test]
fn a_plate_that_covers_leaves_nothing() {
    let level = |low: f64, high: f64, z: f64, up: bool| {
        let corner = |x, y| DVec3::new(x, y, z);
        let mut corners = vec![
            corner(low, low),
            corner(high, low),
            corner(high, high),
            corner(low, high),
        ];
        if !up {
            corners.reverse();
        }
        Patch::try_new(corners).unwrap()
    };
    let [floor, ceiling] = [level(0.0, 1.0, 0.0, true), level(0.0, 1.0, 1.0, false)];
    for z in [1e-6, 0.25, 0.5, 1.0 - 1e-6] {
        let found = exchange([&floor, &ceiling], &[level(-1.0, 2.0, z, true)]);
        assert!(found.value <= found.error, "{z}: {found:?}");
        assert!(found.error <= 1e-12, "{z}: {found:?}");
    }
}

/// A wall through the middle plane of a symmetric pair hides half: each half sees the half beside
/// it, and nothing of the other.
#[test]
fn a_wall_in_the_middle_leaves_two_halves() {
    let level = |x: [f64; 2], z: f64, up: bool| {
        let corner = |x, y| DVec3::new(x, y, z);
        let mut corners = vec![
            corner(x[0], 0.0),
            corner(x[1], 0.0),
            corner(x[1], 1.0),
            corner(x[0], 1.0),
        ];
        if !up {
            corners.reverse();
        }
        Patch::try_new(corners).unwrap()
    };
    let [floor, ceiling] = [
        level([-1.0, 1.0], 0.0, true),
        level([-1.0, 1.0], 1.0, false),
    ];
    let wall = [[-1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [-1.0, 1.0]];
    let wall = wall.map(|[y, z]| DVec3::new(0.0, y, z)).to_vec();
    let past = exchange([&floor, &ceiling], &[Patch::try_new(wall).unwrap()]);
    let halves = [level([0.0, 1.0], 0.0, true), level([0.0, 1.0], 1.0, false)];
    let half = exchange([&halves[0], &halves[1]], &[]);
    let difference = (past.value - 2.0 * half.value).abs();
    assert!(
        difference <= past.error + 2.0 * half.error,
        "{past:?} {half:?}"
    );
    assert!(past.error <= 1e-12);
}

/// Where all counts as touching, nothing but the limits is known; sizes whose squares leave the
/// range are refused.
#[test]
fn nothing_is_made_up_where_nothing_is_known() {
    let case = OccludedFamily::ALL[0].case(0).unwrap();
    let [first, second] = [&case.pair[0], &case.pair[1]].map(Polygon::new);
    let blocker = Polygon::new(&case.blockers[0]);
    let polygons = [&blocker];
    let past = |touching: f64| {
        let occluders = Occluders {
            polygons: &polygons,
            touching,
        };
        first
            .exchange_area_past(&second, &occluders, 0.0)
            .unwrap()
            .exchange
    };
    let (sharp, blind) = (past(0.0), past(1e3));
    assert!(agree(sharp, blind, 0.0), "{sharp:?} {blind:?}");
    assert!(blind.error > 1e3 * sharp.error, "{sharp:?} {blind:?}");
    for scale in [1e-100, 1e100] {
        let scaled = |patch: &Patch| {
            let corners = patch.corners().iter().map(|corner| *corner * scale);
            Polygon::new(&Patch::try_new(corners.collect()).unwrap())
        };
        let blocker = scaled(&case.blockers[0]);
        let polygons = [&blocker];
        let occluders = Occluders {
            polygons: &polygons,
            touching: 0.0,
        };
        let [first, second] = [&case.pair[0], &case.pair[1]].map(scaled);
        if let Ok(answer) = first.exchange_area_past(&second, &occluders, 1e-12) {
            let ExchangeArea { value, error } = answer.exchange;
            assert!(
                value >= 0.0 && value.is_finite() && error.is_finite(),
                "{scale}: {answer:?}"
            );
        }
    }
}

/// What stands beside all lines of sight, in the box around the pair or out of it, leaves the
/// unoccluded value, without a rule along edges.
#[test]
fn what_is_beside_changes_nothing() {
    let level = |z: f64, [low, high]: [f64; 2], is_up: bool| {
        let mut corners = vec![
            DVec3::new(low, 0.0, z),
            DVec3::new(high, 0.0, z),
            DVec3::new(high, 1.0, z),
            DVec3::new(low, 1.0, z),
        ];
        if !is_up {
            corners.reverse();
        }
        Polygon::new(&Patch::try_new(corners).unwrap())
    };
    let (floor, ceiling) = (level(0.0, [0.0, 1.0], true), level(1.0, [3.0, 4.0], false));
    let bare = floor.exchange_area(&ceiling, DEFAULT_TOLERANCE).unwrap();
    // lines of sight are right of x = 2.7 at z = 0.9
    let beside = [
        level(0.9, [0.0, 2.6], true),
        level(0.5, [5.0, 6.0], true),
        level(-0.5, [0.0, 4.0], true),
    ];
    for polygon in &beside {
        let occluders = Occluders {
            polygons: &[polygon],
            touching: 0.0,
        };
        let answer = floor.exchange_area_past(&ceiling, &occluders, DEFAULT_TOLERANCE);
        let answer = answer.unwrap();
        assert_ne!(answer.route, Route::Occluded);
        assert!(agree(answer.exchange, bare.exchange, 0.0));
    }
    let inside = level(0.9, [0.0, 2.8], true);
    let occluders = Occluders {
        polygons: &[&inside],
        touching: 0.0,
    };
    let answer = floor.exchange_area_past(&ceiling, &occluders, DEFAULT_TOLERANCE);
    let answer = answer.unwrap();
    assert!(answer.exchange.value < bare.exchange.value - 1e-6);
}

/// A plane of sight that is level at the middle of a stretch, where the boundary is looked for
/// first, settles nothing beside that place.
#[test]
fn a_plane_that_is_level_for_a_moment_settles_nothing() {
    let patch = |corners: [[f64; 3]; 4]| {
        let corners = corners.map(DVec3::from_array);
        Patch::try_new(corners.into_iter().collect()).unwrap()
    };
    let floor = patch([
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ]);
    // both upper corners of the wall's ends are at 1, so that y is at ½ half-way along its rims
    let wall = patch([
        [2.0, 0.1, 0.0],
        [2.0, 0.4, 1.0],
        [2.0, 0.9, 1.0],
        [2.0, 0.6, 0.0],
    ]);
    let plate = patch([
        [1.5, 0.2, 0.5],
        [1.5, 0.8, 0.5],
        [1.5, 0.8, 1.5],
        [1.5, 0.2, 1.5],
    ]);
    let case = OccludedPair {
        pair: [floor, wall],
        blockers: vec![plate],
    };
    let found = of(&case);
    assert!(found.error <= 1e-11 * found.value, "{found:?}");
    second_road(&case).unwrap();
}
