//! How much variance random walks have, by what steers them (§3.4, §3.5).
//!
//! A cube of 150 patches, each with a reflectance and an emittance of its own. Walks are steered by the form factors alone, and
//! by the null-variance probabilities of a solution that is a share off at random, from all digits right to none. The error is the
//! standard deviation of one walk, relative to the exact value: so many times less is that of the mean of so many walks, squared.

use super::{Row, StudyError};
use crate::numeric::compensated_sum;
use crate::scene::{Material, Scene};
use crate::transport::walks::{Steering, Walks};
use crate::transport::{RadiositySystem, TransportError};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::time::Instant;

/// How far the solution that steers is off, at most, relative to itself.
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

    let mut rows = Vec::new();
    let mut add = |case: String,
                   method: &str,
                   value: f64,
                   run: &dyn Fn() -> Result<Walks, TransportError>|
     -> Result<(), TransportError> {
        let start = Instant::now();
        let found = run()?;
        rows.push(Row {
            case,
            method: method.to_owned(),
            value,
            relative_error: found.variance.sqrt() / value,
            seconds: start.elapsed().as_secs_f64() / f64::from(walks.max(1)),
        });
        Ok(())
    };
    let exact = radiosity.values[PATCH];
    let plain = "steered by form factors".to_owned();
    add(plain.clone(), "gathering", exact, &|| {
        room.gathering_walks(PATCH, &emittances, Steering::FormFactors, walks, 1)
    })?;
    add(plain, "shooting", response, &|| {
        room.shooting_walks(&emittances, &looked_at, Steering::FormFactors, walks, 1)
    })?;
    for off in OFF {
        let case = format!("steered by a solution {off:e} off");
        let mut random = ChaCha8Rng::seed_from_u64(34);
        let mut flaw = || 1.0 + off * random.random_range(-1.0..=1.0);
        let guess: Vec<f64> = radiosity
            .values
            .iter()
            .map(|value| value * flaw())
            .collect();
        add(case.clone(), "gathering", exact, &|| {
            let towards = Steering::Towards(guess.as_slice());
            room.gathering_walks(PATCH, &emittances, towards, walks, 2)
        })?;
        let mut guess = importance.clone();
        let both = guess.values.iter_mut().zip(&mut guess.reflected.values);
        for (value, reflected) in both {
            let flaw = flaw();
            *value *= flaw;
            *reflected *= flaw;
        }
        add(case, "shooting", response, &|| {
            let towards = Steering::Towards(&guess);
            room.shooting_walks(&emittances, &looked_at, towards, walks, 2)
        })?;
    }
    Ok(rows)
}
