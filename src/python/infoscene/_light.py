"""Light in equilibrium, on the mesh as it is and on one that is refined."""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _infoscene
from ._arguments import Accuracy, Call, Channel, FaceValues, Light, Listener, Refinement
from ._meshes import MeshLike, Obstacles, scene_of
from ._results import Column, warn


@dataclass(frozen=True, eq=False)
class Radiosity:
    """Light in equilibrium: ``values[i]`` is the radiosity of face i, in the unit of emittances."""

    values: Column
    """Radiosities; of a coloured scene the means of the channels."""
    irradiance: Column = field(repr=False)
    """Irradiances."""
    relative_error: float
    """A bound on the relative error of each radiosity, for the form factors as computed."""
    form_factor_bounds: Column | None = field(repr=False)
    """Bounds on what the form factors' errors change; none where no bound is known."""
    resolution: float
    """The length by which each coordinate may be off."""
    resolution_bounds: Column | None = field(repr=False)
    """Bounds on what that can change beside it; none where no bound is known."""
    importance: Column | None = field(repr=False)
    """Importances, if direct ones were given."""
    colours: Column | None = field(repr=False)
    """Radiosities of the three channels, a row for each face, if the scene is coloured."""
    closed: bool
    """Do all rows of form factors sum to one?"""
    emitted: float
    """The power that is emitted."""
    absorbed: float
    """The power that is absorbed."""
    escaped: float
    """The power that escapes."""
    residual: float
    """The largest relative residual of the equations."""
    iterations: int
    """Products with the matrix."""
    areas: Column = field(repr=False)
    """The areas of the faces."""
    names: list[str] = field(repr=False)
    """The names of the faces."""
    notes: list[str] = field(repr=False)
    """Remarks on the mesh."""

    @property
    def bounds(self) -> Column | None:
        """Bounds on the errors: the solution's and the form factors' together."""
        if self.form_factor_bounds is None:
            return None
        # the sum and the product round by an ulp each at most
        rounded = 1.0 + 4.0 * np.finfo(float).eps
        both = self.form_factor_bounds + self.relative_error * self.values
        return np.asarray(both * rounded, np.float64)

    def cell_data(self) -> dict[str, Column]:
        """Columns for ``mesh.cell_data.update(light.cell_data())``."""
        bounds = self.bounds
        columns = {"radiosity": self.values, "irradiance": self.irradiance}
        if bounds is not None:
            columns["radiosity_bound"] = bounds
        if self.colours is not None:
            columns["radiosity_rgb"] = self.colours
        return columns


class RefineStep(NamedTuple):
    """A round of a refinement; errors are relative, in L2, over all that is not light."""

    elements: int
    """Elements of the mesh."""
    links: int
    """Links between them."""
    evaluations: int
    """Form factors that were computed so far."""
    seconds: float
    """Time that was taken so far."""
    error_bound: float | None
    """A bound on the error of the last step, where one is known."""
    error_estimate: float | None
    """An estimate of the error; none for a linear solution."""
    mutual_information: float | None
    """The mutual information of the links' chain, in bits."""


@dataclass(frozen=True, eq=False)
class Refined:
    """Light on a mesh that was refined: means over each face of the mesh that was given."""

    values: Column
    """Mean radiosities of the faces."""
    irradiance: Column = field(repr=False)
    """Mean irradiances."""
    gathered: Column | None = field(repr=False)
    """Mean radiosities after one more gather, if it was asked for."""
    elements: list[int] = field(repr=False)
    """Elements that each face was cut into."""
    faces: list[int] = field(repr=False)
    """The numbers of the faces: those that have an area."""
    areas: Column = field(repr=False)
    """The areas of the elements."""
    names: list[str] = field(repr=False)
    """The names of the elements' faces."""
    mesh: tuple[Column, NDArray[np.int64], NDArray[np.int64]] = field(repr=False)
    """The refined mesh: vertices, corners and offsets, which every function takes as a mesh."""
    element_values: Column = field(repr=False)
    """The mean radiosity of each element of that mesh."""
    element_faces: list[int] = field(repr=False)
    """The face that each element is a piece of."""
    steps: list[RefineStep]
    """The mesh as given, then each round."""
    oracle: str
    """The oracle."""
    linear: bool
    """Was the solution linear on each element, not constant?"""
    notes: list[str] = field(repr=False)
    """Remarks on the mesh, and on bounds that there are not."""

    @property
    def error_bound(self) -> float | None:
        """A bound on the relative error in L2 of the last mesh, where one is known."""
        return self.steps[-1].error_bound

    def polydata(self) -> Any:
        """The refined mesh as a pyvista ``PolyData``, coloured by radiosity."""
        import pyvista

        vertices, corners, offsets = self.mesh
        padded = np.insert(corners, offsets[:-1], np.diff(offsets))
        mesh = pyvista.PolyData(vertices, padded)
        mesh.cell_data["radiosity"] = self.element_values
        mesh.cell_data["face"] = np.array(self.element_faces)
        return mesh

    @property
    def error_estimate(self) -> float | None:
        """An estimate of that error."""
        return self.steps[-1].error_estimate


def radiosity(
    mesh: MeshLike,
    reflectance: FaceValues | None = None,
    emittance: FaceValues | None = None,
    *,
    obstacles: Obstacles = None,
    importance: FaceValues | None = None,
    tolerance: float | None = None,
    absolute: float | None = None,
    congruence: bool = True,
    threads: int | None = None,
    progress: Listener | None = None,
) -> Radiosity:
    """Solves for light in equilibrium: ``B = E + R F B``, face by face, with bounds.

    >>> import infoscene
    >>> light = infoscene.radiosity("cube:2", reflectance=0.75, emittance=1.0)
    >>> [round(float(B), 9) for B in light.values[:2]]  # a furnace: E/(1 − R) everywhere
    [4.0, 4.0]
    >>> bool(light.bounds.max() < 1e-12)
    True

    Parameters
    ----------
    mesh, obstacles, tolerance, absolute, congruence, threads, progress
        As of `form_factors`.
    reflectance
        The parts of the arriving power that leave again, 0 to 1: a number for all faces, an array
        with one for each, or three of its channels, n × 3, or a dictionary by face, beside the
        materials of a file. Without any, a file's own.
    emittance
        The power that a unit of area sends out by itself, likewise; ≥ 0.
    importance
        Direct importances: if some are given, importances are computed, too.

    Returns
    -------
    Radiosity
        ``mesh.cell_data.update(light.cell_data())`` attaches it to a pyvista mesh.

    Raises
    ------
    ValueError
        If a material is out of range or unknown, a number is NaN, or no bound can be had, as where
        nothing absorbs.
    """
    found = _infoscene.radiosity(
        scene_of(mesh, obstacles),
        Accuracy(tolerance, absolute, congruence),
        Light.of(reflectance, emittance, importance),
        Call.of(threads, progress),
    )
    warn(found)
    return Radiosity(**found)


def refine(
    mesh: MeshLike,
    reflectance: FaceValues | None = None,
    emittance: FaceValues | None = None,
    *,
    elements: int | None = None,
    links: int | None = None,
    error: float | None = None,
    oracle: str = "gradient",
    obstacles: Obstacles = None,
    channel: Channel | None = None,
    importance: FaceValues | None = None,
    linear: bool = False,
    exact: bool = False,
    bound: bool = False,
    gather: bool = False,
    threads: int | None = None,
    progress: Listener | None = None,
) -> Refined:
    """Solves for light on a mesh that is refined, round by round, where an oracle says it matters.

    >>> import infoscene
    >>> light = infoscene.refine("lit-cube", elements=100)
    >>> light.steps[-1].elements >= 100
    True
    >>> len(light.element_values) == light.steps[-1].elements
    True

    Parameters
    ----------
    mesh, obstacles, threads, progress
        As of `form_factors`; ``progress`` is told of each round.
    reflectance, emittance
        As of `radiosity`.
    elements, links, error
        The end, one of them: so many elements, so many links at least, or an estimated relative
        error in L2 of at most this.
    oracle
        The oracle: ``"gradient"``, ``"information"``, ``"paper"``, …, as ``infoscene refine
        --help`` lists them.
    channel
        ``"r"``, ``"g"`` or ``"b"``: that of coloured light must be named.
    importance
        Direct importances: elements are cut for the light of these faces.
    linear
        Whether the solution is linear on each element, not constant.
    exact
        Whether links have exact form factors, which lose no energy.
    bound
        Whether the error is bounded where something stands in the way, too: seconds to minutes.
    gather
        Whether light is gathered once more in the end.

    Raises
    ------
    ValueError
        Unless one end is given; if the oracle is unknown, or the scene is refused.
    """
    found = _infoscene.refine(
        scene_of(mesh, obstacles),
        Refinement(elements, links, error, oracle, linear, exact, bound, gather),
        Light.of(reflectance, emittance, importance, channel=channel),
        Call.of(threads, progress),
    )
    steps = [RefineStep(**step) for step in found.pop("steps")]
    offsets = np.cumsum([0, *found.pop("counts")], dtype=np.int64)
    arrays = (found.pop("vertices"), np.arange(offsets[-1]), offsets)
    return Refined(steps=steps, mesh=arrays, **found)
