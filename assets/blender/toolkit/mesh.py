"""`Mesh`: plain arrays with two UV layouts, before anything becomes a Blender object."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import bmesh
import numpy as np
from mathutils import Euler

UV = tuple[float, float]


class Mesh:
    """Vertices, faces, a material index per face, and two UV layouts given per face corner.

    label_uv  where a drawn label sits (0..1, v up); None: no label
    bake_uv   island layout for the baked atlas, any scale; None: Blender's smart projection
    weight    texture resolution this mesh deserves, relative to the others
    """

    def __init__(
        self,
        vertices: Sequence,
        faces: Sequence,
        material_of_face: Sequence[int] | None = None,
        materials: Sequence = (),
        label_uv: list[list[UV]] | None = None,
        bake_uv: list[list[UV]] | None = None,
        weight: float = 1.0,
        smooth: bool = True,
    ):
        self.v = np.asarray(vertices, float)
        self.f = [tuple(int(i) for i in face) for face in faces]
        self.mi = list(material_of_face) if material_of_face is not None else [0] * len(self.f)
        self.mats = list(materials)
        self.label_uv = label_uv
        self.bake_uv = bake_uv
        self.weight = weight
        self.smooth = smooth
        self.rest: np.ndarray | None = None  # pattern coordinates, if not those of the vertices

    # ---- transforms: in place, chainable
    def move(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Mesh:
        self.v = self.v + np.array([x, y, z])
        return self

    def turn(self, rx: float = 0.0, ry: float = 0.0, rz: float = 0.0, pivot=(0, 0, 0)) -> Mesh:
        """Rotate by Euler angles (XYZ, radians) about a pivot."""
        matrix = np.array(Euler((rx, ry, rz)).to_matrix())
        self.v = (self.v - pivot) @ matrix.T + pivot
        return self

    def scale(self, x: float, y: float | None = None, z: float | None = None) -> Mesh:
        factors = [x, x if y is None else y, x if z is None else z]
        self.v = self.v * factors
        return self.flip() if np.prod(factors) < 0 else self

    def warp(self, function: Callable) -> Mesh:
        """Replace every vertex by function(x, y, z)."""
        self.v = np.array([function(*p) for p in self.v])
        return self

    def flip(self) -> Mesh:
        self.f = [face[::-1] for face in self.f]
        for name in ("label_uv", "bake_uv"):
            layout = getattr(self, name)
            if layout is not None:
                setattr(self, name, [corner[::-1] for corner in layout])
        return self

    # ---- settings: in place, chainable
    def weigh(self, weight: float) -> Mesh:
        self.weight = weight
        return self

    def keep_pattern(self) -> Mesh:
        """From now on moving the mesh no longer moves it through its material's pattern."""
        self.rest = self.v.copy()
        return self

    def flat(self) -> Mesh:
        self.smooth = False
        return self

    def copy(self) -> Mesh:
        twin = Mesh(
            self.v.copy(),
            self.f,
            self.mi,
            self.mats,
            self.label_uv,
            self.bake_uv,
            self.weight,
            self.smooth,
        )
        twin.rest = None if self.rest is None else self.rest.copy()
        return twin

    def keep_faces(self, keep: Sequence[int]) -> None:
        for name in ("f", "mi", "label_uv", "bake_uv"):
            values = getattr(self, name)
            if values is not None:
                setattr(self, name, [values[i] for i in keep])

    def signed_volume(self) -> float:
        total = 0.0
        for face in self.f:
            a = self.v[face[0]]
            for i in range(1, len(face) - 1):
                total += float(np.dot(a, np.cross(self.v[face[i]], self.v[face[i + 1]])))
        return total / 6

    def is_closed(self) -> bool:
        """Whether every edge is shared by two faces running opposite ways."""
        edges = {(a, b) for f in self.f for a, b in zip(f, f[1:] + f[:1], strict=True)}
        return all((b, a) in edges for a, b in edges)

    def outward(self) -> Mesh:
        """Flip a closed mesh that is inside out (it would bake black and be culled)."""
        return self.flip() if self.signed_volume() < 0 else self


def face_normal(points: np.ndarray) -> np.ndarray:
    """Unnormalised normal of a planar polygon."""
    return sum(
        np.cross(points[i] - points[0], points[i + 1] - points[0])
        for i in range(1, len(points) - 1)
    )


def cube_project(mesh: Mesh) -> Mesh:
    """Bake islands by dominant axis: bevel strips stay with a neighbour, labels stay unskewed."""
    layout = []
    span = 4 * float(np.ptp(mesh.v, axis=0).max())
    for face in mesh.f:
        points = mesh.v[list(face)]
        normal = face_normal(points)
        axis = int((np.abs(normal) * [1.0, 1.02, 1.04]).argmax())
        positive = int(normal[axis] >= 0)
        i, j = [(1, 2), (0, 2), (0, 1)][axis]
        mirror = 1 if (axis, positive) in ((0, 1), (1, 0), (2, 1)) else -1
        shift = (axis * 2 + positive) * span
        layout.append([(shift + p[i] * mirror, p[j]) for p in points])
    mesh.bake_uv = layout
    return mesh


def bevel(mesh: Mesh, width: float, segments: int = 1, sharper_than_deg: float = 30) -> Mesh:
    """Round the sharp edges; labels survive, bake islands are projected anew."""
    bm = bmesh.new()
    verts = [bm.verts.new(p) for p in mesh.v]
    layer = bm.loops.layers.uv.new("label")
    for i, face in enumerate(mesh.f):
        new = bm.faces.new([verts[j] for j in face])
        new.material_index = mesh.mi[i]
        if mesh.label_uv:
            for loop, uv in zip(new.loops, mesh.label_uv[i], strict=True):
                loop[layer].uv = uv
    bm.normal_update()
    limit = math.radians(sharper_than_deg)
    edges = [e for e in bm.edges if len(e.link_faces) == 2 and e.calc_face_angle(0) > limit]
    bmesh.ops.bevel(
        bm,
        geom=edges,
        offset=width,
        segments=segments,
        profile=0.5,
        affect="EDGES",
        clamp_overlap=True,
        loop_slide=True,
        material=-1,
    )
    result = from_bmesh(bm, mesh.mats)
    result.weight, result.smooth = mesh.weight, mesh.smooth
    return cube_project(result)


def from_bmesh(bm: bmesh.types.BMesh, materials: Sequence = ()) -> Mesh:
    """Take a bmesh over (and free it)."""
    bm.verts.index_update()
    layer = bm.loops.layers.uv.get("label")
    result = Mesh(
        [v.co[:] for v in bm.verts],
        [[v.index for v in f.verts] for f in bm.faces],
        [f.material_index for f in bm.faces],
        materials,
        [[loop[layer].uv[:] for loop in f.loops] for f in bm.faces] if layer else None,
    )
    bm.free()
    return result
