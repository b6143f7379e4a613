//! A scene as View3D `.vs3`.

use crate::scene::files::decimal::complement;
use crate::scene::files::error::NotExpressible;
use crate::scene::files::obj::writer::VertexNumbers;
use crate::scene::{Channels, NamedPatch, PatchMaterial, Scene};
use glam::DVec3;
use std::collections::HashMap;
use std::fmt::Write;

/// Writes a scene: shapes, grey reflectances, bases and rows read back exactly.
///
/// The reflectance of a coloured patch is the mean of its channels; one that is not known is 0.
/// In a name, white space becomes single spaces, and `!` and a `/` that begins a word become `_`.
///
/// # Errors
/// [`NotExpressible`] if a patch emits light or has more than four corners.
pub fn write_view3d(scene: &Scene) -> Result<String, NotExpressible> {
    let count = scene.patches().len();
    let mut vertices = VertexNumbers::default();
    let mut leads = HashMap::new();
    let (mut points, mut surfaces) = (String::new(), String::new());
    let patches = scene.patches().iter().map(|patch| ('S', patch));
    let obstructions = scene.obstructions().iter().map(|patch| ('O', patch));
    for (index, (keyword, patch)) in patches.chain(obstructions).enumerate() {
        let corners = corners(index, patch, &mut vertices, &mut points)?;
        let _ = write!(surfaces, "{keyword} {}", index + 1);
        for corner in corners {
            let _ = write!(surfaces, " {corner}");
        }
        let (mut base, mut combined) = (0, 0);
        if index < count {
            base = scene.base_of(index).map_or(0, |base| base + 1);
            let lead = leads.entry(scene.group_of(index)).or_insert(index);
            combined = if *lead < index { *lead + 1 } else { 0 };
        }
        let reflectance = patch.material().reflectance();
        let emissivity = emissivity(reflectance.map_or(0.0, Channels::mean));
        let name = word_by_word(patch.name());
        let _ = writeln!(surfaces, " {base} {combined} {emissivity} {name}");
    }
    Ok(format!("F 3\n{points}{surfaces}End of data\n"))
}

/// The emissivity of a surface with this reflectance, as a decimal: 1 − reflectance, not rounded.
pub(crate) fn emissivity(reflectance: f64) -> String {
    complement(&format!("{reflectance:?}")).unwrap_or_else(|| "1".to_owned())
}

/// Notes on what [`write_view3d`] leaves out of a scene.
pub(crate) fn left_out_of_view3d(scene: &Scene) -> Vec<String> {
    let count = |is: &dyn Fn(&PatchMaterial) -> bool| {
        let patches = scene.patches().iter();
        patches.filter(|patch| is(patch.material())).count()
    };
    let unknown = count(&|material| material.faults().next().is_some());
    let coloured = count(&|material| material.reflectance().is_ok_and(|colour| !colour.is_grey()));
    let notes = [
        (unknown, "whose material is not known are written as black"),
        (coloured, "are coloured and have the mean of their channels"),
    ];
    let without_area = scene.empty_rows().len();
    let notes = notes
        .into_iter()
        .chain([(without_area, "without an area are left out")]);
    let notes = notes.filter(|(patches, _)| *patches > 0);
    notes
        .map(|(patches, what)| format!("{patches} patches {what}"))
        .collect()
}

fn corners(
    index: usize,
    patch: &NamedPatch,
    vertices: &mut VertexNumbers,
    points: &mut String,
) -> Result<[usize; 4], NotExpressible> {
    let not = |what: String, mend: &'static str| NotExpressible {
        format: "View3D",
        what,
        mend,
    };
    if patch
        .material()
        .emittance()
        .is_ok_and(|colour| colour.largest() > 0.0)
    {
        let what = format!("patch {index} ({}) emits light", patch.name());
        return Err(not(what, "write Wavefront OBJ, which has Ke"));
    }
    let given = patch.shape().given_corners();
    if given.len() > 4 {
        let what = format!(
            "patch {index} ({}) has {} corners",
            patch.name(),
            given.len()
        );
        return Err(not(what, NotExpressible::SPLIT));
    }
    let mut numbers = [0; 4];
    for (number, corner) in numbers.iter_mut().zip(given) {
        *number = vertices.number_or(*corner, |number| {
            let DVec3 { x, y, z } = *corner;
            let _ = writeln!(points, "V {number} {x:?} {y:?} {z:?}");
        });
    }
    Ok(numbers)
}

fn word_by_word(name: &str) -> String {
    let words = name.split_whitespace().map(|word| {
        let word = word.replace('!', "_");
        match word.strip_prefix('/') {
            Some(rest) => format!("_{rest}"),
            None => word,
        }
    });
    words.collect::<Vec<_>>().join(" ")
}
