"""What carries a thing however indirectly, what shares that, and what a thing holds."""

import pytest
from sdgen.catalog.predicate import Related
from sdgen.facts.carriers import carriers_of
from sdgen.kleene import NO, YES

from .scenes import FLOOR, asset, facts, thing

HOLLOW = {"name": "in", "part": "body", "center_m": (0, 0, 0.05), "size_m": (0.2, 0.2, 0.1)}
BOWL = asset(
    "bowl",
    (0.22, 0.22, 0.06),
    containers=[HOLLOW],
    supports=[
        {
            "name": "bottom",
            "part": "body",
            "z_m": 0.01,
            "polygon_m": [(-0.08, -0.08), (0.08, -0.08), (0.08, 0.08), (-0.08, 0.08)],
            "container": "in",
        }
    ],
)


def laid():
    """On the table an apple on a plate, and a bowl with an apple in it; an apple on the floor."""
    return facts(
        thing(1, "table", 2, 2),
        thing(2, "plate", 1.8, 2, 0.75),
        thing(3, "apple", 1.8, 2, 0.76),
        thing(4, "bowl", 2.2, 2, 0.75),
        thing(5, "apple", 2.2, 2, 0.76),
        thing(6, "apple", 3, 2),
        more=[BOWL],
    )


def test_what_is_fixed_carries_itself():
    f = laid()
    assert {k: c.either for k, c in f.carriers(3).items()} == {2: YES, 1: YES}
    assert {k: (c.on, c.inside) for k, c in f.carriers(5).items()} == {4: (NO, YES), 1: (YES, NO)}
    assert set(f.carriers(6)) == {FLOOR}


@pytest.mark.parametrize(
    ("of", "relation", "held"),
    [(1, "ON", [3, 5]), (1, "INSIDE", []), (4, "INSIDE", [5]), (4, "ON", []), (2, "ON", [3])],
)
def test_what_a_thing_holds(of, relation, held):
    assert laid().carried(of, {"apple"}, relation) == tuple((k, YES) for k in held)


def test_what_shares_a_table():
    f = laid()
    assert f.sharing(3, {"apple", "plate"}) == ((2, YES), (5, YES))
    assert f.sharing(6, {"apple", "plate", "table"}) == ((1, YES),)


def test_in_a_fridge_what_stands_on_a_plate_counts_where_it_is_in_the_hollow_itself():
    f = facts(
        thing(1, "fridge", 2, 2),
        thing(2, "plate", 2, 2, 0.5),
        thing(3, "apple", 2, 2, 0.51),
        thing(4, "apple", 2.2, 2.1, 0.5),
    )
    assert f.holds(3, "ON") == (2,)
    assert f.carried(1, {"apple"}, "INSIDE") == ((3, YES), (4, YES))
    assert f.sharing(3, {"apple"}) == ((4, YES),)
    assert f.carried(1, {"apple"}, "ON") == ()


@pytest.mark.parametrize("order", [(2, 3), (3, 2)])
def test_the_surest_way_counts_whichever_is_found_first(order):
    """1 is perhaps on 2 and surely on 3, each of which is on 4, and 4 on 5."""
    sure = {2: False, 3: True}
    ways = {1: [Related(k, "plate", True, sure[k]) for k in order]}
    ways |= {2: [Related(4, "plate", True, True)], 3: [Related(4, "plate", True, True)]}
    ways |= {4: [Related(5, "table", True, True)]}
    plates = {k: thing(k, "plate", 2, 2) for k in (1, 2, 3, 4)}

    class Stacked:
        bodies = facts(*plates.values()).bodies

        def on(self, key):
            return ways.get(key, [])

        def inside(self, _key):
            return []

    found = {k: carrier.on for k, carrier in carriers_of(Stacked(), 1).items()}
    assert found == {2: (True, False), 3: YES, 4: YES, 5: YES}


def test_two_things_each_in_the_other_are_no_endless_matter():
    f = facts(thing(1, "bowl", 2, 2), thing(2, "bowl", 2, 2, 0.01), more=[BOWL])
    assert f.holds(1, "INSIDE") == (2,)
    assert f.holds(2, "INSIDE") == (1,)
    assert set(carriers_of(f, 1)) == {2, FLOOR}
    assert f.sharing(1, {"bowl"}) == ((2, YES),)
