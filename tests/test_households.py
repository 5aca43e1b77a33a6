"""Who lives there, and what they want to hear of."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.catalog.folder import extension_names
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Concern, Hazard, HouseholdTemplate, MemberRule, ReachRow, Trait
from sdgen.households import (
    Decision,
    decide,
    draw_template,
    household_from,
    reach_at,
    sample_household,
    wished_traits,
)
from sdgen.scene import Household, Member, Notify
from sdgen.seeding import lane

CATALOG = load_catalog()
ROLES = ("parent", "grandparent", "child")


def drawn_household(seed: int, index: int) -> Household:
    template = draw_template(CATALOG, lane(seed, index, "template"))
    return sample_household(CATALOG, template, lane(seed, index, "household"))


REACH = (ReachRow(max_age=1, reach_m=0.8), ReachRow(max_age=4, reach_m=1.1))
STOVE, SHARP = CATALOG.hazard("stove_on"), CATALOG.hazard("sharp_object")


def living(*ages: int, **notifications: Notify) -> Household:
    members = tuple(Member(role="member", age=age) for age in ages)
    return Household(template="test", members=members, notifications=notifications)


def test_everyone_hears_of_what_concerns_everyone() -> None:
    assert decide(STOVE, {}, living(80), REACH) == Decision(
        True, "now", "It concerns everyone who lives here, and it is too urgent to wait."
    )


@pytest.mark.parametrize(
    ("urgency", "notify"), [("high", "now"), ("medium", "now"), ("low", "summary")]
)
def test_the_default_follows_the_urgency(urgency: str, notify: str) -> None:
    hazard = STOVE.model_copy(update={"urgency": urgency})
    assert decide(hazard, {}, living(40), REACH).notify == notify


@pytest.mark.parametrize(
    ("choice", "report"), [("now", True), ("summary", True), ("silent", False)]
)
def test_the_households_choice_wins(choice: Notify, report: bool) -> None:
    found = decide(CATALOG.hazard("spill"), {}, living(40, spill=choice), REACH)
    assert (found.report, found.notify) == (report, choice)


@pytest.mark.parametrize(
    ("ages", "height", "report"),
    [
        ((40, 38), 0.0, False),  # no child
        ((40, 9), 0.0, False),  # too old for the hazard
        ((40, 3), 0.75, True),
        ((40, 3), 1.1, True),  # just in reach
        ((40, 3), 1.11, False),  # just out of reach
        ((40, 1), 0.9, False),
        ((40, 1, 4), 0.9, True),  # the older child reaches it
        ((8,), 1.29, True),  # beyond the table: reaches everything
    ],
)
def test_sharp_things_concern_children_who_can_reach_them(
    ages: tuple[int, ...], height: float, report: bool
) -> None:
    found = decide(SHARP, {"reach_height_m": height}, living(*ages), REACH)
    assert found.report is report
    assert found.notify == ("now" if report else "silent")


def test_a_choice_cannot_make_it_concern_nobodys_children() -> None:
    found = decide(SHARP, {"reach_height_m": 0.1}, living(40, sharp_object="now"), REACH)
    assert found == Decision(False, "silent", "Nobody who lives here is 8 or younger.")


def test_without_reach_any_child_will_do() -> None:
    hazard = SHARP.model_copy(update={"concerns": Concern(who="children", max_age=3)})
    assert decide(hazard, {}, living(2, 40), REACH).report
    assert not decide(hazard, {}, living(4, 40), REACH).report


def test_a_reach_hazard_without_its_height_is_a_bug() -> None:
    with pytest.raises(ValueError, match="reach_height_m"):
        decide(SHARP, {}, living(3), REACH)


@pytest.mark.parametrize(
    ("ages", "height", "reason"),
    [
        ((3,), 0.75, "A child of 3 reaches 1.10 m high, it lies at 0.75 m, and it is too urgent"),
        ((3,), 1.2, "It lies at 1.20 m, above the 1.10 m that a child of 3 reaches."),
        # Settled a hair into the floor it still is on the floor.
        ((3,), -0.0004, "A child of 3 reaches 1.10 m high, it lies on the floor, and it is too"),
        ((0,), 0.3, "A baby reaches 0.80 m high, it lies at 0.30 m, and it is too urgent to wait."),
        ((7,), 1.5, "A child of 7 reaches as high as a grown-up, it lies at 1.50 m, and it is too"),
    ],
)
def test_the_reason_is_a_sentence(ages: tuple[int, ...], height: float, reason: str) -> None:
    found = decide(SHARP, {"reach_height_m": height}, living(*ages), REACH).reason
    assert found.startswith(reason)
    assert found.endswith(".")


@pytest.mark.parametrize(
    ("ages", "above", "floor", "report", "reason"),
    [
        # What is low enough anyway is taken from the floor.
        ((3,), 0.3, 0.75, True, "A child of 3 reaches 1.10 m high, it lies at 0.75 m, and"),
        (
            (3,),
            1.0,
            1.45,
            True,
            "A child of 3 reaches 1.10 m high, from what it climbs on 0.45 m higher, it lies at",
        ),
        (
            (3,),
            1.2,
            1.65,
            False,
            "It lies at 1.65 m, 1.20 m above what stands beside it, above the 1.10 m that a child",
        ),
        # A baby does not climb.
        ((0,), 0.3, 0.75, False, "It lies at 0.75 m, above the 0.40 m that a baby reaches."),
        ((0, 3), 0.3, 0.75, True, "A child of 3 reaches 1.10 m high"),
    ],
)
def test_children_climb_and_babies_do_not(
    ages: tuple[int, ...], above: float, floor: float, report: bool, reason: str
) -> None:
    reach = (
        ReachRow(max_age=0, reach_m=0.4, climbs=False),
        ReachRow(max_age=3, reach_m=1.1),
    )
    lies = {"reach_height_m": above, "height_m": floor, "climbed_id": 7}
    found = decide(SHARP, lies, living(*ages), reach)
    assert found.report is report
    assert found.reason.startswith(reason)


@pytest.mark.parametrize(
    ("choice", "reason"),
    [
        ("now", "It concerns everyone who lives here, and the household wants to be told at once."),
        ("silent", "It concerns everyone who lives here, but the household does not want to hear"),
    ],
)
def test_the_reason_says_what_the_household_chose(choice: Notify, reason: str) -> None:
    spill = CATALOG.hazard("spill")
    assert decide(spill, {}, living(40, spill=choice), REACH).reason.startswith(reason)


def test_nobody_is_silent_about_fire_or_an_open_front_door() -> None:
    for name in ("stove_on", "candle_on", "front_door_open"):
        found = decide(CATALOG.hazard(name), {}, living(40, **{name: "silent"}), REACH)
        assert found.report, name
        assert found.notify == "now"
        assert not any("silent" in t.notifications.get(name, ()) for t in CATALOG.households)


def with_pet(*ages: int, pets: tuple[str, ...] = (), conditions: tuple[str, ...] = ()) -> Household:
    return living(*ages).model_copy(update={"pets": pets, "conditions": conditions})


def test_a_pet_makes_medicine_and_an_open_door_urgent() -> None:
    medicine, door = CATALOG.hazard("poison_medication"), CATALOG.hazard("front_door_open")
    lies = {"reach_height_m": 0.4}
    assert not decide(medicine, lies, living(40), REACH).report
    found = decide(medicine, lies, with_pet(40, pets=("dog",)), REACH)
    assert found == Decision(
        True,
        "now",
        "Nobody who lives here is 6 or younger, but a dog lives here: the household is told at "
        "once.",
    )
    later = {"notifications": {"front_door_open": "summary"}}
    assert decide(door, {}, living(40).model_copy(update=later), REACH).notify == "summary"
    cat = with_pet(40, pets=("cat",)).model_copy(update=later)
    assert decide(door, {}, cat, REACH).notify == "now"


def test_who_may_fall_is_told_of_what_one_falls_over() -> None:
    later = {"notifications": {"tripping_hazard": "summary", "spill": "summary"}}
    for condition in ("walks with a stick", "has weak eyesight"):
        for name in later["notifications"]:
            hazard = CATALOG.hazard(name)
            well = living(80).model_copy(update=later)
            ill = with_pet(80, conditions=(condition,)).model_copy(update=later)
            assert decide(hazard, {}, well, REACH).notify == "summary"
            found = decide(hazard, {}, ill, REACH)
            assert found.notify == "now"
            assert f"and somebody who lives here {condition}:" in found.reason


def test_every_pet_and_condition_matters_to_a_hazard() -> None:
    """Some to one of a pack alone: nobody smokes where no hazard asks."""
    everything = load_catalog(extensions=extension_names())
    for template in CATALOG.households:
        for trait in template.traits:
            concerned = [
                hazard.id
                for hazard in everything.hazards
                for words in (
                    hazard.concerns.living_with,
                    *(rule.living_with for rule in hazard.concerns.raised_by),
                )
                if trait in words
            ]
            assert concerned, trait


def test_what_matters_to_nothing_is_never_drawn() -> None:
    pets = (Trait(name="goldfish"), Trait(name="cat"))
    owner = CATALOG.households[0].model_copy(update={"pets": pets})
    drawn = {
        pet
        for k in range(40)
        for pet in sample_household(CATALOG, owner, lane(1, k, "household")).pets
    }
    assert drawn == {"cat"}


_HAZARDS = st.sampled_from(CATALOG.hazards)
_AGES = st.lists(st.integers(0, 99), min_size=1, max_size=5)
_CHOICES = st.dictionaries(
    st.sampled_from([h.id for h in CATALOG.hazards]),
    st.sampled_from(["now", "summary", "silent"]),
)


@given(_HAZARDS, _AGES, _CHOICES, st.floats(0, 2.5))
def test_silent_means_not_reported_and_nothing_else(
    hazard: Hazard, ages: list[int], chosen: dict[str, Notify], height: float
) -> None:
    found = decide(hazard, {"reach_height_m": height}, living(*ages, **chosen), CATALOG.reach)
    assert found.report == (found.notify != "silent")
    assert found.reason


@given(_AGES, st.floats(0, 2.5), st.floats(0, 2.5))
def test_what_is_lower_is_reported_as_well(ages: list[int], a: float, b: float) -> None:
    low, high = sorted((a, b))
    if decide(SHARP, {"reach_height_m": high}, living(*ages), CATALOG.reach).report:
        assert decide(SHARP, {"reach_height_m": low}, living(*ages), CATALOG.reach).report


def test_reach_grows_with_age() -> None:
    reaches = [reach_at(age, CATALOG.reach) for age in range(0, 25)]
    assert reaches == sorted(reaches)
    assert 0.6 < reach_at(1, CATALOG.reach) < 1.0
    assert reach_at(18, CATALOG.reach) == float("inf")


def test_sampling_covers_the_templates_and_keeps_their_ages() -> None:
    templates = {template.name: template for template in CATALOG.households}
    seen: Counter[str] = Counter()
    reported = Counter[bool]()
    for index in range(400):
        household = drawn_household(7, index)
        template = templates[household.template]
        seen[template.name] += 1
        for member, rule in zip(household.members, template.members, strict=True):
            assert member.role == rule.role
            assert rule.age[0] <= member.age <= rule.age[1]
        assert {*household.pets, *household.conditions} <= set(template.traits)
        assert set(household.opt_outs) <= {one.name for one in template.opt_outs}
        assert set(household.notifications) == set(template.notifications)
        reported[decide(SHARP, {"reach_height_m": 0.75}, household, CATALOG.reach).report] += 1
    assert set(seen) == set(templates)
    assert min(seen.values()) > 20
    assert min(reported.values()) > 80  # both answers are common, or CAS would measure nothing


def test_couples_are_of_an_age_and_parents_were_grown_up() -> None:
    for index in range(400):
        household = drawn_household(7, index)
        ages = {role: [m.age for m in household.members if m.role == role] for role in ROLES}
        for role in ("parent", "grandparent"):
            assert max(ages[role], default=0) - min(ages[role], default=0) <= 9
        if household.template in ("couple", "elderly_couple"):
            assert abs(household.members[0].age - household.members[1].age) <= 10
        assert min(ages["parent"], default=99) - max(ages["child"], default=0) >= 15


def test_an_age_beside_the_member_before_stays_within_its_own_range() -> None:
    rule = MemberRule(role="parent", age=(22, 45), years_after=(-8, 8))
    assert rule.ages(30) == (22, 38)
    assert rule.ages(None) == (22, 45)
    assert rule.ages(70) == (45, 45)
    assert rule.ages(5) == (22, 22)
    assert MemberRule(role="child", age=(0, 3), years_after=(18, 44)).ages(19) == (0, 1)


def test_sampling_depends_on_the_lane_alone() -> None:
    first = [drawn_household(7, k) for k in range(5)]
    assert first == [drawn_household(7, k) for k in range(5)]
    assert len({household.model_dump_json() for household in first}) > 1


def test_each_hazard_is_sometimes_wanted_and_sometimes_not() -> None:
    for hazard in CATALOG.hazards:
        answers = {
            decide(
                hazard,
                {"reach_height_m": 0.75},
                drawn_household(1, k),
                CATALOG.reach,
            ).notify
            for k in range(200)
        }
        assert "now" in answers, hazard.id


def test_a_household_can_be_given_in_full() -> None:
    template = next(t for t in CATALOG.households if t.name == "single")
    household = household_from(template, [33], pets=["cat"], notifications={"spill": "summary"})
    assert household.members == (Member(role="adult", age=33),)
    with pytest.raises(ValueError):
        household_from(template, [33, 34])


def concerning(**keys: object) -> Hazard:
    """Spills, were they to concern others."""
    concern = Concern.model_validate(keys)
    return CATALOG.hazard("spill").model_copy(update={"concerns": concern})


@pytest.mark.parametrize(
    ("concern", "household", "room", "reason"),
    [
        (
            {"who": "older_people", "min_age": 65},
            living(40, 71),
            "hall",
            "Somebody of 71 lives here, and it is too urgent to wait.",
        ),
        (
            {"who": "older_people", "min_age": 65},
            living(40, 64),
            "hall",
            "Nobody who lives here is 65 or older.",
        ),
        (
            {"who": "living_with", "living_with": ["cat", "dog"]},
            with_pet(40, pets=("dog",)),
            "hall",
            "A dog lives here, and it is too urgent to wait.",
        ),
        (
            {"who": "living_with", "living_with": ["has dementia"]},
            with_pet(80, conditions=("has dementia",)),
            "hall",
            "Somebody who lives here has dementia, and it is too urgent to wait.",
        ),
        (
            {"who": "living_with", "living_with": ["cat", "dog"]},
            living(40),
            "hall",
            "It concerns who lives with this alone: cat, dog.",
        ),
        (
            {"who": "everyone", "rooms": ["child_room", "bedroom"]},
            living(40),
            "bedroom",
            "It concerns everyone who lives here, and it is too urgent to wait.",
        ),
        (
            {"who": "everyone", "rooms": ["child_room", "bedroom"]},
            living(40),
            "hall",
            "It would concern them in the child room or bedroom alone.",
        ),
    ],
)
def test_whom_else_a_hazard_concerns(
    concern: dict[str, object], household: Household, room: str, reason: str
) -> None:
    found = decide(concerning(**concern), {}, household, REACH, room)
    assert found.reason == reason
    assert found.report == reason.endswith("too urgent to wait.")


@pytest.mark.parametrize(
    "keys",
    [
        {"who": "older_people"},
        {"who": "living_with"},
        {"who": "everyone", "min_age": 65},
        {"who": "everyone", "living_with": ["cat"]},
        {"who": "older_people", "min_age": 65, "by_reach": True},
    ],
)
def test_a_concern_without_what_it_needs_or_with_what_is_anothers_is_refused(
    keys: dict[str, object],
) -> None:
    with pytest.raises(ValueError):
        Concern.model_validate(keys)


def test_who_opted_out_hears_nothing_but_of_what_nobody_is_silent_about() -> None:
    food, stove = CATALOG.hazard("fridge_open"), CATALOG.hazard("stove_on")
    out = living(40).model_copy(update={"opt_outs": ("sanitation", "stove_on", "spill")})
    assert decide(food, {}, out, REACH) == Decision(
        False,
        "silent",
        "It concerns everyone who lives here, but the household opted out of sanitation.",
    )
    assert decide(CATALOG.hazard("spill"), {}, out, REACH).notify == "silent"
    assert decide(stove, {}, out, REACH).notify == "now"
    assert decide(CATALOG.hazard("broken_item"), {}, out, REACH).notify == "now"


def test_half_of_the_scenes_with_a_pets_hazard_have_the_pet() -> None:
    """Where the household may have one at all; the draw of hazards knows nothing of it."""
    lilies = concerning(who="living_with", living_with=["cat"])
    catalog = CATALOG.model_copy(update={"hazards": (*CATALOG.hazards[1:], lilies)})
    may = [t for t in CATALOG.households if "cat" in t.traits]
    having = 0
    for k in range(400):
        wished = wished_traits([lilies], CATALOG.categories, lane(5, k, "wished"))
        assert set(wished) <= {"cat"}
        template = draw_template(
            catalog, lane(5, k, "template"), lambda one, w=wished: not w or one in may
        )
        found = sample_household(catalog, template, lane(5, k, "household"), wished)
        assert not wished or found.pets.count("cat") == 1
        having += "cat" in found.pets
    assert 200 < having < 330


def test_who_has_a_hazards_bowl_has_the_pet() -> None:
    """Whatever a hazard puts, and nothing else, belongs to a pet: nobody has it without one."""
    catalog = load_catalog(extensions=("hygiene",))
    bowl = catalog.hazard("pet_bowl_on_table")
    for k in range(20):
        wished = wished_traits([bowl], catalog.categories, lane(5, k, "wished"))
        assert wished == ("cat", "dog")
        template = next(t for t in catalog.households if "cat" in t.traits)
        assert sample_household(catalog, template, lane(5, k, "household"), wished).pets
    assert wished_traits([catalog.hazard("spill")], catalog.categories, lane(5, 0, "wished")) == ()


def test_shares_of_traits_are_kept_and_old_files_still_read() -> None:
    template = next(t for t in CATALOG.households if t.name == "elderly_couple")
    drawn = Counter(
        condition
        for k in range(600)
        for condition in sample_household(CATALOG, template, lane(9, k, "h")).conditions
    )
    assert 240 < drawn["walks with a stick"] < 360
    assert 100 < drawn["has dementia"] < 200
    written = template.model_dump(mode="json") | {"conditions": ["walks with a stick"]}
    del written["opt_outs"]
    (old,) = HouseholdTemplate.model_validate(written).conditions
    assert (old.name, old.share) == ("walks with a stick", 0.5)


def test_every_shipped_hazard_says_how_bad_it_is_and_who_says_so() -> None:
    for hazard in load_catalog().hazards:
        assert hazard.severity is not None, hazard.id
        assert hazard.guidance, hazard.id
        for one in (*hazard.guidance, hazard.severity.source):
            assert min(len(one.body), len(one.title), len(one.says)) >= 5, hazard.id
            assert str(one) in hazard.source or one == hazard.severity.source
