//! A cube whose patches reflect, emit and matter unevenly, with its radiosity or importance
//! solved, and the chain's formulas as printed in §3.4 and §3.5.

use crate::claims::{Case, ClaimError};
use crate::exchange::ExchangeAreas;
use crate::scene::{Material, Scene};
use crate::transport::{Importance, RadiositySystem};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The quantity whose chain is built.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Carrier {
    Radiosity,
    Importance,
}

/// A lit cube, and the chain's formulas as they are printed, with the numerator B_j.
pub(crate) struct Lit {
    pub(crate) scene: Scene,
    pub(crate) exchange: ExchangeAreas,
    pub(crate) materials: Vec<Material>,
    /// E, or V.
    pub(crate) sources: Vec<f64>,
    /// B, or I.
    pub(crate) solution: Vec<f64>,
    pub(crate) importance: Option<Importance>,
}

impl Lit {
    /// Solves the case; with `flaw`, the solution of every second patch is wrong by that share.
    pub(crate) fn new(case: &Case<'_>) -> Result<Self, ClaimError> {
        let carrier = match case.switch("importance")? {
            true => Carrier::Importance,
            false => Carrier::Radiosity,
        };
        Self::of(carrier, case)
    }

    pub(crate) fn of(carrier: Carrier, case: &Case<'_>) -> Result<Self, ClaimError> {
        let scene = super::section_2::cube(case)?;
        let exchange = scene.exchange_areas()?;
        let mut random = ChaCha8Rng::seed_from_u64(case.count("seed")?.into());
        let mut materials = Vec::new();
        for _ in 0..exchange.rows() {
            let [reflectance, emittance]: [f64; 2] = random.random();
            let material = Material::try_new(0.05 + 0.9 * reflectance, emittance);
            materials.push(material.map_err(|error| ClaimError::Input {
                name: "seed",
                reason: error.to_string(),
            })?);
        }
        let sources: Vec<f64> = materials.iter().map(Material::emittance).collect();
        let room = RadiositySystem::of(&exchange, &materials)?;
        let importance = match carrier {
            Carrier::Radiosity => None,
            Carrier::Importance => Some(room.importance(&sources)?),
        };
        let mut solution = match &importance {
            Some(importance) => importance.values.clone(),
            None => room.radiosity(&sources)?.values,
        };
        for value in solution.iter_mut().step_by(2) {
            *value *= 1.0 + case.number("flaw")?;
        }
        Ok(Self {
            scene,
            exchange,
            materials,
            sources,
            solution,
            importance,
        })
    }

    pub(crate) const fn patches(&self) -> usize {
        self.exchange.rows()
    }

    pub(crate) fn reflectance(&self, i: usize) -> f64 {
        self.materials[i].reflectance()
    }

    pub(crate) fn form_factor(&self, i: usize, j: usize) -> f64 {
        self.exchange.get(i, j).exchange.value / self.exchange.areas()[i]
    }

    /// `B − E`, or `I − V`.
    pub(crate) fn gathered(&self, i: usize) -> f64 {
        self.solution[i] - self.sources[i]
    }

    /// `R_i F_ij B_j/(B_i − E_i)`, or `R_j F_ij I_j/(I_i − V_i)`.
    pub(crate) fn transition(&self, i: usize, j: usize) -> f64 {
        let reflecting = if self.importance.is_some() { j } else { i };
        self.reflectance(reflecting) * self.form_factor(i, j) * self.solution[j] / self.gathered(i)
    }

    /// `A_i B_i (B_i − E_i)/R_i`, or `A_i R_i I_i (I_i − V_i)`.
    pub(crate) fn weight(&self, i: usize) -> f64 {
        let product = self.exchange.areas()[i] * self.solution[i] * self.gathered(i);
        if self.importance.is_some() {
            product * self.reflectance(i)
        } else {
            product / self.reflectance(i)
        }
    }

    /// `B_i B_j A_i F_ij`, the potential of a pair, §5.
    pub(crate) fn potential(&self, i: usize, j: usize) -> f64 {
        self.solution[i] * self.solution[j] * self.exchange.get(i, j).exchange.value
    }

    /// B, or R I.
    pub(crate) fn brightness(&self) -> Vec<f64> {
        let values = self.solution.iter().zip(&self.materials);
        values
            .map(|(value, material)| match self.importance {
                Some(_) => material.reflectance() * value,
                None => *value,
            })
            .collect()
    }
}
