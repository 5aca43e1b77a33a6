"""Asks an OpenAI-compatible endpoint. What it answers is a stranger's, and so is how it fails."""

from __future__ import annotations

import json
import time
from dataclasses import dataclass
from typing import Any

from sdgen.errors import SdgenError, UsageError, one_line

#: An answer of 200 kB, escaped and with what is said about it.
_MAX_BYTES = 1_500_000


@dataclass(frozen=True)
class Endpoint:
    """Whom to ask: ``base_url`` None is the client's own default (or its environment variable).
    ``timeout_s`` is for the whole answer; of a refusal, between two packets of it."""

    model: str
    key: str
    base_url: str | None = None
    temperature: float | None = None
    timeout_s: float = 120.0


def ask(endpoint: Endpoint, prompt: str) -> str:
    """The answer to a prompt. Raises SdgenError, one line, for whatever goes wrong; ImportError
    where the client is not installed."""
    import openai

    if not (endpoint.key.isascii() and endpoint.key.isprintable()):
        raise UsageError(
            "OPENAI_API_KEY holds what no key has: letters beyond ASCII, or a line end"
        )
    more: dict[str, Any] = {}
    if endpoint.temperature is not None:
        more["temperature"] = endpoint.temperature
    try:
        client = openai.OpenAI(
            api_key=endpoint.key,
            base_url=endpoint.base_url,
            timeout=endpoint.timeout_s,
            max_retries=0,
        )
        with client.chat.completions.with_streaming_response.create(
            model=endpoint.model, messages=[{"role": "user", "content": prompt}], **more
        ) as response:
            body = _bounded(response, endpoint.timeout_s)
    except openai.APIStatusError as error:
        raise _failed(endpoint, f"{error.status_code}: {_told(error)}") from None
    except Exception as error:
        # A body cut short is told by what carries the client, another package in each version.
        if "Timeout" in type(error).__name__:
            late = f"no answer within {endpoint.timeout_s:g} s (--timeout)"
            raise _failed(endpoint, late) from None
        raise _failed(endpoint, str(error.__cause__ or error) or type(error).__name__) from None
    return _content(endpoint, body)


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


def _content(endpoint: Endpoint, body: bytes) -> str:
    try:
        content = json.loads(body)["choices"][0]["message"]["content"]
    except (ValueError, RecursionError, LookupError, TypeError):
        content = None
    if not isinstance(content, str) or not content.strip():
        raise _failed(endpoint, "its reply holds no answer (choices[0].message.content)")
    return content


def _told(error: Any) -> str:
    """What an endpoint says of its refusal."""
    body = error.body if isinstance(error.body, dict) else {}
    message = body.get("message")
    return message if isinstance(message, str) else str(error.message)


def _failed(endpoint: Endpoint, why: str) -> SdgenError:
    where = endpoint.base_url or "the default endpoint"
    return SdgenError(f"{one_line(where)}: model {one_line(endpoint.model)!r}: {one_line(why)}")
