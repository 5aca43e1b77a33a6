"""The command line under trouble: kills, two builds at once, a full disk."""

import importlib.util
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

MAIN = "from sdgen.cli.main import main; main()"
SMALL = ["--n", "3", "--seed", "7", "--views", "1", "--sensors", "none", "--workers", "2"]

pytestmark = pytest.mark.slow


def command(out: Path, options: list[str]) -> list[str]:
    return [sys.executable, "-c", MAIN, "build", *options, "--out", str(out)]


def run(out: Path, options: list[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command(out, options), capture_output=True, text=True, timeout=600)


def kills():
    path = Path(__file__).parents[2] / "benchmarks" / "kills.py"
    spec = importlib.util.spec_from_file_location("kills", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_killed_five_times_at_random_moments_it_ends_in_the_same_bytes(tmp_path):
    options = ["--n=6", "--seed=7", "--views=1", "--sensors=none", "--workers=2"]
    differing, hits = kills().compare(tmp_path, options, kills=5, seed=1)
    assert hits >= 2
    assert differing == []


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
