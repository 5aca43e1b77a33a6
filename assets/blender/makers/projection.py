"""Putting a drawn label on faces that look one way, by flat projection."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from toolkit.materials import Material
from toolkit.mesh import Mesh, face_normal

# seen from outside: which coordinate runs to the right and which up, and their signs
_VIEWS = {
    "+x": (1, 1, 2, 1),
    "-x": (1, -1, 2, 1),
    "+y": (0, -1, 2, 1),
    "-y": (0, 1, 2, 1),
    "+z": (1, 1, 0, -1),  # upright for somebody looking from the front, +X
    "-z": (1, 1, 0, 1),
}


def project_label(
    mesh: Mesh,
    material: Material,
    side: str,
    centre: tuple[float, float],
    size: tuple[float, float],
    facing: float = 0.5,
    only: Callable[[np.ndarray], bool] | None = None,
) -> Mesh:
    """Give the faces that look towards `side` a label material.

    centre, size: where the label lies, in (right, up) coordinates of that view (metres, the right
    axis as seen from outside). only: a test on a face's centre, to leave some faces out.
    """
    right, right_sign, up, up_sign = _VIEWS[side]
    axis = "xyz".index(side[1])
    sign = 1 if side[0] == "+" else -1
    if material not in mesh.mats:
        mesh.mats.append(material)
    number = mesh.mats.index(material)
    if mesh.label_uv is None:
        mesh.label_uv = [[(0.0, 0.0)] * len(face) for face in mesh.f]
    for i, face in enumerate(mesh.f):
        points = mesh.v[list(face)]
        normal = face_normal(points)
        normal = normal / (np.linalg.norm(normal) + 1e-12)
        if normal[axis] * sign < facing or (only and not only(points.mean(0))):
            continue
        mesh.mi[i] = number
        mesh.label_uv[i] = [
            (
                (p[right] * right_sign - centre[0]) / size[0] + 0.5,
                (p[up] * up_sign - centre[1]) / size[1] + 0.5,
            )
            for p in points
        ]
    return mesh
