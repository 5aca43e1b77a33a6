"""Whose folder is it, and what is the data set in it built with?"""

from __future__ import annotations

from pathlib import Path

from sdgen.dataset.records import Build, DatasetInfo
from sdgen.dataset.scene_folder import BUILD_FOLDER
from sdgen.dataset.text import parse, read_bytes, read_record
from sdgen.errors import InputError, SdgenError
from sdgen.options import BuildOptions


def refuse_foreign(root: Path) -> None:
    """Raise SdgenError for a file, and for a folder that holds something else."""
    if not root.exists():
        return
    if not root.is_dir():
        raise SdgenError(f"{root} is a file; choose another --out")
    # The names alone prove nothing: other tools have a dataset.json or a .build folder too.
    unfinished = root / BUILD_FOLDER / "build.json"
    if unfinished.is_file() or _is_ours(root / "dataset.json"):
        return
    if any(path.name != BUILD_FOLDER for path in root.iterdir()):
        raise SdgenError(
            f"{root} is not empty and holds no data set of sdgen; choose another --out"
        )


def _is_ours(path: Path) -> bool:
    """True for a ``dataset.json`` that sdgen wrote, be it of another version."""
    try:
        data = parse(read_bytes(path, str(path)), str(path))
    except InputError:
        return False
    return isinstance(data, dict) and {"format_version", "catalogue_sha256"} <= data.keys()


def build_of(root: Path) -> Build | None:
    """What the data set in a folder is built with; None when there is none yet."""
    unfinished = root / BUILD_FOLDER / "build.json"
    if unfinished.is_file():
        return read_record(Build, unfinished, str(unfinished))
    if (root / "dataset.json").is_file():
        return read_record(DatasetInfo, root / "dataset.json", str(root / "dataset.json")).build()
    return None


def differences(found: Build, asked: Build, which: str = "now") -> list[str]:
    """What another build was made with, in words: ``seed 7 (now 8)``, where ``which`` says whose
    the second value is. The number of scenes may differ."""
    out = []
    if found.format_version != asked.format_version:
        out.append(f"format {found.format_version} ({which} {asked.format_version})")
    for name in BuildOptions.model_fields:
        before, now = getattr(found.options, name), getattr(asked.options, name)
        if name != "n" and before != now:
            out.append(f"{name} {_shown(before)} ({which} {_shown(now)})")
    if found.catalogue_sha256 != asked.catalogue_sha256:
        out.append("another catalogue")
    if found.assets_sha256 != asked.assets_sha256:
        out.append("other assets")
    for name in sorted({*found.versions, *asked.versions}):
        before, now = found.versions.get(name, "none"), asked.versions.get(name, "none")
        if before != now:
            out.append(f"{name} {before} ({which} {now})")
    return out


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return ",".join(str(item) for item in value) or "none"
    return str(value)
