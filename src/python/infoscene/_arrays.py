"""Arrays of any kind made into those that the extension module reads.

Arrays that come from elsewhere may be read-only, misaligned (zero-copy buffers of Dask), of the
other byte order, strided or single. What holds numbers is converted; what does not is refused.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def floats(given: object, what: str) -> NDArray[np.float64]:
    """Numbers as an aligned, contiguous array of 64 bits."""
    return np.require(_numbers(given, what, "fiu"), np.float64, ["C", "A"])


def integers(given: object, what: str) -> NDArray[np.int64]:
    """Integers as an aligned, contiguous array of 64 bits."""
    array = _numbers(given, what, "iu")
    if array.dtype.kind == "u" and array.size and int(array.max()) > np.iinfo(np.int64).max:
        raise ValueError(f"{what}: {array.max()} is out of range: count vertices from 0")
    return np.require(array, np.int64, ["C", "A"])


def points(given: object, what: str) -> NDArray[np.float64]:
    """Coordinates, three to a point."""
    array = floats(given, what)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what}: the shape is {array.shape}: give three coordinates a point")
    return array


def is_single(given: object) -> bool:
    """Whether coordinates have no more than 32 bits, so that each may be off by its last place."""
    dtype = np.asarray(given).dtype
    return dtype.kind == "f" and dtype.itemsize <= 4


def _numbers(given: object, what: str, kinds: str) -> NDArray[Any]:
    if np.ma.isMaskedArray(given) and np.ma.getmaskarray(given).any():
        raise ValueError(f"{what}: some entries are masked: fill them or leave them out")
    try:
        array = np.asarray(given)
    except ValueError as error:
        raise ValueError(f"{what}: the lists are not of equal lengths: {error}") from error
    if array.size == 0 and array.dtype.kind == "f":
        return array.astype(np.int64 if "f" not in kinds else np.float64)
    if array.dtype.kind not in kinds:
        wanted = "numbers" if "f" in kinds else "integers"
        raise TypeError(f"{what}: the type is {array.dtype}: give {wanted}")
    return array
