"""What the hazard catalogue says, resolved and checked (``catalogue.json``)."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from functools import cached_property
from typing import Annotated, Any, Literal

from pydantic import Field, field_validator, model_validator

from sdgen.catalog.activity import Activity
from sdgen.catalog.row import Row
from sdgen.catalog.terms import Predicate
from sdgen.catalog.words import (
    PAIR,
    CategoryName,
    HazardName,
    OptionalCategories,
    Point2,
    Point3,
    Quaternion,
    Rectangle,
    RoomName,
    RoomNames,
    State,
    Text,
    Word,
    between,
    names_of,
    span,
)
from sdgen.geometry import Coordinate, Vec3
from sdgen.scene import Notify, Record
from sdgen.strict import Expect, problem, refuse
from sdgen.vocabulary import (
    EVIDENCE_PIXELS,
    ZONE_ACROSS_SHARE,
    ZONE_KEEP_SHARE,
    HoldingRelation,
    OpeningKind,
    Urgency,
)

Group = Literal["safety", "sanitation", "child_safety"]
Label = Literal["unsafe", "unsanitary", "unsafe for children"]
WindowKind = Literal["large", "small", "none"]
#: Weights are divided by: nothing may have none.
AboveZero = Annotated[float, Field(gt=0)]
CategoryKind = Literal["small", "furniture", "opening", "structure", "hazard_only"]


# --- how to make an anomaly or a lookalike ------------------------------------------------------


class Near(Record):
    """No farther than ``max_m`` from something of the categories ``to`` (in ``to_state``, if any)
    in the same room: box to box, or ``from_above`` on the floor plan, whatever the heights.
    ``bring``: what is in another state is brought into it, and where there is none, one is put
    there, too; with a ``count`` above 1 so many are put there."""

    to: Annotated[tuple[str, ...], names_of("category"), Expect("a category or a list of them")]
    to_state: State | None = None
    max_m: Annotated[float, between(0.0, 5.0)]
    from_above: bool = False
    bring: bool = False
    count: Annotated[int, between(1, 8)] = 1

    @property
    def axes(self) -> slice:
        """Of x, y and z, those along which it is measured."""
        return slice(0, 2 if self.from_above else 3)

    @model_validator(mode="after")
    def _brought(self) -> Near:
        if self.count > 1 and not self.bring:
            refuse(problem(("count",), "counts what is brought along: it needs 'bring: true'"))
        return self


class Before(Record):
    """On the floor before the front of something of the categories ``of``, or before or behind a
    door or a window, with its middle no farther than ``max_m`` from it."""

    of: Annotated[tuple[str, ...], names_of("category"), Expect("a category or a list of them")]
    max_m: Annotated[float, between(0.05, 3.0)] = 0.6


class PlaceRecipe(Record):
    """Put a new object of one of ``categories`` (in ``state``, if any) ``relation`` a target.

    ``targets`` are receptacle categories or ``floor``; ``zone`` asks for a spot in such a zone
    (on the floor or on what lies flat on it), wholly or, ``across``, with its ends out of it,
    ``avoid_zones`` for one clear of them; ``rooms`` restricts rooms. Models that come in one of the
    states of ``not_state`` (a cut apple) are left out. ``near`` and ``before`` name other things
    it is to be by; ``over_edge`` [least, most] says how far it reaches over the edge of its target,
    metres, with less than 0 within it.
    """

    kind: Literal["place"] = "place"
    categories: tuple[str, ...]
    state: str | None = None
    not_state: tuple[str, ...] = ()
    relation: HoldingRelation
    targets: tuple[str, ...]
    zone: tuple[str, ...] = ()
    across: bool = False
    avoid_zones: tuple[str, ...] = ()
    rooms: tuple[str, ...] = ()
    min_height_m: float | None = None
    max_height_m: float | None = None
    near: Near | None = None
    before: Before | None = None
    over_edge: tuple[float, float] | None = None
    weight: AboveZero = 1.0

    @property
    def zone_share(self) -> float:
        """How much of its footprint a thing has in the zone that is asked for, at least."""
        return ZONE_ACROSS_SHARE if self.across else ZONE_KEEP_SHARE


class SetRecipe(Record):
    """Bring an object that the home already has into ``state`` (a joint or a mesh variant); one
    that is ``near`` something, if it says so."""

    kind: Literal["set"] = "set"
    categories: tuple[str, ...]
    state: str
    rooms: tuple[str, ...] = ()
    near: Near | None = None
    weight: AboveZero = 1.0


Recipe = Annotated[PlaceRecipe | SetRecipe, Field(discriminator="kind")]


class Raise(Record):
    """A pet or a condition of a household that makes a hazard matter to it; ``source`` says who
    says so."""

    living_with: Annotated[tuple[str, ...], names_of("pet or condition")]
    source: Text


class Concern(Record):
    """Whom a hazard concerns: everyone, households with a member up to ``max_age`` (children) or
    from ``min_age`` on (older people), or those that are ``living_with`` one of some pets and
    conditions.

    ``by_reach`` further asks that such a child can reach ``evidence.reach_height_m``; with
    ``rooms`` it concerns them in rooms of these types alone. Where a household has what is in
    ``raised_by``, it is told at once, whomever else that concerns.
    """

    who: Literal["everyone", "children", "older_people", "living_with"]
    max_age: Annotated[int | None, between(0, 17)] = None
    min_age: Annotated[int | None, between(18, 120)] = None
    living_with: Annotated[tuple[str, ...], names_of("pet or condition", least=0)] = ()
    by_reach: bool = False
    rooms: RoomNames = ()
    raised_by: tuple[Raise, ...] = ()

    @model_validator(mode="after")
    def _of_whom(self) -> Concern:
        needed = {"children": "max_age", "older_people": "min_age", "living_with": "living_with"}
        for who, key in needed.items():
            given = getattr(self, key) not in (None, ())
            if self.who == who and not given:
                years = " (years)" if key.endswith("age") else ""
                refuse(problem((), f"who: {who} needs {key}{years}"))
            if self.who != who and given:
                refuse(problem((key,), f"{key} belongs to who: {who}"))
        if self.who != "children" and self.by_reach:
            refuse(problem(("by_reach",), "by_reach belongs to who: children"))
        return self


class Guidance(Record):
    """Public guidance that one can look up: who gives it, in what, and what it says."""

    body: Text
    title: Text
    says: Text

    def __str__(self) -> str:
        return f"{self.body}, {self.title}: {self.says}"


#: The classes of harm of the UK's Housing Health and Safety Rating System (2006), worst first.
Harm = Literal["extreme", "severe", "serious", "moderate"]


class Severity(Record):
    """The worst harm that is likely, and who says so."""

    harm: Harm
    source: Annotated[Guidance, Expect("{body: ..., title: ..., says: ...}")]


class RemedyRule(Record):
    """One step that undoes the anomaly: an action word, and where to, if anywhere."""

    action: str
    targets: tuple[str, ...] = ()


class Hazard(Record):
    """One class of the catalogue. ``never_silent``: no household may choose not to hear of it.

    A view shows it with ``evidence_pixels`` (at the reference size) of the parts that show its
    state, or that are named so, and with ``EVIDENCE_PIXELS`` of the whole object; where
    ``evidence_outdoors`` is above 0, with so many of what lies outdoors, seen through the opening
    that the object fills, too.
    """

    id: str
    title: str
    paper_class: str = ""
    group: Group
    label: Label
    concerns: Concern
    urgency: Urgency
    never_silent: bool = False
    message: str
    source: str
    guidance: tuple[Guidance, ...] = ()
    severity: Severity | None = None
    predicate: Predicate
    relation: str | None = None
    evidence_state: str | None = None
    evidence_parts: tuple[str, ...] = ()
    evidence_pixels: int = EVIDENCE_PIXELS
    evidence_outdoors: int = 0
    anomalies: tuple[Recipe, ...]
    lookalikes: tuple[Recipe, ...] = ()
    remedy: tuple[RemedyRule, ...]
    pack: str = "core"


class Abode(Record):
    """Where a category normally lives: a prior for clutter. ``hollow``: in which hollows of the
    targets, by their models' name for them (``drawer`` is ``drawer_2``, too). ``state``: only of
    models that come in that state; these live where such abodes say, and nowhere else."""

    relation: HoldingRelation
    targets: tuple[str, ...]
    rooms: tuple[str, ...] = ()
    hollow: str | None = None
    state: str | None = None
    weight: AboveZero = 1.0


class AtMost(Record):
    """So many of a category a home is given in a room, and in all; None: any number."""

    room: Annotated[int | None, between(1, 100)] = None
    home: Annotated[int | None, between(1, 100)] = None

    def reached(self, in_room: int, in_home: int) -> bool:
        """True when there may be no more."""
        return (self.room is not None and in_room >= self.room) or (
            self.home is not None and in_home >= self.home
        )


class Holds(Record):
    """How often a small thing holds others where it lies as clutter, and how many."""

    chance: Annotated[float, between(0.0, 1.0)]
    count: Annotated[tuple[int, int], span(1, 20, whole=True), PAIR]


class Category(Record):
    """An object category. ``switched_on``: the share of its furniture that stands switched on;
    ``stands_open``: the share that somebody left open, where it has room to.

    ``climb_m``: children climb on it and stand about so high above its bottom (a model's own
    surface near that height says how high); None: they do not.

    ``tiled_m``: rooms with such furniture are tiled all round, where there are tiles, and the walls
    that it stands at up to so high at least.

    ``alike``: it comes in several, so that one piece of furniture may hold two of one model.
    ``reserved``: hollows that only take what lives in a hollow of that name. ``belongs_to``: the
    pets, conditions and age groups with which it comes, ``always`` or as often as anything;
    ``sleeps``: how many a bed is for. ``holds``: what lives on or in such a small thing is there
    so often. ``rows``: what stands in rows on its shelves; the first that a shelf draws fills it.
    """

    name: str
    superclass: str
    extents_min_m: Vec3
    extents_max_m: Vec3
    mass_min_kg: float
    mass_max_kg: float
    properties: tuple[str, ...] = ()
    lives: tuple[Abode, ...] = ()
    kind: CategoryKind = "small"
    switched_on: float = 0.0
    stands_open: float = 0.0
    climb_m: float | None = None
    tiled_m: float | None = None
    at_most: AtMost = AtMost()
    alike: bool = False
    reserved: tuple[str, ...] = ()
    belongs_to: tuple[str, ...] = ()
    always: bool = False
    sleeps: int = 0
    holds: Holds | None = None
    rows: tuple[Row, ...] = ()


#: Where what belongs to the building is, and what people hang on walls.
FittedAt = Literal[
    "window",
    "under_window",
    "beside_door",
    "before_door",
    "beside",
    "at_hand",
    "wall",
    "ceiling",
    "over",
    "bare_wall",
]


class Fitting(Record):
    """What belongs to the building, on its walls, ceilings and floors, in rooms of these types
    (none: in all).

    At each ``window`` that has nothing yet, its upper end above it, ``under_window``,
    ``beside_door`` (inner ones and the front door), ``beside`` each piece ``of`` these categories,
    ``at_hand`` of who sits on it (the wall at its side, or else beside it) or, ``count`` a room,
    anywhere along a ``wall``, ``z_m`` high but for windows; in the middle of the ``ceiling``; or on
    the floor, ``before_door``, inside each door ``of`` these kinds.

    Sets of ``count`` of one size, of any models, their middle ``z_m`` high: ``over`` the middle of
    each piece ``of`` these categories, higher where it is high; on each stretch of ``bare_wall``
    longer than ``least_m``.
    """

    name: str
    category: str
    where: FittedAt
    of: tuple[str, ...] = ()
    rooms: tuple[str, ...] = ()
    chance: float = 1.0
    count: tuple[int, int] = (1, 1)
    z_m: float = 0.0
    least_m: float = 2.0


class ClutterPrior(Record):
    """How many small things a receptacle category holds in a room type."""

    receptacle: str
    count_min: int
    count_max: int


class FurnitureRule(Record):
    """How rooms of a type in generated homes get a piece of furniture (or several).

    ``where`` says how it is placed: against a ``wall`` (at ``z_m``, if it hangs), in a ``corner``,
    in the ``middle``; ``row``: the pieces of ``row`` side by side against one wall; ``run``: so
    along one wall, two that face or, with a ``corner`` unit, round one corner or two, with as many
    of ``extra`` at its last unit as chance and the walls allow; ``island``: so in the middle of
    the room, ``gap_m`` from all else, with seats of ``extra`` at the back; and, relative to a piece
    of ``of`` placed before: ``on`` it, ``beside`` it, ``before`` its front (``gap_m`` away, facing
    it), ``under`` it, ``around`` it (facing it), ``above`` it on the wall, ``over`` it in a row of
    wall units, or ``opposite``, against the wall it faces, with nothing in between. ``count`` is
    per room, or per piece of ``of`` for ``on``, ``beside``, ``around`` and ``above``; with fewer
    than ``least`` of them (half as many ``around`` a short table) it has found no place. Smaller
    rooms than ``from_m2`` are not asked for it. ``front_m`` of floor before it is kept free, and
    against a ``wall`` ``gap_m`` beside it; what is ``around`` a table stands ``gap_m`` from it, or
    pushed under, and what is ``under`` a piece lies so much before its middle, or where near there
    nothing stands half on it. What lies flat in the ``middle`` lies clear of all that stands.
    ``largest``: large models mostly come first.

    A rule begins a group, with those after it that are about a piece of the group; a group that
    misses something is placed anew a few times. Without a ``needed`` piece of it, it does not stand
    at all; without one that begins a group the room is arranged anew. Of the places there are,
    those ``near`` pieces of some categories, ``facing`` them, ``aligned`` with them (at the same
    wall) or ``centred`` (in the middle of a free stretch of wall) come first.
    """

    category: CategoryName = ""
    row: Annotated[tuple[CategoryName, ...], Expect("a list of categories")] = ()
    where: Literal[
        "wall",
        "corner",
        "middle",
        "row",
        "run",
        "island",
        "on",
        "beside",
        "before",
        "under",
        "around",
        "above",
        "over",
        "opposite",
    ]
    of: OptionalCategories = ()
    # Limits that no real room exceeds; a negative gap puts a chair under its desk.
    count: Annotated[tuple[int, int], span(0, 20, whole=True), PAIR] = (1, 1)
    least: Annotated[int, between(1, 20)] = 1
    chance: Annotated[float, between(0.0, 1.0)] = 1.0
    from_m2: Annotated[float, between(0.0, 500.0)] = 0.0
    needed: bool = False
    front_m: Annotated[float, between(0.0, 5.0)] = 0.5
    gap_m: Annotated[float, between(-2.0, 5.0)] = 0.0
    z_m: Annotated[float, between(0.0, 5.0)] = 0.0
    corner: CategoryName = ""
    extra: Annotated[tuple[CategoryName, ...], Expect("a list of categories")] = ()
    near: OptionalCategories = ()
    facing: OptionalCategories = ()
    aligned: OptionalCategories = ()
    centred: bool = False
    largest: bool = False

    @model_validator(mode="after")
    def _of_its_kind(self) -> FurnitureRule:
        rows = ("row", "run", "island")
        wanted = {"row" if self.where in rows else "category"}
        if self.where not in ("wall", "corner", "middle", *rows):
            wanted.add("of")
        given = {key for key in ("category", "row", "of") if getattr(self, key)}
        found = [
            problem((), f"missing key {key!r}: 'where: {self.where}' needs it")
            for key in sorted(wanted - given)
        ]
        besides = {"run": set[str](), "island": {"corner"}}.get(self.where, {"corner", "extra"})
        wishes = {key for key in ("near", "facing", "aligned", "centred") if getattr(self, key)}
        misplaced = given - wanted
        misplaced |= {key for key in besides if getattr(self, key)}
        misplaced |= wishes if self.where in rows else set()
        found += [
            problem((key,), f"does not go with 'where: {self.where}'") for key in sorted(misplaced)
        ]
        if found:
            refuse(*found)
        return self


class RoomType(Record):
    """A room type: size, windows and furniture in generated homes, clutter counts by receptacle.

    ``area_m2`` is the range of its area, ``narrowest_m`` the least width of its main part. A room
    that needs ``daylight`` gets an outer wall that a window fits in; ``windows`` says which kind
    it has where there is such a wall, ``sill_m`` how high. A room with ``corridor_m`` is a corridor
    that wide, as long as the rooms along it ask; one with ``free_wall_m`` has a straight wall so
    long that no door is in. ``beside`` are room types that it wishes to share
    a wall with. ``joined`` are room types that it has a door to besides that it opens from, and how
    often (where they share a wall); ``opens_to`` says by which kinds of opening instead of a door
    it is joined to rooms of a type, and how often by each. Homes with a room
    that ``belongs_to`` pets, conditions or age groups are those of households with one of them.
    """

    name: str
    area_m2: tuple[float, float] = (8.0, 16.0)
    narrowest_m: float = 2.0
    daylight: bool = True
    windows: WindowKind = "large"
    sill_m: float = 0.9
    corridor_m: tuple[float, float] | None = None
    free_wall_m: float = 0.0
    # Pairs, for their order decides which is drawn first.
    joined: tuple[tuple[str, float], ...] = ()
    opens_to: tuple[tuple[str, tuple[tuple[OpeningKind, float], ...]], ...] = ()
    beside: tuple[str, ...] = ()
    furniture: tuple[FurnitureRule, ...] = ()
    clutter: tuple[ClutterPrior, ...] = ()
    floor_clutter_min: int = 0
    floor_clutter_max: int = 2
    belongs_to: tuple[str, ...] = ()


class MemberRule(Record):
    """One member of a kind of household: its age, an inclusive range, and by how many years the
    member listed before it is older (less than 0: younger), as far as its age allows."""

    role: Text
    age: Annotated[tuple[int, int], span(0, 120, whole=True), PAIR]
    years_after: Annotated[tuple[int, int], span(-60, 60, whole=True), PAIR] | None = None

    def ages(self, before: int | None) -> tuple[int, int]:
        """The youngest and the oldest it may be beside a member of age ``before``."""
        least, most = self.age
        if self.years_after is None or before is None:
            return least, most
        low, high = before - self.years_after[1], before - self.years_after[0]
        low, high = min(max(low, least), most), max(min(high, most), least)
        return min(low, high), high


class Trait(Record):
    """A pet or a condition that households of a kind may have, and what share of them does."""

    name: str
    share: Annotated[float, between(0.0, 1.0)] = 0.5
    source: Text = ""


class HouseholdTemplate(Record):
    """A kind of household to sample from.

    It lives in homes with the room types of ``rooms`` (one that comes twice: with two of them) and
    beds for ``beds``; None: for all members.
    ``pets`` and ``conditions`` are what it may have, each in its share of the households.
    Its homes are as tidy as a draw from ``tidiness`` (0: messy, 1: tidy).
    ``notifications`` gives, by hazard, choices that are equally likely; a hazard that is not
    named gets the default of its urgency. ``opt_outs`` name groups of hazards (or single ones) of
    which a share of the households wants to hear nothing.
    """

    name: str
    weight: AboveZero
    members: tuple[MemberRule, ...]
    pets: tuple[Trait, ...] = ()
    conditions: tuple[Trait, ...] = ()
    rooms: tuple[str, ...] = ()
    beds: int | None = None
    tidiness: tuple[float, float] = (0.2, 0.9)
    notifications: dict[str, tuple[Notify, ...]] = Field(default_factory=dict)
    opt_outs: tuple[Trait, ...] = ()

    @field_validator("pets", "conditions", mode="before")
    @classmethod
    def _of_older_versions(cls, value: Any) -> Any:
        """A word alone: half of the households have it."""
        if not isinstance(value, list):
            return value
        # Records, since what has been through here counts as Python's, which must be exact.
        return tuple(
            Trait(name=item) if isinstance(item, str) else Trait.model_validate(item)
            for item in value
        )

    @property
    def traits(self) -> tuple[str, ...]:
        """The names of all pets and conditions that it may have."""
        return tuple(trait.name for trait in (*self.pets, *self.conditions))

    @property
    def sleepers(self) -> int:
        """How many sleep in the home."""
        return len(self.members) if self.beds is None else self.beds


class AgeGroup(Record):
    """Members up to ``max_age`` years, by name. ``visits``: the share of households without one
    that one visits so often that its things are there."""

    name: str
    max_age: Annotated[int, between(0, 120)]
    visits: Annotated[float, between(0.0, 1.0)] = 0.0


class ReachRow(Record):
    """Up to this age a child grasps things this high (metres, standing, arm up), and ``climbs`` on
    what it can."""

    max_age: Annotated[int, between(0, 17)]
    reach_m: Annotated[float, between(0.1, 2.5)]
    climbs: bool = True


class SurfaceChoice(Record):
    """Surfaces of which a home has one in all rooms of these types; of no types: in all rooms that
    no choice before it names."""

    rooms: RoomNames = ()
    of: Annotated[tuple[Word, ...], Field(min_length=1), Expect("a list of surfaces")]


class Style(Record):
    """What makes the rooms of a home look like one home's.

    ``suites`` gives, for each part of a home (a word of its own, such as ``kitchen``), suites of
    models of which one is drawn; categories with a model of a drawn suite use no other models.
    Of other categories the models with one of the ``tags`` are used, where there are any.
    """

    name: str
    title: str = ""
    weight: AboveZero = 1.0
    floors: tuple[SurfaceChoice, ...] = ()
    walls: tuple[SurfaceChoice, ...] = ()
    ceilings: tuple[SurfaceChoice, ...] = ()
    skirtings: tuple[SurfaceChoice, ...] = ()
    splashbacks: tuple[SurfaceChoice, ...] = ()
    # Pairs, for their order decides which is drawn first.
    suites: tuple[tuple[str, tuple[str, ...]], ...] = ()
    tags: tuple[str, ...] = ()


class FurnitureItem(Record):
    """One piece of a base home: category, bottom centre, heading (front along +X at 0).

    ``on`` names a category placed before it in the room: the piece stands on the nearest such
    one, at that model's real height, and z is ignored. ``against_wall`` makes ``position_m`` the
    middle of the back instead of the centre, so that models of any depth touch the wall.
    ``jitter_m`` shifts it by up to so much along x and y. ``width_m`` [least, most] restricts the
    models to those that wide (their y extent), where units stand side by side; ``model`` names the
    one that is meant, ``joints`` and ``variant`` how it stands (of a home that is as drawn, at rest
    without them; of another, as often as its category says, on or open).
    """

    category: CategoryName
    position_m: Point3
    yaw_deg: Annotated[float, between(-360.0, 360.0)] = 0.0
    width_m: Annotated[tuple[float, float], span(0.0, 20.0), PAIR] | None = None
    optional: bool = False
    on: CategoryName | None = None
    against_wall: bool = False
    # More than half a metre would be another place.
    jitter_m: Annotated[float, between(0.0, 0.5)] = Field(default=0.0, ge=0.0)
    model: Annotated[str, Expect("the id of a model")] | None = None
    variant: str = "default"
    joints: dict[str, Coordinate] = Field(default_factory=dict)


class ThingItem(Record):
    """One small thing of a base home, of a ``model``, where it lies: it is let go of there, and
    stays but for a hair. ``variant`` and ``joints`` are how it looks and stands open.

    ``anomaly`` names the hazard that it is: every scene of the home labels it. Else it goes where
    it is a hazard.
    """

    category: CategoryName
    model: Annotated[str, Expect("the id of a model")]
    position_m: Point3
    quat_xyzw: Quaternion = (0.0, 0.0, 0.0, 1.0)
    variant: str = "default"
    joints: dict[str, Coordinate] = Field(default_factory=dict)
    anomaly: HazardName | None = None

    @model_validator(mode="after")
    def _turns(self) -> ThingItem:
        if abs(sum(value * value for value in self.quat_xyzw) - 1.0) > 1e-3:
            refuse(problem(("quat_xyzw",), "expected a unit quaternion"))
        return self


class RoomSpec(Record):
    """A room as a home is specified: axis-aligned rectangles that join to its outline."""

    name: Word
    type: RoomName
    rectangles_m: Annotated[tuple[Rectangle, ...], Expect("[[x_min, y_min, x_max, y_max], ...]")]
    furniture: tuple[FurnitureItem, ...] = ()
    things: tuple[ThingItem, ...] = ()

    @model_validator(mode="after")
    def _low_before_high(self) -> RoomSpec:
        wrong = [
            problem(("rectangles_m", index), "expected [x_min, y_min, x_max, y_max]")
            for index, (a, b, c, d) in enumerate(self.rectangles_m)
            if a >= c or b >= d
        ]
        if not self.rectangles_m:
            wrong = [problem(("rectangles_m",), "expected at least one rectangle")]
        if wrong:
            refuse(*wrong)
        return self


class OpeningSpec(Record):
    """A door or window of a base home: centre on the wall's middle line.

    A door's leaf swings into the room that is listed first; with ``hinge_flip`` into the other.
    ``model`` names what fills it, ``joints`` how far its leaves are turned (radians); without them
    what the home's style has, open as often as doors are.
    """

    kind: OpeningKind
    center_m: Point2
    along: Literal["x", "y"]
    sill_m: Annotated[float, between(0.0, 3.0)] = 0.0
    small: bool = False
    hinge_flip: bool = False
    model: Annotated[str, Expect("the id of a model")] | None = None
    joints: dict[str, Coordinate] = Field(default_factory=dict)


class HomeSpec(Record):
    """What a home is to be: a base home drawn by hand, or a generated one (``procedural``: rules
    furnish its rooms). ``style`` None: any. ``as_drawn``: what is drawn is all there is."""

    id: str
    title: str
    kind: Literal["base", "procedural"] = "base"
    height_m: float = 2.6
    rooms: tuple[RoomSpec, ...]
    openings: tuple[OpeningSpec, ...]
    style: str | None = None
    as_drawn: bool = False


class HomeMix(Record):
    """Which rooms a generated home has: all ``rooms`` open from the ``hub``, but those whose type
    is in ``off``: each of them opens from a room of the type that stands there with it."""

    name: str
    weight: AboveZero
    hub: str
    rooms: tuple[str, ...]
    off: tuple[tuple[str, str], ...] = ()

    def parents(self) -> tuple[int, ...]:
        """By index into the hub and the rooms: which each opens from; -1 for the hub.

        Where a type comes twice, what opens from it is shared out among its rooms in turn.
        """
        types = (self.hub, *self.rooms)
        others = dict(self.off)
        out = [-1]
        for k, name in enumerate(self.rooms, start=1):
            before = sum(other == name for other in types[1:k])
            open_from = [j for j, other in enumerate(types) if other == others.get(name)]
            out.append(open_from[before % len(open_from)] if open_from else 0)
        return tuple(out)


def canonical_sha256(data: Any) -> str:
    """SHA-256 of what JSON says, however it is laid out."""
    text = json.dumps(data, sort_keys=True, separators=(",", ":"), ensure_ascii=True)
    return hashlib.sha256(text.encode("ascii")).hexdigest()


class Catalog(Record):
    """The whole catalogue, resolved: what a build uses and ``catalogue.json`` holds."""

    hazards: tuple[Hazard, ...]
    categories: tuple[Category, ...]
    room_types: tuple[RoomType, ...]
    households: tuple[HouseholdTemplate, ...]
    reach: tuple[ReachRow, ...]
    homes: tuple[HomeSpec, ...]
    mixes: tuple[HomeMix, ...] = ()
    groups: tuple[AgeGroup, ...] = ()
    styles: tuple[Style, ...] = ()
    fittings: tuple[Fitting, ...] = ()
    activities: tuple[Activity, ...] = ()

    @cached_property
    def sha256(self) -> str:
        """SHA-256 of the canonical JSON (sorted keys, no white space); workers get it along."""
        return canonical_sha256(self.model_dump(mode="json"))

    @cached_property
    def climbs(self) -> dict[str, float]:
        """By category what children climb on, and about how high they then stand, metres."""
        return {c.name: c.climb_m for c in self.categories if c.climb_m is not None}

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Catalog:
        """A copy with some fields changed, and so with a digest of its own."""
        copied = super().model_copy(update=update, deep=deep)
        for cached in ("sha256", "climbs", "_by_name"):
            copied.__dict__.pop(cached, None)
        return copied

    def hazard(self, hazard_id: str) -> Hazard:
        """The hazard of this id (KeyError when there is none)."""
        for item in self.hazards:
            if item.id == hazard_id:
                return item
        raise KeyError(hazard_id)

    def category(self, name: str) -> Category:
        """The category of this name (KeyError when there is none)."""
        return self._by_name[name]

    @cached_property
    def _by_name(self) -> dict[str, Category]:
        return {c.name: c for c in self.categories}


class UniqueAnomaly(Record):
    """An enumerated (hazard, category, state, relation, target category), with the room type where
    a recipe sets what is in rooms of some types."""

    hazard: str
    category: str
    state: str | None
    relation: str | None
    target: str | None
    room: str | None = None
