"""The running account of a build: what was made, what failed, why, with how much memory."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from sdgen.dataset.records import ManifestEntry
from sdgen.engines.protocol import Outcome
from sdgen.engines.report import BuildReport, SceneDone, SceneFailed
from sdgen.engines.worker import SceneResult
from sdgen.errors import SceneRejected
from sdgen.rejection import Cause


@dataclass
class Tally:
    """Takes in scenes as they come; each method gives back the event to show."""

    requested: int
    made: int = 0
    resumed: int = 0
    frames: int = 0
    homes: int = 0
    failed: list[SceneFailed] = field(default_factory=list)
    rejections: Counter[Cause] = field(default_factory=Counter)
    anomalies: Counter[str] = field(default_factory=Counter)
    counts: Counter[int] = field(default_factory=Counter)
    unseen: list[str] = field(default_factory=list)
    memory_mb: list[float] = field(default_factory=list)

    def take_resumed(self, entry: ManifestEntry) -> SceneDone:
        """A scene that an earlier run made."""
        self.resumed += 1
        self.anomalies.update(entry.hazards)
        self.counts[entry.anomalies] += 1
        names = tuple(Counter(entry.hazards).elements())
        return SceneDone(entry.index, entry.id, names, resumed=True)

    def take_made(self, index: int, result: SceneResult, memory_mb: float) -> SceneDone:
        """A scene that is in place now."""
        self.made += 1
        self.frames += result.frames
        self.homes += result.home_attempts
        self.rejections.update(result.rejections)
        self.anomalies.update(result.hazards)
        self.counts[len(result.hazards)] += 1
        self.memory_mb.append(memory_mb)
        if not result.all_visible:
            self.unseen.append(result.scene_id)
        return SceneDone(
            index,
            result.scene_id,
            result.hazards,
            frames=result.frames,
            seconds=result.seconds,
            memory_mb=memory_mb,
        )

    def take_failed(self, outcome: Outcome) -> SceneFailed:
        """A scene that could not be made: its budget is spent, or its worker met an error."""
        error = outcome.error
        if isinstance(error, SceneRejected):
            causes = dict(error.causes)
            self.homes += error.home_attempts
        else:
            causes = {Cause("worker", "error"): 1}
        self.rejections.update(causes)
        failure = SceneFailed(outcome.job, f"{outcome.job:06d}", causes)
        self.failed.append(failure)
        return failure

    def report(self, out: Path, seconds: float, peak_mb: float, renderer: str) -> BuildReport:
        """The closing account."""
        return BuildReport(
            out=out,
            requested=self.requested,
            made=self.made,
            resumed=self.resumed,
            failed=tuple(self.failed),
            frames=self.frames,
            seconds=seconds,
            peak_memory_mb=peak_mb,
            home_attempts=self.homes,
            rejections=dict(self.rejections),
            anomalies=dict(self.anomalies),
            renderer=renderer,
            anomaly_counts=dict(sorted(self.counts.items())),
            worker_mb=tuple(self.memory_mb),
        )
