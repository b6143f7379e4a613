//! The run time of an evaluation, by repeating it.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// The result, and the mean time in seconds of so many evaluations.
pub(super) fn mean_time<T>(repetitions: u32, evaluate: impl Fn() -> T) -> (T, f64) {
    let start = Instant::now();
    let mut result = black_box(evaluate());
    for _ in 1..repetitions {
        result = black_box(evaluate());
    }
    let seconds = start.elapsed().as_secs_f64() / f64::from(repetitions.max(1));
    (result, seconds)
}

/// Evaluations whose median is a time, at least.
const REPETITIONS: usize = 5;

/// The result, and the median time in seconds of as many evaluations as fill a time: of one that
/// fills it alone, its own.
pub(super) fn median_time<T>(least: Duration, evaluate: impl Fn() -> T) -> (T, f64) {
    let once = || {
        let start = Instant::now();
        let result = black_box(evaluate());
        (result, start.elapsed())
    };
    let (mut result, first) = once();
    if least.is_zero() || first > least {
        return (result, first.as_secs_f64());
    }
    // below some µs the clock itself counts: many at a time
    let batch = (20_000 / first.as_nanos().max(20)).clamp(1, 1000);
    let mut times = Vec::new();
    let start = Instant::now();
    while times.len() < REPETITIONS || start.elapsed() < least {
        let begin = Instant::now();
        for _ in 0..batch {
            result = black_box(evaluate());
        }
        #[expect(clippy::cast_precision_loss, reason = "up to 1000")]
        let count = batch as f64;
        times.push(begin.elapsed().as_secs_f64() / count);
    }
    times.sort_by(f64::total_cmp);
    (result, times[times.len() / 2])
}
