"""Meshes and textures of the library as files that many scenes share: OBJ and PNG, each once."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np
import numpy.typing as npt
from PIL import Image

from sdgen.geometry import Array
from sdgen.library import Library, MeshData


class ModelFiles:
    """Writes into ``folder`` what it is asked for, under names that say what it is.

    The same names for the same questions in the same order.
    """

    def __init__(self, library: Library, folder: Path) -> None:
        self._library = library
        self._folder = folder
        self._known: dict[object, str] = {}
        self._taken: set[str] = set()

    def mesh(self, asset_id: str, part: str) -> str:
        """Name of the OBJ of a part, at joint value 0 in the object's frame; models of one shape in
        several colours share it."""
        key = (self._library.folder_of(asset_id), self._library.assets[asset_id].mesh, part)
        if key not in self._known:
            name = self._known[key] = self._free(f"{asset_id}.{part}.obj")
            (self._folder / name).write_bytes(obj(self._library.mesh(asset_id)[part]))
        return self._known[key]

    def hull(self, asset_id: str, number: int) -> str:
        """Name of the OBJ of a convex collision piece, by its place among the model's."""
        asset = self._library.assets[asset_id]
        key = (self._library.folder_of(asset_id), asset.hulls, "hull", number)
        if key not in self._known:
            name = self._known[key] = self._free(f"{asset_id}.hull{number}.obj")
            points = self._library.hulls(asset_id)[number].vertices_m
            (self._folder / name).write_bytes(hull_obj(points))
        return self._known[key]

    def texture(self, path: Path, name: str) -> str:
        """Name of a texture as PNG, ``name`` unless another has it."""
        if path not in self._known:
            file = self._known[path] = self._free(f"{name}.png")
            with Image.open(path) as image:
                image.convert("RGB").save(self._folder / file, compress_level=1)
        return self._known[path]

    def once(self, key: object, name: str, content: bytes) -> str:
        """Name of any other file that scenes share, ``name`` unless another has it."""
        if key not in self._known:
            file = self._known[key] = self._free(name)
            (self._folder / file).write_bytes(content)
        return self._known[key]

    def _free(self, name: str) -> str:
        stem, dot, ending = name.rpartition(".")
        number = 1
        while name in self._taken:
            number += 1
            name = f"{stem}-{number}{dot}{ending}"
        self._taken.add(name)
        return name


def obj(mesh: MeshData, material: str | None = None) -> bytes:
    """A mesh as OBJ; corners that share a place share their texture's and normal's, too.
    ``material`` is the file of its material, which is named as the file is."""
    count = len(mesh.vertices)
    text = ""
    if material is not None:
        text = f"mtllib {material}\nusemtl {material.removesuffix('.mtl')}\n"
    text += ("v %.5f %.5f %.5f\n" * count) % tuple(mesh.vertices.ravel().tolist())
    text += ("vt %.5f %.5f\n" * count) % tuple(mesh.uvs.ravel().tolist())
    text += ("vn %.4f %.4f %.4f\n" * count) % tuple(mesh.normals.ravel().tolist())
    numbers = np.repeat(mesh.faces.ravel() + 1, 3).tolist()
    text += ("f %d/%d/%d %d/%d/%d %d/%d/%d\n" * len(mesh.faces)) % tuple(numbers)
    return text.encode("ascii")


def hull_obj(points: Array) -> bytes:
    """The convex hull of points (N, 3) as OBJ."""
    vertices, faces = hull_mesh(points)
    text = ("v %.5f %.5f %.5f\n" * len(vertices)) % tuple(vertices.ravel().tolist())
    text += ("f %d %d %d\n" * len(faces)) % tuple((faces.ravel() + 1).tolist())
    return text.encode("ascii")


def hull_mesh(points: Array) -> tuple[Array, npt.NDArray[np.int64]]:
    """Vertices (N, 3) and triangles (M, 3) of the convex hull of points. ModuleNotFoundError
    without scipy (pip install sdgen[assets])."""
    import trimesh

    hull = trimesh.convex.convex_hull(points)
    return np.asarray(hull.vertices), np.asarray(hull.faces)


def numbers(values: Iterable[float]) -> str:
    """Numbers as XML attributes have them."""
    return " ".join(f"{float(value):.6f}".rstrip("0").rstrip(".") for value in values)
