"""A model as its source has it, with every face and a large texture, to be shown beside ours."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from sdgen.catalog.records import Catalog
from sdgen.errors import InputError
from sdgen.importing.bake import kept
from sdgen.importing.frame import stand
from sdgen.importing.glb_file import model_glb
from sdgen.importing.layouts import Candidate, find_models
from sdgen.importing.manifest import manifest_of
from sdgen.importing.model import by_link, hulls_text, jpeg, painted
from sdgen.importing.opened import opened_source
from sdgen.importing.reading import read_model
from sdgen.importing.shelf import Origin
from sdgen.importing.table import load_table
from sdgen.importing.tree import References
from sdgen.library import Library
from sdgen.resources import data_path

#: As many as a library's model may have; pixels a side of the texture.
_FACES, _TEXTURE_PX = 150_000, 1024


def as_before(origin: Origin, catalog: Catalog, folder: Path) -> Library | None:
    """A library in ``folder`` with the one model as it was before it was imported; None when its
    source is not there any more, or no longer the same."""
    try:
        if not Path(origin.root).exists():
            return None
        with opened_source(Path(origin.root)) as (roots, _):
            for root in roots:
                found = [c for c in find_models(origin.source, root) if c.place == origin.entry]
                if found:
                    return _library(origin, found[0], catalog, folder)
    except (InputError, OSError):
        pass
    return None


def _library(origin: Origin, candidate: Candidate, catalog: Catalog, folder: Path) -> Library:
    references = References(candidate.root, candidate.folder)
    scan = read_model(origin.source, candidate, references)
    table = load_table(origin.source, catalog)
    scan, _ = stand(scan, candidate.name, table, catalog, [])
    groups = by_link(scan)
    look = kept(groups, False, _TEXTURE_PX) or painted(groups, _FACES, _TEXTURE_PX, [])
    size = scan.extents_m
    asset = origin.asset
    names = [part for part in asset.parts if part.name in look.meshes]
    asset = asset.model_copy(
        update={
            "extents_m": tuple(round(float(v), 4) for v in size),
            "parts": tuple(
                part.model_copy(update={"faces": len(look.meshes[part.name].faces)})
                for part in names
            ),
            "variants": {"default": tuple(part.name for part in names)},
            "states": (),
            "supports": (),
            "containers": (),
        }
    )
    corners = np.concatenate([mesh.vertices for mesh in look.meshes.values()])
    low, high = corners.min(axis=0), corners.max(axis=0)
    box = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    files = {
        asset.mesh: model_glb(look.meshes, "../" + asset.texture),
        asset.hulls: hulls_text({"body": [low + box * np.maximum(high - low, 0.002)]}),
        asset.texture: jpeg(look),
        "manifest.yaml": manifest_of("# One model as it was.", [asset], {}),
    }
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    return Library([data_path("assets"), folder])  # ours has the floor to draw it on
