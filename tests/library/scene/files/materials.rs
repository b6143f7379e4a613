//! Materials never stand in the way of shapes: what is wrong with them is a note, and unknown.

use super::{obj, obj_with, vs3};
use infoscene::scene::files::{
    Fault, FileError, LoadedScene, NonPlanarFaces, Source, read, read_obj,
};
use infoscene::scene::{Material, PatchMaterial};
use std::path::Path;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const FACE: &str = "f 1 2 3 4\n";

fn material(loaded: &LoadedScene, patch: usize) -> &PatchMaterial {
    loaded.scene.patches()[patch].material()
}

/// The reflectance of a patch whose material is grey.
fn grey(loaded: &LoadedScene, patch: usize) -> f64 {
    let material = material(loaded, patch).grey();
    material.map_or(f64::NAN, |material| material.reflectance())
}

fn assert_noted(loaded: &LoadedScene, parts: &[&str]) {
    let notes = loaded.notes.join("\n");
    for part in parts {
        assert!(notes.contains(part), "no {part:?} in {notes}");
    }
}

/// The reason why a reflectance or an emittance is not known is that of the note.
#[test]
fn what_a_library_says_wrongly_is_unknown_and_noted() {
    for (lines, is_reflectance, says) in [
        (
            "Kd 1.2 1 1",
            true,
            "line 2: the reflectance is 1.2: it must",
        ),
        ("Kd -.1 .5 .5", true, "the reflectance is -0.1"),
        (
            "Kd abc",
            true,
            "the first channel is \"abc\": write a number",
        ),
        ("Kd .5 .5", true, "the third channel is missing"),
        ("Kd .5 .5 .5 .5", true, "one value too many"),
        (
            "Kd spectral file.rfl 1",
            true,
            "\"spectral\" is not supported",
        ),
        ("Kd xyz 1 1 1", true, "\"xyz\" is not supported"),
        ("Ke -1 9 9", false, "the emittance is -1"),
        (
            "Ke nan",
            false,
            "the first channel is \"nan\": write a finite",
        ),
    ] {
        let text = format!("mtllib a.mtl\n{SQUARE}usemtl a\n{FACE}{FACE}");
        let loaded = obj_with(&text, &format!("newmtl a\n{lines}\n")).unwrap();
        let material = material(&loaded, 0);
        let [fault, other] = if is_reflectance {
            [material.reflectance(), material.emittance()]
        } else {
            [material.emittance(), material.reflectance()]
        };
        let fault = fault.unwrap_err().to_string();
        assert!(other.is_ok() && fault.contains(says), "{fault}");
        assert_noted(
            &loaded,
            &[&fault, "a.mtl, line 2", "light of 2 patches only"],
        );
        assert_eq!(loaded.notes.len(), 1, "{:?}", loaded.notes);
    }
}

/// A later statement mends an earlier one, and materials that no face uses are no matter.
#[test]
fn unused_faults_are_no_matter() {
    let text = format!("mtllib a.mtl\n{SQUARE}usemtl a\n{FACE}");
    let materials = "newmtl a\nKd nan\nKd 1 1 1\nnewmtl b\nKd nan nan nan\nnewmtl b\nKd 0.5\n";
    let loaded = obj_with(&text, materials).unwrap();
    assert!(loaded.notes.is_empty(), "{:?}", loaded.notes);
    // R = 1 is a reflectance
    assert_eq!(grey(&loaded, 0), 1.0);
}

#[test]
fn statements_without_a_material_are_noted() {
    let text = format!("mtllib a.mtl\n{SQUARE}usemtl a\n{FACE}");
    let loaded = obj_with(&text, "Kd .5\nnewmtl\nnewmtl a\nKt 0 0 0\nPfc 3\nKt 1\n").unwrap();
    assert_noted(
        &loaded,
        &[
            "a.mtl, line 1: the material that this belongs to is missing",
            "a.mtl, line 2: the name of the material is missing",
            "a.mtl: ignored, they change nothing here: Kt (2 times, first in line 4), Pfc (line 5)",
        ],
    );
    assert_eq!((grey(&loaded, 0), loaded.notes.len()), (0.0, 3));
    let loaded = obj_with(&text, &format!("{SQUARE}nothing\n")).unwrap();
    assert_noted(&loaded, &["a.mtl: it defines no material"]);
    assert!(material(&loaded, 0).reflectance().is_err());
    // what has no name is nobody's
    let loaded = obj_with(&text, "newmtl a\nKd .5\nnewmtl\nKd .9\n").unwrap();
    assert_eq!(grey(&loaded, 0), 0.5);
}

/// A library that is not there, and names that nothing defines.
#[test]
fn missing_materials_are_unknown() {
    for (statement, says) in [
        (
            "usemtl gold",
            "line 5: there is no material gold: define it",
        ),
        ("usemtl (null)", "there is no material (null)"),
        ("usemtl", "line 5: the name of the material is missing"),
        (
            "mtllib lost.mtl\nusemtl gold",
            "line 6: there is no material gold: define it, or name one that is there \
             (/nowhere/lost.mtl cannot be read)",
        ),
    ] {
        let loaded = obj(&format!("{SQUARE}{statement}\n{FACE}")).unwrap();
        let fault = material(&loaded, 0).emittance().unwrap_err().to_string();
        assert!(
            fault.contains("room.obj, ") && fault.contains(says),
            "{fault}"
        );
        assert_noted(&loaded, &[&fault]);
    }
    // black, as faces without a name are
    for statement in ["mtllib lost.mtl", "mtllib"] {
        let loaded = obj(&format!("{SQUARE}{statement}\n{FACE}usemtl gold\n")).unwrap();
        assert_eq!(material(&loaded, 0).grey(), Some(Material::BLACK));
        assert_noted(&loaded, &["room.obj, line 5: the "]);
        assert_eq!(loaded.notes.len(), 1, "{:?}", loaded.notes);
    }
}

/// Names are whole lines; one that is nearly that of a material is taken for it, with a note.
#[test]
fn names_of_materials_are_whole_lines() {
    let materials = "newmtl Material #1\nKd .1\nnewmtl Material #2  \nKd .2\n\
        newmtl two  blanks\nKd .3\nnewmtl wood # brown\nKd .4\nnewmtl #5\nKd .5\n";
    for (name, expected, is_noted) in [
        ("Material #1", 0.1, false),
        ("  Material #2 ", 0.2, false),
        ("two  blanks", 0.3, false),
        ("two blanks", 0.3, true),
        ("two  blanks # there", 0.3, true),
        ("wood # brown", 0.4, false),
        ("wood", 0.4, true),
        ("#5", 0.5, false),
        ("wood # red", f64::NAN, true),
        ("material #1", f64::NAN, true),
        // either of two that differ
        ("Material", f64::NAN, true),
    ] {
        let text = format!("mtllib a.mtl\n{SQUARE}usemtl {name}\n{FACE}");
        let loaded = obj_with(&text, materials).unwrap();
        let found = grey(&loaded, 0);
        assert!(found.to_bits() == expected.to_bits(), "{name:?}: {found}");
        assert_eq!(
            !loaded.notes.is_empty(),
            is_noted,
            "{name}: {:?}",
            loaded.notes
        );
    }
    let text = format!("{SQUARE}usemtl wood\n{FACE}mtllib a.mtl\n");
    let loaded = obj_with(&text, "newmtl wood\nKd .4\n").unwrap();
    assert_eq!(grey(&loaded, 0), 0.4);
    assert_noted(
        &loaded,
        &["line 5: material wood is used before \"mtllib\" in line 7"],
    );
}

/// Definitions that agree are one; of others it is unknown what differs.
#[test]
fn a_name_defined_twice_is_unknown_if_it_differs() {
    let text = format!("mtllib a.mtl\n{SQUARE}usemtl a\n{FACE}");
    let with = |materials: &str| obj_with(&text, materials).unwrap();
    let loaded = with("newmtl a\nKd .5\nKe 1\nnewmtl b\nnewmtl a\nKd .5\nKe 1 1 1\n");
    assert_eq!((grey(&loaded, 0), loaded.notes.len()), (0.5, 0));
    let loaded = with("newmtl a\nKd .5\nKe 1\nnewmtl a\nKd .5 .5 .6\nKe 1\n");
    let fault = material(&loaded, 0).reflectance().unwrap_err().to_string();
    for part in [
        "material a is defined twice",
        "a.mtl, line 1",
        "a.mtl, line 4",
    ] {
        assert!(fault.contains(part), "{fault}");
    }
    assert!(material(&loaded, 0).emittance().is_ok());
    assert_noted(&loaded, &[&fault]);
}

/// An emissivity of 0 is a reflectance of 1; what is none is unknown, and nothing emits.
#[test]
fn emissivities_are_no_obstacle() {
    for (emit, says) in [
        ("0", None),
        ("0.0e-7 mirror", None),
        (
            "1e-400 mirror",
            Some("is so small that the reflectance rounds to 1"),
        ),
        ("1e-30 mirror", Some("the emissivity 1e-30 is so small")),
        (
            "1.1 bright",
            Some("the emissivity is 1.1: it must be at least 0 and at most 1"),
        ),
        ("-0.1", Some("the emissivity is -0.1")),
        ("nan x", Some("emit is \"nan\": write a finite number")),
        ("wall", Some("emit is \"wall\": write a number")),
        ("", Some("emit is missing")),
    ] {
        let vertices = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\n";
        let text = format!("{vertices}S 7 1 2 3 4 0 0 {emit}\nEnd of data\n");
        let loaded = vs3(&text).unwrap();
        let material = material(&loaded, 0);
        assert!(material.emittance().is_ok());
        match (material.reflectance(), says) {
            (Ok(reflectance), None) => assert_eq!(reflectance.g, 1.0),
            (Err(fault), Some(says)) => {
                let fault = fault.to_string();
                assert!(fault.contains("room.vs3, line 6, patch 0"), "{fault}");
                assert!(fault.contains(says), "{fault}");
                assert_noted(&loaded, &[&fault]);
            }
            other => panic!("{emit}: {other:?}"),
        }
    }
}

/// Paths as people write them: the file is found, with a note if it is elsewhere than they say.
#[test]
fn libraries_are_found_as_people_write_them() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    };
    write("paint.mtl", "newmtl a\nKd .1\n");
    write("my paint.mtl", "newmtl a\nKd .2\n");
    write("textures/Deep.mtl", "newmtl a\nKd .3\n");
    write("Both.mtl", "newmtl a\nKd .4\n");
    write("BOTH.mtl", "newmtl a\nKd .5\n");
    let loaded = |library: &str| -> LoadedScene {
        write(
            "room.obj",
            &format!("mtllib {library}\n{SQUARE}usemtl a\n{FACE}"),
        );
        read(&folder.path().join("room.obj"), NonPlanarFaces::Refuse).unwrap()
    };
    let absolute = folder.path().join("paint.mtl");
    for (library, expected, is_noted) in [
        ("paint.mtl", 0.1, false),
        ("./paint.mtl", 0.1, false),
        ("paint.mtl   # comment", 0.1, false),
        ("PAINT.MTL", 0.1, true),
        (absolute.to_str().unwrap(), 0.1, false),
        ("C:\\Users\\x\\Paint.mtl", 0.1, true),
        ("/Users/x/paint.mtl", 0.1, true),
        ("/Users/x/my paint.mtl", 0.2, true),
        ("my paint.mtl", 0.2, false),
        ("\"my paint.mtl\"", 0.2, false),
        ("my\\ paint.mtl", 0.2, false),
        ("'My Paint.mtl'", 0.2, true),
        (".\\textures\\Deep.mtl", 0.3, false),
        ("Textures/deep.mtl", 0.3, true),
        ("BOTH.mtl", 0.5, false),
        ("Both.mtl", 0.4, false),
        // one of two that differ in case alone
        ("both.mtl", f64::NAN, true),
        ("../gone.mtl", f64::NAN, true),
    ] {
        let loaded = loaded(library);
        let found = grey(&loaded, 0);
        assert!(found.to_bits() == expected.to_bits(), "{library}: {found}");
        assert_eq!(
            !loaded.notes.is_empty(),
            is_noted,
            "{library}: {:?}",
            loaded.notes
        );
    }
    let ambiguous = loaded("both.mtl");
    assert_noted(&ambiguous, &["\"BOTH.mtl\" and \"Both.mtl\" both fit"]);
    let several = loaded("my paint.mtl gone.mtl");
    assert_eq!(grey(&several, 0), 0.2);
    assert_noted(&several, &["gone.mtl: it cannot be read"]);
}

/// Exporters that name a library before every object name one library.
#[test]
fn a_library_is_read_once() {
    let named = "mtllib a.mtl\n".repeat(1000);
    let text = format!("{named}{SQUARE}usemtl a\n{FACE}");
    let loaded = obj_with(&text, "newmtl a\nKs 1\nKd .5\n").unwrap();
    assert_eq!((grey(&loaded, 0), loaded.notes.len()), (0.5, 1));
}

/// The words of a line are cut where files are; missing names end in `.mtl`.
#[test]
fn a_line_is_cut_into_the_files_that_are_there() {
    let files = ["a.mtl", "my paint.mtl", "b c.mtl", "c.mtl", "d #1.mtl"];
    let library = |name: &str| {
        let reason = "not there".to_owned();
        let missing = FileError::of_file(Path::new(name), Fault::CannotRead { reason });
        let is_there = files.contains(&name);
        let text = format!("newmtl {name}\nKd .5\n");
        is_there.then(|| Source::new(name, text)).ok_or(missing)
    };
    for (line, found, missing) in [
        ("my paint.mtl", &["my paint.mtl"][..], None),
        ("a.mtl my paint.mtl", &["a.mtl", "my paint.mtl"], None),
        ("b c.mtl  a.mtl", &["b c.mtl", "a.mtl"], None),
        ("gone far.mtl a.mtl", &["a.mtl"], Some("gone far.mtl")),
        ("a.mtl # paints", &["a.mtl"], None),
        ("d #1.mtl", &["d #1.mtl"], None),
        ("no extension", &[], Some("no extension")),
    ] {
        let uses = files.map(|file| format!("usemtl {file}\n{FACE}")).concat();
        let source = Source::new("room.obj", format!("mtllib {line}\n{SQUARE}{uses}"));
        let loaded = read_obj(&source, &library, NonPlanarFaces::Refuse).unwrap();
        for (patch, file) in files.iter().enumerate() {
            let is_known = material(&loaded, patch).reflectance().is_ok();
            assert_eq!(is_known, found.contains(file), "{line}: {file}");
        }
        let notes = loaded.notes.join("\n");
        let says = |name: &str| notes.contains(&format!("the material file {name}: it cannot"));
        assert_eq!(
            missing.is_none(),
            !notes.contains("it cannot be read"),
            "{notes}"
        );
        assert!(missing.is_none_or(says), "{notes}");
    }
}
