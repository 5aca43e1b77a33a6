"""What fits becomes a file that the catalogue reads, and that says what it holds."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.load import extension_names, load_catalog, written_hazard
from sdgen.catalog.records import PlaceRecipe, SetRecipe
from sdgen.errors import InputError
from sdgen.proposals.check import Idea, Refused
from sdgen.proposals.review import check_loads, joined, review_file


def idea(target: str, line: int = 1, thing: str = "vase", **more: object) -> Idea:
    recipe = PlaceRecipe.model_validate(
        {
            "categories": (thing,),
            "state": "BROKEN",
            "relation": "ON",
            "targets": (target,),
            **more,
        }
    )
    return Idea(line, recipe, "it falls")


def test_the_file_is_the_hazard_and_what_is_new(tmp_path: Path) -> None:
    ideas = [idea("wardrobe"), idea("stool", 2)]
    refused = [Refused(3, "unicorn", "unknown", "unknown category 'unicorn'")]
    text = review_file(written_hazard("broken_item"), ideas, refused)
    file = tmp_path / "hazards" / "broken_item.yaml"
    file.parent.mkdir()
    file.write_text(text, encoding="utf-8")
    for where in (tmp_path, file):
        catalog = load_catalog([where])
        before, after = load_catalog().hazard("broken_item"), catalog.hazard("broken_item")
        assert after.anomalies == (*before.anomalies, *(one.recipe for one in ideas))
        same = {"anomalies": before.anomalies, "pack": before.pack}
        assert after.model_copy(update=same) == before
        assert len(catalog.hazards) == len(load_catalog().hazards)
    assert "# line 3: unicorn: unknown category 'unicorn'\n" in text
    assert "&" not in text.replace(" & ", "")


def test_every_shipped_hazard_can_be_written_so(tmp_path: Path) -> None:
    """The same again, with nothing new: what was written is all there."""
    packs = extension_names()
    catalog = load_catalog(extensions=packs)
    for hazard in catalog.hazards:
        text = review_file(written_hazard(hazard.id, extensions=packs), [], [])
        (tmp_path / f"{hazard.id}.yaml").write_text(text, encoding="utf-8")
    again = load_catalog(sorted(tmp_path.iterdir()), packs)
    for before, after in zip(catalog.hazards, again.hazards, strict=True):
        assert after.model_copy(update={"pack": before.pack}) == before


def test_ideas_of_one_line_are_one_line() -> None:
    several = [
        *(idea(target, thing=thing) for thing in ("vase", "mug") for target in ("stool", "bench")),
        idea("stool", thing="plate"),
        *(idea("floor", 2, rooms=(room,)) for room in ("toilet", "storage")),
        idea("floor", 2),
        Idea(3, SetRecipe(categories=("mirror",), state="BROKEN", rooms=("office",)), ""),
        Idea(3, SetRecipe(categories=("mirror",), state="BROKEN", rooms=("hall",)), ""),
    ]
    assert joined(several) == [
        (
            "{place: [vase, mug], state: BROKEN, relation: ON, target: [stool, bench]}",
            "line 1: it falls",
        ),
        ("{place: plate, state: BROKEN, relation: ON, target: stool}", "line 1: it falls"),
        (
            "{place: vase, state: BROKEN, relation: ON, target: floor, rooms: [toilet, storage]}",
            "line 2: it falls",
        ),
        ("{place: vase, state: BROKEN, relation: ON, target: floor}", "line 2: it falls"),
        (
            "{set: mirror, state: BROKEN, rooms: [office, hall]}",
            "line 3: no reason given",
        ),
    ]


def test_what_does_not_load_is_told_as_of_the_file_meant(tmp_path: Path) -> None:
    text = review_file(written_hazard("broken_item"), [idea("unicorn")], [])
    shown = tmp_path / "broken_item.yaml"
    with pytest.raises(InputError) as caught:
        check_loads(text, "broken_item", shown, [], [])
    (problem,) = caught.value.problems
    assert problem.startswith(f"{shown}:")
    assert "unknown category 'unicorn'" in problem
    assert not shown.exists()
