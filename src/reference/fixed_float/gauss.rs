//! Gauss–Legendre rules with all the digits of a [`FixedFloat`].

use super::FixedFloat;
use super::functions::kept;
use crate::numeric::{NodeNumber, legendre_node};
use std::any::Any;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// Most points of a rule.
pub const LARGEST_ORDER: usize = 64;

/// Nodes in `[−1, 1]`, decreasing, with their weights, which sum to 2.
pub type GaussRule<const N: usize> = Vec<(FixedFloat<N>, FixedFloat<N>)>;

thread_local! {
    static RULES: RefCell<HashMap<usize, Rc<dyn Any>>> = RefCell::default();
}

/// The rule with `order` points, at most [`LARGEST_ORDER`]; computed once per thread.
#[must_use]
pub fn gauss_rule<const N: usize>(order: usize) -> Rc<GaussRule<N>> {
    let order = order.clamp(1, LARGEST_ORDER);
    kept(&RULES, N * (LARGEST_ORDER + 1) + order, || rule(order))
}

impl<const N: usize> From<f64> for FixedFloat<N> {
    fn from(value: f64) -> Self {
        Self::new(value)
    }
}

impl<const N: usize> NodeNumber for FixedFloat<N> {
    // 2⁹ digits
    const STEPS: usize = 9;
}

fn rule<const N: usize>(order: usize) -> GaussRule<N> {
    let nodes = (0..order).rev().map(|i| legendre_node(order, i));
    nodes.map(|[x, weight]| (x, weight)).collect()
}
