//! A solution reads the exchange areas through their products alone.

use super::{radiosity, uneven};
use infoscene::exchange::ExchangeError;
use infoscene::numeric::{DoubleDouble, Symmetric};
use infoscene::scene::Scene;
use infoscene::transport::{ExchangeOperator, ExchangeRows, RadiositySystem};

/// Products written down as they are defined, all with 106 bits.
struct Plain<'e>(&'e Symmetric<f64>);

impl Plain<'_> {
    fn sums(&self, term: impl Fn(usize, usize) -> DoubleDouble) -> Vec<DoubleDouble> {
        let n = self.0.order();
        let others = |i: usize| (0..n).filter(move |j| *j != i);
        let zero = DoubleDouble::from(0.0);
        (0..n)
            .map(|i| {
                others(i).fold(zero, |sum, j| {
                    sum + DoubleDouble::from(*self.0.get(i, j)) * term(i, j)
                })
            })
            .collect()
    }
}

fn high(sums: Vec<DoubleDouble>) -> Vec<f64> {
    sums.into_iter().map(|sum| sum.high()).collect()
}

impl ExchangeOperator for Plain<'_> {
    fn order(&self) -> usize {
        self.0.order()
    }

    fn differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError> {
        Ok(high(self.sums(|i, j| DoubleDouble::difference(x[i], x[j]))))
    }

    fn absolute_differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError> {
        Ok(high(
            self.sums(|i, j| DoubleDouble::from((x[i] - x[j]).abs())),
        ))
    }

    fn gathered(&self, x: &[f64]) -> Result<Vec<DoubleDouble>, ExchangeError> {
        Ok(self.sums(|_, j| DoubleDouble::from(x[j])))
    }

    fn precise_differences(&self, x: &[DoubleDouble]) -> Result<Vec<DoubleDouble>, ExchangeError> {
        Ok(self.sums(|i, j| x[i] - x[j]))
    }
}

/// Two ways to the products, one solution: within the bounds of both.
#[test]
fn any_operator_with_the_same_products_has_the_same_solution() {
    let exchange = Scene::built_in("cube:2").unwrap().exchange_areas().unwrap();
    let n = exchange.rows();
    let reflectances: Vec<f64> = (0..n).map(|patch| 0.9 * uneven(patch, 1)).collect();
    let emittances: Vec<f64> = (0..n).map(|patch| uneven(patch, 2)).collect();
    let dense = radiosity(&exchange, &reflectances, &emittances);
    let rows = ExchangeRows {
        own: vec![0.0; n],
        own_bounds: vec![0.0; n],
        open_areas: vec![None; n],
    };
    let plain = Plain(exchange.values());
    let bounds = Plain(exchange.errors());
    let system = RadiositySystem::try_new(plain, Some(bounds), rows, reflectances).unwrap();
    let found = system.radiosity(&emittances).unwrap();
    let both = dense.relative_error + found.relative_error;
    assert!(both < 1e-15, "{both}");
    for (one, other) in dense.values.iter().zip(&found.values) {
        assert!((one - other).abs() <= both * one, "{one} {other}");
    }
}
