"""How far the colour pictures of a build depart from a perfect camera's: strengths, and words for
them. What one view gets is drawn from them; masks and depth are always perfect."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping

from pydantic import Field

from sdgen.errors import did_you_mean
from sdgen.scene import Look, Record
from sdgen.seeding import Rng

#: ``blur`` counts pixels of a picture so wide.
BLUR_AT_WIDTH = 640
#: Cameras miss white along the colours of lamps and daylight (red against blue) more than across
#: them (green against magenta): by so much.
_TINT = 0.3
#: Light of a white pixel by channel (ITU-R BT.709): a wrong white is no wrong exposure.
_LUMINANCE = (0.2126, 0.7152, 0.0722)
#: Read noise of small sensors, as a share of the shot noise of white: of 4,000 electrons some 15.
_READ = 0.25
#: Lenses always darken their corners and sensors always have noise, this much of the strength at
#: least; whether anything moved, or was out of focus, or lit for, is up to chance.
_ALWAYS = 0.5
#: Decimals of what is drawn: what is written is what was done.
_DECIMALS = 5


class CameraLook(Record):
    """Strengths of what a camera does to colours, 0 for nothing; each view draws its own values.

    ``exposure``: stops over or under, at most. ``white_balance``: how far red and blue are off, at
    most, as a share. ``vignetting``: share of the light that corners lose. ``blur``: of focus and
    motion, pixels at a width of 640. ``noise``: standard deviation of white, as a share of it.
    """

    exposure: float = Field(default=0.0, ge=0.0, le=3.0)
    white_balance: float = Field(default=0.0, ge=0.0, le=0.5)
    vignetting: float = Field(default=0.0, ge=0.0, le=0.9)
    blur: float = Field(default=0.0, ge=0.0, le=8.0)
    noise: float = Field(default=0.0, ge=0.0, le=0.5)

    def __bool__(self) -> bool:
        """True when anything is done to colours."""
        return any(getattr(self, name) for name in STRENGTHS)

    def __str__(self) -> str:
        """The words that ``--look`` takes for it."""
        for name, look in PRESETS.items():
            if self == look:
                return name
        words = [f"{name}={getattr(self, name):g}" for name in STRENGTHS if getattr(self, name)]
        return ",".join(words)


#: Names of the strengths, in the order in which light meets them.
STRENGTHS = tuple(CameraLook.model_fields)
#: Looks by name. A phone's is mild: a good sensor, a steady hand. A robot's head camera has a small
#: sensor, a cheap lens and dim rooms, and turns while it looks. Both are judgements.
PRESETS: Mapping[str, CameraLook] = {
    "none": CameraLook(),
    "phone": CameraLook(exposure=0.3, white_balance=0.06, vignetting=0.15, blur=0.6, noise=0.012),
    "robot": CameraLook(exposure=0.6, white_balance=0.12, vignetting=0.35, blur=1.0, noise=0.035),
}


def look_of(text: str) -> CameraLook:
    """``robot``, ``noise=0.02,blur=1`` or ``phone,noise=0``: a look by name, strengths, or both.

    ValueError says what is wrong with the text.
    """
    values: dict[str, float] = {}
    for k, word in enumerate(word.strip() for word in text.split(",")):
        name, equals, number = (part.strip() for part in word.partition("="))
        if not equals:
            if k > 0 or name not in PRESETS:
                hint = did_you_mean(name, [*PRESETS, *STRENGTHS])
                raise ValueError(
                    f"has {name!r} where a look ({', '.join(PRESETS)}), which comes first, or "
                    f"NAME=STRENGTH is meant{hint}"
                )
            values.update(PRESETS[name].model_dump())
            continue
        if name not in STRENGTHS:
            raise ValueError(f"names no strength: {name!r}{did_you_mean(name, STRENGTHS)}")
        values[name] = _strength(name, number)
    return CameraLook(**values)


def _strength(name: str, text: str) -> float:
    field = CameraLook.model_fields[name]
    most = next(one.le for one in field.metadata if hasattr(one, "le"))
    plain = re.fullmatch(r"\d{1,3}(?:\.\d{0,9})?|\.\d{1,9}", text, flags=re.ASCII)
    if plain is None or float(text) > most:
        raise ValueError(f"has no number from 0 to {most:g} for {name}")
    return float(text)


def drawn_look(look: CameraLook, blur_scale: float, rng: Rng) -> Look:
    """What one view's camera does, within these strengths: the same draws whatever they are.

    ``blur_scale``: pixels of the picture for one of a picture of width 640.
    """
    stops, warm, tint, corners, focus, moved, grain = rng.uniform(-1.0, 1.0, 7).tolist()
    gains = [math.exp(look.white_balance * off) for off in (warm, _TINT * tint, -warm)]
    white = sum(gain * share for gain, share in zip(gains, _LUMINANCE, strict=True))
    noise = look.noise * _at_least(grain)
    blur = look.blur * blur_scale
    return Look(
        exposure_stops=_rounded(look.exposure * stops),
        white_balance=(
            _rounded(gains[0] / white),
            _rounded(gains[1] / white),
            _rounded(gains[2] / white),
        ),
        vignetting=_rounded(look.vignetting * _at_least(corners)),
        focus_px=_rounded(blur * (1 + focus) / 2),
        motion_px=_rounded(blur * (1 + moved)),
        shot_noise=_rounded(noise),
        read_noise=_rounded(_READ * noise),
        noise_seed=int(rng.integers(2**32)),
    )


def _at_least(drawn: float) -> float:
    """From -1 to 1, as a share that is never small."""
    return _ALWAYS + (1 - _ALWAYS) * (1 + drawn) / 2


def _rounded(value: float) -> float:
    return round(value, _DECIMALS) + 0.0
