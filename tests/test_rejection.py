"""Rejections are counted, written, read and said without text in between."""

import pickle
from collections import Counter

from hypothesis import given
from hypothesis import strategies as st
from sdgen.errors import SceneRejected
from sdgen.rejection import Cause, causes_in_words, most_frequent, reject
from sdgen.scene import cause_counts, causes_of

NAMES = st.one_of(st.none(), st.sampled_from(["", "spill", "stove_on", "cup"]))
CAUSES = st.builds(
    Cause, st.sampled_from(["home", "proof", "twin"]), st.sampled_from(["no_place"]), *[NAMES] * 4
)
COUNTED = st.dictionaries(CAUSES, st.integers(1, 99), max_size=6)


@given(COUNTED)
def test_what_is_written_is_sorted_and_comes_back(causes):
    counts = cause_counts(causes)
    assert causes_of(counts) == Counter(causes)
    again = cause_counts(dict(reversed(causes.items())))
    assert again == counts


@given(COUNTED)
def test_a_rejected_scene_crosses_processes_whole(causes):
    error = SceneRejected("000003", causes, home_attempts=2)
    back = pickle.loads(pickle.dumps(error))
    assert (back.scene_id, back.causes, str(back)) == ("000003", causes, str(error))
    assert back.home_attempts == 2
    assert list(back.causes) == [cause for cause, _ in most_frequent(causes)]


def test_words_name_the_hazard_or_the_stage_and_the_other_hazard():
    overlap = reject(
        "proof", "accidental", hazard="pills_by_bed", category="pill_bottle", other="x"
    )
    assert overlap.cause.overlap
    assert overlap.cause.in_words() == "pills_by_bed: accidental (pill_bottle) as x"
    already = reject("hazards", "already_set", hazard="h", category="door", state="OPEN")
    assert already.cause.in_words() == "h: already set (door OPEN)"
    floor = reject("home", "no_free_floor", measured=0.1, limit=0.2)
    assert not floor.cause.overlap
    assert causes_in_words({floor.cause: 2, overlap.cause: 7}, most=1).endswith("as x x7")
    assert floor.cause.in_words() == "home: no free floor"
