"""The cuts of a face that gain the most."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from . import _infoscene
from ._arguments import (
    Call,
    Chain,
    Channel,
    Face,
    FaceValues,
    Light,
    Listener,
    face_name,
    faces_named,
)
from ._meshes import MeshLike, Obstacles, scene_of
from ._results import Column


class Enclosure(NamedTuple):
    """Decimal bounds of the best cut, and what is proved about it."""

    position: tuple[str, str]
    """The lower and the upper bound of the position."""
    gain: tuple[str, str]
    """The lower and the upper bound of the gain, in bits."""
    certificate: str
    """The statement that is proved."""


@dataclass(frozen=True, eq=False)
class BestSplit:
    """The cut of a face that gains the most mutual information."""

    face: int
    """The number of the face."""
    axis: str
    """The axis across which it is cut: ``"u"`` from corner 0 to corner 1, or ``"v"``."""
    position: float
    """The relative position of the first cut, from corner 0."""
    positions: Column
    """The relative positions of all cuts."""
    position_error: float
    """The absolute error of a position."""
    gain: float
    """The gain, in bits."""
    gain_relative_error: float
    """The relative error of a gain."""
    gain_at_middle: float
    """The gain of equal parts, in bits."""
    maximum_gain: float
    """The largest gain that equal parts could bring at all, in bits."""
    residual: float
    """The largest derivative of the gain that is left, in bits."""
    enclosure: Enclosure | None
    """The enclosure, if it was asked for."""
    notes: list[str] = field(repr=False)
    """Remarks on the mesh."""


def best_split(
    mesh: MeshLike,
    face: Face = 0,
    *,
    obstacles: Obstacles = None,
    against: Face | Iterable[Face] | None = None,
    axis: Literal["u", "v"] | None = None,
    parts: int = 2,
    precision: int | None = None,
    chain: Chain = "visibility",
    channel: Channel | None = None,
    reflectance: FaceValues | None = None,
    emittance: FaceValues | None = None,
    importance: FaceValues | None = None,
    threads: int | None = None,
    progress: Listener | None = None,
) -> BestSplit:
    """Finds the cut of a face that gains the most mutual information.

    >>> import infoscene
    >>> cut = infoscene.best_split("two-squares")  # the paper's fig. 2, which prints 0.40
    >>> cut.axis, round(cut.position, 9)  # enclosed by a proof in Coq: 0.39920102604538512…
    ('u', 0.399201026)
    >>> infoscene.best_split("two-squares", precision=80).enclosure.position[0][:14]
    '0.399201026045'

    Parameters
    ----------
    mesh, obstacles, threads, progress
        As of `form_factors`.
    face
        The face to cut: a number, or a name in a file.
    against
        The faces it is judged against; all others unless given.
    axis
        The axis across which it is cut: ``"u"`` runs from corner 0 to corner 1, ``"v"`` from corner
        0 to the last; the better one unless given.
    parts
        The number of parts.
    precision
        Bits to which the best cut and its gain are enclosed, and proved to be the best.
    chain, channel, reflectance, emittance, importance
        As of `mutual_information`.

    Raises
    ------
    ValueError
        If the face cannot be cut so, or nothing can be enclosed.
    """
    found = _infoscene.best_split(
        scene_of(mesh, obstacles),
        face_name(face),
        faces_named(against),
        axis,
        parts,
        precision,
        Light.of(reflectance, emittance, importance, chain=chain, channel=channel),
        Call.of(threads, progress),
    )
    enclosed = found.pop("enclosures")
    enclosure = None
    if enclosed is not None:
        position, gain = (
            (one["lower"], one["upper"]) for one in (enclosed["position"], enclosed["gain"])
        )
        enclosure = Enclosure(position, gain, enclosed["certificate"])
    return BestSplit(enclosure=enclosure, **found)
