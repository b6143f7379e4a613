//! A refinement that breaks a promise, with the source that makes it again.

use super::sabotage::{Sabotage, broken_flow};
use crate::chain::ReversibleChain;
use crate::chain::random::families::RefinementDraw;

/// A refinement that broke a promise.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Counterexample {
    /// The broken promise.
    pub reason: String,
    /// Joint matrix of the refined chain, in rows.
    pub joint: Vec<Vec<f64>>,
    /// The coarse state that each state of the refined chain is a part of.
    pub parents: Vec<usize>,
    /// Rust source that makes the refinement.
    pub source: String,
}

impl Counterexample {
    pub(super) fn none() -> Self {
        let (reason, source) = (String::new(), String::new());
        Self {
            reason,
            joint: Vec::new(),
            parents: Vec::new(),
            source,
        }
    }

    pub(super) fn new(reason: String, draw: &RefinementDraw, sabotage: Option<Sabotage>) -> Self {
        let Ok(refinement) = draw.refinement() else {
            return Self {
                reason,
                source: format!("{draw:?}"),
                ..Self::none()
            };
        };
        let parents = refinement.parents().to_vec();
        match broken_flow(&refinement, sabotage) {
            None => Self {
                reason,
                joint: rows(refinement.refined()),
                parents,
                source: format!("{refinement:?}"),
            },
            Some(flow) => {
                let source = format!(
                    "// broken on purpose: w_k P_kl of a chain that is no refinement of the coarse \
                     one\n\
                     let flow = {flow:?};\nlet coarse = {:?};\nlet parents = {parents:?};",
                    rows(refinement.coarse())
                );
                Self {
                    reason,
                    joint: flow,
                    parents,
                    source,
                }
            }
        }
    }
}

fn rows(chain: &ReversibleChain) -> Vec<Vec<f64>> {
    chain
        .joint()
        .row_iter()
        .map(|row| row.iter().copied().collect())
        .collect()
}
