//! The exchange area of two planar polygons as a double integral over their edges.
//!
//! For polygons P and Q that see each other wholly, both given counter-clockwise
//! as seen from their fronts, Stokes' theorem applied twice gives
//!
//! ```text
//! A_P F_PQ = 1/(2π) ∮_P ∮_Q ln r  dr_P · dr_Q
//!          = 1/(2π) Σ_edges e of P Σ_edges f of Q  (e·f) ∫₀¹ ∫₀¹ ln r(s, t) dt ds,
//! ```
//!
//! where e and f are the edge vectors. The inner integral is elementary: with v the
//! coordinate along f of the edge's points, counted from the foot of the
//! perpendicular from the outer point, and d the length of that perpendicular,
//!
//! ```text
//! ∫ ln √(v² + d²) dv = v ln r − v + d atan(v/d).
//! ```
//!
//! The outer integral is done by quadrature. Its integrand is singular where the
//! outer point, moved along the complexified line of e, meets an end of f or the line
//! of f itself. Edges at right angles contribute nothing.

use crate::precision::Real;
use crate::quadrature::{Level, Singularity};

/// A point or vector of space.
pub type Point = [Real; 3];

/// A planar polygon by its corners, counter-clockwise as seen from its front.
pub type Polygon = Vec<Point>;

fn minus(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|k| &a[k] - &b[k])
}

fn dot(a: &Point, b: &Point) -> Real {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &a[i] * &b[j] - &a[j] * &b[i]
    })
}

fn along(start: &Point, edge: &Point, s: &Real) -> Point {
    std::array::from_fn(|k| &start[k] + s * &edge[k])
}

/// Start and vector of every edge.
fn edges(polygon: &Polygon) -> Vec<(Point, Point)> {
    let next = polygon.iter().cycle().skip(1);
    let pairs = polygon.iter().zip(next);
    pairs.map(|(a, b)| (a.clone(), minus(b, a))).collect()
}

/// The area of a polygon: half the length of Σ (corner × next corner).
pub fn area(polygon: &Polygon) -> Real {
    let mut sum: Point = std::array::from_fn(|_| Real::int(0));
    for (start, edge) in edges(polygon) {
        let term = cross(&start, &edge);
        sum = std::array::from_fn(|k| &sum[k] + &term[k]);
    }
    dot(&sum, &sum).sqrt().half()
}

/// The exchange area `A_P F_PQ` of two polygons.
pub fn exchange_area(p: &Polygon, q: &Polygon, level: &Level) -> Real {
    let mut sum = Real::int(0);
    for outer in &edges(p) {
        for inner in &edges(q) {
            let cosine = dot(&outer.1, &inner.1);
            if !cosine.is_zero() {
                sum += cosine * mean_logarithm(outer, inner, level);
            }
        }
    }
    sum / (Real::int(2) * Real::pi())
}

/// ∫₀¹ ∫₀¹ ln r dt ds for one pair of edges.
fn mean_logarithm(outer: &(Point, Point), inner: &(Point, Point), level: &Level) -> Real {
    let length = dot(&inner.1, &inner.1).sqrt();
    let direction: Point = std::array::from_fn(|k| &inner.1[k] / &length);
    let mut sum = Real::int(0);
    level.visit(
        &Real::int(0),
        &Real::int(1),
        &singularities(outer, inner),
        |s, weight| {
            let point = along(&outer.0, &outer.1, s);
            sum += weight * inner_integral(&point, &inner.0, &direction, &length);
        },
    );
    sum / length
}

/// ∫ ln r along the segment from `start` of the given direction and length.
fn inner_integral(point: &Point, start: &Point, direction: &Point, length: &Real) -> Real {
    let to_start = minus(start, point);
    let sideways = cross(&to_start, direction);
    let distance_squared = dot(&sideways, &sideways);
    let from = dot(&to_start, direction);
    let to = &from + length;
    let along_it = |v: &Real| {
        let square = v.squared() + &distance_squared;
        if square.is_zero() {
            square
        } else {
            v * square.ln().half()
        }
    };
    let mut integral = along_it(&to) - along_it(&from) - length;
    if !distance_squared.is_zero() {
        let distance = distance_squared.sqrt();
        let angle = (to / &distance).atan() - (from / &distance).atan();
        integral += distance * angle;
    }
    integral
}

/// The singularities of the outer integrand, in the parameter s of the outer edge.
fn singularities(outer: &(Point, Point), inner: &(Point, Point)) -> Vec<Singularity> {
    let (start, edge) = outer;
    let squared_length = dot(edge, edge);
    let mut found: Vec<Singularity> = Vec::new();
    // The two ends of the inner edge.
    for t in [Real::int(0), Real::int(1)] {
        let end = along(&inner.0, &inner.1, &t);
        let s = dot(&minus(&end, start), edge) / &squared_length;
        let sideways = minus(&end, &along(start, edge, &s));
        let height = (dot(&sideways, &sideways) / &squared_length).sqrt();
        add(&mut found, s, height);
    }
    // Where the two lines come closest: there d² = |e × f|²/|f|² (s − s*)² + D².
    let normal = cross(edge, &inner.1);
    let normal_squared = dot(&normal, &normal);
    if normal_squared > negligible() {
        let between = minus(&inner.0, start);
        let s = dot(&cross(&between, &inner.1), &normal) / &normal_squared;
        let gap = dot(&between, &normal).abs() / &normal_squared;
        let height = gap * dot(&inner.1, &inner.1).sqrt();
        add(&mut found, s, height);
    }
    found
}

/// Rounding errors are below this, lengths of the scenes above.
fn negligible() -> Real {
    Real::decimal("1e-40")
}

/// Adds a singularity, snapped to the ends of the edge and to earlier ones.
fn add(found: &mut Vec<Singularity>, s: Real, height: Real) {
    let known = [Real::int(0), Real::int(1)];
    let places = known.into_iter().chain(found.iter().map(|e| e.at.clone()));
    let place = places.into_iter().find(|p| (p - &s).abs() < negligible());
    let at = place.unwrap_or(s);
    let height = if height < negligible() {
        Real::int(0)
    } else {
        height
    };
    found.push(Singularity { at, height });
}
