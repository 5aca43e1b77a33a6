"""What shuts hollows and doorways: which leaf is meant, whether it stands open, opened and shut."""

from __future__ import annotations

from collections.abc import Iterator

from sdgen.actions import at_rest, settled_states
from sdgen.agent.mend.state import Setting, State, called, changed
from sdgen.facts import Facts
from sdgen.library.records import AssetInfo
from sdgen.library.states import rule_holds, rules_of
from sdgen.scene import ObjectInstance

#: How far a leaf is opened, of the way from where it counts as open to where it ends: the furthest
#: that there is room for.
OPENED = (1.0, 0.75, 0.5, 0.25, 0.1)


def leaves_of(info: AssetInfo) -> tuple[str, ...]:
    """The joints of a model that open something, in their order."""
    shuts = {hollow.closed_by for hollow in info.containers}
    opens = {rule.joint for rule in info.states if rule.state == "OPEN"}
    return tuple(joint.name for joint in info.joints if joint.name in shuts | opens)


def is_open(item: ObjectInstance, info: AssetInfo, joint: str | None) -> bool:
    """Whether a leaf surely stands open; what no leaf shuts is always open."""
    if joint is None:
        return True
    rules = [rule for rule in rules_of(info, item.variant) if rule.joint == joint]
    holding = {rule.state for rule in rules if rule_holds(rule, item.variant, item.joints)}
    return bool(holding) and "CLOSED" not in holding


def meant(item: ObjectInstance, info: AssetInfo, part: str | None) -> tuple[str, ...] | str:
    """The joints that a part names: itself, or what shuts the hollow of that name; all for None.
    A sentence where there is no such part."""
    leaves = leaves_of(info)
    words = f"the {item.category.replace('_', ' ')} {item.id}"
    if not leaves:
        return f"{words} has nothing that opens or shuts"
    if part is None:
        return leaves
    shuts = {hollow.name: hollow.closed_by for hollow in info.containers}
    joint = part if part in leaves else shuts.get(part)
    if joint is None:
        known = ", ".join(sorted({*leaves, *(name for name, leaf in shuts.items() if leaf)}))
        return f"{words} has no {part!r} that opens or shuts (there is: {known})"
    return (joint,)


def opened(setting: Setting, state: State, key: int, part: str | None) -> State | str:
    """A leaf opened as far as there is room: the named one, else the first that is shut."""
    item = state.facts.bodies[key].item
    info = setting.library.info(item.asset)
    joints = meant(item, info, part)
    if isinstance(joints, str):
        return joints
    shut = [joint for joint in joints if not is_open(item, info, joint)]
    if not shut:
        return f"{called(state.facts, key)} stands open already"
    why = f"{called(state.facts, key)} cannot be opened"
    for after in _ways_open(item, info, shut[0]):
        found = changed(setting, state, {key: after})
        if isinstance(found, State):
            return found
        why = f"{called(state.facts, key)} cannot be opened: {found}"
    return why


def _ways_open(item: ObjectInstance, info: AssetInfo, name: str) -> Iterator[ObjectInstance]:
    joint = info.joint(name)
    rules = [r for r in rules_of(info, item.variant) if r.joint == name and r.state == "OPEN"]
    least = max((r.min for r in rules if r.min is not None), default=None)
    most = min((r.max for r in rules if r.max is not None), default=None)
    if least is None and most is not None:  # one that turns the other way
        start, end = most, joint.lower
    else:
        start, end = least or 0.0, joint.upper
    for share in OPENED:
        value = round(start + share * (end - start), 4)
        after = item.model_copy(update={"joints": {**item.joints, name: value}})
        after = settled_states(after, info)
        if is_open(after, info, name):
            yield after


def shut(setting: Setting, state: State, key: int, part: str | None) -> State | str:
    """The named leaf shut, else all of them, as far as they go."""
    item = state.facts.bodies[key].item
    info = setting.library.info(item.asset)
    joints = meant(item, info, part)
    if isinstance(joints, str):
        return joints
    rest = at_rest(item, info).joints
    wanted = {**item.joints, **{joint: rest[joint] for joint in joints}}
    if wanted == item.joints:
        return f"{called(state.facts, key)} is shut already"
    after = settled_states(item.model_copy(update={"joints": wanted}), info)
    found = changed(setting, state, {key: after})
    if isinstance(found, str):
        return f"{called(state.facts, key)} does not shut: {found}"
    return found


def shut_in(facts: Facts, key: int) -> int | None:
    """What a thing is shut in, however indirectly: something whose leaf before it is not open."""
    todo, seen = [key], set[int]()
    while todo:
        one = todo.pop()
        if one in seen or one not in facts.bodies:
            continue
        seen.add(one)
        for related in facts.inside(one):
            ajar = related.undecided if related.states is not None else ()
            if related.holds and ("CLOSED" in (related.states or ()) or ajar):
                return related.target_id
        held = (*facts.on(one), *facts.inside(one))
        todo += [r.target_id for r in held if r.holds and not _fixed(facts, r.target_id)]
    return None


def _fixed(facts: Facts, key: int) -> bool:
    return key not in facts.bodies or facts.bodies[key].item.fixed
