"""Whom a label concerns: the filter between what a detector sees and what it says.

The paper's filter is children alone: without them, what is unsafe for children is not reported.
Ours also heeds what a household has opted out of; it knows no hazard, only the label, so that a
detector with four labels can be asked. Where it knows the hazard, the household's choice counts.
"""

from __future__ import annotations

from sdgen.catalog.records import Catalog, Label
from sdgen.scene import Graph, GraphNode, Household, Notify
from sdgen.vocabulary import ROOM_SUPERCLASS, STRUCTURES

#: Up to this age somebody is a child: the catalogue's group of that name.
CHILD_AGE = 12


class Told:
    """What a household is told of a label, by a catalogue's groups."""

    def __init__(self, catalog: Catalog) -> None:
        self._groups: dict[str, set[str]] = {}
        for hazard in catalog.hazards:
            self._groups.setdefault(hazard.label, set()).add(hazard.group)

    def __call__(self, label: Label, household: Household, hazard: str | None = None) -> Notify:
        """``silent`` for what concerns children where none lives, and for what the household opted
        out of; its choice for the hazard, where one is named; else ``now``."""
        if label == "unsafe for children" and not any(
            member.age <= CHILD_AGE for member in household.members
        ):
            return "silent"
        groups = self._groups.get(label, set())
        if (groups and groups <= set(household.opt_outs)) or hazard in household.opt_outs:
            return "silent"
        if hazard is not None:
            return household.notifications.get(hazard, "now")
        return "now"


def things(graph: Graph) -> tuple[GraphNode, ...]:
    """The nodes that may be reported: no rooms, no floors, walls or ceilings."""
    return tuple(
        node
        for node in graph.nodes
        if node.category != ROOM_SUPERCLASS and node.class_name not in STRUCTURES
    )
