"""A data set's scenes checked one by one, by several processes where that is worth it."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import closing
from typing import Any

from sdgen.dataset.records import ManifestEntry
from sdgen.engines.in_order import in_order
from sdgen.engines.protocol import Factory
from sdgen.errors import SceneRejected
from sdgen.rejection import causes_in_words
from sdgen.validate.problems import Problem

#: With fewer scenes than this, starting processes takes longer than it saves.
WORTH_WORKERS = 8


def scene_by_scene(
    checker: Factory, args: tuple[Any, ...], entries: Sequence[ManifestEntry], workers: int
) -> Generator[list[Problem], None, None]:
    """What ``checker(*args)`` finds at each index of ``entries``, in the manifest's order.

    A scene at which workers crash is a problem of its own; other errors are raised. Close it: its
    processes end with it.
    """
    if len(entries) < WORTH_WORKERS:
        workers = 1
    with closing(in_order(checker, args, len(entries), workers)) as outcomes:
        for outcome in outcomes:
            if isinstance(outcome.error, SceneRejected):
                text = f"scenes/{entries[outcome.job].id}: workers end at it"
                yield [Problem("scene", f"{text} ({causes_in_words(outcome.error.causes)})")]
            elif outcome.error is not None:
                raise outcome.error
            else:
                yield outcome.result
