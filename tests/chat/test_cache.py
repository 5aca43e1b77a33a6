"""Answers on disk: found again, refused when they are a stranger's invention."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from sdgen.chat.cache import Cache
from sdgen.chat.endpoint import Answer, Endpoint
from sdgen.chat.question import Picture, Question, request_of
from sdgen.errors import InputError, SdgenError

from tests import toy

HERE = Endpoint("small", "secret", "http://here/v1", 0)
QUESTION = Question("what?", (Picture("abc 10x10", 10, 10, lambda: ("image/png", b"x")),))
ANSWER = Answer("an answer, ünicode \u2028", 7, None, True)


def test_an_answer_is_found_again_whoever_was_asked(tmp_path: Path) -> None:
    cache = Cache(tmp_path / "c")
    request = request_of(HERE, QUESTION)
    assert cache.get(request) is None
    cache.put(request, ANSWER)
    there = Endpoint("small", "other", "http://there/v1", 0.0)
    assert Cache(tmp_path / "c").get(request_of(there, QUESTION)) == ANSWER
    (path,) = (tmp_path / "c").iterdir()
    assert "secret" not in path.read_text()
    assert "here" not in path.read_text()


@pytest.mark.parametrize(
    "other",
    [
        request_of(Endpoint("large", "k", None, 0), QUESTION),
        request_of(Endpoint("small", "k", None, 0.5), QUESTION),
        request_of(Endpoint("small", "k", None, None), QUESTION),
        request_of(Endpoint("small", "k", None, 0, max_tokens=5), QUESTION),
        request_of(HERE, Question("what?")),
        request_of(HERE, Question("what now?", QUESTION.pictures)),
    ],
)
def test_another_question_is_another(tmp_path: Path, other: dict[str, object]) -> None:
    cache = Cache(tmp_path)
    cache.put(request_of(HERE, QUESTION), ANSWER)
    assert cache.get(other) is None


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda text: text[:40], "not JSON"),
        (lambda text: text.replace("what?", "what else?"), "another question"),
        (lambda text: text.replace('"cut": true', '"cut": 3'), "cut"),
        (lambda text: json.dumps({**json.loads(text), "more": 1}), "more"),
        (lambda text: json.dumps({**json.loads(text), "answer": ""}), "answer"),
        (lambda text: json.dumps({**json.loads(text), "tokens_in": -5}), "tokens_in"),
    ],
)
def test_a_file_that_is_none_of_ours_is_named(tmp_path: Path, change, words: str) -> None:  # type: ignore[no-untyped-def]
    cache = Cache(tmp_path)
    request = request_of(HERE, QUESTION)
    cache.put(request, ANSWER)
    path = cache.path(request)
    path.write_text(change(path.read_text()))
    with pytest.raises(InputError, match=words) as caught:
        cache.get(request)
    assert str(path) in str(caught.value)
    assert "take the file away" in str(caught.value)


def test_places_that_are_no_folder_for_answers(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    (tmp_path / "link").symlink_to(tmp_path)
    data = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    for place in (tmp_path / "file", tmp_path / "link", data / "scenes" / "c"):
        with pytest.raises(SdgenError):
            Cache(place)
