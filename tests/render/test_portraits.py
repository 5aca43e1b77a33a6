"""Pictures of single models."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sdgen.cameras.pinhole import project
from sdgen.cli.main import run
from sdgen.library import Library
from sdgen.library.states import derive_states
from sdgen.render import open_renderer
from sdgen.render.portraits import look_in_state, looks_of, portrait, portrait_camera

from tests.fakes import RED
from tests.shipped import shipped_library


@pytest.mark.parametrize("extents", [(0.1, 0.1, 0.3), (1.0, 0.4, 0.01), (0.6, 2.0, 1.2)])
def test_the_camera_sees_all_of_it_and_little_else(extents: tuple[float, float, float]) -> None:
    x, y, z = extents
    corners = np.array([(a * x, b * y, c * z) for a in (0, 1) for b in (0, 1) for c in (0, 1)])
    camera = portrait_camera(corners, 200)
    pixels, depth = project(camera, corners)
    assert (depth > camera.near_m).all()
    assert (pixels > 0).all()
    assert (pixels < 199).all()
    assert np.ptp(pixels, axis=0).max() > 0.7 * 200


def test_a_portrait_shows_the_model_on_the_floor(library: Library) -> None:
    with open_renderer("cpu") as renderer:
        picture = portrait(renderer, library, "cube_01", looks_of(library.info("cube_01"))[0], 96)
    assert picture.shape == (96, 96, 3)
    middle = picture[40:56, 40:56].reshape(-1, 3).mean(axis=0)
    assert middle[0] > 2 * max(middle[1], middle[2])
    assert middle[0] / middle[1] == pytest.approx(RED[0] / RED[1], rel=0.2)
    corner = picture[-6:, :6].reshape(-1, 3).mean(axis=0)
    assert corner[0] < 1.6 * corner[1]


def test_looks_name_variants_and_open_joints(library: Library) -> None:
    assert [look.name for look in looks_of(library.info("flush_01"))] == ["default", "pane"]
    looks = looks_of(library.info("cabinet_01"))
    assert [look.name for look in looks] == ["default", "open"]


@pytest.mark.parametrize(
    ("asset", "state"),
    [("fridge_01", "OPEN"), ("mug_01", "BROKEN"), ("apple_01", "EXPIRED"), ("wardrobe_01", "OPEN")],
)
def test_a_look_in_a_state_is_in_that_state(asset: str, state: str) -> None:
    info = shipped_library().info(asset)
    look = look_in_state(info, state)
    assert look is not None
    assert state in derive_states(info, look.variant, look.joints)
    assert look_in_state(info, "FULL_OF_WONDER") is None


def test_the_command_writes_pages(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "cups.png"
    words = ["mug_01", "mug_02", "mug_03"]
    options = ["--size", "48", "--per-page", "2", "--columns", "2", "--renderer", "cpu"]
    assert run(["assets", "sheet", "-o", str(out), *options, *words]) == 0
    assert capsys.readouterr().out.splitlines() == [
        f"{tmp_path / 'cups-01.png'}: 2 pictures",
        f"{tmp_path / 'cups-02.png'}: 1 pictures",
    ]
    with Image.open(tmp_path / "cups-01.png") as sheet:
        assert sheet.size == (2 * 52 + 4, 66 + 4)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["-o", "x.gif", "mug"], "a sheet is a .png or a .jpg"),
        (["-o", "nowhere/x.png", "mug"], "no such folder"),
        (["-o", "x.png", "mugg"], "did you mean 'mug'"),
    ],
)
def test_bad_requests_are_told(
    words: list[str],
    told: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["assets", "sheet", *words]) == 2
    assert told in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
