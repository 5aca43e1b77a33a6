"""Scenes by what is in them, without a look at pixels."""

from pathlib import Path

import pytest
from sdgen.dataset import Dataset
from sdgen.errors import InputError

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Without a single picture left: a filter that reads one fails."""
    made = toy.build_with_twins(tmp_path_factory.mktemp("set") / "d", n=8)
    for picture in made.rglob("*.png"):
        picture.unlink()
    return made


def test_by_hazard(path: Path) -> None:
    data = Dataset(path)
    found = data.filter(hazard="sharp_object")
    assert [item.id for item in found] == [
        item.id
        for item in data
        if any(a.hazard == "sharp_object" for a in item.anomalies.anomalies)
    ]
    assert 0 < len(found) < len(data) == 8


def test_twins_go_by_the_hazards_of_their_scene(path: Path) -> None:
    scenes, twins = Dataset(path), Dataset(path, twins=True)
    found = twins.filter(hazard="stove_on")
    assert [item.entry.twin_of for item in found] == [
        item.id for item in scenes.filter(hazard="stove_on")
    ]


def test_by_split_room_and_household_and_all_at_once(path: Path) -> None:
    data = Dataset(path)
    for split in data.info.splits:
        assert {item.entry.split for item in data.filter(split=split)} == {split}
    room = data[0].scene.home.rooms[0].type
    assert len(data.filter(room=room)) == 8
    kind = data[0].household.template
    assert all(i.household.template == kind for i in data.filter(household=kind))
    both = data.filter(hazard="stove_on", split="train", household=kind, room="kitchen")
    assert [item.id for item in both] == [
        item.id
        for item in data
        if item.entry.split == "train"
        and any(a.hazard == "stove_on" for a in item.anomalies.anomalies)
    ]


def test_a_hazard_and_a_room_are_of_the_same_anomaly(path: Path) -> None:
    data = Dataset(path)
    rooms = {room.type for room in data[0].scene.home.rooms}
    for room in rooms:
        wanted = [
            item.id
            for item in data
            for a in item.anomalies.anomalies
            if a.hazard == "stove_on"
            and next(r.type for r in item.scene.home.rooms if r.id == a.room_id) == room
        ]
        assert [item.id for item in data.filter(hazard="stove_on", room=room)] == wanted


def test_by_twin(path: Path, tmp_path: Path) -> None:
    assert len(Dataset(path).filter(twin=True)) == 8
    assert len(Dataset(path).filter(twin=False)) == 0
    alone = toy.build(tmp_path / "d", toy.small(n=2))
    assert len(Dataset(alone).filter(twin=True)) == 0


def test_a_filter_leaves_its_data_set_alone_and_can_be_filtered(path: Path) -> None:
    data = Dataset(path)
    train = data.filter(split="train")
    assert len(train.filter(hazard="stove_on")) <= len(train) < len(data) == 8
    assert train.split == "train"
    assert "scenes of train" in repr(train) or "scene of train" in repr(train)


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ({"hazard": "stove_one"}, "no hazard 'stove_one' in this data set .*'stove_on'"),
        ({"split": "trian"}, "no split 'trian' .*'train'"),
        ({"room": "kitchn"}, "no room type 'kitchn' .*'kitchen'"),
        ({"household": "nobody"}, "no household 'nobody' in these scenes"),
    ],
)
def test_words_nobody_knows_are_named(path: Path, asked: dict[str, str], words: str) -> None:
    with pytest.raises(InputError, match=words):
        Dataset(path).filter(**asked)  # type: ignore[arg-type]


def test_a_scene_knows_its_twin(path: Path) -> None:
    item = Dataset(path)[3]
    assert item.twin is not None
    assert item.twin.id == "000003-twin"
    assert item.twin.twin is None
    assert not item.twin.anomalies.anomalies
