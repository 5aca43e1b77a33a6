"""Data sets of older format versions: what their files lacked or said otherwise, said our way.

1.0 (sdgen 0.1): members of a kind of household are lists, models have one outline for all parts,
causes of rejections are words, which have no place in our records and are left out.
"""

from __future__ import annotations

from typing import Any


def catalogue_as_now(value: Any, version: str) -> Any:
    """``catalogue.json`` of a format version, as this version reads it."""
    if version != "1.0" or not isinstance(value, dict):
        return value
    kinds = value.get("households")
    if not isinstance(kinds, list):
        return value
    return {**value, "households": [_household(kind) for kind in kinds]}


def _household(kind: Any) -> Any:
    members = kind.get("members") if isinstance(kind, dict) else None
    if not isinstance(members, list):
        return kind
    said = [
        {"role": one[0], "age": one[1:]} if isinstance(one, list) and len(one) == 3 else one
        for one in members
    ]
    return {**kind, "members": said}


def asset_as_now(value: Any, version: str) -> Any:
    """A line of ``assets.jsonl`` of a format version, as this version reads it."""
    if version != "1.0" or not isinstance(value, dict) or "outline_m" not in value:
        return value
    said = dict(value)
    outline, parts = said.pop("outline_m"), said.get("parts")
    if isinstance(parts, list) and parts and isinstance(parts[0], dict) and outline:
        # Of a model as a whole; the first part is the one that stays where the object is.
        said["outlines_m"] = {str(parts[0].get("name")): [outline]}
    return said


def physics_as_now(value: Any) -> Any:
    """``physics.json`` of any format version, as this version reads it: the file does not tell its
    version, causes that are words do."""
    if not isinstance(value, dict) or not isinstance(value.get("rejections"), dict):
        return value
    return {**value, "rejections": [], "taken_away": []}


def info_as_now(value: Any) -> Any:
    """``dataset.json`` of any format version, as this version reads it."""
    if not isinstance(value, dict) or value.get("format_version") != "1.0":
        return value
    failed = value.get("failed")
    return {**value, "failed": {key: [] for key in failed}} if isinstance(failed, dict) else value
