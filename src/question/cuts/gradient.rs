//! The cuts across a gradient (§4.2): of one patch, and of many side by side.

use crate::discretize::{CertifiedCut, CutComparison, GradientCut};
use crate::exchange::{Progress, Unheard};
use crate::numeric::Interval;
use crate::question::QuestionError;
use crate::question::decimals;

/// Pairs of exponents beyond which nobody reads the cuts.
const MOST_PAIRS: usize = 10_000;

/// The question for the cuts of a patch whose radiosity grows as the power n of the position l.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Cut;
/// let linear = Cut { exponent: 1.0, ..Cut::default() }.ask(&Unheard)?;
/// // the root of the stationarity condition at 320 bits
/// assert!((linear.mutual_information_cut - 0.482_761_524_917_780).abs() < 1e-14);
/// assert!((linear.mean_square_cut - 0.5).abs() < 1e-15);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// The exponent n of the radiosity, from 1e-6 to 1e12.
    pub exponent: f64,
    /// The exponent of the irradiance.
    pub irradiance: IrradianceExponent,
    /// Bits of the ends of enclosures, if the cuts are to be enclosed, too.
    pub precision: Option<u32>,
}

/// The exponent m of the irradiance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IrradianceExponent {
    /// A number: 1 is what the paper prints.
    Fixed(f64),
    /// The exponent of the radiosity, which the paper's hypotheses imply.
    OfRadiosity,
}

impl Default for Cut {
    /// The paper's reading of a linear radiosity.
    fn default() -> Self {
        Self {
            exponent: 1.0,
            irradiance: IrradianceExponent::Fixed(1.0),
            precision: None,
        }
    }
}

/// Both cuts of one patch: information in bits per flux, errors for `B = lⁿ`.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct CutAnswer {
    /// The exponent n of the radiosity.
    pub exponent: f64,
    /// The exponent m of the irradiance.
    pub irradiance_exponent: f64,
    /// The position of the cut of highest mutual information.
    pub mutual_information_cut: f64,
    /// The distance of that cut from 1, to full relative precision.
    pub mutual_information_complement: f64,
    /// The gain of that cut.
    pub mutual_information_gain: f64,
    /// The position of the cut of least mean square error.
    pub mean_square_cut: f64,
    /// The distance of that cut from 1, to full relative precision.
    pub mean_square_complement: f64,
    /// The mean square error of that cut.
    pub mean_square_error: f64,
    /// The distance of the mean-square cut beyond the other one.
    pub distance: f64,
    /// The gain of the mean-square cut.
    pub gain_at_mean_square_cut: f64,
    /// The mean square error of the mutual-information cut.
    pub error_at_mutual_information_cut: f64,
    /// The share of the highest gain that the mean-square cut has.
    #[serde(skip)]
    pub gain_kept: f64,
    /// The error of the mutual-information cut above the least one, as a share of the least.
    #[serde(skip)]
    pub error_excess: f64,
    /// Enclosures, if they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosures: Option<CutEnclosures>,
}

/// Enclosures of both cuts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct CutEnclosures {
    /// The position of the cut of highest mutual information.
    #[serde(serialize_with = "decimals::ends")]
    pub mutual_information_cut: Interval,
    /// The distance of that cut from 1.
    #[serde(serialize_with = "decimals::ends")]
    pub mutual_information_complement: Interval,
    /// The gain of that cut.
    #[serde(serialize_with = "decimals::ends")]
    pub mutual_information_gain: Interval,
    /// The position of the cut of least mean square error.
    #[serde(serialize_with = "decimals::ends")]
    pub mean_square_cut: Interval,
    /// The distance of that cut from 1.
    #[serde(serialize_with = "decimals::ends")]
    pub mean_square_complement: Interval,
    /// The mean square error of that cut.
    #[serde(serialize_with = "decimals::ends")]
    pub mean_square_error: Interval,
}

impl From<[CertifiedCut; 2]> for CutEnclosures {
    fn from([information, square]: [CertifiedCut; 2]) -> Self {
        Self {
            mutual_information_cut: information.position,
            mutual_information_complement: information.complement,
            mutual_information_gain: information.value,
            mean_square_cut: square.position,
            mean_square_complement: square.complement,
            mean_square_error: square.value,
        }
    }
}

impl From<CutComparison> for CutAnswer {
    fn from(cuts: CutComparison) -> Self {
        let (information, square) = (&cuts.information, &cuts.square);
        Self {
            exponent: cuts.patch.exponent(),
            irradiance_exponent: cuts.patch.irradiance_exponent(),
            mutual_information_cut: information.position,
            mutual_information_complement: information.complement,
            mutual_information_gain: information.value,
            mean_square_cut: square.position,
            mean_square_complement: square.complement,
            mean_square_error: square.value,
            distance: cuts.distance(),
            gain_at_mean_square_cut: cuts.gain_at_square,
            error_at_mutual_information_cut: cuts.error_at_information,
            gain_kept: cuts.gain_kept(),
            error_excess: cuts.error_excess(),
            enclosures: cuts.certified.map(CutEnclosures::from),
        }
    }
}

impl Cut {
    /// Computes the answer.
    ///
    /// # Errors
    /// [`QuestionError::Discretize`] if an exponent is out of range.
    pub fn ask(&self, _: &dyn Progress) -> Result<CutAnswer, QuestionError> {
        let irradiance = match self.irradiance {
            IrradianceExponent::Fixed(exponent) => exponent,
            IrradianceExponent::OfRadiosity => self.exponent,
        };
        let patch = GradientCut::try_new(self.exponent, irradiance)?;
        Ok(CutComparison::try_new(patch, self.precision)?.into())
    }
}

/// The question for the cuts of many patches: each exponent of the radiosity with each of the
/// irradiance.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Cuts;
/// let cuts = Cuts { exponents: vec![1.0, 1e6], ..Cuts::default() }.ask(&Unheard)?;
/// // n (1 − l) tends to the root of x = 2 (1 − e^−x)
/// let scaled = 1e6 * cuts.cuts[1].mutual_information_complement;
/// assert!((scaled - 2.0 * (1.0 - (-scaled).exp())).abs() < 1e-5);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Cuts {
    /// The exponents of the radiosity.
    pub exponents: Vec<f64>,
    /// The exponents of the irradiance.
    pub irradiance: Vec<IrradianceExponent>,
    /// Bits of the ends of enclosures, if the cuts are to be enclosed, too.
    pub precision: Option<u32>,
}

impl Default for Cuts {
    /// The paper's reading, of no radiosity yet.
    fn default() -> Self {
        Self {
            exponents: Vec::new(),
            irradiance: vec![IrradianceExponent::Fixed(1.0)],
            precision: None,
        }
    }
}

/// The cuts of many patches.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct CutsAnswer {
    /// The cuts: for each exponent of the radiosity those for every exponent of the irradiance.
    pub cuts: Vec<CutAnswer>,
    /// The exponents of the irradiance, as asked for.
    #[serde(skip)]
    pub irradiance: Vec<IrradianceExponent>,
}

impl CutsAnswer {
    /// The cuts for one exponent of the irradiance, by its index, at rising exponents of the
    /// radiosity.
    #[must_use]
    pub fn rising(&self, irradiance: usize) -> Vec<&CutAnswer> {
        let step = self.irradiance.len().max(1);
        let mut cuts: Vec<&CutAnswer> = self.cuts.iter().skip(irradiance).step_by(step).collect();
        cuts.sort_by(|a, b| a.exponent.total_cmp(&b.exponent));
        cuts
    }
}

impl Cuts {
    /// Computes the answer.
    ///
    /// # Errors
    /// [`QuestionError::Discretize`] if an exponent is out of range;
    /// [`QuestionError::TooManyPairsOfExponents`].
    pub fn ask(&self, progress: &dyn Progress) -> Result<CutsAnswer, QuestionError> {
        let pairs = self.exponents.len().saturating_mul(self.irradiance.len());
        if pairs > MOST_PAIRS {
            return Err(QuestionError::TooManyPairsOfExponents {
                pairs,
                most: MOST_PAIRS,
            });
        }
        let questions = self.exponents.iter().flat_map(|exponent| {
            self.irradiance.iter().map(|irradiance| Cut {
                exponent: *exponent,
                irradiance: *irradiance,
                precision: self.precision,
            })
        });
        let cuts = questions.map(|cut| {
            let answer = cut.ask(&Unheard)?;
            progress.advance(1);
            Ok(answer)
        });
        Ok(CutsAnswer {
            cuts: cuts.collect::<Result<_, QuestionError>>()?,
            irradiance: self.irradiance.clone(),
        })
    }
}
