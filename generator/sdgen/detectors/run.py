"""Detectors by name, run over a data set."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from itertools import chain

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.records import Report
from sdgen.detectors.rules import rules
from sdgen.detectors.simple import always, chance, never
from sdgen.errors import UsageError, did_you_mean

#: A detector looks at one scene of a data set: at its ``shown_graph``, its household, its views.
Detector = Callable[[Dataset, SceneItem], tuple[Report, ...]]

#: Those that need neither training nor a language model.
DETECTORS: Mapping[str, Detector] = {
    "rules": rules,
    "never": never,
    "always": always,
    "chance": chance,
}


def detect(
    data: Dataset,
    method: str | Detector,
    on_scene: Callable[[int, int], None] | None = None,
    twins: bool = False,
) -> dict[str, tuple[Report, ...]]:
    """Reports of a detector, or the one of that name, for every scene, and for their benign twins
    where these are asked for.

    UsageError for a method nobody knows, InputError for a scene whose files disagree.
    """
    if isinstance(method, str):
        if method not in DETECTORS:
            raise UsageError(f"no method {method!r}{did_you_mean(method, list(DETECTORS))}")
        method = DETECTORS[method]
    return detect_all(data, {"": method}, on_scene, twins)[""]


def detect_all(
    data: Dataset,
    detectors: Mapping[str, Detector],
    on_scene: Callable[[int, int], None] | None = None,
    twins: bool = False,
) -> dict[str, dict[str, tuple[Report, ...]]]:
    """Reports of several detectors, by their names: as ``detect``, with each scene opened, and its
    graph made out, once for all of them."""
    out: dict[str, dict[str, tuple[Report, ...]]] = {name: {} for name in detectors}
    total = len(data)
    for done, item in enumerate(data, start=1):
        for one in looked_at(item, twins):
            with derived_from(data, one):
                for name, detector in detectors.items():
                    out[name][one.id] = detector(data, one)
        if on_scene is not None:
            on_scene(done, total)
    return out


def looked_at(item: SceneItem, twins: bool) -> Iterable[SceneItem]:
    """A scene, and its benign twin where it has one and that is asked for."""
    twin = item.twin if twins else None
    return chain((item,), () if twin is None else (twin,))
