"""Questions for language models: true, balanced, and asked by the harnesses themselves."""

import base64
import importlib.util
import io
import json
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from PIL import Image
from sdgen.dataset import Dataset
from sdgen.export import export
from sdgen.export.question_files import framed
from sdgen.export.questions import NOTHING, NOTIFY

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("toy") / "d", n=8)


@pytest.fixture(scope="module")
def folder(path: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("q") / "q"
    export(Dataset(path), "questions", out)
    return out


def rows(folder: Path) -> list[dict[str, Any]]:
    lines = (folder / "questions.jsonl").read_text(encoding="utf-8").splitlines()
    return [json.loads(line) for line in lines]


def test_every_answer_is_true(path: Path, folder: Path) -> None:
    data = Dataset(path)
    titles = {hazard.id: hazard.title for hazard in data.catalog.hazards}
    asked = rows(folder)
    assert {row["kind"] for row in asked} >= {"anomaly", "twin", "notify"}
    for row in asked:
        item = data.scene(row["scene"])
        said = row["options"]["ABCD".index(row["answer"])]
        wrong = {a.object_id: a for a in item.anomalies.anomalies if a.hazard == row["hazard"]}
        if row["kind"] == "anomaly":
            assert said == titles[wrong[row["object_id"]].hazard]
        elif row["kind"] == "notify":
            assert said == NOTIFY[wrong[row["object_id"]].notify]
        else:
            assert said == NOTHING
            assert row["object_id"] not in wrong
        assert len(set(row["options"])) == len(row["options"])
        assert row["split"] == item.entry.split


def test_something_is_wrong_as_often_as_nothing_is(folder: Path) -> None:
    kinds = Counter(row["kind"] for row in rows(folder))
    assert kinds["anomaly"] == kinds["twin"] + kinds["lookalike"] > 0
    pairs = Counter(row["twin"] for row in rows(folder) if row["twin"])
    assert set(pairs.values()) == {2}


def test_boxes_are_the_views_own_and_frames_hide_nothing(path: Path, folder: Path) -> None:
    for row in rows(folder):
        if row["kind"] != "twin":
            item = Dataset(path).scene(row["scene"])
            seen = item.visibility.views[row["view"]].objects
            assert row["box"] in [list(o.bbox) for o in seen if o.object_id == row["object_id"]]
        picture = Image.open(folder / row["image"])
        assert picture.size == (160, 120)
    rgb = np.full((40, 50, 3), 9, dtype=np.uint8)
    drawn = framed(rgb, (10, 12, 8, 6))
    assert np.array_equal(drawn[12:18, 10:18], rgb[12:18, 10:18])
    assert (drawn[12 - 3, 10:18] == (255, 0, 0)).all()
    framed(rgb, (0, 0, 50, 40))  # no room for a frame


def test_the_table_is_read_as_vlmevalkit_does(folder: Path) -> None:
    """``load`` of ``vlmeval/smp/file.py``, and the columns that ``ImageMCQDataset`` asks for."""
    pandas = pytest.importorskip("pandas")
    table = pandas.read_csv(folder / "sdgen_questions.tsv", sep="\t")
    asked = rows(folder)
    assert {"index", "image", "question", "A", "B", "C", "D", "answer", "category"} <= set(table)
    assert list(table["index"]) == list(range(len(asked)))
    for row, (_, line) in zip(asked, table.iterrows(), strict=True):
        picture = Image.open(io.BytesIO(base64.b64decode(line["image"])))
        assert np.array_equal(np.asarray(picture), np.asarray(Image.open(folder / row["image"])))
        options = [line[letter] for letter in "ABCD" if not pandas.isna(line[letter])]
        assert options == row["options"]
        assert (line["answer"], line["category"]) == (row["answer"], row["kind"])


def test_inspect_runs_the_task(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    inspect_ai = pytest.importorskip("inspect_ai")
    from inspect_ai.model import ModelOutput, ModelUsage, get_model

    monkeypatch.chdir(folder)
    asked = rows(folder)

    def reply(text: str) -> ModelOutput:
        output = ModelOutput.from_content("mockllm/model", f"ANSWER: {text}")
        output.usage = ModelUsage(total_tokens=1)  # or it would download a tokeniser
        return output

    # A model that knows all answers but of twins: no pair is right, then.
    replies = [reply(row["answer"] if row["kind"] != "twin" else "E") for row in asked]
    (log,) = inspect_ai.eval(
        "inspect_task.py",
        model=get_model("mockllm/model", custom_outputs=replies),
        log_dir=str(tmp_path / "logs"),
        display="none",
        max_samples=1,
        max_connections=1,
    )
    assert log.status == "success"
    scores = {name: m.value for score in log.results.scores for name, m in score.metrics.items()}
    right = sum(row["kind"] != "twin" for row in asked) / len(asked)
    assert scores["accuracy"] == pytest.approx(right)
    assert (scores["anomaly"], scores["twin"], scores["pairs_right"]) == (1.0, 0.0, 0.0)
    assert any("image" in str(part) for part in log.samples[0].input[0].content)


def lmms_task(folder: Path) -> dict[str, Any]:
    """The YAML as lmms-eval loads it: ``!function module.name`` is imported from beside it."""
    place = folder / "lmms_eval"

    class Loader(yaml.SafeLoader):
        pass

    def function(loader: Any, node: Any) -> Any:
        module, name = loader.construct_scalar(node).split(".")
        spec = importlib.util.spec_from_file_location(module, place / f"{module}.py")
        assert spec is not None
        assert spec.loader is not None
        made = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(made)
        return getattr(made, name)

    Loader.add_constructor("!function", function)
    text = (place / "sdgen_questions.yaml").read_text(encoding="utf-8")
    task: dict[str, Any] = yaml.load(text, Loader=Loader)  # noqa: S506
    return task


def test_lmms_eval_gets_what_it_asks_for(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    datasets = pytest.importorskip("datasets")
    monkeypatch.chdir(folder)
    task = lmms_task(folder)
    loaded = datasets.load_dataset(
        task["dataset_path"], cache_dir=str(tmp_path), **task["dataset_kwargs"]
    )[task["test_split"]]
    assert len(loaded) == len(rows(folder))
    results: dict[str, list[Any]] = {"accuracy": [], "pairs_right": []}
    for doc in loaded:
        (picture,) = task["doc_to_visual"](doc)
        assert picture.mode == "RGB"
        extra = task["lmms_eval_specific_kwargs"]["default"]
        text = task["doc_to_text"](doc, extra)
        assert doc["question"] in text
        assert text.index("A. ") < text.index("B. ") < text.index(extra["post_prompt"])
        answer = task["doc_to_target"](doc)
        for name, said in task["process_results"](doc, [f"The answer is {answer}."]).items():
            results[name].append(said)
    metrics = {one["metric"]: one["aggregation"] for one in task["metric_list"]}
    assert {name: metrics[name](results[name]) for name in metrics} == {
        "accuracy": 1.0,
        "pairs_right": 1.0,
    }
    wrong = task["process_results"](loaded[0], ["I do not know"])
    assert not wrong["accuracy"]["right"]


def test_without_twins_near_misses_are_asked(tmp_path: Path) -> None:
    made = toy.build(tmp_path / "d", toy.small(n=8))
    export(Dataset(made), "questions", tmp_path / "q")
    kinds = Counter(row["kind"] for row in rows(tmp_path / "q"))
    assert kinds["twin"] == 0
    assert kinds["lookalike"] == kinds["anomaly"]


def test_nothing_of_sdgen_is_needed_to_run_them(folder: Path) -> None:
    for name in ("inspect_task.py", "lmms_eval/utils.py"):
        assert "import sdgen" not in (folder / name).read_text(encoding="utf-8")
    assert "sdgen_questions" not in sys.modules
