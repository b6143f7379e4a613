"""Form factors of a mesh's faces, and of points."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _infoscene
from ._arguments import Accuracy, Call, Face, Listener, face_name
from ._arrays import points as coordinates
from ._laws import MatrixLaws, check_form_factors
from ._meshes import MeshLike, Obstacles, scene_of
from ._results import Column, warn


@dataclass(frozen=True, eq=False, repr=False)
class FormFactors:
    """Form factors: ``F[i, j]`` is from face i to face j, the part of what leaves i that meets j.

    ``F @ B`` is the irradiance of radiosities ``B``; rows of a closed room sum to 1;
    ``areas[i] * F[i, j] == areas[j] * F[j, i]`` up to the bounds; ``numpy.asarray(F)`` is the
    matrix.
    """

    values: Column
    """The form factors, a row for each face that sends."""
    bounds: Column
    """Bounds on their absolute errors, for the coordinates as they are."""
    areas: Column
    """The areas of all faces."""
    row_sums: Column | None
    """The sums of all rows, if all are known: 1 where nothing escapes."""
    row_sum_bounds: Column | None
    """Bounds on the errors of the sums."""
    rows: list[int]
    """The faces that send, one for each row: all, or those of ``sender``."""
    columns: list[int]
    """The faces that receive, one for each column."""
    names: list[str]
    """The names of all faces."""
    resolution: float
    """The length by which each coordinate may be off, 0 if they are exact."""
    resolution_bounds: Column | None
    """Bounds on what that can change, beside the errors; none if coordinates are exact."""
    notes: list[str]
    """Remarks on the mesh: what was mended, what has no effect."""

    def __getitem__(self, index: Any) -> Any:
        return self.values[index]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        array = self.values if dtype is None else self.values.astype(dtype, copy=False)
        return array.copy() if copy else array

    def __matmul__(self, other: Any) -> Any:
        return self.values @ other

    def __len__(self) -> int:
        return len(self.values)

    @property
    def shape(self) -> tuple[int, int]:
        """The numbers of rows and of columns."""
        return len(self.rows), len(self.columns)

    def check(self) -> MatrixLaws:
        """Checks the laws of form factors, within the bounds: `check_form_factors`."""
        if self.rows != self.columns or len(self.rows) != len(self.areas):
            raise ValueError("laws hold for the whole matrix: leave out sender and receiver")
        return check_form_factors(self.values, self.areas, bounds=self.bounds)

    def cell_data(self) -> dict[str, Column]:
        """Sums of rows, for ``mesh.cell_data.update(F.cell_data())``."""
        sums = self.row_sums
        return {} if sums is None else {"row_sum": sums}

    def __repr__(self) -> str:
        largest = float(self.bounds.max(initial=0.0))
        return f"<FormFactors {self.shape[0]} × {self.shape[1]}, errors ≤ {largest:.1e}>"


@dataclass(frozen=True, eq=False, repr=False)
class PointFormFactors:
    """The form factors from points of surfaces: ``values[k, j]`` is from point k to face j."""

    values: Column
    """The form factors, a row for each point."""
    bounds: Column
    """Bounds on their absolute errors."""
    unseen: Column | None
    """The part that sees the front of no face; none where occlusion is ignored."""
    unseen_bounds: Column | None
    """Bounds on its error."""
    backs: Column | None
    """The part of ``unseen`` that sees a back side or an obstacle; the rest sees nothing at all."""
    backs_bounds: Column | None
    """Bounds on its error."""
    areas: Column
    """The areas of the faces."""
    names: list[str]
    """The names of the faces."""
    notes: list[str]
    """Remarks on the mesh and the points."""

    def __getitem__(self, index: Any) -> Any:
        return self.values[index]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        array = self.values if dtype is None else self.values.astype(dtype, copy=False)
        return array.copy() if copy else array

    def __len__(self) -> int:
        return len(self.values)

    def __repr__(self) -> str:
        points, faces = self.values.shape
        return f"<PointFormFactors {points} points × {faces} faces>"


def form_factors(
    mesh: MeshLike,
    *,
    obstacles: Obstacles = None,
    sender: Face | None = None,
    receiver: Face | None = None,
    tolerance: float | None = None,
    absolute: float | None = None,
    congruence: bool = True,
    threads: int | None = None,
    progress: Listener | None = None,
) -> FormFactors:
    """Computes form factors: ``F[i, j]`` is from i to j (pyviewfactor's matrix is the transpose).

    ::

        F_ij = 1/(π A_i) ∫_i ∫_j cos θ_i cos θ_j / r² · (do they see each other?)

    the part of the power leaving face i that meets face j, past all that stands in the way, by
    closed forms. Every value has a bound on its error, and the numbers are the very bits that
    ``infoscene form-factor --matrix`` writes.

    >>> import numpy as np, infoscene
    >>> square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    >>> above = square[::-1] + [0, 0, 1]
    >>> F = infoscene.form_factors((np.vstack([square, above]), [[0, 1, 2, 3], [4, 5, 6, 7]]))
    >>> round(float(F[0, 1]), 12)  # Howell, C-11: opposite unit squares
    0.199824895698
    >>> F.check().broken
    ()

    Parameters
    ----------
    mesh
        The mesh, or a `Scene`, which says how it is taken.
    obstacles
        A mesh, or a list of meshes, that only stands in the way.
    sender, receiver
        Only the row of this face, or its column: a number, or a name in a file, which may mean
        several.
    tolerance
        The relative error that is accepted of each form factor, 1e-12 unless given. A
        `ToleranceWarning` tells where it is missed.
    absolute
        The absolute error that is accepted even where it is more, relatively.
    congruence
        Whether pairs that are congruent share one value: fast, and at most 1e-15 away.
    threads
        Threads to compute with; all cores, or ``RAYON_NUM_THREADS``, if none are given.
    progress
        A function that is called with a `Progress` some times a second, in this thread.

    Returns
    -------
    FormFactors
        Values, bounds and areas as arrays. n faces take 25 n² bytes up to 16,384 of them, and
        beyond that 16 n², at the cost of the time that sharing saves.

    Raises
    ------
    ValueError
        If a face is no simple polygon, faces overlap, or a name is unknown: it says which and what
        to do.
    TypeError
        If an argument is of the wrong kind.
    """
    found = _infoscene.form_factors(
        scene_of(mesh, obstacles),
        Accuracy(tolerance, absolute, congruence),
        None if sender is None else face_name(sender),
        None if receiver is None else face_name(receiver),
        Call.of(threads, progress),
    )
    warn(found)
    return FormFactors(**found)


def point_form_factors(
    mesh: MeshLike,
    points: ArrayLike,
    normals: ArrayLike,
    *,
    obstacles: Obstacles = None,
    threads: int | None = None,
    progress: Listener | None = None,
) -> PointFormFactors:
    """Computes form factors from points of surfaces, past all that stands in the way.

    Row k says which part of what a surface at point k sends out meets each face; the rest is
    ``unseen``: the sky, back sides and obstacles.

    >>> import infoscene
    >>> F = infoscene.point_form_factors("cube:1", [[0.5, 0.5, 0.0]], [[0, 0, 1]])
    >>> round(float(F.values.max()), 5)  # Howell, B-3: the ceiling over the middle of the floor
    0.23946
    >>> bool(F.unseen[0] < 1e-15)
    True

    Parameters
    ----------
    mesh, obstacles
        As of `form_factors`.
    points
        Coordinates, m × 3.
    normals
        Vectors of any length along the normals of the surface, m × 3, or one for all points.
    threads, progress
        As of `form_factors`.

    Raises
    ------
    ValueError
        If a normal has no direction, or the mesh is refused.
    """
    at, along = coordinates(points, "points"), _normals(normals, points)
    found = _infoscene.point_form_factors(
        scene_of(mesh, obstacles), at, along, Call.of(threads, progress)
    )
    return PointFormFactors(**found)


def _normals(given: ArrayLike, points: ArrayLike) -> Any:
    count = len(np.asarray(points))
    normals = np.asarray(given)
    if normals.shape == (3,):
        normals = np.broadcast_to(normals, (count, 3))
    array = coordinates(normals, "normals")
    if len(array) != count:
        raise ValueError(f"{len(array)} normals for {count} points: give one for each, or one")
    return array
