//! The numbers of the page of findings on cuts of radiosities that are no powers.

use crate::discretize::{JudgedCut, Profile};
use crate::numeric::Bounded;
use crate::report::render::page::{PageError, Texts};
use crate::study::cuts::profiles::{PROFILES, ProfileRow, profiles};

/// Accuracy of a profile's cut, and of what is computed at it.
const CUT: f64 = 1e-9;

/// A profile's two cuts, where both exist.
struct Pair {
    case: &'static str,
    information: JudgedCut,
    square: JudgedCut,
}

impl Pair {
    fn apart(&self) -> f64 {
        (self.square.position - self.information.position).abs()
    }

    /// The share of the highest gain that the mean-square cut keeps.
    fn kept(&self) -> f64 {
        self.square.gain / self.information.gain
    }
}

/// The pair with the largest value.
fn extreme(
    pairs: impl Iterator<Item = Pair>,
    value: impl Fn(&Pair) -> f64,
) -> Result<Pair, PageError> {
    let largest = pairs.max_by(|a, b| value(a).total_cmp(&value(b)));
    largest.ok_or_else(|| PageError::without("a profile", "study profiles"))
}

/// The pairs of cuts of the wanted profiles under one reading of the irradiance.
fn pairs<'r>(
    rows: &'r [ProfileRow],
    irradiance: &'r str,
    is_wanted: fn(&Profile) -> bool,
) -> impl Iterator<Item = Pair> + 'r {
    rows.iter().filter_map(move |row| {
        let (case, profile) = PROFILES.iter().find(|(case, _)| *case == row.case)?;
        let is_row = row.irradiance == irradiance && is_wanted(profile);
        Some(Pair {
            case,
            information: row.information.filter(|_| is_row)?,
            square: row.square,
        })
    })
}

/// Adds the numbers.
pub(super) fn profile_cuts(texts: &mut Texts) -> Result<(), PageError> {
    let rows = profiles()?;
    monotone(&rows, texts)?;
    for step in pairs(&rows, PROPORTIONAL, |p| matches!(p, Profile::Step { .. })) {
        PageError::unless(step.apart() <= 0.0, "at a jump both cuts are the jump")?;
    }
    narrow_bump(&rows, texts)?;
    let mut constant = rows.iter().filter(|row| row.irradiance == "constant");
    let gains_nothing = constant.all(|row| row.information.is_none_or(|cut| cut.gain <= 0.0));
    PageError::unless(gains_nothing, "constant irradiance: no cut gains anything")
}

/// The reading in which the irradiance is proportional to the radiosity.
const PROPORTIONAL: &str = "∝ B";

fn monotone(rows: &[ProfileRow], texts: &mut Texts) -> Result<(), PageError> {
    let is_monotone = |profile: &Profile| !is_inner_bump(profile);
    for (irradiance, apart, case) in [
        (PROPORTIONAL, "monotone_apart", "monotone_case"),
        ("∝ B − ½ lowest B", "emitting_apart", "emitting_case"),
    ] {
        let farthest = extreme(pairs(rows, irradiance, is_monotone), Pair::apart)?;
        texts.number(apart, Bounded::estimate(farthest.apart(), CUT), 3)?;
        texts.text(case, farthest.case.to_owned());
    }
    let all = pairs(rows, PROPORTIONAL, is_monotone);
    let costly = extreme(all, |pair| -pair.kept())?;
    let excess = costly.information.square_error / costly.square.square_error - 1.0;
    texts.text("costly_case", costly.case.to_owned());
    for (name, value, decimals) in [
        ("costly_information", costly.information.position, 3),
        ("costly_square", costly.square.position, 3),
        ("costly_kept", 100.0 * costly.kept(), 1),
        ("costly_excess", 100.0 * excess, 0),
    ] {
        texts.number(name, Bounded::estimate(value, 100.0 * CUT), decimals)?;
    }
    Ok(())
}

fn narrow_bump(rows: &[ProfileRow], texts: &mut Texts) -> Result<(), PageError> {
    let narrow = pairs(rows, PROPORTIONAL, is_inner_bump).filter(|pair| pair.case == BUMP);
    let bump = extreme(narrow, Pair::apart)?;
    texts.text("bump_case", bump.case.to_owned());
    let sigmas = |cut: &JudgedCut| Bounded::estimate((cut.position - 0.5).abs() / 0.05, 20.0 * CUT);
    texts.number("bump_information", sigmas(&bump.information), 2)?;
    texts.number("bump_square", sigmas(&bump.square), 2)?;
    let kept = Bounded::estimate(100.0 * bump.kept(), 100.0 * CUT);
    texts.number("bump_kept", kept, 0)
}

/// The narrow bump of the page: `narrow_bump` has its centre 0.5 and width 0.05.
const BUMP: &str = "bump at 0.5, σ 0.05";

fn is_inner_bump(profile: &Profile) -> bool {
    matches!(profile, Profile::Bump { centre, .. } if *centre < 1.0)
}
