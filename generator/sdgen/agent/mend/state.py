"""A scene while it is mended: what stays the same of it, and how it is now."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from sdgen.agent.mend.reach import Arms
from sdgen.agent.mend.records import Pair
from sdgen.cameras.lens import Gaze
from sdgen.catalog.records import Catalog
from sdgen.facts import Facts, bodies_of, unheld
from sdgen.freespace import union
from sdgen.hazards.certify import Positive, facts_of, survey
from sdgen.hazards.remedies import stocked
from sdgen.hazards.twin import After
from sdgen.home.context import HomeContext
from sdgen.home.layout import Layout
from sdgen.home.reach import Reach
from sdgen.households import decide
from sdgen.library import Library
from sdgen.physics.client import Client
from sdgen.pipeline.putting import facts_after
from sdgen.pipeline.undoing import check_standing
from sdgen.scene import Household, ObjectInstance, Scene
from sdgen.zones import floor_obstacles, narrow_floor


@dataclass(frozen=True)
class Setting:
    """What stays the same while a scene is mended."""

    catalog: Catalog
    library: Library
    client: Client
    household: Household
    context: HomeContext
    arms: Arms


@dataclass(frozen=True)
class Held:
    """What is in the hand, as it was when it was grabbed, and the hazards that it was: whether the
    household would be told of each."""

    item: ObjectInstance
    pairs: Mapping[Pair, bool]


@dataclass(frozen=True)
class State:
    """A scene as it is now, without what is in the hand; the pairs that hold, or may, in it and
    whether the household would be told of each; where the agent stands, and how far it has come.

    ``sure``: none of the pairs is in doubt.
    """

    facts: Facts
    layout: Layout
    pairs: Mapping[Pair, bool]
    sure: bool
    place: Gaze
    held: Held | None = None
    walked_m: float = 0.0

    @property
    def holding(self) -> Mapping[Pair, bool]:
        """The pairs that hold, of what is in the hand, too."""
        return self.pairs if self.held is None else {**self.pairs, **self.held.pairs}


def setting_of(
    scene: Scene, household: Household, catalog: Catalog, library: Library, client: Client
) -> Setting:
    """What mending a scene goes by, all of it from the scene itself."""
    traits = {one.name: one.properties for one in catalog.categories}
    furniture = bodies_of([item for item in scene.objects if item.fixed], library.infos)
    arms = Arms(scene)
    context = HomeContext(
        scene.home,
        scene.zones,
        catalog,
        lambda _: (),
        Reach(catalog, furniture),
        narrow=narrow_floor(scene.home, furniture, traits),
        standing=union(floor_obstacles(furniture)),
        free=arms.floor.shape,
    )
    return Setting(catalog, library, client, household, context, arms)


def start_of(scene: Scene, setting: Setting) -> State:
    """A scene as it is found, the agent where it begins."""
    facts = facts_of(scene, setting.library.infos, setting.catalog)
    looked_at = [one.name for one in setting.catalog.categories if "LOOKABLE" in one.properties]
    empty = Layout(setting.library, iter(()), frozenset(looked_at))
    place = setting.arms.start(scene)
    return judged(setting, State(facts, stocked(empty, scene.objects), {}, True, place))


def judged(setting: Setting, state: State) -> State:
    """The state with the pairs that its facts say."""
    found = survey(state.facts, setting.catalog).positives
    pairs = {(one.object_id, one.hazard): _told(one, state.facts, setting) for one in found}
    sure = all(one.verdict.sure for one in found)
    return replace(state, pairs=pairs, sure=sure)


def _told(one: Positive, facts: Facts, setting: Setting) -> bool:
    hazard = setting.catalog.hazard(one.hazard)
    # Of what is in doubt not all may have been measured.
    evidence = {**hazard.predicate.measure(one.object_id, facts), **one.verdict.evidence}
    room = facts.room_type(one.object_id)
    return decide(hazard, evidence, setting.household, setting.catalog.reach, room).report


def with_facts(setting: Setting, state: State, facts: Facts) -> State:
    """The state of a scene whose facts are these."""
    layout = stocked(state.layout, facts.scene.objects)
    return judged(setting, replace(state, facts=facts, layout=layout))


def changed(setting: Setting, state: State, changes: After) -> State | str:
    """The state after these objects have changed where they stand, or are gone; why not, where
    something would lose its hold or cut into something."""
    library = setting.library
    facts = facts_after(state.facts, changes, library.infos, setting.catalog)
    fallen = lost(state.facts, facts)
    if fallen is not None:
        return f"{called(facts, fallen)} would fall"
    objection = check_standing(state.facts.scene, facts, library, setting.client)
    if objection is not None:
        what = " and ".join(called(facts, key) for key in objection.objects) or "something"
        return f"{what}: {objection.cause.check.replace('_', ' ')}"
    return with_facts(setting, state, facts)


def lost(before: Facts, after: Facts) -> int | None:
    """What rests on nothing since, or None."""
    found = list(unheld(after))
    return next((key for key in found if key not in set(unheld(before))), None) if found else None


def called(facts: Facts, key: int) -> str:
    """An object, or a floor, in words."""
    if key in facts.bodies or key in facts.structures:
        return f"the {facts.category(key).replace('_', ' ')} {key}"
    return f"{key}"
