"""One place maps errors to exit codes: one clear line each, never a traceback."""

from __future__ import annotations

import errno
import os
import subprocess
import sys

import click
import pytest
from sdgen.cli import main as cli_main
from sdgen.cli.main import COMMANDS, cli, describe, run
from sdgen.errors import BuildIncomplete, InputError, SceneRejected, SdgenError, UsageError
from sdgen.rejection import Cause


def raising(error: BaseException) -> click.Command:
    @click.command()
    def broken() -> None:
        raise error

    return broken


@pytest.mark.parametrize(
    ("error", "code", "text"),
    [
        (SdgenError("the cellar floods"), 1, "error: the cellar floods\n"),
        (UsageError("no such cellar"), 2, "error: no such cellar\n"),
        (BuildIncomplete("2 of 9"), 3, "error: 2 of 9\n"),
        (InputError(["a.yaml:1: x", "a.yaml:2: y"]), 1, "error: a.yaml:1: x\nerror: a.yaml:2: y\n"),
        (KeyboardInterrupt(), 130, "interrupted\n"),
        (
            OSError(errno.ENOSPC, "No space left on device", "/x/y"),
            1,
            "error: /x/y: No space left on device; "
            "free some space, then run the same command again\n",
        ),
    ],
)
def test_errors_become_one_line_and_a_code(
    error: BaseException,
    code: int,
    text: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(cli_main.LazyGroup, "get_command", lambda *_: raising(error))
    assert run(["doctor"]) == code
    out, err = capsys.readouterr()
    assert out == ""
    assert err.lstrip("\n") == text


def test_a_bug_is_one_line_that_says_how_to_report_it(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(
        cli_main.LazyGroup, "get_command", lambda *_: raising(ZeroDivisionError("a\nb"))
    )
    monkeypatch.delenv("SDGEN_DEBUG", raising=False)
    assert run(["doctor"]) == 1
    err = capsys.readouterr().err
    assert len(err.splitlines()) == 1
    assert "unexpected ZeroDivisionError: a b" in err
    assert "SDGEN_DEBUG=1" in err
    monkeypatch.setenv("SDGEN_DEBUG", "1")
    assert run(["doctor"]) == 1
    assert "Traceback" in capsys.readouterr().err


def test_scene_rejected_names_scene_and_reasons() -> None:
    causes = {Cause("hazards", "no_place", "spill"): 3, Cause("physics", "no_rest"): 9}
    text = describe(SceneRejected("000007", causes))
    told = "physics: no rest x9, spill: no place x3"
    assert text == f"error: scene 000007: could not be made ({told})"


@pytest.mark.parametrize(
    ("args", "hint"),
    [
        (["bild"], "did you mean 'build'?"),
        (["build", "--sed", "4"], "--seed"),
        (["build", "extra"], "unexpected extra argument"),
        (["assets", "show"], "Missing argument"),
        (["detect", "x"], "'--method'. Choose from: rules, never, always"),
        (["export", "."], "Missing option '-o'"),
        (["valdate", "x"], "did you mean 'validate'?"),
        (["catalog", "tset"], "did you mean 'test'?"),
        (["home", "exprot"], "did you mean 'export'?"),
        (["assets", "imprt"], "did you mean 'import'?"),
        (["assets", "show", "mug_1"], "did you mean 'mug_01'?"),
    ],
)
def test_usage_errors_are_one_line_with_a_hint_and_exit_2(
    args: list[str], hint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(args) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert len(err.splitlines()) == 1
    assert err.startswith("error: ")
    assert hint in err


def leaf_commands(group: click.Group, path: tuple[str, ...] = ()) -> list[tuple[str, ...]]:
    found = []
    for name in group.list_commands(click.Context(group)):
        command = group.get_command(click.Context(group), name)
        assert command is not None
        if isinstance(command, click.Group):
            found += leaf_commands(command, (*path, name))
        found.append((*path, name))
    return found


@pytest.mark.parametrize("path", leaf_commands(cli), ids=" ".join)
def test_every_command_has_help_with_an_example(
    path: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run([*path, "--help"]) == 0
    out = capsys.readouterr().out
    assert "Example: sdgen " in " ".join(out.split())
    command: click.Command = cli
    for name in path:
        assert isinstance(command, click.Group)
        command = command.get_command(click.Context(command), name) or command
    for param in command.params:
        if isinstance(param, click.Option) and not param.hidden:
            assert param.help, f"{' '.join(path)} {param.opts}: no help"


def test_every_promised_command_is_there(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["--help"]) == 0
    out = capsys.readouterr().out
    for name, help_line in COMMANDS.items():
        assert f"  {name} " in out
        assert help_line in out


def test_a_reader_that_leaves_early_is_no_error() -> None:
    command = f"{sys.executable} -m sdgen assets list | head -1"
    done = subprocess.run(command, shell=True, capture_output=True, text=True)
    assert done.stdout.count("\n") == 1
    assert done.stderr == ""


def test_a_terminal_without_unicode_is_no_error() -> None:
    code = "from sdgen.cli import main as m; m.run = lambda: print('1 \\u00b1 2') or 0; m.main()"
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert (done.stdout, done.returncode) == ("1 ? 2\n", 0), done.stderr


def test_an_optional_package_that_is_missing_is_one_line_that_names_the_extra() -> None:
    code = (
        "import sys\n"
        "class Without:\n"
        "    def find_spec(self, name, *_):\n"
        "        if name.split('.')[0] == 'scipy':\n"
        "            raise ModuleNotFoundError(f'No module named {name!r}', name=name)\n"
        "sys.meta_path.insert(0, Without())\n"
        "from sdgen.cli.main import run\n"
        "sys.exit(run(['assets', 'validate', '--only', 'mug_01', '--workers', '1']))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 1
    assert done.stderr == (
        "error: this needs the package 'scipy': pip install scipy (or sdgen's extra [assets])\n"
    )
    assert "bug" not in describe(ModuleNotFoundError("No module named 'x.y'"))


@pytest.mark.parametrize(("module", "name"), [("pxr", "usd-core"), ("rerun", "rerun-sdk")])
def test_a_missing_package_is_named_as_pip_knows_it(module: str, name: str) -> None:
    """Another's package may have the name of the module: ``rerun`` does."""
    told = describe(ModuleNotFoundError(f"No module named '{module}.x'", name=module))
    assert f"pip install {name} " in told


def test_the_shell_completes_commands() -> None:
    environment = {
        **os.environ,
        "_SDGEN_COMPLETE": "bash_complete",
        "COMP_WORDS": "sdgen val",
        "COMP_CWORD": "1",
    }
    command = [sys.executable, "-c", "from sdgen.cli.main import main; main()"]
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert (done.returncode, done.stdout) == (0, "plain,validate\n")
