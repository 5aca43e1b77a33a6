"""What it costs a household to be told wrongly, and not to be told: a judgement, and a file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from pydantic import Field

from sdgen.errors import InputError
from sdgen.scene import Notify, Record
from sdgen.strict import no_mapping, read
from sdgen.yaml_source import read_yaml

Cost = Annotated[float, Field(ge=0, le=1e9)]


class Costs(Record):
    """Costs of what is said of one object in one inspection, in units of an interruption for
    nothing.

    The defaults are a judgement, not a measurement: a hazard that a household wants to hear of at
    once is worth ten needless interruptions, a line in the day's summary bothers a fifth as much as
    an interruption. What a household wants is its ``notify``: ``now``, ``summary`` or ``silent``.
    """

    #: An anomaly that is wanted now, in the summary, or not at all, and nobody tells.
    missed_now: Cost = 10.0
    missed_summary: Cost = 3.0
    missed_silent: Cost = 0.0
    #: Wanted now, told in the summary.
    late: Cost = 3.0
    #: Wanted in the summary, told now.
    early: Cost = 0.5
    #: An anomaly that the household does not want to hear of, told now or in the summary.
    unwanted_now: Cost = 1.0
    unwanted_summary: Cost = 0.2
    #: Nothing is wrong with it, and it is told now or in the summary.
    false_alarm_now: Cost = 1.0
    false_alarm_summary: Cost = 0.2

    def of(self, wanted: Notify | None, said: Notify | None) -> float:
        """The cost of one object. ``wanted`` is None where nothing is wrong with it, ``said`` is
        None where nothing is said of it, which is the same to a household as ``silent``."""
        told = None if said == "silent" else said
        if wanted is None:
            return 0.0 if told is None else self._told("false_alarm", told)
        if told is None:
            return float(getattr(self, f"missed_{wanted}"))
        if wanted == "silent":
            return self._told("unwanted", told)
        if wanted == told:
            return 0.0
        return self.late if wanted == "now" else self.early

    def _told(self, what: str, told: Notify) -> float:
        return float(getattr(self, f"{what}_{told}"))


def read_costs(path: Path) -> Costs:
    """Costs from a YAML file; what it leaves out keeps its default. Raises InputError, located."""
    source = read_yaml(path, str(path))
    if isinstance(source.value, dict):
        record = read(source, (), source.value, Costs)
        if record is not None and not source.noted:
            return record
    elif not source.noted:
        source.problem((), no_mapping(source.value))
    raise InputError(source.problems)
