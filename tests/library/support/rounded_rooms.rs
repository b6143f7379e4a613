//! Rooms as files carry them: turned, divided into patches, their corners rounded to decimals.

use glam::{DQuat, DVec3};
use infoscene::scene::Scene;
use infoscene::scene::files::{NonPlanarFaces, Source, read_obj};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// Shapes of rooms.
const SIZES: [[f64; 3]; 4] = [
    [2.0, 2.0, 2.0],
    [5.0, 4.0, 3.0],
    [8.0, 5.0, 3.0],
    [1.0, 6.0, 2.5],
];

/// The decimals that files carry.
const DECIMALS: [usize; 4] = [2, 3, 6, 9];

/// The divisions of walls.
#[derive(Debug, Clone, Copy)]
enum Division {
    Whole,
    Panels,
    Triangles,
    Grid,
    /// Panels that do not match those of the neighbours, and corners on the middle of an edge.
    Joints,
}

/// Polygons, counter-clockwise as seen from inside, and how they are placed and written.
#[derive(Debug, Clone)]
pub struct Room {
    pub polygons: Vec<Vec<DVec3>>,
    pub turn: DQuat,
    pub shift: DVec3,
    pub decimals: usize,
}

impl Room {
    /// A room of any shape and division, turned about any axis.
    pub fn any(seed: u64) -> Self {
        let mut dice = ChaCha8Rng::seed_from_u64(seed);
        let size = SIZES[dice.random_range(0..SIZES.len())];
        let divisions = [
            Division::Whole,
            Division::Panels,
            Division::Triangles,
            Division::Grid,
            Division::Joints,
        ];
        let division = divisions[dice.random_range(0..divisions.len())];
        let mut polygons = Vec::new();
        for axis in 0..3 {
            for at_end in [false, true] {
                let wall = Wall { size, axis, at_end };
                polygons.extend(wall.divided(division, &mut dice));
            }
        }
        let decimals = DECIMALS[dice.random_range(0..DECIMALS.len())];
        Self {
            polygons,
            turn: any_turn(&mut dice),
            shift: DVec3::from_array([(); 3].map(|()| dice.random_range(-3.0..3.0))),
            decimals,
        }
    }

    /// The box of this size with whole walls.
    pub fn whole(size: [f64; 3], seed: u64, decimals: usize) -> Self {
        let mut dice = ChaCha8Rng::seed_from_u64(seed);
        let walls = (0..3).flat_map(|axis| [false, true].map(|at_end| (axis, at_end)));
        Self {
            polygons: walls
                .map(|(axis, at_end)| {
                    let wall = Wall { size, axis, at_end };
                    wall.part([0.0, 1.0], [0.0, 1.0])
                })
                .collect(),
            turn: any_turn(&mut dice),
            shift: DVec3::ZERO,
            decimals,
        }
    }

    /// The text of a Wavefront OBJ file, rounded.
    pub fn rounded(&self) -> String {
        text(&self.polygons, |corner| {
            let placed = self.turn * corner + self.shift;
            placed.to_array().map(|x| format!("{x:.*}", self.decimals))
        })
    }

    /// The same without a turn, to the last bit.
    pub fn exact(&self) -> String {
        text(&self.polygons, |corner| {
            corner.to_array().map(|x| format!("{x}"))
        })
    }

    /// Half a unit in the last place.
    pub fn half_unit(&self) -> f64 {
        0.5 * 10f64.powi(-i32::try_from(self.decimals).unwrap())
    }
}

/// The scene of an OBJ file without materials.
pub fn read(text: &str) -> Scene {
    let source = Source::new("room.obj", text);
    let library = |name: &str| panic!("{name} is not asked for");
    read_obj(&source, &library, NonPlanarFaces::Refuse)
        .unwrap()
        .scene
}

fn text(polygons: &[Vec<DVec3>], written: impl Fn(DVec3) -> [String; 3]) -> String {
    let mut lines = String::new();
    let mut vertices = 0;
    for polygon in polygons {
        let mut face = "f".to_owned();
        for corner in polygon {
            vertices += 1;
            lines += &format!("v {}\n", written(*corner).join(" "));
            face += &format!(" {vertices}");
        }
        lines += &format!("{face}\n");
    }
    lines
}

fn any_turn(dice: &mut impl Rng) -> DQuat {
    let z = dice.random_range(-1.0..1.0f64);
    let around = dice.random_range(0.0..TAU);
    let across = (1.0 - z * z).sqrt();
    let axis = DVec3::new(across * around.cos(), across * around.sin(), z);
    DQuat::from_axis_angle(axis.normalize(), dice.random_range(0.0..TAU))
}

struct Wall {
    size: [f64; 3],
    axis: usize,
    at_end: bool,
}

impl Wall {
    fn corner(&self, [u, v]: [f64; 2]) -> DVec3 {
        let mut corner = [0.0; 3];
        corner[self.axis] = if self.at_end {
            self.size[self.axis]
        } else {
            0.0
        };
        for (step, share) in [(1, u), (2, v)] {
            let along = (self.axis + step) % 3;
            corner[along] = share * self.size[along];
        }
        DVec3::from_array(corner)
    }

    fn facing(&self, corners: Vec<[f64; 2]>) -> Vec<DVec3> {
        let mut corners: Vec<DVec3> = corners.into_iter().map(|c| self.corner(c)).collect();
        if self.at_end {
            corners.reverse();
        }
        corners
    }

    fn part(&self, [a, b]: [f64; 2], [c, d]: [f64; 2]) -> Vec<DVec3> {
        self.facing(vec![[a, c], [b, c], [b, d], [a, d]])
    }

    fn divided(&self, division: Division, dice: &mut impl Rng) -> Vec<Vec<DVec3>> {
        let [o, i] = [0.0, 1.0];
        let counts = match division {
            Division::Whole => [1, 1],
            Division::Grid => [3, 3],
            Division::Panels => [[1, 1], [2, 1], [1, 2]][dice.random_range(0..3)],
            Division::Joints if dice.random_bool(0.4) => {
                let middle = [0.5, o];
                let fans = [
                    vec![[o, o], middle, [o, i]],
                    vec![middle, [i, i], [o, i]],
                    vec![middle, [i, o], [i, i]],
                ];
                return fans.map(|fan| self.facing(fan)).to_vec();
            }
            Division::Joints => [[2, 1], [1, 3], [2, 3], [3, 2]][dice.random_range(0..4)],
            Division::Triangles => {
                let halves = if dice.random_bool(0.5) {
                    [vec![[o, o], [i, o], [i, i]], vec![[o, o], [i, i], [o, i]]]
                } else {
                    [vec![[o, o], [i, o], [o, i]], vec![[i, o], [i, i], [o, i]]]
                };
                return halves.map(|half| self.facing(half)).to_vec();
            }
        };
        let [columns, rows] = counts.map(|count: u32| {
            let mut cuts: Vec<f64> = (1..count)
                .map(|k| (f64::from(k) + dice.random_range(-0.2..0.2)) / f64::from(count))
                .collect();
            cuts.insert(0, 0.0);
            cuts.push(1.0);
            cuts
        });
        let pairs = |cuts: &[f64]| -> Vec<[f64; 2]> {
            cuts.windows(2).map(|ends| [ends[0], ends[1]]).collect()
        };
        let rows = pairs(&rows);
        let columns = pairs(&columns).into_iter();
        columns
            .flat_map(|column| rows.iter().map(move |row| self.part(column, *row)))
            .collect()
    }
}
