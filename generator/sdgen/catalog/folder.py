"""The files of a catalogue folder, found and parsed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from sdgen.catalog.limits import MAX_BYTES, MAX_FILES
from sdgen.errors import InputError, did_you_mean
from sdgen.resources import data_path
from sdgen.yaml_source import Source, read_yaml

#: Folders of a catalogue, a file an entry (of the first two several), and its single files.
FOLDERS = ("categories", "activities", "hazards", "homes")
FILES = ("rooms", "fittings", "styles", "mixes", "households")
#: What others refer to comes first.
_ORDER = (
    "categories",
    "rooms",
    "styles",
    "fittings",
    "hazards",
    "households",
    "homes",
    "mixes",
    "activities",
)
#: What a file was called before, when a plan meant two things.
_RENAMED = {"plans": "mixes"}
_SUFFIXES = (".yaml", ".yml")
#: What may lie beside the files of a catalogue: words for people.
_TEXTS = ("", ".md", ".rst", ".txt")
#: Folders of the shipped catalogue that are not read with it: packs when they are asked for, and
#: what other people's models are (see ``sdgen.importing.table``).
_APART = ("extensions", "sources")


@dataclass
class Folder:
    """The parsed files of one catalogue folder by kind (the name of a folder or single file).

    ``pack`` names it in its hazards; ``problems`` are those of files that could not be read.
    """

    pack: str
    sources: dict[str, list[Source]] = field(default_factory=dict)
    problems: list[str] = field(default_factory=list)
    bytes_left: int = MAX_BYTES

    def all(self) -> Iterator[tuple[str, Source]]:
        """Every file with its kind, in reading order: what others refer to first."""
        for kind in _ORDER:
            for source in self.sources.get(kind, ()):
                yield kind, source

    def add(self, kind: str, path: Path, shown: str) -> None:
        """Parse a file, or note why it cannot be read."""
        files = self.sources.setdefault(kind, [])
        if len(files) >= MAX_FILES:
            self._once(f"{Path(shown).parent}: holds more than {MAX_FILES} files")
            return
        if self.bytes_left < 0:
            self._once(f"{self.pack}: its files have more than {MAX_BYTES // 10**6} MB")
            return
        with suppress(OSError, ValueError):  # what cannot be read is told by who reads it
            self.bytes_left -= path.stat().st_size
        try:
            files.append(read_yaml(path, shown))
        except InputError as error:
            self.problems += error.problems

    def _once(self, problem: str) -> None:
        if problem not in self.problems:
            self.problems.append(problem)


def open_folder(root: Path, pack: str, shown: str) -> Folder:
    """All files of a folder; what looks like one of them but is not is a problem."""
    out = Folder(pack)
    for path in sorted(root.iterdir()):
        name = f"{shown}/{path.name}"
        if path.name in FOLDERS and path.is_dir():
            for below in sorted(path.iterdir()):
                if _is_set_aside(below):
                    continue
                if _is_yaml(below):
                    out.add(path.name, below, f"{name}/{below.name}")
                elif below.is_dir():
                    text = "folders in it are not read; move its files up"
                    out.problems.append(f"{name}/{below.name}: {text}")
                elif problem := _no_text(below):
                    out.problems.append(f"{name}/{below.name}: {problem}")
        elif path.stem in FILES and _is_yaml(path):
            out.add(path.stem, path, name)
        elif path.name in _APART and (pack == "core" or path.name != "sources"):
            continue
        elif problem := _misplaced(path):
            out.problems.append(f"{name}: {problem}")
    return out


def _is_yaml(path: Path) -> bool:
    return path.suffix in _SUFFIXES and not path.name.startswith(".")


def _is_set_aside(path: Path) -> bool:
    """Hidden, or put aside by its name: nobody takes it for a part of the catalogue."""
    return path.name.startswith((".", "_"))


def _no_text(path: Path) -> str:
    """What is wrong with a file that is no YAML: nothing, where it is words for people."""
    if _is_set_aside(path) or path.suffix.lower() in _TEXTS:
        return ""
    near = did_you_mean(path.suffix, _SUFFIXES)
    return f"no file of a catalogue: its name does not end in .yaml{near}"


def _draws(source: Source) -> bool:
    """Whether a file draws a home, wherever it lies: no hazard has rooms with outlines."""
    return isinstance(source.value, dict) and {"rooms", "openings"} <= source.value.keys()


def _misplaced(path: Path) -> str:
    """What is wrong with something in a catalogue's folder that belongs to none of its kinds."""
    if _is_set_aside(path):
        return ""
    if _is_yaml(path):
        if path.stem in _RENAMED:
            return f"is called {_RENAMED[path.stem]}.yaml now: rename it"
        near = did_you_mean(path.name, [f"{name}.yaml" for name in FILES])
        return f"no file of a catalogue{near}"
    if not path.is_dir():
        return _no_text(path)
    if path.name == "sources":
        return "tables of models are given to 'sdgen assets import' with --table: move it out"
    return f"no folder of a catalogue{did_you_mean(path.name, (*FOLDERS, 'extensions'))}"


def extension_names() -> tuple[str, ...]:
    """Names of the shipped extension packs."""
    root = data_path("hazard_catalog", "extensions")
    if not root.is_dir():
        return ()
    return tuple(sorted(path.name for path in root.iterdir() if path.is_dir()))


def open_extra(path: Path) -> Folder:
    """An extra folder, or one file: its name or its folder's name says what it holds; a home's may
    lie anywhere."""
    shipped = data_path("hazard_catalog").resolve()
    if path.resolve() == shipped or shipped in path.resolve().parents:
        return Folder(pack="core")  # loaded already
    if not path.is_dir():
        single = Folder(pack=path.stem)
        if path.stem in _RENAMED and _is_yaml(path):
            single.problems.append(f"{path}: {_misplaced(path)}")
            return single
        folder = path.resolve().parent.name
        kind = path.stem if path.stem in FILES else folder if folder in FOLDERS else "hazards"
        single.add(kind, path, str(path))
        if folder not in FOLDERS and any(map(_draws, single.sources.get("hazards", ()))):
            single.sources["homes"] = single.sources.pop("hazards")
        return single
    out = open_folder(path, path.resolve().name, str(path))
    if not out.sources and not out.problems:
        layout = f"{', '.join(f'{name}/*.yaml' for name in FOLDERS)}, "
        layout += ", ".join(f"{name}.yaml" for name in FILES)
        out.problems.append(f"{path}: no catalogue file in it (expected {layout})")
    return out
