"""Things put aside on a floor stand at a wall, along it; others lie anywhere that takes them."""

import itertools
import math

import pytest
from sdgen.home.ground import ASIDE_M, Ground, walls_of
from sdgen.seeding import lane
from shapely.affinity import rotate
from shapely.geometry import MultiPolygon, Point, Polygon, box

#: An L, drawn clockwise.
ROOM = Polygon([(0, 0), (0, 4), (2, 4), (2, 2), (5, 2), (5, 0)])
ASIDE = Ground(ROOM, None, walls_of(ROOM))


def footprint(size, point, yaw):
    x, y = point
    flat = box(x - size[0] / 2, y - size[1] / 2, x + size[0] / 2, y + size[1] / 2)
    return rotate(flat, yaw, use_radians=True)


def drawn(ground, size, looked_at=False, times=200):
    rng = lane(0, 0, "ground")
    for _ in range(times):
        found = ground.draw(size, looked_at, rng)
        assert found is not None
        print_ = footprint(size, *found)
        if ground.takes(print_, *found, looked_at):
            yield print_, *found


@pytest.mark.parametrize("size", [(0.9, 0.1, 0.1), (0.1, 0.9, 0.1), (0.3, 0.25, 0.2), (0.05,) * 3])
def test_what_is_put_aside_stands_at_a_wall(size):
    seen = list(drawn(ASIDE, size))
    assert len(seen) > 100
    for print_, _, _ in seen:
        # Past the corner that juts into the room, the near end of what lies askew is in the air.
        assert print_.distance(ROOM.exterior) <= ASIDE_M[1] + 0.06
    sides = {min(range(6), key=lambda k: print_.distance(edges()[k])) for print_, _, _ in seen}
    assert sides == set(range(6)), "at every wall"


def edges():
    corners = list(ROOM.exterior.coords)
    return [Polygon([a, b, b]).exterior for a, b in itertools.pairwise(corners)]


def test_what_is_long_lies_along_the_wall():
    for size in ((0.9, 0.1, 0.1), (0.1, 0.9, 0.1)):
        for print_, _, _ in drawn(ASIDE, size):
            far = max(Point(corner).distance(ROOM.exterior) for corner in print_.exterior.coords)
            assert far < 0.6, "one end sticks out into the room"


def test_what_is_looked_at_faces_the_room():
    for _, (x, y), yaw in drawn(ASIDE, (0.3, 0.3, 0.4), looked_at=True):
        assert ROOM.covers(Point(x + 0.6 * math.cos(yaw), y + 0.6 * math.sin(yaw)))


def test_walls_that_are_taken_are_left_out():
    free = box(0, 3, 5, 4)
    ground = Ground(ROOM, None, walls_of(ROOM).intersection(free))
    for print_, _, _ in drawn(ground, (0.2, 0.2, 0.2)):
        assert print_.distance(free) < 0.2
    nothing = Ground(ROOM, None, walls_of(ROOM).difference(ROOM.buffer(0.1)))
    assert nothing.draw((0.2, 0.2, 0.2), False, lane(0, 0, "ground")) is None


def test_floor_without_room_has_no_spot():
    assert Ground(ROOM, MultiPolygon()).draw((0.2,) * 3, False, lane(0, 0, "x")) is None


def test_long_things_lie_square_to_the_room_wherever_they_are():
    """Or how an umbrella is turned would tell one in the way from one that is put aside."""
    for ground in (ASIDE, Ground(ROOM, ROOM.buffer(-0.1))):
        turned = [math.sin(2 * yaw) for _, _, yaw in drawn(ground, (0.9, 0.1, 0.1))]
        assert max(map(abs, turned)) < 0.8
