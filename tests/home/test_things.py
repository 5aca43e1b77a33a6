"""Things that a base home draws: where they lie, and what a drawing may not ask for."""

from __future__ import annotations

from itertools import count
from pathlib import Path

import pytest
from sdgen.catalog.home_text import home_text
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog, HomeSpec
from sdgen.errors import InputError
from sdgen.home.drawing_check import check_drawings
from sdgen.home.shell import build_shell
from sdgen.home.style import HomeStyle
from sdgen.home.things import Things, things_drawn
from sdgen.options import BuildOptions
from sdgen.pipeline import make_scene
from sdgen.pipeline.one_home import one_home
from sdgen.resources import data_path
from sdgen.seeding import lane
from sdgen.vocabulary import OPENINGS

from tests.shipped import shipped_library

LIBRARY = shipped_library()
#: A knife on the floor in everybody's way, an apple beside it, a book lying on its side.
KNIFE = "{category: knife, model: knife_01, position_m: [5.3, 6, 0.02]}"
APPLE = "{category: apple, model: apple_01, position_m: [4.9, 6.2, 0.002]}"
BOOK = (
    "{category: book, model: book_01, position_m: [2.4, 1.2, 0.2], "
    "quat_xyzw: [0.707107, 0, 0, 0.707107]}"
)


def drawn(folder: Path, *things: str, as_drawn: bool = False) -> Path:
    """The first base home, with things in its hall."""
    text = data_path("hazard_catalog", "homes", "apartment_1.yaml").read_text()
    text = text.replace("id: apartment_1", f"id: mine\nas_drawn: {str(as_drawn).lower()}")
    listed = "".join(f"      - {thing}\n" for thing in things)
    text = text.replace("openings:\n", f"    things:\n{listed}\nopenings:\n")
    path = folder / "mine.yaml"
    path.write_text(text)
    return path


def read(path: Path) -> tuple[Catalog, HomeSpec]:
    catalog = load_catalog([path])
    return catalog, next(home for home in catalog.homes if home.id == "mine")


def test_a_thing_is_what_is_drawn(tmp_path: Path) -> None:
    catalog, spec = read(drawn(tmp_path, APPLE))
    home = build_shell(spec, HomeStyle(), LIBRARY, count(1), lane(0, 0, "x"))
    things = things_drawn(spec, home, LIBRARY, count(1000))
    assert isinstance(things, Things)
    (apple,) = things.items
    assert (apple.asset, apple.pose.position_m, apple.fixed) == (
        "apple_01",
        (4.9, 6.2, 0.002),
        False,
    )
    assert next(room.name for room in home.rooms if room.id == apple.room_id) == "hall"
    assert catalog.category("apple").kind == "small"


def test_text_of_it_is_read_back(tmp_path: Path) -> None:
    _, spec = read(drawn(tmp_path, APPLE, KNIFE.replace("}", ", anomaly: sharp_object}")))
    (tmp_path / "mine.yaml").write_text(home_text(spec))
    assert read(tmp_path / "mine.yaml")[1] == spec


@pytest.mark.parametrize(
    ("thing", "told"),
    [
        ("{category: apple, model: aple_01, position_m: [5, 6, 0]}", "(did you mean 'apple_01'?)"),
        ("{category: apple, model: pear_01, position_m: [5, 6, 0]}", "no model 'pear_01' of apple"),
        ("{category: appel, model: apple_01, position_m: [5, 6, 0]}", "did you mean 'apple'?"),
        (
            "{category: apple, model: apple_01, position_m: [1, 1, 0]}",
            "apple lies outside room 'hall'",
        ),
        (
            "{category: apple, model: apple_01, position_m: [5, 6, 0], quat_xyzw: [1, 1, 0, 0]}",
            "expected a unit quaternion",
        ),
        (
            "{category: apple, model: apple_01, position_m: [5, 6, 0], variant: blue}",
            "apple_01 has no variant 'blue'",
        ),
        (
            "{category: apple, model: apple_01, position_m: [5, 6, 0], joints: {lid: 1}}",
            "apple_01 has no joint 'lid'",
        ),
        (
            "{category: apple, model: apple_01, position_m: [5, 6, 0], anomaly: sharp_objekt}",
            "did you mean 'sharp_object'?",
        ),
        ("{category: apple, position_m: [5, 6, 0]}", "missing key 'model'"),
    ],
)
def test_what_is_drawn_wrong(thing: str, told: str, tmp_path: Path) -> None:
    path = drawn(tmp_path, thing)

    def check() -> None:
        check_drawings(load_catalog([path]), LIBRARY, [path])

    with pytest.raises(InputError) as caught:
        check()
    assert told in str(caught.value)
    assert "mine.yaml:" in str(caught.value)
    assert "things[0]" in str(caught.value)


@pytest.mark.slow
def test_kept_where_they_lie_beside_everyday_things(tmp_path: Path) -> None:
    catalog, _ = read(drawn(tmp_path, APPLE))
    scene = one_home("mine", catalog, LIBRARY, BuildOptions(views=0)).bundle.scene
    apples = [item for item in scene.objects if item.asset == "apple_01"]
    assert any(
        max(abs(a - b) for a, b in zip(item.pose.position_m, (4.9, 6.2, 0.0), strict=True)) < 0.03
        for item in apples
    )
    assert sum(not item.fixed for item in scene.objects) > 50


@pytest.mark.slow
def test_as_drawn_adds_nothing(tmp_path: Path) -> None:
    catalog, spec = read(drawn(tmp_path, APPLE, as_drawn=True))
    scene = one_home("mine", catalog, LIBRARY, BuildOptions(views=0)).bundle.scene
    assert [item.category for item in scene.objects if not item.fixed] == ["apple"]
    pieces = {piece.category for room in spec.rooms for piece in room.furniture}
    fixed = {item.category for item in scene.objects if item.fixed}
    assert fixed <= pieces | set(OPENINGS)
    assert not any(
        any(item.joints.values()) for item in scene.objects if item.category not in OPENINGS
    )


@pytest.mark.slow
def test_what_is_a_hazard_as_it_lies_is_taken_away_or_labelled(tmp_path: Path) -> None:
    options = BuildOptions(homes="base", hazards_min=0, hazards_max=0, views=8)
    for labelled in (False, True):
        thing = KNIFE.replace("}", ", anomaly: sharp_object}") if labelled else KNIFE
        catalog, spec = read(drawn(tmp_path, thing, as_drawn=True))
        catalog = catalog.model_copy(update={"homes": (spec,)})
        bundle = make_scene(0, catalog, LIBRARY, options)
        knives = [item.id for item in bundle.scene.objects if item.asset == "knife_01"]
        found = [(one.hazard, one.object_id) for one in bundle.anomalies.anomalies]
        assert found == ([("sharp_object", knives[0])] if labelled else [])
        assert len(knives) == labelled


@pytest.mark.slow
def test_what_lies_on_its_side_takes_space_too(tmp_path: Path) -> None:
    catalog, _ = read(drawn(tmp_path, BOOK.replace("2.4, 1.2, 0.2", "4.9, 6.1, 0.2")))
    options = BuildOptions(views=0)
    assert one_home("mine", catalog, LIBRARY, options).bundle.anomalies.anomalies == ()
