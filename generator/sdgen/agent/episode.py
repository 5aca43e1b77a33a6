"""One episode: an agent walks, looks, opens, reports, and stops. Every wish has a defined end."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from sdgen.agent.account import Account
from sdgen.agent.eyes import Eyes, Look
from sdgen.agent.house import House
from sdgen.agent.options import AgentOptions
from sdgen.agent.stage import Stage
from sdgen.agent.ways import length_m
from sdgen.cameras.lens import Gaze, camera_at, toward
from sdgen.catalog.records import Label
from sdgen.dataset.records import Report
from sdgen.errors import UsageError, did_you_mean
from sdgen.geometry import Vec2
from sdgen.library import Library
from sdgen.scene import Notify
from sdgen.seeding import Rng

#: What an agent can do, in the order of their numbers in the environment's action space.
Move = Literal[
    "stop",
    "forward",
    "turn_left",
    "turn_right",
    "look_up",
    "look_down",
    "go_to",
    "open",
    "close",
    "scan",
    "report",
]
MOVES: tuple[Move, ...] = get_args(Move)
LABELS: tuple[str, ...] = get_args(Label)
NOTIFY: tuple[Notify, ...] = get_args(Notify)


@dataclass(frozen=True, eq=False)
class Result:
    """What came of a move: the pictures it gave, in order (one; of a scan one for each heading; of
    ``stop`` and of what was refused none), why it was refused (None: it was not), and whether it
    hit something. ``opened``: doors that were opened on the way."""

    move: Move
    looks: tuple[Look, ...] = ()
    refused: str | None = None
    collided: bool = False
    opened: tuple[int, ...] = ()


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
        self._rooms = {room.id: room for room in stage.scene.home.rooms}
        self.gaze = self._start(rng)
        self.start = self.gaze
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
        if not floor.holds(point):
            if floor.shape.is_empty:
                raise UsageError(f"scene {self.stage.id}: no free floor to start from")
            point = floor.nearest(point)  # what was put there since stands in the way
        return Gaze(*point, start.yaw_rad, pitch)

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
        camera = camera_at(self.gaze, room_id, self.options.camera)
        look = self._eyes.look(camera, "rgb" in self.options.sensors)
        self.account.see(look, self.house.scene, room_id, self.steps)
        return look

    def forward(self) -> Result:
        """A step ahead, as far as nothing is in the way."""
        before = self.gaze
        self.gaze, collided = self.house.floor.step(before, self.options.forward_m)
        self.path_m += math.dist(before.point, self.gaze.point)
        self.collisions += collided
        return self._seen("forward", collided=collided)

    def turn(self, times: int = 1) -> Result:
        """Turn left, or right where ``times`` is negative; each is a step."""
        yaw = self.gaze.yaw_rad + times * self.options.turn_rad
        self.gaze = self.gaze._replace(yaw_rad=math.remainder(yaw, 2 * math.pi))
        return self._seen("turn_left" if times >= 0 else "turn_right", steps=max(1, abs(times)))

    def tilt(self, times: int = 1) -> Result:
        """Look further up, or down where ``times`` is negative, as far as the neck goes."""
        most = math.radians(self.options.pitch_most_deg)
        pitch = self.gaze.pitch_rad + times * math.radians(self.options.look_deg)
        self.gaze = self.gaze._replace(pitch_rad=min(max(pitch, -most), most))
        return self._seen("look_up" if times >= 0 else "look_down", steps=max(1, abs(times)))

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
        return Result("scan", tuple(looks))

    def go_to(self, key: int) -> Result:
        """Walk to a room, or before an object and look at it, by the shortest way."""
        floor = self.house.floor
        if key in self._rooms:
            part = floor.within_reach(self.gaze.point).intersection(floor.outline_of(key))
            if part.is_empty:
                return self._refuse("go_to", f"no way leads into room {key}")
            middle = part.representative_point()
            return self.go((float(middle.x), float(middle.y)))
        body = self.house.bodies.get(key)
        if body is None:
            return self._refuse("go_to", f"there is no room or object {key}")
        middle = body.footprint.centroid
        reached = floor.within_reach(self.gaze.point)
        if reached.is_empty:
            return self._refuse("go_to", "the agent stands where nothing leads to")
        spot = floor.nearest_in(reached, body.footprint)
        eye = np.array([*spot, self.options.camera.height_m])
        at = np.array([middle.x, middle.y, float(body.low[2] + body.high[2]) / 2])
        yaw, pitch = toward(eye, at)
        return self.go(spot, yaw, pitch)

    def go(self, point: Vec2, yaw_rad: float | None = None, pitch_rad: float | None = None) -> Result:
        """Walk to a point of the free floor by the shortest way, open the doors on it, and look
        there; without a direction, the way one came."""
        way = self.house.floor.route(self.gaze.point, point, doors=True)
        if way is None:
            return self._refuse("go_to", "no way leads there")
        opened = self.house.floor.shut_on(way)
        stuck = [why for door in opened if (why := self._moved(door, True)) is not None]
        if stuck:
            return self._refuse("go_to", stuck[0])
        walked = length_m(way)
        yaw = self.gaze.yaw_rad
        if len(way) > 1:
            yaw = math.atan2(way[-1][1] - way[-2][1], way[-1][0] - way[-2][0])
        most = math.radians(self.options.pitch_most_deg)
        pitch = self.gaze.pitch_rad if pitch_rad is None else min(max(pitch_rad, -most), most)
        self.gaze = Gaze(*way[-1], yaw if yaw_rad is None else yaw_rad, pitch)
        self.path_m += walked
        steps = max(1, math.ceil(walked / self.options.forward_m)) + len(opened)
        return self._seen("go_to", steps=steps, opened=opened)

    def open(self, key: int) -> Result:
        """Open the first leaf or drawer of a thing within reach that is shut."""
        return self._move_leaf("open", key)

    def close(self, key: int) -> Result:
        """Shut all leaves and drawers of a thing within reach."""
        return self._move_leaf("close", key)

    def _move_leaf(self, move: Literal["open", "close"], key: int) -> Result:
        if key not in self.house.bodies:
            return self._refuse(move, f"there is no object {key}")
        away = self.house.away_m(self.gaze.point, key)
        if away > self.options.reach_m:
            return self._refuse(move, f"object {key} is {away:.2f} m away, out of reach")
        why = self._moved(key, move == "open")
        return self._seen(move) if why is None else self._refuse(move, why)

    def _moved(self, key: int, opening: bool) -> str | None:
        why = self.house.moved(key, opening, self.gaze.point)
        if why is None:
            self._eyes.show(self.house.scene)
        return why

    def report(self, key: int, label: str, notify: Notify = "now", score: float = 1.0) -> Result:
        """Say that an object is wrong, in place of what was said of it before.

        UsageError for a label or a notify that nobody knows.
        """
        if label not in LABELS:
            raise UsageError(f"no label {label!r}{did_you_mean(label, LABELS)}")
        if notify not in NOTIFY:
            raise UsageError(f"no notify {notify!r}{did_you_mean(notify, NOTIFY)}")
        if key not in self.house.bodies:
            return self._refuse("report", f"there is no object {key}")
        self.reports[key] = Report(object_id=key, label=label, notify=notify, score=score)
        self.reported_at.setdefault(key, self.steps)
        return self._seen("report")

    def stop(self) -> Result:
        """Say that one is done."""
        self.steps += 1
        self.done = True
        return Result("stop")

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

    def say(self, reports: Iterable[Report]) -> None:
        """Report all of these where the agent stands, each a step."""
        for one in reports:
            self.report(one.object_id, one.label, one.notify, one.score)

    def _seen(
        self, move: Move, steps: int = 1, collided: bool = False, opened: tuple[int, ...] = ()
    ) -> Result:
        self.steps += steps
        return Result(move, (self.look(),), None, collided, opened)

    def _refuse(self, move: Move, why: str) -> Result:
        self.steps += 1
        self.refusals.append(why)
        return Result(move, refused=why)
