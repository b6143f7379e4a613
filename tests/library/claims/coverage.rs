//! No claim of the paper is missing from the registry.

use infoscene::claims::{Case, Computation, Context, Inputs, registry};

/// Every claim, in paper order.
const CLAIMS: [&str; 116] = [
    "s1-optimum-is-highest-information",
    "s1-optimum-has-least-error",
    "s2-convergence-to-stationary",
    "s2-areas-are-stationary",
    "s2-continuous-chain",
    "s2-reciprocity",
    "eq1-eq2-eq3-difference",
    "s2-continuous-difference",
    "s2-information-is-mutual",
    "s2-discretizing-loses",
    "s2-finer-grids-know-more",
    "eq4-limit",
    "s2-discrete-below-continuous",
    "s2-discrete-below-for-planar-patches",
    "s2-radiosity-complexity",
    "s3-most-precise-has-highest-information",
    "theorem-1",
    "corollary-1",
    "eq5-first-line",
    "eq5-second-line",
    "eq5-regular",
    "eq6-bound",
    "eq6-attained",
    "eq6-sum",
    "eq6-sum-is-a-maximum",
    "s32-largest-weight",
    "s33-hypotheses",
    "eq7",
    "eq7-maximum",
    "eq7-maximum-total",
    "eq7-total-is-a-maximum",
    "s34-extends-null-variance",
    "s34-rows-sum-to-one",
    "s34-equilibrium",
    "s34-normalisation",
    "s34-reciprocity",
    "s34-hypotheses",
    "s34-reversion",
    "s34-discrete-weights",
    "s34-weights-without-total",
    "s34-discrete-transitions",
    "s34-null-variance-gathering",
    "s35-rows-sum-to-one",
    "s35-equilibrium",
    "s35-reciprocity",
    "s35-hypotheses",
    "s35-reversion",
    "s35-discrete",
    "s35-null-variance-shooting",
    "fig1-dark-part",
    "fig1-lit-part",
    "fig1-lit-part-nearly",
    "fig1-dark-part-in-scenes",
    "fig1-lit-part-in-scenes",
    "fig2-orthogonal-small",
    "fig2-orthogonal-middle",
    "fig2-parallel-cut",
    "fig2-curve",
    "fig3-cut",
    "fig3-curve",
    "fig3-displacement",
    "fig4-optimum",
    "fig4-displaced-towards-the-edges",
    "fig4-cases",
    "fig5-optimal",
    "fig5-regular",
    "fig5-bad",
    "fig5-order",
    "s42-objective",
    "s42-across-the-gradient",
    "s42-information-cut-1",
    "s42-information-cut-2",
    "s42-information-cut-3",
    "s42-information-cut-4",
    "s42-highest-information-cut-1",
    "s42-highest-information-cut-2",
    "s42-highest-information-cut-3",
    "s42-highest-information-cut-4",
    "s42-polynomial",
    "s42-mean-square-cut-1",
    "s42-mean-square-cut-2",
    "s42-mean-square-cut-3",
    "s42-mean-square-cut-4",
    "s42-very-near",
    "s5-gain-for-constant-radiosity",
    "s5-maximum-for-constant-radiosity",
    "s5-maximum-is-proportional",
    "s5-potential-against-real-gain",
    "s5-gain-grows-with-gradient",
    "s5-sum-is-generalised-area",
    "s5-largest-generalised-area",
    "s5-step-1",
    "s5-step-2",
    "s5-step-2-highest-potential",
    "s5-step-3",
    "s5-cheap-gradient",
    "s5-analogy-with-power-oracle",
    "s5-unstable-logarithms",
    "s5-printed-gain-is-unstable",
    "s5-full-gain-is-the-better-oracle",
    "s6-theorem-with-applications",
    "s6-cuts-across-gradients",
    "s6-evidence-on-error",
    "s6-oracle-is-useful",
    "s6-minimises-error",
    "appA-premises",
    "eq9",
    "eq10",
    "eq11",
    "eq12",
    "eq13",
    "eq14",
    "eq14-mesh",
    "appB2-limit",
    "appB2-penumbra",
    "appB2-plate",
];

#[test]
fn no_claim_is_missing() {
    let ids: Vec<String> = registry()
        .unwrap()
        .into_iter()
        .map(|claim| claim.id)
        .collect();
    assert_eq!(ids, CLAIMS);
}

/// The numbers of the results section, as printed.
#[test]
fn every_printed_number_of_the_results_is_there() {
    let printed: Vec<String> = registry()
        .unwrap()
        .into_iter()
        .filter_map(|claim| Some(claim.printed?.text))
        .collect();
    let figures = ["0.40", "0.39", "6", "1.3569", "1.3331", "1.2554"];
    // of the expression printed, and under the hypotheses
    let cuts = ["0.48", "0.61", "0.68", "0.74"];
    let squares = ["0.5", "0.64", "0.72", "0.77"];
    let all = [figures.as_slice(), &cuts, &cuts, &squares];
    assert_eq!(printed, all.concat());
}

/// Places name a section, equation or figure; quantities are no sentences of the paper.
#[test]
fn every_claim_has_its_place() {
    for claim in registry().unwrap() {
        assert!(
            claim.place.contains('§') || claim.place.starts_with("App."),
            "{}",
            claim.id
        );
        assert!(
            claim.quantity.len() > 15 && !claim.quantity.ends_with('.'),
            "{}",
            claim.id
        );
    }
}

/// A name in the data that no function has fails when the data are read.
#[test]
fn computations_are_known_by_their_names_alone() {
    for computation in Computation::ALL {
        let found = Computation::try_from(computation.name().to_owned());
        assert_eq!(found.as_ref(), Ok(computation));
    }
    assert!(Computation::try_from("theorem_2".to_owned()).is_err());
}

/// A switch is `true` or `false`, never a number, and no number is a switch.
#[test]
fn switches_and_numbers_are_told_apart() {
    let inputs: Inputs = serde_json::from_str(r#"{"uniform": true, "line": 1}"#).unwrap();
    let context = Context::default();
    let case = Case::new(inputs, &context);
    assert_eq!(case.switch("uniform"), Ok(true));
    assert_eq!(case.count("line"), Ok(1));
    assert!(case.switch("line").is_err());
    assert!(case.number("uniform").is_err());
    assert!(case.number("missing").is_err());
}
