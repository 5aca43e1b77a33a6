"""Licences of models, and which of them a data set takes over."""

from __future__ import annotations

from collections.abc import Iterable

#: Licences (SPDX) under which models may be passed on in a data set, from the widest to the
#: narrowest: assets.jsonl names each model's licence, attribution and source.
LICENCES = (
    "CC0-1.0",
    "MIT-0",
    "MIT",
    "BSD-3-Clause",
    "Apache-2.0",
    "CC-BY-3.0",
    "CC-BY-4.0",
    "CC-BY-SA-3.0",
    "CC-BY-SA-4.0",
)
#: Those that allow it for no trade; a build takes such models only when it is told to.
NON_COMMERCIAL = ("CC-BY-NC-3.0", "CC-BY-NC-4.0", "CC-BY-NC-SA-3.0", "CC-BY-NC-SA-4.0")
_NARROWER = {name: rank for rank, name in enumerate((*LICENCES, *NON_COMMERCIAL))}


def narrowest(licences: Iterable[str]) -> str:
    """The most restrictive of some licences. Raises ValueError when there is none."""
    return max(licences, key=lambda name: _NARROWER[name])
