"""``sdgen catalog propose``, from the command line to the file."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.cli.main import run
from sdgen.proposals import trial

from tests.chat.endpoint import Fake, endpoint

ANSWER = """\
Here are some:
```yaml
- {place: [candle, unicorn], state: ON, relation: ON, target: wardrobe, reason: "forgotten there"}
- {place: candle, state: ON, relation: ON, target: coffee_table}
- {place: laptop, state: ON, relation: ON, target: desk}
```
"""


@pytest.fixture(autouse=True)
def few_homes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trial, "HOMES_TRIED", 3)
    monkeypatch.delenv("OPENAI_API_KEY", raising=False)
    monkeypatch.delenv("OPENAI_BASE_URL", raising=False)


def test_without_a_key_the_prompt_is_printed(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert run(["catalog", "propose", "candle_on"]) == 0
    first = capsys.readouterr()
    assert "Candle left burning" in first.out
    assert first.err == "no OPENAI_API_KEY: give this to a model, then --answer FILE\n"
    monkeypatch.setenv("OPENAI_API_KEY", "k")
    assert run(["catalog", "propose", "candle_on", "--prompt-only"]) == 0
    second = capsys.readouterr()
    assert (second.out, second.err) == (first.out, "")


def test_an_answer_becomes_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "answer.txt").write_text(ANSWER, encoding="utf-8")
    out = tmp_path / "mine" / "hazards" / "candle_on.yaml"
    command = ["catalog", "propose", "candle_on", "--answer", str(tmp_path / "answer.txt")]
    assert run([*command, "--out", str(out)]) == 0
    told = capsys.readouterr().out
    assert told.startswith("4 proposed, 1 fit\n")
    assert f"review it, then sdgen catalog validate {out}" in told
    assert "target: wardrobe}  # line 3: forgotten there" in told
    assert "line 3: unicorn: unknown category 'unicorn' (did you mean 'corn'?)" in told
    assert "the hazard has it" in told
    assert "never true of a laptop" in told
    before = load_catalog().hazard("candle_on").anomalies
    (new,) = load_catalog([tmp_path / "mine"]).hazard("candle_on").anomalies[len(before) :]
    assert new.categories == ("candle",)
    written = out.read_bytes()
    assert run([*command, "--out", str(out)]) == 1
    assert f"{out}: exists already" in capsys.readouterr().err
    assert out.read_bytes() == written


def test_a_model_is_asked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("openai")
    monkeypatch.setenv("OPENAI_API_KEY", "secret")
    assert run(["catalog", "propose", "candle_on"]) == 2
    assert "say which model to ask: --model NAME" in capsys.readouterr().err
    with endpoint(Fake().says(ANSWER)) as fake:
        monkeypatch.setenv("OPENAI_BASE_URL", fake.url)
        assert run(["catalog", "propose", "candle_on", "--model", "small", "--json"]) == 0
    assert fake.keys == ["Bearer secret"]
    assert "Candle left burning" in fake.asked[0]["messages"][0]["content"]
    found = json.loads(capsys.readouterr().out)
    assert (found["hazard"], found["proposed"], found["written"]) == ("candle_on", 4, None)
    assert [one["recipe"]["targets"] for one in found["fit"]] == [["wardrobe"]]
    assert {one["why"] for one in found["refused"]} == {"unknown", "duplicate", "beyond"}
    with endpoint(Fake(b'{"error": {"message": "no credit left"}}', 402)) as fake:
        words = ["--model", "small", "--base-url", fake.url]
        assert run(["catalog", "propose", "candle_on", *words]) == 1
    assert capsys.readouterr().err == f"error: {fake.url}: model 'small': 402: no credit left\n"


@pytest.mark.parametrize(
    ("raw", "told"),
    [
        (b"I cannot help with that.", "answer:1: expected a list of recipes"),
        (b"- !!python/object/apply:os.system ['touch x']", "tags are not allowed"),
        (b"\x00\xff", "is not UTF-8 text"),
        (b"x" * 300_000, "answer: is larger than 200 kB"),
    ],
)
def test_a_hostile_answer_is_an_error_and_nothing_is_written(
    raw: bytes, told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    answer, out = tmp_path / "answer", tmp_path / "candle_on.yaml"
    answer.write_bytes(raw)
    words = ["--answer", str(answer), "--out", str(out)]
    assert run(["catalog", "propose", "candle_on", *words]) == 1
    error = capsys.readouterr().err
    assert told in error
    assert "Traceback" not in error
    assert list(tmp_path.iterdir()) == [answer]


def test_what_is_no_file_or_no_hazard(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    os.mkfifo(tmp_path / "fifo")
    for words, code, told in (
        (["candle_of"], 2, "no hazard 'candle_of' (did you mean 'candle_on'?)"),
        (["candle_on", "--answer", str(tmp_path / "fifo")], 1, "is a FIFO, not a file"),
        (["candle_on", "--answer", str(tmp_path / "none")], 1, "no such file"),
        (["candle_on", "--out", str(tmp_path / "x.yaml")], 2, "its id as its name: candle_on.yaml"),
    ):
        assert run(["catalog", "propose", *words]) == code
        assert told in capsys.readouterr().err


def test_nothing_that_fits_writes_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "answer").write_text("- {place: unicorn, relation: ON, target: desk}\n")
    out = tmp_path / "candle_on.yaml"
    words = ["--answer", str(tmp_path / "answer"), "--out", str(out)]
    assert run(["catalog", "propose", "candle_on", *words]) == 0
    assert f"nothing to write: {out} is not made" in capsys.readouterr().out
    assert not out.exists()


def test_without_the_client_its_extra_is_named() -> None:
    code = (
        "import sys\n"
        "class Without:\n"
        "    def find_spec(self, name, *_):\n"
        "        if name.split('.')[0] in ('openai', 'httpx'):\n"
        "            raise ModuleNotFoundError(f'No module named {name!r}', name=name)\n"
        "sys.meta_path.insert(0, Without())\n"
        "from sdgen.cli.main import run\n"
        "sys.exit(run(['catalog', 'propose', 'candle_on', '--model', 'small']))"
    )
    environment = {**os.environ, "OPENAI_API_KEY": "k"}
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert done.returncode == 1
    assert done.stderr == (
        "error: this needs the package 'openai': pip install openai (or sdgen's extra [llm])\n"
    )
