"""Written scenes loaded into Bullet anew: nothing cuts into anything, floats or moves."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import NamedTuple

from sdgen.closing import Closing
from sdgen.dataset import Dataset, SceneItem
from sdgen.errors import InputError
from sdgen.library import Library
from sdgen.physics.checks import penetrations, unsupported
from sdgen.physics.client import Client
from sdgen.physics.settle import STILL_STEPS, moving
from sdgen.physics.world import World
from sdgen.validate.at_hand import other_models
from sdgen.validate.problems import Problem
from sdgen.validate.scenes import scene_by_scene


class LetStand(NamedTuple):
    """What letting scenes stand found, and how many of them were."""

    problems: list[Problem]
    scenes: int


def check_physics(
    data: Dataset,
    library: Library,
    workers: int = 1,
    on_scene: Callable[[int, int], None] | None = None,
) -> LetStand:
    """What is wrong with the physics of a sound data set's scenes, twins included.

    ``library`` must be the one of the build, model by model, or none is let stand: records say
    nothing of collision pieces. Scenes are shared by ``workers`` processes; the problems come in
    the manifest's order.
    """
    problems = list(other_models(data, library, "physics"))
    if problems:
        return LetStand(problems, 0)
    total = len(data.entries)
    setup = (data.path, library.folders, library.sha256)
    with closing(scene_by_scene(_Checker, setup, data.entries, workers)) as scenes:
        for done, found in enumerate(scenes, start=1):
            problems += found
            if on_scene is not None:
                on_scene(done, total)
    return LetStand(problems, total)


class _Checker(Closing):
    """Lets scenes stand, by their place in the manifest, one after another in one simulator."""

    def __init__(self, path: Path, folders: tuple[Path, ...], sha256: str) -> None:
        self._data = Dataset(path)
        self._library = Library(folders, sha256)
        self._client = Client()

    def __call__(self, index: int) -> list[Problem]:
        item = SceneItem(self._data.path, self._data.entries[index], checked=False)
        try:
            return list(check_scene_physics(item, self._library, self._client))
        except InputError as error:
            return [Problem("physics", text) for text in error.problems]

    def close(self) -> None:
        """Let go of the simulator."""
        self._client.close()


def check_scene_physics(item: SceneItem, library: Library, client: Client) -> Iterator[Problem]:
    """One scene: unpenetrated (all pairs), supported (what is fixed may hang), and still."""
    scene, where = item.scene, item.where("scene.json")
    named: dict[int, str] = {s.id: s.category for s in scene.home.structures}
    shell = set(named)
    named |= {thing.id: thing.category for thing in scene.objects}

    def problem(key: int, text: str) -> Problem:
        return Problem("physics", f"{where}: object {key} ({named[key]}): {text}")

    world = World(library, client)
    world.become(scene, [thing.id for thing in scene.objects if not thing.fixed])
    for violation in penetrations(world):
        # Named by the thing, not by the wall.
        first, other = sorted(violation.objects, key=lambda k: k in shell)
        depth = f"{violation.measured * 1000:.1f} mm (limit {violation.limit * 1000:.0f})"
        yield problem(first, f"cuts into {named[other]} {other} by {depth}")
    for violation in unsupported(world):
        (key,) = violation.objects
        yield problem(key, f"nothing within {violation.limit * 1000:.0f} mm under it")
    for violation in moving(world):
        (key,) = violation.objects
        metres = violation.check == "moves"
        far = violation.measured * 1000 if metres else math.degrees(violation.measured)
        unit = "mm" if metres else "degrees"
        yield problem(key, f"{violation.check} by {far:.0f} {unit} in {STILL_STEPS} steps")
