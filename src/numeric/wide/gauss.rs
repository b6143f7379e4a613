//! Gauss–Legendre rules with all the digits of a [`Wide`].
//!
//! ```text
//!   k P_k(x) = (2k − 1) x P_{k−1}(x) − (k − 1) P_{k−2}(x)
//!   nodes P_n(x) = 0,  weights 2 (1 − x²)/(n P_{n−1}(x))²
//! ```

use super::Wide;
use super::functions::kept;
use std::any::Any;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// Most points of a rule.
pub const LARGEST_ORDER: usize = 64;

/// Nodes in `[−1, 1]` with their weights, which sum to 2.
pub type GaussRule<const N: usize> = Vec<(Wide<N>, Wide<N>)>;

thread_local! {
    static RULES: RefCell<HashMap<usize, Rc<dyn Any>>> = RefCell::default();
}

/// The rule with `order` points, at most [`LARGEST_ORDER`]; computed once per thread.
#[must_use]
pub fn gauss_rule<const N: usize>(order: usize) -> Rc<GaussRule<N>> {
    let order = order.clamp(1, LARGEST_ORDER);
    kept(&RULES, N * (LARGEST_ORDER + 1) + order, || rule(order))
}

fn rule<const N: usize>(order: usize) -> GaussRule<N> {
    #[allow(clippy::cast_precision_loss, reason = "at most 64")]
    let n = order as f64;
    let reciprocals: Vec<Wide<N>> = (1..=order)
        .map(|k| {
            #[allow(clippy::cast_precision_loss, reason = "at most 64")]
            let k = k as f64;
            Wide::new(k).reciprocal()
        })
        .collect();
    let one = Wide::new(1.0);
    // P_n and P_{n−1}
    let legendre = |x: Wide<N>| {
        let (mut current, mut previous) = (x, one);
        for k in 2..=order {
            #[allow(clippy::cast_precision_loss, reason = "at most 64")]
            let m = k as f64;
            let next = (Wide::new(2.0 * m - 1.0) * x * current - Wide::new(m - 1.0) * previous)
                * reciprocals[k - 1];
            (previous, current) = (current, next);
        }
        (current, previous)
    };
    let at = |k: usize| {
        #[allow(clippy::cast_precision_loss, reason = "at most 64")]
        let start = (std::f64::consts::PI * (k as f64 + 0.75) / (n + 0.5)).cos();
        let mut x = Wide::new(start);
        // the start is right to two digits at least, and Newton's step doubles them: 2⁹ digits
        for _ in 0..9 {
            let (current, previous) = legendre(x);
            // (1 − x²) P_n' = n (P_{n−1} − x P_n)
            let slope = Wide::new(n) * (previous - x * current);
            x = x - current * (one - x.square()) / slope;
        }
        let (_, previous) = legendre(x);
        let weight = (one - x.square()).scaled(1) / (Wide::new(n) * previous).square();
        (x, weight)
    };
    if order == 1 {
        return vec![(Wide::ZERO, Wide::new(2.0))];
    }
    (0..order).map(at).collect()
}
