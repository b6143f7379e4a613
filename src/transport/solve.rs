//! Solution of the equations of [`RadiositySystem`], with a bound on its error.

use super::{ExchangeOperator, Importance, RadiositySolution, RadiositySystem, TransportError};
use crate::numeric::{DoubleDouble, SQUARED_EPSILON, Scalar, Scaled, conjugate_gradients, real};

/// A smaller relative error than this is lost in the rounding of the answer.
const GOAL: f64 = f64::EPSILON / 64.0;

/// The factor by which one run of conjugate gradients reduces the residual.
pub(super) const REDUCTION: f64 = 1e-8;

/// Runs beyond which nothing more is hoped for.
const MOST_RUNS: usize = 40;

/// Bounces after which light has come wherever it can.
const MOST_BOUNCES: usize = 1000;

/// Iterations of one run.
pub(super) const MOST_ITERATIONS: usize = 500;

/// A generous bound on the relative rounding of the sums of positive numbers in these bounds: n ε
/// for n up to 4e9.
const ROUNDING: f64 = 1e-6;

/// A solution with 106 bits.
struct Solved {
    values: Vec<DoubleDouble>,
    relative_error: f64,
    iterations: usize,
}

impl<O: ExchangeOperator> RadiositySystem<O> {
    /// The radiosities for these emittances.
    ///
    /// **Accuracy** [`RadiositySolution::relative_error`] is a bound, apart from the error of the
    /// exchange areas; for stiff scenes, too, it comes out below 1e-15
    /// (`stiff_scenes_keep_their_digits`).
    ///
    /// # Errors
    /// [`TransportError::WrongCount`], [`TransportError::SourceOutOfRange`],
    /// [`TransportError::NoSource`], [`TransportError::NoBound`]; [`TransportError::Exchange`] if
    /// exchange areas cannot be read.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// use infoscene::scene::Material;
    /// use infoscene::transport::RadiositySystem;
    /// // a furnace: what emits as much as it absorbs glows evenly
    /// let cube = Scene::built_in("cube:2")?.exchange_areas()?;
    /// let room = RadiositySystem::of(&cube, &[Material::try_new(0.75, 0.25)?; 24])?;
    /// let radiosity = room.radiosity(&[0.25; 24])?;
    /// assert!(radiosity.values.iter().all(|value| (value - 1.0).abs() < 1e-15));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn radiosity(&self, emittances: &[f64]) -> Result<RadiositySolution, TransportError> {
        self.check("emittance", "emittances", emittances)?;
        self.brightness(emittances)
    }

    /// The importances for these direct importances V: 1 for a patch that is looked at, 0 for
    /// others, for example.
    ///
    /// # Errors
    /// As [`radiosity`](Self::radiosity).
    pub fn importance(&self, direct: &[f64]) -> Result<Importance, TransportError> {
        self.check("direct importance", "direct importances", direct)?;
        let sources = self.reflectances.iter().zip(direct);
        let sources: Vec<f64> = sources.map(|(reflectance, v)| reflectance * v).collect();
        // what is looked at may reflect nothing
        let reflected = if sources.iter().any(|source| *source > 0.0) {
            self.brightness(&sources)?
        } else {
            RadiositySolution::dark(sources.len())
        };
        let received = reflected.received.iter().zip(direct);
        let values = received
            .map(|(received, direct)| direct + received)
            .collect();
        Ok(Importance { values, reflected })
    }

    /// Refuses what are not numbers ≥ 0, one for each patch and one of them positive.
    pub(super) fn check(
        &self,
        what: &'static str,
        all: &'static str,
        sources: &[f64],
    ) -> Result<(), TransportError> {
        let (found, expected) = (sources.len(), self.reflectances.len());
        if found != expected {
            return Err(TransportError::WrongCount {
                what: all,
                found,
                expected,
            });
        }
        let wrong = |value: &f64| !(value.is_finite() && *value >= 0.0);
        if let Some(patch) = sources.iter().position(wrong) {
            let value = sources[patch];
            return Err(TransportError::SourceOutOfRange { what, patch, value });
        }
        if sources.iter().all(|value| *value <= 0.0) {
            return Err(TransportError::NoSource { what });
        }
        Ok(())
    }

    /// The answer for sources of which one is positive.
    fn brightness(&self, sources: &[f64]) -> Result<RadiositySolution, TransportError> {
        let largest = sources.iter().copied().fold(0.0, f64::max);
        let power = Scaled::new(largest).exponent;
        let sources: Vec<f64> = sources
            .iter()
            .map(|source| Scaled::new(*source).times_power(-power))
            .collect();
        let solved = self.solve(&sources)?;
        if !solved.relative_error.is_finite() {
            return Err(TransportError::NoBound);
        }
        let values = leading(&solved.values);
        let received = self.received(&values)?;
        let form_factor_errors = self.form_factor_errors(&values, &sources)?;
        let rows = values.iter().zip(&received).zip(&sources).enumerate();
        let residual = rows
            .filter(|(_, ((value, _), _))| **value > 0.0)
            .map(|(i, ((value, received), source))| {
                let reflected = DoubleDouble::from(self.reflectances[i]) * *received;
                let left = DoubleDouble::from(*value) - reflected - DoubleDouble::from(*source);
                left.high().abs() / value
            })
            .fold(0.0, f64::max);
        let unscaled = |value: f64| Scaled::new(value).times_power(power);
        Ok(RadiositySolution {
            values: values.into_iter().map(unscaled).collect(),
            received: received
                .iter()
                .map(|value| unscaled(value.high()))
                .collect(),
            // that of the solution, and its last rounding
            relative_error: solved.relative_error + 0.5 * f64::EPSILON,
            form_factor_errors: form_factor_errors
                .map(|errors| errors.into_iter().map(unscaled).collect()),
            residual,
            iterations: solved.iterations,
        })
    }

    /// `Σ_j F_ij B_j`.
    fn received(&self, values: &[f64]) -> Result<Vec<DoubleDouble>, TransportError> {
        let gathered = self.exchange.gathered(values)?;
        let rows = gathered.into_iter().enumerate();
        let received = rows.map(|(i, others)| {
            let own = DoubleDouble::from(self.own[i] * values[i]);
            if self.areas[i].high() > 0.0 {
                (others + own) / self.areas[i]
            } else {
                others
            }
        });
        Ok(received.collect())
    }

    /// `M x`, with x = 0 where nothing is reflected.
    pub(super) fn product(&self, x: &[f64]) -> Result<Vec<f64>, TransportError> {
        let mut image = self.exchange.differences(x)?;
        for (i, image) in image.iter_mut().enumerate() {
            if self.diagonal[i] > 0.0 {
                *image += self.excess[i] * x[i];
            } else {
                *image = 0.0;
            }
        }
        Ok(image)
    }

    /// `x + T x + … + T^(K−1) x` and K: as given, or large enough to reach all that can be reached.
    fn bounces(
        &self,
        x: &[f64],
        given: Option<usize>,
    ) -> Result<(Vec<f64>, usize), TransportError> {
        let (mut sum, mut last) = (x.to_vec(), x.to_vec());
        let reached = |sum: &[f64]| sum.iter().filter(|value| **value > 0.0).count();
        let mut terms = 1;
        while terms < given.unwrap_or(MOST_BOUNCES) {
            let before = reached(&sum);
            if given.is_none() && before == sum.len() {
                break;
            }
            last = self.over_diagonal(&leading(&self.exchange.gathered(&last)?));
            for (sum, last) in sum.iter_mut().zip(&last) {
                *sum += last;
            }
            terms += 1;
            if given.is_none() && reached(&sum) == before {
                break;
            }
        }
        Ok((sum, terms))
    }

    fn over_diagonal(&self, x: &[f64]) -> Vec<f64> {
        let rows = x.iter().zip(&self.diagonal);
        rows.map(|(x, d)| if *d > 0.0 { x / d } else { 0.0 })
            .collect()
    }

    /// `A_i (E_i − (1−R_i) B_i)/R_i − e_i B_i − Σ_j J_ij (B_i − B_j)` and a bound on its rounding.
    fn residual(
        &self,
        values: &[DoubleDouble],
        sources: &[f64],
    ) -> Result<(Vec<f64>, Vec<f64>), TransportError> {
        let differences = self.exchange.precise_differences(values)?;
        let sizes = self.exchange.absolute_differences(&leading(values))?;
        let unit = {
            let n = real(values.len());
            (n * n + 100.0) * SQUARED_EPSILON
        };
        let rows = differences.into_iter().zip(sizes).enumerate();
        let both = rows.map(|(i, (difference, size))| {
            let reflectance = self.reflectances[i];
            if reflectance <= 0.0 {
                return (0.0, 0.0);
            }
            let loss = DoubleDouble::difference(1.0, reflectance) * values[i];
            let gain = DoubleDouble::from(sources[i]);
            let scale = self.areas[i] / DoubleDouble::from(reflectance);
            let escaping =
                self.escaping[i].map_or(DoubleDouble::from(0.0), |escaping| escaping * values[i]);
            let residual = scale * (gain - loss) - escaping - difference;
            let terms = scale.high() * (sources[i] + loss.high()) + escaping.high() + size;
            (residual.high(), unit * terms)
        });
        Ok(both.unzip())
    }

    fn solve(&self, sources: &[f64]) -> Result<Solved, TransportError> {
        let mut values: Vec<DoubleDouble> = sources
            .iter()
            .zip(&self.diagonal)
            .map(|(source, diagonal)| if *diagonal > 0.0 { 0.0 } else { *source })
            .map(DoubleDouble::from)
            .collect();
        // from nothing but lights that reflect nothing, the residual is the right side b
        let (mut residual, _) = self.residual(&values, sources)?;
        let direct = self.over_diagonal(&residual);
        let (light, bounces) = self.bounces(&direct, None)?;
        let mut best: Option<(f64, Vec<DoubleDouble>)> = None;
        let mut iterations = 0;
        for _ in 0..MOST_RUNS {
            let run = conjugate_gradients(
                |x| self.product(x),
                &self.diagonal,
                &residual,
                REDUCTION,
                MOST_ITERATIONS,
            )?;
            iterations += run.iterations;
            for (value, change) in values.iter_mut().zip(run.solution) {
                *value = *value + DoubleDouble::from(change);
            }
            let rounding;
            (residual, rounding) = self.residual(&values, sources)?;
            let unknown = residual.iter().zip(&rounding).map(|(r, rho)| r.abs() + rho);
            let unknown = self.over_diagonal(&unknown.collect::<Vec<_>>());
            let (unknown, _) = self.bounces(&unknown, Some(bounces))?;
            let error = largest_ratio(&unknown, &light) * (1.0 + ROUNDING);
            let known = best.as_ref().map_or(f64::INFINITY, |(error, _)| *error);
            // also a comparison that NaN fails
            if error < known {
                best = Some((error, values.clone()));
            }
            if !(error > GOAL && error < 0.5 * known) {
                break;
            }
        }
        let (relative_error, values) = best.unwrap_or((f64::INFINITY, values));
        Ok(Solved {
            values,
            relative_error,
            iterations,
        })
    }
}

pub(super) fn leading(numbers: &[DoubleDouble]) -> Vec<f64> {
    numbers.iter().map(|number| number.high()).collect()
}

/// `max a_i/b_i`, 0/0 being 0.
fn largest_ratio(a: &[f64], b: &[f64]) -> f64 {
    let ratios = a
        .iter()
        .zip(b)
        .map(|(a, b)| if *a > 0.0 || a.is_nan() { a / b } else { 0.0 });
    ratios.fold(0.0, |most, ratio| if ratio <= most { most } else { ratio })
}

impl RadiositySolution {
    /// No light at all.
    pub(crate) fn dark(count: usize) -> Self {
        Self {
            values: vec![0.0; count],
            received: vec![0.0; count],
            relative_error: 0.0,
            form_factor_errors: Some(vec![0.0; count]),
            residual: 0.0,
            iterations: 0,
        }
    }
}
