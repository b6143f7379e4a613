//! The page of findings: statements that do not hold as printed, and the reach of §4.2.
//!
//! The text is a template, `templates/findings.md`; every number in it is computed here and rounded
//! to decimals that its error leaves certain. A number that the template lacks, a place without a
//! number, and a sentence that the numbers no longer bear out are errors.
//!
//! **Not here**: proofs, which the page cites.

use super::findings_profiles::profile_cuts;
use super::findings_refinement::refinement;
use crate::claims::{ClaimError, Judgement, Printed};
use crate::discretize::{
    BestGrid, BoxGrid, ContactShadow, CutMeasure, GradientCut, GradientLimit, HalfPlaneShadow,
    UNIT_CUBE,
};
use crate::numeric::{Bounded, Interval, Scalar, larger, largest, smaller};
use crate::report::render::page::{PageError, Texts};
use crate::study::Row;
use crate::study::gain::stability::gain_stability;
use crate::study::lines::figure_5::SAMPLES;

const TEMPLATE: &str = include_str!("../../templates/findings.md");

/// Claims of which the page says one verdict.
const TOGETHER: [&[&str]; 4] = [
    &["fig5-optimal", "fig5-bad"],
    &["eq6-sum-is-a-maximum", "eq7-total-is-a-maximum"],
    &[
        "s42-highest-information-cut-2",
        "s42-highest-information-cut-3",
        "s42-highest-information-cut-4",
        "s42-objective",
    ],
    &[
        "s3-most-precise-has-highest-information",
        "s1-optimum-is-highest-information",
        "s1-optimum-has-least-error",
    ],
];

/// Bits of the enclosures: far more than the digits shown.
const BITS: u32 = 128;
/// Absolute error of sums of some ten thousand terms, with a margin of a thousand.
const SUMMED: f64 = 1e-9;
/// The page in Markdown, from the judgements of all claims.
///
/// # Errors
/// [`PageError`] if a claim is missing, a computation fails, a number is not certain to the
/// decimals shown, or a sentence no longer holds.
pub fn findings_page(judgements: &[Judgement]) -> Result<String, PageError> {
    let claims = Claims(judgements);
    let mut texts = Texts::default();
    verdicts(&claims, &mut texts)?;
    light(&claims, &mut texts)?;
    cuts(&mut texts)?;
    gains(&claims, &mut texts)?;
    figure_5(&claims, &mut texts)?;
    let limit = ContactShadow::limit_of_the_discontinuity_line()?;
    texts.number("shadow_limit", Bounded::estimate(limit, 1e-6), 3)?;
    penumbrae(&claims, &mut texts)?;
    limits(&mut texts)?;
    profile_cuts(&mut texts)?;
    refinement(judgements, &mut texts)?;
    texts.filled(TEMPLATE)
}

/// Judgements by id.
struct Claims<'j>(&'j [Judgement]);

impl<'j> Claims<'j> {
    fn named(&self, id: &str) -> Result<&'j Judgement, ClaimError> {
        let found = self.0.iter().find(|judgement| judgement.claim.id == id);
        found.ok_or_else(|| ClaimError::UnknownClaim {
            id: id.to_owned(),
            nearest: None,
        })
    }

    fn verdict(&self, id: &str) -> Result<String, ClaimError> {
        Ok(self.named(id)?.verdict.name().replace('_', " "))
    }

    fn printed(&self, id: &str) -> Result<&'j Printed, PageError> {
        let printed = self.named(id)?.claim.printed.as_ref();
        printed.ok_or_else(|| PageError::without("a printed number", id))
    }

    fn enclosure(&self, id: &str) -> Result<&'j Interval, PageError> {
        let finding = self.named(id)?.finding.as_ref();
        let enclosure = finding.and_then(|finding| finding.enclosure.as_ref());
        enclosure.ok_or_else(|| PageError::without("an enclosure", id))
    }
}

fn verdicts(claims: &Claims<'_>, texts: &mut Texts) -> Result<(), PageError> {
    for (name, id) in [
        ("below_verdict", "s2-discrete-below-continuous"),
        ("transitions_verdict", "s34-discrete-transitions"),
        ("objective_verdict", "s42-objective"),
        ("weights_verdict", "s34-weights-without-total"),
        ("unstable_verdict", "s5-unstable-logarithms"),
        ("figure_5_verdict", "fig5-regular"),
        ("figure_5_others", "fig5-optimal"),
        ("maximum_verdict", "eq6-sum-is-a-maximum"),
        ("nearly_verdict", "fig1-lit-part-nearly"),
        ("precise_verdict", "s3-most-precise-has-highest-information"),
        ("potential_verdict", "s5-step-2-highest-potential"),
    ] {
        texts.text(name, claims.verdict(id)?);
    }
    for ids in TOGETHER {
        for pair in ids.windows(2) {
            let [first, second] = [claims.verdict(pair[0])?, claims.verdict(pair[1])?];
            PageError::unless(first == second, "claims named together have one verdict")?;
        }
    }
    Ok(())
}

/// §3.4: the row sums `R F B_i/(B_i − E_i)` of two patches that see each other.
fn light(claims: &Claims<'_>, texts: &mut Texts) -> Result<(), PageError> {
    let excess = claims.enclosure("s34-discrete-transitions")?;
    let first = excess.constant(1.0) + excess;
    texts.enclosed("first_row", &first, 0)?;
    let reflectance = excess.constant(0.5);
    // B_1 = 1/(1 − R²), B_2 = R B_1, E_2 = 0
    let one = excess.constant(1.0);
    let second = reflectance.clone() / &(one - &reflectance.square()) * &reflectance;
    let row = reflectance * &second / &second;
    texts.enclosed("second_row", &row, 1)
}

/// §4.2: both readings and the mean-square cuts, enclosed.
fn cuts(texts: &mut Texts) -> Result<(), PageError> {
    let mut lines = String::new();
    for n in 1..=4u32 {
        let exponent = f64::from(n);
        let printed = GradientCut::try_new(exponent, 1.0)?;
        let derived = GradientCut::try_new(exponent, exponent)?;
        let square = printed.certified_mean_square_cut(BITS)?.position;
        let positions = [
            printed.certified_mutual_information_cut(BITS)?.position,
            derived.certified_mutual_information_cut(BITS)?.position,
        ];
        let [far, near] = positions.each_ref().map(|cut| (square.clone() - cut).abs());
        PageError::unless(n == 1 || near < far, "the derived cuts are nearer")?;
        let [printed, derived] = positions;
        let shown = [printed, derived, square].map(|cut| Texts::enclosed_text("cuts", &cut, 4));
        let [printed, derived, square] = shown;
        lines += &format!("  | {n} | {} | {} | {} |\n", printed?, derived?, square?);
    }
    texts.text("cuts", lines);
    Ok(())
}

/// App. B.2: the best cuts of a penumbra, and the share of the gain that its lines keep.
fn penumbrae(claims: &Claims<'_>, texts: &mut Texts) -> Result<(), PageError> {
    let shown = |number: &Interval, decimals| Texts::enclosed_text("penumbrae", number, decimals);
    let mut lines = String::new();
    let mut last = Interval::precise(100.0, BITS);
    for height in [0.05, 0.2, 0.35] {
        let shadow = HalfPlaneShadow::try_new(0.5, height)?;
        let like = Interval::precise(1.0, BITS);
        let [information, square] = CutMeasure::ALL;
        let best = shadow.certified_cut(information, BITS)?;
        let least = shadow.certified_cut(square, BITS)?;
        let kept = shadow.gains_on_lines(information, &like);
        let [lit, umbra] = kept.map(|gain| gain / &best.value * &like.constant(100.0));
        PageError::unless(lit < umbra, "the lit line keeps less")?;
        PageError::unless(umbra < last, "the nearer, the better the umbra line")?;
        last = umbra.clone();
        let ends = shadow.lit_line(&like) + &shadow.umbra_line(&like);
        let middle = ends / &like.constant(2.0);
        let [far, near] = [&best, &least].map(|cut| (cut.position.clone() - &middle).abs());
        PageError::unless(near < far, "the mean-square cut is nearer to the middle")?;
        lines += &format!(
            "  | {height} | {} | {} | {} | {} | {} % | {} % |\n",
            shown(&shadow.lit_line(&like), 4)?,
            shown(&shadow.umbra_line(&like), 4)?,
            shown(&best.position, 6)?,
            shown(&least.position, 6)?,
            shown(&lit, 0)?,
            shown(&umbra, 0)?
        );
    }
    texts.text("penumbrae", lines);
    let plate = claims.named("appB2-plate")?.finding.as_ref();
    let plate = plate.ok_or_else(|| PageError::without("a finding", "appB2-plate"))?;
    let kept = Bounded::estimate(100.0 * plate.quantity.number(), 1e-6);
    texts.number("plate_kept", kept, 1)
}

/// §5: the missing factor, and the digits that forms of the gain keep.
fn gains(claims: &Claims<'_>, texts: &mut Texts) -> Result<(), PageError> {
    let ratio = claims.enclosure("s34-weights-without-total")?;
    texts.enclosed("constant_ratio", ratio, 0)?;
    let reached = claims.enclosure("eq6-sum-is-a-maximum")?;
    texts.enclosed("reached", reached, 3)?;
    let excess = claims.enclosure("s3-most-precise-has-highest-information")?;
    let percent = (excess.clone() - &excess.constant(1.0)) * &excess.constant(100.0);
    texts.enclosed("precise_excess", &percent, 1)?;
    let digits = claims.enclosure("s5-printed-gain-is-unstable")?.to_f64();
    let left = if digits > 0.0 {
        format!("{digits:.0}")
    } else {
        "no".to_owned()
    };
    texts.text("printed_digits", left);
    let rows = gain_stability(0)?;
    for (name, method) in [
        ("stable_digits", "sum-of-terms"),
        ("single_digits", "sum-of-terms, single"),
    ] {
        let errors = rows.iter().filter(|row| row.method == method);
        let worst = largest(errors.map(|row: &Row| row.relative_error));
        // twice the error, so that another platform's logarithm shows no other digit
        texts.text(name, format!("{:.0}", (-(2.0 * worst).log10()).floor()));
    }
    Ok(())
}

/// Fig. 5: the regular grids about the printed value, and the reading as plug-in estimates.
fn figure_5(claims: &Claims<'_>, texts: &mut Texts) -> Result<(), PageError> {
    for (name, cells) in [("below", 7), ("above", 8)] {
        let grid = BoxGrid::regular(UNIT_CUBE, cells)?;
        let information = grid.information()?.mutual_information;
        texts.number(name, Bounded::bound(information.value, SUMMED), 4)?;
    }
    let best = BestGrid::find(UNIT_CUBE, 6)?.grid;
    let quarters = BoxGrid::try_new(UNIT_CUBE, &[0.25, 0.375, 0.5, 0.625, 0.75])?;
    let regular = BoxGrid::regular(UNIT_CUBE, 6)?;
    let (mut least, mut most): (f64, f64) = (f64::INFINITY, 0.0);
    for (names, id, grid) in [
        (["regular", "printed_regular"], "fig5-regular", regular),
        (["best", "printed_best"], "fig5-optimal", best),
        (["bad", "printed_bad"], "fig5-bad", quarters),
    ] {
        let information = grid.information()?.mutual_information.value;
        let expected = information + grid.expected_bias(SAMPLES)?;
        texts.number(names[0], Bounded::estimate(expected, SUMMED), 4)?;
        let printed = claims.printed(id)?;
        texts.text(names[1], printed.text.clone());
        let below = (expected - printed.value) / grid.expected_deviation(SAMPLES)?;
        (least, most) = (smaller(least, below), larger(most, below));
    }
    let is_one = (0.8..1.2).contains(&least) && (0.8..1.2).contains(&most);
    PageError::unless(is_one, "the printed values lie one standard deviation low")?;
    texts.text("samples", thousands(SAMPLES));
    Ok(())
}

/// A whole number with commas between thousands.
fn thousands(number: u64) -> String {
    if number < 1000 {
        return number.to_string();
    }
    format!("{},{:03}", thousands(number / 1000), number % 1000)
}

fn limits(texts: &mut Texts) -> Result<(), PageError> {
    for (cut, limit, rate) in [
        (
            GradientLimit::FixedIrradiance,
            "limit_printed",
            "rate_printed",
        ),
        (
            GradientLimit::EqualExponents,
            "limit_derived",
            "rate_derived",
        ),
        (GradientLimit::MeanSquare, "limit_square", "rate_square"),
    ] {
        let found = cut.enclosed(BITS)?;
        texts.enclosed(limit, &found.limit, 12)?;
        texts.enclosed(rate, &found.rate, 4)?;
    }
    Ok(())
}
