"""Furnished scenes of others: read, understood as rooms and pieces, written as base homes."""
