"""The ``sdgen`` command: one lazy group, and the one place that maps errors to exit codes."""

from __future__ import annotations

import errno
import io
import os
import re
import select
import signal
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module

import click

import sdgen
from sdgen.cli import signals
from sdgen.cli.group import NamedGroup
from sdgen.errors import FULL, SHOWN, InputError, SdgenError, Stopped

#: Command -> one line for ``sdgen --help``. Module ``sdgen.cli.<name>`` defines ``<name>``; it is
#: imported only when the command is used, so ``sdgen --help`` stays quick.
COMMANDS = {
    "build": "Build a data set of labelled homes.",
    "merge": "Join pieces of --range into one data set.",
    "validate": "Check a data set: schemas, hashes, masks, every label again.",
    "stats": "Count what a data set holds.",
    "view": "Make a page that shows a data set.",
    "export": "Write a data set for other tools.",
    "import": "Make a data set of others' scene graphs.",
    "train": "Train the offline baselines.",
    "detect": "Run a detector over a data set.",
    "evaluate": "Score predictions against a data set.",
    "benchmark": "Print the tables of detectors; seal and open secret tests.",
    "explore": "Walk through a home, or have it explored.",
    "home": "Draw one home, or write it as YAML or GLB.",
    "catalog": "List, show and check what can go wrong.",
    "assets": "List and show the models.",
    "doctor": "Say what this machine can do, and what is missing.",
}

#: Command -> its module and function, where Python has the word for itself.
MODULES = {"import": "import_graphs"}

#: 128 and the signal: SIGINT is 2.
EXIT_INTERRUPTED = 130
#: What a shell reports of a tool that a closed pipe has ended (128 + SIGPIPE).
EXIT_PIPE = 141
#: Packages only some commands need -> the extra of sdgen that brings them.
EXTRAS = {
    "av": "video",
    "coacd": "assets",
    "datasets": "huggingface",
    "gymnasium": "agent",
    "openai": "llm",
    "pandas": "pandas",
    "pxr": "usd",
    "pyarrow": "lerobot",
    "pycocotools": "coco",
    "ray": "ray",
    "rerun": "rerun",
    "scipy": "assets",
    "sklearn": "learn",
    "torch": "torch",
}
#: Packages that pip calls otherwise than Python does.
DISTRIBUTIONS = {"pxr": "usd-core", "rerun": "rerun-sdk", "sklearn": "scikit-learn"}
EPILOG = "Example: sdgen build --n 12 --seed 7 && sdgen view output/sdgen-n12-s7"


class LazyGroup(NamedGroup):
    """A group that knows its commands by name and imports each when it is used."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        name = MODULES.get(cmd_name, cmd_name)
        command: click.Command = getattr(import_module(f"sdgen.cli.{name}"), name)
        return command

    def invoke(self, ctx: click.Context) -> object:
        try:
            return super().invoke(ctx)
        except BrokenPipeError as error:
            if _reader_gone():
                raise
            # Another pipe than ours; click would end without a word.
            raise SdgenError(f"a process of this command has died ({error})") from error

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


@click.group(cls=LazyGroup, epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(sdgen.__version__, prog_name="sdgen")
def cli() -> None:
    """Homes with household hazards: images, scene graphs, proved anomaly labels."""


def run(args: Sequence[str] | None = None) -> int:
    """Run one command line; returns its exit code, and every error as one clear line."""
    try:
        result = cli.main(args=args, prog_name="sdgen", standalone_mode=False)
        sys.stdout.flush()
        return result if isinstance(result, int) else 0
    except click.exceptions.NoArgsIsHelpError as error:
        error.show()
        return error.exit_code
    except click.ClickException as error:
        message = " ".join(error.format_message().split()).rstrip(".")
        _say(f"error: {message}{_help_hint(error)}")
        return error.exit_code
    except Stopped as stopped:
        _say(signals.in_words(stopped.number, _resumable(args)))
        return stopped.exit_code
    except (click.Abort, KeyboardInterrupt):
        _say(signals.in_words(signal.SIGINT, _resumable(args)))
        return EXIT_INTERRUPTED
    except (BrokenPipeError, SystemExit):  # click and rich turn the one into the other
        if not _reader_gone():
            raise
        # Keep the interpreter from flushing into the pipe again.
        sys.stdout = sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
        return EXIT_PIPE
    except Exception as error:
        if os.environ.get("SDGEN_DEBUG"):
            traceback.print_exc()
        _say(describe(error))
        return error.exit_code if isinstance(error, SdgenError) else 1


def _resumable(args: Sequence[str] | None) -> bool:
    """True for a command that goes on where it was stopped: a build, a download, questions."""
    args = sys.argv[1:] if args is None else args
    words = [word for word in args if word[:1] != "-"]
    asks = words[:1] == ["detect"] and any(word.split("=")[0] == "--model" for word in args)
    return words[:1] == ["build"] or words[:2] == ["assets", "fetch"] or asks


def describe(error: Exception) -> str:
    """What went wrong, for a person: one line (one a problem for bad input files)."""
    if isinstance(error, InputError):
        lines = [f"error: {problem}" for problem in error.problems[:SHOWN]]
        if len(error.problems) > SHOWN:
            lines.append(f"error: and {len(error.problems) - SHOWN} more problems")
        return "\n".join(lines)
    if isinstance(error, SdgenError):
        return f"error: {error}"
    if isinstance(error, OSError) and error.strerror:
        where = f"{error.filename}: " if error.filename else ""
        return f"error: {where}{error.strerror}{_os_advice(error)}"
    # Packages that raise the error of an import again, later, lose its name (trimesh does).
    named = re.match(r"No module named '(\w+)", str(error))
    if isinstance(error, ModuleNotFoundError) and named:
        package = named[1]
        extra = f" (or sdgen's extra [{EXTRAS[package]}])" if package in EXTRAS else ""
        name = DISTRIBUTIONS.get(package, package)
        return f"error: this needs the package {name!r}: pip install {name}{extra}"
    if isinstance(error, MemoryError):
        return "error: out of memory; use fewer --workers or a smaller --size, then resume"
    text = " ".join(str(error).split()) or "no message"
    return (
        f"error: unexpected {type(error).__name__}: {text} "
        "(a bug in sdgen: please report it with the output of SDGEN_DEBUG=1 and 'sdgen doctor')"
    )


def _reader_gone() -> bool:
    """True when whoever read our standard output or error has left: no error of ours."""
    poll = select.poll()
    for stream in (sys.__stdout__, sys.__stderr__):
        if stream is not None:
            poll.register(stream.fileno(), 0)
    return any(event & (select.POLLERR | select.POLLHUP) for _, event in poll.poll(0))


def _open_what_is_closed() -> None:
    """Give closed standard streams (``>&-``) a place; a closed output is a reader that has left.

    Otherwise the next file opened would be number 1 or 2, and a library's print end up in it.
    """
    filled = set()
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        os.set_inheritable(number, True)
        filled.add(number)
    os.close(number)
    if 1 in filled:
        reader, writer = os.pipe()
        os.dup2(writer, 1)
        os.close(writer)
        os.close(reader)
        sys.stdout = sys.__stdout__ = open(1, "w", closefd=False)  # type: ignore[misc]  # noqa: SIM115


def _help_hint(error: click.ClickException) -> str:
    ctx = error.ctx if isinstance(error, click.UsageError) else None
    return f" (see '{ctx.command_path} --help')" if ctx is not None else ""


def _os_advice(error: OSError) -> str:
    if error.errno in FULL:
        return "; free some space, then run the same command again"
    if error.errno in (errno.EACCES, errno.EPERM, errno.EROFS):
        return "; choose a place you may write to and read from"
    return ""


def _say(text: str) -> None:
    click.echo(text, err=True)


def main() -> None:
    """Entry point of the ``sdgen`` script."""
    _open_what_is_closed()
    for stream in (sys.stdout, sys.stderr):
        # A terminal that can't show a degree sign shows a question mark instead of failing.
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    signals.listen()
    sys.exit(run())
