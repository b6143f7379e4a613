//! The links to patches that reflect nothing, turned round by reciprocity.
//!
//! ```text
//!   A_i F_ij = A_j F_ji          i: black, j: reflects, F_ji: the link's
//! ```
//!
//! Nothing of what a black patch receives goes on, so that it needs no links of its own; those by
//! which it is a source tell what it receives. They are as fine as the light that comes back from
//! it asks for, where the elements j vary, so that sums over them are better than a few points of
//! the patch itself would be. Of exact factors a black patch has links of its own, too, which say
//! the same: they do not count beside these.
//!
//! **Not covered**: what black patches receive from each other, between which there is no link.

use super::lighting::Lighting;
use super::link::{Link, Links};
use super::link_factor::Visibility;
use super::tree::Tree;

/// A link to a black element, seen from there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turned<'l> {
    /// The black element.
    pub(super) receiver: usize,
    /// The element that reflects.
    pub(super) source: usize,
    /// `A_i F_ij`.
    pub(super) exchange: f64,
    /// What stands between.
    pub(super) sight: &'l Visibility,
}

/// The links whose receivers reflect, each with what stands between.
pub(super) fn reflected_links<'l>(
    tree: &'l Tree,
    links: &'l Links,
    lighting: &'l Lighting,
) -> impl Iterator<Item = (&'l Link, &'l Visibility)> {
    let receiver = |link: &Link| tree.elements()[link.receiver as usize].patch();
    let links = links.with_sights();
    links.filter(move |(link, _)| lighting.reflectance(receiver(link)) > 0.0)
}

/// The links to black elements from elements that reflect, turned round.
pub(super) fn turned_links<'l>(
    tree: &'l Tree,
    links: &'l Links,
    lighting: &'l Lighting,
) -> impl Iterator<Item = Turned<'l>> {
    reflected_links(tree, links, lighting).filter_map(move |(link, sight)| {
        let [to, from] = [link.receiver, link.source].map(|end| end as usize);
        let is_black = lighting.reflectance(tree.elements()[from].patch()) <= 0.0;
        is_black.then(|| Turned {
            receiver: from,
            source: to,
            exchange: tree.elements()[to].shape().area() * link.value,
            sight,
        })
    })
}
