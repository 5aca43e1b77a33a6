"""Writes the gallery of a data set: an index of scenes, and a page each. Plain files, offline."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sdgen.dataset import Dataset, ManifestEntry, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.disk import remove_tree
from sdgen.dataset.output_file import write_output
from sdgen.dataset.records import count
from sdgen.gallery.files import (
    INDEX,
    SCRIPTS,
    VENDOR,
    begin_page,
    folder_of,
    put,
    refuse_foreign,
    templates,
)
from sdgen.gallery.models import MODELS, SURFACES, Models
from sdgen.gallery.scene_page import Around, ScenePages
from sdgen.gallery.script import call
from sdgen.library import Library

#: How the style begins: it is written first and shows that a folder is a page of ours, which may
#: be written over, finished or not.
MARK = b"/* sdgen view */"
SCENES = "scenes.js"


@dataclass(frozen=True)
class Shown:
    """A finished gallery: its index, and how many of the scenes it shows."""

    index: Path
    scenes: int
    total: int


def write_gallery(
    data: Dataset,
    out: Path,
    limit: int | None = None,
    on_scene: Callable[[int, int], None] | None = None,
    library: Library | None = None,
) -> Shown:
    """Write the gallery of a data set into the folder ``out``: its scenes, each with its twins.

    Colour pictures are linked, not copied: keep the gallery beside the data set. ``limit`` shows
    only the first scenes; models come from ``library``, else boxes stand for them. Raises
    SdgenError when ``out`` holds something else, is a link or lies among a data set's scenes,
    InputError for a broken scene; a new gallery that cannot be finished is taken away again.
    """
    refuse_foreign(out, MARK)
    fresh = not out.exists()
    try:
        return _write(data, out, limit, on_scene, library)
    except BaseException:
        if fresh:
            remove_tree(out)
        raise


def _write(
    data: Dataset,
    out: Path,
    limit: int | None,
    on_scene: Callable[[int, int], None] | None,
    library: Library | None,
) -> Shown:
    environment = templates()
    begin_page(out, MARK, (*SCRIPTS, *VENDOR))
    for name in (MODELS, SURFACES):
        folder_of(out, name)
    models = Models(data.infos, data.info.assets_sha256, library, out)
    pages = ScenePages(data, models, out, environment)
    families = list(_families(data))[:limit]
    total = sum(map(len, families))
    rows: list[dict[str, Any]] = []
    for k, family in enumerate(families):
        before = families[k - 1][0].id if k else None
        after = families[k + 1][0].id if k + 1 < len(families) else None
        for entry in family:
            # Anew each time: an item holds all that was read of it.
            items = {one.id: SceneItem(data.path, one) for one in family}
            item = items.pop(entry.id)
            with derived_from(data, item):
                rows.append(pages.write(item, Around(before, after, _others(entry, items))))
            if on_scene is not None:
                on_scene(len(rows), total)
    put(out / SCENES, call("index", _index(rows)))
    text = environment.get_template("index.html.j2").render(
        data=data,
        info=data.info,
        counts=count(data.entries),
        shown=len(families),
        without_pictures=all(row["overview"].endswith("svg") for row in rows),
    )
    write_output(out / INDEX, text.encode("utf-8"))
    return Shown(out / INDEX, len(families), len(data))


def _families(data: Dataset) -> Iterator[tuple[ManifestEntry, ...]]:
    """The scenes of a data set, each followed by its twins, those that it does not show itself."""
    shown = {item.id for item in data}
    twins: dict[str, list[ManifestEntry]] = {}
    for entry in data.entries:
        if entry.twin_of is not None and entry.id not in shown:
            twins.setdefault(entry.twin_of, []).append(entry)
    for item in data:
        yield (item.entry, *twins.get(item.id, ()))


def _others(entry: ManifestEntry, items: dict[str, SceneItem]) -> tuple[tuple[str, SceneItem], ...]:
    """With what a scene is compared, in words: a scene with its twins, a twin with its scene."""
    if entry.twin_of is not None:
        return tuple(
            ("the scene itself", one) for key, one in items.items() if key == entry.twin_of
        )
    out = []
    for key, one in items.items():
        undone = key.rsplit("-", 1)[-1]
        out.append(("its twin" if one.entry.kind == "twin" else f"{undone} undone", one))
    return tuple(out)


def _index(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """The index as JSON: words once, and a row a scene that counts in them."""
    words = {
        key: sorted({one for row in rows for one in _listed(row[key])})
        for key in ("hazards", "rooms", "household", "split", "kind")
    }
    place = {key: {name: k for k, name in enumerate(names)} for key, names in words.items()}
    packed = [
        [
            row["id"],
            row["home"],
            *(place[key][row[key]] for key in ("kind", "split", "household")),
            [place["rooms"][name] for name in row["rooms"]],
            [n for key, times in row["hazards"].items() for n in (place["hazards"][key], times)],
            row["crop"],
            row["overview"],
            row["inset"],
            int(row["hidden"]),
            row["twins"],
        ]
        for row in rows
    ]
    return {"words": words, "rows": packed}


def _listed(value: Any) -> list[str]:
    return [value] if isinstance(value, str) else list(value)
