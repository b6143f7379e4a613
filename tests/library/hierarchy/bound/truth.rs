//! Galerkin's solution on a tree by exact form factors, and its error by a finer solution gathered
//! once more at points.

use glam::DVec3;
use infoscene::form_factor::{DEFAULT_TOLERANCE, Polygon, point_form_factor};
use infoscene::hierarchy::{Element, Lighting, Tree};
use infoscene::scene::Scene;

/// A tree with leaves no larger than `size`.
pub fn uniform(scene: &Scene, size: f64) -> Tree {
    let mut tree = Tree::new(scene.patches().iter().map(|patch| patch.shape()));
    let mut element = 0;
    while element < tree.elements().len() {
        let at = &tree.elements()[element];
        if at.is_leaf() && at.radius() > 0.7072 * size {
            tree.quarter(element).unwrap();
        }
        element += 1;
    }
    tree
}

fn leaves(tree: &Tree) -> Vec<&Element> {
    tree.leaves().map(|leaf| &tree.elements()[leaf]).collect()
}

/// Exchange areas between the leaves of a tree.
pub struct Exchange {
    rows: Vec<Vec<f64>>,
    areas: Vec<f64>,
    patches: Vec<usize>,
}

impl Exchange {
    pub fn of(tree: &Tree) -> Self {
        let leaves = leaves(tree);
        let polygons: Vec<Polygon> = leaves
            .iter()
            .map(|leaf| Polygon::new(leaf.shape()))
            .collect();
        let n = leaves.len();
        let mut rows = vec![vec![0.0; n]; n];
        for i in 0..n {
            for j in 0..i {
                if leaves[i].patch() == leaves[j].patch() {
                    continue;
                }
                let pair = polygons[i].exchange_area(&polygons[j], DEFAULT_TOLERANCE);
                rows[i][j] = pair.unwrap().exchange.value;
                rows[j][i] = rows[i][j];
            }
        }
        let areas = leaves.iter().map(|leaf| leaf.shape().area()).collect();
        let patches = leaves.iter().map(|leaf| leaf.patch()).collect();
        Self {
            rows,
            areas,
            patches,
        }
    }

    /// Radiosities, by Gauss and Seidel's iteration.
    pub fn solved(&self, light: &Lighting) -> Vec<f64> {
        let of = |values: &[f64]| {
            self.patches
                .iter()
                .map(|p| values[*p])
                .collect::<Vec<f64>>()
        };
        let (r, e) = (of(light.reflectances()), of(light.emittances()));
        let mut b = e.clone();
        for _ in 0..20_000 {
            let mut change: f64 = 0.0;
            for i in 0..b.len() {
                if r[i] > 0.0 {
                    let row = self.rows[i].iter().zip(&b);
                    let received: f64 = row.map(|(exchange, b)| exchange * b).sum();
                    let next = e[i] + r[i] * received / self.areas[i];
                    change = change.max((next - b[i]).abs() / next);
                    b[i] = next;
                }
            }
            if change < 1e-10 {
                return b;
            }
        }
        panic!("no end");
    }
}

/// The points of a fine mesh, and what they see of it.
pub struct Truth {
    points: Vec<(DVec3, usize, f64)>,
    factors: Vec<Vec<f32>>,
    exchange: Exchange,
}

impl Truth {
    /// 2 × 2 Gauss points on each leaf, a rectangle, of a fine tree.
    pub fn of(tree: &Tree) -> Self {
        let leaves = leaves(tree);
        let mut points = Vec::new();
        for leaf in &leaves {
            let c = leaf.shape().corners();
            let [u, v] = [c[1] - c[0], c[3] - c[0]];
            let nodes = [0.5 - 0.5 / 3f64.sqrt(), 0.5 + 0.5 / 3f64.sqrt()];
            for s in nodes {
                for t in nodes {
                    points.push((
                        c[0] + s * u + t * v,
                        leaf.patch(),
                        leaf.shape().area() / 4.0,
                    ));
                }
            }
        }
        let normals: Vec<DVec3> = (0..tree.patches())
            .map(|patch| tree.elements()[patch].shape().normal())
            .collect();
        let row = |(point, patch, _): &(DVec3, usize, f64)| {
            let factor = |leaf: &&Element| point_form_factor(*point, normals[*patch], leaf.shape());
            leaves
                .iter()
                .map(|leaf| factor(leaf).unwrap() as f32)
                .collect()
        };
        let factors = points.iter().map(row).collect();
        let exchange = Exchange::of(tree);
        Self {
            points,
            factors,
            exchange,
        }
    }

    /// The true radiosity at each point.
    pub fn solved(&self, light: &Lighting) -> Vec<f64> {
        let b = self.exchange.solved(light);
        let gathered = self
            .points
            .iter()
            .zip(&self.factors)
            .map(|((_, patch, _), row)| {
                let received: f64 = row.iter().zip(&b).map(|(f, b)| f64::from(*f) * b).sum();
                light.emittances()[*patch] + light.reflectances()[*patch] * received
            });
        gathered.collect()
    }

    /// `‖B − B_h‖` and `‖B‖` over patches that reflect, of which those that emit count in the
    /// first only.
    pub fn error(&self, truth: &[f64], tree: &Tree, light: &Lighting, values: &[f64]) -> [f64; 2] {
        let mut squares = [0.0; 2];
        let numbers = numbers(tree);
        for ((point, patch, weight), b) in self.points.iter().zip(truth) {
            if light.reflectances()[*patch] > 0.0 {
                let leaf = numbers[leaf_at(tree, *patch, *point)].unwrap();
                squares[0] += weight * (b - values[leaf]).powi(2);
                if light.emittances()[*patch] == 0.0 {
                    squares[1] += weight * b * b;
                }
            }
        }
        squares.map(f64::sqrt)
    }
}

fn numbers(tree: &Tree) -> Vec<Option<usize>> {
    let mut numbers = vec![None; tree.elements().len()];
    for (leaf, element) in tree.leaves().enumerate() {
        numbers[element] = Some(leaf);
    }
    numbers
}

/// The leaf of a patch cut into rectangles in which a point lies.
fn leaf_at(tree: &Tree, patch: usize, point: DVec3) -> usize {
    let mut element = patch;
    while !tree.elements()[element].is_leaf() {
        let children = tree.elements()[element].children();
        let inside = |child: &usize| {
            let corners = tree.elements()[*child].shape().corners();
            let low = corners.iter().copied().reduce(DVec3::min).unwrap();
            let high = corners.iter().copied().reduce(DVec3::max).unwrap();
            (low - 1e-9).cmple(point).all() && point.cmple(high + 1e-9).all()
        };
        element = children.clone().find(inside).unwrap();
    }
    element
}
