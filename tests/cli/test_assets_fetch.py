"""``sdgen assets fetch``: the licence first, then models; every refusal is one clear line."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import click
import pytest
from sdgen.cli.main import run
from sdgen.importing.fetched import FILE

from tests.importing.fake_sources import YCB, put_gso, put_hub, put_ycb, ycb_path
from tests.importing.file_server import Site, serving


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch) -> Iterator[Site]:
    monkeypatch.setenv("no_proxy", "127.0.0.1")
    with serving() as one:
        put_ycb(one)
        put_gso(one)
        put_hub(one)
        yield one


def fetch(site: Site, *words: str) -> int:
    return run(["assets", "fetch", *words, "--base-url", site.base])


def test_models_are_fetched(site: Site, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = str(tmp_path / "ycb")
    assert fetch(site, "ycb", "025_mug", "002_can", "--out", out, "--accept-licence") == 0
    said, licence = capsys.readouterr()
    assert said == f"{out}: 2 models of YCB Object and Model Set, 2 fetched now\n"
    assert "Creative Commons Attribution 4.0 International" in licence
    assert "https://creativecommons.org/licenses/by/4.0/" in licence
    assert (tmp_path / "ycb/002_can/google_16k/textured.obj").is_file()
    assert fetch(site, "ycb", "025_mug", "002_can", "--out", out, "--accept-licence") == 0
    assert "2 models of YCB Object and Model Set, 0 fetched now" in capsys.readouterr().out


def test_names_are_listed_without_a_licence(site: Site, capsys: pytest.CaptureFixture[str]) -> None:
    assert fetch(site, "ycb", "--list") == 0
    assert capsys.readouterr() == ("".join(f"{name}\n" for name in YCB), "")


def test_what_fails_is_told_and_the_rest_is_there(
    site: Site, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    site.put(ycb_path("063-a_marbles"), b"noise")
    assert fetch(site, "ycb", "--all", "--out", str(tmp_path), "--accept-licence") == 1
    out, err = capsys.readouterr()
    assert "2 models of YCB Object and Model Set, 2 fetched now" in out
    assert [line for line in err.splitlines() if line.startswith("error: ")] == [
        f"error: 063-a_marbles: {site.base}{ycb_path('063-a_marbles')}: "
        "is no zip and no tar archive"
    ]


def test_a_model_that_is_only_listed_is_an_error_where_it_was_named(
    site: Site, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    told = "099_gone: listed by YCB Object and Model Set, which has no model of it"
    assert fetch(site, "ycb", "--all", "--out", str(tmp_path), "--accept-licence") == 0
    assert capsys.readouterr().err.splitlines()[-1] == told
    assert fetch(site, "ycb", "099_gone", "--out", str(tmp_path), "--accept-licence") == 1
    assert capsys.readouterr().err.splitlines()[-1] == f"error: {told}"


def test_without_acceptance_nothing_is_asked_for(
    site: Site, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert fetch(site, "replicacad", "--all", "--out", str(out)) == 2
    err = capsys.readouterr().err
    assert "no commercial use" in err
    assert "its own texts disagree" in err
    assert err.splitlines()[-1] == (
        "error: read the licence above; --accept-licence accepts CC-BY-NC-4.0 (nothing was fetched)"
    )
    assert site.asked == []
    assert not out.exists()


@pytest.mark.parametrize("answer", [True, False])
def test_at_a_terminal_it_asks(
    answer: bool,
    site: Site,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    asked: list[str] = []

    def confirm(text: str, **_: object) -> bool:
        asked.append(text)
        return answer

    monkeypatch.setattr(sys.stdin, "isatty", lambda: True)
    monkeypatch.setattr(click, "confirm", confirm)
    code = fetch(site, "ycb", "025_mug", "--out", str(tmp_path / "out"))
    assert asked == ["Do you accept it?"]
    assert (code, bool(site.asked)) == ((0, True) if answer else (1, False))
    assert (tmp_path / "out").exists() is answer
    assert answer or "was not accepted; nothing was fetched" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["yvb", "--list"], "no source 'yvb' (did you mean 'ycb'?)"),
        (["ycb", "--out", "x"], "name models, or --all; --list prints their names"),
        (["ycb", "025_mug", "--all", "--out", "x"], "name models, or --all"),
        (["ycb", "025_mug"], "--out FOLDER"),
        (["ycb", "025_mug", "--out", ""], "names no folder"),
        (["ycb", "--list", "--base-url", "ftp://x"], "--base-url 'ftp://x': expected http://HOST"),
    ],
)
def test_what_makes_no_sense_is_a_usage_error(
    words: list[str],
    told: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["assets", "fetch", *words]) == 2
    err = capsys.readouterr().err
    assert told in err
    assert len(err.splitlines()) == 1
    assert os.listdir(tmp_path) == []


def test_an_unknown_model_is_a_usage_error(
    site: Site, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert fetch(site, "gso", "Mug_Blu", "--out", str(out), "--accept-licence") == 2
    told = capsys.readouterr().err.splitlines()[-1]
    assert told == "error: no model 'Mug_Blu' (did you mean 'Mug_Blue'?); see --list"
    assert not out.exists()


def test_fantastic_breaks_says_where_to_ask(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    words = ["fantastic-breaks", "--all", "--out", str(out), "--accept-licence"]
    assert run(["assets", "fetch", *words]) == 1
    err = capsys.readouterr().err
    assert "https://terascale-all-sensing-research-studio.github.io/FantasticBreaks/" in err
    assert "state no licence" in err
    assert len(err.splitlines()) == 1
    assert not out.exists()


def test_a_place_that_is_no_folder_is_told(
    site: Site, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("mine")
    words = ["ycb", "025_mug", "--out", str(tmp_path / "file"), "--accept-licence"]
    assert fetch(site, *words) == 1
    assert "is a file, not a folder" in capsys.readouterr().err
    assert site.asked == []


def test_a_stopped_run_goes_on_where_it_was(site: Site, tmp_path: Path) -> None:
    path = ycb_path("002_can")
    served = site.put(path, os.urandom(300_000))
    good, served.cut_after, served.cuts, served.stall = served.body, 200_000, 1, True
    out = tmp_path / "out"
    words = ["assets", "fetch", "ycb", "002_can", "--out", str(out), "--accept-licence"]
    command = subprocess.Popen(
        [sys.executable, "-m", "sdgen", *words, "--base-url", site.base],
        stdin=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    parts: list[Path] = []
    while command.poll() is None:
        parts = [part for part in out.glob(".fetching/*.part") if part.stat().st_size > 100_000]
        if parts:
            break
        time.sleep(0.01)
    assert parts, "it ended before it was stopped"
    command.send_signal(signal.SIGTERM)
    _, said = command.communicate(timeout=20)
    assert command.returncode == 128 + signal.SIGTERM
    assert said.splitlines()[-1] == "terminated: resume with the same command"
    assert not (out / FILE).exists()
    have = parts[0].stat().st_size
    assert parts[0].read_bytes() == good[:have]
    site.asked.clear()
    assert fetch(site, *words[2:]) == 1  # noise is no archive, but it came whole
    assert [headers.get("range") for at, headers in site.asked if at == path] == [f"bytes={have}-"]
