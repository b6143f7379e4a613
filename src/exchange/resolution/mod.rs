//! Bounds on what the resolution of a scene can change of its exchange areas.
//!
//! ```text
//!   |ΔJ_ij| ≤ c_ij + c_ji,    c_ij = Σ_e R_e · E_e(j) + |j ∩ N(i)| + Σ_{f of j in N(i)} R_f
//!   |ΔA_i|  ≤ Σ_e R_e
//! ```
//!
//! where every corner of i moves by δ_i at most, and i stays plane.
//!
//! * **Ribbons.** An edge e and its new place span a ribbon of area `R_e ≤ δ (|e| + δ)`. Old
//!   polygon, new polygon and ribbons close up, so a ray from a point of j that is not inside meets
//!   the front of i as often as that of its new place, up to its crossings of ribbons. Rays of all
//!   points of j through an element dA of a ribbon carry dA times the form factor from dA to j:
//!
//! ```text
//!   E ≤ min(1, A_j h / (π d³))      d: the distance of the element, h: its height over j
//! ```
//!
//!   whichever way dA faces, as the cosine at dA is at most 1 and j lies in a half space. A vector
//!   area has no more size than the surface, which is the second line.
//! * **Points inside.** Points of j between the old place of i and the new one are nearer to i than
//!   δ_i, in N(i); each counts with all that it may receive. They are found by cutting j with the
//!   sides of i moved out.
//! * **Both move.** The second step is from the new place of i; so areas are taken with their
//!   ribbons, distances less δ_i + δ_j, N(i) is as wide as both, and the ribbons of what moves in
//!   it count in it.
//!
//! `δ_i = √3 r`, and what a bent polygon was moved by when it was put into its plane
//! ([`moved`](crate::geometry::Patch::moved)). A pair that is left out, because one plane counts as
//! the other's or as behind it, would be left out rightly if one of the two were moved by the
//! height of one over the other: it has δ_i larger by that.
//!
//! **Rows that sum to one.** A closed scene stays closed where corners move together. What the
//! polygons as given leave open, or cover twice, are cracks: along the joints of three edges, and
//! where bent polygons were put flat. With the cracks spanned, the surface is closed, and a ray
//! from i meets one front more or less only where it meets a crack:
//!
//! ```text
//!   |A_i − Σ_j J_ij| ≤ Σ_j Σ_e C_e · E_e(i) + Σ_{e of i} C_e        C_e = |e| · width of the crack
//! ```
//!
//! The widths are measured, and end where the resolution does not explain them any more: what gapes
//! wider is open.
//!
//! **What stands between.** An occluder k, its new place and its ribbons close up, too, so a ray
//! from i to j is cut by one and not by the other only if it crosses a ribbon of k or ends between
//! its two places: `c_ki + c_kj` more for each k in the way.
//!
//! The bound is for the worst of all places of the corners, and several times what roundings do.
//! The form factor `F = J/A` changes by `(|ΔJ| + F |ΔA|)/(A − |ΔA|)` at most.
//!
//! Open `loose` for one polygon and its c.
//!
//! **Not covered**: occluders that touch the space between two patches up to the noise, which count
//! as beside it in truth, too; parts and bases, which are taken to lie in each other.

mod loose;

use crate::exchange::plan::facing::Facing;
use crate::geometry::Patch;
use crate::numeric::tolerance;
use crate::scene::{ResolvedSurfaces, Scene};
use loose::Loose;

/// The polygons of a scene, ready for these bounds.
#[derive(Debug, Clone)]
pub(crate) struct Resolution {
    surfaces: ResolvedSurfaces,
    outlines: Vec<Loose>,
    /// All surfaces, where they may stand between others; obstructions come after the patches.
    occluders: Vec<Loose>,
}

impl Resolution {
    /// The polygons of a scene that are these patches, unless its coordinates are exact.
    ///
    /// **Arguments** `is_occluded`: whether surfaces may stand between others.
    pub(crate) fn of(scene: &Scene, patches: &[usize], is_occluded: bool) -> Option<Self> {
        let surfaces = scene.resolved_surfaces()?;
        let cracks = scene.cracks();
        let loose = |shape: &Patch, cracks: &[f64]| {
            let delta = tolerance::SQRT_3 * surfaces.length + shape.moved();
            Loose::of(shape, delta, cracks)
        };
        let patch = |patch: &usize| loose(scene.patches()[*patch].shape(), &cracks[*patch]);
        let all = scene.surfaces().filter(|_| is_occluded);
        Some(Self {
            surfaces,
            outlines: patches.iter().map(patch).collect(),
            occluders: all.map(|surface| loose(surface.shape(), &[])).collect(),
        })
    }

    /// The surfaces that are taken as bent, coplanar or touching.
    pub(crate) const fn surfaces(&self) -> ResolvedSurfaces {
        self.surfaces
    }

    /// A bound on the change of the exchange area of two polygons with this value.
    pub(crate) fn change(&self, first: usize, second: usize, facing: Facing) -> f64 {
        let [one, two] = [&self.outlines[first], &self.outlines[second]];
        if one.is_in_front_of(two) || two.is_in_front_of(one) {
            return 0.0;
        }
        let most = self.most(first, second);
        let change = if facing == Facing::Visible {
            one.change(two) + two.change(one)
        } else {
            let more = one.overtopped_by(two).min(two.overtopped_by(one));
            let [one, two] = [one, two].map(|outline| outline.looser(more));
            one.change(&two) + two.change(&one)
        };
        change.min(most)
    }

    /// A bound on the change of the exchange area of two polygons as a surface between them moves.
    pub(crate) fn change_by(&self, surface: usize, first: usize, second: usize) -> f64 {
        let occluder = &self.occluders[surface];
        let ends = [first, second].map(|polygon| occluder.change(&self.outlines[polygon]));
        ends.iter().sum()
    }

    /// A bound on any change of the exchange area of two polygons.
    pub(crate) fn most(&self, first: usize, second: usize) -> f64 {
        let [one, two] = [first, second].map(|polygon| &self.outlines[polygon]);
        (one.area + one.ribbons).min(two.area + two.ribbons)
    }

    /// A bound on the change of a polygon's area.
    pub(crate) fn area_change(&self, polygon: usize) -> f64 {
        self.outlines[polygon].ribbons
    }

    /// A bound on what a polygon's exchange areas may sum to beside its area, by the cracks of a
    /// closed scene.
    pub(crate) fn lost_in_cracks(&self, polygon: usize) -> f64 {
        let own = &self.outlines[polygon];
        self.outlines.iter().map(|other| own.lost_to(other)).sum()
    }
}
