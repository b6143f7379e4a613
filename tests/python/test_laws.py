"""The laws of form factors, on matrices from here and from elsewhere."""

import infoscene
import numpy as np
import pytest
from conftest import cube, squares


def box():
    """The inside of a box 1 × 2 × 3: faces of three areas."""
    vertices, faces = cube(1)
    return vertices * [1, 2, 3], faces


def test_a_matrix_of_ours_breaks_no_law():
    for mesh in (box(), "cornell-box", squares()):
        laws = infoscene.form_factors(mesh).check()
        assert laws, str(laws)
    assert infoscene.form_factors(box()).check().closed
    assert not infoscene.form_factors(squares()).check().closed


def test_each_law_is_broken_by_its_own_fault():
    F = infoscene.form_factors(box())
    faults = {
        "range": (0, 0, -1e-3, None),
        "row sum": (0, 0, 1e-3, None),
        "reciprocity": (0, 2, -1e-3, (0, 2)),
    }
    for law, (i, j, change, worst) in faults.items():
        values = F.values.copy()
        values[i, j] += change
        laws = infoscene.check_form_factors(values, F.areas, bounds=F.bounds)
        assert [broken.law for broken in laws.broken] == [law], str(laws)
        assert laws.broken[0].cases == 1
        assert laws.broken[0].excess > 0.9e-3
        assert worst is None or laws.broken[0].worst == worst
        assert not laws and not laws.transposed


def test_a_change_within_the_bounds_breaks_nothing():
    F = infoscene.form_factors(box())
    values = F.values.copy()
    values[0, 2] -= 1e-3
    assert infoscene.check_form_factors(values, F.areas, bounds=2e-3)
    assert not infoscene.check_form_factors(values, F.areas)


def test_the_transpose_is_recognised():
    F = infoscene.form_factors(box())
    laws = infoscene.check_form_factors(F.values.T, F.areas)
    assert laws.transposed and "F.T" in str(laws)
    assert not F.check().transposed


def test_pyviewfactors_matrix_is_the_transpose():
    pyviewfactor = pytest.importorskip("pyviewfactor")
    pv = pytest.importorskip("pyvista")
    vertices, faces = box()
    mesh = pv.PolyData.from_regular_faces(vertices, faces)
    theirs = pyviewfactor.compute_viewfactor_matrix(mesh, skip_obstruction=True)
    F = infoscene.form_factors(mesh)
    # their quadrature is right to 1e-6 for faces that share an edge
    assert np.abs(theirs.T - F.values).max() < 1e-5
    assert np.abs(theirs - F.values).max() > 0.05
    laws = infoscene.check_form_factors(theirs, F.areas, bounds=1e-5)
    assert laws.transposed
    assert infoscene.check_form_factors(theirs.T, F.areas, bounds=1e-5)


def test_what_is_no_matrix_is_refused():
    areas = [1.0, 1.0]
    for values, given, message in [
        ([[0, np.nan], [0, 0]], areas, r"entry \(0, 1\) is NaN"),
        ([[0, 1, 0], [0, 0, 0]], areas, "square"),
        ([[0, 1], [1, 0]], [1.0], "areas"),
        ([[0, 1], [1, 0]], [1.0, -1.0], "area of face 1 is -1"),
    ]:
        with pytest.raises(ValueError, match=message):
            infoscene.check_form_factors(values, given)
    with pytest.raises(TypeError, match="numbers"):
        infoscene.check_form_factors([["a", "b"], ["c", "d"]], areas)
