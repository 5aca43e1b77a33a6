"""A scene being mended: actions, what they need, and what comes of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from pydantic import ValidationError

from sdgen.agent.mend import handling, leaves, placing
from sdgen.agent.mend.records import Action, Outcome, Pair
from sdgen.agent.mend.state import Setting, State, called, setting_of, start_of
from sdgen.cameras.lens import Gaze
from sdgen.catalog.records import Catalog
from sdgen.dataset.item import SceneItem
from sdgen.dataset.reader import Dataset
from sdgen.errors import InputError, did_you_mean
from sdgen.facts import Facts
from sdgen.library import Library
from sdgen.physics.client import Client
from sdgen.scene import Household, Scene
from sdgen.seeding import lane

#: What is done with the thing in the hand, and with what stands there: all words there are.
WITH_HAND = ("put_on", "put_in", "put_down", "move_away", "throw_away")
WITH_OBJECT = ("grab", "open", "close", "switch_off", "put_out", "empty", "wipe_up", "sweep_up")
ACTIONS = ("go_to", *WITH_OBJECT, *WITH_HAND)


class Mending:
    """A scene that an agent mends, action by action: :meth:`do`.

    It never raises for what it is asked to do: what cannot be done is refused, counted, and changes
    nothing. The same scene, seed and actions come out the same. The ``client`` is the caller's, and
    used by no other meanwhile. Raises InputError for a model that the library has not.
    """

    def __init__(
        self,
        scene: Scene,
        household: Household,
        catalog: Catalog,
        library: Library,
        client: Client,
        seed: int = 0,
    ) -> None:
        missing = sorted({item.asset for item in scene.objects} - set(library.infos))
        if missing:
            raise InputError([f"scene {scene.id}: the library has no model {missing[0]!r}"])
        self.seed = seed
        self.setting: Setting = setting_of(scene, household, catalog, library, client)
        self.start: State = start_of(scene, self.setting)
        self.state: State = self.start
        self.outcomes: tuple[Outcome, ...] = ()

    @property
    def scene(self) -> Scene:
        """The scene as it is now, without what is in the hand."""
        return self.state.facts.scene

    @property
    def facts(self) -> Facts:
        """Its facts."""
        return self.state.facts

    @property
    def place(self) -> Gaze:
        """Where the agent stands."""
        return self.state.place

    @property
    def in_hand(self) -> int | None:
        """The id of what is in the hand."""
        return None if self.state.held is None else self.state.held.item.id

    @property
    def pairs(self) -> Mapping[Pair, bool]:
        """The pairs that hold now, and whether the household would be told of each."""
        return self.state.holding

    def do(self, asked: Action | Mapping[str, Any]) -> Outcome:
        """Carry out an action, or refuse it. What is no action at all is refused, too."""
        before = self.state
        action, found = self._tried(asked)
        if isinstance(found, State):
            self.state = found
        outcome = Outcome(
            action=action,
            done=isinstance(found, State),
            refused=None if isinstance(found, State) else found,
            removed=tuple(sorted(before.holding.keys() - self.state.holding.keys())),
            caused=tuple(sorted(self.state.holding.keys() - before.holding.keys())),
            in_hand=self.in_hand,
            walked_m=round(self.state.walked_m - before.walked_m, 4),
        )
        self.outcomes = (*self.outcomes, outcome)
        return outcome

    def _tried(self, asked: Action | Mapping[str, Any]) -> tuple[Action, State | str]:
        try:
            action = asked if isinstance(asked, Action) else Action.model_validate(asked)
        except ValidationError as error:
            first = error.errors()[0]
            where = ".".join(map(str, first["loc"]))
            what = f"no action: {where}: {first['msg']}" if where else f"no action: {first['msg']}"
            return Action(action=""), what
        if action.action not in ACTIONS:
            hint = did_you_mean(action.action, list(ACTIONS))
            return action, f"no action {action.action!r}{hint}"
        if action.action == "go_to":
            return action, self._gone_to(action.object_id)
        if action.action in WITH_OBJECT:
            return action, self._to_object(action)
        return action, self._with_hand(action)

    def _gone_to(self, key: int | None) -> State | str:
        state, arms = self.state, self.setting.arms
        rooms = {room.id: room.id for room in state.facts.scene.home.rooms}
        rooms |= {one.id: one.room_id for one in state.facts.structures.values()}
        there: Gaze | None
        if key is not None and key in rooms:
            there = arms.into_room(state.place, rooms[key])
            words = f"room {rooms[key]}"
        elif key is not None and key in state.facts.bodies:
            body = state.facts.bodies[key]
            there = arms.beside(state.place, body.footprint, body.item.room_id, key)
            words = called(state.facts, key)
        else:
            return self._unknown(key)
        way_m = None if there is None else arms.way_m(state.place, there)
        if there is None or way_m is None:
            return f"no place that can be got to is within reach of {words}"
        return replace(state, place=there, walked_m=state.walked_m + way_m)

    def _to_object(self, action: Action) -> State | str:
        key = action.object_id
        if key is None or key not in self.state.facts.bodies:
            return self._unknown(key)
        far = self._too_far(key)
        if far is not None:
            return far
        word, setting, state = action.action, self.setting, self.state
        does: Mapping[str, Callable[[], State | str]] = {
            "grab": lambda: handling.grabbed(setting, state, key),
            "open": lambda: leaves.opened(setting, state, key, action.part),
            "close": lambda: leaves.shut(setting, state, key, action.part),
            "wipe_up": lambda: handling.cleaned(setting, state, key, word),
            "sweep_up": lambda: handling.cleaned(setting, state, key, word),
        }
        back = does.get(word, lambda: handling.back_at_rest(setting, state, key, word))
        return back()

    def _with_hand(self, action: Action) -> State | str:
        setting, state, held = self.setting, self.state, self.state.held
        if held is None:
            return "the hand is empty"
        if action.object_id not in (None, held.item.id):
            return f"the hand holds {held.item.id}, not {action.object_id}"
        rng = lane(self.seed, state.facts.scene.index, f"mend:{len(self.outcomes)}")
        target = action.target_id
        if action.action == "put_down":
            return placing.down(setting, state, held, rng)
        if action.action == "move_away":
            return placing.aside(setting, state, held, rng)
        if target is None and action.action == "throw_away":
            return placing.taken_out(setting, state, held)
        if target is None or target not in state.facts.bodies:
            return self._unknown(target)
        far = self._too_far(target)
        if far is not None:
            return far
        return placing.put(setting, state, held, action.action, target, action.part, rng)

    def _unknown(self, key: int | None) -> str:
        if key is None:
            return "it needs the id of an object"
        if key == self.in_hand:
            return f"{key} is in the hand"
        return f"no object {key} in this scene"

    def _too_far(self, key: int) -> str | None:
        body = self.state.facts.bodies[key]
        if self.setting.arms.reaches(self.state.place.point, body.footprint, key):
            return None
        return f"{called(self.state.facts, key)} is out of reach: go there first"


def mending_of(
    data: Dataset, item: SceneItem, library: Library, client: Client, seed: int = 0
) -> Mending:
    """A scene of a data set, to be mended. ``library`` is the one it was built with: InputError for
    another."""
    if library.sha256 != data.info.assets_sha256:
        text = "dataset.json: assets_sha256: other models than the ones at hand (--assets)"
        raise InputError([text])
    return Mending(item.scene, item.household, data.catalog, library, client, seed)
