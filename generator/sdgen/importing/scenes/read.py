"""A furnished scene of somebody as a base home: the formats, and the way through."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np

from sdgen.catalog.home_text import home_text
from sdgen.catalog.records import Catalog, FurnitureItem, HomeSpec, ThingItem
from sdgen.errors import InputError, UsageError, did_you_mean
from sdgen.home.drawing_check import drawing_problems
from sdgen.importing.scenes.found import FoundScene
from sdgen.importing.scenes.gltf import read_gltf
from sdgen.importing.scenes.mjcf import read_mjcf
from sdgen.importing.scenes.naming import Namer
from sdgen.importing.scenes.prove import Key, unkept
from sdgen.importing.scenes.replicacad import read_replicacad
from sdgen.importing.scenes.to_home import Imported, to_home
from sdgen.importing.scenes.virtualhome import read_virtualhome
from sdgen.library import Library
from sdgen.yaml_source import show_path

#: ``(path, catalogue, namer)`` -> what was found. Raises InputError for what cannot be read.
Reader = Callable[[Path, Catalog, Namer], FoundScene]
FORMATS: Mapping[str, Reader] = {
    "gltf": read_gltf,
    "mjcf": read_mjcf,
    "replicacad": read_replicacad,
    "virtualhome": read_virtualhome,
}
#: What becomes of things that are a hazard as they lie.
Violating = Literal["remove", "label"]
#: Characters of a line that is told.
_LONGEST = 300
#: What is left out may bear others: so often a drawing is looked at again.
_LOOKS = 8


def import_home(
    format_: str,
    path: Path,
    name: str,
    catalog: Catalog,
    library: Library,
    namer: Namer,
    violating: Violating = "remove",
) -> Imported:
    """The scene of a file as a base home called ``name``, which builds as it is.

    Small things that are a hazard as they lie are left out, or, ``violating`` says so, kept and
    labelled in every scene of the home; furniture that is one is always left out.

    Raises UsageError for a format nobody knows, InputError for a file that cannot be read or has
    no room.
    """
    if format_ not in FORMATS:
        raise UsageError(f"no format {format_!r}{did_you_mean(format_, list(FORMATS))}")
    # Numbers of strangers may overflow: what comes of that is refused as not finite.
    with np.errstate(over="ignore", invalid="ignore"):
        scene = FORMATS[format_](path, catalog, namer)
    imported = to_home(scene, name, catalog, library, namer)
    return _in_plain_words(_as_a_build_takes_it(imported, catalog, library, violating))


def text_of(imported: Imported, format_: str, path: Path) -> str:
    """The YAML of an imported home; its head says where it is from and what is not in it."""
    lead = [
        f"Written by sdgen home import from {path.name} ({format_}): change what you like.",
        f"Check it with: sdgen catalog validate {imported.spec.id}.yaml",
        *(f"Assumed: {text}" for text in imported.told),
        *(f"Left out: {text}" for text in imported.unresolved),
    ]
    return home_text(imported.spec, [_plain(line) for line in lead])


def _in_plain_words(imported: Imported) -> Imported:
    """The same, its words on a line each: names of strangers hold anything."""
    title = _plain(imported.spec.title) or imported.spec.id
    return replace(
        imported,
        spec=imported.spec.model_copy(update={"title": title}),
        told=tuple(map(_plain, imported.told)),
        unresolved=tuple(map(_plain, imported.unresolved)),
        guessed=tuple(map(_plain, imported.guessed)),
    )


def _plain(text: str) -> str:
    printable = "".join(one if one.isprintable() else " " for one in text)
    return " ".join(printable.split())[:_LONGEST]


def _as_a_build_takes_it(
    imported: Imported, catalog: Catalog, library: Library, violating: Violating
) -> Imported:
    """The home without what a build would refuse: what hangs in the air, what cuts into another,
    what does not stay, what is a hazard as it is (unless that is to be labelled)."""
    spec, unresolved = imported.spec, list(imported.unresolved)
    told = list(imported.told)
    proved = False
    for _ in range(_LOOKS):
        wrong: dict[Key, str] = {}
        for path, text in drawing_problems(spec, catalog, library):
            match path:
                case ("rooms", int(room), "furniture" | "things" as kept, int(number), *_):
                    wrong.setdefault(Key(room, kept, number), text)
                case _:
                    raise InputError([f"{spec.id}: {show_path(path)}: {text}"])
        if not wrong:
            if proved:
                break
            found = unkept(spec, catalog, library)
            wrong = dict(found.pieces)
            told += [text for text in found.told if text not in told]
            if violating == "label":
                spec = _labelled(spec, found.anomalies)
            else:
                why = "is a hazard as it is: {}"
                wrong |= {key: why.format(name) for key, name in found.anomalies.items()}
            proved = not wrong
        wrong = _with_carried(spec, wrong)
        for key, text in sorted(wrong.items()):
            room_spec = spec.rooms[key.room]
            listed: Sequence[FurnitureItem | ThingItem] = room_spec.things
            if key.list == "furniture":
                listed = room_spec.furniture
            item = listed[key.number]
            unresolved.append(f"{item.category} in {room_spec.name}: {text}")
        spec = _without(spec, wrong)
    counts = {
        **imported.counts,
        "furniture": sum(len(room.furniture) for room in spec.rooms),
        "things": sum(len(room.things) for room in spec.rooms),
        "labelled": sum(t.anomaly is not None for room in spec.rooms for t in room.things),
    }
    return replace(
        imported, spec=spec, told=tuple(told), unresolved=tuple(unresolved), counts=counts
    )


def _labelled(spec: HomeSpec, anomalies: Mapping[Key, str]) -> HomeSpec:
    """The home with these things as the anomalies that they are."""
    rooms = []
    for r, room in enumerate(spec.rooms):
        things = tuple(
            thing.model_copy(update={"anomaly": anomalies[key]})
            if (key := Key(r, "things", k)) in anomalies
            else thing
            for k, thing in enumerate(room.things)
        )
        rooms.append(room.model_copy(update={"things": things}))
    return spec.model_copy(update={"rooms": tuple(rooms)})


def _with_carried(spec: HomeSpec, gone: Mapping[Key, str]) -> dict[Key, str]:
    """What goes, and the furniture that stood on it: it would hang in the air."""
    out = dict(gone)
    for r, room in enumerate(spec.rooms):
        left: set[str] = set()
        for k, item in enumerate(room.furniture):  # what carries others comes before them
            key = Key(r, "furniture", k)
            if item.on is not None and item.on not in left:
                out.setdefault(key, f"the {item.on} that carried it is left out")
            if key not in out:
                left.add(item.category)
    return out


def _without(spec: HomeSpec, gone: Mapping[Key, str]) -> HomeSpec:
    rooms = []
    for r, room in enumerate(spec.rooms):
        kept = tuple(
            item for k, item in enumerate(room.furniture) if Key(r, "furniture", k) not in gone
        )
        things = tuple(t for k, t in enumerate(room.things) if Key(r, "things", k) not in gone)
        rooms.append(room.model_copy(update={"furniture": kept, "things": things}))
    return spec.model_copy(update={"rooms": tuple(rooms)})
