"""States follow from joints and variants; between two limits nothing is certain."""

import numpy as np
import pytest
from sdgen.actions import at_rest, in_state
from sdgen.geometry import apply
from sdgen.library.records import AssetInfo, StateRule
from sdgen.library.states import derive_states, object_from_part, state_parts, undecided_states
from sdgen.scene import ObjectInstance, Pose
from sdgen.seeding import lane

FRIDGE = AssetInfo.model_validate(
    {
        "id": "fridge_01",
        "category": "fridge",
        "licence": "CC-BY-4.0",
        "source": "test",
        "extents_m": (0.6, 0.6, 1.7),
        "mass_kg": 60,
        "parts": [
            {"name": "body", "faces": 10},
            {"name": "door", "faces": 10, "joint": "door"},
            {"name": "freezer", "faces": 10, "joint": "freezer"},
            {"name": "lamp", "faces": 2},
        ],
        "joints": [
            {
                "name": name,
                "type": "revolute",
                "origin_m": (0.3, 0.3, 0),
                "axis": (0, 0, 1),
                "lower": 0,
                "upper": 1.8,
            }
            for name in ("door", "freezer")
        ],
        "variants": {
            "default": ["body", "door", "freezer"],
            "lit": ["body", "door", "freezer", "lamp"],
        },
        "states": [
            {"state": "CLOSED", "joint": "door", "max": 0.03},
            {"state": "OPEN", "joint": "door", "min": 0.5, "parts": ["door"]},
            {"state": "CLOSED", "joint": "freezer", "max": 0.03},
            {"state": "OPEN", "joint": "freezer", "min": 0.5, "parts": ["freezer"]},
            {"state": "ON", "variants": ["lit"], "parts": ["lamp"]},
            {"state": "OFF", "variants": ["default"]},
        ],
    }
)


@pytest.mark.parametrize(
    ("joints", "states", "undecided"),
    [
        ({}, ("CLOSED", "OFF"), ()),
        ({"door": 1.0}, ("OFF", "OPEN"), ()),
        ({"freezer": 0.6}, ("OFF", "OPEN"), ()),
        ({"door": 0.2}, ("OFF",), ("CLOSED", "OPEN")),
        ({"door": 1.0, "freezer": 0.2}, ("OFF", "OPEN"), ("CLOSED", "OPEN")),
    ],
)
def test_open_needs_one_door_closed_needs_all(joints, states, undecided):
    assert derive_states(FRIDGE, "default", joints) == states
    assert undecided_states(FRIDGE, "default", joints) == undecided


#: A bin that shuts with its lid unless it is full: then it has none.
BIN = FRIDGE.model_copy(
    update={
        "variants": {"default": ("body", "door"), "full": ("body",)},
        "states": tuple(
            StateRule.model_validate(rule)
            for rule in (
                {"state": "CLOSED", "joint": "door", "max": 0.03, "variants": ("default",)},
                {"state": "OPEN", "joint": "door", "min": 0.5, "variants": ("default",)},
                {"state": "CLOSED", "joint": "freezer", "max": 0.03, "variants": ("full",)},
            )
        ),
    }
)


@pytest.mark.parametrize(
    ("variant", "joints", "states", "undecided"),
    [
        ("default", {"door": 0.2}, (), ("CLOSED", "OPEN")),
        ("full", {"door": 0.2}, ("CLOSED",), ()),
        # Nor does a rule that cannot hold keep the others from saying CLOSED.
        ("default", {"door": 0.0, "freezer": 1.0}, ("CLOSED",), ()),
        ("full", {"freezer": 0.2}, (), ("CLOSED",)),
    ],
)
def test_the_rules_of_another_variant_say_nothing(variant, joints, states, undecided):
    assert derive_states(BIN, variant, joints) == states
    assert undecided_states(BIN, variant, joints) == undecided


def test_the_evidence_of_open_is_the_door_that_is_open():
    assert state_parts(FRIDGE, "OPEN", "default", {"freezer": 1.0}) == ("freezer",)
    assert state_parts(FRIDGE, "ON", "lit", {}) == ("lamp",)
    assert state_parts(FRIDGE, "OFF", "default", {}) == ("body", "door", "freezer")


def test_a_part_turns_about_its_hinge():
    moved = object_from_part(FRIDGE, "door", {"door": np.pi / 2})
    assert np.allclose(apply(moved, [(0.3, -0.3, 1.0)]), [(0.9, 0.3, 1.0)])


def _a_fridge() -> ObjectInstance:
    return ObjectInstance(
        id=1,
        category="fridge",
        asset="fridge_01",
        pose=Pose(position_m=(0, 0, 0), quat_xyzw=(0, 0, 0, 1)),
        room_id=2,
    )


def test_every_state_can_be_reached_and_left():
    item = _a_fridge()
    for state in FRIDGE.state_names:
        for scene in range(20):
            changed = in_state(item, FRIDGE, state, lane(0, scene, "state"))
            assert changed is not None
            assert state in changed.states
            assert not undecided_states(FRIDGE, changed.variant, changed.joints)
            assert at_rest(changed, FRIDGE).states == ("CLOSED", "OFF")
    assert in_state(item, FRIDGE, "BROKEN", lane(0, 0, "state")) is None


def test_what_is_opened_stands_anywhere_from_ajar_to_wide():
    item = _a_fridge()
    drawn = [in_state(item, FRIDGE, "OPEN", lane(0, k, "state")).joints for k in range(300)]
    for rule in (rule for rule in FRIDGE.states if rule.state == "OPEN"):
        values = [joints[rule.joint] for joints in drawn if joints.get(rule.joint)]
        upper = FRIDGE.joint(rule.joint).upper
        assert min(values) < rule.min + 0.05 + 0.1 * (upper - rule.min), "some stand ajar"
        assert min(values) >= rule.min + 0.05, "none so near to the limit that one would doubt it"
        assert upper - 0.1 * (upper - rule.min) < max(values) <= upper
