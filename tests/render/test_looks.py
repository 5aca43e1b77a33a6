"""Each part of a look does to colours what it says, and no more."""

import hashlib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.looks import PRESETS, drawn_look
from sdgen.render.looks import as_seen
from sdgen.scene import Look
from sdgen.seeding import lane

PERFECT = Look(
    exposure_stops=0.0,
    white_balance=(1.0, 1.0, 1.0),
    vignetting=0.0,
    focus_px=0.0,
    motion_px=0.0,
    shot_noise=0.0,
    read_noise=0.0,
    noise_seed=3,
)
GOLDEN = "a4977c8395c642494751d61861b581b42d967926e52f1a09e3ab9037475fc9ac"


def look(**parts):
    return PERFECT.model_copy(update=parts)


def grey(value, size=(90, 120)):
    return np.full((*size, 3), value, dtype=np.uint8)


def linear(rgb):
    value = rgb / 255.0
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


@pytest.fixture(scope="module")
def picture():
    return np.random.default_rng(5).integers(0, 256, (75, 100, 3), dtype=np.uint8)


def test_without_a_look_nothing_is_touched(picture):
    assert as_seen(picture, None) is picture
    assert np.array_equal(as_seen(picture, PERFECT), picture)


@pytest.mark.parametrize("stops", [-1.0, -0.3, 0.5, 1.0])
def test_exposure_is_in_stops_of_light(stops):
    for value in (30, 80, 120):
        seen = as_seen(grey(value), look(exposure_stops=stops))
        assert linear(seen).mean() == pytest.approx(linear(value) * 2**stops, rel=0.03)
    assert as_seen(grey(250), look(exposure_stops=1.0)).min() == 255


def test_white_balance_turns_grey_warm_and_nothing_else_does(picture):
    seen = as_seen(grey(120), look(white_balance=(1.1, 1.0, 0.9)))
    red, green, blue = (linear(seen[..., k]).mean() / linear(120) for k in range(3))
    assert (red, green, blue) == pytest.approx((1.1, 1.0, 0.9), rel=0.02)
    rest = look(exposure_stops=0.4, vignetting=0.4, focus_px=1.0, motion_px=2.0)
    assert np.ptp(as_seen(grey(120), rest), axis=2).max() == 0


def test_corners_lose_what_vignetting_says_and_the_middle_nothing():
    seen = linear(as_seen(grey(180, (91, 121)), look(vignetting=0.4))[..., 0]) / linear(180)
    assert seen[45, 60] == pytest.approx(1.0, abs=0.01)
    corners = seen[[0, 0, -1, -1], [0, -1, 0, -1]]
    assert corners == pytest.approx([0.6] * 4, abs=0.01)
    assert (np.diff(seen[45, 60:]) <= 1e-9).all()


@pytest.mark.parametrize("parts", [{"focus_px": 1.3}, {"motion_px": 5.0}, {"focus_px": 0.4}])
def test_blur_spreads_light_and_loses_none(parts):
    point = grey(0, (41, 41))
    point[20, 20] = 255
    seen = linear(as_seen(point, look(**parts))[..., 0])
    assert seen.sum() == pytest.approx(1.0, abs=0.05)
    rows, columns = np.nonzero(seen)
    assert np.ptp(columns) > 0
    assert (np.ptp(rows) > 0) == ("focus_px" in parts)
    assert np.array_equal(seen, seen[:, ::-1])
    assert np.array_equal(seen, seen[::-1])
    across = (seen.sum(axis=0) * (np.arange(41) - 20) ** 2).sum()
    wished = parts.get("focus_px", 0.0) ** 2 + parts.get("motion_px", 0.0) ** 2 / 12
    # Pixels are squares: each adds a twelfth.
    assert across == pytest.approx(wished + 1 / 12, rel=0.25)


def test_blur_goes_round_a_panorama():
    stripe = grey(0, (9, 60))
    stripe[:, 0] = 255
    assert as_seen(stripe, look(motion_px=4.0))[:, -1].max() == 0
    assert as_seen(stripe, look(motion_px=4.0), wraps=True)[:, -1].min() > 0


def test_noise_grows_with_its_strength_and_with_light():
    def spread(value, **parts):
        return linear(as_seen(grey(value, (200, 200)), look(**parts))).std()

    for strength in (0.02, 0.04):
        for value in (60, 188):
            wished = strength * np.sqrt(linear(value))
            assert spread(value, shot_noise=strength) == pytest.approx(wished, rel=0.05)
            assert spread(value, read_noise=strength) == pytest.approx(strength, rel=0.12)
    seen = linear(as_seen(grey(120, (300, 300)), look(shot_noise=0.05, read_noise=0.01)))
    assert seen.mean() == pytest.approx(linear(120), rel=0.01)
    # Pixels and channels have noise of their own.
    assert abs(np.corrcoef(seen[..., 0].ravel(), seen[..., 1].ravel())[0, 1]) < 0.02
    assert abs(np.corrcoef(seen[:, 1:, 0].ravel(), seen[:, :-1, 0].ravel())[0, 1]) < 0.02


def test_one_seed_is_one_noise(picture):
    one = look(shot_noise=0.05, read_noise=0.01)
    assert np.array_equal(as_seen(picture, one), as_seen(picture, one))
    other = one.model_copy(update={"noise_seed": 4})
    assert not np.array_equal(as_seen(picture, one), as_seen(picture, other))


def test_a_twin_differs_only_where_the_scene_does(picture):
    """Up to what blurs across: the noise of both is the same."""
    twin = picture.copy()
    twin[30:40, 50:70] //= 2
    robot = drawn_look(PRESETS["robot"], 1.0, lane(7, 3, "look:2"))
    differs = (as_seen(picture, robot) != as_seen(twin, robot)).any(axis=2)
    rows, columns = np.nonzero(differs)
    reach = 8
    assert differs.any()
    assert rows.min() >= 30 - reach
    assert rows.max() < 40 + reach
    assert columns.min() >= 50 - reach
    assert columns.max() < 70 + reach


@settings(max_examples=60, deadline=None)
@given(
    st.builds(
        Look,
        exposure_stops=st.floats(-3, 3),
        white_balance=st.tuples(*[st.floats(0.4, 2.0)] * 3),
        vignetting=st.floats(0, 0.9),
        focus_px=st.floats(0, 12),
        motion_px=st.floats(0, 24),
        shot_noise=st.floats(0, 0.5),
        read_noise=st.floats(0, 0.2),
        noise_seed=st.integers(0, 2**32 - 1),
    ),
    st.tuples(st.integers(1, 60), st.integers(1, 60)),
)
def test_any_look_of_any_size_gives_a_picture(any_look, size):
    rgb = np.random.default_rng(1).integers(0, 256, (*size, 3), dtype=np.uint8)
    before = rgb.copy()
    seen = as_seen(rgb, any_look)
    assert seen.shape == rgb.shape
    assert seen.dtype == np.uint8
    assert np.array_equal(rgb, before)
    black = as_seen(np.zeros_like(rgb), any_look.model_copy(update={"read_noise": 0.0}))
    assert black.max() == 0


def test_bytes_are_those_of_any_machine():
    """Tables are rounded, sums are exact and streams of bits are numpy's promise: written down
    once, checked everywhere."""
    rgb = np.arange(60 * 80 * 3, dtype=np.uint32).reshape(60, 80, 3) * 2654435761 >> 24
    seen = as_seen(
        rgb.astype(np.uint8),
        look(
            exposure_stops=0.31,
            white_balance=(1.07, 0.99, 0.93),
            vignetting=0.21,
            focus_px=0.83,
            motion_px=1.7,
            shot_noise=0.03,
            read_noise=0.008,
        ),
    )
    assert hashlib.sha256(seen.tobytes()).hexdigest() == GOLDEN
