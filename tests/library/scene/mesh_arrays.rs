//! Faces in arrays: the same scene as in a file, and refusals that name faces.

use infoscene::geometry::GeometryError;
use infoscene::scene::files::{Fault, MeshArrays, NonPlanarFaces, Reading, Source, read_obj};

/// A square folded along its diagonal by so much, and a triangle beside it.
fn folded(height: f64) -> MeshArrays {
    MeshArrays {
        vertices: vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, height],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 2.0],
        ],
        corners: vec![0, 1, 2, 3, 0, 3, 4],
        offsets: vec![0, 4, 7],
        is_single: false,
    }
}

fn faults(mesh: &MeshArrays) -> Vec<(Option<String>, Fault)> {
    let refused = mesh.scene(&[], Reading::default()).unwrap_err();
    let told = refused.told().iter();
    told.map(|one| (one.patch.clone(), one.fault.clone()))
        .collect()
}

#[test]
fn arrays_are_the_scene_of_the_same_file() {
    let loaded = folded(0.0).scene(&[], Reading::default()).unwrap();
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 2\nf 1 2 3 4\nf 1 4 5\n";
    let source = Source::new("same.obj", text);
    let of_file = read_obj(&source, &|_| unreachable!(), Reading::default()).unwrap();
    let shapes = |scene: &infoscene::Scene| -> Vec<_> {
        scene
            .patches()
            .iter()
            .map(|patch| patch.shape().clone())
            .collect()
    };
    assert_eq!(shapes(&loaded.scene), shapes(&of_file.scene));
    assert_eq!(loaded.scene.group_names(), ["face 0", "face 1"]);
    assert!(loaded.notes.is_empty());
}

#[test]
fn a_face_stays_one_row_whatever_becomes_of_it() {
    let reading = NonPlanarFaces::Triangulate;
    let mut mesh = folded(0.1);
    let loaded = mesh.scene(&[], reading).unwrap();
    assert_eq!(
        (loaded.scene.patches().len(), loaded.scene.group_count()),
        (3, 2)
    );
    // a face on one line has no area
    mesh.corners.extend([0, 1, 1]);
    mesh.offsets = vec![0, 4, 7, 10];
    let loaded = mesh.scene(&[], reading).unwrap();
    assert_eq!(loaded.scene.row_areas()[2], 0.0);
    assert!(
        loaded.notes[0].ends_with("(first: face 2)"),
        "{:?}",
        loaded.notes
    );
}

#[test]
fn coordinates_of_32_bits_may_be_off_by_their_last_place() {
    // 2⁻²² bends the square by no more than such coordinates are known
    let mesh = MeshArrays {
        is_single: true,
        ..folded(2.0_f64.powi(-22))
    };
    let resolution = mesh
        .scene(&[], Reading::default())
        .unwrap()
        .scene
        .resolution();
    assert!(resolution > 1e-8 && resolution < 1e-6, "{resolution}");
    let exact = MeshArrays {
        is_single: false,
        ..mesh
    };
    assert!(matches!(
        faults(&exact)[..],
        [(
            Some(_),
            Fault::Geometry {
                source: GeometryError::NotPlanar { .. }
            }
        )]
    ));
}

#[test]
fn faces_are_refused_by_their_numbers() {
    let wrong = |vertex| MeshArrays {
        corners: vec![0, 1, 2, 3, 0, 3, vertex],
        ..folded(0.0)
    };
    for vertex in [-1, 5, i64::MAX] {
        let found = faults(&wrong(vertex));
        let expected = Fault::NotAVertex {
            corner: 2,
            vertex,
            vertices: 5,
        };
        assert_eq!(found, [(Some("1 (face 1)".to_owned()), expected)]);
    }
    // the shapes of faces are told only where all vertices are there
    let both = MeshArrays {
        corners: vec![0, 1, 2, 3, 0, 3, 5],
        ..folded(0.1)
    };
    assert_eq!(faults(&both).len(), 1);
    assert_eq!(faults(&folded(0.1))[0].0.as_deref(), Some("0 (face 0)"));
}

#[test]
fn offsets_must_divide_the_corners() {
    for (offsets, place, offset) in [
        (vec![1, 7], 0, 1),
        (vec![0, 5, 4, 7], 2, 4),
        (vec![0, 4, 8], 2, 8),
        (vec![0, 4], 1, 4),
        (vec![0, -4, 7], 1, -4),
        (vec![], 0, 0),
    ] {
        let mesh = MeshArrays {
            offsets,
            ..folded(0.0)
        };
        let expected = Fault::NotAnOffset {
            place,
            offset,
            corners: 7,
        };
        assert_eq!(faults(&mesh), [(None, expected)]);
    }
}

#[test]
fn obstacles_only_obstruct() {
    let obstacle = folded(0.0);
    let loaded = folded(0.0).scene(&[obstacle], Reading::default()).unwrap();
    assert_eq!(loaded.scene.patches().len(), 2);
    let names: Vec<_> = loaded
        .scene
        .obstructions()
        .iter()
        .map(|one| one.name())
        .collect();
    assert_eq!(names, ["obstacle 0 face 0", "obstacle 0 face 1"]);
}
