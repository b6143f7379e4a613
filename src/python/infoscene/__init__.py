"""Form factors with error bounds, radiosity, and information-theoretic scene discretization.

>>> import infoscene
>>> F = infoscene.form_factors("two-squares")  # or a file, arrays, a mesh of another library
>>> float(F[0, 1])  # from face 0 to face 1; Howell, C-14: 0.2000437760754
0.200043776075...
>>> bool(F.bounds[0, 1] < 1e-14)
True

================================  =======================================================
`form_factors`                    all form factors of a mesh, past what is in the way
`point_form_factors`              the form factors from points
`check_form_factors`              the laws that a matrix of form factors breaks, any matrix
`mutual_information`              entropies and mutual information of a scene
`continuous_information`          the limit of the latter on ever finer meshes
`best_split`                      the cut of a face that gains the most
`radiosity`                       light in equilibrium, with bounds
`refine`                          the same on a mesh that is refined where it matters
`reproduce`                       the claims of the paper, computed and judged
================================  =======================================================

A mesh is a path (OBJ, View3D, STL), the name of a built-in scene (``"cube:10"``,
``"cornell-box"``, …), a pyvista ``PolyData``, a trimesh, a meshio mesh, or arrays:
``(vertices, faces)``, ``(vertices, lists of corners)`` or ``(vertices, corners, offsets)``.
`Scene` takes the same, and how to read it. The front of a face is the side from which its corners
run counter-clockwise; a room is seen from inside. Results are in the order of the faces.

Every value comes with a bound on its error. Information is in bits, lengths in any one unit.
Functions run without the interpreter's lock, on all cores (``threads=`` or ``RAYON_NUM_THREADS``
say otherwise), hear Ctrl-C, and report to ``progress=``. What is wrong raises a `ValueError` that
names the face and the mend, or a `TypeError` for a wrong kind of argument.
"""

from ._claims import Claim, reproduce
from ._cuts import BestSplit, Enclosure, best_split
from ._factors import FormFactors, PointFormFactors, form_factors, point_form_factors
from ._information import (
    ContinuousInformation,
    MutualInformation,
    continuous_information,
    mutual_information,
)
from ._infoscene import __version__
from ._laws import Broken, MatrixLaws, check_form_factors
from ._light import Radiosity, Refined, RefineStep, radiosity, refine
from ._meshes import MeshLike, Scene
from ._results import Progress, ToleranceWarning

__all__ = [
    "BestSplit",
    "Broken",
    "Claim",
    "ContinuousInformation",
    "Enclosure",
    "FormFactors",
    "MatrixLaws",
    "MeshLike",
    "MutualInformation",
    "PointFormFactors",
    "Progress",
    "Radiosity",
    "RefineStep",
    "Refined",
    "Scene",
    "ToleranceWarning",
    "__version__",
    "best_split",
    "check_form_factors",
    "continuous_information",
    "form_factors",
    "mutual_information",
    "point_form_factors",
    "radiosity",
    "refine",
    "reproduce",
]
