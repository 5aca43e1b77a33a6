"""Mending a scene: actions on it with what they need and physical checks, planners, a score."""

from sdgen.agent.mend.careless import careless_planner
from sdgen.agent.mend.mending import ACTIONS, Mending, mending_of
from sdgen.agent.mend.planners import remedy_planner
from sdgen.agent.mend.planning import Left
from sdgen.agent.mend.records import Action, MendScore, Outcome, Pair
from sdgen.agent.mend.score import score

__all__ = [
    "ACTIONS",
    "Action",
    "Left",
    "MendScore",
    "Mending",
    "Outcome",
    "Pair",
    "careless_planner",
    "mending_of",
    "remedy_planner",
    "score",
]
