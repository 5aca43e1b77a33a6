"""The committed JSON Schemas are those of the records, and describe what is written."""

import json
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator  # type: ignore[import-untyped]
from sdgen.benchmark import detect, write_predictions
from sdgen.cameras.lens import Lens
from sdgen.dataset import Dataset
from sdgen.dataset.schema import FILES, schema_of, schema_text, write_schemas
from sdgen.dataset.text import record_bytes
from sdgen.looks import PRESETS, drawn_look
from sdgen.resources import data_path
from sdgen.scene import Panorama
from sdgen.seeding import lane
from sdgen.truth.observable import Observability, Observable

from tests import toy

UPDATE = "run 'python -m sdgen.dataset.schema'"


@pytest.mark.parametrize("name", FILES)
def test_committed_schema_is_up_to_date(name: str) -> None:
    path = data_path("schema", f"{name}.schema.json")
    assert path.is_file(), UPDATE
    assert path.read_text(encoding="utf-8") == schema_text(name), UPDATE


def test_no_schema_of_a_file_that_is_gone() -> None:
    names = {p.name.removesuffix(".schema.json") for p in data_path("schema").glob("*.json")}
    assert names == set(FILES), UPDATE


def test_writing_them_takes_stale_ones_away(tmp_path: Path) -> None:
    (tmp_path / "old.schema.json").write_text("{}")
    write_schemas(tmp_path)
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted(f"{n}.schema.json" for n in FILES)


CERTIFICATES = Observability(
    lens=Lens(),
    spacing_m=0.5,
    headings=12,
    pitches_deg=(0.0,),
    positions_m=((0.5, 1.0),),
    anomalies=(
        Observable(
            anomaly_id="a00",
            object_id=17,
            seen=((3,),),
            sure=((2,),),
            differs=((7,),),
            poses_seen=2,
            poses_differ=3,
            best=(0, 0, 1),
        ),
    ),
)


PANORAMA = Panorama(
    index=0,
    room_id=100,
    views=(0, 1, 2, 3, 4, 5),
    width=308,
    height=154,
    world_from_panorama=toy.camera(0, toy.small()).world_from_camera,
    look=drawn_look(PRESETS["robot"], 0.25, lane(7, 0, "look:100")),
)


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = toy.build(tmp_path_factory.mktemp("set") / "d")
    data = Dataset(path)
    write_predictions(path.parent / "predictions.jsonl", detect(data, "always"))
    (data[0].folder / "observability.json").write_bytes(record_bytes(CERTIFICATES))
    (data[0].folder / "panoramas" / "00").mkdir(parents=True)
    stitched = data[0].folder / "panoramas" / "00" / "panorama.json"
    stitched.write_bytes(record_bytes(PANORAMA))
    return path


def _documents(path: Path, name: str) -> list[Any]:
    lines = {"asset": "assets.jsonl", "manifest": "manifest.jsonl"}
    if name == "prediction":
        text = (path.parent / "predictions.jsonl").read_text(encoding="utf-8")
        return [json.loads(line) for line in text.splitlines()]
    if name in lines:
        text = (path / lines[name]).read_text(encoding="utf-8")
        return [json.loads(line) for line in text.splitlines()]
    if name in ("dataset", "catalogue"):
        return [json.loads((path / f"{name}.json").read_text(encoding="utf-8"))]
    folders = {"view": "views/*/", "panorama": "panoramas/*/"}
    pattern = f"{folders.get(name, '')}{name}.json"
    found = sorted((path / "scenes").glob(f"*/{pattern}"))
    return [json.loads(file.read_text(encoding="utf-8")) for file in found]


@pytest.mark.parametrize("name", FILES)
def test_written_files_follow_their_schema(path: Path, name: str) -> None:
    validator = Draft202012Validator(schema_of(name))
    documents = _documents(path, name)
    assert documents
    for document in documents:
        assert [e.message for e in validator.iter_errors(document)] == []


@pytest.mark.parametrize("name", FILES)
def test_unknown_and_missing_keys_break_the_schema(path: Path, name: str) -> None:
    validator = Draft202012Validator(schema_of(name))
    document = _documents(path, name)[0]
    assert not validator.is_valid({**document, "surprise": 1})
    first = next(iter(document))
    assert not validator.is_valid({k: v for k, v in document.items() if k != first})
