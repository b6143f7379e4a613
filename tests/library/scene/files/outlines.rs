//! Outlines as modellers write them: what is clear of them is mended, and counted.

use super::{obj, vs3};
use glam::{DQuat, DVec3};
use infoscene::form_factor::{DEFAULT_TOLERANCE, Polygon};
use infoscene::geometry::Patch;
use infoscene::scene::Scene;
use infoscene::scene::files::{LoadedScene, NonPlanarFaces, Source, read_obj};
use proptest::prelude::*;

/// Parallel unit squares at distance 1: Howell, C-11.
const OPPOSITE: f64 = 0.199_824_895_698_387_5;

/// Unit squares at distance 1, and points on the lower one.
const SQUARES: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
    v .5 0 0\nv 1 0 0\nv 2 0 0\nv .1 0 0\nv .2 0 0\nv .3 0 0\n";

fn vertices(corners: &[DVec3]) -> String {
    let lines = corners
        .iter()
        .map(|c| format!("v {:?} {:?} {:?}\n", c.x, c.y, c.z));
    lines.collect()
}

/// The face of an OBJ file with these corners.
fn face(corners: &[DVec3], faces: NonPlanarFaces) -> Result<LoadedScene, String> {
    let numbers: Vec<String> = (1..=corners.len()).map(|k| k.to_string()).collect();
    let text = format!("{}f {}\n", vertices(corners), numbers.join(" "));
    let read = read_obj(&Source::new("face.obj", text), &super::no_library, faces);
    read.map_err(|refusal| refusal.to_string())
}

/// Whatever outline stands for the lower square, it sees the upper one as that does.
#[test]
fn what_encloses_nothing_is_left_out() {
    for (outline, note) in [
        ("1 2 3 4", None),
        ("1 9 2 3 4", None),
        ("1 2 3 4 4", Some("1 face repeats a corner")),
        ("1 1 2 2 2 3 4 1", Some("1 face repeats a corner")),
        ("1 2 10 3 4", Some("1 face repeats a corner")),
        ("1 9 1 2 3 4", Some("1 face runs out and back")),
        ("1 2 11 2 3 4", Some("1 face runs out and back")),
        ("1 11 2 3 4", Some("1 face runs out and back")),
        ("1 9 11 2 3 4", Some("1 face runs out and back")),
        ("1 2 11 11 10 3 4", Some("1 face runs out and back")),
        ("1 2 3 4 8 4", Some("1 face runs out and back")),
        // around a corner and back
        ("1 2 11 7 11 2 3 4", Some("1 face runs out and back")),
    ] {
        let words: Vec<&str> = outline.split(' ').collect();
        for first in 0..words.len() {
            let mut words = words.clone();
            words.rotate_left(first);
            let text = format!("{SQUARES}f {}\nf 5 8 7 6\n", words.join(" "));
            let loaded = obj(&text).unwrap();
            let exchange = loaded.scene.exchange_areas().unwrap();
            let value = exchange.get(0, 1).exchange.value;
            assert!((value - OPPOSITE).abs() < 1e-14, "{words:?}: {value}");
            assert_eq!(loaded.scene.row_areas(), [1.0, 1.0], "{words:?}");
            let notes = loaded.notes.join("\n");
            let is_said = note.map_or(notes.is_empty(), |note| notes.contains(note));
            assert!(is_said, "{words:?}: {notes}");
        }
    }
}

/// One note for each kind, with the number of faces and the first line.
#[test]
fn mends_are_counted() {
    let text = format!("{SQUARES}f 1 2 3 4 4\nf 5 8 8 7 6\nf 1 9 2\nf 1 2\nf 3 3 3\n");
    let loaded = obj(&text).unwrap();
    assert_eq!(
        loaded.notes,
        [
            "room.obj: 2 faces repeat a corner; that counts once (first: line 15)",
            "room.obj: 3 faces have no area; such a face keeps its number and exchanges nothing \
             (first: line 17)"
        ]
    );
}

/// A face without area keeps its number, name and material.
#[test]
fn a_face_without_area_is_a_row_without_a_patch() {
    // also where decimals do not lie on a line exactly
    for line in ["1 9 2", "12 13 14", "1 2", "1", "1 1 1", "9 2 1 10 11 12"] {
        let text = format!("{SQUARES}f {line}\nf 1 2 3 4\no thread\nf {line}\nf 5 8 7 6\n");
        let loaded = obj(&text).unwrap();
        let scene = loaded.scene;
        assert_eq!(
            scene.group_names(),
            ["face 0", "face 1", "thread 0", "thread 1"]
        );
        assert_eq!(scene.row_areas(), [0.0, 1.0, 0.0, 1.0]);
        assert_eq!([0, 1].map(|patch| scene.group_of(patch)), [1, 3]);
        assert_eq!(scene.empty_rows().len(), 2);
    }
    // slivers that f64 can tell from a line are patches
    let sliver = format!("{SQUARES}v .5 1e-9 0\nf 1 2 15\n");
    assert_eq!(obj(&sliver).unwrap().scene.patches().len(), 1);
}

#[test]
fn outlines_that_cross_themselves_are_refused() {
    let points = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n\
        v 4 1 0\nv 4 2 0\nv 1.5 0 0\nv 2 3 0\n";
    for outline in [
        // bow ties, with and without a net area
        "1 2 4 3",
        "1 3 2 10",
        // an opening that runs the way of the outline, one outside, one across the edge
        "1 2 3 4 1 5 8 7 6 5",
        "1 2 10 9 2 3 4",
        "1 2 3 4 1 5 6 10 9 5",
        // twice around
        "1 2 3 4 1 2 3 4",
        // a corner on an edge
        "1 2 3 11 4",
        "1 2 3 4 1 5 6 7 12 5",
    ] {
        let refusal = obj(&format!("{points}f {outline}\n")).unwrap_err();
        let message = refusal.to_string();
        let is_named = ["cross or touch", "no area"]
            .iter()
            .any(|what| message.contains(what));
        assert!(
            is_named && refusal.told().len() == 1,
            "{outline}: {message}"
        );
    }
}

/// A square with an opening and another with nothing in it at distance 1: additivity of contour
/// integrals to 40 digits.
#[test]
fn an_opening_stays_open() {
    let points = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n\
        v 0 0 1\nv 3 0 1\nv 3 3 1\nv 0 3 1\n";
    let outline = [1, 2, 3, 4, 1, 5, 6, 7, 8, 5];
    for first in 0..outline.len() {
        let mut outline = outline.map(|k| k.to_string());
        outline.rotate_left(first);
        let text = format!("{points}o wall\nf {}\nf 9 12 11 10\n", outline.join(" "));
        let LoadedScene { scene, notes } = obj(&text).unwrap();
        assert_eq!(
            (scene.group_names(), scene.patches().len()),
            (vec!["wall 0", "wall 1"], 3)
        );
        assert_eq!(scene.row_areas(), [8.0, 9.0]);
        let value = scene.exchange_areas().unwrap().get(0, 1).exchange.value / 8.0;
        assert!((value - 0.526_138_074_308_372_2).abs() < 1e-14, "{value}");
        assert!(
            notes[0].contains("1 face is bridged around openings"),
            "{notes:?}"
        );
    }
}

/// Light passes through an opening: a wall with one hides nothing that is seen through it.
#[test]
fn nothing_is_blocked_through_an_opening() {
    let points = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nv -1 -1 0\nv -1 1 0\nv 1 1 0\nv 1 -1 0\n\
        v -.5 -.5 -1\nv .5 -.5 -1\nv .5 .5 -1\nv -.5 .5 -1\n\
        v -.5 -.5 1\nv .5 -.5 1\nv .5 .5 1\nv -.5 .5 1\n";
    let panels = "f 9 10 11 12\nf 13 16 15 14\n";
    let open = format!("{points}{panels}f 1 2 3 4 1 5 6 7 8 5\n");
    assert!(obj(&open).unwrap().scene.blocker().is_none());
    let shut = format!("{points}{panels}f 1 2 3 4\n");
    assert!(obj(&shut).unwrap().scene.blocker().is_some());
}

/// An island in an opening, an opening that touches the outline in a corner, and two squares on a
/// string.
#[test]
fn any_outline_that_encloses_its_area_once_is_clear() {
    let points = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 1 1 0\nv 1 8 0\nv 8 8 0\nv 8 1 0\n\
        v 3 3 0\nv 6 3 0\nv 6 6 0\nv 3 6 0\nv 12 0 0\nv 12 3 0\nv 9 3 0\n";
    for (outline, area) in [
        ("1 2 3 4 1 5 9 10 11 12 9 5 6 7 8 5", 81.0 - 49.0 + 9.0),
        ("1 2 3 4 1 6 7 8", 81.0 - 56.0),
        ("9 10 11 12 9 1 4 3 2 1", 81.0 - 9.0),
        ("5 8 7 6 5 9 12 11 10 9", 49.0 - 9.0),
        ("9 10 11 2 13 14 2 11 12", 9.0 + 4.5),
        ("5 8 7 6 5 1 2 1", 49.0),
        ("1 2 13 14 2 3 4", 81.0 + 4.5),
        // an island that reaches out of its opening
        ("1 2 3 4 1 5 9 10 15 11 12 9 5 6 7 8 5", -1.0),
    ] {
        let read = obj(&format!("{points}f {outline}\n"));
        match read {
            Ok(loaded) => {
                let found = loaded.scene.row_areas();
                assert!((found[0] - area).abs() < 1e-12, "{outline}: {found:?}");
            }
            Err(refusal) => assert!(area < 0.0, "{outline}: {refusal}"),
        }
    }
}

/// The corners of 10a and 10b: a bent outline with three corners on one edge, begun at each corner.
#[test]
fn corners_on_a_line_make_up_no_triangle() {
    let bent = [
        [0.0, 0.0, 0.0],
        [0.0, 0.002, 3.0],
        [4.0, 0.0, 3.0],
        [4.0, 0.0, 2.0],
        [4.0, 0.0, 1.0],
        [4.0, 0.0, 0.0],
    ];
    // the same, with corners on all edges
    let more = [
        [0.0, 0.0, 0.0],
        [0.0, 0.001, 1.5],
        [0.0, 0.002, 3.0],
        [1.0, 0.0015, 3.0],
        [4.0, 0.0, 3.0],
        [4.0, 0.0, 1.0],
        [4.0, 0.0, 0.0],
        [3.0, 0.0, 0.0],
        [0.3, 0.0, 0.0],
    ];
    for corners in [bent.to_vec(), more.to_vec()] {
        let corners: Vec<DVec3> = corners.into_iter().map(DVec3::from_array).collect();
        for first in 0..corners.len() {
            let mut corners = corners.clone();
            corners.rotate_left(first);
            let turned = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
            for corners in [
                corners.clone(),
                corners.iter().map(|c| turned * *c).collect(),
            ] {
                let loaded = face(&corners, NonPlanarFaces::Triangulate).unwrap();
                let patches = loaded.scene.patches().iter();
                let shapes: Vec<&Patch> = patches.map(|patch| patch.shape()).collect();
                assert!(shapes.iter().all(|patch| patch.corners().len() == 3));
                // 4 × 3, and the bend of 2 mm
                let area: f64 = shapes.iter().map(|patch| patch.area()).sum();
                assert!((area - 12.0).abs() < 1e-5, "{first}: {area}");
                assert!(shapes.iter().all(|patch| patch.area() > 0.1));
            }
        }
    }
}

/// A bent face that is bridged around an opening is split, too.
#[test]
fn a_bent_face_with_an_opening_is_split_around_it() {
    let outline = [
        [0, 0],
        [3, 0],
        [3, 3],
        [0, 3],
        [0, 0],
        [1, 1],
        [1, 2],
        [2, 2],
        [2, 1],
        [1, 1],
    ];
    let bent = |[x, y]: [i32; 2]| {
        let height = if [x, y] == [3, 3] { 0.01 } else { 0.0 };
        DVec3::new(x.into(), y.into(), height)
    };
    let corners = outline.map(bent);
    assert!(
        face(&corners, NonPlanarFaces::Refuse)
            .unwrap_err()
            .contains("off the plane")
    );
    let loaded = face(&corners, NonPlanarFaces::Triangulate).unwrap();
    let area: f64 = loaded.scene.row_areas().iter().sum();
    assert_eq!(
        (loaded.scene.group_count(), loaded.scene.patches().len()),
        (8, 8)
    );
    assert!((area - 8.0).abs() < 1e-3, "{area}");
}

/// A wall with openings in a row, each bridged to the one before it or to the wall's lower edge.
#[derive(Debug, Clone)]
struct Wall {
    /// The corners of each opening, clockwise from the one at the lower left.
    openings: Vec<[DVec3; 4]>,
    /// Whether each is bridged to the one before it.
    chained: Vec<bool>,
}

impl Wall {
    fn corners(&self) -> [DVec3; 4] {
        let far = 2.0 * self.openings.len() as f64 + 1.0;
        [[0.0, 0.0], [far, 0.0], [far, 3.0], [0.0, 3.0]].map(|[x, y]| DVec3::new(x, y, 0.0))
    }

    /// Once around an opening, and those that are bridged to it.
    fn around(&self, opening: usize) -> Vec<DVec3> {
        let mut outline = self.openings[opening].to_vec();
        if self.chained.get(opening + 1) == Some(&true) {
            outline.extend(self.around(opening + 1));
            outline.push(self.openings[opening][3]);
        }
        outline.push(self.openings[opening][0]);
        outline
    }

    fn outline(&self) -> Vec<DVec3> {
        let [start, rest @ ..] = self.corners();
        let mut outline = vec![start];
        for opening in (0..self.openings.len()).filter(|opening| !self.chained[*opening]) {
            let foot = DVec3::new(2.0 * opening as f64 + 1.0, 0.0, 0.0);
            outline.push(foot);
            outline.extend(self.around(opening));
            outline.push(foot);
        }
        outline.extend(rest);
        outline
    }
}

fn wall() -> impl Strategy<Value = Wall> {
    let opening = (any::<bool>(), proptest::array::uniform8(0.0..0.3f64));
    proptest::collection::vec(opening, 1..5).prop_map(|openings| {
        let place = |(number, (_, shift)): (usize, &(bool, [f64; 8]))| {
            let x = 2.0 * number as f64 + 1.0;
            let corner = |k: usize, [along, up]: [f64; 2]| {
                DVec3::new(x + along + shift[2 * k], up + shift[2 * k + 1], 0.0)
            };
            [
                corner(0, [0.0, 1.0]),
                corner(1, [0.0, 2.0]),
                corner(2, [1.0, 2.0]),
                corner(3, [1.0, 1.0]),
            ]
        };
        Wall {
            chained: openings
                .iter()
                .enumerate()
                .map(|(k, (is, _))| k > 0 && *is)
                .collect(),
            openings: openings.iter().enumerate().map(place).collect(),
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Whatever way openings are bridged, whatever corner comes first and however the wall stands:
    /// its polygons do not overlap, and what they exchange with another square is what the wall
    /// exchanges without openings, less what these do.
    #[test]
    fn a_wall_counts_without_its_openings(
        wall in wall(),
        first in any::<proptest::sample::Index>(),
        axis in [-1.0..1.0f64, -1.0..1.0, 0.1..1.0],
        angle in 0.0..6.3f64,
    ) {
        let turned = DQuat::from_axis_angle(DVec3::from_array(axis).normalize(), angle);
        let place = |corner: &DVec3| turned * (*corner - DVec3::new(1.0, 1.0, 0.0));
        let mut outline: Vec<DVec3> = wall.outline().iter().map(place).collect();
        let start = first.index(outline.len());
        outline.rotate_left(start);
        let polygon = |corners: &[DVec3]| {
            Polygon::new(&Patch::try_new(corners.iter().map(place).collect()).unwrap())
        };
        let far = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        let far = far.map(|[x, y]| DVec3::new(x + 1.0, y + 1.0, 0.7));
        let other = polygon(&far);
        let exchange = |corners: &[DVec3]| {
            let found = polygon(corners).exchange_area(&other, DEFAULT_TOLERANCE).unwrap();
            found.exchange.value
        };
        let openings: f64 = wall.openings.iter().map(|o| exchange(&reversed(o))).sum();
        let expected = exchange(&wall.corners()) - openings;

        let mut corners = outline.clone();
        corners.extend(far.iter().map(place));
        let count = outline.len();
        let numbers = |range: std::ops::Range<usize>| -> String {
            range.map(|k| format!(" {}", k + 1)).collect()
        };
        let text = format!(
            "{}f{}\nf{}\n", vertices(&corners), numbers(0..count), numbers(count..count + 4)
        );
        let scene = obj(&text).unwrap().scene;
        prop_assert_eq!(scene.group_count(), 2);
        prop_assert!(scene.patches().len() <= wall.openings.len() + 4);
        prop_assert!(scene.check_overlap().is_ok());
        let found = scene.exchange_areas().unwrap().get(0, 1).exchange.value;
        prop_assert!((found - expected).abs() < 1e-13, "{} {}", found, expected);
    }
}

fn reversed(corners: &[DVec3; 4]) -> [DVec3; 4] {
    let [a, b, c, d] = *corners;
    [d, c, b, a]
}

/// A base that has no area, or is divided, holds nothing.
#[test]
fn nothing_lies_in_a_surface_without_area() {
    let text = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 .5 0 0\n\
        S 1 1 2 3 4 0 0 .5 floor\nS 2 1 5 2 0 0 0 .5 thread\nS 3 1 5 2 0 1 0 .5 on the floor\n";
    let loaded = vs3(&format!("{text}End of data\n")).unwrap();
    assert_eq!(loaded.scene.row_areas(), [1.0, 0.0, 0.0]);
    let refusal = vs3(&format!("{text}S 4 1 2 3 0 2 0 .5 mat\nEnd of data\n")).unwrap_err();
    assert!(
        refusal.to_string().contains("patch 3 (S 4, mat): a base"),
        "{refusal}"
    );
}

/// Rows without a patch stay where they are when patches are cut.
#[test]
fn rows_without_a_patch_stay_between_their_neighbours() {
    let text = format!("{SQUARES}f 1 9 2\nf 1 2 3 4\nf 1 2\nf 5 8 7 6\nf 3 3\n");
    let scene = obj(&text).unwrap().scene;
    let rows =
        |scene: &Scene| -> Vec<bool> { scene.row_areas().iter().map(|area| *area > 0.0).collect() };
    assert_eq!(rows(&scene), [false, true, false, true, false]);
    let (cut, _) = scene.subdivided(1).unwrap();
    let whole = [
        [false].as_slice(),
        &[true; 4],
        &[false],
        &[true; 4],
        &[false],
    ];
    assert_eq!(rows(&cut), whole.concat());
    let refusal = scene.patch_of_row(2).unwrap_err();
    assert!(
        refusal.to_string().contains("patch 2 (face 2) has no area"),
        "{refusal}"
    );
    assert_eq!(scene.patch_of_row(3), Ok(1));
}
