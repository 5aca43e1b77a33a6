"""What the paper reports (Mullen et al. 2024, SafetyDetect): AS and CAS of its tables, percent.

Their homes, hazards and words are others than ours: the numbers stand beside ours to be read, not
to be subtracted.
"""

from __future__ import annotations

from typing import NamedTuple


class Reported(NamedTuple):
    """A row of the paper: how it calls it, AS and CAS in percent (None: not given)."""

    title: str
    as_: float | None
    cas: float | None


#: Our name of a method -> its row, in the paper's order. All are with GPT-4.
METHODS: dict[str, Reported] = {
    "object-list": Reported("Object List + E, C", 12.4, 5.1),
    "scene-description": Reported("Scene Description + E, C", 21.5, 13.6),
    "sg": Reported("SG, no C", 18.8, None),
    "e-sg": Reported("E + SG, no C", 38.8, None),
    "sg-c": Reported("SG & C", 83.2, 80.8),
    "e-sg-c": Reported("E + SG & C", 94.0, 88.8),
    "cot-sg-c": Reported("CoT + SG & C", 96.0, 90.5),
}

#: The model -> its row, with the chain-of-thought prompt.
MODELS: dict[str, Reported] = {
    "flan-t5-large": Reported("FLAN-T5-Large", 81.3, 51.2),
    "gpt-3.5-turbo": Reported("GPT-3.5-Turbo", 94.0, 88.8),
    "gpt-4": Reported("GPT-4", 96.0, 90.5),
}

#: On a robot in one real room, detection rate in percent of 20 experiments.
REAL_ROBOT = 82.7
