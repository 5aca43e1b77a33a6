"""Walls close the rooms except where openings are, and openings know their rooms."""

import itertools

import pytest
from sdgen.catalog.records import HomeSpec
from sdgen.home.shell import build_shell
from sdgen.home.style import HomeStyle
from sdgen.seeding import lane
from shapely.geometry import Polygon, box

from tests.shipped import shipped_library

BASE = HomeSpec.model_validate(
    {
        "id": "two_rooms",
        "title": "two rooms",
        "rooms": [
            {"name": "kitchen", "type": "kitchen", "rectangles_m": [(0, 0, 4, 3)]},
            {"name": "hall", "type": "hall", "rectangles_m": [(4, 0, 6, 3), (4, 3, 6, 5)]},
            {"name": "bath", "type": "bathroom", "rectangles_m": [(0, 3, 4, 5)]},
        ],
        "openings": [
            {"kind": "door", "center_m": (4, 1.5), "along": "y"},
            {"kind": "front_door", "center_m": (5, 0), "along": "x"},
            {"kind": "window", "center_m": (0, 1.5), "along": "y", "sill_m": 0.9},
            {"kind": "window", "center_m": (0, 4), "along": "y", "sill_m": 1.4, "small": True},
            {"kind": "door", "center_m": (4, 4), "along": "y", "hinge_flip": True},
        ],
    }
)


@pytest.fixture(scope="module")
def home():
    return build_shell(
        BASE, HomeStyle(), shipped_library(), itertools.count(1), lane(0, 0, "shell")
    )


def test_rooms_are_the_rectangles_less_half_a_wall(home):
    areas = [Polygon(r.polygon_m).area for r in home.rooms]
    assert areas == pytest.approx([3.88 * 2.88, 1.88 * 4.88, 3.88 * 1.88])


def test_openings_know_their_rooms(home):
    kitchen, hall, bath = (r.id for r in home.rooms)
    rooms = [o.room_ids for o in home.openings]
    assert [set(r) for r in rooms] == [{kitchen, hall}, {hall}, {kitchen}, {bath}, {hall, bath}]
    assert rooms[0] == (kitchen, hall)
    assert rooms[4] == (bath, hall)  # flipped: opens into the bathroom


@pytest.mark.parametrize("height", [0.02, 1.2, 2.0, 2.4])
def test_the_wall_ring_is_closed_except_for_openings(home, height):
    for room in home.rooms:
        pieces = [
            box(
                p.center_m[0] - p.size_m[0] / 2,
                p.center_m[1] - p.size_m[1] / 2,
                p.center_m[0] + p.size_m[0] / 2,
                p.center_m[1] + p.size_m[1] / 2,
            )
            for s in home.structures
            if s.room_id == room.id and s.category == "wall"
            for p in s.pieces
            if abs(p.center_m[2] - height) < p.size_m[2] / 2
        ]
        outline = Polygon(room.polygon_m)
        ring = outline.buffer(0.05, join_style="mitre").difference(outline)
        covered = sum(ring.intersection(p).area for p in pieces)
        gaps = sum(
            o.width_m * 0.05
            for o in home.openings
            if room.id in o.room_ids and o.center_m[2] < height < o.center_m[2] + o.height_m
        )
        overlap = 4 * 0.05 * 0.05 * 2  # corners may be covered by both walls that meet there
        assert covered == pytest.approx(ring.area - gaps, abs=overlap)
        assert not any(outline.buffer(-1e-6).intersects(p) for p in pieces)


def test_ids_are_unique(home):
    ids = [r.id for r in home.rooms] + [s.id for s in home.structures]
    ids += [o.object_id for o in home.openings]
    assert len(ids) == len(set(ids))
