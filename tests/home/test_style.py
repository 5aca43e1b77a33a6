"""One home, one style: its surfaces, and models that match."""

from __future__ import annotations

from itertools import count

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Style, SurfaceChoice
from sdgen.hazards.splits import SplitModels
from sdgen.home.style import HomeStyle, style_random
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome, furnished_home, pick_home
from sdgen.seeding import lane

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()


@pytest.fixture(scope="module")
def homes() -> list[FurnishedHome]:
    models = SplitModels(LIBRARY, "test")
    options = BuildOptions(seed=5)
    out = []
    for index in range(8):
        spec = pick_home(CATALOG, options, index).spec(CATALOG, lane(5, index, "plan"))
        made = furnished_home(spec, CATALOG, LIBRARY, models, count(1), lane(5, index, "furnish"))
        if isinstance(made, FurnishedHome):
            out.append(made)
    assert len(out) >= 5
    return out


def models_of(home, category):
    items = home.layout.items.values()
    return [LIBRARY.assets[item.asset] for item in items if item.category == category]


def test_kitchens_doors_and_windows_are_of_one_suite(homes):
    for home in homes:
        fronts = [models_of(home, c) for c in ("kitchen_counter", "sink_cabinet", "wall_cabinet")]
        suites = {model.suite for models in fronts for model in models}
        assert len(suites) == 1
        assert None not in suites
        assert len({model.id for model in models_of(home, "door")}) <= 1


def test_rooms_of_a_choice_share_a_surface_and_homes_differ(homes):
    styles = {home.context.home.style for home in homes}
    assert len(styles) > 1
    for home in homes:
        style = next(s for s in CATALOG.styles if s.name == home.context.home.style)
        floors = {
            s.room_id: s.surface for s in home.context.home.structures if s.category == "floor"
        }
        wet = set(style.floors[0].rooms)
        dry = {floors[r.id] for r in home.context.home.rooms if r.type not in wet}
        assert len(dry) == 1, style.name


def style(**fields):
    return Style(name="plain", **fields)


def test_a_surface_or_suite_that_is_not_there_is_passed_over():
    plain = style(
        walls=(SurfaceChoice(of=("no_such", "plaster_white")),),
        suites=(("kitchen", ("none", "ours")),),
    )
    for index in range(5):
        drawn = style_random([plain], LIBRARY, {"ours"}.__contains__, lane(1, index, "style"))
        assert drawn.surface("wall", "kitchen") == "plaster_white"
        assert drawn.suites == {"ours"}


def test_where_none_of_its_suites_is_there_a_home_has_another_styles():
    first = style(suites=(("kitchen", ("withheld",)),), weight=1000.0)
    second = Style(name="other", suites=(("kitchen", ("ours",)),), weight=0.001)
    drawn = style_random([first, second], LIBRARY, {"ours"}.__contains__, lane(1, 0, "style"))
    assert (drawn.name, drawn.suites) == ("plain", {"ours"})


def test_models_match_by_suite_then_by_tag_and_else_any_will_do():
    a, b, c = LIBRARY.by_category("sofa")[:3]
    a = a.model_copy(update={"suite": "ours"})
    b = b.model_copy(update={"tags": ("grey",)})
    assert HomeStyle(suites=frozenset({"ours"}), tags=frozenset({"grey"})).matching([a, b, c]) == (
        a,
    )
    assert HomeStyle(tags=frozenset({"grey"})).matching([a, b, c]) == (b,)
    assert HomeStyle().matching([a, b, c]) == (a, b, c)


def test_a_home_without_styles_is_built_of_anything():
    assert style_random([], LIBRARY, bool, lane(1, 0, "style")) == HomeStyle()
    assert HomeStyle().surface("floor", "kitchen") is None
