"""One episode: an agent walks, looks, opens, reports, and stops. Every wish has a defined end."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from shapely.geometry import Point

from sdgen.agent.account import Account
from sdgen.agent.eyes import Eyes, Look
from sdgen.agent.house import House
from sdgen.agent.moves import LABELS, MOVES, NOTIFY, Move
from sdgen.agent.options import AgentOptions
from sdgen.agent.stage import Stage
from sdgen.agent.ways import first_part, length_m
from sdgen.cameras.lens import Gaze, toward
from sdgen.dataset.records import Report
from sdgen.errors import UsageError, did_you_mean
from sdgen.geometry import Vec2
from sdgen.library import Library
from sdgen.scene import Notify
from sdgen.seeding import Rng

#: Nearer than this to a piece of floor, metres, is on it.
_ON_M = 0.01


Argument = Mapping[str, "int | float | str"]


@dataclass(frozen=True, eq=False)
class Result:
    """What came of a move, and of what it was told (``argument``): the pictures it gave, in order
    (one; of a scan one for each heading; of ``stop`` and of what was refused none), why it was
    refused (None: it was not), and whether it hit something. ``opened``: doors that were opened on
    the way; ``reward``: what a report is worth."""

    move: Move
    argument: Argument
    looks: tuple[Look, ...] = ()
    refused: str | None = None
    collided: bool = False
    opened: tuple[int, ...] = ()
    reward: float = 0.0


class Episode:
    """An agent in a home, from its start to its ``stop`` or the last step that it has.

    What cannot be done is no error: it is refused, costs a step and is counted. UsageError where
    the home has no free floor to start from. ``eyes`` may be shared by episodes one after another.
    """

    def __init__(
        self, stage: Stage, library: Library, eyes: Eyes, options: AgentOptions, rng: Rng
    ) -> None:
        self.stage = stage
        self.options = options
        self.house = House(stage.scene, library)
        self.account = Account(stage.scene, stage.anomalies)
        self.steps = 0
        self.path_m = 0.0
        self.done = False
        self.refusals: list[str] = []
        self.collisions = 0
        self.reports: dict[int, Report] = {}
        self.reported_at: dict[int, int] = {}
        self._eyes = eyes
        self._watch: Callable[[Result], None] | None = None
        self._rooms = {room.id: room for room in stage.scene.home.rooms}
        self.gaze = self._start(rng)
        #: Where it went: every corner of its way.
        self.trail: list[Vec2] = [self.gaze.point]
        eyes.show(self.house.scene)

    def _start(self, rng: Rng) -> Gaze:
        floor, start = self.house.floor, self.stage.scene.agent_start
        pitch = math.radians(self.options.pitch_deg)
        if self.options.start == "random":
            found = floor.random(rng)
            if found is None:
                raise UsageError(f"scene {self.stage.id}: no free floor to start from")
            return found._replace(pitch_rad=pitch)
        point: Vec2 = (start.position_m[0], start.position_m[1])
        if not floor.holds(point) or not floor.main.distance(Point(point)) < _ON_M:
            # Something was put there since; or furniture shuts it in, in older data sets.
            if floor.main.is_empty:
                raise UsageError(f"scene {self.stage.id}: no free floor to start from")
            point = floor.nearest_in(floor.main, Point(point))
        return Gaze(*point, start.yaw_rad, pitch)

    def watch(self, watcher: Callable[[Result], None]) -> None:
        """Have somebody told what comes of every move from now on."""
        self._watch = watcher

    @property
    def over(self) -> bool:
        """Whether it has ended, by ``stop`` or for want of steps."""
        return self.done or self.steps >= self.options.max_steps

    @property
    def room_id(self) -> int:
        """The room that the agent is in."""
        return self.house.floor.room_at(self.gaze.point)

    def look(self) -> Look:
        """What the agent sees now; no step."""
        room_id = self.room_id
        colours = "rgb" in self.options.sensors
        look = self._eyes.look(self.gaze, room_id, self.options.camera, colours)
        self.account.see(look, self.house.scene, room_id, self.steps)
        return look

    def forward(self) -> Result:
        """A step ahead, as far as nothing is in the way."""
        before = self.gaze
        self.gaze, collided = self.house.floor.step(before, self.options.forward_m)
        self.path_m += math.dist(before.point, self.gaze.point)
        self.trail.append(self.gaze.point)
        self.collisions += collided
        asked = {"forward_m": self.options.forward_m}
        return self._seen("forward", asked, collided=collided)

    def turn(self, times: int = 1) -> Result:
        """Turn left, or right where ``times`` is negative; each is a step."""
        times = self._left(times)
        yaw = self.gaze.yaw_rad + times * self.options.turn_rad
        self.gaze = self.gaze._replace(yaw_rad=math.remainder(yaw, 2 * math.pi))
        move: Move = "turn_left" if times >= 0 else "turn_right"
        asked = {"turn_rad": times * self.options.turn_rad}
        return self._seen(move, asked, max(1, abs(times)))

    def tilt(self, times: int = 1) -> Result:
        """Look further up, or down where ``times`` is negative, as far as the neck goes."""
        most = math.radians(self.options.pitch_most_deg)
        times = self._left(times)
        pitch = self.gaze.pitch_rad + times * math.radians(self.options.look_deg)
        self.gaze = self.gaze._replace(pitch_rad=min(max(pitch, -most), most))
        move: Move = "look_up" if times >= 0 else "look_down"
        asked = {"look_rad": times * math.radians(self.options.look_deg)}
        return self._seen(move, asked, max(1, abs(times)))

    def scan(self) -> Result:
        """A full turn to the left, a picture at each heading; each is a step."""
        looks = []
        begin = self.gaze.yaw_rad
        for k in range(1, self.options.headings + 1):
            yaw = begin + min(k * self.options.turn_rad, 2 * math.pi)
            self.gaze = self.gaze._replace(yaw_rad=math.remainder(yaw, 2 * math.pi))
            self.steps += 1
            looks.append(self.look())
            if self.over:
                break
        return self._told(Result("scan", {}, tuple(looks)))

    def go_to(self, key: int) -> Result:
        """Walk to a room, or before an object and look at it, by the shortest way."""
        floor, asked = self.house.floor, {"object_id": key}
        if key in self._rooms:
            part = floor.within_reach(self.gaze.point).intersection(floor.outline_of(key))
            if part.is_empty:
                return self._refuse("go_to", asked, f"no way leads into room {key}")
            middle = part.representative_point()
            return self._walk((float(middle.x), float(middle.y)), None, None, asked)
        body = self.house.bodies.get(key)
        if body is None:
            return self._refuse("go_to", asked, f"there is no room or object {key}")
        middle = body.footprint.centroid
        reached = floor.within_reach(self.gaze.point)
        if reached.is_empty:
            return self._refuse("go_to", asked, "the agent stands where nothing leads to")
        spot = floor.nearest_in(reached, body.footprint)
        eye = np.array([*spot, self.options.camera.height_m])
        at = np.array([middle.x, middle.y, float(body.low[2] + body.high[2]) / 2])
        yaw, pitch = toward(eye, at)
        return self._walk(spot, yaw, pitch, asked)

    def go(
        self, point: Vec2, yaw_rad: float | None = None, pitch_rad: float | None = None
    ) -> Result:
        """Walk to a point of the free floor by the shortest way, open the doors on it, and look
        there; without a direction, the way one came."""
        return self._walk(point, yaw_rad, pitch_rad, {"x_m": point[0], "y_m": point[1]})

    def _walk(
        self, point: Vec2, yaw_rad: float | None, pitch_rad: float | None, asked: Argument
    ) -> Result:
        way = self.house.floor.route(self.gaze.point, point, doors=True)
        if way is None:
            return self._refuse("go_to", asked, "no way leads there")
        # Who has no more steps stops on the way.
        left = self._steps_left
        way = first_part(way, left * self.options.forward_m)
        opened = self.house.floor.shut_on(way)
        stuck = [why for door in opened if (why := self._moved(door, True)) is not None]
        if stuck:
            return self._refuse("go_to", asked, stuck[0])
        way = first_part(way, max(0, left - len(opened)) * self.options.forward_m)
        walked = length_m(way)
        yaw = self.gaze.yaw_rad
        if len(way) > 1:
            yaw = math.atan2(way[-1][1] - way[-2][1], way[-1][0] - way[-2][0])
        most = math.radians(self.options.pitch_most_deg)
        pitch = self.gaze.pitch_rad if pitch_rad is None else min(max(pitch_rad, -most), most)
        self.gaze = Gaze(*way[-1], yaw if yaw_rad is None or way[-1] != point else yaw_rad, pitch)
        self.path_m += walked
        self.trail += way[1:]
        steps = max(1, math.ceil(walked / self.options.forward_m - 1e-6)) + len(opened)
        return self._seen("go_to", asked, steps, opened=opened)

    def open(self, key: int) -> Result:
        """Open the first leaf or drawer of a thing within reach that is shut."""
        return self._move_leaf("open", key)

    def close(self, key: int) -> Result:
        """Shut all leaves and drawers of a thing within reach."""
        return self._move_leaf("close", key)

    def _move_leaf(self, move: Literal["open", "close"], key: int) -> Result:
        asked = {"object_id": key}
        if key not in self.house.bodies:
            return self._refuse(move, asked, f"there is no object {key}")
        away = self.house.away_m(self.gaze.point, key)
        if away > self.options.reach_m:
            return self._refuse(move, asked, f"object {key} is {away:.2f} m away, out of reach")
        why = self._moved(key, move == "open")
        return self._seen(move, asked) if why is None else self._refuse(move, asked, why)

    def _moved(self, key: int, opening: bool) -> str | None:
        why = self.house.moved(key, opening, self.gaze.point)
        if why is None:
            self._eyes.show(self.house.scene)
        return why

    def report(
        self, key: int, label: str, notify: Notify = "now", score: float | None = None
    ) -> Result:
        """Say that an object is wrong, in place of what was said of it before.

        Worth 1 / |A+| for an anomaly that the household wants reported, minus that for one that it
        does not want and for what is none, nothing where it is ``silent``; less what was said of it
        before was worth. UsageError for a label or a notify that nobody knows.
        """
        if label not in LABELS:
            raise UsageError(f"no label {label!r}{did_you_mean(label, LABELS)}")
        if notify not in NOTIFY:
            raise UsageError(f"no notify {notify!r}{did_you_mean(notify, NOTIFY)}")
        asked = {"object_id": key, "label": label, "notify": notify}
        if key not in self.house.bodies:
            return self._refuse("report", asked, f"there is no object {key}")
        before = self._worth(key)
        self.reports[key] = Report(object_id=key, label=label, notify=notify, score=score)
        self.reported_at.setdefault(key, self.steps + 1)
        return self._seen("report", asked, reward=self._worth(key) - before)

    def _worth(self, key: int) -> float:
        said = self.reports.get(key)
        if said is None or said.notify == "silent":
            return 0.0
        wanted = {one.object_id for one in self.stage.anomalies if one.report}
        return (1.0 if key in wanted else -1.0) / max(1, len(wanted))

    def stop(self) -> Result:
        """Say that one is done."""
        self.steps += 1
        self.done = True
        return self._told(Result("stop", {}))

    def do(self, move: str, target: int = 0, label: str = "", notify: Notify = "now") -> Result:
        """A move by its name. UsageError for one that nobody knows."""
        if self.over:
            raise UsageError("the episode is over: start another one")
        plain = {
            "stop": self.stop,
            "forward": self.forward,
            "turn_left": self.turn,
            "turn_right": lambda: self.turn(-1),
            "look_up": self.tilt,
            "look_down": lambda: self.tilt(-1),
            "scan": self.scan,
        }
        aimed = {"go_to": self.go_to, "open": self.open, "close": self.close}
        if move in plain:
            return plain[move]()
        if move in aimed:
            return aimed[move](target)
        if move == "report":
            return self.report(target, label, notify)
        raise UsageError(f"no move {move!r}{did_you_mean(move, MOVES)}")

    def conclude(self, reports: Iterable[Report]) -> None:
        """Have these be all that was said, at the end: no steps are taken for them."""
        self.reports = {one.object_id: one for one in reports}
        self.reported_at = dict.fromkeys(self.reports, self.steps)

    def _seen(
        self,
        move: Move,
        asked: Argument,
        steps: int = 1,
        collided: bool = False,
        opened: tuple[int, ...] = (),
        reward: float = 0.0,
    ) -> Result:
        self.steps += steps
        return self._told(Result(move, asked, (self.look(),), None, collided, opened, reward))

    @property
    def _steps_left(self) -> int:
        return max(0, self.options.max_steps - self.steps)

    def _left(self, times: int) -> int:
        """As often as there are steps for, with its sign."""
        return int(math.copysign(min(abs(times), max(1, self._steps_left)), times))

    def _refuse(self, move: Move, asked: Argument, why: str) -> Result:
        self.steps += 1
        self.refusals.append(why)
        return self._told(Result(move, asked, refused=why))

    def _told(self, result: Result) -> Result:
        if self._watch is not None:
            self._watch(result)
        return result
