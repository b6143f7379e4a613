//! `infoscene store check DIR`, and the shares of a store.

use super::output::Output;
use super::{Answer, Outcome};
use infoscene::exchange::Shard;
use infoscene::question::CheckStore;
use infoscene::report::store_state_report;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Store {
    #[command(subcommand)]
    question: StoreQuestion,
}

#[derive(Debug, clap::Subcommand)]
enum StoreQuestion {
    /// Tell what of a matrix is there, and whether it keeps the laws of form factors: exit status 1
    /// if something is missing or broken.
    Check {
        /// The folder that `form-factor --store` wrote.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
        #[command(flatten)]
        output: Output,
    },
}

impl Store {
    pub(super) fn answer(self) -> Answer {
        let StoreQuestion::Check { folder, output } = self.question;
        output.check()?;
        let state = CheckStore { folder }.ask()?;
        output.write(&store_state_report(&state)?)?;
        Ok(if state.is_whole() {
            Outcome::Done
        } else {
            Outcome::Differs
        })
    }
}

/// Reads `K/N`, K from 1 to N.
pub(super) fn shard(text: &str) -> Result<Shard, String> {
    let parts = text.split_once('/');
    let numbers = parts.and_then(|(k, n)| Some((k.parse::<usize>().ok()?, n.parse().ok()?)));
    match numbers {
        Some((number, of)) if (1..=of).contains(&number) => Ok(Shard {
            number: number - 1,
            of,
        }),
        _ => Err("it must be K/N, the K-th of N shares, as 3/16".to_owned()),
    }
}
