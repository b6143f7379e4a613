//! Enclosures in records: their ends as decimal numbers, with every certain digit.

use crate::numeric::Interval;
use serde::{Serialize, Serializer};

/// Serializes the ends of an enclosure as decimal numbers; null for one without bounds.
pub(super) fn ends<S: Serializer>(enclosure: &Interval, serializer: S) -> Result<S::Ok, S::Error> {
    enclosure.every_decimal().serialize(serializer)
}

/// Serializes the ends of several enclosures as decimal numbers.
pub(super) fn all_ends<S: Serializer>(
    enclosures: &[Interval],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(enclosures.iter().map(Interval::every_decimal))
}

/// Serializes the ends of an enclosure with 60 decimals at most.
#[cfg(feature = "report")]
pub(super) fn ends_to_60<S: Serializer>(
    enclosure: &Interval,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    enclosure.to_decimal(60).serialize(serializer)
}
