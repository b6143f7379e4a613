//! The verdict on a claim; which one a finding gets is said by the [rule](Verdict::of).

/// The verdict on a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// An enclosure lies inside what is printed, or a proof stands.
    Confirmed,
    /// An estimate agrees within its stated error.
    Supported,
    /// An enclosure is disjoint from what is printed, and the paper states the configuration.
    Refuted,
    /// Anything else that was computed.
    Undecided,
    /// Not computed.
    NotChecked,
}

impl Verdict {
    /// All verdicts.
    pub const ALL: [Self; 5] = [
        Self::Confirmed,
        Self::Supported,
        Self::Refuted,
        Self::Undecided,
        Self::NotChecked,
    ];

    /// The word used in tables and in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Confirmed => "confirmed",
            Self::Supported => "supported",
            Self::Refuted => "refuted",
            Self::Undecided => "undecided",
            Self::NotChecked => "not_checked",
        }
    }

    /// The meaning of the verdict, in half a sentence.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Confirmed => "an enclosure lies inside what is printed, or a proof stands",
            Self::Supported => "an estimate agrees within its stated error; nothing stronger yet",
            Self::Refuted => {
                "an enclosure is disjoint, and the paper states the configuration completely"
            }
            Self::Undecided => "anything else, with the reason",
            Self::NotChecked => "not computed yet, with the reason",
        }
    }

    /// The verdict on a statement that says several things, from the verdicts on each: refuted with
    /// one of them, and no better settled than the least settled.
    #[must_use]
    pub fn of_all(verdicts: &[Self]) -> Self {
        let by_rank = [
            Self::Refuted,
            Self::NotChecked,
            Self::Undecided,
            Self::Supported,
        ];
        let worst = by_rank.into_iter().find(|rank| verdicts.contains(rank));
        worst.unwrap_or(Self::Confirmed)
    }

    /// The verdict where a theorem alone decides.
    pub(super) const fn of_proof(is_refuted: bool) -> Self {
        if is_refuted {
            Self::Refuted
        } else {
            Self::Confirmed
        }
    }
}
