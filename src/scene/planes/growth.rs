//! Planes of surfaces whose corners are rounded: a wall grows from its largest panel.
//!
//! ```text
//!   tilt of a plane  =  4 δ / width        δ = √3 resolutions, width: of all that lies in it
//! ```
//!
//! The plane of a small panel says little far from it, that of a wall much. So a plane starts from
//! the largest surface that is left and takes in others, the nearest first, each time put through
//! corners of all of them. It takes what leaves all corners within half the noise of each other;
//! what a tilt cannot bring there is not tried. Of the plane through three far corners and that of
//! least squares the thinner one is taken.
//!
//! **Not covered**: exact scenes, whose planes are found by their numbers.

use super::{SharedPlane, centred, through_far_corners};
use crate::geometry::{Plane, mean};
use glam::DVec3;

/// The steepest slope of a plane of least squares over one through three of its points.
const STEEPEST: f64 = 1.0;

/// A surface that waits for its plane.
pub(super) struct Panel {
    pub surface: usize,
    pub own: SharedPlane,
    pub corners: Vec<DVec3>,
    pub centre: DVec3,
    /// The largest distance of a corner from the centre.
    pub radius: f64,
    pub tilt: f64,
}

impl Panel {
    /// A surface with these corners and this width, whose corners are off by `delta` at most.
    pub(super) fn new(
        surface: usize,
        own: SharedPlane,
        corners: Vec<DVec3>,
        [width, delta]: [f64; 2],
    ) -> Self {
        let centre = mean(&corners);
        let distances = corners.iter().map(|corner| corner.distance(centre));
        Self {
            surface,
            own,
            radius: distances.fold(0.0, f64::max),
            centre,
            corners,
            tilt: tilt(delta, width),
        }
    }

    /// Whether both may lie in one plane, to judge by what their tilts leave open.
    fn may_share(&self, other: &Self, noise: f64) -> bool {
        let [one, two] = [&self.own.plane, &other.own.plane];
        let tilt = self.tilt + other.tilt;
        if one.normal.cross(two.normal).length_squared() > tilt * tilt {
            return false;
        }
        let height = one.height(other.centre).abs();
        let reach = self.centre.distance(other.centre);
        let allowed = noise + self.tilt.max(other.tilt) * (reach + other.radius);
        height <= allowed
    }
}

/// The largest slope of a plane of this width over the exact one.
fn tilt(delta: f64, width: f64) -> f64 {
    (4.0 * delta / width).min(1.0)
}

/// Panels gathered in planes: the members of each and the plane, in the order of their largest
/// members.
pub(super) fn grown(
    mut panels: Vec<Panel>,
    noise: f64,
    delta: f64,
) -> Vec<(Vec<usize>, SharedPlane)> {
    panels.sort_by(|a, b| {
        let by_size = b.radius.total_cmp(&a.radius);
        by_size.then(a.surface.cmp(&b.surface))
    });
    let mut is_placed = vec![false; panels.len()];
    let mut found = Vec::new();
    for place in 0..panels.len() {
        if is_placed[place] {
            continue;
        }
        let seed = &panels[place];
        let later = place + 1..panels.len();
        let open = later.filter(|other| !is_placed[*other]);
        let mut near: Vec<usize> = open
            .filter(|other| seed.may_share(&panels[*other], noise))
            .collect();
        near.sort_by(|a, b| {
            let distance = |place: usize| panels[place].centre.distance_squared(seed.centre);
            distance(*a).total_cmp(&distance(*b)).then(a.cmp(b))
        });
        let mut wall = Wall::of(seed);
        for other in near {
            is_placed[other] = wall.takes(&panels[other], 0.5 * noise);
        }
        found.push(wall.finished(delta));
    }
    found
}

/// A plane that grows.
struct Wall {
    members: Vec<usize>,
    corners: Vec<DVec3>,
    shared: SharedPlane,
}

impl Wall {
    fn of(seed: &Panel) -> Self {
        Self {
            members: vec![seed.surface],
            corners: seed.corners.clone(),
            shared: seed.own.clone(),
        }
    }

    /// Takes a panel in if all corners then lie `together`.
    fn takes(&mut self, panel: &Panel, together: f64) -> bool {
        let [low, high] = self.shared.range(panel.corners.iter().copied());
        let (low, high) = (low.min(self.shared.low), high.max(self.shared.high));
        let before = self.corners.len();
        self.corners.extend_from_slice(&panel.corners);
        // with something left for those to come, before the plane is put through all of them again
        if high - low <= 0.5 * together {
            (self.shared.low, self.shared.high) = (low, high);
        } else {
            match thinnest(&self.corners).filter(|fitted| fitted.thickness() <= together) {
                Some(fitted) => self.shared = fitted,
                None => {
                    self.corners.truncate(before);
                    return false;
                }
            }
        }
        self.members.push(panel.surface);
        true
    }

    fn finished(self, delta: f64) -> (Vec<usize>, SharedPlane) {
        let mut shared = self.shared;
        if self.members.len() > 1
            && let Some(fitted) = thinnest(&self.corners)
            && fitted.thickness() <= shared.thickness()
        {
            shared = fitted;
        }
        shared.plane.origin = middle(&self.corners, &shared.plane);
        shared.plane.tilt = tilt(delta, width(&self.corners, shared.plane.normal));
        (self.members, shared)
    }
}

/// The mean of points, put into a plane.
fn middle(points: &[DVec3], plane: &Plane) -> DVec3 {
    let mean = mean(points);
    mean - plane.height(mean) * plane.normal
}

/// The smaller extent of points in a plane: across the line to the point farthest from the first.
fn width(points: &[DVec3], normal: DVec3) -> f64 {
    let origin = points[0];
    let farthest = points.iter().copied().max_by(|a, b| {
        let [a, b] = [a, b].map(|point| point.distance_squared(origin));
        a.total_cmp(&b)
    });
    let along = farthest.map_or(DVec3::X, |point| (point - origin).normalize_or_zero());
    let across = normal.cross(along);
    let places = points.iter().map(|point| (*point - origin).dot(across));
    let [low, high] = places.fold([0.0, 0.0], |[low, high]: [f64; 2], place| {
        [low.min(place), high.max(place)]
    });
    high - low
}

/// The thinner of the planes through far corners and of least squares.
fn thinnest(corners: &[DVec3]) -> Option<SharedPlane> {
    let far = through_far_corners(|| corners.iter().copied())?;
    let fitted = least_squares(corners, &far.plane);
    let fitted = centred(fitted, || corners.iter().copied());
    Some(if fitted.thickness() < far.thickness() {
        fitted
    } else {
        far
    })
}

/// The plane from which squared heights are least, among those near a given one.
fn least_squares(points: &[DVec3], near: &Plane) -> Plane {
    let mean = mean(points);
    let (across, up) = near.normal.any_orthonormal_pair();
    let [mut xx, mut xy, mut yy, mut xh, mut yh] = [0.0; 5];
    for point in points {
        let from = *point - mean;
        let (x, y, h) = (from.dot(across), from.dot(up), from.dot(near.normal));
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xh += x * h;
        yh += y * h;
    }
    let determinant = xx * yy - xy * xy;
    // h = a x + b y
    let a = (xh * yy - yh * xy) / determinant;
    let b = (yh * xx - xh * xy) / determinant;
    let normal = (near.normal - a * across - b * up).normalize_or_zero();
    // points on one line leave a slope open, and then any, or none
    let is_sound = a.abs() + b.abs() <= STEEPEST;
    if is_sound {
        Plane::new(normal, mean)
    } else {
        *near
    }
}
