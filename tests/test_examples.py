"""The examples run on a data set that takes seconds to build."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.cli.main import run

ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / "examples"

pytestmark = pytest.mark.xdist_group("examples")  # one data set, one worker


@pytest.fixture(scope="module")
def homes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("examples") / "homes"
    options = "--n 2 --seed 7 --hazards 2-3 --views 4 --size 160x120 --workers 1 --catalog"
    code = run(["build", *options.split(), str(EXAMPLES / "extra_catalog"), "--out", str(out)])
    assert code == 0
    return out


def call(script: str, *args: object) -> str:
    command = [sys.executable, str(EXAMPLES / script), *map(str, args)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_my_detector_can_be_scored(
    homes: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "predictions.jsonl"
    call("my_detector.py", homes, out)
    assert len(out.read_text(encoding="utf-8").splitlines()) == 2
    capsys.readouterr()
    assert run(["evaluate", str(homes), str(out)]) == 0
    assert "AS" in capsys.readouterr().out


@pytest.mark.slow
def test_crops_shows_every_visible_anomaly(homes: Path, tmp_path: Path) -> None:
    listed = call("crops.py", homes, tmp_path).split()
    assert listed
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        Path(name).name for name in listed
    )


def test_the_extra_catalogue_adds_one_hazard() -> None:
    shipped = {hazard.id for hazard in load_catalog().hazards}
    extended = {hazard.id for hazard in load_catalog([EXAMPLES / "extra_catalog"]).hazards}
    assert extended - shipped == {"paper_on_stove"}
    assert shipped <= extended


@pytest.mark.parametrize("path", sorted(EXAMPLES.iterdir()), ids=lambda path: path.name)
def test_every_example_is_listed(path: Path) -> None:
    listed = (EXAMPLES / "README.md").read_text(encoding="utf-8")
    assert path.name in listed or path.name in ("README.md", "__pycache__")
