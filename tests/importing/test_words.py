"""What names say: words of any spelling, the last phrase first, and what is none of ours."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.catalog.load import load_catalog
from sdgen.importing.words import load_words, words_of

CATALOG = load_catalog()
WORDS = load_words(CATALOG)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("aws_robomaker_residential_TVCabinet_01", "aws robomaker residential tv cabinet"),
        ("coffeeTable-round.v2", "coffee table round"),
        ("065-a_cups", "cups"),
        ("ACE_Coffee_Mug_16_oz", "ace coffee mug oz"),
        ("Mens_Bahama_in_Black_b4ADzYywRHl", "mens bahama in black"),
        ("Été_Tasse", "été tasse"),
        ("1080p", ""),
        ("", ""),
    ],
)
def test_names_are_split_into_words(name: str, expected: str) -> None:
    assert words_of(name) == tuple(expected.split())


WORD = st.text(alphabet="abcdefghijklmnopqrstuvwxyz", min_size=2, max_size=8)


@given(st.lists(WORD, min_size=1, max_size=5))
def test_snake_kebab_and_camel_case_say_the_same(words: list[str]) -> None:
    spelled = ("_".join(words), "-".join(words), " ".join(words), "".join(map(str.title, words)))
    assert {words_of(f"{name}_01") for name in spelled} == {tuple(words)}


@given(st.text(max_size=200))
def test_any_text_has_words_and_says_something_or_nothing(text: str) -> None:
    assert all(word == word.lower() and len(word) > 1 for word in words_of(text))
    for found in WORDS.find(text):
        assert found.phrase
        assert all(name in {c.name for c in CATALOG.categories} for name in found.categories)


def first(name: str) -> tuple[str, ...] | None:
    found = WORDS.find(name)
    return found[0].categories if found else None


@pytest.mark.parametrize("category", [c.name for c in CATALOG.categories if c.kind == "small"])
def test_every_small_category_is_known_by_its_name(category: str) -> None:
    camel = "".join(map(str.title, category.split("_")))
    plural = category if category.endswith("s") else f"{category}s"
    for name in (category, f"my_{category}_02", camel, plural):
        said = first(name)
        assert category in (said or ()), name


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("Coffee_Mug_Blue", ("mug",)),
        ("nightStand_03", ("nightstand",)),
        ("knives", ("knife",)),
        ("KitchenTable", ("kitchen_table",)),
        ("table_lamp", ("table_lamp",)),
        ("wooden_beads_on_string", ("wooden_beads",)),
        ("bowl_with_apples", ("bowl",)),
        ("box_of_tissues", ("cardboard_box", "storage_bin")),
        ("orange", ("orange",)),
        ("orange_vase", ("vase",)),
        ("ToyTruck", ("toy_car",)),
        # No such thing, though its name holds one of ours.
        ("coffee_mug_holder", ()),
        ("bottle_opener_stand", ()),
        ("table_cloth", ()),
        ("dollhouse_sofa", ()),
        ("plush_shoe", ()),
        # Nothing at all.
        ("mesh_0042", None),
        ("very_long_name_of_a_shirt_in_orange", None),
    ],
)
def test_the_last_phrase_says_what_it_is(name: str, expected: tuple[str, ...] | None) -> None:
    assert first(name) == expected
