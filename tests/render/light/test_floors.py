"""Shade on floors against what stands there."""

from __future__ import annotations

import numpy as np
import pytest
from sdgen.library import Library
from sdgen.render.light.home_light import light_of_home
from sdgen.render.raster.drawn import drawn_parts
from sdgen.scene import Daylight, Scene

from tests.fakes import box_room, thing

pytest.importorskip("embreex")

LAMP = thing(60, "ceiling_lamp_91", (0.0, 0.0, 2.39), fixed=True)


def night(*things) -> Scene:
    scene = box_room(things)
    home = scene.home.model_copy(update={"daylight": Daylight(time="night")})
    return scene.model_copy(update={"home": home})


def shade_at(library: Library, scene: Scene, *places: tuple[float, float]) -> list[float]:
    """The share of its light that the floor gets at these places (x, y)."""
    from sdgen.render.light.floors import STEP_M

    shade = light_of_home(library, scene, drawn_parts(library, scene)).floor
    assert shade is not None
    cells = [np.rint((np.array(one) - shade.corner_m) / STEP_M).astype(int) for one in places]
    return [float(shade.share[row, column]) for column, row in cells]


def test_an_empty_floor_has_no_shade(library: Library) -> None:
    assert shade_at(library, night(LAMP), (0.0, 0.0), (1.5, 1.0)) == pytest.approx([1.0, 1.0])


def test_under_a_table_it_is_darker_than_beside_it_and_far_off_it_is_not(library: Library) -> None:
    table = thing(10, "table_01", (0.0, 0.0, 0.0), fixed=True)
    under, beside, far = shade_at(library, night(LAMP, table), (0.0, 0.0), (0.9, 0.0), (-1.8, -1.3))
    assert under < 0.5
    assert under < beside < far
    assert far > 0.9


def test_what_lies_about_throws_none(library: Library) -> None:
    """Shade tells nothing of what is not fixed."""
    loose = thing(10, "table_01", (0.0, 0.0, 0.0))
    assert shade_at(library, night(LAMP, loose), (0.0, 0.0)) == pytest.approx([1.0])
