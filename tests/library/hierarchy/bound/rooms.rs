//! Rooms with a light in the ceiling, and their materials.

use glam::DVec3;
use infoscene::geometry::{Patch, Rectangle};
use infoscene::hierarchy::Lighting;
use infoscene::scene::{NamedPatch, Scene};

/// A room, by the index of each patch its face (x = 0, x = 1, y = 0, y = 1, z = 0, z = 1), and
/// the patch that is the light.
pub struct Room {
    pub scene: Scene,
    pub faces: Vec<usize>,
    pub light: usize,
}

/// The reflectances of the faces of the first two rooms.
pub const MIXED: [f64; 6] = [0.6, 0.3, 0.5, 0.5, 0.4, 0.8];

impl Room {
    /// The inside of a box with a light on the ceiling, from `low` to `high` in x and y.
    pub fn new(size: DVec3, low: [f64; 2], high: [f64; 2]) -> Self {
        let [x, y, z] = [size.x * DVec3::X, size.y * DVec3::Y, size.z * DVec3::Z];
        let mut parts = vec![
            (0, DVec3::ZERO, y, z),
            (1, x, z, y),
            (2, DVec3::ZERO, z, x),
            (3, y, x, z),
            (4, DVec3::ZERO, x, y),
        ];
        let mut light = 0;
        let lines = |k: usize, end: f64| {
            let mut lines = vec![0.0, low[k], high[k], end];
            lines.dedup();
            lines
        };
        let (across, along) = (lines(0, size.x), lines(1, size.y));
        for a in across.windows(2) {
            for b in along.windows(2) {
                if a[0] == low[0] && b[0] == low[1] {
                    light = parts.len();
                }
                let corner = DVec3::new(a[0], b[0], size.z);
                let (u, v) = ((b[1] - b[0]) * DVec3::Y, (a[1] - a[0]) * DVec3::X);
                parts.push((5, corner, u, v));
            }
        }
        let patch = |(index, (_, corner, u, v)): (usize, &(usize, DVec3, DVec3, DVec3))| {
            let shape = Patch::try_from(&Rectangle::try_new(*corner, *u, *v).unwrap()).unwrap();
            NamedPatch::new(format!("patch {index}"), shape)
        };
        let scene = Scene::try_new(parts.iter().enumerate().map(patch).collect()).unwrap();
        let faces = parts.iter().map(|part| part.0).collect();
        Self {
            scene,
            faces,
            light,
        }
    }

    /// Three rooms: light in the ceiling of a cube; touching a wall; of a double cube.
    pub fn all() -> [Self; 3] {
        [
            Self::new(DVec3::ONE, [0.5, 0.25], [0.75, 0.5]),
            Self::new(DVec3::ONE, [0.75, 0.25], [1.0, 0.5]),
            Self::new(DVec3::new(2.0, 1.0, 1.0), [0.0, 0.5], [0.25, 0.75]),
        ]
    }

    /// A black light of emittance 1 between faces with these reflectances.
    pub fn lit(&self, faces: [f64; 6]) -> Lighting {
        let mut reflectances: Vec<f64> = self.faces.iter().map(|face| faces[*face]).collect();
        let mut emittances = vec![0.0; reflectances.len()];
        reflectances[self.light] = 0.0;
        emittances[self.light] = 1.0;
        Lighting::try_new(reflectances, emittances).unwrap()
    }
}
