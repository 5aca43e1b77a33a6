"""Tables of sources: strictly read, one row a name, the user's own before ours."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.catalog.load import load_catalog
from sdgen.errors import InputError, UsageError
from sdgen.importing.table import SOURCES, Row, Table, load_table, model_key, read_table
from sdgen.importing.words import category_names, load_words
from sdgen.yaml_source import parse_yaml

CATALOG = load_catalog()
NAMES = category_names(CATALOG)
WORDS = load_words(CATALOG)


def rows(text: str) -> tuple[Row, ...]:
    return read_table(parse_yaml(text.encode(), "mine.yaml"), NAMES)


def problems(text: str) -> tuple[str, ...]:
    with pytest.raises(InputError) as caught:
        rows(text)
    return caught.value.problems


def table(*texts: str) -> Table:
    return Table(WORDS, tuple(map(rows, texts)))


@pytest.mark.parametrize("source", SOURCES)
def test_every_shipped_row_names_categories_of_ours_and_facts_that_fit_them(source: str) -> None:
    found = load_table(source, CATALOG).layers
    assert found
    assert found[0]
    for row in found[0]:
        for name in row.category:
            category = CATALOG.category(name)
            assert category.kind not in ("structure", "hazard_only"), row
            if row.mass_kg is not None:
                assert category.mass_min_kg <= row.mass_kg <= category.mass_max_kg, row


#: Names of each source that the tables must know (true: that have a category of ours).
KNOWN = {
    "ycb": {
        "001_chips_can": True,
        "019_pitcher_base": True,
        "027-skillet": True,
        "063-b_marbles": True,
        "065-j_cups": False,
        "070-a_colored_wood_blocks": True,
        "072-k_toy_airplane": False,
        "073-m_lego_duplo": True,
        "077_rubiks_cube": False,
    },
    "gso": {
        "ASICS_GELBlur33_20_GS_BlackWhiteSafety_Orange": True,
        "Womens_Multi_13": True,
        "Womens_Canvas_Bahama_in_White_4UyOhP6rYGO": True,
        "Pokémon_Omega_Ruby_Alpha_Sapphire_Dual_Pack_Nintendo_3DS": False,
        "Granimals_20_Wooden_ABC_Blocks_Wagon_85VdSftGsLi": False,
        "Office_Depot_HP_61Tricolor_Ink_Cartridge": False,
        "Ecoforms_Plant_Saucer_S14MOCHA": False,
        "Ecoforms_Plant_Container_S14Turquoise": True,
        "Schleich_Allosaurus": True,
        "CoQ10_BjTLbuRVt1t": True,
        "Olive_Kids_Mermaids_Pack_n_Snack_Backpack": True,
    },
    "replicacad": {
        "frl_apartment_wall_cabinet_03": True,
        "frl_apartment_bike_02": False,
        "kitchenCupboard_01": True,
        "chestOfDrawers_01_dynamic": True,
        "doors/doubledoor": True,
        "doors/door3": True,
        "fridge/top_door": True,
        "frl_apartment_stage": False,
    },
    "fantastic-breaks": {"00/00002": False, "09/09006": False},
    "folder": {
        "aws_robomaker_residential_TV_02": True,
        "aws_robomaker_residential_TVCabinet_01": True,
        "aws_robomaker_residential_HouseWallB_01": False,
        "sofa_02_4k": True,
        "painted_wooden_chair_02": True,
    },
}


@pytest.mark.parametrize("source", SOURCES)
def test_shipped_tables_know_the_models_of_their_source(source: str) -> None:
    shipped = load_table(source, CATALOG)
    for name, ours in KNOWN[source].items():
        row = shipped.row(name)
        assert row is not None, name
        assert bool(row.category) is ours, (name, row)
        assert row.category or row.why or row.skip


def test_a_whole_name_comes_before_patterns_and_a_longer_pattern_before_a_shorter_one() -> None:
    found = table(
        "rows:\n"
        "  - {models: 'Cup_*', category: mug}\n"
        "  - {models: ['*', '*_Tall'], category: vase}\n"
        "  - {models: 'Cup_Wine*', category: wine_glass}\n"
        "  - {models: Cup_Wine_Tall, category: pitcher}\n"
    )
    names = ("Cup_Wine_Tall", "Cup_Wine_Red", "Cup_Tall", "Lamp", "cup  wine_red")
    said = [row.category for name in names if (row := found.row(name))]
    expected = [("pitcher",), ("wine_glass",), ("vase",), ("vase",), ("wine_glass",)]
    assert said == expected


def test_the_users_own_table_comes_first(tmp_path: Path) -> None:
    own = tmp_path / "mine.yaml"
    own.write_text("rows:\n  - {models: '02*', category: vase}\n", encoding="utf-8")
    both = load_table("ycb", CATALOG, [own])
    mug, banana = both.row("025_mug"), both.row("011_banana")
    assert mug is not None
    assert mug.category == ("vase",)
    assert banana is not None
    assert banana.category == ("banana",)
    assert banana.mass_kg == 0.066


def test_all_that_is_wrong_in_a_table_is_said_at_once_and_where() -> None:
    found = problems(
        "rows:\n"
        "  - {models: a, category: mugg}\n"
        "  - {models: b, categori: mug}\n"
        "  - {models: c}\n"
        "  - {models: d, category: mug, skip: no thing}\n"
        "  - {models: e, category: mug, front: +z}\n"
        "  - {models: f, category: mug, mass_kg: -1}\n"
        "  - {models: g, category: mug, states: [broken]}\n"
        "  - {models: [], category: mug}\n"
    )
    wanted = (
        "mine.yaml:2: rows[0].category: unknown category 'mugg' (did you mean 'mug'?)",
        "mine.yaml:3: rows[1].categori: unknown key (did you mean 'category'?)",
        "mine.yaml:4: rows[2]: missing key 'category': expected one, or 'why' there is none",
        "mine.yaml:5: rows[3].skip: does not go with 'category'",
        "mine.yaml:6: rows[4].front: '+z' is not one of +x, -x, +y, -y",
        "mine.yaml:7: rows[5].mass_kg: -1 is not between 0.0001 and 1000",
        "mine.yaml:8: rows[6].states[0]: 'broken' is not a state; states are UPPER CASE",
        "mine.yaml:9: rows[7].models: expected at least one model's name",
    )
    for start in wanted:
        assert any(line.startswith(start) for line in found), (start, found)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "mine.yaml:1: is empty"),
        ("[]", "mine.yaml:1: expected a mapping"),
        ("rows: {}", "mine.yaml:1: rows: expected a list of rows"),
        ("rows: []\nrow: []", "mine.yaml:2: row: unknown key (did you mean 'rows'?)"),
        ("rows:\n- {models: a, models: b}", "models"),
        ("rows: !!python/object:os.system x", "mine.yaml:1"),
        ("rows:\n- {models: '*', category: mug}\n- {models: '*', category: cup}", "category 'cup'"),
    ],
)
def test_what_is_no_table_is_refused(text: str, expected: str) -> None:
    assert any(expected in line for line in problems(text)), problems(text)


def test_no_model_is_named_twice() -> None:
    text = (
        "rows:\n"
        "  - {models: [Mug_01, x], category: mug}\n"
        "  - {models: ['mug 01', y], category: vase}\n"
    )
    assert problems(text) == ("mine.yaml:3: rows[1].models: 'mug 01' is named by rows[0] already",)
    assert problems("rows:\n- {models: _, category: mug}\n") == (
        "mine.yaml:2: rows[0].models: '_' names no model",
    )


def test_a_missing_table_and_an_unknown_source_are_said(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"unknown source 'ybc' \(did you mean 'ycb'\?\)"):
        load_table("ybc", CATALOG)
    missing, bad = tmp_path / "missing.yaml", tmp_path / "bad.yaml"
    bad.write_text("rows: 3\n", encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load_table("ycb", CATALOG, [missing, bad])
    assert len(caught.value.problems) == 2
    assert str(missing) in caught.value.problems[0]
    assert caught.value.problems[1].startswith(f"{bad}:1: rows: expected a list of rows")


@given(st.text(max_size=40), st.lists(st.text(alphabet="ab*_é ", max_size=6), max_size=4))
def test_looking_up_any_name_never_fails(name: str, patterns: list[str]) -> None:
    named = tuple({model_key(one): one for one in patterns if one.strip("*_ ")}.values())
    found = Table(WORDS, ((Row(models=named or ("a",), category=("mug",)),),))
    row = found.row(name)
    assert row is None or row.category == ("mug",)
    for pattern in named:
        assert found.row(pattern.replace("*", "ab")) is not None


@given(st.recursive(st.none() | st.booleans() | st.integers() | st.text(max_size=8), st.lists))
def test_any_rows_are_read_or_refused_with_their_place(value: object) -> None:
    source = parse_yaml(json.dumps({"rows": value}).encode(), "mine.yaml")
    try:
        found = read_table(source, NAMES)
    except InputError as error:
        found, told = (), error.problems
    else:
        told = ()
    assert all(isinstance(row, Row) for row in found)
    assert all(problem.startswith("mine.yaml:") for problem in told)
    assert found == () or told == ()
