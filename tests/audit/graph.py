"""The graph's relations, computed again from meshes, outside of the documented margins."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
import shapely

from tests.audit.dataset import Finding, Scene, Thing

Floats = npt.NDArray[np.float64]

BOX_M = 0.012


def boxes(scene: Scene) -> Iterator[Finding]:
    """``bounding_box`` against the box of all that is drawn."""
    for thing in scene.things.values():
        told = scene.nodes[thing.id]["bounding_box"]
        middle, half = np.array(told["center"]), np.array(told["size"]) / 2
        off = float(np.abs(np.stack([middle - half, middle + half]) - thing.box).max())
        if off > BOX_M:
            yield scene.found(thing, f"box is not its mesh's ({' '.join(thing.states)})", off)


def close(scene: Scene) -> Iterator[Finding]:
    """CLOSE: boxes (as the graph tells them) less than 1.5 m apart, in one room."""
    things = list(scene.things.values())
    told = [scene.nodes[t.id]["bounding_box"] for t in things]
    middle = np.array([box["center"] for box in told])
    half = np.array([box["size"] for box in told]) / 2
    apart = np.abs(middle[:, None] - middle) - half[:, None] - half
    gaps = np.linalg.norm(np.maximum(apart, 0), axis=2)
    for i, a in enumerate(things):
        for j, b in enumerate(things):
            if i == j or a.room != b.room:
                continue
            edge = (a.id, "CLOSE", b.id) in scene.edges
            if (gaps[i, j] < 1.44 and not edge) or (gaps[i, j] > 1.56 and edge):
                word = "CLOSE" if edge else "not CLOSE"
                yield scene.found(a, f"{word} to {b.category} {b.id}", float(gaps[i, j]))


def surfaces(thing: Thing) -> list[tuple[shapely.Geometry, float]]:
    """The level surfaces of a model where it stands: outline from above and height."""
    found = []
    by_name = {part.name: part for part in thing.parts}
    for support in thing.record["supports"]:
        part = by_name.get(support["part"])
        if part is None:
            continue
        ring = np.array([[x, y, support["z_m"]] for x, y in support["polygon_m"]])
        world = part.world(ring)
        if np.ptp(world[:, 2]) <= 0.015:
            found.append((shapely.Polygon(world[:, :2]).buffer(0), float(world[:, 2].max())))
    return found


def on(scene: Scene) -> Iterator[Finding]:
    """ON furniture: within a centimetre over a surface that lies below half of the footprint."""
    holders = [(t, surfaces(t)) for t in scene.furniture]
    for thing in scene.small:
        area = thing.footprint.area or 1e-9
        told = set(scene.on.get(thing.id, []))
        best: tuple[float, int] | None = None
        unsure = False
        for holder, tops in holders:
            for outline, height in tops:
                rise = thing.bottom - height
                if not -0.02 <= rise <= 0.02:
                    continue
                share = outline.intersection(thing.footprint).area / area
                if rise <= 0.007 and share > 0.62:
                    if best is None or height > best[0]:
                        best = (height, holder.id)
                elif share > 0.38:
                    unsure = True
        elsewhere = scene.inside.get(thing.id) or told & {t.id for t in scene.small}
        if best and not unsure and not elsewhere and best[1] not in told:
            other = scene.things[best[1]]
            yield scene.found(thing, f"not ON {other.category} {other.id}", best[0])
        for b in told & {t.id for t in scene.furniture}:
            tops = surfaces(scene.things[b])
            rises = [
                thing.bottom - height
                for outline, height in tops
                if outline.intersection(thing.footprint).area / area > 0.38
            ]
            if not any(-0.03 <= rise <= 0.02 for rise in rises):
                yield scene.found(thing, f"ON {scene.things[b].category} {b} and not over it")


def inside(scene: Scene) -> Iterator[Finding]:
    """INSIDE: the middle lies in a hollow of the holder."""
    hollows = []
    for holder in scene.things.values():
        for hollow in holder.record["containers"]:
            part = next((p for p in holder.parts if p.name == hollow["part"]), None)
            if part is not None:
                hollows.append((holder, part, hollow))
    for thing in scene.small:
        middle = ((thing.box[0] + thing.box[1]) / 2)[None]
        told = set(scene.inside.get(thing.id, []))
        deep: dict[int, float] = {}
        for holder, part, hollow in hollows:
            if holder.id != thing.id:
                away = np.abs(part.local(middle)[0] - hollow["center_m"])
                depth = float((np.array(hollow["size_m"]) / 2 - away).min())
                deep[holder.id] = max(deep.get(holder.id, -9.0), depth)
        for id, depth in deep.items():
            if (depth > 0.015 and id not in told) or (depth < -0.015 and id in told):
                word = "INSIDE" if id in told else "not INSIDE"
                yield scene.found(thing, f"{word} {scene.things[id].category} {id}", depth)


def facing(scene: Scene) -> Iterator[Finding]:
    """FACING of seats: less than 75 degrees between front and what is looked at, in one room."""
    seats = [t for t in scene.furniture if t.has("SITTABLE", scene.catalogue)]
    shown = [t for t in scene.things.values() if t.has("LOOKABLE", scene.catalogue)]
    for seat in seats:
        for other in shown:
            if seat.room != other.room or seat.id == other.id:
                continue
            middles = [(t.box[0] + t.box[1])[:2] / 2 for t in (seat, other)]
            towards = middles[1] - middles[0]
            if np.linalg.norm(towards) < 0.1:
                continue
            cosine = seat.front[:2] @ towards / np.linalg.norm(towards)
            angle = float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))
            told = (seat.id, "FACING", other.id) in scene.edges
            if (angle < 65 and not told) or (angle > 85 and told):
                word = "FACING" if told else "not FACING"
                yield scene.found(seat, f"{word} {other.category} {other.id}", angle)


def zones(scene: Scene) -> Iterator[Finding]:
    """IN_DOORWAY, IN_WALKWAY and BLOCKS: half of the footprint in such zones."""
    shapes: dict[str, list[shapely.Geometry]] = {"doorway": [], "walkway": []}
    doorways: dict[int, list[shapely.Geometry]] = {}
    for zone in scene.scene["zones"]:
        shape = shapely.Polygon(zone["polygon_m"]).buffer(0)
        if zone["kind"] in shapes:
            shapes[zone["kind"]].append(shape)
        if zone["kind"] in {"doorway", "swing"}:  # a door blocked from opening is blocked
            doorways.setdefault(zone["source_id"], []).append(shape)
    union = {kind: shapely.union_all(found) for kind, found in shapes.items()}
    for thing in scene.small:
        low = thing.bottom < 0.45  # doorways and walkways end at the knee
        area = thing.footprint.area or 1e-9
        for kind, shape in union.items():
            share = thing.footprint.intersection(shape).area / area if low else 0.0
            told = f"IN_{kind.upper()}" in scene.nodes[thing.id]["tags"]
            # The package takes outlines of few points; half a thing is half a thing within 6 %.
            if abs(thing.bottom - 0.5) > 0.06 and (share < 0.44 if told else share > 0.56):
                yield scene.found(thing, f"{'' if told else 'not '}IN_{kind.upper()}", share)
        for door, found in doorways.items():
            share = thing.footprint.intersection(shapely.union_all(found)).area / area
            told = (thing.id, "BLOCKS", door) in scene.edges
            sure = thing.height > 0.036 and share > 0.66 and low
            if (told and (share < 0.34 or thing.height < 0.024)) or (sure and not told):
                yield scene.found(thing, f"{'' if told else 'not '}BLOCKS door {door}", share)
