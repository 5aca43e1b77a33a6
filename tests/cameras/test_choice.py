"""What a home's views show of a scene, and which of them its pictures are."""

import itertools

import numpy as np
import pytest
from sdgen.cameras.choice import Marked, pick, shows
from sdgen.cameras.cover import CANONICAL, near_count
from sdgen.cameras.framing import framed, glance_pixels
from sdgen.cameras.parts import part_area, part_points
from sdgen.cameras.sight import estimate_pixels
from sdgen.cameras.view import View, poses_of
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.seeding import lane
from sdgen.vocabulary import EVIDENCE_PIXELS

from tests.fakes import box_room, thing


def views(count: int) -> list[View]:
    near = near_count(CANONICAL)
    return [
        View("near" if k < near else "room", np.array([k, 0.0, 1.2]), np.array([k, 1.0, 0.7]))
        for k in range(count)
    ]


def drawn(shown, anomalies, count: int, seed: int = 0) -> list[int]:
    every = views(12)
    picked = pick(every, np.array(shown, dtype=np.bool_), anomalies, count, lane(seed, 0, "pick"))
    return [next(k for k, view in enumerate(every) if view is one) for one in picked]


def only(view: int, marked: int, among: int) -> list[list[bool]]:
    return [[v == view and m == marked for m in range(among)] for v in range(CANONICAL)]


def test_large_things_must_show_more_than_small_ones():
    sizes = [glance_pixels(d) for d in (0.01, 0.08, 0.3, 1.0, 5.0)]
    assert sizes == sorted(sizes)
    assert sizes[0] >= 150 < sizes[-1]


def test_all_contents_decide_what_a_view_shows(library: Library):
    """A cube on a table shows from this side, one behind it does not."""
    scene = box_room(
        [
            thing(10, "table_01", (0.9, 0.9, 0)),
            thing(11, "cube_01", (0.9, 0.8, 0.74)),
            thing(12, "cube_02", (0.9, 1.05, 0.74)),
        ]
    )
    before = View("near", np.array([0.9, -0.6, 1.0]), np.array([0.9, 0.8, 0.8]))
    away = View("near", np.array([0.9, -0.6, 1.0]), np.array([0.9, -1.8, 0.8]))
    above = View("near", np.array([0.3, 0.2, 1.9]), np.array([0.9, 0.9, 0.8]))
    marked = [Marked(11), Marked(12)]
    with RayWorld(library, scene) as world:
        found = shows(library, scene, world.cast, [before, away, above], marked)
    assert found.tolist() == [[True, False], [False, False], [True, True]]


def test_what_the_frame_cuts_is_not_shown(library: Library) -> None:
    """A cube that is half in the picture, with pixels enough; of a table, which is large, most
    will do."""
    scene = box_room([thing(10, "table_01", (0.9, 0.9, 0)), thing(11, "cube_01", (0.9, 0.8, 0.74))])
    eye = np.array([0.9, -0.6, 1.2])
    aims = [np.array([0.9, 0.8, z]) for z in (0.6, -0.05)]
    views = [View("near", eye, aim) for aim in aims]
    points = part_points(library, scene.object(11), ())
    inside = [framed(poses_of([view]), points).inside.mean() for view in views]
    assert inside[0] == 1.0
    assert 0.0 < inside[1] < 1.0
    with RayWorld(library, scene) as world:
        found = shows(library, scene, world.cast, views, [Marked(10), Marked(11)])
        pixels = estimate_pixels(world.cast, poses_of(views), points, 11, np.array([1]))
    assert pixels[1] > 2 * glance_pixels(part_area(library, scene.object(11), ()))
    assert found.tolist() == [[True, True], [True, False]]


@pytest.mark.parametrize(
    ("parts", "pixels", "shown"),
    [
        ((), EVIDENCE_PIXELS, [True, True, True, False]),
        # The legs stand behind cubes or below the top, and the more of them is asked for, the more.
        (("legs",), EVIDENCE_PIXELS, [True, False, False, False]),
        (("legs",), 20, [True, True, False, False]),
        # From afar there is enough of the top, too little of the table.
        (("top",), 1, [True, True, True, False]),
    ],
)
def test_a_view_shows_enough_of_a_part_and_of_the_whole(
    library: Library, parts: tuple[str, ...], pixels: int, shown: list[bool]
) -> None:
    """A table from before, past cubes, from above and from afar."""
    table = thing(10, "table_01", (0.9, 0.9, 0))
    cubes = [thing(11 + k, "cube_01", (0.9, -0.2, 0.25 + 0.2 * k)) for k in range(3)]
    middle = np.array([0.9, 0.9, 0.5])
    before = View("near", np.array([0.9, -1.4, 1.4]), middle)
    above = View("near", np.array([0.9, 0.2, 1.9]), np.array([0.9, 0.9, 0.7]))
    afar = View("near", np.array([0.9, -4.3, 1.4]), middle)
    found: list[bool] = []
    for others, views in ((), [before]), (cubes, [before]), ((), [above, afar]):
        scene = box_room([table, *others], size_m=(9.0, 9.0))
        with RayWorld(library, scene) as world:
            marked = [Marked(10, parts, pixels)]
            found += shows(library, scene, world.cast, views, marked)[:, 0].tolist()
    assert found == shown


def test_as_many_views_as_asked_for_canonical_ones_first():
    nothing = np.zeros((CANONICAL, 0))
    assert drawn(nothing, [], 8) == list(range(8))
    assert drawn(nothing, [], 11) == list(range(11))
    assert drawn(nothing, [], 0) == []


@pytest.mark.parametrize("count", range(1, 8))
def test_fewer_views_have_the_usual_mix_whatever_they_show(count):
    rng = np.random.default_rng(count)
    for seed in range(6):
        shown = rng.random((CANONICAL, 9)) < 0.4
        picked = drawn(shown, [False] * 9, count, seed)
        assert sum(k < near_count(CANONICAL) for k in picked) == near_count(count)


def test_one_view_more_than_anomalies_leaves_none_out():
    """Even where each is seen in one view only, and these are of one kind."""
    for where in itertools.combinations(range(CANONICAL), 3):
        shown = np.zeros((CANONICAL, 7), dtype=np.bool_)
        shown[list(where), [0, 1, 2]] = True
        shown[[k for k in range(8) if k not in where][:4], [3, 4, 5, 6]] = True
        assert set(where) <= set(drawn(shown, [k < 3 for k in range(7)], 4))


def test_fewer_still_do_not_tell_anomalies_from_near_misses():
    """Two things, each in a view of its own, and room for one: as often this one as that."""
    shown = np.array(only(0, 0, 2)) | np.array(only(1, 1, 2))
    first = sum(drawn(shown, [True, False], 1, seed) == [0] for seed in range(200))
    assert 70 < first < 130
