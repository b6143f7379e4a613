//! Rooms with a light in the ceiling, empty, of two wings, with a plate under the light, or with a
//! table and a screen.
//!
//! ```text
//!   name                edges      light                          reflectances
//!   lit-cube            1, 1, 1    [1/2, 3/4] × [1/4, 1/2]        .4 .8 .6 .3 .5 .5
//!   lit-cube-edge       1, 1, 1    [3/4, 1] × [1/4, 1/2]          .4 .8 .6 .3 .5 .5
//!   lit-hall            2, 1, 1    [0, 1/4] × [1/2, 3/4]          .5
//!   lit-wings           2, 2, 1    [3/2, 7/4] × [1/4, 1/2]        .5, without the quarter x, y > 1
//!   shaded-cube         lit-cube with a plate [7/16, 3/4] × [3/16, 1/2] at z = 0.4
//!   shaded-cube-low     lit-cube with the plate at z = 1/16, just above the floor
//!   shaded-cube-sharp   lit-cube with the plate at z = 0.4, light [5/8, 21/32] × [3/8, 13/32]
//!   lit-table           lit-cube with the plate at z = 1/4 on two panels along y, and an upright
//!                       screen x = 3/16, y in [9/16, 13/16], z in [1/2, 3/4]
//! ```
//!
//! Reflectances are those of floor, ceiling, left, right, front and back, 1/2 for both sides of a
//! plate; the light emits 1 and reflects nothing. The ceiling is cut into rectangles around the
//! light, so that no patch lies in another one; a plate is two patches, back to back.
//!
//! **Not covered**: several lights.

use super::boxes::box_faces;
use super::rectangle_patch;
use crate::scene::{Material, NamedPatch, Scene, SceneError};
use glam::DVec3;

/// A rectangle `x0..x1 × y0..y1` on a level.
type Level = [[f64; 2]; 2];

const LIT_CUBE: Level = [[0.5, 0.75], [0.25, 0.5]];
const PLATE: Level = [[0.4375, 0.75], [0.1875, 0.5]];
/// The sides of a plate.
const BOTH: [&str; 2] = ["plate, below", "plate, above"];
/// The height of a table.
const TABLE: f64 = 0.25;
const CUBE: [f64; 6] = [0.4, 0.8, 0.6, 0.3, 0.5, 0.5];
const GREY: f64 = 0.5;

/// A lit room, or `None` if it is not the name of one.
pub(super) fn lit_room(name: &str) -> Option<Result<Scene, SceneError>> {
    let cube = |light| Patches::of_box([1.0; 3], light, CUBE);
    let patches = match name {
        "lit-cube" => cube(LIT_CUBE),
        "lit-cube-edge" => cube([[0.75, 1.0], [0.25, 0.5]]),
        "lit-hall" => Patches::of_box([2.0, 1.0, 1.0], [[0.0, 0.25], [0.5, 0.75]], [GREY; 6]),
        "lit-wings" => wings(),
        "shaded-cube" => cube(LIT_CUBE).and_then(|room| room.with(BOTH, hanging(PLATE, 0.4))),
        "shaded-cube-low" => {
            cube(LIT_CUBE).and_then(|room| room.with(BOTH, hanging(PLATE, 0.0625)))
        }
        "shaded-cube-sharp" => cube([[0.625, 0.65625], [0.375, 0.40625]])
            .and_then(|room| room.with(BOTH, hanging(PLATE, 0.4))),
        "lit-table" => cube(LIT_CUBE).and_then(Patches::with_table),
        _ => return None,
    };
    Some(patches.and_then(|room| Scene::try_new(room.0)))
}

/// The patches of a room, so far.
#[derive(Debug, Default)]
struct Patches(Vec<NamedPatch>);

impl Patches {
    /// A box with a light in its ceiling.
    fn of_box(edges: [f64; 3], light: Level, reflectances: [f64; 6]) -> Result<Self, SceneError> {
        let mut room = Self::default();
        let [x, y, z] = edges;
        let faces = box_faces(x * DVec3::X, y * DVec3::Y, z * DVec3::Z);
        for ((name, origin, u, v), reflectance) in faces.into_iter().zip(reflectances) {
            if name == "ceiling" {
                room.ceiling([[0.0, x], [0.0, y]], z, light, reflectance)?;
            } else {
                room.add(name, [origin, u, v], Material::known(reflectance, 0.0))?;
            }
        }
        Ok(room)
    }

    fn add(
        &mut self,
        name: &str,
        [origin, u, v]: [DVec3; 3],
        material: Material,
    ) -> Result<(), SceneError> {
        let patch = rectangle_patch(self.0.len(), name, origin, u, v)?;
        self.0.push(patch.with_material(material));
        Ok(())
    }

    /// A light, and the ceiling around it: two strips along x, and what is left between them.
    fn ceiling(
        &mut self,
        [[left, right], [front, back]]: Level,
        height: f64,
        light: Level,
        reflectance: f64,
    ) -> Result<(), SceneError> {
        let [[x0, x1], [y0, y1]] = light;
        self.add("light", hanging(light, height), Material::known(0.0, 1.0))?;
        let around = [
            [[left, right], [front, y0]],
            [[left, right], [y1, back]],
            [[left, x0], [y0, y1]],
            [[x1, right], [y0, y1]],
        ];
        for part in around {
            if part.iter().all(|[from, to]| from < to) {
                let material = Material::known(reflectance, 0.0);
                self.add("ceiling", hanging(part, height), material)?;
            }
        }
        Ok(())
    }

    /// A plate with a front on either side: the first is that to which u × v points.
    fn with(
        mut self,
        [first, second]: [&str; 2],
        [origin, u, v]: [DVec3; 3],
    ) -> Result<Self, SceneError> {
        let material = Material::known(GREY, 0.0);
        self.add(first, [origin, u, v], material)?;
        self.add(second, [origin, v, u], material)?;
        Ok(self)
    }

    /// A table of a top on two panels, and a screen.
    fn with_table(self) -> Result<Self, SceneError> {
        let [[x0, x1], [y0, y1]] = PLATE;
        let panel = |x| {
            [
                DVec3::new(x, y0, 0.0),
                (y1 - y0) * DVec3::Y,
                TABLE * DVec3::Z,
            ]
        };
        let corner = DVec3::new(0.1875, 0.5625, 0.5);
        let panels = ["panel, right", "panel, left"];
        self.with(["table, below", "table, above"], hanging(PLATE, TABLE))?
            .with(panels, panel(x0))?
            .with(panels, panel(x1))?
            .with(
                ["screen, right", "screen, left"],
                [corner, 0.25 * DVec3::Y, 0.25 * DVec3::Z],
            )
    }
}

/// Corner and edges of a rectangle whose front looks down.
fn hanging([[x0, x1], [y0, y1]]: Level, height: f64) -> [DVec3; 3] {
    let edges = [(y1 - y0) * DVec3::Y, (x1 - x0) * DVec3::X];
    [DVec3::new(x0, y0, height), edges[0], edges[1]]
}

/// A room of three unit squares around a corner, with a light at the end of one wing.
fn wings() -> Result<Patches, SceneError> {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let grey = Material::known(GREY, 0.0);
    let mut room = Patches::default();
    for corner in [DVec3::ZERO, x, y] {
        room.add("floor", [corner, x, y], grey)?;
    }
    let lit = [[1.0, 2.0], [0.0, 1.0]];
    room.ceiling(lit, 1.0, [[1.5, 1.75], [0.25, 0.5]], GREY)?;
    for corner in [z, y + z] {
        room.add("ceiling", [corner, y, x], grey)?;
    }
    // counter-clockwise from the origin, as seen from above
    let around = [
        ("front", DVec3::ZERO, x),
        ("front", x, x),
        ("right", 2.0 * x, y),
        ("inner back", 2.0 * x + y, -x),
        ("inner right", x + y, y),
        ("back", x + 2.0 * y, -x),
        ("left", 2.0 * y, -y),
        ("left", y, -y),
    ];
    for (name, corner, along) in around {
        room.add(name, [corner, z, along], grey)?;
    }
    Ok(room)
}
