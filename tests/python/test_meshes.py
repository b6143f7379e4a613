"""Meshes of any kind are the same mesh; what is none is refused, with face and mend."""

import pickle

import infoscene
import numpy as np
import pytest
from conftest import cube, squares


@pytest.fixture(scope="module")
def expected():
    return infoscene.form_factors(cube(2)).values


def test_meshes_of_other_libraries_are_taken(expected):
    vertices, faces = cube(2)
    meshio, pv = pytest.importorskip("meshio"), pytest.importorskip("pyvista")
    for mesh in (
        pv.PolyData.from_regular_faces(vertices, faces),
        meshio.Mesh(vertices, [("quad", faces[:10]), ("line", [[0, 1]]), ("quad", faces[10:])]),
        infoscene.Scene((vertices, faces)),
    ):
        assert np.array_equal(infoscene.form_factors(mesh).values, expected)


def test_trimesh_is_taken():
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box()
    box.invert()
    F = infoscene.form_factors(box)
    assert F.shape == (12, 12) and F.check().closed
    # two triangles of a wall are joined, in whichever order
    joined = infoscene.form_factors(infoscene.Scene(box, join=True))
    cubes = infoscene.form_factors(cube(1))
    assert np.abs(np.sort(joined.values, axis=1) - np.sort(cubes.values, axis=1)).max() < 1e-14


def test_pyvista_points_of_32_bits_are_rounded_ones():
    pv = pytest.importorskip("pyvista")
    vertices, faces = cube(2)
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)  # a rotation, not a reflection
    mesh = pv.PolyData.from_regular_faces((vertices @ turn).astype(np.float32), faces)
    F = infoscene.form_factors(mesh)
    # 24 bits of coordinates up to 2
    assert 0 < F.resolution < 1e-6
    exact = infoscene.form_factors(cube(2)).values
    assert (np.abs(F.values - exact) <= F.resolution_bounds + F.bounds).all()
    assert F.resolution_bounds.max() < 1e-4


def test_ragged_faces_come_as_lists_or_by_offsets():
    pv = pytest.importorskip("pyvista")
    # the cube, one face of which is cut into two triangles
    vertices, faces = cube(1)
    lists = [*faces[:5].tolist(), faces[5][[0, 1, 2]].tolist(), faces[5][[0, 2, 3]].tolist()]
    corners, offsets = np.concatenate(lists), [0, 4, 8, 12, 16, 20, 23, 26]
    padded = np.concatenate([[len(face), *face] for face in lists])
    answers = [
        infoscene.form_factors(mesh).values
        for mesh in (
            (vertices, lists),
            (vertices, corners, offsets),
            (vertices, corners.astype(np.int32), np.array(offsets, np.uint8)),
            pv.PolyData(vertices, padded),
        )
    ]
    whole = infoscene.form_factors(cube(1)).values
    for answer in answers:
        assert np.array_equal(answer, answers[0])
        # the two triangles take what the square took
        assert np.abs(answer[:5, 5] + answer[:5, 6] - whole[:5, 5]).max() < 1e-14


def test_arrays_of_any_layout_are_taken(expected):
    vertices, faces = cube(2)
    raw = np.empty(vertices.nbytes + 1, np.uint8)
    misaligned = raw[1:].view(vertices.dtype).reshape(vertices.shape)
    misaligned[:] = vertices
    assert not misaligned.flags.aligned
    frozen = vertices.copy()
    frozen.setflags(write=False)
    wide = np.zeros((2 * len(vertices), 5))
    wide[::2, 1:4] = vertices
    whole = (2 * vertices).astype(np.int16)  # 0, 1 and 2
    for given in (
        misaligned,
        frozen,
        np.asfortranarray(vertices),
        wide[::2, 1:4],
        vertices.astype(">f8"),
        vertices.astype(np.longdouble),
        vertices.astype(np.float32),
        vertices.astype(np.float16),
        whole,
        vertices.tolist(),
    ):
        values = infoscene.form_factors((given, faces.astype(">i4"))).values
        assert np.abs(values - expected).max() < 1e-14


def test_a_scene_survives_pickling(expected):
    scene = pickle.loads(
        pickle.dumps(infoscene.Scene(cube(2), obstacles=[squares()], reverse=True))
    )
    assert scene.reverse and len(scene.obstacles) == 1
    F = infoscene.form_factors(infoscene.Scene(cube(2)))
    again = pickle.loads(pickle.dumps(F))
    assert np.array_equal(again.values, expected) and again.names[3] == "face 3"


def test_faces_are_refused_with_number_and_mend():
    vertices, faces = cube(1)
    bent = vertices.copy()
    bent[faces[1][0]] += [0.1, 0.2, 0.3]
    hole = vertices.copy()
    hole[faces[2][3], 1] = np.nan
    crossed, wide = faces.copy(), vertices.copy()
    crossed[4] = crossed[4][[0, 2, 1, 3]]
    wide[faces[4][2]] += [0.5, 0.2, 0.0]
    for mesh, message in [
        ((bent, faces), r"face 1\).*off the plane.*Scene\(…, triangulate=True\) does"),
        ((hole, faces), r"face 2\).*NaN.*mend the vertex"),
        ((wide, crossed), r"face 4\).*cross or touch.*reorder or split the face"),
        (
            (vertices, faces + 1),
            r"face 5\): corner . is vertex 24, and there are 24: count them from 0, up to 23$",
        ),
        ((vertices, faces - 1), r"face 0\): corner . is vertex -1"),
        ((vertices, [*faces.tolist(), [0, 1]]), r"face 6\).*at least 3 corners.*add corners"),
        ((vertices, faces.ravel(), [0, 4, 3, 24]), r"offset 2 is 3"),
        ((vertices, faces.ravel(), [0, 4, 8]), r"offset 2 is 8.*number of corners, 24"),
        ((vertices, faces.ravel(), [4, 24]), r"offset 0 is 4"),
        (
            (vertices, np.vstack([faces, faces[:1]])),
            r"patches 0 \(face 0\) and 6 \(face 6\).*overlap",
        ),
    ]:
        with pytest.raises(ValueError, match=message):
            infoscene.form_factors(mesh)


def test_a_bent_face_is_triangulated_on_request_and_stays_one_row():
    vertices, faces = cube(2)
    # the middles of the walls moved outwards: a quarter of a wall is no longer planar
    middle = np.isclose(np.abs(vertices - 0.5).sum(axis=1), 0.5)
    bulged = vertices + 0.1 * (vertices - 0.5) * middle[:, None]
    with pytest.raises(ValueError, match="triangulate=True"):
        infoscene.form_factors((bulged, faces))
    F = infoscene.form_factors(infoscene.Scene((bulged, faces), triangulate=True))
    assert F.shape == (24, 24) and F.check().closed


def test_a_face_without_area_keeps_its_number():
    vertices, faces = cube(1)
    F = infoscene.form_factors((vertices, np.vstack([faces[:1], [[0, 1, 1, 0]], faces[1:]])))
    assert F.areas.tolist() == [1, 0, 1, 1, 1, 1, 1]
    assert not F.values[1].any() and not F.values[:, 1].any()
    assert F.notes == [
        "mesh: 1 face has no area; such a face keeps its number and exchanges "
        "nothing (first: face 1)"
    ]


def test_obstacles_are_refused_by_their_own_numbers():
    vertices, faces = cube(1)
    with pytest.raises(ValueError, match=r"obstacle 1, patch 0 \(face 0\): corner 2 is vertex 9"):
        infoscene.form_factors(cube(1), obstacles=[squares(), (vertices[:4], [[0, 1, 9]])])


def test_what_is_no_mesh_is_a_type_error():
    vertices, faces = cube(1)
    pv = pytest.importorskip("pyvista")
    for given, message in [
        (3, "a int is no mesh"),
        (None, "a NoneType is no mesh"),
        ([vertices, faces], "a list is no mesh"),
        ((vertices,), "a tuple of 1"),
        ((vertices, faces.astype(float)), "give integers"),
        ((vertices.astype(complex), faces), "give numbers"),
        ((vertices.astype(str), faces), "give numbers"),
        ((vertices, [[0, 1, 2.5]]), "face 0: the type is float64"),
        ((vertices, "faces"), "no list of faces"),
        (pv.ImageData(dimensions=(3, 3, 3)), r"give its extract_surface\(\)"),
    ]:
        with pytest.raises(TypeError, match=message):
            infoscene.form_factors(given)
    for given, message in [
        ((vertices[:, :2], faces), r"vertices: the shape is \(24, 2\)"),
        ((vertices, faces.ravel()), "give a row of corners for each face"),
        ((vertices, np.empty((0, 3), int)), "no face"),
        ((np.ma.masked_equal(vertices, 0.0), faces), "some entries are masked"),
        (pv.PolyData(vertices), "has 24 verts beside its faces"),
    ]:
        with pytest.raises(ValueError, match=message):
            infoscene.form_factors(given)
    meshio = pytest.importorskip("meshio")
    with pytest.raises(ValueError, match="'tetra' are no flat faces"):
        infoscene.form_factors(meshio.Mesh(vertices, [("tetra", [[0, 1, 2, 3]])]))
    with pytest.raises(TypeError, match="an obstacle is a mesh in memory"):
        infoscene.form_factors(cube(1), obstacles="cube:1")
    with pytest.raises(TypeError, match="own obstacles"):
        infoscene.form_factors(infoscene.Scene(cube(1)), obstacles=squares())


def test_files_and_names_are_refused_as_by_the_command(tmp_path):
    path = tmp_path / "bad.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nf 1 2 3\n")
    for given, message in [
        (path, "bad.obj, line 3.*no vertex 3"),
        (tmp_path / "none.obj", "none.obj"),
        ("cubes", "no built-in scene"),
    ]:
        with pytest.raises(ValueError, match=message):
            infoscene.form_factors(given)


def test_options_are_refused_with_their_names():
    for options, message in [
        ({"tolerance": 0.0}, "tolerance"),
        ({"tolerance": float("nan")}, "tolerance"),
        ({"absolute": -1.0}, "absolute"),
        ({"threads": 0}, "threads is 0"),
        ({"sender": "flor"}, 'no patch "flor"'),
        ({"sender": 99}, 'no patch "99"'),
    ]:
        with pytest.raises(ValueError, match=message):
            infoscene.form_factors("cube:1", **options)
    for options in ({"threads": 1.5}, {"progress": 3}, {"sender": 1.5}, {"tolerance": "small"}):
        with pytest.raises(TypeError):
            infoscene.form_factors("cube:1", **options)
    for options in ({"occlusion": "some"}, {"resolution": -1.0}, {"subdivide": 9}):
        with pytest.raises(ValueError, match=next(iter(options))):
            infoscene.form_factors(infoscene.Scene("cube:1", **options))
