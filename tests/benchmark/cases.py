"""Scenes and reports by hand, for tests of scores: no data set behind them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sdgen.benchmark.outcome import Outcome, outcome
from sdgen.benchmark.truth import Thing, Truth, Way, Wrong
from sdgen.dataset.records import Report


def wrong(object_id: int, notify: Any = "now", hazard: str = "spill", **more: Any) -> Wrong:
    """An anomaly that a household wants to hear of in this way."""
    fields = {"group": "safety", "label": "unsafe", "shown": "1 to 4 times", "in_twin": False}
    way = Way(hazard, more.pop("category", "cup"), (), None, more.pop("target", None))
    return Wrong(
        id=f"a{object_id:02d}",
        object_id=object_id,
        room="kitchen",
        report=notify != "silent",
        notify=notify,
        way=way,
        **{**fields, **more},
    )


def truth(
    name: str,
    *anomalies: Wrong,
    near: Mapping[int, tuple[str, ...]] | None = None,
    split: str = "test",
    twin: bool = False,
) -> Truth:
    """A scene with these anomalies and lookalikes, among objects 1 to 99; with a benign twin, too,
    if that is asked for."""
    things = {key: Thing("cup", "kitchen") for key in range(1, 100)}
    benign = Truth(f"{name}-twin", split, (), {}, things) if twin else None
    return Truth(name, split, anomalies, near or {}, things, benign)


def said(*object_ids: int, notify: Any = "now", sure: float | None = None) -> tuple[Report, ...]:
    """Reports of these objects."""
    return tuple(
        Report(object_id=key, label="unsafe", notify=notify, score=sure) for key in object_ids
    )


def outcomes(
    truths: Sequence[Truth], predictions: Mapping[str, tuple[Report, ...]]
) -> tuple[Outcome, ...]:
    """What became of them."""
    return tuple(outcome(one, predictions) for one in truths)
