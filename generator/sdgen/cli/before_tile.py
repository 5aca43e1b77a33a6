"""The picture of an imported model as it was in its source, for ``sdgen assets sheet``."""

from __future__ import annotations

from pathlib import Path
from typing import Any


def before_tile(drawn_by: Any, library: Any, asset_id: str, size: int) -> list[tuple[str, Any]]:
    """Label and picture; none for a model that was not imported or whose source is gone."""
    from sdgen.catalog.load import load_catalog
    from sdgen.importing.before import as_before
    from sdgen.importing.shelf import origins
    from sdgen.render.portraits import looks_of, portrait
    from sdgen.scratch import scratch_folder

    origin = origins(library.folder_of(asset_id)).get(asset_id)
    if origin is None:
        return []
    with scratch_folder() as scratch:
        folder: Path = scratch / "before"
        folder.mkdir()
        before = as_before(origin, load_catalog(), folder)
        if before is None:
            return []
        look = looks_of(before.info(asset_id))[0]
        return [(f"{origin.name}, its source", portrait(drawn_by, before, asset_id, look, size))]
