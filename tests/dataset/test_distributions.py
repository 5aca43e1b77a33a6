"""Distributions over a data set, against its records."""

from pathlib import Path

import pytest
from sdgen.dataset import Dataset
from sdgen.dataset.distributions import NUMBERS, Spread, distributions
from sdgen.errors import InputError

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=8))
    for picture in made.rglob("*.png"):
        picture.unlink()
    return made


def test_names_are_counted_as_the_records_have_them(path: Path) -> None:
    data = Dataset(path)
    found = distributions(data).names
    counts = data.info.counts
    by_hazard = {k: v for k, v in counts.anomalies_by_hazard.items() if v}
    assert found["anomalies_by_hazard"].counts == by_hazard
    assert sum(found["anomalies_by_room"].counts.values()) == counts.anomalies
    assert sum(found["anomalies_by_notify"].counts.values()) == counts.anomalies
    assert sum(found["lookalikes_by_hazard"].counts.values()) == counts.lookalikes
    assert sum(found["scenes_by_household"].counts.values()) == counts.scenes
    rooms = sum(len(item.scene.home.rooms) for item in data)
    assert sum(found["rooms_by_type"].counts.values()) == rooms


def test_every_number_is_in_one_bin(path: Path) -> None:
    data = Dataset(path)
    found = distributions(data).numbers
    assert set(found) == set(NUMBERS)
    for spread in found.values():
        assert sum(spread.counts) == spread.n
        assert len(spread.counts) == len(spread.edges) - 1
    loose = [t for item in data for t in item.scene.objects if not t.fixed]
    assert found["height_m"].n == len(loose)
    assert found["height_m"].maximum == max(round(t.pose.position_m[2], 4) for t in loose)
    assert found["objects_per_scene"].mean == data.info.counts.objects / 8
    assert found["evidence_pixels"].n == data.info.counts.anomalies
    shown = [max(s.evidence_pixels) for item in data for s in item.visibility.anomalies]
    assert found["evidence_pixels"].minimum == min(shown)
    outline = data[0].scene.home.rooms
    assert found["floor_area_m2"].maximum is not None
    assert found["floor_area_m2"].maximum > len(outline)


def test_of_one_split_and_of_a_data_set_without_views(path: Path, tmp_path: Path) -> None:
    train = distributions(Dataset(path, split="train"))
    assert train.numbers["objects_per_scene"].n == len(Dataset(path, split="train"))
    blind = toy.build(tmp_path / "d", toy.small(n=4, views=0, sensors=()))
    found = distributions(Dataset(blind)).numbers["evidence_pixels"]
    assert found == Spread(
        title=found.title,
        n=0,
        minimum=None,
        median=None,
        mean=None,
        maximum=None,
        edges=found.edges,
        counts=(0,) * len(found.counts),
    )


def test_files_that_disagree_are_one_clear_error(tmp_path: Path) -> None:
    made = toy.build(tmp_path / "d", toy.small(n=1))
    (made / "assets.jsonl").write_text("")
    with pytest.raises(InputError, match=r"is not in assets\.jsonl"):
        distributions(Dataset(made))
