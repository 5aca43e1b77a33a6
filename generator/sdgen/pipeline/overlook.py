"""A home's views: chosen before anything lies there, then held against what does."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import compress

import numpy as np
import shapely
from shapely.geometry import Polygon

from sdgen.cameras.around import Surroundings
from sdgen.cameras.choice import Marked, pick, shows
from sdgen.cameras.cover import CANONICAL, choose, shown_at_rest, states_shown, things_shown
from sdgen.cameras.judged import Inventory
from sdgen.cameras.overviews import overviews
from sdgen.cameras.posts import near_views, swept_by
from sdgen.cameras.seen import Seen
from sdgen.cameras.spots import SetTo, spots_of
from sdgen.cameras.view import CLEARANCE_M, clear, to_cameras
from sdgen.catalog.records import PlaceRecipe, SetRecipe
from sdgen.facts import Facts
from sdgen.hazards.evidence import evidence_of
from sdgen.hazards.placing import Injected
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.physics.rays import RayWorld
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.rejection import Rejection, reject
from sdgen.scene import Anomaly, Camera
from sdgen.seeding import Rng
from sdgen.vocabulary import FLAT_M

#: Outlines of where cameras may stand are this exact: plain overlays stumble over slivers.
_GRID_M = 1e-4
#: No eye is so little above a board beside it: a book on that would stand before it in every try.
_ON_SHELF_M = 0.12


def overlooked(home: FurnishedHome, count: int, client: Client, rng: Rng) -> FurnishedHome:
    """The home with ``count`` views or, if more, the canonical ones, and with what these show.

    The canonical views come first and are the same for any ``count``: content follows from them
    alone.
    """
    context, layout, library = home.context, home.layout, home.layout.library
    spots = spots_of(context, layout, rng, home.things)
    swept = swept_by(layout, spots.states).buffer(CLEARANCE_M)
    free = shapely.union_all([Polygon(ring) for ring in home.free_space])
    free = shapely.difference(free, swept, grid_size=_GRID_M)
    with RayWorld(library, home.scene(0, layout.items), client.still) as world:
        around = Surroundings(layout, context.zones).of
        near = near_views(library, free, spots, around, rng)
        near = list(compress(near, clear(world.cast, near)))
        near = list(compress(near, clear(world.cast, near, _ON_SHELF_M)))
        views = [*near, *overviews(context.home, _inventory(home), free, world.cast, rng)]
    states = np.zeros((len(views), len(spots.states)), dtype=np.bool_)
    for numbers in _at_once(spots.states):
        now = [spots.states[k] for k in numbers]
        items = {**layout.items, **{one.item.id: one.item for one in now}}
        with RayWorld(library, home.scene(0, items), client.still) as world:
            states[:, numbers] = states_shown(library, views, now, world.cast)
    with RayWorld(library, home.scene(0, layout.items), client.still) as world:
        states = shown_at_rest(library, views, spots.states, states, world.cast)
        shows = np.concatenate([things_shown(views, spots.points_m, world.cast), states], axis=1)
        chosen = choose(views, shows, spots.weight, max(count, CANONICAL), rng)
        canonical = chosen[:CANONICAL]
        on_them = shows[canonical, : len(spots.target)].any(axis=0)
        shown = zip(spots.states, states[canonical].T, strict=True)
        seen = Seen(
            library,
            [views[k] for k in canonical],
            [one for one, views_show in shown if views_show.any()],
            set(spots.target.tolist()) - set(spots.target[on_them].tolist()),
            world.cast,
        )
    return replace(
        home, context=replace(context, shows=seen), views=tuple(views[k] for k in chosen)
    )


def _inventory(home: FurnishedHome) -> Inventory:
    """What an overview may show of a furnished home. A rug and a mat are floor to a person, and so
    is no piece of furniture what is as thin."""
    layout, catalog = home.layout, home.context.catalog
    furniture = [
        key
        for key, item in layout.items.items()
        if catalog.category(item.category).kind == "furniture"
        and layout.info(key).extents_m[2] > FLAT_M
    ]
    rooms = {key: item.room_id for key, item in layout.items.items()}
    return Inventory.of(home.context.home, rooms, furniture)


def out_of_view(home: FurnishedHome, hazards: Sequence[str]) -> Rejection | None:
    """Why no try in this home can show all these hazards: one of them would only be set to a state,
    and no view shows any of what could be."""
    context = home.context
    for hazard_id in hazards:
        recipes = context.catalog.hazard(hazard_id).anomalies
        could = [
            (item.id, recipe.state)
            for recipe in recipes
            if isinstance(recipe, SetRecipe)
            for item in home.layout.items.values()
            if item.category in recipe.categories
        ]
        placed = any(isinstance(recipe, PlaceRecipe) for recipe in recipes)
        ways = [context.shows.set_to(*one) for one in could]
        if could and not placed and all(way is not None and not way for way in ways):
            return reject("views", "unseen", hazard=hazard_id)
    return None


def _at_once(states: Sequence[SetTo]) -> list[list[int]]:
    """Numbers of the states in rounds, each object in one state a round; one round at least."""
    rounds: list[list[int]] = [[]]
    times: Counter[int] = Counter()
    for number, one in enumerate(states):
        if times[one.item.id] == len(rounds):
            rounds.append([])
        rounds[times[one.item.id]].append(number)
        times[one.item.id] += 1
    return rounds


@dataclass(frozen=True)
class Looked:
    """A scene's cameras, and those of its near misses that a view shows."""

    cameras: tuple[Camera, ...]
    lookalikes: tuple[Injected, ...]


def looked_at(
    home: FurnishedHome,
    facts: Facts,
    anomalies: Sequence[Anomaly],
    lookalikes: Sequence[Injected],
    options: BuildOptions,
    client: Client,
    rng: Rng,
) -> Looked | Rejection:
    """The scene as the home's views show it, all in place; rejected when they miss an anomaly.

    A near miss that they do not show is one thing among others, as an anomaly that they do not
    show is none: of a knife both must show the blade.
    """
    library, canonical, scene = home.layout.library, home.views[:CANONICAL], facts.scene
    marked = [marked_as(one) for one in anomalies]
    for one in lookalikes:
        body, hazard = facts.bodies[one.object_id], home.context.catalog.hazard(one.hazard)
        marked.append(Marked(one.object_id, *evidence_of(hazard, body.info, body.item)))
    with RayWorld(library, scene, client.still) as world:
        if not clear(world.cast, canonical).all():
            return reject("views", "blocked")
        shown = shows(library, scene, world.cast, canonical, marked)
    visible = [bool(column.any()) for column in shown.T]
    for anomaly, seen in zip(anomalies, visible, strict=False):
        if not seen:
            return reject("views", "unseen", hazard=anomaly.hazard, objects=(anomaly.object_id,))
    kept = tuple(
        one for one, seen in zip(lookalikes, visible[len(anomalies) :], strict=True) if seen
    )
    is_anomaly = [k < len(anomalies) for k in range(len(marked))]
    views = pick(home.views, shown, is_anomaly, options.views, rng)
    size = (options.width, options.height)
    raised = [view.at(options.eye_height_m) for view in views]
    return Looked(to_cameras(raised, scene.home, size, rng), kept)


def marked_as(anomaly: Anomaly) -> Marked:
    """What of an anomaly a view must show."""
    return Marked(
        anomaly.object_id,
        anomaly.evidence_parts,
        anomaly.evidence_pixels_needed,
        anomaly.evidence_outdoors_needed,
        anomaly.evidence_objects,
    )
