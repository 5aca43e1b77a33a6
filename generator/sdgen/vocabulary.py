"""The closed lists of words and the few measures that rooms of the package share.

Words: kinds of openings and zones, relations, tags. Measures: what several rooms must take to be
the same thing, or a label would say one thing and a home be built by another.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal, get_args

#: What fills holes in walls. Categories of objects and kinds of openings are the same words.
#: Passages have a casing and no leaf.
InnerOpening = Literal["door", "double_door", "passage", "wide_passage"]
OpeningKind = Literal[InnerOpening, "front_door", "window"]
OPENINGS: tuple[OpeningKind, ...] = get_args(OpeningKind)
#: The openings one walks through, between rooms and in all.
INNER_DOORS: tuple[InnerOpening, ...] = get_args(InnerOpening)
DOORS: tuple[OpeningKind, ...] = (*INNER_DOORS, "front_door")
#: How many leaves hang in an opening that has any, side by side.
LEAVES: Mapping[OpeningKind, int] = MappingProxyType({"door": 1, "front_door": 1, "double_door": 2})

#: Regions with a meaning.
ZoneKind = Literal["doorway", "walkway", "swing", "heat", "water", "child_reach"]
ZONE_KINDS: tuple[ZoneKind, ...] = get_args(ZoneKind)

#: When and under what sky a home is seen: of the world outside its windows.
Season = Literal["spring", "summer", "autumn", "winter"]
SEASONS: tuple[Season, ...] = get_args(Season)
Weather = Literal["clear", "cloudy", "overcast"]
WEATHERS: tuple[Weather, ...] = get_args(Weather)
DayTime = Literal["day", "evening", "night"]

#: What a home itself is made of, a piece a room: categories of nodes that are no objects, and the
#: superclasses that VirtualHome gives them and rooms ("Floor" is its commoner spelling).
StructureKind = Literal["floor", "wall", "ceiling"]
#: Where a face of a wall looks: walls run along the axes.
Facing = Literal["+x", "-x", "+y", "-y"]
FACINGS: tuple[Facing, ...] = get_args(Facing)
#: Surfaces are of whole structures, or of bands of a wall: at its foot, behind kitchen units.
SurfaceKind = Literal[StructureKind, "skirting", "splashback"]
STRUCTURES: tuple[StructureKind, ...] = get_args(StructureKind)
STRUCTURE_SUPERCLASS: Mapping[StructureKind, str] = MappingProxyType(
    {"floor": "Floor", "wall": "Walls", "ceiling": "Ceiling"}
)
ROOM_SUPERCLASS = "Rooms"

#: Relations by which one thing holds another: where a recipe may put it, what labels name.
HoldingRelation = Literal["ON", "INSIDE"]
HOLDING: tuple[HoldingRelation, ...] = get_args(HoldingRelation)

#: How soon a hazard wants doing something about.
Urgency = Literal["high", "medium", "low"]

#: Relations between an object and another node; the first five are VirtualHome's.
RELATIONS = (
    "ON",
    "INSIDE",
    "BETWEEN",
    "CLOSE",
    "FACING",
    "UNDER",
    "BLOCKS",
    "NEAR_HEAT",
    "NEAR_WATER",
)
#: Unary facts of an object.
TAGS = ("IN_DOORWAY", "IN_REACH_OF_CHILD", "IN_WALKWAY", "NEAR_EDGE")

#: Half of a wall's thickness, metres: base homes are drawn on the middle lines of walls 0.12 m
#: thick (a plastered half-brick or stud partition), and each room wears its own half.
HALF_WALL_M = 0.06
#: Flatter than this, metres, is walked and stood over: rugs, mats, puddles. ADA 2010, section
#: 303.2 and 303.3, lets a route step up by 13 mm at most; a rug's pile is pressed down.
FLAT_M = 0.03
#: A covering no thicker than this, metres, gives way under feet and furniture: flat-woven rugs and
#: mats have 3 to 5 mm. What is thicker would be cut by a leg, so it lies clear of furniture.
PRESSED_M = 0.005
#: How high a small child grasps things, metres: the reach of a six-year-old, standing, arm up, of
#: ``hazard_catalog/households.yaml``; two hazards take it as their limit.
CHILD_REACH_M = 1.29
#: What hangs higher than this, metres, is walked under or past: wall cabinets and shelves hang at
#: 1.3 m or more in our homes, over furniture or against the wall.
OVERHEAD_M = 1.3

#: Where, of fittings, what people hang on walls is: of any models, in sets.
ON_BARE_WALLS = ("over", "bare_wall")

#: Of its footprint, a thing that is in a zone has at least this in it: more in than out.
ZONE_SHARE = 0.5
#: So near to that it is undecided: of a thing 0.3 m long this is 4.5 cm, which is seen, not
#: measured.
ZONE_SHARE_MARGIN = 0.15
#: Of its footprint, what a thing has in a zone that it is put into: all but a hair, so that nobody
#: takes what is in the way for something put aside. Of 3,354 spots with 0.7 in walkways, 102
#: were on no way of the audit's and beside a wall or furniture; of 3,317 such ones, 50.
ZONE_KEEP_SHARE = 0.99
#: And what has its ends beside it, a cord that lies across a way: surely more in than out.
ZONE_ACROSS_SHARE = 0.7
#: Of its footprint, what may reach into a zone to be avoided: a thing at the edge of a walkway is
#: in nobody's way, and zones taken whole would leave small rooms bare.
ZONE_AVOID_SHARE = 0.2

#: People judge headings to about so many degrees: nearer to a limit, an angle is undecided.
HEADING_MARGIN_DEG = 5.0

#: Pixels are counted at this size (width, height), whatever size is rendered: options of pictures
#: must not decide content.
REFERENCE_SIZE = (640, 480)
#: So many pixels of its evidence at that size, and an anomaly counts as seen: what data sets
#: promise. A judgement: a patch of 10 by 10.
EVIDENCE_PIXELS = 100

#: What moved further than this while the scene came to rest is not where it was put (Habitat 2.0,
#: SceneSmith).
DRIFT_LIMIT_M = 0.1

#: Category of models that no build places: imported ones of a kind, or of a size, that no category
#: has. Scenes that name them by id may hold them.
UNCATEGORISED = "uncategorised"
