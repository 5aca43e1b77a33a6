"""Asking an endpoint: the answer, or one clear line for whatever else comes back."""

from __future__ import annotations

import json
import time

import pytest
from sdgen.chat import endpoint as asking
from sdgen.chat.endpoint import Endpoint, ask
from sdgen.errors import SdgenError, UsageError

from .endpoint import Fake, endpoint

pytest.importorskip("openai")


def asked(fake: Fake, **more: object) -> str:
    with endpoint(fake) as there:
        return ask(Endpoint("small", "k", there.url, **more), "what else?")  # type: ignore[arg-type]


def test_the_answer_is_what_the_model_says() -> None:
    fake = Fake().says("- {place: vase}")
    assert asked(fake, temperature=0.5) == "- {place: vase}"
    (request,) = fake.asked
    assert request["model"] == "small"
    assert request["messages"] == [{"role": "user", "content": "what else?"}]
    assert request["temperature"] == 0.5
    assert fake.keys == ["Bearer k"]


def test_what_is_not_asked_for_is_not_sent() -> None:
    fake = Fake().says("x")
    asked(fake)
    assert set(fake.asked[0]) == {"model", "messages"}


def failure(fake: Fake, **more: object) -> str:
    with pytest.raises(SdgenError) as caught:
        asked(fake, **more)
    text = str(caught.value)
    assert "\n" not in text
    assert "\x1b" not in text
    assert len(text) < 800
    return text


@pytest.mark.parametrize(
    ("status", "body", "told"),
    [
        (401, b'{"error": {"message": "no such key"}}', "401: no such key"),
        (
            404,
            b'{"error": {"message": "no model\\n\\u001b[31m small"}}',
            "404: no model [31m small",
        ),
        (400, b"<html>" + b"x" * 100_000, "400: "),
        (200, b"", "holds no answer"),
        (200, b"<html>", "holds no answer"),
        (200, b"[" * 100_000, "holds no answer"),
        (200, b'{"choices": []}', "holds no answer"),
        (200, b'{"choices": 3}', "holds no answer"),
        (200, b'{"choices": [{"message": {"content": null}}]}', "holds no answer"),
        (200, b'{"choices": [{"message": {"content": 7}}]}', "holds no answer"),
        (200, b'{"choices": [{"message": {"content": "  "}}]}', "holds no answer"),
        (200, b" " * 2_000_000, "answers more than 1500 kB"),
        (200, json.dumps({"choices": [NotImplemented.__class__.__name__]}).encode(), "no answer"),
    ],
)
def test_a_bad_reply_is_one_line(status: int, body: bytes, told: str) -> None:
    assert told in failure(Fake(body, status))


def test_nobody_there_and_no_address() -> None:
    for url, told in (("http://127.0.0.1:1/v1", "refused"), ("nowhere", "protocol")):
        with pytest.raises(SdgenError, match=told) as caught:
            ask(Endpoint("small", "k", url, timeout_s=5), "?")
        assert url in str(caught.value)


def test_an_answer_that_drips_ends_with_the_time_it_has() -> None:
    fake = Fake(drip_s=0.2)
    fake.says("x" * 1000)
    start = time.monotonic()
    assert "no answer within 1 s (--timeout)" in failure(fake, timeout_s=1.0)
    assert time.monotonic() - start < 10


@pytest.mark.parametrize("key", ["schlüssel", "a\nb"])
def test_a_key_that_is_none_is_said_and_not_shown(key: str) -> None:
    with pytest.raises(UsageError, match="OPENAI_API_KEY") as caught:
        ask(Endpoint("small", key), "?")
    assert key not in str(caught.value)


def test_the_limit_holds_what_an_answer_may_be() -> None:
    from sdgen.proposals.answer import MAX_BYTES

    assert asking._MAX_BYTES > 6 * MAX_BYTES
