"""overhang, edge and above: read, evaluated, measured, said. Swept in tests/facts."""

from __future__ import annotations

import math

import pytest
from sdgen.catalog.predicate import Overlooked, Span, Verdict
from sdgen.catalog.terms.term import ALWAYS, EITHER, NEVER, Can, Case
from sdgen.kleene import Kleene

from tests.catalog.worlds import Thing, World

from .reading import read


def exactly(length_m: float) -> Span:
    return Span(length_m, length_m, length_m)


@pytest.mark.parametrize(
    ("text", "span", "value", "sure"),
    [
        ("{min_m: 0.05}", exactly(0.06), True, True),
        ("{min_m: 0.05}", exactly(0.055), True, False),
        ("{min_m: 0.05}", exactly(0.045), False, False),
        ("{min_m: 0.05}", exactly(0.0), False, True),
        ("{min_m: 0.05}", Span(0.1, 0.0, 0.1), True, False),
        ("{min_m: 0.05}", Span(0.1, 0.07, 0.2), True, True),
        ("{max_m: 0.05}", exactly(0.0), True, True),
        # Neither end is within the limits, and what lies between may be.
        ("{min_m: 0.05, max_m: 0.1}", Span(0.0, 0.0, 0.2), False, False),
        ("{min_m: 0.05, max_m: 0.1}", Span(0.2, 0.15, 0.2), False, True),
    ],
)
def test_overhang(text: str, span: Span, value: bool, sure: bool) -> None:
    term, world = read(f"overhang: {text}")[0], World({1: Thing(overhang=span)})
    found = term.evaluate(1, world)
    evidence = {"overhang_m": span.measured_m}
    assert found == Verdict(value, sure, evidence if value else {})
    assert term.measure(1, world) == evidence


@pytest.mark.parametrize(
    ("text", "span", "value", "sure"),
    [
        ("{max_m: 0.08}", exactly(0.05), True, True),
        ("{max_m: 0.08}", exactly(0.07), True, False),
        ("{max_m: 0.08}", exactly(0.11), False, True),
        ("{max_m: 0.08}", exactly(math.inf), False, True),
        ("{min_m: 0.08}", exactly(math.inf), False, True),
        ("{min_m: 0.08}", exactly(0.5), True, True),
        ("{min_m: 0.08}", Span(0.5, 0.4, math.inf), True, False),
        ("{max_m: 0.08}", Span(math.inf, 0.01, math.inf), False, False),
        ("{max_m: 0.08}", Span(math.inf, 0.2, math.inf), False, True),
    ],
)
def test_edge(text: str, span: Span, value: bool, sure: bool) -> None:
    term, world = read(f"edge: {text}")[0], World({1: Thing(edge=span)})
    found = term.evaluate(1, world)
    evidence = {"edge_m": span.measured_m}
    assert found == Verdict(value, sure, evidence if value else {})
    assert term.measure(1, world) == (evidence if math.isfinite(span.measured_m) else {})


@pytest.mark.parametrize(
    ("overlooked", "value", "sure"),
    [
        ((), False, True),
        ((Overlooked(2, 0.1, 0.6),), True, True),
        ((Overlooked(2, 0.28, 0.6),), True, False),
        ((Overlooked(2, 0.4, 0.6),), False, True),
        ((Overlooked(2, 0.1, 0.27),), False, False),
        ((Overlooked(2, 0.1, -0.2),), False, True),
        ((Overlooked(2, 0.1, 0.6, Kleene(True, False)),), True, False),
        ((Overlooked(3, 0.0, 0.0), Overlooked(2, 0.1, 0.6)), True, True),
    ],
)
def test_above(overlooked: tuple[Overlooked, ...], value: bool, sure: bool) -> None:
    term, _ = read("above: {of: [bed, sofa]}")
    world = World({1: Thing(overlooked={("bed", "sofa"): overlooked})})
    found = term.evaluate(1, world)
    assert (found.value, found.sure) == (value, sure)
    if value:
        gap_m = overlooked[-1].gap_m
        assert found.evidence == {"above_id": 2, "above_gap_m": gap_m, "above_drop_m": 0.6}
    else:
        assert found.evidence == {}
    nearest = [one.target_id for one in overlooked[:1]]
    assert [v for k, v in term.measure(1, world).items() if k == "above_id"] == nearest


FLOOR = Case("vase", relation="ON", target="floor")
SHELF = Case("vase", relation="ON", target="shelf")


@pytest.mark.parametrize(
    ("text", "on_floor"),
    [
        ("overhang: {min_m: 0.05}", NEVER),
        ("overhang: {max_m: 0.05}", ALWAYS),
        ("edge: {max_m: 0.08}", NEVER),
        ("edge: {min_m: 0.3}", NEVER),
        ("above: {of: bed}", NEVER),
        ("above: {of: bed, drop_m: 0}", EITHER),
    ],
)
def test_what_recipes_say_of_them(text: str, on_floor: Can) -> None:
    term, problems = read(text)
    assert problems == []
    assert term.possible(FLOOR) == on_floor
    assert term.possible(SHELF) == EITHER


def test_they_are_read_strictly_and_said() -> None:
    for text, problem in (
        ("overhang: {}", "overhang: needs min_m or max_m (metres)"),
        ("overhang: {min_m: 0}", "overhang.min_m: 0 is no lower limit"),
        ("overhang: {max_m: 0.005}", "overhang: nothing is surely within these limits"),
        ("overhang: {from: 1}", "overhang.from: unknown key"),
        ("edge: 0.08", "edge: expected a mapping"),
        ("edge: {max_m: 0.01}", "edge: nothing is surely within these limits"),
        ("edge: {max: 0.01}", "edge.max: unknown key (did you mean 'max_m'?)"),
        ("above: {}", "above: missing key 'of'"),
        ("above: {of: bet}", "did you mean 'bed'?"),
        ("above: {of: bed, within_m: 0.01}", "above.within_m: nothing is surely so near"),
        ("above: {of: bed, drop_m: -1}", "above.drop_m: -1 is not between 0 and 10"),
    ):
        assert any(problem in found for found in read(text)[1]), read(text)[1]
    words = {
        "overhang: {min_m: 0.05}": "it reaches at least 0.05 m over an edge",
        "edge: {max_m: 0.08}": "it is at most 0.08 m from the edge of what it is on",
        "above: {of: [bed, sofa]}": (
            "it is at least 0.3 m above bed or sofa, and seen from above at most 0.3 m beside it"
        ),
    }
    assert {text: read(text)[0].in_words() for text in words} == words
