"""What looks at a scene and says what is wrong: rules, coins, classifiers, language models."""

from sdgen.detectors.run import DETECTORS, Detector, detect, detect_all, looked_at
from sdgen.detectors.told import Told, things

__all__ = ["DETECTORS", "Detector", "Told", "detect", "detect_all", "looked_at", "things"]
