"""``sdgen detect`` with a language model, as a user runs it: whole, killed, refused, replayed."""

from __future__ import annotations

import base64
import hashlib
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from sdgen.chat.endpoint import _masked
from sdgen.cli.detect import ASKING
from sdgen.cli.main import run
from sdgen.detectors.prompts import PROMPTS

from tests import toy
from tests.chat.endpoint import Fake, endpoint
from tests.chat.unreliable import Unreliable, unreliable

pytest.importorskip("openai")
Captured = pytest.CaptureFixture[str]
FAST = ["--longest-wait", "0.05", "--timeout", "5"]


@pytest.fixture(scope="module")
def homes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=6))


@pytest.fixture(autouse=True)
def key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", "any")
    monkeypatch.delenv("OPENAI_BASE_URL", raising=False)


@pytest.fixture
def good() -> Iterator[Unreliable]:
    with unreliable(Unreliable(reliable=True)) as fake:
        yield fake


def words(homes: Path, out: Path, url: str, *more: str, method: str = "cot-sg-c") -> list[str]:
    given = ["detect", str(homes), "--method", method, "-o", str(out), "--base-url", url, *FAST]
    return [*given, *([] if "--model" in more else ["--model", "small"]), *more]


def account(out: Path) -> dict[str, Any]:
    told: dict[str, Any] = json.loads(Path(f"{out}.account.json").read_text(encoding="utf-8"))
    return told


def test_the_commands_methods_are_those_there_are() -> None:
    assert tuple(PROMPTS) == ASKING


@pytest.mark.parametrize("method", ASKING)
def test_predictions_account_and_answers_are_written(
    homes: Path, tmp_path: Path, capsys: Captured, good: Unreliable, method: str
) -> None:
    out = tmp_path / "p.jsonl"
    assert (
        run(words(homes, out, good.url, "--price-in", "2", "--price-out", "8", method=method)) == 0
    )
    told = capsys.readouterr().err
    assert "small: about " in told
    assert "at your prices 0." in told
    assert "6 scenes: 6 answered, 0 partly, 0 unparsable, 0 failed" in told
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "p.jsonl",
        "p.jsonl.account.json",
        "p.jsonl.cache",
    ]
    found = account(out)
    settings = found["settings"]
    assert (settings["method"], settings["household"]) == (method, "filter")
    assert settings["prompt_sha256"] == PROMPTS[method].sha256
    # Toy scenes repeat: a question that came before is not paid for again.
    assert 0 < found["paid"] <= found["cost"]
    assert [scene["status"] for scene in found["scenes"]] == ["answered"] * 6
    assert run(["evaluate", str(homes), str(out)]) == 0


def test_the_same_command_again_asks_nothing(homes: Path, tmp_path: Path, good: Unreliable) -> None:
    out = tmp_path / "p.jsonl"
    assert run(words(homes, out, good.url)) == 0
    asked, before = sum(good.tries.values()), out.read_bytes()
    assert run(words(homes, out, good.url)) == 0
    assert (sum(good.tries.values()), out.read_bytes()) == (asked, before)
    assert account(out)["spent"]["paid_tokens_in"] == 0
    assert account(out)["spent"]["cached"] == account(out)["spent"]["questions"]


def test_a_replay_needs_neither_key_nor_endpoint(
    homes: Path,
    tmp_path: Path,
    capsys: Captured,
    good: Unreliable,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    out, cache = tmp_path / "p.jsonl", tmp_path / "answers"
    assert run(words(homes, out, good.url, "--cache", str(cache))) == 0
    monkeypatch.delenv("OPENAI_API_KEY")
    nowhere = "http://127.0.0.1:1/v1"
    again = tmp_path / "again.jsonl"
    assert run(words(homes, again, nowhere, "--cache", str(cache), "--replay")) == 0
    assert again.read_bytes() == out.read_bytes()
    sorted(cache.iterdir())[0].unlink()
    capsys.readouterr()
    assert run(words(homes, tmp_path / "x", nowhere, "--cache", str(cache), "--replay")) == 1
    assert "was never answered (--replay)" in capsys.readouterr().err
    assert not (tmp_path / "x").exists()


def test_one_that_is_killed_goes_on_where_it_was(homes: Path, tmp_path: Path) -> None:
    """Interrupted in the middle; then nothing that was answered is asked again."""
    out, cache = tmp_path / "p.jsonl", tmp_path / "p.jsonl.cache"
    # Slow enough that on a busy machine, too, it is still asking when it is stopped.
    with unreliable(Unreliable(reliable=True, pause_s=0.6)) as fake:
        line = words(homes, out, fake.url, "--batch", "1", "--concurrency", "2")
        command = [sys.executable, "-m", "sdgen", *line]
        # Tests that run in the background of a shell ignore SIGINT, and hand that down.
        started = subprocess.Popen(
            command,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ},
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        )
        until = time.monotonic() + 60
        while len(list(cache.glob("*.json"))) < 4 and time.monotonic() < until:
            time.sleep(0.01)
        started.send_signal(signal.SIGINT)
        _, told = started.communicate(timeout=30)
        assert started.returncode == 130, told
        assert told.splitlines()[-1] == "interrupted: resume with the same command"
        assert not out.exists()
        kept = {path.name for path in cache.glob("*.json")}
        fake.tries.clear()
        fake.pause_s = 0.0
        assert run(line) == 0
        whole = {path.name for path in cache.glob("*.json")}
        assert kept < whole
        assert sum(fake.tries.values()) == len(whole) - len(kept)


def test_several_models_in_one_table(
    homes: Path, tmp_path: Path, capsys: Captured, good: Unreliable
) -> None:
    models = ["--model", "small", "--model", "other/large"]
    out = tmp_path / "p-{model}.jsonl"
    assert run(words(homes, tmp_path / "p.jsonl", good.url, *models)) == 2
    assert "-o p-{model}.jsonl" in capsys.readouterr().err
    assert run(words(homes, out, good.url, *models)) == 0
    table = capsys.readouterr().out
    assert "household: filter" in table
    assert "other/large" in table
    names = {path.name for path in tmp_path.glob("*.jsonl")}
    assert names == {"p-small.jsonl", "p-other-large.jsonl"}


def test_an_estimate_asks_nobody_and_writes_nothing(
    homes: Path, tmp_path: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("OPENAI_API_KEY")
    monkeypatch.chdir(tmp_path)
    line = ["detect", str(homes), "--method", "sg-c", "--model", "small", "--estimate"]
    assert run([*line, "--price-in", "1000", "--price-out", "0"]) == 0
    told = capsys.readouterr().out
    assert told.startswith("small: about 6 questions, ")
    assert "at your prices " in told
    assert list(tmp_path.iterdir()) == []


def test_scenes_that_could_not_be_asked_are_named_and_the_exit_is_3(
    homes: Path, tmp_path: Path, capsys: Captured
) -> None:
    out = tmp_path / "p.jsonl"
    with endpoint(Fake(b'{"error": {"message": "slow down"}}', 429)) as fake:
        assert run(words(homes, out, fake.url, "--retries", "1")) == 3
        (line,) = [one for one in capsys.readouterr().err.splitlines() if "error" in one]
        assert "6 of 6 scenes could not be asked: 429: slow down (6)" in line
        assert "the same command asks them again" in line
        assert account(out)["scenes_by_status"]["failed"] == 6
        assert not out.exists()
        # And it does.
        fake.status = 200
        fake.says("none")
        assert run(words(homes, out, fake.url)) == 0
    good = out.read_bytes()
    assert len(good.splitlines()) == 6
    # What went well stays, whatever a later run comes to.
    with endpoint(Fake(b"no", 500)) as fake:
        again = [*words(homes, out, fake.url, "--retries", "0"), "--cache", str(tmp_path / "c")]
        assert run(again) == 3
    assert "stays as it was" in capsys.readouterr().err
    assert out.read_bytes() == good
    kept = account(out)
    assert kept["scenes_by_status"]["failed"] == 0
    assert kept["predictions_sha256"] == hashlib.sha256(good).hexdigest()
    # Of another detector there is no account.
    assert run(["detect", str(homes), "--method", "never", "-o", str(out)]) == 0
    beside = out.with_name("p.jsonl.account.json")
    assert not beside.exists()
    beside.write_text("mine")
    assert run(["detect", str(homes), "--method", "never", "-o", str(out)]) == 0
    assert beside.read_text() == "mine"


def test_a_key_is_masked_in_the_forms_that_gateways_echo() -> None:
    key = "sk/SECRET+xyzzy="
    forms = [key, "sk%2FSECRET%2Bxyzzy%3D", "sk\\/SECRET+xyzzy="]
    forms += [base64.b64encode(one.encode()).decode() for one in (key, f"Bearer {key}")]
    text = _masked(" and ".join(forms), key)
    assert "SECRET" not in text
    assert all(form not in text for form in forms)
    assert _masked("any word", "any") == "any word"


@pytest.mark.parametrize("status", [200, 401])
def test_a_key_that_an_endpoint_repeats_is_kept_nowhere(
    homes: Path,
    tmp_path: Path,
    capsys: Captured,
    monkeypatch: pytest.MonkeyPatch,
    status: int,
) -> None:
    key = "sk-SECRET-xyzzy"
    monkeypatch.setenv("OPENAI_API_KEY", key)
    said = {"error": {"message": f"bad key {key}"}}
    if status == 200:
        said = {"choices": [{"message": {"content": f"'{key}': 'unsafe'"}}]}
    with endpoint(Fake(json.dumps(said).encode(), status)) as fake:
        run(words(homes, tmp_path / "p.jsonl", fake.url))
    assert fake.asked
    told = capsys.readouterr()
    assert key not in told.out + told.err
    kept = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert status == 401 or kept
    assert not [path for path in kept if key.encode() in path.read_bytes()]


def test_an_endpoint_that_refuses_the_key_is_asked_three_times(
    homes: Path, tmp_path: Path, capsys: Captured
) -> None:
    with endpoint(Fake(b'{"error": {"message": "no such key"}}', 401)) as fake:
        assert (
            run(words(homes, tmp_path / "p.jsonl", fake.url, "--concurrency", "1", "--batch", "2"))
            == 1
        )
    assert len(fake.asked) == 3
    assert "401: no such key (the first 3 questions were refused" in capsys.readouterr().err
    assert not (tmp_path / "p.jsonl").exists()


def test_an_unreliable_endpoint_leaves_no_scene_without_an_account(tmp_path: Path) -> None:
    homes, out = toy.build(tmp_path / "d", toy.small(n=4, sensors=())), tmp_path / "p.jsonl"
    with unreliable(Unreliable(late_s=0.0)) as fake:
        code = run(words(homes, out, fake.url, "--batch", "1", "--retries", "6"))
    found = account(out)
    assert [scene["scene"] for scene in found["scenes"]] == [f"{k:06d}" for k in range(4)]
    failed = [scene for scene in found["scenes"] if scene["status"] == "failed"]
    assert code == (3 if failed else 0)
    assert all(scene["why"] for scene in failed)
    assert found["spent"]["retries"] > 0


@pytest.mark.parametrize(
    ("more", "words_"),
    [
        (["--method", "sg-c"], "say which model to ask: --model NAME"),
        (["--method", "rules", "--model", "m"], "--model is for methods that ask"),
        (["--method", "rules", "--household", "prompt"], "--household is for methods that ask"),
        (["--method", "sg-c", "--model", "m", "--price-in", "3"], "--price-in and --price-out"),
        (["--method", "sg", "--model", "m", "--parser", "m"], "--parser is for"),
        (["--method", "sg-c", "--model", "m", "--temperature", "hot"], "is no number, nor none"),
        (["--method", "sg-c", "--trained", "x"], "name one of them"),
        (["--method", "rules", "--threshold", "0.5"], "--threshold goes with --trained"),
        (["--trained", "x", "--threshold", "1.5"], "1.5 is not in the range"),
        (["--method", "sg-c", "--model", "m", "--base-url", "nonsense"], "no address of an"),
        (["--method", "sg-c", "--model", "m", "--base-url", "file:///etc"], "no address of an"),
        (["--method", "sg-c", "--model", "m", "--base-url", "http://h:99999"], "no address of an"),
        (["--method", "sg-c", "--model", "m", "--base-url", ""], "no address of an"),
        (["--method", "sg-c", "--model", "m", "--timeout", "nan"], "--timeout: nan is no number"),
    ],
)
def test_options_that_make_no_sense_are_one_line(
    homes: Path, tmp_path: Path, capsys: Captured, more: list[str], words_: str
) -> None:
    assert run(["detect", str(homes), "-o", str(tmp_path / "p.jsonl"), *more]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert words_ in line
    assert list(tmp_path.iterdir()) == []


def test_no_key_is_said_before_the_work(
    homes: Path, tmp_path: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("OPENAI_API_KEY")
    assert run(words(homes, tmp_path / "p.jsonl", "http://127.0.0.1:1/v1")) == 2
    assert "no OPENAI_API_KEY" in capsys.readouterr().err


def test_pictures_that_are_not_there_and_no_standard_output(
    tmp_path: Path, capsys: Captured
) -> None:
    homes = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    assert run(words(homes, tmp_path / "p.jsonl", "http://x/v1", method="views")) == 2
    assert "has no colour pictures" in capsys.readouterr().err
    assert run(words(homes, Path("-"), "http://x/v1")) == 2
    assert "name a file" in capsys.readouterr().err


def test_a_bad_file_among_the_answers_is_named(
    homes: Path, tmp_path: Path, capsys: Captured, good: Unreliable
) -> None:
    out = tmp_path / "p.jsonl"
    assert run(words(homes, out, good.url)) == 0
    for path in (tmp_path / "p.jsonl.cache").iterdir():
        path.write_text("{}")
    capsys.readouterr()
    assert run(words(homes, out, good.url)) == 1
    assert "take the file away to ask again" in capsys.readouterr().err
