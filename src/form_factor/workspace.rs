//! Memory for the work on a pair, kept from one pair to the next.

use super::contour::Scratch;
use crate::form_factor::gauss::lambert::RelativeEdge;
use crate::form_factor::gauss::points::{Block, PointLanes};
use std::cell::RefCell;

thread_local! {
    static WORKSPACE: RefCell<Workspace> = RefCell::default();
}

/// Buffers that the routes fill anew for each pair.
#[derive(Debug, Default)]
pub(super) struct Workspace {
    pub scratch: Scratch,
    pub blocks: [Vec<Block>; 2],
    pub together: [Vec<PointLanes>; 2],
    pub sides: Vec<RelativeEdge>,
}

impl Workspace {
    /// Lends this thread's workspace to some work, which must not ask for it again.
    pub(super) fn with<T>(work: impl FnOnce(&mut Self) -> T) -> T {
        WORKSPACE.with_borrow_mut(work)
    }
}
