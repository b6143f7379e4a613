//! Ears of a simple polygon, and the rest of it as they are cut off.
//!
//! An ear is a corner that turns left and whose triangle contains no other corner. A simple polygon
//! with more than three corners has two (Meisters 1975). The ear clipper knows which corners are
//! ears; its user chooses among them, and says how a turn is computed: rounded or exactly, in space
//! or in a plane.
//!
//! Reference: Meisters, "Polygons have ears", *American Mathematical Monthly* 82 (1975), 648–651.

/// A simple polygon, counter-clockwise, of which ears are cut off one by one.
pub(crate) struct EarClipper<'a, P, T> {
    corners: &'a [P],
    turn: T,
    left: Vec<usize>,
}

impl<'a, P: Copy + PartialEq, T: Fn(P, P, P) -> f64> EarClipper<'a, P, T> {
    /// The whole polygon.
    ///
    /// **Arguments** `turn`: twice the signed area of a triangle, positive if it runs
    /// counter-clockwise.
    pub(crate) fn new(corners: &'a [P], turn: T) -> Self {
        Self {
            corners,
            turn,
            left: (0..corners.len()).collect(),
        }
    }

    /// The corners that remain, in order.
    pub(crate) fn left(&self) -> &[usize] {
        &self.left
    }

    /// The corner at a place among those left, between its neighbours.
    pub(crate) fn triangle(&self, place: usize) -> [usize; 3] {
        let n = self.left.len();
        [n - 1, 0, 1].map(|step| self.left[(place + step) % n])
    }

    /// The turn at a place, positive to the left.
    pub(crate) fn turn(&self, place: usize) -> f64 {
        let [a, b, c] = self.triangle(place).map(|i| self.corners[i]);
        (self.turn)(a, b, c)
    }

    /// Tells whether the remaining outline never turns right. A triangle is taken not to.
    pub(crate) fn is_convex(&self) -> bool {
        let n = self.left.len();
        n <= 3 || (0..n).all(|place| self.turn(place) >= 0.0)
    }

    /// Tells whether the corner at this place is an ear.
    pub(crate) fn is_ear(&self, place: usize) -> bool {
        let [a, b, c] = self.triangle(place).map(|i| self.corners[i]);
        let turn = &self.turn;
        let is_inside = |p: P| {
            let is_corner = p == a || p == b || p == c;
            !is_corner && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0
        };
        turn(a, b, c) > 0.0 && !self.left.iter().any(|i| is_inside(self.corners[*i]))
    }

    /// The places of all ears, in order.
    pub(crate) fn ears(&self) -> impl Iterator<Item = usize> {
        (0..self.left.len()).filter(|place| self.is_ear(*place))
    }

    /// Cuts off the corner at a place; returns the triangle.
    pub(crate) fn cut(&mut self, place: usize) -> [usize; 3] {
        let triangle = self.triangle(place);
        self.left.remove(place);
        triangle
    }

    /// Cuts the whole outline up; returns its triangles. Corners at which nothing turns are
    /// corners of triangles as long as there is an ear, and are passed over then.
    ///
    /// **Arguments** `preferred`: one of the ears, if there are any.
    pub(crate) fn triangles(
        mut self,
        preferred: impl Fn(&Self) -> Option<usize>,
    ) -> Vec<[usize; 3]> {
        let mut triangles = Vec::with_capacity(self.corners.len().saturating_sub(2));
        while self.left.len() > 3 {
            let places = || 0..self.left.len();
            let is_straight = |place: &usize| self.turn(*place) == 0.0;
            let chosen = preferred(&self).or_else(|| places().find(is_straight));
            // none only if rounding hides all ears: any left turn will do then
            let any_left_turn = || places().find(|place| self.turn(*place) > 0.0);
            let place = chosen.or_else(any_left_turn).unwrap_or(0);
            let has_area = self.turn(place) > 0.0;
            let triangle = self.cut(place);
            triangles.extend(has_area.then_some(triangle));
        }
        let rest = <[usize; 3]>::try_from(self.left()).ok();
        triangles.extend(rest.filter(|_| self.turn(1) > 0.0));
        triangles
    }
}
