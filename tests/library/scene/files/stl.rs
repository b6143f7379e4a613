//! The content of an STL file, binary and as text, judged by the crate `stl_io` and by the form
//! factors of the unit cube.

use super::{obj, stl};
use glam::DVec3;
use infoscene::scene::files::{Fault, LoadedScene, write_obj, write_stl};
use infoscene::scene::{Material, NamedPatch, Scene};
use proptest::prelude::*;
use std::fmt::Write;
use std::io::Cursor;
use stl_io::{Normal, Triangle, Vertex};

/// The inside of the unit cube: a face is the four corners of a square, halved along the diagonal
/// from its first corner.
const FACES: [[[u8; 3]; 4]; 6] = [
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
    [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]],
    [[0, 0, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1]],
    [[1, 0, 0], [1, 0, 1], [1, 1, 1], [1, 1, 0]],
    [[0, 0, 0], [0, 0, 1], [1, 0, 1], [1, 0, 0]],
    [[0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]],
];

/// The form factors of opposite and of adjacent faces of a cube: Howell, C-11 and C-14, in closed
/// form.
const OPPOSITE: f64 = 0.199_824_895_698_387_38;
const ADJACENT: f64 = 0.200_043_776_075_403_16;

fn triangles() -> Vec<Triangle> {
    let halves = FACES.iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let triangles = halves.map(|corners| {
        let vertices = corners.map(|corner| Vertex::new(corner.map(f32::from)));
        let [a, b, c] = corners.map(|corner| DVec3::from_array(corner.map(f64::from)));
        let normal = (b - a).cross(c - a).normalize().as_vec3();
        Triangle {
            normal: Normal::new(normal.to_array()),
            vertices,
        }
    });
    triangles.collect()
}

/// A binary file as `stl_io` writes it.
fn binary(triangles: &[Triangle]) -> Vec<u8> {
    let mut bytes = Vec::new();
    stl_io::write_stl(&mut bytes, triangles.iter()).unwrap();
    bytes
}

/// A text with a solid of this name.
fn text(name: &str, triangles: &[Triangle]) -> String {
    let mut text = format!("solid {name}\n");
    for Triangle { normal, vertices } in triangles {
        let [x, y, z] = normal.0;
        write!(text, " facet normal {x} {y} {z}\n  outer loop\n").unwrap();
        for Vertex { 0: [x, y, z] } in vertices {
            writeln!(text, "   vertex {x} {y} {z}").unwrap();
        }
        text += "  endloop\n endfacet\n";
    }
    text + &format!("endsolid {name}\n")
}

fn names(loaded: &LoadedScene) -> Vec<&str> {
    let patches = loaded.scene.patches().iter();
    patches.map(NamedPatch::name).collect()
}

fn corners(loaded: &LoadedScene) -> Vec<Vec<DVec3>> {
    let patches = loaded.scene.patches().iter();
    patches
        .map(|patch| patch.shape().corners().to_vec())
        .collect()
}

/// Two triangles make up each face: what they exchange adds up to what the face does.
#[test]
fn a_cube_of_triangles_exchanges_as_a_cube() {
    let text = stl(text("cube", &triangles())).unwrap();
    let binary = stl(binary(&triangles())).unwrap();
    assert_eq!(corners(&text), corners(&binary));
    assert!(text.notes.is_empty() && binary.notes.is_empty());
    let areas = text.scene.exchange_areas().unwrap();
    for (face, opposite) in [(0, 1), (2, 3), (4, 5)] {
        for (from, to) in (0..6).map(|other| (face, other)).filter(|(i, j)| i != j) {
            let halves = |face: usize| [2 * face, 2 * face + 1];
            let pairs = halves(from).into_iter();
            let pairs = pairs.flat_map(|from| halves(to).map(|to| areas.get(from, to).exchange));
            let (value, error) = pairs.fold((0.0, 0.0), |(value, error), pair| {
                (value + pair.value, error + pair.error)
            });
            let expected = if to == opposite { OPPOSITE } else { ADJACENT };
            // the last places of the expected value, and of the sum
            assert!(
                (value - expected).abs() <= error + 1e-16,
                "{from} {to} {value}"
            );
            assert!(error < 1e-12);
        }
    }
}

#[test]
fn facets_are_named_after_their_solid() {
    let two = &triangles()[..2];
    let several = text("floor", two) + &text("", two) + &text("a  wall\t", &two[..1]);
    let several = several + &text("floor", &two[1..]);
    let loaded = stl(several).unwrap();
    assert_eq!(
        names(&loaded),
        [
            "floor 0", "floor 1", "facet 0", "facet 1", "a wall 0", "floor 2"
        ]
    );
    assert_eq!(names(&stl(binary(two)).unwrap()), ["facet 0", "facet 1"]);
    // the solid is the object
    assert_eq!(loaded.scene.groups_named("floor"), [0, 1, 5]);
}

/// Decimals stay what they are in 64 bits: as numbers of 32 bits 0.1 would be off by 1.5e-9.
#[test]
fn the_decimals_of_a_text_are_kept() {
    let loaded = stl(
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0.1 0 0\nvertex 0.7 1e-3 0\n\
        vertex 0.1 .3 -0\nendloop\nendfacet\nendsolid",
    )
    .unwrap();
    let expected = [[0.1, 0.0, 0.0], [0.7, 1e-3, 0.0], [0.1, 0.3, 0.0]];
    assert_eq!(corners(&loaded), [expected.map(DVec3::from_array)]);
}

#[test]
fn the_same_text_may_be_written_in_many_ways() {
    let plain = text("room", &triangles());
    let loaded = stl(plain.as_str()).unwrap();
    for other in [
        plain.to_uppercase().replace("ROOM", "room"),
        plain.replace('\n', "\r\n"),
        plain.replace(' ', "\t"),
        plain.replace('\n', "\n\n  "),
        format!("\u{feff}{plain}"),
        format!("\n{plain}"),
        plain.replace("endsolid room", "endsolid"),
        plain.replace("facet normal", "facet NORMAL"),
    ] {
        assert_eq!(stl(other.as_str()).unwrap(), loaded, "{other}");
    }
}

/// Normals are not used: whether they are there, are zero or no numbers; those that contradict the
/// corners are counted.
#[test]
fn the_order_of_the_corners_says_which_side_is_the_front() {
    let plain = text("room", &triangles());
    let loaded = stl(plain.as_str()).unwrap();
    let without = |normal: &str| {
        let lines = plain.lines().map(|line| match line.split_once("normal") {
            Some((head, _)) => format!("{head}{normal}"),
            None => line.to_owned(),
        });
        lines.collect::<Vec<_>>().join("\n")
    };
    for normal in ["normal 0 0 0", "normal nan nan nan", "normal", ""] {
        assert_eq!(stl(without(normal)).unwrap(), loaded, "{normal}");
    }
    let up = stl(without("normal 0 0 1")).unwrap();
    assert_eq!(up.scene, loaded.scene);
    // of the floor's two, the ceiling's two and eight of the walls, the ceiling looks down
    let [note] = up.notes.as_slice() else {
        panic!("{:?}", up.notes)
    };
    assert!(
        note.starts_with("room.stl: 2 normals point to the back"),
        "{note}"
    );
    let mut turned = triangles();
    for triangle in &mut turned[3..6] {
        triangle.normal.0 = triangle.normal.0.map(|x| -x);
    }
    let turned = stl(binary(&turned)).unwrap();
    assert_eq!(corners(&turned), corners(&loaded));
    assert!(turned.notes[0].contains("3 normals"), "{:?}", turned.notes);
}

/// The length decides: exporters write `solid` into the heads of binary files, too.
#[test]
fn a_binary_file_may_begin_with_solid() {
    let plain = binary(&triangles());
    let loaded = stl(plain.clone()).unwrap();
    for head in [
        "solid cube",
        "solid cube\nfacet normal 0 0 1\n",
        "COLOR=\0\0\0\0",
    ] {
        let mut bytes = plain.clone();
        bytes[..80].fill(b' ');
        bytes[..head.len()].copy_from_slice(head.as_bytes());
        assert_eq!(stl(bytes.clone()).unwrap(), loaded);
        // and with a wrong length, since zeros are in no text
        bytes.push(7);
        assert_eq!(stl(bytes).unwrap().scene, loaded.scene);
    }
    let mut coloured = plain;
    for facet in coloured[84..].chunks_exact_mut(50) {
        facet[48..].copy_from_slice(b"\xff\x7f");
    }
    assert_eq!(stl(coloured).unwrap(), loaded);
}

/// A head that counts too much is of a file that was cut short; what follows the last facet is
/// left out, and said.
#[test]
fn the_head_counts_the_facets() {
    let plain = binary(&triangles());
    let count = |count: u32| {
        let mut bytes = plain.clone();
        bytes[80..84].copy_from_slice(&count.to_le_bytes());
        stl(bytes)
    };
    for more in [13, u32::MAX] {
        let refusal = count(more).unwrap_err();
        let missing = Fault::FacetsMissing {
            counted: more as usize,
            held: 12,
        };
        assert_eq!(refusal.told()[0].fault, missing);
    }
    let fewer = count(10).unwrap();
    assert_eq!(fewer.scene.patches().len(), 10);
    assert!(
        fewer.notes[0].contains("100 bytes after the last of 10"),
        "{:?}",
        fewer.notes
    );
    assert!(matches!(
        count(0).unwrap_err().told()[0].fault,
        Fault::NoPatch { .. }
    ));
    for length in 0..plain.len() {
        let refusal = stl(&plain[..length]).unwrap_err();
        let says = if length < 84 {
            "a head of 84 bytes"
        } else {
            "cut short"
        };
        assert!(refusal.to_string().contains(says), "{length}: {refusal}");
    }
}

#[test]
fn what_is_no_facet_is_refused_with_its_place() {
    let mut spoilt = triangles();
    spoilt[7].vertices[1].0[2] = f32::NAN;
    let refusal = stl(binary(&spoilt)).unwrap_err().to_string();
    assert!(
        refusal.starts_with("room.stl, patch 7 (facet 7): corner 1"),
        "{refusal}"
    );
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n\
        endloop\nendfacet\n";
    let solid = format!("solid a\n{facet}endsolid a\n");
    for (from, to, line, says) in [
        (
            "vertex 1 0 0",
            "vertex 1 nan 0",
            5,
            "y is \"nan\": write a finite number",
        ),
        (
            "vertex 1 0 0",
            "vertex 1 0,5 0",
            5,
            "y is \"0,5\": write a number",
        ),
        ("vertex 1 0 0", "vertex 1 0", 5, "z is missing"),
        (
            "vertex 1 0 0",
            "vertex 1 0 0 1",
            5,
            "\"1\" is one value too many",
        ),
        ("vertex 1 0 0\n", "", 7, "a vertex of the facet is missing"),
        (
            "endloop",
            "vertex 1 1 0\nendloop",
            7,
            "more than three vertices is not supported",
        ),
        (
            "vertex 1 0 0",
            "corner 1 0 0",
            8,
            "a vertex of the facet is missing",
        ),
        ("endfacet\n", "", 8, "\"endsolid\" belongs after"),
        (
            "outer loop\n",
            "endfacet\n",
            3,
            "a vertex of the facet is missing",
        ),
        ("facet normal 0 0 1\n", "", 2, "\"outer\" belongs between"),
        ("endsolid a\n", "", 8, "\"endsolid\" is missing: add it"),
        (
            "endsolid a",
            "solid b\nendsolid",
            9,
            "\"endsolid\" is missing: add it",
        ),
        (
            "endsolid a\n",
            "endsolid a\nendsolid a",
            10,
            "\"endsolid\" belongs after \"solid",
        ),
        (facet, "", 0, "it has no patch: a facet with an area begins"),
    ] {
        let refusal = stl(solid.replacen(from, to, 1)).unwrap_err();
        let [fault] = refusal.told() else {
            panic!("{refusal}")
        };
        assert_eq!(fault.line.unwrap_or(0), line, "{refusal}");
        assert!(refusal.to_string().contains(says), "{refusal}");
    }
    // each fault once, and what is unknown is no fault
    let several = solid.replace("vertex 1 0 0", "vertex 1 0 x") + &solid.replace("loop\n", "lop\n");
    let refusal = stl(several + "colour 1 0 0\nendsolid").unwrap_err();
    let lines: Vec<_> = refusal.told().iter().map(|fault| fault.line).collect();
    assert_eq!(lines, [Some(5), Some(20)], "{refusal}");
    for no_stl in ["", "v 0 0 0\n", "solidarity", &"noise ".repeat(100)] {
        assert!(stl(no_stl).is_err(), "{no_stl}");
    }
}

/// A facet without area is a row that exchanges nothing, so that all others keep their numbers.
#[test]
fn a_facet_without_area_keeps_its_number() {
    let mut with_sliver = triangles();
    with_sliver[4].vertices[2] = with_sliver[4].vertices[1];
    let mut with_line = with_sliver.clone();
    with_line[4].vertices = [[0.0; 3], [0.5; 3], [1.0; 3]].map(Vertex::new);
    for triangles in [with_sliver, with_line] {
        let loaded = stl(binary(&triangles)).unwrap();
        assert_eq!(loaded.notes.len(), 1, "{:?}", loaded.notes);
        assert!(
            loaded.notes[0].ends_with("(first: facet 4)"),
            "{:?}",
            loaded.notes
        );
        assert_eq!(loaded.scene.group_names()[5], "facet 5");
        assert_eq!(loaded.scene.row_areas()[3..6], [0.5, 0.0, 0.5]);
        assert_eq!(stl(text("", &triangles)).unwrap().scene, loaded.scene);
        let written = write_stl(&loaded.scene).unwrap();
        assert_eq!(stl(written.bytes).unwrap().scene, loaded.scene);
    }
}

/// Written files are read alike by `stl_io`, and read back with coordinates of 32 bits.
#[test]
fn written_triangles_read_back() {
    let cube = stl(binary(&triangles())).unwrap();
    let written = write_stl(&cube.scene).unwrap();
    assert_eq!(written.losses.len(), 1, "{:?}", written.losses);
    assert!(written.losses[0].contains("names"));
    assert_eq!(stl(written.bytes.clone()).unwrap().scene, cube.scene);
    let mesh = stl_io::read_stl(&mut Cursor::new(written.bytes)).unwrap();
    assert_eq!(mesh.into_triangle_vec(), triangles());
    let grey = Material::try_new(0.5, 0.0).unwrap();
    let text = "v 0 0 0\nv 0.1 0 0\nv 0 1e4 0\nf 1 2 3";
    let patch = obj(text).unwrap().scene.patches()[0].clone();
    let scene = Scene::try_new(vec![patch.with_material(grey)]).unwrap();
    let losses = write_stl(&scene).unwrap().losses;
    // 0.1 in 24 bits is 0.100000001490116
    let says = ["names", "become black", "by up to 1.5e-9"];
    assert_eq!(losses.len(), 3);
    assert!(
        losses
            .iter()
            .zip(says)
            .all(|(loss, part)| loss.contains(part)),
        "{losses:?}"
    );
}

#[test]
fn what_stl_cannot_say_is_refused() {
    let cube = Scene::built_in("cube:1").unwrap();
    let triangle = stl(binary(&triangles()[..1])).unwrap().scene;
    let fin = triangle.patches().to_vec();
    let far = obj("v 1e8 0 0\nv 100000001 0 0\nv 1e8 1 0\nf 1 2 3")
        .unwrap()
        .scene;
    let beyond = obj("v 0 0 0\nv 1e39 0 0\nv 0 1e39 0\nf 1 2 3")
        .unwrap()
        .scene;
    let pair = Scene::try_new([fin.clone(), fin.clone()].concat()).unwrap();
    for (scene, says) in [
        (cube, "patch 0 (floor 0,0) has 4 corners: cut it"),
        (
            triangle.with_obstructions(fin),
            "only obstructs: write View3D",
        ),
        (pair.with_groups(&[0, 0]).unwrap(), "summed into one row"),
        (far, "an area after its corners are rounded"),
        (beyond, "an area after its corners are rounded"),
    ] {
        let refusal = write_stl(&scene).unwrap_err().to_string();
        assert!(refusal.contains(says), "{refusal}");
    }
}

/// A number of 32 bits, small, large or plain.
fn single() -> impl Strategy<Value = f32> {
    prop_oneof![
        -1.0..1.0f32,
        Just(0.0),
        (-30..30i32).prop_map(|e| 2f32.powi(e))
    ]
}

proptest! {
    /// Our reader and `stl_io` agree about any binary file, and our writer gives it back.
    #[test]
    fn any_triangles_are_read_as_stl_io_reads_them(
        places in proptest::collection::vec([[single(), single(), single()], [
            single(), single(), single()], [single(), single(), single()]], 1..8),
    ) {
        let triangles: Vec<Triangle> = places.into_iter().map(|corners| Triangle {
            normal: Normal::new([0.0; 3]),
            vertices: corners.map(Vertex::new),
        }).collect();
        let bytes = binary(&triangles);
        let judge = stl_io::read_stl(&mut Cursor::new(&bytes)).unwrap().into_triangle_vec();
        let loaded = match stl(bytes) {
            Ok(loaded) => loaded,
            Err(refusal) => {
                // no triangle has an area
                prop_assert!(refusal.to_string().contains("it has no patch"), "{}", refusal);
                return Ok(());
            }
        };
        prop_assert_eq!(loaded.scene.group_count(), judge.len());
        for (index, patch) in loaded.scene.patches().iter().enumerate() {
            let facet = judge[loaded.scene.group_of(index)];
            let expected = facet.vertices.map(|v| DVec3::from_array(v.0.map(f64::from)));
            prop_assert_eq!(patch.shape().corners(), expected);
        }
        let written = write_stl(&loaded.scene).unwrap();
        prop_assert_eq!(written.losses.len(), 1);
        prop_assert_eq!(stl(written.bytes).unwrap().scene, loaded.scene.clone());
        // and to OBJ and back, to the bit
        let text = write_obj(&loaded.scene, "a.mtl").unwrap();
        let back = super::obj_with(&text.obj, &text.mtl).unwrap();
        prop_assert_eq!(names(&back), names(&loaded));
        prop_assert_eq!(corners(&back), corners(&loaded));
        prop_assert_eq!(back.scene.row_areas(), loaded.scene.row_areas());
    }
}
