//! Random straight lines through a scene, and the chords that the patches cut out of them.
//!
//! ```text
//!   local line    from a uniform point of all fronts, direction by cosine, to the first surface
//!   global line   uniform among the lines that meet a sphere around the scene: every piece from a
//!                 front to the next front
//! ```
//!
//! Both kinds of chords have the same distribution: from patch i to patch j with probability `A_i
//! F_ij / A_T`, F with occlusion, because the first surface that a line meets is the visible one. A
//! line through a room that is convex inside has one chord; where it is concave or something stands
//! in it, a global line may have several. A line goes on the innermost of patches that lie in each
//! other.
//!
//! No line slips between neighbours with a common edge. Candidates are found in a tree of boxes.
//!
//! **Not covered**: the random numbers, which the caller supplies.
//!
//! Reference: Sbert, *An Integral Geometry Based Method for Fast Form-Factor Computation*,
//! Eurographics 1993.

use crate::geometry::{Facet, LocalLine, bounds, line_through_sphere};
use crate::numeric::tolerance;
use crate::scene::{NamedPatch, Scene};
use glam::DVec3;
use rstar::primitives::{GeomWithData, Rectangle as Box3};
use rstar::{AABB, RTree, RTreeObject, SelectionFunction};

/// A chord of a line, from the front of a patch to the front of another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chord {
    /// The rows of both patches.
    pub rows: [usize; 2],
    /// Cosines of the angles to both normals, > 0.
    pub cosines: [f64; 2],
    /// The square of its length, in units of the sum of the patches' areas; > 0.
    pub square: f64,
}

/// The result of following a global line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Passage {
    /// No front.
    Nothing,
    /// Chords, one at least.
    Chords,
    /// A front from or to which no chord goes: the scene is open, or something in it is no patch.
    Escape,
}

/// A patch that lies in no other one, what lies in it, or an obstruction.
#[derive(Debug)]
struct Surface {
    facet: Facet,
    /// None for an obstruction.
    row: Option<usize>,
    /// Surfaces that lie directly in it.
    parts: Vec<usize>,
}

/// The point at which a line meets a surface.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// The key by which crossings are sorted.
    rank: f64,
    distance: f64,
    /// Between line and normal: positive where the line leaves the front.
    cosine: f64,
    surface: usize,
}

/// A scene made ready for lines.
#[derive(Debug)]
pub struct SceneLines {
    surfaces: Vec<Surface>,
    boxes: RTree<GeomWithData<Box3<[f64; 3]>, usize>>,
    /// Triangles of the patches that lie in no other one, and the sum of their areas up to each.
    starts: Vec<(usize, [DVec3; 3])>,
    sums: Vec<f64>,
    radius: f64,
}

impl SceneLines {
    /// Makes a scene ready.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let all = || scene.patches().iter().chain(scene.obstructions());
        let corners = all().flat_map(|patch| patch.shape().corners());
        let [lowest, highest] = bounds(corners.copied());
        let middle = 0.5 * lowest + 0.5 * highest;
        // in units of a power of two near the size, so that squares stay in range
        let unit = (0.5 * highest - 0.5 * lowest).max_element().log2();
        let unit = unit.round().exp2();
        let count = scene.patches().len();
        let surface = |(index, patch): (usize, &NamedPatch)| {
            let shape = patch.shape();
            let local = |corner: DVec3| (corner - middle) / unit;
            Surface {
                facet: Facet::new(shape.corners(), shape.normal(), local),
                row: (index < count).then(|| scene.group_of(index)),
                parts: Vec::new(),
            }
        };
        let mut surfaces: Vec<Surface> = all().enumerate().map(surface).collect();
        for part in 0..count {
            if let Some(base) = scene.base_of(part) {
                surfaces[base].parts.push(part);
            }
        }
        let is_whole = |index: usize| index >= count || scene.base_of(index).is_none();
        let radius = surfaces
            .iter()
            .flat_map(|surface| surface.facet.corners())
            .map(|corner| corner.length())
            .fold(0.0, f64::max);
        let slack = DVec3::splat(tolerance::PLANARITY * radius);
        let (mut boxes, mut starts, mut sums) = (Vec::new(), Vec::new(), Vec::new());
        let mut sum = 0.0;
        for (index, surface) in surfaces.iter().enumerate().filter(|(i, _)| is_whole(*i)) {
            let [low, high] = bounds(surface.facet.corners().copied());
            let (low, high) = (low - slack, high + slack);
            let place = Box3::from_corners(low.to_array(), high.to_array());
            boxes.push(GeomWithData::new(place, index));
            if surface.row.is_some() {
                for [a, b, c] in surface.facet.triangles() {
                    sum += 0.5 * (*b - *a).cross(*c - *a).length();
                    starts.push((index, [*a, *b, *c]));
                    sums.push(sum);
                }
            }
        }
        Self {
            surfaces,
            boxes: RTree::bulk_load(boxes),
            starts,
            sums,
            radius,
        }
    }

    /// The chord of a local line; `None` if it meets no front.
    ///
    /// **Arguments** five uniform numbers from 0 to 1: three for the point, two for the direction.
    #[must_use]
    pub fn local(&self, [place, s, t, u, v]: [f64; 5]) -> Option<Chord> {
        let total = *self.sums.last()?;
        let start = self.sums.partition_point(|area| *area <= place * total);
        let (index, triangle) = self.starts[start.min(self.starts.len() - 1)];
        let normal = self.surfaces[index].facet.normal();
        let LocalLine {
            origin,
            direction,
            cosine,
        } = LocalLine::leaving(triangle, normal, [s, t, u, v]);
        let mut nearest: Option<Crossing> = None;
        for surface in self.candidates(origin, direction, 0.0) {
            if surface == index {
                continue;
            }
            let Some(mut crossing) = self.crossing(surface, origin, direction) else {
                continue;
            };
            if crossing.distance <= 0.0 {
                continue;
            }
            // of two faces of a thin wall the one that is met is the one in front
            let is_front = crossing.cosine < 0.0 && self.surfaces[surface].row.is_some();
            if !is_front {
                crossing.rank = crossing.distance * (1.0 + tolerance::PLANARITY);
            }
            if nearest.is_none_or(|nearest| crossing.precedes(&nearest)) {
                nearest = Some(crossing);
            }
        }
        let leaving = Crossing {
            rank: 0.0,
            distance: 0.0,
            cosine,
            surface: index,
        };
        self.chord([&leaving, &nearest?], origin, direction)
    }

    /// The chords of a global line, added to those given.
    ///
    /// **Arguments** four uniform numbers from 0 to 1: two for the direction, two for the place.
    pub fn global(&self, numbers: [f64; 4], chords: &mut Vec<Chord>) -> Passage {
        let [origin, direction] = line_through_sphere(self.radius, numbers);
        let mut crossings: Vec<Crossing> = self
            .candidates(origin, direction, f64::NEG_INFINITY)
            .filter_map(|surface| self.crossing(surface, origin, direction))
            .collect();
        for crossing in &mut crossings {
            // at a thin wall the line arrives before it leaves
            if crossing.cosine > 0.0 {
                crossing.rank += tolerance::PLANARITY * self.radius;
            }
        }
        crossings.sort_unstable_by(|a, b| a.order(b));
        let before = chords.len();
        let (mut passage, mut open) = (Passage::Nothing, None);
        for crossing in &crossings {
            let is_patch = self.surfaces[crossing.surface].row.is_some();
            if is_patch && crossing.cosine > 0.0 {
                if open.is_some() {
                    passage = Passage::Escape;
                }
                open = Some(crossing);
                continue;
            }
            let arrives = is_patch && crossing.cosine < 0.0;
            match open.take() {
                Some(leaving) => match self.chord([leaving, crossing], origin, direction) {
                    Some(chord) => chords.push(chord),
                    None => passage = Passage::Escape,
                },
                None if arrives => passage = Passage::Escape,
                None => {}
            }
        }
        if open.is_some() || passage == Passage::Escape {
            chords.truncate(before);
            return Passage::Escape;
        }
        if chords.len() > before {
            Passage::Chords
        } else {
            Passage::Nothing
        }
    }

    /// Surfaces whose boxes the line enters, from a distance on.
    fn candidates(
        &self,
        origin: DVec3,
        direction: DVec3,
        from: f64,
    ) -> impl Iterator<Item = usize> + '_ {
        let line = LineThroughBoxes {
            origin: origin.to_array(),
            inverse: direction.recip().to_array(),
            from,
        };
        let found = self.boxes.locate_with_selection_function(line);
        found.map(|place| place.data)
    }

    fn crossing(&self, surface: usize, origin: DVec3, direction: DVec3) -> Option<Crossing> {
        let facet = &self.surfaces[surface].facet;
        let distance = facet.crossing(origin, direction)?;
        Some(Crossing {
            rank: distance,
            distance,
            cosine: facet.normal().dot(direction),
            surface,
        })
    }

    fn chord(&self, ends: [&Crossing; 2], origin: DVec3, direction: DVec3) -> Option<Chord> {
        let [leaving, arriving] = ends;
        let length = arriving.distance - leaving.distance;
        let cosines = [leaving.cosine, -arriving.cosine];
        if !(length > 0.0 && cosines.iter().all(|cosine| *cosine > 0.0)) {
            return None;
        }
        let row = |surface: usize| {
            let mut innermost = surface;
            while let Some(part) = self.surfaces[innermost]
                .parts
                .iter()
                .find(|part| self.surfaces[**part].facet.is_met(origin, direction))
            {
                innermost = *part;
            }
            self.surfaces[innermost].row
        };
        Some(Chord {
            rows: [row(leaving.surface)?, row(arriving.surface)?],
            cosines,
            square: length * length / self.sums.last()?,
        })
    }
}

impl Crossing {
    /// Along the line, the same for any order in which the crossings were found.
    fn order(&self, other: &Self) -> std::cmp::Ordering {
        let by_surface = self.surface.cmp(&other.surface);
        self.rank.total_cmp(&other.rank).then(by_surface)
    }

    fn precedes(&self, other: &Self) -> bool {
        self.order(other).is_lt()
    }
}

/// Boxes that a line enters.
struct LineThroughBoxes {
    origin: [f64; 3],
    inverse: [f64; 3],
    from: f64,
}

impl LineThroughBoxes {
    fn enters(&self, place: &AABB<[f64; 3]>) -> bool {
        let (mut from, mut to) = (self.from, f64::INFINITY);
        let (low, high) = (place.lower(), place.upper());
        for axis in 0..3 {
            // minima and maxima pass over 0/0, of a line in the plane of a side
            let [a, b] =
                [low, high].map(|end| (end[axis] - self.origin[axis]) * self.inverse[axis]);
            from = from.max(a.min(b));
            to = to.min(a.max(b));
        }
        from <= to
    }
}

impl<T: RTreeObject<Envelope = AABB<[f64; 3]>>> SelectionFunction<T> for LineThroughBoxes {
    fn should_unpack_parent(&self, envelope: &AABB<[f64; 3]>) -> bool {
        self.enters(envelope)
    }

    fn should_unpack_leaf(&self, leaf: &T) -> bool {
        self.enters(&leaf.envelope())
    }
}
