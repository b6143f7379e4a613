"""Meshes of any kind made into arrays, and scenes of them."""

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol, TypeAlias, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import floats, integers, is_single, points

Occlusion: TypeAlias = Literal["exact", "refuse", "ignore"]


class PolyDataLike(Protocol):
    """A pyvista ``PolyData``: faces are padded by their numbers of corners."""

    @property
    def points(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class TrimeshLike(Protocol):
    """A trimesh."""

    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class MeshioLike(Protocol):
    """A meshio mesh: cells come in blocks of one type."""

    @property
    def points(self) -> Any: ...
    @property
    def cells(self) -> Any: ...


MeshLike: TypeAlias = Union[
    "Scene",
    str,
    "os.PathLike[str]",
    PolyDataLike,
    TrimeshLike,
    MeshioLike,
    tuple[ArrayLike, Union[ArrayLike, Sequence[ArrayLike]]],
    tuple[ArrayLike, ArrayLike, ArrayLike],
]
"""A mesh, or where one is.

A path of an OBJ, View3D or STL file, or the name of a built-in scene; a pyvista ``PolyData``, a
trimesh, or a meshio mesh; ``(vertices, faces)`` with an array of the faces' corners, or a list of
lists where faces have different numbers of them; ``(vertices, corners, offsets)``, where face ``i``
has the corners ``corners[offsets[i]:offsets[i + 1]]``.
"""


Obstacles: TypeAlias = Union[MeshLike, Sequence[MeshLike], None]
"""A mesh, a list of meshes, or none."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """Polygons in arrays, as the extension module reads them."""

    vertices: NDArray[np.float64]
    corners: NDArray[np.int64]
    offsets: NDArray[np.int64]
    is_single: bool

    @classmethod
    def of(cls, given: object) -> "Mesh":
        """The polygons of a mesh in memory."""
        if isinstance(given, tuple):
            return cls._of_arrays(given)
        if hasattr(given, "points") and isinstance(getattr(given, "cells", None), list):
            return cls._of_meshio(given)
        if hasattr(given, "points") and hasattr(given, "faces"):
            return cls._of_polydata(given)
        if hasattr(given, "vertices") and hasattr(given, "faces"):
            return cls._joined(given.vertices, *_regular(given.faces))
        name = type(given).__name__
        if hasattr(given, "extract_surface"):
            raise TypeError(f"a {name} has cells that are no faces: give its extract_surface()")
        raise TypeError(
            f"a {name} is no mesh: give a path, the name of a built-in scene, a pyvista PolyData, "
            "a trimesh, a meshio mesh, (vertices, faces) or (vertices, corners, offsets)"
        )

    @classmethod
    def _joined(cls, vertices: object, corners: object, offsets: object) -> "Mesh":
        corners, offsets = integers(corners, "corners"), integers(offsets, "offsets")
        for array, what in ((corners, "corners"), (offsets, "offsets")):
            if array.ndim != 1:
                raise ValueError(
                    f"{what}: the shape is {array.shape}: give one number after another"
                )
        if len(offsets) < 2:
            raise ValueError("the mesh has no face: give one at least")
        return cls(points(vertices, "vertices"), corners, offsets, is_single(vertices))

    @classmethod
    def _of_arrays(cls, given: tuple[Any, ...]) -> "Mesh":
        if len(given) == 3:
            return cls._joined(*given)
        if len(given) != 2:
            raise TypeError(
                f"a tuple of {len(given)} is no mesh: give (vertices, faces) or "
                "(vertices, corners, offsets)"
            )
        vertices, faces = given
        if hasattr(faces, "ndim") or hasattr(faces, "__array__"):
            return cls._joined(vertices, *_regular(faces))
        return cls._joined(vertices, *_ragged(faces))

    @classmethod
    def _of_polydata(cls, mesh: Any) -> "Mesh":
        for kind in ("verts", "lines", "strips"):
            count = getattr(mesh, f"n_{kind}", 0)
            if count:
                mend = "triangulate()" if kind == "strips" else "extract_surface()"
                raise ValueError(
                    f"the mesh has {count} {kind} beside its faces, so that its cells are not its "
                    f"faces: give its {mend}, or only the faces"
                )
        return cls._joined(mesh.points, *_padded(integers(mesh.faces, "faces")))

    @classmethod
    def _of_meshio(cls, mesh: Any) -> "Mesh":
        blocks: list[tuple[NDArray[np.int64], NDArray[np.int64]]] = []
        for block in mesh.cells:
            if block.type in ("vertex", "line"):
                continue
            if block.type not in ("triangle", "quad", "polygon"):
                raise ValueError(
                    f"cells of type {block.type!r} are no flat faces: give the surface in "
                    "triangles, quads or polygons"
                )
            is_array = getattr(block.data, "ndim", 0) == 2
            blocks.append(_regular(block.data) if is_array else _ragged(block.data))
        counts = [np.diff(offsets) for _, offsets in blocks]
        offsets = np.cumsum(np.concatenate([[0], *counts])).astype(np.int64)
        corners = [corners for corners, _ in blocks]
        return cls._joined(mesh.points, np.concatenate([_EMPTY, *corners]), offsets)


_EMPTY = np.empty(0, np.int64)


def _regular(faces: object) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Faces of equal numbers of corners."""
    array = integers(faces, "faces")
    if array.ndim != 2:
        raise ValueError(
            f"faces: the shape is {array.shape}: give a row of corners for each face; corners in "
            "one row come with offsets, (vertices, corners, offsets)"
        )
    count, corners = array.shape
    return array.reshape(-1), np.arange(count + 1, dtype=np.int64) * corners


def _ragged(faces: Iterable[Any]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Faces in lists."""
    if isinstance(faces, (str, bytes)) or not hasattr(faces, "__iter__"):
        raise TypeError(f"faces: {type(faces).__name__} is no list of faces")
    lists = [integers(face, f"face {number}") for number, face in enumerate(faces)]
    for number, face in enumerate(lists):
        if face.ndim != 1:
            raise ValueError(f"face {number}: the shape is {face.shape}: give a list of corners")
    counts = [0, *map(len, lists)]
    return np.concatenate([_EMPTY, *lists]), np.cumsum(counts).astype(np.int64)


def _padded(faces: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Faces that are each preceded by the number of their corners, as VTK has them."""
    if faces.size and faces[0] > 0 and faces.size % (int(faces[0]) + 1) == 0:
        rows = faces.reshape(-1, int(faces[0]) + 1)
        if (rows[:, 0] == faces[0]).all():
            return _regular(rows[:, 1:])
    places, place = [], 0
    while place < faces.size:
        places.append(place)
        place += max(int(faces[place]), 0) + 1
    heads = np.array(places, np.int64)
    offsets = np.concatenate([[0], np.cumsum(faces[heads])]).astype(np.int64)
    return np.delete(faces, heads), offsets


class Scene:
    """A mesh, and how it is taken: every function takes one in place of a mesh.

    >>> import infoscene
    >>> room = infoscene.Scene("cube:1", subdivide=2)
    >>> len(infoscene.form_factors(room).areas)
    96

    Parameters
    ----------
    mesh
        The mesh (`MeshLike`).
    obstacles
        A mesh, or a list of meshes, that only stands in the way, on both sides.
    triangulate
        Whether faces that are not planar are split into triangles, which still make up one face.
        Otherwise they are refused.
    resolution
        The length by which each coordinate may be off, 0 for none. Without it, the decimals of a
        file say it, and the last place of 32-bit coordinates, where surfaces miss each other by so
        little.
    join
        Whether neighbours in one plane with one material are joined; rows are no longer faces then.
    reverse
        Whether the front of every face is turned to its other side.
    subdivide
        The number of times, up to 8, that every face is quartered; rows are the parts then.
    occlusion
        ``"exact"`` computes what is left past all that stands in the way, ``"refuse"`` refuses a
        scene with anything in the way, ``"ignore"`` computes as if nothing were.

    Raises
    ------
    TypeError
        If something is no mesh, or is not of the right type.
    ValueError
        If arrays do not have the shape of a mesh. The faces themselves are checked when a question
        is asked.
    """

    def __init__(
        self,
        mesh: MeshLike,
        *,
        obstacles: Obstacles = None,
        triangulate: bool = False,
        resolution: float | None = None,
        join: bool = False,
        reverse: bool = False,
        subdivide: int = 0,
        occlusion: Occlusion = "exact",
    ) -> None:
        if isinstance(mesh, Scene):
            raise TypeError("this is a Scene already: give its mesh, and all that is said of it")
        is_named = isinstance(mesh, (str, os.PathLike))
        self.name: str | None = os.fspath(mesh) if isinstance(mesh, (str, os.PathLike)) else None
        self.mesh: Mesh | None = None if is_named else Mesh.of(mesh)
        self.obstacles: list[Mesh] = _obstacles(obstacles)
        self.triangulate = bool(triangulate)
        self.resolution = None if resolution is None else _length(resolution)
        self.join = bool(join)
        self.reverse = bool(reverse)
        if not 0 <= subdivide <= 8:
            raise ValueError(f"subdivide is {subdivide}: faces are quartered 0 to 8 times")
        self.subdivide = int(subdivide)
        self.occlusion: Occlusion = occlusion

    def __repr__(self) -> str:
        if self.mesh is None:
            return f"Scene({self.name!r})"
        return f"Scene(<{len(self.mesh.offsets) - 1} faces>)"


def scene_of(mesh: MeshLike, obstacles: Obstacles) -> Scene:
    """The scene of a mesh and of what stands in the way."""
    if not isinstance(mesh, Scene):
        return Scene(mesh, obstacles=obstacles)
    if obstacles is not None:
        raise TypeError("a Scene has its own obstacles: give them to it, Scene(…, obstacles=…)")
    return mesh


def _obstacles(given: object) -> list[Mesh]:
    if given is None:
        return []
    several = given if isinstance(given, list) else [given]
    for one in several:
        if isinstance(one, (str, os.PathLike, Scene)):
            raise TypeError(
                f"an obstacle is a mesh in memory, and this is a {type(one).__name__}: read it "
                "first, with pyvista, trimesh or meshio"
            )
    return [Mesh.of(one) for one in several]


def _length(given: float) -> float:
    length = float(floats(given, "resolution"))
    if not (length >= 0.0 and np.isfinite(length)):
        raise ValueError(f"resolution is {length}: it must be a length, 0 or more")
    return length
