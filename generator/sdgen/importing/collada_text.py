"""Makes COLLADA files of strangers ready for pycollada, which drops what it cannot resolve.

https://www.khronos.org/files/collada_spec_1_4.pdf. A geometry whose material names a missing image
would vanish with it; here it loses the material alone.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from xml.etree.ElementTree import Element, tostring

from sdgen.errors import AssetError
from sdgen.importing.scan import Up
from sdgen.importing.tree import MAX_BYTES, References
from sdgen.importing.xml_text import parse_xml


def prepared(raw: bytes, shown: str, references: References) -> tuple[bytes, float, Up]:
    """The file without broken materials, metres of its unit, and its up axis, which trimesh does
    not apply. Raises AssetError, located, for what is no XML."""
    root = parse_xml(raw, shown, MAX_BYTES)
    if not any(True for _ in _named(root, "instance_visual_scene")):
        raise AssetError([f"{shown}: holds no scene"])
    metres, up = _asset(root)
    sound = _materials(root)
    lost: set[str] = set()
    for bound in _named(root, "technique_common"):
        for use in [child for child in bound if _tag(child) == "instance_material"]:
            target = use.get("target", "").removeprefix("#")
            if target not in sound:
                lost.add(target)
                bound.remove(use)
    if not lost:
        return raw, metres, up
    names = ", ".join(sorted(lost)[:3])
    references.note(f"{shown}: materials that lead nowhere, left out: {names}")
    return tostring(root), metres, up


def _asset(root: Element) -> tuple[float, Up]:
    metres = 1.0
    for unit in _named(root, "unit"):
        try:
            metres = float(unit.get("meter", "1"))
        except ValueError:
            metres = 1.0
        break
    if not math.isfinite(metres) or metres <= 0:
        metres = 1.0
    axis = next((element.text or "" for element in _named(root, "up_axis")), "")
    return metres, "z" if axis.strip() == "Z_UP" else "y"


def _materials(root: Element) -> set[str]:
    """Ids of the materials all of whose effects and images are there."""
    images = {image.get("id", "") for image in _named(root, "image") if _init_from(image)}
    effects = {
        effect.get("id", "")
        for effect in _named(root, "effect")
        if all(_init_from(surface) in images for surface in _named(effect, "surface"))
    }
    return {
        material.get("id", "")
        for material in _named(root, "material")
        if any(
            instance.get("url", "").removeprefix("#") in effects
            for instance in _named(material, "instance_effect")
        )
    }


def _init_from(element: Element) -> str:
    """What an image or a surface is made from: a text, in COLLADA 1.5 that of a child."""
    for init in _named(element, "init_from"):
        return "".join(init.itertext()).strip()
    return ""


def _named(element: Element, tag: str) -> Iterator[Element]:
    """Elements below one, by their name without the namespace."""
    return (child for child in element.iter() if _tag(child) == tag)


def _tag(element: Element) -> str:
    return element.tag.rsplit("}", 1)[-1] if isinstance(element.tag, str) else ""
