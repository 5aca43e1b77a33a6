"""predictions.jsonl: read strictly, every problem located, all at once."""

import contextlib
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sdgen.benchmark import detect, evaluate, read_leniently, read_predictions, write_predictions
from sdgen.dataset import Dataset
from sdgen.errors import SHOWN, InputError, SdgenError

from tests import toy
from tests.edits import reseal


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build(tmp_path_factory.mktemp("set") / "d"))


def test_written_predictions_read_back(data: Dataset, tmp_path: Path) -> None:
    told = detect(data, "rules")
    write_predictions(tmp_path / "new" / "p.jsonl", told)
    assert read_predictions(tmp_path / "new" / "p.jsonl", data) == told
    assert [p.name for p in (tmp_path / "new").iterdir()] == ["p.jsonl"]


def test_notify_is_now_when_left_out(data: Dataset, tmp_path: Path) -> None:
    path = tmp_path / "p.jsonl"
    path.write_text('{"scene": "000003", "reports": [{"object_id": 11, "label": "unsafe"}]}\n\n')
    assert read_predictions(path, data)["000003"][0].notify == "now"


def _line(reports: str, scene: str = "000003") -> str:
    return f'{{"scene": "{scene}", "reports": [{reports}]}}'


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("not json", ":1: not JSON"),
        (_line("") + "\n" + _line(""), ":2: scene: '000003' is on line 1 already"),
        (_line("", "000009"), ":1: scene: no scene '000009' (did you mean"),
        (
            _line('{"object_id": 12, "label": "unsafe"}'),
            ":1: reports[0].object_id: scene",
        ),
        (
            _line('{"object_id": 11, "label": "unsafe"}, {"object_id": 11, "label": "unsafe"}'),
            ":1: reports[1].object_id: object 11 appears twice",
        ),
        (
            _line('{"object_id": 11, "label": "danger"}'),
            ":1: reports[0].label: 'danger' is not one of",
        ),
        (
            _line('{"object_id": 11, "label": "unsafe", "notify": "later"}'),
            ":1: reports[0].notify: 'later' is not one of now, summary, silent",
        ),
        (
            _line('{"object_id": "11", "label": "unsafe"}'),
            ":1: reports[0].object_id: expected a whole number, got",
        ),
        (
            _line('{"object_id": 11.0, "label": "unsafe"}'),
            ":1: reports[0].object_id: expected a whole number, got",
        ),
        (
            _line('{"object_id": true, "label": "unsafe"}'),
            ":1: reports[0].object_id: expected a whole number, got",
        ),
        (_line('{"object_id": 11}'), ":1: reports[0]: missing key 'label'"),
        (_line('{"object_id": 11, "label": "unsafe", "x": 1}'), ":1: reports[0].x: unknown key"),
        ('{"scene": "000003", "report": []}', ":1: report: unknown key (did you mean 'reports'?)"),
        ("[]", ":1: expected a mapping"),
    ],
)
def test_bad_predictions_are_located(
    data: Dataset, tmp_path: Path, text: str, expected: str
) -> None:
    path = tmp_path / "p.jsonl"
    path.write_text(text + "\n", encoding="utf-8")
    with pytest.raises(InputError) as caught:
        read_predictions(path, data)
    assert any(p.startswith(f"{path}{expected}") for p in caught.value.problems), str(caught.value)


def test_all_problems_are_told_at_once(data: Dataset, tmp_path: Path) -> None:
    path = tmp_path / "p.jsonl"
    path.write_text("x\n" + _line("", "000009") + "\n" + _line('{"object_id": 1}') + "\n")
    with pytest.raises(InputError) as caught:
        read_predictions(path, data)
    assert [p.split(":")[1] for p in caught.value.problems] == ["1", "2", "3"]


def test_a_missing_file_is_an_input_error(data: Dataset, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        read_predictions(tmp_path / "none.jsonl", data)
    with pytest.raises(InputError, match="is a folder, not a file"):
        read_predictions(tmp_path, data)


@given(st.binary(max_size=80))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_no_bytes_raise_anything_else(data: Dataset, tmp_path: Path, junk: bytes) -> None:
    (tmp_path / "p.jsonl").write_bytes(junk)
    with contextlib.suppress(InputError):
        read_predictions(tmp_path / "p.jsonl", data)


@pytest.mark.parametrize("name", ["manifest.jsonl", "scenes/000000/scene.json", "scenes/p.jsonl"])
def test_predictions_never_overwrite_the_data_set(data: Dataset, name: str) -> None:
    with pytest.raises(SdgenError, match="belongs to the data set"):
        write_predictions(data.path / name, {})
    assert len(Dataset(data.path)) == 4


@pytest.mark.parametrize(
    "line",
    [
        "x",
        '{"scene": "009999", "reports": []}',
        _line(", ".join('{"object_id": 12, "label": "unsafe"}' for _ in range(300))),
        _line(", ".join(f'{{"object_id": {k}, "label": "un"}}' for k in range(300))),
    ],
)
def test_problems_of_a_long_file_are_bounded(data: Dataset, tmp_path: Path, line: str) -> None:
    path = tmp_path / "p.jsonl"
    path.write_text(f"{line}\n" * 500)
    with pytest.raises(InputError) as caught:
        read_predictions(path, data)
    assert SHOWN <= len(caught.value.problems) <= 2 * SHOWN + 1


def test_what_is_bad_is_skipped_and_counted_where_that_is_asked_for(
    data: Dataset, tmp_path: Path
) -> None:
    path = tmp_path / "p.jsonl"
    sound = '{"object_id": 11, "label": "unsafe", "score": 0.5}'
    lines = [
        "no json",
        "[]",
        '{"scene": 3, "reports": []}',
        '{"scene": "000003"}',
        _line(sound, "000009"),
        _line(
            f'{sound}, {sound}, {{"object_id": 305, "label": "danger"}}, "knife", null, '
            '{"object_id": 12, "label": "unsafe"}, {"object_id": -1, "label": "unsafe"}'
        ),
        _line(sound),
        _line(sound, "000001"),
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    found = read_leniently(path, data)
    assert dict(found.counts) == {
        "broken_lines": 4,
        "unknown_scenes": 1,
        "repeated_scenes": 1,
        "bad_reports": 3,
        "repeated_objects": 1,
        "unknown_objects": 2,
    }
    assert {key: [r.object_id for r in one] for key, one in found.predictions.items()} == {
        "000003": [11, 12, -1],
        "000001": [11],
    }
    assert evaluate(data, found.predictions).false_alarms_per_scene.mean == 2 / len(data)
    notes = list(found.notes())
    assert notes[0] == "4 lines that are no predictions were skipped"
    assert notes[1] == "1 line of an unknown scene was skipped"
    assert notes[-1] == "2 reports of objects that do not exist count as false alarms"
    strict = detect(data, "rules")
    write_predictions(tmp_path / "s.jsonl", strict)
    assert read_leniently(tmp_path / "s.jsonl", data).predictions == strict
    assert not list(read_leniently(tmp_path / "s.jsonl", data).notes())


@given(st.binary(max_size=80))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_no_bytes_stop_a_lenient_reader(data: Dataset, tmp_path: Path, junk: bytes) -> None:
    (tmp_path / "p.jsonl").write_bytes(junk)
    assert not read_leniently(tmp_path / "p.jsonl", data).predictions


def test_ids_are_known_however_a_scene_is_laid_out(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2, sensors=()))
    scene = path / "scenes" / "000001" / "scene.json"
    scene.write_text(scene.read_text(encoding="utf-8").replace('"id": ', '"id" :  '))
    reseal(path)
    data = Dataset(path)
    told = detect(data, "always")
    write_predictions(tmp_path / "p.jsonl", told)
    assert read_predictions(tmp_path / "p.jsonl", data) == told
