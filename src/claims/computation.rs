//! The computations by name: one list, from which the names in the data and the calls are made.

use super::{Case, ClaimError, Finding};
use crate::claims::sections::{
    appendix, continuous_limit, figure_5, refinement, regular_grids, section_2, section_3,
    section_3_light, section_4_1, section_4_2, section_5, section_5_oracle, shadows,
};

macro_rules! computations {
    ($($variant:ident => $section:ident::$function:ident),+ $(,)?) => {
        /// A computation that claims name in their data; the name is that of its function.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
        #[serde(try_from = "String")]
        pub enum Computation {
            $(
                #[doc = concat!("`", stringify!($section), "::", stringify!($function), "`.")]
                $variant,
            )+
        }

        impl Computation {
            /// Every computation, in paper order.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// The name, as in the data.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => stringify!($function),)+
                }
            }

            /// The file of its function in `src/claims/sections`, without the ending.
            #[must_use]
            pub const fn section(self) -> &'static str {
                match self {
                    $(Self::$variant => stringify!($section),)+
                }
            }

            /// Computes a case.
            ///
            /// # Errors
            /// [`ClaimError`] if an input is missing or useless, or a routine refuses.
            pub fn compute(self, case: &Case<'_>) -> Result<Finding, ClaimError> {
                match self {
                    $(Self::$variant => $section::$function(case),)+
                }
            }
        }
    };
}

computations! {
    WalkConverges => section_2::walk_converges,
    AreasAreStationary => section_2::areas_are_stationary,
    FormFactorsAreReciprocal => section_2::form_factors_are_reciprocal,
    InformationIsADifference => section_2::information_is_a_difference,
    InformationIsMutual => section_2::information_is_mutual,
    ContinuousInformationIsADifference => continuous_limit::continuous_information_is_a_difference,
    DiscretizingLoses => continuous_limit::discretizing_loses,
    ContinuousLimitIsApproached => continuous_limit::continuous_limit_is_approached,
    ContinuousIsLeastUpperBound => continuous_limit::continuous_is_least_upper_bound,
    FinerRegularGridsKnowMore => continuous_limit::finer_regular_grids_know_more,
    Theorem1 => section_3::theorem_1,
    PairIncreasesAddUp => section_3::pair_increases_add_up,
    DestinationWeightDropsOut => section_3::destination_weight_drops_out,
    RegularForm => section_3::regular_form,
    SubdivisionBoundHolds => section_3::subdivision_bound_holds,
    SubdivisionBoundIsAttained => section_3::subdivision_bound_is_attained,
    BoundsSumToWeight => section_3::bounds_sum_to_weight,
    LargestWeightHasLargestPotential => section_3::largest_weight_has_largest_potential,
    SplitPatchesFulfilTheHypotheses => section_3::split_patches_fulfil_the_hypotheses,
    VisibilityBoundHolds => section_3::visibility_bound_holds,
    PrintedTotalIsAMaximum => section_3::printed_total_is_a_maximum,
    BoundsSumToArea => section_3::bounds_sum_to_area,
    LightRowsSumToOne => section_3_light::light_rows_sum_to_one,
    LightWeightsAreStationary => section_3_light::light_weights_are_stationary,
    LightWeightsSumToNormalisation => section_3_light::light_weights_sum_to_normalisation,
    LightIsReciprocal => section_3_light::light_is_reciprocal,
    DividedLightAddsUp => section_3_light::divided_light_adds_up,
    EvenLightIsVisibility => section_3_light::even_light_is_visibility,
    PrintedRowsOfLight => section_3_light::printed_rows_of_light,
    ContinuousLightExtendsDiscrete => section_3_light::continuous_light_extends_discrete,
    NullVarianceGathering => section_3_light::null_variance_gathering,
    NullVarianceShooting => section_3_light::null_variance_shooting,
    PotentialsSumToGeneralisedArea => section_5_oracle::potentials_sum_to_generalised_area,
    LightHasTheSameMeasures => section_3_light::light_has_the_same_measures,
    DiscontinuityBeatsDarkerCuts => section_4_1::discontinuity_beats_darker_cuts,
    DiscontinuityBeatsLitCuts => section_4_1::discontinuity_beats_lit_cuts,
    DiscontinuityBeatsLitCutsNearly => shadows::discontinuity_beats_lit_cuts_nearly,
    HangingScreensDarkenMostAtTheUmbra => shadows::hanging_screens_darken_most_at_the_umbra,
    StandingScreensCutAlongTheirLine => shadows::standing_screens_cut_along_their_line,
    OrthogonalCutGainsLittle => section_4_1::orthogonal_cut_gains_little,
    OrthogonalMiddleGainsNothing => section_4_1::orthogonal_middle_gains_nothing,
    BestParallelCut => section_4_1::best_parallel_cut,
    CurveHasOneMaximum => section_4_1::curve_has_one_maximum,
    BestCornerCut => section_4_1::best_corner_cut,
    OrthogonalSlopeExplainsTheShift => section_4_1::orthogonal_slope_explains_the_shift,
    BestThreeCellGrid => section_4_1::best_three_cell_grid,
    BestGridLiesNearerToTheEdges => section_4_1::best_grid_lies_nearer_to_the_edges,
    Figure4CasesLose => section_4_1::figure_4_cases_lose,
    BestGridInformation => section_4_1::best_grid_information,
    RegularGridInformation => regular_grids::regular_grid_information,
    ChosenGridInformation => figure_5::chosen_grid_information,
    BestGridBeatsRegularGrid => section_4_1::best_grid_beats_regular_grid,
    ObjectiveFollows => section_4_2::objective_follows,
    HighestInformationIsMostPrecise => section_4_2::highest_information_is_most_precise,
    BestCutIsPerpendicular => section_4_2::best_cut_is_perpendicular,
    InformationCut => section_4_2::information_cut,
    PolynomialFollows => section_4_2::polynomial_follows,
    MeanSquareCut => section_4_2::mean_square_cut,
    CutsAreNear => section_4_2::cuts_are_near,
    PrintedWeightsAreNotNormalised => section_5::printed_weights_are_not_normalised,
    PrintedGainIsProportional => section_5::printed_gain_is_proportional,
    PrintedMaximumIsProportional => section_5_oracle::printed_maximum_is_proportional,
    MaximumIsProportionalToPotential => section_5_oracle::maximum_is_proportional_to_potential,
    PotentialIsFarFromRealGain => section_5::potential_is_far_from_real_gain,
    GainGrowsWithGradient => section_5_oracle::gain_grows_with_gradient,
    DiscardedPairsGainLittle => section_5_oracle::discarded_pairs_gain_little,
    LargerAreaHasLargerBound => section_5_oracle::larger_area_has_larger_bound,
    PickedPatchHasHigherPotential => section_5_oracle::picked_patch_has_higher_potential,
    GradientGuaranteesGain => section_5_oracle::gradient_guarantees_gain,
    PotentialIsPowerTimesRatio => section_5_oracle::potential_is_power_times_ratio,
    ExactGainCostsMore => section_5::exact_gain_costs_more,
    PrintedGainIsUnstable => section_5::printed_gain_is_unstable,
    KernelsEstimateTheGradient => refinement::kernels_estimate_the_gradient,
    FullGainBeatsPotential => refinement::full_gain_beats_potential,
    OracleBeatsUniformMeshes => refinement::oracle_beats_uniform_meshes,
    InformationCutsHaveLeastError => refinement::information_cuts_have_least_error,
    UnlistedPremisesFollow => appendix::unlisted_premises_follow,
    Equation9 => appendix::equation_9,
    Equation10 => appendix::equation_10,
    Equation11 => appendix::equation_11,
    LogSumInequality => appendix::log_sum_inequality,
    Equation13 => appendix::equation_13,
    Inequality14 => appendix::inequality_14,
    MeshGainIsTheBound => appendix::mesh_gain_is_the_bound,
    ALitCutCanBeatTheLine => appendix::a_lit_cut_can_beat_the_line,
    PenumbraCutsBeatBothLines => shadows::penumbra_cuts_beat_both_lines,
    PlateIsBestCutBesideItsLines => shadows::plate_is_best_cut_beside_its_lines,
}

impl TryFrom<String> for Computation {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        let found = Self::ALL
            .iter()
            .find(|computation| computation.name() == name);
        let unknown = || format!("there is no computation \"{name}\"");
        found.copied().ok_or_else(unknown)
    }
}

impl Computation {
    /// The cells a side of the best grid that this computation shares with others, if it does.
    ///
    /// It decides only which claims are judged one after another: those that share a grid.
    pub(super) fn shared_grid(self, case: &Case<'_>) -> Option<u32> {
        match self {
            Self::BestThreeCellGrid | Self::Figure4CasesLose => Some(3),
            Self::BestGridLiesNearerToTheEdges
            | Self::BestGridInformation
            | Self::BestGridBeatsRegularGrid => case.count("cells").ok(),
            _ => None,
        }
    }
}
