"""A home as an agent finds and changes it: what stands in its way, what it opens and shuts."""

from __future__ import annotations

from shapely.geometry import Point

from sdgen.actions import settled_states
from sdgen.agent.walk import Floor
from sdgen.facts import Body, Measured, bodies_of
from sdgen.geometry import Vec2
from sdgen.hazards.twin import with_changes
from sdgen.library import Library
from sdgen.library.records import AssetInfo, Joint
from sdgen.scene import ObjectInstance, Scene
from sdgen.zones import floor_obstacles


class House:
    """A scene that changes as things are opened and shut."""

    def __init__(self, scene: Scene, library: Library) -> None:
        self._library = library
        self._become(scene)

    def _become(self, scene: Scene) -> None:
        self.scene = scene
        bodies = bodies_of(scene.objects, self._library.infos)
        self.bodies: dict[int, Body] = {body.item.id: body for body in bodies}
        self.floor = Floor(scene, floor_obstacles(self.bodies.values()))

    def away_m(self, point: Vec2, key: int) -> float:
        """How far a thing is from a point of the floor, on the plan."""
        return float(self.bodies[key].footprint.distance(Point(point)))

    def moved(self, key: int, opening: bool, point: Vec2) -> str | None:
        """Open the first leaf or drawer of a thing that is shut, or shut all of them, with what is
        in them, while the agent stands at a point. Why that cannot be, else None."""
        item = self.bodies[key].item
        info = self._library.info(item.asset)
        joints = _opened(item, info) if opening else _shut(item, info)
        if joints is None:
            has = any(_opens(joint, info) for joint in info.joints)
            if not has:
                return f"a {_words(item)} cannot be {'opened' if opening else 'shut'}"
            return f"the {_words(item)} is {'open' if opening else 'shut'} already"
        after = settled_states(item.model_copy(update={"joints": joints}), info)
        infos = self._library.infos
        measured = Measured(self.scene, infos)
        objects = with_changes(self.scene, {key: after}, infos, measured)
        before = self.scene
        self._become(before.model_copy(update={"objects": objects}))
        if not self.floor.holds(point):
            self._become(before)
            return f"the agent stands in the way of the {_words(item)}"
        return None


def _opens(joint: Joint, info: AssetInfo) -> bool:
    return any(rule.state == "OPEN" and rule.joint == joint.name for rule in info.states)


def _opened(item: ObjectInstance, info: AssetInfo) -> dict[str, float] | None:
    """Joint values with the first one that is shut wide open; None where there is none."""
    for joint in info.joints:
        least = [r.min for r in info.states if r.state == "OPEN" and r.joint == joint.name]
        if least and item.joints.get(joint.name, 0.0) < (least[0] or 0.0):
            return {**item.joints, joint.name: joint.upper}
    return None


def _shut(item: ObjectInstance, info: AssetInfo) -> dict[str, float] | None:
    """Joint values with all that opens shut; None where it is so already."""
    shut = {j.name: max(0.0, j.lower) for j in info.joints if _opens(j, info)}
    if not shut or all(item.joints.get(name, 0.0) == value for name, value in shut.items()):
        return None
    return {**item.joints, **shut}


def _words(item: ObjectInstance) -> str:
    return item.category.replace("_", " ")
