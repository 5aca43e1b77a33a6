"""Predictions against truth: the metrics, and a strict reader of predictions."""

from sdgen.benchmark.metrics import Evaluation, Score, evaluate
from sdgen.benchmark.predictions import prediction_bytes, read_predictions, write_predictions
from sdgen.dataset.records import Report
from sdgen.detectors import DETECTORS, detect

__all__ = [
    "DETECTORS",
    "Evaluation",
    "Report",
    "Score",
    "detect",
    "evaluate",
    "prediction_bytes",
    "read_predictions",
    "write_predictions",
]
