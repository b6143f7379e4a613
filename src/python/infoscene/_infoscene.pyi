from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._arguments import Accuracy, Call, Light, Refinement
from ._meshes import Scene

__all__ = [
    "__version__",
    "best_split",
    "form_factors",
    "matrix_laws",
    "measure",
    "point_form_factors",
    "radiosity",
    "refine",
    "reproduce",
]

__version__: str

def form_factors(
    scene: Scene, accuracy: Accuracy, sender: str | None, receiver: str | None, call: Call
) -> dict[str, Any]: ...
def point_form_factors(
    scene: Scene, points: NDArray[np.float64], normals: NDArray[np.float64], call: Call
) -> dict[str, Any]: ...
def matrix_laws(
    values: NDArray[np.float64], areas: NDArray[np.float64], bounds: NDArray[np.float64]
) -> dict[str, Any]: ...
def measure(
    scene: Scene,
    accuracy: Accuracy,
    light: Light,
    is_open: bool,
    is_continuous: bool,
    call: Call,
) -> dict[str, Any]: ...
def best_split(
    scene: Scene,
    patch: str,
    against: list[str],
    axis: str | None,
    parts: int,
    precision: int | None,
    light: Light,
    call: Call,
) -> dict[str, Any]: ...
def radiosity(scene: Scene, accuracy: Accuracy, light: Light, call: Call) -> dict[str, Any]: ...
def refine(scene: Scene, refinement: Refinement, light: Light, call: Call) -> dict[str, Any]: ...
def reproduce(
    claims: list[str], printed_only: bool, precision: int | None, call: Call
) -> list[dict[str, Any]]: ...
