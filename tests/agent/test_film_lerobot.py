"""A LeRobot data set: consistent by itself, and read by LeRobot where it is installed."""

from __future__ import annotations

import io
import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from sdgen.agent.film import lerobot as ours
from sdgen.agent.film.lerobot import Pictures, write_lerobot
from sdgen.agent.film.lerobot_rows import RGB
from sdgen.agent.film.steps import ACTIONS
from sdgen.errors import SdgenError

from tests.agent import film

pytest.importorskip("pyarrow")
av = pytest.importorskip("av")

EPISODES = (film.episode(8), film.episode(5, scene="000007"), film.episode(2))
LENGTHS = [7, 4, 1]
FPS = 10


def table(path: Path) -> Any:
    import pyarrow.parquet as pq

    return pq.read_table(path)


@pytest.fixture(scope="module", params=["video", "image"])
def written(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("lerobot") / request.param
    write_lerobot(iter(EPISODES), out, FPS, pictures=request.param)
    return out


def test_what_it_says_of_itself_is_what_is_there(written: Path) -> None:
    info = json.loads((written / "meta/info.json").read_text())
    assert info["codebase_version"] == "v3.0"
    assert (info["total_episodes"], info["total_frames"], info["fps"]) == (3, 12, FPS)
    assert info["splits"] == {"train": "0:3"}
    rows = table(written / "data/chunk-000/file-000.parquet")
    kept = {name for name, of in info["features"].items() if of["dtype"] != "video"}
    assert set(rows.column_names) == kept
    assert rows["index"].to_pylist() == list(range(12))
    assert rows["episode_index"].to_pylist() == [0] * 7 + [1] * 4 + [2]
    assert info["features"][RGB]["shape"] == [48, 64, 3]


def test_the_index_of_episodes_leads_to_their_rows(written: Path) -> None:
    episodes = table(written / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    assert [row["length"] for row in episodes] == LENGTHS
    assert [row["dataset_from_index"] for row in episodes] == [0, 7, 11]
    assert [row["dataset_to_index"] for row in episodes] == [7, 11, 12]
    stats = json.loads((written / "meta/stats.json").read_text())
    for name, of in stats.items():
        low, high = np.array(of["min"], dtype=float), np.array(of["max"], dtype=float)
        assert low.shape == (
            (3, 1, 1) if name == RGB else np.shape(episodes[0][f"stats/{name}/min"])
        )
        for key in ("mean", "q01", "q50", "q99"):
            assert np.all(low - 1e-6 <= of[key]), (name, key)
            assert np.all(of[key] <= high + 1e-6), (name, key)
        assert of["count"] == [12]


def test_statistics_are_those_of_all_frames(written: Path) -> None:
    stats = json.loads((written / "meta/stats.json").read_text())
    seen = np.stack([s.rgb for e in EPISODES for s in e.steps[:-1] if s.rgb is not None]) / 255
    assert np.ravel(stats[RGB]["mean"]) == pytest.approx(seen.mean(axis=(0, 1, 2)))
    assert np.ravel(stats[RGB]["std"]) == pytest.approx(seen.std(axis=(0, 1, 2)))
    assert np.ravel(stats[RGB]["max"]) == pytest.approx(seen.max(axis=(0, 1, 2)))


def test_a_frame_is_what_was_seen_before_what_was_done(written: Path) -> None:
    rows = table(written / "data/chunk-000/file-000.parquet").to_pylist()
    pairs = [(a, b) for e in EPISODES for a, b in zip(e.steps[:-1], e.steps[1:], strict=True)]
    for row, (before, after) in zip(rows, pairs, strict=True):
        gaze = before.gaze
        assert row["observation.state"] == pytest.approx(list(gaze), abs=1e-6)
        assert ACTIONS[int(row["action"][3])] == after.action
        assert row["next.reward"] == after.reward
        assert row["next.done"] == after.done
    assert rows[0]["action"][0] == 0.25  # as asked for
    assert rows[1]["action"][1] == -0.5
    assert rows[3]["action"][1] == pytest.approx(0.7)  # what going to the kitchen changed
    assert rows[4]["action"][4] == 305


def test_scenes_and_households_are_kept(written: Path) -> None:
    about = json.loads((written / "meta/sdgen.json").read_text())
    assert [episode["scene"] for episode in about["episodes"]] == ["000003", "000007", "000003"]
    assert about["episodes"][0]["summary"]["found"] == [600]
    assert about["actions"] == list(ACTIONS)


def test_pictures_are_those_seen(written: Path) -> None:
    seen = [step.rgb for episode in EPISODES for step in episode.steps[:-1]]
    if written.name == "image":
        rows = table(written / "data/chunk-000/file-000.parquet")[RGB].to_pylist()
        for row, rgb in zip(rows, seen, strict=True):
            with Image.open(io.BytesIO(row["bytes"])) as image:
                np.testing.assert_array_equal(np.asarray(image), rgb)
        return
    episodes = table(written / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    assert episodes[1][f"videos/{RGB}/from_timestamp"] == 0.7
    assert episodes[1][f"videos/{RGB}/to_timestamp"] == 1.1
    with av.open(str(written / f"videos/{RGB}/chunk-000/file-000.mp4")) as video:
        frames = [frame.to_ndarray(format="rgb24") for frame in video.decode(video=0)]
    for frame, rgb in zip(frames, seen, strict=True):
        assert rgb is not None
        assert np.abs(frame.astype(int) - rgb).mean() < 8


def test_large_data_sets_are_of_several_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ours, "DATA_MB", 0)
    monkeypatch.setattr(ours, "VIDEO_MB", 0)
    write_lerobot(EPISODES, tmp_path / "d", FPS)
    rows = [table(path).num_rows for path in sorted((tmp_path / "d/data").rglob("*.parquet"))]
    assert rows == LENGTHS
    for k, path in enumerate(sorted((tmp_path / "d/videos").rglob("*.mp4"))):
        with av.open(str(path)) as video:
            assert len(list(video.decode(video=0))) == LENGTHS[k]
    episodes = table(tmp_path / "d/meta/episodes/chunk-000/file-000.parquet").to_pylist()
    assert [row["data/file_index"] for row in episodes] == [0, 1, 2]
    assert [row[f"videos/{RGB}/from_timestamp"] for row in episodes] == [0, 0, 0]


@pytest.mark.parametrize(
    ("episodes", "pictures", "says"),
    [
        ((), "video", "no episode"),
        ((film.episode(1),), "video", "nothing was done"),
        ((film.episode(rgb=False),), "video", "no colours"),
        ((film.episode(), film.episode(width=32)), "image", "32x48 pixels, others"),
        ((film.episode(width=33),), "video", "even numbers"),
    ],
)
def test_what_cannot_be_written_leaves_nothing(
    tmp_path: Path, episodes: Any, pictures: Pictures, says: str
) -> None:
    with pytest.raises(SdgenError, match=says):
        write_lerobot(episodes, tmp_path / "d", pictures=pictures)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("package", ["av", "pyarrow"])
def test_a_missing_package_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, package: str
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ModuleNotFoundError):
        write_lerobot(EPISODES, tmp_path / "d")
    assert list(tmp_path.iterdir()) == []


def test_the_client_itself_reads_it(
    written: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HF_HOME", str(tmp_path))
    monkeypatch.setenv("HF_HUB_OFFLINE", "1")
    client = pytest.importorskip("lerobot.datasets.lerobot_dataset")
    backend = "pyav"  # the other one needs FFmpeg's own libraries
    data = client.LeRobotDataset("sdgen/walks", root=written, video_backend=backend)
    assert (data.num_frames, data.num_episodes, data.fps) == (12, 3, FPS)
    assert len(data) == 12
    seen = [step for episode in EPISODES for step in episode.steps[:-1]]
    for k, step in enumerate(seen):
        item = data[k]
        assert item[RGB].shape == (3, 48, 64)
        rgb = item[RGB].numpy().transpose(1, 2, 0) * 255
        assert np.abs(rgb - step.rgb).mean() < (8 if written.name == "video" else 1e-3)
        state = [step.gaze.x_m, step.gaze.y_m, step.gaze.yaw_rad, step.gaze.pitch_rad]
        assert item["observation.state"].tolist() == pytest.approx(state, abs=1e-6)
        assert item["action"].shape == (5,)
        assert item["task"] == ours.TASK
    assert [bool(data[k]["next.done"]) for k in (6, 7, 10, 11)] == [True, False, True, True]
    assert data.meta.stats[RGB]["mean"].shape == (3, 1, 1)
    part = client.LeRobotDataset(
        "sdgen/walks",
        root=written,
        episodes=[1],
        video_backend=backend,
        delta_timestamps={"action": [0.0, 0.1], RGB: [-0.1, 0.0]},
    )
    assert part.num_frames == 4
    assert part[1]["action"].shape == (2, 5)
    assert part[1][RGB].shape == (2, 3, 48, 64)
