"""The parts that all answers share."""

import warnings
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Column: TypeAlias = NDArray[np.float64]


class ToleranceWarning(UserWarning):
    """A tolerance that was asked for is missed; the bounds beside the values hold all the same."""


class Progress(NamedTuple):
    """The state of a computation, as a callback is told some times a second."""

    done: int
    """Units of work that are finished."""
    total: int
    """Units of work in all, 0 where that is not known."""
    name: str
    """The name of the units, such as ``"pairs"``."""
    state: str
    """The state in words, where the length is not known beforehand."""


def warn(found: dict[str, Any]) -> None:
    """Warns of a tolerance that is missed."""
    unreached = found.pop("unreached")
    if unreached is not None:
        warnings.warn(unreached, ToleranceWarning, stacklevel=3)
