//! Materials: a patch reflects a part of the light that arrives, equally in all directions, and may
//! emit some itself.
//!
//! A [`Material`] is that of one channel of colour, two numbers. A patch has one for each channel,
//! and they may be unknown: a file names a material that is not there, or gives a number that none
//! can have. That is no matter for geometry; who asks for light is refused, with the reason
//! ([`PatchMaterial`]).
//!
//! **Not covered**: spectra beyond three channels, gloss, transparency.

use super::channel::{Channel, Channels};
use std::fmt;
use std::sync::Arc;

/// Diffuse reflectance and emittance, in one channel.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Material {
    reflectance: f64,
    emittance: f64,
}

/// A material was refused.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MaterialError {
    /// A reflectance outside `[0, 1]`.
    #[error("the reflectance is {reflectance}: it must be at least 0 and at most 1")]
    ReflectanceOutOfRange {
        /// The reflectance as given.
        reflectance: f64,
    },
    /// An emittance that is negative or not finite.
    #[error("the emittance is {emittance}: it must be finite and at least 0")]
    EmittanceOutOfRange {
        /// The emittance as given.
        emittance: f64,
    },
    /// An emissivity outside `[0, 1]`: it stands for a reflectance outside `[0, 1]`.
    #[error("the emissivity is {emissivity}: it must be at least 0 and at most 1")]
    EmissivityOutOfRange {
        /// The emissivity as given.
        emissivity: f64,
    },
    /// A positive emissivity whose reflectance rounds to 1.
    #[error(
        "the emissivity {emissivity:e} is so small that the reflectance rounds to 1: write 0, or \
         1.2e-16 at least"
    )]
    EmissivityTooSmall {
        /// The emissivity as given.
        emissivity: f64,
    },
}

/// A reflectance, if it is one; zero has no sign.
pub(crate) fn checked_reflectance(reflectance: f64) -> Result<f64, MaterialError> {
    if (0.0..=1.0).contains(&reflectance) {
        Ok(reflectance + 0.0)
    } else {
        Err(MaterialError::ReflectanceOutOfRange { reflectance })
    }
}

/// An emittance, if it is one; zero has no sign.
pub(crate) fn checked_emittance(emittance: f64) -> Result<f64, MaterialError> {
    if emittance.is_finite() && emittance >= 0.0 {
        Ok(emittance + 0.0)
    } else {
        Err(MaterialError::EmittanceOutOfRange { emittance })
    }
}

impl Material {
    /// The material that reflects and emits nothing, the default of a patch.
    pub const BLACK: Self = Self {
        reflectance: 0.0,
        emittance: 0.0,
    };

    /// The material with this reflectance (dimensionless) and emittance (power per area, in any one
    /// unit).
    ///
    /// # Errors
    /// [`MaterialError::ReflectanceOutOfRange`] unless `0 ≤ reflectance ≤ 1`;
    /// [`MaterialError::EmittanceOutOfRange`] unless `emittance` is finite and ≥ 0.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Material;
    /// assert_eq!(Material::try_new(0.5, 2.0)?.reflectance(), 0.5);
    /// assert!(Material::try_new(1.5, 0.0).is_err());
    /// # Ok::<(), infoscene::scene::MaterialError>(())
    /// ```
    pub fn try_new(reflectance: f64, emittance: f64) -> Result<Self, MaterialError> {
        Ok(Self {
            reflectance: checked_reflectance(reflectance)?,
            emittance: checked_emittance(emittance)?,
        })
    }

    /// The material of numbers that are known to be in range: those of built-in scenes.
    pub(super) const fn known(reflectance: f64, emittance: f64) -> Self {
        debug_assert!(reflectance >= 0.0 && reflectance <= 1.0 && emittance >= 0.0);
        Self {
            reflectance,
            emittance,
        }
    }

    /// The fraction of the arriving power that leaves again, in `[0, 1]`.
    #[must_use]
    pub const fn reflectance(&self) -> f64 {
        self.reflectance
    }

    /// The power that a unit of area sends out by itself, ≥ 0.
    #[must_use]
    pub const fn emittance(&self) -> f64 {
        self.emittance
    }
}

/// The reason why a reflectance or an emittance is not known: where it stands, the broken condition
/// and its mend.
#[derive(Debug, Clone, PartialEq, Eq, Hash, thiserror::Error)]
#[error("{reason}")]
pub struct MaterialFault {
    reason: Arc<str>,
}

impl MaterialFault {
    /// The fault with this reason.
    #[must_use]
    pub fn new(reason: impl fmt::Display) -> Self {
        Self {
            reason: reason.to_string().into(),
        }
    }
}

/// A number for each channel, or the reason why it is not known.
pub(crate) type Property = Result<Channels<f64>, MaterialFault>;

/// The material of a patch, as far as it is known: reflectance and emittance in each channel.
#[derive(Debug, Clone, PartialEq)]
pub struct PatchMaterial {
    pub(crate) reflectance: Property,
    pub(crate) emittance: Property,
}

impl PatchMaterial {
    /// The material that reflects and emits nothing, the default of a patch.
    pub const BLACK: Self = Self {
        reflectance: Ok(Channels {
            r: 0.0,
            g: 0.0,
            b: 0.0,
        }),
        emittance: Ok(Channels {
            r: 0.0,
            g: 0.0,
            b: 0.0,
        }),
    };

    /// The material of which nothing is known.
    #[must_use]
    pub fn unknown(fault: MaterialFault) -> Self {
        Self {
            reflectance: Err(fault.clone()),
            emittance: Err(fault),
        }
    }

    /// The reflectance.
    ///
    /// # Errors
    /// The reason why it is not known.
    pub const fn reflectance(&self) -> Result<&Channels<f64>, &MaterialFault> {
        self.reflectance.as_ref()
    }

    /// The emittance.
    ///
    /// # Errors
    /// The reason why it is not known.
    pub const fn emittance(&self) -> Result<&Channels<f64>, &MaterialFault> {
        self.emittance.as_ref()
    }

    /// The material in one channel.
    ///
    /// # Errors
    /// The reason why it is not known.
    pub fn channel(&self, channel: Channel) -> Result<Material, &MaterialFault> {
        Ok(Material {
            reflectance: *self.reflectance()?.of(channel),
            emittance: *self.emittance()?.of(channel),
        })
    }

    /// The material, if it is known and the same in all channels.
    #[must_use]
    pub fn grey(&self) -> Option<Material> {
        let is_grey = |property: &Property| property.as_ref().is_ok_and(Channels::is_grey);
        let known = self.channel(Channel::Red).ok();
        known.filter(|_| is_grey(&self.reflectance) && is_grey(&self.emittance))
    }

    /// The reasons why something is not known, each once.
    pub fn faults(&self) -> impl Iterator<Item = &MaterialFault> {
        let reflectance = self.reflectance.as_ref().err();
        let emittance = self.emittance.as_ref().err();
        let other = emittance.filter(move |fault| reflectance != Some(*fault));
        reflectance.into_iter().chain(other)
    }
}

impl From<Material> for PatchMaterial {
    /// One material for all channels.
    fn from(material: Material) -> Self {
        Channels::grey(material).into()
    }
}

impl From<Channels<Material>> for PatchMaterial {
    fn from(materials: Channels<Material>) -> Self {
        Self {
            reflectance: Ok(materials.map(Material::reflectance)),
            emittance: Ok(materials.map(Material::emittance)),
        }
    }
}
