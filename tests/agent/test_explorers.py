"""Explorers see homes, the planner all that can be seen; and what it costs is told."""

from __future__ import annotations

import base64
import io

import numpy as np
import pytest
from PIL import Image
from sdgen.agent.compare import certificates, compare
from sdgen.agent.explored import explored
from sdgen.agent.explorers import EXPLORERS
from sdgen.agent.film.recorder import Recorder
from sdgen.agent.options import AgentOptions
from sdgen.agent.score import score_episode
from sdgen.agent.tour import shortest_tour
from sdgen.cameras.lens import Lens
from sdgen.chat.question import Question
from sdgen.detectors.pictured import Pictured
from sdgen.detectors.rules import rules
from sdgen.errors import UsageError
from sdgen.seeding import lane
from sdgen.truth.observable import Observability

from tests.agent import homes
from tests.detectors.asking import Scripted
from tests.shared import Shared
from tests.shipped import shipped_library

OPTIONS = AgentOptions(camera=Lens(width=96, height=96), max_steps=1000)
HOMES = (0, 1, 2)


def certificate(shared: Shared, home: int) -> Observability:
    return shared.value(
        f"certificate-96-{home}",
        lambda: certificates(homes.sample(), homes.sample()[home], shipped_library(), OPTIONS),
    )


@pytest.mark.parametrize("home", HOMES)
def test_the_planner_is_shown_all_that_can_be_seen(home: int, shared: Shared) -> None:
    found = certificate(shared, home)
    episode = homes.episode(homes.stage(home), OPTIONS)
    floor, start = episode.house.floor, episode.gaze.point
    tour = shortest_tour(found, floor, start, episode.stage.places)
    looks = EXPLORERS["planner"](episode, lane(0, 0, "x"), tour)
    ids = {one.id for one in episode.stage.anomalies}
    assert set(episode.account.first_shown) >= ids - set(tour.unreachable)
    assert len(looks) <= 1 + len(ids)
    shortest = shortest_tour(found, floor, start)
    assert shortest.length_m <= tour.length_m + 0.5
    score = score_episode(episode, shortest)
    assert score.path_ratio is None or 0.0 < score.path_ratio <= 1.0
    said = {
        report.object_id for report in rules(homes.sample(), explored(homes.sample()[home], looks))
    }
    wrong = {one.object_id for one in episode.stage.anomalies}
    assert said <= wrong


def test_room_by_room_sees_the_floor_of_a_home() -> None:
    episode = homes.episode(options=OPTIONS)
    looks = EXPLORERS["rooms"](episode, lane(0, 0, "x"), None)
    assert episode.account.coverage > 0.9
    assert not episode.refusals
    rooms = {look.camera.room_id for look in looks}
    assert rooms == {room.id for room in episode.stage.scene.home.rooms}


def test_the_frontier_is_pushed_back_until_none_is_left() -> None:
    episode = homes.episode(options=OPTIONS)
    EXPLORERS["frontier"](episode, lane(0, 0, "x"), None)
    assert not episode.over
    assert episode.account.coverage > 0.9


def test_a_random_walk_takes_all_its_steps_and_is_the_same_for_a_seed() -> None:
    options = homes.OPTIONS.model_copy(update={"max_steps": 40})
    ways = []
    for seed in (1, 1, 2):
        episode = homes.episode(options=options)
        EXPLORERS["random"](episode, lane(seed, 0, "x"), None)
        assert episode.steps == 40
        ways.append(episode.trail)
    assert ways[0] == ways[1] != ways[2]


def test_a_film_has_a_step_for_every_picture() -> None:
    episode = homes.episode()
    recorder = Recorder(episode, episode.look())
    episode.watch(recorder.add)
    episode.scan()
    episode.open(65_000)
    episode.stop()
    film = recorder.film({"found": 0})
    assert [step.action for step in film.steps] == ["start", *["scan"] * 12, "open", "stop"]
    assert film.steps[-2].refused == "there is no object 65000"
    assert [step.done for step in film.steps] == [False] * 14 + [True]


@pytest.mark.slow
def test_the_table_tells_what_exploring_costs() -> None:
    rows = compare(
        homes.sample(),
        shipped_library(),
        ["random", "planner"],
        {"rules": rules},
        OPTIONS.model_copy(update={"max_steps": 60}),
        limit=2,
    )
    by = {(row.explorer, row.before): row for row in rows}
    assert set(by) == {
        ("random", "explored"),
        ("planner", "explored"),
        ("", "views"),
        ("", "everything"),
    }
    assert by["", "everything"].AS.mean == 1.0
    planner, walk = by["planner", "explored"], by["random", "explored"]
    assert planner.shown is not None
    assert walk.shown is not None
    assert planner.shown.mean == 1.0
    assert walk.misses is not None
    assert sum(walk.misses.values()) > 0
    with pytest.raises(UsageError, match="no explorer"):
        compare(homes.sample(), shipped_library(), ["best"], {"rules": rules}, OPTIONS)


def test_a_detector_that_sends_pictures_sees_what_was_explored() -> None:
    episode = homes.episode(options=OPTIONS)
    looks = [episode.look(), *episode.scan().looks]
    seen = explored(homes.sample()[0], looks)
    sent: list[Question] = []

    def says(question: Question) -> str:
        sent.append(question)
        return "none"

    assert Pictured(Scripted(says), per="view")(homes.sample(), seen) == ()
    shown = [question.pictures[0] for question in sent]
    # After a full turn one sees again what one saw first.
    assert len({picture.digest for picture in shown}) == len(looks) - 1
    with Image.open(io.BytesIO(base64.b64decode(shown[3].url().partition(",")[2]))) as image:
        assert (np.asarray(image) == looks[3].rgb).all()
