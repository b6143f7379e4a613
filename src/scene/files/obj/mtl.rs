//! Wavefront MTL: of each material the diffuse reflectance `Kd` and the emittance `Ke`.
//!
//! ```text
//!   newmtl name      Kd r [g b]      Ke r [g b]        scalar = (r + g + b)/3
//! ```
//!
//! What says nothing about diffuse light is read over; gloss, transparency and textures are noted
//! as left out.
//!
//! **Not covered**: spectral curves and CIEXYZ values, which are refused.

use crate::scene::files::error::{Fault, FileError, excerpt};
use crate::scene::files::source::{Source, number};
use crate::scene::{Material, MaterialError};
use std::collections::HashMap;

const COLOUR: &str = "three numbers (red, green, blue)";

/// Statements that have no effect on diffuse light.
const SILENT: [&str; 7] = ["ka", "ns", "ni", "sharpness", "illum", "km", "tr"];

/// Statements that would have an effect, and have none here.
const LEFT_OUT: [&str; 17] = [
    "ks", "tf", "d", "bump", "disp", "decal", "refl", "norm", "pr", "pm", "ps", "pc", "pcr",
    "aniso", "anisor", "map_kd", "map_ke",
];

/// The materials of a file by name; `notes` says what is left out.
pub(crate) fn read_mtl(
    source: &Source,
    materials: &mut HashMap<String, Material>,
    notes: &mut Vec<String>,
) -> Result<(), FileError> {
    let mut current: Option<String> = None;
    for (line, text) in source.lines() {
        let at = |fault| source.fault(line, fault);
        let text = text.split('#').next().unwrap_or_default();
        let Some(keyword) = text.split_whitespace().next() else {
            continue;
        };
        let values: Vec<&str> = text.split_whitespace().skip(1).collect();
        match keyword.to_ascii_lowercase().as_str() {
            "newmtl" => {
                let name = values.join(" ");
                if name.is_empty() {
                    let (what, form) = ("the name of the material", "\"newmtl name\"");
                    return Err(at(Fault::Missing { what, form }));
                }
                materials.insert(name.clone(), Material::BLACK);
                current = Some(name);
            }
            key @ ("kd" | "ke") => {
                let material = current.as_ref().and_then(|name| materials.get_mut(name));
                let Some(material) = material else {
                    let (what, form) = (
                        "the material that this belongs to",
                        "\"newmtl name\" before it",
                    );
                    return Err(at(Fault::Missing { what, form }));
                };
                let is_reflectance = key == "kd";
                let value = scalar(&values, is_reflectance).map_err(at)?;
                let changed = if is_reflectance {
                    Material::try_new(value, material.emittance())
                } else {
                    Material::try_new(material.reflectance(), value)
                };
                *material = changed.map_err(|source| at(Fault::Material { source }))?;
            }
            key if SILENT.contains(&key) => {}
            key if LEFT_OUT.contains(&key) || key.starts_with("map_") => {
                let keyword = if key.starts_with("map_") {
                    "map_…"
                } else {
                    keyword
                };
                let note = format!(
                    "{}: \"{keyword}\" is left out, materials are diffuse and of one colour",
                    source.file().display()
                );
                if !notes.contains(&note) {
                    notes.push(note);
                }
            }
            _ => {
                return Err(at(Fault::UnknownKeyword {
                    format: "Wavefront MTL",
                    keyword: excerpt(keyword),
                }));
            }
        }
    }
    Ok(())
}

/// The mean of the three channels, each of them checked; one value stands for all three.
fn scalar(values: &[&str], is_reflectance: bool) -> Result<f64, Fault> {
    if let Some(kind @ ("spectral" | "xyz")) = values.first().copied() {
        return Err(Fault::NotSupported {
            what: format!("a colour given as \"{kind}\" is not supported"),
            mend: "write red, green and blue",
        });
    }
    let first = number(values.first().copied(), "the first channel", COLOUR)?;
    let channels = match values {
        [_] => [first; 3],
        _ => [
            first,
            number(values.get(1).copied(), "the second channel", COLOUR)?,
            number(values.get(2).copied(), "the third channel", COLOUR)?,
        ],
    };
    if let Some(given) = values.get(3) {
        return Err(Fault::TooMany {
            given: excerpt(given),
            form: COLOUR,
        });
    }
    for channel in channels {
        let source = if is_reflectance && !(0.0..=1.0).contains(&channel) {
            MaterialError::ReflectanceOutOfRange {
                reflectance: channel,
            }
        } else if channel < 0.0 {
            MaterialError::EmittanceOutOfRange { emittance: channel }
        } else {
            continue;
        };
        return Err(Fault::Material { source });
    }
    // from the first channel on, so that equal channels have their own value as the mean
    let [red, green, blue] = channels;
    Ok(red + ((green - red) + (blue - red)) / 3.0)
}
