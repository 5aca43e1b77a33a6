"""Tables of ``sdgen evaluate``."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from rich.table import Table

from sdgen.benchmark import BaseRates, Comparison, Evaluation, Score
from sdgen.benchmark.tables import CUTS, FIXED, MICRO, ROWS, in_words, over_in_words, p_in_words
from sdgen.cli.table import echo_table


def echo_evaluations(
    scores: Mapping[str, Evaluation],
    compared: Sequence[Comparison],
    rates: Mapping[str, BaseRates],
) -> None:
    """Print the scores, a column a detector, what they differ by, and their base rates."""
    several = len(scores) > 1
    columns = list(scores) if several else ["mean ± se", "95 % interval"]
    table = Table("score", *columns, "over")
    for title, over, found in _rows(list(scores.values())):
        if title is None:
            table.add_section()
            continue
        if not found:
            table.add_row(title)
            continue
        cells = [_shown(one) for one in found] if several else [_shown(found[0]), _ends(found[0])]
        table.add_row(title, *cells, f"{over_in_words([one.n for one in found])} {over}".strip())
    echo_table(table)
    for one in compared:
        titles = {name: title for title, name in ROWS.items()}
        table = Table(f"{one.detector} minus {one.baseline}", "difference", "p", "over")
        for name, difference in one.differences.items():
            p, over = p_in_words(difference.p), f"{difference.n} scenes"
            table.add_row(titles[name], in_words(difference), p, over)
        echo_table(table)
    if rates:
        first = next(iter(rates.values()))
        share = f"{100 * first.hazard_share:.3g} % of homes with a hazard"
        table = Table(share, *rates)
        for title, row in _rate_rows(first):
            table.add_row(title, *(row(one) for one in rates.values()))
        echo_table(table)


def _rows(found: Sequence[Evaluation]) -> Iterator[tuple[str | None, str, list[Score]]]:
    """Rows of the table: title, of what there are so many, scores; a title of None: a line; no
    scores: a title over rows."""
    for title, name in ROWS.items():
        scores: list[Score] = [getattr(one, name) for one in found]
        if name in FIXED or any(one.n for one in scores):
            yield title, FIXED.get(name, ""), scores
    for title, key in MICRO.items():
        yield title, "", [one.micro[key] for one in found]
    for title, field in CUTS.items():
        keys = list(getattr(found[0], field))
        rows = [(key, [getattr(one, field)[key] for one in found]) for key in keys]
        if field != "recall_by_hazard":
            rows = [(key, scores) for key, scores in rows if any(one.n for one in scores)]
        if not rows:
            continue
        hazards = field == "recall_by_hazard"
        yield None, "", []
        if not hazards:
            yield title, "", []
        for key, scores in rows:
            over = "anomalies" if field.startswith("recall") else "lookalikes"
            yield f"recall, {key}" if hazards else f"  {key}", over, scores


def _rate_rows(first: BaseRates) -> Iterator[tuple[str, Callable[[BaseRates], str]]]:
    """Rows of the table of base rates: a title, and what a detector's cell says."""
    yield "homes with hazards", lambda one: str(one.homes_with_hazards)
    yield "homes without, that were looked at", lambda one: str(one.clean_homes)
    yield "recall of all that was said", lambda one: in_words(one.recall)
    yield "precision", lambda one: in_words(one.precision)
    yield "false alarms a home-day", lambda one: in_words(one.false_alarms_per_home_day)
    yield "unwanted a home-day", lambda one: in_words(one.unwanted_per_home_day)
    for level in first.at_recall:

        def cell(one: BaseRates, level: str = level) -> str:
            score = one.at_recall[level]
            return "never reached" if score.mean is None else in_words(score)

        yield f"false alarms a home-day at recall {level}", cell
    costs = {
        "detector": "cost a home-day",
        "best_threshold": "cost at its best threshold",
        "never": "cost of silence",
    }
    for key, title in costs.items():

        def cost(one: BaseRates, key: str = key) -> str:
            return in_words(one.cost_per_home_day[key])

        yield title, cost


def _shown(value: Score) -> str:
    if value.mean is None:
        return "-"
    return f"{value.mean:.3f}" + (f" ± {value.se:.3f}" if value.se is not None else "")


def _ends(value: Score) -> str:
    if value.low is None or value.high is None:
        return "-"
    return f"{value.low:.3f} to {value.high:.3f}"
