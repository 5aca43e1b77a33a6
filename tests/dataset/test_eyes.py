"""Perceived graphs of data sets: options, pickling, pictures that are not there."""

import pickle
from dataclasses import replace
from pathlib import Path

import pytest
from sdgen import Dataset, Perception
from sdgen.dataset import SceneItem
from sdgen.errors import InputError, UsageError

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("seen") / "d", n=4)


def names(graph) -> set[int]:
    return {node.id for node in graph.nodes}


def test_a_data_set_hands_its_scenes_eyes(path: Path) -> None:
    data = Dataset(path, graph_view="perceived")
    assert {11, 77, 100, 210, 600} <= names(data[3].shown_graph)
    assert names(data[3].shown_graph) == set(data[3].graph) == set(data.graph(3, "perceived"))
    assert names(data[3].twin.shown_graph) == names(data[3].shown_graph) - {4000, 600}
    # The truth stays what it was.
    assert 65535 in names(data[3].scene_graph)
    assert 65535 not in names(data[3].shown_graph)


def test_perception_goes_with_the_data_set(path: Path) -> None:
    data = Dataset(path, perception=Perception(missed=1.0))
    rooms_and_walls = {100, 101, 200, 201, 202, 210, 211, 212}
    assert set(data.graph(3, "perceived")) == rooms_and_walls
    shown = data.filter(hazard="stove_on")
    assert set(shown.graph(0, "perceived")) == rooms_and_walls
    assert set(Dataset(path).graph(3)) > rooms_and_walls


def test_views_are_chosen(path: Path) -> None:
    kitchen = Dataset(path, perception=Perception(views=(0, 0))).graph(3, "perceived")
    assert 600 in kitchen
    assert 512 not in kitchen
    room = Dataset(path, perception=Perception(views="room")).graph(3, "perceived")
    assert {600, 512} <= set(room)
    with pytest.raises(UsageError, match="scene 000003 has no view 2, only 0 to 1"):
        Dataset(path, perception=Perception(views=(2,))).graph(3, "perceived")


def test_they_can_be_pickled_also_after_use(path: Path) -> None:
    data = Dataset(path, graph_view="perceived", perception=Perception(missed=0.3, seed=4))
    before = data[3].shown_graph
    assert pickle.loads(pickle.dumps(data))[3].shown_graph == before
    item = data[3]
    slim = len(pickle.dumps(item))
    assert pickle.loads(pickle.dumps(item)).shown_graph == before
    assert data.catalog is not None
    assert len(pickle.dumps(data[3])) == slim  # neither catalogue nor models go along


@pytest.mark.parametrize("sensors", [("rgb",), ("rgb", "depth"), ("instance",), ()])
def test_pictures_that_were_never_taken_are_an_error_of_the_input(tmp_path, sensors) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=sensors))
    with pytest.raises(InputError, match="a perceived graph is made of depth and instance") as it:
        Dataset(path, graph_view="perceived")[0].shown_graph  # noqa: B018
    assert len(it.value.problems) == 1
    assert Dataset(path)[0].shown_graph.nodes


def test_a_picture_that_was_changed_is_an_error(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    (path / "scenes/000000/views/00/depth.png").write_bytes(b"no picture")
    with pytest.raises(InputError, match=r"depth\.png: changed since"):
        Dataset(path).graph(0, "perceived")


@pytest.mark.parametrize(
    ("name", "edit", "said"),
    [
        ("views/00/view.json", ('"K": [[', '"K": [[-'), "view.json: K: its focal lengths"),
        ("scene.json", ('"asset": "stove_01"', '"asset": "stove_9"'), "it names 'stove_9', which"),
        ("scene.json", ('"category": "knife"', '"category": "dagger"'), "names 'dagger', which"),
    ],
)
def test_files_that_disagree_are_told_with_their_name(tmp_path: Path, name, edit, said) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    file = path / "scenes/000000" / name
    before = file.read_text()
    assert edit[0] in before
    file.write_text(before.replace(*edit))
    with pytest.raises(InputError, match=said):
        Dataset(path, partial=True).graph(0, "perceived")


def test_an_item_without_eyes_says_so(path: Path) -> None:
    item = replace(Dataset(path)[3], graph_view="perceived", eyes=None)
    with pytest.raises(ValueError, match="no eyes"):
        item.shown_graph  # noqa: B018
    assert isinstance(item, SceneItem)
