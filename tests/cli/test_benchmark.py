"""sdgen benchmark, as a user runs it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from sdgen.cli.main import run

from tests import toy

Captured = pytest.CaptureFixture[str]


@pytest.mark.slow
def test_a_test_set_is_sealed_opened_and_refused_when_changed(
    tmp_path: Path, capsys: Captured
) -> None:
    secret, sealed, seal = (tmp_path / name for name in ("secret.json", "sealed", "seal.json"))
    options = ["--n", "1", "--views", "1", "--size", "64x48", "--hazards", "1-1", "--quiet"]
    words = ["benchmark", "seal", "--seed-file", str(secret), "--dataset", str(sealed)]
    assert run([*words, "-o", str(seal), "--", *options]) == 0
    told = capsys.readouterr()
    seed = str(json.loads(secret.read_text())["seed"])
    assert seed not in told.out + told.err + seal.read_text()
    digest = told.out.split("digest ")[1].split()[0]

    opened = tmp_path / "opened"
    words = ["benchmark", "open", str(seal), "--seed-file", str(secret), "--dataset", str(opened)]
    assert run([*words, "--digest", digest]) == 0
    told = capsys.readouterr()
    assert f"seed {seed}: 1 scenes are what was sealed, every byte" in told.out

    picture = opened / "scenes/000000/views/00/rgb.png"
    picture.write_bytes(picture.read_bytes() + b"x")
    assert run(words) == 1
    assert "scenes/000000/views/00/rgb.png: changed" in capsys.readouterr().err
    assert run([*words, "--digest", "0" * 64]) == 1
    assert "not the one published" in capsys.readouterr().err


@pytest.mark.parametrize("word", ["--seed=7", "--out", "--range", "--homes=mine.yaml"])
def test_what_the_secret_says_is_not_said_again(
    tmp_path: Path, capsys: Captured, word: str
) -> None:
    words = ["--seed-file", str(tmp_path / "s"), "--dataset", str(tmp_path / "d")]
    assert run(["benchmark", "seal", *words, "-o", str(tmp_path / "o"), "--", word]) == 2
    assert word in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_the_tables_are_printed_written_and_told_to_programs(
    tmp_path: Path, capsys: Captured
) -> None:
    pytest.importorskip("sklearn")
    homes = toy.build(tmp_path / "homes", toy.small(n=12, twins=True))
    prior = tmp_path / "models" / "prior"
    assert run(["train", str(homes), "--kind", "prior", "-o", str(prior)]) == 0
    mine = tmp_path / "r" / "mine.jsonl"
    assert run(["detect", str(homes), "--method", "rules", "-o", str(mine)]) == 0
    capsys.readouterr()
    words = ["benchmark", str(homes), "--split", "all", "--trained", str(prior.parent)]
    words += ["--runs", str(mine.parent)]
    assert run(words) == 0
    page = capsys.readouterr().out
    for row in ("| rules | full |", "| prior | full |", "| prior | perceived |", "| mine | full |"):
        assert f"\n{row}" in page
    assert run([*words, "-o", str(tmp_path / "board.md")]) == 0
    assert (tmp_path / "board.md").read_text(encoding="utf-8") == page
    capsys.readouterr()
    assert run([*words, "--graph-view", "full", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [row["detector"] for row in told["rows"]] == [
        *("rules", "never", "always", "chance", "prior"),
        "mine",
    ]
    assert told["base_rate"] == 0.05


def test_a_split_without_scenes_is_named(tmp_path: Path, capsys: Captured) -> None:
    homes = toy.build(tmp_path / "homes", toy.small(n=1))
    assert run(["benchmark", str(homes)]) == 2
    assert "no scene of the split 'test'; say --split all" in capsys.readouterr().err


def test_without_pictures_only_the_full_graph_is_scored(tmp_path: Path, capsys: Captured) -> None:
    homes = toy.build(tmp_path / "homes", toy.small(n=6, sensors=()))
    assert run(["benchmark", str(homes), "--split", "all"]) == 0
    told = capsys.readouterr()
    assert "there is no perceived graph to score" in told.err
    assert "What perception costs" not in told.out
