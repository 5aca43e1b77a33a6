"""What is known of classes before one of their things is seen."""

import numpy as np
import pytest
from sdgen.perception.kinds import Kinds

from tests import toy
from tests.perception.toys import kinds


def test_tables_carry_and_knives_do_not():
    table, knife = kinds()["kitchen_table"], kinds()["knife"]
    assert (table.carries, table.flat, table.boxy, table.hung) == (True, True, True, False)
    assert not knife.carries
    assert table.largest == pytest.approx((1.2, 0.8, 0.74))


def test_a_fridge_has_a_hollow_behind_a_door():
    (hollow,) = kinds()["fridge"].hollows
    assert hollow.shut
    assert hollow.low == pytest.approx((0.05 / 0.6, 0.05 / 0.6, 0.1 / 1.8))
    assert hollow.high == pytest.approx((0.55 / 0.6, 0.55 / 0.6, 1.7 / 1.8))


def test_the_catalogue_says_what_hangs():
    assert kinds()["picture_frame"].hung
    assert kinds()["wall_cabinet"].hung
    assert not kinds()["sofa"].hung
    assert not kinds()["doormat"].hung


def test_a_class_without_models_is_as_large_as_the_catalogue_says():
    category = toy.catalog().category("sofa")
    assert np.array_equal(kinds()["sofa"].largest, category.extents_max_m)
    with pytest.raises(KeyError):
        kinds()["unicorn"]


def test_alike_are_the_nearest_in_size_of_the_same_kind():
    knife = toy.infos()["knife_01"]
    sizes = {"fork": 0.19, "spoon": 0.22, "spatula": 0.4, "plate": 0.3, "table_lamp": 0.2}
    models = [
        knife.model_copy(
            update={"id": f"{name}_01", "category": name, "extents_m": (size, 0.03, 0.01)}
        )
        for name, size in sizes.items()
    ]
    known = Kinds(toy.catalog(), [knife, *models])
    assert known.alike("knife") == ("fork", "spoon", "plate")
    assert known.alike("spatula")[0] == "plate"
