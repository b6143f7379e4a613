"""The example in the documentation runs, conserves power and draws a red wall."""

import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT

EXAMPLE = ROOT / "src" / "python" / "notebooks" / "lit_room.py"


def test_the_example_draws_a_lit_room(tmp_path):
    pv = pytest.importorskip("pyvista")
    text = EXAMPLE.read_text()
    assert "SIDE = 12\n" in text
    script, picture = tmp_path / "lit_room.py", tmp_path / "room.png"
    script.write_text(text.replace("SIDE = 12\n", "SIDE = 4\n"))
    run = subprocess.run([sys.executable, script, picture], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    emitted, absorbed, pillar = map(
        float, re.findall(r"(\d+\.\d+) (?:emitted|absorbed|on)", run.stdout)
    )
    assert emitted == pytest.approx(absorbed + pillar, abs=2e-3) and pillar > 0
    pixels = np.asarray(pv.read(picture)["PNGImage"]).astype(float)
    red, green = (pixels[:, k] > 1.2 * pixels[:, j] + 10 for k, j in ((0, 1), (1, 0)))
    dark = pixels.sum(axis=1) < 10
    # the left wall, the right wall and the pillar
    assert all(part.mean() > 0.01 for part in (red, green, dark)), pixels.mean(axis=0)
