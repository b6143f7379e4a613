//! Whatever the bytes, a reader answers with a scene or with one message, and never panics.

use infoscene::scene::files::{
    FileErrors, LoadedScene, NonPlanarFaces, Source, read_obj, read_stl, read_view3d, write_obj,
    write_stl, write_view3d,
};
use proptest::prelude::*;
use proptest::sample::Index;

const OBJ: &str = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0.0\nv 0 1 0\nv .5 .5 1e0\n\
    o floor\nusemtl grey\nf 1 2 3 4\ng side \\\nwall # left\nf 1/1 2//2 5/1/1\nf -1 -3 -5\n";
const MTL: &str = "newmtl grey\nKd 0.5 .25 1\nKe 1 2 3\nNs 10\nmap_Kd a.png\n";
const VS3: &str = "T title\nC encl=1 eps=1e-4\nF 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\n\
    V 5 .5 .5 1e0\nS 1 1 2 3 4 0 0 .9 floor ! part\nS 2 1 2 3 0 1 0 .25 mat\nS 3 1 2 5 0 0 0 1 a\n\
    S 4 2 3 5 0 0 3 1 b\nO 5 3 4 5 0\n\
    End of data\n";

const STL: &str = "solid room\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n\
    vertex 1 1 0.0\n endloop\nendfacet\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\n\
    vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid room\nsolid\nfacet normal 1 0 0\n\
    outer loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 0 .5 1e0\nendloop\nendfacet\nendsolid\n";
/// The number of formats that are text, and of all.
const TEXTS: usize = 4;
const FORMATS: usize = 5;

/// The readers, by what the file would be.
fn read(format: usize, bytes: &[u8], faces: NonPlanarFaces) -> Result<LoadedScene, FileErrors> {
    let source = |name: &str| Source::from_bytes(name, bytes.to_vec());
    let library = |name: &str| Ok(Source::new(name, MTL));
    match format {
        0 => read_obj(&source("a.obj")?, &library, faces),
        1 => {
            let materials = |_: &str| source("a.mtl");
            read_obj(&Source::new("a.obj", OBJ), &materials, faces)
        }
        2 => read_view3d(&source("a.vs3")?, faces),
        _ => read_stl("a.stl".as_ref(), bytes.to_vec(), faces),
    }
}

/// Either a scene of positive areas, or one line that begins with the name of a file and names a
/// line or the whole.
fn check(format: usize, bytes: &[u8]) -> Result<(), TestCaseError> {
    for faces in [NonPlanarFaces::Refuse, NonPlanarFaces::Triangulate] {
        match read(format, bytes, faces) {
            Ok(loaded) => {
                let mut patches = loaded.scene.patches().iter();
                prop_assert!(patches.all(|patch| patch.shape().area() > 0.0));
                // what is read can be joined, and written or refused
                let joined = loaded.scene.joined();
                prop_assert!(joined.is_ok(), "{:?}", joined);
                let [obj, vs3, stl] = [
                    write_obj(&loaded.scene, "a.mtl").is_ok(),
                    write_view3d(&loaded.scene).is_ok(),
                    write_stl(&loaded.scene).is_ok(),
                ];
                prop_assert!(format < TEXTS - 1 || (obj && vs3) || !stl);
            }
            Err(refusal) => {
                let ends = |byte: &u8| matches!(byte, b'\n' | b'\r');
                let lines = bytes.split(ends).count().max(OBJ.lines().count());
                for fault in refusal.told() {
                    let message = fault.to_string();
                    prop_assert!(message.starts_with("a."), "{}", message);
                    prop_assert!(!message.contains(char::is_control), "{:?}", message);
                    prop_assert!(message.len() < 600, "{}", message);
                    prop_assert!(fault.line.is_none_or(|line| (1..=lines).contains(&line)));
                }
            }
        }
    }
    Ok(())
}

fn valid(format: usize) -> Vec<u8> {
    match format {
        0..TEXTS => [OBJ, MTL, VS3, STL][format].into(),
        // two of the facets, and what follows the last
        _ => {
            let scene = read(3, STL.as_bytes(), NonPlanarFaces::Refuse)
                .unwrap()
                .scene;
            let mut bytes = write_stl(&scene).unwrap().bytes;
            bytes[80] = 2;
            bytes
        }
    }
}

#[test]
fn the_files_that_are_spoilt_are_valid() {
    for format in 0..FORMATS {
        read(format, &valid(format), NonPlanarFaces::Refuse).unwrap();
    }
}

/// Cut after any byte: never a panic, and a View3D file that is cut before its last line is
/// refused.
#[test]
fn truncated_files_are_read_or_refused() {
    for format in 0..FORMATS {
        let bytes = valid(format);
        for length in 0..bytes.len() {
            check(format, &bytes[..length]).unwrap();
        }
    }
    for length in 0..=VS3.find("End").unwrap() {
        let cut = &VS3.as_bytes()[..length];
        assert!(read(2, cut, NonPlanarFaces::Refuse).is_err(), "{length}");
    }
}

/// A keyword, a separator or a number, most of them at the ends of what is allowed.
fn word() -> impl Strategy<Value = String> {
    let keywords = [
        "v", "f", "o", "g", "usemtl", "mtllib", "newmtl", "Kd", "Ke", "V", "S", "O", "F", "C", "T",
        "End", "solid", "facet", "vertex", "endfacet", "endsolid", "\n", "\n", "\n", "\\\n", "#",
        "!", "/", "\\", "=", "grey", "\u{2028}", "\0", "\r",
    ];
    let numbers = [
        "0",
        "1",
        "-1",
        "2",
        "3",
        "4",
        "6",
        "-6",
        "1e308",
        "-1e308",
        "5e-324",
        "nan",
        "inf",
        "1/1",
        "//",
        "+1",
        "0.5",
        "18446744073709551615",
        "-9223372036854775808",
        "1e-99999999999",
        "0.9e99999999999999999999",
    ];
    prop_oneof![
        1 => proptest::sample::select(keywords.to_vec()).prop_map(str::to_owned),
        2 => proptest::sample::select(numbers.to_vec()).prop_map(str::to_owned),
        1 => any::<f64>().prop_map(|x| format!("{x:?}")),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn random_bytes_are_refused(
        format in 0..FORMATS,
        bytes in proptest::collection::vec(any::<u8>(), 0..400),
    ) {
        check(format, &bytes)?;
    }

    /// Words of the formats in any order.
    #[test]
    fn random_words_are_read_or_refused(
        format in 0..TEXTS,
        words in proptest::collection::vec(word(), 0..80),
    ) {
        check(format, words.join(" ").as_bytes())?;
    }

    /// A valid file with words replaced, and lines left out or said twice.
    #[test]
    fn files_with_wrong_words_are_read_or_refused(
        format in 0..TEXTS,
        changes in proptest::collection::vec(
            (any::<Index>(), any::<Index>(), 0..6usize, word()),
            1..4,
        ),
    ) {
        let text = String::from_utf8(valid(format)).unwrap();
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for (line, place, kind, word) in changes {
            let line = line.index(lines.len());
            match kind {
                0 => lines.insert(line, lines[line].clone()),
                1 if lines.len() > 1 => drop(lines.remove(line)),
                _ => {
                    let mut words: Vec<&str> = lines[line].split(' ').collect();
                    let place = place.index(words.len());
                    words[place] = &word;
                    lines[line] = words.join(" ");
                }
            }
        }
        check(format, (lines.join("\n") + "\n").as_bytes())?;
    }

    /// A valid file with bytes changed, cut out and put in.
    #[test]
    fn mutated_files_are_read_or_refused(
        format in 0..FORMATS,
        changes in proptest::collection::vec(
            (
                any::<Index>(),
                0..4usize,
                prop_oneof![
                    any::<u8>(),
                    proptest::sample::select(b"0123456789-+.eE \n\\/#!vfVSO".to_vec()),
                ],
            ),
            1..12,
        ),
    ) {
        let mut bytes = valid(format);
        for (place, kind, byte) in changes {
            let place = place.index(bytes.len());
            match kind {
                0 => bytes[place] = byte,
                1 => bytes.insert(place, byte),
                2 if bytes.len() > 1 => drop(bytes.remove(place)),
                _ => bytes.swap(place, place / 2),
            }
        }
        check(format, &bytes)?;
    }
}
