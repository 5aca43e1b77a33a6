"""``sdgen detect`` with a method that asks a language model: estimate, run, account."""

from __future__ import annotations

import math
import os
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import click

from sdgen.cli.quiet import hint
from sdgen.errors import UsageError

if TYPE_CHECKING:
    from sdgen.chat.asker import Asker
    from sdgen.chat.tokens import Estimate, Price
    from sdgen.dataset import Dataset
    from sdgen.detectors.account import Account
    from sdgen.detectors.asked import AskingDetector

#: Before a run so many scenes are looked at for its estimate.
_SAMPLE = 20
_MODEL = "{model}"


@dataclass(frozen=True)
class Asking:
    """The options of ``asking_options``, by name."""

    models: tuple[str, ...]
    base_url: str | None
    household: Any
    batch: int | None
    plain_names: bool
    relations: str
    parser: str | None
    per: Any
    with_graph: bool
    boxes: Any
    picture_width: int
    temperature: float | str
    max_tokens: int | None
    timeout: float
    concurrency: int
    retries: int
    longest_wait: float
    price_in: float | None
    price_out: float | None
    estimate_only: bool
    cache: Path | None
    replay: bool

    def check(self, output: Path | None) -> None:
        """Raises UsageError for options that make no sense together, SdgenError for an output that
        cannot be."""
        from sdgen.dataset.output_file import check_output
        from sdgen.detectors.account import account_path

        for name in ("timeout", "longest_wait", "price_in", "price_out"):
            value = getattr(self, name)
            if value is not None and not math.isfinite(value):
                raise UsageError(f"--{name.replace('_', '-')}: {value} is no number")
        if self.base_url is not None:
            check_address(self.base_url)
        if not self.models:
            raise UsageError("say which model to ask: --model NAME")
        if (self.price_in is None) != (self.price_out is None):
            raise UsageError("--price-in and --price-out: give both, or neither")
        if not (self.estimate_only or self.replay or self.key):
            raise UsageError(
                "no OPENAI_API_KEY: set it (to any word, where the endpoint wants none); "
                "--estimate and --replay need none"
            )
        if output is None:
            return
        if output == Path("-"):
            raise UsageError("'-': the account goes beside the predictions; name a file")
        for place in self.outputs(output).values():
            check_output(place)
            check_output(account_path(place))

    @property
    def key(self) -> str:
        """The key of the endpoint, empty where there is none."""
        return os.environ.get("OPENAI_API_KEY", "").strip()

    @property
    def price(self) -> Price | None:
        """What tokens cost, None where that is not said."""
        from sdgen.chat.tokens import Price

        if self.price_in is None or self.price_out is None:
            return None
        return Price(self.price_in, self.price_out)

    def outputs(self, output: Path) -> dict[str, Path]:
        """The predictions file of each model. Raises UsageError where two have one."""
        models = tuple(dict.fromkeys(self.models))
        out = {
            model: output.with_name(output.name.replace(_MODEL, _file_name(model)))
            for model in models
        }
        if len(set(out.values())) < len(models):
            example = f"{output.stem}-{_MODEL}{output.suffix}"
            raise UsageError(f"several models, one file: put {_MODEL} in its name, -o {example}")
        return out


def check_address(url: str) -> None:
    """Raises UsageError for what is no address of an endpoint."""
    try:
        parts = urlsplit(url)
        good = parts.scheme in ("http", "https") and bool(parts.hostname)
        _ = parts.port  # raises for one beyond 65535
    except ValueError:
        good = False
    if not good:
        raise UsageError(f"--base-url {url!r}: no address of an endpoint (http://HOST:PORT/v1)")


def _file_name(model: str) -> str:
    return re.sub(r"[^A-Za-z0-9._-]+", "-", model).strip("-.") or "model"


def detect_asking(
    data: Dataset, method: str, output: Path | None, twins: bool, asking: Asking
) -> None:
    """Ask each model about each scene, and write predictions and accounts.

    Raises AskIncomplete where some scenes could not be asked, when all is written.
    """
    from sdgen.detectors.account import AskIncomplete

    outputs = asking.outputs(output) if output else dict.fromkeys(asking.models)
    _check_data(data, method, asking)
    accounts: dict[str, Account] = {}
    lost: list[str] = []
    for model, place in outputs.items():
        detector = _detector(method, model, place, asking)
        _tell_estimate(data, detector, twins, asking)
        if not asking.estimate_only and place is not None:
            accounts[model] = _one_model(data, detector, twins, asking, place)
            lost += _lost(accounts[model])
    if len(accounts) > 1:
        _table(accounts)
    if lost:
        raise AskIncomplete("; ".join(lost))


def _check_data(data: Dataset, method: str, asking: Asking) -> None:
    from sdgen.detectors.pictured import shows_pictures
    from sdgen.detectors.prompts import PROMPTS

    if method == "views" and not shows_pictures(data):
        raise UsageError(f"{data.path}: has no colour pictures, which 'views' shows")
    if asking.parser and (method == "views" or not PROMPTS[method].categories):
        raise UsageError(f"--parser is for methods with categories and relations, not {method!r}")


def _detector(method: str, model: str, place: Path | None, asking: Asking) -> AskingDetector:
    """The detector of a model, with the cache of its output."""
    from sdgen.chat.cache import Cache
    from sdgen.detectors.pictured import Pictured
    from sdgen.detectors.prompted import BATCH, Prompted
    from sdgen.detectors.prompts import PROMPTS
    from sdgen.detectors.relation_strings import Wording

    folder = asking.cache or (place.with_name(f"{place.name}.cache") if place else None)
    cache = Cache(folder) if folder else None
    asker = _asker(model, asking, cache)
    wording = Wording(states=not asking.plain_names, more=asking.relations == "more")
    if method == "views":
        return Pictured(
            asker,
            household=asking.household,
            per=asking.per,
            with_graph=asking.with_graph,
            unit=asking.boxes,
            picture_width=asking.picture_width,
            wording=wording,
        )
    return Prompted(
        PROMPTS[method],
        asker,
        household=asking.household,
        wording=wording,
        batch=BATCH if asking.batch is None else asking.batch,
        parser=_asker(asking.parser, asking, cache) if asking.parser else None,
    )


def _asker(model: str, asking: Asking, cache: Any) -> Asker:
    from sdgen.chat.asker import Asker
    from sdgen.chat.endpoint import Endpoint
    from sdgen.chat.patience import Patience

    endpoint = Endpoint(
        model=model,
        key=asking.key,
        base_url=asking.base_url or None,
        temperature=None if isinstance(asking.temperature, str) else asking.temperature,
        timeout_s=asking.timeout,
        max_tokens=asking.max_tokens,
    )
    patience = Patience(asking.retries, longest_s=asking.longest_wait)
    return Asker(endpoint, cache, patience, asking.replay)


def _tell_estimate(data: Dataset, detector: AskingDetector, twins: bool, asking: Asking) -> None:
    """Say what the run is about to take: on standard output where that is all that is asked."""
    from sdgen.detectors.asked import estimate

    sample = None if asking.estimate_only else _SAMPLE
    found, known = estimate(data, detector, twins, sample)
    words = f"{detector.asker.endpoint.model}: {_estimated(found, asking.price)}"
    if known:
        words += f"; {known:,} of the questions are answered already"
    if asking.estimate_only:
        click.echo(words)
    else:
        hint(words)


def _estimated(found: Estimate, price: Price | None) -> str:
    words = (
        f"about {found.questions:,} questions, {found.tokens_in:,} tokens to ask and "
        f"{found.tokens_out:,} to answer (letters by four)"
    )
    if price is not None:
        words += f", at your prices {price.of(found.tokens_in, found.tokens_out):,.2f}"
    return words


def _one_model(
    data: Dataset, detector: AskingDetector, twins: bool, asking: Asking, place: Path
) -> Account:
    from sdgen.benchmark import prediction_bytes
    from sdgen.cli.bar import bar
    from sdgen.cli.scoring import scoring
    from sdgen.dataset.output_file import write_output
    from sdgen.dataset.text import record_bytes
    from sdgen.detectors.account import account_of, account_path
    from sdgen.detectors.asked import ask_about

    with bar("asking") as on_scene:
        found, scenes = ask_about(data, detector, twins, asking.concurrency, on_scene)
    said = prediction_bytes(found) if found or not scenes else None
    account = account_of(detector.settings(data), scenes, asking.price, said)
    path = account_path(place)
    hint(f"{place}: {_in_words(account)}")
    if said is None and place.exists():
        # Not over those of a run that went well, nor over their account.
        hint(f"no scene was answered: {place} stays as it was")
        return account
    if said is not None:
        write_output(place, said)
    write_output(path, record_bytes(account))
    hint(f"how it went, scene by scene: {path}")
    if said is None:
        hint(f"no scene was answered: {place} is not written")
        return account
    hint(f"score them: {scoring(data, place)}")
    return account


def _in_words(account: Account) -> str:
    """What became of the scenes, and what it took."""
    spent = account.spent
    by = ", ".join(f"{count} {status}" for status, count in account.scenes_by_status.items())
    words = f"{len(account.scenes)} scenes: {by}; {account.unlabelled:,} without a class, "
    words += f"{account.invented:,} invented"
    if account.boxes:
        words += f", {account.unmatched:,} of {account.boxes:,} boxes on nothing"
    words += f"; {spent.questions:,} questions, {spent.cached:,} of them known without asking, "
    words += f"{spent.retries:,} retries, {spent.tokens_in:,} tokens asked and "
    words += f"{spent.tokens_out:,} answered"
    if spent.estimated:
        words += f" (letters by four of {spent.estimated:,} questions)"
    if account.cost is not None and account.paid is not None:
        words += f", cost {account.cost:,.2f}, of it now {account.paid:,.2f}"
    return words


def _lost(account: Account) -> list[str]:
    """Which scenes could not be asked, and why; nothing where all could."""
    lost = [one for one in account.scenes if one.why]
    if not lost:
        return []
    failed = sum(one.status == "failed" for one in lost)
    some = f", {len(lost) - failed} only in part" if len(lost) > failed else ""
    why = Counter(one.why[0] for one in lost)
    reasons = ", ".join(f"{text} ({count})" for text, count in why.most_common(3))
    return [
        f"model {account.settings.model!r}: {failed} of {len(account.scenes)} scenes could "
        f"not be asked{some}: {reasons}; the same command asks them again"
    ]


def _table(accounts: dict[str, Account]) -> None:
    """How it went with each model."""
    from rich.table import Column, Table

    from sdgen.cli.table import echo_table
    from sdgen.detectors.account import STATUSES

    table = Table(Column("model", no_wrap=True), *STATUSES, "invented", "tokens", "cost")
    for model, account in accounts.items():
        spent = account.spent
        table.add_row(
            model,
            *(str(account.scenes_by_status[status]) for status in STATUSES),
            f"{account.invented:,}",
            f"{spent.tokens_in + spent.tokens_out:,}",
            "-" if account.cost is None else f"{account.cost:,.2f}",
        )
    settings = next(iter(accounts.values())).settings
    table.title = f"{settings.title}, household: {settings.household}, graph: {settings.graph_view}"
    echo_table(table)
