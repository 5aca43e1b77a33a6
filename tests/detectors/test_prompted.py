"""The paper's detectors: what is asked, what comes of the answers, and how it is accounted for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from sdgen.chat.question import Question
from sdgen.dataset import Dataset
from sdgen.dataset.records import Report
from sdgen.detectors.asked import ask_about, estimate
from sdgen.detectors.prompted import Prompted
from sdgen.detectors.prompts import PROMPTS
from sdgen.detectors.relation_strings import Wording, Words
from sdgen.detectors.who import who_lives_here
from sdgen.errors import SdgenError

from tests import toy
from tests.chat.unreliable import asked_in, good_answer

from .asking import Scripted

PAPER = [name for name in PROMPTS if name != "views"]


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=4, sensors=())))


def answer(question: Question) -> str:
    return good_answer(question.text, 0)


def prompted(
    method: str, says: Callable[[Question], str | None] = answer, **more: object
) -> tuple[Prompted, Scripted]:
    asker = Scripted(says)
    return Prompted(PROMPTS[method], asker, **more), asker  # type: ignore[arg-type]


def named(data: Dataset, scene: int, name: str) -> set[int]:
    return {n.id for n in data[scene].scene_graph.nodes if n.class_name == name}


@pytest.mark.parametrize("method", PAPER)
def test_each_method_finds_what_a_model_says(data: Dataset, method: str) -> None:
    detector, _ = prompted(method)
    found, accounts = ask_about(data, detector, threads=2)
    assert set(found) == {item.id for item in data}
    assert [one.status for one in accounts] == ["answered"] * 4
    # Scene 1 has a child and two knives: one on the shelf, and the lit stove.
    knives = named(data, 1, "knife")
    said = {report.object_id: report for report in found["000001"]}
    assert knives <= set(said)
    wanted = "unsafe for children" if PROMPTS[method].categories else "unsafe"
    assert {said[number].label for number in knives} == {wanted}
    assert {said[number].notify for number in knives} == {"now"}


def test_every_thing_is_asked_about_once_in_questions_of_nearly_one_size(data: Dataset) -> None:
    detector, asker = prompted("cot-sg-c", batch=3)
    looked = detector.look(data, data[3])
    asked = [asked_in(question.text) for question in asker.questions]
    strings = [piece.text for piece in Words(data[3].shown_graph).relations()]
    assert [string for some in asked for string in some] == strings
    assert {len(some) for some in asked} <= {2, 3}
    assert looked.account.asked == len(strings)
    whole, once = prompted("cot-sg-c", batch=0)
    whole.look(data, data[3])
    assert len(once.questions) == 1


def test_the_question_is_the_papers_with_the_strings_in_it(data: Dataset) -> None:
    detector, asker = prompted("cot-sg-c")
    detector.look(data, data[0])
    (question,) = asker.questions
    before, after = PROMPTS["cot-sg-c"].template.split("[CONTENT]")
    assert question.text.startswith(f"{before}['")
    assert question.text.endswith(f"']{after}")


def test_without_children_the_filter_keeps_what_concerns_them_to_itself(data: Dataset) -> None:
    """Scene 2 has no child: the paper's filter."""
    knives = named(data, 2, "knife")
    for household, notify in (("filter", "silent"), ("none", "now")):
        detector, _ = prompted("cot-sg-c", household=household)
        said = {one.object_id: one.notify for one in detector(data, data[2])}
        assert {said[number] for number in knives} == {notify}


def test_a_household_in_the_prompt_is_told_as_the_model_says(data: Dataset) -> None:
    def says(question: Question) -> str:
        assert question.text.startswith(
            "Who lives in this home: adult (38 years), adult (36 years)"
        )
        strings = asked_in(question.text)
        return "\n".join(
            f"'{s}': 'unsafe' ({'summary' if 'knife' in s else 'now'})" for s in strings
        )

    detector, _ = prompted("cot-sg-c", says, household="prompt")
    said = {one.object_id: one.notify for one in detector(data, data[2])}
    assert {said[number] for number in named(data, 2, "knife")} == {"summary"}
    assert {said[number] for number in named(data, 2, "stove")} == {"now"}


def test_who_lives_here_tells_wishes_and_nothing_of_the_scene(data: Dataset) -> None:
    who = toy.household(5).model_copy(
        update={
            "opt_outs": ("sanitation",),
            "notifications": {"stove_on": "now", "spill": "silent"},
        }
    )
    words = who_lives_here(who, data.catalog)
    assert "child (5 years)" in words
    assert "not want to hear of: sanitation; Spilled liquid." in words
    assert "hear at once of: Stove left on." in words


def test_a_string_that_stands_for_several_things_reports_them_all(data: Dataset) -> None:
    detector, _ = prompted("object-list", lambda q: "'knife': 'unsafe'")
    looked = detector.look(data, data[2])
    assert looked.reports is not None
    assert {one.object_id for one in looked.reports} == named(data, 2, "knife")
    assert len(looked.reports) == 2


def test_the_second_model_reads_the_first_ones_lines(data: Dataset) -> None:
    parser = Scripted(
        lambda q: "Unsanitary." if "knife" in q.text.rpartition("\n")[2] else "normal"
    )
    detector, _ = prompted("cot-sg-c", parser=parser)
    looked = detector.look(data, data[2])
    assert looked.reports is not None
    assert {one.object_id for one in looked.reports} == named(data, 2, "knife")
    assert {one.label for one in looked.reports} == {"unsanitary"}
    assert len(parser.questions) == looked.account.asked
    assert all("one word classification" in question.text for question in parser.questions)
    assert looked.account.spent.questions == 1 + len(parser.questions)
    assert detector.settings(data).parser == "scripted"


def test_a_second_model_that_does_not_answer_leaves_strings_without_a_class(data: Dataset) -> None:
    parser = Scripted(lambda q: None if "knife" in q.text else "normal")
    looked = prompted("cot-sg-c", parser=parser)[0].look(data, data[2])
    assert looked.reports == ()
    assert (looked.account.status, looked.account.unlabelled) == ("partly", 2)
    assert looked.account.why == ("503: gone",)


@pytest.mark.parametrize(
    ("says", "status", "unlabelled", "invented"),
    [
        (lambda q: answer(q)[: len(answer(q)) // 2], "partly", True, 0),
        (lambda q: "I like turtles.", "unparsable", True, 0),
        (lambda q: f"'unicorn INSIDE hall': 'unsafe'\n{answer(q)}", "answered", False, 1),
        (lambda q: answer(q).replace("'normal'", "'harmless'"), "partly", True, 0),
    ],
)
def test_bad_answers_are_counted_as_what_they_are(
    data: Dataset, says: Callable[[Question], str], status: str, unlabelled: bool, invented: int
) -> None:
    detector, _ = prompted("cot-sg-c", says)
    looked = detector.look(data, data[1])
    assert looked.reports is not None
    one = looked.account
    assert (one.status, one.unlabelled > 0, one.invented) == (status, unlabelled, invented)
    assert one.labelled + one.unlabelled == one.asked
    ids = {node.id for node in data[1].scene_graph.nodes}
    assert {report.object_id for report in looked.reports} <= ids


def test_a_scene_that_cannot_be_asked_is_silent_and_named(data: Dataset) -> None:
    lost = data[2].id
    strings = {piece.text for piece in Words(data[2].shown_graph).relations()}
    detector, _ = prompted(
        "cot-sg-c", lambda q: None if set(asked_in(q.text)) == strings else answer(q)
    )
    found, accounts = ask_about(data, detector)
    assert set(found) == {item.id for item in data} - {lost}
    (failed,) = [one for one in accounts if one.status == "failed"]
    assert (failed.scene, failed.why, failed.spent.failed) == (lost, ("503: gone",), 1)
    with pytest.raises(SdgenError, match=f"scene {lost} could not be asked: 503: gone"):
        detector(data, data[2])


def test_it_is_shown_what_the_graph_view_shows(data: Dataset) -> None:
    neutral = Dataset(data.path, graph_view="neutral")
    full, plain = prompted("cot-sg-c")[0], prompted("cot-sg-c", wording=Wording(states=False))[0]
    texts = [
        detector.questions(some, some[3])[0].text
        for some, detector in ((data, full), (neutral, full), (data, plain))
    ]
    assert "stove (on)" in texts[0]
    assert "stove (on)" not in texts[1]
    assert texts[1] == texts[2]
    assert full.settings(neutral).graph_view == "neutral"


def test_the_estimate_is_near_what_is_asked(data: Dataset) -> None:
    detector, asker = prompted("cot-sg-c", batch=4)
    about, known = estimate(data, detector)
    ask_about(data, detector)
    assert about.questions == len(asker.questions)
    letters = sum(len(question.text) for question in asker.questions)
    assert about.tokens_in == pytest.approx(letters / 4, rel=0.05)
    assert known == 0


def test_twins_are_asked_about_where_that_is_wanted(tmp_path: Path) -> None:
    data = Dataset(toy.build_with_twins(tmp_path / "d", n=2))
    detector, _ = prompted("sg-c")
    assert set(ask_about(data, detector)[0]) == {"000000", "000001"}
    found, accounts = ask_about(data, detector, twins=True)
    assert "000001-twin" in found
    assert {one.scene for one in accounts} == set(found)


def test_no_label_of_the_scene_is_read(data: Dataset, tmp_path: Path) -> None:
    """Detectors see graph and household; anomalies.json could as well not be there."""
    path = toy.build(tmp_path / "d", toy.small(n=2, sensors=()))
    for file in path.glob("scenes/*/anomalies.json"):
        file.unlink()
    found, _ = ask_about(Dataset(path), prompted("cot-sg-c")[0])
    assert any(isinstance(one, Report) for reports in found.values() for one in reports)
