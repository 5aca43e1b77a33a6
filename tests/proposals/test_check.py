"""What of an answer could be the hazard: judged placement by placement, each with its reason."""

from __future__ import annotations

import pytest
from sdgen.catalog.cases import cases
from sdgen.catalog.load import load_catalog
from sdgen.errors import InputError
from sdgen.proposals.answer import read_answer
from sdgen.proposals.check import Checked, checked

from tests.shipped import shipped_library


def judged(text: str, hazard: str = "broken_item") -> Checked:
    catalog = load_catalog()
    source = read_answer(text.encode(), "a")
    return checked(source, catalog.hazard(hazard), catalog, shipped_library())


def words(found: Checked) -> list[str]:
    return [idea.what for idea in found.ideas]


def test_a_line_is_split_into_its_placements() -> None:
    found = judged(
        "- {place: [vase, mug], state: BROKEN, relation: ON, target: [wardrobe, toilet],"
        ' reason: "it\\nfalls"}\n'
        "- {place: plate, state: BROKEN, relation: ON, target: floor, rooms: [bathroom, storage]}\n"
        "- {set: mirror, state: BROKEN, rooms: [office]}\n"
    )
    assert found.refused == []
    assert words(found) == [
        "BROKEN vase ON wardrobe",
        "BROKEN vase ON toilet",
        "BROKEN mug ON wardrobe",
        "BROKEN mug ON toilet",
        "BROKEN plate ON floor in a bathroom",
        "BROKEN plate ON floor in a storage",
        "mirror BROKEN in a office",
    ]
    assert [idea.line for idea in found.ideas] == [1, 1, 1, 1, 2, 2, 3]
    assert found.ideas[0].reason == "it falls"
    assert all(len(cases(idea.recipe)) == 1 for idea in found.ideas)


PLATE = "place: plate, state: BROKEN, relation: ON"


@pytest.mark.parametrize(
    ("line", "why", "told"),
    [
        (f"{{{PLATE}, target: chiar}}", "unknown", "unknown category 'chiar' (did you mean 'chair"),
        (f"{{{PLATE}, target: chair, rooms: cellar}}", "unknown", "unknown room type 'cellar'"),
        ("{set: unicorn, state: OPEN}", "unknown", "unknown category 'unicorn'"),
        ("{place: plate, state: MELTED, relation: ON, target: bed}", "impossible", "can be MELTED"),
        (
            "{place: plate, state: BROKEN, relation: INSIDE, target: chair}",
            "impossible",
            "no model of chair has a hollow",
        ),
        (f"{{{PLATE}, target: knife}}", "impossible", "no model of knife has a surface"),
        ("{set: plate, state: BROKEN}", "impossible", "plate is placed by another recipe"),
        (
            "{place: plate, state: BROKEN, relation: INSIDE, target: trash_bin}",
            "impossible",
            "can never satisfy the predicate",
        ),
        ("{place: laptop, relation: ON, target: desk}", "beyond", "is never true of a laptop"),
        (f"{{{PLATE}, target: coffee_table}}", "duplicate", "the hazard has it"),
        (f"{{{PLATE}, target: floor, rooms: kitchen}}", "duplicate", "the hazard has it"),
        ("hello", "malformed", "expected a mapping (key: value), got text 'hello'"),
        ("[1, 2]", "malformed", "expected a mapping"),
        ("null", "malformed", "expected a mapping"),
        (".nan", "malformed", "expected a mapping"),
        ("{}", "malformed", "missing key 'place'"),
        ("{set: stove}", "malformed", "missing key 'state'"),
        ("{place: plate}", "malformed", "missing key 'relation'"),
        (f"{{{PLATE}, target: [[chair]]}}", "malformed", "expected a category, got a list"),
        (f"{{{PLATE}, target: {{a: 1}}}}", "malformed", "expected a category or a list of them"),
        (f"{{{PLATE}, target: bed, min_height_m: .nan}}", "malformed", "expected a number"),
        (f"{{{PLATE}, target: bed, min_height_m: .inf}}", "malformed", "expected a number"),
        (f"{{{PLATE}, target: bed, min_height_m: 1e9}}", "malformed", "is not between 0 and 10"),
        (
            "{place: plate, state: on, relation: ON, target: bed}",
            "malformed",
            "'on' is not a state",
        ),
        ("{place: plate, relation: ABOVE, target: bed}", "malformed", "'ABOVE' is not one of ON"),
    ],
)
def test_what_cannot_be_is_told_why(line: str, why: str, told: str) -> None:
    found = judged(f"- {line}\n")
    assert found.ideas == []
    (refused,) = found.refused
    assert refused.why == why
    assert told in refused.detail
    assert refused.line == 1


def test_unknown_keys_and_words_leave_the_rest_of_a_line() -> None:
    found = judged(f"- {{{PLATE}, target: [chair, thron], wieght: 3, near: {{to: stove}}}}\n")
    assert words(found) == ["BROKEN plate ON chair"]
    assert [(r.why, r.what) for r in found.refused] == [
        ("malformed", "wieght"),
        ("malformed", "near"),
        ("unknown", "thron"),
    ]


def test_a_line_that_names_nothing_is_told() -> None:
    """Of one whose words were all unknown, each word is; of one without words, the line."""
    (refused,) = judged(f"- {{{PLATE}, target: []}}\n").refused
    assert refused.why == "malformed"
    (refused,) = judged(f"- {{{PLATE}, target: thron}}\n").refused
    assert (refused.why, refused.what) == ("unknown", "thron")


def test_what_the_list_had_is_a_duplicate() -> None:
    found = judged(f"- {{{PLATE}, target: chair}}\n" * 2)
    assert [r.why for r in found.refused] == ["duplicate"]
    # Anywhere on the floor is on the floor of each room, too.
    everywhere = f"- {{{PLATE}, target: floor}}\n- {{{PLATE}, target: floor, rooms: bathroom}}\n"
    assert words(judged(everywhere)) == ["BROKEN plate ON floor"]


def test_another_hazard_that_it_surely_is_too_is_noted() -> None:
    catalog = load_catalog()
    spill = catalog.hazard("spill")
    mine = spill.model_copy(update={"id": "mine", "anomalies": spill.anomalies[:1]})
    both = catalog.model_copy(update={"hazards": (*catalog.hazards, mine)})
    source = read_answer(b"- {place: puddle, state: SPILLED, relation: ON, target: bench}", "a")
    (idea,) = checked(source, mine, both, shipped_library()).ideas
    assert idea.also == ("spill",)


def test_a_stranger_cannot_ask_for_any_number() -> None:
    names = ", ".join(sorted(c.name for c in load_catalog().categories))
    line = f"- {{place: [{names}], state: BROKEN, relation: ON, target: [{names}]}}\n"
    with pytest.raises(InputError, match=r"a:1: the list stands for more than 1000 placements"):
        judged(line)


def test_words_of_strangers_are_one_printable_line() -> None:
    found = judged('- "\\e[31mred\\nx"\n- {"\\x07\\n": 1, place: "a\\nb\\u2028c"}\n')
    assert found.refused
    for refused in found.refused:
        assert f"{refused.what}{refused.detail}".isprintable(), refused
