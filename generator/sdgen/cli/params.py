"""Option values, read strictly: one that makes no sense is a usage error with an example."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Literal, TypeVar

import click

from sdgen.errors import did_you_mean
from sdgen.options import Sensor

#: As BuildOptions has them.
SIZE_MIN, SIZE_MAX = 16, 4096
SENSORS: tuple[Sensor, ...] = ("rgb", "depth", "instance")

T = TypeVar("T")


def parsed(parse: Callable[[str], T]) -> Callable[[click.Context, click.Parameter, str], T | None]:
    """A click callback that reads an option's text with ``parse``; None stays None."""

    def callback(ctx: click.Context, param: click.Parameter, value: str | None) -> T | None:
        if value is None:
            return None
        try:
            return parse(value.strip())
        except ValueError as error:
            raise click.BadParameter(f"{value!r} {error}", ctx, param) from None

    return callback


def size(text: str) -> tuple[int, int]:
    """``640x480`` -> (width, height) in pixels. ValueError says what is wrong."""
    match = re.fullmatch(r"(\d{1,6})x(\d{1,6})", text, flags=re.ASCII)
    if match is None:
        raise ValueError("is not WIDTHxHEIGHT, for example 640x480")
    width, height = int(match[1]), int(match[2])
    if not (SIZE_MIN <= width <= SIZE_MAX and SIZE_MIN <= height <= SIZE_MAX):
        raise ValueError(f"is out of range: each side has {SIZE_MIN} to {SIZE_MAX} pixels")
    return width, height


def hazard_count(text: str) -> tuple[int, int]:
    """``0-5`` -> (0, 5): how many anomalies a scene gets; ``3`` means exactly three."""
    match = re.fullmatch(r"(\d{1,6})(?:-(\d{1,6}))?", text, flags=re.ASCII)
    if match is None:
        raise ValueError("is not MIN-MAX, for example 0-5")
    least, most = int(match[1]), int(match[2] or match[1])
    if least > most:
        raise ValueError("has the larger number first")
    return least, most


def homes_meant(text: str) -> Literal["base", "procedural", "mixed"] | Path:
    """A word for the homes of a build, or the file of one home. ValueError for anything else."""
    words: dict[str, Literal["base", "procedural", "mixed"]] = {
        "base": "base",
        "procedural": "procedural",
        "mixed": "mixed",
    }
    if text in words:
        return words[text]
    path = Path(text)
    if path.suffix not in (".yaml", ".yml"):
        near = did_you_mean(text, [*words])
        raise ValueError(f"is neither base, procedural or mixed nor a FILE.yaml{near}")
    if not path.is_file():
        raise ValueError("is no file")
    return path


def scene_range(text: str) -> tuple[int, int]:
    """``0:500`` -> (0, 500): scene indices, the last one not included."""
    match = re.fullmatch(r"(\d{1,12}):(\d{1,12})", text, flags=re.ASCII)
    if match is None:
        raise ValueError("is not FIRST:END, for example 0:500")
    first, end = int(match[1]), int(match[2])
    if first >= end:
        raise ValueError("holds no scene: the end must be the larger number")
    return first, end


def sensor_list(text: str) -> tuple[Sensor, ...]:
    """``depth,rgb`` -> ("rgb", "depth"), in a fixed order; ``none`` -> ()."""
    words = [word.strip() for word in text.split(",")]
    if words == ["none"]:
        return ()
    for word in words:
        if word == "none":
            raise ValueError("says none and others: none stands alone")
        if word not in SENSORS:
            raise ValueError(f"names no sensor {word!r}{did_you_mean(word, [*SENSORS, 'none'])}")
    return tuple(sensor for sensor in SENSORS if sensor in words)


def metres(text: str) -> float:
    """A length in metres. ValueError for what is no finite number."""
    try:
        value = float(text)
    except ValueError:
        raise ValueError("is no number of metres") from None
    if not math.isfinite(value):
        raise ValueError("is no length")
    return value


def destination(text: str) -> Path:
    """A folder to write to. ValueError for an empty name, which would be the current folder."""
    if not text:
        raise ValueError("names no folder")
    return Path(text)


def split_names(values: tuple[str, ...]) -> tuple[str, ...]:
    """``("a,b", "c")`` -> ``("a", "b", "c")``, without repeats and blanks, order kept."""
    names = [name.strip() for value in values for name in value.split(",")]
    return tuple(dict.fromkeys(name for name in names if name))
