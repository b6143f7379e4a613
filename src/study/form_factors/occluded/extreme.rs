//! Extreme pairs past others, each with its exact value from a symmetry.
//!
//! A half-plane whose edge runs over the middle line of two squares hides exactly half, at any
//! height and slope, as long as it passes between them: the mirror image of a line that it hides is
//! one that it leaves. A wall in the plane of symmetry leaves each half what is beside it. Plates
//! half-way are [known](crate::reference::past_halfway_plates).

use super::OccludedPair;
use super::halfway::{Plate, UNIT, level, pair};
use crate::form_factor::FormFactorError;
use crate::geometry::{GeometryError, Patch};
use crate::reference::Truth;
use crate::study::StudyError;
use glam::DVec3;

/// An extreme pair with what it exchanges, past what is in the way and without it.
#[derive(Debug)]
pub(super) struct ExtremeCase {
    pub(super) name: &'static str,
    pub(super) pair: OccludedPair,
    pub(super) truth: Truth,
    pub(super) unoccluded: Truth,
}

impl ExtremeCase {
    /// The pair, some multiple of two polygons' exchange, and what it is without blockers.
    fn of(
        name: &'static str,
        pair: OccludedPair,
        truth: Result<Truth, FormFactorError>,
    ) -> Result<Self, StudyError> {
        let refused = |source| StudyError::FormFactor {
            case: name.to_owned(),
            source,
        };
        let unoccluded = Truth::of(&pair.pair).map_err(refused)?;
        Ok(Self {
            truth: truth.map_err(refused)?,
            unoccluded,
            name,
            pair,
        })
    }
}

/// The cases of the study; `is_quick` leaves out those with hundreds of blockers.
pub(super) fn cases(is_quick: bool) -> Result<Vec<ExtremeCase>, StudyError> {
    let mut cases = halved()?;
    cases.extend(walls()?);
    cases.extend(plates()?);
    cases.push(sized("64 plates half-way", 1.0, 1.0, &chequers(8))?);
    if !is_quick {
        cases.push(sized("256 plates half-way", 1.0, 1.0, &chequers(16))?);
    }
    Ok(cases)
}

/// 2⁻³⁰, some 1e-9.
const BILLIONTH: f64 = 1.0 / 1_073_741_824.0;
/// 2⁻⁴⁰, some 1e-12.
const TRILLIONTH: f64 = BILLIONTH / 1024.0;
/// 2⁻²⁰, some 1e-6.
const MILLIONTH: f64 = 1024.0 * BILLIONTH;

/// Squares half hidden by half-planes of some heights and slopes.
fn halved() -> Result<Vec<ExtremeCase>, StudyError> {
    // from the middle line at one height to x = far at another
    let screen = |middle: f64, far: f64, there: f64| {
        let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        Patch::try_new(vec![
            at(0.5, -4.0, middle),
            at(far, -4.0, there),
            at(far, 5.0, there),
            at(0.5, 5.0, middle),
        ])
    };
    let tilted = 0.5 + 3.5 * BILLIONTH;
    let screens = [
        (
            "half-plane 1e-12 above",
            1.0,
            screen(TRILLIONTH, 4.0, TRILLIONTH)?,
        ),
        (
            "half-plane 1e-12 below",
            1.0,
            screen(1.0 - TRILLIONTH, 4.0, 1.0 - TRILLIONTH)?,
        ),
        (
            "half-plane with a slope of 1e-9",
            1.0,
            screen(0.5, 4.0, tilted)?,
        ),
        (
            "screen to the far edge, grazing",
            1.0,
            screen(0.5, 1.0, 1.0)?,
        ),
        (
            "screen to the near edge, grazing",
            1.0,
            screen(0.5, 1.0, 0.0)?,
        ),
        ("half-plane between squares 1e-6 apart", MILLIONTH, {
            screen(0.5 * MILLIONTH, 4.0, 0.5 * MILLIONTH)?
        }),
        ("half-plane between squares 1e6 apart", 1.0 / MILLIONTH, {
            screen(0.5 / MILLIONTH, 4.0, 0.5 / MILLIONTH)?
        }),
    ];
    let half = |(name, height, screen): (&'static str, f64, Patch)| {
        let pair = [level(UNIT, 0.0, true)?, level(UNIT, height, false)?];
        let truth = Truth::of(&pair).map(|whole| whole.times(0.5));
        let blockers = vec![screen];
        ExtremeCase::of(name, OccludedPair { pair, blockers }, truth)
    };
    let mut cases = screens
        .into_iter()
        .map(half)
        .collect::<Result<Vec<_>, _>>()?;
    let strip = [[0.0, 1.0], [0.0, BILLIONTH]];
    let pair = [level(strip, 0.0, true)?, level(strip, 1.0, false)?];
    let truth = Truth::of(&pair).map(|whole| whole.times(0.5));
    let blockers = vec![screen(0.25, 4.0, 0.25)?];
    let name = "half-plane between strips 1e-9 wide";
    cases.push(ExtremeCase::of(
        name,
        OccludedPair { pair, blockers },
        truth,
    )?);
    Ok(cases)
}

/// Walls in a plane of symmetry.
fn walls() -> Result<Vec<ExtremeCase>, StudyError> {
    let upright = |y: [f64; 2]| {
        let corners = [[y[0], 0.0], [y[1], 0.0], [y[1], 1.0], [y[0], 1.0]];
        Patch::try_new(corners.map(|[y, z]| DVec3::new(0.0, y, z)).to_vec())
    };
    let ceiling = |y: [f64; 2]| level([[0.0, 1.0], y], 1.0, false);
    Ok(vec![
        beside_a_wall("wall from floor to ceiling", ceiling)?,
        beside_a_wall("wall in a corner, on both sides of it", upright)?,
    ])
}

/// A floor and another square with a wall between their halves, each of which sees its own.
fn beside_a_wall(
    name: &'static str,
    other: impl Fn([f64; 2]) -> Result<Patch, GeometryError>,
) -> Result<ExtremeCase, StudyError> {
    let floor = |y: [f64; 2]| level([[0.0, 1.0], y], 0.0, true);
    let half = [floor([0.0, 0.5])?, other([0.0, 0.5])?];
    let pair = [floor([0.0, 1.0])?, other([0.0, 1.0])?];
    let truth = Truth::of(&half).map(|half| half.times(2.0));
    let wall = [[-1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [-1.0, 1.0]];
    let wall = wall.map(|[x, z]| DVec3::new(x, 0.5, z));
    let blockers = vec![Patch::try_new(wall.to_vec())?];
    ExtremeCase::of(name, OccludedPair { pair, blockers }, truth)
}

/// Plates half-way, narrow or with narrow openings.
fn plates() -> Result<Vec<ExtremeCase>, StudyError> {
    let thin = [0.5 - 0.5 * BILLIONTH, 0.5 + 0.5 * BILLIONTH];
    let small = [0.5 - 0.5 * MILLIONTH, 0.5 + 0.5 * MILLIONTH];
    let wide = [-1.0, 2.0];
    let beside = |[low, high]: [f64; 2]| [[-1.0, low], [high, 2.0]];
    let slit = |gap| beside(gap).map(|x| [x, wide]);
    let window = |gap: [f64; 2]| [slit(gap), beside(gap).map(|y| [gap, y])].concat();
    // 2⁻¹⁵: a window of a billionth of the whole
    let opening = [0.5 - 1.0 / 65536.0, 0.5 + 1.0 / 65536.0];
    let cases: [(&'static str, f64, f64, Vec<Plate>); 8] = [
        ("strip 1e-9 wide", 1.0, 1.0, vec![[thin, wide]]),
        ("plate 1e-6 × 1e-6", 1.0, 1.0, vec![[small, small]]),
        ("plate 1e-9 × 1e-9", 1.0, 1.0, vec![[thin, thin]]),
        ("slit 1e-6 wide", 1.0, 1.0, slit(small).to_vec()),
        ("slit 1e-9 wide", 1.0, 1.0, slit(thin).to_vec()),
        ("window of 1e-9 of the whole", 1.0, 1.0, window(opening)),
        (
            "plate, size 1e-30",
            1.0,
            (-100f64).exp2(),
            vec![[[0.25, 0.625], [0.125, 0.75]]],
        ),
        (
            "plate, squares 1e6 apart",
            1.0 / MILLIONTH,
            1.0,
            vec![[[0.25, 0.625], [0.125, 0.75]]],
        ),
    ];
    let of =
        |(name, height, size, plates): (_, _, _, Vec<Plate>)| sized(name, height, size, &plates);
    cases.into_iter().map(of).collect()
}

/// `side` rows of `side` plates, as far apart as they are wide.
fn chequers(side: u32) -> Vec<Plate> {
    let span = |k: u32| [0.25, 0.75].map(|part| (f64::from(k) + part) / f64::from(side));
    let all = (0..side).flat_map(|i| (0..side).map(move |j| [i, j]));
    all.map(|place| place.map(span)).collect()
}

/// Plates half-way between two unit squares, all scaled by a power of two.
fn sized(
    name: &'static str,
    height: f64,
    size: f64,
    plates: &[Plate],
) -> Result<ExtremeCase, StudyError> {
    let (pair, truth) = pair(name, height, plates)?;
    let scaled = |patch: &Patch| {
        let corners = patch.corners().iter().map(|corner| *corner * size);
        Patch::try_new(corners.collect())
    };
    let [first, second] = pair.pair.each_ref().map(scaled);
    let blockers: Result<Vec<Patch>, GeometryError> = pair.blockers.iter().map(scaled).collect();
    let pair = OccludedPair {
        pair: [first?, second?],
        blockers: blockers?,
    };
    ExtremeCase::of(name, pair, Ok(truth.times(size * size)))
}
