//! The planes of a scene's polygons that can see each other.
//!
//! ```text
//!   h is in front of g   ⇔   some corner of h has n_g · (x − o_g) > noise
//! ```
//!
//! If h is not in front of g, or g not in front of h, no polygon of one exchanges anything with a
//! polygon of the other: all their pairs are left out at once. A plane whose polygons face both
//! ways counts as two. The noise is that of [`ScenePlanes`](crate::scene::planes).
//!
//! Where only some rows are asked for, their planes alone are compared with all others.
//!
//! **Not covered**: more than [`MOST_PLANES`] planes; then only pairs in one plane are left out
//! here, unless only some rows are asked for.

use crate::geometry::Plane;
use crate::scene::Scene;
use glam::DVec3;
use std::collections::HashMap;

/// Most planes of which all pairs are compared: the table takes their square in bytes.
pub(crate) const MOST_PLANES: usize = 2048;

/// The relation of two planes, which decides whether their polygons can exchange anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(
    clippy::enum_variant_names,
    reason = "the term of computer graphics is back-facing"
)]
pub(crate) enum Facing {
    /// Some pairs may exchange something: each decides for itself.
    Visible,
    /// Nothing: both lie in one plane.
    Coplanar,
    /// Nothing: one lies behind the other.
    BackFacing,
}

/// The planes of polygons, each way that they face, and which of them can see each other.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FacingPlanes {
    /// The plane of each polygon.
    of: Vec<u32>,
    /// The polygons of each plane, in order.
    members: Vec<Vec<usize>>,
    compared: Compared,
}

/// The relations of planes that are known.
#[derive(Debug, Clone, PartialEq)]
enum Compared {
    /// None, as there are more than [`MOST_PLANES`].
    None,
    /// The relations of some planes with all.
    Some(HashMap<usize, Vec<Facing>>),
    /// All of them: that of g and h stands at `g · planes + h`.
    All(Vec<Facing>),
}

impl FacingPlanes {
    /// The planes of polygons; one whose root is another lies in that one, and in its plane.
    ///
    /// **Arguments** `patches`: the patch that each polygon is; `roots`: the polygon that each lies
    /// in, in the end; `asked`: polygons one of which is in every pair that will be asked for, if
    /// not all pairs are.
    pub(crate) fn of(
        scene: &Scene,
        patches: &[usize],
        roots: &[usize],
        asked: Option<&[usize]>,
    ) -> Self {
        let shared = scene.planes();
        let mut planes: Vec<Plane> = Vec::new();
        let mut numbers = HashMap::new();
        let mut of = vec![u32::MAX; patches.len()];
        for (polygon, patch) in patches.iter().enumerate() {
            if roots[polygon] == polygon {
                let plane = *numbers.entry(shared.plane_of(*patch)).or_insert_with(|| {
                    let plane = shared.facing(*patch);
                    let origin = plane.origin * shared.unit();
                    planes.push(Plane { origin, ..plane });
                    planes.len() - 1
                });
                of[polygon] = u32::try_from(plane).unwrap_or(u32::MAX);
            }
        }
        let mut members = vec![Vec::new(); planes.len()];
        for polygon in 0..patches.len() {
            of[polygon] = of[roots[polygon]];
            members[of[polygon] as usize].push(polygon);
        }
        // what lies in a patch is in front of nothing that the patch is not in front of
        let whole = |polygon: usize| {
            let is_whole = roots[polygon] == polygon;
            let shape = scene.patches()[patches[polygon]].shape();
            if is_whole { shape.corners() } else { &[] }
        };
        let relation = |[first, second]: [usize; 2]| {
            relation(
                &planes,
                &members,
                whole,
                shared.noise_length(),
                [first, second],
            )
        };
        let count = planes.len();
        let compared = match asked {
            Some(polygons) => {
                let row = |plane: usize| (0..count).map(|other| relation([plane, other])).collect();
                let planes = polygons.iter().map(|polygon| of[*polygon] as usize);
                Compared::Some(planes.map(|plane| (plane, row(plane))).collect())
            }
            None if count <= MOST_PLANES => {
                let mut table = vec![Facing::Coplanar; count * count];
                for (first, second) in (0..count).flat_map(|g| (g + 1..count).map(move |h| (g, h)))
                {
                    let found = relation([first, second]);
                    table[first * count + second] = found;
                    table[second * count + first] = found;
                }
                Compared::All(table)
            }
            None => Compared::None,
        };
        Self {
            of,
            members,
            compared,
        }
    }

    pub(crate) const fn count(&self) -> usize {
        self.members.len()
    }

    /// Tells whether it is known of all planes which see nothing of each other.
    pub(crate) const fn are_compared(&self) -> bool {
        matches!(self.compared, Compared::All(_))
    }

    pub(crate) fn of_patch(&self, polygon: usize) -> usize {
        self.of[polygon] as usize
    }

    /// The relation of the planes of two polygons.
    pub(crate) fn facing_of(&self, [first, second]: [usize; 2]) -> Facing {
        self.facing(self.of_patch(first), self.of_patch(second))
    }

    /// The relation of two planes.
    pub(crate) fn facing(&self, first: usize, second: usize) -> Facing {
        if first == second {
            return Facing::Coplanar;
        }
        match &self.compared {
            Compared::All(table) => table[first * self.count() + second],
            Compared::Some(rows) => {
                let row = |plane: usize, other: usize| rows.get(&plane).map(|row| row[other]);
                let known = row(first, second).or_else(|| row(second, first));
                known.unwrap_or(Facing::Visible)
            }
            Compared::None => Facing::Visible,
        }
    }

    /// Numbers of pairs left out: in one plane, behind each other.
    pub(crate) fn pairs_left_out(&self) -> [usize; 2] {
        let mut left_out = [0, 0];
        for (first, polygons) in self.members.iter().enumerate() {
            left_out[0] += polygons.len() * (polygons.len() - 1) / 2;
            if !self.are_compared() {
                continue;
            }
            for (second, others) in self.members.iter().enumerate().skip(first + 1) {
                let pairs = polygons.len() * others.len();
                match self.facing(first, second) {
                    Facing::Visible => {}
                    Facing::Coplanar => left_out[0] += pairs,
                    Facing::BackFacing => left_out[1] += pairs,
                }
            }
        }
        left_out
    }
}

/// The relation of two planes, the same both ways.
fn relation<'p>(
    planes: &[Plane],
    members: &[Vec<usize>],
    corners: impl Fn(usize) -> &'p [DVec3],
    noise: f64,
    [first, second]: [usize; 2],
) -> Facing {
    // is something of `other` above, or more than noise off, the plane?
    let any = |plane: usize, other: usize, is: fn(f64) -> f64| {
        let all = members[other].iter().flat_map(|polygon| corners(*polygon));
        all.into_iter()
            .any(|corner| is(planes[plane].sure_height(*corner)) > noise)
    };
    let in_front = |plane: usize, other: usize| any(plane, other, |height| height);
    if in_front(first, second) && in_front(second, first) {
        Facing::Visible
    } else if any(first.min(second), first.max(second), f64::abs) {
        Facing::BackFacing
    } else {
        Facing::Coplanar
    }
}
