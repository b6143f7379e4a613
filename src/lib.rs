//! Information-theoretic scene discretization, checked.
//!
//! A scene of patches is a reversible Markov chain whose transition probabilities are form factors; its
//! mutual information measures how much of the light transfer a discretization keeps. This crate
//! computes the results of
//!
//! > M. Feixas, E. del Acebo, Ph. Bekaert, M. Sbert, *Information Theory Tools for Scene
//! > Discretization*, Eurographics Workshop on Rendering, 1999,
//!
//! judges every claim of the paper, and offers what it takes as a library. Data flows one way, and a module
//! uses only modules to its left:
//!
//! ```text
//! numeric → geometry → form_factor → scene → transport → chain → information → discretize → claims → study → report → cli
//! ```
//!
//! ```
//! use infoscene::discretize::PatchSplit;
//! use infoscene::geometry::SplitAxis;
//! use infoscene::scene::Scene;
//!
//! // fig. 2: two unit squares with a common edge; where to cut the first one, parallel to the edge?
//! let squares = Scene::built_in("two-squares")?;
//! let best = PatchSplit::try_new(&squares, 0, &[1], SplitAxis::U)?.best(2)?;
//! assert_eq!(format!("{:.2}", best.positions[0]), "0.40"); // as the paper prints
//! # Ok::<(), infoscene::discretize::DiscretizeError>(())
//! ```
//!
//! Information is in bits, lengths in any one unit, positions relative (0 to 1). Constructors check their
//! input and return `Result`; a formula states the arguments it is meant for, and an index out of range panics
//! as it does for a slice. The command never panics.

pub mod chain;
pub mod claims;
pub mod discretize;
pub mod form_factor;
pub mod geometry;
pub mod information;
pub mod numeric;
#[cfg(feature = "report")]
pub mod report;
pub mod scene;
#[cfg(feature = "report")]
pub mod study;
pub mod transport;

/// The README's example, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
