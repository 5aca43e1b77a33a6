"""``sdgen doctor``: what this machine can do, and what is missing."""

from __future__ import annotations

import json
import platform
import sys
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from typing import Literal

import click

from sdgen.errors import SdgenError, os_error_in_words

Level = Literal["ok", "note", "bad"]
_MARK: dict[Level, str] = {"ok": "ok  ", "note": "note", "bad": "BAD "}


@dataclass(frozen=True)
class Finding:
    """One line of the report: ``bad`` means nothing can be built here."""

    what: str
    level: Level
    text: str


def _python() -> Finding:
    text = f"{platform.python_version()} on {platform.machine()}"
    if sys.version_info[:2] > (3, 11):
        text += "; PyBullet has no wheel for it and is built from source (needs g++)"
        return Finding("Python", "note", text)
    return Finding("Python", "ok", text)


def _pybullet() -> Finding:
    if find_spec("pybullet") is None:
        return Finding("PyBullet", "bad", "not installed: pip install pybullet (Python ≤ 3.11)")
    from sdgen.physics.bullet import pb

    try:
        text = version("pybullet")
    except PackageNotFoundError:
        text = "of unknown version"
    if not pb.isNumpyEnabled():
        return Finding(
            "PyBullet",
            "note",
            f"{text}, built without numpy: pictures are many times slower; reinstall it with "
            "numpy present (pip install --no-build-isolation --force-reinstall pybullet)",
        )
    return Finding("PyBullet", "ok", f"{text}, with numpy")


def _egl() -> Finding:
    from sdgen.render.registry import renderer_type

    found = renderer_type("egl").probe()
    if found.works:
        return Finding("EGL renderer", "ok", found.renderer_string)
    return Finding(
        "EGL renderer",
        "note",
        f"does not start ({found.reason}); pictures come from TinyRenderer. {found.hint}",
    )


def _light() -> Finding:
    from sdgen.render.light import HAS_RAYS

    if HAS_RAYS:
        return Finding("Light", "ok", f"by rays, embreex {version('embreex')}")
    text = "rooms are lit evenly: there is no embreex here (it has wheels for most machines)"
    return Finding("Light", "note", text)


def _cache() -> Finding:
    from sdgen.library.cache import cache_root

    root = cache_root()
    try:
        root.mkdir(parents=True, exist_ok=True)
        probe = root / ".doctor"
        probe.write_text("", encoding="utf-8")
        probe.unlink()
    except OSError as error:
        hint = "set SDGEN_CACHE to a folder that can be written"
        return Finding("Model cache", "bad", f"{root}: {error.strerror}; {hint}")
    return Finding("Model cache", "ok", str(root))


def _assets() -> Finding:
    from sdgen.library import load_library

    library = load_library()
    text = f"{len(library.assets)} models of {len(library.categories)} categories"
    if not library.assets:
        return Finding("Assets", "bad", "the library is empty")
    return Finding("Assets", "ok", f"{text}, {len(library.surfaces)} surfaces")


def _catalogue() -> Finding:
    from sdgen.catalog.load import load_catalog

    catalog = load_catalog()
    text = f"{len(catalog.hazards)} hazards, {len(catalog.homes)} base homes"
    return Finding("Catalogue", "ok", text)


_CHECKS: dict[str, Callable[[], Finding]] = {
    "Python": _python,
    "PyBullet": _pybullet,
    "EGL renderer": _egl,
    "Light": _light,
    "Model cache": _cache,
    "Assets": _assets,
    "Catalogue": _catalogue,
}


def examine() -> list[Finding]:
    """All findings; a check that meets broken input, or a package or a library of the system that
    cannot be loaded, becomes a bad finding itself."""
    out: list[Finding] = []
    for what, check in _CHECKS.items():
        if what == "EGL renderer" and any(f.what == "PyBullet" and f.level == "bad" for f in out):
            continue
        try:
            out.append(check())
        except SdgenError as error:
            out.append(Finding(what, "bad", str(error)))
        except ImportError as error:
            text = " ".join(str(error).split())
            advice = "install it anew (pip install --force-reinstall), or what it lacks"
            out.append(Finding(what, "bad", f"cannot be loaded: {text}; {advice}"))
        except OSError as error:
            out.append(Finding(what, "bad", os_error_in_words(error)))
    return out


@click.command(epilog="Example: sdgen doctor")
@click.option("--json", "as_json", is_flag=True, help="Print one object.")
def doctor(as_json: bool) -> None:
    """Say what this machine can do, and what is missing.

    Exit code 0 when data sets can be built here, 1 when not.
    """
    findings = examine()
    if as_json:
        data = {f.what: {"level": f.level, "text": f.text} for f in findings}
        click.echo(json.dumps(data, indent=2, ensure_ascii=False))
    else:
        for finding in findings:
            click.echo(f"{_MARK[finding.level]}  {finding.what:<12}  {finding.text}")
    if any(finding.level == "bad" for finding in findings):
        raise click.exceptions.Exit(1)
