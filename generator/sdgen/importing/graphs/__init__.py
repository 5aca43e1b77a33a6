"""Scene graphs of others as scenes of boxes, for detectors that look at graphs."""
