"""What lies in a catalogue's folder is read, is words for people, or is told."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog

from .worlds import HAZARD, problems, write


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("hazard/x.yaml", "hazard: no folder of a catalogue (did you mean 'hazards'?)"),
        ("Hazards/x.yaml", "Hazards: no folder of a catalogue (did you mean 'hazards'?)"),
        ("pictures/x.png", "pictures: no folder of a catalogue (one of: activities, categories,"),
        ("hazards/more/x.yaml", "hazards/more: folders in it are not read; move its files up"),
        ("hazards/x.yamll", "hazards/x.yamll: no file of a catalogue: its name does not end in"),
        ("hazards/x.YAML", "hazards/x.YAML: no file of a catalogue: its name does not end in"),
        ("hazards/x.json", "hazards/x.json: no file of a catalogue: its name does not end in"),
        ("room.yaml", "room.yaml: no file of a catalogue (did you mean 'rooms.yaml'?)"),
        ("rooms.yaml.bak", "rooms.yaml.bak: no file of a catalogue: its name does not end in"),
    ],
)
def test_what_would_not_be_read_is_told(tmp_path: Path, name: str, told: str) -> None:
    folder = write(tmp_path, hazards__wobbly_vase=HAZARD)
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).write_text("x: 1\n")
    (found,) = problems(folder)
    assert found.startswith(f"{folder}/{told}")


@pytest.mark.parametrize(
    "name",
    [
        "README.md",
        "LICENSE",
        "hazards/notes.txt",
        ".git/x.yaml",
        "_old/x.yaml",
        "hazards/.x.yaml",
        "hazards/_draft.yaml",
    ],
)
def test_words_for_people_and_what_is_set_aside_are_left_alone(tmp_path: Path, name: str) -> None:
    folder = write(tmp_path, hazards__wobbly_vase=HAZARD)
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).write_text("x: 1\n")
    assert load_catalog([folder]).hazard("wobbly_vase")


def test_an_id_is_taken_once_whatever_the_pack(tmp_path: Path) -> None:
    one = write(tmp_path / "one", hazards__wobbly_vase=HAZARD)
    two = write(tmp_path / "two", hazards__wobbly_vase=HAZARD)
    (found,) = problems(one, two)
    assert found.startswith(f"{two}/hazards/wobbly_vase.yaml:1: hazard 'wobbly_vase' is already")
    assert f"{one}/hazards/wobbly_vase.yaml:1 (to replace it add 'replaces: true')" in found
    write(two, hazards__wobbly_vase=HAZARD + "replaces: true\n")
    assert load_catalog([one, two]).hazard("wobbly_vase").pack == "two"
    (found,) = problems(two)
    assert ":16: replaces: there is no hazard 'wobbly_vase' to replace" in found
    # Nor twice in one folder.
    (one / "hazards" / "wobbly_vase.yml").write_text(HAZARD)
    (found,) = problems(one)
    assert "hazard 'wobbly_vase' is already defined" in found


@pytest.mark.parametrize(
    "text",
    [
        "den: {floor_clutter: [0, 1], clutter: {}, like: den}\n",
        "den: {floor_clutter: [0, 1], clutter: {}, like: loft}\n"
        "loft: {floor_clutter: [0, 1], clutter: {}, like: den}\n",
        "den: {floor_clutter: [0, 1], clutter: {}, like: corridor}\n",
    ],
    ids=["itself", "a circle", "a chain"],
)
def test_room_types_are_like_one_that_is_its_own(tmp_path: Path, text: str) -> None:
    found = problems(write(tmp_path, rooms=text))
    assert "like: " in found[0]
    assert "is like another room type itself: name that one, or none" in found[0]
