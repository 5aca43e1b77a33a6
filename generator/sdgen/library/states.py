"""States and poses of parts, derived from variant and joint values; never stored as truth."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from sdgen.geometry import Array, joint_matrix
from sdgen.library.records import AssetInfo, StateRule, Support


def rules_of(asset: AssetInfo, variant: str) -> tuple[StateRule, ...]:
    """The rules that say something of a variant: those of others cannot hold, and need not."""
    return tuple(rule for rule in asset.states if not rule.variants or variant in rule.variants)


def rule_holds(rule: StateRule, variant: str, joints: Mapping[str, float]) -> bool:
    """True when the rule's joint limit and variant both hold."""
    if rule.variants and variant not in rule.variants:
        return False
    if rule.joint is not None:
        value = joints.get(rule.joint, 0.0)
        if rule.min is not None and value < rule.min:
            return False
        if rule.max is not None and value > rule.max:
            return False
    return bool(rule.variants) or rule.joint is not None


def derive_states(asset: AssetInfo, variant: str, joints: Mapping[str, float]) -> tuple[str, ...]:
    """States of the model, sorted. OPEN holds when any joint is open, CLOSED when all are shut."""
    rules = rules_of(asset, variant)
    holding = {r.state for r in rules if rule_holds(r, variant, joints)}
    if "CLOSED" in holding and any(
        r.state == "CLOSED" and not rule_holds(r, variant, joints) for r in rules
    ):
        holding.discard("CLOSED")
    return tuple(sorted(holding))


def rest_states(asset: AssetInfo) -> tuple[str, ...]:
    """States that a model comes in, sorted: its default variant, every joint at 0."""
    return derive_states(asset, "default", {})


def undecided_states(
    asset: AssetInfo, variant: str, joints: Mapping[str, float]
) -> tuple[str, ...]:
    """OPEN and CLOSED when some joint lies in the dead band between the two limits."""
    out: set[str] = set()
    for joint in asset.joints:
        rules = [r for r in rules_of(asset, variant) if r.joint == joint.name]
        if rules and not any(rule_holds(r, variant, joints) for r in rules):
            out.update(r.state for r in rules)
    return tuple(sorted(out))


def state_parts(
    asset: AssetInfo, state: str, variant: str, joints: Mapping[str, float]
) -> tuple[str, ...]:
    """Drawn parts that are the evidence of a state that holds (all drawn parts when unnamed)."""
    drawn = asset.variants[variant]
    named = [
        part
        for rule in asset.states
        if rule.state == state and rule_holds(rule, variant, joints)
        for part in rule.parts
        if part in drawn
    ]
    return tuple(dict.fromkeys(named)) or drawn


def object_from_part(asset: AssetInfo, part: str, joints: Mapping[str, float]) -> Array:
    """4x4 that moves a part's mesh (given at joint value 0) to where its joint puts it."""
    name = asset.part(part).joint
    if name is None:
        return np.eye(4)
    joint = asset.joint(name)
    return joint_matrix(joint.type, joint.origin_m, joint.axis, joints.get(name, 0.0))


def drawn_supports(
    asset: AssetInfo, variant: str, joints: Mapping[str, float]
) -> Iterator[tuple[Support, Array]]:
    """The supports that a variant has, each with the 4x4 that moves it to where its joint is."""
    for support in asset.supports:
        if support.part in asset.variants[variant]:
            yield support, object_from_part(asset, support.part, joints)
