//! The names of walls on a net: inside, or a number inside and the name below the net.

use crate::report::render::units::MARGIN;

/// The width of a letter of a broad font and the height of a line, in the fine units of a page, and
/// the space around them.
const LETTER: f64 = 80.0;
const LINE: f64 = 160.0;
const SPACE: f64 = 30.0;
/// Walls that may have their name below.
const MOST_BELOW: usize = 24;

/// A text about a place.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Label {
    pub(super) text: String,
    pub(super) middle: [f64; 2],
    /// Half the width and half the height.
    pub(super) half: [f64; 2],
}

/// The labels of a net.
#[derive(Debug, Default)]
pub(super) struct Labels {
    /// The names and numbers inside walls.
    pub(super) inside: Vec<Label>,
    /// The lines below the net.
    pub(super) below: Vec<String>,
}

type Edge = [[f64; 2]; 2];

impl Labels {
    /// The labels of walls with these names and borders, on a page of this width.
    pub(super) fn new<'n>(walls: impl Iterator<Item = (&'n str, Vec<Edge>)>, width: f64) -> Self {
        let mut labels = Self::default();
        let mut numbered = Vec::new();
        for (name, border) in walls {
            if let Some(label) = inside(name, &border) {
                labels.inside.push(label);
            } else if numbered.len() < MOST_BELOW {
                let number = (numbered.len() + 1).to_string();
                if let Some(label) = inside(&number, &border) {
                    labels.inside.push(label);
                    numbered.push(format!("{number} {name}"));
                }
            }
        }
        labels.below = lines(&numbered, width - 2.0 * f64::from(MARGIN));
        labels
    }
}

/// The text where it lies inside of a wall: above the lower end, in a lower corner, else in the
/// middle.
fn inside(text: &str, border: &[Edge]) -> Option<Label> {
    let corners = || border.iter().flatten();
    let end = |k: usize, pick: fn(f64, f64) -> f64, from: f64| {
        corners().map(|corner| corner[k]).fold(from, pick)
    };
    let (left, right) = (
        end(0, f64::min, f64::INFINITY),
        end(0, f64::max, f64::NEG_INFINITY),
    );
    let bottom = end(1, f64::max, f64::NEG_INFINITY);
    let half = [0.5 * width(text) + SPACE, 0.5 * LINE + 0.5 * SPACE];
    let count = crate::numeric::real(2 * border.len());
    let mean = [0, 1].map(|k| corners().map(|corner| corner[k]).sum::<f64>() / count);
    let places = [
        [0.5 * (left + right), bottom - SPACE - half[1]],
        [left + SPACE + half[0], bottom - SPACE - half[1]],
        [right - SPACE - half[0], bottom - SPACE - half[1]],
        [mean[0], bottom - SPACE - half[1]],
        mean,
    ];
    let has_room = |middle: &[f64; 2]| {
        is_inside(*middle, border) && border.iter().all(|edge| is_beside(edge, *middle, half))
    };
    let middle = places.into_iter().find(has_room)?;
    Some(Label {
        text: text.to_owned(),
        middle,
        half,
    })
}

fn width(text: &str) -> f64 {
    LETTER * crate::numeric::real(text.chars().count())
}

/// Does a line to the right meet the border an odd number of times?
fn is_inside([x, y]: [f64; 2], border: &[Edge]) -> bool {
    let meets = |[from, to]: &&Edge| {
        let crosses = (from[1] > y) != (to[1] > y);
        crosses && x < from[0] + (y - from[1]) / (to[1] - from[1]) * (to[0] - from[0])
    };
    border.iter().filter(meets).count() % 2 == 1
}

/// Does an edge leave the rectangle about a place free?
fn is_beside([from, to]: &Edge, middle: [f64; 2], half: [f64; 2]) -> bool {
    let [start, end] = [from, to].map(|point| [point[0] - middle[0], point[1] - middle[1]]);
    let is_out = |k: usize| start[k].min(end[k]) >= half[k] || start[k].max(end[k]) <= -half[k];
    let across = [start[1] - end[1], end[0] - start[0]];
    let height = across[0] * start[0] + across[1] * start[1];
    let reach = across[0].abs() * half[0] + across[1].abs() * half[1];
    is_out(0) || is_out(1) || height.abs() >= reach
}

/// Texts set in lines of this width.
fn lines(texts: &[String], page: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for text in texts {
        match lines.last_mut() {
            Some(line) if width(line) + width(text) + 2.0 * LETTER <= page => {
                *line += "; ";
                *line += text;
            }
            _ => lines.push(text.clone()),
        }
    }
    lines
}
