"""Boxes and numbers in a model's free text."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.detectors.pointing import Pointing, read_pointings


@pytest.mark.parametrize(
    "text",
    [
        "picture 2: [10, 20, 30, 40]: 'unsafe for children': knife on the floor",
        "- **Picture 2**: (10, 20, 30.0, 40) – unsafe for children",
        "Picture #2\n[10,20,30,40]: unsafe for children",
        json.dumps([{"picture": 2, "box": [10, 20, 30, 40], "label": "unsafe for children"}]),
        '```json\n{"image": 2, "bbox": [10, 20, 30, 40], "class": "unsafe for children"}\n```',
    ],
)
def test_a_box_in_any_dress(text: str) -> None:
    (one,) = read_pointings(text, nodes=True).found
    assert one == Pointing("unsafe for children", picture=2, box=(10.0, 20.0, 30.0, 40.0))


def test_a_node_by_its_number_where_that_may_be() -> None:
    text = "[17]: 'unsafe' (silent)"
    (one,) = read_pointings(text, nodes=True).found
    assert one == Pointing("unsafe", node=17, notify="silent")
    assert read_pointings(text, nodes=False).found == ()


def test_a_class_nobody_offered_and_what_is_normal() -> None:
    found = read_pointings("[1, 2, 3, 4]: scary\n[1, 2, 3, 4]: normal", nodes=False)
    assert [one.label for one in found.found] == [None]


@pytest.mark.parametrize(("text", "readable"), [("none", True), ("[]", True), ("Turtles!", False)])
def test_nothing_and_nonsense(text: str, readable: bool) -> None:
    found = read_pointings(text, nodes=True)
    assert (found.found, found.readable) == ((), readable)


@given(st.one_of(st.text(), st.text(alphabet="[](),.0123456789 picture:\nunsafe")), st.booleans())
def test_any_text_is_read(text: str, nodes: bool) -> None:
    for one in read_pointings(text, nodes).found:
        assert (one.box is None) != (one.node is None)
