"""Written scenes stand in a world made anew; what was moved by hand is found."""

from __future__ import annotations

import shutil
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
    assert (done, seen) == ([], [(1, 2), (2, 2)])
    assert run(["validate", str(written), "--physics"]) == 0
    assert "2 scenes checked, let stand, no problem found" in capsys.readouterr().out


def test_other_models_are_no_measure(written: Path, tmp_path: Path) -> None:
    (problem,) = check_physics(Dataset(written), fake_library(tmp_path / "assets"))
    assert problem.text.startswith("dataset.json: assets_sha256: other models")


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
        (into_furniture, ["cuts into wardrobe"]),
        (into_the_air, ["nothing within 10 mm under it", "moves by "]),
        (furniture_into_furniture, ["cuts into "]),
    ],
)
def test_what_was_moved_by_hand_is_found(written, library, client, change, found) -> None:
    scene = Dataset(written)[0].scene
    loose = next(item for item in scene.objects if not item.fixed)
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
    for text in found:
        assert any(
            line.startswith("scenes/000000/scene.json: object ")
            and text in line
            and str(guilty) in line
            for line in texts
        ), texts
