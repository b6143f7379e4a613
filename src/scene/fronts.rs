//! Scenes whose patches all face away from each other.
//!
//! Light arrives at fronts only. A file whose faces run clockwise has all its fronts outside, and
//! every form factor is 0: right, and not what was meant.
//!
//! ```text
//!   i and j face each other   ⇔   a corner of j is in front of i's plane, and one of i of j's
//!   turned away               ⇔   no two patches face each other, and with all fronts turned some
//!                                 would
//! ```
//!
//! In front means by more than the noise of the coordinates ([`ScenePlanes`]).

use super::Scene;
use super::planes::{Placed, ScenePlanes};
use rayon::prelude::*;
use std::collections::HashMap;

impl Scene {
    /// Tells whether all patches face away from each other, and would not with their fronts turned
    /// ([`reversed`](Self::reversed)).
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let inside = Scene::built_in("cube:2")?;
    /// assert!(!inside.is_turned_away());
    /// assert!(inside.reversed().is_turned_away());
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    #[must_use]
    pub fn is_turned_away(&self) -> bool {
        let planes = self.planes();
        let mut members: HashMap<Placed, Vec<usize>> = HashMap::new();
        for patch in 0..self.patches().len() {
            let plane = planes.plane_of(patch);
            members.entry(plane).or_default().push(patch);
        }
        let members: Vec<Vec<usize>> = members.into_values().collect();
        let any_sees = |side: f64| {
            let sees = |own: &Vec<usize>| self.any_faces(planes, own, side);
            members.par_iter().any(sees)
        };
        !any_sees(1.0) && any_sees(-1.0)
    }

    /// Tells whether a patch of those in one plane faces any other, on their fronts' side of the
    /// planes (1) or on the other (−1).
    fn any_faces(&self, planes: &ScenePlanes, own: &[usize], side: f64) -> bool {
        let rises = |patch: usize, over: usize| {
            let plane = planes.facing(over);
            let mut corners = planes.corners(self.surface(patch));
            corners.any(|corner| side * plane.sure_height(corner) > planes.noise())
        };
        (0..self.patches().len())
            .filter(|other| rises(*other, own[0]))
            .any(|other| own.iter().any(|patch| rises(*patch, other)))
    }
}
