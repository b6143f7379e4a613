//! Exchange areas past polygons that stand in the way, by a rule over the area of one polygon.
//!
//! ```text
//!   A_P F_PQ = ∫_P F(x) dA        F(x): form factor from the point x past the blockers, in closed
//!                                 form (form_factor::point_form_factor_past)
//! ```
//!
//! F bends along lines of discontinuity: planes through a vertex and an edge of two polygons, and
//! the planes of the polygons, where they meet P (`lines`). P is cut along them into convex cells,
//! and each cell into triangles with one corner and half a side of it (`rules`): towards these, and
//! nowhere else, F may be singular. A Gauss rule is doubled on each triangle until two agree; where
//! they do not, a double-exponential rule in both directions is, too.
//!
//! The error is an *estimate*: the difference of the last two rules, which says nothing certain.
//!
//! **Not covered**: curves on which three edges are seen concurrent, with two blockers and more.
//! Cells that they cross converge slowly, and the estimate says so.

mod lines;
mod rules;

use crate::form_factor::{FormFactorError, Occluders, Polygon, Viewpoint};
use crate::geometry::{Patch, convex_pieces};
use crate::numeric::{Bounded, CompensatedSum, try_parallel_map};
use glam::{DVec2, DVec3};
use lines::Chart;

/// The exchange area of two polygons past others, about to an error of `tolerance` of the whole
/// unoccluded value of a point, π being far.
///
/// **Arguments** `tolerance`: relative to the area of the first polygon, 1e-14 or more.
/// **Returns** the value with an estimate of its error, in squared units of length.
///
/// # Errors
/// As [`point_form_factor_past`](crate::form_factor::point_form_factor_past).
pub fn exchange_area_past(
    first: &Patch,
    second: &Patch,
    blockers: &[Patch],
    tolerance: f64,
) -> Result<Bounded, FormFactorError> {
    let polygons: Vec<Polygon> = blockers.iter().map(Polygon::new).collect();
    let polygons: Vec<&Polygon> = polygons.iter().collect();
    let occluders = Occluders {
        polygons: &polygons,
        touching: 0.0,
    };
    let receiver = Polygon::new(second);
    let chart = Chart::of(first);
    let seen = |at: DVec2| {
        let view = Viewpoint::try_new(chart.point(at), first.normal(), 0.0)?;
        let blockers = occluders.polygons.iter().map(|one| view.sight(one));
        let blockers = blockers.collect::<Result<Vec<_>, _>>()?;
        let part = view.form_factor(&view.sight(&receiver)?, blockers.iter());
        Ok::<_, FormFactorError>(part.value)
    };
    let scene: Vec<&[DVec3]> = std::iter::once(second.corners())
        .chain(blockers.iter().map(Patch::corners))
        .collect();
    let cuts = lines::cuts(&chart, &scene, second.normal());
    let mut cells = Vec::new();
    for piece in convex_pieces(first.corners(), first.normal()) {
        let outline = piece.iter().map(|corner| chart.flat(*corner)).collect();
        cells.extend(lines::cells(outline, &cuts));
    }
    let each = tolerance * first.area();
    let share = |cell: &Vec<DVec2>| each * (rules::area(cell) / first.area()).max(1e-3);
    let parts = try_parallel_map(cells.len(), &|cell| {
        rules::integral(&cells[cell], &seen, share(&cells[cell]))
    })?;
    let (mut value, mut error) = (CompensatedSum::default(), 0.0);
    for part in parts {
        value.add(part.value);
        error += part.error;
    }
    Ok(Bounded::estimate(value.total(), error))
}
