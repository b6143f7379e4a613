//! The curve of a claim's figure.

use super::reproduce::named_claims;
use crate::claims::{Context, judge, registry};
use crate::exchange::Progress;
use crate::question::QuestionError;

/// The question for the curve of a claim's figure.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Curve;
/// let fig_2 = Curve { claim: "fig2-curve".to_owned() }.ask(&Unheard)?;
/// let best = fig_2.points.iter().max_by(|a, b| a.y.total_cmp(&b.y));
/// // as the paper prints: the points are a hundredth apart
/// assert!(best.is_some_and(|best| (best.x - 0.40).abs() < 1e-9));
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Curve {
    /// The id of the claim.
    pub claim: String,
}

/// A curve and the labels of its axes.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct CurveAnswer {
    /// The points, as computed.
    pub points: Vec<CurvePoint>,
    /// The labels of the axes, with units.
    #[serde(skip)]
    pub axes: [String; 2],
}

/// A point of a curve.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct CurvePoint {
    /// The abscissa.
    pub x: f64,
    /// The ordinate.
    pub y: f64,
}

impl Curve {
    /// Computes the answer.
    ///
    /// # Errors
    /// [`QuestionError::Claim`] if there is no such claim or its computation fails;
    /// [`QuestionError::NoCurve`].
    pub fn ask(&self, _: &dyn Progress) -> Result<CurveAnswer, QuestionError> {
        for claim in named_claims(std::slice::from_ref(&self.claim))? {
            let Some(axes) = claim.curve_axes.clone() else {
                continue;
            };
            if let Some(finding) = judge(&claim, &Context::default())?.finding {
                let points = finding.curve.into_iter();
                return Ok(CurveAnswer {
                    points: points.map(|[x, y]| CurvePoint { x, y }).collect(),
                    axes,
                });
            }
        }
        let with_curve = registry()?.into_iter();
        let with_curve = with_curve.filter(|claim| claim.curve_axes.is_some());
        Err(QuestionError::NoCurve {
            id: self.claim.clone(),
            with_curve: with_curve.map(|claim| claim.id).collect(),
        })
    }
}
