//! Congruent pairs of rectangles along the axes of a turned frame.
//!
//! ```text
//!   model                     the rectangle between the lines that its corners are on (`lines`)
//!   offset                    most that a corner is off its model, along each axis
//! ```
//!
//! Models lie between few lines, exactly along the axes: their pairs fall into classes as those of
//! any axis-parallel rectangles do ([`Lattice`]). A class has the value of the model of its first
//! pair, whose bound is widened by what the offsets and the lattice's spread may change
//! (`perturbation`). Closed forms of axis-parallel rectangles evaluate it.
//!
//! **Not covered**: pairs of rectangles in different frames.

use super::classes::Classes;
use super::congruence::Lattice;
use super::facing::FacingPlanes;
use super::frames::{Frame, frames};
use super::lines::Lines;
use super::{Representative, Source};
use crate::geometry::FlatBox;
use crate::scene::NamedPatch;

/// The rectangles along the axes of one frame, and the models that stand for them.
#[derive(Debug, Clone, PartialEq)]
struct TurnedFrame {
    /// The polygons, in order.
    members: Vec<usize>,
    /// The rectangles that stand for them, along the axes of the frame.
    models: Vec<FlatBox>,
    /// The largest distance of a corner from its model's along an axis.
    offset: f64,
}

impl TurnedFrame {
    /// The frames of the rectangles that are not along the coordinate axes, with their lattices.
    fn all_of(patches: &[NamedPatch]) -> Vec<(Self, Lattice)> {
        let is_turned = |polygon: &usize| {
            let shape = patches[*polygon].shape();
            shape.corners().len() == 4 && FlatBox::of(shape).is_none()
        };
        let found = frames(patches, (0..patches.len()).filter(is_turned));
        let turned = |(frame, members): &(Frame, Vec<usize>)| Self::of(frame, patches, members);
        found.iter().filter_map(turned).collect()
    }

    fn of(frame: &Frame, patches: &[NamedPatch], candidates: &[usize]) -> Option<(Self, Lattice)> {
        let lines = Lines::of(frame, patches, candidates);
        let (mut members, mut models) = (Vec::new(), Vec::new());
        for (polygon, corners) in candidates.iter().zip(&lines.corners) {
            let normal = frame.direction(patches[*polygon].shape().normal());
            if let Some(model) = model(&lines, corners, normal) {
                members.push(*polygon);
                models.push(model);
            }
        }
        let boxes: Vec<Option<FlatBox>> = models.iter().copied().map(Some).collect();
        let lattice = Lattice::of_boxes(&boxes, lines.largest)?;
        let offset = lines.offset();
        let turned = Self {
            members,
            models,
            offset,
        };
        Some((turned, lattice))
    }
}

/// The rectangle between the lines of these corners; none if they are no rectangle's.
fn model(lines: &Lines, corners: &[[usize; 3]], normal: [f64; 3]) -> Option<FlatBox> {
    let [v0, v1, v2, v3] = *corners else {
        return None;
    };
    let along = |from: [usize; 3], to: [usize; 3]| {
        let mut axes = (0..3).filter(|axis| from[*axis] != to[*axis]);
        axes.next().filter(|_| axes.next().is_none())
    };
    let (u, v) = (along(v0, v1)?, along(v0, v3)?);
    let is_closed = along(v1, v2) == Some(v) && along(v3, v2) == Some(u);
    if u == v || !is_closed {
        return None;
    }
    let axis = 3 - u - v;
    let ends = |end: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|k| end(lines.place(k, v0[k]), lines.place(k, v2[k])))
    };
    Some(FlatBox {
        axis,
        faces_along: normal[axis] > 0.0,
        lower: ends(f64::min),
        upper: ends(f64::max),
    })
}

/// The classes of congruent pairs in turned frames.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TurnedClasses {
    frames: Vec<(TurnedFrame, Classes)>,
    /// The number of classes before those of each frame.
    starts: Vec<usize>,
    /// Number of classes of all frames.
    pub(crate) count: usize,
    /// The frame of each polygon, and its place there.
    places: Vec<Option<[u32; 2]>>,
}

impl TurnedClasses {
    /// The classes of all frames; none without frames.
    pub(crate) fn of(patches: &[NamedPatch], facings: &FacingPlanes) -> Option<Self> {
        let mut places = vec![None; patches.len()];
        let (mut frames, mut starts, mut count) = (Vec::new(), Vec::new(), 0);
        for (frame, lattice) in TurnedFrame::all_of(patches) {
            let number = u32::try_from(frames.len()).ok()?;
            for (place, polygon) in (0u32..).zip(&frame.members) {
                places[*polygon] = Some([number, place]);
            }
            let classes = Classes::of(lattice, facings, &frame.members);
            starts.push(count);
            count += classes.representatives.len();
            frames.push((frame, classes));
        }
        (count > 0).then_some(Self {
            frames,
            starts,
            count,
            places,
        })
    }

    /// The place of a pair's class among those of all frames.
    pub(crate) fn place(&self, first: usize, second: usize) -> Option<usize> {
        let [[frame, one], [other_frame, other]] = [self.places[first]?, self.places[second]?];
        if frame != other_frame {
            return None;
        }
        let frame = frame as usize;
        let place = self.frames[frame].1.place(one as usize, other as usize)?;
        Some(self.starts[frame] + place)
    }

    pub(crate) fn representative(&self, class: usize) -> Option<Representative> {
        let frame = self.starts.partition_point(|start| *start <= class) - 1;
        let (turned, classes) = self.frames.get(frame)?;
        let places = *classes.representatives.get(class - self.starts[frame])?;
        Some(Representative {
            pair: places.map(|place| turned.members[place]),
            source: Source::Boxes(places.map(|place| turned.models[place])),
            spread: turned.offset + classes.lattice.spread(),
        })
    }

    /// Whether a polygon is in a frame.
    pub(crate) fn has(&self, polygon: usize) -> bool {
        self.places[polygon].is_some()
    }
}
