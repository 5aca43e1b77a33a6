"""What exploring costs: explorers and detectors over the homes of a data set, in one table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import islice
from typing import Literal

from sdgen.agent.episode import Episode
from sdgen.agent.explored import explored
from sdgen.agent.explorers import EXPLORERS
from sdgen.agent.eyes import Eyes
from sdgen.agent.options import AgentOptions
from sdgen.agent.score import EpisodeScore, Miss, score_episode
from sdgen.agent.stage import check_models, stage_of
from sdgen.agent.tour import shortest_tour
from sdgen.benchmark.outcome import SceneScores, score_scene
from sdgen.benchmark.scores import Score, score
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.detectors.run import Detector
from sdgen.errors import UsageError, did_you_mean
from sdgen.library import Library
from sdgen.render.process import process_renderer
from sdgen.scene import Record
from sdgen.seeding import lane
from sdgen.truth.observability import observability
from sdgen.truth.observable import Observability

#: What a detector had before it: what an explorer saw, what the data set's views show, or all.
Before = Literal["explored", "views", "everything"]


class Row(Record):
    """One explorer with one detector; ``explorer`` is empty where nobody walked.

    AS, CAS, false alarms and label accuracy are means over homes as ``sdgen evaluate`` has them.
    ``shown`` and ``found`` are shares of the anomalies that can be seen from some pose that one
    gets to: of which a picture showed enough, and which were reported. ``steps_to_find``: the step
    of the picture that showed what was reported. ``path_ratio``: the shortest tour that sees all of
    them, by the way walked. ``misses``: why the others were not reported.
    """

    explorer: str
    detector: str
    before: Before
    homes: int
    AS: Score
    CAS: Score
    false_alarms: Score
    label_accuracy: Score
    shown: Score | None = None
    found: Score | None = None
    steps: Score | None = None
    steps_to_find: Score | None = None
    path_m: Score | None = None
    path_ratio: Score | None = None
    coverage: Score | None = None
    misses: dict[Miss, int] | None = None


def compare(
    data: Dataset,
    library: Library,
    explorers: Sequence[str],
    detectors: Mapping[str, Detector],
    options: AgentOptions,
    seed: int = 0,
    renderer: str = "auto",
    limit: int | None = None,
    on_scene: Callable[[int, int], None] | None = None,
) -> list[Row]:
    """The rows of all explorers with all detectors, and of the detectors without exploring.

    An explorer looks, then each detector says what it makes of the same pictures; ``limit``: of
    the first so many homes. UsageError for an explorer nobody knows; InputError for another library
    than the data set was built with.
    """
    for name in explorers:
        if name not in EXPLORERS:
            raise UsageError(f"no explorer {name!r}{did_you_mean(name, list(EXPLORERS))}")
    check_models(data, library)
    views = {
        "views": Dataset(data.path, data.split, graph_view="perceived"),
        "everything": Dataset(data.path, data.split),
    }
    walked: dict[tuple[str, str], list[EpisodeScore]] = {}
    still: dict[tuple[str, str], list[SceneScores]] = {}
    with Eyes(library, process_renderer(renderer), options.whole_home) as eyes:
        total = len(data) if limit is None else min(limit, len(data))
        for done, item in enumerate(islice(data, total), start=1):
            found = certificates(data, item, library, options)
            for name in explorers:
                runs = explored_scores(
                    data, item, found, name, detectors, library, eyes, options, seed
                )
                for detector, result in runs:
                    walked.setdefault((name, detector), []).append(result)
            for before, shown in views.items():
                for detector, scores in _without(shown, item.id, detectors):
                    still.setdefault((before, detector), []).append(scores)
            if on_scene is not None:
                on_scene(done, total)
    return [
        *(_walked_row(*key, scores) for key, scores in walked.items()),
        *(_still_row(*key, scores) for key, scores in still.items()),
    ]


def certificates(
    data: Dataset, item: SceneItem, library: Library, options: AgentOptions
) -> Observability:
    """The certificates of a scene for this camera: those that it was built with, or made now."""
    written = item.observability
    if written is not None and written.lens == options.camera:
        return written
    with derived_from(data, item):
        anomalies = item.anomalies.anomalies
        return observability(library, item.scene, anomalies, data.catalog, options.camera)


def explored_scores(
    data: Dataset,
    item: SceneItem,
    found: Observability,
    explorer: str,
    detectors: Mapping[str, Detector],
    library: Library,
    eyes: Eyes,
    options: AgentOptions,
    seed: int,
) -> Iterator[tuple[str, EpisodeScore]]:
    """Explore a scene once, and score what each detector says of it."""
    stage = stage_of(data, item)
    episode = Episode(stage, library, eyes, options, lane(seed, item.entry.index, "agent"))
    floor, start = episode.house.floor, episode.gaze.point
    tour = shortest_tour(found, floor, start)
    clearly = shortest_tour(found, floor, start, episode.stage.places)
    rng = lane(seed, item.entry.index, f"explorer:{explorer}")
    looks = EXPLORERS[explorer](episode, rng, clearly)
    seen = explored(item, looks)
    for name, detector in detectors.items():
        with derived_from(data, item):
            episode.conclude(detector(data, seen))
        yield name, score_episode(episode, tour)


def _without(
    data: Dataset, scene_id: str, detectors: Mapping[str, Detector]
) -> Iterator[tuple[str, SceneScores]]:
    """What the detectors say of a scene where nobody walked."""
    item = data.scene(scene_id)
    if data.graph_view == "perceived" and not {"depth", "instance"} <= {*data.info.options.sensors}:
        return
    if data.graph_view == "perceived" and not item.entry.views:
        return
    for name, detector in detectors.items():
        with derived_from(data, item):
            yield name, score_scene(item.anomalies.anomalies, detector(data, item))


def _walked_row(explorer: str, detector: str, scores: Sequence[EpisodeScore]) -> Row:
    finds = [find for one in scores for find in one.finds]
    can = [find for find in finds if find.observable]
    misses = Counter(find.miss for find in finds if find.miss is not None)
    return Row(
        explorer=explorer,
        detector=detector,
        before="explored",
        homes=len(scores),
        AS=score(one.AS for one in scores),
        CAS=score(one.CAS for one in scores),
        false_alarms=score(one.false_alarms for one in scores),
        label_accuracy=score(one.label_accuracy for one in scores),
        shown=score(float(find.shown is not None) for find in can),
        found=score(float(find.reported is not None) for find in can),
        steps=score(float(one.steps) for one in scores),
        steps_to_find=score(float(f.shown) for f in finds if f.reported and f.shown is not None),
        path_m=score(one.path_m for one in scores),
        path_ratio=score(one.path_ratio for one in scores),
        coverage=score(one.coverage for one in scores),
        misses=dict(sorted(misses.items())),
    )


def _still_row(before: str, detector: str, scores: Sequence[SceneScores]) -> Row:
    return Row(
        explorer="",
        detector=detector,
        before="views" if before == "views" else "everything",
        homes=len(scores),
        AS=score(one.as_ for one in scores),
        CAS=score(one.cas for one in scores),
        false_alarms=score(one.false_alarms for one in scores),
        label_accuracy=score(one.label_accuracy for one in scores),
    )
