"""Pieces with their categories and models, and long ones as several."""

from __future__ import annotations

import math

import pytest
from sdgen.home.notes import ThingNote
from sdgen.importing.scenes.contents import sort_piece
from sdgen.importing.scenes.found import FoundPiece
from sdgen.importing.scenes.likeness import models_like, side_by_side, unlike
from sdgen.importing.scenes.naming import Named

from tests.importing.scenes.homes import CATALOG, NAMER
from tests.shipped import shipped_library

LIBRARY = shipped_library()
UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def piece(name: str, extents: tuple[float, float, float], **more: object) -> FoundPiece:
    return FoundPiece(name, (1.0, 2.0, 0.0), UPRIGHT, extents, **more)  # type: ignore[arg-type]


def test_a_model_that_was_imported_from_the_same_source_is_taken() -> None:
    fridge = LIBRARY.by_category("fridge")[0]
    found = sort_piece(piece("thing_7", (1, 1, 1), source=fridge.source), NAMER, LIBRARY, CATALOG)
    assert found.category == "fridge"
    assert found.model is not None
    assert LIBRARY.assets[found.model].source == fridge.source
    other = sort_piece(piece("thing_7", (1, 1, 1), source="cad:no_such"), NAMER, LIBRARY, CATALOG)
    assert (other.category, other.model) == (None, None)


def test_a_note_of_another_catalogue_is_told() -> None:
    """Exported with an extension pack that is not here."""
    note = ThingNote(category="terrarium", model="terrarium_01", room="hall")
    found = sort_piece(piece("terrarium_7", (1, 1, 1), note=note), NAMER, LIBRARY, CATALOG)
    assert (found.category, found.model) == (None, None)
    assert found.named.why == "no category is called 'terrarium'"


def test_a_front_along_another_axis_is_turned_to_ours() -> None:
    found = sort_piece(
        piece("sofa", (2.0, 0.9, 0.8)), lambda _: Named("sofa", "x", front="+y"), LIBRARY, CATALOG
    )
    assert found.piece.front
    assert found.piece.extents_m == (0.9, 2.0, 0.8)
    assert found.piece.quat_xyzw == pytest.approx((0, 0, math.sqrt(0.5), math.sqrt(0.5)))


def test_of_unknown_size_is_a_middling_one_on_the_floor() -> None:
    found = sort_piece(piece("bed", (0.0, 0.0, 0.0), sized=False), NAMER, LIBRARY, CATALOG).piece
    assert found.extents_m in [model.extents_m for model in LIBRARY.by_category("bed")]
    assert found.position_m == (1.0, 2.0, 0.0)


def test_a_long_counter_is_several_beside_each_other() -> None:
    long = piece("counter", (0.6, 3.6, 0.9))
    parts = side_by_side(long, "kitchen_counter", LIBRARY)
    assert len(parts) > 1
    assert sum(part.extents_m[1] for part in parts) == pytest.approx(3.6)
    assert sum(part.position_m[1] for part in parts) / len(parts) == pytest.approx(2.0)
    assert all(models_like("kitchen_counter", part.extents_m, LIBRARY) for part in parts)
    # Nobody has three sofas in the place of one.
    assert side_by_side(piece("sofa", (0.9, 6.0, 0.8)), "sofa", LIBRARY) == [
        piece("sofa", (0.9, 6.0, 0.8))
    ]


def test_likeness() -> None:
    assert unlike((1, 2, 1), (2, 1, 1)) == 0
    assert unlike((1, 2, 1), (2, 1, 1), turned=False) == pytest.approx(math.log(2))
    assert unlike((1, 1, 1), (1, 1, 2)) < unlike((1, 1, 1), (1, 2, 1))
