//! The parts of edges that run along each other.

use glam::DVec3;

/// An edge of a polygon, from corner to corner.
pub(super) type Edge = [DVec3; 2];

/// The part of an edge along which another one runs the opposite way, as places from 0 to 1 on it;
/// coordinates are known to `noise`.
pub(super) fn shared(edge: Edge, other: Edge, noise: f64) -> Option<[f64; 2]> {
    let along = edge[1] - edge[0];
    let length = along.length();
    if length <= noise {
        return None;
    }
    let direction = along / length;
    let is_beside = |point: DVec3| (point - edge[0]).cross(direction).length() <= noise;
    if !other.into_iter().all(is_beside) {
        return None;
    }
    let [from, to] = other.map(|point| (point - edge[0]).dot(direction));
    let part = [to.max(0.0), from.min(length)];
    (part[1] - part[0] > noise).then(|| part.map(|place| place / length))
}

/// The edge between two places from 0 to 1.
pub(super) fn part_of(edge: Edge, places: [f64; 2]) -> Edge {
    places.map(|place| edge[0].lerp(edge[1], place))
}

/// The parts of an edge that these leave over.
pub(super) fn left_over(edge: Edge, mut taken: Vec<[f64; 2]>, noise: f64) -> Vec<Edge> {
    let noise = noise / edge[0].distance(edge[1]);
    taken.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let mut from = 0.0;
    let mut left = Vec::new();
    for [start, end] in taken.into_iter().chain([[1.0, 1.0]]) {
        if start > from + noise {
            left.push(part_of(edge, [from, start]));
        }
        from = end.max(from);
    }
    left
}
