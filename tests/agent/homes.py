"""Homes to walk in: the committed sample, and one made of it with every door shut."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from sdgen.agent.episode import Episode
from sdgen.agent.eyes import Eyes
from sdgen.agent.options import AgentOptions
from sdgen.agent.stage import Stage, stage_of
from sdgen.cameras.lens import Lens
from sdgen.dataset import Dataset
from sdgen.render.process import process_renderer
from sdgen.seeding import lane

from tests.shipped import shipped_library

SAMPLE = Path(__file__).resolve().parents[2] / "output" / "sample"
#: Small pictures: what they show is not what is tested.
OPTIONS = AgentOptions(camera=Lens(width=64, height=48))


@cache
def sample() -> Dataset:
    return Dataset(SAMPLE, graph_view="perceived")


@cache
def stage(index: int = 0) -> Stage:
    return stage_of(sample(), sample()[index])


@cache
def eyes() -> Eyes:
    """For all tests of a module: whoever uses them lets go of them at its end."""
    return Eyes(shipped_library(), process_renderer())


def let_go() -> None:
    """EGL allows one renderer a process: other modules draw with their own."""
    eyes().close()
    eyes.cache_clear()


def episode(of: Stage | None = None, options: AgentOptions = OPTIONS, seed: int = 0) -> Episode:
    home = of or stage()
    return Episode(home, shipped_library(), eyes(), options, lane(seed, 0, "agent"))
