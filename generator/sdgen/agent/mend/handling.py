"""What is done to a thing where it is: grabbed, switched off, put out, emptied, wiped up."""

from __future__ import annotations

from dataclasses import replace

from sdgen.agent.mend.leaves import shut_in
from sdgen.agent.mend.state import Held, Setting, State, called, changed, lost, with_facts
from sdgen.catalog.records import Catalog
from sdgen.hazards.certify import categories_of
from sdgen.hazards.twin import set_back
from sdgen.pipeline.putting import facts_after, stays


def grabbed(setting: Setting, state: State, key: int) -> State | str:
    """The thing in the hand, all else as it was."""
    facts = state.facts
    item = facts.bodies[key].item
    if state.held is not None:
        return f"the hand is full: it holds the {state.held.item.category} {state.held.item.id}"
    if item.fixed:
        return f"{called(facts, key)} is fixed"
    around = shut_in(facts, key)
    if around is not None:
        return f"{called(facts, key)} is shut in by {called(facts, around)}: open it first"
    after = facts_after(facts, {key: None}, setting.library.infos, setting.catalog)
    fallen = lost(facts, after)
    if fallen is not None:
        return f"{called(facts, fallen)} rests on {called(facts, key)}"
    pairs = {pair: told for pair, told in state.pairs.items() if pair[0] == key}
    return replace(with_facts(setting, state, after), held=Held(item, pairs))


def concerned(catalog: Catalog, action: str, category: str) -> bool:
    """Whether some hazard of such things is undone by this action."""
    return any(
        any(rule.action == action for rule in hazard.remedy)
        and category in (categories_of(hazard.predicate) or ())
        for hazard in catalog.hazards
    )


def back_at_rest(setting: Setting, state: State, key: int, action: str) -> State | str:
    """A thing ``switch_off``, ``put_out`` or ``empty`` has brought back to how it comes."""
    facts = state.facts
    body = facts.bodies[key]
    around = shut_in(facts, key)
    if around is not None:
        return f"{called(facts, key)} is shut in by {called(facts, around)}: open it first"
    wanted = any(
        pair[0] == key
        and action in (rule.action for rule in setting.catalog.hazard(pair[1]).remedy)
        for pair in state.pairs
    )
    burns = concerned(setting.catalog, "put_out", body.item.category)
    states = facts.states(key)
    may = {
        "switch_off": not burns and any(s == "ON" or s.endswith("_ON") for s in states),
        "put_out": burns,
        "empty": "FULL" in states or concerned(setting.catalog, action, body.item.category),
    }[action]
    ways = set_back(body.item, setting.library.info(body.item.asset), action)
    ways = tuple(one for one in ways if one.variant != body.item.variant)
    if not (may or wanted) or not ways:
        return f"{called(facts, key)} is nothing to {action.replace('_', ' ')} as it is"
    why = ""
    for after in ways:
        found = changed(setting, state, {key: after})
        if isinstance(found, str):
            why = found
        elif body.item.fixed or stays(key, found.facts, setting.library, setting.client):
            return found
        else:
            why = "it would not stay"
    return f"{called(facts, key)} cannot be brought back to rest: {why}"


def cleaned(setting: Setting, state: State, key: int, action: str) -> State | str:
    """What ``wipe_up`` or ``sweep_up`` concerns is gone."""
    facts = state.facts
    if not concerned(setting.catalog, action, facts.category(key)):
        return f"{called(facts, key)} is nothing to {action.replace('_', ' ')}"
    around = shut_in(facts, key)
    if around is not None:
        return f"{called(facts, key)} is shut in by {called(facts, around)}: open it first"
    return changed(setting, state, {key: None})
