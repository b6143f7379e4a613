//! The cost of certainty: width of an enclosure against its run time.
//!
//! Each quantity is the same source in every number type: `f64`; intervals with `f64` ends (53
//! bits); intervals with ends of 128, 256 and 512 bits. An enclosure's relative error is its width
//! over its value, a bound; that of `f64` is the distance to an enclosure of 640 bits. Optima are
//! searched with 53 bits and tightened at the precision named, proof of the global maximum
//! included.

use super::Row;
use super::run_time::median_time;
use crate::discretize::{
    BoxGrid, DiscretizeError, GradientCut, PatchSplit, RectangleSplit, UNIT_CUBE,
};
use crate::form_factor::RectanglePair;
use crate::geometry::SplitAxis;
use crate::numeric::{Interval, Scalar};
use crate::scene::Scene;
use std::time::Duration;

/// Bits of the enclosures measured, besides those of `f64`.
const PRECISIONS: [u32; 3] = [128, 256, 512];
/// Bits of the enclosure that judges `f64`.
const JUDGE: u32 = 640;

/// A quantity in closed form, in every number type.
trait Quantity {
    fn at<S: Scalar>(&self, like: &S) -> Result<S, DiscretizeError>;
}

/// `A F` of two unit squares with a common edge.
struct SquaresExchange(RectanglePair);

impl Quantity for SquaresExchange {
    fn at<S: Scalar>(&self, like: &S) -> Result<S, DiscretizeError> {
        Ok(self.0.lifted(like).exchange_value()?)
    }
}

/// The gain of two squares cut in the middle.
struct MiddleGain(RectangleSplit);

impl Quantity for MiddleGain {
    fn at<S: Scalar>(&self, like: &S) -> Result<S, DiscretizeError> {
        self.0.lifted(like).gain(&[like.constant(0.5)])
    }
}

/// Mutual information of the cube with a regular grid.
struct RegularGrid(u32);

impl Quantity for RegularGrid {
    fn at<S: Scalar>(&self, like: &S) -> Result<S, DiscretizeError> {
        BoxGrid::regular_like(UNIT_CUBE, self.0, like)?.mutual_information()
    }
}

/// The rows of the study; `is_quick` times each evaluation once only.
///
/// # Errors
/// [`DiscretizeError`] if a quantity cannot be computed, which the tests exclude.
pub fn work_precision(is_quick: bool) -> Result<Vec<Row>, DiscretizeError> {
    let least = if is_quick {
        Duration::ZERO
    } else {
        Duration::from_millis(200)
    };
    let scene = Scene::built_in("two-squares")?;
    let pair = RectanglePair::try_new(&scene.rectangle(0)?, &scene.rectangle(1)?)?;
    let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U)?;
    let cut = GradientCut::try_new(2.0, 1.0)?;
    let mut rows = Vec::new();
    value_rows(
        &mut rows,
        "form factor of two squares",
        &SquaresExchange(pair),
        least,
    )?;
    value_rows(
        &mut rows,
        "gain in the middle, fig. 2",
        &MiddleGain(split.rectangles()?.clone()),
        least,
    )?;
    value_rows(
        &mut rows,
        "regular 3 × 3 grid, fig. 4",
        &RegularGrid(3),
        least,
    )?;
    optimum_rows(
        &mut rows,
        "best cut, fig. 2",
        &|| Ok(split.best(2)?.positions[0]),
        &|bits| Ok(split.certified_best(bits)?.position),
        least,
    )?;
    optimum_rows(
        &mut rows,
        "best cut, §4.2, n = 2",
        &|| Ok(cut.mutual_information_cut()?.position),
        &|bits| Ok(cut.certified_mutual_information_cut(bits)?.position),
        least,
    )?;
    Ok(rows)
}

fn value_rows(
    rows: &mut Vec<Row>,
    case: &str,
    quantity: &impl Quantity,
    least: Duration,
) -> Result<(), DiscretizeError> {
    let exact = quantity.at(&Interval::precise(1.0, JUDGE))?;
    let (plain, seconds) = timed(least, || quantity.at(&1.0))?;
    rows.push(plain_row(case, plain, &exact, seconds));
    let (coarse, seconds) = timed(least, || quantity.at(&Interval::point(1.0f64)))?;
    rows.push(enclosed_row(case, 53, coarse.width(), &exact, seconds));
    for bits in PRECISIONS {
        let like = Interval::precise(1.0, bits);
        let (enclosure, seconds) = timed(least, || quantity.at(&like))?;
        rows.push(enclosed_row(case, bits, enclosure.width(), &exact, seconds));
    }
    Ok(())
}

type Plain<'f> = dyn Fn() -> Result<f64, DiscretizeError> + 'f;
type Certified<'f> = dyn Fn(u32) -> Result<Interval, DiscretizeError> + 'f;

fn optimum_rows(
    rows: &mut Vec<Row>,
    case: &str,
    plain: &Plain<'_>,
    certified: &Certified<'_>,
    least: Duration,
) -> Result<(), DiscretizeError> {
    let exact = certified(JUDGE)?;
    let (value, seconds) = timed(least, plain)?;
    rows.push(plain_row(case, value, &exact, seconds));
    for bits in [f64::MANTISSA_DIGITS].into_iter().chain(PRECISIONS) {
        let (enclosure, seconds) = timed(least, || certified(bits))?;
        rows.push(enclosed_row(case, bits, enclosure.width(), &exact, seconds));
    }
    Ok(())
}

fn plain_row(case: &str, value: f64, exact: &Interval, seconds: f64) -> Row {
    let error = ((exact.constant(value) - exact) / exact).abs();
    Row {
        case: case.to_owned(),
        method: "f64".to_owned(),
        value: exact.to_f64(),
        relative_error: error.to_doubles().1,
        seconds,
    }
}

fn enclosed_row(case: &str, bits: u32, width: f64, exact: &Interval, seconds: f64) -> Row {
    let value = exact.to_f64();
    Row {
        case: case.to_owned(),
        method: format!("enclosure, {bits} bits"),
        value,
        relative_error: width / value.abs(),
        seconds,
    }
}

/// The result, and the time of one evaluation.
fn timed<T>(
    least: Duration,
    evaluate: impl Fn() -> Result<T, DiscretizeError>,
) -> Result<(T, f64), DiscretizeError> {
    // constants are computed once per thread and precision
    evaluate()?;
    let (result, seconds) = median_time(least, evaluate);
    Ok((result?, seconds))
}
