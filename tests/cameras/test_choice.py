"""Near views are as many in every scene and fall on benign things too."""

import pytest
from sdgen.cameras import choice
from sdgen.cameras.choice import (
    Sight,
    glance_pixels,
    high_count,
    like_anomalies,
    near_count,
    unseen,
)
from sdgen.catalog.records import Hazard, SetRecipe
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.scene import Anomaly
from sdgen.seeding import lane

from tests.fakes import box_room, thing


@pytest.mark.parametrize(
    ("views", "most", "near"), [(8, 5, 5), (12, 5, 8), (4, 5, 3), (1, 5, 0), (0, 5, 0), (6, 1, 4)]
)
def test_the_number_of_near_views_follows_from_the_options_alone(views, most, near):
    options = BuildOptions(views=views, hazards_max=most)
    assert near_count(options) == near
    assert high_count(options) == (1 if views - near > 2 else 0)


def test_large_things_must_show_more_than_small_ones():
    sizes = [glance_pixels(d) for d in (0.01, 0.08, 0.3, 1.0, 5.0)]
    assert sizes == sorted(sizes)
    assert sizes[0] == sizes[1] >= 200


def test_categories_follow_the_recipes_weights_however_small():
    """Things of one category stay together, and which comes first is a matter of weight."""
    recipes = [
        SetRecipe(categories=("stove",), state="ON", weight=1e-8),
        SetRecipe(categories=("oven",), state="ON", weight=3e-8),
    ]
    hazard = Hazard.model_construct(id="hot", anomalies=tuple(recipes))
    benign = {k: ("stove", "oven", "chair")[k % 3] for k in range(1, 13)}
    first = []
    for k in range(400):
        order = [benign[i] for i in like_anomalies(hazard, benign, {}, lane(k, 0, "x"))]
        assert order in (
            ["stove"] * 4 + ["oven"] * 4 + ["chair"] * 4,
            ["oven"] * 4 + ["stove"] * 4 + ["chair"] * 4,
        )
        first.append(order[0])
    assert first.count("oven") == pytest.approx(300, abs=40)


def test_lookalikes_come_before_other_things_and_now_and_then_first_of_their_category():
    hazard = Hazard.model_construct(
        id="hot", anomalies=(SetRecipe(categories=("stove",), state="ON"),)
    )
    benign = {1: "stove", 2: "stove", 3: "pan", 4: "chair"}
    orders = {
        tuple(like_anomalies(hazard, benign, {2: "hot", 3: "hot"}, lane(k, 0, "x")))
        for k in range(50)
    }
    assert orders == {(1, 2, 3, 4), (2, 1, 3, 4)}


def test_anomalies_are_searched_for_longer_than_other_things(
    library: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: dict[int, int] = {}

    def none(*arguments: object) -> None:
        asked[arguments[3].object_id] = arguments[-1]  # type: ignore[attr-defined, assignment]

    monkeypatch.setattr(choice, "best_near_pose", none)
    sight = Sight(
        library,
        box_room([thing(10, "cube_01", (0, 0, 0)), thing(11, "cube_02", (1, 0, 0))]),
        cast=None,  # type: ignore[arg-type]
        seed=0,
    )
    anomaly = Anomaly.model_construct(object_id=10, evidence_parts=())
    assert unseen(sight, [anomaly]) is anomaly
    assert sight.near(11) is None
    assert asked == {10: choice.ANOMALY_ROUNDS, 11: 1}
