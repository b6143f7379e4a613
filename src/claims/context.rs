//! The context that computations of claims share: a precision, and grids that several ask for.

use super::ClaimError;
use crate::discretize::{CertifiedGrid, UNIT_CUBE};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Bits of an enclosure's ends if nothing else is asked for: some 57 digits, of which the longest
/// computation of the registry leaves more than 30 certain (`enclosures_are_narrow`).
pub const DEFAULT_PRECISION: u32 = 192;

type SharedGrid = Arc<OnceLock<Result<CertifiedGrid, ClaimError>>>;

/// The precision of enclosures, and the best grids found so far.
#[derive(Debug)]
pub struct Context {
    bits: u32,
    best_grids: Mutex<BTreeMap<u32, SharedGrid>>,
}

impl Context {
    /// Constructs a context in which enclosed numbers have ends of `bits` bits.
    #[must_use]
    pub const fn new(bits: u32) -> Self {
        Self {
            bits,
            best_grids: Mutex::new(BTreeMap::new()),
        }
    }

    /// Bits of the enclosures' ends.
    #[must_use]
    pub const fn bits(&self) -> u32 {
        self.bits
    }

    /// The certified best grid of the unit cube with so many cells a side, computed once.
    ///
    /// # Errors
    /// [`ClaimError::Discretize`] if it is not found.
    pub fn best_grid(&self, cells: u32) -> Result<CertifiedGrid, ClaimError> {
        let shared = {
            // a panic elsewhere leaves the map as it was: entries are only ever added
            let grids = self.best_grids.lock();
            let mut grids = grids.unwrap_or_else(PoisonError::into_inner);
            grids.entry(cells).or_default().clone()
        };
        shared
            .get_or_init(|| Ok(CertifiedGrid::best(UNIT_CUBE, cells, self.bits)?))
            .clone()
    }
}

impl Default for Context {
    fn default() -> Self {
        Self::new(DEFAULT_PRECISION)
    }
}
