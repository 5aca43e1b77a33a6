"""A model that sees: what it is shown, and what its boxes mean."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from PIL import Image
from sdgen.chat.question import Question
from sdgen.dataset import Dataset, SceneItem
from sdgen.detectors.pictured import Pictured, shows_pictures

from tests import toy

from .asking import Scripted


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=4)))


def pictured(says: Callable[[Question], str | None], **more: object) -> tuple[Pictured, Scripted]:
    asker = Scripted(says)
    return Pictured(asker, **more), asker  # type: ignore[arg-type]


def stove(item: SceneItem) -> tuple[int, tuple[int, int, int, int]]:
    """The stove's id, and its box in view 0."""
    (number,) = (node.id for node in item.scene_graph.nodes if node.class_name == "stove")
    (box,) = (seen.bbox for seen in item.visibility.views[0].objects if seen.object_id == number)
    return number, box


def test_a_question_a_room_with_all_its_views_or_one_a_view(data: Dataset) -> None:
    for per, pictures in (("room", [1, 1]), ("view", [1, 1])):
        detector, _ = pictured(lambda q: "none", per=per)
        asked = detector.questions(data, data[3])
        assert [len(question.pictures) for question in asked] == pictures
        assert "a view of the kitchen of a home, 160 pixels wide and 120 high" in asked[0].text
        assert "living room" in asked[1].text


def test_pictures_are_the_views_made_small(data: Dataset) -> None:
    detector, _ = pictured(lambda q: "none", picture_width=80)
    question = detector.questions(data, data[3])[0]
    content = base64.b64decode(question.pictures[0].url().partition(",")[2])
    with Image.open(io.BytesIO(content)) as image:
        assert (image.size, image.format) == ((80, 60), "PNG")
    assert "80 pixels wide and 60 high" in question.text


@pytest.mark.parametrize("unit", ["pixels", "thousandths"])
def test_a_box_around_an_object_reports_it(data: Dataset, unit: str) -> None:
    number, (x, y, w, h) = stove(data[3])
    wide, high = (80 / 160, 60 / 120) if unit == "pixels" else (1000 / 160, 1000 / 120)
    box = f"[{x * wide:.1f}, {y * high:.1f}, {w * wide:.1f}, {h * high:.1f}]"
    detector, _ = pictured(
        lambda q: f"picture 1: {box}: 'unsafe': a lit stove" if "kitchen" in q.text else "none",
        picture_width=80,
        unit=unit,
    )
    looked = detector.look(data, data[3])
    assert looked.reports is not None
    assert [(one.object_id, one.label) for one in looked.reports] == [(number, "unsafe")]
    assert (looked.account.status, looked.account.boxes, looked.account.unmatched) == (
        "answered",
        1,
        0,
    )


def test_boxes_on_nothing_are_counted_and_report_nothing(data: Dataset) -> None:
    answers = "picture 1: [500, 500, 9, 9]: 'unsafe'\npicture 9: [1, 1, 9, 9]: 'unsafe'"
    detector, _ = pictured(lambda q: answers)
    looked = detector.look(data, data[3])
    assert looked.reports == ()
    assert (looked.account.boxes, looked.account.unmatched) == (4, 4)


def test_with_the_graph_things_may_be_named_by_number(data: Dataset) -> None:
    number, _ = stove(data[3])

    def says(question: Question) -> str:
        numbers = re.findall(r"^\[(\d+)\] stove", question.text, re.M)
        return "\n".join(f"[{n}]: 'unsafe'" for n in numbers) or "[64000]: 'unsafe'"

    looked = pictured(says, with_graph=True)[0].look(data, data[3])
    assert looked.reports is not None
    assert [one.object_id for one in looked.reports] == [number]
    # The number that is nothing of the room was never shown.
    assert (looked.account.invented, looked.account.invented_examples) == (1, ("[64000]",))
    assert "[" + str(number) not in pictured(says)[0].questions(data, data[3])[0].text


def test_the_filter_and_the_prompt_hold_for_pictures_too(data: Dataset) -> None:
    _, (x, y, w, h) = stove(data[2])
    line = f"picture 1: [{x}, {y}, {w}, {h}]: 'unsafe for children'"
    for household, said, notify in (
        ("filter", line, "silent"),
        ("none", line, "now"),
        ("prompt", f"{line} (summary)", "summary"),
    ):
        detector, asker = pictured(
            lambda q, said=said: said, household=household, picture_width=160
        )  # type: ignore[misc]
        reports = detector(data, data[2])
        assert reports[0].notify == notify
        assert asker.questions[0].text.startswith("Who lives") is (household == "prompt")


@pytest.mark.parametrize(
    ("said", "status"),
    [
        ("none", "answered"),
        ("Turtles!", "unparsable"),
        ("picture 1: [1, 2, 3, 4]: scary", "partly"),
    ],
)
def test_answers_are_counted_as_what_they_are(data: Dataset, said: str, status: str) -> None:
    assert pictured(lambda q: said)[0].look(data, data[1]).account.status == status


def test_a_data_set_without_pictures_shows_none(data: Dataset, tmp_path: Path) -> None:
    assert shows_pictures(data)
    assert not shows_pictures(Dataset(toy.build(tmp_path / "d", toy.small(n=1, sensors=()))))
