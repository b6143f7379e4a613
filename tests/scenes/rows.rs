//! Exchange areas of bases without their parts, and of rows that are summed.

use glam::{DQuat, DVec3};
use infoscene::chain::{ReversibleChain, visibility_chain};
use infoscene::geometry::Patch;
use infoscene::information::{Surroundings, mutual_information, scene_information};
use infoscene::numeric::tolerance;
use infoscene::scene::{
    Closure, Congruence, ExchangeAreas, Material, NamedPatch, Scene, SceneError, ScenePairs,
};
use nalgebra::DMatrix;

const TOLERANCE: f64 = 1e-12;

/// Opposite faces of a cube, `(2/π)(ln(2/√3) + 2√2 arctan(1/√2) − π/2)`: Howell, C-11 with X = Y = 1.
fn opposite() -> f64 {
    let arc = 2.0 * 2f64.sqrt() * (0.5f64.sqrt()).atan();
    2.0 / std::f64::consts::PI * ((2.0 / 3f64.sqrt()).ln() + arc - std::f64::consts::FRAC_PI_2)
}

fn polygon(name: &str, corners: &[(f64, f64)], z: f64) -> NamedPatch {
    let corners = corners.iter().map(|(x, y)| DVec3::new(*x, *y, z));
    NamedPatch::new(name.to_owned(), Patch::try_new(corners.collect()).unwrap())
}

fn square(name: &str, low: f64, high: f64, z: f64) -> NamedPatch {
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

fn turned(scene: &Scene, patches: &[NamedPatch]) -> Vec<NamedPatch> {
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    assert_eq!(scene.patches().len(), patches.len());
    let turned = patches.iter().map(|patch| {
        let corners = patch.shape().corners().iter().map(|corner| turn * *corner);
        let shape = Patch::try_new(corners.collect()).unwrap();
        NamedPatch::new(patch.name().to_owned(), shape)
    });
    turned.collect()
}

fn pairs(scene: &Scene) -> ScenePairs {
    ScenePairs::try_new(scene, TOLERANCE, Congruence::Shared).unwrap()
}

fn held(scene: &Scene) -> ExchangeAreas {
    pairs(scene).exchange_areas().unwrap()
}

/// Rows of both scenes by number: what each exchanges is the same within both bounds, and the bounds are small.
fn assert_same(one: &ExchangeAreas, other: &ExchangeAreas, most: f64) {
    let n = one.patches();
    assert_eq!(n, other.patches());
    for i in 0..n {
        let off = (one.areas()[i] - other.areas()[i]).abs();
        assert!(
            off <= one.area_bounds()[i] + other.area_bounds()[i],
            "{i}: {off}"
        );
        for j in 0..n {
            let [a, b] = [one, other].map(|areas| areas.get(i, j).exchange);
            let bounds = a.error_bound + b.error_bound;
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
    let turned_base = Scene::try_new(turned(&base, base.patches())).unwrap();
    let turned_base = turned_base.with_base(1, 0).unwrap();
    let turned_cut = Scene::try_new(turned(&cut, cut.patches())).unwrap();
    let turned_cut = turned_cut.with_groups(&rows).unwrap();
    assert_same(&held(&turned_base), &held(&turned_cut), 1e-11);
    assert_same(&held(&turned_base), &held(&base), 1e-11);
    // differences reach the tolerance, too
    assert_eq!(held(&turned_base).account().unreached, 0);
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

/// A_g F_gh = Σ Σ A_i F_ij, and twice each pair within the row on the diagonal.
#[test]
fn rows_are_sums() {
    let cube = Scene::built_in("cube:2").unwrap();
    let labels: Vec<usize> = (0..24).map(|patch| (patch * patch) % 7).collect();
    let summed = cube.clone().with_groups(&labels).unwrap();
    let (fine, coarse) = (held(&cube), held(&summed));
    let n = summed.group_count();
    assert_eq!((coarse.patches(), n), (n, 4));
    for g in 0..n {
        for h in 0..n {
            let patches = |row: usize| summed.patches_of_group(row);
            let terms = patches(g).flat_map(|i| patches(h).map(move |j| (i, j)));
            let terms: Vec<f64> = terms.map(|(i, j)| fine.get(i, j).exchange.value).collect();
            let sum: f64 = terms.iter().sum();
            let found = coarse.get(g, h).exchange;
            assert!((found.value - sum).abs() <= found.error_bound, "{g} {h}");
            assert!(found.error_bound <= 1e-12 * sum, "{g} {h}");
            assert_eq!(coarse.get(h, g), coarse.get(g, h));
        }
        assert!(coarse.sees_itself(g));
    }
    // the four sides of a cube see each other, and all of it sees nothing but itself
    let sides = Scene::built_in("cube:1").unwrap();
    let ring = held(&sides.clone().with_groups(&[0, 1, 2, 2, 2, 2]).unwrap());
    let adjacent = 0.25 * (1.0 - opposite());
    // View3D manual, §6.1
    assert!((opposite() - 0.199_824_896).abs() < 5e-10);
    let own = ring.get(2, 2).exchange.value / ring.areas()[2];
    assert!((own - (1.0 - 2.0 * adjacent)).abs() < 1e-14, "{own}");
    let all = sides.with_groups(&[0; 6]).unwrap();
    let measured = scene_information(&pairs(&all), Surroundings::None).unwrap();
    assert!(measured.mutual_information.abs() <= measured.error && measured.error < 1e-12);
    assert!((measured.closure.worst().sum - 1.0).abs() < 1e-14);
}

/// A cube with a mat, a window with a pane in it, and rows across walls.
fn furnished(labels: bool) -> Scene {
    let mut patches = Scene::built_in("cube:1").unwrap().patches().to_vec();
    patches.push(square("mat", 0.125, 0.5, 0.0));
    for (name, low) in [("window", 0.25), ("pane", 0.375)] {
        let corners = [
            (low, low),
            (1.0 - low, low),
            (1.0 - low, 1.0 - low),
            (low, 1.0 - low),
        ];
        let corners = corners.map(|(y, z)| DVec3::new(0.0, y, z));
        patches.push(NamedPatch::new(
            name.to_owned(),
            Patch::try_new(corners.to_vec()).unwrap(),
        ));
    }
    let left = patches
        .iter()
        .position(|patch| patch.name().starts_with("left"))
        .unwrap();
    let scene = Scene::try_new(patches).unwrap();
    let scene = scene.with_base(6, 0).unwrap();
    let scene = scene.with_base(7, left).unwrap().with_base(8, 7).unwrap();
    // the pane counts with the ceiling, the window with the wall that it is in, the back with the mat
    let labels = if labels {
        vec![0, 1, 2, 3, 4, 6, 6, 2, 1]
    } else {
        (0..9).collect()
    };
    scene.with_groups(&labels).unwrap()
}

#[test]
fn rows_of_a_closed_room_sum_to_one() {
    for labels in [false, true] {
        let scene = furnished(labels);
        assert_eq!((scene.overlap(), scene.blocker()), (None, None));
        let pairs = pairs(&scene);
        let closure = Closure::of(&pairs).unwrap();
        for row in closure.rows() {
            assert!((row.sum - 1.0).abs() <= 1e-13, "{row:?}");
            assert!(row.error_bound <= 1e-12, "{row:?}");
        }
        assert!(closure.is_closed());
        let total: f64 = pairs.areas().iter().sum();
        assert!((total - 6.0).abs() <= 1e-14);
    }
}

/// A joint matrix whose rows and columns are summed is the chain of the summed scene.
#[test]
fn a_summed_scene_is_the_coarser_chain() {
    let cube = Scene::built_in("cube:3").unwrap();
    let labels: Vec<usize> = (0..54).map(|patch| (patch * 7) % 13).collect();
    let fine = cube.exchange_areas().unwrap().into_values();
    let summed = cube.with_groups(&labels).unwrap();
    let n = summed.group_count();
    let mut coarse = DMatrix::zeros(n, n);
    for i in 0..54 {
        for j in 0..54 {
            coarse[(summed.group_of(i), summed.group_of(j))] += fine[(i, j)];
        }
    }
    let coarse = ReversibleChain::try_new(0.5 * (&coarse + coarse.transpose())).unwrap();
    let bits = mutual_information(&coarse);
    let chain = visibility_chain(&summed).unwrap();
    assert!((mutual_information(&chain) - bits).abs() <= tolerance::IDENTITY);
    let measured = scene_information(&pairs(&summed), Surroundings::None).unwrap();
    let off = (measured.mutual_information - bits).abs();
    assert!(off <= measured.error && measured.error <= 1e-10, "{off}");
}

/// As they come, held, by rows and by entries: the same values, sums, counts and information; on any number of threads.
#[test]
fn all_ways_to_the_rows_agree() {
    for scene in [furnished(false), furnished(true)] {
        let pairs = pairs(&scene);
        let held = pairs.exchange_areas().unwrap();
        let (sums, account) = pairs.row_sums(|_, _, exchange| [exchange.value]).unwrap();
        assert_eq!(&account, held.account());
        for (i, [sum]) in sums.iter().enumerate() {
            let row = (0..held.patches()).map(|j| held.get(i, j).exchange.value);
            assert!((sum - row.sum::<f64>()).abs() <= 1e-15);
        }
        let by_rows = pairs.for_each_row(|i, row| -> Result<(), SceneError> {
            for (j, answer) in row.iter().enumerate() {
                assert_eq!(answer, &held.get(i, j));
            }
            Ok(())
        });
        assert_eq!(&by_rows.unwrap(), held.account());
        let (entries, account) = pairs.entries(None, None).unwrap();
        assert_eq!(&account, held.account());
        for entry in &entries {
            assert_eq!(entry.answer, held.get(entry.from, entry.to));
        }
        let plan = account.plan;
        let parts = plan.untouched + plan.congruent + plan.computed;
        assert_eq!(parts, plan.pairs);
        assert_eq!(plan.routes.values().sum::<usize>(), plan.pairs);
        let chain = visibility_chain(&scene).unwrap();
        let measured = scene_information(&pairs, Surroundings::None).unwrap();
        let off = (measured.mutual_information - mutual_information(&chain)).abs();
        assert!(off <= tolerance::IDENTITY, "{off}");
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(5)
            .build()
            .unwrap();
        let again = pool.install(|| scene_information(&pairs, Surroundings::None).unwrap());
        assert_eq!(again, measured);
    }
    // nine patches, the window is summed with its wall and is in no pair
    let counted = |labels| held(&furnished(labels)).account().plan.pairs;
    assert_eq!((counted(false), counted(true)), (36, 28));
}

/// A strip of this width is left of the floor: as a patch of its own it exchanges what the difference says, within its bound.
#[test]
fn what_cancels_keeps_an_honest_bound() {
    for width in [1e-3, 1e-6, 1e-9, 1e-12, 4e-15] {
        let edge = 1.0 - width;
        let strip = |low, high| {
            let corners = [(low, 0.0), (high, 0.0), (high, 1.0), (low, 1.0)];
            polygon("strip", &corners, 0.0)
        };
        let floor = vec![square("floor", 0.0, 1.0, 0.0), strip(0.0, edge)];
        let base = held(&with_walls(floor).with_base(1, 0).unwrap());
        let cut = held(&with_walls(vec![strip(edge, 1.0), strip(0.0, edge)]));
        let off = (base.areas()[0] - cut.areas()[0]).abs();
        assert!(off <= base.area_bounds()[0], "{width}: {off}");
        for wall in 2..7 {
            let [left, alone] = [&base, &cut].map(|areas| areas.get(0, wall).exchange);
            let off = (left.value - alone.value).abs();
            assert!(
                off <= left.error_bound + alone.error_bound,
                "{width} {wall}: {off}"
            );
            assert!((0.0..=base.areas()[0]).contains(&left.value));
            assert!(
                left.error_bound < 2e-14,
                "{width} {wall}: {}",
                left.error_bound
            );
        }
    }
}

/// Off the plane by what is accepted: the base lacks the part's projection, and the bound covers the difference; the part hides
/// nothing of its base, and is hidden by nothing of it.
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
        assert!((a.value - b.value).abs() <= a.error_bound + b.error_bound);
        assert!(b.error_bound < 1e-11);
        assert_eq!(off.get(0, 1).exchange.value, 0.0);
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

#[test]
fn a_row_has_a_material_if_its_patches_agree() {
    let mut patches = walls();
    let paint = Material::try_new(0.5, 1.0).unwrap();
    patches[0] = patches[0].clone().with_material(paint);
    patches[3] = patches[3].clone().with_material(paint);
    let scene = Scene::try_new(patches).unwrap();
    let same = scene.clone().with_groups(&[0, 1, 1, 0, 2]).unwrap();
    assert_eq!(
        [0, 1, 2].map(|row| same.group_material(row).unwrap()),
        [paint, Material::BLACK, Material::BLACK]
    );
    assert_eq!(same.group_names(), ["ceiling 0,0", "left 0,0", "back 0,0"]);
    let none = SceneError::NoSuchPatch { index: 3, last: 2 };
    assert_eq!(same.group_material(3).unwrap_err(), none);
    let mixed = scene.with_groups(&[0, 1, 0, 2, 3]).unwrap();
    let refusal = mixed.group_material(0).unwrap_err().to_string();
    assert!(
        refusal.contains("(ceiling 0,0)") && refusal.contains("(right 0,0)"),
        "{refusal}"
    );
}
