"""Scenes that several tests share."""

import shutil
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]


def cube(n, dtype=float):
    """The inside of the unit cube, n × n squares a face: vertices, faces."""
    steps = np.arange(n + 1) / n
    u, v = (grid.ravel() for grid in np.meshgrid(steps, steps, indexing="ij"))
    first = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    square = np.stack([first, first + n + 1, first + n + 2, first + 1], axis=1)
    vertices, faces = [], []
    for axis in range(3):
        for side in (0.0, 1.0):
            at = np.empty((len(u), 3))
            at[:, axis], at[:, (axis + 1) % 3], at[:, (axis + 2) % 3] = side, u, v
            faces.append((square if side == 0.0 else square[:, ::-1]) + sum(map(len, vertices)))
            vertices.append(at)
    return np.concatenate(vertices).astype(dtype), np.concatenate(faces)


def squares():
    """Two parallel unit squares that face each other at distance 1."""
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    above = square[::-1] + [0, 0, 1]
    return np.vstack([square, above]), np.arange(8).reshape(2, 4)


@pytest.fixture
def command():
    """The program, built by cargo or named by INFOSCENE_PROGRAM."""
    import os

    named = os.environ.get("INFOSCENE_PROGRAM")
    built = [ROOT / "target" / profile / "infoscene" for profile in ("release", "debug", "edit")]
    found = [named] if named else [str(path) for path in built if path.exists()]
    found += [path for path in [shutil.which("infoscene")] if path]
    if not found:
        pytest.skip("the program is not built: cargo build --release")
    return found[0]
