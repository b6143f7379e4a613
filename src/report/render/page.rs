//! Generated pages: templates with named places, and the texts to fill them.

use crate::chain::ChainError;
use crate::claims::ClaimError;
use crate::discretize::DiscretizeError;
use crate::numeric::{Bounded, Interval, Scalar};
use std::collections::BTreeMap;

/// A page that cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PageError {
    /// A claim, or its computation.
    #[error(transparent)]
    Claim(#[from] ClaimError),
    /// A grid or a cut.
    #[error(transparent)]
    Discretize(#[from] DiscretizeError),
    /// A chain.
    #[error(transparent)]
    Chain(#[from] ChainError),
    /// A table.
    #[error(transparent)]
    Report(#[from] crate::report::ReportError),
    /// A template cannot be filled.
    #[error("a template cannot be filled: {0}")]
    Template(#[from] minijinja::Error),
    /// A number is not certain to the decimals that its place shows.
    #[error("\"{name}\" is {value} ± {error:e}: {decimals} decimals are not certain")]
    Uncertain {
        /// Name of the place.
        name: &'static str,
        /// The number.
        value: f64,
        /// The error of the number.
        error: f64,
        /// Decimals to show.
        decimals: u32,
    },
    /// A sentence that the numbers no longer support.
    #[error("the page says what no longer holds: {statement}")]
    NoLonger {
        /// The statement.
        statement: &'static str,
    },
    /// Something that a page needs is not there.
    #[error("there is not {what} of {owner}")]
    Missing {
        /// The missing thing.
        what: &'static str,
        /// The claim or study that should have it.
        owner: String,
    },
    /// A place has no text, or a text no place.
    #[error("the template and the texts do not match at \"{name}\"")]
    Place {
        /// Name of the place.
        name: String,
    },
}

impl PageError {
    /// An error unless a statement of the page holds.
    pub(crate) const fn unless(holds: bool, statement: &'static str) -> Result<(), Self> {
        if holds {
            Ok(())
        } else {
            Err(Self::NoLonger { statement })
        }
    }

    pub(crate) fn without(what: &'static str, owner: &str) -> Self {
        let owner = owner.to_owned();
        Self::Missing { what, owner }
    }
}

/// Texts for the places `{{name}}` of a template.
#[derive(Debug, Default)]
pub(crate) struct Texts {
    texts: BTreeMap<&'static str, String>,
}

impl Texts {
    /// Adds a text; one that ends in a newline takes the place's own.
    pub(crate) fn text(&mut self, name: &'static str, text: String) {
        self.texts.insert(name, text);
    }

    /// Adds a number with so many decimals.
    pub(crate) fn number(
        &mut self,
        name: &'static str,
        number: Bounded,
        decimals: u32,
    ) -> Result<(), PageError> {
        let text = decimal_text(name, number, decimals)?;
        self.text(name, text);
        Ok(())
    }

    /// Adds an enclosed number with so many decimals.
    pub(crate) fn enclosed(
        &mut self,
        name: &'static str,
        enclosure: &Interval,
        decimals: u32,
    ) -> Result<(), PageError> {
        let text = Self::enclosed_text(name, enclosure, decimals)?;
        self.text(name, text);
        Ok(())
    }

    /// An enclosed number with so many decimals.
    pub(crate) fn enclosed_text(
        name: &'static str,
        enclosure: &Interval,
        decimals: u32,
    ) -> Result<String, PageError> {
        let value = enclosure.to_f64();
        // the nearest double adds half a unit of its last place
        let error = enclosure.width() + f64::EPSILON * value.abs();
        decimal_text(name, Bounded::bound(value, error), decimals)
    }

    /// The template with every place filled.
    ///
    /// # Errors
    /// [`PageError::Place`] for a place without a text and a text without a place.
    pub(crate) fn filled(&self, template: &str) -> Result<String, PageError> {
        let mut page = String::new();
        let mut rest = template;
        let mut used = Vec::new();
        while let Some((before, after)) = rest.split_once("{{") {
            let place = |name: &str| PageError::Place {
                name: name.to_owned(),
            };
            let (name, after) = after.split_once("}}").ok_or_else(|| place(after))?;
            let text = self.texts.get(name).ok_or_else(|| place(name))?;
            used.push(name);
            page += before;
            page += text.trim_end_matches('\n');
            rest = after;
        }
        match self.texts.keys().find(|name| !used.contains(*name)) {
            Some(name) => Err(PageError::Place {
                name: (*name).to_owned(),
            }),
            None => Ok(page + rest),
        }
    }
}

/// The number rounded to so many decimals, all of them certain to one unit.
fn decimal_text(name: &'static str, number: Bounded, decimals: u32) -> Result<String, PageError> {
    let Bounded { value, error, .. } = number;
    let unit = 0.1f64.powi(decimals.try_into().unwrap_or(i32::MAX));
    if value.is_finite() && error <= 0.5 * unit {
        let places = usize::try_from(decimals).unwrap_or(0);
        return Ok(format!("{value:.places$}").replace('-', "−"));
    }
    Err(PageError::Uncertain {
        name,
        value,
        error,
        decimals,
    })
}
