//! The best of all straight cuts of a square is perpendicular to the gradient (§4.2), if radiosity
//! and irradiance vary along it alone.

use infoscene::discretize::{GradientCut, StraightCut};
use infoscene::information::divergence;
use infoscene::numeric::integral;
use proptest::prelude::*;

fn patch(n: f64, m: f64) -> GradientCut {
    GradientCut::try_new(n, m).unwrap()
}

/// A straight cut across the gradient is the cut of the closed form, and one that hardly leans
/// nearly so.
#[test]
fn straight_cuts_agree_with_the_closed_form() {
    for (n, m) in [(1.0, 1.0), (3.0, 1.0), (2.0, 2.0), (0.5, 30.0), (1e3, 1.0)] {
        let patch = patch(n, m);
        let best = patch.mutual_information_cut().unwrap();
        let straight = StraightCut::try_new(0.0, best.position).unwrap();
        assert!(
            (straight.gain(&patch) / best.value - 1.0).abs() < 1e-9,
            "{n} {m}"
        );
        let found = StraightCut::best(0.0, &patch).unwrap();
        assert!((found.cut.offset() - best.position).abs() < 1e-9);
        let leaning = StraightCut::best(1e-5 / (n + m), &patch).unwrap();
        assert!((leaning.gain / best.value - 1.0).abs() < 1e-6, "{n} {m}");
    }
}

/// The gain by strips along the gradient instead of across: a strip at t is cut at `l = (c − t sin
/// θ)/cos θ`, within 0 and 1, and has the flux `l^(n+1)` and the weight `l^(n+m+1)` before the cut;
/// by quadrature between the kinks.
fn shares_by_strips(degrees: f64, offset: f64, n: f64, m: f64) -> [f64; 2] {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let reach = offset * (sine + cosine);
    let crossing = |t: f64| ((reach - t * sine) / cosine).clamp(0.0, 1.0);
    let kinks = [(reach - cosine) / sine, reach / sine].map(|t| t.clamp(0.0, 1.0));
    let share = |power: f64| -> f64 {
        let pieces = [(0.0, kinks[0]), (kinks[0], kinks[1]), (kinks[1], 1.0)];
        let pieces = pieces.into_iter().filter(|(from, to)| to > from);
        pieces
            .map(|ends| {
                integral(|t| crossing(t).powf(power), ends, 1e-13)
                    .unwrap()
                    .value
            })
            .sum()
    };
    let shares = [n + 1.0, n + m + 1.0].map(share);
    shares.map(|near| near.clamp(0.0, 1.0))
}

#[test]
fn straight_cuts_agree_with_quadrature_the_other_way() {
    for degrees in [1.0, 10.0, 30.0, 45.0, 60.0, 80.0, 89.0] {
        for offset in [0.05, 0.3, 0.5, 0.62, 0.9, 0.99] {
            for (n, m) in [(1.0, 1.0), (2.0, 2.0), (4.0, 1.0), (0.5, 7.0)] {
                let gain = StraightCut::try_new(degrees, offset)
                    .unwrap()
                    .gain(&patch(n, m));
                let [flux, weight] = shares_by_strips(degrees, offset, n, m);
                let strips = divergence(&[flux, 1.0 - flux], &[weight, 1.0 - weight]);
                // both shares to 1e-13 and more pieces than one; the gain's slopes are logarithms
                // and ratios of flux to weight
                let slope = 40.0 + flux / weight + (1.0 - flux) / (1.0 - weight);
                let left = (gain - strips).abs() / slope;
                assert!(left < 1e-12, "{degrees} {offset} {n} {m}: {left:e}");
            }
        }
    }
}

/// Cuts along the gradient gain nothing, and the best gain falls as the cut turns there.
#[test]
fn best_gain_falls_with_the_angle() {
    for (n, m) in [(1.0, 1.0), (4.0, 1.0), (4.0, 4.0), (30.0, 2.0)] {
        let patch = patch(n, m);
        let best = |degrees: u32| StraightCut::best(degrees.into(), &patch).unwrap().gain;
        let gains: Vec<f64> = (0..=90).map(best).collect();
        assert!(gains.windows(2).all(|pair| pair[1] < pair[0]), "{n} {m}");
        assert_eq!(gains[90], 0.0);
        let along = StraightCut::try_new(90.0, 0.3).unwrap().gain(&patch);
        assert!(along.abs() < 1e-28, "{along:e}");
    }
}

proptest! {
    /// No line gains more than the best one across: any angle, any offset, any exponents.
    #[test]
    fn no_line_beats_the_best_across_the_gradient(
        degrees in prop_oneof![0.0..=90.0, Just(0.0), Just(90.0), 0.0..1e-3, 89.99..=90.0],
        offset in prop_oneof![0.001..0.999, 0.9..0.99999],
        n in prop_oneof![0.01..10.0, 1.0..1000.0],
        m in prop_oneof![0.01..10.0, 1.0..1000.0],
    ) {
        let patch = patch(n, m);
        let best = patch.mutual_information_cut().unwrap().value;
        let gain = StraightCut::try_new(degrees, offset).unwrap().gain(&patch);
        prop_assert!(gain >= 0.0 && gain <= best * (1.0 + 1e-9), "{} > {}", gain, best);
    }
}

/// The highest gain over offsets of the lines at one angle, radiosity ∝ l and irradiance `H(l, t)`,
/// by midpoint sums.
fn best_by_sums(degrees: f64, irradiance: impl Fn(f64, f64) -> f64) -> f64 {
    const CELLS: u32 = 160;
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let middle = |k: u32| (f64::from(k) + 0.5) / f64::from(CELLS);
    let mut cells = Vec::new();
    for (i, j) in (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j))) {
        let (l, t) = (middle(i), middle(j));
        cells.push((l * cosine + t * sine, l, l * irradiance(l, t)));
    }
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total = cells
        .iter()
        .fold([0.0, 0.0], |sum, cell| [sum[0] + cell.1, sum[1] + cell.2]);
    let mut best = 0.0;
    let mut near = [0.0, 0.0];
    for pair in cells.windows(2) {
        near = [near[0] + pair[0].1, near[1] + pair[0].2];
        // cells on one line belong together
        if pair[1].0 - pair[0].0 > 1e-9 {
            let [flux, weight] = [0, 1].map(|k| near[k] / total[k]);
            best = f64::max(
                best,
                divergence(&[flux, 1.0 - flux], &[weight, 1.0 - weight]),
            );
        }
    }
    best
}

/// The sums see what the closed forms see; and the order of the irradiance along l does not matter
/// for straight cuts.
#[test]
fn best_line_is_perpendicular_for_any_irradiance_along_the_gradient() {
    let across = StraightCut::best(0.0, &patch(1.0, 1.0)).unwrap().gain;
    assert!((best_by_sums(0.0, |l, _| l) / across - 1.0).abs() < 1e-3);
    let unsorted: [fn(f64) -> f64; 3] = [
        |l| l,
        |l| 1.0 + 9.0 * (2.0 * l - 1.0).powi(2),
        |l| 1.0 + 5.0 * (7.0 * l).sin().powi(2),
    ];
    for irradiance in unsorted {
        let best = best_by_sums(0.0, |l, _| irradiance(l));
        for degrees in [10.0, 30.0, 45.0, 60.0, 80.0, 90.0] {
            assert!(best_by_sums(degrees, |l, _| irradiance(l)) < best);
        }
    }
}

/// The control: an irradiance that varies across the gradient of the radiosity, too, turns the best
/// cut; one that varies across it only lays it along.
#[test]
fn best_line_turns_with_an_irradiance_across_the_gradient() {
    let oblique = |l: f64, t: f64| l + 2.0 * t;
    let across = best_by_sums(0.0, oblique);
    let leaning = best_by_sums(60.0, oblique);
    assert!(leaning > 1.2 * across, "{leaning} {across}");
    assert!(best_by_sums(0.0, |_, t| t) < 1e-20 && best_by_sums(90.0, |_, t| t) > 0.05);
}

#[test]
fn lines_outside_of_the_square_are_refused() {
    for bad in [-1.0, 90.1, f64::NAN] {
        assert!(
            StraightCut::try_new(bad, 0.5).is_err()
                && StraightCut::best(bad, &patch(1.0, 1.0)).is_err()
        );
    }
    for bad in [0.0, 1.0, -0.1, f64::NAN] {
        assert!(StraightCut::try_new(45.0, bad).is_err());
    }
}
