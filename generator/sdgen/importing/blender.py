"""Runs a script in Blender, whichever there is: $BLENDER, the package ``bpy``, or the system's.

Nothing here imports bpy: it runs in a process of its own, so that neither its size nor its crashes
are ours.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from sdgen.errors import SdgenError

#: Names the Blender to use before any other.
VARIABLE = "BLENDER"
#: Lines of its output that are told when it fails.
_LAST_LINES = 12
_LONGEST_LINE = 300
#: Bytes at the end of its output in which those are looked for.
_TAIL = 20_000
_RUN_SCRIPT = ("--background", "--factory-startup", "--python-exit-code", "1", "--python")


class BlenderError(SdgenError):
    """There is no Blender, or it failed."""


@dataclass(frozen=True)
class Blender:
    """How to run a script: the words before its path. ``name`` says which Blender it is."""

    command: tuple[str, ...]
    name: str


def find_blender() -> Blender:
    """``$BLENDER``, else the package ``bpy`` of this Python, else ``blender`` on the PATH.

    Raises BlenderError that says what to install when there is none.
    """
    chosen = os.environ.get(VARIABLE)
    if chosen:
        found = shutil.which(chosen)
        if found is None:
            raise BlenderError(f"${VARIABLE} is {chosen!r}: no such program")
        return Blender((found, *_RUN_SCRIPT), found)
    if find_spec("bpy") is not None:
        return Blender((sys.executable,), "the package bpy")
    found = shutil.which("blender")
    if found is not None:
        return Blender((found, *_RUN_SCRIPT), found)
    raise BlenderError(_missing(sys.version_info[:2]))


def _missing(python: tuple[int, int]) -> str:
    """What to install, for a Python version."""
    release = {(3, 11): "'bpy>=4.2,<5.1'", (3, 13): "'bpy>=5.1'"}.get(python)
    package = (
        f"'pip install {release}'"
        if release
        else f"(bpy has no release for Python {python[0]}.{python[1]}: 3.11 and 3.13 have one)"
    )
    return (
        "retexturing needs Blender 3.4 or later, and there is none: install your system's "
        f"('apt install blender', or from blender.org), name one in ${VARIABLE}, or install the "
        f"package bpy {package}"
    )


def run_script(blender: Blender, script: Path, arguments: Sequence[str], scratch: Path) -> str:
    """Run a script of ours; its output, the end of it. There is no limit of time.

    ``scratch`` is a folder for what it prints. Raises BlenderError with the last lines when it
    fails.
    """
    log = scratch / "blender.log"
    command = [*blender.command, str(script), "--", *arguments]
    environment = {**os.environ, "SDGEN_SITE_PACKAGES": _site_packages()}
    try:
        with log.open("wb") as output:
            code = subprocess.run(
                command,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                env=environment,
                cwd=scratch,
                check=False,
            ).returncode
    except OSError as error:
        raise BlenderError(f"{blender.name} cannot be started ({error.strerror})") from None
    printed = _tail(log)
    if code != 0:
        ended = f"was ended by signal {-code}" if code < 0 else f"failed with exit code {code}"
        raise BlenderError("\n".join([f"{blender.name} {ended}; it said last:", *_last(printed)]))
    return printed


def _site_packages() -> str:
    """Where our NumPy is: Debian's Blender runs the system's Python, which may have none."""
    numpy = find_spec("numpy")
    return str(Path(numpy.origin).parent.parent) if numpy and numpy.origin else ""


def _tail(log: Path) -> str:
    with log.open("rb") as file:
        file.seek(max(0, log.stat().st_size - _TAIL))
        return file.read().decode("utf-8", "replace")


def _last(printed: str) -> list[str]:
    lines = [line.rstrip() for line in printed.splitlines() if line.strip()]
    return [f"  {line[:_LONGEST_LINE]}" for line in lines[-_LAST_LINES:]] or ["  nothing"]
