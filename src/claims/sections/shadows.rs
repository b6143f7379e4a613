//! Fig. 1 and appendix B in general position: lit parts whose form factors vary, screens that stand
//! on a patch or hang over it in any direction, penumbrae, a plate of finite size.

use crate::chain::random::seeded::RandomChains;
use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::{
    CutMeasure, DiscontinuityLine, HalfPlaneShadow, LineKind, OccludedPair, PatchSplit, View,
};
use crate::geometry::{Patch, SplitAxis};
use crate::information::divergence;
use crate::numeric::{Certificate, Interval, Scalar, larger, smaller, tolerance};
use crate::scene::{NamedPatch, Occlusion, Scene};
use glam::DVec3;

/// A part of the lit part, of any shape, against the whole of it, for lit form factors that vary
/// by up to ρ = `spread` · 3/(2 + d), d the lit share of the patch, and no penumbra.
///
/// A part with the share τ of the lit area has a share s of the flux, and the gain is convex in s:
/// the extremes stand for all form factors, ρ on the part and 1 on the rest, or 1 and ρ. With
/// σ = 1 − τ and e = 1/d − 1, the gain of the whole less that of the part is, in nats per flux,
///
/// ```text
///   f = (1 − s) ln((σ + e)/(1 − s)) − s ln(s/τ)
///   bright  s = ρτ/N, N = 1 + (ρ − 1)τ:   N f/σ ≥ ln N + ln(1 + e/σ) − ρ(ρ − 1)τ/N
///                                              ≥ ln(1/d) − (ρ − 1)
///   dim     s = τ/M,  M = 1 + (ρ − 1)σ:   M f = τ ln M + ρσ [ln M + ln(1 + e/σ) − ln ρ]
///                                              ≥ ρσ [ln(1/d) − ln ρ]
/// ```
///
/// as ln(ρ/N) ≤ (ρ − 1)σ/N, τ/N ≤ 1/ρ and σ ≤ 1. So `q = (ρ − 1)/ln(1/d) < 1` is enough, since
/// ln ρ ≤ ρ − 1. For `spread ≤ 1`
///
/// ```text
///   q ≤ L/(2 + d),   L = (1 − d)/ln(1/d) the logarithmic mean of d and 1, which grows with d
/// ```
///
/// is enclosed on boxes of d. For a larger spread the worst of many parts may be a counterexample.
pub(crate) fn discontinuity_beats_lit_cuts_nearly(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let spread = case.number("spread")?;
    let boxes = case.count("boxes")?;
    let (ratio, [share, part, line]) = worst_lit_part(spread);
    let found = format!("the highest gain found of a part, relative to the line's, is {ratio:.3}");
    let one = Interval::precise(1.0, case.bits());
    if spread <= 1.0 {
        let count = one.constant(f64::from(boxes));
        let mut bound = one.zero();
        for k in 0..boxes {
            let from = one.constant(f64::from(k)) / &count;
            let to = one.constant(f64::from(k + 1)) / &count;
            let mean = if k + 1 == boxes {
                one.clone()
            } else {
                (to.clone() - &one) / &to.ln()
            };
            bound = bound.larger_of(&(mean / &(from + &one.constant(2.0))));
        }
        let note = format!("it leaves room everywhere: {found}");
        return Ok(Finding::decided(bound < one, false, bound).noting(note));
    }
    // D(s, 1 − s ‖ t, 1 − t)/ln(1/d)
    let [share, part, line] = [share, part, line].map(|number| one.constant(number));
    let nats = |flux: &Interval, area: &Interval| (flux.clone() / area).ln() * flux;
    let rest = nats(&(one.clone() - &share), &(one.clone() - &part));
    let ratio = (nats(&share, &part) + &rest) / &-line.ln();
    Ok(Finding::decided(false, ratio > one, ratio).noting(found))
}

/// The highest gain of a part of the lit part relative to that of the line, with its share of the
/// flux, its share of the patch and the lit share.
fn worst_lit_part(spread: f64) -> (f64, [f64; 3]) {
    let gain = |share: f64, t: f64| divergence(&[share, 1.0 - share], &[t, 1.0 - t]);
    let mut worst = (0.0, [0.5; 3]);
    for k in 1..40 {
        let line = f64::from(k) / 40.0;
        let most = spread * 3.0 / (2.0 + line);
        for j in 1..50 {
            let t = f64::from(j) / 50.0;
            let (inner, rest) = (t * line, (1.0 - t) * line);
            let bright = most * inner / (most * inner + rest);
            let dim = inner / (inner + most * rest);
            for share in [bright, dim] {
                let ratio = gain(share, inner) / gain(1.0, line);
                if ratio > worst.0 {
                    worst = (ratio, [share, inner, line]);
                }
            }
        }
    }
    worst
}

/// A source of numbers from 0 to 1, and of scenes with a unit floor.
struct RandomScenes(RandomChains);

/// The reach of a screen that stands for an infinite one.
const FAR: f64 = 20.0;

impl RandomScenes {
    fn new(case: &Case<'_>) -> Result<Self, ClaimError> {
        Ok(Self(RandomChains::new(case.count("seed")?.into())))
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.0.numbers(1).first().copied().unwrap_or(0.5)
    }

    /// A direction in the floor's plane, and what is left of it.
    fn directions(&mut self) -> [DVec3; 2] {
        let angle = self.between(0.0, std::f64::consts::TAU);
        let along = DVec3::new(angle.cos(), angle.sin(), 0.0);
        [along, DVec3::Z.cross(along)]
    }

    /// A screen that stands on the floor along a line, and a square wall parallel to it: the floor
    /// sees all of the wall before the line, and nothing beyond.
    fn standing_screen(&mut self) -> Result<Scene, ClaimError> {
        let [along, left] = self.directions();
        let foot = DVec3::new(self.between(0.05, 0.95), self.between(0.05, 0.95), 0.0);
        // beyond the floor, more often near than far
        let apart = 1.42 + 12.0 * self.between(0.0, 1.0).powi(2);
        let aside = self.between(-0.5, 0.5) * along + apart * left;
        let corner = foot + aside - 0.5 * along + self.between(0.0, 2.0) * DVec3::Z;
        let wall = vec![
            corner,
            corner + along,
            corner + along + DVec3::Z,
            corner + DVec3::Z,
        ];
        let [start, end] = [foot - FAR * along, foot + FAR * along];
        let up = FAR * DVec3::Z;
        scene(wall, vec![start, end, end + up, start + up])
    }

    /// A half-plane with an edge in any direction, nearly level, between floor and ceiling.
    fn hanging_screen(&mut self) -> Result<Scene, ClaimError> {
        let [along, left] = self.directions();
        let at = DVec3::new(self.between(0.3, 0.7), self.between(0.3, 0.7), 0.0);
        let at = at + self.between(0.1, 0.4) * DVec3::Z;
        let edge = FAR * (along + self.between(-0.02, 0.02) * DVec3::Z);
        let aside = FAR * left;
        let screen = vec![at - edge, at + edge, at + edge + aside, at - edge + aside];
        let ceiling = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        let ceiling = ceiling.map(|(x, y)| DVec3::new(x, y, 1.0));
        scene(ceiling.to_vec(), screen)
    }
}

/// A unit floor, a source and a screen that only obstructs.
fn scene(source: Vec<DVec3>, screen: Vec<DVec3>) -> Result<Scene, ClaimError> {
    let floor = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    let named = |name: &str, corners| -> Result<_, ClaimError> {
        Ok(NamedPatch::new(name.to_owned(), Patch::try_new(corners)?))
    };
    let scene = Scene::try_new(vec![named("floor", floor)?, named("source", source)?])?;
    Ok(scene.with_obstructions(vec![named("screen", screen)?]))
}

/// The cuts parallel to a line of discontinuity, and the position of that along it.
fn cuts_beside(scene: &Scene, line: &DiscontinuityLine) -> Result<(PatchSplit, f64), ClaimError> {
    let [start, end] = line.ends;
    let split = PatchSplit::parallel_to(scene, 0, &[1], end - start, Occlusion::Exact)?;
    let position = split.position_of(0.5 * (start + end));
    Ok((split, position))
}

/// The place at a share of the way from an end of the floor, the left or the right one, to a cut.
fn on_the_way(position: f64, is_left: bool, share: f64) -> f64 {
    if is_left {
        share * position
    } else {
        1.0 - share * (1.0 - position)
    }
}

/// Screens that stand on the floor: the gain of cuts through the lit part against that of the cut
/// at `candidate` of the way to the line, where the lit form factors vary by at most 3/(2 + d).
pub(crate) fn standing_screens_cut_along_their_line(
    case: &Case<'_>,
) -> Result<Finding, ClaimError> {
    let mut random = RandomScenes::new(case)?;
    let (count, candidate) = (case.count("scenes")?, case.number("candidate")?);
    let (mut meeting, mut others, mut best_of_others) = (0, 0, 0);
    let mut largest: f64 = 0.0;
    for _ in 0..count {
        let scene = random.standing_screen()?;
        let pair = OccludedPair::of(&scene, [0, 1], Occlusion::Exact)?;
        let lines = pair.lines()?;
        let mut sharp = lines.iter().filter(|line| line.kind() == LineKind::Sharp);
        let Some(line) = sharp.next() else {
            continue; // the screen misses what the floor sees of the wall
        };
        let (split, position) = cuts_beside(&scene, line)?;
        // lit on the left, where positions begin, or on the right
        let is_left = line.sides[0] == View::Lit;
        let at = |share: f64| on_the_way(position, is_left, share);
        let own = split.gain(&[at(candidate)])?;
        let mut ratio: f64 = 0.0;
        for k in 1..16 {
            ratio = larger(ratio, split.gain(&[at(f64::from(k) / 16.0)])? / own);
        }
        let before = split.share_before(position);
        let lit = if is_left { before } else { 1.0 - before };
        if spread_of_lit_part(&pair)? <= 3.0 / (2.0 + lit) {
            meeting += 1;
            largest = larger(largest, ratio);
        } else {
            others += 1;
            best_of_others += i32::from(ratio < 1.0);
        }
    }
    let holds = largest < 1.0 && meeting > 0;
    let note = format!(
        "{meeting} screens meet the condition; of {others} others the line is best for \
         {best_of_others}"
    );
    Ok(Finding::statement(holds, largest, tolerance::OCCLUDED_GAIN)
        .sampled()
        .noting(note))
}

/// The largest form factor over the least, at points of the floor that see all of the source.
fn spread_of_lit_part(pair: &OccludedPair) -> Result<f64, ClaimError> {
    let (mut least, mut most) = (f64::INFINITY, 0.0);
    for i in 0..=12 {
        for j in 0..=12 {
            let inside = |k: i32| 1e-6 + (1.0 - 2e-6) * f64::from(k) / 12.0;
            let point = DVec3::new(inside(i), inside(j), 0.0);
            let seen = pair.seen_from(point)?.value;
            if seen > 0.0 {
                (least, most) = (smaller(least, seen), larger(most, seen));
            }
        }
    }
    Ok(most / least)
}

/// Screens that hang over the floor: cuts beyond an umbra line that leave one part totally dark,
/// against that at `candidate` of the way from the floor's end to the line.
pub(crate) fn hanging_screens_darken_most_at_the_umbra(
    case: &Case<'_>,
) -> Result<Finding, ClaimError> {
    let mut random = RandomScenes::new(case)?;
    let candidate = case.number("candidate")?;
    let (mut lines, mut largest): (u32, f64) = (0, 0.0);
    for _ in 0..case.count("scenes")? {
        let scene = random.hanging_screen()?;
        let pair = OccludedPair::of(&scene, [0, 1], Occlusion::Exact)?;
        let found = pair.lines()?;
        for line in found.iter().filter(|line| line.kind() == LineKind::Umbra) {
            let (split, position) = cuts_beside(&scene, line)?;
            let is_left = line.sides[0] == View::Dark;
            let dark = if is_left {
                [0.0, position]
            } else {
                [position, 1.0]
            };
            // past its end a line may leave a part that is not dark
            let parts = split.parts();
            if parts.flux(0, &dark)? > DARK * parts.whole_flux(0)? {
                continue;
            }
            let at = |share: f64| on_the_way(position, is_left, share);
            let own = split.gain(&[at(candidate)])?;
            for k in 1..8 {
                largest = larger(largest, split.gain(&[at(f64::from(k) / 8.0)])? / own);
            }
            lines += 1;
        }
    }
    let holds = largest < 1.0 && lines > 0;
    let note = format!("{lines} umbra lines part a dark part from the rest of the floor");
    Ok(Finding::statement(holds, largest, tolerance::OCCLUDED_GAIN)
        .sampled()
        .noting(note))
}

/// The share of the flux that rounding may leave in the dark.
const DARK: f64 = 1e-12;

/// Parallel unit squares at distance 1 and a half-plane x > `edge` at `height`: the gain along the
/// better of the umbra line and the lit line, as a share of that of the best cut in between; does
/// it stay below `most`?
pub(crate) fn penumbra_cuts_beat_both_lines(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let shadow = HalfPlaneShadow::try_new(case.number("edge")?, case.number("height")?)?;
    let most = case.interval("most")?;
    let [information, square] = CutMeasure::ALL;
    let best = shadow.certified_cut(information, case.bits())?;
    let least = shadow.certified_cut(square, case.bits())?;
    let gains = shadow.gains_on_lines(information, &most);
    let kept = gains.map(|gain| gain / &best.value);
    let [lit, umbra] = kept.each_ref().map(|share| 100.0 * share.to_f64());
    let note = format!(
        "the cut of highest mutual information is at {:.6}, that of least square error at {:.6}; \
         the umbra line, at {:.4}, keeps {umbra:.1} % of the gain, the lit line, at {:.4}, \
         {lit:.1} %",
        best.position.to_f64(),
        least.position.to_f64(),
        shadow.umbra_line(&1.0),
        shadow.lit_line(&1.0)
    );
    let [lit, umbra] = kept;
    let share = lit.larger_of(&umbra);
    // a cut that gains more than both lines is a counterexample, whether it is the best or not
    let is_best = matches!(best.certificate, Certificate::Unique { .. });
    Ok(Finding::decided(share < most, share > most && is_best, share).noting(note))
}

/// Parallel unit squares at distance 1 and a plate [0.3, 0.62] × [0.25, 0.55] at `height`: the
/// largest share of the highest gain of a parallel cut that a cut along a line of discontinuity
/// keeps; does it stay below `most`?
pub(crate) fn plate_is_best_cut_beside_its_lines(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let height = case.number("height")?;
    let plate = [(0.3, 0.25), (0.62, 0.25), (0.62, 0.55), (0.3, 0.55)];
    let plate = plate.map(|(x, y)| DVec3::new(x, y, height));
    let ceiling = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
    let ceiling = ceiling.map(|(x, y)| DVec3::new(x, y, 1.0));
    let scene = scene(ceiling.to_vec(), plate.to_vec())?;
    let lines = OccludedPair::of(&scene, [0, 1], Occlusion::Exact)?.lines()?;
    let mut shares: Vec<f64> = Vec::new();
    let mut told = Vec::new();
    for axis in SplitAxis::ALL {
        let split = PatchSplit::try_new(&scene, 0, &[1], axis)?;
        let best = split.best_cut(CutMeasure::Information)?;
        let highest = split.gain(&[best])?;
        let along = lines
            .iter()
            .map(|line| line.ends.map(|end| split.position_of(end)));
        for [from, to] in along {
            if (from - to).abs() < tolerance::OCCLUDED_POSITION {
                shares.push(split.gain(&[from])? / highest);
            }
        }
        told.push(format!("across {} at {best:.5}", axis.name()));
    }
    let largest = shares.iter().copied().fold(0.0, f64::max);
    let all = shares.len() == lines.len() && !lines.is_empty();
    let note = format!(
        "the best cuts are {}; {} lines keep from {:.1} to {:.1} %",
        told.join(" and "),
        shares.len(),
        100.0 * shares.iter().copied().fold(f64::INFINITY, f64::min),
        100.0 * largest
    );
    let holds = all && largest < case.number("most")?;
    Ok(Finding::statement(holds, largest, tolerance::OCCLUDED_GAIN).noting(note))
}
