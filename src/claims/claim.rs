//! One claim of the paper, as it stands in `data/paper/`.

use super::{Inputs, Verdict};
use crate::numeric::Interval;

/// What there is to do about a claim.
#[derive(Debug, Clone, PartialEq)]
pub enum Task {
    /// Compute it and judge.
    Compute {
        /// Name of the function, as in [`computations`](super::computations).
        computation: String,
        /// What it is computed from.
        input: Inputs,
        /// A change of input under which the verdict must turn.
        control: Inputs,
        /// The verdict on record: any other is an error of the suite.
        recorded: Verdict,
    },
    /// Nothing to compute: a theorem of `proofs/` decides it.
    Proved {
        /// Is it the contrary that is proved?
        is_refuted: bool,
        /// What a reader should know.
        note: String,
    },
    /// Nothing yet, for this reason.
    NotChecked {
        /// Why.
        reason: String,
    },
}

/// A claim of the paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// Short name, unique.
    pub id: String,
    /// Where it stands in the paper.
    pub place: String,
    /// What is claimed, in our own words.
    pub quantity: String,
    /// The printed number, if it is one.
    pub printed: Option<Printed>,
    /// Does the paper state the configuration completely? If not, disagreement refutes nothing.
    pub complete: bool,
    /// What the axes of the figure's curve measure, with their units, if its computation returns one.
    pub curve_axes: Option<[String; 2]>,
    /// Theorems of `proofs/Statements.v` that prove the claim as it stands, or its contrary.
    pub proof: Vec<String>,
    /// What to do.
    pub task: Task,
}

/// A number as printed: it stands for an interval of half a unit of its last decimal either way.
#[derive(Debug, Clone, PartialEq)]
pub struct Printed {
    /// As in the paper.
    pub text: String,
    /// Its value.
    pub value: f64,
    /// How many decimals it is printed with.
    pub decimals: u32,
}

impl Printed {
    /// Reads a printed number; `None` if it is not a plain decimal.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let value: f64 = text.parse().ok().filter(|value: &f64| value.is_finite())?;
        let decimals = text
            .split_once('.')
            .map_or(0, |(_, decimals)| decimals.len());
        Some(Self {
            text: text.to_owned(),
            value,
            decimals: decimals.try_into().ok()?,
        })
    }

    /// The interval it stands for.
    #[must_use]
    pub fn interval(&self) -> (f64, f64) {
        let half = 0.5 * 0.1f64.powi(self.decimals.try_into().unwrap_or(i32::MAX));
        (self.value - half, self.value + half)
    }

    /// Its ends, each enclosed; `None` if the text is no decimal number.
    #[must_use]
    pub fn exact_interval(&self, bits: u32) -> Option<[Interval; 2]> {
        let value = Interval::parse(&self.text, bits)?;
        let half = Interval::parse(&format!("5e-{}", self.decimals + 1), bits)?;
        Some([value.clone() - &half, value + &half])
    }
}

/// A claim as written in TOML.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Entry {
    id: String,
    place: String,
    quantity: String,
    printed: Option<String>,
    #[serde(default = "yes")]
    complete: bool,
    computation: Option<String>,
    verdict: Option<Verdict>,
    not_checked: Option<String>,
    curve: Option<[String; 2]>,
    #[serde(default)]
    proof: Vec<String>,
    note: Option<String>,
    #[serde(default)]
    input: Inputs,
    #[serde(default)]
    control: Inputs,
}

const fn yes() -> bool {
    true
}

impl TryFrom<Entry> for Claim {
    type Error = String;

    fn try_from(entry: Entry) -> Result<Self, String> {
        let id = entry.id;
        let printed = match entry.printed {
            None => None,
            Some(text) => Some(
                Printed::parse(&text)
                    .ok_or_else(|| format!("claim {id}: \"{text}\" is not a decimal number"))?,
            ),
        };
        let task = match (entry.computation, entry.verdict, entry.not_checked) {
            (Some(computation), Some(recorded), None) => {
                let (input, control) = (entry.input, entry.control);
                Task::Compute {
                    computation,
                    input,
                    control,
                    recorded,
                }
            }
            (None, None, Some(reason)) => Task::NotChecked { reason },
            (None, Some(verdict @ (Verdict::Confirmed | Verdict::Refuted)), None)
                if !entry.proof.is_empty() =>
            {
                Task::Proved {
                    is_refuted: verdict == Verdict::Refuted,
                    note: entry.note.unwrap_or_default(),
                }
            }
            _ => {
                return Err(format!(
                    "claim {id}: needs computation and verdict, or proof and verdict, or not_checked"
                ));
            }
        };
        let (place, quantity, complete) = (entry.place, entry.quantity, entry.complete);
        Ok(Self {
            id,
            place,
            quantity,
            printed,
            complete,
            curve_axes: entry.curve,
            proof: entry.proof,
            task,
        })
    }
}
