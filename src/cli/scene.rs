//! SCENE: the arguments that questions about a scene share.

use infoscene::exchange::{Congruence, Tolerance};
use infoscene::form_factor::DEFAULT_TOLERANCE;
use infoscene::question::SceneSource;
use infoscene::scene::Occlusion;
use infoscene::scene::files::NonPlanarFaces;

#[derive(Debug, clap::Args)]
pub(super) struct SceneArgument {
    /// A scene file (Wavefront .obj, View3D .vs3 or .stl), or a built-in scene: two-squares,
    /// three-squares, cube:N, box:X,Y,Z, tetrahedron, octahedron, dodecahedron, icosahedron,
    /// cornell-box, cornell-box-blocks, lit-cube, lit-cube-edge, lit-hall, lit-wings, shaded-cube,
    /// shaded-cube-low, shaded-cube-sharp or lit-table.
    scene: String,
    /// Split faces that are not planar into triangles; when a scene is converted, also those of
    /// more corners than the format holds.
    #[arg(long)]
    triangulate: bool,
    /// Join patches that share an edge and lie in one plane, as the triangles of a wall do, if they
    /// have the same material and are of the same object.
    #[arg(long)]
    merge: bool,
    /// Quarter every patch so many times: triangles and quadrilaterals into four alike.
    #[arg(long, value_name = "TIMES", default_value_t = 0,
        value_parser = clap::value_parser!(u32).range(0..=8))]
    subdivide: u32,
    /// The length by which each coordinate may be off, 0 to take them as exact; if it is not given,
    /// half a unit in the last decimal of the file, where surfaces miss each other by so little.
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    resolution: Option<f64>,
    /// Turn the front of every patch to its other side.
    #[arg(long)]
    reverse: bool,
    /// Leave out that patches and obstructions hide others, and say how many pairs that concerns.
    #[arg(long)]
    unoccluded: bool,
}

impl SceneArgument {
    /// The scene that is meant.
    pub(super) fn source(&self) -> SceneSource {
        SceneSource {
            faces: if self.triangulate {
                NonPlanarFaces::Triangulate
            } else {
                NonPlanarFaces::Refuse
            },
            resolution: self.resolution,
            join: self.merge,
            reverse: self.reverse,
            subdivide: self.subdivide,
            occlusion: if self.unoccluded {
                Occlusion::Ignore
            } else {
                Occlusion::Exact
            },
            ..SceneSource::from(self.scene.as_str())
        }
    }
}

/// The arguments that questions about the pairs of a scene share.
#[derive(Debug, clap::Args)]
pub(super) struct ScenePairsArguments {
    #[command(flatten)]
    scene: SceneArgument,
    /// The relative error asked for of every form factor.
    #[arg(long, value_name = "REL", default_value_t = DEFAULT_TOLERANCE, value_parser = relative)]
    tolerance: f64,
    /// The absolute error that is accepted of every form factor even where it is more, relatively;
    /// if none is given, 2.2e-16 divided by the number of patches, which no row sum can feel.
    #[arg(long, value_name = "ABS", value_parser = absolute)]
    absolute: Option<f64>,
    /// Compute congruent pairs, too.
    #[arg(long, hide = true)]
    every_pair: bool,
}

fn length(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if number >= 0.0 && f64::is_finite(number) => Ok(number),
        _ => Err("it must be a length, 0 or more".to_owned()),
    }
}

fn relative(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if number > 0.0 && number < 1.0 => Ok(number),
        _ => Err("it must be a number between 0 and 1".to_owned()),
    }
}

fn absolute(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if (0.0..1.0).contains(&number) => Ok(number),
        _ => Err("it must be a number from 0 to 1".to_owned()),
    }
}

impl ScenePairsArguments {
    /// The error that is accepted of form factors.
    pub(super) const fn tolerance(&self) -> Tolerance {
        Tolerance {
            relative: self.tolerance,
            absolute: self.absolute,
        }
    }

    /// The scene that is meant.
    pub(super) fn source(&self) -> SceneSource {
        self.scene.source()
    }

    /// The treatment of congruent pairs.
    pub(super) const fn congruence(&self) -> Congruence {
        if self.every_pair {
            Congruence::Ignored
        } else {
            Congruence::Shared
        }
    }
}
