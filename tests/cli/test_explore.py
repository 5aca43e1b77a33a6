"""``sdgen explore``: walks by script and by explorers, what they write, and clear errors."""

from __future__ import annotations

import contextlib
import json
import os
import pty
import subprocess
import sys
import time
from pathlib import Path

import pytest
from PIL import Image
from sdgen.cli.main import run

from tests.agent import homes

SAMPLE = str(homes.SAMPLE)
SMALL = ("--size", "48x32", "--quiet")


def explore(*words: object) -> int:
    return run(["explore", *map(str, words)])


def test_a_script_is_walked_filmed_and_scored(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    walk, plan = tmp_path / "walk", tmp_path / "plan.png"
    moves = "forward 2, turn_left 2, go_to 65000, scan, stop"
    code = explore(SAMPLE, 0, "--do", moves, "-o", walk, "--plan", plan, "--json", *SMALL)
    assert code == 0
    score = json.loads(capsys.readouterr().out)
    assert score["scene"] == "000000"
    assert score["refused"] == 1
    assert score["steps"] == 2 + 2 + 1 + 12 + 1
    assert score["shortest_m"] is None or score["shortest_m"] >= 0.0
    lines = [json.loads(line) for line in (walk / "trajectory.jsonl").read_text().splitlines()]
    assert [line["action"] for line in lines] == [
        "start", "forward", "forward", "turn_left", "turn_left", "go_to", *["scan"] * 12, "stop",
    ]  # fmt: skip
    summary = json.loads((walk / "episode.json").read_text())["summary"]
    assert summary == {**score, "reports": []}
    assert [line["steps"] for line in lines][-3:] == [16, 17, 18]
    with Image.open(walk / "video.gif") as film, Image.open(plan) as drawn:
        assert film.n_frames == len(lines)
        assert min(drawn.size) > 200


def test_a_script_is_read_from_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    script = tmp_path / "moves.txt"
    script.write_text("turn_left 3\nstop\n")
    assert explore(SAMPLE, "000001", "--do", f"@{script}", *SMALL) == 0
    assert "4 steps" in capsys.readouterr().out


def test_an_explorer_looks_and_a_detector_says(capsys: pytest.CaptureFixture[str]) -> None:
    code = explore(SAMPLE, 1, "--explorer", "planner", "--size", "96x96", "--json", "--quiet")
    assert code == 0
    score = json.loads(capsys.readouterr().out)
    assert score["shown"] == score["observable"]
    assert score["false_alarms"] == 0.0


@pytest.mark.slow
def test_without_a_scene_explorers_are_compared(capsys: pytest.CaptureFixture[str]) -> None:
    words = (SAMPLE, "--explorer", "random", "--max-steps", 20, "--limit", 2, *SMALL)
    assert explore(*words) == 0
    told = capsys.readouterr().out
    assert "random" in told
    assert "(all of it)" in told
    assert explore(*words, "--json") == 0
    rows = json.loads(capsys.readouterr().out)
    assert [row["homes"] for row in rows] == [2, 2, 2]


@pytest.mark.parametrize(
    ("words", "why"),
    [
        ((SAMPLE, 0, "--do", "fly"), "--do:1: no move 'fly'"),
        ((SAMPLE, 0, "--do", "@nowhere.txt"), "nowhere.txt"),
        ((SAMPLE, 7, "--do", "stop"), "000007"),
        ((SAMPLE, 0), "no terminal"),
        ((SAMPLE, 0, "--do", "stop", "--explorer", "rooms"), "name one of them"),
        ((SAMPLE, 0, "--explorer", "rooms", "--explorer", "random"), "one, for one scene"),
        ((SAMPLE, 0, "--do", "stop", "--method", "rules"), "go with --explorer"),
        ((SAMPLE, 0, "--do", "stop", "--plan", "plan.jpg"), ".png"),
        ((SAMPLE, 0, "--do", "stop", "--limit", 3), "--limit"),
        ((SAMPLE, "--do", "stop"), "--do goes with a SCENE"),
        ((SAMPLE, "-o", "walk"), "--out goes with a SCENE"),
        ((SAMPLE + "/scenes", 0, "--do", "stop"), "dataset.json"),
    ],
)
def test_what_makes_no_sense_is_told_in_a_line(
    words: tuple[object, ...],
    why: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert explore(*words) in (1, 2)
    told = capsys.readouterr()
    assert why in told.err
    assert "Traceback" not in told.err
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_there_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "walk").mkdir()
    (tmp_path / "walk" / "mine.txt").write_text("mine")
    assert explore(SAMPLE, 0, "--do", "stop", "-o", tmp_path / "walk", *SMALL) == 1
    assert [path.name for path in (tmp_path / "walk").iterdir()] == ["mine.txt"]


@pytest.mark.slow
def test_keys_walk_in_a_terminal() -> None:
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "sdgen", "explore", SAMPLE, "0", "--size", "48x32"]
    child = subprocess.Popen(command, stdin=theirs, stdout=theirs, stderr=theirs, close_fds=True)
    os.close(theirs)
    told = b""
    todo = [(b"x stop", key) for key in (b"w", b"a", b"d", b"?", b"g")]
    todo += [(b"none): ", b"65000\r"), (b"65000\r\n", b""), (b"object 65000", b"x")]
    at = 0
    with contextlib.suppress(OSError):  # its end of the terminal is closed
        while piece := os.read(ours, 65536):
            told += piece
            while todo and (found := told.find(todo[0][0], at)) >= 0:
                at = found + len(todo[0][0])
                time.sleep(0.1)  # until it waits for a key: what comes before is thrown away
                os.write(ours, todo.pop(0)[1])
    assert child.wait(60) == 0
    text = told.decode("utf-8", "replace")
    assert "refused: there is no room or object 65000" in text
    assert "w forward" in text
    assert "5 steps" in text
