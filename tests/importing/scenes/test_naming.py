"""What names say."""

from __future__ import annotations

import pytest
from sdgen.importing.scenes.found import FoundPiece
from sdgen.importing.scenes.naming import (
    exact_namer,
    opening_of,
    room_in,
    room_type_of,
    room_word,
    structure_of,
    words_of,
)
from sdgen.importing.scenes.table_namer import table_namer

from tests.importing.scenes.homes import CATALOG


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("floor", "floor"),
        ("floor_12_kitchen", "floor"),
        ("floor_7_my_den", "floor"),
        ("Wall North", "wall"),
        ("wall_12_kitchen/skirting_white", "wall"),
        ("LivingRoomWall_03", "wall"),
        ("roof", "ceiling"),
        ("wall_cabinet_3", None),
        ("wall_shelf", None),
        ("floor_lamp", None),
        ("wallet", None),
        ("ceiling_lamp_2", None),
        ("wall art", None),
        ("", None),
        ("17", None),
    ],
)
def test_parts_of_the_building(name: str, kind: str | None) -> None:
    assert structure_of(name, CATALOG) == kind


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("door_17", "door"),
        ("Front Door", "front_door"),
        ("front_door_39880", "front_door"),
        ("Kitchen Window 2", "window"),
        ("DoorFrame", "passage"),
        ("fridge_door_handle", None),
        ("doormat_2", None),
    ],
)
def test_openings(name: str, kind: str | None) -> None:
    assert opening_of(name) == kind


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("kitchen", "kitchen"),
        ("Master_Bedroom_2", "bedroom"),
        ("LivingRoom", "living_room"),
        ("hallway", "hall"),
        ("helipad", None),
    ],
)
def test_rooms(name: str, kind: str | None) -> None:
    assert room_type_of(name, CATALOG) == kind


def test_words() -> None:
    assert words_of("Kitchen_Counter-03 (1)") == ("kitchen", "counter")
    assert words_of("tvStand2") == ("tv", "stand")
    assert room_in("floor_12_living_room") == "living_room"
    assert room_in("floor_living") is None
    assert room_word("Küche 2", "room") == "ku_che_2"
    assert room_word("2nd", "room") == "room"
    assert room_word("居間", "room") == "room"


def piece(name: str, extents: tuple[float, float, float], sized: bool = True) -> FoundPiece:
    return FoundPiece(name, (0, 0, 0), (0, 0, 0, 1), extents, sized=sized)


def test_our_own_names_whatever_follows_them() -> None:
    named = exact_namer(CATALOG)
    assert named(piece("Kitchen Counter_042", (0.6, 0.6, 0.9))).category == "kitchen_counter"
    assert named(piece("spaceship", (1, 1, 1))).category is None


def test_tables_and_guesses() -> None:
    cad = table_namer("replicacad", CATALOG)
    sofa = cad(piece("frl_apartment_sofa", (0.0, 0.0, 0.0), sized=False))
    assert (sofa.category, sofa.front, sofa.guessed) == ("sofa", "+y", False)
    assert "bicycle" in cad(piece("frl_apartment_bike_01", (0.5, 1.8, 1.0))).why
    anybody = table_namer("gltf", CATALOG)
    guessed = anybody(piece("Refrigerator_A", (0.65, 0.6, 1.8)))
    assert (guessed.category, guessed.guessed) == ("fridge", True)
    assert anybody(piece("bed_7", (2.1, 1.6, 0.8))).guessed is False
