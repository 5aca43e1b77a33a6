"""What follows from poses and states: relations, tags and measured terms.

ON, INSIDE, CLOSE and FACING follow VirtualHome's geometry (Puig et al. 2018 and its graph code).
Every threshold is in :mod:`sdgen.facts.thresholds`, with the margin within which nothing is
claimed. Predicates, graph edges and tags all ask :class:`Facts`, so they cannot disagree.
"""

from sdgen.facts.body import Body, bodies_of, with_footprints
from sdgen.facts.entered import entered_structures
from sdgen.facts.front import Edge, Facts
from sdgen.facts.held import in_the_air, unheld
from sdgen.facts.measured import Measured
from sdgen.facts.rooms import Rooms, room_at

__all__ = [
    "Body",
    "Edge",
    "Facts",
    "Measured",
    "Rooms",
    "bodies_of",
    "entered_structures",
    "in_the_air",
    "room_at",
    "unheld",
    "with_footprints",
]
