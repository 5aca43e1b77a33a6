"""What cannot be in a real home: things in the air, in walls, in one another."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
import shapely

from tests.audit.dataset import MATS, Finding, Part, Scene, Thing
from tests.audit.meshes import depths, drop, spread

Floats = npt.NDArray[np.float64]

#: Solid things may share this much, metres: what a person does not see.
PENETRATION_M = 0.005
#: Cloth gives way and sinks in: so much of it is not seen, metres.
YIELDING_M = 0.015
CLOTH = {"clothes_pile", "towel", "blanket", "cushion", "hat", "rubber_gloves", "teddy_bear"} | {
    "backpack",
    "handbag",
    "slippers",
}
#: A gap that is seen, metres.
FLOATING_M = 0.01
#: A flat-woven rug of up to this thickness gives way under a leg, metres.
PILE_M = 0.005
#: Crumbs smaller than this are not looked at, metres.
CRUMB_M = 0.006
#: A piece whose middle is this far beyond what bears it would tip, metres.
TIPPING_M = 0.005
SAMPLES = 400


def overlap(a: Floats, b: Floats, by: float) -> bool:
    """Whether two boxes share more than ``by`` metres along every axis."""
    # Half a million times a data set: as plain numbers in a third of the time.
    (a_low, a_high), (b_low, b_high) = a.tolist(), b.tolist()
    return all(min(a_high[k], b_high[k]) - max(a_low[k], b_low[k]) > by for k in range(len(a_low)))


def over(part: Part, box: Floats) -> Floats:
    """Triangles of a part that lie over or under a box, and not wholly above it."""
    triangles = part.triangles
    least, most = triangles.min(1), triangles.max(1)
    near = (least[:, :2] <= box[1, :2]).all(1) & (most[:, :2] >= box[0, :2]).all(1)
    return triangles[near & (most[:, 2] >= box[0, 2] - 0.5) & (least[:, 2] <= box[1, 2])]


def below(scene: Scene, thing: Thing) -> Floats:
    """All triangles of other things that could carry a thing, (F, 3, 3)."""
    reach = thing.box + np.array([[0, 0, -FLOATING_M], [0, 0, 0]])
    found = [
        over(part, reach)
        for other in scene.things.values()
        if other.id != thing.id and overlap(reach, other.box, 0)
        for part in other.parts
        if overlap(reach, part.box, 0)
    ]
    return np.concatenate(found) if found else np.zeros((0, 3, 3))


def heights_above(points: Floats, triangles: Floats) -> Floats:
    """How high each point is over what is under it, the floor at 0 too."""
    return np.minimum(points[:, 2], drop(points, triangles))


def floating(scene: Scene) -> Iterator[Finding]:
    """Loose things that nothing carries within a centimetre."""
    for thing in scene.small:
        if thing.bottom <= FLOATING_M:
            continue
        points = np.concatenate([part.vertices for part in thing.parts])
        triangles = below(scene, thing)
        low = points[np.argsort(points[:, 2], kind="stable")[:60]]
        if heights_above(low, triangles).min() <= FLOATING_M:
            continue
        dense = np.concatenate([part.world(part.mesh.samples[0]) for part in thing.parts])
        dense = np.concatenate([points, dense])
        gap = float(heights_above(dense[:: max(1, len(dense) // SAMPLES)], triangles).min())
        if gap > FLOATING_M:
            yield scene.found(thing, "in the air", gap)


def shards_in_air(scene: Scene) -> Iterator[Finding]:
    """Pieces of a broken thing that lie on nothing, or would tip over the edge they lie on."""
    for thing in scene.small:
        if "BROKEN" not in thing.states:
            continue
        triangles = below(scene, thing)
        for part in thing.parts:
            if part.name != "shards":  # what is cracked hangs together
                continue
            hanging = []
            for faces in part.mesh.clusters:
                own = part.triangles[faces]
                if np.ptp(own.reshape(-1, 3), axis=0).max() < CRUMB_M:
                    continue
                rest = np.delete(part.triangles, faces, axis=0)
                points = np.concatenate([own.reshape(-1, 3), spread(own, 0.01)[0]])
                heights = heights_above(points, np.concatenate([triangles, rest]))
                borne = points[heights <= FLOATING_M][:, :2]
                ground = shapely.convex_hull(shapely.multipoints(borne)).buffer(TIPPING_M)
                if not ground.contains(shapely.Point(points[:, :2].mean(0))):
                    hanging.append(float(heights.min()))
            if hanging:
                what = f"{len(hanging)} pieces of its {part.name} in the air"
                yield scene.found(thing, what, max(hanging))


def into_walls(scene: Scene) -> Iterator[Finding]:
    """Things and furniture that enter a wall, a ceiling or the floor."""
    walls, ceilings = scene.boxes("wall"), scene.boxes("ceiling")
    for thing in scene.things.values():
        for part in thing.parts:
            if scene.is_opening(thing) and part.joint is None:
                continue  # a frame is in its wall
            # Hinges are let into the frame: leaves of doors may touch the wall they hang in.
            least = 0.03 if scene.is_opening(thing) else PENETRATION_M
            for name, boxes in (("a wall", walls), ("the ceiling", ceilings)):
                near = [box for box in boxes if overlap(box, part.box, least)]
                if near:
                    points = np.concatenate([part.vertices, part.world(part.mesh.samples[0])])
                    deepest = max(depth_in_box(points, box) for box in near)
                    if deepest > least:
                        yield scene.found(thing, f"{part.name} in {name}", deepest)
            if part.box[0, 2] < -PENETRATION_M:
                yield scene.found(thing, f"{part.name} in the floor", -part.box[0, 2])


def depth_in_box(points: Floats, box: Floats) -> float:
    """How deep the deepest point lies in a flat box: measured across its thinnest side."""
    thin = int(np.argmin(box[1] - box[0]))
    within = ((points >= box[0]) & (points <= box[1])).all(1)
    if not within.any():
        return 0.0
    across = points[within, thin]
    return float(np.minimum(across - box[0, thin], box[1, thin] - across).max())


def penetration(a: Thing, b: Thing, least: float = PENETRATION_M) -> tuple[float, str]:
    """The greatest depth of a sample of one in a part of the other, and which parts."""
    worst, where = 0.0, ""
    for part in a.solids:
        for other in b.solids:
            if not overlap(part.box, other.box, least):
                continue
            for inner, outer, name in ((part, other, b.category), (other, part, a.category)):
                if name in CLOTH:  # cloth is no solid, and piles of it have no underside
                    continue
                points = np.concatenate([inner.vertices, inner.world(inner.mesh.samples[0])])
                depth = deepest(points, outer, least)
                if depth > worst:
                    worst, where = depth, f"{part.name} and {other.name}"
    return worst, where


def deepest(points: npt.NDArray[np.float64], part: Part, least: float) -> float:
    """How deep the deepest of some points (N, 3) of the world lies in a part's mesh, metres; 0 for
    less than ``least``."""
    near = ((points > part.box[0]) & (points < part.box[1])).all(1)
    return float(depths(part.local(points[near]), part.mesh, least).max()) if near.any() else 0.0


def entangled(scene: Scene) -> Iterator[Finding]:
    """Small things that stand in other things."""
    things = list(scene.things.values())
    for i, a in enumerate(things):
        for b in things[i + 1 :]:
            if (a.fixed and b.fixed) or not overlap(a.box, b.box, PENETRATION_M):
                continue
            least = YIELDING_M if {a.category, b.category} & CLOTH else PENETRATION_M
            depth, where = penetration(a, b, least)
            if depth > least:
                thing, other = (b, a) if a.fixed else (a, b)
                yield scene.found(thing, f"in {other.category} {other.id}: {where}", depth)


def furniture_in_furniture(scene: Scene) -> Iterator[Finding]:
    """Furniture, lamps, leaves and drawers that stand in other furniture, doors or windows."""
    things = [thing for thing in scene.things.values() if thing.fixed]
    for i, a in enumerate(things):
        for b in things[i + 1 :]:
            if MATS & {a.category, b.category} or (scene.is_opening(a) and scene.is_opening(b)):
                continue
            if overlap(a.box, b.box, PENETRATION_M):
                depth, where = penetration(a, b)
                if depth > PENETRATION_M:
                    yield scene.found(a, f"in {b.category} {b.id}: {where}", depth)


def through_rugs(scene: Scene) -> Iterator[Finding]:
    """What stands on the ground below a rug or a mat and so through it; leaves that sweep it."""
    flat = [t for t in scene.things.values() if t.category in MATS]
    for mat in flat:
        top = mat.box[1, 2]
        inner = mat.footprint.buffer(-0.01)
        for thing in scene.things.values():
            if thing.id == mat.id or thing.bottom > top - PILE_M:
                continue
            if not shapely.box(*thing.box[0, :2], *thing.box[1, :2]).intersects(inner):
                continue
            points = np.concatenate(
                [np.concatenate([p.vertices, p.world(p.mesh.samples[0])]) for p in thing.parts]
            )
            low = points[points[:, 2] < top - PILE_M]
            cut = low[shapely.contains_xy(inner, low[:, 0], low[:, 1])]
            if len(cut):
                depth = float(top - cut[:, 2].min())
                yield scene.found(thing, f"through {mat.category} {mat.id}", depth)
