"""The hazard catalogue, from YAML folders to one resolved :class:`Catalog`.

A folder holds ``hazards/*.yaml``, ``categories/*.yaml``, ``activities/*.yaml``, ``homes/*.yaml``,
``rooms.yaml``, ``fittings.yaml``, ``styles.yaml``, ``mixes.yaml`` and ``households.yaml``, each
optional except in the shipped one. Later folders add to earlier ones; to replace an entry they say
``replaces: true``. A single file may stand in for a folder.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from sdgen.catalog.activity import ActivityYaml
from sdgen.catalog.consistency import check_activities, check_among, check_choices
from sdgen.catalog.entry import Entry
from sdgen.catalog.enumeration import check_against_library, enumerate_anomalies
from sdgen.catalog.folder import Folder, extension_names, open_extra, open_folder
from sdgen.catalog.hazard_yaml import read_hazard
from sdgen.catalog.home_yaml import read_home
from sdgen.catalog.limits import MAX_ENTRIES, MAX_HAZARDS
from sdgen.catalog.records import Catalog
from sdgen.catalog.words import NOT_A_NAME, WORD, Names
from sdgen.catalog.world_yaml import (
    AgeGroupYaml,
    CategoryYaml,
    FittingYaml,
    HouseholdYaml,
    MixYaml,
    ReachYaml,
    RoomTypeYaml,
    StyleYaml,
)
from sdgen.errors import InputError, did_you_mean
from sdgen.resources import data_path
from sdgen.strict import no_mapping, unknown_key
from sdgen.yaml_source import Path_, Source

__all__ = ["check_against_library", "enumerate_anomalies", "load_catalog"]

#: What an entry of each folder or file is called.
_KINDS = {
    "categories": "category",
    "rooms": "room type",
    "mixes": "mix of rooms",
    "styles": "style",
    "fittings": "fitting",
    "activities": "activity",
    "hazards": "hazard",
    "homes": "home",
    "households": "household",
    "groups": "age group",
    "reach": "table",
}


def load_catalog(
    extra: Sequence[Path] = (),
    extensions: Sequence[str] = (),
    only: Sequence[str] | None = None,
) -> Catalog:
    """Load the shipped catalogue, shipped extension packs and extra folders or hazard files.

    ``only`` keeps just these hazard ids. Raises InputError with every problem found, each
    ``file:line: key path: problem``.
    """
    folders, problems = _opened(extra, extensions)
    catalog = _resolve(folders, problems)
    if only is None:
        return catalog
    known = [hazard.id for hazard in catalog.hazards]
    wrong = [
        f"unknown hazard {name!r}{did_you_mean(name, known)}" for name in only if name not in known
    ]
    if wrong:
        raise InputError(wrong)
    kept = tuple(hazard for hazard in catalog.hazards if hazard.id in only)
    return catalog.model_copy(update={"hazards": kept})


def written_hazard(
    hazard: str, extra: Sequence[Path] = (), extensions: Sequence[str] = ()
) -> dict[str, Any]:
    """What a hazard of a sound catalogue is written as: plain values, in their order."""
    folders, _ = _opened(extra, extensions)
    files = [
        source
        for folder in folders
        for source in folder.sources.get("hazards", ())
        if Path(source.file).stem == hazard
    ]
    return dict(files[-1].value)


def _opened(extra: Sequence[Path], extensions: Sequence[str]) -> tuple[list[Folder], list[str]]:
    """All folders of a catalogue, parsed, later ones over earlier ones; and their problems."""
    problems: list[str] = []
    folders = [open_folder(data_path("hazard_catalog"), "core", "hazard_catalog")]
    shipped = extension_names()
    # In order of id, whichever way they are named: what is built does not depend on it.
    for name in sorted(set(extensions)):
        if name not in shipped:
            near = did_you_mean(name, shipped) if shipped else " (none are shipped)"
            problems.append(f"unknown extension pack {name!r}{near}")
            continue
        path = data_path("hazard_catalog", "extensions", name)
        folders.append(open_folder(path, name, f"hazard_catalog/extensions/{name}"))
    folders += [open_extra(path) for path in extra]
    for folder in folders:
        problems.extend(folder.problems)
    return folders, problems


def _resolve(folders: Sequence[Folder], problems: list[str]) -> Catalog:
    """All folders as one catalogue. Raises InputError with ``problems`` and all found here."""
    found: dict[str, dict[str, Entry]] = {kind: {} for kind in _KINDS}
    for folder in folders:
        for file, source in folder.all():
            for kind, entry in _entries(file, source, folder.pack):
                _add(found[kind], _KINDS[kind], entry)
    _check_numbers(found, folders, problems)
    names = Names(
        categories=tuple(sorted(found["categories"])),
        rooms=tuple(sorted(found["rooms"])),
        hazards=tuple(sorted(found["hazards"])),
        traits=tuple(sorted(set(_traits(found["households"].values())))),
        groups=tuple(sorted(found["groups"])),
        styles=tuple(sorted(found["styles"])),
        activities=tuple(sorted(found["activities"])),
        like=_kinds_of(found["rooms"]),
    )

    def named(kind: str, model: type[Any], as_written: bool = False) -> tuple[Any, ...]:
        order = list(found[kind]) if as_written else sorted(found[kind])
        read = ((name, found[kind][name].read(model, names)) for name in order)
        return tuple(written.record(name) for name, written in read if written is not None)

    hazards = (read_hazard(found["hazards"][name], names) for name in sorted(found["hazards"]))
    homes = (read_home(found["homes"][name], names) for name in sorted(found["homes"]))
    reach = (entry.read(ReachYaml, names) for entry in found["reach"].values())
    catalog = Catalog(
        hazards=tuple(hazard for hazard in hazards if hazard is not None),
        categories=named("categories", CategoryYaml),
        room_types=named("rooms", RoomTypeYaml),
        households=named("households", HouseholdYaml),
        reach=tuple(row for table in reach if table is not None for row in table.rows),
        homes=tuple(home.record() for home in homes if home is not None),
        mixes=named("mixes", MixYaml),
        groups=named("groups", AgeGroupYaml),
        styles=named("styles", StyleYaml),
        fittings=named("fittings", FittingYaml, as_written=True),
        activities=named("activities", ActivityYaml),
    )
    if not any(source.problems for folder in folders for _, source in folder.all()):
        check_among(found["hazards"], catalog.hazards, catalog.categories)
        check_choices(found["households"], catalog.households, catalog.hazards)
        check_activities(found["activities"], catalog.activities, catalog.hazards)
    for folder in folders:
        for _, source in folder.all():
            problems.extend(source.problems)
    if problems:
        raise InputError(tuple(dict.fromkeys(problems)))
    return catalog


def _check_numbers(
    found: Mapping[str, Mapping[str, Entry]], folders: Sequence[Folder], problems: list[str]
) -> None:
    """Raise InputError, before anything is made of them, where there are too many entries."""
    for kind, entries in found.items():
        most = MAX_HAZARDS if kind == "hazards" else MAX_ENTRIES
        if len(entries) > most:
            text = f"is one {_KINDS[kind]} too many: a catalogue has at most {most}"
            list(entries.values())[most].problem(text)
            problems.extend(p for f in folders for _, source in f.all() for p in source.problems)
            raise InputError(tuple(dict.fromkeys(problems)))


def _kinds_of(rooms: Mapping[str, Entry]) -> dict[str, tuple[str, ...]]:
    """By room type, those that are written to be ``like`` it."""
    out: dict[str, tuple[str, ...]] = {}
    for name in sorted(rooms):
        like = rooms[name].key("like")
        if isinstance(like, str):
            # Of one kind only: no rule has to follow a chain, or a circle.
            if like in rooms and rooms[like].key("like") is not None:
                text = f"{like!r} is like another room type itself: name that one, or none"
                rooms[name].problem(text, "like")
            out[like] = (*out.get(like, ()), name)
    return out


def _traits(templates: Iterable[Entry]) -> Iterator[str]:
    """Every pet and condition that households are written with."""
    for entry in templates:
        for key in ("pets", "conditions"):
            written = entry.key(key)
            several = written if isinstance(written, list) else [written]
            words = (one.get("is") if isinstance(one, dict) else one for one in several)
            yield from (word for word in words if isinstance(word, str))


def _add(found: dict[str, Entry], kind: str, entry: Entry) -> None:
    """Take an entry, or note that it exists already (or does not, for it to replace)."""
    first = found.get(entry.name)
    replaces = entry.key("replaces") is True
    if first is not None and not replaces:
        where = f"{first.source.file}:{first.source.line(first.path)}"
        hint = "(to replace it add 'replaces: true')"
        entry.problem(f"{kind} {entry.name!r} is already defined at {where} {hint}")
        return
    if first is None and replaces:
        near = did_you_mean(entry.name, sorted(found))
        entry.problem(f"there is no {kind} {entry.name!r} to replace{near}", "replaces")
    found[entry.name] = entry


def _entries(kind: str, source: Source, pack: str) -> Iterator[tuple[str, Entry]]:
    """The entries of a file of a kind, each with its own kind: a file of households has three."""
    value = source.value
    if value is None and source.problems:
        return  # could not be parsed, as noted
    if not isinstance(value, dict):
        source.problem((), no_mapping(value))
    elif kind in ("hazards", "homes"):
        yield kind, _whole(source, pack)
    elif kind != "households":
        yield from _named(kind, source, (), value, pack)
    else:
        for key in value:
            if key == "reach":
                yield "reach", Entry(key, source, (key,), value[key], pack)
            elif key == "templates":
                yield from _named(kind, source, (key,), value[key], pack)
            elif key == "groups":
                yield from _named("groups", source, (key,), value[key], pack)
            else:
                source.problem((key,), unknown_key(key, ("templates", "groups", "reach")))


def _named(
    kind: str, source: Source, path: Path_, value: Any, pack: str
) -> Iterator[tuple[str, Entry]]:
    """The entries of a mapping of names to entries."""
    if not isinstance(value, dict):
        source.problem(path, no_mapping(value))
        return
    for name, below in value.items():
        if not WORD.fullmatch(name):
            source.problem((*path, name), f"{name!r} {NOT_A_NAME}")
        yield kind, Entry(name, source, (*path, name), below, pack)


def _whole(source: Source, pack: str) -> Entry:
    """A file that is one entry: its ``id`` must be the file's name."""
    entry = Entry(Path(source.file).stem, source, (), source.value, pack)
    found = entry.key("id")
    if isinstance(found, str) and found != entry.name:
        entry.problem(f"the id must be the file's name, {entry.name!r}", "id")
    return entry
