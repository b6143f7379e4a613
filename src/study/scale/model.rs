//! The model: times and memory of n patches on N nodes of c threads.
//!
//! ```text
//!   pass      (n²/2) t/(N c) + s/b                       t: a pair, s: what a node sends
//!             s = 16 K (n²/128)/N                  K = 4 sums of two numbers, tiles of 128 rows
//!   store     as a pass, + 12 n²/(N w)                   w: a node's disk, written
//!   product   8 (n²/2)/(N m) + s/b                       m: entries read by a node's threads, held
//!             8 (n²/2)/(N r) + s/b                       r: read from the store
//!             s = 16 β (n/2)/N + 16 n                    β = max(16, n²/2²³) blocks of rows
//!   solution  P products                                 P: measured
//! ```
//!
//! On one node nothing is sent. Threads of a node are taken to share its work evenly, and its
//! memory and disks not to be shared with other nodes. What a product sends grows like n³, as
//! blocks of rows have 2²² entries whatever n is.
//!
//! **Not covered**: the latency of messages, a few for each pass and product; load that is uneven.

use super::{Basis, ScaleRow};
use crate::numeric::real;

/// What the model is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Terms {
    /// Seconds of one thread for a pair that takes the value of a congruent one, is computed, and
    /// is computed past others.
    pub(super) pair: [f64; 3],
    /// Seconds of one thread for an entry of a held matrix in a product.
    pub(super) entry: f64,
    /// Seconds of one thread for an entry in a product from a store in the page cache.
    pub(super) stored_entry: f64,
    /// Products of a solution.
    pub(super) products: f64,
    /// Bytes of a scene's pairs, a patch.
    pub(super) patch: f64,
    /// Bytes a second that a node sends, if the ranks stand on several.
    pub(super) network: Option<f64>,
}

/// Threads of a node, taken for granted.
const THREADS: usize = 32;
/// Bytes a second between two nodes, where no message between nodes was timed: 10 Gbit/s.
const NETWORK: f64 = 1.25e9;
/// Bytes a second that a node's disk writes, and reads.
const DISK: f64 = 1e9;
/// Bytes a second that a node's memory delivers to all of its threads.
const MEMORY: f64 = 1e11;

/// The kinds of pairs.
const KINDS: [&str; 3] = ["congruent", "computed", "past others"];

/// Numbers of patches and of nodes that are predicted.
const PATCHES: [usize; 2] = [100_000, 1_000_000];
const NODES: [usize; 4] = [1, 10, 100, 1000];

impl Terms {
    /// The terms, each with what it rests on.
    pub(super) fn rows(&self) -> Vec<ScaleRow> {
        let term = |case: String, basis, value, unit| ScaleRow {
            case,
            basis,
            patches: None,
            nodes: 1,
            ranks: 1,
            threads: 1,
            value,
            unit,
            memory: None,
        };
        let pairs = KINDS.iter().zip(self.pair);
        let pairs = pairs.map(|(kind, t)| (format!("t, a pair {kind}"), t, "s"));
        let measured = pairs.chain([
            ("an entry of a product, held".to_owned(), self.entry, "s"),
            (
                "an entry of a product, stored".to_owned(),
                self.stored_entry,
                "s",
            ),
            ("P, products of a solution".to_owned(), self.products, ""),
            ("a patch in memory".to_owned(), self.patch, "bytes"),
        ]);
        let assumed = [
            ("c, threads of a node", real(THREADS), ""),
            ("r and w, disk of a node", DISK, "bytes/s"),
            ("memory of a node", MEMORY, "bytes/s"),
        ];
        let measured = measured.map(|(case, value, unit)| (case, Basis::Measured, value, unit));
        let assumed =
            assumed.map(|(case, value, unit)| (case.to_owned(), Basis::Assumed, value, unit));
        let basis = match self.network {
            Some(_) => Basis::Measured,
            None => Basis::Assumed,
        };
        let network = "b, network of a node".to_owned();
        let network = (network, basis, self.network(), "bytes/s");
        let all = measured.chain(assumed).chain([network]);
        all.map(|(case, basis, value, unit)| term(case, basis, value, unit))
            .collect()
    }

    /// Bytes a second between two nodes.
    fn network(&self) -> f64 {
        self.network.unwrap_or(NETWORK)
    }

    /// What the model predicts.
    pub(super) fn predictions(&self) -> Vec<ScaleRow> {
        let mut rows = Vec::new();
        for patches in PATCHES {
            for nodes in NODES {
                let work = self.works(patches, nodes);
                rows.extend(work.map(|(case, value, memory)| ScaleRow {
                    case,
                    basis: Basis::Predicted,
                    patches: Some(patches),
                    nodes,
                    ranks: nodes,
                    threads: THREADS,
                    value,
                    unit: "s",
                    memory: Some(memory),
                }));
            }
        }
        rows
    }

    /// The works with so many patches on so many nodes: seconds, and bytes of a node.
    fn works(&self, patches: usize, nodes: usize) -> [(String, f64, f64); 6] {
        let (n, count) = (real(patches), real(nodes));
        let share = count * real(THREADS);
        let sent = |bytes: f64| {
            if nodes > 1 {
                bytes / self.network()
            } else {
                0.0
            }
        };
        let pairs = n * n / 2.0;
        let scene = self.patch * n;
        let pass = |kind: usize| {
            let seconds = pairs * self.pair[kind] / share + sent(64.0 * n * n / 128.0 / count);
            (format!("measure, pairs {}", KINDS[kind]), seconds, scene)
        };
        let written = 12.0 * n * n / (count * DISK);
        let fill = pairs * self.pair[1] / share + written;
        let blocks = (n * n / f64::from(1 << 23)).max(16.0);
        let message = sent(16.0 * blocks * (n / 2.0) / count + 16.0 * n);
        let entries = 8.0 * pairs / count;
        let held = (pairs * self.entry / share).max(entries / MEMORY) + message;
        let stored = (pairs * self.stored_entry / share).max(entries / DISK) + message;
        let threads = real(THREADS);
        [
            pass(0),
            pass(1),
            pass(2),
            (
                "store, pairs computed".to_owned(),
                fill,
                scene + threads * 40.0 * 1024.0 * 1024.0,
            ),
            (
                "radiosity, held".to_owned(),
                self.products * held,
                scene + 2.0 * entries + 16.0 * 16.0 * n,
            ),
            (
                "radiosity, from the store".to_owned(),
                self.products * stored,
                scene + threads * 2.0 * 8.0 * f64::from(1 << 22) + 16.0 * 16.0 * n,
            ),
        ]
    }
}
