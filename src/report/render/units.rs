//! The units of all drawings, so that they have one look.

/// The factor by which a figure is drawn finer than its page.
pub(super) const FINER: u32 = 10;
/// A letter's height is 14; the library's size is 1.24 times that.
pub(super) const LETTERS: u32 = 174;
/// The margin around the figure.
pub(super) const MARGIN: u32 = 12;
/// Height of a row of the legend, and length of the sample of a line in it.
pub(super) const ROW: u32 = 20;
pub(super) const SAMPLE: i32 = 400;
