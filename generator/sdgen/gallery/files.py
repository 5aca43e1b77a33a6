"""Where pages are written: folders that are ours, files that replace older ones of ours."""

from __future__ import annotations

import os
import stat
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from sdgen.dataset.output_file import refuse_data_set, refuse_links, write_output
from sdgen.errors import SdgenError, naming
from sdgen.files import kind_of
from sdgen.gallery.words import plain

INDEX = "index.html"
STYLE = "style.css"
#: Ours, and three.js with its licence (scripts/vendor_three.py).
SCRIPTS = (
    "index.js",
    "scene.js",
    "graph.js",
    "space_models.js",
    "space_shell.js",
    "space_marks.js",
    "space_controls.js",
    "space.js",
)
VENDOR = ("three.min.js", "three.LICENSE.txt")


def templates() -> Environment:
    """The page templates, strict about names and careful with text from files."""
    environment = Environment(
        loader=PackageLoader("sdgen.gallery", "templates"),
        autoescape=select_autoescape(default=True, default_for_string=True),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["words"] = plain
    return environment


def begin_page(out: Path, mark: bytes, scripts: Sequence[str] = ()) -> None:
    """Make the folder of a page, with its style, which begins with ``mark``, and its scripts."""
    out.mkdir(parents=True, exist_ok=True)
    package = files("sdgen.gallery")
    write_output(out / STYLE, mark + b"\n" + (package / "static" / STYLE).read_bytes())
    for name in scripts:
        folder = "vendor" if name in VENDOR else "static"
        put(out / name, (package / folder / name).read_bytes())


def refuse_foreign(out: Path, mark: bytes) -> None:
    """Raise SdgenError for a folder that holds something other than a page with this mark."""
    refuse_links(out, "folder")
    refuse_data_set(out)
    if out.exists() and not out.is_dir():
        raise SdgenError(f"{out}: is a file; choose another place for the page")
    style = out / STYLE
    ours = style.is_file() and style.read_bytes().startswith(mark)
    if out.is_dir() and any(out.iterdir()) and not ours:
        raise SdgenError(f"{out}: is not empty; choose another place for the page")


def folder_of(out: Path, name: str) -> Path:
    """A folder of a page, made where it is not there. Raises SdgenError for a link."""
    folder = out / name
    refuse_links(folder, "folder")
    folder.mkdir(exist_ok=True)
    return folder


def put(path: Path, data: bytes) -> None:
    """Write a file of a page, in place of an older one, without waiting for the disk: a page can
    be made again. Raises SdgenError for what is no plain file."""
    try:
        mode = path.lstat().st_mode
    except FileNotFoundError:
        mode = stat.S_IFREG
    if not stat.S_ISREG(mode):
        raise SdgenError(f"{path}: is {kind_of(mode)}; take it away or choose another place")
    partial = path.with_name(f".{path.name}.partial")
    with naming(path):
        partial.unlink(missing_ok=True)
        try:
            with partial.open("xb") as file:  # never through a link that somebody puts there
                file.write(data)
            os.replace(partial, path)
        finally:
            partial.unlink(missing_ok=True)
