//! `cargo test` is the reproducibility check: verdicts, controls, enclosures, and the committed
//! tables.

mod coverage;
mod enclosures;
mod reported;
mod tables;
mod verdicts;

use infoscene::claims::{Context, Judgement, judge_all, registry};
use std::sync::LazyLock;

/// The context of all tests: its best grids are found once. That two processes write the same bytes
/// is checked by `.ci/run`.
static CONTEXT: LazyLock<Context> = LazyLock::new(Context::default);

/// Every claim, judged once for all tests.
static JUDGEMENTS: LazyLock<Vec<Judgement>> = LazyLock::new(judgements);

/// Every claim, judged a second time.
static AGAIN: LazyLock<Vec<Judgement>> = LazyLock::new(judgements);

fn judgements() -> Vec<Judgement> {
    judge_all(&registry().unwrap(), &CONTEXT, |_, _| ()).unwrap()
}
