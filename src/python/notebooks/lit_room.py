# %% [markdown]
# # A room with a lamp and a pillar: form factors, light, and how far to trust both
#
# Cells as in a notebook (Jupytext, VS Code, Spyder), or at once:
#
#     pip install . pyvista
#     python src/python/notebooks/lit_room.py lit-room.png
#
# It draws the room from above, one wall taken away, coloured by radiosity.

# %%
import sys

import infoscene
import numpy as np
import pyvista as pv

# %% [markdown]
# The room, seen from inside: each wall is a grid, so that light can vary over it, from a corner
# along two edges that turn counter-clockwise for who stands in the room.

# %%
SIDE = 12


def wall(corner, first, second):
    """A grid on a rectangle whose front is where `first × second` points."""
    steps = np.linspace(0, 1, SIDE + 1)
    u, v = np.meshgrid(steps, steps, indexing="ij")
    points = np.array(corner) + u.reshape(-1, 1) * first + v.reshape(-1, 1) * second
    corners = np.arange((SIDE + 1) ** 2).reshape(SIDE + 1, SIDE + 1)
    here, along, up = corners[:-1, :-1], corners[1:, :-1], corners[:-1, 1:]
    faces = np.stack([here, along, corners[1:, 1:], up], axis=-1).reshape(-1, 4)
    return pv.PolyData.from_regular_faces(points, faces)


x, y, z = np.diag([4.0, 3.0, 2.5])
walls = {
    "floor": wall((0, 0, 0), x, y),
    "ceiling": wall((0, 0, 2.5), y, x),
    "left": wall((0, 0, 0), y, z),
    "right": wall((4, 0, 0), z, y),
    "near": wall((0, 0, 0), z, x),
    "far": wall((0, 3, 0), x, z),
}
room = pv.PolyData().append_polydata(*walls.values())
name = np.repeat(list(walls), SIDE * SIDE)

# a pillar from the floor to the ceiling: it only stands in the way, and is black
pillar = pv.Box((2.5, 2.9, 1.3, 1.7, 0, 2.5))

# %% [markdown]
# Materials by face: a lamp on the ceiling, a red and a green wall.

# %%
centers = room.cell_centers().points
beside = np.abs(centers[:, :2] - 1.5).max(axis=1)
lamp = (name == "ceiling") & (beside < 0.5)
colour = {"left": (0.65, 0.08, 0.06), "right": (0.14, 0.45, 0.1)}
reflectance = np.array([colour.get(one, (0.75, 0.75, 0.75)) for one in name])
reflectance[lamp] = 0
emittance = np.where(lamp, 20.0, 0.0)

# %% [markdown]
# Form factors are asked for to six digits: that is enough for a picture. `F[i, j]` is from i to j;
# what rows lack to 1 falls on the pillar.

# %%
scene = infoscene.Scene(room, obstacles=pillar)
accuracy = {"tolerance": 1e-6, "absolute": 1e-9}
light = infoscene.radiosity(scene, reflectance, emittance, **accuracy)
worst = float((light.bounds / light.values).max())
print(f"{room.n_cells} faces, radiosities right to {worst:.0e} for this mesh")
print(f"{light.emitted:.3f} emitted, {light.absorbed:.3f} absorbed")
print(f"{light.escaped:.3f} on the pillar")

# %% [markdown]
# Results are columns of the mesh. The ceiling and the near wall are left out of the picture.

# %%
room.cell_data.update(light.cell_data())
shown = room.extract_cells(np.flatnonzero(~np.isin(name, ["ceiling", "near"])))
rgb = shown.cell_data["radiosity_rgb"]
shown.cell_data["seen"] = np.clip(rgb / np.percentile(rgb, 98), 0, 1) ** (1 / 2.2)

plotter = pv.Plotter(off_screen=True, window_size=(960, 640))
plotter.add_mesh(shown, scalars="seen", rgb=True, lighting=False)
plotter.add_mesh(pillar, color="black", lighting=False)
plotter.camera_position = [(2, -5.6, 4.4), (2, 1.6, 1.0), (0, 0, 1)]
plotter.screenshot(sys.argv[1] if len(sys.argv) > 1 else "lit-room.png")
