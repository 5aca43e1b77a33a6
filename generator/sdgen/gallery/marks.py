"""What was measured of a thing, as lines, regions and boxes that a viewer draws."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from sdgen.catalog.terms import DistanceTerm, HeightTerm, Term, ZoneTerm
from sdgen.facts import Facts
from sdgen.gallery.words import plain, split_key
from sdgen.scene import BoundingBox, EvidenceValue, Zone

#: By the id of what it names: what that is to the thing.
_OTHERS = {
    "target_id": "",
    "climbed_id": "can be climbed on",
    "nearest_id": "",
    "above_id": "below it",
    "facing_id": "faced",
    "away_from_id": "turned away from",
}
Mark = dict[str, Any]


def marks_of(
    object_id: int,
    evidence: Mapping[str, EvidenceValue],
    predicate: Term | None,
    facts: Facts,
    boxes: Mapping[int, BoundingBox],
) -> list[Mark]:
    """Heights, distances, angles, zones and other things that an anomaly or a near miss hangs on.

    ``line``: from, to (metres) and a text; ``height``: a line up to the thing, and the limits of
    the rule; ``zone``: a polygon between two heights, and what share of the thing lies in it;
    ``thing``: another one, by its id.
    """
    leaves = list(_leaves(predicate)) if predicate is not None else []
    groups: dict[str, dict[str, EvidenceValue]] = {}
    for key, value in evidence.items():
        base, number = split_key(key)
        groups.setdefault(number, {})[base] = value
    # Floors and walls are there anyway.
    things = {key: box for key, box in boxes.items() if key in facts.bodies}
    out: list[Mark] = []
    for group in groups.values():
        out += _heights(object_id, group, leaves, boxes)
        out += _others(object_id, group, leaves, things)
    named = {str(group["zone_name"]) for group in groups.values() if "zone_name" in group}
    share = next(
        (group["zone_overlap"] for group in groups.values() if "zone_overlap" in group), None
    )
    low, _ = _corners(boxes[object_id])
    at = _rounded((*boxes[object_id].center[:2], low[2]))
    for zone in _zones(object_id, named, leaves, facts):
        text = plain(zone.kind)
        out.append(
            _zone(zone) | {"at": at, "text": text if share is None else f"{text} {share:.0%}"}
        )
    return out


def _leaves(term: Term) -> Iterator[Term]:
    below = term.within()
    if not below:
        yield term
    for one in below:
        yield from _leaves(one)


def _heights(
    object_id: int,
    group: Mapping[str, EvidenceValue],
    leaves: list[Term],
    boxes: Mapping[int, BoundingBox],
) -> Iterator[Mark]:
    low, _ = _corners(boxes[object_id])
    for key in ("reach_height_m", "height_m"):
        if key not in group:
            continue
        limits = [t for t in leaves if isinstance(t, HeightTerm) and t.evidence == key]
        start = low[2] - float(group[key])
        words = "height" if key == "height_m" or "climbed_id" not in group else "for a child"
        yield {
            "kind": "height",
            "at": _rounded(boxes[object_id].center[:2]),
            "from": round(start, 3),
            "to": round(low[2], 3),
            "text": f"{words} {group[key]:.2f} m",
            "limits": [
                {"z": round(start + limit, 3), "text": f"{word} {limit:g} m"}
                for term in limits
                for word, limit in (("at most", term.max_m), ("at least", term.min_m))
                if limit is not None
            ],
        }


def _others(
    object_id: int,
    group: Mapping[str, EvidenceValue],
    leaves: list[Term],
    boxes: Mapping[int, BoundingBox],
) -> Iterator[Mark]:
    for key, words in _OTHERS.items():
        other = group.get(key)
        if not isinstance(other, int) or other not in boxes or other == object_id:
            continue
        yield {"kind": "thing", "id": other, "text": words}
        if key == "nearest_id" and "distance_m" in group:
            limit = next(
                (t.max_m for t in leaves if isinstance(t, DistanceTerm) and t.max_m is not None),
                None,
            )
            text = f"{group['distance_m']:.2f} m"
            text += f" (at most {limit:g} m)" if limit is not None else ""
            yield _line(*_nearest(boxes[object_id], boxes[other]), text)
        elif key == "above_id":
            text = f"{group.get('above_drop_m', 0.0):.2f} m higher"
            yield _line(*_nearest(boxes[object_id], boxes[other]), text)
        elif key in ("facing_id", "away_from_id"):
            angle = group.get("facing_deg", group.get("away_deg"))
            here, there = (np.array(boxes[k].center) for k in (object_id, other))
            yield _line(here, there, f"{angle:.0f}°" if angle is not None else "")


def _zones(object_id: int, named: set[str], leaves: list[Term], facts: Facts) -> list[Zone]:
    """The zones that evidence names; of a near miss those that most of the thing lies in."""
    for term in leaves:
        if not named and isinstance(term, ZoneTerm):
            shares = facts.zone_shares(object_id, term.any_of)
            named = {max(shares, key=lambda share: share.fraction).name} if shares else set()
    return [zone for zone in facts.scene.zones if zone.name in named]


def _zone(zone: Zone) -> Mark:
    return {
        "kind": "zone",
        "polygon": [_rounded(point) for point in zone.polygon_m],
        "low": round(zone.z_min_m, 3),
        "high": round(zone.z_max_m, 3),
    }


def _line(here: Any, there: Any, text: str) -> Mark:
    return {"kind": "line", "from": _rounded(here), "to": _rounded(there), "text": text}


def _nearest(a: BoundingBox, b: BoundingBox) -> tuple[Any, Any]:
    """Points of two boxes that are nearest to each other, in the middle of what they share."""
    (low_a, high_a), (low_b, high_b) = _corners(a), _corners(b)
    low, high = np.maximum(low_a, low_b), np.minimum(high_a, high_b)
    middle = (low + high) / 2
    here = np.where(low <= high, middle, np.clip(middle, low_a, high_a))
    there = np.where(low <= high, middle, np.clip(middle, low_b, high_b))
    return here, there


def _corners(box: BoundingBox) -> tuple[Any, Any]:
    middle, half = np.array(box.center), np.array(box.size) / 2
    return middle - half, middle + half


def _rounded(values: Any) -> list[float]:
    return [round(float(value), 3) for value in values]
