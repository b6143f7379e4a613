//! Digits that solvers keep of radiosities in stiff scenes.
//!
//! Reflectances up to 1 − 1e-12, two rooms that hardly see each other, emission over thirty orders
//! of magnitude. Each method is given the same joint matrix in `f64`, and judged by the
//! [enclosure](exact_radiosities) of its exact solution; the error is that of the worst patch,
//! relative to its own radiosity.
//!
//! * `chosen`: [`RadiositySystem::radiosity`];
//! * `elimination`: LU with pivots of `I − R F`, the usual way for few patches;
//! * `bounces`: `B ← E + R F B` until no patch changes by 1e-14 of itself, the usual way for many,
//!   10,000 times at most.

use crate::numeric::{Interval, Scalar, real};
use crate::scene::Scene;
use crate::study::StudyError;
use crate::study::form_factors::extreme_pairs::{CHOSEN, StabilityRow};
use crate::study::run_time::mean_time;
use crate::transport::RadiositySystem;
use nalgebra::{DMatrix, DVector};

/// Bits of the enclosures that judge.
const JUDGE: u32 = 256;

/// A closed scene: what its patches exchange, reflect and emit.
#[derive(Debug, Clone)]
pub struct StiffScene {
    /// The property that makes it stiff.
    pub name: String,
    /// Exchange areas, symmetric.
    pub exchange: DMatrix<f64>,
    /// Reflectances.
    pub reflectances: Vec<f64>,
    /// Emittances.
    pub emittances: Vec<f64>,
}

/// The scenes of the study.
///
/// # Errors
/// None that is known: the cubes are built in.
pub fn stiff_scenes() -> Result<Vec<StiffScene>, StudyError> {
    let cube = Scene::built_in("cube:2")?.exchange_areas()?.into_values();
    let mut scenes = reflecting_cubes(&cube);
    scenes.extend(coupled_rooms(&cube));
    scenes.extend(separate_rooms(&cube));
    scenes.extend(uneven_cubes(&cube));
    Ok(scenes)
}

/// Numbers around 1, a little different from patch to patch.
fn uneven(patch: usize) -> f64 {
    1.0 + real(patch * 7 % 11) / 8.0
}

/// Cubes that absorb less and less.
fn reflecting_cubes(cube: &DMatrix<f64>) -> Vec<StiffScene> {
    let patches = 0..cube.nrows();
    let scene = |exponent: i32| {
        let absorbed = 10f64.powi(-exponent);
        let reflectance = |patch| 1.0 - absorbed * uneven(patch) / 3.0;
        StiffScene {
            name: format!("cube, one patch emits, R = 1 − 1e-{exponent} and less"),
            exchange: cube.clone(),
            reflectances: patches.clone().map(reflectance).collect(),
            emittances: patches.clone().map(|patch| f64::from(patch == 3)).collect(),
        }
    };
    [1, 3, 6, 9, 12, 15].map(scene).to_vec()
}

/// Two cubes whose patches exchange `between` with those of the other.
fn two_rooms(cube: &DMatrix<f64>, between: impl Fn(usize, usize) -> f64) -> DMatrix<f64> {
    let count = cube.nrows();
    DMatrix::from_fn(2 * count, 2 * count, |i, j| {
        let (own, other) = (i % count, j % count);
        if (i < count) == (j < count) {
            cube[(own, other)]
        } else {
            between(own, other)
        }
    })
}

fn reflectance_in_words(mirror: f64) -> &'static str {
    if mirror > 0.9 { "1 − 1e-9" } else { "0.5" }
}

/// Two rooms, every patch of one sees every patch of the other a little.
fn coupled_rooms(cube: &DMatrix<f64>) -> Vec<StiffScene> {
    let patches = 0..2 * cube.nrows();
    let scene = |(exponent, mirror): (i32, f64)| {
        let coupling = 10f64.powi(-exponent);
        let between = |i, j| coupling * f64::sqrt(uneven(i) * uneven(j)) / 24.0;
        let reflectance = |patch| mirror * (1.0 - 1e-10 * uneven(patch));
        let emittance = |patch| f64::from(patch == 3) * 0.7;
        StiffScene {
            name: format!(
                "two rooms, form factors of 1e-{exponent} between them, R = {}",
                reflectance_in_words(mirror)
            ),
            exchange: two_rooms(cube, between),
            reflectances: patches.clone().map(reflectance).collect(),
            emittances: patches.clone().map(emittance).collect(),
        }
    };
    [(12, 0.5), (12, 1.0 - 1e-9), (100, 0.5)]
        .map(scene)
        .to_vec()
}

/// Two rooms, no light from one to the other.
fn separate_rooms(cube: &DMatrix<f64>) -> Vec<StiffScene> {
    let patches = 0..2 * cube.nrows();
    let emittance = |patch: usize| match patch {
        3 => 1.0,
        40 => 1e-30,
        _ => 0.0,
    };
    let scene = |mirror: f64| StiffScene {
        name: format!(
            "two closed rooms, lights of 1 and 1e-30, R = {}",
            reflectance_in_words(mirror)
        ),
        exchange: two_rooms(cube, |_, _| 0.0),
        reflectances: vec![mirror; 2 * cube.nrows()],
        emittances: patches.clone().map(emittance).collect(),
    };
    [0.5, 1.0 - 1e-9].map(scene).to_vec()
}

/// Cubes whose patches differ by many orders of magnitude.
fn uneven_cubes(cube: &DMatrix<f64>) -> [StiffScene; 2] {
    let patches = 0..cube.nrows();
    let spans = |patch: usize| 10f64.powi(-30 * i32::try_from(patch).unwrap_or(0) / 23);
    let reflectance = |patch: usize| 0.99 * real(patch * 5 % 24) / 23.0;
    let nearly_black = |patch: usize| f64::from(patch == 7) * 1e-100;
    [
        StiffScene {
            name: "cube, emittances from 1e-30 to 1, R from 0 to 0.99".to_owned(),
            exchange: cube.clone(),
            reflectances: patches.clone().map(reflectance).collect(),
            emittances: patches.clone().map(spans).collect(),
        },
        StiffScene {
            name: "cube, black but for one patch, R = 1e-100 there".to_owned(),
            exchange: cube.clone(),
            reflectances: patches.clone().map(nearly_black).collect(),
            emittances: patches.map(|patch| f64::from(patch == 20)).collect(),
        },
    ]
}

/// The radiosities of a closed scene, enclosed: elimination without pivots of
/// `A_i B_i − R_i Σ_j J_ij B_j = A_i E_i` with ends of `bits` bits.
///
/// **Returns** `None` if a pivot may be 0 at this precision.
#[must_use]
pub fn exact_radiosities(scene: &StiffScene, bits: u32) -> Option<Vec<Interval>> {
    let number = |value: f64| Interval::precise(value, bits);
    let n = scene.reflectances.len();
    let mut rows: Vec<Vec<Interval>> = (0..n)
        .map(|i| {
            let entries = scene.exchange.row(i);
            let area = entries
                .iter()
                .fold(number(0.0), |sum, entry| sum + &number(*entry));
            let reflectance = number(scene.reflectances[i]);
            let mut row: Vec<Interval> = entries
                .iter()
                .map(|entry| -(number(*entry) * &reflectance))
                .collect();
            row[i] = row[i].clone() + &area;
            row.push(area * &number(scene.emittances[i]));
            row
        })
        .collect();
    for k in 0..n {
        let pivot = rows[k][k].clone();
        for i in k + 1..n {
            let (above, below) = rows.split_at_mut(i);
            let factor = below[0][k].clone() / &pivot;
            if !factor.is_bounded() {
                return None;
            }
            for j in k..=n {
                let share = factor.clone() * &above[k][j];
                below[0][j] = below[0][j].clone() - &share;
            }
        }
    }
    let mut values: Vec<Interval> = Vec::with_capacity(n);
    for i in (0..n).rev() {
        let mut rest = rows[i][n].clone();
        for (j, value) in (i + 1..n).rev().zip(&values) {
            rest = rest - &(rows[i][j].clone() * value);
        }
        values.push(rest / &rows[i][i]);
    }
    values.reverse();
    Some(values)
}

/// The largest relative error of radiosities among the patches.
#[must_use]
pub fn worst_error(found: &[f64], exact: &[Interval]) -> f64 {
    let errors = found.iter().zip(exact).map(|(found, exact)| {
        let apart = (exact.constant(*found) - exact).abs().to_f64();
        let size = exact.abs().to_f64();
        if size > 0.0 { apart / size } else { apart }
    });
    errors.fold(
        0.0,
        |worst, error| if error <= worst { worst } else { error },
    )
}

/// The rows of the study; each solution is repeated `repetitions` times for its time.
///
/// # Errors
/// [`StudyError`] if a scene is refused, which the tests exclude.
pub fn transport_stability(repetitions: u32) -> Result<Vec<StabilityRow>, StudyError> {
    let mut rows = Vec::new();
    for scene in stiff_scenes()? {
        let Some(exact) = exact_radiosities(&scene, JUDGE) else {
            continue;
        };
        let lit = exact.iter().map(Scalar::to_f64);
        let dimmest = lit.filter(|value| *value > 0.0).fold(f64::MAX, f64::min);
        let lit = exact.iter().filter(|value| value.to_f64() > 0.0);
        let uncertainty = lit.map(|value| value.width() / value.to_f64());
        let uncertainty = uncertainty.fold(0.0, f64::max);
        let room = RadiositySystem::of_matrix(&scene.exchange, scene.reflectances.clone())?;
        let bound = room.radiosity(&scene.emittances)?.relative_error;
        let mut add = |method: &str, bound: Option<f64>, form: &dyn Fn() -> Vec<f64>| {
            let (found, seconds) = mean_time(repetitions, form);
            let relative_error = worst_error(&found, &exact);
            rows.push(StabilityRow {
                case: scene.name.clone(),
                method: method.to_owned(),
                value: dimmest,
                relative_error: relative_error.is_finite().then_some(relative_error),
                seconds,
                bound,
                route: (method == CHOSEN).then_some("conjugate-gradients"),
                input_error: None,
                uncertainty: Some(uncertainty),
                unoccluded: None,
            });
        };
        add(CHOSEN, Some(bound), &|| {
            room.radiosity(&scene.emittances)
                .map(|found| found.values)
                .unwrap_or_default()
        });
        add("elimination", None, &|| elimination(&scene));
        add("bounces", None, &|| bounces(&scene));
    }
    Ok(rows)
}

/// `R F`.
fn reflected(scene: &StiffScene) -> DMatrix<f64> {
    let mut matrix = scene.exchange.clone();
    for (mut row, reflectance) in matrix.row_iter_mut().zip(&scene.reflectances) {
        let area: f64 = row.iter().sum();
        row *= reflectance / area;
    }
    matrix
}

fn elimination(scene: &StiffScene) -> Vec<f64> {
    let n = scene.reflectances.len();
    let matrix = DMatrix::identity(n, n) - reflected(scene);
    let right = DVector::from_column_slice(&scene.emittances);
    let found = matrix.lu().solve(&right);
    found.map_or_else(|| vec![f64::NAN; n], |found| found.as_slice().to_vec())
}

fn bounces(scene: &StiffScene) -> Vec<f64> {
    let matrix = reflected(scene);
    let sources = DVector::from_column_slice(&scene.emittances);
    let mut values = sources.clone();
    for _ in 0..10_000 {
        let next = &sources + &matrix * &values;
        let change = next.iter().zip(&values).map(|(a, b)| (a - b).abs() / a);
        let is_still = change.fold(0.0, f64::max) < 1e-14;
        values = next;
        if is_still {
            break;
        }
    }
    values.as_slice().to_vec()
}
