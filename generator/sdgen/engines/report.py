"""What a build says while it runs, and in the end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from sdgen.rejection import Causes

#: Scenes at the start and at the end of a build whose memory is compared.
MEMORY_SPAN = 100


@dataclass(frozen=True)
class SceneDone:
    """A scene folder is in place: just made, or found whole from an earlier run.

    ``memory_mb`` is the most its worker held while making it.
    """

    index: int
    scene_id: str
    hazards: tuple[str, ...]
    frames: int = 0
    seconds: float = 0.0
    resumed: bool = False
    memory_mb: float = 0.0


@dataclass(frozen=True)
class SceneFailed:
    """A scene's attempt budget is spent; ``causes`` counts its rejections."""

    index: int
    scene_id: str
    causes: Causes = field(default_factory=dict)


@dataclass(frozen=True)
class Note:
    """One line the user should read once: a renderer fallback, a worker that was replaced."""

    text: str


BuildEvent = SceneDone | SceneFailed | Note
OnEvent = Callable[[BuildEvent], None]


def ignore_event(event: BuildEvent) -> None:
    """The callback of a build nobody watches."""


@dataclass(frozen=True)
class BuildReport:
    """The closing account of one build.

    ``made`` scenes were built in this run, ``resumed`` were there already, ``failed`` could not
    be made. ``home_attempts`` counts the homes tried for the made and the failed ones;
    ``rejections`` says by cause why tries were thrown away, ``anomalies`` counts by hazard over
    all good scenes of the range, ``anomaly_counts`` these scenes by their number of anomalies.
    ``peak_memory_mb`` is the most one run's processes held together, shared pages counted in each;
    ``worker_mb`` the most a worker held making each scene, in the order they came: it grows with
    the models that workers meet for the first time, and a worker above its share is replaced.
    """

    out: Path
    requested: int
    made: int
    resumed: int
    failed: tuple[SceneFailed, ...]
    frames: int
    seconds: float
    peak_memory_mb: float
    home_attempts: int
    rejections: Causes
    anomalies: dict[str, int]
    renderer: str
    anomaly_counts: dict[int, int] = field(default_factory=dict)
    worker_mb: tuple[float, ...] = ()

    @property
    def homes_per_hour(self) -> float:
        """Scenes made in an hour at this run's pace; 0 when none was made."""
        return 3600.0 * self.made / self.seconds if self.seconds > 0 else 0.0

    @property
    def frames_per_second(self) -> float:
        """Views written in a second of the whole build; 0 when none was made."""
        return self.frames / self.seconds if self.seconds > 0 else 0.0

    @property
    def acceptance_rate(self) -> float:
        """Made scenes per home tried, 0 to 1; 1 when nothing was tried."""
        return self.made / self.home_attempts if self.home_attempts else 1.0

    @property
    def complete(self) -> bool:
        """Every requested scene is there."""
        return not self.failed and self.made + self.resumed == self.requested

    @property
    def worker_first_mb(self) -> float:
        """The most a worker held in the first hundred scenes (the first half of fewer)."""
        return max(self.worker_mb[: self.memory_span], default=0.0)

    @property
    def worker_last_mb(self) -> float:
        """The most a worker held in the last hundred scenes (the last half of fewer)."""
        return max(self.worker_mb[-self.memory_span :], default=0.0)

    @property
    def memory_span(self) -> int:
        """Scenes that ``worker_first_mb`` and ``worker_last_mb`` look at."""
        return max(1, min(MEMORY_SPAN, len(self.worker_mb) // 2))
