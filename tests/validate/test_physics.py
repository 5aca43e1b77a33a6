"""Written scenes stand in a world made anew; what was moved by hand is found."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.geometry import Vec3
from sdgen.library import Library, load_library
from sdgen.physics.client import Client
from sdgen.scene import ObjectInstance, Scene
from sdgen.validate.physics import check_physics, check_scene_physics
from sdgen.vocabulary import FLAT_M, OPENINGS
from shapely.geometry import Polygon

from tests.fakes import fake_library
from tests.shared import Shared


@pytest.fixture(scope="module")
def written(shared: Shared, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A scene and its twin."""

    def make(path: Path) -> None:
        options = "--n 1 --seed 7 --views 2 --size 64x48 --twins --renderer cpu --workers 1"
        assert run(["build", *options.split(), "--out", str(path)]) == 0

    copied = tmp_path_factory.mktemp("physics") / "d"
    return Path(shutil.copytree(shared.folder("drawn-by-tiny", make), copied))


@pytest.fixture(scope="module")
def library() -> Library:
    return load_library()


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    with Client() as one:
        yield one


@pytest.mark.slow
def test_a_written_scene_and_its_twin_stand(
    written: Path, library: Library, capsys: pytest.CaptureFixture[str]
) -> None:
    seen: list[tuple[int, int]] = []
    done = check_physics(Dataset(written), library, on_scene=lambda k, n: seen.append((k, n)))
    assert (done, seen) == (([], 2), [(1, 2), (2, 2)])
    assert run(["validate", str(written), "--physics"]) == 0
    assert "2 scenes checked, let stand, no problem found" in capsys.readouterr().out


def test_other_models_are_no_measure(written: Path, tmp_path: Path) -> None:
    (problem,), stood = check_physics(Dataset(written), fake_library(tmp_path / "assets"))
    assert stood == 0
    assert problem.text.startswith("dataset.json: assets_sha256: other models")


@pytest.fixture(scope="module")
def many(written: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The twin (it is the lighter one) ten times: more than enough for several processes."""
    copied = tmp_path_factory.mktemp("many") / "d"
    shutil.copytree(written, copied, ignore=shutil.ignore_patterns("scenes"))
    lines = (written / "manifest.jsonl").read_text().splitlines()
    twin = next(entry for entry in map(json.loads, lines) if entry["twin_of"])
    names = [f"{k:06d}" for k in range(10)]
    for name in names:
        shutil.copytree(written / "scenes" / twin["id"], copied / "scenes" / name)
    entries = [{**twin, "id": name, "index": int(name), "twin_of": None} for name in names]
    (copied / "manifest.jsonl").write_text("".join(f"{json.dumps(e)}\n" for e in entries))
    info = json.loads((copied / "dataset.json").read_text())
    info["counts"] |= {"scenes": 10, "twins": 0}
    (copied / "dataset.json").write_text(json.dumps(info))
    return copied


@pytest.mark.slow
def test_many_scenes_are_shared_and_every_problem_says_where(
    many: Path, library: Library, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    data = Path(shutil.copytree(many, tmp_path / "d"))
    scene = Dataset(data)[4].scene
    loose = next(item for item in scene.objects if not item.fixed)
    (data / "scenes/000004/scene.json").write_text(
        into_the_air(scene, loose, []).model_dump_json(), encoding="utf-8"
    )
    broken = data / "scenes/000007/scene.json"
    broken.write_text(broken.read_text().replace('"position_m":', '"what": 1, "position_m":', 1))
    temporary = tmp_path / "tmp"
    temporary.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(temporary))
    seen: list[tuple[int, int]] = []
    found, stood = check_physics(Dataset(data), library, 2, lambda k, n: seen.append((k, n)))
    assert stood == 10
    assert seen == [(k, 10) for k in range(1, 11)]
    texts = [problem.text for problem in found]
    assert all(text.startswith(("scenes/000004/", "scenes/000007/")) for text in texts), texts
    assert texts == sorted(texts, key=lambda text: text[:13])
    assert f"object {loose.id} ({loose.category}): nothing within 10 mm under it" in texts[0]
    assert "scenes/000007/scene.json" in texts[-1]
    assert "what" in texts[-1]
    assert list(temporary.iterdir()) == []


LET_STAND = """
import sys
from pathlib import Path
from sdgen.cli import main as module
from sdgen.dataset import Dataset
from sdgen.library import load_library
from sdgen.validate.physics import check_physics

def check(args=None, **rest):
    say = lambda k, n: print(k, flush=True)
    check_physics(Dataset(Path(sys.argv[1])), load_library(), 2, say)

module.cli.main = check
module.main()
"""


@pytest.mark.slow
@pytest.mark.skipif(not os.path.exists("/proc/self/environ"), reason="Linux only")
def test_interrupted_it_leaves_no_process_and_no_folder(many: Path, tmp_path: Path) -> None:
    running = subprocess.Popen(
        [sys.executable, "-c", LET_STAND, str(many)],
        env={**os.environ, "TMPDIR": str(tmp_path)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert running.stdout is not None
    assert running.stdout.readline() == "1\n"
    assert len(with_environment(str(tmp_path))) == 3
    begin = time.monotonic()
    running.send_signal(signal.SIGTERM)
    _, said = running.communicate(timeout=30)
    assert time.monotonic() - begin < 5
    assert (said, running.returncode) == ("terminated\n", 143)
    assert with_environment(str(tmp_path)) == []
    assert list(tmp_path.iterdir()) == []


def with_environment(text: str) -> list[str]:
    """Processes that have ``text`` in their environment."""
    out = []
    for path in Path("/proc").glob("[0-9]*"):
        try:
            if f"TMPDIR={text}" in (path / "environ").read_text(errors="replace"):
                out.append(path.name)
        except OSError:
            continue
    return out


def moved(scene: Scene, key: int, position_m: Vec3) -> Scene:
    objects = [
        item.model_copy(update={"pose": item.pose.model_copy(update={"position_m": position_m})})
        if item.id == key
        else item
        for item in scene.objects
    ]
    return scene.model_copy(update={"objects": tuple(objects)})


def into_a_wall(scene: Scene, loose: ObjectInstance, solid: list[ObjectInstance]) -> Scene:
    wall = next(s for s in scene.home.structures if s.category == "wall")
    return moved(scene, loose.id, wall.pieces[0].center_m)


def into_furniture(scene: Scene, loose: ObjectInstance, solid: list[ObjectInstance]) -> Scene:
    return moved(scene, loose.id, solid[0].pose.position_m)


def into_the_air(scene: Scene, loose: ObjectInstance, solid: list[ObjectInstance]) -> Scene:
    middle = Polygon(scene.home.rooms[0].polygon_m).representative_point()
    return moved(scene, loose.id, (middle.x, middle.y, 1.9))


def furniture_into_furniture(
    scene: Scene, loose: ObjectInstance, solid: list[ObjectInstance]
) -> Scene:
    return moved(scene, solid[1].id, solid[0].pose.position_m)


@pytest.mark.parametrize(
    ("change", "found"),
    [
        (into_a_wall, ["cuts into wall"]),
        (into_furniture, ["cuts into "]),
        (into_the_air, ["nothing within 10 mm under it", "moves by "]),
        (furniture_into_furniture, ["cuts into "]),
    ],
)
def test_what_was_moved_by_hand_is_found(written, library, client, change, found) -> None:
    scene = Dataset(written)[0].scene
    # The tallest: a flat one would lie in the air under a wardrobe's boards.
    loose = max(
        (item for item in scene.objects if not item.fixed),
        key=lambda item: library.info(item.asset).extents_m[2],
    )
    solid = [
        item
        for item in scene.objects
        if item.fixed
        and item.category not in OPENINGS
        and library.info(item.asset).extents_m[2] > FLAT_M
        and item.pose.position_m[2] == 0
    ]
    solid.sort(key=lambda item: item.category != "wardrobe")
    item = SimpleNamespace(
        scene=change(scene, loose, solid), where=lambda name: f"scenes/000000/{name}"
    )
    texts = [problem.text for problem in check_scene_physics(item, library, client)]
    guilty = solid[1].id if change is furniture_into_furniture else loose.id
    other = solid[0].id if change is into_furniture else guilty  # either of them cuts the other
    for text in found:
        assert any(
            line.startswith("scenes/000000/scene.json: object ")
            and text in line
            and str(guilty) in line
            and str(other) in line
            for line in texts
        ), texts
