"""sdgen benchmark, as a user runs it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from sdgen.cli.main import run

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
