"""The same two rooms of a stranger in every format: what becomes of them, and what is told."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from sdgen.catalog.home_text import home_text
from sdgen.catalog.load import load_catalog
from sdgen.home.drawing_check import check_drawings
from sdgen.importing.scenes.read import text_of
from sdgen.importing.scenes.to_home import Imported

from tests.importing.scenes.homes import (
    ROOMS,
    THINGS,
    imported,
    shape_of,
    write_glb,
    write_graph,
    write_mjcf,
)
from tests.shipped import shipped_library

#: VirtualHome writes its classes in one word, and no walls that tell anything.
GRAPH = {
    "floor_kitchen": ROOMS["floor_kitchen"],
    "floor_bedroom": ROOMS["floor_bedroom"],
    "fridge": THINGS["Fridge_01"],
    "kitchentable": THINGS["kitchen_table"],
    "bed": THINGS["bed.001"],
    "closet": THINGS["wardrobe (2)"],
    "spaceship": THINGS["Alien Artefact"],
}


def from_glb(folder: Path) -> Imported:
    return imported("gltf", write_glb(folder / "home.glb", {**ROOMS, **THINGS}))


def from_mjcf(folder: Path) -> Imported:
    return imported("mjcf", write_mjcf(folder / "home.xml", {**ROOMS, **THINGS}))


def from_graph(folder: Path) -> Imported:
    return imported("virtualhome", write_graph(folder / "home.json", GRAPH))


SCENES = {"gltf": from_glb, "mjcf": from_mjcf, "virtualhome": from_graph}


@pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)
def test_two_rooms_with_a_wall_between(make: Callable[[Path], Imported], tmp_path: Path) -> None:
    spec = make(tmp_path).spec
    assert {room.name.replace("floor_", ""): room.type for room in spec.rooms} == {
        "kitchen": "kitchen",
        "bedroom": "bedroom",
    }
    kitchen, bedroom = (
        next(shape_of(spec, r.name) for r in spec.rooms if r.type == kind)
        for kind in ("kitchen", "bedroom")
    )
    # Inner faces stay; of the wall between, 0.2 m thick, the middle does.
    assert np.allclose(kitchen.bounds, (-0.06, -0.06, 3.1, 4.06), atol=0.01)
    assert np.allclose(bedroom.bounds, (3.1, -0.06, 7.26, 4.06), atol=0.01)
    ways = {opening.kind for opening in spec.openings}
    assert "front_door" in ways
    assert ways & {"door", "passage"}


@pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)
def test_furniture_stands_where_it_stood(make: Callable[[Path], Imported], tmp_path: Path) -> None:
    made = make(tmp_path)
    found = {p.category: p for room in made.spec.rooms for p in room.furniture}
    assert set(found) == {"fridge", "kitchen_table", "bed", "wardrobe"}
    for name, category in (
        ("Fridge_01", "fridge"),
        ("kitchen_table", "kitchen_table"),
        ("bed.001", "bed"),
        ("wardrobe (2)", "wardrobe"),
    ):
        middle, _ = THINGS[name]
        at = found[category].position_m
        # Another model is a little deeper, and stands at the wall all the same.
        assert np.hypot(at[0] - middle[0], at[1] - middle[1]) < 0.2, category
        assert at[2] == 0
    # The fridge stands in the corner: its back to one of the walls, its front into the room.
    assert found["fridge"].yaw_deg % 360 in (0, 270)
    # And the wardrobe's back is to the wall behind it.
    assert found["wardrobe"].yaw_deg % 360 == 270


@pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)
def test_what_nobody_knows_is_told(make: Callable[[Path], Imported], tmp_path: Path) -> None:
    made = make(tmp_path)
    (line,) = made.unresolved
    assert line.startswith(("Alien Artefact: no category", "spaceship"))
    assert made.counts["found"] == 5
    assert any("front door" in line for line in made.told)


@pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)
def test_the_file_is_one_that_builds(make: Callable[[Path], Imported], tmp_path: Path) -> None:
    made = make(tmp_path)
    file = tmp_path / "mine.yaml"
    file.write_text(text_of(made, "gltf", Path("home.glb")))
    catalog = load_catalog([file])
    check_drawings(catalog, shipped_library(), [file])
    (home,) = (home for home in catalog.homes if home.id == "mine")
    assert home_text(home) == home_text(made.spec)
    assert "# Left out: " in file.read_text()


def test_the_doorway_between_walls_is_a_passage(tmp_path: Path) -> None:
    (way,) = (o for o in from_glb(tmp_path).spec.openings if o.kind in ("door", "passage"))
    # Walls leave 1 m of it open, from y = 1 to 2.
    assert (way.kind, way.along) == ("passage", "y")
    assert np.allclose(way.center_m, (3.1, 1.5), atol=0.01)


def test_walls_alone_tell_of_rooms(tmp_path: Path) -> None:
    closed = {**ROOMS, "wall_inner_a": ((3.1, 2.0, 1.3), (0.2, 4.0, 2.6))}
    walls = {name: block for name, block in closed.items() if name.startswith("wall")}
    del walls["wall_inner_b"]
    made = imported("mjcf", write_mjcf(tmp_path / "home.xml", {**walls, **THINGS}))
    assert sorted(room.type for room in made.spec.rooms) == ["bedroom", "kitchen"]
    assert any("rooms are what walls go round" in line for line in made.told)


def test_without_floors_and_walls_there_is_one_room_around_all(tmp_path: Path) -> None:
    made = imported("gltf", write_glb(tmp_path / "home.glb", THINGS))
    (room,) = made.spec.rooms
    assert shape_of(made.spec, room.name).area == pytest.approx(7.4 * 3.8, rel=0.1)
    assert any("one room was drawn around all things" in line for line in made.told)


def test_a_turned_home_is_turned_back(tmp_path: Path) -> None:
    text = write_mjcf(tmp_path / "home.xml", {**ROOMS, **THINGS}).read_text()
    turned = text.replace("<worldbody>", '<worldbody><frame euler="0 0 17">')
    (tmp_path / "home.xml").write_text(turned.replace("</worldbody>", "</frame></worldbody>"))
    made = imported("mjcf", tmp_path / "home.xml")
    assert any("turned by -17.00 degrees" in line for line in made.told)
    spec = made.spec
    areas = {room.type: shape_of(spec, room.name).area for room in spec.rooms}
    assert areas["kitchen"] == pytest.approx(3.16 * 4.12, rel=0.01)
    assert areas["bedroom"] == pytest.approx(4.16 * 4.12, rel=0.01)
    assert sum(len(room.furniture) for room in spec.rooms) == 4


def test_of_several_storeys_the_fullest_is_taken(tmp_path: Path) -> None:
    above = {
        "floor_attic": ((1.5, 2.0, 2.95), (3.0, 4.0, 0.1)),
        "nightstand": ((1.5, 2.0, 3.25), (0.4, 0.4, 0.5)),
    }
    made = imported("mjcf", write_mjcf(tmp_path / "home.xml", {**ROOMS, **THINGS, **above}))
    assert len(made.spec.rooms) == 2
    assert any("2 storeys" in line for line in made.told)
    assert any(line.startswith("nightstand: stands in another storey") for line in made.unresolved)


def test_names_of_strangers_leave_the_file_whole(tmp_path: Path) -> None:
    names = {
        'stool" \n- bad: [yes': THINGS["kitchen_table"],
        "Bett\u2028\x85 für Gäste \u202e": THINGS["bed.001"],
    }
    blocks = {name: ROOMS[name] for name in ROOMS} | names
    made = imported("gltf", write_glb(tmp_path / "home.glb", blocks))
    file = tmp_path / "mine.yaml"
    file.write_text(text_of(made, "gltf", Path("ho\nme.glb")), encoding="utf-8")
    assert any(home.id == "mine" for home in load_catalog([file]).homes)
