//! A clock that the ranks of a job share: work begins when all are there, and ends with the last.

use super::{Basis, ScaleRow, StudyError};
use crate::exchange::{Ranks, agreed, gather_texts};
use std::collections::BTreeSet;
use std::fs;
use std::time::Instant;

/// The rows of what was timed so far.
pub(super) struct Timer<'r> {
    pub(super) ranks: &'r dyn Ranks,
    nodes: usize,
    pub(super) rows: Vec<ScaleRow>,
}

impl<'r> Timer<'r> {
    /// A clock of these ranks, which stand on as many nodes as there are names of hosts; where a
    /// system does not tell its name, on one.
    pub(super) fn new(ranks: &'r dyn Ranks) -> Self {
        let host = fs::read_to_string("/proc/sys/kernel/hostname").ok();
        let hosts = gather_texts(ranks, host.as_deref());
        Self {
            ranks,
            nodes: hosts.into_iter().collect::<BTreeSet<_>>().len(),
            rows: Vec::new(),
        }
    }

    /// Nodes that the ranks stand on.
    pub(super) const fn nodes(&self) -> usize {
        self.nodes
    }

    /// The largest of what each rank has.
    pub(super) fn largest(&self, own: f64) -> f64 {
        let all = self.ranks.gather(vec![own]);
        all.concat().into_iter().fold(own, f64::max)
    }

    /// Times some work on so many threads of each rank, and notes it; its seconds, and its answer.
    pub(super) fn time<T: Send>(
        &mut self,
        (case, patches, threads): (&str, usize, usize),
        work: impl FnOnce() -> Result<T, StudyError> + Send,
    ) -> Result<(f64, T), StudyError> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        self.ranks.gather(Vec::new());
        let start = Instant::now();
        let answer = match pool {
            Ok(pool) => pool.install(work),
            // as many as there are
            Err(_) => work(),
        };
        let seconds = start.elapsed().as_secs_f64();
        let answer = agreed(self.ranks, answer)?;
        let value = self.largest(seconds);
        let memory = self.most_memory();
        self.note(case, (Some(patches), threads), (value, "s"), memory);
        Ok((value, answer))
    }

    /// Notes a number that was measured.
    pub(super) fn note(
        &mut self,
        case: &str,
        (patches, threads): (Option<usize>, usize),
        (value, unit): (f64, &'static str),
        memory: Option<f64>,
    ) {
        self.rows.push(ScaleRow {
            case: case.to_owned(),
            basis: Basis::Measured,
            patches,
            nodes: self.nodes,
            ranks: self.ranks.count(),
            threads,
            value,
            unit,
            memory,
        });
    }

    /// The most memory that a rank ever had, where the system tells.
    pub(super) fn most_memory(&self) -> Option<f64> {
        let most = self.largest(most_memory().unwrap_or(0.0));
        (most > 0.0).then_some(most)
    }
}

/// The most memory that this process ever had, where the system tells.
fn most_memory() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = line.trim().trim_end_matches("kB").trim().parse().ok()?;
    Some(kilobytes * 1024.0)
}
