"""Suites: models that one home has together, as `suites.yaml` says and the manifest repeats."""

import copy
from pathlib import Path
from typing import Any

import pytest
import yaml
from sdgen.library import Library
from sdgen.library.records import Asset
from sdgen.library.shape import corners_of

from tests.by_path import ROOT
from tests.library.test_bad_folders import _shipped, problems, write
from tests.shipped import shipped_library

SUITES = yaml.safe_load((ROOT / "assets" / "blender" / "suites.yaml").read_text(encoding="utf-8"))
TAGS = yaml.safe_load((ROOT / "assets" / "blender" / "tags.yaml").read_text(encoding="utf-8"))
KITCHENS = [name for name, members in SUITES.items() if "kitchen_counter" in members]
BATHROOM = {"toilet", "washbasin", "bathtub", "bathroom_cabinet"}
BEDROOM = {"bed", "nightstand", "wardrobe", "dresser"}
WORKTOP_M, DEEP_M = 0.9, 0.584


@pytest.fixture(scope="module")
def library() -> Library:
    return shipped_library()


def members(library: Library, suite: str, category: str) -> list[Asset]:
    return [a for a in library.assets.values() if a.suite == suite and a.category == category]


def worktop(asset: Asset) -> tuple[float, float]:
    """Height of the unit's worktop and how far its front is from the wall."""
    top = next(s for s in asset.supports if s.name == "top")
    return top.z_m, max(x for x, _ in top.edge_m[:, :2]) + asset.extents_m[0] / 2


def test_the_manifest_says_what_the_list_says(library: Library) -> None:
    said = {
        f"{category}_{number:02d}": suite
        for suite, categories in SUITES.items()
        for category, numbers in categories.items()
        for number in numbers
    }
    assert {a.id: a.suite for a in library.assets.values() if a.suite} == said


def test_the_manifest_has_the_tags_of_the_list(library: Library) -> None:
    said = {
        (f"{category}_{number:02d}", tag)
        for tag, categories in TAGS.items()
        for category, numbers in categories.items()
        for number in numbers
    }
    assert {(a.id, tag) for a in library.assets.values() for tag in a.tags} == said


def test_every_finish_has_what_a_kitchen_needs() -> None:
    finishes = [members for tag, members in TAGS.items() if tag.endswith("_goods")]
    assert len(finishes) >= 4
    for members in finishes:
        assert {"fridge", "stove", "range_hood", "microwave", "kettle", "toaster"} <= set(members)


def test_there_are_enough_of_each_kind() -> None:
    assert len(KITCHENS) >= 8
    assert sum("door" in found for found in SUITES.values()) >= 8
    assert sum("window" in found for found in SUITES.values()) >= 5
    assert sum(set(found) == BATHROOM for found in SUITES.values()) >= 4
    assert sum(set(found) == BEDROOM for found in SUITES.values()) >= 6


@pytest.mark.parametrize("suite", KITCHENS)
def test_a_kitchen_is_complete_and_joins_without_a_step(library: Library, suite: str) -> None:
    counters = members(library, suite, "kitchen_counter")
    sinks = members(library, suite, "sink_cabinet")
    walls = members(library, suite, "wall_cabinet")
    (corner,) = members(library, suite, "corner_counter")
    (dishwasher,) = members(library, suite, "dishwasher")
    assert {round(a.extents_m[1], 3) for a in counters} >= {0.4, 0.6, 0.8}
    assert 0.8 in {round(a.extents_m[1], 3) for a in sinks}
    assert {round(a.extents_m[1], 3) for a in walls} == {0.4, 0.6, 0.8}
    assert {round(a.extents_m[2], 3) for a in walls} == {0.7}
    assert any(joint.type == "prismatic" for a in counters for joint in a.joints)
    for unit in (*counters, corner):
        assert worktop(unit) == pytest.approx((WORKTOP_M, DEEP_M), abs=0.002), unit.id
    # a dishwasher's support ends at its door, a sink's stops before the bowl: what is drawn tells
    for unit in (*sinks, dishwasher, corner):
        drawn = corners_of([library.model(unit.id).meshes["body"]]).reshape(-1, 3)
        top = drawn[abs(drawn[:, 2] - WORKTOP_M) < 0.004]
        ends = (top[:, 1].min(), top[:, 1].max())
        assert ends == pytest.approx((-unit.extents_m[1] / 2, unit.extents_m[1] / 2), abs=1e-3)
        if unit is corner or "farmhouse" in unit.title:  # measured above; a trough stands out
            continue
        assert top[:, 0].max() + unit.extents_m[0] / 2 == pytest.approx(DEEP_M, abs=0.003), unit.id


def test_a_corner_has_its_notch_before_the_room(library: Library) -> None:
    """No worktop and no case in the quarter that faces +X and +Y, apart from the door."""
    for unit in library.by_category("corner_counter"):
        drawn = corners_of([library.model(unit.id).meshes["body"]]).reshape(-1, 3)
        inner = DEEP_M - unit.extents_m[0] / 2 + 0.001
        assert not ((drawn[:, 0] > inner) & (drawn[:, 1] > inner)).any()


def test_windows_of_a_suite_come_in_both_sizes(library: Library) -> None:
    for suite in (name for name, found in SUITES.items() if "window" in found):
        assert {a.extents_m[1] for a in members(library, suite, "window")} == {0.6, 1.2}, suite


def _own(folder: Path, suite: object) -> Path:
    model, surface = copy.deepcopy(_shipped())
    data: dict[str, Any] = {"assets": [model], "surfaces": [surface]}
    for name in (model["mesh"], model["hulls"], model["texture"], surface["texture"]):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes((ROOT / "assets" / name).read_bytes())
    model["id"], surface["id"], model["suite"] = "my_fridge", "my_surface", suite
    write(folder, data)
    return folder


@pytest.mark.parametrize(("suite", "read"), [("white_flat", "white_flat"), (None, None)])
def test_a_model_of_a_users_folder_joins_a_suite_or_none(
    tmp_path: Path, suite: str | None, read: str | None
) -> None:
    assert Library([_own(tmp_path, suite)]).assets["my_fridge"].suite == read


@pytest.mark.parametrize("suite", ["", "two words", "../up", 3, ["white_flat"]])
def test_a_suite_that_is_no_word_is_told(tmp_path: Path, suite: object) -> None:
    assert "my_fridge: suite: " in problems(_own(tmp_path, suite))
