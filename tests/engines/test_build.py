"""Builds resume, extend, repair and refuse; what is finished is never lost."""

import json
import shutil

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.engines.build import build as run_build
from sdgen.engines.fit import Misfits
from sdgen.engines.report import Note, SceneDone
from sdgen.errors import InputError, SdgenError, UsageError
from sdgen.options import BuildOptions

from tests.shipped import shipped_library

pytestmark = pytest.mark.xdist_group("build")  # one data set, one worker
OPTIONS = {"n": 2, "seed": 7, "views": 1, "sensors": ()}


@pytest.fixture(scope="module")
def tools():
    return {"catalog": load_catalog(), "library": shipped_library()}


def build(tools, out, events=None, **changes):
    options = BuildOptions.model_validate({**OPTIONS, **changes})
    return run_build(options, out, **tools, on_event=(events if events is not None else []).append)


def manifest(out):
    return (out / "manifest.jsonl").read_text()


@pytest.fixture(scope="module")
def built(tools, tmp_path_factory):
    out = tmp_path_factory.mktemp("build") / "set"
    report = build(tools, out)
    assert report.complete
    assert report.made == 2
    return out


@pytest.mark.slow
def test_a_larger_n_extends_and_a_repeat_does_nothing(tools, built, tmp_path):
    out = tmp_path / "set"
    shutil.copytree(built, out)
    assert build(tools, out).resumed == 2
    assert manifest(out) == manifest(built)
    report = build(tools, out, n=3)
    assert (report.made, report.resumed) == (1, 2)
    assert manifest(out).startswith(manifest(built))


@pytest.mark.slow
def test_a_damaged_scene_is_made_again_to_the_same_bytes(tools, built, tmp_path):
    out = tmp_path / "set"
    shutil.copytree(built, out)
    (out / "scenes" / "000001" / "scene.json").write_text("{")
    events = []
    report = build(tools, out, events)
    assert (report.made, report.resumed) == (1, 1)
    assert any(isinstance(e, Note) and "000001" in e.text for e in events)
    assert manifest(out) == manifest(built)


@pytest.mark.slow
def test_twins_have_the_same_things_and_no_anomalies(tools, tmp_path):
    out = tmp_path / "set"
    events = []
    build(tools, out, events, twins=True, toggles=True, hazards_min=2, hazards_max=2)
    assert sum(isinstance(e, SceneDone) for e in events) == 2
    for name in ("000000", "000001"):
        scene = json.loads((out / "scenes" / name / "scene.json").read_text())
        twin = json.loads((out / "scenes" / f"{name}-twin" / "scene.json").read_text())
        found = json.loads((out / "scenes" / name / "anomalies.json").read_text())["anomalies"]
        left = json.loads((out / "scenes" / f"{name}-twin" / "anomalies.json").read_text())
        touched = {a["object_id"] for a in found} | {u["target_id"] for u in left["undone"]}
        assert len(found) == 2
        assert left["anomalies"] == []
        assert twin["twin_of"] == name

        def others(record, touched=touched):
            return [o for o in record["objects"] if o["id"] not in touched]

        assert others(scene) == others(twin)
        assert scene["home"] == twin["home"]
        assert [u["anomaly_id"] for u in left["undone"]] == ["a00", "a01"]
        for toggle in ("a00", "a01"):
            folder = out / "scenes" / f"{name}-undo-{toggle}"
            kept = json.loads((folder / "anomalies.json").read_text())
            assert [a["id"] for a in kept["anomalies"]] == [
                a for a in ("a00", "a01") if a != toggle
            ]
            assert (folder / "views/00/view.json").is_file()
    assert json.loads((out / "dataset.json").read_text())["options"]["n"] == 2


@pytest.mark.slow
@pytest.mark.parametrize("changes", [{"seed": 8}, {"hazards_max": 3}, {"n": 1}])
def test_a_folder_of_other_options_is_refused_and_left_alone(tools, built, changes):
    before = manifest(built)
    with pytest.raises(SdgenError, match=r"--(out|n)"):
        build(tools, built, **changes)
    assert manifest(built) == before


def test_what_cannot_be_drawn_or_made_is_said_before_anything_is_written(tools, tmp_path):
    with pytest.raises(UsageError):
        build(tools, tmp_path / "a", hazards_max=40)
    catalog = tools["catalog"]
    hazard = catalog.hazard("stove_on")
    recipe = hazard.anomalies[0].model_copy(update={"state": "SPILLED"})
    broken = catalog.model_copy(
        update={"hazards": (hazard.model_copy(update={"anomalies": (recipe,)}),)}
    )
    with pytest.raises(InputError, match="stove_on"):
        build({**tools, "catalog": broken}, tmp_path / "b", hazards_max=1)
    assert list(tmp_path.iterdir()) == []


def test_a_build_that_starts_anew_looks_for_places_for_its_hazards(tools, tmp_path, monkeypatch):
    out = tmp_path / "set"
    (out / "scenes").mkdir(parents=True)
    found = Misfits(("hazard 'mine' fits nowhere",))
    monkeypatch.setattr("sdgen.engines.build.misfits", lambda *_: found)
    options = BuildOptions.model_validate(OPTIONS)
    with pytest.raises(InputError, match="fits nowhere"):
        run_build(options, out, **tools, overwrite=True)
    with pytest.raises(SdgenError) as caught:
        run_build(options, out, **tools)
    assert "fits nowhere" not in str(caught.value)


@pytest.mark.parametrize("wanted", [(1, 3), (-1, 1), (2, 1)])
def test_scenes_that_the_data_set_does_not_have_are_refused(tools, tmp_path, wanted):
    with pytest.raises(UsageError, match=rf"--range {wanted[0]}:{wanted[1]} "):
        run_build(
            BuildOptions.model_validate(OPTIONS), tmp_path / "set", **tools, index_range=wanted
        )
    assert list(tmp_path.iterdir()) == []


def test_a_build_reads_no_model_that_no_scene_needs(tools, tmp_path, monkeypatch):
    """Reading all of them took three seconds at the end of every build."""

    def read(library, asset_id):
        raise AssertionError(asset_id)

    monkeypatch.setattr("sdgen.library.Library.mesh", read)
    assert build(tools, tmp_path / "set", n=0, hazards_max=0).complete
    told = json.loads((tmp_path / "set" / "dataset.json").read_text())
    assert {"OPEN", "BROKEN", "SPILLED"} <= set(told["vocabularies"]["states"])


def test_a_cache_that_cannot_be_written_is_noted_and_ends_no_build(tools, tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("SDGEN_CACHE", str(tmp_path / "file" / "cache"))
    events = []
    assert build(tools, tmp_path / "set", events, n=0, hazards_max=0).complete
    told = [event.text for event in events if isinstance(event, Note)]
    (line,) = (text for text in told if "cache" in text)
    assert line.startswith(str(tmp_path / "file" / "cache"))
    assert "models are unpacked to a temporary folder" in line
