"""``sdgen explore DATASET SCENE``: one walk, its pictures and its scores."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import click

from sdgen.cli.quiet import hint

if TYPE_CHECKING:
    from sdgen.agent.episode import Episode
    from sdgen.agent.eyes import Look
    from sdgen.agent.film.steps import Film
    from sdgen.agent.options import AgentOptions
    from sdgen.agent.score import EpisodeScore
    from sdgen.agent.tour import Tour
    from sdgen.dataset import Dataset, SceneItem
    from sdgen.detectors.run import Detector
    from sdgen.geometry import Vec2
    from sdgen.library import Library
    from sdgen.scene import Scene
    from sdgen.truth.observable import Observability


@dataclass(frozen=True)
class Walk:
    """Who decides where to go, and what is written of it."""

    script: str | None
    explorer: str | None
    detectors: Mapping[str, Detector]
    output: Path | None
    video: Literal["gif", "mp4", "none"]
    lerobot: Path | None
    plan: Path | None


def explore_one(
    data: Dataset,
    item: SceneItem,
    library: Library,
    walk: Walk,
    options: AgentOptions,
    seed: int,
    renderer: str,
    as_json: bool,
) -> None:
    """Walk, write what was asked for, and print the scores."""
    from sdgen.agent.compare import certificates
    from sdgen.agent.episode import Episode
    from sdgen.agent.eyes import Eyes
    from sdgen.agent.film.recorder import Recorder
    from sdgen.agent.score import score_episode
    from sdgen.agent.stage import check_models, stage_of
    from sdgen.agent.tour import shortest_tour
    from sdgen.render.process import process_renderer
    from sdgen.seeding import lane

    lines = _script(walk.script)
    if lines is None and walk.explorer is None:
        hint("opening the home ...")
    check_models(data, library)
    stage = stage_of(data, item)
    found = certificates(data, item, library, options)
    with Eyes(library, process_renderer(renderer), options.whole_home) as eyes:
        rng = lane(seed, item.entry.index, "agent")
        episode = Episode(stage, library, eyes, options, rng)
        floor, start = episode.house.floor, episode.gaze.point
        tour = shortest_tour(found, floor, start)
        recorder = Recorder(episode, episode.look())
        episode.watch(recorder.add)
        if lines is not None:
            for line in lines:
                for result in line.do(episode):
                    if result.refused is not None:
                        hint(f"refused: {result.move}: {result.refused}")
        elif walk.explorer is not None:
            clearly = shortest_tour(found, floor, start, episode.stage.places)
            _explore(data, item, episode, walk, clearly, seed)
        else:
            from sdgen.cli.explore_keys import by_keys

            by_keys(episode)
        score = score_episode(episode, tour)
    said = [episode.reports[key].model_dump(mode="json") for key in sorted(episode.reports)]
    film = recorder.film({**score.model_dump(mode="json"), "reports": said})
    _write(walk, film, library, stage.scene, found, episode.trail)
    if as_json:
        click.echo(json.dumps(score.model_dump(mode="json"), indent=1))
        return
    _echo(score)


def _script(text: str | None) -> Any:
    from sdgen.agent.script import read_script
    from sdgen.dataset.text import read_bytes
    from sdgen.errors import InputError

    if text is None:
        return None
    if not text.startswith("@"):
        return read_script(text, "--do")
    path = Path(text[1:])
    try:
        return read_script(read_bytes(path, str(path)).decode("utf-8-sig"), str(path))
    except UnicodeDecodeError:
        raise InputError([f"{path}: no text in UTF-8"]) from None


def _explore(
    data: Dataset, item: SceneItem, episode: Episode, walk: Walk, tour: Tour, seed: int
) -> None:
    """Have an explorer look, and a detector say what it makes of it."""
    from sdgen.agent.explored import explored
    from sdgen.agent.explorers import EXPLORERS
    from sdgen.dataset.derived import derived_from
    from sdgen.seeding import lane

    assert walk.explorer is not None
    rng = lane(seed, item.entry.index, f"explorer:{walk.explorer}")
    looks: list[Look] = EXPLORERS[walk.explorer](episode, rng, tour)
    (detector,) = walk.detectors.values()
    with derived_from(data, item):
        reports = detector(data, explored(item, looks))
    episode.conclude(reports)
    for one in reports:
        thing = episode.house.bodies[one.object_id].item
        hint(f"reports {one.object_id} ({thing.category}): {one.label} ({one.notify})")


def _write(
    walk: Walk,
    film: Film,
    library: Library,
    scene: Scene,
    found: Observability,
    trail: Sequence[Vec2],
) -> None:
    # What may fail comes first: nothing is to be half written.
    if walk.lerobot is not None:
        from sdgen.agent.film.lerobot import write_lerobot

        camera = film.options.camera
        even = camera.width % 2 == camera.height % 2 == 0
        write_lerobot([film], walk.lerobot, pictures="video" if even else "image")
        hint(f"{walk.lerobot}: a LeRobot data set of one episode")
    if walk.plan is not None:
        from sdgen.agent.plan import certificate_plan
        from sdgen.dataset.output_file import output_file

        with output_file(walk.plan) as file:
            certificate_plan(scene, library.infos, found, trail).save(file, "PNG")
        hint(f"{walk.plan}")
    if walk.output is not None:
        from sdgen.agent.film.folder import write_folder

        write_folder(film, walk.output, walk.video)
        count = len(film.steps)
        hint(f"{walk.output}: {count} picture{'s' * (count != 1)}")


#: Why something was missed, in words.
_WHY = {
    "unobservable": "cannot be seen from anywhere",
    "never_looked": "never looked",
    "could_not_see": "looked, and could not see it",
    "did_not_understand": "saw it, and did not understand",
}


def _echo(score: EpisodeScore) -> None:
    from rich.table import Table

    from sdgen.cli.table import echo_table

    def said(value: float | None) -> str:
        return "-" if value is None else f"{value:.2f}"

    tour = "no tour" if score.shortest_m is None else f"shortest tour {score.shortest_m:.1f} m"
    click.echo(
        f"scene {score.scene}: {score.steps} step{'s' * (score.steps != 1)}, "
        f"{score.path_m:.1f} m walked ({tour}), {score.coverage:.0%} of the floor seen, "
        f"{score.refused} refused, {score.collisions} collisions"
    )
    click.echo(
        f"AS {said(score.AS)}, CAS {said(score.CAS)}, false alarms {score.false_alarms:.0f}, "
        f"label accuracy {said(score.label_accuracy)}"
    )
    table = Table("anomaly", "object", "first shown", "reported", "missed")
    for find in score.finds:
        table.add_row(
            find.hazard,
            str(find.object_id),
            "-" if find.shown is None else f"step {find.shown}",
            "-" if find.reported is None else f"step {find.reported}",
            _WHY[find.miss] if find.miss is not None else "",
        )
    if score.finds:
        echo_table(table)
