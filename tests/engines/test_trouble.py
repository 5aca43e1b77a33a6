"""The command line under trouble: kills, two builds at once, a full disk."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.by_path import module_at

MAIN = "from sdgen.cli.main import main; main()"
SMALL = ["--n", "3", "--seed", "7", "--views", "1", "--sensors", "none", "--workers", "2"]

pytestmark = pytest.mark.slow


def command(out: Path, options: list[str]) -> list[str]:
    return [sys.executable, "-c", MAIN, "build", *options, "--out", str(out)]


def run(out: Path, options: list[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command(out, options), capture_output=True, text=True, timeout=600)


@pytest.mark.skipif(not os.path.exists("/proc/self/environ"), reason="Linux only")
def test_stopped_in_every_way_it_leaves_nothing_behind_and_ends_in_the_same_bytes(tmp_path):
    """Tiny pictures by the CPU's renderer: dataset.json remembers it over all stops."""
    options = ["--n=4", "--seed=7", "--views=1", "--size=32x32", "--sensors=instance"]
    options += ["--renderer=cpu", "--workers=2"]
    found = module_at("benchmarks/kills.py").compare(tmp_path, options, kills=4, seed=1)
    assert found.hits >= 3
    assert found.stayed == []
    assert found.differing == []
    info = json.loads((tmp_path / "stopped" / "dataset.json").read_text())
    assert info["renderers"] == ["TinyRenderer"]


def test_killed_in_the_middle_it_goes_on_where_it_was(tmp_path):
    """Kills the parent alone, once a scene is there: the workers must end with it."""
    out = tmp_path / "set"
    build = subprocess.Popen(
        command(out, SMALL), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        deadline = time.monotonic() + 300
        while not list(out.glob("scenes/*")) and time.monotonic() < deadline:
            time.sleep(0.05)
        assert list(out.glob("scenes/*"))
        # Meanwhile a second build on the same folder says so, and leaves it be.
        # (The first is held still, or it might end before the second looks.)
        os.kill(build.pid, signal.SIGSTOP)
        second = run(out, SMALL)
        assert build.poll() is None
        assert second.returncode == 1
        assert "another build is writing here" in second.stderr
    finally:
        os.kill(build.pid, signal.SIGKILL)
        build.wait()
    again = run(out, SMALL)
    assert again.returncode == 0, again.stderr
    assert "were there already" in again.stdout
    assert sorted(p.name for p in (out / "scenes").iterdir()) == ["000000", "000001", "000002"]
    assert not (out / ".build").exists()


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
def test_a_full_disk_is_one_line_and_the_same_command_goes_on(tmp_path):
    out = tmp_path / "set"
    assert run(out, ["--n", "1", *SMALL[2:]]).returncode == 0
    # What is written there does not fit.
    entries = out / ".build" / "entries"
    entries.mkdir(parents=True)
    (entries / ".000001.json.partial").symlink_to("/dev/full")
    full = run(out, SMALL)
    assert full.returncode == 1
    (line,) = [line for line in full.stderr.splitlines() if line.startswith("error")]
    assert "No space left" in line
    assert "same command goes on" in line
    done = run(out, SMALL)
    assert done.returncode == 0, done.stderr
    assert run(tmp_path / "whole", SMALL).returncode == 0
    assert (out / "manifest.jsonl").read_bytes() == (tmp_path / "whole/manifest.jsonl").read_bytes()
