"""What can be made out of a home from its pictures."""

from sdgen.perception.clouds import View
from sdgen.perception.kinds import Kinds
from sdgen.perception.options import Perception
from sdgen.perception.perceive import perceive
from sdgen.perception.perceived import Perceived

__all__ = ["Kinds", "Perceived", "Perception", "View", "perceive"]
