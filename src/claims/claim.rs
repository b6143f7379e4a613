//! One claim of the paper, as it stands in `data/paper/`.

use super::{Computation, Formula, Inputs, OneSided, Theorem, Verdict};
use crate::numeric::Interval;
use std::collections::BTreeMap;

/// The task that a claim sets.
#[derive(Debug, Clone, PartialEq)]
pub enum Task {
    /// Compute it and judge.
    Compute {
        /// The computation.
        computation: Computation,
        /// The inputs of the computation.
        input: Inputs,
        /// Changes under which the verdict must turn.
        control: Control,
        /// The verdict on record: any other is an error of the suite.
        recorded: Verdict,
        /// The only side to which the computation can decide; none for both.
        can_only: Option<OneSided>,
    },
    /// Nothing to compute: a theorem of `proofs/` decides it.
    Proved {
        /// Whether the contrary is proved.
        is_refuted: bool,
        /// A note for the reader.
        note: String,
    },
    /// Nothing of its own: the claim is that all of these hold.
    AllOf {
        /// The ids of the claims.
        members: Vec<String>,
        /// The names of the claims in a sentence.
        note: String,
        /// The verdict on record.
        recorded: Verdict,
    },
    /// Nothing yet, for this reason.
    NotChecked {
        /// The reason.
        reason: String,
    },
}

/// A claim of the paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// Short name, unique.
    pub id: String,
    /// The place in the paper.
    pub place: String,
    /// The statement, in our own words.
    pub quantity: String,
    /// The printed number, if it is one.
    pub printed: Option<Printed>,
    /// Whether the paper states the configuration completely: if not, disagreement refutes nothing.
    pub complete: bool,
    /// The labels of the axes of the figure's curve, with units, if its computation returns one.
    pub curve_axes: Option<[String; 2]>,
    /// Theorems of `proofs/Statements.v` that prove the claim as it stands, or its contrary.
    pub proof: Vec<Theorem>,
    /// The formula that it is about.
    pub formula: Formula,
    /// The step from these theorems to the claim that is shown on paper only, by no machine.
    pub on_paper: Option<String>,
    /// The task.
    pub task: Task,
}

/// A change of a claim's inputs, of the number it prints, or of both.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Control {
    /// Inputs in place of their namesakes.
    pub inputs: Inputs,
    /// The number taken for the printed one.
    pub printed: Option<Printed>,
}

/// A number as printed: it stands for an interval of half a unit of its last decimal either way.
#[derive(Debug, Clone, PartialEq)]
pub struct Printed {
    /// The text in the paper.
    pub text: String,
    /// The value of the text.
    pub value: f64,
    /// The number of its decimals.
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

    /// The ends of that interval, each enclosed; `None` if the text is no decimal number.
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
    computation: Option<Computation>,
    verdict: Option<Verdict>,
    can_only: Option<OneSided>,
    not_checked: Option<String>,
    all_of: Option<Vec<String>>,
    curve: Option<[String; 2]>,
    #[serde(default)]
    proof: Vec<String>,
    on_paper: Option<String>,
    note: Option<String>,
    #[serde(default)]
    input: Inputs,
    #[serde(default)]
    control: ControlEntry,
}

/// A control as written in TOML.
#[derive(Debug, Default, serde::Deserialize)]
struct ControlEntry {
    printed: Option<String>,
    #[serde(flatten)]
    inputs: Inputs,
}

const fn yes() -> bool {
    true
}

impl Entry {
    /// The claim of this entry, whose theorems and formula are among these.
    pub(super) fn claim(
        self,
        theorems: &BTreeMap<String, Theorem>,
        formulas: &BTreeMap<String, Formula>,
    ) -> Result<Claim, String> {
        let formula = formulas.get(&self.id).cloned();
        let formula = formula.ok_or_else(|| format!("claim {}: it has no formula", self.id))?;
        let printed = self.number(self.printed.as_deref())?;
        let (proof, task) = (self.theorems(theorems)?, self.task()?);
        Ok(Claim {
            id: self.id,
            place: self.place,
            quantity: self.quantity,
            printed,
            complete: self.complete,
            curve_axes: self.curve,
            proof,
            formula,
            on_paper: self.on_paper,
            task,
        })
    }

    /// A number as printed, if there is one.
    fn number(&self, text: Option<&str>) -> Result<Option<Printed>, String> {
        let printed = text.map(|text| {
            let printed = Printed::parse(text);
            printed.ok_or_else(|| format!("claim {}: \"{text}\" is not a decimal number", self.id))
        });
        printed.transpose()
    }

    /// The theorems that it names.
    fn theorems(&self, all: &BTreeMap<String, Theorem>) -> Result<Vec<Theorem>, String> {
        let id = &self.id;
        let found = self.proof.iter().map(|name| {
            let theorem = all.get(name).cloned();
            theorem.ok_or_else(|| format!("claim {id}: {name} is not in data/proved_theorems.toml"))
        });
        let found: Vec<Theorem> = found.collect::<Result<_, _>>()?;
        if found.is_empty() && self.on_paper.is_some() {
            return Err(format!("claim {id}: on_paper needs a proof to lie beside"));
        }
        Ok(found)
    }

    /// The work: what is to be computed, if anything.
    fn task(&self) -> Result<Task, String> {
        let not_checked = self.not_checked.as_ref();
        match (self.computation, self.verdict, not_checked, &self.all_of) {
            (Some(computation), Some(recorded), None, None) => Ok(Task::Compute {
                computation,
                input: self.input.clone(),
                control: Control {
                    inputs: self.control.inputs.clone(),
                    printed: self.number(self.control.printed.as_deref())?,
                },
                recorded,
                can_only: self.can_only,
            }),
            (None, None, Some(reason), None) => Ok(Task::NotChecked {
                reason: reason.clone(),
            }),
            (None, Some(recorded), None, Some(members)) => Ok(Task::AllOf {
                note: format!("holds where all of these do: {}", members.join(", ")),
                members: members.clone(),
                recorded,
            }),
            (None, Some(verdict @ (Verdict::Confirmed | Verdict::Refuted)), None, None)
                if !self.proof.is_empty() =>
            {
                Ok(Task::Proved {
                    is_refuted: verdict == Verdict::Refuted,
                    note: self.note.clone().unwrap_or_default(),
                })
            }
            _ => Err(format!(
                "claim {}: needs computation and verdict, or proof and verdict, or all_of and \
                 verdict, or not_checked",
                self.id
            )),
        }
    }
}
