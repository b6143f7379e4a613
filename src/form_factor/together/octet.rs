//! Eight pairs side by side, and their measures.

use super::Asked;
use crate::form_factor::Polygon;
use crate::form_factor::clipped_pair::horizon::Displacement;
use crate::form_factor::clipped_pair::{Apart, ClippedPair, FAR, Measures, Span, relative_wanted};
use crate::form_factor::gauss::aspect::{Aspect, AspectLanes, Placing, RungLanes, SERIES, Series};
use crate::numeric::{LANES, Lanes, real, vector_value};

/// Three coordinates of eight points.
pub(super) type Points = [Lanes; 3];

/// The first or second polygons of eight pairs. The fourth corner of a triangle is its third.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    pub corners: [Points; 4],
    pub jacobian: Points,
    normal: Points,
    pub centre: Points,
    radius: Lanes,
    largest: Lanes,
    tilt: Lanes,
    area: Lanes,
    perimeter: Lanes,
    count: Lanes,
    lines: LinesLanes,
}

/// The fields of `CellLines`.
#[derive(Debug, Clone, Copy)]
struct LinesLanes {
    half: Lanes,
    middle: Lanes,
    directions: [Points; 2],
    spreads: [Lanes; 2],
    unevenness: Lanes,
}

const NOTHING: Side = Side {
    corners: [[[0.0; LANES]; 3]; 4],
    jacobian: [[0.0; LANES]; 3],
    normal: [[0.0; LANES]; 3],
    centre: [[0.0; LANES]; 3],
    radius: [0.0; LANES],
    largest: [0.0; LANES],
    tilt: [0.0; LANES],
    area: [0.0; LANES],
    perimeter: [0.0; LANES],
    count: [0.0; LANES],
    lines: LinesLanes {
        half: [0.0; LANES],
        middle: [0.0; LANES],
        directions: [[[0.0; LANES]; 3]; 2],
        spreads: [[0.0; LANES]; 2],
        unevenness: [0.0; LANES],
    },
};

impl Side {
    #[inline(always)]
    fn put(&mut self, lane: usize, polygon: &Polygon) {
        let shape = &polygon.shape;
        let last = shape.corners.len() - 1;
        for (k, corner) in self.corners.iter_mut().enumerate() {
            let from = shape.corners[k.min(last)];
            corner[0][lane] = from.x;
            corner[1][lane] = from.y;
            corner[2][lane] = from.z;
        }
        for axis in 0..3 {
            self.jacobian[axis][lane] = shape.jacobians[0][axis];
            self.normal[axis][lane] = polygon.normal[axis];
            self.centre[axis][lane] = shape.centre[axis];
        }
        self.radius[lane] = shape.radius;
        self.largest[lane] = shape.largest;
        self.tilt[lane] = polygon.tilt;
        self.area[lane] = shape.area;
        self.perimeter[lane] = shape.perimeter;
        self.count[lane] = real(last + 1);
        let (lines, from) = (&mut self.lines, &shape.lines);
        lines.half[lane] = from.half;
        lines.middle[lane] = from.middle;
        for k in 0..2 {
            for axis in 0..3 {
                lines.directions[k][axis][lane] = from.directions[k][axis];
            }
            lines.spreads[k][lane] = from.spreads[k];
        }
        lines.unevenness[lane] = from.unevenness;
    }
}

/// Eight pairs side by side.
#[derive(Debug)]
pub(super) struct Octet<'p> {
    pub sides: [Side; 2],
    /// The polygons that the sides hold: one that stays is not put again.
    held: [[Option<&'p Polygon>; LANES]; 2],
    tolerances: Lanes,
    /// The lanes that hold polygons of one cell.
    is_held: [bool; LANES],
}

impl<'p> Octet<'p> {
    /// None yet.
    pub(super) const fn new() -> Self {
        Self {
            sides: [NOTHING; 2],
            held: [[None; LANES]; 2],
            tolerances: [0.0; LANES],
            is_held: [false; LANES],
        }
    }

    /// Takes up to eight pairs, in the first lanes; what others hold means nothing.
    pub(super) fn fill<'a>(&mut self, pairs: impl Iterator<Item = &'a Asked<'p>>)
    where
        'p: 'a,
    {
        for (lane, (polygons, tolerance)) in pairs.take(LANES).enumerate() {
            self.tolerances[lane] = tolerance.max(0.0);
            for (k, polygon) in polygons.iter().copied().enumerate() {
                let is_there = self.held[k][lane].is_some_and(|held| std::ptr::eq(held, polygon));
                if !is_there {
                    self.sides[k].put(lane, polygon);
                    self.held[k][lane] = Some(polygon);
                }
            }
            let are_aligned = polygons.iter().all(|polygon| polygon.rectangle.is_some());
            let has_one_cell = |polygon: &&Polygon| polygon.shape.cells.len() == 1;
            self.is_held[lane] = !are_aligned && polygons.iter().all(has_one_cell);
        }
    }

    /// The measures of all.
    pub(super) fn measured(&self) -> Measured {
        let (sides, is_held, tolerances) = (&self.sides, self.is_held, &self.tolerances);
        let series = SERIES.as_slice();
        vector_value!(
            Measured::default(),
            measured(sides, is_held, tolerances, series)
        )
    }
}

/// The measures of eight pairs.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Measured {
    /// The heights of each polygon's corners above the other's plane.
    heights: [[Lanes; 4]; 2],
    /// The larger distance by which the planes are off at the other polygon.
    tilted: Lanes,
    gap: Lanes,
    reach: Lanes,
    highest: [Lanes; 2],
    largest: Lanes,
    ribbons: Lanes,
    received: Lanes,
    by_height: Lanes,
    by_place: Lanes,
    estimate: Lanes,
    rungs: [RungLanes; 2],
    is_served: [bool; LANES],
}

impl Measured {
    /// Whether a pair can be answered from its measures.
    pub(super) const fn is_served(&self, lane: usize) -> bool {
        self.is_served[lane]
    }

    /// The distance by which the planes of a pair are off at the other polygon.
    pub(super) const fn tilted(&self, lane: usize) -> f64 {
        self.tilted[lane]
    }

    /// The measures of a pair.
    pub(super) fn measures(&self, lane: usize) -> Measures {
        Measures {
            gap: self.gap[lane],
            reach: self.reach[lane],
            highest: [self.highest[0][lane], self.highest[1][lane]],
            largest: self.largest[lane],
            ribbons: self.ribbons[lane],
            received: self.received[lane],
            by_height: self.by_height[lane],
            by_place: self.by_place[lane],
            estimate: self.estimate[lane],
            rungs: self.rungs.map(|rungs| rungs.at(lane)),
        }
    }

    /// The heights of the corners of a pair.
    pub(super) fn heights_of(&self, lane: usize) -> [[f64; 4]; 2] {
        self.heights.map(|heights| heights.map(|lanes| lanes[lane]))
    }
}

/// A pair with these measures.
pub(super) fn pair<'p>(
    ([first, second], tolerance): &Asked<'p>,
    [on_first, on_second]: &'p [[f64; 4]; 2],
    measures: &Measures,
    tilted: f64,
) -> ClippedPair<'p> {
    let corners = [first, second].map(|polygon| polygon.shape.corners.len());
    ClippedPair::measured(
        [first, second],
        [&first.shape, &second.shape],
        [&on_first[..corners[0]], &on_second[..corners[1]]],
        Displacement {
            height: tilted,
            ..Displacement::default()
        },
        measures,
        tolerance.max(0.0),
    )
}

/// `(x − y)·n`, by lane.
#[inline(always)]
fn product(x: &Points, y: &Points, n: &Points, lane: usize) -> f64 {
    (x[0][lane] - y[0][lane]) * n[0][lane]
        + (x[1][lane] - y[1][lane]) * n[1][lane]
        + (x[2][lane] - y[2][lane]) * n[2][lane]
}

/// `|x − y|²`, by lane.
#[inline(always)]
fn squared_distance(x: &Points, y: &Points, lane: usize) -> f64 {
    let (a, b, c) = (
        x[0][lane] - y[0][lane],
        x[1][lane] - y[1][lane],
        x[2][lane] - y[2][lane],
    );
    a * a + b * b + c * c
}

#[inline(always)]
fn measured(
    sides: &[Side; 2],
    is_held: [bool; LANES],
    tolerances: &Lanes,
    series: &[Series],
) -> Measured {
    let mut out = Measured::default();
    let mut spans = [[[0.0; LANES]; 3]; 2];
    let mut is_sure = [[1.0; LANES]; 2];
    for side in 0..2 {
        let (polygon, plane) = (&sides[side], &sides[1 - side]);
        heights(
            polygon,
            plane,
            &mut out,
            side,
            &mut spans[side],
            &mut is_sure[side],
        );
    }
    let [first, second] = sides;
    let (near, far, middles) = distances(sides, &spans);
    let mut aspects = [AspectLanes::default(); 2];
    let mut wanted = [0.0; LANES];
    for l in 0..LANES {
        let distance = squared_distance(&second.centre, &first.centre, l).sqrt();
        let radii = first.radius[l] + second.radius[l];
        let is_far = distance > FAR * radii;
        let gap = if is_far { distance - radii } else { near[l] };
        let reach = if is_far { distance + radii } else { far[l] };
        let sizes = [
            [first.area[l], first.perimeter[l]],
            [second.area[l], second.perimeter[l]],
        ];
        let span = |[least, mean, most]: &[Lanes; 3]| Span {
            least: least[l],
            mean: mean[l],
            most: most[l],
        };
        let both = [span(&spans[0]), span(&spans[1])];
        let measures = Measures::of(sizes, both, distance, [gap, reach]);
        out.gap[l] = measures.gap;
        out.reach[l] = measures.reach;
        out.highest[0][l] = measures.highest[0];
        out.highest[1][l] = measures.highest[1];
        out.largest[l] = measures.largest;
        out.ribbons[l] = measures.ribbons;
        out.received[l] = measures.received;
        out.by_height[l] = measures.by_height;
        out.by_place[l] = measures.by_place;
        out.estimate[l] = measures.estimate;
        wanted[l] = relative_wanted(tolerances[l]);
        for k in 0..2 {
            let (radius, gap) = (sides[1 - k].radius[l], measures.gap_of(middles[k][l]));
            aspects[k].put(
                l,
                &aspect(
                    sides,
                    k,
                    l,
                    &both[k],
                    [distance, radius, gap, measures.reach],
                ),
            );
        }
    }
    for (out, aspects) in out.rungs.iter_mut().zip(&mut aspects) {
        *out = aspects.rungs(&wanted, series);
    }
    for l in 0..LANES {
        let reach = out.reach[l];
        out.is_served[l] = is_held[l]
            && is_sure[0][l] > 0.0
            && is_sure[1][l] > 0.0
            && reach > 1e-59
            && reach < 1e59;
    }
    out
}

/// The aspect of one polygon's lines, by lane.
#[inline(always)]
fn aspect(
    sides: &[Side; 2],
    k: usize,
    l: usize,
    heights: &Span,
    [distance, radius, gap, reach]: [f64; 4],
) -> Aspect {
    let [first, second] = sides;
    let towards = |axis: usize| (second.centre[axis][l] - first.centre[axis][l]) / distance;
    let [x, y, z] = [towards(0), towards(1), towards(2)];
    let lines = &sides[k].lines;
    let cosine = |along: &Points| along[0][l] * x + along[1][l] * y + along[2][l] * z;
    Aspect::of(&Placing {
        distance,
        radius,
        gap,
        cosines: [cosine(&lines.directions[0]), cosine(&lines.directions[1])],
        heights: [heights.least, heights.most],
        noise: 4.0 * f64::EPSILON * reach,
        half: lines.half[l],
        middle: lines.middle[l],
        unevenness: lines.unevenness[l],
        spreads: [lines.spreads[0][l], lines.spreads[1][l]],
    })
}

/// The heights of one side's corners above the other's planes, as `side_of` takes them where all
/// are certainly in front.
#[inline(always)]
fn heights(
    polygon: &Side,
    plane: &Side,
    out: &mut Measured,
    side: usize,
    [least, mean, most]: &mut [Lanes; 3],
    is_sure: &mut Lanes,
) {
    let origin = &plane.corners[0];
    for l in 0..LANES {
        let farthest = origin[0][l].abs().max(origin[1][l].abs());
        let farthest = farthest.max(origin[2][l].abs());
        let noise = 4.0 * f64::EPSILON * (polygon.largest[l] + farthest);
        let distance = squared_distance(&polygon.centre, origin, l).sqrt() + polygon.radius[l];
        out.tilted[l] = f64::max(out.tilted[l], plane.tilt[l] * distance);
        let certain = 4.0 * f64::EPSILON * distance + 64.0 * noise;
        let h = [
            product(&polygon.corners[0], origin, &plane.normal, l),
            product(&polygon.corners[1], origin, &plane.normal, l),
            product(&polygon.corners[2], origin, &plane.normal, l),
            product(&polygon.corners[3], origin, &plane.normal, l),
        ];
        least[l] = h[0].min(h[1]).min(h[2]).min(h[3]);
        most[l] = h[0].max(h[1]).max(h[2]).max(h[3]);
        let three = h[0] + h[1] + h[2];
        let sum = if polygon.count[l] > 3.0 {
            three + h[3]
        } else {
            three
        };
        mean[l] = sum / polygon.count[l];
        is_sure[l] = if least[l] > certain { 1.0 } else { 0.0 };
        for (heights, h) in out.heights[side].iter_mut().zip(h) {
            heights[l] = h;
        }
    }
}

/// A lower and an upper bound on the distances of polygons near each other, and the distances of
/// planes that [`Apart`] has for middles of lines.
#[inline(always)]
fn distances([first, second]: &[Side; 2], spans: &[[Lanes; 3]; 2]) -> (Lanes, Lanes, [Lanes; 2]) {
    let (mut near, mut far) = ([0.0; LANES], [0.0; LANES]);
    let mut middles = [[0.0; LANES]; 2];
    for l in 0..LANES {
        let distance = squared_distance(&second.centre, &first.centre, l).sqrt();
        let along = |axis: usize| (second.centre[axis][l] - first.centre[axis][l]) / distance;
        let direction = [along(0), along(1), along(2)];
        let reached = |corner: &Points| {
            (corner[0][l] - first.centre[0][l]) * direction[0]
                + (corner[1][l] - first.centre[1][l]) * direction[1]
                + (corner[2][l] - first.centre[2][l]) * direction[2]
        };
        let places = |side: &Side| {
            let [a, b, c, d] = &side.corners;
            [reached(a), reached(b), reached(c), reached(d)]
        };
        let apart = Apart::of_four(places(first), places(second));
        near[l] = apart.gap.max(spans[0][0][l]).max(spans[1][0][l]);
        middles[0][l] = apart.middles[0];
        middles[1][l] = apart.middles[1];
    }
    for x in &first.corners {
        for y in &second.corners {
            for (l, far) in far.iter_mut().enumerate() {
                *far = f64::max(*far, squared_distance(x, y, l));
            }
        }
    }
    for far in &mut far {
        *far = far.sqrt();
    }
    (near, far, middles)
}
