//! Faces that are not planar, split on request.

use glam::DVec3;
use infoscene::geometry::{GeometryError, Patch};
use infoscene::numeric::tolerance;
use infoscene::scene::Scene;
use infoscene::scene::files::{Fault, FileErrors, NonPlanarFaces, Source, read_obj};
use proptest::prelude::*;

fn face(corners: &[DVec3], faces: NonPlanarFaces) -> Result<Vec<Patch>, FileErrors> {
    let mut text = String::new();
    for DVec3 { x, y, z } in corners {
        text.push_str(&format!("v {x:?} {y:?} {z:?}\n"));
    }
    text.push('f');
    for index in 1..=corners.len() {
        text.push_str(&format!(" {index}"));
    }
    let loaded = read_obj(&Source::new("face.obj", text), &super::no_library, faces)?;
    Ok(loaded
        .scene
        .patches()
        .iter()
        .map(|patch| patch.shape().clone())
        .collect())
}

fn triangles(corners: &[DVec3]) -> Vec<Patch> {
    face(corners, NonPlanarFaces::Triangulate).unwrap()
}

/// The left wall of the Cornell box: cut along the diagonal that keeps the room convex, as its file
/// does by hand.
#[test]
fn a_bulging_wall_keeps_its_room_convex() {
    let corners = [
        [552.8, 0.0, 0.0],
        [549.6, 0.0, 559.2],
        [556.0, 548.8, 559.2],
        [556.0, 548.8, 0.0],
    ];
    let corners = corners.map(DVec3::from_array);
    let room = Scene::built_in("cornell-box").unwrap();
    let by_hand = room
        .patches()
        .iter()
        .filter(|patch| patch.name().starts_with("left wall"));
    let by_hand: Vec<Patch> = by_hand.map(|patch| patch.shape().clone()).collect();
    assert_eq!(triangles(&corners), by_hand);
    // 3.2 between the diagonals, shared by four corners
    let refusals = face(&corners, NonPlanarFaces::Refuse).unwrap_err();
    let refusal = &refusals.told()[0];
    assert_eq!(
        (refusal.line, refusal.patch.as_deref()),
        (Some(5), Some("0 (face 0)"))
    );
    let Fault::Geometry {
        source: GeometryError::NotPlanar { deviation, .. },
    } = refusal.fault
    else {
        panic!("{refusal}")
    };
    assert!((0.8..=3.2).contains(&deviation), "{deviation}");
    assert!(
        refusal
            .to_string()
            .contains("into triangles, or let its reader"),
        "{refusal}"
    );
}

/// A dart has one diagonal inside, whichever way it is folded.
#[test]
fn a_dart_is_cut_through_its_reflex_corner() {
    for height in [-0.1, 0.1] {
        let corners = [
            [0.0, 0.0, 0.0],
            [2.0, 0.0, height],
            [0.5, 0.5, 0.0],
            [0.0, 2.0, 0.0],
        ];
        let corners = corners.map(DVec3::from_array);
        let found = triangles(&corners);
        let expected = [[0, 1, 2], [0, 2, 3]].map(|triangle| triangle.map(|k| corners[k]).to_vec());
        let found: Vec<Vec<DVec3>> = found.iter().map(|patch| patch.corners().to_vec()).collect();
        assert_eq!(found, expected);
    }
}

/// The choice does not depend on the unit of length: products of coordinates are as large as 1e450
/// here, as small as 1e-360.
#[test]
fn the_same_triangles_are_found_at_any_scale() {
    let corners = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.1],
        [2.0, 2.0, 0.0],
        [0.5, 1.0, 0.2],
        [0.0, 2.0, 0.0],
    ];
    let place = |scale: f64| {
        let corners = corners.map(|corner| scale * DVec3::from_array(corner));
        let found = triangles(&corners);
        let places = found.iter().map(|patch| {
            let place = |corner| corners.iter().position(|other| other == corner);
            patch.corners().iter().map(place).collect()
        });
        places.collect::<Vec<Vec<_>>>()
    };
    assert_eq!(place(1.0).len(), 3);
    for exponent in [-120, 150] {
        assert_eq!(place(10f64.powi(exponent)), place(1.0));
    }
}

#[test]
fn planar_faces_stay_whole() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    assert_eq!(triangles(&square).len(), 1);
}

#[test]
fn a_crossing_outline_is_no_face_of_triangles_either() {
    let corners = [
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, 0.1],
        [0.0, 1.5, 0.0],
    ];
    let refusal = face(&corners.map(DVec3::from_array), NonPlanarFaces::Triangulate).unwrap_err();
    let is_crossing = matches!(
        refusal.told()[0].fault,
        Fault::Geometry {
            source: GeometryError::NotSimple { .. }
        }
    );
    assert!(is_crossing, "{refusal}");
}

/// Corners at increasing angles around the origin, on a circle or at free distances, lifted off
/// their plane.
fn outline(radius: impl Strategy<Value = f64>) -> impl Strategy<Value = Vec<DVec3>> {
    let corner = (0.1..1.0f64, radius, -0.1..0.1f64);
    proptest::collection::vec(corner, 4..12).prop_map(|corners| {
        let whole: f64 = corners.iter().map(|(angle, ..)| angle).sum();
        let mut turned = 0.0;
        let place = |(angle, radius, height): (f64, f64, f64)| {
            turned += angle / whole * std::f64::consts::TAU;
            DVec3::new(radius * f64::cos(turned), radius * f64::sin(turned), height)
        };
        corners.into_iter().map(place).collect()
    })
}

proptest! {
    /// A face splits into n − 2 triangles with the corners of the face; each edge inside is met by
    /// its reverse, so that the outline is what remains; all fronts on the same side of the mean
    /// plane.
    #[test]
    fn triangles_make_up_the_face(corners in outline(0.9..1.0f64)) {
        let found = triangles(&corners);
        prop_assert_eq!(found.len(), corners.len() - 2);
        let place = |corner: &DVec3| corners.iter().position(|other| other == corner).unwrap();
        let mut edges = Vec::new();
        for patch in &found {
            let [a, b, c] = [0, 1, 2].map(|k| place(&patch.corners()[k]));
            for edge in [(a, b), (b, c), (c, a)] {
                match edges.iter().position(|other| *other == (edge.1, edge.0)) {
                    Some(reverse) => {
                        edges.remove(reverse);
                    }
                    None => edges.push(edge),
                }
            }
        }
        edges.sort_unstable();
        let outline: Vec<(usize, usize)> = (0..corners.len())
            .map(|k| (k, (k + 1) % corners.len()))
            .collect();
        prop_assert_eq!(edges, outline);
        let whole: DVec3 = found
            .iter()
            .map(|patch| patch.area() * patch.normal())
            .sum();
        for patch in &found {
            prop_assert!(patch.normal().dot(whole) > 0.0);
        }
    }

    /// The triangles of a convex outline are a hull: every corner is in front of every triangle.
    #[test]
    fn triangles_of_a_convex_outline_leave_a_convex_front(corners in outline(Just(1.0))) {
        for patch in triangles(&corners) {
            for corner in &corners {
                let height = (*corner - patch.corners()[0]).dot(patch.normal());
                // a normal is known to ε over the least height of its triangle, some 1e-3 here
                prop_assert!(height >= -tolerance::PLANARITY, "{}", height);
            }
        }
    }
}
