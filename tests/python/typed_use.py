"""Calls as users write them, for the type checker: nothing here is run."""

from pathlib import Path

import infoscene
import numpy as np
from numpy.typing import NDArray
from typing_extensions import assert_type

vertices = np.zeros((4, 3))
faces = np.array([[0, 1, 2, 3]])

F = infoscene.form_factors((vertices, faces), obstacles=[(vertices, [[0, 1, 2], [0, 2, 3]])])
assert_type(F.values, NDArray[np.float64])
assert_type(F.check().transposed, bool)
infoscene.form_factors(Path("room.obj"), sender="floor", receiver=3, threads=2)
infoscene.form_factors((vertices, faces.ravel(), [0, 4]), progress=lambda told: print(told.done))
infoscene.form_factors(infoscene.Scene("cube:2", occlusion="refuse"))

light = infoscene.radiosity((vertices, faces), 0.5, {0: 1.0, "lamp": (1.0, 0.5, 0.2)})
assert_type(light.bounds, NDArray[np.float64] | None)
assert_type(float(infoscene.mutual_information("cube:2")), float)
assert_type(infoscene.best_split("two-squares", against=[1]).position, float)
assert_type(infoscene.refine("lit-cube", elements=10).steps[0].links, int)
assert_type(infoscene.reproduce("theorem-1")[0].verdict, str)

infoscene.form_factors(3)  # type: ignore[arg-type]
infoscene.form_factors("cube:1", tolerance="small")  # type: ignore[arg-type]
infoscene.mutual_information("cube:1", chain="markov")  # type: ignore[arg-type]
infoscene.Scene("cube:1", occlusion="some")  # type: ignore[arg-type]
