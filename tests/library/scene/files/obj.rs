//! The content of an OBJ file and its MTL file, in all spellings that the formats allow.

use super::{obj, obj_with};
use glam::DVec3;
use infoscene::scene::files::{NonPlanarFaces, Source, read, read_obj};
use infoscene::scene::{Channels, Scene};
use std::path::Path;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn corners(text: &str) -> Vec<DVec3> {
    let loaded = obj(text).unwrap();
    assert_eq!(loaded.scene.patches().len(), 1, "{text}");
    loaded.scene.patches()[0].shape().corners().to_vec()
}

#[test]
fn the_same_face_may_be_written_in_many_ways() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    for face in [
        "f 1 2 3 4",
        "f -4 -3 -2 -1",
        "f 1/1 2/2 3/3 4/4",
        "f 1//1 2//1 3//1 4//1",
        "f 1/1/1 2/2/1 -2/3/1 -1",
        "f 1 2 \\\n 3 4",
        "  f\t1 2 \\\r\n3 \\\r\n4\r\n",
        "f 1 2 3 4 # the front is above",
        "f 1// 2// 3// 4//",
        "F 1 2 3 4",
        "f 1 2 3 4 \\",
        "vt 0 0\nvn 0 0 1\ns off\nf 1 2 3 4",
    ] {
        assert_eq!(corners(&format!("{SQUARE}{face}\n")), square, "{face}");
    }
    for ends in ["\r\n", "\r", "\n\r", "\r\r\n"] {
        let ended = format!("# a room\n{SQUARE}f 1 2 3 4\n").replace('\n', ends);
        assert_eq!(corners(&ended), square, "{ends:?}");
    }
    let mixed = format!("{}f 1 2 3 4\r", SQUARE.replacen('\n', "\r", 2));
    assert_eq!(corners(&mixed), square);
    let marked = format!("\u{feff}{SQUARE}f 1 2 3 4").into_bytes();
    let marked = Source::from_bytes("room.obj", marked).unwrap();
    assert_eq!(
        marked,
        Source::new("room.obj", format!("{SQUARE}f 1 2 3 4"))
    );
    let weighted = "v 0 0 0 1\nv 1.e0 0. .0 nan\nv +1 1 -0 nan inf nan\nv 0 1 0\nvt nan\nvn x\n\
        f 1 2 3 4";
    assert_eq!(corners(weighted), square);
}

/// The front is the side from which a face runs counter-clockwise.
#[test]
fn reversed_corners_turn_the_front() {
    for (face, normal) in [("f 1 2 3 4", DVec3::Z), ("f 4 3 2 1", -DVec3::Z)] {
        let loaded = obj(&format!("{SQUARE}{face}")).unwrap();
        assert_eq!(loaded.scene.patches()[0].shape().normal(), normal);
    }
}

/// Six corners, one of them reflex: area 3 by hand, and not six triangles.
#[test]
fn polygons_stay_whole() {
    let text = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6";
    let loaded = obj(text).unwrap();
    let [patch] = loaded.scene.patches() else {
        panic!("{:?}", loaded.scene)
    };
    assert_eq!(
        (patch.shape().corners().len(), patch.shape().area()),
        (6, 3.0)
    );
}

#[test]
fn objects_and_groups_and_a_number_name_the_faces() {
    let face = "f 1 2 3 4\n";
    let text = format!(
        "{SQUARE}{face}o  east  wing\n{face}{face}g wall\n{face}g\n{face}g default\n{face}o\n{face}"
    );
    let loaded = obj(&text).unwrap();
    let names: Vec<&str> = loaded.scene.patches().iter().map(|p| p.name()).collect();
    assert_eq!(
        names,
        [
            "face 0",
            "east wing 0",
            "east wing 1",
            "east wing wall 0",
            "east wing 2",
            "east wing 3",
            "face 1"
        ]
    );
}

/// Kd and Ke, of three channels or of one for all; black without a material; the last word counts.
#[test]
fn materials_have_three_channels() {
    let face = "f 1 2 3 4\n";
    let text = format!(
        "mtllib all.mtl\n{SQUARE}{face}usemtl a\n{face}usemtl the lamp\n{face}usemtl grey\n{face}\
         usemtl one\n{face}"
    );
    let materials = "# paints\nnewmtl a\nKd 0.25 0.5 0.75\nNs 10\nillum 2\n\
        newmtl the lamp\nKe 1 2 6 # bright\nKd 0 0 0\nnewmtl grey\nkd 0.747 0.747 0.747\n\
        newmtl one\nKd 0.3\n";
    let loaded = obj_with(&text, materials).unwrap();
    let found = loaded.scene.patches().iter().map(|patch| {
        let material = patch.material();
        let properties = [material.reflectance(), material.emittance()];
        properties.map(|property| {
            let Channels { r, g, b } = *property.unwrap();
            [r, g, b]
        })
    });
    let found: Vec<[[f64; 3]; 2]> = found.collect();
    let dark = [0.0; 3];
    assert_eq!(
        found,
        [
            [dark, dark],
            [[0.25, 0.5, 0.75], dark],
            [dark, [1.0, 2.0, 6.0]],
            [[0.747; 3], dark],
            [[0.3; 3], dark],
        ]
    );
    assert!(loaded.notes.is_empty());
}

/// A statement without effect is noted once, however often it occurs.
#[test]
fn what_is_left_out_is_said() {
    let text = format!("mtllib a.mtl\n{SQUARE}p 1\nl 1 2\nl 2 3\nf 1 2 3 4");
    let loaded = obj_with(
        &text,
        "newmtl a\nKs 1 1 1\nmap_Kd wood.png\nmap_Bump x\nKs 0 0 0\n",
    )
    .unwrap();
    let notes = loaded.notes.join("\n");
    for left_out in ["\"Ks\"", "\"map_…\"", "\"p\"", "\"l\""] {
        assert_eq!(notes.matches(left_out).count(), 1, "{notes}");
    }
    assert!(notes.contains("(2 lines, first: line 7)"), "{notes}");
    assert_eq!(loaded.notes.len(), 4);
    // what nobody knows has no effect either
    let text = format!("frame 1\n{SQUARE}frame 2\nG x\nf 1 2 3 4\nv 1 2 3 red\n");
    let notes = obj(&text).unwrap().notes;
    assert_eq!(
        notes,
        [
            "room.obj: 1 vertex has more than coordinates, a weight or a colour; the rest is \
             ignored (first: line 9)",
            "room.obj: ignored, they change nothing here: frame (2 times, first in line 1), G \
             (line 7)"
        ]
    );
    let many: String = (0..100).map(|k| format!("word{k} 1\n")).collect();
    let notes = obj(&format!("{many}{SQUARE}f 1 2 3 4\n")).unwrap().notes;
    assert!(
        notes[0].ends_with("word19 (line 20), and other words (80 times, first in line 21)"),
        "{notes:?}"
    );
}

/// Bytes that are not UTF-8 are Latin-1, in names as in comments; a name is all of its line.
#[test]
fn names_are_read_as_they_are_written() {
    let text = format!("{SQUARE}o W\u{e4}nde # 2\nf 1 2 3 4\ng \u{fc}ber\nf 1 2 3 4 # \u{e9}\n");
    let latin_1: Vec<u8> = text.chars().map(|c| u8::try_from(c).unwrap()).collect();
    let mixed = [text.as_bytes(), b"# \xff\n"].concat();
    for (bytes, note) in [
        (text.clone().into_bytes(), None),
        (
            latin_1,
            Some("room.obj: 3 bytes are not UTF-8 and read as Latin-1 (first: line 5)"),
        ),
        (
            mixed,
            Some("room.obj: 1 byte is not UTF-8 and read as Latin-1 (first: line 9)"),
        ),
    ] {
        let source = Source::from_bytes("room.obj", bytes).unwrap();
        let loaded = read_obj(&source, &super::no_library, NonPlanarFaces::Refuse).unwrap();
        let names: Vec<&str> = loaded.scene.patches().iter().map(|p| p.name()).collect();
        assert_eq!(names, ["W\u{e4}nde # 2 0", "W\u{e4}nde # 2 \u{fc}ber 0"]);
        assert_eq!(loaded.notes.first().map(String::as_str), note);
    }
    // in a number such a byte is a fault
    let source = Source::from_bytes("room.obj", b"v 1 0 \xff\n".to_vec()).unwrap();
    let refusal = read_obj(&source, &super::no_library, NonPlanarFaces::Refuse).unwrap_err();
    assert!(refusal.to_string().contains("z is \"\u{ff}\""), "{refusal}");
    // a name of a megabyte is not copied for every face
    let text = format!("{SQUARE}o {}\nf 1 2 3 4\n", "x".repeat(1_000_000));
    let loaded = obj(&text).unwrap();
    assert_eq!(loaded.scene.patches()[0].name().len(), 66);
    assert!(
        loaded.notes[0].contains("1 name is very long"),
        "{:?}",
        loaded.notes
    );
}

/// Several libraries, and one whose name has a space, beside the file that names them.
#[test]
fn libraries_lie_beside_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("a.mtl", "newmtl a\nKd .1 .1 .1\n");
    write("b.mtl", "newmtl b\nKd .2 .2 .2\n");
    write("my paints.mtl", "newmtl c\nKd .3 .3 .3\n");
    let face = "f 1 2 3 4\n";
    write(
        "room.OBJ",
        &format!(
            "mtllib a.mtl b.mtl\nmtllib my paints.mtl\n{SQUARE}usemtl a\n{face}\
             usemtl b\n{face}usemtl c\n{face}"
        ),
    );
    let loaded = read(&folder.path().join("room.OBJ"), NonPlanarFaces::Refuse).unwrap();
    let patches = loaded.scene.patches().iter();
    let found: Vec<f64> = patches
        .map(|patch| patch.material().grey().unwrap().reflectance())
        .collect();
    assert_eq!(found, [0.1, 0.2, 0.3]);
}

/// The files of the built-in scenes are these, to the last bit.
#[test]
fn files_are_the_built_in_scenes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/scenes");
    for (file, name) in [
        ("two-squares.obj", "two-squares"),
        ("three-squares.obj", "three-squares"),
        ("cube-3.obj", "cube:3"),
        ("tetrahedron.obj", "tetrahedron"),
        ("cube.obj", "cube:1"),
        ("octahedron.obj", "octahedron"),
        ("dodecahedron.obj", "dodecahedron"),
        ("icosahedron.obj", "icosahedron"),
        ("box.obj", "box:1,1,2"),
        ("box-flat.obj", "box:1,1,0.1"),
        ("box-long.obj", "box:1,1,10"),
    ] {
        let read = read(&folder.join(file), NonPlanarFaces::Refuse)
            .unwrap()
            .scene;
        let built_in = Scene::built_in(name).unwrap();
        assert_eq!(read.patches().len(), built_in.patches().len());
        for (read, built_in) in read.patches().iter().zip(built_in.patches()) {
            assert_eq!(read.shape(), built_in.shape(), "{file}: {}", read.name());
        }
    }
}
