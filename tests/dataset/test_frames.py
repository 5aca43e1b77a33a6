"""Views as arrays, in other processes too: pickled, forked, spawned, and by PyTorch's loader."""

import multiprocessing
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sdgen.dataset import Dataset
from sdgen.errors import UsageError

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=4))


def total(frame: dict[str, Any]) -> int:
    """Something of the pixels: a transform that pickles."""
    return int(frame["rgb"].sum())


def test_an_item_a_view_with_its_pixels_and_boxes(path: Path) -> None:
    data = Dataset(path)
    frames = data.frames(pixels=("rgb", "depth", "instance", "part"))
    assert len(frames) == data.info.counts.views == len(list(frames))
    for k, frame in enumerate(frames):
        item = data[k // 2]
        view = k % 2
        assert (frame["scene"], frame["view"]) == (item.id, view)
        for name in ("rgb", "depth", "instance", "part"):
            assert np.array_equal(frame[name], getattr(item, name)(view))
            assert frame[name].flags.writeable  # torch warns of others
        shown = item.visibility.views[view].objects
        assert frame["object_ids"].tolist() == [o.object_id for o in shown]
        assert frame["boxes"].tolist() == [list(o.bbox) for o in shown]
        wrong = {a.object_id: a.hazard for a in item.anomalies.anomalies}
        assert frame["hazards"] == [
            [wrong[o.object_id]] if o.object_id in wrong else [] for o in shown
        ]
    with pytest.raises(IndexError):
        frames[len(frames)]


def test_of_filtered_scenes_only(path: Path) -> None:
    some = Dataset(path).filter(hazard="stove_on")
    assert {frame["scene"] for frame in some.frames()} == {item.id for item in some}


def test_what_was_not_built_is_refused(tmp_path: Path, path: Path) -> None:
    blind = toy.build(tmp_path / "d", toy.small(n=1, sensors=("rgb",)))
    with pytest.raises(UsageError, match="'instance': this data set was built without it"):
        Dataset(blind).frames()
    with pytest.raises(UsageError, match=r"no 'rbg' .*'rgb'"):
        Dataset(path).frames(pixels=("rbg",))


@pytest.mark.parametrize("how", ["fork", "spawn"])
def test_other_processes_read_the_same(path: Path, how: str) -> None:
    frames = Dataset(path).frames(transform=total)
    assert frames[0] > 0  # used here first: nothing that was read is in the way there
    context = multiprocessing.get_context(how)
    with context.Pool(2) as pool:
        found = pool.map(frames.__getitem__, range(len(frames)))
    assert found == list(frames)


def test_pickled_after_use(path: Path) -> None:
    frames = Dataset(path).frames(transform=total)
    _ = frames[1], frames.scenes[1].scene_graph
    assert pickle.loads(pickle.dumps(frames))[1] == frames[1]


@pytest.mark.parametrize("workers", [0, 2])
def test_the_loader_of_pytorch_feeds_from_it(path: Path, workers: int) -> None:
    torch = pytest.importorskip("torch")
    frames = Dataset(path).frames(pixels=("rgb",), transform=lambda frame: frame["rgb"])
    loader = torch.utils.data.DataLoader(
        frames,
        batch_size=3,
        num_workers=workers,
        multiprocessing_context="fork" if workers else None,
    )
    batches = list(loader)
    assert [len(batch) for batch in batches] == [3, 3, 2]
    assert torch.equal(torch.cat(batches)[5], torch.from_numpy(Dataset(path)[2].rgb(1)))
    scenes = torch.utils.data.DataLoader(
        Dataset(path),
        batch_size=2,
        num_workers=workers,
        collate_fn=list,
        multiprocessing_context="fork" if workers else None,
    )
    ids = [item.id for batch in scenes for item in batch]
    assert ids == [item.id for item in Dataset(path)]


def test_sdgen_does_not_import_torch(path: Path) -> None:
    code = (
        "import sys, sdgen\n"
        f"sdgen.Dataset({str(path)!r}).frames()[0]\n"
        "assert not {'torch', 'pandas', 'datasets'} & set(sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
