"""Furniture rules and mixes of rooms: read into records, mistakes located."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.errors import InputError

CATALOG = load_catalog()


def problems(folder: Path, name: str, text: str) -> str:
    (folder / name).write_text(text)
    with pytest.raises(InputError) as caught:
        load_catalog([folder])
    return "\n".join(caught.value.problems)


def room(rules: str) -> str:
    return f"den:\n  floor_clutter: [0, 1]\n  clutter: {{desk: [1, 2]}}\n  furniture:\n{rules}"


def test_shipped_rules_name_what_can_be_placed():
    types = {t.name: t for t in CATALOG.room_types}
    kitchen = types["kitchen"].furniture
    assert kitchen[0].where == "run"
    assert {"stove", "sink_cabinet"} <= set(kitchen[0].row)
    kinds = {c.name: c.kind for c in CATALOG.categories}
    for room_type in CATALOG.room_types:
        assert room_type.furniture, room_type.name
        for rule in room_type.furniture:
            for name in (rule.category, *rule.row):
                assert not name or kinds[name] in ("furniture", "small"), name


def test_mixes_are_of_three_to_ten_rooms_with_a_kitchen_and_a_bathroom():
    assert {1 + len(mix.rooms) for mix in CATALOG.mixes} == set(range(3, 11))
    for mix in CATALOG.mixes:
        assert {"kitchen", "bathroom", "bedroom"} <= {mix.hub, *mix.rooms}


def test_a_room_type_and_a_mix_of_ones_own(tmp_path):
    (tmp_path / "rooms.yaml").write_text(
        room("    - {category: desk, where: wall, needed: true}\n")
        + "    - {category: chair, where: before, of: desk, gap_m: -0.2}\n"
        + "  area_m2: [6, 9]\n"
    )
    (tmp_path / "mixes.yaml").write_text("with_den: {hub: hall, rooms: [den, kitchen, bathroom]}\n")
    catalog = load_catalog([tmp_path])
    den = next(t for t in catalog.room_types if t.name == "den")
    assert den.area_m2 == (6.0, 9.0)
    assert [rule.where for rule in den.furniture] == ["wall", "before"]
    assert any(mix.name == "with_den" and mix.weight == 1.0 for mix in catalog.mixes)


def test_what_holds_in_a_room_type_holds_in_those_like_it(tmp_path):
    (tmp_path / "rooms.yaml").write_text(
        room("    - {category: desk, where: wall}\n") + "  like: office\n"
    )
    catalog = load_catalog([tmp_path])
    plain = {c.name: c for c in CATALOG.categories}
    named = 0
    for category in catalog.categories:
        for mine, theirs in zip(category.lives, plain[category.name].lives, strict=True):
            added = {"den"} if "office" in theirs.rooms else set()
            assert set(mine.rooms) == {*theirs.rooms} | added
            named += "den" in mine.rooms
    assert named > 10


@pytest.mark.parametrize(
    ("off", "said"),
    [
        ("{den: hall}", "no den is among its rooms"),
        ("{bedroom: office}", "this home has no office"),
        ("{bedroom: kitchen, kitchen: bedroom}", "goes round in a circle: bedroom from kitchen"),
        ("{bedroom: bedroom}", "goes round in a circle"),
        ("{bedrom: hall}", "did you mean 'bedroom'"),
    ],
)
def test_rooms_that_open_from_nowhere_are_told(tmp_path, off, said):
    (tmp_path / "rooms.yaml").write_text(room("    - {category: desk, where: wall}\n"))
    mix = f"mine: {{hub: hall, rooms: [kitchen, bedroom, bathroom], off: {off}}}\n"
    (tmp_path / "mixes.yaml").write_text(mix)
    assert said in problems(tmp_path, "mixes.yaml", mix)


@pytest.mark.parametrize(
    ("rule", "said"),
    [
        ("{category: dessk, where: wall}", "did you mean 'desk'"),
        ("{category: desk, where: walll}", "'walll' is not one of"),
        ("{category: chair, where: before, of: bed}", "no bed is placed before it"),
        ("{category: chair, where: before}", "of"),
        ("{where: row, row: [desk, dessk]}", "unknown category 'dessk'"),
        ("{where: row}", "row"),
        ("{category: desk, where: wall, count: [0.5, 2]}", "whole numbers"),
        ("{category: desk, where: wall, chance: 2}", "not between 0 and 1"),
        ("{category: desk, where: wall, colour: red}", "unknown key"),
        (
            "{where: row, row: [desk, chair], near: desk}",
            "does not go with 'where: row'",
        ),
        ("{category: desk, where: wall, corner: chair}", "does not go with 'where: wall'"),
    ],
)
def test_mistakes_in_rules_are_located(tmp_path, rule, said):
    found = problems(tmp_path, "rooms.yaml", room(f"    - {rule}\n"))
    assert said in found
    assert "rooms.yaml:5" in found


def test_mistakes_in_mixes_are_located(tmp_path):
    found = problems(tmp_path, "mixes.yaml", "mine: {hub: halll, rooms: [kitchen, barn]}\n")
    assert "mixes.yaml:1" in found
    assert "unknown room type 'barn'" in found
    assert "halll" in found


@pytest.mark.parametrize("alone", [False, True])
def test_a_file_of_mixes_under_its_old_name_is_told_the_new_one(tmp_path, alone):
    text = "mine: {hub: hall, rooms: [kitchen, bathroom]}\n"
    path = tmp_path / "plans.yaml"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        load_catalog([path if alone else tmp_path])
    assert caught.value.problems == (f"{path}: is called mixes.yaml now: rename it",)
    path.rename(path.with_name("mixes.yaml"))
    assert any(mix.name == "mine" for mix in load_catalog([tmp_path]).mixes)
