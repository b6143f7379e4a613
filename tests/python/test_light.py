"""Light from Python: furnaces, colours, refinement."""

import infoscene
import numpy as np
import pytest
from conftest import cube, squares


def test_a_furnace_is_as_bright_everywhere():
    # a closed room of one material: B = E/(1 − R)
    light = infoscene.radiosity(cube(3), reflectance=0.75, emittance=np.ones(54))
    assert np.abs(light.values - 4).max() <= light.bounds.max() < 1e-11
    assert light.emitted == pytest.approx(6, rel=1e-14)
    assert light.absorbed == pytest.approx(6, rel=1e-12)
    assert light.closed and light.colours is None and light.importance is None


def test_two_squares_are_lit_as_by_hand():
    # B1 = 1 + R F B2, B2 = R F B1
    F = infoscene.form_factors(squares())[0, 1]
    light = infoscene.radiosity(squares(), reflectance=[0.5, 0.8], emittance={0: 1.0, 1: 0.0})
    first = 1 / (1 - 0.5 * 0.8 * F * F)
    assert light.values == pytest.approx([first, 0.8 * F * first], rel=1e-14)
    assert light.irradiance == pytest.approx([0.8 * F * F * first, F * first], rel=1e-14)
    assert light.escaped == pytest.approx((1 - F) * light.values.sum(), rel=1e-13)


def test_light_solves_its_equation_with_the_form_factors_at_hand():
    rng = np.random.default_rng(2)
    R, E = rng.uniform(0, 0.9, 54), rng.uniform(0, 1, 54)
    light = infoscene.radiosity(cube(3), R, E)
    F = infoscene.form_factors(cube(3)).values
    # numpy's own solution, some ε times the condition, 10, away
    solved = np.linalg.solve(np.eye(54) - R[:, None] * F, E)
    assert np.abs(light.values - solved).max() < 1e-13


def test_channels_are_solved_each_by_itself():
    R = np.tile([0.2, 0.5, 0.8], (6, 1))
    light = infoscene.radiosity(cube(1), R, 1.0)
    furnace = 1 / (1 - R[0])
    assert np.abs(light.colours - furnace).max() < 1e-12
    assert light.values == pytest.approx(furnace.mean(), rel=1e-13)
    one = infoscene.radiosity(cube(1), {"all": (0.2, 0.5, 0.8)}, 1.0)
    assert np.array_equal(one.colours, light.colours)


def test_importance_is_that_of_the_transposed_system():
    rng = np.random.default_rng(3)
    R, V = rng.uniform(0, 0.9, 24), rng.uniform(0, 1, 24)
    light = infoscene.radiosity(cube(2), R, 1.0, importance=V)
    F = infoscene.form_factors(cube(2)).values
    # equal areas: I = V + Fᵀ R I
    solved = np.linalg.solve(np.eye(24) - F.T * R[None, :], V)
    assert np.abs(light.importance - solved).max() < 1e-12


def test_materials_of_a_file_are_its_own_unless_changed():
    box = infoscene.radiosity("cornell-box")
    assert box.emitted > 0 and box.values.max() > 0
    dark = infoscene.radiosity("cornell-box", reflectance=0.0)
    assert (dark.values <= box.values + 1e-12).all() and dark.values.sum() < box.values.sum()
    with pytest.raises(ValueError, match="emittances are 0|no light|emit"):
        infoscene.radiosity(cube(1), 0.5)


def test_materials_are_refused_with_face_and_range():
    for R, E, error, message in [
        (np.full(6, 1.5), 1.0, ValueError, r"patch 0 \(face 0\): the reflectance is 1.5"),
        ([0.5] * 5 + [np.nan], 1.0, ValueError, r"patch 5 \(face 5\): the reflectance is NaN"),
        (0.5, [1, 1, -1, 1, 1, 1], ValueError, r"patch 2 \(face 2\): the emittance is -1"),
        (0.5, [np.inf] * 6, ValueError, "must be finite"),
        ([0.5] * 5, 1.0, ValueError, "reflectance has 5 values for 6 faces"),
        (0.5, {7: 1.0}, ValueError, 'no patch "7"'),
        (np.zeros((6, 2)), 1.0, ValueError, r"shape is \(6, 2\)"),
        ("0.5", 1.0, TypeError, "reflectance: the type is"),
        (0.5, {1.5: 1.0}, TypeError, "1.5 is no face"),
    ]:
        with pytest.raises(error, match=message):
            infoscene.radiosity(cube(1), R, E)


def test_columns_attach_to_a_pyvista_mesh():
    pv = pytest.importorskip("pyvista")
    mesh = pv.PolyData.from_regular_faces(*cube(2))
    light = infoscene.radiosity(mesh, 0.5, 1.0)
    mesh.cell_data.update(light.cell_data())
    assert np.array_equal(mesh.cell_data["radiosity"], light.values)
    assert np.array_equal(mesh.cell_data["radiosity_bound"], light.bounds)


def test_refinement_ends_where_it_is_told_to():
    told = []
    light = infoscene.refine("lit-cube", elements=200, progress=told.append)
    assert light.steps[-1].elements >= 200 and light.oracle == "gradient"
    assert light.error_bound is None or light.error_bound > light.error_estimate / 100
    assert [step.elements for step in light.steps] == sorted(s.elements for s in light.steps)
    assert any("elements" in one.state for one in told)
    for options, message in [
        ({}, "give one of elements, links and error"),
        ({"elements": 10, "links": 5}, "give one of"),
        ({"error": -1.0}, "must be > 0"),
        ({"elements": 100, "oracle": "delphi"}, "delphi"),
    ]:
        with pytest.raises(ValueError, match=message):
            infoscene.refine("lit-cube", **options)


def test_refined_light_of_a_furnace_is_that_of_the_furnace():
    light = infoscene.refine(cube(1), reflectance=0.5, emittance=1.0, elements=100, exact=True)
    assert np.abs(light.values - 2).max() < 1e-10
    assert light.faces == list(range(6)) and sum(light.elements) >= 100


def test_the_refined_mesh_is_a_mesh_with_the_light_of_the_faces():
    pv = pytest.importorskip("pyvista")
    light = infoscene.refine("lit-cube", elements=60)
    F = infoscene.form_factors(light.mesh)
    assert len(F) == light.steps[-1].elements and F.check().closed
    # means over the elements of each face
    power = np.bincount(light.element_faces, F.areas * light.element_values)
    assert power / np.bincount(light.element_faces, F.areas) == pytest.approx(
        light.values, rel=1e-12
    )
    mesh = light.polydata()
    assert isinstance(mesh, pv.PolyData) and mesh.n_cells == len(F)
    assert mesh.compute_cell_sizes()["Area"] == pytest.approx(F.areas, rel=1e-6)
