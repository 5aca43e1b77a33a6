"""A signal ends a command with one line and its own exit code; a second one at once."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import pytest

SLOW_COMMAND = """
import sys, time
from sdgen.cli import main as module

def slow(args=None, **rest):
    try:
        print("ready", flush=True)
        time.sleep(30)
    finally:
        if "stubborn" in sys.argv:
            print("cleaning", flush=True)
            time.sleep(30)

module.cli.main = slow
module.main()
"""


def start(*words: str) -> subprocess.Popen[str]:
    """A command that waits for its end, and for long after it told to be ``stubborn``."""
    return subprocess.Popen(
        [sys.executable, "-c", SLOW_COMMAND, *words],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@pytest.mark.parametrize(
    ("command_line", "advice"),
    [(("build", "--n", "2"), ": resume with the same command"), (("validate", "build"), "")],
)
@pytest.mark.parametrize(
    ("name", "word"), [("SIGTERM", "terminated"), ("SIGINT", "interrupted"), ("SIGHUP", "hung up")]
)
def test_a_signal_is_one_line_and_an_exit_code(
    name: str, word: str, command_line: tuple[str, ...], advice: str
) -> None:
    number = getattr(signal, name)
    if signal.getsignal(number) is signal.SIG_IGN:
        pytest.skip(f"{name} is ignored here, and stays so in what is started from here")
    command = start(*command_line)
    assert command.stdout is not None
    assert command.stdout.readline() == "ready\n"
    command.send_signal(number)
    _, said = command.communicate(timeout=10)
    assert said == f"{word}{advice}\n"
    assert command.returncode == 128 + number


def test_a_second_signal_ends_it_at_once() -> None:
    command = start("stubborn")
    assert command.stdout is not None
    assert command.stdout.readline() == "ready\n"
    command.send_signal(signal.SIGTERM)
    assert command.stdout.readline() == "cleaning\n"
    begin = time.monotonic()
    command.send_signal(signal.SIGTERM)
    _, said = command.communicate(timeout=10)
    assert time.monotonic() - begin < 5
    assert command.returncode == -signal.SIGTERM
    assert "Traceback" not in said


def test_a_signal_that_is_ignored_stays_so() -> None:
    code = (
        "import signal; signal.signal(signal.SIGHUP, signal.SIG_IGN);"
        "from sdgen.cli import signals; signals.listen();"
        "import os; os.kill(os.getpid(), signal.SIGHUP); print('alive')"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (done.stdout, done.stderr, done.returncode) == ("alive\n", "", 0), os.name
