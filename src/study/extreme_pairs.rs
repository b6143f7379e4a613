//! What the routes to a form factor keep of stiff and extreme pairs.
//!
//! Aspect ratios, gaps, angles, distances, sizes, slivers and needles, each far beyond what scenes hold. Every route is asked for
//! all it can give (tolerance 0), the chooser for the default tolerance; each value is judged by the [`Truth`] of the
//! corners as they are in `f64`, computed in the run.
//!
//! Where rounding of the corners took digits before any route saw them, the row says how many: `input_error` is the relative
//! difference between the exact values of the pair as rounded and of the same pair before its move.

use super::polygon_pairs::facing;
use super::{Row, StudyError, Truth};
use crate::form_factor::{Answer, DEFAULT_TOLERANCE, Polygon, Route};
use crate::geometry::{GeometryError, Patch};
use crate::numeric::try_parallel_map;
use glam::DVec3;
use std::hint::black_box;
use std::time::Instant;

/// One measurement: a gain, or a pair by one route.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct StabilityRow {
    /// What was computed.
    pub case: String,
    /// How it was computed; `chosen` for what the chooser took.
    pub method: String,
    /// The exact value.
    pub value: f64,
    /// |computed − exact| / exact; none if the chooser refused.
    pub relative_error: Option<f64>,
    /// Time of one evaluation, in seconds.
    pub seconds: f64,
    /// The bound on the relative error, where the method has one.
    pub bound: Option<f64>,
    /// The route, of a pair.
    pub route: Option<&'static str>,
    /// How much the rounding of the corners changed the exact value, relative, where the pair was moved.
    pub input_error: Option<f64>,
    /// How far the exact value may be off, relative: an enclosure's width, or a reference's estimate.
    pub uncertainty: Option<f64>,
}

impl From<Row> for StabilityRow {
    fn from(row: Row) -> Self {
        Self {
            case: row.case,
            method: row.method,
            value: row.value,
            relative_error: Some(row.relative_error),
            seconds: row.seconds,
            bound: None,
            route: None,
            input_error: None,
            uncertainty: None,
        }
    }
}

/// The routes that serve any polygons.
pub const ROUTES: [Route; 4] = [
    Route::Contour,
    Route::PointToPolygon,
    Route::Kernel,
    Route::DoubleDouble,
];

/// What the exact value of a pair takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Effort {
    /// Well below a second.
    Little,
    /// Some seconds.
    Much,
}

/// An extreme pair, and what it was before a move rounded it.
struct Case {
    name: String,
    effort: Effort,
    pair: [Patch; 2],
    meant: Option<[Patch; 2]>,
}

/// The rows of the study, for each pair the chooser's and those of the routes that serve it; each evaluation is repeated
/// `repetitions` times for its time. `is_quick` leaves out the pairs whose exact value takes a second and more.
///
/// # Errors
/// [`StudyError`] if a pair has no exact value, which the tests exclude.
pub fn route_stability(repetitions: u32, is_quick: bool) -> Result<Vec<StabilityRow>, StudyError> {
    let mut rows = Vec::new();
    let mut cases = cases()?;
    cases.retain(|case| !is_quick || case.effort == Effort::Little);
    let exact = try_parallel_map(cases.len(), &|case| cases[case].judged())?;
    for (case, (truth, input_error)) in cases.iter().zip(exact) {
        let [first, second] = case.pair.each_ref().map(Polygon::new);
        let mut add = |method: &str, form: &dyn Fn() -> Option<Answer>| {
            let answer = form();
            if answer.is_none() && method != CHOSEN {
                return;
            }
            let start = Instant::now();
            for _ in 0..repetitions {
                black_box(form());
            }
            let seconds = start.elapsed().as_secs_f64() / f64::from(repetitions.max(1));
            let exact = truth.value();
            let exchange = answer.map(|answer| answer.exchange);
            rows.push(StabilityRow {
                case: case.name.clone(),
                method: method.to_owned(),
                value: exact,
                relative_error: exchange.map(|found| truth.relative_error_of(found.value)),
                seconds,
                bound: exchange.map(|found| found.error_bound / exact),
                route: answer.map(|answer| answer.route.name()),
                input_error,
                uncertainty: Some(truth.uncertainty()),
            });
        };
        add(CHOSEN, &|| {
            first.exchange_area(&second, DEFAULT_TOLERANCE).ok()
        });
        for route in ROUTES {
            add(route.name(), &|| {
                // nothing but a refusal comes by another route than asked
                let answer = first.exchange_area_by(route, &second, 0.0);
                answer.ok().filter(|answer| answer.route == route)
            });
        }
    }
    Ok(rows)
}

/// The method that is the chooser.
pub const CHOSEN: &str = "chosen";

impl Case {
    /// Its exact value, and how much rounding changed that.
    fn judged(&self) -> Result<(Truth, Option<f64>), StudyError> {
        let truth = self.truth(&self.pair)?;
        let input_error = match &self.meant {
            Some(meant) => Some(self.truth(meant)?.relative_difference(&truth)),
            None => None,
        };
        Ok((truth, input_error))
    }

    fn truth(&self, pair: &[Patch; 2]) -> Result<Truth, StudyError> {
        Truth::of(pair).map_err(|source| StudyError::FormFactor {
            case: self.name.clone(),
            source,
        })
    }
}

/// Patches with these corners, each turned to face the other.
fn pair(first: &[DVec3], second: &[DVec3]) -> Result<[Patch; 2], GeometryError> {
    Ok([
        Patch::try_new(facing(first, second))?,
        Patch::try_new(facing(second, first))?,
    ])
}

fn rectangle(origin: [f64; 3], u: DVec3, v: DVec3) -> Vec<DVec3> {
    let o = DVec3::from_array(origin);
    vec![o, o + u, o + u + v, o + v]
}

fn triangle(corners: [[f64; 3]; 3]) -> Vec<DVec3> {
    corners.map(DVec3::from_array).to_vec()
}

/// The second of two unit squares with a common edge at this angle, in degrees.
fn wing(degrees: f64) -> Vec<DVec3> {
    // the sine of the smaller angle, as 180° − 1e-6° has lost digits
    let acute = degrees.min(180.0 - degrees).to_radians();
    let cosine = acute.cos().copysign(90.0 - degrees);
    rectangle([0.0; 3], DVec3::Y, DVec3::new(cosine, 0.0, acute.sin()))
}

fn cases() -> Result<Vec<Case>, GeometryError> {
    use Effort::{Little, Much};
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let floor = |width: f64, depth: f64| rectangle([0.0; 3], width * x, depth * y);
    let above =
        |height: f64, width: f64, depth: f64| rectangle([0.0, 0.0, height], width * x, depth * y);
    let wall = |length: f64, height: f64| rectangle([0.0; 3], length * y, height * z);
    let square = floor(1.0, 1.0);
    let leaning = triangle([[0.2, 0.1, 0.7], [0.9, 0.3, 1.1], [0.4, 0.8, 0.5]]);
    let lying = triangle([[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [0.3, 0.9, 0.1]]);
    let diamond = |height: f64| -> Vec<DVec3> {
        // a square turned by 45° whose corners are exact
        [[0.5, -0.25], [1.25, 0.5], [0.5, 1.25], [-0.25, 0.5]]
            .map(|[x, y]| DVec3::new(x, y, height))
            .to_vec()
    };
    let scaled = |corners: &[DVec3], factor: f64| -> Vec<DVec3> {
        corners.iter().map(|c| *c * factor).collect()
    };
    let moved = |corners: &[DVec3], shift: DVec3| -> Vec<DVec3> {
        corners.iter().map(|c| *c + shift).collect()
    };
    let mut cases = Vec::new();
    let mut add = |effort: Effort,
                   name: &str,
                   first: &[DVec3],
                   second: &[DVec3]|
     -> Result<(), GeometryError> {
        cases.push(Case {
            name: name.to_owned(),
            effort,
            pair: pair(first, second)?,
            meant: None,
        });
        Ok(())
    };
    // aspect ratios
    add(
        Little,
        "facing, 1 × 1e9, 1 apart",
        &floor(1.0, 1e9),
        &above(1.0, 1.0, 1e9),
    )?;
    add(
        Little,
        "facing, 1 × 1e-9, 1 apart",
        &floor(1.0, 1e-9),
        &above(1.0, 1.0, 1e-9),
    )?;
    add(
        Little,
        "facing, 1 × 1e-9 and 1e9 × 1",
        &floor(1.0, 1e-9),
        &above(1.0, 1e9, 1.0),
    )?;
    add(
        Little,
        "turned by 45°, 1 × 1e-9 and a square",
        &floor(1.0, 1e-9),
        &diamond(1.0),
    )?;
    add(
        Little,
        "common edge, depths 1 and 1e-9",
        &square,
        &wall(1.0, 1e-9),
    )?;
    add(
        Little,
        "common edge, depths 1 and 1e9",
        &square,
        &wall(1.0, 1e9),
    )?;
    add(
        Little,
        "common edge, depths 1e-9 and 1e9",
        &floor(1e-9, 1.0),
        &wall(1.0, 1e9),
    )?;
    add(
        Little,
        "common edge 1e9 long, depths 1",
        &floor(1.0, 1e9),
        &wall(1e9, 1.0),
    )?;
    // gaps
    add(
        Little,
        "facing, 1e-12 apart",
        &square,
        &above(1e-12, 1.0, 1.0),
    )?;
    add(
        Much,
        "facing, turned by 45°, 1e-12 apart",
        &square,
        &diamond(1e-12),
    )?;
    let beside = rectangle([1e-12, 0.0, 0.0], x, y);
    add(Much, "perpendicular, gap 1e-12", &beside, &wall(1.0, 1.0))?;
    let gap = moved(&wing(60.0), -1e-12 * x);
    add(Much, "at 60°, gap 1e-12", &square, &gap)?;
    let apart = triangle([[0.0, 0.0, 1e-12], [0.7, -0.4, 0.9], [-0.5, 0.3, 0.8]]);
    add(Much, "triangles, corners 1e-12 apart", &lying, &apart)?;
    // angles
    for degrees in [
        1e-6,
        1e-3,
        1.0,
        60.0,
        120.0,
        179.0,
        180.0 - 1e-3,
        180.0 - 1e-6,
    ] {
        let name = if degrees > 179.0 {
            format!("common edge, 180° − {:.0e}°", 180.0 - degrees)
        } else {
            format!("common edge, {degrees}°")
        };
        add(Much, &name, &square, &wing(degrees))?;
    }
    add(Little, "common edge, 90°", &square, &wall(1.0, 1.0))?;
    // distances
    add(Little, "facing, 1e6 apart", &square, &above(1e6, 1.0, 1.0))?;
    let far = DVec3::new(6e5, -3e5, 7e5);
    add(
        Little,
        "triangles, 1e6 apart",
        &lying,
        &moved(&leaning, far),
    )?;
    let grazing = moved(&wall(1.0, 1.0), DVec3::new(1e6, 3e5, 0.0));
    add(Little, "perpendicular, 1e6 apart", &square, &grazing)?;
    // sizes
    let common = wall(1.0, 1.0);
    let opposite = above(1.0, 1.0, 1.0);
    for factor in [1e-150, 1e150] {
        for (name, first, second) in [
            ("facing", &square, &opposite),
            ("common edge", &square, &common),
            ("triangles", &lying, &leaning),
        ] {
            // turned before, as products of such coordinates leave the range
            let turned = [facing(first, second), facing(second, first)];
            let [first, second] = turned.map(|corners| scaled(&corners, factor));
            add(Little, &format!("{name}, size {factor:e}"), &first, &second)?;
        }
    }
    let tiny = moved(&scaled(&leaning, 1e-9), 0.25 * (x + y + 2.0 * z));
    add(Little, "triangles, sizes 1 and 1e-9", &lying, &tiny)?;
    // slivers and needles
    let sliver = triangle([[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-9, 0.0]]);
    let upright = triangle([[0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.0, 1e-9]]);
    let steep = triangle([[0.0; 3], [1.0, 0.0, 0.0], [0.3, 0.2, 0.9]]);
    add(
        Much,
        "slivers 1e-9 thick, common edge, 90°",
        &sliver,
        &upright,
    )?;
    add(Much, "sliver 1e-9 thick, common edge", &sliver, &steep)?;
    let needle = triangle([[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1e-9, 0.0]]);
    let facing_needle = triangle([[0.0; 3], [0.2, 1.0, 0.4], [-0.3, 0.1, 0.8]]);
    add(
        Much,
        "needle 1e-9 wide, common corner",
        &needle,
        &facing_needle,
    )?;
    add(Little, "needle 1e-9 wide", &needle, &leaning)?;
    let other_needle = triangle([[0.5, -0.5, 0.5], [0.5, 0.5, 0.5], [0.5, 0.5, 0.500_000_001]]);
    add(Little, "needles 1e-9 wide, crossed", &needle, &other_needle)?;
    // horizons
    let dipping = triangle([[0.2, 0.3, -0.5], [0.9, 0.1, 1e-9], [0.4, 0.8, -0.2]]);
    add(Much, "1e-9 above the horizon", &square, &dipping)?;
    // moved: rounding takes digits before any route sees the pair
    for (effort, name, pair_of, shift) in [
        (Little, "triangles, moved by 1e9", [&lying, &leaning], 1e9),
        (Little, "triangles, moved by 1e3", [&lying, &leaning], 1e3),
        (
            Much,
            "slivers 1e-9 thick, moved by 1",
            [&sliver, &steep],
            1.0,
        ),
    ] {
        let [first, second] = pair_of;
        let shift = shift * DVec3::new(1.0, 1.0, -1.0) / 3.0;
        cases.push(Case {
            name: name.to_owned(),
            effort,
            pair: pair(&moved(first, shift), &moved(second, shift))?,
            meant: Some(pair(first, second)?),
        });
    }
    Ok(cases)
}
