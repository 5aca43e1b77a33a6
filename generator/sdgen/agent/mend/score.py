"""How well a scene was mended, and how many actions its remedies take."""

from __future__ import annotations

from sdgen.agent.mend.mending import Mending
from sdgen.agent.mend.records import MendScore, Pair
from sdgen.hazards.twin import GONE, PUT, SET_BACK

#: Actions that the catalogue's remedies take: where one goes, what is done there; of what is
#: carried, where it is got from and put to; with a leaf before that, it is opened and shut.
ONE_PLACE, CARRIED, CARRIED_ASIDE, LEAF = 2, 4, 3, 2


def score(mending: Mending) -> MendScore:
    """The score of a scene as it is mended by now."""
    before, now = mending.start.pairs, mending.pairs
    removed = sorted(before.keys() - now.keys())
    unadvised = [pair for pair in removed if not _as_advised(mending, pair)]
    caused = sorted(now.keys() - before.keys())
    return MendScore(
        anomalies=len(before),
        removed=len(removed),
        unadvised=len(unadvised),
        unadvised_reported=sum(before[pair] for pair in unadvised),
        left_reported=sum(told for pair, told in now.items() if pair in before),
        caused=len(caused),
        caused_reported=sum(now[pair] for pair in caused),
        actions=len(mending.outcomes),
        refused=sum(not one.done for one in mending.outcomes),
        remedy_actions=sum(remedy_actions(mending, pair) for pair in before),
        walked_m=round(mending.state.walked_m, 3),
    )


def remedy_actions(mending: Mending, pair: Pair) -> int:
    """How many actions the first remedy of an anomaly takes that this home has a target for."""
    setting, facts = mending.setting, mending.start.facts
    rules = setting.catalog.hazard(pair[1]).remedy
    for rule in rules:
        if rule.action in (*SET_BACK, *GONE):
            return ONE_PLACE
        if rule.action == "move_away":
            return CARRIED_ASIDE
        for target in facts.ids_of(rule.targets):
            info = facts.bodies[target].info
            shut = rule.action == "put_in" and any(c.closed_by for c in info.containers)
            return CARRIED + LEAF * shut
    return CARRIED


def _as_advised(mending: Mending, pair: Pair) -> bool:
    """Whether what became of an anomaly's object is what one of its remedies says; so it is where
    nothing was done to the object itself."""
    key, hazard = pair
    facts = mending.facts
    before = mending.start.facts.bodies[key].item
    rules = mending.setting.catalog.hazard(hazard).remedy
    if key not in facts.bodies:
        return any(rule.action in (*GONE, "throw_away") for rule in rules)
    now = facts.bodies[key].item
    if (now.pose, now.joints, now.variant) == (before.pose, before.joints, before.variant):
        return True
    if (now.joints, now.variant) != (before.joints, before.variant):
        return any(rule.action in SET_BACK for rule in rules)
    for rule in rules:
        targets = facts.holds(key, PUT[rule.action]) if rule.action in PUT else ()
        wanted = ("floor",) if rule.action == "move_away" else rule.targets
        if any(facts.category(target) in wanted for target in targets):
            return True
    return False
