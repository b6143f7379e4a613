//! Random walks that estimate radiosity and response (§3.4, §3.5).
//!
//! A *gathering* walk starts at the patch whose radiosity is asked for and goes where light may
//! come from; a *shooting* walk starts at a source and goes where its light falls. Both go on for
//! ever: they end when the remaining weight is below 2⁻⁷⁰ of what was found.
//!
//! ```text
//!   gathering from i:  B_i = E_i + Σ_k W_k E_ik,        W ← W · R_i F_ij / P_ij
//!   shooting:          ⟨V, B⟩ = Σ_i A_i V_i B_i = Σ_k W_k V_ik,
//!                      W₀ = A_i E_i / q_i,              W ← W · F_ij R_j / P_ij
//! ```
//!
//! Steered by the solution itself, `P_ij = R_i F_ij B_j/(B_i − E_i)`, gathering has `W_k = Π_{m<k}
//! (B_m − E_m)/B_(m+1)`, and the sum telescopes to B_i *on every walk*; likewise shooting with
//! `P_ij = R_j F_ij I_j/(I_i − V_i)` and `q_i ∝ A_i E_i I_i` to `Σ A E I = ⟨V, B⟩`: no variance.
//! Steered by the form factors alone, `P = F`, they have it. Probabilities that are only nearly
//! those of the solution bring nearly no variance.
//!
//! **Not covered**: absorption by chance (Russian roulette).
//!
//! Reference: Sbert, Brusi, Tobler, Purgathofer, *Random Walk Radiosity with Generalized Transition
//! Probabilities*, report IIIA-98-07-RR, Universitat de Girona, 1998.

use super::{DenseExchange, Importance, RadiositySystem, TransportError};
use crate::numeric::compensated_sum;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::HashMap;

/// The probabilities that steer walks.
#[derive(Debug, Clone, Copy)]
pub enum Steering<'s, T: ?Sized> {
    /// The form factors alone.
    FormFactors,
    /// A solution, known or guessed.
    Towards(&'s T),
}

/// The estimate of some walks.
#[derive(Debug, Clone, PartialEq)]
pub struct Walks {
    /// The estimate.
    pub mean: f64,
    /// The variance of one walk's estimate.
    pub variance: f64,
    /// The farthest that one walk's estimate was from the mean.
    pub farthest: f64,
    /// Steps of the longest walk.
    pub longest: u32,
    /// Number of walks.
    pub walks: u32,
}

impl Walks {
    /// The standard error of the mean.
    #[must_use]
    pub fn standard_error(&self) -> f64 {
        (self.variance / f64::from(self.walks)).sqrt()
    }
}

/// Share of what was found below which the remaining weight does not count.
#[expect(clippy::cast_precision_loss, reason = "a power of two")]
const LEFT: f64 = 1.0 / (1u128 << 70) as f64;

/// A walk that is longer is cut off and refused: with reflectances up to 0.9999 none is.
const MOST_STEPS: u32 = 1_000_000;

impl RadiositySystem<DenseExchange<'_>> {
    /// The radiosity of one patch by gathering walks.
    ///
    /// **Arguments** `steering`: by the form factors, or towards radiosities, one for each patch;
    /// `seed`: the same one gives the same walks.
    ///
    /// # Errors
    /// [`TransportError::NoSuchPatch`]; [`TransportError::NoWalks`];
    /// [`TransportError::WrongCount`], [`TransportError::SourceOutOfRange`],
    /// [`TransportError::NoSource`]; [`TransportError::EndlessWalk`] where hardly any light ends.
    pub fn gathering_walks(
        &self,
        from: usize,
        emittances: &[f64],
        steering: Steering<'_, [f64]>,
        walks: u32,
        seed: u64,
    ) -> Result<Walks, TransportError> {
        self.check("emittance", "emittances", emittances)?;
        let brightness = self.steering(steering)?;
        let last = brightness.len() - 1;
        if from > last {
            return Err(TransportError::NoSuchPatch { patch: from, last });
        }
        let mut ways = Ways::new(self, &brightness);
        statistics(walks, seed, |random| {
            let reflected = |at: usize, _| self.reflectances[at];
            ways.follow([emittances, &brightness], (from, 1.0), reflected, random)
        })
    }

    /// The response `Σ_i A_i V_i B_i` by shooting walks: with `V = δ_k` the power `A_k B_k` that
    /// leaves patch k.
    ///
    /// **Arguments** `direct`: V; `steering`: by emitted power and form factors, or towards
    /// importances.
    ///
    /// # Errors
    /// As [`gathering_walks`](Self::gathering_walks).
    pub fn shooting_walks(
        &self,
        emittances: &[f64],
        direct: &[f64],
        steering: Steering<'_, Importance>,
        walks: u32,
        seed: u64,
    ) -> Result<Walks, TransportError> {
        self.check("emittance", "emittances", emittances)?;
        self.check("direct importance", "direct importances", direct)?;
        let (importance, reflected) = match steering {
            Steering::FormFactors => (vec![1.0; direct.len()], None),
            Steering::Towards(importance) => (
                importance.values.clone(),
                Some(importance.reflected.values.as_slice()),
            ),
        };
        let steered = reflected.map_or(Steering::FormFactors, Steering::Towards);
        let brightness = self.steering(steered)?;
        self.check("importance", "importances", &importance)?;
        let power = |i: usize| self.areas[i].high() * emittances[i];
        let chances: Vec<f64> = (0..importance.len())
            .map(|i| power(i) * importance[i])
            .collect();
        let starts = Cumulative::new(chances);
        let mut ways = Ways::new(self, &brightness);
        statistics(walks, seed, |random| {
            let Some(at) = starts.draw(random) else {
                return (0.0, 0);
            };
            let start = (at, starts.total() / importance[at]);
            let reflected = |_, next: usize| self.reflectances[next];
            ways.follow([direct, &importance], start, reflected, random)
        })
    }

    /// The brightness that steers.
    fn steering(&self, steering: Steering<'_, [f64]>) -> Result<Vec<f64>, TransportError> {
        match steering {
            Steering::FormFactors => Ok(vec![1.0; self.reflectances.len()]),
            Steering::Towards(brightness) => {
                self.check("brightness", "brightnesses", brightness)?;
                Ok(brightness.to_vec())
            }
        }
    }
}

/// Numbers to be drawn from, in proportion.
struct Cumulative(Vec<f64>);

impl Cumulative {
    fn new(mut chances: Vec<f64>) -> Self {
        let mut sum = 0.0;
        for chance in &mut chances {
            sum += *chance;
            *chance = sum;
        }
        Self(chances)
    }

    fn total(&self) -> f64 {
        self.0.last().copied().unwrap_or(0.0)
    }

    /// One of them; `None` if all are 0. What has no chance is never drawn.
    fn draw(&self, random: &mut ChaCha8Rng) -> Option<usize> {
        let at = random.random::<f64>() * self.total();
        let place = self.0.partition_point(|sum| *sum <= at);
        (place < self.0.len()).then_some(place)
    }
}

/// The transitions of walks, row by row as they are needed.
struct Ways<'w, 'e> {
    room: &'w RadiositySystem<DenseExchange<'e>>,
    brightness: &'w [f64],
    rows: HashMap<usize, Cumulative>,
}

impl<'w, 'e> Ways<'w, 'e> {
    fn new(room: &'w RadiositySystem<DenseExchange<'e>>, brightness: &'w [f64]) -> Self {
        let rows = HashMap::new();
        Self {
            room,
            brightness,
            rows,
        }
    }

    /// A walk from a patch with a weight, until the rest does not count: what it finds, and its
    /// steps.
    ///
    /// **Arguments** `finds`, `left`: what a patch adds per weight, and how much may follow;
    /// `reflected`: of a step, the reflectance that it passes.
    fn follow(
        &mut self,
        [finds, left]: [&[f64]; 2],
        (mut at, mut weight): (usize, f64),
        reflected: impl Fn(usize, usize) -> f64,
        random: &mut ChaCha8Rng,
    ) -> (f64, u32) {
        let mut found = weight * finds[at];
        let mut steps = 0;
        while let Some((next, received)) = self.step(at, random) {
            weight *= reflected(at, next) * received / self.brightness[next];
            at = next;
            found += weight * finds[at];
            steps += 1;
            if weight * left[at] <= LEFT * found || steps == MOST_STEPS {
                break;
            }
        }
        (found, steps)
    }

    /// The next patch, and what this one receives, `Σ_j F_ij β_j`; `None` if that is nothing.
    fn step(&mut self, at: usize, random: &mut ChaCha8Rng) -> Option<(usize, f64)> {
        let (room, brightness) = (self.room, self.brightness);
        let area = room.areas[at].high();
        let row = self.rows.entry(at).or_insert_with(|| {
            let chances = brightness.iter().enumerate();
            Cumulative::new(chances.map(|(j, b)| b * room.exchange(at, j)).collect())
        });
        let next = row.draw(random)?;
        Some((next, row.total() / area))
    }
}

impl RadiositySystem<DenseExchange<'_>> {
    /// `A_i F_ij`.
    fn exchange(&self, i: usize, j: usize) -> f64 {
        if i == j {
            self.own[i]
        } else {
            self.exchange.get(i, j)
        }
    }
}

/// Mean and variance of what a walk finds.
fn statistics(
    walks: u32,
    seed: u64,
    mut walk: impl FnMut(&mut ChaCha8Rng) -> (f64, u32),
) -> Result<Walks, TransportError> {
    if walks == 0 {
        return Err(TransportError::NoWalks);
    }
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut longest = 0;
    let one = |_| {
        let (found, steps) = walk(&mut random);
        longest = longest.max(steps);
        if steps == MOST_STEPS {
            return Err(TransportError::EndlessWalk { steps });
        }
        Ok(found)
    };
    let found: Vec<f64> = (0..walks).map(one).collect::<Result<_, _>>()?;
    let mean = compensated_sum(found.iter().copied()) / f64::from(walks);
    let deviations = || found.iter().map(|value| (value - mean).abs());
    let squares = compensated_sum(deviations().map(|d| d * d));
    Ok(Walks {
        mean,
        variance: squares / f64::from(walks.max(2) - 1),
        farthest: deviations().fold(0.0, f64::max),
        longest,
        walks,
    })
}
