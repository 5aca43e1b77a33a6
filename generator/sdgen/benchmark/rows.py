"""The rows of a leaderboard: detectors that are run here, and predictions others have made."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from sdgen.benchmark.base_rates import BaseRates, NoHomes, base_rates
from sdgen.benchmark.leaderboard import Row
from sdgen.benchmark.metrics import evaluate
from sdgen.benchmark.predictions import read_predictions, silence
from sdgen.dataset import Dataset
from sdgen.dataset.records import Predictions
from sdgen.detectors import DETECTORS, Detector, detect_all
from sdgen.detectors.account import Account, read_account
from sdgen.detectors.model_file import RECORD
from sdgen.detectors.trained import Trained, load_trained
from sdgen.errors import InputError, UsageError

#: How a household enters what the untrained say.
_HOUSEHOLD = {"rules": "own", "chance": "a coin", "always": "none", "never": "none"}


def pictured(data: Dataset) -> bool:
    """True when a graph can be perceived: views have depth and masks."""
    options = data.info.options
    return options.views_about > 0 and {"depth", "instance"} <= set(options.sensors)


def trained_in(folders: Iterable[Path]) -> dict[str, Trained]:
    """The models in folders, or in the folders in them, by what tables call them: their kind, and
    the graphs they learned from unless these were full.

    Raises InputError for a folder without one, UsageError for two of one name.
    """
    out: dict[str, Trained] = {}
    places: dict[str, Path] = {}
    for folder in folders:
        found = [sub for sub in (folder, *sorted(folder.iterdir())) if (sub / RECORD).exists()]
        if not found:
            raise InputError([f"{folder}: no model of 'sdgen train' in it, nor in its folders"])
        for sub in found:
            model = load_trained(sub)
            view = "" if model.graph_view == "full" else f" (of {model.graph_view} graphs)"
            name = f"{model.kind}{view}"
            if name in out:
                raise UsageError(f"{sub}: a second model {name!r} beside {places[name]}")
            out[name], places[name] = model, sub
    return out


def offline_rows(
    data: Dataset,
    trained: Mapping[str, Trained],
    base_rate: float,
    on_scene: Callable[[int, int], None] | None = None,
) -> list[Row]:
    """Rows of all that needs no key, on the data set's view of the graph."""
    # All that a detector could say decides its curve, its own threshold the rest.
    low = {name: replace(model, threshold=0.0) for name, model in trained.items()}
    # Rules ask for states, which a neutral graph has none of.
    plain = {k: one for k, one in DETECTORS.items() if k != "rules" or data.graph_view != "neutral"}
    detectors: dict[str, Detector] = {**plain, **low}
    found = detect_all(data, detectors, on_scene, twins=True)
    rows = []
    for name, said in found.items():
        model = trained.get(name)
        sure = said if model is None else _at_least(said, model.threshold)
        rates, lacking = _rates(data, said, sure, base_rate)
        rows.append(
            Row(
                detector=name,
                graph_view=data.graph_view,
                household=_HOUSEHOLD.get(name, "filter"),
                note=lacking,
                evaluation=evaluate(data, sure),
                base_rates=rates,
            )
        )
    return rows


def _rates(
    data: Dataset, said: Predictions, sure: Predictions, base_rate: float
) -> tuple[BaseRates | None, str]:
    """The curve of all that a detector could say, and where on it its own threshold lies; None,
    and why, where it looked at no home of one of the two kinds."""
    try:
        curve = base_rates(data, said, base_rate)
    except NoHomes as error:
        return None, str(error)
    if sure is said:
        return curve, ""
    own = base_rates(data, sure, base_rate)
    names = ("recall", "precision", "false_alarms_per_home_day", "unwanted_per_home_day")
    costs = {**curve.cost_per_home_day, "detector": own.cost_per_home_day["detector"]}
    update = {name: getattr(own, name) for name in names} | {"cost_per_home_day": costs}
    return curve.model_copy(update=update), ""


def _at_least(found: Predictions, threshold: float) -> Predictions:
    return {
        scene: tuple(report for report in reports if (report.score or 0.0) >= threshold)
        for scene, reports in found.items()
    }


def rows_of_runs(data: Dataset, folder: Path, base_rate: float) -> list[Row]:
    """Rows of the predictions in a folder: those that ``sdgen detect`` made with a language model
    have an account beside them, of others the file's name is all that is known."""
    files = sorted(folder.glob("*.jsonl"))
    if not files:
        raise InputError([f"{folder}: no predictions (*.jsonl) in it"])
    return [_row(data, path, base_rate) for path in files]


def _row(data: Dataset, path: Path, base_rate: float) -> Row:
    said = read_predictions(path, data)
    rates, lacking = _rates(data, said, said, base_rate)
    account = read_account(path)
    notes = [silence(said, data), lacking]
    if account is None:
        return Row(
            detector=path.stem,
            graph_view=None,
            household="unknown",
            note="; ".join(filter(None, notes)),
            evaluation=evaluate(data, said),
            base_rates=rates,
        )
    return Row(
        detector=account.settings.method,
        graph_view=account.settings.graph_view,
        household=account.settings.household,
        model=account.settings.model,
        note="; ".join(filter(None, (_note(account), *notes))),
        evaluation=evaluate(data, said),
        base_rates=rates,
    )


def _note(account: Account) -> str:
    """What a reader must know of a run beside its scores."""
    seen = account.settings.perception
    odd = seen.model_dump(exclude_defaults=True) if seen else {}
    said = [f"{key} {value}" for key, value in odd.items()]
    return "; ".join(
        [
            *([f"perceived with {', '.join(said)}"] if said else []),
            *(
                f"{count} {what}"
                for count, what in (
                    (account.scenes_by_status.get("failed", 0), "scenes got no answer"),
                    (account.scenes_by_status.get("partly", 0), "scenes were answered in part"),
                    (account.invented, "answers were for things that are not there"),
                    (account.unmatched, "boxes were on nothing"),
                )
                if count
            ),
        ]
    )
