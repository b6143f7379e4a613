//! STL as text: nested statements, one a line.

use super::{Facet, Reader};
use crate::scene::files::error::{FileError, FileErrors, excerpt};
use crate::scene::files::fault::Fault;
use crate::scene::files::source::{Source, number};
use glam::DVec3;

const VERTEX: &str = "\"vertex x y z\"";
const FACET: &str = "\"facet normal x y z\", then \"outer loop\", three vertices, \"endloop\" and \
                     \"endfacet\"";

pub(super) fn read(source: &Source, reader: &mut Reader) -> Result<(), FileErrors> {
    let mut solid = Solid::default();
    let mut faults = FileErrors::default();
    let mut last = 1;
    for (line, text) in source.lines() {
        last = line;
        faults.keep(statement(source, reader, &mut solid, (line, text)));
    }
    faults.keep(solid.closed().map_err(|fault| source.fault(last, fault)));
    faults.none_or_refused()
}

fn statement(
    source: &Source,
    reader: &mut Reader,
    solid: &mut Solid,
    (line, text): (usize, &str),
) -> Result<(), FileError> {
    let at = |fault| source.fault(line, fault);
    let (keyword, rest) = word(text);
    match keyword.to_ascii_lowercase().as_str() {
        "" => Ok(()),
        "solid" => {
            let name = rest.split_whitespace().collect::<Vec<_>>().join(" ");
            solid.begin(reader.remarks.short_name(line, name))
        }
        "facet" => solid.facet(line, rest),
        // "outer loop" … "endloop": a facet has one outline
        "outer" | "endloop" => solid.inside(keyword).map(|_| ()),
        "vertex" => solid.vertex(rest),
        "endfacet" => match solid.end_facet() {
            Ok(Some(facet)) => {
                let first = facet.place;
                let added = reader.facet(&solid.name, facet);
                return added.map_err(|(patch, fault)| source.patch_fault(first, patch, fault));
            }
            found => found.map(|_| ()),
        },
        "endsolid" => solid.end(),
        _ => {
            reader.remarks.ignore(keyword, line);
            Ok(())
        }
    }
    .map_err(at)
}

/// The first word of a text, and what follows it.
fn word(text: &str) -> (&str, &str) {
    let text = text.trim();
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    (word, rest.trim_start())
}

/// A solid, as far as it is read. What is at fault is taken as if it were right: its fault is told
/// once.
#[derive(Default)]
struct Solid {
    is_open: bool,
    name: String,
    /// The facet that is open; a corner that is at fault is not finite.
    facet: Option<Facet>,
    /// Whether the statements of a facet come without one, up to the next.
    is_lost: bool,
}

impl Solid {
    fn begin(&mut self, name: String) -> Result<(), Fault> {
        let closed = self.closed();
        (self.is_open, self.name) = (true, name);
        closed
    }

    fn facet(&mut self, line: usize, rest: &str) -> Result<(), Fault> {
        let (second, values) = word(rest);
        let is_normal = second.eq_ignore_ascii_case("normal");
        let components = values.split_whitespace().map(str::parse);
        let components: Result<Vec<f64>, _> = components.collect();
        let normal = components.ok().filter(|_| is_normal);
        let normal = normal.and_then(|values| <[f64; 3]>::try_from(values).ok());
        let before = self.facet.replace(Facet {
            corners: Vec::with_capacity(3),
            // what is no direction is not used either
            normal: normal.map(DVec3::from_array).filter(|n| n.is_finite()),
            place: line,
        });
        self.is_lost = false;
        let was_open = std::mem::replace(&mut self.is_open, true);
        match before {
            Some(_) => Err(misplaced(
                "facet",
                "after the \"endfacet\" of the one before",
            )),
            None if was_open => Ok(()),
            None => Err(misplaced("facet", "after \"solid name\"")),
        }
    }

    /// The facet that is open; the first statement outside of one is refused.
    fn inside(&mut self, keyword: &str) -> Result<Option<&mut Facet>, Fault> {
        let was_lost = std::mem::replace(&mut self.is_lost, self.facet.is_none());
        if self.is_lost && !was_lost {
            let place = "between \"facet\" and \"endfacet\"";
            return Err(misplaced(keyword, place));
        }
        Ok(self.facet.as_mut())
    }

    fn vertex(&mut self, rest: &str) -> Result<(), Fault> {
        let Some(facet) = self.inside("vertex")? else {
            return Ok(());
        };
        if facet.corners.len() == 3 {
            return Err(Fault::NotSupported {
                what: "a facet of more than three vertices is not supported".to_owned(),
                mend: "split it into triangles",
            });
        }
        let corner = corner(rest);
        facet.corners.push(*corner.as_ref().unwrap_or(&DVec3::NAN));
        corner.map(|_| ())
    }

    /// The facet that ends, unless a corner of it is at fault.
    fn end_facet(&mut self) -> Result<Option<Facet>, Fault> {
        self.inside("endfacet")?;
        let Some(facet) = self.facet.take() else {
            return Ok(None);
        };
        if facet.corners.len() < 3 {
            self.is_lost = true;
            let (what, form) = ("a vertex of the facet", FACET);
            return Err(Fault::Missing { what, form });
        }
        let is_right = facet.corners.iter().all(|corner| corner.is_finite());
        Ok(is_right.then_some(facet))
    }

    fn end(&mut self) -> Result<(), Fault> {
        let was_open = std::mem::take(&mut self.is_open);
        match self.facet.take() {
            Some(_) => Err(misplaced(
                "endsolid",
                "after the \"endfacet\" of the last facet",
            )),
            None if was_open => Ok(()),
            None => Err(misplaced("endsolid", "after \"solid name\"")),
        }
    }

    /// Refuses a solid that has no end.
    const fn closed(&self) -> Result<(), Fault> {
        if self.is_open {
            return Err(Fault::NoEnd { last: "endsolid" });
        }
        Ok(())
    }
}

fn corner(rest: &str) -> Result<DVec3, Fault> {
    let mut values = rest.split_whitespace();
    let mut coordinate = |what| number(values.next(), what, VERTEX);
    let corner = DVec3::new(coordinate("x")?, coordinate("y")?, coordinate("z")?);
    match values.next() {
        None => Ok(corner),
        Some(given) => Err(Fault::TooMany {
            given: excerpt(given),
            form: VERTEX,
        }),
    }
}

/// The refusal of a statement that belongs elsewhere.
fn misplaced(keyword: &str, place: &'static str) -> Fault {
    Fault::Misplaced {
        keyword: excerpt(keyword),
        place,
    }
}
