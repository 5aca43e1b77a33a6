"""Data sets that are not what they say, and readers that leave: one clear end each, and soon."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from sdgen.cli.main import run
from sdgen.errors import SHOWN
from sdgen.rejection import Cause

from tests import toy
from tests.edits import reseal

Captured = pytest.CaptureFixture[str]

COMMANDS: dict[str, list[str]] = {
    "stats": [],
    "view": ["-o", "OUT/page"],
    "detect": ["--method", "never", "-o", "OUT/p.jsonl"],
    "export": ["-o", "OUT/a.tar"],
    "evaluate": ["OUT/none.jsonl"],
}


@contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """What waits for ever fails instead."""

    def late(*_: object) -> None:
        pytest.fail(f"took more than {seconds} s")

    before = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def _call(command: str, path: Path, out: Path) -> int:
    (out / "none.jsonl").write_text("")
    return run([command, str(path), *(word.replace("OUT", str(out)) for word in COMMANDS[command])])


def _edit(path: Path, change: Callable[[Any], None]) -> None:
    data = json.loads(path.read_text(encoding="utf-8"))
    change(data)
    path.write_text(json.dumps(data), encoding="utf-8")


def _no_line(path: Path) -> None:
    lines = (path / "manifest.jsonl").read_bytes().splitlines(keepends=True)
    (path / "manifest.jsonl").write_bytes(lines[0] + lines[2])


def _empty(path: Path) -> None:
    (path / "manifest.jsonl").write_bytes(b"")


def _no_line_and_folder(path: Path) -> None:
    _no_line(path)
    (path / "scenes" / "000001").rename(path.parent / "gone")


def _no_folder(path: Path) -> None:
    (path / "scenes" / "000001").rename(path.parent / "gone")


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (_no_line, "lists 2 scenes and 0 twins, dataset.json counts 3 and 0 (not listed: 000001)"),
        (_empty, "lists 0 scenes and 0 twins, dataset.json counts 3 and 0 (not listed: 000000, "),
        (_no_line_and_folder, "counts 3 and 0 (not listed: 000001)"),
        (_no_folder, "scenes/000001: missing"),
    ],
)
def test_an_incomplete_data_set_is_an_error_that_names_what_is_missing(
    tmp_path: Path, capsys: Captured, command: str, damage: Callable[[Path], None], words: str
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=3, sensors=()))
    (tmp_path / "out").mkdir()
    damage(path)
    assert _call(command, path, tmp_path / "out") == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert words in line
    assert os.listdir(tmp_path / "out") == ["none.jsonl"]
    assert run(["validate", str(path)]) == 1
    assert "000001" in capsys.readouterr().out


@pytest.mark.parametrize("command", ["detect", "export", "evaluate"])
def test_another_catalogue_is_neither_used_nor_passed_on(
    tmp_path: Path, capsys: Captured, command: str
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    (tmp_path / "out").mkdir()
    _edit(path / "catalogue.json", lambda data: data["hazards"][0].update(title="Another"))
    assert _call(command, path, tmp_path / "out") == 1
    told = capsys.readouterr().err
    assert told == "error: catalogue.json: not the catalogue whose digest dataset.json has\n"
    assert os.listdir(tmp_path / "out") == ["none.jsonl"]


def test_scenes_that_could_not_be_made_are_not_missing(tmp_path: Path) -> None:
    path = tmp_path / "d"
    with toy.open_writer(path, toy.small(n=3, sensors=())) as writer:
        toy.add_scene(writer, 1)
        writer.finish(failed={"000000": {Cause("hazards", "no_place"): 9}})
    assert run(["stats", str(path)]) == 0


@pytest.mark.parametrize("command", ["view", "validate"])
def test_a_pipe_for_a_picture_is_not_waited_for(
    tmp_path: Path, capsys: Captured, command: str
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    picture = path / "scenes/000000/views/00/rgb.png"
    picture.unlink()
    os.mkfifo(picture)
    with at_most(5):
        assert run([command, str(path)]) == 1
    told = capsys.readouterr()
    assert "rgb.png: is a FIFO, not a file" in told.out + told.err


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"asset": "stove_77"}, "asset: 'stove_77' is not in assets.jsonl (did you mean 'stove_"),
        ({"variant": "litt"}, "variant: stove_01 has no 'litt' (did you mean 'lit'?)"),
        ({"category": "stov"}, "category: 'stov' is not in catalogue.json (did you mean 'stove'?)"),
        ({"room_id": 7}, "room_id: scene.json has no room 7"),
    ],
)
@pytest.mark.parametrize("command", ["view", "detect"])
def test_what_an_object_names_and_is_not_there_is_told(
    tmp_path: Path, capsys: Captured, command: str, change: dict[str, object], words: str
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    _edit(path / "scenes/000000/scene.json", lambda data: data["objects"][0].update(change))
    reseal(path)
    (tmp_path / "out").mkdir()
    args = ["--method", "rules"] if command == "detect" else []
    assert run([command, str(path), *args, "-o", str(tmp_path / "out" / "o")]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"error: scenes/000000/scene.json: object 11: {words}")


@pytest.mark.parametrize("bad", ["predictions", "manifest"])
def test_many_bad_lines_are_told_shortly_and_soon(
    tmp_path: Path, capsys: Captured, bad: str
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    predictions = tmp_path / "p.jsonl"
    predictions.write_text("")
    target = predictions if bad == "predictions" else path / "manifest.jsonl"
    target.write_text('{"scene": "9", "reports": []}\n' * 100_000, encoding="utf-8")
    start = time.monotonic()
    assert run(["evaluate", str(path), str(predictions)]) == 1
    assert time.monotonic() - start < 5
    assert 10 < len(capsys.readouterr().err.splitlines()) <= SHOWN + 1
    assert run(["validate", str(path)]) == (bad == "manifest")
    assert len(capsys.readouterr().out.splitlines()) <= SHOWN + 1


@pytest.mark.parametrize(
    "command", [["stats", "SET"], ["stats", "SET", "--json"], ["catalog", "list"], ["--help"]]
)
def test_a_reader_that_has_left_ends_quietly(tmp_path: Path, command: list[str]) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    args = [str(path) if word == "SET" else word for word in command]
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run(
        [sys.executable, "-m", "sdgen", *args], stdout=write, stderr=subprocess.PIPE, text=True
    )
    os.close(write)
    assert (done.returncode, done.stderr) == (141, "")


@pytest.mark.parametrize("command", ["stats SET", "catalog list", "doctor", "--help"])
def test_a_closed_output_is_a_reader_that_has_left(tmp_path: Path, command: str) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    line = f"{sys.executable} -m sdgen {command.replace('SET', str(path))} >&-"
    done = subprocess.run(line, shell=True, stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (141, "")


def test_no_file_takes_the_place_of_a_closed_stream() -> None:
    code = (
        "import os; from sdgen.cli import main as m\n"
        "m.run = lambda: os.open(os.devnull, os.O_RDONLY)\n"
        "m.main()"
    )
    line = f"{sys.executable} -c '{code}' <&- >&- 2>&-"
    assert subprocess.run(line, shell=True).returncode > 2


def test_none_is_no_sensor_among_others(tmp_path: Path, capsys: Captured) -> None:
    assert run(["build", "--sensors", "none,rgb", "--out", str(tmp_path / "d")]) == 2
    assert "none stands alone" in capsys.readouterr().err
