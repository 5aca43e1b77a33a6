"""Answers on disk, a file a question: a run that was stopped asks nothing twice."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from pydantic import Field

from sdgen.chat.endpoint import Answer
from sdgen.chat.question import digest_of
from sdgen.dataset.output_file import refuse_data_set, refuse_links, write_output
from sdgen.dataset.text import record_bytes, to_record
from sdgen.errors import InputError, SdgenError
from sdgen.files import read_plain
from sdgen.scene import Record

#: As large as a question and its answer may be, escaped.
_MAX_BYTES = 8_000_000


class Asked(Record):
    """A question as it is kept: all that decides its answer, a picture by its digest."""

    model: str
    text: str
    pictures: tuple[str, ...] = ()
    temperature: float | None = None
    max_tokens: int | None = None


class Kept(Record):
    """A file of the cache: what was asked and what was answered."""

    request: Asked
    answer: str = Field(min_length=1)
    tokens_in: int | None = Field(default=None, ge=0)
    tokens_out: int | None = Field(default=None, ge=0)
    cut: bool = False


class Cache:
    """A folder of answers, named by the digests of their questions. Only answers are kept: what
    failed is asked again. Raises SdgenError for a place that is no folder, or a data set's."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        refuse_links(folder, "folder")
        refuse_data_set(folder / "x")
        if folder.exists() and not folder.is_dir():
            raise SdgenError(f"{folder}: is no folder; name another place for the answers")

    def path(self, request: dict[str, Any]) -> Path:
        """Where the answer to a request is, or would be."""
        return self.folder / f"{digest_of(request)}.json"

    def get(self, request: dict[str, Any]) -> Answer | None:
        """The answer to a request, None where there is none yet. Raises InputError, located, for a
        file that is not what we write, or that answers another question."""
        path = self.path(request)
        if not os.path.lexists(path):
            return None
        try:
            kept = to_record(Kept, read_plain(path, str(path), _MAX_BYTES, links=False), str(path))
            if digest_of(kept.request.model_dump(mode="json")) != path.stem:
                raise InputError([f"{path}: answers another question than its name says"])
        except InputError as error:
            again = [f"{line}; take the file away to ask again" for line in error.problems]
            raise InputError(again) from None
        return Answer(kept.answer, kept.tokens_in, kept.tokens_out, kept.cut)

    def put(self, request: dict[str, Any], answer: Answer) -> None:
        """Keep an answer, whole or not at all."""
        kept = Kept(
            request=Asked(**{**request, "pictures": tuple(request["pictures"])}),
            answer=answer.text,
            tokens_in=answer.tokens_in,
            tokens_out=answer.tokens_out,
            cut=answer.cut,
        )
        write_output(self.path(request), record_bytes(kept))
