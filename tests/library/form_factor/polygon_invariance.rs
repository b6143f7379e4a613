//! Changes that leave an exchange area alone, family by family.
//!
//! ```text
//!   A F(P, Q) = A F(Q, P)                     the two exchanged
//!   A F(MP, MQ) = A F(P, Q)                   moved: exactly by quarter turns, mirrors
//!                                             and short shifts
//!   A F(2ᵏP, 2ᵏQ) = 4ᵏ A F(P, Q)              enlarged
//!   A F(P, Q) = A F(P₁, Q) + A F(P₂, Q)       cut in two
//! ```
//!
//! each within the error bounds of what is compared. A turn by any angle rounds the corners, by at
//! most δ. The exchange area is the flux through P of the vector irradiance Φ of Q, which has no
//! sources outside Q: it depends on the outline of P only, and a moved outline changes it by the
//! flux through the ribbon swept,
//!
//! ```text
//!   |ΔA F| ≤ δ·(perimeter P · max|Φ_Q| + perimeter Q · max|Φ_P|),   |Φ_Q| ≤ min(1, A_Q/(π d²))
//! ```
//!
//! at distance d. Where one polygon cuts or touches the plane of the other, what lies in front
//! changes as well: Φ is 0 in the plane outside Q, and inside it the cut, no longer than the
//! perimeter, moves by δ/sin θ for planes at an angle θ.

use glam::{DMat3, DVec3};
use infoscene::form_factor::{Answer, DEFAULT_TOLERANCE, Polygon, Route};
use infoscene::geometry::Patch;
use infoscene::reference::Truth;
use infoscene::study::form_factors::families::Family;
use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::OnceLock;

type Pair = [Patch; 2];

fn answer([first, second]: &Pair) -> Result<Answer, String> {
    Polygon::new(first)
        .exchange_area(&Polygon::new(second), DEFAULT_TOLERANCE)
        .map_err(|error| format!("refused: {error}"))
}

/// Both patches with every corner moved.
fn moved(pair: &Pair, to: impl Fn(DVec3) -> DVec3) -> Pair {
    pair.each_ref()
        .map(|patch| Patch::try_new(patch.corners().iter().map(|c| to(*c)).collect()).unwrap())
}

fn corners(pair: &Pair) -> String {
    format!(
        "{:?}",
        pair.each_ref().map(|patch| patch.corners().to_vec())
    )
}

/// A pair and its own answer.
struct Case {
    pair: Pair,
    answer: Result<Answer, String>,
    number: u64,
}

impl Case {
    fn new(family: Family, number: u64) -> Self {
        let pair = family.pair(number).unwrap();
        Self {
            answer: answer(&pair).map_err(|error| format!("{error}\n  {}", corners(&pair))),
            pair,
            number,
        }
    }
}

fn compare(what: &str, case: &Case, other: &Pair, factor: f64, allowed: f64) -> Result<(), String> {
    let one = case.answer.clone()?.exchange;
    let two = answer(other)
        .map_err(|error| format!("{error} when {what}\n  {}", corners(other)))?
        .exchange;
    let difference = (one.value * factor - two.value).abs();
    let bound = one.error * factor + two.error + allowed;
    if difference <= bound {
        return Ok(());
    }
    Err(format!(
        "{what}: {} and {} differ by {difference:.2e}, bounds {:.1e} and {:.1e}, allowed \
         {allowed:.1e}\n  {}",
        one.value * factor,
        two.value,
        one.error * factor,
        two.error,
        corners(other),
    ))
}

/// The first pairs of every family, computed once for all laws.
fn cases() -> &'static [(Family, Case)] {
    static CASES: OnceLock<Vec<(Family, Case)>> = OnceLock::new();
    CASES.get_or_init(|| {
        numbered(PAIRS)
            .map(|(family, number)| (family, Case::new(family, number)))
            .collect()
    })
}

fn numbered(count: u64) -> impl ParallelIterator<Item = (Family, u64)> {
    let families = Family::ALL.into_par_iter();
    families.flat_map(move |family| {
        (0..count)
            .into_par_iter()
            .map(move |number| (family, number))
    })
}

/// Lists what fails, wrong values before refusals.
fn assert_none(mut failures: Vec<String>) {
    let is_refusal = |failure: &String| failure.contains("refused");
    failures.sort_by_key(is_refusal);
    let refused = failures
        .iter()
        .filter(|failure| is_refusal(failure))
        .count();
    let shown: Vec<_> = failures.iter().take(8).cloned().collect();
    let wrong = failures.len() - refused;
    assert!(
        failures.is_empty(),
        "{wrong} wrong, {refused} refused:\n{}",
        shown.join("\n")
    );
}

/// Runs a law on the pairs of the default run.
fn assert_law(law: impl Fn(&Case) -> Result<(), String> + Sync) {
    let failures = cases().par_iter().filter_map(|(family, case)| {
        let failed = law(case).err()?;
        Some(format!("{family:?} {}: {failed}", case.number))
    });
    assert_none(failures.collect());
}

fn swapped(case: &Case) -> Result<(), String> {
    let [first, second] = case.pair.clone();
    compare("exchanged", case, &[second, first], 1.0, 0.0)
}

fn enlarged(case: &Case) -> Result<(), String> {
    let powers = [1, -1, 40, -40, 130, -130];
    let scale = f64::from(powers[(case.number % 6) as usize]).exp2();
    compare(
        "enlarged",
        case,
        &moved(&case.pair, |c| c * scale),
        scale * scale,
        0.0,
    )
}

/// One of the 48 symmetries of the cube, exactly; a mirror image has its corners in the other
/// order.
fn turned_by_quarters(case: &Case) -> Result<(), String> {
    let number = case.number;
    let order = [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [0, 2, 1],
        [1, 0, 2],
        [2, 1, 0],
    ];
    let chosen = (number % 6) as usize;
    let signs: [f64; 3] = std::array::from_fn(|k| {
        if ((number / 6) >> k) & 1 == 1 {
            -1.0
        } else {
            1.0
        }
    });
    let turn =
        |c: DVec3| DVec3::from_array(std::array::from_fn(|k| signs[k] * c[order[chosen][k]]));
    let is_mirror = (chosen >= 3) != (signs.iter().product::<f64>() < 0.0);
    let mut image = moved(&case.pair, turn);
    if is_mirror {
        image = image
            .map(|patch| Patch::try_new(patch.corners().iter().rev().copied().collect()).unwrap());
    }
    compare("turned by quarters", case, &image, 1.0, 0.0)
}

/// Moves a pair by a shift that every corner takes without rounding; other pairs are left out, and
/// counted by the caller.
fn shifted(case: &Case) -> Option<Result<(), String>> {
    let (pair, number) = (&case.pair, case.number);
    let short = |k: u64| ((number * 37 + k * 101) % 1024) as f64 / 128.0 - 4.0;
    let shift = DVec3::new(short(1), short(2), short(3));
    let lost = |a: f64, b: f64| {
        let sum = a + b;
        let from_b = sum - a;
        (a - (sum - from_b)) + (b - from_b)
    };
    let is_exact = |c: &DVec3| (0..3).all(|k| lost(c[k], shift[k]) == 0.0);
    let all = pair.iter().flat_map(Patch::corners).all(is_exact);
    all.then(|| compare("shifted", case, &moved(pair, |c| c + shift), 1.0, 0.0))
}

/// The rotation of a quaternion of whole numbers: every entry is one rounded quotient.
fn rotation(number: u64) -> DMat3 {
    let part = |k: u64| ((number * 7919 + k * 104_729) / 3 % 19) as f64 - 9.0;
    let [a, b, c, d] = [part(1).abs() + 1.0, part(2), part(3), part(4)];
    let norm = a * a + b * b + c * c + d * d;
    let rows = [
        [
            a * a + b * b - c * c - d * d,
            2.0 * (b * c - a * d),
            2.0 * (b * d + a * c),
        ],
        [
            2.0 * (b * c + a * d),
            a * a - b * b + c * c - d * d,
            2.0 * (c * d - a * b),
        ],
        [
            2.0 * (b * d - a * c),
            2.0 * (c * d + a * b),
            a * a - b * b - c * c + d * d,
        ],
    ];
    DMat3::from_cols_array_2d(&rows.map(|row| row.map(|x| x / norm))).transpose()
}

fn perimeter(patch: &Patch) -> f64 {
    let corners = patch.corners();
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a.distance(*b)).sum()
}

/// The change that corners moved by `delta` may cause, by the module's formula.
fn allowance(pair: &Pair, delta: f64) -> f64 {
    let [p, q] = pair;
    let radius = |patch: &Patch| {
        let distances = patch
            .corners()
            .iter()
            .map(|c| c.distance(patch.corners()[0]));
        distances.fold(0.0, f64::max)
    };
    let apart = p.corners()[0].distance(q.corners()[0]) - radius(p) - radius(q);
    let flux = |patch: &Patch| {
        if apart > 0.0 {
            (patch.area() / (PI * apart * apart)).min(1.0)
        } else {
            1.0
        }
    };
    // touching within δ counts: the moved outline may reach behind
    let is_cut = |patch: &Patch, other: &Patch| {
        let heights = other
            .corners()
            .iter()
            .map(|c| (*c - patch.corners()[0]).dot(patch.normal()));
        heights.fold(f64::INFINITY, f64::min) <= 2.0 * delta
    };
    let cut = if is_cut(p, q) || is_cut(q, p) {
        1.0 + 1.0 / p.normal().cross(q.normal()).length()
    } else {
        1.0
    };
    delta * (perimeter(p) * flux(q) + perimeter(q) * flux(p)) * cut
}

/// A coordinate is three products of entries and coordinates, each factor and operation rounded:
/// off by 2ε of the corner's length; all three by 2√3 ε.
fn turned(case: &Case) -> Result<(), String> {
    let (pair, number) = (&case.pair, case.number);
    let rotation = rotation(number);
    let lengths = pair.iter().flat_map(Patch::corners).map(|c| c.length());
    let delta = 4.0 * f64::EPSILON * lengths.fold(0.0, f64::max);
    let image = pair.each_ref().map(|patch| {
        Patch::try_new(patch.corners().iter().map(|c| rotation * *c).collect())
            .map_err(|error| error.to_string())
    });
    let [Ok(first), Ok(second)] = image else {
        // far from the origin, rounding leaves a polygon off its plane by more than is accepted;
        // never near it
        return if delta > 1e-13 {
            Ok(())
        } else {
            Err(format!("a turned patch is refused: {image:?}"))
        };
    };
    compare(
        "turned by any angle",
        case,
        &[first, second],
        1.0,
        allowance(pair, delta),
    )
}

/// The parts on both sides of a diagonal inside the polygon; of a triangle those beside a median,
/// whose foot is rounded by ε/2 of itself.
fn halves(patch: &Patch) -> ([Patch; 2], f64) {
    let corners = patch.corners();
    let n = corners.len();
    if n == 3 {
        let middle = 0.5 * corners[0] + 0.5 * corners[1];
        let [a, b, c] = [corners[0], corners[1], corners[2]];
        let parts = [vec![a, middle, c], vec![middle, b, c]];
        let delta = f64::EPSILON * middle.length();
        return (parts.map(|part| Patch::try_new(part).unwrap()), delta);
    }
    let opposite = match n {
        4 => 2,
        6 => 3,
        _ => 5,
    };
    for (from, to) in [(0, opposite), (n - 1, n - 1 - opposite)] {
        let (low, high) = (from.min(to), from.max(to));
        let inside = corners[low..=high].to_vec();
        let outside = [&corners[high..], &corners[..=low]].concat();
        if let [Ok(one), Ok(two)] = [inside, outside].map(Patch::try_new)
            && (one.area() + two.area() - patch.area()).abs() < 1e-9 * patch.area()
            && one.normal().dot(patch.normal()) > 0.0
            && two.normal().dot(patch.normal()) > 0.0
        {
            return ([one, two], 0.0);
        }
    }
    panic!("no diagonal of {corners:?} is inside");
}

fn cut_in_two(case: &Case) -> Result<(), String> {
    let pair = &case.pair;
    let ([one, two], delta) = halves(&pair[0]);
    let whole = case.answer.clone()?.exchange;
    let part = |part: Patch| {
        let pair = [part, pair[1].clone()];
        answer(&pair)
            .map(|answer| answer.exchange)
            .map_err(|error| format!("{error} of a part\n  {}", corners(&pair)))
    };
    let (one, two) = (part(one)?, part(two)?);
    let difference = (whole.value - one.value - two.value).abs();
    let allowed = allowance(pair, delta);
    let bound = whole.error + one.error + two.error + allowed;
    if difference <= bound {
        return Ok(());
    }
    Err(format!(
        "cut: {} + {} − {} = {difference:.2e}, bounds add to {bound:.1e}\n  {}",
        one.value,
        two.value,
        whole.value,
        corners(pair),
    ))
}

/// `0 < A F ≤ min(A_P, A_Q)`: every pair of the families exchanges something, but for what 256 bits
/// show to lie in one plane.
fn in_range(case: &Case) -> Result<(), String> {
    let (pair, answer) = (&case.pair, case.answer.clone()?);
    if answer.route == Route::Coplanar && Truth::of(pair).is_ok_and(|truth| truth.value() == 0.0) {
        return Ok(());
    }
    let (value, bound) = (answer.exchange.value, answer.exchange.error);
    let largest = pair[0].area().min(pair[1].area()) * (1.0 + 4.0 * f64::EPSILON);
    let is_sound = value > 0.0 && value - bound <= largest && bound >= 0.0 && bound < value;
    if is_sound && !answer.route.name().is_empty() {
        return Ok(());
    }
    Err(format!(
        "{value} with bound {bound:.1e} by {} where at most {largest} is possible\n  {}",
        answer.route.name(),
        corners(pair),
    ))
}

fn all_laws(case: &Case) -> Result<(), String> {
    in_range(case)?;
    swapped(case)?;
    enlarged(case)?;
    turned_by_quarters(case)?;
    shifted(case).unwrap_or(Ok(()))?;
    turned(case)?;
    cut_in_two(case)
}

/// Pairs of each family in the default run.
const PAIRS: u64 = 600;

#[test]
fn exchange_areas_are_positive_and_at_most_the_areas() {
    assert_law(in_range);
}

#[test]
fn exchanging_the_polygons_changes_nothing() {
    assert_law(swapped);
}

#[test]
fn powers_of_two_change_the_unit_only() {
    assert_law(enlarged);
}

#[test]
fn quarter_turns_and_mirrors_change_nothing() {
    assert_law(turned_by_quarters);
}

#[test]
fn exact_shifts_change_nothing() {
    let can_shift = |case: &Case| shifted(case).is_some();
    let exact = cases()
        .par_iter()
        .filter(|(_, case)| can_shift(case))
        .count();
    assert!(
        exact as u64 > 2 * PAIRS,
        "only {exact} pairs can be shifted exactly"
    );
    assert_law(|case| shifted(case).unwrap_or(Ok(())));
}

#[test]
fn turns_change_what_rounded_corners_may() {
    assert_law(turned);
}

#[test]
fn the_parts_of_a_polygon_add_up() {
    assert_law(cut_in_two);
}

/// All laws on as many pairs of each family as asked for.
#[test]
#[ignore = "takes an hour: \
            INFOSCENE_COUNT=100000 cargo test --release --test library all_laws -- --ignored"]
fn all_laws_hold_on_many_pairs() {
    let count = std::env::var("INFOSCENE_COUNT").map_or(100_000, |count| count.parse().unwrap());
    let failures = numbered(count).filter_map(|(family, number)| {
        let failed = all_laws(&Case::new(family, number)).err()?;
        Some(format!("{family:?} {number}: {failed}"))
    });
    assert_none(failures.collect());
}
