//! Notes on the patches whose material is not known, which matters to light alone.

use crate::scene::NamedPatch;
use std::collections::HashMap;

/// Reasons that are told one by one.
const MOST_TOLD: usize = 20;

/// A note for each reason why the reflectance or the emittance of patches is not known.
pub(crate) fn notes_on_unknown_materials(patches: &[NamedPatch]) -> Vec<String> {
    let mut places = HashMap::new();
    let mut reasons: Vec<(String, usize)> = Vec::new();
    for fault in patches.iter().flat_map(|patch| patch.material().faults()) {
        let next = reasons.len();
        let place = *places.entry(fault).or_insert(next);
        match reasons.get_mut(place) {
            Some((_, patches)) => *patches += 1,
            None => reasons.push((fault.to_string(), 1)),
        }
    }
    let more = reasons.len().saturating_sub(MOST_TOLD);
    let mut notes: Vec<String> = reasons
        .into_iter()
        .take(MOST_TOLD)
        .map(|(reason, patches)| {
            let concerned = if patches == 1 { "patch" } else { "patches" };
            format!("{reason}; this matters to the light of {patches} {concerned} only")
        })
        .collect();
    if more > 0 {
        notes.push(format!("{more} more reasons why materials are not known"));
    }
    notes
}
