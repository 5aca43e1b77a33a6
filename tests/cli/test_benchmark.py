"""sdgen benchmark, as a user runs it."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from sdgen.benchmark.seal import LEAST_SEED
from sdgen.cli.main import run

from tests import toy

SEED = LEAST_SEED + 1234567
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
    for row in (
        "| rules | full |",
        "| prior | full |",
        "| prior | perceived |",
        "| mine | not said |",
    ):
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


def test_runs_are_not_written_over_and_want_no_clean_homes(
    tmp_path: Path, capsys: Captured
) -> None:
    homes = toy.build_with_twins(tmp_path / "homes", n=3)
    mine = tmp_path / "r" / "mine.jsonl"
    assert run(["detect", str(homes), "--method", "rules", "-o", str(mine)]) == 0
    before = mine.read_bytes()
    words = ["benchmark", str(homes), "--split", "test", "--runs", str(mine.parent)]
    words += ["--graph-view", "full"]
    assert run([*words, "-o", str(mine)]) == 1
    assert "choose another place" in capsys.readouterr().err
    assert mine.read_bytes() == before
    assert run([*words, "-o", str(mine.parent / "board.md")]) == 1
    assert "choose another place" in capsys.readouterr().err
    assert run([*words, "--runs", str(mine.parent), "--graph-view", "full"]) == 0
    page = capsys.readouterr().out
    assert "mine (not said): base rates need homes with and without hazards" in page
    assert page.count("\n| mine |") == 1
    assert page.count("\n| rules |") == 2


def test_two_models_of_one_name_are_refused_and_views_tell_them_apart(
    tmp_path: Path, capsys: Captured
) -> None:
    homes = toy.build(tmp_path / "homes", toy.small(n=12, twins=True))
    for place, view in (("a", "full"), ("b", "full"), ("c", "neutral")):
        words = ["train", str(homes), "--kind", "prior", "--graph-view", view]
        assert run([*words, "-o", str(tmp_path / place)]) == 0
    words = ["benchmark", str(homes), "--split", "all", "--graph-view", "neutral"]
    words += ["--trained", str(tmp_path / "a")]
    capsys.readouterr()
    assert run([*words, "--trained", str(tmp_path / "b")]) == 2
    assert f"{tmp_path / 'b'}: a second model 'prior'" in capsys.readouterr().err
    assert run([*words, "--trained", str(tmp_path / "c")]) == 0
    page = capsys.readouterr().out
    assert "\n| prior | neutral |" in page
    assert "\n| prior (of neutral graphs) | neutral |" in page


def test_a_trained_row_scores_as_its_predictions_do(tmp_path: Path, capsys: Captured) -> None:
    homes = toy.build(tmp_path / "homes", toy.small(n=12, twins=True))
    model, said = tmp_path / "prior", tmp_path / "p.jsonl"
    assert run(["train", str(homes), "--kind", "prior", "-o", str(model)]) == 0
    words = ["detect", str(homes), "--trained", str(model), "--twins", "-o", str(said)]
    assert run(words) == 0
    every, none = tmp_path / "every.jsonl", tmp_path / "none.jsonl"
    for place, least in ((every, "0"), (none, "1")):
        assert run([*words[:-2], "--threshold", least, "-o", str(place)]) == 0
    assert len(every.read_bytes()) > len(said.read_bytes()) > len(none.read_bytes())
    capsys.readouterr()
    assert run(["evaluate", str(homes), str(said), "--json"]) == 0
    alone = json.loads(capsys.readouterr().out)
    words = ["benchmark", str(homes), "--split", "all", "--trained", str(model), "--json"]
    assert run([*words, "--graph-view", "full"]) == 0
    row = json.loads(capsys.readouterr().out)["rows"][-1]
    assert row["detector"] == "prior"
    assert {key: row["evaluation"][key] for key in alone} == alone
    # Its curve goes on where it says nothing any more: to all that there is to find.
    assert row["base_rates"]["curve"][-1]["recall"] == 1


def test_a_secret_is_neither_written_over_nor_made_in_vain(
    tmp_path: Path, capsys: Captured
) -> None:
    secret, sealed = tmp_path / "s.json", tmp_path / "d"
    words = ["benchmark", "seal", "--seed-file", str(secret), "--dataset", str(sealed)]
    seal = str(tmp_path / "seal.json")
    for more, told in (
        (["-o", str(secret), "--", "--n", "1"], "choose another place"),
        (["-o", str(sealed / "seal.json"), "--", "--n", "1"], "choose another place"),
        (["-o", seal, "--", "--width", "64"], "--width"),
        (["-o", seal, "--", "--n", "0"], "a test of no scenes"),
    ):
        assert run([*words, *more]) in (1, 2)
        assert told in capsys.readouterr().err
    # A build that was not begun leaves no secret, one of another seed tells none.
    assert run([*words, "-o", seal, "--", "--n", "1", "--only", "nothing"]) != 0
    assert not secret.exists()
    other = toy.build(tmp_path / "mine", toy.small(n=1, seed=SEED))
    words[-1] = str(other)
    assert run([*words, "-o", seal, "--", "--n", "1"]) == 1
    assert f"{secret} is not there" in capsys.readouterr().err
    secret.write_text(json.dumps({"seed": SEED + 1, "nonce": "0" * 64}))
    assert run([*words, "-o", seal, "--", "--n", "1"]) != 0
    told = capsys.readouterr()
    assert str(SEED) not in told.err + told.out
    assert str(SEED + 1) not in told.err + told.out
    secret.unlink()
    shutil.rmtree(other)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "notes.txt").write_text("x")
    words[-1] = str(tmp_path / "mine")
    assert run([*words, "-o", seal, "--", "--n", "1"]) == 1
    assert "no data set" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["mine"]


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
