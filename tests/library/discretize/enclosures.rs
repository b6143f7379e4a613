//! Enclosures against the independent values, to one unit of their last printed digit.

use crate::support::breadth::some_of;
use crate::support::references::{Row, rows};
use infoscene::discretize::{
    BoxGrid, CertifiedGrid, GradientCut, GradientLimit, PatchSplit, UNIT_CUBE,
};
use infoscene::form_factor::RectanglePair;
use infoscene::form_factor::rectangles::parallel;
use infoscene::form_factor::rectangles::perpendicular;
use infoscene::form_factor::rectangles::perpendicular::Plate;
use infoscene::geometry::{Rectangle, Span, SplitAxis};
use infoscene::numeric::{Certificate, CertifiedMaximum, Interval, Scalar};
use infoscene::scene::Scene;

/// The precision that claims are enclosed with by default.
const BITS: u32 = 192;
/// Width that every enclosed claim must stay below.
const WIDTH: f64 = 1e-30;

fn number(text: &str) -> Interval {
    Interval::parse(text, 2 * BITS).unwrap()
}

/// `text ± 1` of its last digit. Where fewer digits are printed than are promised the rest are
/// zeros.
fn printed(text: &str, promised: usize) -> Interval {
    let fraction = text.split_once('.').map_or("", |(_, fraction)| fraction);
    let unit = number(&format!("1e-{}", fraction.len().max(promised)));
    let value = number(text);
    (value.clone() - &unit).hull(&(value + &unit))
}

/// The digits promised in a row's last column: `>=28 digits`.
fn promised(row: &Row) -> usize {
    let digits = row.text("digits").split_once(">=");
    let digits = digits.and_then(|(_, rest)| rest.split_once(' '));
    digits.map_or(0, |(digits, _)| digits.parse().unwrap())
}

fn row(file: &str, id: &str) -> Row {
    let found = rows(file).into_iter().find(|row| row.id == id);
    found.unwrap_or_else(|| panic!("{file} has no row {id}"))
}

/// `enclosure ⊂ printed ± 1 unit of its last digit`, width ≤ 1e-30.
fn assert_encloses(enclosure: &Interval, printed: &Interval, id: &str) {
    assert!(
        printed.contains(enclosure),
        "{id}: {:?} outside {:?}",
        enclosure.to_decimal(40),
        printed.to_decimal(40)
    );
    let width = enclosure.width();
    assert!(width <= WIDTH, "{id}: width {width:e}");
}

fn assert_row(enclosure: &Interval, file: &str, id: &str) {
    let row = row(file, id);
    assert_encloses(
        enclosure,
        &printed(row.text("value"), promised(&row)),
        &row.id,
    );
}

/// The best cut of the floor, whose certificate must be that of a global maximum.
fn best(split: &PatchSplit) -> CertifiedMaximum {
    let best = split.certified_best(BITS).unwrap();
    assert!(
        !matches!(best.certificate, Certificate::Unknown { .. }),
        "{:?}",
        best.certificate
    );
    best
}

/// The file's U is `½ A_T ΔI`.
fn half_of(gain: &Interval, scene: &Scene) -> Interval {
    gain.constant(0.5 * scene.total_area()) * gain
}

/// The best parallel cut of two squares, of 35 digits.
#[test]
fn the_cut_of_two_squares_is_enclosed_to_35_digits() {
    let scene = Scene::built_in("two-squares").unwrap();
    let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
    // Newton's method on the exact derivative at 60 digits
    let exact = printed("0.39920102604538512521124559685795978", 0);
    assert_encloses(&best(&split).position, &exact, "two squares");
}

/// Figs. 2 and 3 and a floor twice as deep: positions and gains.
#[test]
fn best_cuts_are_enclosed_to_25_digits() {
    for (scene, against, axis, id) in [
        (
            Scene::built_in("two-squares").unwrap(),
            vec![1],
            SplitAxis::U,
            "split_perp_par_bothdepth1",
        ),
        (
            Scene::floor_and_wall(2.0).unwrap(),
            vec![1],
            SplitAxis::U,
            "split_perp_par_splitdepth2",
        ),
        (
            Scene::built_in("two-squares").unwrap(),
            vec![1],
            SplitAxis::V,
            "split_perp_orth_bothdepth1",
        ),
        (
            Scene::built_in("three-squares").unwrap(),
            vec![1, 2],
            SplitAxis::U,
            "three_squares",
        ),
    ] {
        let split = PatchSplit::try_new(&scene, 0, &against, axis).unwrap();
        let best = best(&split);
        assert_row(&best.position, "splits.csv", &format!("{id}_t"));
        let half = half_of(&best.value, &scene);
        assert_row(&half, "splits.csv", &format!("{id}_U"));
        let is_alone = matches!(best.certificate, Certificate::Unique { .. });
        assert_eq!(
            is_alone,
            axis == SplitAxis::U,
            "an orthogonal cut has a mirror image"
        );
    }
}

/// The curves of figs. 2 and 3 at every tenth that the file has; the tenths are not doubles.
#[test]
fn curves_are_enclosed_to_28_digits() {
    let squares = Scene::built_in("two-squares").unwrap();
    let corner = Scene::built_in("three-squares").unwrap();
    let like = Interval::precise(1.0, BITS);
    let mut count = 0;
    for (scene, against, axis, id) in [
        (&squares, vec![1], SplitAxis::U, "curve_perp_par_t"),
        (&squares, vec![1], SplitAxis::V, "curve_perp_orth_t"),
        (&corner, vec![1, 2], SplitAxis::U, "curve_three_t"),
    ] {
        let split = PatchSplit::try_new(scene, 0, &against, axis).unwrap();
        let split = split.rectangles().unwrap().lifted(&like);
        for row in rows("splits.csv") {
            let Some(tenths) = row.id.strip_prefix(id) else {
                continue;
            };
            let position = Interval::parse(&format!("0.{tenths}"), BITS).unwrap();
            let half = half_of(&split.gain(&[position]).unwrap(), scene);
            assert_row(&half, "splits.csv", &row.id);
            count += 1;
        }
    }
    assert_eq!(count, 10, "rows of curves");
}

/// Every row of §4.2: n = 1, 2, 3, 4, 8, 64 as printed, n = 1, 2, 3, 4 where irradiance grows as
/// radiosity, the limits.
#[test]
fn cuts_of_section_4_2_are_enclosed_to_28_digits() {
    let mut count = 0;
    for n in [1, 2, 3, 4, 8, 64] {
        let cut = GradientCut::try_new(n.into(), 1.0).unwrap();
        let information = cut.certified_mutual_information_cut(BITS).unwrap();
        let square = cut.certified_mean_square_cut(BITS).unwrap();
        for (enclosure, quantity) in [
            (information.position, "mi42_l"),
            (information.complement, "mi42_1ml"),
            (information.value, "mi42_f_bits"),
            (square.position, "mse42_l"),
            (square.complement, "mse42_1ml"),
            (square.value, "mse42_mse"),
        ] {
            let id = quantity.replace("42_", &format!("42_n{n}_"));
            assert_row(&enclosure, "section_4_2.csv", &id);
            count += 1;
        }
    }
    for n in [1, 2, 3, 4] {
        let cut = GradientCut::try_new(n.into(), n.into()).unwrap();
        let cut = cut.certified_mutual_information_cut(BITS).unwrap();
        for (enclosure, quantity) in [
            (cut.position, "l"),
            (cut.complement, "1ml"),
            (cut.value, "f_bits"),
        ] {
            let id = format!("mi42same_n{n}_{quantity}");
            assert_row(&enclosure, "section_4_2.csv", &id);
            count += 1;
        }
    }
    for (limit, id) in GradientLimit::ALL.into_iter().zip(["mi", "same", "mse"]) {
        let enclosure = limit.enclosed(BITS).unwrap().limit;
        assert_row(&enclosure, "section_4_2.csv", &format!("limit42_{id}"));
        count += 1;
    }
    assert_eq!(count, rows("section_4_2.csv").len());
}

/// Regular grids of 1, 2, 3, 4, 6 cells a side.
#[test]
fn regular_grids_are_enclosed_to_29_digits() {
    for cells in [1, 2, 3, 4, 6] {
        let information = CertifiedGrid::regular(UNIT_CUBE, cells, BITS).unwrap();
        assert_row(
            &information,
            "cube_grids.csv",
            &format!("cube_regular_{cells}"),
        );
    }
}

/// The best grid of `cells` cells: lines to 20 digits, information to 29.
fn assert_best_grid(cells: u32) {
    let best = CertifiedGrid::best(UNIT_CUBE, cells, BITS).unwrap();
    let id = format!("cube_optimal_{cells}");
    assert_row(&best.mutual_information, "cube_grids.csv", &id);
    for (k, line) in best.half.iter().enumerate() {
        assert_row(line, "cube_grids.csv", &format!("{id}_line{}", k + 1));
    }
    // with one free line the maximum is global
    let is_global = matches!(best.certificate, Certificate::Unique { .. });
    assert_eq!(is_global, cells == 3, "{:?}", best.certificate);
    if cells == 3 {
        let twentieths = best.half[0].constant(20.0) * &best.half[0];
        assert_row(&twentieths, "cube_grids.csv", "fig4_opt_x");
    }
}

/// The best grids of 3 and 4 cells.
#[test]
fn best_grids_are_enclosed_to_20_digits() {
    some_of([3, 4]).for_each(assert_best_grid);
}

/// The best grid of 6 cells.
#[test]
#[ignore = "seconds: cargo test --release --test library six_cells -- --ignored"]
fn the_best_grid_of_six_cells_is_enclosed_to_20_digits() {
    assert_best_grid(6);
}

/// Fig. 4 at x = 2 and 6 and at the regular grid; the file's 13 digits there are from doubles.
#[test]
fn figure_4_is_enclosed_to_13_digits() {
    let like = Interval::precise(1.0, BITS);
    for (x, id) in [
        ("2", "fig4_x2"),
        ("6", "fig4_x6"),
        ("", "fig4_x6.666667 (regular)"),
    ] {
        let line = match x {
            "" => like.clone() / &like.constant(3.0),
            x => Interval::parse(x, BITS).unwrap() / &like.constant(20.0),
        };
        let grid = BoxGrid::mirrored(UNIT_CUBE, &[line], 3, &like).unwrap();
        let text = row("cube_grids.csv", id).text("value").to_owned();
        let exact = printed(&text[..text.len().min(15)], 0);
        assert_encloses(&grid.mutual_information().unwrap(), &exact, id);
    }
}

/// The extents of a row's two polygons along x, y and z, as the decimals that they are printed
/// with.
fn extents(row: &Row) -> [[[Interval; 2]; 3]; 2] {
    let polygons: Vec<&str> = row.text("inputs").split(';').collect();
    [0, 1].map(|which| {
        let corners: Vec<[String; 3]> = serde_json::from_str(&polygons[which][2..]).unwrap();
        [0, 1, 2].map(|axis| {
            let mut all: Vec<Interval> = corners
                .iter()
                .map(|corner| Interval::parse(&corner[axis], BITS).unwrap())
                .collect();
            all.sort_by(|a, b| a.to_f64().total_cmp(&b.to_f64()));
            [all[0].clone(), all[all.len() - 1].clone()]
        })
    })
}

/// Exchange area of two rectangles by their extents; the first lies in a plane z = 0, the second is
/// parallel to it, or in the plane x = 0.
fn exchange(row: &Row) -> Interval {
    let [first, second] = extents(row);
    let span = |[lower, upper]: &[Interval; 2]| Span::try_new(lower.clone(), upper.clone());
    let is_flat = |[lower, upper]: &[Interval; 2]| lower.to_f64() == upper.to_f64();
    let [x, y] = [&first[0], &first[1]].map(|extent| span(extent).unwrap());
    if is_flat(&second[2]) {
        let spans = [&second[0], &second[1]].map(|extent| span(extent).unwrap());
        parallel::exchange_area(&[x, y], &spans, &second[2][0])
            .unwrap()
            .value
    } else {
        assert!(is_flat(&second[0]) && second[0][0].is_zero(), "{}", row.id);
        let [width, depth] = [&second[1], &second[2]].map(|extent| span(extent).unwrap());
        let [first, second] =
            [(x, y), (depth, width)].map(|(depth, width)| Plate::try_new(depth, width).unwrap());
        perpendicular::exchange_area(&first, &second).value
    }
}

/// The 18 aligned pairs, of the decimals as printed (0.1 is no double); and by their doubles, where
/// these are the same.
#[test]
fn exchange_areas_are_enclosed_to_30_digits() {
    let like = Interval::precise(1.0, BITS);
    let (mut count, mut same) = (0, 0);
    for row in rows("form_factors.csv") {
        let polygons = row.polygons();
        let rectangles: Result<Vec<_>, _> = polygons.iter().map(Rectangle::try_from).collect();
        let Ok(rectangles) = rectangles else { continue };
        let pairs = [(0, 1), (1, 0)]
            .map(|(first, second)| RectanglePair::try_new(&rectangles[first], &rectangles[second]));
        let [Ok(pair), Ok(reverse)] = pairs else {
            continue;
        };
        let exact = printed(row.text("exchange_area"), 0);
        assert_encloses(&exchange(&row), &exact, &row.id);
        count += 1;
        let corners = extents(&row);
        if corners.iter().flatten().flatten().all(Interval::is_point) {
            for pair in [pair, reverse] {
                let value = pair.lifted(&like).exchange_value().unwrap();
                assert_encloses(&value, &exact, &row.id);
            }
            same += 1;
        }
    }
    assert_eq!((count, same), (18, 12));
}
