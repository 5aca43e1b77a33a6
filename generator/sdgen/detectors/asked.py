"""What all that ask a language model have in common, and their run over a data set."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

from sdgen.chat.asker import Asker, Outcome
from sdgen.chat.question import Question
from sdgen.chat.threads import in_threads
from sdgen.chat.tokens import Estimate, estimate_of
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Report
from sdgen.detectors.account import SceneAccount, Settings, spent, told
from sdgen.detectors.run import looked_at
from sdgen.errors import SdgenError


@dataclass(frozen=True)
class Looked:
    """What was found in a scene, None where it could not be asked, and how that went."""

    reports: tuple[Report, ...] | None
    account: SceneAccount


class AskingDetector(Protocol):
    """A detector that asks a language model."""

    @property
    def asker(self) -> Asker:
        """Who asks."""
        ...

    def questions(self, data: Dataset, item: SceneItem) -> Sequence[Question]:
        """What is asked about a scene."""
        ...

    def more(self, data: Dataset, item: SceneItem) -> Estimate:
        """About what is asked after that, of a second model."""
        ...

    def look(self, data: Dataset, item: SceneItem) -> Looked:
        """Asks, reads, and accounts for it."""
        ...

    def settings(self, data: Dataset) -> Settings:
        """How it asks."""
        ...


def outcomes_of(asker: Asker, questions: Sequence[Question], scene: str) -> list[Outcome]:
    """What becomes of a scene's questions, up to the first that fails: the scene fails with it,
    and those before it are not asked again."""
    out: list[Outcome] = []
    for number, question in enumerate(questions, start=1):
        out.append(asker.ask(question, f"scene {scene}, question {number}"))
        if out[-1].text is None:
            break
    return out


def failed(scene: str, outcomes: Sequence[Outcome]) -> Looked | None:
    """A scene of which a question failed for good; None where none did."""
    why = [one.why for one in outcomes if one.text is None]
    if not why:
        return None
    account = SceneAccount(scene=scene, status="failed", why=told(why), spent=spent(outcomes))
    return Looked(None, account)


def reports_or_raise(looked: Looked) -> tuple[Report, ...]:
    """The reports, for those who have no use for an account. Raises SdgenError."""
    if looked.reports is None:
        why = "; ".join(looked.account.why)
        raise SdgenError(f"scene {looked.account.scene} could not be asked: {why}")
    return looked.reports


def items_of(data: Dataset, twins: bool) -> Iterator[SceneItem]:
    """The scenes, and their twins where these are asked for."""
    for item in data:
        yield from looked_at(item, twins)


def ask_about(
    data: Dataset,
    detector: AskingDetector,
    twins: bool = False,
    threads: int = 4,
    on_scene: Callable[[int, int], None] | None = None,
) -> tuple[dict[str, tuple[Report, ...]], tuple[SceneAccount, ...]]:
    """Reports of every scene that could be asked, and an account of all.

    Raises SdgenError where the endpoint refuses everybody, InputError for bad files.
    """
    _ = data.catalog, data.infos  # read once, not by each thread
    found: dict[str, tuple[Report, ...]] = {}
    accounts: list[SceneAccount] = []
    looked = in_threads(items_of(data, twins), lambda item: detector.look(data, item), threads)
    total = sum(1 for _ in items_of(data, twins))
    for done, one in enumerate(looked, start=1):
        accounts.append(one.account)
        if one.reports is not None:
            found[one.account.scene] = one.reports
        if on_scene is not None:
            on_scene(done, total)
    return found, tuple(sorted(accounts, key=lambda account: account.scene))


def estimate(
    data: Dataset, detector: AskingDetector, twins: bool = False, sample: int | None = None
) -> tuple[Estimate, int]:
    """About what a run is going to ask, and how many of the questions are answered already.

    ``sample``: look at so many scenes, spread evenly, and take the others to be as these.
    """
    items = list(items_of(data, twins))
    step = 1 if sample is None or not sample else max(1, len(items) // sample)
    total, known = Estimate(), 0
    for item in items[::step]:
        questions = detector.questions(data, item)
        total += estimate_of(questions) + detector.more(data, item)
        known += sum(map(detector.asker.knows, questions))
    factor = len(items) / max(1, len(items[::step]))
    return total.times(factor), round(known * factor)
