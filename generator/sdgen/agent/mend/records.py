"""What an agent does to a scene, what came of it, and how well a scene was mended."""

from __future__ import annotations

from sdgen.scene import Record

#: An object and the id of a hazard that it is.
Pair = tuple[int, str]


class Action(Record):
    """One action. Its word and what it concerns: ``object_id`` is what is gone to, grabbed, opened,
    switched off …, ``target_id`` what the thing in the hand is put on or into (its own id may be
    left out). ``part`` names one hollow or joint of it: ``freezer`` of a fridge, ``drawer_2``."""

    action: str
    object_id: int | None = None
    target_id: int | None = None
    part: str | None = None


class Outcome(Record):
    """What came of an action. One that was ``refused`` (why, in a sentence) changed nothing.

    ``removed`` and ``caused`` are pairs of object and hazard that held before and no longer do, and
    that hold since. What is in the hand still counts as what it was when it was grabbed.
    """

    action: Action
    done: bool
    refused: str | None = None
    removed: tuple[Pair, ...] = ()
    caused: tuple[Pair, ...] = ()
    in_hand: int | None = None
    walked_m: float = 0.0


class MendScore(Record):
    """How well a scene was mended.

    Of its ``anomalies`` those that no longer hold are ``removed``; ``unadvised`` ones of them by
    nothing that their remedies say (bleach put into the cupboard under the sink).
    Pairs that hold and did not before are ``caused``. ``…_reported`` counts those of which this
    household would be told. ``actions`` counts all, the ``refused`` ones too; ``remedy_actions`` is
    how many the catalogue's remedies take.
    """

    anomalies: int
    removed: int
    unadvised: int
    unadvised_reported: int
    left_reported: int
    caused: int
    caused_reported: int
    actions: int
    refused: int
    remedy_actions: int
    walked_m: float
