"""Stable resting poses."""

import math

import numpy as np
import pytest
from sdgen.geometry import box_corners
from sdgen.library.poses import resting_poses
from sdgen.library.shape import centre_of_mass

from tests.shipped import shipped_library


def test_a_slab_lies_flat_on_either_side() -> None:
    slab = box_corners((-0.5, -0.5, 0.0), (0.5, 0.5, 0.1))
    first, second, *rest = resting_poses([slab], np.array([0.0, 0.0, 0.05]))
    assert {first.up, second.up} == {(0.0, 0.0, 1.0), (0.0, 0.0, -1.0)}
    assert first.share == pytest.approx(second.share, abs=1e-3)
    assert first.share > 0.35
    assert all(pose.share < first.share for pose in rest)


def test_a_cube_has_six_equal_ways() -> None:
    poses = resting_poses([box_corners((0, 0, 0), (1, 1, 1))], np.array([0.5, 0.5, 0.5]))
    assert len(poses) == 6
    assert [pose.share for pose in poses] == pytest.approx([1 / 6] * 6, abs=2e-3)


def test_a_heavy_foot_makes_standing_likely() -> None:
    column = box_corners((-0.05, -0.05, 0.0), (0.05, 0.05, 0.3))
    low = resting_poses([column], np.array([0.0, 0.0, 0.02]))
    even = resting_poses([column], np.array([0.0, 0.0, 0.15]))

    def standing(poses) -> float:
        return sum(pose.share for pose in poses if pose.up[2] > 0.9)

    assert standing(low) > standing(even)


def test_round_things_have_one_pose_at_least() -> None:
    angles = np.linspace(0, 2 * math.pi, 25)[:-1]
    heights = np.linspace(-0.9, 0.9, 11)
    ball = np.array(
        [
            (math.cos(a) * math.sqrt(1 - h * h), math.sin(a) * math.sqrt(1 - h * h), h)
            for a in angles
            for h in heights
        ]
    )
    assert len(resting_poses([ball], np.zeros(3))) >= 1


def test_the_library_stores_what_its_hulls_give() -> None:
    library = shipped_library()
    for name in ("fridge_01", "mug_01", "milk_carton_01"):
        asset = library.assets[name]
        drawn = asset.variants["default"]
        pieces = [hull.vertices_m for hull in library.hulls(name) if hull.part in drawn]
        assert asset.resting == resting_poses(pieces, centre_of_mass(pieces))
