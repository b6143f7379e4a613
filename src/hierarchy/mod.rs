//! Hierarchical radiosity: light on a mesh that an oracle refines (§5, §6).
//!
//! ```text
//!   B(x) = E + R ∫ k(x,y) B(y) dy       k = cos θ_x cos θ_y/(π r²), 0 where something stands between
//! ```
//!
//! Patches are cut into a [`Tree`] of elements; its leaves carry the solution, a constant each or a
//! linear function. An element receives light through [`Links`] from others, each between elements
//! as large as its error allows (`linking`), so that there are far fewer links than pairs of
//! leaves. A [`Refinement`] goes round by round:
//!
//! ```text
//!   cut     the leaves that an oracle ranks first         oracle/, division, tree
//!   link    what the larger mesh needs                    linking, link_factor/
//!   solve   B = E + R H through the links                 exchange, solution
//! ```
//!
//! Mesh and links are decided separately: coupled, as the steps of §5 have it, good meshes get bad
//! links. [`Oracle`] is the trait that the paper's oracle and its rivals share; `infoscene study
//! oracles` compares them on equal terms.
//!
//! # Errors
//!
//! Measured on three lit boxes against a reference of its own ([`Reference`],
//! [`crate::reference::BoxRadiosity`]): 14 to 18 % of ‖B‖ for constants on 100 elements, 7 to 9 % on 400
//! and half as much on four times as many; 4 to 6, 2 and 0.6 % for linear functions on 100, 400 and
//! 1,600. Light that is gathered once more ([`Refinement::gathered`]) is some ten times better.
//!
//! ```
//! use infoscene::hierarchy::{Factors, Goal, Lighting, OracleName, Refinement};
//! use infoscene::scene::{Channel, Occlusion, Scene};
//! let room = Scene::built_in("shaded-cube")?;
//! let lighting = Lighting::of(&room, Channel::Green)?;
//! let mut mesh = Refinement::try_new(&room, lighting, Occlusion::Exact, Factors::OfPoints)?;
//! let oracle = OracleName::Gradient.oracle(None)?;
//! mesh.refine(&*oracle, Goal::Elements(300), &mut |_| ())?;
//! // walls are darker than the light, and links far fewer than pairs
//! assert!(mesh.solution().radiosity.iter().all(|radiosity| *radiosity <= 1.0));
//! assert!(mesh.links().count() < 300 * 299 / 4);
//! # Ok::<(), infoscene::hierarchy::HierarchyError>(())
//! ```
//!
//! **Not covered**: patches that lie in another one; reflection that is not diffuse.
//!
//! References: Hanrahan, Salzman, Aupperle, *A rapid hierarchical radiosity algorithm*, SIGGRAPH
//! 1991; Gortler, Schröder, Cohen, Hanrahan, *Wavelet radiosity*, SIGGRAPH 1993.

mod black;
mod bound;
mod division;
mod error;
mod exchange;
mod gather;
mod information;
mod lighting;
mod link;
mod link_factor;
mod linking;
mod oracle;
mod refinement;
mod solution;
mod tree;
mod turned;
mod view;

pub use bound::{ErrorBound, WeightedSum};
pub use division::{Bisection, CutCriterion, Division};
pub use error::HierarchyError;
pub use exchange::Received;
pub use information::link_information;
pub use lighting::Lighting;
pub use link::{Link, Links};
pub use link_factor::{LinkFactors, Visibility};
pub use linking::Factors;
pub use oracle::{ImportanceDriven, Indicator, Oracle, OracleName, Reference};
pub use refinement::{Goal, Refinement};
pub use solution::Solution;
pub use tree::{Element, Tree};
pub use view::{OracleCost, View};
