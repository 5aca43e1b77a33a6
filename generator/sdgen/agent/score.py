"""How an episode went: what was found and reported, how far was walked, and why the rest was
missed."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from sdgen.agent.episode import Episode
from sdgen.agent.tour import Tour
from sdgen.benchmark.outcome import score_scene
from sdgen.scene import Anomaly, Record

#: Why an anomaly was not reported. ``unobservable``: no pose that one gets to shows it.
#: ``never_looked``: it was never before the camera. ``could_not_see``: it was, but too far, too
#: much aside or behind something. ``did_not_understand``: a picture showed enough of it.
Miss = Literal["unobservable", "never_looked", "could_not_see", "did_not_understand"]


class Find(Record):
    """What became of one anomaly: the step of the first picture that showed enough of it, the step
    of its report, and why it was missed, each None where there is none. ``observable``: None
    without certificates."""

    anomaly_id: str
    object_id: int
    hazard: str
    observable: bool | None
    shown: int | None
    reported: int | None
    miss: Miss | None


class EpisodeScore(Record):
    """One episode's scores. AS, CAS, unwanted, false_alarms and label_accuracy are those of
    ``sdgen evaluate`` (None: not defined for it).

    ``path_m`` was walked in ``steps``; ``shortest_m`` is the tour that sees all that can be seen,
    ``path_ratio`` how much of the walk it is, times the share of the observable that was shown (0
    to 1, as SPL: Anderson et al. 2018; both None without certificates, or where nothing can be
    seen). ``coverage``: the share of the floor plan that was seen. ``refused``:
    moves that could not be done, ``collisions``: steps into something.
    """

    scene: str
    AS: float | None
    CAS: float | None
    unwanted: float
    false_alarms: float
    label_accuracy: float | None
    anomalies: int = Field(ge=0)
    observable: int | None
    shown: int = Field(ge=0)
    found: int = Field(ge=0)
    steps: int = Field(ge=0)
    path_m: float
    shortest_m: float | None
    path_ratio: float | None
    coverage: float
    refused: int = Field(ge=0)
    collisions: int = Field(ge=0)
    finds: tuple[Find, ...]


def score_episode(episode: Episode, tour: Tour | None = None) -> EpisodeScore:
    """The scores of an episode as far as it went; ``tour`` is the shortest from its start, by the
    certificates of its scene."""
    anomalies = episode.stage.anomalies
    reports = tuple(episode.reports[key] for key in sorted(episode.reports))
    scores = score_scene(anomalies, reports)
    finds = tuple(_find(episode, one, tour) for one in anomalies)
    shortest = tour.length_m if tour is not None and tour.stops else None
    ratio = None
    seen = [find.shown is not None for find in finds if find.observable]
    if shortest is not None and seen:
        least = shortest / max(shortest, episode.path_m) if shortest else 1.0
        ratio = least * sum(seen) / len(seen)
    return EpisodeScore(
        scene=episode.stage.id,
        AS=scores.as_,
        CAS=scores.cas,
        unwanted=scores.unwanted,
        false_alarms=scores.false_alarms,
        label_accuracy=scores.label_accuracy,
        anomalies=len(anomalies),
        observable=None if tour is None else sum(find.observable is True for find in finds),
        shown=len(episode.account.first_shown),
        found=sum(find.reported is not None for find in finds),
        steps=episode.steps,
        path_m=round(episode.path_m, 3),
        shortest_m=None if shortest is None else round(shortest, 3),
        path_ratio=None if ratio is None else round(ratio, 4),
        coverage=round(episode.account.coverage, 4),
        refused=len(episode.refusals),
        collisions=episode.collisions,
        finds=finds,
    )


def _find(episode: Episode, anomaly: Anomaly, tour: Tour | None) -> Find:
    shown = episode.account.first_shown.get(anomaly.id)
    reported = episode.reported_at.get(anomaly.object_id)
    observable = None if tour is None else anomaly.id not in tour.unreachable
    return Find(
        anomaly_id=anomaly.id,
        object_id=anomaly.object_id,
        hazard=anomaly.hazard,
        observable=observable,
        shown=shown,
        reported=reported,
        miss=None if reported is not None else _miss(episode, anomaly, shown, observable),
    )


def _miss(episode: Episode, anomaly: Anomaly, shown: int | None, observable: bool | None) -> Miss:
    if shown is not None:
        return "did_not_understand"
    if observable is False:
        return "unobservable"
    if anomaly.id in episode.account.looked_at:
        return "could_not_see"
    return "never_looked"
