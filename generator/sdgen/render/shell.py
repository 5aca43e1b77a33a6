"""Floors, walls and ceilings as OBJ files with flat normals and textures in metres."""

from __future__ import annotations

import hashlib
import shutil
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sdgen.geometry import Array, vec3
from sdgen.scene import Box, Structure

#: Outward normals of a box's six faces.
_NORMALS = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))

#: Where the light stands, from the world's origin. Almost overhead and far away: soft shadows
#: where things touch, and walls, which must be opaque to hide what is behind them, throw a strip
#: of shadow a forearm wide.
LIGHT_M = (12.0, -14.0, 100.0)

# How bright each face of the shell is drawn, as a share of its texture, in _NORMALS' order: a
# little different from wall to wall, so that corners can be seen. Floors take the shader's light.
_LEVEL = {
    "floor": (1.0,) * 6,
    "wall": (0.90, 0.96, 0.94, 0.88, 0.80, 0.70),
    "ceiling": (0.97,) * 6,
}

# Walls lie about that they look down a little: what faces away from the light gets no highlight
# and no shadow in Bullet's shader, which paints ugly ones on walls along the light.
_WALL_DIP = -0.35


@dataclass(frozen=True)
class Face:
    """All faces of a structure that look one way: a mesh, and the colour factor that brings it
    to the brightness it should have under the plugin's shader."""

    normal: tuple[float, float, float]
    vertices_m: Array
    uvs: Array
    brightness: float


def structure_faces(structure: Structure, tile_m: float) -> list[Face]:
    """Quads of the structure's boxes, grouped by direction; four vertices a quad.

    Texture coordinates are world metres / ``tile_m``, so the pattern runs on across pieces.
    Floors show their top and ceilings their underside only: nothing sees the rest.
    """
    wanted = {"floor": (4,), "ceiling": (5,), "wall": (0, 1, 2, 3, 4, 5)}[structure.category]
    out = []
    for index in wanted:
        quads = np.concatenate([_quad(piece, index) for piece in structure.pieces])
        across, up = ((1, 2), (0, 2), (0, 1))[index // 2]
        uvs = quads[:, [across, up]] / tile_m
        normal = _lit_normal(structure.category, index)
        brightness = _LEVEL[structure.category][index] / _shade(normal)
        out.append(Face(normal, quads, uvs, brightness))
    return out


def _lit_normal(category: str, index: int) -> tuple[float, float, float]:
    normal = np.asarray(_NORMALS[index], dtype=float)
    if category == "wall" and index < 4:
        normal[2] = _WALL_DIP
        normal /= np.linalg.norm(normal)
    return vec3(normal)


def _shade(normal: tuple[float, float, float]) -> float:
    """What Bullet's shader makes of a white face without highlight (useShadowMapInstancingPS)."""
    light = np.asarray(LIGHT_M) / np.linalg.norm(LIGHT_M)
    half_lambert = 0.5 + 0.5 * float(light @ np.asarray(normal))
    return 0.5 + 0.5 * half_lambert * (0.7 if half_lambert < 0.5 else 1.0)


def _quad(piece: Box, index: int) -> Array:
    """Corners of one face, counter-clockwise seen from outside."""
    centre, half = np.asarray(piece.center_m), np.asarray(piece.size_m) / 2
    normal = np.asarray(_NORMALS[index], dtype=float)
    axis = index // 2
    first = np.eye(3)[(axis + 1) % 3]
    second = np.cross(normal, first)
    corners = [
        centre + half * (normal + a * first + b * second)
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    return np.array(corners)


def face_obj(face: Face, mtl: str) -> str:
    """The face group as a Wavefront OBJ of triangles."""
    lines = [f"mtllib {mtl}", "usemtl m"]
    lines += [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in face.vertices_m]
    lines += [f"vt {u:.5f} {v:.5f}" for u, v in face.uvs]
    lines.append("vn {:.4f} {:.4f} {:.4f}".format(*face.normal))
    for base in range(1, len(face.vertices_m) + 1, 4):
        for triangle in ((base, base + 1, base + 2), (base, base + 2, base + 3)):
            lines.append("f " + " ".join(f"{k}/{k}/1" for k in triangle))
    return "\n".join(lines) + "\n"


class ShellFolder:
    """Writes shell meshes into a folder, named by content, one MTL a texture."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def write(self, face: Face, texture: Path) -> Path:
        """OBJ file of a face group that wears ``texture``."""
        image = self._folder / texture.name
        mtl = self._folder / f"{texture.stem}.mtl"
        if not mtl.exists():
            shutil.copyfile(texture, image)
            mtl.write_text(
                f"newmtl m\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nmap_Kd {image.name}\n", encoding="utf-8"
            )
        text = face_obj(face, mtl.name)
        name = hashlib.sha256(text.encode("utf-8")).hexdigest()[:20]
        path = self._folder / f"{name}.obj"
        if not path.exists():
            path.write_text(text, encoding="utf-8")
        return path
