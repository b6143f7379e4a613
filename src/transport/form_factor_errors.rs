//! Bounds on what the errors of exchange areas bring to a solution: `M x − g(x) ≥ θ g(B)` gives
//! `|B* − B| ≤ x/θ`, as the head of [`system`](super::system) derives.

use super::solve::{MOST_ITERATIONS, REDUCTION, leading};
use super::{ExchangeOperator, RadiositySystem, TransportError};
use crate::numeric::{conjugate_gradients, real};

/// A bound on the relative rounding of radiosities as `f64`, and of their products.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

impl<O: ExchangeOperator> RadiositySystem<O> {
    /// `g(x)`: what the errors of the exchange areas can do to the equations.
    fn perturbation(&self, x: &[f64], sources: &[f64]) -> Result<Option<Vec<f64>>, TransportError> {
        let Some(bounds) = &self.errors else {
            return Ok(None);
        };
        let between = bounds.absolute_differences(x)?;
        let from_others = leading(&bounds.gathered(x)?);
        let row = |i: usize| {
            let reflectance = self.reflectances[i];
            if reflectance <= 0.0 {
                0.0
            } else if self.escaping[i].is_some() {
                // the area counts on its own: A (B − E)/R
                let gained = (x[i] - sources[i]).max(0.0) / reflectance;
                let of_area = self.open_area_bounds[i] * gained;
                from_others[i] + self.own_bounds[i] * x[i] + of_area
            } else {
                let (lost, gained) = ((1.0 - reflectance) * x[i], sources[i]);
                // the differences are those of numbers that are rounded themselves
                let imbalance = (lost - gained).abs() + ROUNDED * (lost + gained);
                let nearly_even = ROUNDED * (from_others[i] + self.row_bounds[i] * x[i]);
                between[i] + nearly_even + self.row_bounds[i] * imbalance / reflectance
            }
        };
        Ok(Some((0..x.len()).map(row).collect()))
    }

    /// The bounds that the errors of the form factors bring.
    pub(super) fn form_factor_errors(
        &self,
        values: &[f64],
        sources: &[f64],
    ) -> Result<Option<Vec<f64>>, TransportError> {
        let Some(forces) = self.perturbation(values, sources)? else {
            return Ok(None);
        };
        let none = vec![0.0; values.len()];
        if forces.iter().all(|force| *force <= 0.0) {
            return Ok(Some(none));
        }
        let reaction = conjugate_gradients(
            |x| self.product(x),
            &self.diagonal,
            &forces,
            REDUCTION,
            MOST_ITERATIONS,
        )?
        .solution;
        let image = self.product(&reaction)?;
        let Some(sideways) = self.perturbation(&reaction, &none)? else {
            return Ok(None);
        };
        // what rounding may have added to the product
        let size = self.exchange.absolute_differences(&reaction)?;
        let unit = real(values.len() + 32) * f64::EPSILON;
        let shares = (0..values.len()).filter(|i| forces[*i] > 0.0).map(|i| {
            let rounding = unit * (size[i] + self.excess[i] * reaction[i].abs());
            (image[i] - sideways[i] - rounding) / forces[i]
        });
        let share = shares.fold(f64::INFINITY, f64::min);
        let is_safe = share > 0.0 && reaction.iter().all(|x| *x >= 0.0);
        Ok(is_safe.then(|| reaction.into_iter().map(|x| x / share).collect()))
    }
}
