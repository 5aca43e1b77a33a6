"""The built wheel works from any folder, its data included."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest
import sdgen

from tests.shipped import shipped_library

ROOT = Path(__file__).resolve().parent.parent
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("wheel")]  # one wheel, one worker


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("dist")
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "-o", str(out)]
    done = subprocess.run([*command, str(ROOT)], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    (path,) = out.glob("*.whl")
    return path


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The ``sdgen`` script of a fresh environment that holds the wheel.

    Its dependencies are borrowed from this environment by path; a path file inside a borrowed
    folder is not read, so the checkout itself stays out of sight.
    """
    folder = tmp_path_factory.mktemp("env")
    venv.create(folder, with_pip=False, symlinks=True)
    python = folder / "bin" / "python"
    pip = [sys.executable, "-m", "pip", "--python", str(python), "install", "--no-deps"]
    subprocess.run([*pip, "--no-index", "--quiet", str(wheel)], check=True)
    (site,) = folder.glob("lib/python*/site-packages")
    paths = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib")}
    (site / "borrowed.pth").write_text("\n".join(sorted(paths)) + "\n", encoding="utf-8")
    return folder / "bin" / "sdgen"


def call(program: Path, *args: str, cwd: Path) -> str:
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    done = subprocess.run(
        [str(program), *args], capture_output=True, text=True, cwd=cwd, env=environment
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_wheel_holds_the_data_and_no_litter(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    for wanted in (
        "sdgen/py.typed",
        "sdgen/importing/addresses.yaml",
        "sdgen/gallery/static/space.js",
        "sdgen/gallery/templates/scene.html.j2",
        "sdgen/benchmark/templates/report.html.j2",
        "sdgen/benchmark/templates/leaderboard.md.j2",
        "sdgen/detectors/templates/model_card.md.j2",
        "sdgen/gallery/vendor/three.min.js",
        "sdgen/gallery/vendor/three.LICENSE.txt",
        "sdgen/_data/assets/manifest.yaml",
        "sdgen/_data/assets/LICENSES/CC-BY-4.0.txt",
    ):
        assert wanted in names
    for folder in ("hazard_catalog/hazards", "hazard_catalog/homes", "assets/meshes", "schema"):
        assert any(name.startswith(f"sdgen/_data/{folder}/") for name in names), folder
    assert [name for name in names if "__pycache__" in name or name.endswith(".pyc")] == []
    assert not any(name.startswith(("tests", "generator", "scripts")) for name in names)


def test_installed_command_works_from_another_folder(installed: Path, tmp_path: Path) -> None:
    assert sdgen.__version__ in call(installed, "--version", cwd=tmp_path)
    assets = json.loads(call(installed, "assets", "list", "--json", cwd=tmp_path))
    hazards = json.loads(call(installed, "catalog", "list", "--json", cwd=tmp_path))
    assert [row["id"] for row in assets] == list(shipped_library().assets)
    assert {"spill", "stove_on"} <= {row["id"] for row in hazards}


def test_installed_package_is_the_wheel_not_the_checkout(installed: Path, tmp_path: Path) -> None:
    code = "import sdgen.resources as r; print(r.data_path('assets'))"
    where = call(installed.with_name("python"), "-c", code, cwd=tmp_path)
    assert "_data" in where
    assert str(ROOT) not in where
