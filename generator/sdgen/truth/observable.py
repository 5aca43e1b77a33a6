"""Certificates of from where an agent can see the anomalies of a scene: ``observability.json``."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated

import numpy as np
import numpy.typing as npt
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from sdgen.cameras.lens import Gaze, Lens
from sdgen.geometry import Vec2
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
    spacing_m: float = Field(gt=0.0, le=100.0)
    headings: int = Field(ge=1, le=60)
    pitches_deg: tuple[Annotated[float, Field(ge=-89.0, le=89.0)], ...] = Field(min_length=1)
    positions_m: tuple[Vec2, ...]
    anomalies: tuple[Observable, ...]

    @model_validator(mode="after")
    def _fits(self) -> Observability:
        """Every row has a number of ``headings`` bits for every place, and counts are right."""
        most = 1 << self.headings
        for one in self.anomalies:
            for rows in (one.seen, one.sure, one.differs):
                if [len(row) for row in rows] != [len(self.positions_m)] * len(self.pitches_deg):
                    raise _problem(f"{one.anomaly_id}: not a number for each pitch and place")
                if not all(0 <= bits < most for row in rows for bits in row):
                    raise _problem(f"{one.anomaly_id}: a number with other bits than headings")
            counts = (_bits(one.seen), _bits(one.differs))
            if counts != (one.poses_seen, one.poses_differ):
                raise _problem(f"{one.anomaly_id}: poses_seen or poses_differ are not the bits set")
            shape = (len(self.positions_m), len(self.pitches_deg), self.headings)
            if one.best is not None and not all(
                0 <= k < n for k, n in zip(one.best, shape, strict=True)
            ):
                raise _problem(f"{one.anomaly_id}: best is no pose of the lattice")
        return self


def _bits(rows: Sequence[Sequence[int]]) -> int:
    return sum(bits.bit_count() for row in rows for bits in row)


def _problem(text: str) -> PydanticCustomError:
    return PydanticCustomError("problem", "{text}", {"text": text})


def seen_at(found: Observability, rows: Sequence[Sequence[int]]) -> Bools:
    """The numbers of a certificate's poses as (places, pitches, headings)."""
    bits = np.array(rows, dtype=np.int64).reshape(len(found.pitches_deg), -1).T
    return np.asarray((bits[..., None] >> np.arange(found.headings)) & 1 == 1)


def gaze_of(found: Observability, pose: tuple[int, int, int]) -> Gaze:
    """A pose of the lattice by its indices of place, pitch and heading."""
    place, pitch, heading = pose
    yaw = math.remainder(heading * 2 * math.pi / found.headings, 2 * math.pi)
    return Gaze(*found.positions_m[place], yaw, math.radians(found.pitches_deg[pitch]))
