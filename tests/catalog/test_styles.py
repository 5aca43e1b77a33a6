"""Styles: read into records, mistakes located, names looked up in the library."""

from __future__ import annotations

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.styles import check_styles
from sdgen.engines.fit import check_against_styles
from sdgen.errors import InputError

from tests.shipped import shipped_library

CATALOG = load_catalog()

MINE = """mine:
  floors: [{rooms: [bathroom], of: [tile_white]}, {of: [wood_oak]}]
  suites: {kitchen: [ours]}
"""


def problems(folder, text):
    (folder / "styles.yaml").write_text(text)
    with pytest.raises(InputError) as caught:
        load_catalog([folder])
    return "\n".join(caught.value.problems)


def test_there_are_twelve_styles_of_what_the_library_has():
    assert len(CATALOG.styles) >= 12
    check_against_styles(CATALOG, shipped_library())
    for style in CATALOG.styles:
        assert style.floors, style.name
        assert style.walls, style.name
        assert {"kitchen", "doors"} <= set(dict(style.suites)), style.name


def test_a_style_of_ones_own_is_added(tmp_path):
    (tmp_path / "styles.yaml").write_text(MINE)
    (mine,) = (style for style in load_catalog([tmp_path]).styles if style.name == "mine")
    assert [choice.rooms for choice in mine.floors] == [("bathroom", "toilet"), ()]
    assert mine.suites == (("kitchen", ("ours",)),)
    assert mine.weight == 1.0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("mine: {floors: [{rooms: [bathrom], of: [wood_oak]}]}", "did you mean 'bathroom'"),
        ("mine: {floors: [{rooms: [bathroom]}]}", "styles.yaml:1: mine.floors[0]"),
        ("mine: {flors: []}", "did you mean 'floors'"),
        ("mine: {suites: {kitchen: []}}", "expected at least one suite"),
        ("nordic: {}", "is already defined"),
    ],
)
def test_mistakes_are_located(tmp_path, text, said):
    assert said in problems(tmp_path, text)


def test_a_base_home_of_an_unknown_style_is_told_the_nearest(tmp_path):
    home = (tmp_path / "homes").joinpath("hut.yaml")
    home.parent.mkdir()
    home.write_text("id: hut\ntitle: hut\nstyle: nordik\nrooms: []\nopenings: []\n")
    with pytest.raises(InputError) as caught:
        load_catalog([tmp_path])
    assert any("hut.yaml:3" in p and "'nordic'" in p for p in caught.value.problems)


def test_what_no_library_has_is_named_with_what_it_may_be(tmp_path):
    (tmp_path / "styles.yaml").write_text(
        "mine: {walls: [{of: [wood_oak]}], suites: {kitchen: [whit_flat]}, tags: [pink]}\n"
    )
    catalog = load_catalog([tmp_path])
    own = catalog.model_copy(
        update={"styles": tuple(s for s in catalog.styles if s.name == "mine")}
    )
    with pytest.raises(InputError) as caught:
        check_styles(own, {"wood_oak": "floor"}, {"white_flat"}, set())
    assert caught.value.problems == (
        "style mine: walls[0]: the library has no wall surface 'wood_oak'",
        "style mine: suites.kitchen: no model is of suite 'whit_flat' (did you mean 'white_flat'?)",
        "style mine: no model has the tag 'pink'",
    )
