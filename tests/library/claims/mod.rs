//! `cargo test` is the reproducibility check: verdicts, controls, enclosures, and the committed
//! tables.

mod coverage;
mod enclosures;
mod tables;
mod verdicts;

use infoscene::claims::{Context, Judgement, judge_all, registry};
use std::sync::LazyLock;

/// Every claim, judged once for all tests.
static JUDGEMENTS: LazyLock<Vec<Judgement>> = LazyLock::new(judgements);

fn judgements() -> Vec<Judgement> {
    judge_all(&registry().unwrap(), &Context::default(), || ()).unwrap()
}
