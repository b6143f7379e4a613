//! No claim of the paper is missing from the registry.

use infoscene::claims::registry;

/// What must be there at least, in paper order, by the beginning of the id.
const REQUIRED: [&str; 61] = [
    "s1-optimum",
    "s2-convergence",
    "s2-areas-are-stationary",
    "s2-reciprocity",
    "eq1-eq2-eq3",
    "eq4-limit",
    "s2-discrete-below-continuous",
    "s2-radiosity-complexity",
    "theorem-1",
    "corollary-1",
    "eq5-first-line",
    "eq5-second-line",
    "eq5-regular",
    "eq6-bound",
    "eq6-attained",
    "eq6-sum",
    "s32-largest-weight",
    "s33-hypotheses",
    "eq7",
    "eq7-maximum",
    "eq7-maximum-total",
    "s34-rows",
    "s34-equilibrium",
    "s34-reciprocity",
    "s34-hypotheses",
    "s34-reversion",
    "s34-discrete-weights",
    "s34-discrete-transitions",
    "s34-null-variance-gathering",
    "s35-rows",
    "s35-equilibrium",
    "s35-reciprocity",
    "s35-hypotheses",
    "s35-reversion",
    "s35-discrete",
    "s35-null-variance-shooting",
    "fig1-dark-part",
    "fig1-lit-part",
    "fig2-orthogonal-small",
    "fig2-orthogonal-middle",
    "fig2-parallel-cut",
    "fig3-cut",
    "fig3-displacement",
    "fig4-optimum",
    "fig4-displaced",
    "fig5-optimal",
    "fig5-regular",
    "fig5-bad",
    "fig5-order",
    "s42-objective",
    "s42-across-the-gradient",
    "s42-information-cut",
    "s42-polynomial",
    "s42-mean-square-cut",
    "s42-very-near",
    "s5-gain-for-constant-radiosity",
    "s5-potential-against-real-gain",
    "s5-step",
    "s6-",
    "eq9",
    "eq14",
];

#[test]
fn no_claim_is_missing() {
    let ids: Vec<String> = registry()
        .unwrap()
        .into_iter()
        .map(|claim| claim.id)
        .collect();
    let mut last = 0;
    for required in REQUIRED {
        let found = ids.iter().position(|id| id.starts_with(required));
        let found = found.unwrap_or_else(|| panic!("no claim {required}…"));
        assert!(
            found >= last,
            "{required} stands before its place in the paper"
        );
        last = found;
    }
    assert!(ids.len() >= 89, "only {} claims", ids.len());
}

/// The twelve numbers of the results section, as printed.
#[test]
fn every_printed_number_of_the_results_is_there() {
    let printed: Vec<String> = registry()
        .unwrap()
        .into_iter()
        .filter_map(|claim| Some(claim.printed?.text))
        .collect();
    let figures = ["0.40", "0.39", "6", "1.3569", "1.3331", "1.2554"];
    let cuts = [
        "0.48", "0.61", "0.68", "0.74", "0.5", "0.64", "0.72", "0.77",
    ];
    assert_eq!(printed, [figures.as_slice(), cuts.as_slice()].concat());
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
