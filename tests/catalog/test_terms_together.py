"""The guide's predicates made of several terms mean on real geometry what the guide says."""

from __future__ import annotations

import re

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.predicate_yaml import read_predicate
from sdgen.catalog.terms import Term
from sdgen.facts import Facts
from sdgen.resources import data_path
from sdgen.scene import ObjectInstance
from sdgen.yaml_source import parse_yaml

from tests.facts.scenes import asset, facts, square, thing

README = data_path("hazard_catalog", "README.md").read_text(encoding="utf-8")
SECTION = README.split("### Putting terms together")[1].split("\n### ")[0]
BLOCKS = re.findall(r"```yaml\n(.*?)```", SECTION, re.DOTALL)

SURFACE = {"name": "top", "part": "body", "polygon_m": square(0.29)}
MODELS = (
    asset("frying_pan", (0.2, 0.4, 0.05)),
    asset("vase", (0.1, 0.1, 0.4)),
    asset(
        "bowl",
        (0.1, 0.1, 0.03),
        variants={"default": ["body"], "used": ["body"]},
        states=[{"state": "DIRTY", "variants": ["used"]}],
        supports=[{**SURFACE, "z_m": 0.03, "polygon_m": square(0.04)}],
    ),
    asset("kitchen_counter", (0.6, 0.6, 0.9), supports=[{**SURFACE, "z_m": 0.9}]),
    asset("wall_shelf", (0.6, 0.6, 0.02), supports=[{**SURFACE, "z_m": 0.02}]),
    asset(
        "bed",
        (2.0, 1.0, 0.9),
        supports=[{**SURFACE, "z_m": 0.5, "polygon_m": ((-0.9, -0.4), (0.9, -0.4), (0.9, 0.4))}],
    ),
)


def fixed(*more: float, name: str) -> ObjectInstance:
    found: ObjectInstance = thing(int(more[0]), name, *more[1:])
    return found.model_copy(update={"fixed": True})


@pytest.fixture(scope="module")
def predicates() -> list[Term]:
    catalog = load_catalog()
    names = {c.name for c in catalog.categories}, {r.name for r in catalog.room_types}
    out = []
    for text in BLOCKS:
        source = parse_yaml(text.encode(), "README.md")
        out.append(read_predicate(source, (), source.value, *names))
        assert source.problems == []
    return out


def holds(predicate: Term, *things: ObjectInstance) -> bool:
    """What it surely says of object 1."""
    made: Facts = facts(*things, more=MODELS)
    found = predicate.evaluate(1, made)
    assert found.sure
    return found.value


def test_there_are_three(predicates: list[Term]) -> None:
    assert len(predicates) == 3


def test_a_pans_handle_over_the_edge(predicates: list[Term]) -> None:
    stove, beside = (fixed(k, 2, y, name="kitchen_counter") for k, y in ((2, 2), (3, 2.6)))
    pan = thing(1, "frying_pan", 2, 2.2, 0.9)
    assert holds(predicates[0], stove, pan)
    assert not holds(predicates[0], stove, beside, pan)
    assert not holds(predicates[0], stove, thing(1, "frying_pan", 2, 2, 0.9))


def test_something_heavy_at_an_edge_above_a_bed(predicates: list[Term]) -> None:
    bed, shelf = fixed(2, 1.5, 1, name="bed"), fixed(3, 0.5, 1, 1.5, name="wall_shelf")
    front, back = thing(1, "vase", 0.7, 1, 1.52), thing(1, "vase", 0.3, 1, 1.52)
    assert holds(predicates[1], bed, shelf, front)
    # The wall is behind the shelf, so that it falls to the front alone.
    at_wall = shelf.model_copy(
        update={"pose": shelf.pose.model_copy(update={"position_m": (0.3, 1, 1.5)})}
    )
    assert not holds(predicates[1], bed, at_wall, thing(1, "vase", 0.1, 1, 1.52))
    far = fixed(2, 3, 3, name="bed")
    assert not holds(predicates[1], far, shelf, front)
    assert not holds(predicates[1], bed, shelf, back.model_copy(update={"category": "plate"}))
    low = fixed(3, 0.25, 1, 0.55, name="wall_shelf")
    assert not holds(predicates[1], bed, low, thing(1, "vase", 0.45, 1, 0.57))


def test_dirty_dishes_for_days(predicates: list[Term]) -> None:
    counter = fixed(9, 2, 2, name="kitchen_counter")
    pile = [
        thing(1, "bowl", 1.9, 2, 0.9, variant="used"),
        thing(2, "bowl", 1.9, 2, 0.93, variant="used"),
        thing(3, "bowl", 2.1, 2, 0.9, variant="used"),
        thing(4, "bowl", 2.1, 2, 0.93, variant="used"),
    ]
    assert holds(predicates[2], counter, *pile)
    assert not holds(predicates[2], counter, *pile[:3])
    clean = thing(4, "bowl", 2.1, 2, 0.93)
    assert not holds(predicates[2], counter, *pile[:3], clean)
    elsewhere = thing(4, "bowl", 3, 3, variant="used")
    assert not holds(predicates[2], counter, *pile[:3], elsewhere)
