//! The two best cuts beyond the powers of §4.2: other profiles of radiosity, each under three
//! readings of the irradiance.

use crate::discretize::{DiscretizeError, Irradiance, JudgedCut, Profile, ProfileCut};
use std::time::Instant;

/// One profile under one reading: both cuts, each judged by both measures.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileRow {
    /// The profile in words.
    pub case: &'static str,
    /// The reading in words.
    pub irradiance: &'static str,
    /// The cut of highest mutual information; `None` where every cut gains 0.
    pub information: Option<JudgedCut>,
    /// The cut of least mean square error.
    pub square: JudgedCut,
    /// Whether the profile is symmetric, so that each cut has a twin at 1 − l.
    pub is_symmetric: bool,
    /// Time of each cut, in seconds.
    pub seconds: [f64; 2],
}

/// The profiles, in words and as they are.
pub const PROFILES: [(&str, Profile); 20] = [
    ("l", Profile::Power { exponent: 1.0 }),
    ("l²", Profile::Power { exponent: 2.0 }),
    ("l⁴", Profile::Power { exponent: 4.0 }),
    ("1/10 + l", Profile::Ramp { offset: 0.1 }),
    ("1 + l", Profile::Ramp { offset: 1.0 }),
    ("10 + l", Profile::Ramp { offset: 10.0 }),
    ("e^l", Profile::Exponential { rate: 1.0 }),
    ("e^(3l)", Profile::Exponential { rate: 3.0 }),
    ("e^(4l)", Profile::Exponential { rate: 4.0 }),
    ("e^(16l)", Profile::Exponential { rate: 16.0 }),
    ("e^(64l)", Profile::Exponential { rate: 64.0 }),
    ("step 1 to 10 at 0.3", step(0.3)),
    ("step 1 to 10 at 0.9", step(0.9)),
    ("bump at 1, σ 0.5", bump(1.0, 0.5)),
    ("bump at 1, σ 0.1", bump(1.0, 0.1)),
    ("bump at 0.7, σ 0.2", bump(0.7, 0.2)),
    ("bump at 0.55, σ 0.05", bump(0.55, 0.05)),
    ("bump at 0.5, σ 0.5", bump(0.5, 0.5)),
    ("bump at 0.5, σ 0.2", bump(0.5, 0.2)),
    ("bump at 0.5, σ 0.05", bump(0.5, 0.05)),
];

const fn step(at: f64) -> Profile {
    let (before, after) = (1.0, 10.0);
    Profile::Step { at, before, after }
}

const fn bump(centre: f64, width: f64) -> Profile {
    Profile::Bump { centre, width }
}

/// Every profile, with irradiance proportional to radiosity, to what is left of it where half the
/// lowest radiosity is emitted (left out where that is next to nothing), and constant.
///
/// # Errors
/// [`DiscretizeError`] if a cut is not found.
pub fn profiles() -> Result<Vec<ProfileRow>, DiscretizeError> {
    let mut rows = Vec::new();
    for (case, profile) in PROFILES {
        let lowest = profile.lowest();
        let emission = 0.5 * lowest;
        let emitted = Irradiance::Reflected { emission };
        let readings = [
            ("∝ B", Some(Irradiance::Reflected { emission: 0.0 })),
            (
                "∝ B − ½ lowest B",
                (lowest > 0.1 * profile.flux(0.0, 1.0)).then_some(emitted),
            ),
            ("constant", Some(Irradiance::Constant)),
        ];
        for (irradiance, reading) in readings {
            let Some(reading) = reading else { continue };
            let patch = ProfileCut::try_new(profile, reading)?;
            let start = Instant::now();
            let information = patch.mutual_information_cut()?;
            let first = start.elapsed().as_secs_f64();
            let square = patch.mean_square_cut()?;
            let second = start.elapsed().as_secs_f64() - first;
            rows.push(ProfileRow {
                case,
                irradiance,
                information,
                square,
                is_symmetric: profile.is_symmetric(),
                seconds: [first, second],
            });
        }
    }
    Ok(rows)
}
