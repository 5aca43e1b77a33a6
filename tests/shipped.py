"""The shipped library, read once a process: reading it takes a second, and its models stay warm."""

from __future__ import annotations

from functools import cache

from sdgen.library import Library, load_library


@cache
def shipped_library() -> Library:
    """Shared by all tests of this process: nobody changes it."""
    return load_library()
