"""predictions.jsonl: read strictly, every problem located, all at once."""

import contextlib
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sdgen.benchmark import detect, read_predictions, write_predictions
from sdgen.dataset import Dataset
from sdgen.errors import InputError, SdgenError

from tests import toy


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
