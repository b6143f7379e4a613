"""Form factors of a cube of 600 faces, from Python, beside the command and beside pyviewfactor.

    python benches/python.py PROGRAM

All is timed in one process and in turns, and every matrix is checked before its time is told. The
command's time is that of a process which reads an OBJ file and writes an NPY file; that of a call
is the call's alone. Without pyviewfactor and pyvista that comparison is left out.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

import infoscene
import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "python"))
from conftest import cube  # noqa: E402

ROUNDS = 15


def timed(work):
    start = time.perf_counter()
    answer = work()
    return time.perf_counter() - start, answer


def of_command(program, folder):
    """Runs the command on the file in a folder; the matrix that it has written."""
    matrix = folder / "F.npy"
    arguments = [program, "form-factor", folder / "cube.obj", "--matrix", matrix]
    subprocess.run(arguments, check=True, capture_output=True)
    return np.load(matrix)


def beside_the_command(program, vertices, faces):
    calls, runs = [], []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
        lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in faces]
        (folder / "cube.obj").write_text("\n".join(lines) + "\n")
        for _ in range(ROUNDS):
            seconds, F = timed(lambda: infoscene.form_factors((vertices, faces)))
            calls.append(seconds)
            seconds, matrix = timed(lambda: of_command(program, folder))
            runs.append(seconds)
            # two doors to one computation
            assert np.array_equal(F.values, matrix)
    # 600 roundings of NumPy's sum
    slack = F.bounds.sum(axis=1) + 600 * np.finfo(float).eps
    assert (np.abs(F.values.sum(axis=1) - 1) <= slack).all()
    call, run = median(calls), median(runs)
    print(f"a call {call:.4f} s, the command {run:.4f} s: {call / run:.2f} x (limit 1.2)")
    return call, F


def beside_pyviewfactor(call, F, vertices, faces):
    try:
        import pyviewfactor
        import pyvista
    except ImportError as missing:
        print(f"pyviewfactor is left out: {missing}")
        return

    def theirs(mesh):
        return pyviewfactor.compute_viewfactor_matrix(mesh, skip_obstruction=True)

    # the first call compiles
    theirs(pyvista.PolyData.from_regular_faces(*cube(1)))
    mesh = pyvista.PolyData.from_regular_faces(vertices, faces)
    seconds, matrix = timed(lambda: theirs(mesh))
    # F[i, j] is from j to i there; its quadrature is right to 1e-6 where faces share an edge
    assert np.abs(matrix.T - F.values).max() < 1e-5
    ratio = seconds / call
    print(f"pyviewfactor, compiled before: {seconds:.2f} s, {ratio:.0f} x a call (limit 50)")


def main():
    vertices, faces = cube(10)
    call, F = beside_the_command(sys.argv[1], vertices, faces)
    beside_pyviewfactor(call, F, vertices, faces)


if __name__ == "__main__":
    main()
