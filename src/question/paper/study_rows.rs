//! Rows of the studies of cuts across a gradient, as records.

use crate::discretize::GradientLimit;
use crate::numeric::{Interval, Scalar};
use crate::question::decimals;
use crate::study::cuts::directions::DirectionRow;
use crate::study::cuts::limits::LimitRow;
use crate::study::cuts::profiles::ProfileRow;

/// A cut of §4.2 on its way to its limit.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct LimitRecord {
    /// The exponent n, in words.
    pub case: String,
    /// The cut, in words.
    pub method: &'static str,
    /// The cut.
    #[serde(skip)]
    pub cut: GradientLimit,
    /// The exponent n of the radiosity.
    pub exponent: f64,
    /// `n (1 − l)`.
    pub value: f64,
    /// An enclosure of `n (1 − l)`.
    #[serde(skip)]
    pub enclosure: Interval,
    /// The distance of `n (1 − l)` from its limit, relative to that.
    pub relative_error: f64,
    /// `n (n (1 − l) − limit)`.
    pub scaled_difference: f64,
    /// The limit of `n (1 − l)`.
    #[serde(serialize_with = "decimals::ends_to_60")]
    pub limit: Interval,
    /// The limit of `n (n (1 − l) − limit)`.
    #[serde(serialize_with = "decimals::ends_to_60")]
    pub rate: Interval,
    /// Time of the certified cut, in seconds.
    pub seconds: f64,
}

impl From<LimitRow> for LimitRecord {
    fn from(row: LimitRow) -> Self {
        let limit = row.limits.limit;
        let difference = (row.scaled.clone() - &limit) / &limit;
        Self {
            case: format!("n = {:e}", row.exponent),
            method: match row.cut {
                GradientLimit::FixedIrradiance => "mutual information, m = 1",
                GradientLimit::EqualExponents => "mutual information, m = n",
                GradientLimit::MeanSquare => "mean square",
            },
            cut: row.cut,
            exponent: row.exponent,
            value: row.scaled.to_f64(),
            enclosure: row.scaled,
            relative_error: difference.abs().to_f64(),
            scaled_difference: row.scaled_difference.to_f64(),
            limit,
            rate: row.limits.rate,
            seconds: row.seconds,
        }
    }
}

/// One cut of one profile of radiosity.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct ProfileRecord {
    /// The profile of the radiosity, in words.
    pub case: &'static str,
    /// The irradiance, in words.
    pub irradiance: &'static str,
    /// The measure, `"mutual information"` or `"mean square"`.
    pub method: &'static str,
    /// The position of the cut; none where every cut gains 0.
    pub value: Option<f64>,
    /// The gain of the cut, in bits.
    pub gain: f64,
    /// The share of the highest gain.
    pub gain_share: Option<f64>,
    /// The square error of two constants, relative to that of one.
    pub square_error: Option<f64>,
    /// The square error above the least, as a share of the least; none where that is 0.
    pub relative_error: Option<f64>,
    /// Is `1 − l` as good, by symmetry?
    pub has_twin: bool,
    /// Time of the cut, in seconds.
    pub seconds: f64,
}

impl ProfileRecord {
    /// The cuts of a profile by both measures.
    pub(super) fn both(row: &ProfileRow) -> [Self; 2] {
        let least = row.square.square_error;
        let highest = row.information.map(|cut| cut.gain);
        let cuts = [
            ("mutual information", row.information, row.seconds[0]),
            ("mean square", Some(row.square), row.seconds[1]),
        ];
        cuts.map(|(method, cut, seconds)| Self {
            case: row.case,
            irradiance: row.irradiance,
            method,
            value: cut.map(|cut| cut.position),
            gain: cut.map_or(0.0, |cut| cut.gain),
            gain_share: cut.and_then(|cut| Some(cut.gain / highest?)),
            square_error: cut.map(|cut| cut.square_error),
            relative_error: cut
                .filter(|_| least > 1e-12)
                .map(|cut| cut.square_error / least - 1.0),
            has_twin: row.is_symmetric,
            seconds,
        })
    }
}

/// The best of the parallel straight cuts at one angle.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct DirectionRecord {
    /// The exponents, in words.
    pub case: String,
    /// The angle, in words.
    pub method: String,
    /// The exponent n of the radiosity.
    pub exponent: f64,
    /// The exponent m of the irradiance.
    pub irradiance_exponent: f64,
    /// The angle between the cut and the perpendicular to the gradient.
    pub degrees: f64,
    /// The offset of the cut.
    pub offset: f64,
    /// The gain of the cut, in bits.
    pub gain: f64,
    /// The share of the gain of the best cut across the gradient.
    pub gain_share: f64,
    /// Time of the search, in seconds.
    pub seconds: f64,
}

impl From<&DirectionRow> for DirectionRecord {
    fn from(row: &DirectionRow) -> Self {
        let (n, m) = (row.patch.exponent(), row.patch.irradiance_exponent());
        let cut = &row.best.cut;
        Self {
            case: format!("n = {n}, m = {m}"),
            method: format!("{}°", cut.degrees()),
            exponent: n,
            irradiance_exponent: m,
            degrees: cut.degrees(),
            offset: cut.offset(),
            gain: row.best.gain,
            gain_share: row.share,
            seconds: row.seconds,
        }
    }
}
