//! The form factors of links, past all that stands between.
//!
//! ```text
//!   F(x) ≈ value + gradient·(x − centre)          x: on the receiving element
//!
//!   far       F and ∇F from the receiver's centre, in closed form
//!   near      the means of F and ∇F over the points of a rule on the receiver
//!   partial   the plane through what the points of the rule see past plates, by least squares
//!   hidden    no link
//! ```
//!
//! What may stand between two patches is found once; a pair of their parts asks these plates alone
//! ([`Visibility`]), and less and less of them if it is told what its parents left.
//!
//! [`LinkFactors::exchange_area`] has the exact exchange area of two elements instead.
//!
//! **Cost**, of `cargo bench --bench occlusion -- links`, as a multiple of the textbook's sixteen
//! terms for aligned rectangles: half of it for a link that is clear, near ones included; 3 past a
//! single plate or a corner of a wall; 12 in a furnished room, where several plates are
//! before a link.
//!
//! **Not covered**: patches that lie in another one.

mod rule;
mod visibility;

pub use visibility::Visibility;
pub(in crate::hierarchy) use visibility::{Place, Plates};

use super::HierarchyError;
use super::tree::Element;
use crate::form_factor::{
    ExchangeArea, FormFactorError, Occluders, Plate, PointFactor, PointView, Polygon, Seen,
    point_form_factor_with_gradient, point_kernel,
};
use crate::scene::{Occlusion, Scene};
use glam::DVec3;
use rule::Rule;
use smallvec::SmallVec;

/// The distance of centres, in radii of the receiver, below which a link is near.
const NEAR: f64 = 4.0;
/// The height over a plane, in sizes of elements, that counts as none.
const IN_PLANE: f64 = 1e-12;

/// The form factors between elements of a scene.
#[derive(Debug)]
pub struct LinkFactors<'s> {
    scene: &'s Scene,
    /// None if nothing stands between patches, or that is ignored.
    plates: Option<Plates>,
}

impl<'s> LinkFactors<'s> {
    /// The form factors of a scene.
    ///
    /// # Errors
    /// [`HierarchyError::Scene`] if patches overlap, or something stands between them and that is
    /// refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::hierarchy::{LinkFactors, Tree};
    /// use infoscene::scene::{Occlusion, Scene};
    /// // a floor of 1/64 in the middle of a cube's sees the ceiling as its middle does
    /// let cube = Scene::built_in("cube:1")?;
    /// let mut tree = Tree::new(cube.patches().iter().map(|patch| patch.shape()));
    /// let links = LinkFactors::try_new(&cube, Occlusion::Refuse)?;
    /// let parts = tree.quarter(0)?;
    /// let corner = tree.elements()[parts.start].clone();
    /// let seen: f64 = (0..6)
    ///     .filter_map(|patch| links.between(&corner, &tree.elements()[patch]).transpose())
    ///     .map(|link| link.map(|link| link.value))
    ///     .sum::<Result<_, _>>()?;
    /// // a quarter of the floor sees the cube, and nothing else
    /// assert!((seen - 1.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn try_new(scene: &'s Scene, occlusion: Occlusion) -> Result<Self, HierarchyError> {
        occlusion.check(scene)?;
        let plates = match occlusion {
            Occlusion::Exact => Plates::of(scene),
            Occlusion::Refuse | Occlusion::Ignore => None,
        };
        Ok(Self { scene, plates })
    }

    /// What stands between two patches.
    #[must_use]
    pub fn visibility(&self, first: usize, second: usize) -> &Visibility {
        let plates = self.plates.as_ref();
        plates.map_or(&Visibility::Clear, |plates| {
            plates.of_patches(first, second)
        })
    }

    /// The plates that may stand between patches; none if nothing does.
    pub(in crate::hierarchy) fn into_plates(self) -> Option<Plates> {
        self.plates
    }

    /// The form factor from one element to another; none if none of one sees the other.
    ///
    /// # Errors
    /// [`HierarchyError::FormFactor`] if coordinates leave the range of `f64`.
    pub fn between(
        &self,
        receiver: &Element,
        source: &Element,
    ) -> Result<Option<PointFactor>, HierarchyError> {
        let known = self.visibility(receiver.patch(), source.patch());
        let link = self.between_parts(receiver, source, known)?;
        Ok(link.map(|(factor, _)| factor))
    }

    /// The form factor from one element to another, and what stands between them; none if none of
    /// one sees the other.
    ///
    /// **Arguments** `inherited`: what stands between two elements that the two are, or are parts
    /// of.
    ///
    /// # Errors
    /// As [`between`](Self::between).
    pub fn between_parts(
        &self,
        receiver: &Element,
        source: &Element,
        inherited: &Visibility,
    ) -> Result<Option<(PointFactor, Visibility)>, HierarchyError> {
        if !rises_above(source, receiver) || !rises_above(receiver, source) {
            return Ok(None);
        }
        let Some(plates) = &self.plates else {
            return Ok(Some((unoccluded(receiver, source)?, Visibility::Clear)));
        };
        let visibility = plates.narrowed(inherited, [receiver, source], self.scene.noise_length());
        let factor = match &visibility {
            Visibility::Hidden => return Ok(None),
            Visibility::Clear => unoccluded(receiver, source)?,
            Visibility::Past(between) => {
                let (plates, touching) = (plates.selected(between), self.scene.noise_length());
                match past(receiver, source, &plates, touching) {
                    Some(factor) => factor,
                    None => unoccluded(receiver, source)?,
                }
            }
        };
        Ok(Some((factor, visibility)))
    }

    /// The form factor from a point of a surface with this unit normal to an element.
    ///
    /// **Arguments** `visibility`: of the element, and one on which the point lies.
    ///
    /// # Errors
    /// As [`between`](Self::between).
    pub fn from_point(
        &self,
        point: DVec3,
        normal: DVec3,
        source: &Element,
        visibility: &Visibility,
    ) -> Result<f64, HierarchyError> {
        let shape = source.shape();
        match (&self.plates, visibility) {
            (_, Visibility::Hidden) => Ok(0.0),
            (Some(plates), Visibility::Past(between)) => {
                let touching = self.scene.noise_length();
                let view = PointView {
                    point,
                    normal,
                    touching,
                };
                Ok(plates.form_factor(view, shape, between))
            }
            _ => Ok(point_form_factor_with_gradient(point, normal, shape)?.value),
        }
    }

    /// The kernel `cos θ_x cos θ_y/(π r²)` between points of two surfaces with these unit normals;
    /// 0 if a plate stands between them.
    ///
    /// **Arguments** `ends`: a point and its normal each; `visibility`: of elements on which the
    /// points lie.
    ///
    /// # Errors
    /// As [`between`](Self::between).
    pub fn kernel(
        &self,
        ends: [[DVec3; 2]; 2],
        visibility: &Visibility,
    ) -> Result<f64, HierarchyError> {
        let points = ends.map(|[point, _]| point);
        let touching = self.scene.noise_length();
        let is_hidden = match (&self.plates, visibility) {
            (_, Visibility::Hidden) => true,
            (Some(plates), Visibility::Past(between)) => {
                let mut plates = plates.selected(between).into_iter();
                plates.any(|plate| plate.stands_between(points, touching))
            }
            _ => false,
        };
        if is_hidden {
            return Ok(0.0);
        }
        Ok(point_kernel(ends[0], ends[1])?)
    }

    /// Whether anything can stand between two elements.
    #[must_use]
    pub const fn can_be_hidden(&self) -> bool {
        self.plates.is_some()
    }

    /// The exchange area of two elements, with its error; of a pair it is to be asked once, as the
    /// other order may round otherwise.
    ///
    /// **Arguments** `polygons`: of the elements; `visibility`: of the two, or of what they are
    /// parts of; `tolerance`: relative.
    ///
    /// # Errors
    /// [`HierarchyError::FormFactor`], as of [`Polygon::exchange_area`].
    pub fn exchange_area(
        &self,
        polygons: [&Polygon; 2],
        visibility: &Visibility,
        tolerance: f64,
    ) -> Result<ExchangeArea, HierarchyError> {
        let [one, other] = polygons;
        let answer = match (&self.plates, visibility) {
            (_, Visibility::Hidden) => return Ok(ExchangeArea::NOTHING),
            (Some(plates), Visibility::Past(between)) => {
                let polygons = plates.polygons(between);
                let occluders = Occluders {
                    polygons: &polygons,
                    touching: self.scene.noise_length(),
                };
                one.exchange_area_past(other, &occluders, tolerance)?
            }
            _ => one.exchange_area(other, tolerance)?,
        };
        Ok(answer.exchange)
    }
}

/// The form factor where nothing is in the way.
fn unoccluded(receiver: &Element, source: &Element) -> Result<PointFactor, FormFactorError> {
    let normal = receiver.shape().normal();
    let seen = |point| point_form_factor_with_gradient(point, normal, source.shape());
    let distance = receiver.centre().distance(source.centre());
    if distance > NEAR * receiver.radius() {
        return seen(receiver.centre());
    }
    let mut mean = PointFactor::NOTHING;
    for (point, weight) in Rule::of(receiver).nodes() {
        let part = seen(*point)?;
        mean.value += weight * part.value;
        mean.gradient += *weight * part.gradient;
    }
    Ok(mean)
}

/// The plane through factors past plates at the points of a rule; none if nothing is hidden from
/// any of them.
fn past(
    receiver: &Element,
    source: &Element,
    plates: &[&Plate],
    touching: f64,
) -> Option<PointFactor> {
    let (shape, normal) = (source.shape(), receiver.shape().normal());
    let (corners, front) = (shape.corners(), shape.normal());
    let rule = Rule::of(receiver);
    let views = rule.nodes().iter().map(|(point, _)| PointView {
        point: *point,
        normal,
        touching,
    });
    let see = |view: PointView| match (view.point - corners[0]).dot(front) > 0.0 {
        true => view.visible(corners, plates),
        false => Seen::Part(0.0),
    };
    let seen: SmallVec<[Seen; 8]> = views.clone().map(see).collect();
    if seen.iter().all(|seen| *seen == Seen::Whole) {
        return None;
    }
    let values = views.zip(seen).map(|(view, seen)| match seen {
        Seen::Part(value) => value,
        Seen::Whole => view.form_factor(corners),
    });
    Some(rule.plane(&values.collect::<SmallVec<[f64; 8]>>()))
}

/// Whether some of an element is in front of another's plane.
fn rises_above(element: &Element, other: &Element) -> bool {
    let (normal, origin) = (other.shape().normal(), other.shape().corners()[0]);
    let noise = IN_PLANE * (element.radius() + other.radius());
    let corners = element.shape().corners().iter();
    corners
        .map(|c| (*c - origin).dot(normal))
        .any(|height| height > noise)
}
