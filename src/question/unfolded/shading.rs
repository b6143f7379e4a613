//! Leaves cut into cells over which a function hardly varies, each shaded by its value at the
//! middle.

use crate::geometry::{convex_pieces, mean};
use crate::hierarchy::{Element, HierarchyError};
use glam::DVec3;

/// The least differences that are drawn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fineness {
    pub(super) length: f64,
    pub(super) difference: f64,
}

/// A function of points; it has no value on a light.
pub(super) type Value<'f> = dyn Fn(DVec3) -> Result<Option<f64>, HierarchyError> + 'f;

/// A cell with its corners, and its shade.
type Cell = (Vec<DVec3>, Option<f64>);

/// The share of the way from a corner to the middle at which the function is asked for.
const INWARDS: f64 = 1e-3;

/// The cells of a leaf over which a function varies by no more than a fineness.
pub(super) fn cells(
    leaf: &Element,
    value: &Value<'_>,
    fineness: Fineness,
) -> Result<Vec<Cell>, HierarchyError> {
    let shape = leaf.shape();
    let pieces = convex_pieces(shape.corners(), shape.normal());
    let mut cells = Vec::new();
    for piece in pieces {
        if is_even(&piece, value, fineness)? {
            cells.push(piece);
            continue;
        }
        for corners in quadrilaterals(&piece) {
            divide(corners, value, fineness, &mut cells)?;
        }
    }
    let shaded = cells.into_iter().map(|cell| {
        let shade = value(mean(&cell))?;
        Ok((cell, shade))
    });
    shaded.collect()
}

/// The difference of two values, 0 for those of lights.
fn difference(one: Option<f64>, other: Option<f64>) -> f64 {
    one.zip(other)
        .map_or(0.0, |(one, other)| (one - other).abs())
}

/// Is the function the same all over a polygon, as far as is drawn?
fn is_even(
    corners: &[DVec3],
    value: &Value<'_>,
    fineness: Fineness,
) -> Result<bool, HierarchyError> {
    let middle = mean(corners);
    let there = value(middle)?;
    for corner in corners {
        let here = value(corner.lerp(middle, INWARDS))?;
        if difference(here, there) > fineness.difference {
            return Ok(false);
        }
    }
    Ok(true)
}

/// A convex polygon as quadrilaterals; a triangle is one with a corner twice.
fn quadrilaterals(corners: &[DVec3]) -> Vec<[DVec3; 4]> {
    if let [a, b, c, d] = *corners {
        return vec![[a, b, c, d]];
    }
    let rest = corners.windows(2).skip(1);
    rest.map(|side| [corners[0], side[0], side[1], side[1]])
        .collect()
}

/// Divides a quadrilateral by a grid as fine as the function varies along its edges.
fn divide(
    [a, b, c, d]: [DVec3; 4],
    value: &Value<'_>,
    fineness: Fineness,
    cells: &mut Vec<Vec<DVec3>>,
) -> Result<(), HierarchyError> {
    let middle = mean(&[a, b, c, d]);
    let along = |from: DVec3, to: DVec3| {
        let at = |place: f64| value(from.lerp(to, place).lerp(middle, INWARDS));
        let (first, half, last) = (at(0.0)?, at(0.5)?, at(1.0)?);
        let difference = difference(first, half) + difference(half, last);
        let by_length = from.distance(to) / fineness.length;
        Ok::<_, HierarchyError>(by_length.min(difference / fineness.difference).ceil())
    };
    let columns = along(a, b)?.max(along(d, c)?).max(1.0);
    let rows = along(a, d)?.max(along(b, c)?).max(1.0);
    let at = |column: f64, row: f64| {
        let (right, up) = (column / columns, row / rows);
        a.lerp(b, right).lerp(d.lerp(c, right), up)
    };
    let mut row = 0.0;
    while row < rows {
        let mut column = 0.0;
        while column < columns {
            cells.push(vec![
                at(column, row),
                at(column + 1.0, row),
                at(column + 1.0, row + 1.0),
                at(column, row + 1.0),
            ]);
            column += 1.0;
        }
        row += 1.0;
    }
    Ok(())
}
