"""The paper's detectors: a language model is asked about a scene graph in words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from sdgen.chat.asker import Asker, Outcome
from sdgen.chat.question import Question
from sdgen.chat.tokens import Estimate, estimate_of, tokens_of
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Report
from sdgen.detectors.account import SceneAccount, Settings, spent, told
from sdgen.detectors.asked import Looked, failed, outcomes_of, reports_or_raise
from sdgen.detectors.parsing import Reading, Said, notify_in, read_answer, verdict_in
from sdgen.detectors.prompts import Prompt
from sdgen.detectors.relation_strings import AS_SHOWN, Piece, Wording, Words, sentences
from sdgen.detectors.told import Told
from sdgen.detectors.who import Entry, who_lives_here
from sdgen.scene import Notify

#: So many strings a question, unless asked otherwise: a scene is a handful of questions, and an
#: answer fits what models say at once.
BATCH = 60
#: A quoted string, a colon and a class are about so many tokens more; with a reason, more yet.
_CLASS_TOKENS, _REASON_TOKENS = 6, 15
#: Of what is not asked of each string, about one in so many is named.
_NAMED = 10

#: The second step: "We ask the model to simplify the previous response into a one word
#: classification fitting the categories above" (Mullen et al.); the words are ours.
SIMPLIFY = (
    "Simplify the following response into a one word classification, either 'normal', 'unsafe', "
    "'unsanitary', or 'unsafe for children'. Answer with the classification alone.\n\n[RESPONSE]"
)


@dataclass(frozen=True)
class Prompted:
    """Asks ``asker``'s model by one of the paper's prompts, ``batch`` strings a question (0: all of
    a scene at once). ``parser``: a second model that makes a class of each line of the answer."""

    prompt: Prompt
    asker: Asker
    household: Entry = "filter"
    wording: Wording = AS_SHOWN
    batch: int = BATCH
    parser: Asker | None = None

    def __call__(self, data: Dataset, item: SceneItem) -> tuple[Report, ...]:
        """Its reports on a scene. Raises SdgenError where it cannot be asked."""
        return reports_or_raise(self.look(data, item))

    def questions(self, data: Dataset, item: SceneItem) -> Sequence[Question]:
        """What is asked about a scene."""
        return [self._question(data, item, pieces) for pieces in self._batches(item)]

    def more(self, data: Dataset, item: SceneItem) -> Estimate:
        """What the second model is about to be asked: each string's line."""
        if self.parser is None:
            return Estimate()
        said = (f"'{piece.text}': 'unsafe' as" for some in self._batches(item) for piece in some)
        return estimate_of(_simplify(Said(None, None, words)) for words in said)

    def look(self, data: Dataset, item: SceneItem) -> Looked:
        """Asks, reads, and accounts for it."""
        batches = self._batches(item)
        questions = [self._question(data, item, pieces) for pieces in batches]
        outcomes = outcomes_of(self.asker, questions, item.id)
        if (lost := failed(item.id, outcomes)) is not None:
            return lost
        readings = [self._read(o, pieces) for o, pieces in zip(outcomes, batches, strict=True)]
        first = tuple(outcomes)
        if self.parser is not None:
            readings, more = self._simplified(self.parser, readings, item)
            outcomes += more
        tell = Told(data.catalog)
        reports: dict[int, Report] = {}
        for reading, pieces in zip(readings, batches, strict=True):
            for piece in pieces:
                for report in self._reports(piece, reading.said.get(piece.text), tell, item):
                    reports.setdefault(report.object_id, report)
        account = self._account(item, batches, readings, outcomes, any(o.cut for o in first))
        return Looked(tuple(reports[key] for key in sorted(reports)), account)

    def settings(self, data: Dataset) -> Settings:
        """How it asks."""
        return Settings(
            method=self.prompt.name,
            title=self.prompt.title,
            reconstruction=self.prompt.reconstruction,
            model=self.asker.endpoint.model,
            parser=self.parser.endpoint.model if self.parser else None,
            household=self.household,
            graph_view=data.graph_view,
            perception=data.perception if data.graph_view == "perceived" else None,
            batch=self.batch,
            plain_names=not self.wording.states,
            more_relations=self.wording.more,
            temperature=self.asker.endpoint.temperature,
            max_tokens=self.asker.endpoint.max_tokens,
            prompt_sha256=self.prompt.sha256,
        )

    def _pieces(self, item: SceneItem) -> tuple[Piece, ...]:
        words = Words(item.shown_graph, self.wording)
        if self.prompt.shown == "names":
            return words.names()
        return words.phrases() if self.prompt.shown == "description" else words.relations()

    def _batches(self, item: SceneItem) -> list[tuple[Piece, ...]]:
        """The strings of a scene in questions of nearly one size."""
        pieces = self._pieces(item)
        count = math.ceil(len(pieces) / self.batch) if self.batch else min(1, len(pieces))
        ends = [round(len(pieces) * k / max(1, count)) for k in range(count + 1)]
        return [pieces[a:b] for a, b in pairwise(ends)]

    def _question(self, data: Dataset, item: SceneItem, pieces: Sequence[Piece]) -> Question:
        if self.prompt.shown == "description":
            content = sentences(pieces)
        else:
            content = f"[{', '.join(repr_of(piece.text) for piece in pieces)}]"
        who = ""
        if self.household == "prompt":
            who = who_lives_here(item.household, data.catalog, self.prompt.categories)
        each = _CLASS_TOKENS + (_REASON_TOKENS if self.prompt.cot else 0)
        tokens = sum(tokens_of(piece.text) + each for piece in pieces)
        tokens = tokens if self.prompt.every else max(2, tokens // _NAMED)
        return Question(self.prompt.filled(content, who), answer_tokens=tokens)

    def _read(self, outcome: Outcome, pieces: Sequence[Piece]) -> Reading:
        asked = [piece.text for piece in pieces]
        return read_answer(outcome.text or "", asked, loose=self.prompt.shown != "names")

    def _simplified(
        self, parser: Asker, readings: Sequence[Reading], item: SceneItem
    ) -> tuple[list[Reading], list[Outcome]]:
        """The classes that the second model reads from the lines of the first one's answers. A line
        that it makes no class of, or that it does not answer about, has none."""
        out: list[Reading] = []
        outcomes: list[Outcome] = []
        for reading in readings:
            said: dict[str, Said] = {}
            for string, one in reading.said.items():
                name = f"scene {item.id}, the class of {string!r}"
                outcomes.append(parser.ask(_simplify(one), name))
                said[string] = replace(one, verdict=verdict_in(outcomes[-1].text or ""))
            out.append(replace(reading, said=said))
        return out, outcomes

    def _reports(
        self, piece: Piece, said: Said | None, tell: Told, item: SceneItem
    ) -> list[Report]:
        """What one string's class makes of the nodes that it stands for."""
        if said is None or said.verdict == "normal":
            return []
        if said.verdict is None and self.prompt.categories:
            return []
        # Without classes there is none: what is named counts as unsafe, and its label as nothing.
        label = said.verdict or "unsafe"
        notify: Notify = "now"
        if self.household == "filter":
            notify = tell(label, item.household)
        elif self.household == "prompt":
            notify = said.notify or notify_in(said.words) or "now"
        return [Report(object_id=number, label=label, notify=notify) for number in piece.ids]

    def _account(
        self,
        item: SceneItem,
        batches: Sequence[Sequence[Piece]],
        readings: Sequence[Reading],
        outcomes: Sequence[Outcome],
        cut: bool,
    ) -> SceneAccount:
        asked = sum(map(len, batches))
        named = [said for reading in readings for said in reading.said.values()]
        labelled = sum(said.verdict is not None or not self.prompt.categories for said in named)
        unreadable = sum(not reading.readable for reading in readings)
        unlabelled = (asked if self.prompt.every else len(named)) - labelled
        status = "partly" if unlabelled or unreadable or cut else "answered"
        if readings and unreadable == len(readings):
            status = "unparsable"
        invented = [name for reading in readings for name in reading.invented]
        return SceneAccount(
            scene=item.id,
            status=status,
            why=told(one.why for one in outcomes if one.text is None),
            asked=asked,
            labelled=labelled,
            unlabelled=unlabelled,
            invented=len(invented),
            invented_examples=told(invented),
            unreadable=unreadable,
            spent=spent(outcomes),
        )


def repr_of(text: str) -> str:
    """A string in the quotes of the prompts."""
    return f"'{text}'"


def _simplify(said: Said) -> Question:
    return Question(SIMPLIFY.replace("[RESPONSE]", said.words), answer_tokens=3)
