"""Certificates of from where an agent can see the anomalies of a scene: ``observability.json``."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from pydantic import Field

from sdgen.cameras.lens import Gaze, Lens
from sdgen.geometry import Coordinate, Vec2
from sdgen.scene import Record

Bools = npt.NDArray[np.bool_]


class Observable(Record):
    """From which poses one anomaly can be seen (``seen``), with half as many pixels again as are
    needed (``sure``), and from which its twin looks different (``differs``).

    Of each pitch, in the order of ``pitches_deg``, and of each place, in the order of
    ``positions_m``, a number: bit *k* says whether it is so for the heading k · 360° / ``headings``
    (counter-clockwise from x). ``best``: the pose that shows most of the evidence, as indices of
    place, pitch and heading; None where no pose of the lattice shows enough.
    """

    anomaly_id: str
    object_id: int
    seen: tuple[tuple[int, ...], ...]
    sure: tuple[tuple[int, ...], ...]
    differs: tuple[tuple[int, ...], ...]
    poses_seen: int = Field(ge=0)
    poses_differ: int = Field(ge=0)
    best: tuple[int, int, int] | None


class Observability(Record):
    """``observability.json``: a certificate for each anomaly, for a camera like ``lens``."""

    lens: Lens
    spacing_m: Coordinate
    headings: int = Field(ge=1)
    pitches_deg: tuple[Coordinate, ...]
    positions_m: tuple[Vec2, ...]
    anomalies: tuple[Observable, ...]


def seen_at(found: Observability, rows: Sequence[Sequence[int]]) -> Bools:
    """The numbers of a certificate's poses as (places, pitches, headings)."""
    bits = np.array(rows, dtype=np.int64).reshape(len(found.pitches_deg), -1).T
    return np.asarray((bits[..., None] >> np.arange(found.headings)) & 1 == 1)


def gaze_of(found: Observability, pose: tuple[int, int, int]) -> Gaze:
    """A pose of the lattice by its indices of place, pitch and heading."""
    place, pitch, heading = pose
    yaw = math.remainder(heading * 2 * math.pi / found.headings, 2 * math.pi)
    return Gaze(*found.positions_m[place], yaw, math.radians(found.pitches_deg[pitch]))
