"""Lets a try's contents come to rest and says what does not stand as it was meant to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sdgen.facts import Facts, entered_structures, in_the_air, unheld
from sdgen.geometry import round_position, round_quat
from sdgen.hazards.certify import facts_of
from sdgen.library import Library
from sdgen.physics.checks import penetrations
from sdgen.physics.settle import Settled, moving, settle
from sdgen.physics.world import World
from sdgen.pipeline.contents import Contents
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.rejection import Rejection
from sdgen.scene import Pose

#: After things were taken away, the rest must stand as it stood: what touched them may play by
#: this much; what loses its support moves much further.
STILL_M = 0.003
#: A build allows this share of what validation allows, so that both agree on every machine.
STAYS_SHARE = 0.5


@dataclass(frozen=True)
class Rested:
    """Contents at rest, their poses rounded as written, with the facts of that scene.

    ``offenders`` maps the objects that did not come to rest where they were meant to be to why.
    """

    contents: Contents
    facts: Facts
    settled: Settled
    offenders: Mapping[int, Rejection]


def come_to_rest(
    index: int,
    home: FurnishedHome,
    contents: Contents,
    again: bool,
    library: Library,
    world: World,
) -> Rested:
    """Let everything loose fall, then look whether all of it stands, on its target, uncut.

    ``world`` is the try's own, and holds the contents at their rounded poses after it. ``again``:
    all of it stood already, and something else was taken away.
    """
    loose = {key for key, item in contents.items.items() if not item.fixed}
    world.become(home.scene(index, contents.items), loose)
    settled = settle(world)
    contents = contents.posed(
        {
            key: Pose(
                position_m=round_position(pose.position_m), quat_xyzw=round_quat(pose.quat_xyzw)
            )
            for key, pose in settled.poses.items()
        }
    )
    things = list(contents.items.values())
    contents = contents.housed(home.facts.rooms.room_ids(things, library.infos))
    scene = home.scene(index, contents.items)
    world.become(scene, loose)
    facts = facts_of(scene, library.infos, home.context.catalog, home.facts)
    offenders = _restless(contents, settled, again)
    offenders |= _off_target(contents, facts, offenders)
    if not offenders:
        for key in unheld(facts):
            offenders[key] = contents.objection(key, "physics", "rests_on_nothing")
        entered = entered_structures(facts)
        for violation in (*penetrations(world), *entered, *in_the_air(facts)):
            there = [k for k in violation.objects if k in contents.items]
            for key in [k for k in there if not contents.items[k].fixed] or there[:1]:
                offenders[key] = contents.objection(
                    key,
                    "physics",
                    violation.check,
                    measured=violation.measured,
                    limit=violation.limit,
                )
    return Rested(contents, facts, settled, offenders)


def will_not_stay(contents: Contents, world: World) -> dict[int, Rejection]:
    """What would move on if the written scene were loaded anew, as ``validate --physics`` does
    (which keeps all awake, at twice the limits).

    Settling lets go of what has been still for a moment: one thing in some ten thousand stands on
    an edge then, and tips later. ``world`` is the scene's, and of no use after it.
    """
    world.start_anew()
    found = {}
    for violation in moving(world, STAYS_SHARE, all_awake=False):
        (key,) = violation.objects
        found[key] = contents.objection(
            key, "physics", violation.check, measured=violation.measured, limit=violation.limit
        )
    return found


def _restless(contents: Contents, settled: Settled, again: bool) -> dict[int, Rejection]:
    """What fell, tipped or kept moving, or moved although it had stood before."""
    offenders: dict[int, Rejection] = {}
    for key, drift in settled.drift_m.items():
        if again and drift > STILL_M:
            offenders[key] = contents.objection(
                key, "physics", "moved_again", measured=drift, limit=STILL_M
            )
        elif key in settled.unstable:
            # It fell (m) or tipped (rad) too far; what was still moving has no measure.
            measured, limit = settled.beyond(key) or (None, None)
            offenders[key] = contents.objection(
                key, "physics", "would_not_stand", measured=measured, limit=limit
            )
    return offenders


def _off_target(
    contents: Contents, facts: Facts, offenders: Mapping[int, Rejection]
) -> dict[int, Rejection]:
    """What surely no longer is on or in what it was put on or into."""
    left: dict[int, Rejection] = {}
    for key, intent in contents.intents.items():
        if key in offenders or contents.items[key].fixed:
            continue
        related = facts.related(key, intent.relation)
        if not any(r.target_id == intent.target_id and r.holds and r.sure for r in related):
            left[key] = contents.objection(key, "physics", f"not_{intent.relation.lower()}_target")
    return left
