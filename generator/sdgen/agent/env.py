"""A home to explore as a gymnasium environment (pip install sdgen[agent])."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium import spaces

from sdgen.agent.episode import Episode
from sdgen.agent.eyes import Eyes, Look
from sdgen.agent.house import House
from sdgen.agent.moves import AIMED, LABELS, MOVES, NOTIFY, Move
from sdgen.agent.options import AgentOptions
from sdgen.agent.score import score_episode
from sdgen.agent.stage import Stage, check_models, fresh_stage, stage_of
from sdgen.agent.tour import Tour, shortest_tour
from sdgen.catalog.records import Catalog
from sdgen.dataset import Dataset
from sdgen.errors import UsageError, did_you_mean
from sdgen.library import Library, load_library
from sdgen.options import BuildOptions
from sdgen.render.process import process_renderer
from sdgen.scene import LARGEST_ID, Household
from sdgen.seeding import lane

Observation = dict[str, npt.NDArray[Any]]
Action = Mapping[str, Any]


class HomeEnv(gymnasium.Env[Observation, Any]):
    """Explore homes, and report what is wrong in them.

    ``stages`` gives home number *k* of ``count``; :meth:`of_dataset` and :meth:`of_fresh` make one
    of a data set and one of homes that are made as they are entered. ``reset(options={"home": k})``
    enters home *k*, without it one drawn by the seed.

    An observation has what ``options.sensors`` ask for: ``rgb`` (H, W, 3) uint8, ``depth``
    (H, W, 1) float32 metres, 0 = nothing, ``instance`` (H, W) uint16 node ids, 0 = nothing; and
    ``pose`` (4,) float32: x and y in metres, yaw and pitch in radians.

    An action is a mapping: ``move``, a number of ``MOVES``; ``target``, the id of a room or an
    object for those that have one; ``label`` and ``notify``, numbers of ``LABELS`` and ``NOTIFY``,
    for ``report``. :func:`action` makes one of words. What cannot be done costs a step and is
    counted (``info["refused"]`` says why).

    The reward of a report is 1 / |A+| for an anomaly that the household wants reported, minus that
    for one that it does not want and for what is none, none for what is ``silent``; less what was
    said of the object before was worth: the sum is CAS less reported false alarms by |A+|. An
    episode ends (terminated) with ``stop`` and is cut off (truncated) after ``options.max_steps``.

    ``info`` of a reset tells the scene, the household and the rooms; of each step what was
    ``refused``, ``collided``, ``opened``, and the pictures of a scan; of the last one the
    ``score`` (with the shortest tour where the home was built with ``--observability`` and the
    lens is the certificates').
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 5}  # noqa: RUF012

    def __init__(
        self,
        stages: Callable[[int], Stage],
        count: int,
        library: Library,
        options: AgentOptions | None = None,
        renderer: str = "auto",
        render_mode: str | None = None,
    ) -> None:
        if count < 1:
            raise UsageError("an environment without homes")
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            raise UsageError(f"no render mode {render_mode!r}: rgb_array or none")
        self.options = options or AgentOptions()
        self.render_mode = render_mode
        self._stages = stages
        self._count = count
        self._library = library
        self._renderer = renderer
        self._eyes: Eyes | None = None
        self._episode: Episode | None = None
        self._look: Look | None = None
        self.observation_space: spaces.Space[Any] = _observations(self.options)
        self.action_space = spaces.Dict(
            {
                "move": spaces.Discrete(len(MOVES)),
                "target": spaces.Discrete(LARGEST_ID + 1),
                "label": spaces.Discrete(len(LABELS)),
                "notify": spaces.Discrete(len(NOTIFY)),
            }
        )

    @classmethod
    def of_dataset(
        cls,
        data: Dataset | str | Path,
        options: AgentOptions | None = None,
        library: Library | None = None,
        **more: Any,
    ) -> HomeEnv:
        """The homes of a data set; ``library`` has its models (None: the shipped ones).

        Raises InputError for a folder that is no data set, or one of another format version, and
        where the models are not those it was built with.
        """
        data = data if isinstance(data, Dataset) else Dataset(data)
        library = library or load_library()
        check_models(data, library)
        return cls(_OfDataset(data), len(data), library, options, **more)

    @classmethod
    def of_fresh(
        cls,
        catalog: Catalog,
        options: AgentOptions | None = None,
        build: BuildOptions | None = None,
        library: Library | None = None,
        **more: Any,
    ) -> HomeEnv:
        """Homes that are made as they are entered: those that ``sdgen build`` would write with
        these options (``n`` of them)."""
        library = library or load_library()
        build = (build or BuildOptions()).model_copy(update={"views": 0})
        return cls(_Fresh(catalog, library, build), build.n, library, options, **more)

    @property
    def homes(self) -> int:
        """How many homes there are to enter."""
        return self._count

    @property
    def episode(self) -> Episode:
        """The episode that goes on. Raises UsageError before the first reset."""
        if self._episode is None:
            raise UsageError("the environment was not reset yet")
        return self._episode

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Enter a home. UsageError for one that is not there."""
        super().reset(seed=seed)
        home = self._chosen(options)
        rng = lane(int(self.np_random.integers(2**31)), home, "agent")
        if self._eyes is None:
            renderer = process_renderer(self._renderer)
            self._eyes = Eyes(self._library, renderer, self.options.whole_home)
        self._episode = Episode(self._stages(home), self._library, self._eyes, self.options, rng)
        self._look = self._episode.look()
        return self._observed(self._look), self._told(self._episode.stage)

    def step(self, action: Any) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Do what an action says. Raises UsageError for one that is not in the action space."""
        move, target, label, notify = _words(action)
        result = self.episode.do(move, target, label, notify)
        if result.looks:
            self._look = result.looks[-1]
        assert self._look is not None  # there was a reset, or no episode
        info: dict[str, Any] = {
            "refused": result.refused,
            "collided": result.collided,
            "opened": result.opened,
        }
        if result.move == "scan":
            info["scan"] = [self._observed(look) for look in result.looks]
        over = self.episode.over
        if over:
            info["score"] = score_episode(self.episode, self._tour()).model_dump(mode="json")
        done = self.episode.done
        return self._observed(self._look), result.reward, done, over and not done, info

    def _chosen(self, options: object) -> int:
        """The home that a reset asks for, or one drawn by its seed. Raises UsageError."""
        drawn = int(self.np_random.integers(self._count))
        if options is None:
            return drawn
        if not isinstance(options, Mapping):
            raise UsageError(f"reset: options are a mapping: {options!r}")
        unknown = sorted(map(str, set(options) - {"home"}))
        if unknown:
            raise UsageError(f"reset: no option {unknown[0]!r}: home is the one there is")
        home = options.get("home", drawn)
        if isinstance(home, bool) or not isinstance(home, int | np.integer):
            raise UsageError(f"reset: home: {home!r} is no whole number")
        if not 0 <= home < self._count:
            raise UsageError(f"home {home}: there are {self._count}, from 0 on")
        return int(home)

    def _tour(self) -> Tour | None:
        """The shortest tour of this home, where it was built with certificates for such a lens."""
        stage = self.episode.stage
        found = stage.certificates
        if found is None or found.lens != self.options.camera:
            return None
        return shortest_tour(found, House(stage.scene, self._library).floor, self.episode.trail[0])

    def render(self) -> npt.NDArray[np.uint8] | None:
        """What the agent sees, (H, W, 3) uint8; None without a render mode."""
        if self.render_mode is None or self._look is None:
            return None
        return self._look.rgb

    def close(self) -> None:
        """Let go of the renderer; a second call does nothing."""
        if self._eyes is not None:
            self._eyes.close()
            self._eyes = None
        self._episode = None

    def _observed(self, look: Look) -> Observation:
        out: Observation = {"pose": np.array(look.gaze, dtype=np.float32)}
        if "rgb" in self.options.sensors:
            out["rgb"] = look.rgb.copy()
        if "depth" in self.options.sensors:
            out["depth"] = (look.depth_mm[..., None] / np.float32(1000)).astype(np.float32)
        if "instance" in self.options.sensors:
            out["instance"] = look.instance.copy()
        return out

    def _told(self, stage: Stage) -> dict[str, Any]:
        rooms = {room.id: room.type for room in stage.scene.home.rooms}
        household: Household = stage.household
        return {"scene": stage.id, "household": household.model_dump(mode="json"), "rooms": rooms}


def action(move: Move, target: int = 0, label: str = LABELS[0], notify: str = "now") -> Action:
    """An action of words. UsageError for words that nobody knows."""
    for word, known in ((move, MOVES), (label, LABELS), (notify, NOTIFY)):
        if word not in known:
            raise UsageError(f"no {word!r}{did_you_mean(word, list(known))}")
    return {
        "move": MOVES.index(move),
        "target": target,
        "label": [*LABELS].index(label),  # type: ignore[arg-type]
        "notify": [*NOTIFY].index(notify),  # type: ignore[arg-type]
    }


def _words(action: Any) -> tuple[str, int, str, Any]:
    """Move, target, label and notify of an action. Raises UsageError."""
    if not isinstance(action, Mapping):
        raise UsageError(f"an action is a mapping of move, target, label and notify: {action!r}")
    unknown = sorted(map(str, set(action) - {"move", "target", "label", "notify"}))
    if unknown or "move" not in action:
        what = f"no {unknown[0]!r}" if unknown else "no move"
        raise UsageError(f"an action has move, target, label and notify: {what}")
    move = MOVES[_number(action, "move", len(MOVES))]
    target = _number(action, "target", LARGEST_ID + 1) if move in AIMED else 0
    if move != "report":
        return move, target, "", "now"
    label, notify = _number(action, "label", len(LABELS)), _number(action, "notify", len(NOTIFY))
    return move, target, LABELS[label], NOTIFY[notify]


def _number(action: Action, name: str, count: int) -> int:
    value = action.get(name, 0)
    if isinstance(value, np.ndarray) and value.size == 1:
        value = value.reshape(-1)[0]
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | np.integer):
        raise UsageError(f"action: {name}: {value!r} is no whole number")
    if not 0 <= value < count:
        raise UsageError(f"action: {name}: {value} is not in 0 to {count - 1}")
    return int(value)


def _observations(options: AgentOptions) -> spaces.Dict:
    height, width = options.camera.height, options.camera.width
    turn, tilt = math.pi, math.pi / 2
    found: dict[str, spaces.Space[Any]] = {
        "pose": spaces.Box(
            np.array([-1e4, -1e4, -turn, -tilt], dtype=np.float32),
            np.array([1e4, 1e4, turn, tilt], dtype=np.float32),
        )
    }
    if "rgb" in options.sensors:
        found["rgb"] = spaces.Box(0, 255, (height, width, 3), np.uint8)
    if "depth" in options.sensors:
        found["depth"] = spaces.Box(0.0, 65.535, (height, width, 1), np.float32)
    if "instance" in options.sensors:
        found["instance"] = spaces.Box(0, LARGEST_ID, (height, width), np.uint16)
    return spaces.Dict(found)


class _OfDataset:
    """Home *k* of a data set; small and picklable."""

    def __init__(self, data: Dataset) -> None:
        self.data = data

    def __call__(self, home: int) -> Stage:
        return stage_of(self.data, self.data[home])


class _Fresh:
    """Home *k* of a build that nobody wrote."""

    def __init__(self, catalog: Catalog, library: Library, build: BuildOptions) -> None:
        self.parts = catalog, library, build

    def __call__(self, home: int) -> Stage:
        return fresh_stage(home, *self.parts)
