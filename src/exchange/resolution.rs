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
//! ([`Patch::moved`]). A pair that is left out, because one plane counts as the other's or as behind
//! it, would be left out rightly if one of the two were moved by the height of one over the other:
//! it has δ_i larger by that.
//!
//! **Rows that sum to one.** A closed scene stays closed where corners move together. What the
//! polygons as given leave open, or cover twice, are cracks: along the joints of three edges, and
//! where bent polygons were put flat. With the cracks spanned, the surface is closed, and a ray from
//! i meets one front more or less only where it meets a crack:
//!
//! ```text
//!   |A_i − Σ_j J_ij| ≤ Σ_j Σ_e C_e · E_e(i) + Σ_{e of i} C_e        C_e = |e| · width of the crack
//! ```
//!
//! The widths are measured, and end where the resolution does not explain them any more: what gapes
//! wider is open.
//!
//! The bound is for the worst of all places of the corners, and several times what roundings do.
//! The form factor `F = J/A` changes by `(|ΔJ| + F |ΔA|)/(A − |ΔA|)` at most.
//!
//! **Not covered**: what stands between two patches; parts and bases, which are taken to lie in each
//! other.

use super::ScenePairs;
use super::plan::facing::Facing;
use crate::exchange::rows::terms::RowTerm;
use crate::geometry::{Patch, clipped};
use crate::numeric::{Symmetric, compensated_sum, parallel_map, real, tolerance};
use crate::scene::{ResolvedSurfaces, Scene};
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Pieces of an edge, each with a distance of its own.
const PIECES: u32 = 4;

/// Polygons that are apart by so many of their radii are taken as a whole.
const FAR: f64 = 2.0;

/// The part of what the resolution can change that an error of the computation may be, whatever the
/// tolerance: nobody sees more digits than that.
const UNFELT: f64 = 1e-3;

/// The polygons of a scene, ready for these bounds.
#[derive(Debug, Clone)]
pub(crate) struct Resolution {
    surfaces: ResolvedSurfaces,
    outlines: Vec<Loose>,
}

/// A piece of an edge.
#[derive(Debug, Clone, Copy)]
struct Piece {
    middle: DVec3,
    half: DVec3,
    ribbon: f64,
}

/// A polygon whose corners may move.
#[derive(Debug, Clone)]
struct Loose {
    corners: Vec<DVec3>,
    normal: DVec3,
    /// Outward unit vectors across the edges that have all of the polygon on one side.
    sides: Vec<(DVec3, f64)>,
    pieces: Vec<Piece>,
    /// The pieces of edges along which there are cracks, with the area of these.
    cracks: Vec<Piece>,
    centre: DVec3,
    radius: f64,
    area: f64,
    ribbons: f64,
    delta: f64,
    /// The largest slope of the plane that moved corners make.
    tilt: f64,
}

impl Loose {
    fn of(patch: &Patch, delta: f64, widths: &[f64]) -> Self {
        let (corners, normal) = (patch.corners().to_vec(), patch.normal());
        let centre = corners.iter().sum::<DVec3>() / real(corners.len());
        let radius = corners.iter().map(|corner| corner.distance(centre));
        let ends = || corners.iter().zip(corners.iter().cycle().skip(1));
        let side = |(from, to): (&DVec3, &DVec3)| {
            let out = (*to - *from).cross(normal).normalize_or_zero();
            let offset = out.dot(*from - centre);
            let over = corners.iter().map(|c| out.dot(*c - centre) - offset);
            // up to rounding: a side a little farther out is a side, too
            let over = over.fold(0.0, f64::max);
            (over <= delta).then_some((out, offset + over))
        };
        let piece = |(from, to): (&DVec3, &DVec3)| {
            let (from, along) = (*from, *to - *from);
            let ribbon = delta * (along.length() + delta);
            (0..PIECES).map(move |k| Piece {
                middle: from + along * ((f64::from(k) + 0.5) / f64::from(PIECES)),
                half: along * (0.5 / f64::from(PIECES)),
                ribbon: ribbon / f64::from(PIECES),
            })
        };
        let pieces: Vec<Piece> = ends().flat_map(piece).collect();
        let widths = widths.iter().flat_map(|width| [*width; PIECES as usize]);
        let cracks = pieces.iter().zip(widths).map(|(piece, width)| Piece {
            ribbon: 2.0 * piece.half.length() * width,
            ..*piece
        });
        Self {
            cracks: cracks.filter(|crack| crack.ribbon > 0.0).collect(),
            sides: ends().filter_map(side).collect(),
            radius: radius.fold(0.0, f64::max),
            area: patch.area(),
            ribbons: compensated_sum(pieces.iter().map(|piece| piece.ribbon)),
            tilt: 4.0 * delta / patch.width(),
            pieces,
            centre,
            normal,
            delta,
            corners,
        }
    }

    fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.centre)
    }

    /// A lower bound on the distance of a point.
    fn distance(&self, point: DVec3) -> f64 {
        let out = self.sides.iter().map(|(out, offset)| out.dot(point - self.centre) - offset);
        out.fold(0.0, f64::max).hypot(self.height(point))
    }

    /// The largest height of another polygon over this one's plane, at least 0.
    fn overtopped_by(&self, other: &Self) -> f64 {
        let heights = other.corners.iter().map(|corner| self.height(*corner));
        heights.fold(0.0, f64::max)
    }

    /// Whether all of another polygon is behind this one's plane, wherever the corners of both are.
    fn is_in_front_of(&self, other: &Self) -> bool {
        other.corners.iter().all(|corner| {
            let open = self.delta + other.delta + self.tilt * corner.distance(self.centre);
            self.height(*corner) < -open
        })
    }

    /// The area of what is nearer to another polygon than `reach`, at most.
    fn area_near(&self, other: &Self, reach: f64) -> f64 {
        let mut left = self.corners.clone();
        let plane = [other.normal, -other.normal].map(|normal| (normal, 0.0));
        for (out, offset) in plane.iter().chain(&other.sides) {
            let depth = |c: &DVec3| offset + reach - out.dot(*c - other.centre);
            let depths: Vec<f64> = left.iter().map(depth).collect();
            left = clipped(&left, &depths, DVec3::lerp);
        }
        let Some(first) = left.first() else {
            return 0.0;
        };
        let doubled: DVec3 = left
            .windows(2)
            .map(|pair| (pair[0] - *first).cross(pair[1] - *first))
            .sum();
        0.5 * doubled.length()
    }

    /// The form factor to this polygon of what is no nearer and no higher over it, at most.
    fn share(&self, distance: f64, height: f64) -> f64 {
        if distance <= 0.0 {
            return 1.0;
        }
        let cosine = (height / distance).clamp(0.0, 1.0);
        let area = self.area + self.ribbons;
        (area * cosine / (PI * distance * distance)).min(1.0)
    }

    /// The rays of this polygon that meet the ribbon of a piece of another one's edge, as an
    /// exchange area.
    fn crossed_by(&self, piece: &Piece, reach: f64) -> f64 {
        let distance = self.distance(piece.middle) - piece.half.length() - reach;
        let rise = piece.half.dot(self.normal).abs();
        let open = reach + self.tilt * (piece.middle.distance(self.centre) + reach);
        let height = self.height(piece.middle) + rise + open;
        if height <= 0.0 {
            return 0.0;
        }
        piece.ribbon * self.share(distance, height)
    }

    /// The rays of this polygon that meet cracks along another one's edges.
    fn lost_to(&self, other: &Self) -> f64 {
        let reach = self.delta + other.delta;
        let cracks = other.cracks.iter();
        cracks.map(|crack| self.crossed_by(crack, reach)).sum()
    }

    /// `c_ij` of this polygon and another one, when this one moves.
    fn change(&self, other: &Self) -> f64 {
        let reach = self.delta + other.delta;
        let apart = self.centre.distance(other.centre);
        let gap = apart - self.radius - other.radius - reach;
        if gap > FAR * self.radius.max(other.radius) {
            let far = reach + other.tilt * (apart + self.radius);
            return self.ribbons * other.share(gap, other.overtopped_by(self) + far);
        }
        let swept = self.pieces.iter().map(|piece| other.crossed_by(piece, reach));
        let swept: f64 = swept.sum();
        if gap > 0.0 {
            return swept;
        }
        let near = other.pieces.iter();
        let near = near.filter(|piece| self.distance(piece.middle) - piece.half.length() <= reach);
        let ribbons: f64 = near.map(|piece| piece.ribbon).sum();
        let slope = 1.0_f64.hypot(other.tilt);
        swept + slope * (other.area_near(self, reach) + ribbons)
    }

    /// The polygon with corners that may be off by more.
    fn looser(&self, more: f64) -> Self {
        let factor = (self.delta + more) / self.delta;
        let ribbons = self.ribbons * factor * factor;
        Self {
            pieces: self
                .pieces
                .iter()
                .map(|piece| Piece {
                    ribbon: piece.ribbon * factor * factor,
                    ..*piece
                })
                .collect(),
            delta: self.delta + more,
            tilt: self.tilt * factor,
            ribbons,
            ..self.clone()
        }
    }
}

impl Resolution {
    /// The polygons of a scene that are these patches, unless its coordinates are exact.
    pub(crate) fn of(scene: &Scene, patches: &[usize]) -> Option<Self> {
        let surfaces = scene.resolved_surfaces()?;
        let cracks = scene.cracks();
        let loose = |patch: &usize| {
            let shape = scene.patches()[*patch].shape();
            let delta = tolerance::SQRT_3 * surfaces.length + shape.moved();
            Loose::of(shape, delta, &cracks[*patch])
        };
        Some(Self {
            surfaces,
            outlines: patches.iter().map(loose).collect(),
        })
    }

    /// The surfaces that are taken as bent, coplanar or touching.
    pub(crate) const fn surfaces(&self) -> ResolvedSurfaces {
        self.surfaces
    }

    /// A bound on the change of the exchange area of two polygons with this value.
    fn change(&self, first: usize, second: usize, facing: Facing) -> f64 {
        let [one, two] = [&self.outlines[first], &self.outlines[second]];
        if one.is_in_front_of(two) || two.is_in_front_of(one) {
            return 0.0;
        }
        let most = (one.area + one.ribbons).min(two.area + two.ribbons);
        let change = if facing == Facing::Visible {
            one.change(two) + two.change(one)
        } else {
            let more = one.overtopped_by(two).min(two.overtopped_by(one));
            let [one, two] = [one, two].map(|outline| outline.looser(more));
            one.change(&two) + two.change(&one)
        };
        change.min(most)
    }
}

impl ScenePairs<'_> {
    /// The length by which each coordinate may be off; 0 if they are exact.
    #[must_use]
    pub fn resolution(&self) -> f64 {
        self.loose().map_or(0.0, |loose| loose.surfaces.length)
    }

    /// A bound on what the resolution of the scene can change of the exchange area of two rows; 0
    /// for an exact scene. It does not include the error of the computation, which stands beside.
    ///
    /// # Panics
    /// If there is no such row.
    #[must_use]
    pub fn resolution_error(&self, first: usize, second: usize) -> f64 {
        let Some(resolution) = self.loose() else {
            return 0.0;
        };
        let roots = self.terms().roots();
        let times = if first == second { 2.0 } else { 1.0 };
        let change = |[one, two]: [RowTerm; 2]| {
            let [one, two] = [one.polygon, two.polygon];
            if roots[one] == roots[two] {
                return 0.0;
            }
            resolution.change(one, two, self.facing_polygons(one, two))
        };
        times * self.terms().pairs(first, second).map(change).sum::<f64>()
    }

    /// Bounds on what a row's sum of exchange areas may be off its area in a closed scene, by what
    /// the resolution explains of the cracks between its patches.
    #[must_use]
    pub fn crack_errors(&self) -> Vec<f64> {
        parallel_map(self.rows(), &|row| self.crack_error(row))
    }

    /// The bound of one row among [`crack_errors`](Self::crack_errors).
    pub(crate) fn crack_error(&self, row: usize) -> f64 {
        let Some(Resolution { outlines, .. }) = self.loose() else {
            return 0.0;
        };
        let terms = self.terms().of_row(row).iter();
        let lost = terms.map(|term| {
            let own = &outlines[term.polygon];
            outlines.iter().map(|other| own.lost_to(other)).sum::<f64>()
        });
        lost.sum()
    }

    /// The error of the computation that nobody feels beside what the resolution can change of the
    /// exchange area of two rows.
    pub(crate) fn unfelt(&self, first: usize, second: usize) -> f64 {
        UNFELT * self.resolution_error(first, second)
    }

    /// Whether the plan leaves out two rows as one lies behind the other's plane.
    pub(crate) fn is_behind(&self, first: usize, second: usize) -> bool {
        self.facing(first, second) == Facing::BackFacing
    }

    /// Bounds on what the resolution of the scene can change of the rows' areas.
    #[must_use]
    pub fn area_resolution_errors(&self) -> Vec<f64> {
        let Some(resolution) = self.loose() else {
            return vec![0.0; self.rows()];
        };
        let row = |row: usize| {
            let terms = self.terms().of_row(row).iter();
            terms
                .map(|term| resolution.outlines[term.polygon].ribbons)
                .sum()
        };
        (0..self.rows()).map(row).collect()
    }
}

/// What the resolution of a scene can change of exchange areas that are held, and of areas.
#[derive(Debug, Clone, PartialEq)]
pub struct ResolutionErrors {
    length: f64,
    exchange: Symmetric<f64>,
    own: Vec<f64>,
    areas: Vec<f64>,
    cracks: Vec<f64>,
}

impl ResolutionErrors {
    /// The bounds of all pairs; none if coordinates are exact.
    pub(crate) fn of(pairs: &ScenePairs<'_>) -> Option<Self> {
        let resolution = pairs.loose()?;
        let n = pairs.rows();
        let mut exchange = Symmetric::filled(n, 0.0);
        let rows = exchange.rows_mut().into_par_iter().enumerate();
        rows.for_each(|(i, row)| {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = pairs.resolution_error(i, j);
            }
        });
        let own: Vec<f64> = (0..n).map(|i| pairs.resolution_error(i, i)).collect();
        let areas = pairs.area_resolution_errors();
        Some(Self {
            length: resolution.surfaces.length,
            exchange,
            own,
            areas,
            cracks: pairs.crack_errors(),
        })
    }

    /// The length by which each coordinate may be off.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// The bounds off the diagonal, those of pairs that are left out included.
    #[must_use]
    pub const fn exchange(&self) -> &Symmetric<f64> {
        &self.exchange
    }

    /// The bounds on what rows exchange with themselves.
    #[must_use]
    pub fn own(&self) -> &[f64] {
        &self.own
    }

    /// The bounds on the rows' areas.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Bounds on what a row's sum of exchange areas may be off its area in a closed scene
    /// ([`ScenePairs::crack_errors`]).
    #[must_use]
    pub fn cracks(&self) -> &[f64] {
        &self.cracks
    }
}
