"""Random lanes: every stage of every scene draws from a generator of its own.

A lane is keyed by (root seed, scene index, lane name), so a new lane, or an extension pack,
never shifts what another draws, and scene *i* can be made alone.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

Rng = np.random.Generator

#: Stands in for a drawn 0, which has no logarithm: below all else that is drawn.
_TINY = float(np.finfo(np.float64).tiny)


def _words(text: str) -> tuple[int, ...]:
    digest = hashlib.sha256(text.encode("utf-8")).digest()
    return tuple(int.from_bytes(digest[k : k + 4], "little") for k in range(0, 16, 4))


def lane(seed: int, scene: int, name: str) -> Rng:
    """Generator of the lane ``name`` of scene ``scene`` under root seed ``seed`` (both ≥ 0)."""
    sequence = np.random.SeedSequence(seed, spawn_key=(scene, *_words(name)))
    return np.random.Generator(np.random.PCG64(sequence))


def unit_hash(*parts: object) -> float:
    """A number in [0, 1) that depends only on the text of ``parts`` (splits, withheld assets)."""
    text = "\x1f".join(str(part) for part in parts)
    return int.from_bytes(hashlib.sha256(text.encode("utf-8")).digest()[:8], "big") / 2.0**64


def weighted_keys(rng: Rng, weights: Sequence[float]) -> npt.NDArray[np.float64]:
    """One key a weight (all > 0): sorted by it, largest first, things are drawn without
    replacement by weight.

    Efraimidis and Spirakis (2006) sort by u^(1/w); its logarithm has the same order and does not
    become 0 for every small weight.
    """
    drawn = np.maximum(rng.random(len(weights)), _TINY)
    return np.asarray(np.log(drawn) / np.asarray(weights, dtype=np.float64), dtype=np.float64)
