"""Strong Kleene logic: the truth tables, and what "sure" promises."""

import itertools

from hypothesis import given
from hypothesis import strategies as st
from sdgen.kleene import NO, YES, Kleene, all_of, any_of, at_least, at_most

MAYBE = (Kleene(True, False), Kleene(False, False))
ANY = st.sampled_from([YES, NO, *MAYBE])


def worlds(part):
    """What a part may really be."""
    return [part.value] if part.sure else [True, False]


@given(st.lists(ANY, max_size=4))
def test_sure_is_what_holds_in_every_world_and_only_that(parts):
    for combine, plain in ((all_of, all), (any_of, any)):
        found = combine(parts)
        possible = {plain(world) for world in itertools.product(*map(worlds, parts))}
        assert found.sure == (len(possible) == 1)
        assert found.value == (plain(p.value for p in parts))


def test_nothing_is_claimed_within_a_margin_of_a_limit():
    steps = [k / 100 for k in range(80, 121)]
    for test, first in ((at_most, True), (at_least, False)):
        found = [test(value, 1.0, 0.05) for value in steps]
        assert [f.value for f in found].index(not first) == (21 if first else 20)
        assert [value for value, f in zip(steps, found, strict=True) if not f.sure] == steps[16:25]
