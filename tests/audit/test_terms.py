"""Each term of the catalogue's language, on things put where it holds, and where it does not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.audit.dataset import ROOT, DataSet, Floats, Json, Scene
from tests.audit.drafts import Draft
from tests.audit.labels import world_of
from tests.audit.terms import TERMS, answer, measured
from tests.audit.told import NO, YES, Told, about, every, number, some

UNSURE_YES, UNSURE_NO = Told(True, False), Told(False, False)
UP = np.array([0.0, 0.0, 1.0])
Place = Callable[[Draft], int]


@pytest.fixture(scope="module")
def sample() -> Scene:
    return next(DataSet(ROOT / "output" / "sample").scenes())


def table(draft: Draft, x: float = 0.0) -> tuple[int, Floats]:
    """A bare table in open floor, and a point of its top, ``x`` metres ahead of its middle."""
    id = draft.on_floor("kitchen_table_01")
    thing = draft.thing(id)
    top = max(support["z_m"] for support in thing.record["supports"])
    return id, thing.position + thing.turn @ np.array([x, 0.0, top])


def half_depth(draft: Draft, id: int) -> float:
    return float(draft.thing(id).record["extents_m"][0]) / 2


def on_table(asset: str, beyond: float | None = None, **fields: Any) -> Place:
    """In the middle of a table; or its middle so far beyond the front edge (negative: before)."""

    def place(draft: Draft) -> int:
        id, at = table(draft)
        if beyond is not None:
            at = at + np.array([half_depth(draft, id) + beyond, 0.0, 0.0])
        return draft.put(asset, at, **fields)

    return place


def on_floor(asset: str, **fields: Any) -> Place:
    return lambda draft: draft.on_floor(asset, **fields)


def beside(asset: str, other: str, gap: float, yaw: float = 0.0, **fields: Any) -> Place:
    """On the floor, that far from the box of another, ahead of it."""

    def place(draft: Draft) -> int:
        stood = draft.thing(draft.on_floor(other, **fields))
        id = draft.on_floor(asset, yaw=yaw)
        thing = draft.thing(id)
        draft.move(id, np.array([stood.box[1, 0] + gap - thing.box[0, 0], 0.0, 0.0]))
        return id

    return place


def over_a_bed(rise: float) -> Place:
    def place(draft: Draft) -> int:
        bed = draft.thing(draft.on_floor("bed_01"))
        top = max(support["z_m"] for support in bed.record["supports"])
        return draft.put("vase_01", bed.position + (top + rise) * UP, room=bed.room)

    return place


def dishes(many: int, state: str) -> Place:
    """So many plates on a table, apart from each other, in a state."""

    def place(draft: Draft) -> int:
        _, at = table(draft)
        fields = {"variant": "dirty" if state == "DIRTY" else "default", "states": [state]}
        for k in range(many):
            id = draft.put("plate_01", at + np.array([0.0, -0.25 + 0.25 * k, 0.0]), **fields)
        return id

    return place


def holder(asset: str, held: str | None) -> Place:
    """A thing with another on it."""

    def place(draft: Draft) -> int:
        id = draft.on_floor(asset)
        if held is not None:
            draft.on_top(held, draft.thing(id))
        return id

    return place


def term(kind: str, **fields: Any) -> Json:
    """A term as `catalogue.json` has it."""
    given: dict[str, Json] = {
        "height": {"min_m": None, "max_m": None, "margin_m": 0.03, "evidence": "height_m"},
        "distance": {
            **{"to": [], "to_zone": [], "to_state": None, "from_above": False},
            **{"same_room": False, "min_m": None, "max_m": None, "margin_m": 0.05},
        },
        "relation": {"targets": [], "target_state": None},
        "zone": {"overlap": 0.5, "margin": 0.15},
        "overhang": {"min_m": None, "max_m": None, "margin_m": 0.01},
        "edge": {"min_m": None, "max_m": None, "margin_m": 0.02},
        "above": {"within_m": 0.3, "drop_m": 0.3, "margin_m": 0.05},
        "count": {"state": None, "min": None, "max": None, "within_m": None, "margin_m": 0.05},
        "holds": {"relation": None, "state": None, "min": 1, "max": None},
        "facing": {"max_deg": 45.0, "margin_deg": 5.0},
        "facing_away": {"min_deg": 90.0, "margin_deg": 5.0},
    }
    return {"kind": kind, **given.get(kind, {}), **fields}


KNIFE = term("category", any_of=["knife"])
LIT = term("state", any_of=["ON"])
ON_TABLE = term("relation", relation="ON", targets=["kitchen_table"])
LOW = term("height", max_m=0.5)
REACH = term("height", max_m=0.65, evidence="reach_height_m")
NEAR = term("distance", to=["bucket"], max_m=0.3)
FAR = term("distance", to=["bucket"], min_m=0.3)
OVER = term("overhang", min_m=0.05)
EDGE = term("edge", max_m=0.08)
ABOVE = term("above", of=["bed"])
PILE = term("count", of=["plate"], state="DIRTY", min=3, on="same")
CLOSE_BY = term("count", of=["plate"], min=3, within_m=0.2)
HELD = term("holds", category=["mug"], relation="ON")
AHEAD, AWAY = term("facing", to=["bucket"]), term("facing_away", away_from=["bucket"])
HALF_TURN = float(np.pi)
LIT_CANDLE = {"variant": "lit", "states": ["ON"]}

CASES: list[tuple[Json, Place, Told]] = [
    (KNIFE, on_floor("knife_01"), YES),
    (KNIFE, on_floor("mug_02"), NO),
    (LIT, on_table("candle_01", **LIT_CANDLE), YES),
    (LIT, on_table("candle_01"), NO),
    (ON_TABLE, on_table("mug_02"), YES),
    (ON_TABLE, on_table("mug_02", beyond=0.3), NO),
    (LOW, on_floor("mug_02"), YES),
    (LOW, on_table("mug_02"), NO),
    (term("height", min_m=0.74, max_m=0.9, margin_m=0.2), on_table("mug_02"), UNSURE_YES),
    (NEAR, beside("mug_02", "bucket_01", 0.2), YES),
    (NEAR, beside("mug_02", "bucket_01", 0.28), UNSURE_YES),
    (NEAR, beside("mug_02", "bucket_01", 0.33), UNSURE_NO),
    (NEAR, beside("mug_02", "bucket_01", 0.45), NO),
    (FAR, beside("mug_02", "bucket_01", 0.45), YES),
    (FAR, beside("mug_02", "bucket_01", 0.2), NO),
    (NEAR | {"to_state": "FULL"}, beside("mug_02", "bucket_01", 0.1), NO),
    (OVER, on_table("frying_pan_01", beyond=-0.08), YES),
    (OVER, on_table("mug_02"), NO),
    (OVER, on_floor("mug_02"), NO),
    (EDGE, on_table("mug_02", beyond=-0.06), YES),
    (EDGE, on_table("mug_02", beyond=-0.3), NO),
    (EDGE, on_floor("mug_02"), NO),
    (ABOVE, over_a_bed(0.8), YES),
    (ABOVE, over_a_bed(0.1), NO),
    (ABOVE, on_floor("vase_01"), NO),
    (PILE, dishes(3, "DIRTY"), YES),
    (PILE, dishes(2, "DIRTY"), NO),
    (PILE, dishes(3, "CLEAN"), NO),
    (CLOSE_BY, dishes(2, "DIRTY"), NO),
    (HELD, holder("coffee_table_01", "mug_02"), YES),
    (HELD, holder("coffee_table_01", None), NO),
    (AHEAD, beside("fan_01", "bucket_01", 0.4, yaw=HALF_TURN), YES),
    (AHEAD, beside("fan_01", "bucket_01", 0.4), NO),
    (AWAY, beside("fan_01", "bucket_01", 0.4), YES),
    (AWAY, beside("fan_01", "bucket_01", 0.4, yaw=HALF_TURN), NO),
    (term("all", terms=[KNIFE, LOW]), on_floor("knife_01"), YES),
    (term("all", terms=[KNIFE, LOW]), on_table("knife_01"), NO),
    (term("any", terms=[KNIFE, LOW]), on_table("knife_01"), YES),
    (term("not", term=KNIFE), on_floor("knife_01"), NO),
    (term("not", term=NEAR), beside("mug_02", "bucket_01", 0.28), UNSURE_NO),
]


@pytest.mark.parametrize(("asked", "place", "told"), CASES)
def test_a_term_holds_where_it_should(asked: Json, place: Place, told: Told, sample: Scene) -> None:
    draft = Draft(sample)
    id = place(draft)
    assert answer(asked, world_of(draft.scene), id).told == told


def test_zones_and_rooms_are_those_of_the_scene(sample: Scene) -> None:
    world = world_of(sample)
    zone = term("zone", any_of=["doorway", "walkway"])
    for body in world.bodies.values():
        in_zone = answer(zone, world, body.id).told.holds
        tags = set(sample.nodes[body.id]["tags"])
        assert in_zone or not tags & {"IN_DOORWAY", "IN_WALKWAY"}
        kind = world.room_types(body.id)[0]
        assert answer(term("room", any_of=[kind]), world, body.id).told.holds
        assert answer(term("room", any_of=["nowhere"]), world, body.id).told == NO


def test_a_child_climbs(sample: Scene) -> None:
    """A table is out of reach of who reaches 0.65 m, but not from a stool beside it."""
    draft = Draft(sample)
    id = on_table("knife_01", beyond=-0.1)(draft)
    assert answer(REACH, world_of(draft.scene), id).told == NO
    stool = Draft(sample)
    id = on_table("knife_01", beyond=-0.1)(stool)
    step = stool.on_floor("step_stool_01")
    thing = stool.thing(id)
    stool.move(step, np.array([thing.box[1, 0] + 0.3 - stool.thing(step).box[0, 0], 0.0, 0.0]))
    found = answer(REACH, world_of(stool.scene), id)
    assert found.told == YES
    assert found.evidence["climbed_id"] == step


def test_what_is_measured_of_near_misses(sample: Scene) -> None:
    draft = Draft(sample)
    id = on_table("mug_02")(draft)
    world = world_of(draft.scene)
    both = term("all", terms=[LOW, OVER, term("not", term=EDGE), term("distance", to=["nothing"])])
    assert measured(both, world, id).keys() == {"height_m", "overhang_m"}


def test_every_term_has_a_case() -> None:
    kinds = {asked["kind"] for asked, _, _ in CASES} | {"zone", "room"}
    assert kinds == set(TERMS)


@pytest.mark.parametrize(
    ("parts", "both", "either"),
    [
        ([YES, YES], YES, YES),
        ([YES, NO], NO, YES),
        ([UNSURE_YES, NO], NO, UNSURE_YES),
        ([UNSURE_NO, YES], UNSURE_NO, YES),
        ([], YES, NO),
    ],
)
def test_strong_kleene_logic(parts: list[Told], both: Told, either: Told) -> None:
    assert every(parts) == both
    assert some(parts) == either


def test_limits_are_undecided_within_their_margin() -> None:
    limit = about(1.0, 0.1)
    told = [limit.at_most(value) for value in (0.9, 0.95, 1.0, 1.05, 1.1)]
    assert told == [YES, UNSURE_YES, UNSURE_YES, UNSURE_NO, NO]


def test_numbers_are_undecided_where_it_matters() -> None:
    members = [YES, YES, UNSURE_NO]
    assert number(members, 2, None) == (YES, 2)
    assert number(members, 3, None) == (UNSURE_NO, 2)
    assert number(members, None, 2) == (UNSURE_YES, 2)
    assert number(members, 4, None) == (NO, 2)
