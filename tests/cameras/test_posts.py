"""Near views look at places and what is around them from usual eyes, and onto high ones from lifted
eyes."""

import numpy as np
import pytest
from sdgen.cameras.framing import framed
from sdgen.cameras.posts import near_views
from sdgen.cameras.spots import Spots
from sdgen.cameras.view import HEIGHT_JITTER_M, poses_of
from sdgen.library import Library
from sdgen.options import EYE_HEIGHT_M
from sdgen.seeding import lane
from shapely.geometry import box


@pytest.mark.parametrize(
    ("height_m", "lifted_m"), [(0.04, 0.0), (0.94, 0.0), (1.35, 0.4), (1.55, 0.6), (1.9, 0.6)]
)
def test_eyes_are_lifted_to_look_onto_high_places_alone(
    library: Library, height_m: float, lifted_m: float
) -> None:
    spots = Spots(np.array([[0.0, 0.0, height_m]]), np.array([7]), (), np.ones(1))
    free = box(-3, -3, 3, 3)
    views = near_views(library, free, spots, lambda _, place: place[None], lane(0, 0, "views"))
    heights = [view.eye_m[2] - EYE_HEIGHT_M - lifted_m for view in views]
    assert len(heights) > 100
    assert max(map(abs, heights)) <= HEIGHT_JITTER_M
    assert np.ptp(heights) > HEIGHT_JITTER_M


@pytest.mark.parametrize("height_m", [0.04, 0.78, 1.2])
def test_what_is_around_a_place_is_in_the_picture_wherever_that_is_aimed(
    library: Library, height_m: float
) -> None:
    """Its surface to one side of it, as of a cup at a table's edge; the place itself is not always
    in the middle."""
    place = np.array([0.5, 0.0, height_m])
    edges = np.array([[0.4, y, 0.0] for y in (-0.1, 0.5)] + [[-0.3, 0.3, 0.0]])
    spots = Spots(place[None], np.array([7]), (), np.ones(1))
    views = near_views(library, box(-3, -3, 3, 3), spots, lambda _, at: at + edges, lane(1, 0, "v"))
    assert len(views) > 100
    at = framed(poses_of(views), np.concatenate([place[None], place + edges]))
    assert at.inside[:, 0].all()
    assert at.inside.all(axis=1).mean() > 0.95
    assert np.ptp(at.u[:, 0]) > 200
    assert np.ptp(at.v[:, 0]) > 60


def test_of_more_than_a_picture_holds_it_has_as_much_to_both_sides(library: Library) -> None:
    spots = Spots(np.array([[0.0, 0.0, 0.8]]), np.array([7]), (), np.ones(1))
    wide = np.array([[-9.0, -9.0, 0.8], [9.0, 9.0, 0.8]])
    views = near_views(library, box(-3, -3, 3, 3), spots, lambda *_: wide, lane(1, 0, "v"))
    at = framed(poses_of(views), np.array([[0.0, 0.0, 0.8]]))
    assert at.inside.all()
