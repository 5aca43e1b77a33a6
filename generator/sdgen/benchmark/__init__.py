"""Predictions against truth: the metrics, and a strict reader of predictions."""

from sdgen.benchmark.base_rates import BaseRates, OperatingPoint, base_rates
from sdgen.benchmark.compare import Comparison, Difference, compare
from sdgen.benchmark.costs import Costs, read_costs
from sdgen.benchmark.metrics import Evaluation, Score, evaluate
from sdgen.benchmark.predictions import (
    Lenient,
    prediction_bytes,
    read_leniently,
    read_predictions,
    write_predictions,
)
from sdgen.dataset.records import Report
from sdgen.detectors import DETECTORS, detect

__all__ = [
    "DETECTORS",
    "BaseRates",
    "Comparison",
    "Costs",
    "Difference",
    "Evaluation",
    "Lenient",
    "OperatingPoint",
    "Report",
    "Score",
    "base_rates",
    "compare",
    "detect",
    "evaluate",
    "prediction_bytes",
    "read_costs",
    "read_leniently",
    "read_predictions",
    "write_predictions",
]
