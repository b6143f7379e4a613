//! Information-theoretic scene discretization, checked.
//!
//! A scene of patches is a reversible Markov chain whose transition probabilities are form factors;
//! its mutual information measures how much of the light transfer a discretization keeps. This
//! crate computes the results of
//!
//! > M. Feixas, E. del Acebo, Ph. Bekaert, M. Sbert, *Information Theory Tools for Scene
//! > Discretization*, Eurographics Workshop on Rendering, 1999,
//!
//! judges every claim of the paper, and offers what this takes as a library.
//!
//! # Start here
//!
//! | question | answer |
//! |---|---|
//! | a scene from a file, or a built-in one | [`scene::files::open`], [`Scene::built_in`] |
//! | the exchange area of two polygons, with its error bound | [`Polygon::exchange_area`] |
//! | the form factors of a scene | [`ScenePairs`]: sums, rows, tiles, or [`ExchangeAreas`] |
//! | entropies and mutual information of a scene | [`scene_information`] |
//! | the same of any reversible chain | [`ReversibleChain`], [`mutual_information`] |
//! | the gain of a refinement (Theorem 1) | [`information::refinement_gain`] |
//! | the continuous mutual information | [`information::continuous_information`] |
//! | the best cut of a patch | [`PatchSplit`] |
//! | the lines of discontinuity of a patch behind blockers | [`discretize::OccludedPair`] |
//! | the best grid on the faces of a box | [`discretize::BestGrid`] |
//! | the best cuts across a gradient (§4.2) | [`discretize::GradientCut`] |
//! | radiosity and importance, with bounds | [`RadiositySystem`] |
//! | radiosity on a mesh that an oracle refines | [`hierarchy`] |
//! | a claim of the paper, judged | [`claims::judge`] |
//! | random chains for property tests | `chain::random::strategies` (feature `proptest`) |
//!
//! ```
//! use infoscene::{PatchSplit, Scene, SplitAxis};
//!
//! // fig. 2: two unit squares with a common edge; where to cut one of them, parallel to the edge?
//! let squares = Scene::built_in("two-squares")?;
//! let best = PatchSplit::try_new(&squares, 0, &[1], SplitAxis::U)?.best(2)?;
//! assert_eq!(format!("{:.2}", best.positions[0]), "0.40"); // as the paper prints
//! # Ok::<(), infoscene::discretize::DiscretizeError>(())
//! ```
//!
//! # The house
//!
//! Data flows one way, and a module uses only modules to its left:
//!
//! ```text
//! numeric → geometry → form_factor → scene → exchange → transport → chain → information
//!   → discretize → hierarchy → reference → claims → study → question → report → python
//!   → ranks
//! ```
//!
//! [`numeric`] has numbers that carry their errors, [`geometry`] polygons, [`form_factor`] one pair
//! of polygons, [`scene`] what is there, [`exchange`] what its rows exchange, [`transport`] light
//! in equilibrium, [`chain`] and [`information`] the paper's measures, [`discretize`] its best
//! cuts, [`hierarchy`] light on meshes that are refined. [`reference`](mod@reference) computes the
//! same on slow roads of its own, [`claims`] judges the paper. The feature `report` adds studies,
//! tables and figures, the feature `cli` the command, the feature `python` the Python module that
//! `pip install .` builds, the feature `mpi` the ranks of `mpirun`, which share out what the
//! command computes.
//!
//! # Conventions
//!
//! Information is in bits, lengths in any one unit, positions relative (0 to 1). Every value that
//! is not exact has an error with a [grade](numeric::Grade). Constructors check their input and
//! return `Result`; a formula states the arguments it is meant for, and an index out of range
//! panics as it does for a slice. What stands between two patches takes its part of what they
//! exchange; functions that cannot compute that refuse the scene ([`Occlusion`]).

pub mod chain;
pub mod claims;
pub mod discretize;
pub mod exchange;
pub mod form_factor;
pub mod geometry;
pub mod hierarchy;
pub mod information;
pub mod numeric;
#[cfg(feature = "python")]
pub mod python;
pub mod question;
#[cfg(feature = "mpi")]
pub mod ranks;
pub mod reference;
#[cfg(feature = "report")]
pub mod report;
pub mod scene;
#[cfg(feature = "report")]
pub mod study;
pub mod transport;

pub use chain::{Refinement, ReversibleChain, visibility_chain};
pub use discretize::PatchSplit;
pub use exchange::{ExchangeAreas, ScenePairs};
pub use form_factor::Polygon;
pub use geometry::{Patch, SplitAxis};
pub use information::{mutual_information, scene_information};
pub use numeric::Interval;
pub use scene::{Occlusion, Scene};
pub use transport::RadiositySystem;

/// The README's example, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
