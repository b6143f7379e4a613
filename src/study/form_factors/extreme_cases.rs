//! The extreme pairs, as a table.
//!
//! Aspect ratios, gaps, angles, distances, sizes, slivers and needles, and pairs that a move has
//! rounded. Numbers in the names are those of the shapes.

use super::families::facing;
use crate::geometry::{GeometryError, Patch};
use Shape::{Above, Diamond, Floor, Moved, Scaled, Triangle, Wall, Wing};
use glam::DVec3;

/// The effort that the exact value of a pair takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Effort {
    /// Well below a second.
    Little,
    /// Some seconds.
    Much,
}

/// A polygon, as data.
#[derive(Debug, Clone, Copy)]
enum Shape {
    /// A rectangle `width × depth` in the plane z = 0, from the origin along x and y.
    Floor(f64, f64),
    /// A rectangle at a height, `width × depth`, above the origin along x and y.
    Above(f64, f64, f64),
    /// A rectangle `length × height` in the plane x = 0, from the origin along y and z.
    Wall(f64, f64),
    /// The second of two unit squares with a common edge, at this angle in degrees.
    Wing(f64),
    /// A square turned by 45° at a height; its corners are exact.
    Diamond(f64),
    /// A triangle.
    Triangle([[f64; 3]; 3]),
    /// A shape, moved.
    Moved(&'static Self, [f64; 3]),
    /// A shape, scaled about the origin.
    Scaled(&'static Self, f64),
}

impl Shape {
    fn corners(self) -> Vec<DVec3> {
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        match self {
            Floor(width, depth) => rectangle(DVec3::ZERO, width * x, depth * y),
            Above(height, width, depth) => rectangle(height * z, width * x, depth * y),
            Wall(length, height) => rectangle(DVec3::ZERO, length * y, height * z),
            Wing(degrees) => {
                // the sine of the smaller angle, as 180° − 1e-6° has lost digits
                let acute = degrees.min(180.0 - degrees).to_radians();
                let cosine = acute.cos().copysign(90.0 - degrees);
                rectangle(DVec3::ZERO, y, DVec3::new(cosine, 0.0, acute.sin()))
            }
            Diamond(height) => [[0.5, -0.25], [1.25, 0.5], [0.5, 1.25], [-0.25, 0.5]]
                .map(|[x, y]| DVec3::new(x, y, height))
                .to_vec(),
            Triangle(corners) => corners.map(DVec3::from_array).to_vec(),
            Moved(shape, shift) => moved(&shape.corners(), DVec3::from_array(shift)),
            Scaled(shape, factor) => scaled(&shape.corners(), factor),
        }
    }
}

fn rectangle(origin: DVec3, u: DVec3, v: DVec3) -> Vec<DVec3> {
    vec![origin, origin + u, origin + u + v, origin + v]
}

fn moved(corners: &[DVec3], shift: DVec3) -> Vec<DVec3> {
    corners.iter().map(|corner| *corner + shift).collect()
}

fn scaled(corners: &[DVec3], factor: f64) -> Vec<DVec3> {
    corners.iter().map(|corner| *corner * factor).collect()
}

/// An extreme pair.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExtremePair {
    /// The name of the pair.
    pub(crate) name: &'static str,
    /// The effort that its exact value takes.
    pub(crate) effort: Effort,
    shapes: [Shape; 2],
    change: Change,
}

/// A change of both shapes, after each was turned to face the other.
#[derive(Debug, Clone, Copy)]
enum Change {
    None,
    /// Another size: turned before, as products of such coordinates leave the range.
    Sized(f64),
    /// Moved by so much along (1, 1, −1)/3: rounding takes digits before any route sees the pair.
    Moved(f64),
}

impl ExtremePair {
    const fn sized(mut self, factor: f64) -> Self {
        self.change = Change::Sized(factor);
        self
    }

    const fn moved(mut self, by: f64) -> Self {
        self.change = Change::Moved(by);
        self
    }

    /// The patches as rounded, each turned to face the other.
    pub(crate) fn patches(&self) -> Result<[Patch; 2], GeometryError> {
        let [first, second] = self.shapes.map(Shape::corners);
        let change = |corners: &[DVec3]| match self.change {
            Change::None => corners.to_vec(),
            Change::Sized(factor) => scaled(corners, factor),
            Change::Moved(by) => moved(corners, by * DVec3::new(1.0, 1.0, -1.0) / 3.0),
        };
        match self.change {
            Change::Sized(_) => {
                let [first, second] = [facing(&first, &second), facing(&second, &first)];
                pair(&change(&first), &change(&second))
            }
            Change::None | Change::Moved(_) => pair(&change(&first), &change(&second)),
        }
    }

    /// The patches before a move rounded them; `None` if they were not moved.
    pub(crate) fn meant(&self) -> Result<Option<[Patch; 2]>, GeometryError> {
        let [first, second] = self.shapes.map(Shape::corners);
        let was_moved = matches!(self.change, Change::Moved(_));
        was_moved.then(|| pair(&first, &second)).transpose()
    }
}

/// Patches with these corners, each turned to face the other.
fn pair(first: &[DVec3], second: &[DVec3]) -> Result<[Patch; 2], GeometryError> {
    Ok([
        Patch::try_new(facing(first, second))?,
        Patch::try_new(facing(second, first))?,
    ])
}

const fn little(name: &'static str, first: Shape, second: Shape) -> ExtremePair {
    of_effort(Effort::Little, name, [first, second])
}

const fn much(name: &'static str, first: Shape, second: Shape) -> ExtremePair {
    of_effort(Effort::Much, name, [first, second])
}

const fn of_effort(effort: Effort, name: &'static str, shapes: [Shape; 2]) -> ExtremePair {
    ExtremePair {
        name,
        effort,
        shapes,
        change: Change::None,
    }
}

const SQUARE: Shape = Floor(1.0, 1.0);
const WALL: Shape = Wall(1.0, 1.0);
const OPPOSITE: Shape = Above(1.0, 1.0, 1.0);
const LEANING: Shape = Triangle([[0.2, 0.1, 0.7], [0.9, 0.3, 1.1], [0.4, 0.8, 0.5]]);
const LYING: Shape = Triangle([[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [0.3, 0.9, 0.1]]);
const NEAR_CORNER: Shape = Triangle([[0.0, 0.0, 1e-12], [0.7, -0.4, 0.9], [-0.5, 0.3, 0.8]]);
const SLIVER: Shape = Triangle([[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-9, 0.0]]);
const UPRIGHT: Shape = Triangle([[0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.0, 1e-9]]);
const STEEP: Shape = Triangle([[0.0; 3], [1.0, 0.0, 0.0], [0.3, 0.2, 0.9]]);
const NEEDLE: Shape = Triangle([[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1e-9, 0.0]]);
const AT_NEEDLE: Shape = Triangle([[0.0; 3], [0.2, 1.0, 0.4], [-0.3, 0.1, 0.8]]);
const ACROSS: Shape = Triangle([[0.5, -0.5, 0.5], [0.5, 0.5, 0.5], [0.5, 0.5, 0.500_000_001]]);
const DIPPING: Shape = Triangle([[0.2, 0.3, -0.5], [0.9, 0.1, 1e-9], [0.4, 0.8, -0.2]]);
/// A square a little off the wall's foot.
const BESIDE: Shape = Moved(&SQUARE, [1e-12, 0.0, 0.0]);
const GAPING: Shape = Moved(&Wing(60.0), [-1e-12, 0.0, 0.0]);
const FAR: Shape = Moved(&LEANING, [6e5, -3e5, 7e5]);
const GRAZING: Shape = Moved(&WALL, [1e6, 3e5, 0.0]);
const TINY: Shape = Moved(&Scaled(&LEANING, 1e-9), [0.25, 0.25, 0.5]);
/// A strip a billionth as wide as long.
const STRIP: Shape = Floor(1.0, 1e-9);

/// The pairs of the study, one a line.
#[rustfmt::skip]
pub(crate) const PAIRS: &[ExtremePair] = &[
    // aspect ratios
    little("facing, 1 × 1e9, 1 apart", Floor(1.0, 1e9), Above(1.0, 1.0, 1e9)),
    little("facing, 1 × 1e-9, 1 apart", STRIP, Above(1.0, 1.0, 1e-9)),
    little("facing, 1 × 1e-9 and 1e9 × 1", STRIP, Above(1.0, 1e9, 1.0)),
    little("turned by 45°, 1 × 1e-9 and a square", STRIP, Diamond(1.0)),
    little("common edge, depths 1 and 1e-9", SQUARE, Wall(1.0, 1e-9)),
    little("common edge, depths 1 and 1e9", SQUARE, Wall(1.0, 1e9)),
    little("common edge, depths 1e-9 and 1e9", Floor(1e-9, 1.0), Wall(1.0, 1e9)),
    little("common edge 1e9 long, depths 1", Floor(1.0, 1e9), Wall(1e9, 1.0)),
    // gaps
    little("facing, 1e-12 apart", SQUARE, Above(1e-12, 1.0, 1.0)),
    much("facing, turned by 45°, 1e-12 apart", SQUARE, Diamond(1e-12)),
    much("perpendicular, gap 1e-12", BESIDE, WALL),
    much("at 60°, gap 1e-12", SQUARE, GAPING),
    much("triangles, corners 1e-12 apart", LYING, NEAR_CORNER),
    // angles
    much("common edge, 0.000001°", SQUARE, Wing(1e-6)),
    much("common edge, 0.001°", SQUARE, Wing(1e-3)),
    much("common edge, 1°", SQUARE, Wing(1.0)),
    much("common edge, 60°", SQUARE, Wing(60.0)),
    much("common edge, 120°", SQUARE, Wing(120.0)),
    much("common edge, 179°", SQUARE, Wing(179.0)),
    much("common edge, 180° − 1e-3°", SQUARE, Wing(180.0 - 1e-3)),
    much("common edge, 180° − 1e-6°", SQUARE, Wing(180.0 - 1e-6)),
    little("common edge, 90°", SQUARE, WALL),
    // distances
    little("facing, 1e6 apart", SQUARE, Above(1e6, 1.0, 1.0)),
    little("triangles, 1e6 apart", LYING, FAR),
    little("perpendicular, 1e6 apart", SQUARE, GRAZING),
    // sizes
    little("facing, size 1e-150", SQUARE, OPPOSITE).sized(1e-150),
    little("common edge, size 1e-150", SQUARE, WALL).sized(1e-150),
    little("triangles, size 1e-150", LYING, LEANING).sized(1e-150),
    little("facing, size 1e150", SQUARE, OPPOSITE).sized(1e150),
    little("common edge, size 1e150", SQUARE, WALL).sized(1e150),
    little("triangles, size 1e150", LYING, LEANING).sized(1e150),
    little("triangles, sizes 1 and 1e-9", LYING, TINY),
    // slivers and needles
    much("slivers 1e-9 thick, common edge, 90°", SLIVER, UPRIGHT),
    much("sliver 1e-9 thick, common edge", SLIVER, STEEP),
    much("needle 1e-9 wide, common corner", NEEDLE, AT_NEEDLE),
    little("needle 1e-9 wide", NEEDLE, LEANING),
    little("needles 1e-9 wide, crossed", NEEDLE, ACROSS),
    // horizons
    much("1e-9 above the horizon", SQUARE, DIPPING),
    // moved
    little("triangles, moved by 1e9", LYING, LEANING).moved(1e9),
    little("triangles, moved by 1e3", LYING, LEANING).moved(1e3),
    much("slivers 1e-9 thick, moved by 1", SLIVER, STEEP).moved(1.0),
];
