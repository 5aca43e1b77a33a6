"""The command line under trouble: kills, two builds at once, a full disk, a misfit hazard."""

import importlib.util
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.engines import local
from sdgen.engines.fit import Blame, misfits
from sdgen.errors import InputError, SdgenError
from sdgen.hazards.draw import draw
from sdgen.library import load_library
from sdgen.options import BuildOptions

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


@pytest.fixture(scope="module")
def tools():
    return {"catalog": load_catalog(), "library": load_library()}


def changed(catalog, hazard_id, **changes):
    """The catalogue with every placing recipe of a hazard changed."""
    hazard = catalog.hazard(hazard_id)
    recipes = tuple(r.model_copy(update=changes) for r in hazard.anomalies if r.kind == "place")
    broken = hazard.model_copy(update={"anomalies": recipes})
    hazards = tuple(broken if h.id == hazard_id else h for h in catalog.hazards)
    return catalog.model_copy(update={"hazards": hazards})


def test_every_shipped_hazard_fits_somewhere(tools):
    assert misfits(**tools, options=BuildOptions(seed=1)) == []


def test_a_hazard_without_a_target_is_named_before_anything_is_written(
    tools, tmp_path, monkeypatch
):
    # As if the library had a model of it, and no room a place for it.
    catalog = changed(tools["catalog"], "sharp_object", targets=("stool_of_gold",))
    monkeypatch.setattr(local, "check_against_library", lambda *_: None)
    with pytest.raises(InputError, match=r"sharp_object.* in \d+ tries .*stool_of_gold"):
        local.build(BuildOptions(n=2), tmp_path / "set", catalog, tools["library"])
    assert list(tmp_path.iterdir()) == []


def test_a_hazard_whose_spot_never_fits_is_named(tools):
    catalog = changed(tools["catalog"], "sharp_object", rooms=("ballroom",))
    (problem,) = misfits(catalog, tools["library"], BuildOptions(seed=1))
    assert "sharp_object" in problem
    assert "nothing fits" in problem


def test_a_hazard_that_is_never_proved_ends_the_build_early(tools, tmp_path, monkeypatch):
    """What is put is never accepted: no scene with it can be made."""
    catalog = tools["catalog"]
    hazard = catalog.hazard("sharp_object")
    never = hazard.model_copy(update={"predicate": catalog.hazard("stove_on").predicate})
    catalog = catalog.model_copy(
        update={"hazards": tuple(never if h.id == hazard.id else h for h in catalog.hazards)}
    )
    options = BuildOptions(n=40, seed=7, views=1, sensors=(), hazards_min=1, hazards_max=2)
    monkeypatch.setattr("sdgen.engines.local.SceneWorker", ImpatientWorker)
    with pytest.raises(SdgenError, match=r"'sharp_object' fits nowhere: never made in \d+ tries"):
        local.build(options, tmp_path / "set", catalog, tools["library"], workers=2)
    assert len(list((tmp_path / "set" / "scenes").iterdir())) < 20


def ImpatientWorker(setup):
    """A worker that gives up a scene after few tries, so that the test ends soon."""
    from sdgen.engines.worker import SceneWorker
    from sdgen.pipeline import scene

    scene.HOME_ATTEMPTS, scene.PLACEMENT_ATTEMPTS = 1, 2
    return SceneWorker(setup)


def blame(catalog, **changes):
    return Blame(catalog, BuildOptions(hazards_min=2, hazards_max=2, **changes))


def with_hazard(catalog, hazard, count):
    names = [h.id for h in catalog.hazards]
    found = [i for i in range(200) if hazard in draw(0, i, names, 2, 2, "balanced")]
    return found[:count]


def test_two_failed_scenes_name_the_hazard_the_tries_and_why(tools):
    one = blame(tools["catalog"])
    first, second = with_hazard(tools["catalog"], "spill", 2)
    assert one.failed(first, {"spill: not proved": 90, "home: no free floor": 10}) is None
    said = one.failed(second, {"spill: not proved": 100})
    assert "'spill' fits nowhere: never made in 190 tries for 2 scenes" in said
    assert "its predicate does not accept" in said


def test_a_hazard_that_some_scene_has_does_not_end_the_build(tools):
    one = blame(tools["catalog"])
    one.made.add("spill")
    for index in with_hazard(tools["catalog"], "spill", 4):
        assert one.failed(index, {"spill: no place found": 100}) is None


def test_overlapping_predicates_are_told_as_such(tools):
    one = blame(tools["catalog"])
    first, second = with_hazard(tools["catalog"], "spill", 2)
    one.made.update({h.id for h in tools["catalog"].hazards} - {"spill"})
    assert one.failed(first, {"tripping_hazard: accidental": 100}) is None
    said = one.failed(second, {"tripping_hazard: accidental": 100})
    assert "'spill'" in said
    assert "also is tripping_hazard: make the two predicates exclude each other" in said
