"""What a model's record can get wrong although every value has its type.

Names that point nowhere, numbers that no thing of this world has, and a licence under which a data
set could not be passed on.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator
from itertools import chain

from shapely.geometry import Polygon

from sdgen.errors import did_you_mean
from sdgen.library.licences import LICENCES, NON_COMMERCIAL
from sdgen.library.records import Asset
from sdgen.yaml_source import Path_

#: Mass per volume of the bounding box, kg/m3. Steel is 7,850 and no household thing is a full box
#: of it; paper and wire frames have a few (shipped: 1.3, an open umbrella, to 2,040, a fork).
DENSITY_KG_M3 = (0.5, 8000.0)
#: Thinner than this a box's volume says nothing (a sheet of paper drawn with no thickness).
_THIN_M = 0.001
#: A direction written with three digits is off by less.
_UNIT_SLACK = 0.01
#: No furniture is longer, metres.
_LONGEST_M = 10.0
#: ``part.png`` has eight bits a pixel for the drawn part seen there, 0 for none.
MAX_DRAWN = 255

Found = Iterator[tuple[Path_, str]]


def inconsistencies(asset: Asset) -> Found:
    """Everything wrong with a record: key path and problem."""
    return chain.from_iterable(check(asset) for check in _CHECKS)


def _body(asset: Asset) -> Found:
    if asset.licence not in (*LICENCES, *NON_COMMERCIAL):
        known = f"one of: {', '.join((*LICENCES, *NON_COMMERCIAL))}"
        yield ("licence",), f"{asset.licence!r} lets nobody pass a data set on ({known})"
    if not all(0 < size < _LONGEST_M for size in asset.extents_m):
        yield ("extents_m",), f"{asset.extents_m} is not a size in metres"
        return
    volume = math.prod(max(size, _THIN_M) for size in asset.extents_m)
    low, high = (density * volume for density in DENSITY_KG_M3)
    if not low <= asset.mass_kg <= high:
        text = f"{asset.mass_kg:g} kg in {volume:.3g} m3 is {asset.mass_kg / volume:.3g} kg/m3"
        yield ("mass_kg",), f"{text}; a thing of this size has {low:.2g} to {high:.2g} kg"
    for index, pose in enumerate(asset.resting):
        if abs(math.hypot(*pose.up) - 1.0) > _UNIT_SLACK:
            yield ("resting", index, "up"), f"{list(pose.up)} is not a direction of length 1"


def _names(asset: Asset) -> Found:
    parts = [part.name for part in asset.parts]
    joints = [joint.name for joint in asset.joints]
    containers = [container.name for container in asset.containers]
    no_part, no_joint = _missing("part", parts), _missing("joint", joints)
    if len(set(parts)) != len(parts):
        yield ("parts",), "a name appears twice"
    if "default" not in asset.variants:
        yield ("variants",), "'default' is missing"
    for variant, names in asset.variants.items():
        for index, name in enumerate(names):
            yield from no_part(("variants", variant, index), name)
        if not names:
            yield ("variants", variant), "draws nothing"
        if len(names) > MAX_DRAWN:
            text = f"draws {len(names)} parts; a variant draws at most {MAX_DRAWN}"
            yield ("variants", variant), text
    for index, part in enumerate(asset.parts):
        yield from no_joint(("parts", index, "joint"), part.joint)
    for index, rule in enumerate(asset.states):
        yield from no_joint(("states", index, "joint"), rule.joint)
        for k, name in enumerate(rule.variants):
            path = ("states", index, "variants", k)
            yield from _missing("variant", list(asset.variants))(path, name)
        for k, name in enumerate(rule.parts):
            yield from no_part(("states", index, "parts", k), name)
    for index, support in enumerate(asset.supports):
        yield from no_part(("supports", index, "part"), support.part)
        no_container = _missing("container", containers)
        yield from no_container(("supports", index, "container"), support.container)
    for index, container in enumerate(asset.containers):
        yield from no_part(("containers", index, "part"), container.part)
        yield from no_joint(("containers", index, "closed_by"), container.closed_by)


def _missing(what: str, known: Collection[str]) -> Callable[[Path_, str | None], Found]:
    def check(path: Path_, name: str | None) -> Found:
        if name is not None and name not in known:
            yield path, f"no {what} {name!r}{did_you_mean(name, sorted(known))}"

    return check


def _shapes(asset: Asset) -> Found:
    for index, joint in enumerate(asset.joints):
        if joint.lower > joint.upper:
            yield ("joints", index, "lower"), f"{joint.lower:g} is above upper ({joint.upper:g})"
        if math.hypot(*joint.axis) < 1e-6:
            yield ("joints", index, "axis"), "axis has no direction"
    for index, support in enumerate(asset.supports):
        if len(support.polygon_m) < 3 or not Polygon(support.polygon_m).is_valid:
            yield ("supports", index, "polygon_m"), "polygon_m is no simple polygon"


_CHECKS = (_names, _shapes, _body)
