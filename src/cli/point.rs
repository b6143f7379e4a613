//! `infoscene point SCENE`.

use super::output::{Output, say};
use super::progress::Bar;
use super::scene::SceneArgument;
use super::{Answer, Outcome};
use infoscene::question::{PointSource, Points, SurfacePoint};
use infoscene::report::write_points;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Point {
    #[command(flatten)]
    scene: SceneArgument,
    /// A point of a surface.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = triple,
        requires = "normal", required_unless_present = "points")]
    at: Option<[f64; 3]>,
    /// The surface's normal there, of any length: it points to the side that is seen from.
    #[arg(long, value_name = "NX,NY,NZ", allow_hyphen_values = true, value_parser = triple,
        requires = "at")]
    normal: Option<[f64; 3]>,
    /// A file of points: lines x,y,z,nx,ny,nz, with these names in the first line or without; what
    /// follows a # is a comment.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["at", "normal"])]
    points: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

fn triple(text: &str) -> Result<[f64; 3], String> {
    let numbers = text.split(',').map(|number| number.trim().parse::<f64>());
    match numbers.collect::<Result<Vec<_>, _>>().as_deref() {
        Ok([x, y, z]) if x.is_finite() && y.is_finite() && z.is_finite() => Ok([*x, *y, *z]),
        _ => Err("it must be three finite numbers, as in 0.5,0,-1".to_owned()),
    }
}

impl Point {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        let given = self.at.zip(self.normal);
        let given = given.map(|(at, normal)| SurfacePoint { at, normal });
        let question = Points {
            scene: self.scene.source(),
            points: match &self.points {
                Some(file) => PointSource::File(file.clone()),
                None => PointSource::Given(given.into_iter().collect()),
            },
        };
        let answer = question.ask(&Bar::default())?;
        say(&answer.notes);
        self.output
            .write_with(|format, text| Ok(write_points(&answer, format, text)?))?;
        Ok(Outcome::Done)
    }
}
