//! Nets set beside each other on a page.
//!
//! The largest net comes first. Each other one stands where there is room beside those before it,
//! else in a new row below all.

use glam::DVec2;

/// The space between nets, over the root of their area.
const GAP: f64 = 0.06;

/// A rectangle by its lower left and its upper right corner.
pub(super) type Bounds = [DVec2; 2];

/// The rectangle around points.
pub(super) fn around(points: impl IntoIterator<Item = DVec2>) -> Bounds {
    let nothing = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    let points = points.into_iter();
    points.fold(nothing, |[low, high], point| {
        [low.min(point), high.max(point)]
    })
}

/// Rectangles that are on the page, and what they extend over.
struct Page {
    taken: Vec<Bounds>,
    extent: Bounds,
    /// The upper end of the last row.
    row: f64,
    gap: f64,
}

/// The shifts that bring nets, each of some rectangles, onto one page.
pub(super) fn shifts(nets: &[Vec<Bounds>]) -> Vec<DVec2> {
    let bounds: Vec<Bounds> = nets
        .iter()
        .map(|net| around(net.iter().flatten().copied()))
        .collect();
    let area = |net: &usize| {
        let [low, high] = bounds[*net];
        (high - low).element_product()
    };
    let mut order: Vec<usize> = (0..nets.len()).collect();
    order.sort_by(|one, other| area(other).total_cmp(&area(one)));
    let side = order.iter().map(area).sum::<f64>().sqrt();
    let mut page = Page {
        taken: Vec::new(),
        extent: [DVec2::ZERO; 2],
        row: 0.0,
        gap: GAP * side,
    };
    let mut shifts = vec![DVec2::ZERO; nets.len()];
    for net in order {
        let [low, high] = bounds[net];
        let corner = page.corner(high - low, side);
        shifts[net] = corner - low;
        let shift = |rectangle: &Bounds| rectangle.map(|corner| corner + shifts[net]);
        page.taken.extend(nets[net].iter().map(shift));
        page.extent = around(page.extent.into_iter().chain([corner, corner + high - low]));
    }
    shifts
}

impl Page {
    /// The lower left corner of the place for a rectangle of this size, on a page so wide at least.
    fn corner(&mut self, size: DVec2, width: f64) -> DVec2 {
        if self.taken.is_empty() {
            return DVec2::new(0.0, -size.y);
        }
        let [low, high] = self.extent;
        let within = |right: f64| self.free(size, right);
        if let Some(corner) = within(high.x).or_else(|| within(high.x.max(width))) {
            return corner;
        }
        self.row = low.y - self.gap;
        DVec2::new(0.0, self.row - size.y)
    }

    /// A free place whose right end is at most there; above and to the right, if there are several.
    fn free(&self, size: DVec2, right: f64) -> Option<DVec2> {
        let [low, high] = self.extent;
        let beside = self
            .taken
            .iter()
            .flat_map(|[low, high]| [low.x - self.gap - size.x, high.x + self.gap]);
        let mut columns: Vec<f64> = beside.chain([0.0, right - size.x]).collect();
        columns.retain(|column| *column >= 0.0 && column + size.x <= right);
        columns.sort_by(|one, other| other.total_cmp(one));
        let rows = [high.y - size.y, self.row - size.y, low.y];
        let rows = rows.into_iter().filter(|row| *row >= low.y);
        rows.flat_map(|row| columns.iter().map(move |column| DVec2::new(*column, row)))
            .find(|corner| self.is_free([*corner, *corner + size]))
    }

    fn is_free(&self, [low, high]: Bounds) -> bool {
        let gap = DVec2::splat(0.999 * self.gap);
        let is_apart =
            |[from, to]: &Bounds| (low - gap).cmpge(*to).any() || (high + gap).cmple(*from).any();
        self.taken.iter().all(is_apart)
    }
}
