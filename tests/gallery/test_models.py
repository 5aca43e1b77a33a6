"""Models as scripts: those at hand and the same as the data set's; else it is said why not."""

import base64
import json
from pathlib import Path

import pytest
from sdgen.gallery.files import folder_of
from sdgen.gallery.models import Models
from sdgen.library.records import AssetInfo

from tests.shipped import shipped_library


def models(out: Path, infos: dict[str, AssetInfo], whole: bool = True) -> Models:
    for name in ("models", "surfaces"):
        folder_of(out, name)
    return Models(infos, "0" * 64, shipped_library() if whole else None, out)


def test_a_model_is_a_script_with_a_glb(tmp_path: Path) -> None:
    info = shipped_library().info("stove_01")
    made = models(tmp_path, {"stove_01": info})
    assert made.others
    assert made.why_box("stove_01") == ""
    text = (tmp_path / "models/stove_01.js").read_text(encoding="ascii")
    assert text.startswith('sdgen.model("stove_01",{')
    content = json.loads(text[text.index("{") : text.rindex("}") + 1])
    assert [name for name, _ in content["parts"]] == [part.name for part in info.parts]
    assert content["variants"].keys() == info.variants.keys()
    assert base64.b64decode(content["glb"]).startswith(b"glTF")


@pytest.mark.parametrize("field", ["extents_m", "parts", "outlines_m"])
def test_a_model_that_differs_is_none_of_the_data_sets(tmp_path: Path, field: str) -> None:
    info = shipped_library().info("stove_01")
    changes = {"extents_m": (9, 9, 9), "parts": info.parts[:1], "outlines_m": {}}
    other = info.model_copy(update={field: changes[field]})
    made = models(tmp_path, {"stove_01": other})
    assert made.why_box("stove_01").startswith("differs")
    assert not (tmp_path / "models/stove_01.js").exists()


def test_what_an_older_data_set_does_not_say_does_not_differ(tmp_path: Path) -> None:
    info = shipped_library().info("stove_01")
    older = AssetInfo.model_validate(info.model_dump(exclude={"outlines_m", "resting", "title"}))
    assert models(tmp_path, {"stove_01": older}).why_box("stove_01") == ""


def test_models_that_are_not_at_hand(tmp_path: Path) -> None:
    info = shipped_library().info("stove_01").model_copy(update={"id": "mine_01"})
    assert models(tmp_path, {"mine_01": info}).why_box("mine_01") == "not at hand"
    assert models(tmp_path, {"stove_01": info}, whole=False).why_box("stove_01") == "not at hand"
