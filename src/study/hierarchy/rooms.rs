//! Lit rooms with references: the same rooms on meshes far finer than those that are judged.
//!
//! ```text
//!   error of the reference  ≈  ‖B_N − B_{N/4}‖/‖B‖        linear functions on N and N/4 elements
//! ```
//!
//! The estimate is the error of the coarser one, so that the finer one has less.

use crate::hierarchy::{
    Factors, Goal, HierarchyError, Lighting, OracleName, Reference, Refinement,
};
use crate::scene::{Channel, Occlusion, Scene};
use crate::study::StudyError;

/// A built-in scene in its own light.
pub(super) struct Room {
    pub(super) name: &'static str,
    pub(super) scene: Scene,
    pub(super) lighting: Lighting,
}

/// A reference, with an estimate of its relative error.
pub(super) struct Judge {
    pub(super) reference: Reference,
    pub(super) error: f64,
}

impl Room {
    pub(super) fn try_new(name: &'static str) -> Result<Self, StudyError> {
        let scene = Scene::built_in(name)?;
        let lighting = Lighting::of(&scene, Channel::Green)?;
        Ok(Self {
            name,
            scene,
            lighting,
        })
    }

    /// The room on the mesh of its patches.
    pub(super) fn refinement(&self) -> Result<Refinement<'_>, HierarchyError> {
        let lighting = self.lighting.clone();
        Refinement::try_new(&self.scene, lighting, Occlusion::Exact, Factors::OfPoints)
    }

    /// The reference of so many elements.
    pub(super) fn judge(&self, elements: usize) -> Result<Judge, StudyError> {
        let oracle = OracleName::Gradient.oracle(None)?;
        let mut room = self.refinement()?;
        room.refine(&*oracle, Goal::Elements(elements / 4), &mut |_| ())?;
        let coarse = (room.tree().clone(), room.solution().clone());
        room.refine(&*oracle, Goal::Elements(elements), &mut |_| ())?;
        let reference = Reference::new(room.tree(), room.lighting(), room.solution());
        let error = reference.linear_error_of(&coarse.0, room.lighting(), &coarse.1);
        Ok(Judge { reference, error })
    }
}
