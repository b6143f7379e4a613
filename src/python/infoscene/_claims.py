"""The claims of the paper."""

from dataclasses import dataclass, field

from . import _infoscene
from ._arguments import Call, Listener


@dataclass(frozen=True, eq=False)
class Claim:
    """A claim of the paper, the number behind it and the verdict."""

    id: str
    """The short name of the claim."""
    place: str
    """The place in the paper."""
    quantity: str
    """The statement, in other words."""
    printed: float | None
    """The printed number; none for a claim in words."""
    computed: float | None
    """The number computed."""
    error: float | None
    """The absolute error of the number computed."""
    lower: str | None
    """The lower end of an enclosure, with every certified digit."""
    upper: str | None
    """The upper end of an enclosure, likewise."""
    evidence: str | None
    """The grade of the evidence: ``"proof"``, ``"enclosure"``, ``"bound"``, ``"estimate"``, …"""
    verdict: str
    """``"confirmed"``, ``"supported"``, ``"refuted"``, ``"undecided"`` or ``"not_checked"``."""
    recorded: str
    """The verdict on record."""
    note: str = field(repr=False)
    """A note for the reader."""


def reproduce(
    *claims: str,
    printed_only: bool = False,
    precision: int | None = None,
    threads: int | None = None,
    progress: Listener | None = None,
) -> list[Claim]:
    """Computes the claims of the paper and judges them, in paper order.

    >>> import infoscene
    >>> claim, = infoscene.reproduce("fig2-parallel-cut")
    >>> claim.printed, claim.verdict
    (0.4, 'confirmed')
    >>> round(claim.computed, 12)  # enclosed by a proof in Coq: 0.39920102604538512…
    0.399201026045

    Parameters
    ----------
    claims
        Their ids; all if none is named, which takes some seconds.
    printed_only
        Whether only claims that print a number are meant.
    precision
        Bits of the ends of enclosures.
    threads, progress
        As of `form_factors`.

    Raises
    ------
    ValueError
        If there is no claim of a name.
    """
    found = _infoscene.reproduce(list(claims), printed_only, precision, Call.of(threads, progress))
    return [Claim(**{key: one[key] for key in Claim.__dataclass_fields__}) for one in found]
