"""A model for a thing of which only its box is known: the box, with the states it may have.

Its top carries things where the graph says that it has surfaces, the whole box holds them where it
is a container. What can be opened has a leaf on a joint that is at 0 when shut, what can be
switched on a glow; neither changes the box.
"""

from __future__ import annotations

from collections.abc import Collection

from sdgen.geometry import Vec2, Vec3
from sdgen.library.records import AssetInfo, Container, Joint, Part, StateRule, Support

#: Value of the joint of what stands open, and where OPEN begins and CLOSED ends.
OPEN_RAD, OPENS_RAD, SHUT_RAD = 1.5, 0.6, 0.03
#: Kilograms a cubic metre, of whatever a home holds: hollow furniture, packages, fruit.
DENSITY = 200.0
_LEAST_KG = 0.01


def box_model(
    name: str, category: str, extents_m: Vec3, properties: Collection[str], licence: str
) -> AssetInfo:
    """The record of the model ``name``: a box whose origin is the middle of its bottom."""
    x, y, z = extents_m
    opens, switches = "CAN_OPEN" in properties, "HAS_SWITCH" in properties
    parts = [Part(name="body", faces=12)]
    variants = {"default": ["body"], "on": ["body", "glow"]} if switches else {"default": ["body"]}
    states = []
    joints: tuple[Joint, ...] = ()
    if switches:
        parts.append(Part(name="glow", faces=12))
        states += [
            StateRule(state="ON", variants=("on",), parts=("glow",)),
            StateRule(state="OFF", variants=("default",), parts=("body",)),
        ]
    if opens:
        parts.append(Part(name="leaf", faces=12, joint="leaf"))
        for drawn in variants.values():
            drawn.append("leaf")
        joints = (
            Joint(
                name="leaf",
                type="revolute",
                origin_m=(x / 2, y / 2, 0.0),
                axis=(0.0, 0.0, 1.0),
                lower=0.0,
                upper=1.9,
            ),
        )
        states += [
            StateRule(state="CLOSED", joint="leaf", max=SHUT_RAD),
            StateRule(state="OPEN", joint="leaf", min=OPENS_RAD, parts=("leaf",)),
        ]
    outline = _rectangle(x, y)
    top = Support(name="top", part="body", z_m=z, polygon_m=outline)
    inside = Container(
        name="inside",
        part="body",
        center_m=(0.0, 0.0, z / 2),
        size_m=extents_m,
        closed_by="leaf" if opens else None,
    )
    return AssetInfo(
        id=name,
        category=category,
        licence=licence,
        source="virtualhome",
        extents_m=extents_m,
        outlines_m={part.name: (_corners(extents_m),) for part in parts if part.name != "leaf"},
        mass_kg=max(round(x * y * z * DENSITY, 3), _LEAST_KG),
        parts=tuple(parts),
        joints=joints,
        variants={key: tuple(drawn) for key, drawn in variants.items()},
        states=tuple(states),
        supports=(top,) if set(properties) & {"SURFACES", "SITTABLE", "LIEABLE"} else (),
        containers=(inside,) if "CONTAINERS" in properties else (),
    )


def _rectangle(x: float, y: float) -> tuple[Vec2, ...]:
    return ((-x / 2, -y / 2), (x / 2, -y / 2), (x / 2, y / 2), (-x / 2, y / 2))


def _corners(extents_m: Vec3) -> tuple[Vec3, ...]:
    x, y, z = extents_m
    return tuple((a, b, c) for a, b in _rectangle(x, y) for c in (0.0, z))
