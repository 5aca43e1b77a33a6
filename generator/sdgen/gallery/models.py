"""Models and surfaces as scripts a page loads from disk: browsers fetch nothing else there.

Each file calls one function with what it holds. All scenes of a gallery share them.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from sdgen.errors import AssetError
from sdgen.gallery.files import put
from sdgen.gallery.script import call
from sdgen.library import Library
from sdgen.library.model_glb import model_glb
from sdgen.library.raw import file_bytes
from sdgen.library.records import NAME, AssetInfo
from sdgen.scene import Structure

MODELS, SURFACES = "models", "surfaces"


class Models:
    """The models of a gallery, each written when the first scene asks for it. ``others``: the
    library is not the one the data set was built with (by its digest); what is the same in it, by
    the records and outlines that the data set carries, is drawn all the same."""

    def __init__(
        self,
        infos: Mapping[str, AssetInfo],
        assets_sha256: str,
        library: Library | None,
        out: Path,
    ) -> None:
        self.others = library is not None and library.sha256 != assets_sha256
        self._infos = infos
        self._library = library
        self._out = out
        self._why: dict[str, str] = {}
        self._surfaces: dict[str, bool] = {}

    def why_box(self, asset_id: str) -> str:
        """Why a box stands for a model; empty where its script is there."""
        if asset_id not in self._why:
            self._why[asset_id] = self._write(asset_id)
        return self._why[asset_id]

    def surfaces(self, structures: Iterable[Structure]) -> list[str]:
        """The surfaces of these structures whose scripts are there, sorted."""
        worn = {one.surface for one in structures}
        worn |= {band.surface for one in structures for band in one.bands}
        return sorted(name for name in worn if self._has_surface(name))

    def _write(self, asset_id: str) -> str:
        library = self._library
        if library is None or asset_id not in library.assets:
            return "not at hand"
        stored = self._infos[asset_id]
        try:
            # What an older data set does not say of its models cannot differ.
            there = library.info(asset_id)
            fields = stored.model_fields_set
            if any(getattr(stored, name) != getattr(there, name) for name in fields):
                return "differs from the one the data set was built with"
            content = {
                "parts": [[part.name, part.rgba] for part in there.parts],
                "variants": there.variants,
                "glb": base64.b64encode(model_glb(library, asset_id)).decode("ascii"),
            }
        except AssetError:
            return "cannot be read"
        put(self._out / MODELS / f"{asset_id}.js", call("model", asset_id, content))
        return ""

    def _has_surface(self, name: str) -> bool:
        if name not in self._surfaces:
            self._surfaces[name] = self._write_surface(name)
        return self._surfaces[name]

    def _write_surface(self, name: str) -> bool:
        library = self._library
        if library is None or name not in library.surfaces or not re.fullmatch(NAME, name):
            return False
        try:
            data = file_bytes(library.surface_texture(name))
        except AssetError:
            return False
        kind = "png" if data.startswith(b"\x89PNG") else "jpeg"
        picture = f"data:image/{kind};base64,{base64.b64encode(data).decode('ascii')}"
        content = {"size": library.tile_m(name), "picture": picture}
        put(self._out / SURFACES / f"{name}.js", call("surface", name, content))
        return True
