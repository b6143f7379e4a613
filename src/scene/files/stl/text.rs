//! STL as text: nested statements, one a line.

use super::{Facet, Reader};
use crate::scene::files::error::{Fault, FileError, excerpt};
use crate::scene::files::source::{Source, number};
use glam::DVec3;

const VERTEX: &str = "\"vertex x y z\"";
const FACET: &str = "\"facet normal x y z\", then \"outer loop\", three vertices, \"endloop\" and \
                     \"endfacet\"";

pub(super) fn read(source: &Source, reader: &mut Reader) -> Result<(), FileError> {
    let mut solid = Solid::default();
    let mut last = 1;
    for (line, text) in source.lines() {
        last = line;
        let at = |fault| source.fault(line, fault);
        let (keyword, rest) = word(text);
        let (second, values) = word(rest);
        match keyword.to_ascii_lowercase().as_str() {
            "" => {}
            "solid" => solid.begin(rest).map_err(at)?,
            "facet" => solid.facet(line, second, values).map_err(at)?,
            // "outer loop" … "endloop": a facet has one outline
            "outer" | "endloop" => solid.open(keyword).map(|_| ()).map_err(at)?,
            "vertex" => solid.vertex(rest).map_err(at)?,
            "endfacet" => {
                let (first, facet) = solid.end_facet().map_err(at)?;
                let at = |patch, fault| source.patch_fault(first, patch, fault);
                reader.facet(&solid.name, facet, at)?;
            }
            "endsolid" => solid.end().map_err(at)?,
            _ => {
                return Err(at(Fault::UnknownKeyword {
                    format: "STL",
                    keyword: excerpt(keyword),
                }));
            }
        }
    }
    solid.closed().map_err(|fault| source.fault(last, fault))
}

/// The first word of a text, and what follows it.
fn word(text: &str) -> (&str, &str) {
    let text = text.trim();
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    (word, rest.trim_start())
}

/// A solid, as far as it is read.
#[derive(Default)]
struct Solid {
    is_open: bool,
    name: String,
    /// The facet that is open, and the line in which it begins.
    facet: Option<(usize, Facet)>,
}

impl Solid {
    fn begin(&mut self, name: &str) -> Result<(), Fault> {
        self.closed()?;
        self.is_open = true;
        self.name = name.split_whitespace().collect::<Vec<_>>().join(" ");
        Ok(())
    }

    fn facet(&mut self, line: usize, second: &str, values: &str) -> Result<(), Fault> {
        if !self.is_open {
            return Err(misplaced("facet", "after \"solid name\""));
        }
        if self.facet.is_some() {
            return Err(misplaced(
                "facet",
                "after the \"endfacet\" of the one before",
            ));
        }
        let is_normal = second.eq_ignore_ascii_case("normal");
        let components = values.split_whitespace().map(str::parse);
        let components: Result<Vec<f64>, _> = components.collect();
        let normal = components.ok().filter(|_| is_normal);
        let normal = normal.and_then(|values| <[f64; 3]>::try_from(values).ok());
        let facet = Facet {
            corners: Vec::with_capacity(3),
            // what is no direction is not used either
            normal: normal.map(DVec3::from_array).filter(|n| n.is_finite()),
        };
        self.facet = Some((line, facet));
        Ok(())
    }

    /// The facet that is open; a statement outside of one is refused.
    fn open(&mut self, keyword: &str) -> Result<&mut Facet, Fault> {
        let open = self.facet.as_mut().map(|(_, facet)| facet);
        open.ok_or_else(|| misplaced(keyword, "between \"facet\" and \"endfacet\""))
    }

    fn vertex(&mut self, rest: &str) -> Result<(), Fault> {
        let facet = self.open("vertex")?;
        let mut values = rest.split_whitespace();
        let mut coordinate = |what| number(values.next(), what, VERTEX);
        let corner = DVec3::new(coordinate("x")?, coordinate("y")?, coordinate("z")?);
        if let Some(given) = values.next() {
            return Err(Fault::TooMany {
                given: excerpt(given),
                form: VERTEX,
            });
        }
        if facet.corners.len() == 3 {
            return Err(Fault::NotSupported {
                what: "a facet of more than three vertices is not supported".to_owned(),
                mend: "split it into triangles",
            });
        }
        facet.corners.push(corner);
        Ok(())
    }

    fn end_facet(&mut self) -> Result<(usize, Facet), Fault> {
        let open = self.facet.take();
        let (line, facet) = open.ok_or_else(|| misplaced("endfacet", "after \"facet\""))?;
        if facet.corners.len() < 3 {
            let (what, form) = ("a vertex of the facet", FACET);
            return Err(Fault::Missing { what, form });
        }
        Ok((line, facet))
    }

    fn end(&mut self) -> Result<(), Fault> {
        if !self.is_open {
            return Err(misplaced("endsolid", "after \"solid name\""));
        }
        if self.facet.is_some() {
            return Err(misplaced(
                "endsolid",
                "after the \"endfacet\" of the last facet",
            ));
        }
        self.is_open = false;
        Ok(())
    }

    /// Refuses a solid that has no end.
    const fn closed(&self) -> Result<(), Fault> {
        if self.is_open {
            return Err(Fault::NoEnd { last: "endsolid" });
        }
        Ok(())
    }
}

/// The refusal of a statement that belongs elsewhere.
fn misplaced(keyword: &str, place: &'static str) -> Fault {
    Fault::Misplaced {
        keyword: excerpt(keyword),
        place,
    }
}
