"""Contact sheet as scenes are rendered (PyBullet EGL).

`sheet.py OUT.png [--floor SURFACE] [ID|CATEGORY|FAMILY...]`

Per model: framed; every other variant, or the joints opened; then a 96-pixel crop, doubled, of a
640x480, 60-degree frame from 1.5 m (things over half a metre: 3.3 m, 256-pixel crop).
Needs pybullet, pillow, numpy, PyYAML, trimesh.
"""

from __future__ import annotations

import importlib.util
import json
import math
import shutil
import sys
import tempfile
from pathlib import Path

import numpy as np
import pybullet as p
import yaml
from assemble import ASSETS
from PIL import Image, ImageDraw

CELL, ACROSS, LIGHT = 256, 8, [20, -35, 100]


def glb_parts(path: Path) -> dict[str, tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]]:
    """Node name -> positions, normals (Z up), UV (v up), triangles."""
    raw = path.read_bytes()
    length = int.from_bytes(raw[12:16], "little")
    document, blob = json.loads(raw[20 : 20 + length]), raw[28 + length :]

    def read(index: int, kind: str, width: int) -> np.ndarray:
        a = document["accessors"][index]
        start = document["bufferViews"][a["bufferView"]]["byteOffset"]
        return np.frombuffer(blob, kind, a["count"] * width, start).reshape(-1, width)

    out = {}
    for node in document["nodes"]:
        primitive = document["meshes"][node["mesh"]]["primitives"][0]
        at = primitive["attributes"]
        position, normal = (
            read(at[k], "<f4", 3)[:, [0, 2, 1]] * [1, -1, 1] for k in ("POSITION", "NORMAL")
        )
        uv = read(at["TEXCOORD_0"], "<f4", 2) * [1, -1] + [0, 1]
        out[node["name"]] = (
            position,
            normal,
            uv,
            read(primitive["indices"], "<u2", 1).reshape(-1, 3),
        )
    return out


class Studio:
    """A PyBullet world with a floor, and models unpacked to OBJ in a scratch folder."""

    def __init__(self, folder: Path, surface: str = ""):
        self.folder = folder
        p.connect(p.DIRECT)
        p.loadPlugin(importlib.util.find_spec("eglRenderer").origin, "_eglRendererPlugin")
        if surface:
            shutil.copy(ASSETS / "textures" / f"{surface}.png", folder / "floor.png")
        rng = np.random.default_rng(0)
        grain = np.array([196, 188, 176]) + rng.normal(0, 2.5, (256, 256, 1))
        if not surface:
            Image.fromarray(grain.clip(0, 255).astype("uint8")).save(folder / "floor.png")
        corners = np.array([(-6, -6, 0), (6, -6, 0), (6, 6, 0), (-6, 6, 0)], float)
        uv = np.array([(0, 0), (12, 0), (12, 12), (0, 12)], float)
        up = np.tile([0, 0, 1.0], (4, 1))
        self.floor = self._obj(
            "floor", corners, up, uv, np.array([(0, 1, 2), (0, 2, 3)]), folder / "floor.png"
        )
        for _ in range(3):  # the first frames of a process differ by a rounding level
            p.getCameraImage(32, 32, renderer=p.ER_BULLET_HARDWARE_OPENGL)

    def _obj(self, name, position, normal, uv, faces, texture: Path) -> Path:
        path = self.folder / f"{name}.obj"
        if texture.parent != self.folder:  # the MTL's path must be relative
            shutil.copy(texture, self.folder / texture.name)
        path.with_suffix(".mtl").write_text(f"newmtl m\nKd 1 1 1\nmap_Kd {texture.name}\n")
        lines = [f"mtllib {name}.mtl", "usemtl m"]
        for tag, rows in (("v", position), ("vt", uv), ("vn", normal)):
            lines += [tag + "".join(f" {x:.6f}" for x in row) for row in rows]
        lines += ["f " + " ".join(f"{i}/{i}/{i}" for i in face + 1) for face in faces.astype(int)]
        path.write_text("\n".join(lines) + "\n")
        return path

    def load(self, entry: dict, variant: str = "default", opened: float = 0.0) -> np.ndarray:
        """Put a model into an empty world; returns its points."""
        p.resetSimulation()
        self._body(self.floor, [1, 1, 1, 1], [0, 0, 0], [0, 0, 0, 1])
        joints = {j["name"]: j for j in entry["joints"]}
        wanted, points = entry["variants"][variant], []
        geometry = glb_parts(ASSETS / entry["mesh"])
        for part in entry["parts"]:
            name = part["name"]
            if name not in wanted:
                continue
            shift, turn = np.zeros(3), [0, 0, 0, 1]
            if part.get("joint"):
                j = joints[part["joint"]]
                value, axis, origin = (
                    opened * j["upper"],
                    np.array(j["axis"]),
                    np.array(j["origin_m"]),
                )
                if j["type"] == "revolute":
                    turn = p.getQuaternionFromAxisAngle(axis.tolist(), value)
                    shift = origin - np.reshape(p.getMatrixFromQuaternion(turn), (3, 3)) @ origin
                else:
                    shift = axis * value
            position, normal, uv, faces = geometry[name]
            path = self._obj(
                f"{entry['id']}.{name}", position, normal, uv, faces, ASSETS / entry["texture"]
            )
            self._body(path, part.get("rgba", [1, 1, 1, 1]), shift, turn)
            points.append(position @ np.reshape(p.getMatrixFromQuaternion(turn), (3, 3)).T + shift)
        return np.concatenate(points)

    @staticmethod
    def _body(path: Path, rgba, shift, turn) -> None:
        shape = p.createVisualShape(
            p.GEOM_MESH, fileName=str(path), rgbaColor=rgba, specularColor=[0, 0, 0]
        )
        p.createMultiBody(0, -1, shape, list(shift), list(turn))

    @staticmethod
    def photo(eye, target, fov: float, width: int, height: int, near: float) -> Image.Image:
        view = p.computeViewMatrix(list(eye), list(target), [0, 0, 1])
        lens = p.computeProjectionMatrixFOV(fov, width / height, near, 30)
        rgb = p.getCameraImage(
            width * 2,
            height * 2,
            view,
            lens,
            renderer=p.ER_BULLET_HARDWARE_OPENGL,
            lightDirection=LIGHT,
        )[2]
        pixels = np.reshape(rgb, (2 * height, 2 * width, 4))[..., :3].astype("uint8")
        return Image.fromarray(pixels).resize((width, height), Image.BOX)

    def framed(self, points: np.ndarray, yaw: float, pitch: float) -> Image.Image:
        centre, d, fov = (points.min(0) + points.max(0)) / 2, direction(yaw, pitch), 28
        right = np.cross([0, 0, 1], d)
        right /= np.linalg.norm(right)
        up, q = np.cross(d, right), points - centre
        size = max(abs(q @ right).max(), abs(q @ up).max())
        away = size * 1.13 / math.tan(math.radians(fov / 2)) + max(0, (q @ d).max()) * 0.6
        return self.photo(centre + d * away, centre, fov, CELL, CELL, max(0.01, away * 0.1))

    def from_afar(self, points: np.ndarray, yaw: float, pitch: float) -> Image.Image:
        large = np.ptp(points, axis=0).max() > 0.5
        centre, away, crop = (
            (points.min(0) + points.max(0)) / 2,
            3.3 if large else 1.5,
            128 if large else 48,
        )
        picture = self.photo(
            centre + direction(yaw, max(pitch, 30)) * away, centre, 60, 640, 480, 0.02
        )
        return picture.crop((320 - crop, 240 - crop, 320 + crop, 240 + crop)).resize(
            (CELL, CELL), Image.NEAREST
        )


def direction(yaw: float, pitch: float) -> np.ndarray:
    """From the target to the camera; yaw 0 looks at the front (+X)."""
    y, t = math.radians(yaw), math.radians(pitch)
    return np.array([math.cos(y) * math.cos(t), math.sin(y) * math.cos(t), math.sin(t)])


def row_of(studio: Studio, entry: dict) -> list[Image.Image]:
    x, y, z = entry["extents_m"]
    pitch = 50 if z < 0.35 * max(x, y) else 25
    points = studio.load(entry)
    tiles = [studio.framed(points, 30, pitch)]
    for variant in entry["variants"]:
        if variant != "default":
            tiles.append(studio.framed(studio.load(entry, variant), 30, pitch))
    if entry["joints"]:
        tiles.append(studio.framed(studio.load(entry, "default", 0.8), 30, pitch))
    tiles.append(studio.from_afar(studio.load(entry), 30, pitch))
    for tile in tiles:
        ImageDraw.Draw(tile).text((4, 4), entry["id"], fill="black")
    return tiles


def main(out: str, words: list[str]) -> None:
    surface = ""
    if "--floor" in words:
        k = words.index("--floor")
        surface = words[k + 1]
        words = words[:k] + words[k + 2 :]
    entries = yaml.safe_load((ASSETS / "manifest.yaml").read_text())["assets"]
    chosen = [
        e
        for e in entries
        if not words
        or {e["id"], e["category"], e["source"].split(":")[-1].split(".")[0]} & set(words)
    ]
    with tempfile.TemporaryDirectory() as folder:
        studio = Studio(Path(folder), surface)
        rows = [row_of(studio, e) for e in chosen]
    placed, x, y = [], 0, 0
    for tiles in rows:  # flow: as many models a line as fit
        if x and x + len(tiles) * CELL > ACROSS * CELL:
            x, y = 0, y + CELL + 4
        for tile in tiles:
            placed.append((tile, x, y))
            x += CELL
        x += 4
    sheet = Image.new("RGB", ((ACROSS + 1) * CELL, y + CELL), "white")
    for tile, left, top in placed:
        sheet.paste(tile, (left, top))
    sheet.save(out)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
