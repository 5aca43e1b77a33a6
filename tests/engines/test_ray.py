"""The same bytes from a Ray cluster, machines lost on the way or not; nothing stays behind."""

import os
import tempfile
import threading
import time
from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.engines.build import build
from sdgen.engines.registry import EngineOptions
from sdgen.engines.remote import Order, RemoteWorker
from sdgen.engines.report import Note, SceneDone
from sdgen.errors import SdgenError
from sdgen.library import load_library
from sdgen.options import BuildOptions
from sdgen.scratch import PREFIX

ray = pytest.importorskip("ray", reason="Ray is not installed: pip install 'sdgen[ray]'")

OPTIONS = BuildOptions(n=4, seed=7, views=1, sensors=())

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("ray")]


@pytest.fixture(scope="module")
def tools():
    return {"catalog": load_catalog(), "library": load_library()}


@pytest.fixture(scope="module")
def whole(tools, tmp_path_factory):
    out = tmp_path_factory.mktemp("whole") / "set"
    build(OPTIONS, out, **tools, workers=2)
    return contents(out)


@pytest.fixture
def short_tmp(monkeypatch):
    """A place for temporary files, with a name that leaves room for sockets."""
    with tempfile.TemporaryDirectory(dir="/tmp", prefix="t") as folder:
        monkeypatch.setattr(tempfile, "tempdir", folder)
        monkeypatch.setenv("TMPDIR", folder)
        yield Path(folder)


def contents(folder):
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def test_a_cluster_started_for_the_build_makes_the_same_bytes(tools, whole, tmp_path, short_tmp):
    """Scenes are sent home, as from machines that do not share the folder."""
    engine = EngineOptions("ray", send_home=True)
    events = []
    out = tmp_path / "set"
    report = build(OPTIONS, out, **tools, workers=2, engine=engine, on_event=events.append)
    assert report.made == 4
    assert report.peak_memory_mb > 100
    assert sum(isinstance(event, SceneDone) for event in events) == 4
    assert contents(out) == whole
    assert list(short_tmp.iterdir()) == []
    assert not ray.is_initialized()
    assert os.environ["RAY_USAGE_STATS_ENABLED"] == "0"


def test_a_machine_lost_on_the_way_costs_its_scene_another_try(tools, whole, tmp_path, short_tmp):
    from ray.cluster_utils import Cluster

    out = tmp_path / "set"
    cluster = Cluster(
        initialize_head=True,
        head_node_args={
            "num_cpus": 1,
            "include_dashboard": False,
            "temp_dir": str(short_tmp / "ray"),
        },
    )
    lost = threading.Event()

    def lose(node) -> None:
        cluster.remove_node(node, allow_graceful=False)
        lost.set()

    events = []

    def watch(event) -> None:
        events.append(event)
        if isinstance(event, SceneDone) and len(events) == 1:
            # Both machines are at a scene now, or will be at once.
            time.sleep(0.5)
            lose(second)

    try:
        second = cluster.add_node(num_cpus=1)
        engine = EngineOptions("ray", address=cluster.address)
        report = build(OPTIONS, out, **tools, workers=None, engine=engine, on_event=watch)
        assert lost.is_set()
        assert report.made == 4
        assert contents(out) == whole
        left = [path.name for path in short_tmp.iterdir() if path.name.startswith(PREFIX)]
        assert left == []
        replaced = [event.text for event in events if isinstance(event, Note)]
        assert len(replaced) == 1
        assert "worker lost" in replaced[0]
    finally:
        ray.shutdown()
        cluster.shutdown()


def test_no_cluster_at_the_address_is_one_clear_error(tools, tmp_path):
    engine = EngineOptions("ray", address="127.0.0.1:1")
    with pytest.raises(SdgenError, match=r"--ray-address 127\.0\.0\.1:1: no cluster to work on"):
        build(OPTIONS, tmp_path / "set", **tools, engine=engine)


def test_a_machine_that_would_make_other_bytes_is_refused(tools):
    order = Order(setup=None, versions={"numpy": "0.1"}, shipped=Path("x"), probe=None)
    with pytest.raises(SdgenError, match=r"other bytes: .*numpy .*the build has 0\.1"):
        RemoteWorker(order)
