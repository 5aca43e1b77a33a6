"""``sdgen home``: one home drawn and written, and every bad word one clear line."""

from __future__ import annotations

import io
import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from PIL import Image
from sdgen.catalog.load import load_catalog
from sdgen.cli.home import home
from sdgen.cli.main import run
from sdgen.resources import data_path


def call(*words: str) -> Result:
    return CliRunner().invoke(home, list(words), catch_exceptions=False)


def test_list() -> None:
    homes = load_catalog().homes
    rows = json.loads(call("list", "--json").output)
    assert [row["id"] for row in rows] == [one.id for one in homes]
    assert [len(row["rooms"]) for row in rows] == [len(one.rooms) for one in homes]
    lines = call("list").output.splitlines()
    assert len(lines) == len(homes)
    assert all(one.id in line for one, line in zip(homes, lines, strict=True))


def test_show_draws_a_plan_and_views_by_the_renderer_of_every_machine(tmp_path: Path) -> None:
    out = tmp_path / "flat"
    words = ["--views", "2", "--size", "96x72", "--renderer", "cpu", "--out", str(out)]
    shown = call("show", "apartment_1", *words)
    assert shown.exit_code == 0
    assert f"{out}: plan.png and 2 views" in shown.output
    for room in ("bathroom", "bedroom", "hall", "kitchen", "living_room"):
        assert room in shown.output
    views = sorted(out.glob("*.jpg"))
    assert [path.name[:3] for path in views] == ["00_", "01_"]
    for path in views:
        with Image.open(path) as image:
            assert image.size == (96, 72)
            assert len(image.convert("L").getcolors() or ()) > 20  # it shows something
    with Image.open(out / "plan.png") as plan:
        assert plan.width > 600


def test_show_counts_what_is_there(tmp_path: Path) -> None:
    words = ["--views", "0", "--renderer", "cpu", "--out", str(tmp_path / "out"), "--json"]
    rooms = {row["name"]: row for row in json.loads(call("show", "apartment_1", *words).output)}
    assert rooms["kitchen"]["furniture"]["stove"] == 1
    # 4 x 3.2 m between the middles of walls 0.12 m thick.
    assert rooms["kitchen"]["area_m2"] == pytest.approx(3.88 * 3.08, abs=0.01)
    for row in rooms.values():
        held = sum(row["furniture"].values()) + sum(row["things"].values())
        # Itself, its floor, its ceiling and four walls at the least.
        assert row["nodes"] >= held + 7
    assert sum(sum(row["things"].values()) for row in rooms.values()) > 20


def test_export_is_read_back_by_name_or_as_a_file(tmp_path: Path) -> None:
    file = tmp_path / "mine" / "homes" / "my_flat.yaml"
    assert call("export", "apartment_1", "--seed", "2", "-o", str(file)).exit_code == 0
    (mine,) = (one for one in load_catalog([file]).homes if one.id == "my_flat")
    wanted = [p for room in mine.rooms for p in room.furniture]
    fitted = {fitting.category for fitting in load_catalog().fittings}
    assert len(wanted) > 30
    assert all(piece.model for piece in wanted)
    alone = tmp_path / "my_flat.yaml"
    alone.write_bytes(file.read_bytes())  # in a folder that says nothing of what it holds
    for which in (str(file), str(alone)):
        words = ["--views", "0", "--renderer", "cpu", "--out", str(tmp_path / "out"), "--json"]
        rows = json.loads(call("show", which, *words).output)
        pieces = [pair for row in rows for pair in row["furniture"].items()]
        counted = sum(count for category, count in pieces if category not in fitted)
        assert counted == len(wanted)


def test_export_of_a_glb(tmp_path: Path) -> None:
    import trimesh

    file = tmp_path / "home.glb"
    assert call("export", "three_room_flat_2", "--out", str(file)).exit_code == 0
    loaded = trimesh.load_scene(io.BytesIO(file.read_bytes()), file_type="glb")
    assert any(name.startswith("fridge_") for name in loaded.graph.nodes)


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (["show", "apartment_2"], 2, "no base home 'apartment_2' (did you mean 'apartment_1'?)"),
        (["show", "-5"], 2, "No such option"),
        (["show", "99999999999999999999"], 2, "seed 99999999999999999999 is above"),
        (["show", "none.yaml"], 1, "none.yaml: no such file"),
        (["export", "7", "-o", "home.obj"], 2, "home.obj: expected a name that ends in"),
        (["export", "7", "-o", "My Home.yaml"], 2, "'My Home' is not a name"),
        (["export", "7"], 2, "Missing option"),
    ],
)
def test_bad_words(
    words: list[str], code: int, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["home", *words]) == code
    error = capsys.readouterr().err
    assert text in error
    assert "Traceback" not in error
    assert "unexpected" not in error


def test_a_bad_home_is_told_of_by_every_command_that_reads_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shipped = data_path("hazard_catalog", "homes", "apartment_1.yaml").read_text()
    text = shipped.replace("id: apartment_1", "id: mine").replace(
        "[0.44, 7.51, 0]", "[0.2, 7.51, 0]"
    )
    file = tmp_path / "mine.yaml"
    file.write_text(text)
    number = 1 + text[: text.index("category: fridge")].count("\n")
    wanted = f"error: {file}:{number}: rooms[1].furniture[0]: fridge: none of its "
    out = str(tmp_path / "out")
    for words in (
        ["catalog", "validate", str(file)],
        ["home", "show", str(file), "--out", out],
        ["home", "export", str(file), "--out", f"{out}.yaml"],
        ["build", "--n", "1", "--homes", "base", "--catalog", str(file), "--out", out],
    ):
        assert run(words) == 1
        error = capsys.readouterr().err
        assert wanted in error, words
        assert "into a wall of 'kitchen'" in error
        assert "Traceback" not in error
    assert not Path(out).exists()
