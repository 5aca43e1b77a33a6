"""Asks an OpenAI-compatible endpoint. What it answers is a stranger's, and so is how it fails."""

from __future__ import annotations

import base64
import contextlib
import json
import math
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from urllib.parse import quote

from sdgen.errors import SdgenError, UsageError, one_line

#: An answer of 200 kB, escaped and with what is said about it.
_MAX_BYTES = 1_500_000
#: More tokens than any answer or question has: a count beyond it is nonsense.
_MAX_TOKENS = 10_000_000

#: What is shorter is no key.
_LEAST_KEY = 8

#: A message as the protocol has it: its role, its content (text, or parts with pictures).
Message = dict[str, Any]


@dataclass(frozen=True)
class Endpoint:
    """Whom to ask: ``base_url`` None is the client's own default (or its environment variable).
    ``timeout_s`` is for the whole answer; of a refusal, between two packets of it."""

    model: str
    key: str
    base_url: str | None = None
    temperature: float | None = None
    timeout_s: float = 120.0
    max_tokens: int | None = None


@dataclass(frozen=True)
class Answer:
    """What a model said. Tokens None where the endpoint does not count them; ``cut``: it stopped
    because it had said as much as it may."""

    text: str
    tokens_in: int | None = None
    tokens_out: int | None = None
    cut: bool = False


class AskFailed(SdgenError):
    """A question that got no answer. ``status``: of HTTP, None where nothing came so far; ``why``
    without whom was asked; ``retry_after_s``: when to come back, as the endpoint has it; ``final``:
    asking again is in vain."""

    def __init__(
        self,
        text: str,
        why: str = "",
        status: int | None = None,
        retry_after_s: float | None = None,
        final: bool = False,
    ) -> None:
        super().__init__(text)
        self.why = why
        self.status = status
        self.retry_after_s = retry_after_s
        self.final = final


def ask(endpoint: Endpoint, prompt: str) -> str:
    """The answer to a prompt. Raises AskFailed, one line, for whatever goes wrong; ImportError
    where the client is not installed."""
    return answer_to(endpoint, [{"role": "user", "content": prompt}]).text


def client_of(endpoint: Endpoint) -> Any:
    """The client for an endpoint, which threads may share. Raises UsageError for a key that is
    none, AskFailed for an address that is none."""
    import openai

    if not (endpoint.key.isascii() and endpoint.key.isprintable()):
        raise UsageError(
            "OPENAI_API_KEY holds what no key has: letters beyond ASCII, or a line end"
        )
    try:
        return openai.OpenAI(
            api_key=endpoint.key,
            base_url=endpoint.base_url,
            timeout=endpoint.timeout_s,
            max_retries=0,
        )
    except Exception as error:
        raise _failed(endpoint, str(error) or type(error).__name__, final=True) from None


def answer_to(endpoint: Endpoint, messages: Sequence[Message], client: Any = None) -> Answer:
    """The answer to a conversation; ``client``: one at hand. Raises as ``ask``."""
    import openai

    client = client_of(endpoint) if client is None else client
    more: dict[str, Any] = {}
    if endpoint.temperature is not None:
        more["temperature"] = endpoint.temperature
    if endpoint.max_tokens is not None:
        more["max_tokens"] = endpoint.max_tokens
    try:
        with client.chat.completions.with_streaming_response.create(
            model=endpoint.model, messages=list(messages), **more
        ) as response:
            body = _bounded(response, endpoint.timeout_s)
    except openai.APIStatusError as error:
        raise _refused(endpoint, error) from None
    except Exception as error:
        # A body cut short is told by what carries the client, another package in each version.
        if "Timeout" in type(error).__name__:
            late = f"no answer within {endpoint.timeout_s:g} s (--timeout)"
            raise _failed(endpoint, late) from None
        raise _failed(endpoint, str(error.__cause__ or error) or type(error).__name__) from None
    return _answer(endpoint, body)


def _bounded(response: Any, timeout_s: float) -> bytes:
    """The body, as far as the limits allow. The client's own time limit is between two packets."""
    until = time.monotonic() + timeout_s
    body = bytearray()
    for piece in response.iter_bytes():
        body += piece
        if len(body) > _MAX_BYTES:
            raise ValueError(f"it answers more than {_MAX_BYTES // 1000} kB")
        if time.monotonic() > until:
            raise TimeoutError
    return bytes(body)


def _answer(endpoint: Endpoint, body: bytes) -> Answer:
    reply: Any = None
    choice: Any = None
    content = None
    with contextlib.suppress(ValueError, RecursionError, LookupError, TypeError):
        reply = json.loads(body)
        choice = reply["choices"][0]
        content = choice["message"]["content"]
    if not isinstance(content, str) or not content.strip():
        declined = _declined(choice)
        if declined:
            raise _failed(endpoint, f"the model declines to answer: {declined}", final=True)
        raise _failed(endpoint, "its reply holds no answer (choices[0].message.content)")
    usage = reply.get("usage")
    return Answer(
        # Half of a pair of surrogates is no text: a model may say it, a file cannot.
        text=_masked(content.encode("utf-8", "replace").decode("utf-8"), endpoint.key),
        tokens_in=_count(usage, "prompt_tokens"),
        tokens_out=_count(usage, "completion_tokens"),
        cut=choice.get("finish_reason") == "length",
    )


def _declined(choice: Any) -> str:
    """Why a model gives no answer on purpose, empty where it does not say so."""
    if not isinstance(choice, dict):
        return ""
    message = choice.get("message")
    said = message.get("refusal") if isinstance(message, dict) else None
    if isinstance(said, str) and said.strip():
        return said
    return "content_filter" if choice.get("finish_reason") == "content_filter" else ""


def _count(usage: Any, name: str) -> int | None:
    """Tokens as an endpoint counts them; None for what is no count."""
    value = usage.get(name) if isinstance(usage, dict) else None
    if not isinstance(value, int) or isinstance(value, bool):
        return None
    return value if 0 <= value <= _MAX_TOKENS else None


def _refused(endpoint: Endpoint, error: Any) -> AskFailed:
    """What an endpoint says of its refusal, and when it may be asked again."""
    body = error.body if isinstance(error.body, dict) else {}
    message = body.get("message")
    told = message if isinstance(message, str) else str(error.message)
    after = None
    with contextlib.suppress(ValueError, TypeError):
        after = float(error.response.headers.get("retry-after"))
    return _failed(
        endpoint,
        f"{error.status_code}: {told}",
        status=int(error.status_code),
        retry_after_s=after if after is not None and math.isfinite(after) and after >= 0 else None,
        # Said with the same number as "slower, please", and no waiting helps.
        final=body.get("code") == "insufficient_quota",
    )


def _masked(text: str, key: str) -> str:
    """What an endpoint says, without the key that it was sent: it may be kept, and shown. (Any
    short word may stand for a key where none is wanted.) Also as gateways echo it: quoted for an
    address, in JSON, or in base64."""
    if len(key) < _LEAST_KEY:
        return text
    quoted = {key, quote(key, safe=""), json.dumps(key)[1:-1], key.replace("/", "\\/")}
    coded = {base64.b64encode(one.encode()).decode().rstrip("=") for one in (key, f"Bearer {key}")}
    for form in sorted(quoted | coded, key=len, reverse=True):
        text = text.replace(form, "***")
    return text


def _failed(endpoint: Endpoint, why: str, **more: Any) -> AskFailed:
    where = endpoint.base_url or "the default endpoint"
    why = one_line(_masked(why, endpoint.key))
    text = f"{one_line(where)}: model {one_line(endpoint.model)!r}: {why}"
    return AskFailed(text, why, **more)
