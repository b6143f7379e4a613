//! The faces through a stretch, like the pages of a book, and what a point sees past them.

use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// The set whose exchange is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// The part that is hidden, of all that would be seen.
    Hidden,
    /// The part that is seen.
    Seen,
}

/// The part of a region that counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    InShadow,
    Lit,
}

/// A page of the book: a face through the stretch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Page {
    pub angle: f64,
    pub is_second: bool,
}

/// The sectors around the line in which points of P lie, between the planes of pages: an angle
/// in each, and the inward normals of what bounds it.
///
/// **Arguments** `corners`: of P, from a point of the line.
pub(crate) fn sectors(
    pages: &[Page],
    corners: &[DVec3],
    (east, north): (DVec3, DVec3),
    touching: f64,
) -> Vec<(f64, Vec<DVec3>)> {
    let direction = |angle: f64| angle.cos() * east + angle.sin() * north;
    let mut planes: Vec<f64> = pages.iter().map(|page| page.angle.rem_euclid(PI)).collect();
    planes.sort_by(f64::total_cmp);
    planes.dedup_by(|next, last| (*next - *last).abs() <= touching.max(ONE_PLANE));
    let mut angles = planes.clone();
    angles.extend(planes.iter().map(|angle| angle + PI));
    angles.extend(planes.first().map(|first| first + TAU));
    let between = angles.windows(2).map(|pair| {
        let bounds = if planes.len() == 1 {
            vec![direction(pair[0] + 0.5 * PI)]
        } else {
            vec![direction(pair[0] + 0.5 * PI), direction(pair[1] - 0.5 * PI)]
        };
        (0.5 * (pair[0] + pair[1]), bounds)
    });
    let is_met = |(_, bounds): &(f64, Vec<DVec3>)| {
        let met = |normal: &DVec3| corners.iter().any(|corner| corner.dot(*normal) > touching);
        bounds.iter().all(met)
    };
    let mut met: Vec<(f64, Vec<DVec3>)> = between.filter(is_met).collect();
    for (_, bounds) in &mut met {
        let cuts = |normal: &DVec3| corners.iter().any(|c| c.dot(*normal) < -touching);
        bounds.retain(cuts);
    }
    met
}

/// The largest angle between planes of pages that count as one, and the rounding of angles and of
/// their sines.
pub(crate) fn spread(pages: &[Page], touching: f64) -> f64 {
    let mut planes: Vec<f64> = pages.iter().map(|page| page.angle.rem_euclid(PI)).collect();
    planes.sort_by(f64::total_cmp);
    let apart = planes.windows(2).map(|pair| pair[1] - pair[0]);
    let near = apart.filter(|angle| *angle <= touching.max(ONE_PLANE));
    near.sum::<f64>() + 8.0 * f64::EPSILON
}

/// The parts that count for a point at an angle, with their signs.
pub(crate) fn states(
    pages: &[Page],
    angle: f64,
    is_on_second: bool,
    wanted: Wanted,
) -> [(Part, f64); 2] {
    // the turn from the point to each page, by way of the left or of the right
    let side = |is_left: bool| {
        let turns = pages.iter().map(move |page| {
            let turn = if is_left {
                angle - page.angle
            } else {
                page.angle - angle
            };
            (turn.rem_euclid(TAU), page.is_second)
        });
        turns.filter(|(turn, _)| *turn > 0.0 && *turn < PI)
    };
    let count = |holds: bool| if holds { 1.0 } else { 0.0 };
    let state = |is_left: bool| {
        if !is_on_second {
            let is_hidden = side(is_left).next().is_some();
            return [1.0, count(is_hidden)];
        }
        let seen = side(is_left).find(|(_, is_second)| *is_second);
        let Some((depth, _)) = seen else {
            return [0.0, 0.0];
        };
        let is_hidden = side(is_left).any(|(turn, is_second)| !is_second && turn < depth);
        [1.0, count(is_hidden)]
    };
    let ([left, left_hidden], [right, right_hidden]) = (state(true), state(false));
    let (whole, hidden) = (left - right, left_hidden - right_hidden);
    match wanted {
        Wanted::Hidden => [(Part::InShadow, whole), (Part::Lit, hidden)],
        Wanted::Seen => [(Part::InShadow, 0.0), (Part::Lit, whole - hidden)],
    }
}

/// Planes at less than this angle are one.
const ONE_PLANE: f64 = 1e-12;
