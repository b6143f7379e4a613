//! The joints of surfaces: corners beside the edges of others, and the cracks that they leave.
//!
//! Corners that are exact lie on an edge or on none. Rounded ones lie beside it, by less than the
//! resolution explains, and leave a crack along the edge, or cover a strip twice.

use super::{NamedPatch, Scene};
use crate::geometry::Patch;
use crate::numeric::tolerance;
use glam::DVec3;
use rstar::primitives::{GeomWithData, Line};
use rstar::{PointDistance, RTree};

impl Scene {
    /// The joints at the corners of each patch.
    pub(super) fn corner_joints(&self) -> Vec<Vec<CornerJoint>> {
        let nearby = tolerance::BEND * self.resolution;
        let shapes = || self.patches.iter().map(NamedPatch::shape);
        let edges = EdgeTree::of(shapes());
        let joint = |index: usize, corner: DVec3| {
            let near: Vec<NearEdge> = edges.near(corner, index, nearby).collect();
            let distances = near.iter().map(|edge| edge.distance);
            let aside = distances.fold(f64::INFINITY, f64::min);
            CornerJoint {
                aside: if near.is_empty() { 0.0 } else { aside },
                near,
            }
        };
        let of_patch = |(index, shape): (usize, &Patch)| {
            let corners = shape.given_corners().iter();
            corners.map(|corner| joint(index, *corner)).collect()
        };
        shapes().enumerate().map(of_patch).collect()
    }

    /// The widths of the cracks along the edges of each patch: what its corners lie off the edges
    /// beside them and off the plane that the patch shares, what other corners lie off the edge,
    /// and what the patch was moved by when it was put flat. Corners farther off than a plane
    /// explains ([`tolerance::BEND`]) leave a gap, and no crack.
    pub(crate) fn cracks(&self) -> Vec<Vec<f64>> {
        let (planes, joints) = (self.planes(), self.corner_joints());
        let shapes = || self.patches.iter().map(NamedPatch::shape);
        let none = |shape: &Patch| vec![0.0_f64; shape.corners().len()];
        let mut widths: Vec<Vec<f64>> = shapes().map(none).collect();
        for (shape, joints) in shapes().zip(&joints) {
            for (corner, joint) in shape.given_corners().iter().zip(joints) {
                // a corner at the end of an edge is no joint of it
                let beside = joint.near.iter().filter(|edge| !edge.ends.contains(corner));
                for edge in beside {
                    let width = &mut widths[edge.surface][edge.place];
                    *width = width.max(edge.distance);
                }
            }
        }
        for (index, (shape, joints)) in shapes().zip(&joints).enumerate() {
            let (shared, unit) = (planes.facing(index), planes.unit());
            let corners = shape.given_corners().iter().zip(shape.corners());
            let off = corners.zip(joints).map(|((given, flat), joint)| {
                let height = unit * shared.height(*flat / unit).abs();
                given.distance(*flat) + height + joint.aside
            });
            let off: Vec<f64> = off.collect();
            for (place, width) in widths[index].iter_mut().enumerate() {
                *width += off[place].max(off[(place + 1) % off.len()]);
            }
        }
        widths
    }
}

/// A corner of a patch, and the edges of others that it lies beside.
pub(super) struct CornerJoint {
    near: Vec<NearEdge>,
    /// The distance of the nearest; 0 if none is near.
    pub aside: f64,
}

/// The edges of surfaces, by place.
pub(super) struct EdgeTree(RTree<GeomWithData<Line<[f64; 3]>, [usize; 2]>>);

/// An edge near a point.
pub(super) struct NearEdge {
    surface: usize,
    /// The place of the edge among those of the surface.
    place: usize,
    ends: [DVec3; 2],
    pub distance: f64,
}

impl NearEdge {
    /// Whether the distance of a corner with these edges is that of exactly parallel edges, or the
    /// corner would come to lie on the edge if one of the two were longer or shorter.
    pub(super) fn was_meant(&self, corner: DVec3, own: [DVec3; 2], rounding: f64) -> bool {
        let [from, to] = self.ends;
        let along = to - from;
        let share = (corner - from).dot(along) / along.length_squared();
        let offset = corner - (from + along * share.clamp(0.0, 1.0));
        let are_parallel = |one: DVec3, two: DVec3| {
            let [one_length, two_length] = [one.length(), two.length()];
            let sine = one.cross(two).length() / (one_length * two_length);
            sine * one_length.min(two_length) <= rounding
        };
        own.iter()
            .any(|own| are_parallel(*own, along) || are_parallel(*own, offset))
            || are_parallel(along, offset)
    }
}

impl EdgeTree {
    pub(super) fn of<'s>(shapes: impl Iterator<Item = &'s Patch>) -> Self {
        let edges = shapes.enumerate().flat_map(|(index, shape)| {
            let corners = shape.given_corners();
            let next = corners.iter().cycle().skip(1);
            let ends = corners.iter().zip(next).enumerate();
            ends.map(move |(place, (from, to))| {
                GeomWithData::new(Line::new(from.to_array(), to.to_array()), [index, place])
            })
        });
        Self(RTree::bulk_load(edges.collect()))
    }

    /// The edges of other surfaces within a distance of a point.
    pub(super) fn near(
        &self,
        point: DVec3,
        own: usize,
        distance: f64,
    ) -> impl Iterator<Item = NearEdge> + '_ {
        let near = self
            .0
            .locate_within_distance(point.to_array(), distance * distance);
        let near = near.filter(move |edge| edge.data[0] != own);
        near.map(move |edge| NearEdge {
            surface: edge.data[0],
            place: edge.data[1],
            ends: [edge.geom().from, edge.geom().to].map(DVec3::from_array),
            distance: edge.geom().distance_2(&point.to_array()).sqrt(),
        })
    }
}
