"""What planners do again and again: fetch a thing, put it away, look what came of it."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass

from sdgen.agent.mend import placing
from sdgen.agent.mend.leaves import is_open, shut_in
from sdgen.agent.mend.mending import Mending
from sdgen.agent.mend.records import Action
from sdgen.hazards.remedies import Remedies
from sdgen.scene import ObjectInstance
from sdgen.seeding import lane

#: A place is where one stands already when it is no further, metres.
NEAR_M = 0.05


@dataclass(frozen=True)
class Hands:
    """An agent's hands on a scene that is being mended; it knows all of the scene."""

    mending: Mending

    def do(
        self,
        action: str,
        object_id: int | None = None,
        target_id: int | None = None,
        part: str | None = None,
    ) -> bool:
        """Whether an action was done."""
        asked = Action(action=action, object_id=object_id, target_id=target_id, part=part)
        return self.mending.do(asked).done

    def at(self, key: int, nearest: bool = False) -> bool:
        """Whether a thing is got at from here, or from where one could go to; what is put on or
        into it needs the ``nearest`` place."""
        mending = self.mending
        body = mending.facts.bodies.get(key)
        if body is not None and mending.setting.arms.reaches(
            mending.place.point, body.footprint, key
        ):
            if not nearest:
                return True
            room_id = body.item.room_id
            there = mending.setting.arms.beside(mending.place, body.footprint, room_id, key)
            if there is None or math.dist(there.point, mending.place.point) < NEAR_M:
                return True
        return self.do("go_to", key)

    def fetch(self, key: int) -> bool:
        """A thing taken into the hand: what it is shut in is opened and shut again, what stands on
        it is put beside it."""
        if not self.at(key):
            return False
        around = shut_in(self.mending.facts, key)
        opened: list[str] = []
        if around is not None:
            opened = self._open_until_free(key, around)
            if not self.at(key):
                return False
        for other in self.on_top(key):
            if self.do("grab", other):
                self.lay_down(self.under(key))
                self.at(key)
        got = self.do("grab", key)
        if around is not None:
            for joint in opened:
                self.do("close", around, part=joint)
        return got

    def _open_until_free(self, key: int, around: int) -> list[str]:
        opened: list[str] = []
        body = self.mending.facts.bodies[around]
        if not self.at(around):
            return opened
        for hollow in body.info.containers:
            joint = hollow.closed_by
            if shut_in(self.mending.facts, key) != around or joint is None or joint in opened:
                continue
            if is_open(self.mending.facts.bodies[around].item, body.info, joint):
                continue
            if self.do("open", around, part=joint):
                if shut_in(self.mending.facts, key) == around:
                    self.do("close", around, part=joint)
                else:
                    opened.append(joint)
        return opened

    def on_top(self, key: int) -> list[int]:
        """Loose things on or in a thing."""
        facts = self.mending.facts
        return [
            other
            for other, body in facts.bodies.items()
            if not body.item.fixed
            and any(
                r.holds and r.target_id == key for r in (*facts.on(other), *facts.inside(other))
            )
        ]

    def under(self, key: int) -> int | None:
        """What a thing is on, if that is an object."""
        facts = self.mending.facts
        held = (r.target_id for r in facts.on(key) if r.holds and r.target_id in facts.bodies)
        return next(held, None)

    def lay_down(self, *targets: int | None) -> bool:
        """What is in the hand put back on the first of these that takes it, else aside, else on the
        floor."""
        for target in targets:
            if target is not None and self.at(target, True) and self.do("put_on", target_id=target):
                return True
        return self.do("move_away") or self.do("put_down")

    def store(self, key: int, target: int, shuts: bool = True) -> bool:
        """What is in the hand put into a hollow of a target for such things, opened before, and
        where it ``shuts`` them shut after; those first that are shut or have no leaf."""
        if not self.at(target, nearest=True):
            return False
        for name, joint in self.hollows(target):
            was_open = is_open(self._item(target), self.mending.facts.bodies[target].info, joint)
            if not was_open and not self.do("open", target, part=name):
                continue
            done = self.do("put_in", key, target, name)
            if joint is None or not (shuts if done else not was_open):
                closed = True
            else:
                closed = self.do("close", target, part=joint)
            if done and closed:
                return True
            # Something is in the way of the leaf: what was just put there.
            if done and not self.do("grab", key):
                return False
        return False

    def fits(self, target: int, action: str, without: int | None = None) -> bool:
        """Whether a target has room for what is in the hand, by its measures, if another thing were
        not there; nothing is done."""
        mending, held = self.mending, self.mending.state.held
        if held is None:
            return False
        layout = mending.state.layout
        if without is not None:
            layout = layout.copy()
            layout.drop(without)
        rng = lane(mending.seed, mending.scene.index, f"mend:look:{target}:{without}")
        remedies = Remedies(mending.facts, layout, mending.setting.context, (), rng)
        fit = {name for name, _ in self.hollows(target)}
        spots = remedies.put_at(
            action, held.item, self._item(target), fit.__contains__, layout, 1, placing.SPOTS_DRAWN
        )
        return next(spots, None) is not None

    def hollows(self, target: int) -> Iterator[tuple[str, str | None]]:
        """Hollows of a target for what is in the hand, and the joint that shuts each."""
        mending, held = self.mending, self.mending.state.held
        owner = self._item(target)
        info = mending.facts.bodies[target].info
        if held is None:
            return
        may = mending.setting.context.may_hold
        fit = [h for h in info.containers if may(held.item.category, owner.category, h.name)]
        fit.sort(key=lambda h: h.closed_by is not None and is_open(owner, info, h.closed_by))
        yield from ((hollow.name, hollow.closed_by) for hollow in fit)

    def _item(self, key: int) -> ObjectInstance:
        return self.mending.facts.bodies[key].item

    def nearest(self, categories: Collection[str], key: int) -> list[int]:
        """Furniture of these categories, the nearest to a thing (or to where it was) first."""
        facts = self.mending.facts
        here = self.mending.start.facts.bodies[key].center.tolist()
        bodies = [facts.bodies[other] for other in facts.ids_of(categories)]
        found = [body for body in bodies if body.item.fixed and body.item.id != key]
        found.sort(key=lambda body: (math.dist(here, body.center.tolist()), body.item.id))
        return [body.item.id for body in found]
