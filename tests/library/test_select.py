"""Picking models by id and category."""

import pytest
from sdgen.errors import UsageError
from sdgen.library.select import select

from tests.shipped import shipped_library


def test_words_are_ids_and_categories() -> None:
    library = shipped_library()
    assert select(library, []) == list(library.assets)
    mugs = [asset.id for asset in library.by_category("mug")]
    assert select(library, ["mug", "fridge_01"]) == sorted([*mugs, "fridge_01"])


def test_a_word_that_names_nothing_is_an_error() -> None:
    with pytest.raises(UsageError, match="did you mean 'fridge'"):
        select(shipped_library(), ["frigde"])
