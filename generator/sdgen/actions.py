"""How a state is reached: joint values and mesh variant that make an asset OPEN, ON, BROKEN …"""

from __future__ import annotations

import numpy as np

from sdgen.library.records import AssetInfo, Joint, StateRule
from sdgen.library.states import derive_states
from sdgen.scene import ObjectInstance

#: How far beyond a limit a drawn joint value stays, radians or metres: so ajar, a leaf is seen to
#: stand open, and a rounded value is no doubt.
JOINT_MARGIN = 0.05


def _joint_range(rule: StateRule, joint: Joint) -> tuple[float, float]:
    low = joint.lower if rule.min is None else max(joint.lower, rule.min)
    high = joint.upper if rule.max is None else min(joint.upper, rule.max)
    if rule.min is not None:
        low = min(low + JOINT_MARGIN, (low + high) / 2)
    return low, max(low, high)


def in_state(
    item: ObjectInstance, info: AssetInfo, state: str, rng: np.random.Generator
) -> ObjectInstance | None:
    """The object brought into ``state``; None when the model cannot be in it.

    A joint state picks one joint and a value clear of the limit (CLOSED shuts every joint); a
    variant state picks one of its variants that are nothing further: a tub that is FULL does not
    run over.
    """
    rules = _plainest([rule for rule in info.states if rule.state == state], info)
    if not rules:
        return None
    joints = dict(item.joints)
    variant = item.variant
    if state == "CLOSED":
        joints = {
            **joints,
            **{r.joint: max(0.0, info.joint(r.joint).lower) for r in rules if r.joint},
        }
    else:
        rule = rules[int(rng.integers(len(rules)))]
        if rule.joint is not None:
            low, high = _joint_range(rule, info.joint(rule.joint))
            joints[rule.joint] = round(float(rng.uniform(low, high)), 4)
        if rule.variants:
            variant = rule.variants[int(rng.integers(len(rule.variants)))]
    return settled_states(item.model_copy(update={"joints": joints, "variant": variant}), info)


def _plainest(rules: list[StateRule], info: AssetInfo) -> list[StateRule]:
    """The rules with those of their variants alone that are in the fewest states."""
    states = {v: len(derive_states(info, v, {})) for rule in rules for v in rule.variants}
    least = min(states.values(), default=0)
    kept = [
        rule.model_copy(update={"variants": tuple(v for v in rule.variants if states[v] == least)})
        for rule in rules
    ]
    return [new for new, old in zip(kept, rules, strict=True) if new.variants or not old.variants]


def settled_states(item: ObjectInstance, info: AssetInfo) -> ObjectInstance:
    """The object with the states and parts that its variant and joints imply."""
    return item.model_copy(
        update={
            "states": derive_states(info, item.variant, item.joints),
            "parts": info.variants[item.variant],
        }
    )


def at_rest(item: ObjectInstance, info: AssetInfo) -> ObjectInstance:
    """The object as nobody left it: every joint shut, the default variant."""
    shut = {j.name: min(max(0.0, j.lower), j.upper) for j in info.joints}
    return settled_states(item.model_copy(update={"joints": shut, "variant": "default"}), info)
