"""Why a thing is a hazard, clause by clause, and what is drawn of it."""

from collections.abc import Iterator

import pytest
from sdgen.facts import Facts
from sdgen.gallery.marks import marks_of
from sdgen.gallery.reasons import Rule, rules_of
from sdgen.gallery.words import measured, who
from sdgen.hazards.certify import facts_of
from sdgen.scene import Household

from tests import toy


@pytest.fixture(scope="module")
def facts() -> Facts:
    return facts_of(toy.scene(3), toy.infos(), toy.catalog())


def name(key: int) -> str:
    return f"node {key}"


def flat(rules: tuple[Rule, ...]) -> Iterator[Rule]:
    for rule in rules:
        yield rule
        yield from flat(rule.parts)


@pytest.mark.parametrize("hazard", ["stove_on", "sharp_object", "refrigerated_food_out"])
def test_every_clause_of_an_anomaly_holds(facts: Facts, hazard: str) -> None:
    key = {"stove_on": 11, "sharp_object": 600, "refrigerated_food_out": 4000}[hazard]
    rules = rules_of(toy.catalog().hazard(hazard).predicate, key, facts, name)
    assert rules
    assert all(rule.holds for rule in rules)


def test_a_near_miss_says_what_it_misses_and_by_how_much(facts: Facts) -> None:
    rules = rules_of(toy.catalog().hazard("sharp_object").predicate, 512, facts, name)
    (missed,) = [rule for rule in rules if not rule.holds]
    assert missed.text.startswith("its lowest point is at most 1.44 m")
    assert ("above where a child can stand", "1.80 m") in missed.measured
    # A clause says what it is made of: inside nothing that is closed.
    assert "it is INSIDE knife block" in {rule.text for rule in flat(rules)}


def test_cases_of_other_kinds_are_counted_not_listed(facts: Facts) -> None:
    predicate = toy.catalog().hazard("refrigerated_food_out").predicate
    texts = [rule.text for rule in flat(rules_of(predicate, 77, facts, name))]
    assert any(text.startswith("cases of other kinds (") for text in texts)
    assert len(texts) < 12


def test_heights_are_drawn_with_their_limits(facts: Facts) -> None:
    bundle = toy.bundle(3)
    boxes = {node.id: node.bounding_box for node in bundle.graph.nodes}
    predicate = toy.catalog().hazard("sharp_object").predicate
    (near,) = bundle.anomalies.lookalikes
    (mark,) = marks_of(512, near.evidence, predicate, facts, boxes)
    assert mark["kind"] == "height"
    assert (mark["from"], mark["to"], mark["text"]) == (0.0, 1.8, "height 1.80 m")
    assert mark["limits"] == [{"z": 1.44, "text": "at most 1.44 m"}]


def test_distances_zones_and_others_are_drawn(facts: Facts) -> None:
    bundle = toy.bundle(3)
    boxes = {node.id: node.bounding_box for node in bundle.graph.nodes}
    zone = bundle.scene.zones[0]
    evidence = {"distance_m": 0.5, "nearest_id": 11, "zone_name": zone.name, "target_id_2": 77}
    marks = marks_of(600, evidence, None, facts, boxes)
    assert [mark["kind"] for mark in marks] == ["thing", "line", "thing", "zone"]
    line = marks[1]
    assert line["text"] == "0.50 m"
    ends = [line["from"], line["to"]]
    low, high = (
        [c + side * s / 2 for c, s in zip(boxes[11].center, boxes[11].size, strict=True)]
        for side in (-1, 1)
    )
    assert any(
        all(a - 1e-3 <= v <= b + 1e-3 for a, v, b in zip(low, end, high, strict=True))
        for end in ends
    )
    assert marks[3]["polygon"] == [[round(x, 3), round(y, 3)] for x, y in zone.polygon_m]
    assert marks[3]["text"] == zone.kind.replace("_", " ")
    assert marks[3]["at"][2] == 0.74  # at its foot
    # What is not there, as files of strangers may have it, is not drawn.
    assert marks_of(600, {"nearest_id": 9, "zone_name": "none"}, None, facts, boxes) == []


def test_measures_and_households_are_said_in_words() -> None:
    evidence = {"distance_m": 0.254, "nearest_id": 11, "zone_overlap": 0.5, "facing_deg": 12.4}
    assert measured(evidence, name) == (
        ("distance", "0.25 m"),
        ("nearest", "node 11"),
        ("in the zone", "50%"),
        ("turned towards it by", "12°"),
    )
    assert measured({"relation": "ON", "target_id_2": 7}, name) == (("to", "node 7"),)
    assert who(Household(template="t", members=())) == "Nobody lives here."
    pets = toy.household().model_copy(update={"pets": ("cat",)})
    assert who(pets).endswith("and a child of 5 live here, with a cat.")
