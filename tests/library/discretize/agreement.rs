//! Values computed in doubles agree with their enclosures, over all configurations.

use crate::support::breadth::some_of;
use glam::DVec3;
use infoscene::discretize::{
    BestGrid, BoxGrid, CertifiedCut, CertifiedGrid, Cut, GradientCut, PatchSplit, UNIT_CUBE,
};
use infoscene::form_factor::{ExchangeArea, RectanglePair};
use infoscene::geometry::{Patch, Rectangle, SplitAxis};
use infoscene::numeric::{Certificate, Interval, Scalar, tolerance};
use infoscene::scene::{NamedPatch, Scene};

/// `fast` against an enclosure: absolute error up to `allowed` beyond its width, which is below
/// 1e-30.
fn assert_near(fast: f64, enclosure: &Interval, allowed: f64, what: &str) {
    let (_, off) = (enclosure.constant(fast) - enclosure).abs().to_doubles();
    let width = enclosure.width();
    assert!(
        off <= allowed + width,
        "{what}: {fast:e} is {off:e} off {:e}, {allowed:e} is allowed",
        enclosure.to_f64()
    );
    assert!(width <= 1e-30, "{what}: width {width:e}");
}

/// A scene whose first patch is cut.
struct Example {
    scene: Scene,
    /// The patches that it is judged against.
    against: Vec<usize>,
    name: String,
    /// The axis along which its gain is hardly curved: see [`FLAT_POSITION`].
    flat_along: Option<SplitAxis>,
}

fn examples() -> Vec<Example> {
    let mut examples = Vec::new();
    let mut add = |scene: Scene, name: String, flat_along| {
        let against = (1..scene.patches().len()).collect();
        examples.push(Example {
            scene,
            against,
            name,
            flat_along,
        });
    };
    for depth in [1e-2, 0.1, 0.5, 1.0, 3.0, 10.0, 1e2] {
        let flat_along = (depth < 0.05).then_some(SplitAxis::U);
        let scene = Scene::floor_and_wall(depth).unwrap();
        add(scene, format!("floor {depth} deep"), flat_along);
    }
    for distance in [0.1, 0.5, 1.0, 2.0] {
        let scene = Scene::facing_squares(distance).unwrap();
        add(scene, format!("squares {distance} apart"), None);
    }
    for ([x, y, z], flat_along) in [
        ([1.0, 1.0, 1.0], None),
        ([2.0, 1.0, 0.5], None),
        ([0.1, 1.0, 3.0], Some(SplitAxis::V)),
    ] {
        let scene = Scene::inside_of_box(x, y, z).unwrap();
        add(scene, format!("box {x} {y} {z}"), flat_along);
    }
    let corner = Scene::built_in("three-squares").unwrap();
    add(corner, "corner".to_owned(), None);
    examples
}

/// The effect of the error bounds of the parts' exchange areas on the gain: its derivative by the
/// exchange `G_k` of a part is `(2/A_T) log2( (G_k/G) / (W_k/W) )`.
fn propagated(scene: &Scene, against: &[usize], axis: SplitAxis, cuts: &[f64]) -> f64 {
    let first = scene.rectangle(0).unwrap();
    let mut ends = vec![0.0];
    ends.extend(cuts);
    ends.push(1.0);
    let mut sum = 0.0;
    for other in against {
        let pair = RectanglePair::try_new(&first, &scene.rectangle(*other).unwrap()).unwrap();
        let whole = pair.exchange_area().unwrap().value;
        for part in ends.windows(2) {
            let exchange = pair.part(axis, &part[0], &part[1]).unwrap();
            let ExchangeArea { value, error } = exchange.exchange_area().unwrap();
            let ratio = value / whole / (part[1] - part[0]);
            sum += ratio.log2().abs() * error;
        }
    }
    2.0 * sum / scene.total_area()
}

/// Gains within `tolerance::GAIN` of themselves beyond what the error bounds of the form factors
/// come to, and their derivatives within as much of a bit.
#[test]
fn gains_agree_with_their_enclosures() {
    let like = Interval::precise(1.0, 256);
    for example in examples() {
        let Example {
            scene,
            against,
            name,
            ..
        } = &example;
        for axis in SplitAxis::ALL {
            let split = PatchSplit::try_new(scene, 0, against, axis).unwrap();
            let lifted = split.rectangles().unwrap().lifted(&like);
            for cuts in [vec![0.3], vec![1e-6], vec![0.999], vec![0.25, 0.5]] {
                let wide: Vec<Interval> = cuts.iter().map(|t| like.constant(*t)).collect();
                let what = format!("{name} {axis:?} {cuts:?}");
                let enclosure = lifted.gain(&wide).unwrap();
                let gain = split.gain(&cuts).unwrap();
                let allowed = tolerance::GAIN * gain + propagated(scene, against, axis, &cuts);
                assert_near(gain, &enclosure, allowed, &what);
                for k in 0..cuts.len() {
                    let enclosure = lifted.gain_derivative(&wide, k).unwrap();
                    let slope = split.gain_derivative(&cuts, k).unwrap();
                    assert_near(slope, &enclosure, tolerance::GAIN, &what);
                }
            }
        }
    }
}

/// Position of the best cut where its gain is hardly curved: (b) the floor a hundredth as deep as
/// wide, whose gain is 6e-7 bits, is off by 1.02e-14, a box by 1.3e-14.
const FLAT_POSITION: f64 = 4.0 * tolerance::POSITION;

/// Best cuts within `tolerance::POSITION` of the certified ones, their gains within
/// `tolerance::GAIN`; and all these are certified.
#[test]
fn best_cuts_agree_with_certified_ones() {
    for example in some_of(examples()) {
        let Example {
            scene,
            against,
            name,
            ..
        } = &example;
        for axis in SplitAxis::ALL {
            let what = format!("{name} {axis:?}");
            let split = PatchSplit::try_new(scene, 0, against, axis).unwrap();
            let fast = split.best(2).unwrap();
            let certified = split.certified_best(128).unwrap();
            let is_known = !matches!(certified.certificate, Certificate::Unknown { .. });
            assert!(is_known, "{what}: {:?}", certified.certificate);
            let allowed = match example.flat_along {
                Some(flat) if flat == axis => FLAT_POSITION,
                _ => tolerance::POSITION,
            };
            let found = fast.positions[0];
            // of two maxima that mirror each other the doubles may choose either
            let is_mirrored = (certified.position.to_f64() - found).abs() > 1e-3;
            let found = if is_mirrored { 1.0 - found } else { found };
            assert!(
                !is_mirrored || certified.certificate == Certificate::Several { maximisers: 2 },
                "{what}"
            );
            assert_near(found, &certified.position, allowed, &what);
            assert_near(
                fast.gain,
                &certified.value,
                tolerance::GAIN * fast.gain,
                &what,
            );
        }
    }
}

/// Relative error of a complement, as `GradientCut` promises.
const COMPLEMENT: f64 = 1e-12;

/// Cuts of §4.2 from one end of the exponents to the other, both readings and both criteria.
#[test]
fn gradient_cuts_agree_with_certified_ones() {
    let agree = |fast: &Cut, certified: &CertifiedCut, what: &str| {
        assert_near(
            fast.position,
            &certified.position,
            tolerance::POSITION,
            what,
        );
        let allowed = COMPLEMENT * fast.complement;
        assert_near(fast.complement, &certified.complement, allowed, what);
        assert_near(
            fast.value,
            &certified.value,
            tolerance::GAIN * fast.value,
            what,
        );
        // the small ones are narrow relative to themselves
        for enclosure in [&certified.complement, &certified.value] {
            assert!(enclosure.width() <= 1e-25 * enclosure.to_f64(), "{what}");
        }
    };
    let exponents = [
        1e-6, 1e-3, 0.1, 0.5, 1.0, 1.5, 2.0, 3.0, 10.0, 64.0, 1e3, 1e6, 1e9, 1e12,
    ];
    for n in exponents {
        for m in [1.0, n] {
            let cut = GradientCut::try_new(n, m).unwrap();
            let certified = cut.certified_mutual_information_cut(192).unwrap();
            agree(
                &cut.mutual_information_cut().unwrap(),
                &certified,
                &format!("{n} {m}"),
            );
        }
        let cut = GradientCut::try_new(n, 1.0).unwrap();
        let certified = cut.certified_mean_square_cut(192).unwrap();
        agree(
            &cut.mean_square_cut().unwrap(),
            &certified,
            &format!("{n}, mean square"),
        );
    }
    // exponents that have nothing to do with each other
    for (n, m) in [(1e-6, 1e12), (1e12, 1e-6), (1e6, 3.0), (0.5, 1e4)] {
        let cut = GradientCut::try_new(n, m).unwrap();
        let certified = cut.certified_mutual_information_cut(192).unwrap();
        agree(
            &cut.mutual_information_cut().unwrap(),
            &certified,
            &format!("{n} {m}"),
        );
    }
}

fn assert_best_grid(cells: u32) {
    let what = format!("{cells} cells");
    let fast = BestGrid::find(UNIT_CUBE, cells).unwrap();
    let certified = CertifiedGrid::best(UNIT_CUBE, cells, 128).unwrap();
    assert_eq!(certified.half.len(), (cells as usize - 1) / 2);
    for (line, enclosure) in fast.grid.lines().iter().zip(&certified.half) {
        assert_near(*line, enclosure, tolerance::POSITION, &what);
    }
    let information = fast.information.mutual_information.value;
    let allowed = tolerance::GRID_INFORMATION * information;
    assert_near(information, &certified.mutual_information, allowed, &what);
}

/// Regular grids of 1 to 5 cells a side, best grids of 1 to 3.
#[test]
fn grids_agree_with_certified_ones() {
    for cells in 1..=5 {
        let fast = BoxGrid::regular(UNIT_CUBE, cells)
            .unwrap()
            .mutual_information()
            .unwrap();
        let enclosure = CertifiedGrid::regular(UNIT_CUBE, cells, 128).unwrap();
        let allowed = tolerance::GRID_INFORMATION * fast;
        assert_near(fast, &enclosure, allowed, &format!("{cells} regular cells"));
    }
    some_of([4, 5, 3, 2, 1]).for_each(assert_best_grid);
}

/// A floor that reaches behind the wall's plane, up to a share of it, where it is dark.
fn crossing(share: f64) -> PatchSplit {
    let patch = |name: &str, origin, u, v| {
        let rectangle = Rectangle::try_new(origin, u, v).unwrap();
        NamedPatch::new(name.to_owned(), Patch::try_from(&rectangle).unwrap())
    };
    let length = 1.0 / (1.0 - share);
    let scene = Scene::try_new(vec![
        patch(
            "floor",
            -share * length * DVec3::X,
            length * DVec3::X,
            DVec3::Y,
        ),
        patch("wall", DVec3::ZERO, DVec3::Y, DVec3::Z),
    ]);
    PatchSplit::try_new(&scene.unwrap(), 0, &[1], SplitAxis::U).unwrap()
}

/// A box of cuts on both sides of the other patch's plane gets no enclosure: the
/// floor gains the most at the plane, where its gain has a corner, and no stationary point
/// elsewhere is certified.
#[test]
fn cuts_across_a_plane_are_never_certified_wrongly() {
    for share in [0.13, 0.3, 0.51, 0.9] {
        let split = crossing(share);
        let is_certified = match split.certified_best(128) {
            Ok(found) => !matches!(found.certificate, Certificate::Unknown { .. }),
            Err(_) => false,
        };
        assert!(!is_certified, "{share}");
        // a ten-thousandth to either side of the plane
        let domain = Interval::try_new(share - 1e-4, share + 1e-4).unwrap();
        let lifted = split.rectangles().unwrap().lifted(&domain);
        assert!(lifted.gain(&[domain]).is_err() && lifted.gain_derivative(&[domain], 0).is_err());
        for aside in [-1e-3, 1e-3] {
            let domain = Interval::try_new(share + aside - 1e-4, share + aside + 1e-4).unwrap();
            let gain = split.gain(&[share + aside]).unwrap();
            assert!(
                split
                    .rectangles()
                    .unwrap()
                    .lifted(&domain)
                    .gain(&[domain])
                    .unwrap()
                    .contains(&Interval::point(gain))
            );
            assert!(gain < split.gain(&[share]).unwrap());
        }
    }
}
