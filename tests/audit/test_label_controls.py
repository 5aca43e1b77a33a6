"""Every check of labels, graphs, households and twins finds an edited file."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any

import numpy as np
import pytest

from tests.audit.checks import CHECKS, TWINS, WHOLE
from tests.audit.dataset import ROOT, DataSet, Finding, Json, Scene
from tests.audit.drafts import Draft
from tests.audit.drawn import LEAST_HOUSEHOLDS

UP = np.array([0.0, 0.0, 1.0])
#: What it finds must be of this object (None: of the scene).
Edit = Callable[[Draft], int | None]


@pytest.fixture(scope="module")
def data() -> DataSet:
    return DataSet(ROOT / "output" / "sample")


@pytest.fixture(scope="module")
def sample(data: DataSet) -> Scene:
    return next(data.scenes())


def first(draft: Draft) -> Json:
    """The first label: of medicine within reach, on a chair."""
    label: Json = draft.files["labels"]["anomalies"][0]
    return label


def lifted(draft: Draft) -> int:
    """Its label names what hangs over two metres higher now."""
    draft.move(first(draft)["object_id"], 2.0 * UP)
    return int(first(draft)["object_id"])


def forgotten(draft: Draft) -> int:
    return int(draft.files["labels"]["anomalies"].pop(0)["object_id"])


def knife_put_down(draft: Draft) -> int:
    """Another thing within reach that nobody labelled."""
    return draft.on_floor("knife_01")


def edited(key: str, value: Any) -> Edit:
    def edit(draft: Draft) -> int:
        first(draft)[key] = value
        return int(first(draft)["object_id"])

    return edit


def other_height(draft: Draft) -> int:
    first(draft)["evidence"]["reach_height_m"] += 0.002
    return int(first(draft)["object_id"])


def near_miss_measured_wrongly(draft: Draft) -> int:
    miss = next(m for m in draft.files["labels"]["lookalikes"] if "reach_height_m" in m["evidence"])
    miss["evidence"]["reach_height_m"] -= 0.01
    return int(miss["object_id"])


def listed_twice(draft: Draft) -> int:
    draft.files["labels"]["anomalies"].append(deepcopy(first(draft)))
    return int(first(draft)["object_id"])


def said_open(draft: Draft) -> int:
    item = next(o for o in draft.files["scene"]["objects"] if "CLOSED" in o["states"])
    item["states"] = ["OPEN"]
    return int(item["id"])


def cut(relation: str) -> Edit:
    def edit(draft: Draft) -> int:
        a, _, b = next(e for e in sorted(draft.original.edges) if e[1] == relation)
        draft.cut(a, relation, b)
        return a

    return edit


def moved_to_its_room_only(draft: Draft) -> int:
    """On what it is told to be on no longer."""
    a = next(t.id for t in draft.original.small if draft.original.on.get(t.id))
    draft.move(a, 0.3 * UP)
    return a


def untagged(draft: Draft) -> int:
    node = next(n for n in draft.files["graph"]["nodes"] if n["tags"])
    node["tags"] = []
    return int(node["id"])


def younger(draft: Draft) -> None:
    draft.files["household"]["members"][0]["age"] = 3


def stranger(draft: Draft) -> None:
    draft.files["household"]["conditions"] = ["sleepwalks"]


EDITS: list[tuple[str, Edit]] = [
    ("labels: do not hold", lifted),
    ("labels: do not hold", listed_twice),
    ("labels: unlisted", forgotten),
    ("labels: unlisted", knife_put_down),
    ("labels: evidence", other_height),
    ("labels: evidence", near_miss_measured_wrongly),
    ("labels: states", said_open),
    ("labels: words", edited("message", "A child can reach it.")),
    ("labels: words", edited("severity", "extreme")),
    ("labels: words", edited("urgency", "low")),
    ("labels: words", edited("remedy", [])),
    ("labels: words", edited("target_id", 1)),
    ("labels: implied by nothing", edited("drawn", False)),
    ("household: report and notify", edited("notify", "now")),
    ("household: not of its template", younger),
    ("household: not of its template", stranger),
    *(("graph: edges anew", cut(r)) for r in ("ON", "INSIDE", "CLOSE", "FACING", "BETWEEN")),
    ("graph: edges anew", moved_to_its_room_only),
    ("graph: tags anew", untagged),
]
#: The checks that have their controls here.
HERE = {name for name, _ in EDITS} - {"household: report and notify"}


@pytest.mark.parametrize(("name", "edit"), EDITS)
def test_an_edited_file_is_found(name: str, edit: Edit, sample: Scene) -> None:
    assert not list(CHECKS[name](sample))
    draft = Draft(sample)
    edited_id = edit(draft)
    found = list(CHECKS[name](draft.scene))
    assert edited_id in [finding.object_id for finding in found], found


def template(**fields: Any) -> Json:
    concerns = {"who": "everyone", "max_age": None, "min_age": None, "living_with": []}
    concerns |= {"by_reach": False, "rooms": [], "raised_by": []}
    hazard = {"group": "safety", "urgency": "high", "never_silent": False}
    return hazard | {"concerns": concerns | fields}


@pytest.mark.parametrize(
    ("concerns", "household", "told"),
    [
        ({}, {}, "now"),
        ({"who": "older_people", "min_age": 65}, {}, "silent"),
        ({"who": "older_people", "min_age": 65}, {"ages": [70]}, "now"),
        ({"who": "children", "max_age": 6}, {"ages": [30, 7]}, "silent"),
        ({"who": "children", "max_age": 6}, {"ages": [30, 6]}, "now"),
        ({"who": "living_with", "living_with": ["dog"]}, {"pets": ["cat"]}, "silent"),
        ({"who": "living_with", "living_with": ["dog"]}, {"pets": ["dog"]}, "now"),
        ({"rooms": ["elsewhere"]}, {}, "silent"),
        ({"rooms": ["here"]}, {}, "now"),
        ({"raised_by": [{"living_with": ["smokes"]}]}, {"opt_outs": ["safety"]}, "silent"),
        (
            {"raised_by": [{"living_with": ["smokes"]}]},
            {"opt_outs": ["safety"], "conditions": ["smokes"]},
            "now",
        ),
        ({}, {"opt_outs": ["candle_on"]}, "silent"),
        ({}, {"notifications": {"candle_on": "summary"}}, "summary"),
    ],
)
def test_the_rule_of_notices(
    concerns: Json, household: Json, told: str, sample: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One label against households and hazards of all kinds."""
    draft = Draft(sample)
    if concerns.get("rooms") == ["here"]:
        thing = sample.things[first(draft)["object_id"]]
        concerns = concerns | {"rooms": [sample.rooms[thing.room]["type"]]}
    people = {"pets": [], "conditions": [], "opt_outs": [], "notifications": {}} | household
    people["members"] = [{"role": "adult", "age": age} for age in household.get("ages", [30])]
    draft.files["household"] = people
    hazard = {"id": "candle_on"} | template(**concerns)
    monkeypatch.setitem(sample.catalogue.hazards, "candle_on", hazard)
    label = first(draft) | {"hazard": "candle_on", "evidence": {}}
    for notify in ("now", "summary", "silent"):
        draft.files["labels"]["anomalies"] = [
            label | {"notify": notify, "report": notify != "silent"}
        ]
        scene = Draft(sample)
        scene.files = draft.files
        found = list(CHECKS["household: report and notify"](scene.scene))
        assert bool(found) is (notify != told), found


# --- twins -------------------------------------------------------------------------------------


def gone(draft: Draft) -> None:
    """All anomalies undone by taking their objects away."""
    labels = draft.files["labels"]
    labels["undone"] = [undone(one) for one in labels["anomalies"]]
    ids = {one["object_id"] for one in labels["anomalies"]}
    labels["anomalies"] = []
    objects = draft.files["scene"]["objects"]
    objects[:] = [item for item in objects if item["id"] not in ids]


def undone(label: Json, **fields: Any) -> Json:
    return {
        "anomaly_id": label["id"],
        "hazard": label["hazard"],
        "object_id": label["object_id"],
        "action": "take_away",
        "target_id": None,
        "moved": False,
        "removed": True,
    } | fields


def twin(draft: Draft, kind: str = "twin") -> Scene:
    made = draft.scene
    folder = made.folder.with_name(f"{made.id}-{kind}")
    out = Scene(folder, made.models, made.catalogue)
    out.__dict__.update(draft.files | {"views": draft.original.views})
    return out


def other(draft: Draft) -> Json:
    ids = {one["object_id"] for one in draft.original.labels["anomalies"]}
    found: Json = next(
        o for o in draft.files["scene"]["objects"] if o["id"] not in ids and not o["fixed"]
    )
    return found


def nudged(draft: Draft) -> None:
    draft.move(other(draft)["id"], np.array([0.00001, 0.0, 0.0]))


def put_back(draft: Draft) -> None:
    """Said to be undone, and still there."""
    label = draft.original.labels["anomalies"][0]
    item = next(o for o in draft.original.scene["objects"] if o["id"] == label["object_id"])
    draft.files["scene"]["objects"].append(deepcopy(item))


def no_remedy(draft: Draft) -> None:
    draft.files["labels"]["undone"][0]["action"] = "wipe_up"


def put_on_the_floor(draft: Draft) -> None:
    """Put on what is none of the remedy's targets."""
    put_back(draft)
    id = draft.files["labels"]["undone"][0]["object_id"]
    draft.move(id, np.array([0.0, 0.0, -draft.thing(id).bottom]))
    room = draft.object(id)["room_id"]
    fields = {"action": "put_in", "target_id": draft.floor_id(room)}
    draft.files["labels"]["undone"][0] |= fields | {"moved": True, "removed": False}


def left_open(draft: Draft) -> None:
    """A cupboard's leaf that nobody opened."""
    item = next(o for o in draft.files["scene"]["objects"] if "door" in o["joints"])
    item["joints"]["door"] += 0.4


TWIN_EDITS: list[tuple[str, Callable[[Draft], object]]] = [
    ("twins: left or undone", lambda d: d.files["labels"]["undone"].pop()),
    ("twins: left or undone", lambda d: d.files["labels"]["undone"][0].update(hazard="spill")),
    ("twins: still true", put_back),
    ("twins: against the remedy", put_back),
    ("twins: against the remedy", no_remedy),
    ("twins: against the remedy", put_on_the_floor),
    ("twins: not as their scene", nudged),
    ("twins: not as their scene", left_open),
    ("twins: not as their scene", lambda d: other(d).update(variant="broken")),
    ("twins: not as their scene", lambda d: d.files["scene"]["objects"].remove(other(d))),
    ("twins: not as their scene", lambda d: d.files["labels"]["lookalikes"].pop()),
    ("twins: not as their scene", lambda d: d.files["household"]["pets"].append("cat")),
    ("twins: not as their scene", lambda d: d.files["scene"]["zones"].pop()),
]


def test_every_check_of_twins_has_a_control() -> None:
    assert {name for name, _ in TWIN_EDITS} == set(TWINS)


@pytest.mark.parametrize(("name", "edit"), TWIN_EDITS)
def test_an_edited_twin_is_found(name: str, edit: Callable[[Draft], object], sample: Scene) -> None:
    draft = Draft(sample)
    gone(draft)
    assert [f for check in TWINS.values() for f in check(sample, twin(draft))] == []
    broken = Draft(sample)
    gone(broken)
    edit(broken)
    assert list(TWINS[name](sample, twin(broken)))


def test_a_toggle_undoes_its_own_anomaly(sample: Scene) -> None:
    draft = Draft(sample)
    gone(draft)
    assert not list(TWINS["twins: left or undone"](sample, twin(draft, "undo-a01")))
    assert list(TWINS["twins: left or undone"](sample, twin(draft, "undo-a07")))


# --- whole data sets ---------------------------------------------------------------------------


def found_of(name: str, data: DataSet, scenes: list[Scene]) -> list[Finding]:
    return list(WHOLE[name](data, scenes))


def test_draws_that_were_not_asked_for_are_found(data: DataSet, sample: Scene) -> None:
    assert not found_of("drawn: not as asked", data, [sample])
    twice, none = Draft(sample), Draft(sample)
    twice.files["labels"]["anomalies"].append(deepcopy(first(twice)))
    none.files["labels"]["anomalies"].clear()
    for draft in (twice, none):
        assert found_of("drawn: not as asked", data, [draft.scene])
        assert found_of("drawn: counted in the manifest", data, [draft.scene])
    assert not found_of("drawn: counted in the manifest", data, [sample])


@pytest.mark.parametrize("even", [True, False])
def test_an_uneven_deal_is_found(even: bool, sample: Scene, data: DataSet) -> None:
    """Two classes, one or two a scene: a block is four scenes, three labels of each class."""
    dealt = [["a"], ["b"], ["a", "b"], ["a", "b"] if even else ["a"]]
    scenes = []
    for index, names in enumerate(dealt):
        draft = Draft(sample)
        draft.files["scene"]["index"] = index
        labels = [{"hazard": name, "drawn": True} for name in names]
        draft.files["labels"]["anomalies"] = labels
        scenes.append(draft.scene)
    made = DataSet(data.folder)
    made.about = {
        "options": {"hazards_min": 1, "hazards_max": 2, "draw": "balanced"},
        "hazards_enabled": ["a", "b"],
    }
    made.manifest = made.manifest * 4
    assert bool(found_of("drawn: dealt unevenly", made, scenes)) is not even


@pytest.mark.parametrize(("share", "told"), [(0.0, True), (0.5, False), (1.0, True)])
def test_traits_in_other_shares_are_found(
    share: float, told: bool, sample: Scene, data: DataSet
) -> None:
    """A couple has a cat in half of its households."""
    scenes = []
    for k in range(4 * LEAST_HOUSEHOLDS):
        draft = Draft(sample)
        pets = ["cat"] if k % 100 < 100 * share and (share != 0.5 or k % 2) else []
        draft.files["household"] |= {"template": "couple", "pets": pets, "conditions": []}
        draft.files["labels"]["anomalies"] = []
        scenes.append(draft.scene)
    found = [str(f) for f in found_of("household: trait shares", data, scenes)]
    assert any("cat" in one for one in found) is told, found
