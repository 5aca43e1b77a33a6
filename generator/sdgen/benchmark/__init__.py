"""Predictions against truth: the metrics, a strict reader of predictions, three detectors."""

from sdgen.benchmark.detectors import DETECTORS, detect
from sdgen.benchmark.metrics import Evaluation, Score, evaluate
from sdgen.benchmark.predictions import prediction_bytes, read_predictions, write_predictions
from sdgen.dataset.records import Report

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
