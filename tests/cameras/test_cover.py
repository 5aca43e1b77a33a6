"""A home's views show as much as they can of where small things lie, five near and three wide."""

import numpy as np
import pytest
from sdgen.cameras.cover import CANONICAL, choose, near_count, things_shown
from sdgen.cameras.view import View
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.seeding import lane

from tests.fakes import box_room, thing


def offered(near: int, room: int) -> list[View]:
    kinds = ["near"] * near + ["room"] * room
    return [View("near" if kind == "near" else "room", np.zeros(3), np.ones(3)) for kind in kinds]


@pytest.mark.parametrize(("views", "near"), [(8, 5), (12, 8), (4, 3), (1, 1), (0, 0), (6, 4)])
def test_the_number_of_near_views_follows_from_the_number_of_views_alone(views, near):
    assert near_count(views) == near


def test_what_is_seen_already_counts_little():
    """The two best views show the same; the third shows something else."""
    views = offered(8, 8)
    shows = np.zeros((16, 30), dtype=np.bool_)
    shows[0, :20] = shows[1, :19] = shows[2, 20:] = True
    chosen = choose(views, shows, np.full(30, 1 / 30), 2, lane(0, 0, "cover"))
    assert sorted(chosen) in ([0, 2], [1, 2])


def test_the_mix_of_kinds_is_the_same_whatever_shows_more():
    for seed in range(10):
        shows = np.random.default_rng(seed).random((40, 60)) < 0.2
        shows[20:] &= seed % 2 == 0
        views = offered(20, 20)
        for count in (CANONICAL, 12, 17):
            chosen = choose(views, shows, np.full(60, 1 / 60), count, lane(seed, 0, "cover"))
            assert len(set(chosen)) == count
            assert sum(k < 20 for k in chosen) == near_count(count)


def test_a_longer_choice_begins_with_a_shorter_one():
    shows = np.random.default_rng(1).random((40, 60)) < 0.2
    views, weight = offered(25, 15), np.full(60, 1 / 60)
    long = choose(views, shows, weight, 20, lane(3, 0, "cover"))
    assert choose(views, shows, weight, CANONICAL, lane(3, 0, "cover")) == long[:CANONICAL]


def test_likely_spots_come_first_and_the_draw_decides_between_equals():
    shows = np.zeros((12, 12), dtype=np.bool_)
    np.fill_diagonal(shows, True)
    weight = np.array([0.5, 0.1] + [0.04] * 10)
    firsts = [choose(offered(12, 0), shows, weight, 3, lane(k, 0, "c")) for k in range(30)]
    assert {tuple(f[:2]) for f in firsts} == {(0, 1)}
    assert len({f[2] for f in firsts}) > 4


def test_of_overviews_that_show_as_much_the_better_ones_are_taken():
    """And a bad one only where it shows much more."""
    views = [
        View("room", np.array([2.0 * k, 0.0, 1.2]), np.ones(3), 1, worth)
        for k, worth in enumerate((0.4, 0.8, 0.4))
    ]
    shows, weight = np.ones((3, 10), dtype=np.bool_), np.full(10, 0.1)
    firsts = [choose(views, shows, weight, 1, lane(k, 0, "c")) for k in range(8)]
    assert firsts == [[1]] * 8
    shows[1, 1:] = False
    firsts = [choose(views, shows, weight, 1, lane(k, 0, "c")) for k in range(8)]
    assert [1] not in firsts


def test_another_room_has_its_overview_before_one_has_two():
    """Where it shows much less, too, but not where it shows next to nothing."""
    rooms = (1, 1, 2)
    views = [
        View("room", np.array([2.0 * k, 0.0, 1.2]), np.ones(3), r) for k, r in enumerate(rooms)
    ]
    shows, weight = np.zeros((3, 10), dtype=np.bool_), np.full(10, 0.1)
    shows[0, :6] = shows[1, 6:] = True
    for shown, taken in ((3, {0, 2}), (1, {0, 1})):
        shows[2] = False
        shows[2, 6 : 6 + shown] = True
        assert set(choose(views, shows, weight, 2, lane(0, 0, "c"))) == taken


def test_too_few_views_are_all_taken():
    assert choose([], np.zeros((0, 4)), np.full(4, 0.25), 8, lane(0, 0, "c")) == []
    few = choose(offered(2, 1), np.ones((3, 4)) > 0, np.full(4, 0.25), 8, lane(0, 0, "c"))
    assert sorted(few) == [0, 1, 2]


def test_a_small_thing_shows_near_by_in_the_picture_and_unhidden(library: Library):
    scene = box_room([thing(10, "table_01", (0.5, 0.8, 0))])
    eye = np.array([0.5, -0.9, 1.2])
    view = View("near", eye, np.array([0.5, 0.8, 0.7]))
    far = View("near", np.array([-1.9, -1.9, 1.2]), np.array([0.5, 0.8, 0.7]))
    points = np.array([[0.3, 0.6, 0.78], [0.5, 1.6, 0.04], [0.5, -1.5, 0.04], [-1.8, 0.8, 0.04]])
    with RayWorld(library, scene) as world:
        found = things_shown([view, far], points, world.cast)
    assert found[0].tolist() == [True, False, False, False]
    assert not found[1, 0]  # 3.6 m away
