"""Near views look at places from usual eyes, and onto high ones from lifted eyes; overviews at
rooms."""

import numpy as np
import pytest
from sdgen.cameras.posts import candidates
from sdgen.cameras.spots import Spots
from sdgen.cameras.view import HEIGHT_JITTER_M
from sdgen.library import Library
from sdgen.options import EYE_HEIGHT_M
from sdgen.seeding import lane
from shapely.geometry import box

from tests.fakes import box_room


@pytest.mark.parametrize(
    ("height_m", "lifted_m"), [(0.04, 0.0), (0.94, 0.0), (1.35, 0.4), (1.55, 0.6), (1.9, 0.6)]
)
def test_eyes_are_lifted_to_look_onto_high_places_alone(
    library: Library, height_m: float, lifted_m: float
) -> None:
    spots = Spots(np.array([[0.0, 0.0, height_m]]), np.array([7]), (), np.ones(1))
    views = candidates(library, (), box(-3, -3, 3, 3), spots, lane(0, 0, "views"))
    heights = [view.eye_m[2] - EYE_HEIGHT_M - lifted_m for view in views]
    assert len(heights) > 100
    assert max(map(abs, heights)) <= HEIGHT_JITTER_M
    assert np.ptp(heights) > HEIGHT_JITTER_M


def test_overviews_show_walls_too(library: Library) -> None:
    """However near a room's middle is, the picture's upper edge is above the horizon."""
    (room,) = box_room([]).home.rooms
    none = Spots(np.empty((0, 3)), np.empty(0, dtype=np.int64), (), np.empty(0))
    for half_m in (0.8, 2.0):
        free = box(-half_m, -half_m, half_m, half_m)
        views = candidates(library, [room], free, none, lane(0, 0, "views"))
        assert len(views) > 3
        assert {view.overview_of for view in views} == {room.id}
        ahead = np.array([view.world_from_camera[:3, 2] for view in views])
        assert (ahead[:, 2] / np.hypot(ahead[:, 0], ahead[:, 1])).min() > -0.3
