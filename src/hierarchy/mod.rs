//! Hierarchical radiosity: light on a mesh that an oracle refines (§5, §6).
//!
//! ```text
//!   B(x) = E + R ∫ k(x,y) B(y) dy     k = cos θ_x cos θ_y/(π r²), 0 where something stands between
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
//! [`crate::reference::BoxRadiosity`]): 14 to 18 % of ‖B‖ for constants on 100 elements, 7 to 9 %
//! on 400 and half as much on four times as many; 4 to 6, 2 and 0.6 % for linear functions on 100,
//! 400 and 1,600. Light that is gathered once more ([`Refinement::gathered`]) is some ten times
//! better.
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
//! # Over several machines: the plan
//!
//! Nothing of this is built; matrices are shared out already ([`Ranks`](crate::exchange::Ranks)). A
//! link is 32 bytes, and what it knows of what stands in its way 32 more. As counted by
//! `cargo test --release --test library distribution -- --ignored --nocapture`, with consecutive
//! patches on each rank, and the gradient oracle:
//!
//! | room | leaves | links a patch | links a leaf | read of others, of 4 ranks | of 16 ranks |
//! |---|---|---|---|---|---|
//! | lit-cube, 160 patches | 1,000 | 450 | 72 | 622, at most 898 elements | 399, at most 715 |
//! | | 4,000 | 1,416 | 57 | 1,528, at most 2,209 | 754, at most 1,228 |
//! | | 16,000 | 4,238 | 42 | 3,324, at most 4,263 | 1,401, at most 2,444 |
//! | cornell-box-blocks, 376 | 1,000 | 266 | 100 | 666, at most 800 | 504, at most 694 |
//! | | 4,000 | 654 | 62 | 1,640, at most 2,069 | 902, at most 1,304 |
//! | | 16,000 | 1,897 | 45 | 3,513, at most 4,589 | 1,632, at most 2,409 |
//!
//! 1. **Owners.** A patch belongs to one rank, with its whole tree and the links that its elements
//!    receive by. Pull and push stay inside a tree, and sums over an element's links inside a rank,
//!    in the order they have now: the same bits for any number of ranks. Consecutive patches with
//!    about equally many links give the fullest of 16 ranks 1.10 to 1.22 times the mean.
//! 2. **A product** sends each rank the means of the elements of others that its links read: of
//!    16 ranks each reads 7 to 8 % of the 21,300 elements of the finest meshes, 11 to 13 kB, and
//!    20 kB at most. All means to all ranks are 171 kB, one gather, which is the first step: beside
//!    it a rank reads 1.4 to 2.9 MB of links (of 22 and 46 MB in all). Lists of what is read pay on
//!    finer meshes: in the cube the share falls from 31 to 7 % as leaves become 16 times as many.
//! 3. **Trees are known to all.** A copy of the tree on each rank, kept equal by making all cuts in
//!    the order of elements, saves every question about another's element. An element takes some 72
//!    bytes beside its corners and has 32 links: with 16 ranks the copy is about as large as a
//!    rank's links here, and with more it is what a rank's memory goes to. To divide it, shapes
//!    must travel with new links.
//! 4. **A round.** Ranks judge their own leaves and gather what the oracle says of them (8 bytes a
//!    leaf); each cuts the same leaves, and links what its own elements receive, for which it needs
//!    nothing of others but shapes.
//! 5. **Oracles** that look at the whole mesh (a reference, the adjoint's light) are products like
//!    the solution's; [`View`] counts on each rank, and counts are added in their order.
//!
//! With fewer than some ten patches a rank, trees would have to be divided below their roots, which
//! 1 forbids. How long a round takes on several machines was not measured.
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
