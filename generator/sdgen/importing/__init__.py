"""Turns downloads of others, scanned models and furnished scenes, into libraries and homes."""
