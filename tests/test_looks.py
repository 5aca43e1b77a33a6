"""Words for looks are read strictly, and what is drawn stays within their strengths."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.looks import PRESETS, STRENGTHS, CameraLook, drawn_look, look_of
from sdgen.seeding import lane

MOST = {"exposure": 3.0, "white_balance": 0.5, "vignetting": 0.9, "blur": 8.0, "noise": 0.5}
LOOKS = st.builds(
    CameraLook,
    **{
        name: st.floats(0, most).map(lambda value: float(f"{value:.4f}"))
        for name, most in MOST.items()
    },
)


def test_every_preset_has_its_name() -> None:
    assert not PRESETS["none"]
    for name, look in PRESETS.items():
        assert look_of(name) == look
        assert str(look) == name
    assert set(MOST) == set(STRENGTHS)


def test_strengths_stand_alone_or_change_a_preset() -> None:
    assert look_of("noise=0.02, blur=1") == CameraLook(noise=0.02, blur=1.0)
    assert look_of("robot,noise=0").noise == 0.0
    assert look_of("robot,noise=0").blur == PRESETS["robot"].blur
    assert look_of("noise=0") == PRESETS["none"]


@given(LOOKS)
def test_its_words_mean_it(look: CameraLook) -> None:
    assert look_of(str(look)) == look


@pytest.mark.parametrize(
    "text",
    [
        *("", "fone", "noise=0.1,phone", "noise", "noise=", "noise=nan", "noise=0.6"),
        *("noise=1e-3", "grain=1", "noise=-0.1", "phone,none", "blur=9", "exposure=0,1"),
    ],
)
def test_other_words_are_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"has|names"):
        look_of(text)


@given(LOOKS, st.integers(0, 2**63), st.floats(0.03, 6.4))
def test_what_is_drawn_is_within_the_strengths(look: CameraLook, seed: int, scale: float) -> None:
    drawn = drawn_look(look, scale, lane(seed, 0, "look"))
    assert abs(drawn.exposure_stops) <= look.exposure + 1e-5
    assert look.vignetting / 2 - 1e-5 <= drawn.vignetting <= look.vignetting + 1e-5
    assert 0 <= drawn.focus_px <= look.blur * scale + 1e-5
    assert 0 <= drawn.motion_px <= 2 * look.blur * scale + 1e-5
    assert look.noise / 2 - 1e-5 <= drawn.shot_noise <= look.noise + 1e-5
    assert drawn.read_noise <= drawn.shot_noise
    red, green, blue = drawn.white_balance
    # White is as bright as it was.
    assert 0.2126 * red + 0.7152 * green + 0.0722 * blue == pytest.approx(1.0, abs=1e-4)
    if not look.white_balance:
        assert drawn.white_balance == (1.0, 1.0, 1.0)


def test_more_of_one_draws_the_same_of_another() -> None:
    one = drawn_look(look_of("noise=0.02,blur=1"), 1.0, lane(1, 2, "look"))
    other = drawn_look(look_of("noise=0.04,blur=1,exposure=1"), 1.0, lane(1, 2, "look"))
    assert (one.focus_px, one.motion_px, one.noise_seed) == (
        other.focus_px,
        other.motion_px,
        other.noise_seed,
    )
    assert other.shot_noise == pytest.approx(2 * one.shot_noise, abs=1e-4)
