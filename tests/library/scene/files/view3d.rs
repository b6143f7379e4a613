//! The content of a View3D file.

use super::vs3;

/// Two unit squares at 90°, and a square that covers a quarter of the floor.
const VERTICES: &str = "V 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nV 6 0 1 1\n\
    V 7 .5 0 0\nV 8 .5 .5 0\nV 9 0 .5 0\n";

fn read(surfaces: &str) -> infoscene::scene::files::LoadedScene {
    vs3(&format!("F 3\n{VERTICES}{surfaces}End of data\n")).unwrap()
}

#[test]
fn letters_may_be_of_any_case_and_lines_end_in_any_way() {
    let text = "t A title / with ! anything\n! comment\n/ comment\n\
        c ENCL=1 Eps=1e-4,list = 2 colour=red fast\nC out\nf 3\nv 1 0 0 0 / corner\n\
        v 2 1 0 0\nv 3 1 1 0!\n\ns 1 1 2 3 0 0 0 .9 Tri/angle one ! name\nEND OF DATA\nwhatever";
    for text in [
        text.to_owned(),
        text.replace('\n', "\r\n"),
        text.to_ascii_uppercase(),
    ] {
        let loaded = vs3(&text).unwrap();
        let patch = &loaded.scene.patches()[0];
        assert!(patch.name().eq_ignore_ascii_case("tri/angle one"));
        assert_eq!(patch.shape().corners().len(), 3);
        assert_eq!(patch.shape().area(), 0.5);
        let [note] = loaded.notes.as_slice() else {
            panic!("{:?}", loaded.notes)
        };
        let note = note.to_ascii_lowercase();
        let says = "c encl (line 4), c eps (line 4), c list (line 4), c colour (line 4), c fast \
            (line 4), c out (line 5)";
        assert!(note.contains("ignored") && note.ends_with(says), "{note}");
    }
}

/// 1 − emit as decimals are subtracted: 1 − 0.9 is 0.1, though 1.0 − 0.9 in f64 is not.
#[test]
fn reflectance_is_one_less_emissivity() {
    for (emit, reflectance) in [
        ("0.9", 0.1),
        ("1", 0.0),
        (".253", 0.747),
        ("1e-3", 0.999),
        ("0", 1.0),
    ] {
        let loaded = read(&format!("S 1 1 2 3 4 0 0 {emit} floor\n"));
        let material = loaded.scene.patches()[0].material().grey().unwrap();
        assert_eq!(
            (material.reflectance(), material.emittance()),
            (reflectance, 0.0)
        );
    }
}

/// Numbers need not be in order, patches are in that of the file; `O` obstructs and needs no more
/// than its vertices.
#[test]
fn obstructions_are_no_patches() {
    let loaded =
        read("O 9 1 7 8 9\nS 5 1 2 3 4 0 0 1 floor\nO 2 1 2 5 0 0 0 .5 fin\nS 1 1 4 6 5 0 0 1\n");
    let names = |patches: &[infoscene::scene::NamedPatch]| -> Vec<String> {
        patches
            .iter()
            .map(|patch| patch.name().to_owned())
            .collect()
    };
    assert_eq!(names(loaded.scene.patches()), ["floor", "surface 1"]);
    assert_eq!(names(loaded.scene.obstructions()), ["surface 9", "fin"]);
    assert_eq!(loaded.scene.total_area(), 2.0);
}

/// A base counts without what lies in it; its row may hold others.
#[test]
fn parts_and_rows_are_those_of_the_file() {
    let loaded = read(
        "S 1 1 2 3 4 0 0 .5 floor\nS 2 1 7 8 9 1 0 .5 mat\nS 3 1 4 6 0 0 0 .5 wall\n\
         S 4 1 6 5 0 0 3 .5 wall too\n",
    );
    let scene = &loaded.scene;
    assert_eq!(
        [0, 1, 2, 3].map(|i| scene.base_of(i)),
        [None, Some(0), None, None]
    );
    assert_eq!([0, 1, 2, 3].map(|i| scene.group_of(i)), [0, 1, 2, 2]);
    assert_eq!(
        (scene.group_count(), scene.net_area(0), scene.total_area()),
        (3, 0.75, 2.0)
    );
    assert_eq!(scene.patches_of_group(2).collect::<Vec<_>>(), [2, 3]);
    // what lies in an obstruction is a patch of its own
    let loaded = read("S 1 1 7 8 9 2 0 .5 mat\nO 2 1 2 3 4\n");
    assert_eq!(
        (loaded.scene.base_of(0), loaded.scene.total_area()),
        (None, 0.25)
    );
    // equal numbers sum even where no surface has that number
    let loaded =
        read("S 1 1 4 6 0 0 7 .5 wall\nS 2 1 6 5 0 0 7 .5 wall too\nS 3 1 2 3 4 0 0 .5 floor\n");
    assert_eq!([0, 1, 2].map(|i| loaded.scene.group_of(i)), [0, 0, 1]);
}

/// A fourth vertex that is the third or the first makes a triangle, and so does 0; a surface of two
/// vertices has no area, and keeps its row unless it is summed with others.
#[test]
fn repeated_vertices_are_mended() {
    for fourth in [0, 1, 3] {
        let loaded = read(&format!("S 1 1 2 3 {fourth} 0 0 .5 half\n"));
        let shape = loaded.scene.patches()[0].shape();
        assert_eq!((shape.corners().len(), shape.area()), (3, 0.5), "{fourth}");
        let says = "room.vs3: 1 face repeats a corner; that counts once (first: line 11)";
        assert_eq!(
            loaded.notes.first().map(String::as_str),
            (fourth > 0).then_some(says)
        );
    }
    let loaded = read(
        "S 1 1 2 3 4 0 0 .5 floor\nS 2 1 7 2 0 0 0 .5 sliver\nS 3 1 4 6 5 0 0 .5 wall\n\
         S 4 1 2 2 1 0 3 .5 of the wall\nO 5 1 2 1 2\n",
    );
    assert_eq!(loaded.scene.group_names(), ["floor", "sliver", "wall"]);
    assert_eq!(loaded.scene.row_areas(), [1.0, 0.0, 1.0]);
    assert_eq!(loaded.scene.obstructions(), []);
    assert_eq!(
        loaded.notes,
        [
            "room.vs3: 3 faces have no area; such a face keeps its number and exchanges nothing \
             (first: line 12)"
        ]
    );
}
