"""What became of each scene that a language model was asked about: a file beside predictions."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Literal

from pydantic import Field

from sdgen.chat.asker import Outcome
from sdgen.chat.tokens import Price
from sdgen.dataset.disk import sha256_hex
from sdgen.dataset.graph_views import GraphView
from sdgen.dataset.records import SHA256
from sdgen.dataset.text import read_bytes, read_record
from sdgen.detectors.who import Entry
from sdgen.errors import InputError, SdgenError, one_line
from sdgen.perception import Perception
from sdgen.scene import Record

#: ``answered``: in full; ``partly``: some of it has no label or cannot be read (or the second model
#: did not answer, and ``why``); ``unparsable``: nothing of it can be read; ``failed``: a question
#: of it got no answer, and ``why``: it has no line among the predictions.
Status = Literal["answered", "partly", "unparsable", "failed"]
STATUSES: tuple[Status, ...] = ("answered", "partly", "unparsable", "failed")

#: Of what a model invents and of why questions fail, so many are told.
_TOLD = 5


class AskIncomplete(SdgenError):
    """Some scenes could not be asked; predictions and account of the others are written."""

    exit_code = 3


class Spent(Record):
    """Questions and what they took. ``estimated``: of how many the endpoint counted no tokens, so
    that letters are counted by four. ``cached``: answered before this run."""

    questions: int = 0
    failed: int = 0
    cached: int = 0
    retries: int = 0
    cut: int = 0
    estimated: int = 0
    tokens_in: int = 0
    tokens_out: int = 0
    paid_tokens_in: int = 0
    paid_tokens_out: int = 0

    def __add__(self, other: Spent) -> Spent:
        names = type(self).model_fields
        return Spent(**{name: getattr(self, name) + getattr(other, name) for name in names})


def spent(outcomes: Iterable[Outcome]) -> Spent:
    """What these questions took; ``paid``: in this run."""
    out = Spent()
    for one in outcomes:
        answered = one.text is not None
        out += Spent(
            questions=1,
            failed=int(not answered),
            cached=int(one.cached),
            retries=one.retries,
            cut=int(one.cut),
            estimated=int(answered and not one.counted),
            tokens_in=one.tokens_in,
            tokens_out=one.tokens_out,
            paid_tokens_in=0 if one.cached else one.tokens_in,
            paid_tokens_out=0 if one.cached else one.tokens_out,
        )
    return out


class SceneAccount(Record):
    """One scene. ``asked``: strings, ``labelled``: those that were answered for, ``unlabelled``:
    those named, or to be named, without a class; ``invented``: answers for what was never asked;
    ``unreadable``: answers nothing could be read of. With pictures: ``boxes`` it drew, and
    ``unmatched``: those on nothing."""

    scene: str
    status: Status
    why: tuple[str, ...] = ()
    asked: int = 0
    labelled: int = 0
    unlabelled: int = 0
    invented: int = 0
    invented_examples: tuple[str, ...] = ()
    unreadable: int = 0
    boxes: int = 0
    unmatched: int = 0
    spent: Spent = Spent()


class Settings(Record):
    """How it was asked: what a table must say beside the scores."""

    method: str
    title: str
    reconstruction: bool
    model: str
    parser: str | None = None
    household: Entry
    graph_view: GraphView
    perception: Perception | None = None
    batch: int | None = None
    plain_names: bool | None = None
    more_relations: bool | None = None
    per: str | None = None
    with_graph: bool | None = None
    boxes: str | None = None
    picture_width: int | None = None
    temperature: float | None = None
    max_tokens: int | None = None
    prompt_sha256: str


class Account(Record):
    """``<predictions>.account.json``. ``cost``: of all answers, ``paid``: of those of this run, in
    the currency of the prices; None without prices. ``predictions_sha256``: of the file it is the
    account of; None where no scene was answered, and none was written."""

    settings: Settings
    predictions_sha256: str | None = Field(default=None, pattern=SHA256)
    scenes_by_status: dict[str, int]
    spent: Spent
    asked: int
    labelled: int
    unlabelled: int
    invented: int
    unreadable: int
    boxes: int
    unmatched: int
    price_in: float | None = Field(default=None, ge=0)
    price_out: float | None = Field(default=None, ge=0)
    cost: float | None = None
    paid: float | None = None
    scenes: tuple[SceneAccount, ...]


def account_of(
    settings: Settings,
    scenes: Sequence[SceneAccount],
    price: Price | None = None,
    predictions: bytes | None = None,
) -> Account:
    """The account of all scenes, sorted by their ids, and of the bytes of their predictions."""
    total = sum((one.spent for one in scenes), Spent())
    names = ("asked", "labelled", "unlabelled", "invented", "unreadable", "boxes", "unmatched")
    return Account(
        settings=settings,
        predictions_sha256=None if predictions is None else sha256_hex(predictions),
        scenes_by_status={s: sum(one.status == s for one in scenes) for s in STATUSES},
        spent=total,
        **{name: sum(getattr(one, name) for one in scenes) for name in names},
        price_in=price.per_million_in if price else None,
        price_out=price.per_million_out if price else None,
        cost=price.of(total.tokens_in, total.tokens_out) if price else None,
        paid=price.of(total.paid_tokens_in, total.paid_tokens_out) if price else None,
        scenes=tuple(sorted(scenes, key=lambda one: one.scene)),
    )


def account_path(predictions: Path) -> Path:
    """``p.jsonl`` -> ``p.jsonl.account.json``."""
    return predictions.with_name(f"{predictions.name}.account.json")


def read_account(predictions: Path) -> Account | None:
    """The account beside a file of predictions, None where there is none. Raises InputError for one
    that is not of these predictions."""
    path = account_path(predictions)
    if not os.path.lexists(path):
        return None
    account = read_record(Account, path, str(path))
    data = read_bytes(predictions, str(predictions))
    if account.predictions_sha256 != sha256_hex(data):
        raise InputError([f"{path}: is the account of other predictions than {predictions.name}"])
    return account


def drop_account(predictions: Path) -> None:
    """Take away the account of predictions that others have just replaced; what is none stays."""
    path = account_path(predictions)
    with contextlib.suppress(InputError):
        read_record(Account, path, str(path))
        path.unlink()


def told(texts: Iterable[str]) -> tuple[str, ...]:
    """The first few different ones of strangers' texts, a line each."""
    return tuple(dict.fromkeys(map(one_line, texts)))[:_TOLD]
