//! The reflectances and emittances of rows, for whoever asks for light.

use super::channel::Channels;
use super::material::{MaterialFault, PatchMaterial};
use super::{Scene, SceneError};

impl Scene {
    /// The reflectance that all patches of a row have; reflected power of different ones is not
    /// that of any single one.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::MaterialUnknown`] with the first patch whose
    /// reflectance is not known; [`SceneError::MixedRow`] with the first two that differ.
    pub fn group_reflectance(&self, group: usize) -> Result<Channels<f64>, SceneError> {
        self.group_property(group, "reflectance", PatchMaterial::reflectance)
    }

    /// The emittance that all patches of a row have.
    ///
    /// # Errors
    /// As [`group_reflectance`](Self::group_reflectance).
    pub fn group_emittance(&self, group: usize) -> Result<Channels<f64>, SceneError> {
        self.group_property(group, "emittance", PatchMaterial::emittance)
    }

    /// A property of materials that all patches of a row have.
    fn group_property(
        &self,
        group: usize,
        what: &'static str,
        of: impl Fn(&PatchMaterial) -> Result<&Channels<f64>, &MaterialFault>,
    ) -> Result<Channels<f64>, SceneError> {
        if let Some(empty) = self.empty_row(group) {
            let known = of(&empty.material).copied();
            return known.map_err(|fault| SceneError::MaterialUnknown {
                index: group,
                name: empty.name.clone(),
                what,
                fault: fault.clone(),
            });
        }
        let name = |patch: usize| self.patches[patch].name.clone();
        let mut found: Option<(usize, Channels<f64>)> = None;
        for second in self.patches_of_group(group) {
            let property = of(&self.patches[second].material);
            let property = *property.map_err(|fault| SceneError::MaterialUnknown {
                index: second,
                name: name(second),
                what,
                fault: fault.clone(),
            })?;
            let (first, known) = *found.get_or_insert((second, property));
            if known != property {
                return Err(SceneError::MixedRow {
                    first,
                    second,
                    what,
                    names: [first, second].map(name),
                });
            }
        }
        let last = self.group_count() - 1;
        found
            .map(|(_, known)| known)
            .ok_or(SceneError::NoSuchPatch { index: group, last })
    }
}
