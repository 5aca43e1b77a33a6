"""The words of an agent: what it can do, and how it speaks of what is wrong."""

from __future__ import annotations

from typing import Literal, get_args

from sdgen.catalog.records import Label
from sdgen.scene import Notify

#: What an agent can do, in the order of their numbers in action spaces.
Move = Literal[
    "stop",
    "forward",
    "turn_left",
    "turn_right",
    "look_up",
    "look_down",
    "go_to",
    "open",
    "close",
    "scan",
    "report",
]
MOVES: tuple[Move, ...] = get_args(Move)
#: Those that are about a room or an object.
AIMED: tuple[Move, ...] = ("go_to", "open", "close", "report")
LABELS: tuple[Label, ...] = get_args(Label)
NOTIFY: tuple[Notify, ...] = get_args(Notify)
