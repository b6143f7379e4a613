//! Lines at random know the same form factors, and how well they know them.
//!
//! ```text
//!   z = (estimate − F) / standard error,   |z| < 5 for every seed,   Σ z² over m seeds ~ χ²(m)
//! ```

use crate::support::references::rows;
use crate::support::rooms::patch;
use infoscene::form_factor::sampling::{
    global_lines, local_lines, local_lines_past, quasi_random_lines, quasi_random_lines_past,
};
use infoscene::form_factor::{DEFAULT_TOLERANCE, Polygon};
use infoscene::geometry::Patch;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const SEEDS: u64 = 40;
const LINES: u32 = 3000;

/// Whether estimates with standard errors are what they say: no z beyond 5, and Σ z² between the
/// quantiles of χ² at 4.75 standard deviations (1e-6 on each side) by Wilson and Hilferty's formula
/// `m (1 − 2/(9m) ± 4.75 √(2/(9m)))³`.
fn honest(exact: f64, estimates: &[(f64, f64)]) -> Result<(), String> {
    let z: Vec<f64> = estimates
        .iter()
        .map(|(value, error)| (value - exact) / error)
        .collect();
    if let Some(far) = z.iter().find(|z| z.abs().is_nan() || z.abs() >= 5.0) {
        return Err(format!("z = {far}"));
    }
    #[expect(clippy::cast_precision_loss, reason = "a number of seeds")]
    let m = z.len() as f64;
    let squares: f64 = z.iter().map(|z| z * z).sum();
    let quantile = |side: f64| {
        let part = 2.0 / (9.0 * m);
        m * (1.0 - part + side * 4.75 * part.sqrt()).powi(3)
    };
    if (quantile(-1.0)..quantile(1.0)).contains(&squares) {
        Ok(())
    } else {
        Err(format!("sum of squares {squares} of {m}"))
    }
}

/// Pairs of 30-digit values both ways, a polygon in the notch of another, two partly behind each
/// other's plane.
fn pairs() -> Vec<(String, [Patch; 2], f64)> {
    let mut pairs = Vec::new();
    for row in rows("form_factors.csv") {
        let wanted = [
            "ff_par_unit_d1",
            "ff_perp_1_1",
            "ff_incl_30",
            "ff_tri_corner_vertex",
            "ff_Lshape_par",
        ];
        if wanted.contains(&row.id.as_str()) {
            let [p, q]: [Patch; 2] = row.polygons().try_into().unwrap();
            let (there, back) = (row.number("form_factor"), row.number("reverse_form_factor"));
            pairs.push((row.id.clone(), [p.clone(), q.clone()], there));
            pairs.push((format!("{}, back", row.id), [q, p], back));
        }
    }
    let notched = patch(&[
        [0.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
        [0.25, 1.0, 1.0],
        [0.25, 0.25, 1.0],
        [0.75, 0.25, 1.0],
        [0.75, 1.0, 1.0],
        [1.0, 1.0, 1.0],
        [1.0, 0.0, 1.0],
    ]);
    let below = patch(&[[0.4, 0.4, 0.75], [0.6, 0.4, 0.75], [0.5, 0.9, 0.75]]);
    let square = patch(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    let crossing = patch(&[[0.4, -0.5, -0.5], [0.4, 0.8, -0.2], [0.6, 0.3, 0.9]]);
    for (name, first, second) in [("notch", below, notched), ("horizon", square, crossing)] {
        let answer = Polygon::new(&first).exchange_area(&Polygon::new(&second), DEFAULT_TOLERANCE);
        let exchange = answer.unwrap().exchange.value;
        let (there, back) = (exchange / first.area(), exchange / second.area());
        pairs.push((name.to_owned(), [first.clone(), second.clone()], there));
        pairs.push((format!("{name}, back"), [second, first], back));
    }
    pairs
}

/// Lines of every kind, over 40 seeds: within five standard errors, and spread as these say. A
/// quasi-random standard error comes from 16 shifts, so that its squares are those of Student's t:
/// 15/13 as large on average.
#[test]
fn sampled_form_factors_agree_within_honest_standard_errors() {
    let pairs = pairs();
    assert_eq!(pairs.len(), 14);
    for (name, [first, second], exact) in pairs {
        type Lines = fn(&Patch, &Patch, u64) -> (f64, f64);
        let methods: [(&str, Lines); 3] = [
            ("local", |p, q, seed| {
                let sample = local_lines(p, q, LINES, seed).unwrap();
                (sample.value, sample.standard_error)
            }),
            ("global", |p, q, seed| {
                let sample = global_lines(p, q, LINES, seed).form_factor().unwrap();
                (sample.value, sample.standard_error)
            }),
            ("quasi-random", |p, q, seed| {
                let sample = quasi_random_lines(p, q, LINES, seed).unwrap();
                (sample.value, sample.standard_error * (15f64 / 13.0).sqrt())
            }),
        ];
        for (method, lines) in methods {
            let estimates: Vec<_> = (0..SEEDS)
                .map(|seed| lines(&first, &second, seed))
                .collect();
            if let Err(reason) = honest(exact, &estimates) {
                panic!("{name}, {method} lines: {reason}");
            }
        }
    }
}

/// Negative controls: directions uniform in solid angle instead of by cosine, and standard errors
/// half or twice as large as they are, are found out.
#[test]
fn a_wrong_cosine_and_wrong_standard_errors_are_found_out() {
    const EXACT: f64 = 0.199_824_895_698_387_38; // facing unit squares 1 apart, form_factors.csv
    let lines = |seed: u64, by_cosine: bool| {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let hits = (0..LINES).filter(|_| {
            let [x, y, u, v]: [f64; 4] = random.random();
            let rise = if by_cosine { (1.0 - u).sqrt() } else { 1.0 - u };
            let (sine, cosine) = (std::f64::consts::TAU * v).sin_cos();
            let aside = (1.0 - rise * rise).sqrt() / rise;
            [x + aside * cosine, y + aside * sine]
                .iter()
                .all(|c| (0.0..1.0).contains(c))
        });
        let (hits, lines) = (
            f64::from(u32::try_from(hits.count()).unwrap()),
            f64::from(LINES),
        );
        let part = hits / lines;
        (part, (part * (1.0 - part) / lines).sqrt())
    };
    let estimates = |by_cosine, factor: f64| -> Vec<(f64, f64)> {
        (0..SEEDS)
            .map(|seed| lines(seed, by_cosine))
            .map(|(value, error)| (value, factor * error))
            .collect()
    };
    assert_eq!(honest(EXACT, &estimates(true, 1.0)), Ok(()));
    assert!(honest(EXACT, &estimates(false, 1.0)).is_err());
    assert!(honest(EXACT, &estimates(true, 0.5)).is_err());
    assert!(honest(EXACT, &estimates(true, 2.0)).is_err());
}

/// `P(a uniform line meets a patch) = A / (2πR²)`: areas, also of a concave patch, and half the
/// area is found out.
#[test]
fn global_lines_meet_patches_in_proportion_to_their_areas() {
    for (name, [first, second], _) in pairs() {
        for (which, patch) in [&first, &second].into_iter().enumerate() {
            let areas: Vec<_> = (0..SEEDS)
                .map(|seed| {
                    global_lines(&first, &second, LINES, seed)
                        .area(which)
                        .unwrap()
                })
                .map(|[area, error]| (area, error))
                .collect();
            if let Err(reason) = honest(patch.area(), &areas) {
                panic!("{name}, patch {which}: {reason}");
            }
            let wrong = 0.5 * patch.area();
            assert!(honest(wrong, &areas).is_err(), "{name}, patch {which}");
        }
    }
}

/// A seed names its estimate; a power of two as unit of length changes nothing, up to 2^±500.
#[test]
fn estimates_depend_on_the_seed_alone_and_not_on_the_unit() {
    for (name, [first, second], _) in pairs() {
        let estimates = |p: &Patch, q: &Patch, seed| {
            let local = local_lines(p, q, 500, seed).unwrap();
            let quasi = quasi_random_lines(p, q, 500, seed).unwrap();
            let global = global_lines(p, q, 500, seed);
            (local, quasi, global.met, global.joined)
        };
        let here = estimates(&first, &second, 1);
        assert_eq!(here, estimates(&first, &second, 1), "{name}");
        assert_ne!(here, estimates(&first, &second, 2), "{name}");
        for unit in [500f64.exp2(), (-500f64).exp2()] {
            let scaled = |patch: &Patch| {
                Patch::try_new(patch.corners().iter().map(|c| *c * unit).collect()).unwrap()
            };
            assert_eq!(
                here,
                estimates(&scaled(&first), &scaled(&second), 1),
                "{name}"
            );
        }
    }
}

/// Without lines there is no estimate; with lines but no hit there is one, and its error is not 0.
#[test]
fn no_hit_is_not_certainty() {
    let low = patch(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let far = patch(&[[0.0, 0.0, 1e6], [0.0, 1.0, 1e6], [1.0, 0.0, 1e6]]);
    assert_eq!(local_lines(&low, &far, 0, 1), None);
    assert_eq!(quasi_random_lines(&low, &far, 0, 1), None);
    assert_eq!(global_lines(&low, &far, 0, 1).form_factor(), None);
    for sample in [
        local_lines(&low, &far, 1000, 1),
        quasi_random_lines(&low, &far, 1000, 1),
    ] {
        let sample = sample.unwrap();
        assert_eq!(sample.value, 0.0);
        assert!(sample.standard_error > 5e-4, "{sample:?}");
    }
}

/// A half-plane over the middle line hides half of what two squares exchange, whatever its height;
/// one behind the second square, and one behind the first, hide nothing.
#[test]
fn lines_past_others_know_what_is_hidden() {
    let square = |x: [f64; 2], z: f64, is_up: bool| {
        let mut corners = [
            [x[0], 0.0, z],
            [x[1], 0.0, z],
            [x[1], 1.0, z],
            [x[0], 1.0, z],
        ];
        if !is_up {
            corners.reverse();
        }
        patch(&corners)
    };
    let [first, second] = [
        square([0.0, 1.0], 0.0, true),
        square([0.0, 1.0], 1.0, false),
    ];
    let bare = local_lines(&first, &second, 20_000, 3).unwrap();
    // Howell, C-11
    let exact = 0.199_824_895_698_387;
    for (z, share) in [
        (0.01, 0.5),
        (0.5, 0.5),
        (0.99, 0.5),
        (1.25, 1.0),
        (-0.25, 1.0),
    ] {
        let corners = [[0.5, -9.0, z], [0.5, 9.0, z], [9.0, 9.0, z], [9.0, -9.0, z]];
        let half = [patch(&corners)];
        let local = local_lines_past([&first, &second], &half, 20_000, 3).unwrap();
        let steady = quasi_random_lines_past([&first, &second], &half, 20_000, 3).unwrap();
        for sample in [local, steady] {
            let off = (sample.value - share * exact).abs();
            assert!(off <= 5.0 * sample.standard_error, "{z}: {sample:?}");
        }
        // the same lines
        assert_eq!(local == bare, share > 0.9, "{z}");
    }
}
