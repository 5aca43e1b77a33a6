"""Distributions of a data set as one picture: an SVG of bars."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined

from sdgen.dataset.distributions import ENDLESS, Distributions, Spread
from sdgen.dataset.output_file import write_output
from sdgen.errors import SdgenError

#: Units of the drawing: a column, what names take of it, a bar, what stands above and below bars.
COLUMN, LABEL, BAR, HEAD = 460, 190, 17, 44
COLUMNS = 3


@dataclass(frozen=True)
class Chart:
    """One distribution: what it is of, its numbers in words, and its bars."""

    title: str
    note: str
    bars: tuple[tuple[str, int], ...]

    @property
    def most(self) -> int:
        """The largest count, 1 at least."""
        return max([count for _, count in self.bars] + [1])

    @property
    def height(self) -> int:
        """Units it takes."""
        return HEAD + BAR * max(len(self.bars), 1) + 16


def charts(found: Distributions) -> Iterator[Chart]:
    """The distributions as charts, names first."""
    for tally in found.names.values():
        total = sum(tally.counts.values())
        named = tuple((name.replace("_", " "), count) for name, count in tally.counts.items())
        yield Chart(tally.title, f"{total} in all", named)
    for spread in found.numbers.values():
        yield Chart(spread.title, in_words(spread), tuple(bars(spread)))


def in_words(spread: Spread) -> str:
    """The range and the middle of numbers."""
    if not spread.n:
        return "none"
    return (
        f"{spread.n}, from {spread.minimum:g} to {spread.maximum:g}, median {spread.median:g}, "
        f"mean {spread.mean:.3g}"
    )


def bars(spread: Spread) -> list[tuple[str, int]]:
    """Its bins by name, empty ones at either end left out: the number itself where they are whole
    numbers one by one."""
    filled = [k for k, count in enumerate(spread.counts) if count]
    if not filled:
        return []
    shown = range(filled[0], filled[-1] + 1)
    return [(_bin(spread.edges, k), spread.counts[k]) for k in shown]


def _bin(edges: Sequence[float], k: int) -> str:
    low, high = edges[k], edges[k + 1]
    if high >= ENDLESS:
        return f"{low:g} and more"
    if {b - a for a, b in pairwise(edges)} == {1}:
        return f"{low:g}"
    return f"{low:g} to {round(high, 3):g}"


def write_stats(path: Path, title: str, found: Distributions) -> None:
    """Write the picture, whole or not at all. Raises SdgenError for a name that is no ``.svg``, and
    where ``output_file`` does."""
    if path.suffix != ".svg":
        raise SdgenError(f"{path}: the picture is an SVG; name it .svg")
    write_output(path, stats_svg(title, found).encode("utf-8"))


def stats_svg(title: str, found: Distributions) -> str:
    """The picture as SVG text; the same text for the same data set."""
    tops = [40] * COLUMNS
    placed = []
    for chart in charts(found):
        column = tops.index(min(tops))
        placed.append((column * COLUMN + 10, tops[column], chart))
        tops[column] += chart.height
    environment = Environment(
        loader=PackageLoader("sdgen.gallery", "templates"),
        undefined=StrictUndefined,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template("stats.svg.j2").render(
        title=title,
        charts=placed,
        width=COLUMN * COLUMNS,
        height=max(tops),
        label=LABEL,
        bar=BAR,
        head=HEAD,
        room=COLUMN - LABEL - 80,
    )
