//! Materials: a patch reflects a part of the light that arrives, equally in all directions, and may
//! emit some itself.
//!
//! **Not covered**: spectra (one number stands for all wavelengths), gloss, transparency.

/// Diffuse reflectance and emittance.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Material {
    reflectance: f64,
    emittance: f64,
}

/// A material was refused.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MaterialError {
    /// A reflectance outside `[0, 1)`.
    #[error("the reflectance is {reflectance}: it must be at least 0 and less than 1")]
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
    /// An emissivity outside `(0, 1]`: it stands for a reflectance outside `[0, 1)`.
    #[error("the emissivity is {emissivity}: it must be greater than 0 and at most 1")]
    EmissivityOutOfRange {
        /// The emissivity as given.
        emissivity: f64,
    },
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
    /// [`MaterialError::ReflectanceOutOfRange`] unless `0 ≤ reflectance < 1`: with 1, light would
    /// never die out; [`MaterialError::EmittanceOutOfRange`] unless `emittance` is finite and ≥ 0.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Material;
    /// assert_eq!(Material::try_new(0.5, 2.0)?.reflectance(), 0.5);
    /// assert!(Material::try_new(1.0, 0.0).is_err());
    /// # Ok::<(), infoscene::scene::MaterialError>(())
    /// ```
    pub fn try_new(reflectance: f64, emittance: f64) -> Result<Self, MaterialError> {
        if !(0.0..1.0).contains(&reflectance) {
            return Err(MaterialError::ReflectanceOutOfRange { reflectance });
        }
        if !(emittance.is_finite() && emittance >= 0.0) {
            return Err(MaterialError::EmittanceOutOfRange { emittance });
        }
        // zero has no sign here
        Ok(Self {
            reflectance: reflectance + 0.0,
            emittance: emittance + 0.0,
        })
    }

    /// The fraction of the arriving power that leaves again, in `[0, 1)`.
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
