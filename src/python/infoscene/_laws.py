"""The laws of form factors, checked on a matrix from anywhere."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _infoscene
from ._arrays import floats


class Broken(NamedTuple):
    """A law that a matrix breaks."""

    law: str
    """``"range"``, ``"row sum"`` or ``"reciprocity"``."""
    cases: int
    """Entries, rows or pairs that break it."""
    worst: tuple[int, ...]
    """The worst of them: a row, or a row and a column."""
    excess: float
    """By how much, beyond what is allowed, in the unit of a form factor."""
    told: str
    """The worst one in words."""


@dataclass(frozen=True, eq=False)
class MatrixLaws:
    """The laws that a matrix of form factors obeys or breaks; true if it breaks none."""

    broken: tuple[Broken, ...]
    """The laws that are broken: what no rounding within the bounds explains."""
    closed: bool
    """Do all rows sum to one? An open scene breaks no law by that."""
    transposed: bool
    """Is this the transpose, with ``F[i, j]`` from j to i, as pyviewfactor has it? It breaks
    reciprocity, and its transpose does not."""
    row_sums: NDArray[np.float64] = field(repr=False)
    """The sums of the rows."""
    worst_row: int
    """The row whose sum is farthest from one."""
    largest_reciprocity_error: float
    """The largest ``|A_i F_ij − A_j F_ji| / min(A_i, A_j)``, allowed or not."""

    def __bool__(self) -> bool:
        return not self.broken

    def __str__(self) -> str:
        rows = "closed" if self.closed else "open"
        worst = self.row_sums[self.worst_row] if len(self.row_sums) else 1.0
        head = f"rows are {rows}: the sum farthest from 1 is {worst:.12g}, of face {self.worst_row}"
        lines = [
            head,
            *(f"{one.law} is broken {one.cases} times: {one.told}" for one in self.broken),
        ]
        if self.transposed:
            lines.append(
                "the transpose obeys reciprocity: F[i, j] seems to be from j to i, use F.T"
            )
        if not self.broken:
            lines.append("no law is broken")
        return "\n".join(lines)


def check_form_factors(
    values: ArrayLike, areas: ArrayLike, *, bounds: ArrayLike | None = None
) -> MatrixLaws:
    """Checks the laws of form factors on a matrix from anywhere, ``values[i, j]`` from i to j.

    ::

        range         0 ≤ F_ij ≤ 1
        row sum       Σ_j F_ij ≤ 1             = 1 in a closed scene
        reciprocity   A_i F_ij = A_j F_ji

    Each is allowed what the bounds on the errors explain, and the rounding of sums. If reciprocity
    holds for the transpose only, the matrix is said to be transposed: pyviewfactor's is.

    >>> import infoscene
    >>> F = infoscene.form_factors("cube:2")
    >>> bool(infoscene.check_form_factors(F.values, F.areas, bounds=F.bounds))
    True

    Parameters
    ----------
    values
        The matrix, square.
    areas
        The area of each face.
    bounds
        Bounds on the absolute errors of the entries, one for all or one for each; without them
        1e-12 is taken.

    Raises
    ------
    ValueError
        If the shapes do not fit, an area is not > 0, or a number is NaN.
    """
    matrix = floats(values, "values")
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1]:
        raise ValueError(f"values: the shape is {matrix.shape}: give a square matrix")
    sizes = floats(areas, "areas")
    if sizes.shape != matrix.shape[:1]:
        raise ValueError(
            f"areas: the shape is {sizes.shape}: give one for each of {len(matrix)} rows"
        )
    allowed = floats(1e-12 if bounds is None else bounds, "bounds")
    if allowed.ndim != 0 and allowed.shape != matrix.shape:
        raise ValueError(f"bounds: the shape is {allowed.shape}: give one, or a matrix like values")
    allowed = np.require(np.broadcast_to(allowed, matrix.shape), np.float64, ["C", "A"])
    found = _infoscene.matrix_laws(matrix, sizes, allowed)
    broken = [Broken(**one) for one in found.pop("broken")]
    return MatrixLaws(broken=tuple(one._replace(worst=tuple(one.worst)) for one in broken), **found)
