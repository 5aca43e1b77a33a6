"""A further variant of a model: the parts of the default one again, in other textures.

The new parts are the same meshes under new names, so all that names a part (joints, supports,
containers, collision pieces, states) is given to them as well.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from sdgen.library.glb import glb_document
from sdgen.library.gltf import chunks_of, glb_of
from sdgen.library.records import Asset, Container, Part, StateRule, Support


def glows(part: Part) -> bool:
    """True for lamps and flames: no stain shows on what shines."""
    return max(part.rgba[:3]) > 1.5


def worn_parts(asset: Asset) -> tuple[Part, ...]:
    """The parts of the default variant that are retextured: all of it but what glows."""
    drawn = [asset.part(name) for name in asset.variants["default"]]
    return tuple(part for part in drawn if not glows(part)) or tuple(drawn)


def renamed(asset: Asset, word: str) -> dict[str, str]:
    """Names of the retextured parts -> of those that stand for them in the new variant."""
    return {part.name: f"{part.name}_{word}" for part in worn_parts(asset)}


def with_variant(asset: Asset, word: str, state: str, textures: Mapping[str, str]) -> Asset:
    """The record with a variant ``word``, which is ``state``; ``textures`` are files by part."""
    names = renamed(asset, word)
    added = [
        asset.part(old).model_copy(update={"name": new, "texture": textures[old]})
        for old, new in names.items()
    ]
    drawn = tuple(names.get(name, name) for name in asset.variants["default"])
    evidence = tuple(names.values())
    rules = [_also_of(rule, word, names) for rule in asset.states]
    rule = StateRule(state=state, variants=(word,), parts=evidence)
    return asset.model_copy(
        update={
            "parts": (*asset.parts, *added),
            "variants": {**asset.variants, word: drawn},
            "states": (*rules, rule),
            "supports": (*asset.supports, *_supports(asset, word, names)),
            "containers": (*asset.containers, *_containers(asset, word, names)),
        }
    )


def _also_of(rule: StateRule, word: str, names: Mapping[str, str]) -> StateRule:
    """A rule that speaks of the default variant speaks of the new one, too."""
    if rule.variants and "default" not in rule.variants:
        return rule
    parts = (*rule.parts, *(names[part] for part in rule.parts if part in names))
    variants = (*rule.variants, word) if rule.variants else ()
    return rule.model_copy(update={"parts": parts, "variants": variants})


def _supports(asset: Asset, word: str, names: Mapping[str, str]) -> list[Support]:
    moved = {item.name: f"{item.name}_{word}" for item in asset.containers if item.part in names}
    return [
        item.model_copy(
            update={
                "name": f"{item.name}_{word}",
                "part": names[item.part],
                "container": moved.get(item.container or "", item.container),
            }
        )
        for item in asset.supports
        if item.part in names
    ]


def _containers(asset: Asset, word: str, names: Mapping[str, str]) -> list[Container]:
    return [
        item.model_copy(update={"name": f"{item.name}_{word}", "part": names[item.part]})
        for item in asset.containers
        if item.part in names
    ]


def glb_with_nodes(raw: bytes, names: Mapping[str, str]) -> bytes:
    """The GLB with nodes that show the meshes of others again, under new names, where those are.

    What is there already stays. Raises ValueError for a GLB that is none, a node that is missing,
    or one of a new name that shows something else.
    """
    document = glb_document(raw)
    nodes: list[dict[str, Any]] = document["nodes"]
    by_name = {str(node.get("name")): index for index, node in enumerate(nodes)}
    for old, new in names.items():
        if old not in by_name:
            raise ValueError(f"it has no node {old!r}")
        source = nodes[by_name[old]]
        if new in by_name:
            if nodes[by_name[new]].get("mesh") != source.get("mesh"):
                raise ValueError(f"its node {new!r} shows another mesh than {old!r}")
            continue
        copied = {key: value for key, value in source.items() if key != "children"}
        nodes.append({**copied, "name": new})
        by_name[new] = len(nodes) - 1
        _beside(document, by_name[old], by_name[new])
    _, blob = chunks_of(raw)
    return glb_of(document, blob)


def _beside(document: dict[str, Any], old: int, new: int) -> None:
    """Hang a node where another hangs: below the same node, or in the same scenes."""
    for owner in (*document["nodes"], *document.get("scenes", ())):
        for key in ("children", "nodes"):
            if old in owner.get(key, ()):
                owner[key].append(new)


def hulls_with_parts(raw: bytes, names: Mapping[str, str]) -> bytes:
    """The collision pieces (JSON) with those of some parts again, for the parts that stand for
    them."""
    pieces: list[dict[str, Any]] = json.loads(raw)["pieces"]
    named = {piece["part"] for piece in pieces}
    again = [
        {**piece, "part": names[piece["part"]]}
        for piece in pieces
        if piece["part"] in names and names[piece["part"]] not in named
    ]
    document = {"pieces": [*pieces, *again]}
    return json.dumps(document, separators=(",", ":")).encode() + b"\n"
