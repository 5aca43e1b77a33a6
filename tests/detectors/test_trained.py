"""Trained detectors: what they see, that they are made and read the same, and what is refused."""

from __future__ import annotations

import hashlib
import io
import json
import sys
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.detectors import cnn
from sdgen.detectors.boosted import Boosted
from sdgen.detectors.layout import Layout
from sdgen.detectors.model_file import Kind, arrays_from
from sdgen.detectors.run import detect
from sdgen.detectors.trained import Trained, load_trained
from sdgen.detectors.training import KINDS, Lessons, train
from sdgen.errors import InputError, SdgenError, UsageError

from tests import toy

pytest.importorskip("sklearn")
Captured = pytest.CaptureFixture[str]


@pytest.fixture(scope="module")
def homes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("set") / "d", n=16)


@pytest.fixture(scope="module")
def lessons(homes: Path) -> Lessons:
    return Lessons(Dataset(homes))


@pytest.fixture(scope="module")
def made(lessons: Lessons, tmp_path_factory: pytest.TempPathFactory) -> Callable[[Kind], Path]:
    folder = tmp_path_factory.mktemp("models")

    def make(kind: Kind) -> Path:
        if kind == "cnn":
            pytest.importorskip("torch")
        if not (folder / kind).exists():
            train(lessons, kind, folder / kind)
        return folder / kind

    return make


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_trained_detects_in_scenes_and_twins(
    kind: Kind, made: Callable[[Kind], Path], homes: Path
) -> None:
    data = Dataset(homes)
    found = detect(data, load_trained(made(kind)), twins=True)
    assert found.keys() == {e.id for e in data.entries}
    for item in data:
        ids = {thing.id for thing in item.scene.objects}
        assert {r.object_id for r in found[item.id]} <= ids
        assert all(r.score is not None for r in found[item.id])
    card = (made(kind) / "README.md").read_text(encoding="utf-8")
    assert f"sdgen train DATASET --kind {kind} -o {kind}" in card


def test_the_graph_tells_a_scene_from_its_twin_and_the_object_list_does_not(
    made: Callable[[Kind], Path], homes: Path
) -> None:
    data = Dataset(homes)

    def stove(kind: Kind) -> set[tuple[bool, bool]]:
        found = detect(data, load_trained(made(kind)), twins=True)
        return {
            tuple(11 in {r.object_id for r in found[key]} for key in (item.id, f"{item.id}-twin"))
            for item in data
            if item.entry.anomalies  # the stove is on in each of them
        }  # type: ignore[return-value]

    assert stove("graph") == {(True, False)}
    assert stove("description") == {(True, False)}
    assert all(scene == twin for scene, twin in stove("objects") | stove("prior"))


@pytest.mark.parametrize("kind", KINDS)
def test_the_same_data_and_seed_make_the_same_detector(
    kind: Kind, made: Callable[[Kind], Path], homes: Path, tmp_path: Path
) -> None:
    first = made(kind)
    train(Lessons(Dataset(homes)), kind, tmp_path / kind)
    for name in ("model.json", "model.npz", "README.md"):
        assert (tmp_path / kind / name).read_bytes() == (first / name).read_bytes()


def test_a_threshold_of_ones_own_shows_all_scores(
    made: Callable[[Kind], Path], homes: Path
) -> None:
    data = Dataset(homes)
    item = data[3]
    every = load_trained(made("graph"), threshold=0.0)(data, item)
    assert [r.object_id for r in every] == [thing.id for thing in item.scene.objects]
    assert load_trained(made("graph"), threshold=1.0)(data, item) == ()
    with pytest.raises(UsageError, match="0 to 1"):
        load_trained(made("graph"), threshold=2.0)


@pytest.mark.parametrize("view", ["neutral", "perceived"])
def test_other_views_of_the_graph_are_read_as_they_are(
    view: Any, made: Callable[[Kind], Path], homes: Path
) -> None:
    for kind in ("graph", "prior"):
        found = detect(Dataset(homes, graph_view=view), load_trained(made(kind)))
        assert len(found) == 16


def test_categories_nobody_has_seen_are_scored_by_their_superclass(
    made: Callable[[Kind], Path], homes: Path
) -> None:
    data = Dataset(homes)
    trained = load_trained(made("prior"), threshold=0.0)
    item = data[3]
    graph = item.shown_graph
    strange = replace(item)
    object.__setattr__(
        strange,
        "shown_graph",
        graph.model_copy(
            update={
                "nodes": tuple(
                    n.model_copy(update={"class_name": "flux_capacitor", "category": "Unheard"})
                    if n.id == 11
                    else n
                    for n in graph.nodes
                )
            }
        ),
    )
    assert 11 in {r.object_id for r in trained(data, strange)}


# --- files of strangers --------------------------------------------------------------------------


def tampered(folder: Path, out: Path, change: Callable[[dict[str, np.ndarray]], None]) -> Path:
    """A copy whose arrays are changed, its digest with them."""
    out.mkdir()
    arrays = {k: v.copy() for k, v in arrays_from((folder / "model.npz").read_bytes(), "m").items()}
    change(arrays)
    packed = io.BytesIO()
    np.savez(packed, **arrays)  # type: ignore[arg-type]
    return signed(folder, out, packed.getvalue())


def signed(folder: Path, out: Path, data: bytes) -> Path:
    out.mkdir(exist_ok=True)
    (out / "model.npz").write_bytes(data)
    model = json.loads((folder / "model.json").read_text())
    model["arrays_sha256"] = hashlib.sha256(data).hexdigest()
    (out / "model.json").write_text(json.dumps(model))
    return out


def _circle(arrays: dict[str, np.ndarray]) -> None:
    inner = np.flatnonzero(arrays["finding.feature"] >= 0)[0]
    arrays["finding.left"][inner] = 0


def _beyond(arrays: dict[str, np.ndarray]) -> None:
    inner = np.flatnonzero(arrays["finding.feature"] >= 0)[0]
    arrays["finding.right"][inner] = 10**9


def _column(arrays: dict[str, np.ndarray]) -> None:
    arrays["finding.feature"][0] = 10**6


def _none(arrays: dict[str, np.ndarray]) -> None:
    arrays["rates.by_kind"][0] = np.nan


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (_circle, "leads astray"),
        (_beyond, "leads astray"),
        (_column, "a column that is not there"),
        (_none, "a number that is none"),
        (lambda arrays: arrays.pop("named"), "named"),
        (lambda arrays: arrays.update(columns=np.array([0, 0])), "columns"),
        (lambda arrays: arrays.update(x=np.array(["a"])), "no plain numbers"),
    ],
)
def test_arrays_that_lead_astray_are_one_clear_error(
    change: Any, words: str, made: Callable[[Kind], Path], tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=words) as caught:
        load_trained(tampered(made("graph"), tmp_path / "m", change))
    assert len(caught.value.problems) == 1


def test_nothing_that_is_pickled_is_opened(made: Callable[[Kind], Path], tmp_path: Path) -> None:
    packed = io.BytesIO()
    np.savez(packed, named=np.array([print], dtype=object))
    with pytest.raises(InputError, match="no plain numbers"):
        load_trained(signed(made("graph"), tmp_path / "m", packed.getvalue()))


def test_damaged_files_are_one_clear_error(made: Callable[[Kind], Path], tmp_path: Path) -> None:
    good = made("prior")
    data = (good / "model.npz").read_bytes()
    for k, bad in enumerate((b"", b"no zip", data[: len(data) // 2], data[:-30] + bytes(30))):
        with pytest.raises(InputError, match="no arrays of a detector"):
            load_trained(signed(good, tmp_path / str(k), bad))
    (tmp_path / "0" / "model.npz").write_bytes(data + b"x")
    with pytest.raises(InputError, match="changed since it was written"):
        load_trained(tmp_path / "0")
    with pytest.raises(InputError, match="no trained detector"):
        load_trained(tmp_path)
    with pytest.raises(InputError, match="no such folder"):
        load_trained(tmp_path / "nowhere")


def test_an_array_larger_than_its_file_is_refused_before_room_is_made(tmp_path: Path) -> None:
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        head, {"descr": "<f8", "fortran_order": False, "shape": (10**12,)}
    )
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as out:
        out.writestr("x.npy", head.getvalue() + bytes(64))
    with pytest.raises(InputError, match="another size"):
        arrays_from(packed.getvalue(), "model.npz")


def test_records_of_other_models_are_refused_with_the_key(
    made: Callable[[Kind], Path], tmp_path: Path
) -> None:
    signed(made("prior"), tmp_path, (made("prior") / "model.npz").read_bytes())
    model = json.loads((tmp_path / "model.json").read_text())
    (tmp_path / "model.json").write_text(json.dumps({**model, "kind": "oracle"}))
    with pytest.raises(InputError, match="kind"):
        load_trained(tmp_path)
    words = {**model["words"], "states": model["words"]["states"][:1] * 2}
    (tmp_path / "model.json").write_text(json.dumps({**model, "words": words}))
    with pytest.raises(InputError, match="states: a word appears twice"):
        load_trained(tmp_path)


# --- the command ---------------------------------------------------------------------------------


def test_the_command_trains_several_kinds(homes: Path, tmp_path: Path, capsys: Captured) -> None:
    out = tmp_path / "models"
    words = ["train", str(homes), "--kind", "prior", "--kind", "description", "-o", str(out)]
    assert run([*words, "--graph-view", "neutral", "--seed", "3", "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert [(one["kind"], one["out"]) for one in said] == [
        ("prior", str(out / "prior")),
        ("description", str(out / "description")),
    ]
    model = json.loads((out / "prior" / "model.json").read_text())
    assert (model["graph_view"], model["seed"]) == ("neutral", 3)
    assert isinstance(load_trained(out / "description"), Trained)
    assert run(words) == 1
    assert "is not empty" in capsys.readouterr().err


def test_without_scenes_to_train_on_it_says_so(tmp_path: Path, capsys: Captured) -> None:
    data = toy.build(tmp_path / "d", toy.small(n=1))
    manifest = (data / "manifest.jsonl").read_text().replace('"train"', '"test"')
    (data / "manifest.jsonl").write_text(manifest)
    assert run(["train", str(data), "--kind", "prior", "-o", str(tmp_path / "m")]) == 1
    assert "no scene of the split 'train'" in capsys.readouterr().err
    assert not (tmp_path / "m").exists()


def test_pictures_are_asked_for_before_the_work(tmp_path: Path, capsys: Captured) -> None:
    data = toy.build(tmp_path / "d", toy.small(n=4, sensors=("depth",)))
    assert run(["train", str(data), "--kind", "all", "-o", str(tmp_path / "m")]) == 1
    assert "no instance and no rgb" in capsys.readouterr().err


def test_a_missing_package_is_named_with_its_extra(
    homes: Path, tmp_path: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "sklearn", None)
    with pytest.raises(ModuleNotFoundError):
        __import__("sklearn")
    assert run(["train", str(homes), "--kind", "graph", "-o", str(tmp_path / "m")]) == 1
    assert "sklearn" in capsys.readouterr().err


def test_a_net_answers_for_a_crop_whatever_is_asked_beside_it() -> None:
    torch = pytest.importorskip("torch")
    rng = np.random.default_rng(0)
    weights = {k: torch.from_numpy(v) for k, v in cnn._start(3, rng).items()}
    pixels = torch.from_numpy(rng.random((5, 4, 64, 64), dtype=np.float32))
    place = torch.from_numpy(rng.random((5, 6), dtype=np.float32))
    both = cnn._forward(weights, pixels, place)
    alone = cnn._forward(weights, pixels[:1], place[:1])
    assert torch.allclose(both[:1], alone, atol=1e-5)


def test_more_trees_than_any_model_has_are_refused() -> None:
    trees = {
        "t.start": np.zeros(1),
        "t.roots": np.zeros((60_000, 1), dtype=np.int64),
        "t.feature": np.full(1, -1, dtype=np.int64),
        "t.threshold": np.zeros(1),
        "t.left": np.zeros(1, dtype=np.int64),
        "t.right": np.zeros(1, dtype=np.int64),
        "t.value": np.zeros(1),
    }
    with pytest.raises(ValueError, match="another size"):
        Boosted.from_arrays(trees, "t", 1, 2)
    Boosted.from_arrays({**trees, "t.roots": trees["t.roots"][:5]}, "t", 1, 2)


def test_a_foreign_folder_is_left_alone(homes: Path, tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(SdgenError, match="is not empty"):
        train(Lessons(Dataset(homes)), "prior", tmp_path)
    assert [p.name for p in tmp_path.iterdir()] == ["notes.txt"]


def test_blocks_of_columns_keep_states_from_those_who_see_none(homes: Path) -> None:
    layout = Layout.of(Dataset(homes))
    names = {k: name for name, k in layout.columns.items()}
    assert {names[k][0] for k in layout.columns_of(("kind", "room"))} == {"kind", "room"}
    assert sorted(layout.columns.values()) == list(range(len(layout.columns)))
