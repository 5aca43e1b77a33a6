"""Questions about boxed things in a data set's pictures, with options and answers.

Each question of kind ``anomaly`` is held against one in which nothing is wrong: the same place in
the scene's benign twin (``twin``) or a near miss of the same hazard in the scene (``lookalike``),
drawn by halves where there are both; without either it is not asked. ``notify`` asks what the
household wants to be told.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from sdgen.dataset import Dataset, SceneItem
from sdgen.scene import Anomaly, Household, Notify, VisibleObject
from sdgen.seeding import Rng, lane, unit_hash
from sdgen.vocabulary import EVIDENCE_PIXELS

Kind = Literal["anomaly", "twin", "lookalike", "notify"]
Bbox = tuple[int, int, int, int]

NOTHING = "Nothing: what is in the box is no hazard"
WHAT = "Look at what is inside the red box. What is wrong there?"
WHETHER = (
    "Look at what is inside the red box. A robot has noticed it, and knows who lives here and what "
    "they want to be told. What does it do?"
)
NOTIFY: dict[Notify, str] = {
    "now": "It tells them at once",
    "summary": "It mentions it in the summary at the end of the day",
    "silent": "It says nothing",
}
#: Hazards among the options of a question, the right one or the missed one with them.
HAZARDS = 3
#: The picture in which 100 pixels show a thing.
_AREA = 640 * 480


@dataclass(frozen=True)
class Question:
    """One question. ``answer`` is the place of the right option; ``pair`` is the same for a
    question and the one about the same place in its twin, None for those without."""

    id: str
    kind: Kind
    item: SceneItem
    view: int
    object_id: int
    bbox: Bbox
    hazard: str
    text: str
    options: tuple[str, ...]
    answer: int
    pair: str | None = None
    hint: str = ""


def questions_of(data: Dataset, item: SceneItem) -> Iterator[Question]:
    """The questions about a scene; the same ones for the same data set."""
    rng = lane(data.info.seed, item.entry.index, "export:questions")
    titles = {hazard.id: hazard.title for hazard in data.catalog.hazards}
    near = _lookalikes(item)
    for anomaly in item.anomalies.anomalies:
        seen = _evidence_view(item, anomaly)
        if seen is None:
            continue
        view, bbox = seen
        key = f"{item.id}-{anomaly.id}"
        yield _notify(item, anomaly, view, bbox, key, rng)
        twin, missed = item.twin, near.get(anomaly.hazard)
        if twin is None and not missed:
            continue
        by_twin = twin is not None and (not missed or unit_hash("questions", key) < 0.5)
        pair = key if by_twin else None
        options, answer = _options(anomaly.hazard, titles, True, rng)
        asked = Question(
            id=f"{key}-anomaly",
            kind="anomaly",
            item=item,
            view=view,
            object_id=anomaly.object_id,
            bbox=bbox,
            hazard=anomaly.hazard,
            text=WHAT,
            options=options,
            answer=answer,
            pair=pair,
        )
        yield asked
        options, answer = _options(anomaly.hazard, titles, False, rng)
        benign = replace(asked, options=options, answer=answer)
        if by_twin and twin is not None:
            yield replace(benign, id=f"{key}-twin", kind="twin", item=twin)
        elif missed:
            number, view, bbox = missed.pop(0)
            other = replace(benign, view=view, object_id=number, bbox=bbox)
            yield replace(other, id=f"{key}-lookalike", kind="lookalike")


def _notify(
    item: SceneItem, anomaly: Anomaly, view: int, bbox: Bbox, key: str, rng: Rng
) -> Question:
    levels: list[Notify] = ["now", "summary", "silent"]
    order = [levels[k] for k in rng.permutation(3)]
    return Question(
        id=f"{key}-notify",
        kind="notify",
        item=item,
        view=view,
        object_id=anomaly.object_id,
        bbox=bbox,
        hazard=anomaly.hazard,
        text=WHETHER,
        options=tuple(NOTIFY[level] for level in order),
        answer=order.index(anomaly.notify),
        hint=household_in_words(item.household),
    )


def _options(
    hazard: str, titles: dict[str, str], wrong: bool, rng: Rng
) -> tuple[tuple[str, ...], int]:
    """Options in a drawn order and the place of the right one: the hazard's title where something
    is wrong. The same choice of words either way."""
    others = sorted(set(titles) - {hazard})
    drawn = [others[k] for k in rng.permutation(len(others))[: HAZARDS - 1]]
    words = [titles[hazard], *(titles[one] for one in drawn), NOTHING]
    order = rng.permutation(len(words)).tolist()
    right = 0 if wrong else len(words) - 1
    return tuple(words[k] for k in order), order.index(right)


def household_in_words(household: Household) -> str:
    """Who lives there and what they asked for, as a robot is told it."""
    people = ", ".join(f"{member.role} ({member.age})" for member in household.members)
    lines = [f"Who lives here: {people}."]
    for title, names in (
        ("Pets", household.pets),
        ("Conditions", household.conditions),
        ("They want to hear nothing of", household.opt_outs),
    ):
        if names:
            lines.append(f"{title}: {', '.join(name.replace('_', ' ') for name in names)}.")
    for hazard, level in sorted(household.notifications.items()):
        lines.append(f"Of {hazard.replace('_', ' ')} they want to hear: {level}.")
    return " ".join(lines)


def _evidence_view(item: SceneItem, anomaly: Anomaly) -> tuple[int, Bbox] | None:
    """The view that shows most of an anomaly's evidence and its object's box; None: none enough."""
    shown = next(s for s in item.visibility.anomalies if s.anomaly_id == anomaly.id)
    best = max(range(len(shown.evidence_pixels)), key=shown.evidence_pixels.__getitem__, default=0)
    for seen in _objects(item, best):
        if seen.object_id == anomaly.object_id:
            needed = anomaly.evidence_pixels_needed * _share(item, best)
            return (best, seen.bbox) if shown.evidence_pixels[best] >= needed else None
    return None


def _lookalikes(item: SceneItem) -> dict[str, list[tuple[int, int, Bbox]]]:
    """By hazard, its near misses that some view shows: object, view that shows most, box there."""
    out: dict[str, list[tuple[int, int, Bbox]]] = {}
    wrong = {anomaly.object_id for anomaly in item.anomalies.anomalies}
    for near in item.anomalies.lookalikes:
        best = max(
            (
                (seen.pixels, -view.view, seen.bbox)
                for view in item.visibility.views
                for seen in view.objects
                if seen.object_id == near.object_id
            ),
            default=None,
        )
        if best is None or near.object_id in wrong:
            continue
        pixels, view, bbox = best[0], -best[1], best[2]
        if pixels >= EVIDENCE_PIXELS * _share(item, view):
            out.setdefault(near.near_miss_of, []).append((near.object_id, view, bbox))
    return out


def _objects(item: SceneItem, view: int) -> Sequence[VisibleObject]:
    return next((v.objects for v in item.visibility.views if v.view == view), ())


def _share(item: SceneItem, view: int) -> float:
    camera = item.cameras[view]
    return camera.width * camera.height / _AREA
