"""What stands around homes: never within them, lit by the sun, hidden by what is nearer."""

import numpy as np
import pytest
from sdgen.render.backdrop.boxes import paint_block
from sdgen.render.backdrop.builder import Builder
from sdgen.render.backdrop.canvas import COLUMNS, Canvas, linear, noise
from sdgen.render.backdrop.facades import Cabin, Plain
from sdgen.render.backdrop.far import paint_hills
from sdgen.render.backdrop.light import light_of
from sdgen.render.backdrop.places import place_random
from sdgen.render.backdrop.plants import Tree, crowns, paint_tree
from sdgen.render.backdrop.solids import Block
from sdgen.scene import Outdoors
from sdgen.vocabulary import SEASONS

GRAIN = noise(np.random.default_rng(1), 256, 0.3)
GREY, ROOF = linear(160, 160, 160), linear(160, 60, 40)


def house(x: float, colour=GREY, high: float = 6.0, slope: float = 0.0) -> Block:
    return Block((x, -5.0), (x + 8.0, 5.0), high, Plain(colour), ROOF, slope, 1)


def column(azimuth_deg: float) -> int:
    return int(azimuth_deg / 360 * COLUMNS)


def test_a_wall_is_brighter_on_the_side_of_the_sun():
    seen = []
    for azimuth in (np.pi, 0.0):
        canvas = Canvas(1.5)
        paint_block(canvas, light_of("day", "clear", azimuth, 0.6), house(20.0), GRAIN)
        there = np.isfinite(canvas.far_m[:, column(1)])
        seen.append(canvas.colours[there, column(1)].mean())
    assert seen[0] > 1.5 * seen[1]


def test_the_nearer_hides_the_farther_in_any_order():
    light = light_of("day", "overcast", 0.0, 0.6)
    blocks = [house(20.0, linear(200, 40, 40)), house(60.0, linear(40, 40, 200), 9.0)]
    pictures = []
    for order in (blocks, blocks[::-1]):
        canvas = Canvas(1.5)
        for block in order:
            paint_block(canvas, light, block, GRAIN)
        pictures.append(canvas.colours)
    assert np.allclose(*pictures, atol=1e-4)
    level = int(np.argmin(np.abs(canvas.climbs)))
    assert canvas.far_m[level, column(1)] == pytest.approx(20.0, abs=0.1)


@pytest.mark.parametrize(("eye_m", "front", "behind"), [(1.5, True, False), (20.0, True, True)])
def test_a_roof_shows_the_slope_towards_the_eye_and_from_above_the_other(eye_m, front, behind):
    canvas = Canvas(eye_m)
    # A ridge across the view, 24 m away.
    paint_block(canvas, light_of("day", "clear", 0.0, 0.6), house(20.0, slope=0.4), GRAIN)
    far = canvas.far_m[:, column(1)]
    far = far[np.isfinite(far)]
    assert ((far > 20.2) & (far < 23.8)).any() == front
    assert ((far > 24.2) & (far < 27.8)).any() == behind


def test_a_tree_stands_where_it_is_and_is_as_high_as_it_is():
    canvas = Canvas(1.5)
    canvas.haze_m = 1e9
    crown = crowns("summer", False, np.random.default_rng(2))[0]
    paint_tree(canvas, light_of("day", "clear", 1.0, 0.6), Tree((0.0, 20.0), 8.0, crown))
    rows, columns = np.nonzero(np.isfinite(canvas.far_m))
    assert abs(columns.mean() - column(90)) < 12
    assert canvas.climbs[rows.min()] == pytest.approx(6.5 / 20, abs=0.03)
    assert canvas.climbs[rows.max()] == pytest.approx(-1.5 / 20, abs=0.02)


@pytest.mark.parametrize("season", SEASONS)
@pytest.mark.parametrize("storey", [0, 1, 5])
def test_nothing_stands_in_the_home_and_all_are_finite(storey, season):
    for seed in range(6):
        rng = np.random.default_rng(seed)
        place = place_random(Outdoors(storey=storey, season=season), rng)
        assert len(place.blocks) > 20
        assert len(place.trees) > 8
        for thing in (*place.blocks, *place.trees):
            assert thing.away_m > 6.0


@pytest.mark.parametrize("storey", [0, 5])
def test_by_night_far_hills_have_lights_and_by_day_none(storey):
    outdoors = Outdoors(storey=storey, season="summer")
    place = place_random(outdoors, np.random.default_rng(1))
    place.sea = 0.0
    counts = {}
    for time in ("day", "night"):
        canvas = Canvas(1.5 + 2.9 * storey)
        light = light_of(time, "clear", 0.0, 0.6)
        paint_hills(canvas, light, place, "summer", np.random.default_rng(3))
        hills = canvas.colours[np.isfinite(canvas.far_m)]
        counts[time] = int((hills[:, 0] > 1.5 * hills[:, 2] + 0.1).sum())
    assert counts["day"] == 0
    assert counts["night"] > 100


def test_of_a_car_one_sees_windows_over_its_body_only():
    builder = Builder(Outdoors(season="summer"), np.random.default_rng(4))
    builder.car(12.0, 0.0)
    cabins = [block for block in builder.place.blocks if isinstance(block.painter, Cabin)]
    bodies = [block for block in builder.place.blocks if 0 < block.foot_m < 0.5]
    assert [cabin.foot_m for cabin in cabins] == [pytest.approx(bodies[0].wall_m, abs=0.05)]
