//! The rooms of the house: data flow through them in one direction, and no module uses itself
//! through others.

use crate::{code, sources};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The names that a module uses: every path that begins with `crate`, `super` or `self`, and all
/// that it imports.
struct Module {
    paths: Vec<String>,
    imports: Vec<String>,
}

impl Module {
    fn of(text: &str) -> Self {
        let code = code(text);
        Self {
            paths: paths(&code),
            imports: imports(&code),
        }
    }
}

/// The modules by their path: `form_factor::contour` is `src/form_factor/contour/mod.rs`.
type Modules = BTreeMap<String, Module>;

fn modules() -> Modules {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let named = sources("src").into_iter().map(|path| {
        let inside = path.strip_prefix(&root).unwrap().with_extension("");
        let names = inside.iter().map(|name| name.to_str().unwrap());
        let names: Vec<&str> = names.filter(|name| *name != "mod").collect();
        (
            names.join("::"),
            Module::of(&fs::read_to_string(path).unwrap()),
        )
    });
    named.collect()
}

fn room(module: &str) -> &str {
    module.split("::").next().unwrap()
}

/// The rooms in the order of the arrow in the head of `src/lib.rs`.
fn flow(head: &str) -> Vec<String> {
    let head = head.lines().map_while(|line| line.strip_prefix("//!"));
    let head = head.collect::<Vec<_>>().join("\n");
    let mut blocks = head.split("```text").skip(1);
    let arrow =
        blocks.find_map(|block| block.split("```").next().filter(|text| text.contains('→')));
    let names = arrow.unwrap_or("").split('→');
    names.map(|name| name.trim().to_owned()).collect()
}

fn the_flow() -> Vec<String> {
    flow(include_str!("../../src/lib.rs"))
}

/// The place of a room in the flow: the command, which belongs to the binary, comes last.
fn place(flow: &[String], room: &str) -> Option<usize> {
    let found = flow.iter().position(|name| name == room);
    found.or(["cli", "main"].contains(&room).then_some(flow.len()))
}

/// All paths in the code that begin with `crate`, `super` or `self`, groups in braces taken apart.
fn paths(code: &str) -> Vec<String> {
    let is_path = |at: usize| {
        let before = &code[..at];
        let continues = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
        !before.ends_with(continues) && !before.ends_with("(in ")
    };
    let heads = ["crate::", "super::", "self::"];
    let starts = heads.iter().flat_map(|head| code.match_indices(head));
    let starts = starts.map(|(at, _)| at).filter(|at| is_path(*at));
    starts.flat_map(|at| tree(&code[at..]).0).collect()
}

/// The imports of code by `use`, public or not, groups in braces taken apart.
fn imports(code: &str) -> Vec<String> {
    let statements = code.split(';').filter_map(|statement| {
        let words = statement.trim_start();
        let is_public = words.starts_with("pub use ") || words.starts_with("pub(");
        let (_, tree) = words.split_once("use ")?;
        (is_public || words.starts_with("use ")).then_some(tree)
    });
    statements.flat_map(|text| tree(text).0).collect()
}

/// The paths of the tree of names at the beginning of a text, and the text after it.
fn tree(text: &str) -> (Vec<String>, &str) {
    let text = text.trim_start();
    if let Some(mut rest) = text.strip_prefix('{') {
        let mut found = Vec::new();
        while !rest.is_empty() && !rest.starts_with('}') {
            let (paths, after) = tree(rest.trim_start_matches(',').trim_start());
            found.extend(paths);
            rest = &after[after.find([',', '}']).unwrap_or(after.len())..];
            rest = rest.trim_start_matches(|c: char| c == ',' || c.is_whitespace());
        }
        return (found, rest.strip_prefix('}').unwrap_or(rest));
    }
    if let Some(rest) = text.strip_prefix('*') {
        return (vec!["*".to_owned()], rest);
    }
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let end = text.find(|c| !is_name(c)).unwrap_or(text.len());
    let (name, rest) = text.split_at(end);
    let inner = rest.strip_prefix("::");
    match inner.filter(|inner| inner.starts_with(|c| is_name(c) || c == '{' || c == '*')) {
        Some(inner) => {
            let (paths, rest) = tree(inner);
            let whole = |path: String| match path.as_str() {
                "self" => name.to_owned(),
                _ => format!("{name}::{path}"),
            };
            (paths.into_iter().map(whole).collect(), rest)
        }
        None if name.is_empty() => (Vec::new(), rest),
        None => (vec![name.to_owned()], rest),
    }
}

/// The module that defines what a path means in the module `from`: re-exports are followed.
fn definition(modules: &Modules, from: &str, path: &str, steps: usize) -> String {
    let mut at = from.to_owned();
    for name in path.split("::") {
        let inner = format!("{at}::{name}");
        let inner = inner.trim_start_matches("::").to_owned();
        match name {
            "crate" => at.clear(),
            "self" => (),
            "super" => {
                at = at
                    .rsplit_once("::")
                    .map_or("", |(outer, _)| outer)
                    .to_owned()
            }
            _ if modules.contains_key(&inner) => at = inner,
            _ => {
                let imported = modules.get(&at).map_or(&[][..], |module| &module.imports);
                let end = format!("::{name}");
                let found = imported.iter().find(|path| path.ends_with(&end));
                return match found {
                    Some(path) if steps > 0 => definition(modules, &at, path, steps - 1),
                    _ => at,
                };
            }
        }
    }
    at
}

/// The modules of its room that each module uses. A folder's `mod.rs` may name what is in
/// it.
fn uses(modules: &Modules) -> BTreeMap<&str, BTreeSet<String>> {
    let used = modules.iter().map(|(name, module)| {
        let found = module.paths.iter();
        let found = found.map(|path| definition(modules, name, path, 8));
        let is_own = |used: &String| used == name || used.starts_with(&format!("{name}::"));
        let others = found.filter(|used| room(used) == room(name) && !is_own(used));
        (name.as_str(), others.collect())
    });
    used.collect()
}

/// All modules that a module comes to by uses of uses.
fn reached(uses: &BTreeMap<&str, BTreeSet<String>>, from: &str) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut open = vec![from.to_owned()];
    while let Some(module) = open.pop() {
        let next = uses.get(module.as_str()).into_iter().flatten();
        open.extend(next.filter(|next| reached.insert((*next).clone())).cloned());
    }
    reached
}

/// The modules that reach each other, circle by circle.
fn circles(modules: &Modules) -> Vec<Vec<String>> {
    let uses = uses(modules);
    let reach = uses.keys().map(|module| (*module, reached(&uses, module)));
    let reach: BTreeMap<&str, BTreeSet<String>> = reach.collect();
    let circle = |module: &&str| {
        let returns = |other: &&String| reach[other.as_str()].contains(*module);
        reach[module].iter().filter(returns).cloned().collect()
    };
    let circles = uses.keys().map(circle);
    let circles = circles.filter(|circle: &Vec<String>| !circle.is_empty());
    circles.collect::<BTreeSet<_>>().into_iter().collect()
}

/// One line for each use inside a circle.
fn told(modules: &Modules, circle: &[String]) -> String {
    let uses = uses(modules);
    let inside = circle.iter().flat_map(|module| {
        let used = uses[module.as_str()]
            .iter()
            .filter(|used| circle.contains(used));
        used.map(move |used| format!("  {module} uses {used}\n"))
    });
    inside.collect()
}

#[test]
fn modules_use_only_modules_to_their_left() {
    let flow = the_flow();
    assert!(flow.len() >= 11, "the arrow is {flow:?}");
    let mut uses = 0;
    for (name, module) in modules().iter().filter(|(name, _)| *name != "lib") {
        let own = place(&flow, room(name));
        let paths = module.paths.iter();
        for path in paths.filter_map(|path| path.strip_prefix("crate::")) {
            let used = place(&flow, room(path));
            uses += usize::from(used.is_some() && used < own);
            assert!(used.is_none() || used <= own, "{name} uses {path}");
        }
    }
    assert!(uses > 40, "the check sees {uses} uses only");
}

#[test]
fn every_folder_of_the_library_is_in_the_flow() {
    let flow = the_flow();
    for name in modules().keys().filter(|name| *name != "lib") {
        let own = place(&flow, room(name));
        assert!(
            own.is_some(),
            "{name} has no place in the arrow of src/lib.rs"
        );
    }
}

#[test]
fn the_arrow_is_read_over_several_lines() {
    let head = "//! A house.\n//!\n//! ```text\n//! a = b\n//! ```\n//!\n//! ```text\n//! \
        numeric → geometry →\n//!     chain\n//! ```\nmod x;\n";
    let flow = flow(head);
    assert_eq!(flow, ["numeric", "geometry", "chain"]);
    let places = ["numeric", "chain", "cli", "main", "attic"].map(|room| place(&flow, room));
    assert_eq!(places, [Some(0), Some(2), Some(3), Some(3), None]);
}

#[test]
fn every_path_is_seen() {
    let text = "use crate::{numeric::{self, A, b::C as D}, chain::X};\nlet x = super::y::f(1.0);\n\
        /// [`crate::cli`]\npub(in crate::z) fn g() {} // crate::w\nuse super::{K, L,};\n\
        #[cfg(test)]\nmod tests {\n    use super::*;\n}\n";
    let expected = [
        "crate::numeric",
        "crate::numeric::A",
        "crate::numeric::b::C",
        "crate::chain::X",
        "super::y::f",
        "super::K",
        "super::L",
    ];
    assert_eq!(paths(&code(text)), expected);
}

fn house(files: &[(&str, &str)]) -> Modules {
    let named = files.iter();
    named
        .map(|(name, text)| ((*name).to_owned(), Module::of(text)))
        .collect()
}

#[test]
fn a_circle_inside_a_room_is_seen() {
    let hall = (
        "hall",
        "mod lamp;\nmod wire;\npub use lamp::{Bulb, Lamp};\npub struct Door;",
    );
    let wire = ("hall::wire", "use super::Door;\nuse crate::cellar::Fuse;");
    let cellar = ("cellar", "pub struct Fuse;");
    let lamp = |text| ("hall::lamp", text);
    let found = |files: &[(&str, &str)]| {
        let modules = house(files);
        circles(&modules).concat().join(" ")
    };
    assert_eq!(
        found(&[hall, wire, cellar, lamp("use super::wire::Copper;")]),
        ""
    );
    // by a sibling's name, by the re-export of their folder, and by a path in an expression
    for text in [
        "use super::lamp::Bulb;",
        "use super::{Bulb, Door};",
        "crate::hall::Lamp::new();",
    ] {
        let wire = ("hall::wire", text);
        let files = [hall, wire, cellar, lamp("use super::wire::Copper;")];
        assert_eq!(found(&files), "hall::lamp hall::wire", "{text}");
    }
}

#[test]
fn a_circle_through_a_folder_is_seen() {
    let text = [
        ("hall", "pub use shelf::Book;"),
        (
            "hall::shelf",
            "mod book;\npub use book::Book;\nuse super::desk::Desk;\npub struct Board;",
        ),
        ("hall::shelf::book", "use super::Board;"),
        ("hall::desk", "use super::Book;"),
    ];
    let modules = house(&text);
    let circle = ["hall::desk", "hall::shelf", "hall::shelf::book"];
    assert_eq!(circles(&modules), [circle]);
    let lines = "  hall::desk uses hall::shelf::book\n  hall::shelf uses hall::desk\n  \
        hall::shelf::book uses hall::shelf\n";
    assert_eq!(told(&modules, &circles(&modules)[0]), lines);
}

#[test]
fn rooms_have_no_circles() {
    let modules = modules();
    let found = circles(&modules);
    let lines = found.iter();
    let lines = lines.map(|circle| format!("{circle:?}:\n{}", told(&modules, circle)));
    let lines: Vec<String> = lines.collect();
    assert!(lines.is_empty(), "circles:\n{}", lines.concat());
}
