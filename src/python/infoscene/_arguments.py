"""Arguments that several functions share, as the extension module reads them."""

import os
from collections.abc import Callable, Mapping, Sequence
from numbers import Real
from typing import Any, Literal, NamedTuple, TypeAlias, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats
from ._results import Progress

Chain: TypeAlias = Literal["visibility", "radiosity", "importance"]
Channel: TypeAlias = Literal["r", "g", "b"]
Face: TypeAlias = Union[int, str]
FaceValues: TypeAlias = Union[ArrayLike, Mapping[Face, "float | Sequence[float]"]]
"""A number for all faces, an array with one (or three, of the channels) for each, or a dictionary
with those of some faces by number or name, where a file gives the others."""
Listener: TypeAlias = Callable[[Progress], object]


class Call(NamedTuple):
    """Threads and a callback."""

    threads: int | None
    progress: Callable[[int, int, str, str], object] | None

    @classmethod
    def of(cls, threads: int | None, progress: Listener | None) -> "Call":
        """The call with a callback of one argument."""
        if threads is not None and (isinstance(threads, bool) or int(threads) != threads):
            raise TypeError(f"threads is {threads!r}: give a whole number")
        if threads is not None and threads < 1:
            raise ValueError(f"threads is {threads}: it must be 1 or more, or None for all cores")
        if progress is None:
            return cls(threads, None)
        if not callable(progress):
            raise TypeError(f"progress is a {type(progress).__name__}: give a function")
        listener = progress
        return cls(threads, lambda *told: listener(Progress(*told)))


class Accuracy(NamedTuple):
    """The error that is accepted of form factors."""

    tolerance: float | None
    absolute: float | None
    congruence: bool


class Values(NamedTuple):
    """Numbers for faces, three each, with the number or name of what they are for."""

    argument: str
    is_array: bool
    values: list[tuple[str, tuple[float, float, float]]]

    @classmethod
    def of(cls, argument: str, given: FaceValues | None, *, colours: bool = True) -> "Values":
        """The numbers that are given; none of ``None``."""
        if given is None:
            return cls(argument, False, [])
        if isinstance(given, Mapping):
            pairs = [(face_name(face), _three(argument, one)) for face, one in given.items()]
            return cls(argument, False, pairs)
        if isinstance(given, Real) and not isinstance(given, bool):
            return cls(argument, False, [("all", _three(argument, given))])
        array = floats(given, argument)
        if array.ndim == 0:
            return cls(argument, False, [("all", _three(argument, float(array)))])
        if array.ndim == 1:
            array = np.repeat(array[:, None], 3, axis=1)
        elif not (colours and array.ndim == 2 and array.shape[1] == 3):
            wanted = "a number for each face" + (", or three of its channels" if colours else "")
            raise ValueError(f"{argument}: the shape is {array.shape}: give {wanted}")
        rows = [(r, g, b) for r, g, b in array.tolist()]
        return cls(argument, True, [(str(face), row) for face, row in enumerate(rows)])


class Light(NamedTuple):
    """A chain and its light."""

    chain: str
    channel: str | None
    reflectance: Values
    emittance: Values
    importance: Values

    @classmethod
    def of(
        cls,
        reflectance: FaceValues | None,
        emittance: FaceValues | None,
        importance: FaceValues | None,
        *,
        chain: str = "visibility",
        channel: str | None = None,
    ) -> "Light":
        """The light that these describe."""
        return cls(
            chain,
            channel,
            Values.of("reflectance", reflectance),
            Values.of("emittance", emittance),
            Values.of("importance", importance, colours=False),
        )


class Refinement(NamedTuple):
    """The choices of a refinement."""

    elements: int | None
    links: int | None
    error: float | None
    oracle: str
    linear: bool
    exact: bool
    bound: bool
    gather: bool


def face_name(face: object) -> str:
    """A face's number or name as text."""
    if isinstance(face, str):
        return face
    if isinstance(face, (int, np.integer)) and not isinstance(face, bool):
        return str(int(face))
    raise TypeError(f"{face!r} is no face: give its number or its name")


def faces_named(given: object) -> list[str]:
    """One face, several, or none at all."""
    if given is None:
        return []
    if isinstance(given, (str, int, np.integer)):
        return [face_name(given)]
    if isinstance(given, os.PathLike) or not hasattr(given, "__iter__"):
        raise TypeError(f"{given!r} are no faces: give numbers or names")
    return [face_name(face) for face in given]


def _three(argument: str, given: Any) -> tuple[float, float, float]:
    array = floats(given, argument)
    if array.shape not in ((), (3,)):
        raise ValueError(f"{argument}: the shape is {array.shape}: give a number, or three")
    r, g, b = np.broadcast_to(array, 3).tolist()
    return r, g, b
