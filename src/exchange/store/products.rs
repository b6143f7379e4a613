//! Products with a stored matrix, kept in its folder until a solution is finished.
//!
//! ```text
//!   DIR/form_factors/products/HASH    x, then the product of x
//! ```
//!
//! A solution makes each product from what the products before gave it. So one that was stopped is
//! gone on with by doing the same again, where each product that is there needs no pass over the
//! matrix: the answer has the same bits, and at most one product is lost. A file is written aside
//! and renamed, has the hash of x and of the kind of product as its name, and x in it, so that it
//! is never taken for another.

use super::StoreError;
use super::chunk::{Aside, FORM_FACTORS, doubles, of_doubles};
use super::error::at;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// The folder of products in a store.
const PRODUCTS: &str = "products";

/// The products of one solution, in a store's folder.
#[derive(Debug)]
pub struct ProductFiles {
    folder: PathBuf,
    aside: Aside,
    /// Whether products of an earlier run may be taken.
    resume: bool,
    used: Mutex<BTreeSet<PathBuf>>,
}

impl ProductFiles {
    /// The products of a store, with `resume` those that an earlier run left, too.
    ///
    /// # Errors
    /// [`StoreError::Io`].
    pub fn open(store: &Path, resume: bool) -> Result<Self, StoreError> {
        let folder = store.join(FORM_FACTORS).join(PRODUCTS);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        Ok(Self {
            folder,
            aside: Aside::new(store)?,
            resume,
            used: Mutex::default(),
        })
    }

    fn path(&self, kind: &str, x: &[f64]) -> PathBuf {
        let bytes = kind.bytes().chain(x.iter().flat_map(|x| x.to_le_bytes()));
        let path = self.folder.join(format!("{:016x}", hash(bytes)));
        let mut used = self.used.lock().unwrap_or_else(PoisonError::into_inner);
        used.insert(path.clone());
        path
    }

    /// The product of x of a kind, if an earlier run left it.
    pub(crate) fn find(&self, kind: &str, x: &[f64]) -> Option<Vec<f64>> {
        let path = self.path(kind, x);
        if !self.resume {
            return None;
        }
        let numbers = of_doubles(&fs::read(path).ok()?);
        let (kept, product) = numbers.split_at_checked(x.len())?;
        let is_same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits();
        // a product has as many numbers as x, or two for each
        let is_whole = !product.is_empty() && product.len() % x.len().max(1) == 0;
        (is_whole && kept.iter().zip(x).all(is_same)).then(|| product.to_vec())
    }

    /// Keeps a product.
    pub(crate) fn keep(&self, kind: &str, x: &[f64], product: &[f64]) -> Result<(), StoreError> {
        let bytes = doubles(x.iter().chain(product).copied());
        self.aside.write(&self.path(kind, x), &bytes)
    }

    /// Removes the products of a solution that is finished.
    ///
    /// # Errors
    /// [`StoreError::Io`].
    pub fn clear(&self) -> Result<(), StoreError> {
        let used = self.used.lock().unwrap_or_else(PoisonError::into_inner);
        for path in used.iter().filter(|path| path.exists()) {
            fs::remove_file(path).map_err(at(path))?;
        }
        // another solution may have some there
        drop(fs::remove_dir(&self.folder));
        Ok(())
    }
}

/// FNV-1a, 64 bits: <http://www.isthe.com/chongo/tech/comp/fnv/>.
fn hash(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}
