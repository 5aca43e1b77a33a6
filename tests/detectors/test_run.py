"""Detectors by name, over scenes and their twins, in whatever view of the graph."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.dataset import Dataset
from sdgen.dataset.graph_views import GRAPH_VIEWS, GraphView
from sdgen.detectors import DETECTORS, Told, detect, detect_all, things
from sdgen.scene import Household, Member
from sdgen.vocabulary import STRUCTURES

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=8, twins=True))


def test_twins_are_looked_at_when_asked_for(path: Path) -> None:
    data = Dataset(path)
    alone, both = detect(data, "always"), detect(data, "always", twins=True)
    assert sorted(alone) == [entry.id for entry in data.shown]
    assert set(both) - set(alone) == {e.id for e in data.entries if e.twin_of is not None}
    assert all(detect(data, "rules", twins=True)[key] == () for key in both if "twin" in key)


def test_several_detectors_say_together_what_each_says_alone(path: Path) -> None:
    data = Dataset(path)
    together = detect_all(data, DETECTORS, twins=True)
    assert together == {name: detect(data, name, twins=True) for name in DETECTORS}


@pytest.mark.parametrize("view", GRAPH_VIEWS)
def test_coins_and_alarms_report_only_what_they_are_shown(path: Path, view: GraphView) -> None:
    data = Dataset(path, graph_view=view)
    for item, (key, said) in zip(data, detect(data, "always").items(), strict=True):
        assert key == item.id
        shown = {node.id: node for node in item.shown_graph.nodes}
        assert [report.object_id for report in said] == [n.id for n in things(item.shown_graph)]
        assert all(shown[r.object_id].class_name not in STRUCTURES for r in said)


def test_chance_is_a_fair_coin_the_same_each_time(path: Path) -> None:
    data = Dataset(path)
    one, other = detect(data, "chance"), detect(data, "chance")
    assert one == other
    heads = sum(len(said) for said in one.values())
    tossed = sum(len(said) for said in detect(data, "always").values())
    assert 0 < heads < tossed
    assert len({tuple(r.object_id for r in said) for said in one.values()}) > 1


def household(*ages: int, opt_outs: tuple[str, ...] = (), **choices: str) -> Household:
    members = tuple(Member(role="somebody", age=age) for age in ages)
    return Household.model_validate(
        {"template": "t", "members": members, "opt_outs": opt_outs, "notifications": choices}
    )


def test_the_filter_heeds_children_opt_outs_and_choices(path: Path) -> None:
    told = Told(Dataset(path).catalog)
    assert told("unsafe for children", household(34, 40)) == "silent"
    assert told("unsafe for children", household(34, 5)) == "now"
    assert told("unsafe", household(34)) == "now"
    assert told("unsanitary", household(34, opt_outs=("sanitation",))) == "silent"
    assert told("unsafe", household(34, opt_outs=("sanitation",))) == "now"
    assert told("unsafe", household(34, spill="summary"), "spill") == "summary"
    assert told("unsafe", household(34, opt_outs=("spill",)), "spill") == "silent"
