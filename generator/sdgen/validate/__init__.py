"""Checks a data set from its files alone: everything that is promised of them, found wrong."""

from sdgen.validate.problems import Problem
from sdgen.validate.rebuild import Rebuilt, rebuild
from sdgen.validate.run import validate

__all__ = ["Problem", "Rebuilt", "rebuild", "validate"]
