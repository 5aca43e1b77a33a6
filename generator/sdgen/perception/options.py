"""What an agent perceives of a home, and how badly."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, field_validator

from sdgen.scene import Record
from sdgen.vocabulary import EVIDENCE_PIXELS


class Perception(Record):
    """How a home is perceived from its pictures; without arguments, as well as they allow.

    ``pixels``: an object is seen when some view shows so many of it, at 640 x 480 (in proportion
    at other sizes). ``missed``: the share (0 to 1) of objects that are overlooked all the same.
    ``confused``: the share that is taken for another class of their kind, of about their size.
    ``coarse``: classes are their superclasses ("Food"). ``states``: states are told. ``views``:
    only these cameras are looked through, by index, or those that overlook a ``room`` (or turn in
    it); None: all.
    ``seed``: another one overlooks and confuses others. A scene and its twins overlook and confuse
    the same objects.
    """

    pixels: int = Field(default=EVIDENCE_PIXELS, ge=1)
    missed: float = Field(default=0.0, ge=0.0, le=1.0)
    confused: float = Field(default=0.0, ge=0.0, le=1.0)
    coarse: bool = False
    states: bool = True
    views: Literal["room"] | tuple[int, ...] | None = None
    seed: int = Field(default=0, ge=0)

    @field_validator("views")
    @classmethod
    def _from_zero(cls, views: str | tuple[int, ...] | None) -> str | tuple[int, ...] | None:
        if isinstance(views, tuple) and min(views, default=0) < 0:
            raise ValueError("views are counted from 0")
        return views
