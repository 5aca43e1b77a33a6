"""Remedies and things in words."""

from types import SimpleNamespace
from typing import get_args

from sdgen.catalog.hazard_yaml import Action
from sdgen.gallery.labels import names_of
from sdgen.gallery.words import deed
from sdgen.hazards.twin import TAKE_AWAY

from tests import toy


def test_whatever_undoes_an_anomaly_has_words() -> None:
    for action in (*get_args(Action), TAKE_AWAY):
        said = deed(action, None)
        assert " it" in said, action  # a sentence of ours, not the word of the catalogue
        assert "{" not in said + deed(action, "mug 3")
    assert deed("put_in", "wall cabinet 3") == "put it into wall cabinet 3"
    assert deed("throw_away", None) == "throw it away"
    assert deed("polish", "mug 3") == "polish mug 3"


def test_a_twins_page_calls_what_it_lacks_as_its_scene_does() -> None:
    whole = toy.scene(3)
    first, *others = whole.objects
    scene = SimpleNamespace(scene=whole)
    twin = SimpleNamespace(scene=whole.model_copy(update={"objects": tuple(others)}))
    called = f"{first.category} {first.id}".replace("_", " ")
    assert names_of(twin)(first.id) == f"node {first.id}"  # type: ignore[arg-type]
    assert names_of(twin, scene)(first.id) == called  # type: ignore[arg-type]
