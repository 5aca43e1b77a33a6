"""The leaderboard: the paper's rows beside ours, rows that need no key, what perception costs."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.benchmark import detect, prediction_bytes
from sdgen.benchmark.leaderboard import board, drops, markdown, methods_beside, models_beside
from sdgen.benchmark.paper import METHODS, MODELS
from sdgen.benchmark.rows import Row, offline_rows, pictured, rows_of_runs, trained_in
from sdgen.dataset import Dataset
from sdgen.dataset.text import record_bytes
from sdgen.detectors.account import Settings, account_of
from sdgen.errors import InputError

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=8, twins=True))


@pytest.fixture(scope="module")
def rows(path: Path) -> list[Row]:
    views = [Dataset(path, graph_view=view) for view in ("full", "perceived")]  # type: ignore[arg-type]
    return [row for data in views for row in offline_rows(data, {}, 0.05)]


def settings(**more: object) -> Settings:
    said = {
        "method": "cot-sg-c",
        "title": "CoT + SG & C",
        "reconstruction": False,
        "model": "openai/gpt-4-0613",
        "household": "filter",
        "graph_view": "full",
        "prompt_sha256": "0" * 64,
    }
    return Settings.model_validate(said | more)


def test_rows_without_a_key_are_those_of_the_data_set(path: Path, rows: list[Row]) -> None:
    by_name = {row.detector: row for row in rows if row.graph_view == "full"}
    assert list(by_name) == ["rules", "never", "always", "chance"]
    assert by_name["rules"].evaluation.AS.mean == by_name["rules"].evaluation.CAS.mean == 1
    assert by_name["never"].evaluation.AS.mean == 0
    rates = by_name["always"].base_rates
    assert rates is not None
    assert rates.hazard_share == 0.05
    assert rates.cost_per_home_day["never"].mean is not None


def test_what_perception_costs_is_of_the_same_detectors(rows: list[Row]) -> None:
    found = drops(rows)
    assert [drop.title for drop in found] == ["rules", "never", "always", "chance"]
    assert found[0].full.AS.mean == 1
    assert found[0].perceived.AS.mean is not None
    assert drops([row for row in rows if row.graph_view == "full"]) == []


def test_the_papers_tables_stand_whole_without_rows_of_ours(rows: list[Row]) -> None:
    assert [(b.paper, b.row) for b in methods_beside(rows)] == [(p, None) for p in METHODS.values()]
    assert [b.paper for b in models_beside(rows)] == list(MODELS.values())


def test_runs_of_language_models_stand_beside_the_papers(path: Path, tmp_path: Path) -> None:
    data = Dataset(path)
    found = prediction_bytes(detect(data, "rules"))
    for name, said in {
        "cot": settings(),
        "cot-3": settings(model="gpt-4o"),
        "list": settings(method="object-list", title="Object List + E, C", household="prompt"),
    }.items():
        (tmp_path / f"{name}.jsonl").write_bytes(found)
        account = record_bytes(account_of(said, (), predictions=found))
        (tmp_path / f"{name}.jsonl.account.json").write_bytes(account)
    (tmp_path / "mine.jsonl").write_bytes(found)
    ours = rows_of_runs(data, tmp_path, 0.05)
    assert sorted((row.detector, row.model or "") for row in ours) == [
        ("cot-sg-c", "gpt-4o"),
        ("cot-sg-c", "openai/gpt-4-0613"),
        ("mine", ""),
        ("object-list", "openai/gpt-4-0613"),
    ]
    by_title = {b.paper.title: b.row for b in models_beside(ours)}
    # gpt-4o is another model than gpt-4, of which gpt-4-0613 is one.
    assert by_title["GPT-4"] is not None
    assert by_title["GPT-4"].model == "openai/gpt-4-0613"
    assert by_title["gpt-4o"] is not None
    table = {b.paper.title: b.row for b in methods_beside(ours)}
    listed = table["Object List + E, C"]
    assert listed is not None
    assert listed.household == "prompt"
    assert table["SG, no C"] is None


def test_an_account_of_other_predictions_is_refused(path: Path, tmp_path: Path) -> None:
    data = Dataset(path)
    mine = tmp_path / "mine.jsonl"
    mine.write_bytes(prediction_bytes(detect(data, "rules")))
    beside = tmp_path / "mine.jsonl.account.json"
    for said in (None, b"other"):
        beside.write_bytes(record_bytes(account_of(settings(), (), predictions=said)))
        with pytest.raises(InputError, match="the account of other predictions than mine"):
            rows_of_runs(data, tmp_path, 0.05)
    beside.unlink()
    beside.symlink_to(tmp_path / "nowhere")
    with pytest.raises(InputError, match="account"):
        rows_of_runs(data, tmp_path, 0.05)
    beside.unlink()
    mine.write_bytes(b"")
    (row,) = rows_of_runs(data, tmp_path, 0.05)
    assert "no line for 8 of 8 scenes" in row.note


def test_the_page_has_every_row_and_no_strangers_markup(path: Path, rows: list[Row]) -> None:
    data = Dataset(path)
    strange = rows[0].model_copy(update={"detector": "a|b<script>\n# x"})
    text = markdown(board(data, [*rows, strange], 0.05))
    assert text.count("\n| rules | full |") == 2
    assert "| 96.0 | 90.5 | – |" in text
    assert "<script>" not in text
    assert "a\\|b&lt;script>" in text
    assert "sdgen build --n 8 --seed 7" in text
    width = 0
    for line in text.splitlines():
        cells = line.count("|") - line.count("\\|")
        if not line.startswith("|"):
            width = 0
        elif width:
            assert cells == width, line
        else:
            width = cells


def test_folders_without_models_or_runs_are_refused(path: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no model of 'sdgen train'"):
        trained_in([tmp_path])
    with pytest.raises(InputError, match="no predictions"):
        rows_of_runs(Dataset(path), tmp_path, 0.05)


def test_a_graph_is_perceived_only_with_depth_and_masks(path: Path, tmp_path: Path) -> None:
    assert pictured(Dataset(path))
    assert not pictured(Dataset(toy.build(tmp_path / "e", toy.small(n=1, sensors=("rgb",)))))
