"""The links of a URDF and the joints between them, as the file has them.

http://wiki.ros.org/urdf/XML. Metres and radians.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from xml.etree.ElementTree import Element

import numpy as np

from sdgen.geometry import Array
from sdgen.importing import shapes

#: Links that hang on links.
_DEEPEST = 200


@dataclass(frozen=True)
class UrdfTree:
    """Links by their names, and joints by the names of the links that they move."""

    root: Element
    links: Mapping[str, Element]
    joints: Mapping[str, Element]

    def chain(self, link: str) -> list[Element]:
        """The joints from the root to a link. Raises ValueError when they never end."""
        out: list[Element] = []
        while link in self.joints:
            joint = self.joints[link]
            out.append(joint)
            link = name_in(joint.find("parent"), "link")
            if len(out) > _DEEPEST:
                name = joint.get("name")
                raise ValueError(f"joint {name!r}: links go round in a circle, or on without end")
        return out[::-1]

    def placed(self, link: str) -> Array:
        """Where a link is in the root's frame with every joint at 0, 4x4.

        Raises ValueError where the joints are broken.
        """
        at = np.eye(4)
        for joint in self.chain(link):
            at = at @ origin(joint)
        return at


def urdf_tree(root: Element) -> UrdfTree:
    """The links of a file. Raises ValueError for what is no URDF."""
    if root.tag != "robot":
        raise ValueError(f"is no URDF: its root is <{root.tag[:40]}>")
    return UrdfTree(
        root,
        {link.get("name", ""): link for link in root.findall("link")},
        {name_in(joint.find("child"), "link"): joint for joint in root.findall("joint")},
    )


def origin(element: Element) -> Array:
    """Where a joint or a visual is in its link, 4x4, quarter turns made exact."""
    found = element.find("origin")
    at = numbers(found, "xyz", (0.0, 0.0, 0.0))
    turn = numbers(found, "rpy", (0.0, 0.0, 0.0))
    return shapes.pose(at, shapes.rpy(turn))


def numbers(element: Element | None, key: str, default: tuple[float, ...]) -> tuple[float, ...]:
    """Finite numbers of an attribute, as many as its ``default`` has. Raises ValueError."""
    text = element.get(key) if element is not None else None
    if element is None or text is None or not text.strip():
        return default
    try:
        values = tuple(float(word) for word in text.replace(",", " ").split())
    except ValueError:
        values = ()
    if len(values) != len(default) or not all(map(math.isfinite, values)):
        raise ValueError(f"{element.tag} {key}: {text[:60]!r} is not {len(default)} finite numbers")
    return values


def name_in(element: Element | None, key: str) -> str:
    """The name that an attribute says; empty when there is none."""
    return element.get(key, "") if element is not None else ""
