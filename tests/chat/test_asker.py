"""Asking patiently: again where it may help, never where it may not, and not for ever."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.chat.asker import GIVE_UP_AFTER, GONE_AFTER, Asker
from sdgen.chat.cache import Cache
from sdgen.chat.endpoint import Endpoint
from sdgen.chat.patience import Patience
from sdgen.chat.question import Picture, Question
from sdgen.errors import InputError, SdgenError

from .endpoint import Fake, endpoint
from .unreliable import Unreliable, unreliable

pytest.importorskip("openai")


def asker(url: str, cache: Path | None = None, **more: object) -> tuple[Asker, list[float]]:
    """One that waits for nothing, and the waits that it would have."""
    waits: list[float] = []
    where = Cache(cache) if cache else None
    patience = Patience(retries=3)
    there = Endpoint("small", "k", url, 0.0, timeout_s=5.0)
    return Asker(there, where, patience, sleep=waits.append, **more), waits  # type: ignore[arg-type]


def test_a_refusal_that_passes_is_tried_again_and_one_that_does_not_is_not() -> None:
    for status, tries in ((500, 4), (429, 4), (400, 1), (404, 1)):
        with endpoint(Fake(b'{"error": {"message": "no"}}', status)) as fake:
            asking, waits = asker(fake.url)
            outcome = asking.ask(Question("?"))
        assert (outcome.text, outcome.why) == (None, f"{status}: no")
        assert len(fake.asked) == tries
        assert len(waits) == outcome.retries == tries - 1


def test_money_that_is_gone_is_not_waited_for() -> None:
    body = b'{"error": {"message": "pay", "code": "insufficient_quota"}}'
    with endpoint(Fake(body, 429)) as fake:
        asking, waits = asker(fake.url)
        assert asking.ask(Question("?")).why == "429: pay"
    assert (len(fake.asked), waits) == (1, [])


def test_what_a_model_declines_is_not_asked_again() -> None:
    body = b'{"choices": [{"message": {"content": null, "refusal": "I may not"}}]}'
    with endpoint(Fake(body)) as fake:
        outcome = asker(fake.url)[0].ask(Question("?"))
    assert (len(fake.asked), outcome.why) == (1, "the model declines to answer: I may not")


def test_an_endpoint_that_refuses_everybody_is_left_alone() -> None:
    with endpoint(Fake(b'{"error": {"message": "no such key"}}', 401)) as fake:
        asking, _ = asker(fake.url)
        for number in range(GIVE_UP_AFTER):
            assert asking.ask(Question(f"{number}")).text is None
        with pytest.raises(SdgenError, match=r"401: no such key .*nobody is asked further"):
            asking.ask(Question("one more"))
    assert len(fake.asked) == GIVE_UP_AFTER


def test_one_that_is_gone_is_not_asked_for_hours() -> None:
    with endpoint(Fake(b"", 503)) as fake:
        asking, _ = asker(fake.url)
        outcomes = [asking.ask(Question(f"{number}")) for number in range(GONE_AFTER + 5)]
    assert len(fake.asked) == 4 * GONE_AFTER
    assert all("not asked" in outcome.why for outcome in outcomes[GONE_AFTER:])


def test_an_answer_is_asked_for_once(tmp_path: Path) -> None:
    with endpoint(Fake().says("yes")) as fake:
        first = asker(fake.url, tmp_path)[0].ask(Question("what is it?"))
        again = asker(fake.url, tmp_path)[0].ask(Question("what is it?"))
    assert (first.text, first.cached, again.text, again.cached) == ("yes", False, "yes", True)
    assert len(fake.asked) == 1
    # Nobody counted: letters by four, rounded up.
    assert (first.tokens_in, first.tokens_out, first.counted) == (3, 1, False)


def test_a_failure_is_not_kept(tmp_path: Path) -> None:
    with endpoint(Fake(b"<html>")) as fake:
        assert asker(fake.url, tmp_path / "c")[0].ask(Question("?")).text is None
        fake.says("yes")
        assert asker(fake.url, tmp_path / "c")[0].ask(Question("?")).text == "yes"


def test_a_replay_asks_nobody_and_names_what_is_missing(tmp_path: Path) -> None:
    with endpoint(Fake().says("yes")) as fake:
        asker(fake.url, tmp_path)[0].ask(Question("?"))
        replay, _ = asker(fake.url, tmp_path, replay=True)
        assert replay.ask(Question("?")).text == "yes"
        with pytest.raises(InputError, match="scene 7, question 2 was never answered") as caught:
            replay.ask(Question("else?"), "scene 7, question 2")
    assert str(tmp_path) in str(caught.value)
    assert len(fake.asked) == 1


def test_pictures_go_as_data_urls() -> None:
    picture = Picture("d", 2, 2, lambda: ("image/png", b"\x89PNG"))
    with endpoint(Fake().says("yes")) as fake:
        asker(fake.url)[0].ask(Question("see?", (picture,)))
    (message,) = fake.asked[0]["messages"]
    assert message["content"] == [
        {"type": "text", "text": "see?"},
        {"type": "image_url", "image_url": {"url": "data:image/png;base64,iVBORw=="}},
    ]


def test_with_an_endpoint_that_is_unreliable_every_question_has_an_outcome() -> None:
    with unreliable(Unreliable(late_s=0.0)) as fake:
        asking, _ = asker(fake.url)
        outcomes = [asking.ask(Question(f"Q: Classify - ['mug {k}']")) for k in range(150)]
    failed = [one for one in outcomes if one.text is None]
    assert sum(one.retries for one in outcomes) > 20
    assert 0 < len(failed) < 20
    assert all(one.why for one in failed)
    assert {"429", "500", "leaves", "html", "half a reply", "empty"} <= set(fake.did)
