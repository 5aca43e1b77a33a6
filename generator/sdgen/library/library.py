"""The models a build can use: records at once, meshes when asked for."""

from __future__ import annotations

import hashlib
from collections import OrderedDict
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from sdgen.errors import AssetError
from sdgen.library.above import Above, seen_from_above, with_left_out
from sdgen.library.cache import digest
from sdgen.library.kept import kept_manifest
from sdgen.library.meshes import Floats, Hull, MeshData, check_extents, read_glb, read_hulls
from sdgen.library.prepared import Model, Prepared, open_files
from sdgen.library.raw import file_bytes
from sdgen.library.records import Asset, AssetInfo, Surface
from sdgen.library.sweep import Reach, reach_of, way_of
from sdgen.library.unpack import cached_texture, check_texture, unpack
from sdgen.resources import data_path

#: Models held at a time, of 1,800 shipped. A scene has 60 to 90, and one that is mapped anew costs
#: 0.2 ms. But each holds a file open: no library takes more than half of those a process may have.
_HELD = min(1000, open_files() // 2)


class Library:
    """Assets and surfaces of one or more folders; models are mapped when asked for."""

    def __init__(self, folders: Sequence[Path], sha256: str | None = None) -> None:
        """Read the manifests of ``folders``; ``sha256`` is their digest where it is known."""
        self.folders = tuple(folders)
        self._folder_of: dict[str, Path] = {}
        assets: dict[str, Asset] = {}
        surfaces: dict[str, Surface] = {}
        hasher = hashlib.sha256()
        for folder in folders:
            manifest = kept_manifest(folder)
            hasher.update(manifest.raw)
            for asset in manifest.assets:
                if asset.id in assets:
                    raise AssetError([f"{folder}: {asset.id}: an asset folder before has this id"])
                assets[asset.id] = asset
                self._folder_of[asset.id] = folder
            for surface in manifest.surfaces:
                if surface.id in surfaces:
                    raise AssetError([f"{folder}: {surface.id}: a folder before has this surface"])
                surfaces[surface.id] = surface
                self._folder_of["surface:" + surface.id] = folder
        self.assets: Mapping[str, Asset] = dict(sorted(assets.items()))
        self.surfaces: Mapping[str, Surface] = dict(sorted(surfaces.items()))
        self._by_category: dict[str, tuple[Asset, ...]] = {}
        for asset in self.assets.values():
            before = self._by_category.get(asset.category, ())
            self._by_category[asset.category] = (*before, asset)
        self._infos = _Infos(self)
        self._prepared = Prepared()
        self._held: OrderedDict[str, Model] = OrderedDict()
        self._objs: dict[str, dict[str, Path]] = {}
        self._textures: dict[str, Path] = {}
        self._worn: dict[str, dict[str, Path]] = {}
        self._bounds: dict[str, Mapping[str, Floats]] = {}
        self._above: dict[tuple[str, tuple[str, ...]], Above | None] = {}
        self._ways: dict[str, tuple[Above | None, Reach]] = {}
        self._manifest_hash = hasher
        self._sha256 = sha256

    @property
    def sha256(self) -> str:
        """Digest of all manifests, meshes, hulls and textures: what decides bytes."""
        if self._sha256 is None:
            total = self._manifest_hash.copy()
            for asset in self.assets.values():
                folder = self._folder_of[asset.id]
                files = {asset.mesh, asset.hulls, asset.texture}
                files |= {part.texture for part in asset.parts if part.texture}
                for name in sorted(files):
                    total.update(file_bytes(folder / name))
            for surface in self.surfaces.values():
                folder = self._folder_of["surface:" + surface.id]
                total.update(file_bytes(folder / surface.texture))
            self._sha256 = total.hexdigest()
        return self._sha256

    @property
    def infos(self) -> Mapping[str, AssetInfo]:
        """Records without file names, with outlines, by asset id; each is made when asked for."""
        return self._infos

    @property
    def categories(self) -> tuple[str, ...]:
        """Categories that have at least one model, sorted."""
        return tuple(sorted(self._by_category))

    def by_category(self, category: str) -> tuple[Asset, ...]:
        """Models of a category, sorted by id; empty when there is none."""
        return self._by_category.get(category, ())

    def info(self, asset_id: str) -> AssetInfo:
        """Record of one model (KeyError when there is none)."""
        return self._infos[asset_id]

    def states_by_category(self) -> dict[str, set[str]]:
        """All states some model of each category can be in."""
        return {
            category: {state for asset in assets for state in asset.state_names}
            for category, assets in self._by_category.items()
        }

    def holding(self) -> dict[str, set[str]]:
        """By ``ON`` and ``INSIDE``, the categories of which some model takes things so."""
        out: dict[str, set[str]] = {"ON": set(), "INSIDE": set()}
        for category, assets in self._by_category.items():
            supports = [support for asset in assets for support in asset.supports]
            if any(support.container is None for support in supports):
                out["ON"].add(category)
            if any(asset.containers for asset in assets):
                out["INSIDE"].add(category)
        return out

    def mesh(self, asset_id: str) -> Mapping[str, MeshData]:
        """Triangles of every part. Raises AssetError for a missing or broken file."""
        return self.model(asset_id).meshes

    def hulls(self, asset_id: str) -> tuple[Hull, ...]:
        """Convex collision pieces, none beyond what is drawn.

        Raises AssetError for a missing or broken file.
        """
        return self.model(asset_id).hulls

    def bounds(self, asset_id: str) -> Mapping[str, Floats]:
        """Lowest and highest corner of the box of every part, (2, 3).

        Kept for all models that were asked for, so that a model is not mapped for them alone.
        """
        if asset_id not in self._bounds:
            meshes = self.mesh(asset_id)
            self._bounds[asset_id] = {part: mesh.bounds_m for part, mesh in meshes.items()}
        return self._bounds[asset_id]

    def above(self, asset_id: str, parts: tuple[str, ...]) -> Above | None:
        """The collision pieces of these parts and what they leave out of what is drawn, seen from
        above; None when they have none.

        Kept for all models that were asked for: about 2 KB each.
        """
        key = (asset_id, parts)
        if key not in self._above:
            pieces = [hull.vertices_m for hull in self.hulls(asset_id) if hull.part in parts]
            drawn = [mesh for part, mesh in self.mesh(asset_id).items() if part in parts]
            seen = seen_from_above(pieces) if pieces else None
            self._above[key] = with_left_out(seen, drawn) if seen is not None else None
        return self._above[key]

    def way(self, asset_id: str) -> Above | None:
        """Where leaves, lids and drawers go on their way open; None when nothing opens."""
        return self._opening(asset_id)[0]

    def reach(self, asset_id: str) -> Reach:
        """How far what opens goes beyond the model's box."""
        return self._opening(asset_id)[1]

    def _opening(self, asset_id: str) -> tuple[Above | None, Reach]:
        if asset_id not in self._ways:
            asset = self.assets[asset_id]
            way = way_of(asset, self.mesh(asset_id), self.hulls(asset_id)) if asset.joints else None
            self._ways[asset_id] = way, reach_of(asset, way)
        return self._ways[asset_id]

    def model(self, asset_id: str) -> Model:
        """Arrays of a model. Raises AssetError for a missing or broken file."""
        if asset_id in self._held:
            self._held.move_to_end(asset_id)
        else:
            self._held[asset_id] = self._prepared.model(
                self._folder_of[asset_id], self.assets[asset_id]
            )
            if len(self._held) > _HELD:
                self._held.popitem(last=False)
        return self._held[asset_id]

    def objs(self, asset_id: str) -> Mapping[str, Path]:
        """OBJ file of every part, unpacked into the cache on first use."""
        if asset_id not in self._objs:
            textures = self.textures(asset_id)
            names = "\n".join(f"{k}={v.name}" for k, v in sorted(textures.items()))
            # By what was read, not by what lies on disk now: the file may have changed since.
            meshes = self.mesh(asset_id)
            arrays = [
                np.ascontiguousarray(array).tobytes()
                for mesh in meshes.values()
                for array in (mesh.vertices, mesh.normals, mesh.uvs, mesh.faces)
            ]
            self._objs[asset_id] = unpack(digest(names.encode(), *arrays), meshes, textures)
        return self._objs[asset_id]

    def textures(self, asset_id: str) -> Mapping[str, Path]:
        """Texture file of every part, in the cache."""
        if asset_id not in self._worn:
            asset, folder = self.assets[asset_id], self._folder_of[asset_id]
            self._worn[asset_id] = {
                part.name: cached_texture(folder / (part.texture or asset.texture))
                for part in asset.parts
            }
        return self._worn[asset_id]

    def folder_of(self, asset_id: str) -> Path:
        """The folder a model comes from (KeyError when there is none)."""
        return self._folder_of[asset_id]

    def file(self, asset_id: str, name: str) -> Path:
        """A file that a model's record names."""
        return self._folder_of[asset_id] / name

    def check_files(self, folder: Path) -> None:
        """Read every mesh, hull and texture of one folder. Raises AssetError with all problems."""
        problems: list[str] = []
        textures: set[Path] = set()
        for asset in self.assets.values():
            if self._folder_of[asset.id] != folder:
                continue
            names = [asset.texture, *(part.texture for part in asset.parts if part.texture)]
            textures.update(folder / name for name in names)
            try:
                meshes = read_glb(folder / asset.mesh, asset)
                check_extents(folder / asset.mesh, asset, meshes)
            except AssetError as error:
                problems += error.problems
            try:
                read_hulls(folder / asset.hulls, asset)
            except AssetError as error:
                problems += error.problems
        for surface in self.surfaces.values():
            if self._folder_of["surface:" + surface.id] == folder:
                textures.add(folder / surface.texture)
        for path in sorted(textures):
            try:
                check_texture(path)
            except AssetError as error:
                problems += error.problems
        if problems:
            raise AssetError(problems)

    def tile_m(self, surface_id: str) -> float:
        """How much a tile of a room surface covers, metres."""
        return self.surfaces[surface_id].size_m

    def surface_texture(self, surface_id: str) -> Path:
        """Texture file of a room surface, in the cache."""
        if surface_id not in self._textures:
            folder = self._folder_of["surface:" + surface_id]
            path = folder / self.surfaces[surface_id].texture
            self._textures[surface_id] = cached_texture(path)
        return self._textures[surface_id]


class _Infos(Mapping[str, AssetInfo]):
    """Records by asset id; an outline needs the mesh, so none is made before it is asked for."""

    def __init__(self, library: Library) -> None:
        self._library = library
        self._made: dict[str, AssetInfo] = {}

    def __getitem__(self, asset_id: str) -> AssetInfo:
        if asset_id not in self._made:
            outlines_m = dict(self._library.model(asset_id).outlines_m)
            self._made[asset_id] = self._library.assets[asset_id].info(outlines_m)
        return self._made[asset_id]

    def __iter__(self) -> Iterator[str]:
        return iter(self._library.assets)

    def __len__(self) -> int:
        return len(self._library.assets)


def load_library(extra: Sequence[Path] = ()) -> Library:
    """The shipped library, and further asset folders after it (``--assets PATH``).

    Every file of the further ones is read once. Raises AssetError with all problems of a folder.
    """
    library = Library([data_path("assets"), *extra])
    for folder in extra:
        library.check_files(folder)
    return library
