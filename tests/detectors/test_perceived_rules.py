"""The rules detector on what it is shown."""

from pathlib import Path

import pytest
from sdgen import Dataset, Perception
from sdgen.detectors import DETECTORS, detect
from sdgen.errors import UsageError

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("rules") / "d", n=4)


def test_rules_read_the_perceived_scene(path: Path) -> None:
    truth = detect(Dataset(path), "rules", twins=True)
    seen = detect(Dataset(path, graph_view="perceived"), "rules", twins=True)
    assert seen == truth  # the toy's pictures show all that is wrong
    assert len(seen["000003"]) == 3
    assert seen["000003-twin"] == ()


def test_what_is_overlooked_is_not_reported(path: Path) -> None:
    blind = Dataset(path, graph_view="perceived", perception=Perception(missed=1.0))
    assert detect(blind, "rules") == {f"{k:06d}": () for k in range(4)}
    dull = Dataset(path, graph_view="perceived", perception=Perception(states=False))
    assert {report.object_id for report in detect(dull, "rules")["000003"]} == {600, 4000}


def test_rules_need_states(path: Path) -> None:
    with pytest.raises(UsageError, match="take full or perceived"):
        detect(Dataset(path, graph_view="neutral"), "rules")


@pytest.mark.parametrize("method", sorted(DETECTORS))
@pytest.mark.parametrize(
    "how", [{}, {"coarse": True}, {"missed": 0.5, "confused": 1.0}, {"states": False}]
)
def test_every_detector_runs_on_perceived_graphs(path: Path, method: str, how) -> None:
    data = Dataset(path, graph_view="perceived", perception=Perception(**how))
    found = detect(data, method)
    for item in data:
        known = {node.id for node in item.shown_graph.nodes}
        assert {report.object_id for report in found[item.id]} <= known
