//! Changes that leave a grid's mutual information alone: units, the order of axes, mirror images.

use super::{edges, grid, lines};
use crate::support::intervals::cases;
use proptest::prelude::*;

proptest! {
    #![proptest_config(cases(32))]

    /// Lengths have no unit.
    #[test]
    fn units_do_not_matter(edges in edges(), lines in lines(4), power in -100..=100) {
        let unit = 10f64.powi(power);
        let here = grid(edges, &lines).information().unwrap();
        let there = grid(edges.map(|edge| unit * edge), &lines)
            .information()
            .unwrap();
        let (one, other) = (here.mutual_information, there.mutual_information);
        let difference = one.value - other.value;
        prop_assert!(
            difference.abs() <= one.error + other.error,
            "{difference:e}"
        );
        // powers of two change no bit
        let twice = grid(edges.map(|edge| 2f64.powi(power) * edge), &lines)
            .information()
            .unwrap();
        prop_assert_eq!(here, twice);
    }

    /// Axes may be named in any order.
    #[test]
    fn axes_may_trade_places([x, y, z] in edges(), lines in lines(4)) {
        let here = grid([x, y, z], &lines).information().unwrap();
        for edges in [[x, z, y], [y, x, z], [y, z, x], [z, x, y], [z, y, x]] {
            let there = grid(edges, &lines).information().unwrap();
            let (one, other) = (here.mutual_information, there.mutual_information);
            let difference = one.value - other.value;
            prop_assert!(
                difference.abs() <= one.error + other.error,
                "{difference:e}"
            );
            prop_assert_eq!(here.classes, there.classes);
        }
    }

    /// A box may be seen from its other end.
    #[test]
    fn mirror_images_say_as_much(edges in edges(), lines in lines(4)) {
        let mirrored: Vec<f64> = lines.iter().rev().map(|line| 1.0 - line).collect();
        let here = grid(edges, &lines).information().unwrap();
        let there = grid(edges, &mirrored).information().unwrap();
        let (one, other) = (here.mutual_information, there.mutual_information);
        let difference = one.value - other.value;
        // 1 − t is rounded, which narrow cells notice most: 1e-4 of an edge moves by 1e-12 of
        // itself
        prop_assert!(
            difference.abs() <= one.error + other.error + 1e-14,
            "{difference:e}"
        );
    }

    /// One more line says more (Theorem 1).
    #[test]
    fn one_more_line_says_more(edges in edges(), lines in lines(4), at in 0.01..0.99_f64) {
        let here = grid(edges, &lines).information().unwrap();
        let mut more = lines.clone();
        let place = more.partition_point(|line| *line < at);
        prop_assume!(more.iter().all(|line| (line - at).abs() > 1e-3));
        more.insert(place, at);
        let there = grid(edges, &more).information().unwrap();
        let (one, other) = (here.mutual_information, there.mutual_information);
        let gain = other.value - one.value;
        prop_assert!(gain > -(one.error + other.error), "{gain:e}");
    }
}
