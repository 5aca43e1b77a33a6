"""What only the models' sizes tell of a drawing: each mistake told at its place, all at once."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.errors import InputError
from sdgen.home.drawing_check import check_drawings, drawing_problems

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()

HUT = """\
id: hut
title: A hut
rooms:
  - name: stube
    type: kitchen
    rectangles_m: [[0, 0, 4, 3]]
    furniture:
      - {category: fridge, position_m: [0.09, 2.0, 0], against_wall: true}
      - {category: kitchen_table, position_m: [2.4, 1.6, 0], yaw_deg: 90}
      - {category: wall_shelf, position_m: [2, 2.91, 1.5], yaw_deg: 270, against_wall: true}
      - {category: plant_pot, model: plant_pot_01, position_m: [3.4, 2.4, 0], optional: true}
  - name: kammer
    type: bedroom
    rectangles_m: [[4, 0, 7, 3]]
    furniture:
      - {category: bed, position_m: [5.8, 1.5, 0], yaw_deg: 180, width_m: [0.8, 1.7]}
openings:
  - {kind: front_door, center_m: [1, 0], along: x}
  - {kind: door, center_m: [4, 0.7], along: y}
"""

DRESSER = "{category: dresser, model: dresser_01, position_m: [4.75, 0.7, 0]}"


def problems(tmp_path: Path, *changes: tuple[str, str]) -> list[str]:
    text = HUT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    file = tmp_path / "hut.yaml"
    file.write_text(text)
    try:
        check_drawings(load_catalog([file]), LIBRARY, [file])
    except InputError as error:
        assert all(line.startswith(f"{file}:") for line in error.problems)  # noqa: PT017
        return [line.removeprefix(f"{file}") for line in error.problems]
    return []


@pytest.mark.parametrize("home", CATALOG.homes, ids=lambda home: home.id)
def test_shipped_homes_are_sound(home) -> None:
    assert list(drawing_problems(home, CATALOG, LIBRARY)) == []


def test_the_hut_is_sound(tmp_path: Path) -> None:
    assert problems(tmp_path) == []


@pytest.mark.parametrize(
    ("old", "new", "line", "where", "what"),
    [
        (
            "[0.09, 2.0, 0]",
            "[-0.1, 2.0, 0]",
            8,
            "rooms[0].furniture[0].position_m",
            "stands outside",
        ),
        (
            "[0.09, 2.0, 0], against_wall: true",
            "[0.2, 2.0, 0]",
            8,
            "rooms[0].furniture[0]",
            "into a wall of 'stube'",
        ),
        ("[2.4, 1.6, 0]", "[0.8, 1.9, 0]", 9, "rooms[0].furniture[1]", "cuts into the fridge (fur"),
        ("[2, 2.91, 1.5]", "[2, 2.5, 1.5]", 10, "rooms[0].furniture[2]", "no wall is behind"),
        (
            "[2, 2.91, 1.5], yaw_deg: 270, against_wall: true",
            "[2, 2.2, 1.5], yaw_deg: 270",
            10,
            "rooms[0].furniture[2]",
            "hangs 1.5 m up, but no wall is behind its back",
        ),
        (
            "[2, 2.91, 1.5]",
            "[2, 2.91, 2.58]",
            10,
            "rooms[0].furniture[2]",
            "the ceiling is at 2.6 m",
        ),
        (
            "plant_pot_01",
            "plant_pott_01",
            11,
            "rooms[0].furniture[3]",
            "no model 'plant_pott_01' of plant_pot (did you mean 'plant_pot_01'?)",
        ),
        ("plant_pot_01", "fridge_01", 11, "rooms[0].furniture[3]", "no model 'fridge_01' of plant"),
        ("[0.8, 1.7]", "[3, 4]", 16, "rooms[1].furniture[0]", "is as wide as width_m says"),
        ("[2.4, 1.6, 0]", "[3.3, 0.7, 0]", 9, "rooms[0].furniture[1]", "kitchen_table"),
    ],
)
def test_a_mistake_is_told_at_its_place(
    old: str, new: str, line: int, where: str, what: str, tmp_path: Path
) -> None:
    (told,) = problems(tmp_path, (old, new))[:1]
    assert told.startswith(f":{line}: {where}: ")
    assert what in told


def test_all_mistakes_are_told_at_once(tmp_path: Path) -> None:
    told = problems(
        tmp_path,
        ("[0.09, 2.0, 0], against_wall: true", "[0.2, 2.0, 0]"),
        ("[2, 2.91, 1.5]", "[2, 2.5, 1.5]"),
        ("plant_pot_01", "plant_pott_01"),
        ("[0.8, 1.7]", "[3, 4]"),
    )
    assert [line.split(":")[1] for line in told] == ["8", "10", "11", "16"]


def test_optional_pieces_may_share_a_place_but_not_a_needed_one(tmp_path: Path) -> None:
    pot = "- {category: plant_pot, model: plant_pot_01, position_m: [3.4, 2.4, 0], optional: true}"
    twice = pot + "\n      " + pot.replace("plant_pot, model: plant_pot_01", "floor_lamp")
    assert problems(tmp_path, (pot, twice)) == []
    (told,) = problems(tmp_path, (pot, twice.replace(", optional: true", "", 1)))
    assert "floor_lamp" in told
    assert "cuts into the plant_pot" in told


def test_what_stands_on_a_piece_needs_it(tmp_path: Path) -> None:
    pot = "- {category: plant_pot, model: plant_pot_01, position_m: [3.4, 2.4, 0], optional: true}"
    on = pot + "\n      - {category: microwave, position_m: [2.4, 1.6, 0], on: kitchen_table}"
    assert problems(tmp_path, (pot, on)) == []


def test_a_room_that_furniture_cuts_off(tmp_path: Path) -> None:
    told = problems(
        tmp_path,
        ("[[4, 0, 7, 3]]", "[[4, 0, 7, 1.4]]"),
        ("{category: bed, position_m: [5.8, 1.5, 0], yaw_deg: 180, width_m: [0.8, 1.7]}", DRESSER),
    )
    assert any("furniture leaves no way 0.5 m wide to room 'kammer'" in line for line in told), told
