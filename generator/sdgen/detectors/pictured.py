"""A model that sees is shown the rendered views of a scene and points at what is wrong."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Literal

import numpy as np
import numpy.typing as npt
from PIL import Image

from sdgen.chat.asker import Asker
from sdgen.chat.question import Picture, Question
from sdgen.chat.tokens import Estimate
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Report
from sdgen.dataset.scene_folder import view_folder
from sdgen.detectors.account import SceneAccount, Settings, spent, told
from sdgen.detectors.asked import Looked, failed, outcomes_of, reports_or_raise
from sdgen.detectors.matching import meant
from sdgen.detectors.pointing import Pointing, Pointings, read_pointings
from sdgen.detectors.prompts import PROMPTS, Prompt
from sdgen.detectors.relation_strings import AS_SHOWN, Wording, Words, plain_word
from sdgen.detectors.told import Told, things
from sdgen.detectors.who import Entry, who_lives_here
from sdgen.errors import InputError
from sdgen.scene import GraphNode, Notify, VisibleObject

#: A question shows the views of a room, or one view.
Per = Literal["room", "view"]
#: Boxes are in pixels of the pictures as they are sent, or in thousandths of their sides, as some
#: models are trained to answer.
Unit = Literal["pixels", "thousandths"]
#: Pictures are sent no wider than this, pixels: one tile of those that endpoints charge for.
PICTURE_WIDTH = 512
#: A line that points at something is about so many tokens.
_LINE_TOKENS = 30
_QUALITY = 90


@dataclass(frozen=True)
class Shot:
    """A view that a question shows, and its size as it is sent."""

    view: int
    width: int
    height: int


@dataclass(frozen=True)
class Look:
    """One question: its views, the room they are of (None where a stranger's camera names none),
    and what of it may be named by number."""

    shots: tuple[Shot, ...]
    room: str
    nodes: tuple[GraphNode, ...]


@dataclass(frozen=True)
class Pictured:
    """Asks ``asker``'s model about the pictures of each room, or each view, with the strings of
    the graph or without. Boxes are matched to objects as ``matching`` says."""

    asker: Asker
    household: Entry = "filter"
    per: Per = "room"
    with_graph: bool = False
    unit: Unit = "pixels"
    picture_width: int = PICTURE_WIDTH
    wording: Wording = AS_SHOWN

    @property
    def prompt(self) -> Prompt:
        """The prompt, ours."""
        return PROMPTS["views"]

    def __call__(self, data: Dataset, item: SceneItem) -> tuple[Report, ...]:
        """Its reports on a scene. Raises SdgenError where it cannot be asked."""
        return reports_or_raise(self.look(data, item))

    def questions(self, data: Dataset, item: SceneItem) -> Sequence[Question]:
        """What is asked about a scene."""
        return [self._question(data, item, look) for look in self._looks(item)]

    def more(self, data: Dataset, item: SceneItem) -> Estimate:
        """Nothing is asked after that."""
        return Estimate()

    def look(self, data: Dataset, item: SceneItem) -> Looked:
        """Asks, matches, and accounts for it."""
        looks = self._looks(item)
        questions = [self._question(data, item, look) for look in looks]
        outcomes = outcomes_of(self.asker, questions, item.id)
        if (lost := failed(item.id, outcomes)) is not None:
            return lost
        answers = [read_pointings(o.text or "", self.with_graph) for o in outcomes]
        finder = _Finder(item)
        tell = Told(data.catalog)
        reports: dict[int, Report] = {}
        invented: list[str] = []
        unmatched = 0
        for answer, look in zip(answers, looks, strict=True):
            for one in answer.found:
                number = self._object(one, look, finder)
                if number is None and one.box is None:
                    invented.append(f"[{one.node}]")
                unmatched += number is None and one.box is not None
                if number is not None and one.label is not None:
                    report = self._report(number, one, tell, item)
                    reports.setdefault(number, report)
        account = _account(item.id, answers, unmatched, invented)
        cut = any(outcome.cut for outcome in outcomes)
        if account.status == "answered" and cut:
            account = account.model_copy(update={"status": "partly"})
        account = account.model_copy(update={"spent": spent(outcomes)})
        return Looked(tuple(reports[key] for key in sorted(reports)), account)

    def settings(self, data: Dataset) -> Settings:
        """How it asks."""
        return Settings(
            method=self.prompt.name,
            title=self.prompt.title,
            reconstruction=self.prompt.reconstruction,
            model=self.asker.endpoint.model,
            household=self.household,
            graph_view=data.graph_view,
            perception=data.perception if data.graph_view == "perceived" else None,
            plain_names=not self.wording.states if self.with_graph else None,
            more_relations=self.wording.more if self.with_graph else None,
            per=self.per,
            with_graph=self.with_graph,
            boxes=self.unit,
            picture_width=self.picture_width,
            temperature=self.asker.endpoint.temperature,
            max_tokens=self.asker.endpoint.max_tokens,
            prompt_sha256=self.prompt.sha256,
        )

    def _looks(self, item: SceneItem) -> list[Look]:
        """The questions about a scene: rooms by their ids, or views in order."""
        words = Words(item.shown_graph)
        in_room: dict[int, list[GraphNode]] = {}
        for node in things(item.shown_graph):
            room = words.room(node)
            in_room.setdefault(room.id if room else 0, []).append(node)
        names = {node.id: plain_word(node.class_name, " ") for node in item.shown_graph.nodes}
        groups: dict[tuple[int, int], list[Shot]] = {}
        for view, camera in enumerate(item.cameras):
            key = (camera.room_id, 0 if self.per == "room" else view + 1)
            width = min(camera.width, self.picture_width)
            height = max(1, round(camera.height * width / max(1, camera.width)))
            groups.setdefault(key, []).append(Shot(view, width, height))
        return [
            Look(tuple(shots), names.get(room, "room"), tuple(in_room.get(room, ())))
            for (room, _), shots in sorted(groups.items())
        ]

    def _question(self, data: Dataset, item: SceneItem, look: Look) -> Question:
        pictures = tuple(self._picture(item, shot) for shot in look.shots)
        text = self.prompt.template
        one, first = len(pictures) == 1, look.shots[0]
        shown = f"This is picture 1, a view of the {look.room} of a home, "
        if not one:
            shown = f"These are pictures 1 to {len(pictures)}, views of the {look.room} of a home, "
        shown += f"{first.width} pixels wide and {first.height} high."
        unit = (
            "pixels" if self.unit == "pixels" else "thousandths of the picture's width and height"
        )
        graph = ""
        if self.with_graph:
            words = Words(item.shown_graph, self.wording)
            lines = (f"[{node.id}] {words.relation(node)}" for node in look.nodes)
            graph = (
                "\n\nThe scene graph has these things there; you may name one by its number in "
                "place of a box, [17]: 'unsafe':\n\n" + "\n".join(lines)
            )
        parts = {"[PICTURES]": shown, "[UNIT]": unit, "[GRAPH]": graph}
        for mark, filling in parts.items():
            text = text.replace(mark, filling, 1)
        if self.household == "prompt":
            text = f"{who_lives_here(item.household, data.catalog)}\n\n{text}"
        return Question(text, pictures, answer_tokens=_LINE_TOKENS * len(pictures))

    def _picture(self, item: SceneItem, shot: Shot) -> Picture:
        digest = item.rgb_digest(shot.view)
        if digest is None:
            raise InputError([f"{item.where(view_folder(shot.view))}: has no colour picture"])
        return Picture(
            f"{digest} {shot.width}x{shot.height}",
            shot.width,
            shot.height,
            partial(_encoded, item, shot),
        )

    def _object(self, one: Pointing, look: Look, finder: _Finder) -> int | None:
        """The object that a line of an answer means, None for none."""
        if one.box is None:
            return next((node.id for node in look.nodes if node.id == one.node), None)
        picture = one.picture
        if picture is None and len(look.shots) == 1:
            picture = 1
        if picture is None or not 1 <= picture <= len(look.shots):
            return None
        shot = look.shots[picture - 1]
        wide, high = (shot.width, shot.height) if self.unit == "pixels" else (1000, 1000)
        return finder.at(shot.view, one.box, (wide, high))

    def _report(self, number: int, one: Pointing, tell: Told, item: SceneItem) -> Report:
        assert one.label is not None
        notify: Notify = "now"
        if self.household == "filter":
            notify = tell(one.label, item.household)
        elif self.household == "prompt":
            notify = one.notify or "now"
        return Report(object_id=number, label=one.label, notify=notify)


class _Finder:
    """Finds what boxes mean in the views of a scene."""

    def __init__(self, item: SceneItem) -> None:
        self._item = item
        self._masks: dict[int, npt.NDArray[np.uint16] | None] = {}

    @cached_property
    def _ids(self) -> frozenset[int]:
        return frozenset(node.id for node in things(self._item.shown_graph))

    @cached_property
    def _visible(self) -> dict[int, tuple[VisibleObject, ...]]:
        return {view.view: view.objects for view in self._item.visibility.views}

    def at(
        self, view: int, box: tuple[float, float, float, float], sent: tuple[int, int]
    ) -> int | None:
        """The object that a box means; ``sent``: the picture's size as the model takes it to be."""
        camera = self._item.cameras[view]
        wide, high = camera.width / sent[0], camera.height / sent[1]
        whole = (box[0] * wide, box[1] * high, box[2] * wide, box[3] * high)
        if whole[2] <= 0 or whole[3] <= 0:
            return None
        if view not in self._masks:
            has = self._item.has(view, "instance.png")
            self._masks[view] = self._item.instance(view) if has else None
        found = meant(whole, self._visible.get(view, ()), self._ids, self._masks[view])
        return found.object_id if found else None


def _account(
    scene: str, answers: Sequence[Pointings], unmatched: int, invented: Sequence[str]
) -> SceneAccount:
    lines = [one for answer in answers for one in answer.found]
    unreadable = sum(not answer.readable for answer in answers)
    unlabelled = sum(one.label is None for one in lines)
    status: Literal["answered", "partly", "unparsable"] = "answered"
    if unlabelled or unreadable:
        status = "partly"
    if answers and unreadable == len(answers):
        status = "unparsable"
    return SceneAccount(
        scene=scene,
        status=status,
        labelled=len(lines) - unlabelled,
        unlabelled=unlabelled,
        invented=len(invented),
        invented_examples=told(invented),
        unreadable=unreadable,
        boxes=sum(one.box is not None for one in lines),
        unmatched=unmatched,
    )


def _encoded(item: SceneItem, shot: Shot) -> tuple[str, bytes]:
    """A view as it is sent: PNG where it is stored so, else JPEG. Raises InputError."""
    picture = Image.fromarray(item.rgb(shot.view))
    if picture.size != (shot.width, shot.height):
        picture = picture.resize((shot.width, shot.height), Image.Resampling.LANCZOS)
    buffer = io.BytesIO()
    if item.has(shot.view, "rgb.png"):
        picture.save(buffer, "PNG")
        return "image/png", buffer.getvalue()
    picture.save(buffer, "JPEG", quality=_QUALITY)
    return "image/jpeg", buffer.getvalue()


def shows_pictures(data: Dataset) -> bool:
    """True for a data set whose scenes have colour pictures."""
    return any(
        name.endswith(("rgb.png", "rgb.jpg")) for entry in data.shown for name in entry.files
    )
