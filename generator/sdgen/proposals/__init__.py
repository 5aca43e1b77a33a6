"""Further objects and placements of a hazard, proposed by a language model for a person to review.

As in the SafetyDetect paper: the model is asked for objects, then for places; what it answers is
checked line by line, and what could be a hazard is tried in furnished homes.
"""
