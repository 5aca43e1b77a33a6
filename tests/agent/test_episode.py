"""An agent walks, looks, opens and reports; what cannot be done is refused and counted."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from sdgen.actions import at_rest
from sdgen.agent.episode import Episode
from sdgen.agent.moves import LABELS
from sdgen.agent.score import score_episode
from sdgen.agent.stage import Stage
from sdgen.agent.walk import shut_doors
from sdgen.errors import UsageError
from sdgen.scene import ObjectInstance, Scene
from sdgen.seeding import lane
from shapely.geometry import Point

from tests.agent import homes
from tests.shipped import shipped_library


def changed(stage: Stage, *items: ObjectInstance) -> Stage:
    new = {item.id: item for item in items}
    objects = tuple(new.get(item.id, item) for item in stage.scene.objects)
    return dataclasses.replace(stage, scene=stage.scene.model_copy(update={"objects": objects}))


def all_shut(stage: Stage) -> Stage:
    infos = shipped_library().infos
    doors = {o.object_id for o in stage.scene.home.openings if len(o.room_ids) == 2}
    return changed(
        stage, *(at_rest(i, infos[i.asset]) for i in stage.scene.objects if i.id in doors)
    )


def thing_that_opens(scene: Scene, episode: Episode) -> ObjectInstance:
    """A closed thing of furniture that stands where one gets to."""
    for item in scene.objects:
        if item.fixed and "CLOSED" in item.states and "door" not in item.category:
            result = episode.go_to(item.id)
            near = episode.house.away_m(episode.gaze.point, item.id) < 0.6
            if result.refused is None and near:
                return item
    raise AssertionError("nothing to open")


def test_it_begins_where_the_scene_says_and_looks_ahead() -> None:
    episode = homes.episode()
    start = homes.stage().scene.agent_start
    assert episode.gaze.point == pytest.approx(start.position_m[:2], abs=0.02)
    assert episode.gaze.yaw_rad == start.yaw_rad
    look = episode.look()
    assert look.rgb.shape == (48, 64, 3)
    assert look.rgb.std() > 5.0
    assert (look.instance > 0).mean() > 0.9
    assert look.depth_mm.max() > 500


def test_a_random_start_is_on_the_floor_and_the_same_for_a_seed() -> None:
    options = homes.OPTIONS.model_copy(update={"start": "random"})
    first, again, other = (homes.episode(options=options, seed=s) for s in (1, 1, 2))
    assert first.gaze == again.gaze != other.gaze
    assert first.house.floor.holds(first.gaze.point)


def test_steps_turns_and_glances_move_it_as_they_say() -> None:
    episode = homes.episode()
    before = episode.gaze
    episode.turn(2)
    assert episode.gaze.yaw_rad == pytest.approx(
        math.remainder(before.yaw_rad + math.radians(60), 2 * math.pi)
    )
    episode.tilt(-1)
    assert episode.gaze.pitch_rad == pytest.approx(-math.radians(30))
    episode.tilt(-9)
    assert episode.gaze.pitch_rad == pytest.approx(-math.radians(60))
    episode.forward()
    assert math.dist(before.point, episode.gaze.point) <= 0.25 + 1e-9
    assert episode.steps == 2 + 1 + 9 + 1
    assert episode.path_m == pytest.approx(math.dist(before.point, episode.gaze.point))


def test_a_wall_stops_it() -> None:
    episode = homes.episode()
    for _ in range(100):
        result = episode.forward()
    assert result.collided
    assert episode.collisions > 10
    assert episode.house.floor.holds(episode.gaze.point)


def test_a_scan_looks_all_around_and_ends_where_it_began() -> None:
    episode = homes.episode()
    before = episode.gaze
    result = episode.scan()
    assert len(result.looks) == 12
    assert episode.steps == 12
    assert episode.gaze.yaw_rad == pytest.approx(before.yaw_rad)
    yaws = sorted(look.gaze.yaw_rad for look in result.looks)
    assert np.diff(yaws) == pytest.approx(math.radians(30))


def test_it_goes_to_every_room_and_before_things() -> None:
    episode = homes.episode(options=homes.OPTIONS.model_copy(update={"max_steps": 10_000}))
    for room in episode.stage.scene.home.rooms:
        assert episode.go_to(room.id).refused is None
        assert episode.room_id == room.id
    thing = next(i for i in episode.stage.scene.objects if i.category == "fridge")
    result = episode.go_to(thing.id)
    assert result.refused is None
    assert (result.looks[-1].instance == thing.id).any()


def test_shut_doors_stop_a_walk_and_are_opened_on_the_way_to_a_goal() -> None:
    stage = all_shut(homes.stage())
    assert shut_doors(stage.scene)
    episode = homes.episode(stage, homes.OPTIONS.model_copy(update={"max_steps": 10_000}))
    here = episode.room_id
    floor = episode.house.floor
    doors = set(floor.shut)
    opened: set[int] = set()
    for room in stage.scene.home.rooms:
        if room.id != here:
            goal = floor.open_shape.intersection(floor.outline_of(room.id)).representative_point()
            free = episode.house.floor.route(episode.gaze.point, (goal.x, goal.y))
            result = episode.go((goal.x, goal.y))
            assert result.refused is None
            assert bool(result.opened) == (free is None)
            opened |= set(result.opened)
    assert opened <= doors
    assert opened
    assert all("OPEN" in episode.house.bodies[key].item.states for key in opened)


def test_what_is_shut_is_opened_with_what_is_in_it_and_shut_again() -> None:
    episode = homes.episode(options=homes.OPTIONS.model_copy(update={"max_steps": 10_000}))
    item = thing_that_opens(episode.stage.scene, episode)
    before = episode.look()
    result = episode.open(item.id)
    assert result.refused is None
    assert "OPEN" in episode.house.bodies[item.id].item.states
    assert (result.looks[-1].depth_mm != before.depth_mm).any()
    shut = episode.close(item.id)
    assert shut.refused is None
    assert "CLOSED" in episode.house.bodies[item.id].item.states
    assert (shut.looks[-1].instance == before.instance).all()


def test_what_cannot_be_done_is_refused_and_counted() -> None:
    episode = homes.episode()
    far = max(episode.house.bodies, key=lambda k: episode.house.away_m(episode.gaze.point, k))
    wall = episode.stage.scene.home.structures[0].id
    for result, why in (
        (episode.go_to(65_000), "no room or object 65000"),
        (episode.open(65_000), "no object 65000"),
        (episode.open(far), "out of reach"),
        (episode.report(wall, LABELS[0]), f"no object {wall}"),
        (episode.go((500.0, 500.0)), "no way leads there"),
    ):
        assert result.refused is not None
        assert why in result.refused
        assert result.looks == ()
    assert len(episode.refusals) == episode.steps == 5
    plain = next(i for i in episode.stage.scene.objects if i.category == "rug")
    episode.go_to(plain.id)
    assert "cannot be opened" in str(episode.open(plain.id).refused)


def test_words_that_nobody_knows_are_errors() -> None:
    episode = homes.episode()
    with pytest.raises(UsageError, match="did you mean 'forward'"):
        episode.do("foward")
    key = next(iter(episode.house.bodies))
    with pytest.raises(UsageError, match="no label 'bad'"):
        episode.report(key, "bad")
    episode.stop()
    with pytest.raises(UsageError, match="over"):
        episode.do("forward")


def test_scores_are_those_of_what_was_said() -> None:
    episode = homes.episode()
    wrong = episode.stage.anomalies
    for one in wrong:
        episode.report(one.object_id, one.label, one.notify)
    score = score_episode(episode)
    assert (score.AS, score.false_alarms, score.label_accuracy) == (1.0, 0.0, 1.0)
    assert all(find.miss is None for find in score.finds)
    clean = next(k for k in episode.house.bodies if k not in {a.object_id for a in wrong})
    episode.report(clean, LABELS[0])
    assert score_episode(episode).false_alarms == 1.0


def test_misses_are_told_apart() -> None:
    episode = homes.episode()
    before = score_episode(episode)
    assert {find.miss for find in before.finds} == {"never_looked"}
    one = episode.stage.anomalies[0]
    episode.go_to(one.object_id)
    find = score_episode(episode).finds[0]
    assert find.miss in ("did_not_understand", "could_not_see")
    assert (find.miss == "did_not_understand") == (one.id in episode.account.first_shown)


def test_random_moves_never_leave_the_floor_or_crash() -> None:
    options = homes.OPTIONS.model_copy(update={"max_steps": 100_000, "sensors": ("depth",)})
    episode = homes.episode(options=options)
    rng = lane(5, 0, "moves")
    moves = ["forward", "turn_left", "turn_right", "look_up", "look_down", "go_to", "open", "close"]
    ids = [*episode.house.bodies, *(room.id for room in episode.stage.scene.home.rooms), 3, 65_535]
    for _ in range(150):
        move = moves[int(rng.integers(len(moves)))]
        episode.do(move, ids[int(rng.integers(len(ids)))])
        assert episode.house.floor.holds(episode.gaze.point)


def test_what_it_opens_cannot_close_it_in() -> None:
    """A leaf that would sweep over the agent stays as it is, and so does the home."""
    episode = homes.episode(options=homes.OPTIONS.model_copy(update={"max_steps": 10_000}))
    tried = [i for i in episode.stage.scene.objects if i.fixed and "CLOSED" in i.states][:8]
    assert tried
    for item in tried:
        episode.go_to(item.id)
        before = episode.house.scene
        result = episode.open(item.id)
        assert episode.house.floor.holds(episode.gaze.point)
        assert (episode.house.scene == before) == (result.refused is not None)


def test_who_has_no_more_steps_stops_on_the_way() -> None:
    options = homes.OPTIONS.model_copy(update={"max_steps": 6})
    episode = homes.episode(options=options)
    start = episode.gaze.point
    far = max(
        (room.id for room in episode.stage.scene.home.rooms),
        key=lambda key: episode.house.floor.outline_of(key).distance(Point(start)),
    )
    result = episode.go_to(far)
    assert result.refused is None
    assert episode.over
    assert episode.steps == 6
    assert episode.path_m <= 6 * 0.25 + 1e-9
    assert episode.house.floor.holds(episode.gaze.point)
    turning = homes.episode(options=options)
    turning.turn(100)
    assert turning.steps == 6
