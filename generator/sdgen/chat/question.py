"""A question to a model: its text, the pictures it is about, and the digest it is known by."""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from sdgen.chat.endpoint import Endpoint, Message


@dataclass(frozen=True)
class Picture:
    """A picture, encoded when it is sent. ``digest`` says which it is, whatever encodes it, so
    that an answer is found again where another version of a package packs other bytes."""

    digest: str
    width: int
    height: int
    encoded: Callable[[], tuple[str, bytes]] = field(compare=False)

    def url(self) -> str:
        """``data:image/png;base64,...``"""
        media, content = self.encoded()
        return f"data:{media};base64,{base64.b64encode(content).decode('ascii')}"


@dataclass(frozen=True)
class Question:
    """``text`` and what it is about; ``answer_tokens``: so long an answer is to be expected."""

    text: str
    pictures: tuple[Picture, ...] = ()
    answer_tokens: int = 1

    def messages(self) -> list[Message]:
        """The conversation that asks it."""
        if not self.pictures:
            return [{"role": "user", "content": self.text}]
        parts: list[dict[str, Any]] = [{"type": "text", "text": self.text}]
        parts += [{"type": "image_url", "image_url": {"url": p.url()}} for p in self.pictures]
        return [{"role": "user", "content": parts}]


def request_of(endpoint: Endpoint, question: Question) -> dict[str, Any]:
    """What decides an answer, a picture by its digest: not who is asked for it, nor with what
    key."""
    return {
        "model": endpoint.model,
        "text": question.text,
        "pictures": [picture.digest for picture in question.pictures],
        "temperature": None if endpoint.temperature is None else float(endpoint.temperature),
        "max_tokens": endpoint.max_tokens,
    }


def digest_of(request: dict[str, Any]) -> str:
    """SHA-256 of a request, 64 hex digits."""
    text = json.dumps(request, sort_keys=True, ensure_ascii=True, allow_nan=False)
    return hashlib.sha256(text.encode("ascii")).hexdigest()
