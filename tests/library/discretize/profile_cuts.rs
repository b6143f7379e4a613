//! The two best cuts for profiles that are no powers, against searches that share no formula with
//! them.

use crate::support::high_precision::HighPrecision;
use infoscene::discretize::{GradientCut, Irradiance, Profile, ProfileCut};
use infoscene::numeric::{Scalar, integral};
use infoscene::study::cuts::profiles::PROFILES;

const PROPORTIONAL: Irradiance = Irradiance::Reflected { emission: 0.0 };

fn patch(profile: Profile) -> ProfileCut {
    ProfileCut::try_new(profile, PROPORTIONAL).unwrap()
}

/// Powers are those of §4.2 with m = n.
#[test]
fn powers_are_cut_as_in_section_4_2() {
    for exponent in [0.1, 0.5, 1.0, 2.0, 4.0, 60.0] {
        let cut = GradientCut::try_new(exponent, exponent).unwrap();
        let patch = patch(Profile::Power { exponent });
        let information = patch.mutual_information_cut().unwrap().unwrap();
        let known = cut.mutual_information_cut().unwrap();
        assert!(
            (information.position - known.position).abs() < 1e-10,
            "{exponent}"
        );
        assert!((information.gain / known.value - 1.0).abs() < 1e-10);
        let (square, known) = (
            patch.mean_square_cut().unwrap(),
            cut.mean_square_cut().unwrap(),
        );
        assert!(
            (square.position - known.position).abs() < 1e-10,
            "{exponent}"
        );
        let variance = (exponent / (exponent + 1.0)).powi(2) / (2.0 * exponent + 1.0);
        assert!((square.square_error * variance / known.value - 1.0).abs() < 1e-8);
    }
}

/// Flux and square flux of parts against quadrature.
#[test]
fn parts_of_profiles_agree_with_quadrature() {
    for (case, profile) in PROFILES {
        for (from, to) in [
            (0.0, 0.1),
            (0.0, 0.95),
            (0.25, 0.27),
            (0.4, 1.0),
            (0.95, 1.0),
        ] {
            let jump = profile.jump().unwrap_or(from).clamp(from, to);
            for power in [1, 2] {
                let value = |l: f64| profile.radiosity(l).powi(power);
                let scale = 1e-13 * value(from).max(value(to)).max(value(0.5 * (from + to)));
                let pieces = [(from, jump), (jump, to)]
                    .into_iter()
                    .filter(|(a, b)| b > a);
                let exact: f64 = pieces
                    .map(|ends| integral(value, ends, scale).unwrap().value)
                    .sum();
                let part = match power {
                    1 => profile.flux(from, to),
                    _ => profile.square_flux(from, to),
                };
                assert!(
                    (part / exact - 1.0).abs() < 1e-11,
                    "{case} {from} {to} {power}"
                );
            }
        }
    }
}

/// Both objectives on 20,000 cuts, their integrals by Simpson's rule on the same grid: nothing lies
/// higher than what was found.
#[test]
fn no_cut_on_a_fine_grid_is_better() {
    const STEPS: usize = 20_000;
    #[expect(clippy::cast_precision_loss, reason = "fewer than 2^53")]
    let at = |k: usize| k as f64 / STEPS as f64;
    for (case, profile) in PROFILES {
        let patch = patch(profile);
        let mut sums = vec![[0.0; 2]];
        for k in 0..STEPS {
            // the value just inside either end, for the jumps lie on the grid
            let nudge = 1e-9 / 20_000.0;
            let points = [at(k) + nudge, 0.5 * (at(k) + at(k + 1)), at(k + 1) - nudge]
                .map(|l| profile.radiosity(l));
            let simpson = |power: i32| {
                let [a, b, c] = points.map(|radiosity| radiosity.powi(power));
                (a + 4.0 * b + c) / (6.0 * 20_000.0)
            };
            let last: [f64; 2] = sums[k];
            sums.push([last[0] + simpson(1), last[1] + simpson(2)]);
        }
        let total = sums[STEPS];
        let (mut gain, mut explained) = ((0.0, 0.0), (0.0, 0.0));
        for (k, near) in sums.iter().enumerate().take(STEPS).skip(1) {
            let (l, [g, w]) = (at(k), [near[0] / total[0], near[1] / total[1]]);
            let term = |p: f64, q: f64| {
                if p > 0.0 && q > 0.0 {
                    p * (p / q).log2()
                } else {
                    0.0
                }
            };
            gain = max(gain, (term(g, w) + term(1.0 - g, 1.0 - w), l));
            let means = [near[0] / l, (total[0] - near[0]) / (1.0 - l)];
            explained = max(
                explained,
                (l * (1.0 - l) * (means[0] - means[1]).powi(2), l),
            );
        }
        let left = 1.0 - explained.0 / (total[1] - total[0] * total[0]);
        let found = patch.mutual_information_cut().unwrap().unwrap();
        // beyond 1e-9: Simpson's error, and for bumps that of g log(g/w) where both are small
        assert!(found.gain >= gain.0 - 1e-9, "{case}: {found:?} {gain:?}");
        assert!(
            found.gain <= gain.0 * (1.0 + 1e-6) + 1e-9,
            "{case}: {found:?} {gain:?}"
        );
        let near = |position: f64, l: f64| {
            let twin = if profile.is_symmetric() { 1.0 - l } else { l };
            (position - l).abs().min((position - twin).abs()) < 2e-4
        };
        assert!(near(found.position, gain.1), "{case}: {found:?} {gain:?}");
        let square = patch.mean_square_cut().unwrap();
        assert!(
            square.square_error <= left + 1e-9,
            "{case}: {square:?} {left}"
        );
        assert!(
            near(square.position, explained.1),
            "{case}: {square:?} {explained:?}"
        );
    }
}

fn max(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if b.0 > a.0 { b } else { a }
}

/// The profile e^(kl): both conditions at 256 bits, written out plainly, change their sign within
/// 1e-10 of what is found.
#[test]
fn profile_cuts_agree_with_256_bits() {
    for rate in [0.01, 0.1, 1.0, 4.0, 16.0, 100.0, -4.0] {
        let patch = patch(Profile::Exponential { rate });
        let number = HighPrecision::new;
        let one = number(1.0);
        let total = |k: f64| (number(k).exp() - &one) / &number(k);
        let before =
            |k: f64, l: &HighPrecision| ((l.clone() * &number(k)).exp() - &one) / &number(k);
        // G′ ln(a/b) − W′ (a − b)
        let information = |l: &HighPrecision| {
            let radiosity = (l.clone() * &number(rate)).exp();
            let (all, weights) = (total(rate), total(2.0 * rate));
            let flux = before(rate, l) / &all;
            let weight = before(2.0 * rate, l) / &weights;
            let a = flux.clone() / &weight;
            let b = (one.clone() - &flux) / &(one.clone() - &weight);
            let rise = (a.clone() / &b).ln() * &radiosity / &all;
            rise - &((a - &b) * &(radiosity.clone() * &radiosity / &weights))
        };
        // m₁ + m₂ − 2B, which has the sign of the slope where radiosity rises
        let square = |l: &HighPrecision| {
            let flux = before(rate, l);
            let means = flux.clone() / l + &((total(rate) - &flux) / &(one.clone() - l));
            let left = means - &((l.clone() * &number(rate)).exp() * &number(2.0));
            if rate > 0.0 { left } else { -left }
        };
        let found = patch.mutual_information_cut().unwrap().unwrap().position;
        let sides = [found - 1e-10, found + 1e-10].map(|l| information(&number(l)).to_f64());
        assert!(
            sides[0] > 0.0 && sides[1] < 0.0,
            "{rate}: {found} {sides:?}"
        );
        let found = patch.mean_square_cut().unwrap().position;
        let sides = [found - 1e-10, found + 1e-10].map(|l| square(&number(l)).to_f64());
        assert!(
            sides[0] > 0.0 && sides[1] < 0.0,
            "{rate}: {found} {sides:?}"
        );
    }
}

/// A step is cut where it is, by both; a profile with one level would leave nothing to cut, and is
/// refused.
#[test]
fn steps_are_cut_at_the_step() {
    for at in [0.1, 0.3, 0.9] {
        let patch = patch(Profile::Step {
            at,
            before: 2.0,
            after: 0.5,
        });
        let [information, square] = [
            patch.mutual_information_cut().unwrap().unwrap(),
            patch.mean_square_cut().unwrap(),
        ];
        assert_eq!([information.position, square.position], [at, at]);
        assert!(square.square_error < 1e-14);
    }
}

/// A constant irradiance makes weights proportional to fluxes: no cut gains anything.
#[test]
fn constant_irradiance_gains_nothing() {
    for (case, profile) in PROFILES {
        let patch = ProfileCut::try_new(profile, Irradiance::Constant).unwrap();
        assert!(patch.mutual_information_cut().unwrap().is_none());
        for l in [0.1, 0.5, 0.77] {
            assert_eq!(patch.judged(l).unwrap().gain, 0.0, "{case}");
        }
        // the control: the irradiance that goes with it does gain
        let patch = ProfileCut::try_new(profile, PROPORTIONAL).unwrap();
        assert!(
            patch.judged(0.5).unwrap().gain > 0.0 || profile.is_symmetric(),
            "{case}"
        );
    }
}

/// Mutual information knows flux and weight, not lengths: a bump whose tails are dark is cut alike
/// wherever it lies, on either side. The mean square sees how much dark is left on each side, and
/// is far off: a third of the gain is lost there.
#[test]
fn mutual_information_moves_with_a_narrow_bump_and_mean_square_does_not() {
    let width = 0.05;
    let cuts = [0.45, 0.5, 0.6].map(|centre| {
        let patch = patch(Profile::Bump { centre, width });
        let information = patch.mutual_information_cut().unwrap().unwrap();
        let square = patch.mean_square_cut().unwrap();
        assert!(square.gain < 0.75 * information.gain);
        let mirrored = patch.judged(2.0 * centre - information.position).unwrap();
        assert!((mirrored.gain / information.gain - 1.0).abs() < 1e-9);
        [information, square].map(|cut| (cut.position - centre).abs() / width)
    });
    for [information, square] in cuts {
        assert!((information - cuts[0][0]).abs() < 1e-6, "{cuts:?}");
        assert!(square - information > 0.5, "{cuts:?}");
    }
    assert!(cuts[1][1] - cuts[2][1] > 0.05, "{cuts:?}");
}

/// The findings about e^(3l) and e^(4l), and that nothing monotone in the study lies farther apart.
#[test]
fn monotone_profiles_differ_as_the_findings_say() {
    for (case, profile) in PROFILES {
        if matches!(profile, Profile::Bump { centre, .. } if centre < 1.0) {
            continue;
        }
        let patch = patch(profile);
        let information = patch.mutual_information_cut().unwrap().unwrap();
        let square = patch.mean_square_cut().unwrap();
        let apart = square.position - information.position;
        assert!((0.0..0.074).contains(&apart), "{case} {apart}");
        let (kept, excess) = (
            square.gain / information.gain,
            information.square_error - square.square_error,
        );
        assert!(
            kept > 0.9639 && excess < 0.12 * square.square_error + 1e-12,
            "{case} {kept} {excess}"
        );
        assert_eq!(apart > 0.07, case == "e^(3l)", "{case} {apart}");
        let emission = 0.5 * profile.lowest();
        if profile.jump().is_none() && emission > 0.05 * profile.flux(0.0, 1.0) {
            let emitting = ProfileCut::try_new(profile, Irradiance::Reflected { emission });
            let cut = emitting.unwrap().mutual_information_cut().unwrap().unwrap();
            let apart = square.position - cut.position;
            assert!(apart < 0.0935, "{case} {apart}");
            assert_eq!(apart > 0.0925, case == "e^(3l)", "{case} {apart}");
        }
        assert_eq!(kept < 0.9641, case == "e^(4l)", "{case} {kept}");
    }
}

#[test]
fn profiles_out_of_range_are_refused() {
    let refused = |profile| ProfileCut::try_new(profile, PROPORTIONAL).is_err();
    assert!(
        refused(Profile::Power { exponent: 0.0 }) && refused(Profile::Power { exponent: f64::NAN })
    );
    assert!(
        refused(Profile::Exponential { rate: 0.0 })
            && refused(Profile::Exponential { rate: 101.0 })
    );
    assert!(
        refused(Profile::Ramp { offset: -0.1 })
            && refused(Profile::Bump {
                centre: 0.5,
                width: 0.01
            })
    );
    assert!(refused(Profile::Step {
        at: 1.0,
        before: 1.0,
        after: 2.0
    }));
    assert!(refused(Profile::Step {
        at: 0.5,
        before: 2.0,
        after: 2.0
    }));
    let ramp = Profile::Ramp { offset: 1.0 };
    for emission in [-0.1, 1.1, f64::NAN] {
        assert!(ProfileCut::try_new(ramp, Irradiance::Reflected { emission }).is_err());
    }
    assert!(ProfileCut::try_new(ramp, Irradiance::Reflected { emission: 1.0 }).is_ok());
    let step = Profile::Step {
        at: 0.5,
        before: 1.0,
        after: 2.0,
    };
    assert!(ProfileCut::try_new(step, Irradiance::Reflected { emission: 1.0 }).is_err());
    for l in [0.0, 1.0, f64::NAN] {
        assert!(patch(ramp).judged(l).is_err());
    }
}
