"""Categories, room types, mixes of rooms and households as people write them in YAML."""

from __future__ import annotations

from typing import Annotated, get_args

from pydantic import Field, model_validator

from sdgen.catalog.entry import as_record
from sdgen.catalog.records import (
    Abode,
    AgeGroup,
    AtMost,
    Category,
    CategoryKind,
    ClutterPrior,
    FittedAt,
    Fitting,
    FurnitureRule,
    Group,
    Holds,
    HomeMix,
    HouseholdTemplate,
    MemberRule,
    ReachRow,
    RoomType,
    Style,
    SurfaceChoice,
    Trait,
    WindowKind,
)
from sdgen.catalog.row import Row
from sdgen.catalog.words import (
    PAIR,
    Belongs,
    Categories,
    CategoryName,
    Counts,
    HazardName,
    OptionalCategories,
    RoomName,
    RoomNames,
    Size,
    State,
    Text,
    Weight,
    Word,
    between,
    names_of,
    one_of,
    span,
)
from sdgen.scene import Notify, Record
from sdgen.strict import Expect, problem, refuse
from sdgen.vocabulary import DOORS, HoldingRelation, InnerOpening

#: VirtualHome's spelling; ``category`` of a node in graph.json.
SUPERCLASSES = (
    "Appliances",
    "Ceiling",
    "Decor",
    "Doors",
    "Electronics",
    "Floor",
    "Food",
    "Furniture",
    "Lamps",
    "Props",
    "Walls",
    "Windows",
)
#: VirtualHome's, HEAT_SOURCE and WATER_SOURCE (of which zones are made), and SAT_AT (what a seat
#: at it faces).
PROPERTIES = (
    "CAN_OPEN",
    "CLOTHES",
    "CONTAINERS",
    "COVER_OBJECT",
    "CREAM",
    "CUTTABLE",
    "DRINKABLE",
    "EATABLE",
    "GRABBABLE",
    "HANGABLE",
    "HAS_PAPER",
    "HAS_PLUG",
    "HAS_SWITCH",
    "HEAT_SOURCE",
    "LIEABLE",
    "LOOKABLE",
    "MOVABLE",
    "POURABLE",
    "READABLE",
    "RECIPIENT",
    "SAT_AT",
    "SITTABLE",
    "SURFACES",
    "WATER_SOURCE",
)


class AbodeYaml(Record):
    """``lives``: where a category normally is."""

    relation: HoldingRelation
    target: Categories
    rooms: RoomNames = ()
    hollow: Word | None = None
    state: State | None = None
    weight: Weight = 1.0

    @model_validator(mode="after")
    def _in_a_hollow(self) -> AbodeYaml:
        if self.hollow is not None and self.relation != "INSIDE":
            refuse(problem(("hollow",), "hollow needs 'relation: INSIDE'"))
        return self

    def record(self) -> Abode:
        """The record of it."""
        return as_record(self, Abode, targets=self.target)


class CategoryYaml(Record):
    """One entry of a ``categories/`` file; ``source`` is for people: where the sizes come from."""

    superclass: Annotated[str, one_of(SUPERCLASSES), Expect(f"one of {', '.join(SUPERCLASSES)}")]
    kind: CategoryKind = "small"
    source: Text = ""
    size_m: Annotated[tuple[Size, Size], Expect("[[x, y, z] smallest, [x, y, z] largest]")]
    # A tonne: more than any furniture weighs.
    mass_kg: Annotated[tuple[float, float], span(0.0, 1000.0), PAIR]
    properties: Annotated[tuple[str, ...], names_of("property", 0, PROPERTIES)] = ()
    lives: tuple[AbodeYaml, ...] = ()
    switched_on: Annotated[float, between(0.0, 1.0)] = 0.0
    stands_open: Annotated[float, between(0.0, 1.0)] = 0.0
    # Nobody steps up higher than a kitchen counter.
    climb_m: Annotated[float, between(0.05, 1.2)] | None = None
    tiled_m: Annotated[float, between(0.1, 5.0)] | None = None
    at_most: Annotated[AtMost, Expect("{room: number, home: number}")] = AtMost()
    alike: bool = False
    reserved: Annotated[tuple[str, ...], names_of("hollow", least=0)] = ()
    belongs_to: Belongs = ()
    always: bool = False
    # A family's bed for more is none that anybody sells.
    sleeps: Annotated[int, between(0, 4)] = 0
    holds: Annotated[Holds | None, Expect("{chance: 0 to 1, count: [least, most]}")] = None
    rows: Annotated[tuple[Row, ...], Expect("a list of {of: categories}")] = ()
    replaces: bool = False

    @model_validator(mode="after")
    def _check(self) -> CategoryYaml:
        if any(x > y for x, y in zip(*self.size_m, strict=True)):
            refuse(problem(("size_m",), "the smallest is larger than the largest"))
        if self.mass_kg[0] <= 0:
            refuse(problem(("mass_kg",), "masses must be above 0"))
        if self.switched_on and "HAS_SWITCH" not in self.properties:
            refuse(problem(("switched_on",), "only what has the property HAS_SWITCH is ever on"))
        if self.stands_open and not (self.kind == "furniture" and "CAN_OPEN" in self.properties):
            text = "only furniture with the property CAN_OPEN is ever left open by it"
            refuse(problem(("stands_open",), text))
        if self.tiled_m is not None and self.kind != "furniture":
            refuse(problem(("tiled_m",), "walls are tiled behind furniture alone"))
        if self.holds is not None and self.kind != "small":
            text = "only small things hold others by it; for furniture see 'clutter' of rooms.yaml"
            refuse(problem(("holds",), text))
        if self.rows and self.kind != "furniture":
            refuse(problem(("rows",), "only furniture has shelves that rows stand on"))
        if self.always and not (self.belongs_to and self.lives):
            refuse(problem(("always",), "always needs 'belongs_to' and 'lives': whose, and where?"))
        return self

    def record(self, name: str) -> Category:
        """The record of it."""
        return as_record(
            self,
            Category,
            name=name,
            extents_min_m=self.size_m[0],
            extents_max_m=self.size_m[1],
            mass_min_kg=self.mass_kg[0],
            mass_max_kg=self.mass_kg[1],
            lives=tuple(item.record() for item in self.lives),
        )


class RoomTypeYaml(Record):
    """One entry of ``rooms.yaml``; rules that name the type it is ``like`` hold in it too."""

    like: RoomName | None = None
    area_m2: Annotated[tuple[float, float], span(1.0, 200.0)] = (8.0, 16.0)
    narrowest_m: Annotated[float, between(0.9, 10.0)] = 2.0
    daylight: bool = True
    windows: WindowKind = "large"
    # A large window is 1.2 m high, under a ceiling of 2.4 m or more.
    sill_m: Annotated[float, between(0.0, 1.6)] = 0.9
    # Wide enough for a door to open into, narrower than what would be a room.
    corridor_m: Annotated[tuple[float, float], span(1.0, 4.0), PAIR] | None = None
    free_wall_m: Annotated[float, between(0.0, 10.0)] = 0.0
    joined: dict[RoomName, Annotated[float, between(0.0, 1.0)]] = Field(default_factory=dict)
    opens_to: dict[RoomName, dict[InnerOpening, Annotated[float, between(0.0, 1.0)]]] = Field(
        default_factory=dict
    )
    beside: RoomNames = ()
    furniture: tuple[FurnitureRule, ...] = ()
    clutter: dict[CategoryName, Counts]
    floor_clutter: Counts
    belongs_to: Belongs = ()
    replaces: bool = False

    @model_validator(mode="after")
    def _each_after_what_it_stands_by(self) -> RoomTypeYaml:
        placed: set[str] = set()
        wrong = []
        for index, rule in enumerate(self.furniture):
            for name in rule.of:
                if name not in placed:
                    text = f"no {name} is placed before it in this room"
                    wrong.append(problem(("furniture", index, "of"), text))
            placed |= {rule.category, rule.corner, *rule.row, *rule.extra}
        if wrong:
            refuse(*wrong)
        return self

    def record(self, name: str) -> RoomType:
        """The record of it."""
        return as_record(
            self,
            RoomType,
            name=name,
            joined=tuple(self.joined.items()),
            opens_to=tuple((name, tuple(kinds.items())) for name, kinds in self.opens_to.items()),
            clutter=tuple(
                ClutterPrior(receptacle=receptacle, count_min=least, count_max=most)
                for receptacle, (least, most) in self.clutter.items()
            ),
            floor_clutter_min=self.floor_clutter[0],
            floor_clutter_max=self.floor_clutter[1],
        )


class MixYaml(Record):
    """One entry of ``mixes.yaml``; a room type may come twice."""

    weight: Weight = 1.0
    hub: RoomName
    rooms: Annotated[tuple[RoomName, ...], Field(min_length=1), Expect("a list of room types")]
    off: dict[RoomName, RoomName] = Field(default_factory=dict)
    replaces: bool = False

    @model_validator(mode="after")
    def _every_room_opens_from_another(self) -> MixYaml:
        wrong = []
        for name, other in self.off.items():
            ways = [name]
            while ways[-1] in self.off and self.off[ways[-1]] not in ways:
                ways.append(self.off[ways[-1]])
            if name not in self.rooms:
                wrong.append(problem(("off", name), f"no {name} is among its rooms"))
            elif other not in (self.hub, *self.rooms):
                wrong.append(problem(("off", name), f"this home has no {other}"))
            elif ways[-1] in self.off:
                text = " from ".join([*ways, self.off[ways[-1]]])
                wrong.append(problem(("off", name), f"goes round in a circle: {text}"))
        if wrong:
            refuse(*wrong)
        return self

    def record(self, name: str) -> HomeMix:
        """The record of it."""
        return as_record(self, HomeMix, name=name, off=tuple(self.off.items()))


class FittingYaml(Record):
    """One entry of ``fittings.yaml``."""

    category: CategoryName
    where: FittedAt
    of: OptionalCategories = ()
    rooms: RoomNames = ()
    chance: Annotated[float, between(0.0, 1.0)] = 1.0
    count: Annotated[tuple[int, int], span(0, 20, whole=True), PAIR] = (1, 1)
    z_m: Annotated[float, between(0.0, 5.0)] = 0.0
    least_m: Annotated[float, between(0.3, 20.0)] = 2.0
    replaces: bool = False

    @model_validator(mode="after")
    def _beside_something(self) -> FittingYaml:
        about_pieces = self.where in ("beside", "at_hand", "over", "before_door")
        if about_pieces and not self.of:
            refuse(problem((), f"missing key 'of': 'where: {self.where}' needs it"))
        odd = [name for name in self.of if name not in DOORS]
        if self.where == "before_door" and odd:
            refuse(problem(("of",), f"{odd[0]} is no door (known: {', '.join(DOORS)})"))
        if not about_pieces and self.of:
            refuse(problem(("of",), f"does not go with 'where: {self.where}'"))
        return self

    def record(self, name: str) -> Fitting:
        """The record of it."""
        return as_record(self, Fitting, name=name)


class StyleYaml(Record):
    """One entry of ``styles.yaml``."""

    title: Text = ""
    weight: Weight = 1.0
    floors: tuple[SurfaceChoice, ...] = ()
    walls: tuple[SurfaceChoice, ...] = ()
    ceilings: tuple[SurfaceChoice, ...] = ()
    skirtings: tuple[SurfaceChoice, ...] = ()
    splashbacks: tuple[SurfaceChoice, ...] = ()
    suites: dict[Word, Annotated[tuple[str, ...], names_of("suite")]] = Field(default_factory=dict)
    tags: Annotated[tuple[str, ...], names_of("tag", least=0)] = ()
    replaces: bool = False

    def record(self, name: str) -> Style:
        """The record of it."""
        return as_record(self, Style, name=name, suites=tuple(self.suites.items()))


class TraitYaml(Record):
    """A pet or a condition that a share of the households has."""

    is_: Annotated[Text, Field(alias="is")]
    share: Annotated[float, between(0.0, 1.0)] = 0.5
    source: Text = ""


_Traits = Annotated[
    tuple[Text | TraitYaml, ...], Expect("a list of words, or of {is: ..., share: 0 to 1}")
]


class OptOutYaml(Record):
    """A group of hazards, or one, of which a share of the households wants to hear nothing."""

    of: HazardName | Group
    share: Annotated[float, between(0.0, 1.0)] = 0.5


class NeedsYaml(Record):
    """What the home of a household has: rooms of these types, and beds for so many."""

    rooms: Annotated[tuple[RoomName, ...], Expect("a list of room types")] = ()
    beds: Annotated[int | None, between(0, 20)] = None


class HouseholdYaml(Record):
    """One entry of ``templates`` in ``households.yaml``."""

    weight: Weight = 1.0
    members: Annotated[tuple[MemberRule, ...], Field(min_length=1), Expect("at least one item")]
    pets: _Traits = ()
    conditions: _Traits = ()
    tidiness: Annotated[tuple[float, float], span(0.0, 1.0), PAIR] = (0.2, 0.9)
    needs: Annotated[NeedsYaml, Expect("{rooms: [room types], beds: number}")] = NeedsYaml()
    notifications: dict[
        HazardName, Annotated[tuple[Notify, ...], names_of("choice", 1, get_args(Notify))]
    ] = Field(default_factory=dict)
    opt_outs: Annotated[
        tuple[OptOutYaml, ...], Expect("a list of {of: group or hazard, share: 0 to 1}")
    ] = ()
    replaces: bool = False

    def record(self, name: str) -> HouseholdTemplate:
        """The record of it."""
        return as_record(
            self,
            HouseholdTemplate,
            name=name,
            rooms=self.needs.rooms,
            beds=self.needs.beds,
            pets=_traits(self.pets),
            conditions=_traits(self.conditions),
            opt_outs=tuple(Trait(name=one.of, share=one.share) for one in self.opt_outs),
        )


def _traits(written: tuple[str | TraitYaml, ...]) -> tuple[Trait, ...]:
    return tuple(
        Trait(name=one) if isinstance(one, str) else as_record(one, Trait, name=one.is_)
        for one in written
    )


class AgeGroupYaml(Record):
    """One entry of ``groups`` in ``households.yaml``."""

    max_age: Annotated[int, between(0, 120)]
    visits: Annotated[float, between(0.0, 1.0)] = 0.0
    replaces: bool = False

    def record(self, name: str) -> AgeGroup:
        """The record of it."""
        return as_record(self, AgeGroup, name=name)


class ReachYaml(Record):
    """``reach`` of ``households.yaml``: how high children grasp things, by rising age."""

    rows: tuple[ReachRow, ...]
    source: Text = ""
    replaces: bool = False

    @model_validator(mode="after")
    def _rising(self) -> ReachYaml:
        wrong = [
            problem(("rows", index + 1), "ages and reaches must rise from row to row")
            for index, (a, b) in enumerate(zip(self.rows, self.rows[1:], strict=False))
            if b.max_age <= a.max_age or b.reach_m < a.reach_m
        ]
        if wrong:
            refuse(*wrong)
        return self
