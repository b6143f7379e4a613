//! A pair of polygons, each clipped at the other's plane, with the measures that the choice of a
//! route rests on.
//!
//! `shape` measures one outline, once per polygon; `horizon` finds the part of it in front of the
//! other plane and bounds the displacement of its corners; [`ClippedPair`] here has the measures of
//! both: distances, heights, and an estimate of the value.

pub(crate) mod horizon;
pub(crate) mod shape;

use super::{Answer, ExchangeArea, FormFactorError, Polygon, Route};
use crate::form_factor::gauss::aspect::{Aspect, Placing, Rung};
use crate::form_factor::gauss::points::{Lines, Nodes, Rules};
use crate::numeric::real;
use glam::DVec3;
use horizon::{Displacement, FrontPart, Heights, side_of};
use shape::Shape;
use smallvec::SmallVec;
use std::f64::consts::PI;

/// The parts of a pair in front of each other's planes, with measures that the choice rests on.
pub(crate) struct ClippedPair<'a> {
    pub polygons: [&'a Polygon; 2],
    pub shapes: [&'a Shape; 2],
    pub heights: [&'a [f64]; 2],
    /// A lower bound on the distance between the two; not positive if they may touch.
    pub gap: f64,
    /// An upper bound on all distances.
    pub reach: f64,
    /// Bounds on the displacement of corners.
    pub displacement: Displacement,
    /// The largest height of each.
    highest: [f64; 2],
    /// `area × area × h_max g_max / (π gap⁴)`.
    pub largest: f64,
    /// Bounds on the change that displaced corners cause, per length: by flux through ribbons; for
    /// polygons apart, relative to the value, by other heights, and by other areas and distances.
    ribbons: f64,
    /// The most that a point of either receives, per area.
    received: f64,
    by_height: f64,
    by_place: f64,
    /// An idea of the value.
    pub estimate: f64,
    pub tolerance: f64,
    /// The rules that do on each by the bound relative to the value.
    rungs: [Rung; 2],
}

/// Clips a pair and hands it to `route`, which is not asked if one polygon is behind the other's
/// plane, or in it.
pub(crate) fn with_clipped_pair(
    polygons: [&Polygon; 2],
    tolerance: f64,
    route: impl FnOnce(&ClippedPair) -> Result<Answer, FormFactorError>,
) -> Result<Answer, FormFactorError> {
    let [first, second] = polygons;
    let [mut first_heights, mut second_heights] = [Heights::new(), Heights::new()];
    let (above_second, first_displacement) = side_of(first, second, &mut first_heights);
    let (above_first, second_displacement) = side_of(second, first, &mut second_heights);
    let displacement = first_displacement.and(second_displacement);
    let sides = [&above_second, &above_first];
    if !sides.iter().all(|side| side.is_in_front()) {
        let within = sides.iter().all(|side| matches!(side, FrontPart::Within));
        return Ok(Answer {
            exchange: ExchangeArea {
                value: 0.0,
                error: 2.0 * displacement.height * (first.perimeter() + second.perimeter())
                    + displacement.strip,
            },
            route: if within {
                Route::Coplanar
            } else {
                Route::BackFacing
            },
        });
    }
    let shapes = [
        above_second.shape(&first.shape),
        above_first.shape(&second.shape),
    ];
    let pair = ClippedPair::new(
        polygons,
        shapes,
        [&*first_heights, &*second_heights],
        displacement,
        tolerance,
    );
    route(&pair)
}

impl<'a> ClippedPair<'a> {
    fn new(
        polygons: [&'a Polygon; 2],
        shapes: [&'a Shape; 2],
        heights: [&'a [f64]; 2],
        displacement: Displacement,
        tolerance: f64,
    ) -> Self {
        let [first, second] = shapes;
        let between = second.centre - first.centre;
        let distance = between.length();
        let radii = first.radius + second.radius;
        let spans = heights.map(Span::of);
        let direction = between / distance;
        let apart = Apart::of(first, second, direction);
        // spheres do for polygons far apart
        let range = if distance > FAR * radii {
            [distance - radii, distance + radii]
        } else {
            let gap = apart.gap.max(spans[0].least).max(spans[1].least);
            [gap, farthest(first, second)]
        };
        let sizes = shapes.map(|shape| [shape.area, shape.perimeter]);
        let mut measures = Measures::of(sizes, spans, distance, range);
        for k in 0..2 {
            let lines = &shapes[k].lines;
            let placing = Placing {
                distance,
                radius: shapes[1 - k].radius,
                gap: measures.gap_of(apart.middles[k]),
                cosines: lines.directions.map(|along| along.dot(direction)),
                heights: [spans[k].least, spans[k].most],
                noise: 4.0 * f64::EPSILON * measures.reach,
                half: lines.half,
                middle: lines.middle,
                unevenness: lines.unevenness,
                spreads: lines.spreads,
            };
            measures.rungs[k] = Aspect::of(&placing).rung(relative_wanted(tolerance));
        }
        Self::measured(
            polygons,
            shapes,
            heights,
            displacement,
            &measures,
            tolerance,
        )
    }

    /// A pair in front of each other's planes with these measures.
    pub(crate) const fn measured(
        polygons: [&'a Polygon; 2],
        shapes: [&'a Shape; 2],
        heights: [&'a [f64]; 2],
        displacement: Displacement,
        measures: &Measures,
        tolerance: f64,
    ) -> Self {
        Self {
            polygons,
            shapes,
            heights,
            gap: measures.gap,
            reach: measures.reach,
            displacement,
            highest: measures.highest,
            largest: measures.largest,
            ribbons: measures.ribbons,
            received: measures.received,
            by_height: measures.by_height,
            by_place: measures.by_place,
            estimate: measures.estimate,
            tolerance,
            rungs: measures.rungs,
        }
    }

    /// Bounds the change of the exchange area caused by displaced corners. The kernel takes its
    /// heights from the corners', which are exact where a clip put them on the plane; for all
    /// others a corner out of place is at another height, too.
    pub(crate) fn slack(&self, displacement: Displacement, value: f64, route: Route) -> f64 {
        let Displacement {
            height,
            place,
            ribbon,
            strip,
            ..
        } = displacement;
        let heights = if route == Route::Kernel {
            height
        } else {
            height + place
        };
        let relative = heights * self.by_height + (height + place) * self.by_place;
        // a strip beside the plane sees polygons that are apart from it at grazing angles only
        let grazing = if self.gap > height {
            height / self.gap
        } else {
            1.0
        };
        (height * self.ribbons + ribbon * self.received).min(relative * value.abs())
            + strip * grazing * self.received
    }

    /// Bounds the change caused by points displaced by `place`: of heights and distances, but no
    /// area.
    pub(crate) fn moved(&self, place: f64, value: f64) -> f64 {
        let relative = self.by_height + 8.0 / self.gap;
        (place * self.ribbons).min(place * relative * value.abs())
    }

    /// The absolute error that truncation may have.
    pub(crate) fn wanted(&self) -> f64 {
        0.3 * self.tolerance.max(4.0 * f64::EPSILON) * self.estimate
    }

    /// Gauss points per direction on one of the shapes.
    pub(crate) fn points(&self, k: usize) -> usize {
        if self.rungs[k].points > 0 {
            return self.rungs[k].points;
        }
        let most = self.wanted() / (self.largest * 2.0 * self.shapes[k].peak);
        self.lines(k).points(most)
    }

    /// The lines along which a rule on one of the shapes runs.
    fn lines(&self, k: usize) -> Lines {
        let Shape {
            half_length, slope, ..
        } = self.shapes[k];
        Lines {
            gamma: self.gap / half_length,
            height: (half_length / self.highest[k]).min(0.5),
            jacobian: *slope,
        }
    }

    /// Rules on one of the shapes, and the vectors that they take.
    pub(crate) fn rules(&self, k: usize, points: usize) -> (Rules, usize) {
        let shape = self.shapes[k];
        let rules = self.lines(k).rules(points, shape);
        (rules, rules.blocks(shape))
    }

    /// The nodes of a rule on a shape of one cell.
    pub(crate) fn nodes(&self, k: usize, points: usize) -> &'static Nodes {
        let shape = self.shapes[k];
        self.lines(k).rules(points, shape).of(&shape.cells[0])
    }

    /// A bound on the error of a value by rules on some of the shapes.
    ///
    /// **Arguments** `rules`: which shape, and points a direction.
    ///
    /// With absolute bounds T on the errors of some and the others' relative to the exact value V,
    /// e in all, `|rule − V| ≤ T (1 + e) + (e + e²) V`, and V is at most the rule's value and this.
    pub(crate) fn truncation(&self, rules: &[(usize, usize)], value: f64) -> f64 {
        let (mut absolute, mut relative) = (0.0, 0.0);
        for (k, points) in rules {
            let rung = &self.rungs[*k];
            if rung.points == *points {
                relative += rung.error;
            } else {
                let error = self.lines(*k).error(*points);
                absolute += 2.0 * self.shapes[*k].peak * error * self.largest;
            }
        }
        debug_assert!(relative <= 2.0 * MOST_RELATIVE, "{relative}");
        let share = relative * (1.0 + relative);
        (absolute * (1.0 + relative) + share * value) / (1.0 - share)
    }
}

/// The error of a rule on one shape, relative to the value, that may be left: less than what
/// rounding leaves where the tolerance is tight, so that no digit of the default one is lost.
#[inline(always)]
pub(crate) fn relative_wanted(tolerance: f64) -> f64 {
    let share = if tolerance < TIGHT { 0.01 } else { 0.3 };
    let wanted = share * tolerance.max(4.0 * f64::EPSILON);
    if wanted < MOST_RELATIVE {
        wanted
    } else {
        MOST_RELATIVE
    }
}

/// The tolerance below which a rule's error is kept below rounding.
const TIGHT: f64 = 1e-10;

/// The largest such error: products of those of both shapes are little beside them.
const MOST_RELATIVE: f64 = 1.0 / 16.0;

/// Distances from which on spheres around polygons bound theirs, in sums of the radii.
pub(crate) const FAR: f64 = 4.0;

/// Measures of a pair by numbers alone, the fields of [`ClippedPair`].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Measures {
    pub gap: f64,
    pub reach: f64,
    pub highest: [f64; 2],
    pub largest: f64,
    pub ribbons: f64,
    pub received: f64,
    pub by_height: f64,
    pub by_place: f64,
    pub estimate: f64,
    pub rungs: [Rung; 2],
}

impl Measures {
    /// A lower bound on a distance that is at least the gap, and at least this but for rounding.
    #[inline(always)]
    pub(crate) fn gap_of(&self, apart: f64) -> f64 {
        let apart = apart - 8.0 * f64::EPSILON * self.reach;
        if apart > self.gap { apart } else { self.gap }
    }

    /// The measures of two shapes with these areas and perimeters: without a branch, so that it
    /// serves in the lanes of vectors.
    ///
    /// **Arguments** `distance`: of their centres; `gap`, `reach`: bounds on all distances, but
    /// for rounding.
    #[inline(always)]
    pub(crate) fn of(
        [[area, perimeter], [other_area, other_perimeter]]: [[f64; 2]; 2],
        spans: [Span; 2],
        distance: f64,
        [gap, reach]: [f64; 2],
    ) -> Self {
        let reach = reach * (1.0 + 4.0 * f64::EPSILON);
        let gap = gap - 8.0 * f64::EPSILON * reach;
        let gap = if gap > 0.0 { gap } else { 0.0 };
        let square = (reach / gap) * (reach / gap);
        // infinite if they may touch
        let spread = square * square;
        // heights h weighted by the kernel K: Σ K/Σ h K is at most 1/h_min, and at most
        // (K_max/K_min)/h_mean
        let sensitivity = |span: Span| (1.0 / span.least).min(spread / span.mean);
        let received = |area: f64| (area / (PI * gap * gap)).min(1.0);
        let ribbons = perimeter * received(other_area) + other_perimeter * received(area);
        // corners that are off by δ change heights, areas and r⁴, too: relative to the value
        let by_place = 4.0 / gap + perimeter / area + other_perimeter / other_area;
        // between the far formula and that of two patches near to each other
        let square = distance * distance + area.max(other_area) / PI;
        let means = spans[0].mean * spans[1].mean;
        let cosines = means / (distance * distance).max(means);
        let areas = area * other_area;
        let highest = [spans[0].most, spans[1].most];
        Self {
            gap,
            reach,
            highest,
            largest: areas * (highest[0] / gap) * (highest[1] / gap) / (PI * gap * gap),
            ribbons: 2.0 * ribbons,
            received: received(area).max(received(other_area)),
            by_height: 2.0 * (sensitivity(spans[0]) + sensitivity(spans[1])),
            by_place: 2.0 * by_place,
            estimate: areas * cosines / (PI * square),
            rungs: [Rung::default(); 2],
        }
    }
}

/// The heights of a shape's corners.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span {
    pub least: f64,
    pub mean: f64,
    pub most: f64,
}

impl Span {
    fn of(heights: &[f64]) -> Self {
        let (mut least, mut most, mut sum) = (f64::INFINITY, 0.0, 0.0);
        for height in heights {
            least = f64::min(least, *height);
            most = f64::max(most, *height);
            sum += height;
        }
        let mean = sum / real(heights.len());
        Self { least, mean, most }
    }
}

/// The largest distance of two corners.
fn farthest(first: &Shape, second: &Shape) -> f64 {
    let mut square = 0.0;
    for x in &first.corners {
        for y in &second.corners {
            square = f64::max(square, x.distance_squared(*y));
        }
    }
    square.sqrt()
}

/// Distances between planes across a direction, each touching what lies on one side; negative if
/// they do not part it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Apart {
    /// The distance of the polygons.
    pub gap: f64,
    /// The distance of the middles of one's lines, if it is a quadrilateral, from the other one.
    pub middles: [f64; 2],
}

impl Apart {
    fn of(first: &Shape, second: &Shape, direction: DVec3) -> Self {
        let along = |shape: &Shape| -> SmallVec<[f64; 8]> {
            let corners = shape.corners.iter();
            corners
                .map(|c| (*c - first.centre).dot(direction))
                .collect()
        };
        let (one, other) = (along(first), along(second));
        let four = |places: &[f64]| match *places {
            [a, b, c] => Some([a, b, c, c]),
            [a, b, c, d] => Some([a, b, c, d]),
            _ => None,
        };
        if let (Some(one), Some(other)) = (four(&one), four(&other)) {
            return Self::of_four(one, other);
        }
        let end = one.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let start = other.iter().copied().fold(f64::INFINITY, f64::min);
        Self {
            gap: start - end,
            middles: [start - end; 2],
        }
    }

    /// The distances for two quadrilaterals whose corners are at these places, or triangles, whose
    /// third counts twice.
    #[inline(always)]
    pub(crate) fn of_four([a, b, c, d]: [f64; 4], [e, f, g, h]: [f64; 4]) -> Self {
        let end = a.max(b).max(c).max(d);
        let start = e.min(f).min(g).min(h);
        let last = (a + b).max(b + c).max(c + d).max(d + a);
        let first = (e + f).min(f + g).min(g + h).min(h + e);
        Self {
            gap: start - end,
            middles: [start - 0.5 * last, 0.5 * first - end],
        }
    }
}

/// A bound on `θ/sin θ` for the angle θ that an edge subtends at a distance: with h = tan(θ/2) it
/// is `(1 + h²) atan h / h`, and `atan h ≤ h − h³/3 + h⁵/5`; beyond a right angle only that θ is at
/// most π.
pub(crate) fn widening(length: f64, distance: f64) -> f64 {
    let half = 0.5 * length / distance;
    let square = half * half;
    if square <= 1.0 {
        (1.0 + square) * (1.0 - square * (1.0 / 3.0 - 0.2 * square))
    } else {
        PI
    }
}
