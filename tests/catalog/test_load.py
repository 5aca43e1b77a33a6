"""Loading the catalogue, and every way a folder of somebody else's can be bad."""

from __future__ import annotations

import os
import pickle
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog, PlaceRecipe
from sdgen.errors import InputError
from sdgen.resources import data_path

from .worlds import HAZARD, problems, write

CATEGORY = """\
gizmo:
  superclass: Props
  size_m: [[0.1, 0.1, 0.1], [0.2, 0.2, 0.2]]
  mass_kg: [0.1, 1]
"""


def test_a_folder_adds_to_the_shipped_catalogue(tmp_path: Path) -> None:
    folder = write(tmp_path, hazards__wobbly_vase=HAZARD, categories__mine=CATEGORY)
    catalog = load_catalog([folder])
    hazard = catalog.hazard("wobbly_vase")
    assert hazard.pack == tmp_path.name
    assert hazard.label == "unsafe"
    (recipe,) = hazard.anomalies
    assert isinstance(recipe, PlaceRecipe)
    assert recipe.targets == ("coffee_table",)
    assert catalog.category("gizmo").mass_max_kg == 1.0
    assert len(catalog.hazards) == len(load_catalog().hazards) + 1


def test_a_single_file_stands_in_for_a_folder(tmp_path: Path) -> None:
    write(tmp_path, hazards__wobbly_vase=HAZARD, categories__mine=CATEGORY)
    alone = load_catalog([tmp_path / "hazards" / "wobbly_vase.yaml"])
    assert alone.hazard("wobbly_vase").pack == "wobbly_vase"
    assert load_catalog([tmp_path / "categories" / "mine.yaml"]).category("gizmo")


def test_only_and_the_shipped_folder_itself() -> None:
    few = load_catalog(only=["stove_on", "spill"])
    assert [hazard.id for hazard in few.hazards] == ["spill", "stove_on"]
    assert load_catalog([data_path("hazard_catalog")]) == load_catalog()
    with pytest.raises(InputError, match=r"unknown hazard 'stove_of' \(did you mean 'stove_on'"):
        load_catalog(only=["stove_of"])
    with pytest.raises(InputError, match="unknown extension pack 'none_such'"):
        load_catalog(extensions=["none_such"])


@pytest.mark.parametrize(
    ("shipped", "hint"),
    [
        ((), " (none are shipped)"),
        (("garden", "cellar"), " (one of: cellar, garden)"),
        (tuple(f"pack_{k:02d}" for k in range(20)), ""),  # too many to list
    ],
)
def test_an_unknown_pack_is_told_with_those_there_are(
    monkeypatch: pytest.MonkeyPatch, shipped: tuple[str, ...], hint: str
) -> None:
    monkeypatch.setattr("sdgen.catalog.load.extension_names", lambda: shipped)
    with pytest.raises(InputError) as caught:
        load_catalog(extensions=["attic"])
    assert caught.value.problems == (f"unknown extension pack 'attic'{hint}",)


def test_the_digest_follows_the_content_only(tmp_path: Path) -> None:
    before = load_catalog().sha256
    assert before == load_catalog().sha256
    a, b = tmp_path / "a" / "pack", tmp_path / "b" / "pack"
    write(a, hazards__wobbly_vase=HAZARD)
    write(b, hazards__wobbly_vase=f"# moved, with a comment\n{HAZARD}")
    assert load_catalog([a]).sha256 == load_catalog([b]).sha256 != before
    changed = (loaded := load_catalog()).model_copy(update={"mixes": ()})
    assert loaded.sha256 == before != changed.sha256
    assert loaded.sha256 == before
    assert loaded.model_copy(update={"mixes": ()}).sha256 == changed.sha256
    assert pickle.loads(pickle.dumps(loaded)) == loaded == load_catalog()
    text = load_catalog([a]).model_dump_json()
    assert Catalog.model_validate_json(text) == load_catalog([a])


def test_the_digest_is_made_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """It takes ten milliseconds, and every scene and every twin names it."""
    loaded = load_catalog()
    digest = loaded.sha256
    there = pickle.loads(pickle.dumps(loaded))
    monkeypatch.setattr(Catalog, "model_dump", None)
    assert loaded.sha256 == there.sha256 == digest


def test_replacing_is_asked_for(tmp_path: Path) -> None:
    shipped = data_path("hazard_catalog", "hazards", "stove_on.yaml").read_text(encoding="utf-8")
    changed = shipped.replace("urgency: high", "urgency: low")
    folder = write(tmp_path, hazards__stove_on=changed)
    (problem,) = problems(folder)
    assert (
        "hazard 'stove_on' is already defined at hazard_catalog/hazards/stove_on.yaml:1" in problem
    )
    assert "replaces: true" in problem
    write(tmp_path, hazards__stove_on=changed + "replaces: true\n")
    assert load_catalog([folder]).hazard("stove_on").urgency == "low"


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("title:", "titel:", ":2: titel: unknown key (did you mean 'title'?)"),
        ("urgency: low", "urgency: low\nurgency: high", ":6: urgency: duplicate key"),
        ("urgency: low", "urgency: soon", "urgency: 'soon' is not one of high, medium, low"),
        ("urgency: low", "urgency: 3", "expected one of high, medium, low, got the number 3"),
        ("group: safety", "group: saftey", "group: 'saftey' is not one of safety"),
        ("group: safety", "group: safety\nlabel: unsanitary", "label: the label of group safety"),
        ("id: wobbly_vase", "id: wobbly", ":1: id: the id must be the file's name, 'wobbly_vase'"),
        ("category: vase", "category: vaze", "predicate.category: unknown category 'vaze'"),
        ("category: vase", "state: on", ":9: predicate.state: 'on' is not a state"),
        ("place: vase", "place: vaze", "anomalies[0].place: unknown category 'vaze' (did you mean"),
        ("place: vase", "plaec: vase", "anomalies[0]: expected 'place: [categories]'"),
        ("place: vase,", "place: vase, state: off,", "anomalies[0].state: 'off' is not a state"),
        ("place: vase,", "place: vase, state: true,", "anomalies[0].state: expected a state"),
        ("target: coffee_table", "target: cofee_table", "target: unknown category 'cofee_table'"),
        (
            "relation: ON, target: coffee_table",
            "relation: ON",
            "anomalies[0]: missing key 'target'",
        ),
        (
            "target: coffee_table",
            "target: coffee_table, before: {of: door}",
            "anomalies[0].before: before needs 'target: floor'",
        ),
        (
            "target: coffee_table",
            "target: floor, across: true",
            "anomalies[0].across: across needs a zone that it lies across",
        ),
        (
            "target: coffee_table",
            "target: floor, over_edge: {min_m: 0.01, max_m: 0.1}",
            "anomalies[0].over_edge: over_edge needs 'relation: ON' and furniture to be on",
        ),
        (
            "target: coffee_table",
            "target: coffee_table, over_edge: {min_m: 0.1, max_m: 0.01}",
            "anomalies[0].over_edge.min_m: min_m (0.1) is above max_m (0.01)",
        ),
        (
            "target: coffee_table",
            "target: coffee_table, near: {to: stov, max_m: 0.3}",
            "anomalies[0].near.to: unknown category 'stov'",
        ),
        (
            "target: coffee_table",
            "target: coffee_table, near: {to: stove}",
            "anomalies[0].near: missing key 'max_m'",
        ),
        (
            "target: coffee_table",
            "target: floor, zone: doorway, avoid_zones: walkway",
            "anomalies[0].avoid_zones: avoid_zones does nothing beside a zone",
        ),
        (
            "target: coffee_table",
            "target: coffee_table, rooms: cellar",
            "unknown room type 'cellar'",
        ),
        ("target: coffee_table", "target: coffee_table, weight: -1", "weight: -1 is not between"),
        ("target: coffee_table", "target: coffee_table, wieght: 1", "wieght: unknown key (did you"),
        ("who: everyone", "who: anyone", "concerns.who: 'anyone' is not one of everyone, children"),
        ("who: everyone", "who: children", "concerns: who: children needs max_age"),
        ("who: everyone", "who: everyone, max_age: 3", "max_age belongs to who: children"),
        (
            "who: everyone",
            "who: children, max_age: 3, by_reach: true",
            "concerns.by_reach: by_reach needs a term 'height:",
        ),
        (
            "  - {place: vase,",
            "  - {set: vase, state: BROKEN}\n  - {place: vase,",
            ":13: anomalies[0].set: vase is placed by another recipe: not both",
        ),
        ("{room}", "{place}", "message: unknown placeholder {place}"),
        ("{room}", "{room", "message: has a brace without its pair"),
        ("{room}", "{room.__class__}", "message: unknown placeholder {room.__class__}"),
        ("\nrelation: ON\nanomalies", "\nanomalies", "message: {target} needs 'relation: ON'"),
        ("action: put_on", "action: putt_on", "remedy[0].action: 'putt_on' is not one of"),
        (
            "\nrelation: ON\nanom",
            "\nrelation: ON\nevidence_state: BROKEN\nevidence_parts: rim\nanom",
            ":13: evidence_parts: evidence_state names parts already",
        ),
        (
            "\nrelation: ON\nanom",
            "\nrelation: ON\nevidence_pixels: 15\nanom",
            ":12: evidence_pixels: of the whole thing 100 are needed: name its parts, too",
        ),
        (
            "\nrelation: ON\nanom",
            "\nrelation: ON\nevidence_parts: [rim, rim]\nanom",
            ":12: evidence_parts[1]: 'rim' is listed twice",
        ),
        (
            "\nrelation: ON\nanom",
            "\nrelation: ON\nevidence_parts: []\nanom",
            ":12: evidence_parts: expected at least one part",
        ),
        (
            "\nrelation: ON\nanom",
            "\nrelation: ON\nevidence_parts: rim\nevidence_pixels: 0\nanom",
            ":13: evidence_pixels: 0 is not between 1 and 1000",
        ),
        (
            "\nrelation: ON\nanom",
            "\nrelation: ON\nevidence_parts: rim\nevidence_pixels: few\nanom",
            ":13: evidence_pixels: expected a whole number",
        ),
        (
            "\nrelation: ON\nanom",
            "\nrelation: ON\nevidence_outdoors: 300\nanom",
            ":12: evidence_outdoors: only through openings: every anomaly must be a 'set' of some "
            "of door, double_door, front_door, passage, wide_passage, window",
        ),
        (
            "\nrelation: ON\nanom",
            "\nrelation: ON\nevidence_outdoors: -1\nanom",
            ":12: evidence_outdoors: -1 is not between 0 and 10000",
        ),
        (", target: bookshelf", "", "remedy[0]: action put_on needs a target"),
        ("source: nobody in particular", "source:", "source: is empty: expected text"),
        ("source: nobody in particular", "source: [a, b]", "source: expected text, got a list"),
    ],
)
def test_a_bad_hazard_is_told_with_its_line(
    tmp_path: Path, old: str, new: str, problem: str
) -> None:
    assert old in HAZARD
    folder = write(tmp_path, hazards__wobbly_vase=HAZARD.replace(old, new, 1))
    found = problems(folder)
    assert any(problem in line for line in found), found
    assert all(line.startswith(f"{folder}/hazards/wobbly_vase.yaml:") for line in found)


REACH = "{height: {max_m: 1.1, evidence: reach_height_m}}"
LOW = "{relation: ON, target: coffee_table}"


def test_who_raises_a_hazard_is_somebody_a_household_can_have(tmp_path: Path) -> None:
    told = "concerns: {who: everyone, raised_by: [{living_with: [parot], source: x}]}"
    folder = write(tmp_path, hazards__wobbly_vase=HAZARD.replace("concerns: {who: everyone}", told))
    assert any("unknown pet or condition 'parot'" in line for line in problems(folder))
    birds = "templates: {us: {members: [{role: a, age: [20, 30]}], pets: [parot]}}"
    write(tmp_path, households=birds)
    assert any(hazard.id == "wobbly_vase" for hazard in load_catalog([folder]).hazards)


@pytest.mark.parametrize(
    ("terms", "told"),
    [
        (f"any: [{LOW}, {REACH}]", True),  # only one branch's evidence is kept
        (f"any: [{REACH}, {{all: [{LOW}, {REACH}]}}]", False),
        (f"all: [{LOW}, {REACH}]", False),
        (f"not: {REACH}", True),  # what does not hold is no evidence
    ],
)
def test_by_reach_is_measured_wherever_the_predicate_holds(
    tmp_path: Path, terms: str, told: bool
) -> None:
    text = HAZARD.replace("who: everyone", "who: children, max_age: 3, by_reach: true")
    text = text.replace("  relation: ON\n", f"  {terms}\n")
    folder = write(tmp_path, hazards__wobbly_vase=text)
    if told:
        assert any(":4: concerns.by_reach: by_reach needs" in line for line in problems(folder))
    else:
        assert load_catalog([folder]).hazard("wobbly_vase").concerns.by_reach


def test_a_message_about_what_is_set_has_its_target(tmp_path: Path) -> None:
    """A wall cabinet that stands open is on nothing: the message would have a hole."""
    text = HAZARD.replace("category: vase", "category: wall_cabinet\n  state: OPEN")
    text = text.replace("{place: vase, relation: ON, target: coffee_table}", "{set: wall_cabinet}")
    text = text.replace("{set: wall_cabinet}", "{set: wall_cabinet, state: OPEN}")
    folder = write(tmp_path, hazards__wobbly_vase=text)
    assert load_catalog([folder]).hazard("wobbly_vase").relation == "ON"
    write(tmp_path, hazards__wobbly_vase=text.replace("OPEN\n  relation: ON", "OPEN"))
    (problem,) = problems(folder)
    assert ":6: message: {target} of a thing that is set needs 'relation: ON'" in problem


def test_the_reach_of_children_is_replaced_on_request_only(tmp_path: Path) -> None:
    table = "reach: {rows: [{max_age: 9, reach_m: 1.5}]%s}\n"
    folder = write(tmp_path, households=table % "")
    (problem,) = problems(folder)
    assert "households.yaml:1: reach: table 'reach' is already defined at hazard_cat" in problem
    assert "replaces: true" in problem
    write(tmp_path, households=table % ", replaces: true")
    assert [row.reach_m for row in load_catalog([folder]).reach] == [1.5]


def test_all_problems_come_at_once_in_order(tmp_path: Path) -> None:
    bad = HAZARD.replace("vase", "vaze").replace("low", "soon").replace("bookshelf", "bookself")
    folder = write(
        tmp_path,
        hazards__wobbly_vaze=bad,
        hazards__empty="",
        categories__mine=CATEGORY.replace("Props", "Prop"),
    )
    lines = [problem.split(str(folder))[1] for problem in problems(folder)]
    assert [line.split(": ")[0] for line in lines] == [
        "/categories/mine.yaml:2",
        "/hazards/empty.yaml:1",
        "/hazards/wobbly_vaze.yaml:5",
        "/hazards/wobbly_vaze.yaml:9",
        "/hazards/wobbly_vaze.yaml:13",
        "/hazards/wobbly_vaze.yaml:15",
    ]


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("[[0.1, 0.1, 0.1], [0.2, 0.2, 0.2]]", "[0.1, 0.2]", "size_m[0]: expected a list of 3"),
        ("[[0.1, 0.1, 0.1], [0.2, 0.2, 0.2]]", "0.1", "size_m: expected [[x, y, z] smallest"),
        ("[0.1, 0.1, 0.1]", "[0.1, 0.1, 0.3]", "size_m: the smallest is larger than the largest"),
        ("[0.1, 0.1, 0.1]", "[0.1, 0.1, a]", "size_m[0][2]: expected a number, got text 'a'"),
        ("[0.1, 0.1, 0.1]", "[0.1, 0.1, -1]", "size_m[0][2]: -1 is not between 0 and 50"),
        (
            "mass_kg: [0.1, 1]",
            "switched_on: 0.5\n  mass_kg: [0.1, 1]",
            "switched_on: only what has the property HAS_SWITCH is ever on",
        ),
        (
            "mass_kg: [0.1, 1]",
            "stands_open: 0.5\n  mass_kg: [0.1, 1]",
            "stands_open: only furniture with the property CAN_OPEN",
        ),
        (
            "mass_kg: [0.1, 1]",
            "stands_open: 2\n  mass_kg: [0.1, 1]",
            "stands_open: 2 is not between 0 and 1",
        ),
        ("mass_kg: [0.1, 1]", "mass_kg: [2, 1]", "mass_kg: the first number (2) is above"),
        ("mass_kg: [0.1, 1]", "mass_kg: [0, 1]", "mass_kg: masses must be above 0"),
        ("mass_kg: [0.1, 1]", "mass_kg: 1", "mass_kg: expected a list of 2 numbers, got the"),
        ("superclass: Props", "superclass: props", "(did you mean 'Props'?)"),
        ("superclass: Props", "superclass: Zzz", "Walls, Windows\n"),  # told once
        ("gizmo:", "Gizmo:", "'Gizmo' is not a name"),
        ("gizmo:", "mug:", "category 'mug' is already defined at hazard_catalog/categories/"),
        (
            "  superclass",
            "  lives: [{relation: ON, target: tabel}]\n  superclass",
            "unknown category",
        ),
        ("  superclass", "  properties: [GRABABLE]\n  superclass", "(did you mean 'GRABBABLE'?)"),
        ("  superclass", "  kind: big\n  superclass", "kind: 'big' is not one of small"),
        (
            "  superclass",
            "  lives: [{relation: ON, target: desk, hollow: drawer}]\n  superclass",
            "lives[0].hollow: hollow needs 'relation: INSIDE'",
        ),
        ("  superclass", "  at_most: {room: 0}\n  superclass", "at_most.room: 0 is not between 1"),
        ("  superclass", "  at_most: 2\n  superclass", "at_most: expected {room: number, home:"),
        (
            "  superclass",
            "  belongs_to: dgo\n  superclass",
            "age group 'dgo' (did you mean 'dog'?)",
        ),
        ("  superclass", "  always: true\n  superclass", "always: always needs 'belongs_to' and"),
        (
            "  superclass",
            "  kind: furniture\n  holds: {chance: 0.5, count: [1, 2]}\n  superclass",
            "holds: only small things hold others by it",
        ),
        (
            "  superclass",
            "  holds: {chance: 2, count: [1, 2]}\n  superclass",
            "holds.chance: 2 is not between 0 and 1",
        ),
        (
            "  superclass",
            "  rows: [{of: mug}]\n  superclass",
            "rows: only furniture has shelves that rows stand on",
        ),
        (
            "  superclass",
            "  kind: furniture\n  rows: [{of: mgu}]\n  superclass",
            "rows[0].of: unknown category 'mgu' (did you mean 'mug'?)",
        ),
        (
            "  superclass",
            "  kind: furniture\n  rows: [{of: mug, pile: [2, 9]}]\n  superclass",
            "rows[0].pile[1]: 9 is not between 1 and 3",
        ),
        (
            "  superclass",
            "  kind: furniture\n  rows: {of: mug}\n  superclass",
            "rows: expected a list of {of: categories}",
        ),
    ],
)
def test_a_bad_category_is_told(tmp_path: Path, old: str, new: str, problem: str) -> None:
    assert old in CATEGORY
    found = problems(write(tmp_path, categories__mine=CATEGORY.replace(old, new, 1)))
    assert any(problem in f"{line}\n" for line in found), found


@pytest.mark.parametrize(
    ("name", "text", "problem"),
    [
        ("rooms", "attic: {floor_clutter: [0, 1], clutter: {sofaa: [1, 2]}}", "unknown category"),
        ("rooms", "attic: {floor_clutter: [0, 1.5], clutter: {}}", "expected whole numbers"),
        ("rooms", "attic: {floor_clutter: [0, 1], clutter: {sofa: 3}}", "list of 2 numbers"),
        ("rooms", "- attic", "expected a mapping (key: value), got a list"),
        ("rooms", "hall: {floor_clutter: [0, 1], clutter: {}}", "room type 'hall' is already"),
        ("households", "template: {}", "template: unknown key (did you mean 'templates'?)"),
        ("households", "templates: {us: {members: []}}", "members: expected at least one item"),
        ("households", "templates: {us: {members: [{role: a, age: 5}]}}", "list of 2 numbers"),
        (
            "households",
            "templates: {us: {members: [{role: a, age: [1, 2]}], notifications: {stoev_on: now}}}",
            "notifications.stoev_on: unknown hazard 'stoev_on' (did you mean 'stove_on'?)",
        ),
        (
            "households",
            "templates: {us: {members: [{role: a, age: [1, 2]}], notifications: {stove_on: off}}}",
            "notifications.stove_on: unknown choice 'off'",
        ),
        (
            "households",
            "templates: {us: {members: [{role: a, age: [1, 2]}], notifications: "
            "{candle_on: [now, silent]}}}",
            "templates.us.notifications.candle_on: nobody is silent about candle_on",
        ),
        (
            "households",
            "templates: {us: {members: [{role: a, age: [1, 2]}], needs: {rooms: [atic]}}}",
            "needs.rooms[0]: unknown room type 'atic'",
        ),
        ("households", "groups: {old: {max_age: 200}}", "max_age: 200 is not between 0 and 120"),
        (
            "rooms",
            "attic: {floor_clutter: [0, 1], clutter: {}, belongs_to: childd}",
            "age group 'childd' (did you mean 'child'?)",
        ),
        (
            "households",
            "reach: {rows: [{max_age: 5, reach_m: 1}, {max_age: 4, reach_m: 2}], replaces: true}",
            "rise",
        ),
    ],
)
def test_bad_rooms_and_households_are_told(
    tmp_path: Path, name: str, text: str, problem: str
) -> None:
    found = problems(write(tmp_path, **{name: text}))
    assert any(problem in line for line in found), found


def test_places_that_hold_no_catalogue(tmp_path: Path) -> None:
    assert "no such file" in problems(tmp_path / "none")[0]
    assert "no catalogue file in it" in problems(tmp_path)[0]
    write(tmp_path, hazards__a="\xff")
    (tmp_path / "hazards" / "a.yaml").write_bytes(b"\xff\xfe")
    assert "is not UTF-8 text" in problems(tmp_path)[0]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root reads all")
def test_a_file_one_may_not_read(tmp_path: Path) -> None:
    folder = write(tmp_path, hazards__wobbly_vase=HAZARD)
    (folder / "hazards" / "wobbly_vase.yaml").chmod(0)
    assert "cannot be read (Permission denied)" in problems(folder)[0]


def _problems_or_none(folder: Path) -> tuple[str, ...] | None:
    """None when the folder loads. Anything but an InputError flies through."""
    try:
        load_catalog([folder])
    except InputError as error:
        return error.problems
    return None


def _well_told(found: tuple[str, ...] | None, folder: Path) -> bool:
    """Problems, if any, are single lines that name a file of the folder."""
    if found is None:
        return True
    return bool(found) and all(line.startswith(str(folder)) and "\n" not in line for line in found)


_SLOW_OK = [HealthCheck.function_scoped_fixture, HealthCheck.too_slow]
_KINDS = st.sampled_from(["hazards__x", "categories__x", "homes__x", "rooms", "households"])


@settings(max_examples=60, deadline=None, suppress_health_check=_SLOW_OK)
@given(kind=_KINDS, raw=st.binary(max_size=200) | st.text(max_size=200).map(str.encode))
def test_random_bytes_never_raise_anything_else(tmp_path: Path, kind: str, raw: bytes) -> None:
    folder = write(tmp_path / kind, **{kind: ""})
    folder.joinpath(*f"{kind}.yaml".split("__")).write_bytes(raw)
    assert _well_told(_problems_or_none(folder), folder)


_WORDS = st.sampled_from(
    ["ON", "on", "knife", "floor", "x", "", "kitchen", "now", "{target}", "safety", "children"]
)
_JUNK: st.SearchStrategy[Any] = st.recursive(
    st.none() | st.booleans() | st.integers(-9, 999) | st.floats(-9, 9) | _WORDS,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(_WORDS, inner, max_size=3),
    max_leaves=6,
)


def _shipped(kind: str) -> Any:
    name = {"hazards__x": "hazards/sharp_object.yaml", "homes__x": "homes/apartment_1.yaml"}
    name |= {"categories__x": "categories/food.yaml", "rooms": "rooms.yaml"}
    text = data_path("hazard_catalog", name.get(kind, "households.yaml")).read_text("utf-8")
    return yaml.safe_load(text)


def _paths(value: Any, at: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    out = [at] if at else []
    if isinstance(value, dict | list):
        pairs = value.items() if isinstance(value, dict) else enumerate(value)
        for key, below in pairs:
            out += _paths(below, (*at, key))
    return out


@settings(max_examples=150, deadline=None, suppress_health_check=_SLOW_OK)
@given(kind=_KINDS, data=st.data())
def test_a_shipped_file_with_junk_put_in_never_raises_anything_else(
    tmp_path: Path, kind: str, data: st.DataObject
) -> None:
    """A real file with one value replaced by junk: the deep readers all get their share."""
    value = _shipped(kind)
    path = data.draw(st.sampled_from(_paths(value)))
    spot = value
    for step in path[:-1]:
        spot = spot[step]
    spot[path[-1]] = data.draw(_JUNK)
    text = yaml.safe_dump(value, sort_keys=False, allow_unicode=True)
    folder = write(tmp_path / kind, **{kind: text})
    assert _well_told(_problems_or_none(folder), folder)
