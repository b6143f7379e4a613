//! The paper's claims, computed and judged.

use crate::claims::{
    Claim, ClaimError, Context, DEFAULT_PRECISION, Judgement, Quantity, Theorem, Verdict,
    judge_all, registry,
};
use crate::exchange::Progress;
use crate::numeric::{Grade, Interval};
use crate::question::QuestionError;

/// The question for the verdicts on claims of the paper.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Reproduce;
/// let fig_2 = Reproduce { claims: vec!["fig2-parallel-cut".to_owned()], ..Reproduce::default() };
/// let answer = fig_2.ask(&Unheard)?;
/// let cut = answer.claims[0].computed;
/// assert!(cut.is_some_and(|cut| (cut - 0.399_201_026_045).abs() < 1e-12));
/// assert!(answer.is_as_recorded());
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reproduce {
    /// The ids of the claims; all claims if none is named.
    pub claims: Vec<String>,
    /// Are only claims that print a number meant?
    pub printed_only: bool,
    /// Bits of the ends of enclosures.
    pub precision: u32,
}

impl Default for Reproduce {
    /// All claims, to the default precision.
    fn default() -> Self {
        Self {
            claims: Vec::new(),
            printed_only: false,
            precision: DEFAULT_PRECISION,
        }
    }
}

/// The claims asked for, judged, in paper order.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct ReproduceAnswer {
    /// The claims.
    pub claims: Vec<JudgedClaim>,
}

/// A claim of the paper, the number behind it and the verdict.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct JudgedClaim {
    /// Short name, unique.
    pub id: String,
    /// The place in the paper.
    pub place: String,
    /// The statement, in our own words.
    pub quantity: String,
    /// The printed number; none for a claim in words.
    pub printed: Option<f64>,
    /// The printed number as it stands in the paper.
    #[serde(skip)]
    pub printed_text: Option<String>,
    /// The number of its decimals.
    pub decimals: Option<u32>,
    /// The number computed.
    pub computed: Option<f64>,
    /// The stated error, or the residual that rounding may leave.
    pub error: Option<f64>,
    /// An enclosure of the number, if there is one; its ends follow in decimals.
    #[serde(skip)]
    pub enclosure: Option<Interval>,
    /// The lower end of the enclosure, with every certified digit.
    pub lower: Option<String>,
    /// The upper end of the enclosure, with every certified digit.
    pub upper: Option<String>,
    /// Theorems that prove the claim, or its contrary, each with hypotheses and conclusion.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub proof: Vec<Theorem>,
    /// The step between the theorems and the claim that is shown on paper only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub on_paper: Option<String>,
    /// The grade of the evidence, if there is any.
    pub evidence: Option<Grade>,
    /// The verdict of this run.
    pub verdict: Verdict,
    /// The verdict on record.
    pub recorded: Verdict,
    /// A note for the reader.
    pub note: String,
    /// The curve of the claim's figure, if it has one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub curve: Vec<[f64; 2]>,
}

impl From<&Judgement> for JudgedClaim {
    fn from(judgement: &Judgement) -> Self {
        let claim = &judgement.claim;
        let finding = judgement.finding.as_ref();
        let enclosure = finding.and_then(|finding| finding.enclosure.clone());
        let bounds = enclosure.as_ref().and_then(Interval::every_decimal);
        let (lower, upper) = bounds.map(|bounds| (bounds.lower, bounds.upper)).unzip();
        let printed = claim.printed.as_ref();
        Self {
            id: claim.id.clone(),
            place: claim.place.clone(),
            quantity: claim.quantity.clone(),
            printed: printed.map(|printed| printed.value),
            printed_text: printed.map(|printed| printed.text.clone()),
            decimals: printed.map(|printed| printed.decimals),
            computed: finding.map(|finding| finding.quantity.number()),
            error: finding.map(|finding| match finding.quantity {
                Quantity::Value { error, .. } => error,
                Quantity::Residual { tolerance, .. } => tolerance,
            }),
            enclosure,
            lower,
            upper,
            proof: claim.proof.clone(),
            on_paper: claim.on_paper.clone(),
            evidence: judgement.evidence(),
            verdict: judgement.verdict,
            recorded: judgement.recorded(),
            note: judgement.note().to_owned(),
            curve: finding.map_or_else(Vec::new, |finding| finding.curve.clone()),
        }
    }
}

impl From<&[Judgement]> for ReproduceAnswer {
    fn from(judgements: &[Judgement]) -> Self {
        Self {
            claims: judgements.iter().map(JudgedClaim::from).collect(),
        }
    }
}

impl ReproduceAnswer {
    /// Are all verdicts those on record?
    #[must_use]
    pub fn is_as_recorded(&self) -> bool {
        self.claims
            .iter()
            .all(|claim| claim.verdict == claim.recorded)
    }
}

impl Reproduce {
    /// The claims that are meant, in paper order.
    ///
    /// # Errors
    /// [`QuestionError::Claim`] if there is no claim of a name; [`QuestionError::NonePrinted`].
    pub fn selection(&self) -> Result<Vec<Claim>, QuestionError> {
        let mut claims = named_claims(&self.claims)?;
        if self.printed_only {
            claims.retain(|claim| claim.printed.is_some());
            if claims.is_empty() {
                return Err(QuestionError::NonePrinted {
                    ids: self.claims.clone(),
                });
            }
        }
        Ok(claims)
    }

    /// Computes the answer; progress advances by one with each claim.
    ///
    /// # Errors
    /// As [`selection`](Self::selection), and [`QuestionError::Claim`] if a computation fails.
    pub fn ask(&self, progress: &dyn Progress) -> Result<ReproduceAnswer, QuestionError> {
        let claims = self.selection()?;
        let context = Context::new(self.precision);
        let judgements = judge_all(&claims, &context, |_, _| progress.advance(1))?;
        Ok(ReproduceAnswer::from(judgements.as_slice()))
    }
}

/// The claims with these ids in paper order, all for none.
pub(super) fn named_claims(ids: &[String]) -> Result<Vec<Claim>, ClaimError> {
    let mut claims = registry()?;
    for id in ids {
        if !claims.iter().any(|claim| claim.id == *id) {
            return Err(ClaimError::UnknownClaim {
                id: id.clone(),
                nearest: nearest(&claims, id),
            });
        }
    }
    if !ids.is_empty() {
        claims.retain(|claim| ids.contains(&claim.id));
    }
    Ok(claims)
}

/// The id that begins as a wrong one does, by two letters at least.
fn nearest(claims: &[Claim], id: &str) -> Option<String> {
    let shared = |claim: &Claim| {
        let letters = claim.id.chars().zip(id.chars());
        letters.take_while(|(a, b)| a == b).count()
    };
    let nearest = claims.iter().max_by_key(|claim| shared(claim));
    let nearest = nearest.filter(|claim| shared(claim) > 1);
    nearest.map(|claim| claim.id.clone())
}
