//! Names for the patches of a scene, as people write them.

use crate::scene::Scene;
use std::convert::Infallible;
use std::fmt;
use std::str::FromStr;

/// A name for one row of a scene or several: an index, a name, or `all`.
///
/// A number is the index of a row if there is one, else a name. A name means all rows that have it,
/// and all that are pieces of what has it: of an object or a group of a file, of a face that was
/// cut into triangles, of a patch that was quartered.
///
/// # Examples
/// ```
/// use infoscene::question::PatchName;
/// use infoscene::scene::Scene;
/// let squares = Scene::built_in("two-squares")?;
/// let (quartered, _) = squares.subdivided(1)?;
/// assert_eq!(PatchName::from("wall").rows(&quartered)?, [4, 5, 6, 7]);
/// assert_eq!(PatchName::from(3).rows(&quartered)?, [3]);
/// let refusal = PatchName::from("Wal").rows(&squares).unwrap_err();
/// assert!(refusal.to_string().contains("did you mean \"wall\"?"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct PatchName(String);

/// A name for patches was refused.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PatchNameError {
    /// No row has this index or this name.
    #[error(
        "there is no patch {name:?}{}: name one, give its index from 0 to {last}, or say all",
        similar.as_ref().map(|one| format!(" (did you mean {one:?}?)")).unwrap_or_default()
    )]
    NoSuchPatch {
        /// The index or name.
        name: String,
        /// The name that is most like it, if one is.
        similar: Option<String>,
        /// The largest index.
        last: usize,
    },
    /// One row is needed, and the name means several.
    #[error(
        "{name:?} means {rows} patches, from {first} ({first_name}) on, and one is needed: give \
         its index or its full name"
    )]
    SeveralPatches {
        /// The name.
        name: String,
        /// The number of rows.
        rows: usize,
        /// The first of them.
        first: usize,
        /// The name of the first.
        first_name: String,
    },
}

impl From<usize> for PatchName {
    fn from(index: usize) -> Self {
        Self(index.to_string())
    }
}

impl From<&str> for PatchName {
    fn from(name: &str) -> Self {
        Self(name.trim().to_owned())
    }
}

impl FromStr for PatchName {
    type Err = Infallible;

    fn from_str(name: &str) -> Result<Self, Infallible> {
        Ok(Self::from(name))
    }
}

impl fmt::Display for PatchName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Names that agree by less than this (Jaro–Winkler, 1 for equal ones) are not alike.
const ALIKE: f64 = 0.8;

impl PatchName {
    /// The rows that are meant, in order; at least one.
    ///
    /// # Errors
    /// [`PatchNameError::NoSuchPatch`].
    pub fn rows(&self, scene: &Scene) -> Result<Vec<usize>, PatchNameError> {
        let rows = scene.group_count();
        if let Ok(index) = self.0.parse::<usize>()
            && index < rows
        {
            return Ok(vec![index]);
        }
        if self.0 == "all" {
            return Ok((0..rows).collect());
        }
        let named = scene.groups_named(&self.0);
        if named.is_empty() {
            return Err(PatchNameError::NoSuchPatch {
                name: self.0.clone(),
                similar: self.similar(scene),
                last: rows - 1,
            });
        }
        Ok(named)
    }

    /// The one row that is meant.
    ///
    /// # Errors
    /// [`PatchNameError::NoSuchPatch`]; [`PatchNameError::SeveralPatches`].
    pub fn row(&self, scene: &Scene) -> Result<usize, PatchNameError> {
        match self.rows(scene)?.as_slice() {
            [row] => Ok(*row),
            rows => Err(PatchNameError::SeveralPatches {
                name: self.0.clone(),
                rows: rows.len(),
                first: rows[0],
                first_name: scene.group_names()[rows[0]].to_owned(),
            }),
        }
    }

    /// The name in a scene that is most like this one, whatever their letter case.
    fn similar(&self, scene: &Scene) -> Option<String> {
        let meant = self.0.to_lowercase();
        let alike = |name: &&str| strsim::jaro_winkler(&name.to_lowercase(), &meant);
        let known = scene.known_names().into_iter();
        let rated = known.map(|name| (alike(&name), name));
        let best = rated.max_by(|one, other| one.0.total_cmp(&other.0).then(other.1.cmp(one.1)));
        best.filter(|(alike, _)| *alike >= ALIKE)
            .map(|(_, name)| name.to_owned())
    }
}
