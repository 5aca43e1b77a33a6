"""One thing wrong with a data set: validate names it, readers and exporters refuse it clearly."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.errors import InputError
from sdgen.export import FORMATS, export
from sdgen.gallery import write_gallery
from sdgen.validate import validate

from tests import toy
from tests.edits import edit_picture, reseal

SCENE = "scenes/000001"
Damage = Callable[[Path], None]


def _missing_file(path: Path) -> None:
    (path / SCENE / "scene.json").unlink()


def _flipped_record(path: Path) -> None:
    _flip(path / SCENE / "scene.json")


def _flipped_pictures(path: Path) -> None:
    for file in (path / SCENE).glob("views/*/rgb.png"):
        _flip(file)


def _flip(file: Path) -> None:
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 0x20
    file.write_bytes(data)


def _foreign_version(path: Path) -> None:
    text = (path / "dataset.json").read_text(encoding="utf-8")
    text = re.sub(r'"format_version": ?"[^"]*"', '"format_version": "7.3"', text)
    (path / "dataset.json").write_text(text, encoding="utf-8")


def _climbing_path(path: Path) -> None:
    text = (path / "manifest.jsonl").read_text(encoding="utf-8")
    (path / "manifest.jsonl").write_text(
        text.replace('"scene.json"', '"../../../secret.json"', 1), encoding="utf-8"
    )


def _climbing_id(path: Path) -> None:
    text = (path / "manifest.jsonl").read_text(encoding="utf-8")
    (path / "manifest.jsonl").write_text(
        text.replace('"id":"000001"', '"id":"../../000001"').replace(
            '"id": "000001"', '"id": "../../000001"'
        ),
        encoding="utf-8",
    )


def _two_scenes_with_one_id(path: Path) -> None:
    lines = (path / "manifest.jsonl").read_text(encoding="utf-8").splitlines(keepends=True)
    (path / "manifest.jsonl").write_text("".join([*lines, lines[1]]), encoding="utf-8")


def _not_a_number(path: Path) -> None:
    file = path / SCENE / "scene.json"
    data = json.loads(file.read_text(encoding="utf-8"))
    data["objects"][0]["pose"]["position_m"][0] = float("nan")
    file.write_text(json.dumps(data), encoding="utf-8")
    reseal(path)


def _link_outwards(path: Path) -> None:
    folder = path.parent / "elsewhere"
    (path / SCENE / "views").rename(folder)
    (path / SCENE / "views").symlink_to(folder)


#: What is done, what names it, and whether it shows when the data set is opened or a scene is read.
DAMAGES: dict[str, tuple[Damage, str]] = {
    "missing file": (_missing_file, "scene.json"),
    "flipped byte": (_flipped_record, "scene.json: changed"),
    "flipped byte of a picture": (_flipped_pictures, "rgb.png: changed"),
    "foreign version": (_foreign_version, "format_version: '7.3' cannot be read"),
    "climbing path": (_climbing_path, r"'\.\./\.\./\.\./secret.json'"),
    "climbing id": (_climbing_id, "id: "),
    "two scenes with one id": (_two_scenes_with_one_id, "000001 appears twice"),
    "not a number": (_not_a_number, "scene.json.*NaN"),
    "link outwards": (_link_outwards, "link"),
}
READ_ALL = [name for name, known in FORMATS.items() if not known.models]


@pytest.fixture
def homes(tmp_path: Path) -> Path:
    return toy.build(tmp_path / "homes", toy.small(n=2))


@pytest.mark.parametrize("what", DAMAGES)
def test_validate_names_it(what: str, homes: Path, capsys: pytest.CaptureFixture[str]) -> None:
    damage, words = DAMAGES[what]
    damage(homes)
    found = [problem.text for problem in validate(homes)]
    assert any(re.search(words, text) for text in found), found
    assert run(["validate", str(homes)]) == 1
    out, err = capsys.readouterr()
    assert re.search(words, out)
    assert "Traceback" not in out + err


@pytest.mark.parametrize("what", DAMAGES)
def test_a_reader_refuses_it(what: str, homes: Path) -> None:
    damage, words = DAMAGES[what]
    damage(homes)
    with pytest.raises(InputError, match=words):
        read_all(homes)


def read_all(path: Path) -> None:
    """Read each file of a data set that holds content."""
    for item in Dataset(path):
        for name in ("scene", "scene_graph", "anomalies", "household", "visibility", "physics"):
            getattr(item, name)
        for view in range(len(item.cameras)):
            for pixels in (item.rgb, item.depth, item.instance, item.part):
                pixels(view)


@pytest.mark.parametrize("what", DAMAGES)
@pytest.mark.parametrize("name", READ_ALL)
def test_an_exporter_leaves_nothing(
    name: str, what: str, homes: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    DAMAGES[what][0](homes)
    place = tmp_path / "exported"
    place.mkdir()
    out = place / ("homes.tar" if FORMATS[name].output == "file" else "homes")
    code = run(["export", str(homes), "--format", name, "-o", str(out)])
    said = capsys.readouterr()
    unread = "picture" in what or "link" in what
    if (name == "virtualhome" and unread) or (name == "tar" and what == "not a number"):
        assert code == 0  # the one reads no pictures, the other no numbers
        return
    assert code == 1
    assert re.fullmatch(r"(error: .+\n)+", said.err), said.err
    assert list(place.iterdir()) == []


@pytest.mark.parametrize("what", DAMAGES)
def test_the_gallery_is_not_begun_or_says_what_is_wrong(
    what: str, homes: Path, tmp_path: Path
) -> None:
    damage, words = DAMAGES[what]
    damage(homes)
    with pytest.raises(InputError, match=words):
        write_gallery(Dataset(homes), tmp_path / "page")


def _stranger(mask: object) -> None:
    mask[0, 0] = 999  # type: ignore[index]


def test_a_mask_with_an_id_that_nothing_has(homes: Path, tmp_path: Path) -> None:
    edit_picture(homes / SCENE / "views/01/instance.png", _stranger)
    reseal(homes)
    assert any("id 999 is no node" in problem.text for problem in validate(homes))
    pytest.importorskip("pycocotools")
    with pytest.raises(InputError, match="names 999, which is not there"):
        export(Dataset(homes), "coco", tmp_path / "coco")
    assert list(tmp_path.iterdir()) == [homes]
