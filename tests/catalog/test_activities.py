"""Activities: read into records, mistakes located, what would be a hazard refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.errors import InputError

CATALOG = load_catalog()

MINE = """cards:
  at: coffee_table
  where: middle
  tidiness: [0, 0.5]
  members:
    - {thing: puzzle_box, at: [0, 0], needed: true}
    - {thing: mug, beside: puzzle_box, side: left}
"""


def write(folder: Path, text: str) -> None:
    (folder / "activities").mkdir()
    (folder / "activities" / "mine.yaml").write_text(text)


def problems(folder: Path, text: str) -> str:
    write(folder, text)
    with pytest.raises(InputError) as caught:
        load_catalog([folder])
    return "\n".join(caught.value.problems)


def test_every_room_type_has_activities() -> None:
    assert len(CATALOG.activities) >= 25
    for room in CATALOG.room_types:
        here = [a.name for a in CATALOG.activities if not a.rooms or room.name in a.rooms]
        assert len(here) >= 2, room.name


def test_an_activity_of_ones_own_is_added(tmp_path: Path) -> None:
    write(tmp_path, MINE)
    (mine,) = (a for a in load_catalog([tmp_path]).activities if a.name == "cards")
    assert mine.at == ("coffee_table",)
    assert mine.tidiness == (0.0, 0.5)
    assert [member.called for member in mine.members] == ["puzzle_box", "mug"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (MINE.replace("puzzle_box, at", "puzle_box, at"), "did you mean 'puzzle_box'"),
        (MINE.replace("middle", "midle"), "mine.yaml:3: cards.where"),
        (MINE.replace("middle", "floor"), "'where: floor' has no 'at'"),
        (MINE.replace("  at: coffee_table\n", ""), "missing key 'at'"),
        (MINE.replace("beside: puzzle_box", "beside: mat"), "no member before it is called 'mat'"),
        (MINE.replace("beside:", "on: puzzle_box, beside:"), "it has one place"),
        (MINE.replace("[0, 0.5]", "[0, 2]"), "is not between 0 and 1"),
        (MINE + "  rooms: [balcny]\n", "unknown room type 'balcny'"),
        (MINE + "  excludes: [breakfst]\n", "did you mean 'breakfast'"),
        ("breakfast: {at: desk, members: [{thing: mug}]}", "is already defined"),
    ],
)
def test_mistakes_are_located(tmp_path: Path, text: str, said: str) -> None:
    assert said in problems(tmp_path, text)


def test_what_would_be_a_hazard_is_refused(tmp_path: Path) -> None:
    said = problems(tmp_path, "mine: {at: desk, members: [{thing: candle, state: ON}]}")
    assert "mine.members[0]" in said
    assert "satisfies the hazard" in said
