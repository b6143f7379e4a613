//! Whatever is done to a file, a reader answers with a scene or says what is wrong, and takes no
//! more memory than a hundred times the file.
//!
//! Seeds of each format are changed by bytes, by words and by lines, one to six times; files of
//! extremes are made by hand. To read a new format here, add it to [`FORMATS`]. Memory is counted
//! by the allocator of this program, which is why it is one of its own.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

mod changes;

use changes::{Random, changed};
use infoscene::scene::files::{
    FileErrors, LoadedScene, NonPlanarFaces, Source, read_obj, read_stl, read_view3d, write_stl,
};
use peak_alloc::PeakAlloc;
use std::panic::catch_unwind;
use std::sync::{Mutex, PoisonError};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The allocator counts for all threads: one test at a time.
static TURN: Mutex<()> = Mutex::new(());

/// The most memory in multiples of a file, as it is and with its faces split into triangles, each
/// of which is a patch with a name; and the size that smaller files count as, as messages are as
/// long for a file of one line.
const MOST: usize = 100;
const MOST_IN_TRIANGLES: usize = 200;
const SMALLEST: usize = 1024;

type Read = fn(&[u8], NonPlanarFaces) -> Result<LoadedScene, FileErrors>;

struct Format {
    seeds: fn() -> Vec<Vec<u8>>,
    read: Read,
}

const FORMATS: [Format; 4] = [
    Format {
        seeds: || [OBJ, OUTLINES].map(Vec::from).to_vec(),
        read: obj,
    },
    Format {
        seeds: || vec![MTL.into()],
        read: mtl,
    },
    Format {
        seeds: || vec![VS3.into()],
        read: vs3,
    },
    Format {
        seeds: || vec![STL.into(), binary_stl()],
        read: stl,
    },
];

const OBJ: &str = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0.0\nv 0 1 0\nv .5 .5 1e0\n\
    o floor\nusemtl grey\nf 1 2 3 4\ng side \\\nwall # left\nf 1/1 2//2 5/1/1\nf -1 -3 -5\n";

/// A bridged opening, repeated corners, a spike, faces without area, a bent face.
const OUTLINES: &str = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n\
    v 0 0 5 1 0 0\nv 3 0 5\nv 3 3 5\nv 0 3 5.01\nv 1.5 0 5\no wall\nf 1 2 3 4 1 5 6 7 8 5\n\
    f 5 5 8 7 6 6\nf 9 12 11 10\nf 9 13 10\nf 1 2 13 10 13 2\nf 9 10\n";

const MTL: &str = "newmtl grey\nKd 0.5 .25 1\nKe 1 2 3\nNs 10\nmap_Kd a.png\n";

const VS3: &str = "T title\nC encl=1 eps=1e-4\nF 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\n\
    V 5 .5 .5 1e0\nS 1 1 2 3 4 0 0 .9 floor ! part\nS 2 1 2 3 0 1 0 .25 mat\nS 3 1 2 5 0 0 0 1 a\n\
    S 4 2 3 5 5 0 3 1 b\nS 5 1 2 2 1 0 0 1 thread\nO 6 3 4 5 0\nEnd of data\n";

const STL: &str = "solid room\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n\
    \x20  vertex 1 0 0\n   vertex 1 1 0\n  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 1\n\
    \x20  vertex 1 0 1\n   vertex .5 0 1\n  endloop\n endfacet\nendsolid room\n";

/// The same facets in binary.
fn binary_stl() -> Vec<u8> {
    let text = stl(STL.as_bytes(), NonPlanarFaces::Refuse).unwrap();
    write_stl(&text.scene).unwrap().bytes
}

fn stl(bytes: &[u8], faces: NonPlanarFaces) -> Result<LoadedScene, FileErrors> {
    read_stl("a.stl".as_ref(), bytes.to_vec(), faces)
}

fn obj(bytes: &[u8], faces: NonPlanarFaces) -> Result<LoadedScene, FileErrors> {
    let library = |_: &str| Ok(Source::new("a.mtl", MTL));
    let source = Source::from_bytes("a.obj", bytes.to_vec())?;
    read_obj(&source, &library, faces)
}

fn mtl(bytes: &[u8], faces: NonPlanarFaces) -> Result<LoadedScene, FileErrors> {
    let library = |_: &str| Source::from_bytes("a.mtl", bytes.to_vec());
    read_obj(&Source::new("a.obj", OBJ), &library, faces)
}

fn vs3(bytes: &[u8], faces: NonPlanarFaces) -> Result<LoadedScene, FileErrors> {
    read_view3d(&Source::from_bytes("a.vs3", bytes.to_vec())?, faces)
}

/// Reads a file both ways: a scene of positive areas, or a text, in so much memory.
fn check(read: Read, bytes: &[u8]) -> Result<(), String> {
    for (faces, most) in [
        (NonPlanarFaces::Refuse, MOST),
        (NonPlanarFaces::Triangulate, MOST_IN_TRIANGLES),
    ] {
        let before = MEMORY.current_usage();
        MEMORY.reset_peak_usage();
        let answer = catch_unwind(|| read(bytes, faces)).map_err(|_| "a panic".to_owned())?;
        let used = MEMORY.peak_usage() - before;
        if used > most * bytes.len().max(SMALLEST) {
            return Err(format!("{used} bytes for {}", bytes.len()));
        }
        let is_right = match &answer {
            Ok(LoadedScene { scene, notes }) => {
                let mut patches = scene.patches().iter();
                patches.all(|patch| patch.shape().area() > 0.0)
                    && scene.row_areas().iter().all(|area| *area >= 0.0)
                    && scene.group_names().len() == scene.group_count()
                    && notes.iter().all(|note| note.starts_with("a."))
            }
            Err(faults) => {
                let mut told = faults.told().iter().map(ToString::to_string);
                !faults.told().is_empty() && told.all(|text| text.starts_with("a."))
            }
        };
        if !is_right {
            return Err(format!("{answer:?}"));
        }
    }
    Ok(())
}

fn check_mutated(format: &Format, count: u64) {
    let seeds = (format.seeds)();
    for case in 0..count {
        let mut random = Random(case);
        let mut file = seeds[random.below(seeds.len())].clone();
        for _ in 0..1 + random.below(6) {
            file = changed(&file, &seeds, &mut random);
        }
        if let Err(what) = check(format.read, &file) {
            panic!("case {case}: {what}\n{:?}", String::from_utf8_lossy(&file));
        }
    }
}

/// Ten thousand files.
#[test]
fn mutated_files_are_read_or_refused() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    for format in &FORMATS {
        for seed in (format.seeds)() {
            (format.read)(&seed, NonPlanarFaces::Triangulate).unwrap();
        }
        check_mutated(format, 10_000 / FORMATS.len() as u64);
    }
}

#[test]
#[ignore = "some minutes: cargo test --release --test mutated -- --ignored"]
fn a_million_mutated_files_of_each_format_are_read_or_refused() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    for format in &FORMATS {
        check_mutated(format, 1_000_000);
    }
}

/// Files of 60 kB, each of one thing that takes memory.
#[test]
fn no_file_asks_for_more_memory_than_it_is_worth() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\n";
    let name = "x".repeat(15_000);
    let many = |head: &str, line: &dyn Fn(usize) -> String| {
        let mut text = head.to_owned();
        for number in 0.. {
            if text.len() > 60_000 {
                break;
            }
            text.push_str(&line(number));
        }
        text
    };
    let texts = [
        many("", &|_| "v 0 0 0\n".to_owned()),
        many(square, &|_| "f 1 2 3\n".to_owned()),
        many(square, &|_| "f 1 2 3 4\n".to_owned()),
        many(square, &|_| "f 1 2 3 4 1 2\n".to_owned()),
        many(
            "v 0 0 0\nv 9 0 0\nv 9 9 1\nv 0 9 0\nv 1 1 0\nv 2 5 0\nv 3 1 0\n",
            &|_| "f 1 2 3 4 1 5 6 7 5\n".to_owned(),
        ),
        many(square, &|_| "f 1\n".to_owned()),
        many(square, &|_| "f x\n".to_owned()),
        many(square, &|_| "f 4000000000\n".to_owned()),
        many(&format!("{square}o {name}\n"), &|_| "f 1 2 3\n".to_owned()),
        many(&format!("{square}o {name}\ng {name}\n"), &|_| {
            "f 1 2 3 4\n".to_owned()
        }),
        many(square, &|number| format!("g {number}\nf 1 2 3\n")),
        many("", &|number| format!("w{number}\n")),
        many(square, &|_| "o\nf 1 2 3\n".to_owned()),
        many("mtllib a.mtl\n", &|_| "mtllib a.mtl\n".to_owned()),
        many("mtllib a.mtl\n", &|number| format!("usemtl {number}\n")),
        format!("{square}f{}\n", " 1 2 3".repeat(300)),
        format!("{square}f{}\n", " 1".repeat(30_000)),
        "\\\n".repeat(30_000),
        "\r".repeat(60_000),
        "\u{e9}".repeat(30_000),
    ];
    for text in &texts {
        check(obj, text.as_bytes()).unwrap_or_else(|what| panic!("{what}: {:.60}", text));
    }
    let latin_1: Vec<u8> = vec![0xe9; 60_000];
    check(obj, &latin_1).unwrap();
    let vertices = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\n";
    for text in [
        many("F 3\n", &|number| format!("V {number} 0 0 0\n")),
        many(vertices, &|number| format!("S {number} 1 2 3 0 0 0 1\n")),
        many(vertices, &|number| format!("S {number} 1 1 1 0 0 0 1\n")),
        many(vertices, &|number| format!("O {number} 1 2 3 0\n")),
        many(vertices, &|number| format!("S {number} 1 2 3 0 0 7 1\n")),
        many("", &|number| format!("C {number}x\n")),
        format!("C {}\n", many("", &|number| format!("k{number} "))),
        "S\n".repeat(30_000),
    ] {
        for text in [text.clone(), format!("{text}End of data\n")] {
            check(vs3, text.as_bytes()).unwrap_or_else(|what| panic!("{what}: {:.60}", text));
        }
    }
    for text in [
        many("solid\n", &|_| "facet normal 0 0 1\n".to_owned()),
        many("solid\n", &|_| {
            let corners = "vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n";
            format!("facet\nouter loop\n{corners}endloop\nendfacet\n")
        }),
        format!("solid {name}\n{}", STL.split_once('\n').unwrap().1),
    ] {
        check(stl, text.as_bytes()).unwrap_or_else(|what| panic!("{what}: {:.60}", text));
    }
    let mut facets = binary_stl();
    facets[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    check(stl, &facets).unwrap();
    facets[80..84].copy_from_slice(&1_200u32.to_le_bytes());
    let facet = facets[84..134].to_vec();
    facets.truncate(84);
    facets.extend(facet.repeat(1_200));
    check(stl, &facets).unwrap();
    let materials = [
        many("", &|number| format!("newmtl {number}\nKd 1 1 1\n")),
        many("", &|number| format!("w{number}\n")),
        "Kd\n".repeat(15_000),
    ];
    for text in &materials {
        check(mtl, text.as_bytes()).unwrap_or_else(|what| panic!("{what}: {:.60}", text));
    }
}
