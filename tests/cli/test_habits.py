"""What people expect of any command: quiet, colours, completion, JSON, types."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import click
import pytest
import sdgen
from sdgen.cli.main import cli, run

from tests import toy
from tests.by_path import ROOT

Captured = pytest.CaptureFixture[str]
#: Colours of the foreground and of the background, not bold or dim.
COLOUR = re.compile(r"\x1b\[[0-9;]*(?:3[0-7]|4[0-7]|9[0-7]|38|48)[0-9;]*m")


@pytest.fixture(scope="module")
def homes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d")


def ran(*words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """``python -m sdgen`` in a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "sdgen", *words],
        capture_output=True,
        text=True,
        env={**os.environ, **environment},
    )


def test_the_package_is_a_command() -> None:
    done = ran("--version")
    assert (done.returncode, done.stdout) == (0, f"sdgen, version {sdgen.__version__}\n")


@pytest.mark.parametrize("command", ["stats", "validate", "detect"])
def test_quiet_draws_no_bar_and_gives_no_hint(command: str, homes: Path) -> None:
    more = ["--method", "rules", "-o", str(homes.parent / "p.jsonl")] if command == "detect" else []
    as_on_a_terminal = {"FORCE_COLOR": "1", "TERM": "xterm"}
    loud = ran(command, str(homes), *more, **as_on_a_terminal)
    quiet = ran(command, str(homes), *more, "--quiet", **as_on_a_terminal)
    assert loud.returncode == quiet.returncode == 0
    assert loud.stderr != ""
    assert (quiet.stderr, quiet.stdout) == ("", loud.stdout)


def test_whoever_shows_a_bar_can_be_quiet() -> None:
    def walk(group: click.Group) -> list[click.Command]:
        context = click.Context(group)
        found = [group.get_command(context, name) for name in group.list_commands(context)]
        return [
            leaf
            for one in found
            if one is not None
            for leaf in (walk(one) if isinstance(one, click.Group) else [one])
        ]

    shows = [one for one in walk(cli) if one.callback and _names(one.callback, "bar", "watch")]
    assert len(shows) >= 10
    for command in shows:
        assert any("--quiet" in option.opts for option in command.params), command.name


def _names(function: object, *names: str) -> bool:
    source = Path(sys.modules[function.__module__].__file__ or "").read_text(encoding="utf-8")
    body = source[source.index(f"\ndef {function.__name__}(") + 1 :]  # type: ignore[attr-defined]
    body = body.split("\n\n\n")[0]
    return any(re.search(rf"\b{name}\(", body) for name in names)


def test_no_color_is_heeded(homes: Path) -> None:
    plain = ran("catalog", "list", FORCE_COLOR="1", NO_COLOR="1", TERM="xterm-256color")
    assert plain.returncode == 0
    assert not COLOUR.search(plain.stdout)
    bar = ran("validate", str(homes), FORCE_COLOR="1", TERM="xterm-256color")
    assert COLOUR.search(bar.stderr)
    bar = ran("validate", str(homes), FORCE_COLOR="1", NO_COLOR="1", TERM="xterm-256color")
    assert bar.stderr
    assert not COLOUR.search(bar.stderr)


@pytest.mark.parametrize(
    ("typed", "number", "offered"),
    [("sdgen catalog li", 2, "list"), ("sdgen validate --reb", 2, "--rebuild")],
)
def test_the_shell_completes_commands_of_groups_and_options(
    typed: str, number: int, offered: str
) -> None:
    done = ran(_SDGEN_COMPLETE="bash_complete", COMP_WORDS=typed, COMP_CWORD=str(number))
    assert (done.returncode, done.stdout) == (0, f"plain,{offered}\n")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_what_completes_is_printed_for_each_shell(shell: str) -> None:
    if shell == "bash" and not Path("/bin/bash").exists():
        pytest.skip("no bash")
    done = ran(_SDGEN_COMPLETE=f"{shell}_source")
    assert done.returncode == 0
    assert "_SDGEN_COMPLETE" in done.stdout


def test_export_and_merge_tell_programs_what_they_wrote(
    homes: Path, tmp_path: Path, capsys: Captured
) -> None:
    out = tmp_path / "homes.tar"
    assert run(["export", str(homes), "-o", str(out), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said == {
        "out": str(out),
        "format": "tar",
        "scenes": len(sdgen.Dataset(homes)),
        "files": 1,
        "bytes": out.stat().st_size,
    }
    assert run(["merge", str(homes), "-o", str(tmp_path / "all"), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert (said["scenes"], said["n"], said["missing"], said["failed"]) == (
        len(sdgen.Dataset(homes)),
        sdgen.Dataset(homes).info.n,
        [],
        [],
    )


@pytest.mark.slow
def test_the_public_api_is_typed_for_whoever_uses_it(tmp_path: Path) -> None:
    good = tmp_path / "good.py"
    good.write_text(
        "from pathlib import Path\n"
        "import numpy as np\n"
        "import sdgen\n"
        "from numpy.typing import NDArray\n"
        "homes = sdgen.Dataset('homes', split='train')\n"
        "depth: NDArray[np.float32] = homes[0].depth(0)\n"
        "words: list[str] = [a.message for a in homes.filter(hazard='spill')[0]"
        ".anomalies.anomalies]\n"
        "options = sdgen.BuildOptions(n=2, seed=7)\n"
        "catalog, library = sdgen.load_catalog(), sdgen.load_library()\n"
        "made: int = sdgen.build(options, Path('homes'), catalog, library).made\n"
        "mean: float | None = sdgen.evaluate(homes, 'predictions.jsonl').AS.mean\n",
        encoding="utf-8",
    )
    bad = tmp_path / "bad.py"
    bad.write_text(
        "import sdgen\n"
        "sdgen.Dataset('homes').filter(hazards='spill')\n"
        "sdgen.Dataset('homes')[0].anomalies.anomalys\n"
        "sdgen.BuildOptions(n='two')\n",
        encoding="utf-8",
    )
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache")]
    environment = {**os.environ, "MYPYPATH": ""}
    environment.pop("PYTHONPATH", None)
    done = subprocess.run(
        [*command, str(good)], cwd=tmp_path, capture_output=True, text=True, env=environment
    )
    assert done.returncode == 0, done.stdout + done.stderr
    done = subprocess.run(
        [*command, str(bad)], cwd=tmp_path, capture_output=True, text=True, env=environment
    )
    assert done.returncode == 1
    lines = {int(line.split(":")[1]) for line in done.stdout.splitlines() if ": error:" in line}
    assert lines == {2, 3, 4}, done.stdout


def test_types_are_shipped() -> None:
    assert (ROOT / "generator" / "sdgen" / "py.typed").is_file()
