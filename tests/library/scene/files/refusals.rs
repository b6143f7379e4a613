//! Every bad file gets one message that names file, line, patch, the broken condition and what
//! mends it.

use super::{obj, vs3};
use infoscene::scene::SceneError;
use infoscene::scene::files::{FileErrors, NonPlanarFaces, OpenError, Source, open, read};
use std::time::{Duration, Instant};

/// One line that begins with the place and holds the condition and the mend.
fn assert_says(refusal: &FileErrors, parts: &[&str]) {
    let message = refusal.to_string();
    let mut rest = message.as_str();
    for part in parts {
        let place = rest.find(part);
        assert!(place.is_some(), "no \"{part}\" in {message}");
        rest = &rest[place.unwrap() + part.len()..];
    }
    assert!(
        message.starts_with(parts[0]) && !message.contains('\n'),
        "{message}"
    );
    assert!(message.len() < 400, "{message}");
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn bad_faces_are_named_with_line_and_patch() {
    for (face, says) in [
        ("f 1 2 3 5", &["there is no vertex 5", "1 to 4"] as &[&str]),
        ("f 0 1 2", &["there is no vertex 0", "1 to 4"]),
        ("f -5 1 2", &["there is no vertex -5", "-1 for the last"]),
        (
            "f 1 2 99999999999999999999",
            &["there is no vertex 99999999999999999999"],
        ),
        (
            "f 1 2 -9223372036854775808",
            &["there is no vertex -9223372036854775808"],
        ),
        ("f 1 2 x", &["a corner is \"x\"", "write a number"]),
        ("f 1 2 /3", &["a corner is \"\"", "write a number"]),
        ("f 1 2 2.0", &["a corner is \"2.0\"", "write a number"]),
        ("f", &["the first corner is missing", "\"f a b c\""]),
        ("v 0 3 0\nf 1 3 2 5", &["edges 0 and 2", "cross", "reorder"]),
        ("f 1 3 2 4", &["no area", "into their order"]),
        (
            "v 1e-200 0 0\nv 0 1e-200 0\nf 1 5 6",
            &["no area", "move its corners apart"],
        ),
        (
            "v 0 0 0.5\nf 1 2 3 5 4",
            &[
                "off the plane",
                "of the diameter",
                "into triangles, or let its reader",
            ],
        ),
        (
            "v 1e-11 0 1e-11\nv 0 1 1e-9\nf 1 2 3 6",
            &["off the plane", "into triangles, or let its reader"],
        ),
    ] {
        let refusal = obj(&format!("{SQUARE}o wall\nf 1 2 3\n{face}\n")).unwrap_err();
        let line = 6 + face.lines().count();
        let place = format!("room.obj, line {line}, patch 1 (wall 1): ");
        assert_says(&refusal, &[&[place.as_str()], says].concat());
    }
}

#[test]
fn bad_lines_are_named() {
    for (line, says) in [
        ("v 1 2", &["z is missing", "\"v x y z\""] as &[&str]),
        ("v 1 2 three", &["z is \"three\"", "write a number"]),
        ("v 1 nan 3", &["y is \"nan\"", "finite"]),
        ("v -inf 2 3", &["x is \"-inf\"", "finite"]),
        ("v 1 2 1e999", &["z is \"1e999\"", "finite"]),
        ("v 1 2 1d-3", &["z is \"1d-3\"", "write a number"]),
        ("v 1 2 1,5", &["z is \"1,5\"", "write a number"]),
        (
            "curv 0 1 1 2",
            &[
                "free-form geometry (\"curv\") is not supported",
                "as polygons",
            ],
        ),
    ] {
        let refusal = obj(&format!("# a room\n{SQUARE}{line}\nf 1 2 3\n")).unwrap_err();
        assert_says(&refusal, &[&["room.obj, line 6: "], says].concat());
    }
    let noise = "x".repeat(1_000_000);
    for empty in [
        "",
        "\n\n",
        "# nothing",
        SQUARE,
        "<html>",
        "\u{1b}[2J\u{7}",
        &noise,
        "v 0 0 0\nf 1 1 1",
    ] {
        assert_says(
            &obj(empty).unwrap_err(),
            &["room.obj: ", "no patch", "\"f a b c\""],
        );
    }
}

const VERTICES: &str =
    "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nS 7 1 2 3 4 0 0 .9 floor\n";

#[test]
fn bad_lines_of_view3d_are_named() {
    for (line, says) in [
        ("F 3a", &["\"F 3a\" is not supported", "\"F 3\""] as &[&str]),
        ("F", &["the format is missing"]),
        (
            "M 2 1 2 3 4 1 0 .5 mask",
            &["masking or null surface (\"M\") is not supported", "cut"],
        ),
        (
            "n 2 1 2 3 4 1 0 .5 none",
            &["masking or null surface (\"n\") is not supported"],
        ),
        (
            "X 1 0 0",
            &["coordinate transformation", "write the vertices"],
        ),
        (
            "V 1 0 0 0",
            &["vertex 1 is defined already, in line 2", "another number"],
        ),
        ("V 0 0 0 0", &["there is no vertex or surface 0"]),
        ("V -1 0 0 0", &["the number of the vertex is \"-1\""]),
        ("V 9 0 0", &["z is missing"]),
        ("V 9 0 inf 0", &["y is \"inf\"", "finite"]),
        ("V 9 0 0 0 0", &["one value too many"]),
        (
            "S 7 1 2 3 4 0 0 .9 again",
            &["surface 7 is defined already, in line 7"],
        ),
        ("S 8 1 2 3", &["the fourth vertex is missing"]),
        ("W 1", &["View3D has no \"W\""]),
        ("v1 2 3", &["View3D has no \"v1\""]),
    ] {
        let refusal = vs3(&format!("{VERTICES}{line}\nEnd of data\n")).unwrap_err();
        assert_says(&refusal, &[&["room.vs3, line 8: "], says].concat());
    }
    assert_says(
        &vs3("F 3\nEnd of data").unwrap_err(),
        &["room.vs3: it has no patch", "\"S n v1"],
    );
    for cut in ["", VERTICES] {
        assert_says(
            &vs3(cut).unwrap_err(),
            &["room.vs3: ", "\"End of data\" is missing", "cut short"],
        );
    }
}

#[test]
fn bad_surfaces_of_view3d_are_named_with_their_patch() {
    for (surface, says) in [
        (
            "S 8 1 2 3 9 0 0 .9 a b",
            &["patch 1 (S 8, a b)", "there is no vertex 9"] as &[&str],
        ),
        (
            "S 8 1 2 3 5 0 0 .9 a",
            &[
                "patch 1 (S 8, a)",
                "off the plane",
                "into triangles, or let its reader",
            ],
        ),
        (
            "V 6 0 3 0\nO 8 1 3 2 6",
            &["patch O 8 (surface 8)", "cross", "reorder"],
        ),
        (
            "S 8 1 2 3 0 9 0 .9 a",
            &["patch 1 (S 8, a)", "there is no surface 9"],
        ),
        (
            "S 8 1 2 3 0 8 0 .9 a",
            &["patch 1 (S 8, a)", "cannot lie in patch 1"],
        ),
        (
            "S 8 1 2 5 0 7 0 .9 a",
            &["patch 1 (S 8, a)", "off the plane of its base, patch 0"],
        ),
        (
            "S 8 3 2 1 0 7 0 .9 a",
            &["patch 1 (S 8, a)", "faces away", "reverse"],
        ),
        (
            "S 8 1 2 3 4 7 0 .9 a",
            &["patch 1 (S 8, a)", "leave an area of 0e0"],
        ),
        (
            "O 9 1 2 3 0\nS 8 1 3 4 0 9 0 .9 a",
            &[
                "patch 1 (S 8, a)",
                "not inside the obstruction",
                "surface 9",
                "write 0",
            ],
        ),
        (
            "O 9 1 2 3 0\nS 8 1 2 3 0 0 9 .9 a",
            &["patch 1 (S 8, a)", "surface 9 only obstructs"],
        ),
        (
            "S 8 1 2 3 0 0 7 .9 a\nS 9 1 2 3 0 0 8 .9 b",
            &["patch 2 (S 9, b)", "itself summed into surface 7"],
        ),
    ] {
        let refusal = vs3(&format!("{VERTICES}{surface}\nEnd of data\n")).unwrap_err();
        let place = format!("room.vs3, line {}, ", 7 + surface.lines().count());
        assert_says(&refusal, &[&[place.as_str()], says].concat());
    }
}

#[test]
fn utf_16_is_refused() {
    let text = "o wall\nv 0 0 0\n";
    let little = || text.encode_utf16().flat_map(u16::to_le_bytes);
    let big = || text.encode_utf16().flat_map(u16::to_be_bytes);
    for bytes in [
        [0xff, 0xfe]
            .into_iter()
            .chain(little())
            .collect::<Vec<u8>>(),
        [0xfe, 0xff].into_iter().chain(big()).collect(),
        little().collect(),
        big().collect(),
    ] {
        let refusal = Source::from_bytes("room.obj", bytes).unwrap_err();
        assert_says(&refusal.into(), &["room.obj: ", "UTF-16", "save", "UTF-8"]);
    }
}

#[test]
fn files_that_are_not_there_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::create_dir(path("folder.obj")).unwrap();
    std::fs::write(path("room.txt"), SQUARE).unwrap();
    for (name, says) in [
        ("missing.obj", "cannot be read"),
        ("missing.vs3", "cannot be read"),
        ("folder.obj", "it is a folder"),
        ("room.txt", "Wavefront .obj, a View3D .vs3 or an .stl"),
    ] {
        let path = path(name);
        let refusal = read(&path, NonPlanarFaces::Refuse).unwrap_err();
        assert_says(&refusal, &[path.to_str().unwrap(), says]);
        let opened = open(path.to_str().unwrap(), NonPlanarFaces::Refuse).unwrap_err();
        assert_eq!(opened, OpenError::File(refusal));
    }
    for name in ["", "sphere", "cube:0", "cube:1.5", "Cornell-Box"] {
        let refusal = open(name, NonPlanarFaces::Refuse).unwrap_err();
        assert!(
            matches!(refusal, OpenError::Scene(SceneError::UnknownName { .. })),
            "{name}: {refusal}"
        );
    }
}

/// The first twenty faults, each on its line, and the number of the others; a bad vertex keeps its
/// number, so that the faces after it are not at fault.
#[test]
fn all_faults_are_told_at_once() {
    let text = format!("v 0 0 zero\n{SQUARE}f 2 3 4 5\nf 1 2 3\nv 7 7 inf\nf 2 3 9\n");
    let refusal = obj(&text).unwrap_err();
    let lines: Vec<_> = refusal.told().iter().map(|fault| fault.line).collect();
    assert_eq!(
        (lines, refusal.more()),
        (vec![Some(1), Some(8), Some(9)], 0)
    );
    assert_eq!(refusal.to_string().lines().count(), 3);
    let text = format!("{SQUARE}{}", "f 1 2 x\n".repeat(50));
    let refusal = obj(&text).unwrap_err();
    assert_eq!((refusal.told().len(), refusal.more()), (20, 30));
    let message = refusal.to_string();
    assert_eq!(message.lines().count(), 21);
    assert!(message.ends_with("\nand 30 more"), "{message}");
    // a bad vertex, a bad surface, a surface that names the bad vertex, and no end
    let text = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 x\nS 1 1 2 3 0 0 0 .9\nS 2 1 2 9 0 0 0 .9\n";
    let refusal = vs3(text).unwrap_err();
    let lines: Vec<_> = refusal.told().iter().map(|fault| fault.line).collect();
    assert_eq!(lines, [Some(4), None, Some(6)]);
}

/// Long files are read in one pass.
#[test]
fn a_million_lines_of_noise_are_read_at_once() {
    let start = Instant::now();
    let noise = "noise and more of it\n".repeat(1_000_000);
    assert_eq!(obj(&noise).unwrap_err().told()[0].line, None);
    let refusal = vs3(&noise).unwrap_err();
    assert_eq!((refusal.told()[0].line, refusal.more()), (Some(1), 999_981));
    let comments = "# noise\n".repeat(1_000_000);
    assert_eq!(
        obj(&format!("{comments}f")).unwrap_err().told()[0].line,
        Some(1_000_001)
    );
    let continued = "s \\\n".repeat(1_000_000);
    assert_eq!(
        obj(&format!("{continued}\nf")).unwrap_err().told()[0].line,
        Some(1_000_002)
    );
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}
