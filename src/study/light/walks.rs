//! The variance of random walks, by the probabilities that steer them (§3.4, §3.5).
//!
//! A cube of 150 patches, each with a reflectance and an emittance of its own. Walks are steered by
//! the form factors alone, and by the null-variance probabilities of a solution that is a share off
//! at random, from all digits right to none. The error is the standard deviation of one walk,
//! relative to the exact value: so many times less is that of the mean of so many walks, squared.

use crate::numeric::compensated_sum;
use crate::scene::{Material, Scene};
use crate::study::{Row, StudyError};
use crate::transport::walks::{Steering, Walks};
use crate::transport::{DenseExchange, RadiositySystem};
use crate::transport::{Importance, TransportError};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::time::Instant;

/// The largest relative errors of the solution that steers.
const OFF: [f64; 7] = [0.0, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.5];

/// The patch that walks gather at, and the one that is looked at.
const PATCH: usize = 77;

/// The rows of the study, of so many walks each.
///
/// # Errors
/// None that is known: the cube is built in and lit.
pub fn walk_variance(walks: u32) -> Result<Vec<Row>, StudyError> {
    let exchange = Scene::built_in("cube:5")?.exchange_areas()?;
    let count = exchange.rows();
    let mut random = ChaCha8Rng::seed_from_u64(1999);
    let drawn: Vec<[f64; 2]> = (0..count).map(|_| random.random()).collect();
    let materials: Vec<Material> = drawn
        .iter()
        .map(|[reflectance, _]| Material::try_new(0.9 * reflectance, 0.0).unwrap_or_default())
        .collect();
    let emittances: Vec<f64> = drawn.iter().map(|[_, emittance]| *emittance).collect();
    let room = RadiositySystem::of(&exchange, &materials)?;
    let radiosity = room.radiosity(&emittances)?;
    let looked_at: Vec<f64> = (0..count)
        .map(|patch| f64::from(u8::from(patch == PATCH)))
        .collect();
    let importance = room.importance(&looked_at)?;
    let response = compensated_sum(
        (0..count).map(|i| exchange.areas()[i] * emittances[i] * importance.values[i]),
    );

    let study = Study {
        walks,
        room: &room,
        emittances: &emittances,
        looked_at: &looked_at,
        exact: [radiosity.values[PATCH], response],
    };
    let plain = "steered by form factors";
    let mut rows = vec![
        study.gathering(plain, Steering::FormFactors, 1)?,
        study.shooting(plain, Steering::FormFactors, 1)?,
    ];
    for off in OFF {
        let case = format!("steered by a solution {off:e} off");
        let mut random = ChaCha8Rng::seed_from_u64(34);
        let mut flaw = || 1.0 + off * random.random_range(-1.0..=1.0);
        let values = radiosity.values.iter();
        let guess: Vec<f64> = values.map(|value| value * flaw()).collect();
        let towards = Steering::Towards(guess.as_slice());
        rows.push(study.gathering(&case, towards, 2)?);
        let mut guess = importance.clone();
        let both = guess.values.iter_mut().zip(&mut guess.reflected.values);
        for (value, reflected) in both {
            let flaw = flaw();
            *value *= flaw;
            *reflected *= flaw;
        }
        rows.push(study.shooting(&case, Steering::Towards(&guess), 2)?);
    }
    Ok(rows)
}

/// A lit room, and the exact values that gathering and shooting walks estimate.
struct Study<'r> {
    walks: u32,
    room: &'r RadiositySystem<DenseExchange<'r>>,
    emittances: &'r [f64],
    looked_at: &'r [f64],
    exact: [f64; 2],
}

impl Study<'_> {
    fn gathering(
        &self,
        case: &str,
        steering: Steering<'_, [f64]>,
        seed: u64,
    ) -> Result<Row, TransportError> {
        let start = Instant::now();
        let (room, emittances) = (self.room, self.emittances);
        let walks = room.gathering_walks(PATCH, emittances, steering, self.walks, seed)?;
        Ok(self.row(case, "gathering", self.exact[0], &walks, start))
    }

    fn shooting(
        &self,
        case: &str,
        steering: Steering<'_, Importance>,
        seed: u64,
    ) -> Result<Row, TransportError> {
        let start = Instant::now();
        let (emittances, looked_at) = (self.emittances, self.looked_at);
        let room = self.room;
        let walks = room.shooting_walks(emittances, looked_at, steering, self.walks, seed)?;
        Ok(self.row(case, "shooting", self.exact[1], &walks, start))
    }

    fn row(&self, case: &str, method: &str, value: f64, found: &Walks, start: Instant) -> Row {
        Row {
            case: case.to_owned(),
            method: method.to_owned(),
            value,
            relative_error: found.variance.sqrt() / value,
            seconds: start.elapsed().as_secs_f64() / f64::from(self.walks.max(1)),
        }
    }
}
