//! The visibility chain of a scene: `J_ij = A_i F_ij`, `w_i ∝ A_i`, `P_ij = F_ij`.
//!
//! The power that escapes from an open scene goes to one more state, `outside`, and comes back, so
//! that the chain stays reversible:
//!
//! ```text
//!   J_i,out = A_i (1 − Σ_j F_ij),   J_out,out = 0,   total N = A_T + Σ_i A_i (1 − Σ_j F_ij)
//! ```

use super::error::ChainError;
use super::reversible::ReversibleChain;
use crate::exchange::Closure;
use crate::scene::Scene;
use nalgebra::DMatrix;

/// The visibility chain of a closed scene.
///
/// The weights are the row sums of the exchange areas, which for a closed scene are the areas
/// within the error bounds of the form factors. As if nothing were in the way it is the
/// [`brightness_chain`](super::brightness_chain) of unoccluded exchange areas with brightness 1.
///
/// # Errors
/// [`ChainError::Exchange`] if patches overlap; with the worst row if a row of form factors does
/// not sum to one within its error bounds; or if a form factor is refused.
pub fn visibility_chain(scene: &Scene) -> Result<ReversibleChain, ChainError> {
    let exchange = scene.exchange_areas()?;
    Closure::of_held(&exchange).require_closed()?;
    ReversibleChain::try_new(exchange.into_values())
}

/// The visibility chain of an open scene: the last state is `outside`.
///
/// The chain of a closed scene has that state, too, without weight.
///
/// # Errors
/// [`ChainError::Exchange`] if patches overlap, or if a form factor is refused.
///
/// # Examples
/// ```
/// use infoscene::chain::open_visibility_chain;
/// use infoscene::scene::Scene;
/// // two unit squares at 90° see a fifth of each other
/// let chain = open_visibility_chain(&Scene::built_in("two-squares")?)?;
/// assert_eq!(chain.states(), 3);
/// assert!((chain.transition_probability(0, 2) - 0.8).abs() < 1e-3);
/// assert!((chain.total() - 3.6).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn open_visibility_chain(scene: &Scene) -> Result<ReversibleChain, ChainError> {
    let exchange = scene.exchange_areas()?;
    let closure = Closure::of_held(&exchange);
    closure.require_at_most_one()?;
    let outside = exchange.rows();
    let escaping = |i: usize| exchange.areas()[i] * closure.escaping(i);
    ReversibleChain::try_new(DMatrix::from_fn(outside + 1, outside + 1, |i, j| {
        match (i == outside, j == outside) {
            (true, true) => 0.0,
            (true, false) => escaping(j),
            (false, true) => escaping(i),
            (false, false) => exchange.get(i, j).exchange.value,
        }
    }))
}
