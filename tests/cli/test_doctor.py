import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from sdgen.cli import doctor as module
from sdgen.cli.doctor import Finding, doctor, examine
from sdgen.render.protocol import Probe
from sdgen.render.raster.renderer import INSTALL_HINT, GlRenderer


def test_this_machine_can_build() -> None:
    result = CliRunner().invoke(doctor, ["--json"])
    assert result.exit_code == 0, result.output
    data = json.loads(result.output)
    assert list(data) == [
        "Python", "PyBullet", "EGL renderer", "Light", "Model cache", "Assets", "Catalogue",
    ]  # fmt: skip
    assert data["PyBullet"]["level"] == "ok"


def test_without_egl_it_names_the_packages_and_is_content(monkeypatch: pytest.MonkeyPatch) -> None:
    refused = Probe(False, reason="no libEGL.so.1", hint=INSTALL_HINT)
    monkeypatch.setattr(GlRenderer, "probe", staticmethod(lambda: refused))
    found = next(f for f in examine() if f.what == "EGL renderer")
    assert found.level == "note"
    assert "no libEGL.so.1" in found.text
    assert "libegl1 libgl1-mesa-dri libgl1" in found.text


def test_what_stops_a_build_is_exit_code_1(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "examine", lambda: [Finding("Assets", "bad", "empty")])
    result = CliRunner().invoke(doctor, [])
    assert result.exit_code == 1
    assert "BAD   Assets" in result.output


def test_a_cache_that_cannot_be_written(
    monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    blocked = tmp_path_factory.mktemp("cache") / "file"
    blocked.write_text("", encoding="utf-8")
    monkeypatch.setenv("SDGEN_CACHE", str(blocked / "below"))
    found = next(f for f in examine() if f.what == "Model cache")
    assert found.level == "bad"
    assert "SDGEN_CACHE" in found.text


@pytest.mark.parametrize(
    ("package", "error", "line"),
    [
        (
            "pybullet",
            "ImportError('libGL.so.1: cannot open it')",
            "BAD   PyBullet      cannot be loaded: libGL.so.1: cannot open it; install it anew",
        ),
        (
            "shapely",
            "OSError(2, 'No such file', 'libgeos_c.so')",
            "BAD   Catalogue     libgeos_c.so: No such file",
        ),
    ],
)
def test_a_package_that_is_there_and_cannot_be_loaded_is_a_line(
    tmp_path: Path, package: str, error: str, line: str
) -> None:
    """Built for another Python, say, or without a library of the system."""
    (tmp_path / f"{package}.py").write_text(f"raise {error}\n")
    env = {**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])}
    done = subprocess.run(
        [sys.executable, "-m", "sdgen", "doctor"], env=env, capture_output=True, text=True
    )
    assert done.returncode == 1
    assert done.stderr == ""
    assert any(said.startswith(line) for said in done.stdout.splitlines()), done.stdout
    assert any(said.startswith("ok    Python") for said in done.stdout.splitlines())
