"""Information of a scene's chain."""

from dataclasses import dataclass, field
from typing import Any

from . import _infoscene
from ._arguments import Accuracy, Call, Chain, Channel, FaceValues, Light, Listener
from ._meshes import MeshLike, Obstacles, scene_of
from ._results import Column, warn


@dataclass(frozen=True, eq=False)
class MutualInformation:
    """The information of a scene's chain, in bits; ``float(…)`` is the mutual information."""

    bits: float
    """Mutual information, eq. (3)."""
    error: float
    """The absolute error of the value, of this grade."""
    grade: str
    """``"bound"`` or ``"estimate"``."""
    positional_entropy: float
    """Positional entropy, eq. (1)."""
    entropy_rate: float
    """Entropy rate, eq. (2)."""
    closed: bool
    """Do all rows of form factors sum to one?"""
    total_area: float
    """The sum of the areas."""
    contributions: Column = field(repr=False)
    """The terms of the faces in the mutual information."""
    weights: Column = field(repr=False)
    """The stationary probabilities of the faces."""
    row_sums: Column = field(repr=False)
    """The sums of rows of form factors."""
    outside_contribution: float | None
    """The term of the state outside, if there is one."""
    resolution: float
    """The length by which each coordinate may be off."""
    resolution_error: float | None
    """A bound on what that can change of the mutual information; none where none is known."""
    names: list[str] = field(repr=False)
    """The names of the faces."""
    notes: list[str] = field(repr=False)
    """Remarks on the mesh."""

    def __float__(self) -> float:
        return self.bits

    def cell_data(self) -> dict[str, Column]:
        """Columns for ``mesh.cell_data.update(…)``."""
        return {"mutual_information": self.contributions, "row_sum": self.row_sums}


@dataclass(frozen=True, eq=False)
class ContinuousInformation:
    """The continuous mutual information, in bits, beside that of the mesh; ``float(…)`` is it."""

    bits: float
    """Continuous mutual information, eq. (4)."""
    error: float
    """The absolute error of the value, of this grade; of a sample a standard error."""
    grade: str
    """``"estimate"``, or ``"sample"`` where something stands in the way."""
    lower_bound: float | None
    """A lower bound, if it is sampled: the discrete one less its error."""
    lines: int | None
    """The number of random lines, if it is sampled."""
    discrete: MutualInformation
    """The information of the mesh: what it does not lose."""

    def __float__(self) -> float:
        return self.bits


def mutual_information(
    mesh: MeshLike,
    *,
    obstacles: Obstacles = None,
    chain: Chain = "visibility",
    channel: Channel | None = None,
    reflectance: FaceValues | None = None,
    emittance: FaceValues | None = None,
    importance: FaceValues | None = None,
    open: bool = False,
    tolerance: float | None = None,
    absolute: float | None = None,
    congruence: bool = True,
    threads: int | None = None,
    progress: Listener | None = None,
) -> MutualInformation:
    """Computes entropies and mutual information of a scene's chain, in bits.

    ::

        w_i = A_i / A_T,  I = Σ_i Σ_j w_i F_ij log₂(F_ij / w_j)

    It holds no matrix: memory grows with the faces, not with their pairs.

    >>> import infoscene
    >>> I = infoscene.mutual_information("cube:1")
    >>> round(I.bits, 12), I.grade  # one patch per face, with 50 digits without this program
    (0.263034544099, 'bound')

    Parameters
    ----------
    mesh, obstacles, tolerance, absolute, congruence, threads, progress
        As of `form_factors`.
    chain
        ``"visibility"``, or the chain weighted with the radiosities (§3.4), or with the reflected
        importances (§3.5), which take light.
    channel
        ``"r"``, ``"g"`` or ``"b"``: that of coloured light must be named.
    reflectance, emittance, importance
        The light: a number, an array with one for each face, or a dictionary by face.
    open
        Whether what meets no face goes to one more state, ``outside``; otherwise an open scene is
        refused.

    Raises
    ------
    ValueError
        If the scene is open and ``open`` is false; if a reflectance is not from 0 to 1.
    """
    light = Light.of(reflectance, emittance, importance, chain=chain, channel=channel)
    found = _measured(
        mesh,
        obstacles,
        Accuracy(tolerance, absolute, congruence),
        light,
        (open, False),
        Call.of(threads, progress),
    )
    warn(found)
    return _information(found)


def continuous_information(
    mesh: MeshLike,
    *,
    obstacles: Obstacles = None,
    tolerance: float | None = None,
    threads: int | None = None,
    progress: Listener | None = None,
) -> ContinuousInformation:
    """Computes the continuous mutual information of a closed room: the limit of ever finer meshes.

    In a room that is convex inside it is an integral over its faces; where something stands in the
    way it is sampled by a million random lines, and its error is a standard error.

    >>> import infoscene
    >>> room = infoscene.continuous_information("cube:4")
    >>> bool(room.discrete.bits < room.bits), room.grade  # never less: Corollary 1
    (True, 'estimate')

    Parameters
    ----------
    mesh, obstacles, tolerance, threads, progress
        As of `form_factors`.

    Raises
    ------
    ValueError
        If the room is not closed.
    """
    light = Light.of(None, None, None)
    found = _measured(
        mesh,
        obstacles,
        Accuracy(tolerance, None, True),
        light,
        (False, True),
        Call.of(threads, progress),
    )
    warn(found)
    return ContinuousInformation(
        bits=found["continuous"],
        error=found["continuous_error"],
        grade=found["continuous_grade"],
        lower_bound=found["lower_bound"],
        lines=found["lines"],
        discrete=_information(found),
    )


def _measured(
    mesh: MeshLike,
    obstacles: Obstacles,
    accuracy: Accuracy,
    light: Light,
    asked: tuple[bool, bool],
    call: Call,
) -> dict[str, Any]:
    return _infoscene.measure(scene_of(mesh, obstacles), accuracy, light, *asked, call)


def _information(found: dict[str, Any]) -> MutualInformation:
    names = set(MutualInformation.__dataclass_fields__) - {"bits"}
    return MutualInformation(
        bits=found["mutual_information"], **{name: found[name] for name in names}
    )
