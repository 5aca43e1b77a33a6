"""A furnished, still empty home: shell, openings, furniture, zones, free space."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from shapely.geometry import Polygon

from sdgen.actions import at_rest
from sdgen.cameras.view import View
from sdgen.catalog.records import Catalog, HomeMix, HomeSpec, Style
from sdgen.errors import UsageError
from sdgen.facts import Facts, bodies_of, room_at
from sdgen.freespace import (
    free_shape,
    polygons,
    random_point,
    rounded_rings,
    union,
    unreachable_rooms,
)
from sdgen.geometry import Vec2
from sdgen.hazards.certify import facts_of
from sdgen.home.arrange import furnish_by_rules
from sdgen.home.context import HomeContext, Models
from sdgen.home.daylight import daylight_random
from sdgen.home.fittings import add_fittings
from sdgen.home.furnish import fill_openings, furnish_as_drawn, leave_open, stand_open
from sdgen.home.generate import generate_home
from sdgen.home.layout import Intent, Layout
from sdgen.home.reach import Reach
from sdgen.home.shell import build_shell
from sdgen.home.style import style_random
from sdgen.home.tenants import Homes, Tenants, beds_of, wide_beds
from sdgen.home.things import NO_THINGS, Things, things_drawn
from sdgen.home.wall_bands import with_tiles
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.rejection import Rejection, reject
from sdgen.scene import AgentStart, Home, ObjectInstance, Room, Scene
from sdgen.seeding import Rng, lane
from sdgen.vocabulary import HOLDING, OPENINGS
from sdgen.zones import (
    derive_zones,
    doorway_blocked,
    floor_obstacles,
    narrow_floor,
    swing_blocked,
)

#: Of the scenes of a mixed build whose household fits a base home, this many play in one: a choice.
#: There are few of them, so that more would repeat them; fewer would say little about homes drawn
#: by people. One household in ten fits none, so that a good quarter of all scenes play in them.
BASE_SHARE = 0.3


@dataclass(frozen=True)
class FurnishedHome:
    """Where a scene can play: the home, the furniture, and what follows from them; with
    :func:`~sdgen.pipeline.overlook.overlooked`, the views too, canonical ones first. ``things``
    are those that the home draws itself; ``as_drawn``: no others are added."""

    context: HomeContext
    layout: Layout
    free_space: tuple[tuple[Vec2, ...], ...]
    agent_start: AgentStart
    views: tuple[View, ...] = ()
    things: Things = NO_THINGS
    as_drawn: bool = False

    @property
    def ids(self) -> frozenset[int]:
        """Every node id that is in use."""
        home = self.context.home
        rooms, structures = (r.id for r in home.rooms), (s.id for s in home.structures)
        things = (item.id for item in self.things.items)
        return frozenset((*rooms, *structures, *self.layout.items, *things))

    @cached_property
    def facts(self) -> Facts:
        """Facts of the home with its furniture alone: the same in every try."""
        infos = self.layout.library.infos
        return facts_of(self.scene(0, self.layout.items), infos, self.context.catalog)

    def scene(self, index: int, items: Mapping[int, ObjectInstance]) -> Scene:
        """The scene with these objects, sorted by id."""
        return Scene(
            id=f"{index:06d}",
            index=index,
            home=self.context.home,
            zones=tuple(self.context.zones),
            free_space=self.free_space,
            agent_start=self.agent_start,
            objects=tuple(items[k] for k in sorted(items)),
        )


def _sorted(home: Home) -> Home:
    """The home with its arrays sorted by id, so that their order says nothing either."""
    return home.model_copy(
        update={
            "rooms": tuple(sorted(home.rooms, key=lambda r: r.id)),
            "structures": tuple(sorted(home.structures, key=lambda s: s.id)),
            "openings": tuple(sorted(home.openings, key=lambda o: o.object_id)),
        }
    )


@dataclass(frozen=True)
class HomeChoice:
    """Which home a scene plays in: a base home, or a generated one of this id (``base`` None),
    of one of ``mixes``.

    A generated home is drawn anew for every attempt; its id, and so its split, stays.
    """

    id: str
    base: HomeSpec | None
    mixes: tuple[HomeMix, ...] = ()

    def spec(self, catalog: Catalog, rng: Rng) -> HomeSpec | Rejection:
        """The home to build and furnish; rejected when no generated floor plan came out valid."""
        return self.base or generate_home(self.id, self.mixes, catalog, rng)


def homes_of(
    catalog: Catalog, options: BuildOptions
) -> tuple[tuple[HomeSpec, ...], tuple[HomeMix, ...]]:
    """The base homes, and the mixes of generated ones, that a build may use."""
    bases = () if options.homes == "procedural" else catalog.homes
    mixes = () if options.homes == "base" else catalog.mixes
    if options.homes != "procedural" and not bases:
        raise UsageError("the catalogue has no home to build in (hazard_catalog/homes)")
    if options.homes != "base" and not mixes:
        raise UsageError("the catalogue has no mix of rooms to generate homes from (mixes.yaml)")
    return bases, mixes


def pick_home(
    catalog: Catalog,
    options: BuildOptions,
    index: int,
    fits: Callable[[HomeSpec | HomeMix], bool] = lambda _: True,
    turn: int = 0,
) -> HomeChoice:
    """The home of a scene, by a lane of its own, of those that fit (of all, where none does);
    ``turn`` counts those that were given up before it."""
    rng = lane(options.seed, index, f"home:{turn}" if turn else "home")
    bases, mixes = homes_of(catalog, options)
    in_base = rng.random() < BASE_SHARE
    fitting = [home for kind in (bases, mixes) for home in kind if fits(home)]
    if fitting:
        bases = tuple(home for home in fitting if isinstance(home, HomeSpec))
        mixes = tuple(home for home in fitting if isinstance(home, HomeMix))
    if mixes and not (bases and in_base):
        return HomeChoice(f"procedural_{options.seed}_{index:06d}", None, mixes)
    base = bases[int(rng.integers(len(bases)))]
    return HomeChoice(base.id, base)


def furnished_home(
    spec: HomeSpec,
    catalog: Catalog,
    library: Library,
    models: Models,
    ids: Iterator[int],
    rng: Rng,
    tenants: Tenants | None = None,
    daylight_rng: Rng | None = None,
) -> FurnishedHome | Rejection:
    """A furnished, still empty home. ``ids`` are used up. When it is seen comes from
    ``daylight_rng``; without, it is an ordinary day.

    ``tenants`` are whom it is furnished for: their things may be in it and no others'; None: for
    anybody, with anything.
    """
    if tenants is not None and Homes(catalog).needs_wide_beds(tenants.beds, spec):
        models = wide_beds(models, catalog)
    suites = _suites(models, catalog, library)
    named = _styles(spec, catalog)
    # A home that names its style may have to borrow fronts that its split may show.
    others = [style for style in catalog.styles if style not in named]
    style = style_random(named, library, suites, rng, others)
    theirs = models if tenants is None else tenants.models(models, catalog)
    styled = style.models(theirs)
    home = build_shell(spec, style, library, ids, rng)
    if daylight_rng is not None:
        daylight = daylight_random(home.outdoors.season, daylight_rng)
        home = home.model_copy(update={"daylight": daylight})
    properties: Mapping[str, tuple[str, ...]] = {c.name: c.properties for c in catalog.categories}
    looked_at = frozenset(name for name, traits in properties.items() if "LOOKABLE" in traits)
    layout = fill_openings(spec, home, Layout(library, ids, looked_at), style, models, rng)
    if isinstance(layout, Rejection):
        return layout
    if spec.kind == "procedural":
        layout = furnish_by_rules(home, layout, catalog, styled, rng)
    else:
        layout = furnish_as_drawn(spec, home, layout, catalog, style, models, theirs, rng)
    if isinstance(layout, Rejection):
        return layout
    if not spec.as_drawn:
        layout = add_fittings(home, layout, catalog, styled, rng)
    things = things_drawn(spec, home, library, ids)
    if isinstance(things, Rejection):
        return things
    if tenants is not None and Homes(catalog).has_beds(spec, tenants.beds):
        places = beds_of(layout.items.values(), library.infos, catalog)
        if places < tenants.beds:
            return reject("home", "too_few_beds", measured=places, limit=tenants.beds)
    home = _sorted(with_tiles(home, layout, catalog, style))
    # By id, as anyone has it who reads the scene: a union's last digits depend on the order.
    standing = [layout.items[k] for k in sorted(layout.items)]
    bodies = bodies_of(_shut(standing, library) if spec.as_drawn else standing, library.infos)
    obstacles = floor_obstacles(bodies)
    free = free_shape(home, obstacles)
    cut_off = unreachable_rooms(home, free)
    if cut_off:
        return reject("home", "room_cut_off", category=cut_off[0].type)
    in_swing = swing_blocked(bodies)
    if in_swing:
        return reject("home", "in_door_swing", category=layout.items[in_swing[0]].category)
    in_doorway = doorway_blocked(home, bodies)
    if in_doorway:
        return reject("home", "in_doorway", category=layout.items[in_doorway[0]].category)
    context = HomeContext(
        home,
        derive_zones(home, bodies, free, properties),
        catalog,
        styled,
        Reach(catalog, bodies),
        narrow=narrow_floor(home, bodies, properties),
        standing=union(obstacles),
        free=free,
        tidiness=Tenants.tidiness if tenants is None else tenants.tidiness,
    )
    context = stand_open(layout, context) if spec.as_drawn else leave_open(layout, context, rng)
    # In the piece that every room is reached from: furniture leaves pockets that nothing leads to.
    start = random_point(next(iter(polygons(context.free or free)), Polygon()), rng)
    room = None if start is None else room_at(home.rooms, *start)
    if start is None or room is None:
        return reject("home", "no_free_floor")
    furnished = FurnishedHome(
        context=context,
        layout=layout,
        free_space=rounded_rings(free),
        agent_start=_agent_start(start, room, rng),
        things=things,
        as_drawn=spec.as_drawn,
    )
    return _with_intents(furnished) if things.items else furnished


def _shut(items: Sequence[ObjectInstance], library: Library) -> list[ObjectInstance]:
    """Pieces as nobody left them, doors as they are: a home that is as drawn has pieces open from
    the start, any other opens them when its ways were looked at, and both must be taken alike."""
    return [
        item if item.category in OPENINGS else at_rest(item, library.assets[item.asset])
        for item in items
    ]


def _with_intents(home: FurnishedHome) -> FurnishedHome:
    """The home with what each of its things surely lies on or in."""
    items = {**home.layout.items, **{item.id: item for item in home.things.items}}
    facts = facts_of(home.scene(0, items), home.layout.library.infos, home.context.catalog)
    intents = {}
    for item in home.things.items:
        for relation in HOLDING:
            for found in facts.related(item.id, relation):
                if found.holds and found.sure:
                    intents[item.id] = Intent(relation, found.target_id)
    return replace(home, things=replace(home.things, intents=intents))


def _styles(spec: HomeSpec, catalog: Catalog) -> tuple[Style, ...]:
    """The styles that a home may be of."""
    if spec.style is None:
        return catalog.styles
    return tuple(style for style in catalog.styles if style.name == spec.style)


def _suites(models: Models, catalog: Catalog, library: Library) -> Callable[[str], bool]:
    """Whether there are models of a suite, of all categories that the library has some of it in:
    of a kitchen whose corner units are withheld others would fill the corners."""
    shown: set[str | None] = set()
    lacking: set[str | None] = set()
    for category in catalog.categories:
        here = {model.suite for model in models(category.name)}
        shown |= here
        lacking |= {model.suite for model in library.by_category(category.name)} - here
    return (shown - lacking).__contains__


def _agent_start(point: Vec2, room: Room, rng: Rng) -> AgentStart:
    return AgentStart(
        position_m=(round(point[0], 3), round(point[1], 3), 0.0),
        yaw_rad=round(float(rng.uniform(-3.14159, 3.14159)), 4),
        room_id=room.id,
    )
