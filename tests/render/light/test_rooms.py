"""Light against what can be reckoned by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sdgen.geometry import Vec3
from sdgen.library import Library
from sdgen.render.light.home_light import light_of_home
from sdgen.render.raster.drawn import drawn_parts
from sdgen.scene import Box, Daylight, Scene, Structure

from tests.fakes import box_room, thing

pytest.importorskip("embreex")

NIGHT, NOON = Daylight(time="night"), Daylight(sun_azimuth_deg=0.0, sun_elevation_deg=45.0)


def at(scene: Scene, daylight: Daylight) -> Scene:
    return scene.model_copy(update={"home": scene.home.model_copy(update={"daylight": daylight})})


def open_to_the_east(scene: Scene) -> Scene:
    """The room without the wall at x = 2 (id 4)."""
    walls = tuple(one for one in scene.home.structures if one.id != 4)
    return scene.model_copy(update={"home": scene.home.model_copy(update={"structures": walls})})


def cube_at(library: Library, scene: Scene, place: Vec3) -> np.ndarray:
    """Light at a place from its six sides, (6, 3)."""
    (room,) = light_of_home(library, scene, drawn_parts(library, scene)).rooms
    cell = np.floor((np.array(place) - room.corner_m) / room.cell_m).astype(int)
    return np.asarray(room.cube[tuple(cell)], dtype=float)


def test_a_shut_room_is_dark_however_the_sun_stands(library: Library) -> None:
    for azimuth in (0.0, 45.0, 133.0, 270.0):
        daylight = Daylight(sun_azimuth_deg=azimuth, sun_elevation_deg=30.0)
        scene = at(box_room(), daylight)
        light = light_of_home(library, scene, drawn_parts(library, scene))
        assert light.rooms[0].cube.max() < 0.04
        bright = light_of_home(
            library,
            at(open_to_the_east(scene), NOON),
            drawn_parts(library, open_to_the_east(scene)),
        )
        assert bright.rooms[0].cube.max() > 1.0


def test_a_lamp_lights_as_the_square_of_how_far_it_is(library: Library) -> None:
    """In a wide hall with black walls: what comes from above, below the lamp."""
    lamp = thing(60, "ceiling_lamp_91", (0.0, 0.0, 3.8), fixed=True)
    scene = at(box_room([lamp], size_m=(9.0, 9.0), height_m=4.0), NIGHT)
    light = light_of_home(library, scene, drawn_parts(library, scene))
    assert len(light.rooms) == 1
    dark = at(box_room([], size_m=(9.0, 9.0), height_m=4.0), NIGHT)
    near, far = (cube_at(library, scene, (0.1, 0.1, z))[4, 0] for z in (2.6, 0.4))
    without = cube_at(library, dark, (0.1, 0.1, 2.6))[4, 0]
    assert without < 0.05
    # Walls and floor give some back to both.
    assert 3.0 < near / far < (3.45 / 1.25) ** 2 + 0.5


def test_light_falls_off_from_an_open_side(library: Library) -> None:
    scene = at(open_to_the_east(box_room(size_m=(8.0, 4.0))), NOON)
    lights = [cube_at(library, scene, (x, 0.0, 1.2))[0].mean() for x in (3.6, 1.5, -1.0, -3.4)]
    assert lights == sorted(lights, reverse=True)
    assert lights[0] > 4 * lights[-1]


def test_what_is_large_and_fixed_shades_what_is_under_it(library: Library) -> None:
    table = thing(10, "table_01", (0.0, 0.0, 0.0), fixed=True)
    lamp = thing(60, "ceiling_lamp_91", (0.0, 0.0, 2.39), fixed=True)
    bare, under = (
        cube_at(library, at(box_room(some), NIGHT), (0.2, 0.2, 0.4))[4].mean()
        for some in ([lamp], [lamp, table])
    )
    assert under < 0.75 * bare


def test_what_is_not_fixed_changes_no_light(library: Library) -> None:
    """Light tells nothing of what lies about."""
    lamp = thing(60, "ceiling_lamp_91", (0.0, 0.0, 2.39), fixed=True)
    loose = [thing(10, "table_01", (0.0, 0.0, 0.0)), thing(11, "cube_01", (1.0, 1.0, 0.0))]
    opened = thing(12, "cabinet_01", (-1.2, 0.0, 0.0), fixed=True, joints={"door": -1.5})
    shut = opened.model_copy(update={"joints": {}})
    cubes = [
        light_of_home(library, scene, drawn_parts(library, scene)).rooms[0].cube
        for scene in (
            at(box_room([lamp, shut]), NIGHT),
            at(box_room([lamp, opened, *loose]), NIGHT),
        )
    ]
    assert np.array_equal(*cubes)


def test_the_sun_is_stopped_by_half_a_roof(library: Library) -> None:
    """Over the west half of an open floor a slab at 2 m: from the east at 45 degrees its shadow
    lies 2 m further west."""
    base = box_room(size_m=(8.0, 8.0))
    slab = Box(center_m=(0.0, 0.0, 2.0), size_m=(2.0, 8.0, 0.05))
    floor = base.home.structures[0]
    roof = Structure(id=9, category="wall", room_id=1, surface="w", pieces=(slab,))
    home = base.home.model_copy(update={"structures": (floor, roof), "daylight": NOON})
    scene = base.model_copy(update={"home": home})
    sun = light_of_home(library, scene, drawn_parts(library, scene)).sun
    assert sun is not None
    x = np.array([-3.5, -2.8, -2.0, -1.2, -0.7, 0.5, 2.0])
    points = np.column_stack([x, np.zeros_like(x), np.zeros_like(x)])
    up = np.tile((0.0, 0.0, 1.0), (len(x), 1))
    lit = sun.shines(points, up)
    wanted = [0.0 if -3.0 < k < -1.0 else math.sqrt(0.5) for k in x]
    assert lit == pytest.approx(wanted, abs=1e-6)


def test_even_light_is_the_same_everywhere(
    library: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sdgen.render.light.home_light.HAS_RAYS", False)
    light = light_of_home(library, box_room(), [])
    assert light.sun is None
    cube = light.rooms[0].cube
    assert (cube == cube[0, 0, 0]).all()
    assert cube[0, 0, 0, 4, 0] > cube[0, 0, 0, 5, 0]
