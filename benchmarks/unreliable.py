"""Do all methods that ask a language model get through with an endpoint that is unreliable?

Run: ``python benchmarks/unreliable.py [DATASET] [--scenes 20] [--concurrency 8]``.
Asks about a data set (without one: toy scenes that it makes) with the paper's seven methods, one
of them with a second model that parses, and with pictures in four ways, against a server on this
machine that is late, drops connections, refuses and answers nonsense on purpose
(``tests/chat/unreliable.py``). Then again, with the answers that were kept. Exit 1 unless every
scene is answered or accounted for, no answer is asked for twice, and what was predicted stays.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from sdgen import Dataset
from sdgen.chat.asker import Asker
from sdgen.chat.cache import Cache
from sdgen.chat.endpoint import Endpoint
from sdgen.chat.patience import Patience
from sdgen.detectors.account import STATUSES, Account, account_of
from sdgen.detectors.asked import AskingDetector, ask_about
from sdgen.detectors.pictured import Pictured, shows_pictures
from sdgen.detectors.prompted import Prompted
from sdgen.detectors.prompts import PROMPTS

from tests import toy
from tests.chat.unreliable import Unreliable, unreliable

#: Small, so that what is late is late soon: the server is late by more.
TIMEOUT_S, LATE_S = 1.0, 1.5
PATIENCE = Patience(retries=4, first_s=0.02, longest_s=0.2)


@dataclass
class Row:
    """One method's line of the table, and what is wrong with it."""

    name: str
    account: Account
    again: Account
    seconds: float
    wrong: list[str] = field(default_factory=list)


def detectors(url: str, folder: Path, pictures: bool) -> dict[str, AskingDetector]:
    """All of them by name, each with a cache of its own."""

    def asker(name: str, model: str = "turtle") -> Asker:
        endpoint = Endpoint(model, "any", url, 0.0, TIMEOUT_S)
        return Asker(endpoint, Cache(folder / name), PATIENCE)

    paper = [name for name in PROMPTS if name != "views"]
    out: dict[str, AskingDetector] = {n: Prompted(PROMPTS[n], asker(n)) for n in paper}
    out["cot-sg-c, prompt"] = Prompted(PROMPTS["cot-sg-c"], asker("who"), household="prompt")
    both = asker("two"), asker("two", "small")
    out["cot-sg-c, parser"] = Prompted(PROMPTS["cot-sg-c"], both[0], parser=both[1])
    if pictures:
        for graph in (False, True):
            out["views, room" + ", graph" * graph] = Pictured(
                asker(f"room{graph}"), with_graph=graph
            )
            out["views, view" + ", graph" * graph] = Pictured(
                asker(f"view{graph}"), per="view", with_graph=graph
            )
    return out


def tried(
    name: str, detector: AskingDetector, data: Dataset, fake: Unreliable, threads: int
) -> Row:
    """A method against the endpoint, then again, then from the cache alone."""
    begin = time.monotonic()
    found, scenes = ask_about(data, detector, threads=threads)
    seconds = time.monotonic() - begin
    answers = dict(fake.answered)
    settings = detector.settings(data)
    again, scenes_again = ask_about(data, detector, threads=threads)
    row = Row(name, account_of(settings, scenes), account_of(settings, scenes_again), seconds)
    ids = {item.id for item in data}
    if {one.scene for one in scenes} != ids:
        row.wrong.append("scenes without an account")
    failed = {one.scene for one in scenes if one.status == "failed"}
    if any(one.spent.questions < 1 for one in scenes):
        row.wrong.append("a scene that nobody was asked about")
    if set(found) != ids - failed:
        row.wrong.append("predictions and account disagree")
    if any(one.status == "failed" and not one.why for one in scenes):
        row.wrong.append("a failure without a reason")
    # Where the second model did not answer, it is asked again.
    whole = [one.scene for one in scenes if not one.why]
    if any(found[scene] != again.get(scene) for scene in whole):
        row.wrong.append("another prediction the second time")
    twice = [
        key for key, count in fake.answered.items() if key in answers and count != answers[key]
    ]
    if twice:
        row.wrong.append(f"{len(twice)} answers asked for twice")
    return row


def table(rows: Sequence[Row], scenes: int) -> None:
    """Print it."""
    print(f"{scenes} scenes each")
    print(
        f"| method | {' | '.join(STATUSES)} | failed again | no class | invented | boxes on "
        "nothing | questions | retries | s |"
    )
    print("|---|" + "---:|" * (len(STATUSES) + 8))
    for row in rows:
        one = row.account
        cells = [
            *(one.scenes_by_status[status] for status in STATUSES),
            row.again.scenes_by_status["failed"],
            one.unlabelled,
            one.invented,
            f"{one.unmatched} of {one.boxes}" if one.boxes else "-",
            one.spent.questions,
            one.spent.retries,
            f"{row.seconds:.1f}",
        ]
        print(f"| {row.name} | {' | '.join(map(str, cells))} |")


def main() -> int:
    """Print the table; the exit status."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("dataset", nargs="?", type=Path)
    parser.add_argument("--scenes", type=int, default=20)
    parser.add_argument("--concurrency", type=int, default=8)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as name, unreliable(Unreliable(LATE_S)) as fake:
        folder = Path(name)
        path = args.dataset or toy.build(folder / "toy", toy.small(n=args.scenes))
        data = Dataset(path)
        data.shown = data.shown[: args.scenes]
        every = detectors(fake.url, folder / "answers", shows_pictures(data))
        rows = [tried(n, one, data, fake, args.concurrency) for n, one in every.items()]
        table(rows, len(data))
        print("the server:", ", ".join(f"{k} {v}" for k, v in sorted(fake.did.items())))
    wrong = [f"{row.name}: {text}" for row in rows for text in row.wrong]
    print(*(wrong or ["every scene is answered or accounted for"]), sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
