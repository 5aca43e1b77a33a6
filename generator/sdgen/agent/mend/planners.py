"""The planner that carries out what the catalogue's remedies say; it knows all of the scene."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice

from sdgen.agent.mend.hands import Hands
from sdgen.agent.mend.leaves import shut_in
from sdgen.agent.mend.making_room import in_the_way, room_made
from sdgen.agent.mend.mending import Mending
from sdgen.agent.mend.planning import Left, carries, cupboards, in_order, why_left
from sdgen.agent.mend.records import Pair
from sdgen.catalog.records import RemedyRule
from sdgen.hazards.remedies import goes_on
from sdgen.hazards.twin import GONE, SET_BACK

#: So often room is made for one thing, and so many cupboards are tried that no remedy names.
FULL_TRIED, ELSEWHERE_TRIED = 3, 6


def remedy_planner(mending: Mending, pairs: Iterable[Pair] | None = None) -> tuple[Left, ...]:
    """Carries out the remedy of each of these anomalies (of all, where none are given), with its
    alternatives where one is refused or brings about another hazard; where all that it names is
    full, room is made, and what still goes nowhere goes into any cupboard with which the hazard is
    gone. What is left is returned."""
    left = []
    for pair in in_order(mending, pairs):
        since = len(mending.outcomes)
        if pair in mending.pairs and not _Remedying(mending, pair).carried_out():
            left.append(Left(pair, why_left(mending, since)))
    return tuple(left)


class _Remedying:
    """One anomaly being undone: what held before it was touched must be all that holds after."""

    def __init__(self, mending: Mending, pair: Pair) -> None:
        self.mending, self.pair = mending, pair
        self.hands = Hands(mending)
        self.before = frozenset(mending.pairs)
        self.under = self.hands.under(pair[0])

    def carried_out(self) -> bool:
        """Whether it is undone, and nothing else came about."""
        key, hazard = self.pair
        catalog, facts = self.mending.setting.catalog, self.mending.facts
        rules = catalog.hazard(hazard).remedy
        category = facts.category(key)
        for rule in (one for one in rules if one.action in (*SET_BACK, *GONE)):
            if self._free(key) and self.hands.do(rule.action, key) and self._good():
                return True
        if facts.bodies[key].item.fixed or not any(map(carries, rules)):
            return False
        if not self.hands.fetch(key):
            return False
        for usual in (True, False):
            for rule in filter(carries, rules):
                for target in rule.targets:
                    sensible = rule.action != "put_on" or goes_on(catalog, category, target)
                    if sensible == usual and self._put(rule, target):
                        return True
                if usual and rule.action == "move_away" and self._aside():
                    return True
        if self._with_room_made(rules):
            return True
        return self._thrown_out(rules) or self._elsewhere() or self._given_up()

    def _free(self, key: int) -> bool:
        """Gone to, and not shut in any more."""
        if not self.hands.at(key):
            return False
        around = shut_in(self.mending.facts, key)
        return around is None or self.hands.do("open", around)

    def _put(self, rule: RemedyRule, category: str) -> bool:
        key = self.pair[0]
        for target in self.hands.nearest([category], key):
            if not self.hands.fits(target, rule.action):
                continue
            if rule.action == "put_in":
                done = self.hands.store(key, target)
            else:
                done = self.hands.at(target, True) and self.hands.do(rule.action, key, target)
            if self._settled(done):
                return True
        return False

    def _with_room_made(self, rules: Iterable[RemedyRule]) -> bool:
        """Into something full, out of which something else is taken."""
        key, tried = self.pair[0], 0
        full = [
            target
            for rule in rules
            for category in (rule.targets if rule.action == "put_in" else ())
            for target in self.hands.nearest([category], key)
        ]
        for target in full:
            for other in in_the_way(self.hands, target):
                if tried == FULL_TRIED or self.mending.in_hand != key:
                    return False
                tried += 1
                if self._settled(
                    room_made(self.hands, key, target, other, self.under, self.before)
                ):
                    return True
        return False

    def _aside(self) -> bool:
        rooms = self.mending.scene.home.rooms
        here = self.mending.start.facts.bodies[self.pair[0]].item.room_id
        for room in sorted(rooms, key=lambda one: (one.id != here, one.id)):
            if self.hands.do("go_to", room.id) and self._settled(self.hands.do("move_away")):
                return True
        return False

    def _settled(self, done: bool) -> bool:
        """Whether that was it; else the thing is taken into the hand again."""
        if done and self._good():
            return True
        if done:
            self.hands.fetch(self.pair[0])
        return False

    def _good(self) -> bool:
        now = frozenset(self.mending.pairs)
        return self.pair not in now and now <= self.before

    def _thrown_out(self, rules: Iterable[RemedyRule]) -> bool:
        """Where no bin takes what should go into one, it is carried out of the home."""
        if not any(rule.action == "throw_away" for rule in rules):
            return False
        openings = self.mending.scene.home.openings
        doors = [one.object_id for one in openings if one.kind == "front_door"]
        return any(self.hands.at(door) and self.hands.do("throw_away") for door in doors)

    def _elsewhere(self) -> bool:
        """Where nothing that the remedies name takes it, any other hollow for such things that can
        be shut: nobody advises it, but the hazard is gone."""
        key = self.pair[0]
        if self.mending.in_hand != key:
            return False
        nearest = self.hands.nearest(sorted(set(cupboards(self.mending))), key)
        room = (target for target in nearest if self.hands.fits(target, "put_in"))
        for target in islice(room, ELSEWHERE_TRIED):
            if self._settled(self.hands.store(key, target)):
                return True
            if self.mending.in_hand != key:
                return False
        return False

    def _given_up(self) -> bool:
        if self.mending.in_hand == self.pair[0]:
            self.hands.lay_down(self.under)
        return False
