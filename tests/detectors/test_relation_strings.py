"""Graphs in the paper's words."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from sdgen.detectors.relation_strings import Wording, Words, plain_word, sentences

from .graphs import graph, kitchen, node


def test_a_string_is_name_room_and_what_it_lies_on_or_in() -> None:
    pieces = {piece.text: piece.ids for piece in Words(kitchen()).relations()}
    assert pieces == {
        "apple INSIDE kitchen ON kitchencounter": (5, 6),
        "apple (expired) INSIDE kitchen ON kitchencounter": (7,),
        "fridge (on) INSIDE kitchen ON floor": (4,),
        "kitchencounter INSIDE kitchen ON floor": (3,),
        "milkcarton (opened) INSIDE kitchen INSIDE fridge": (8,),
        "mug INSIDE kitchen": (9,),
    }


def test_plain_names_tell_no_states() -> None:
    pieces = {p.text: p.ids for p in Words(kitchen(), Wording(states=False)).relations()}
    assert pieces["apple INSIDE kitchen ON kitchencounter"] == (5, 6, 7)
    assert not any("(" in text for text in pieces)


def test_more_relations_are_added_when_asked_for() -> None:
    texts = {piece.text for piece in Words(kitchen(), Wording(more=True)).relations()}
    assert "mug INSIDE kitchen NEARHEAT fridge" in texts
    assert "milkcarton (opened) INSIDE kitchen INSIDE fridge IN walkway" in texts


def test_names_and_sentences() -> None:
    words = Words(kitchen())
    assert {p.text: p.ids for p in words.names()}["apple"] == (5, 6)
    text = sentences(words.phrases())
    assert "There is an apple (expired) on the kitchen counter in the kitchen." in text
    assert "There is a milk carton (opened) in the fridge in the kitchen." in text


def test_a_thing_in_no_room_and_edges_that_lead_nowhere() -> None:
    (piece,) = Words(graph([node(5, "apple")], (5, "ON", 9), (8, "INSIDE", 5))).relations()
    assert (piece.text, piece.ids, piece.room_id) == ("apple", (5,), None)


@given(st.text())
def test_a_strangers_name_ends_no_quotation_list_or_line(name: str) -> None:
    word = plain_word(name)
    assert word
    assert len(word) <= 60
    assert word.isprintable()
    assert not set(word) & set("'\"`[](){}<>,:;\n")
