"""Imports PyBullet without its greeting, and catches what its C++ prints."""

from __future__ import annotations

import ctypes
import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass
class Caught:
    """What was printed inside :func:`quiet`, once it is over."""

    text: str = ""


@contextmanager
def quiet() -> Iterator[Caught]:
    """Catch what is written to the process's standard output and error, C's included."""
    caught = Caught()
    _flush()
    with tempfile.TemporaryFile() as sink:
        saved = os.dup(1), os.dup(2)
        os.dup2(sink.fileno(), 1)
        os.dup2(sink.fileno(), 2)
        try:
            yield caught
        finally:
            _flush()
            os.dup2(saved[0], 1)
            os.dup2(saved[1], 2)
            os.close(saved[0])
            os.close(saved[1])
            sink.seek(0)
            caught.text = sink.read().decode("utf-8", "replace")


def _flush() -> None:
    """Empty Python's and C's buffers, or text comes out after the streams are back."""
    sys.stdout.flush()
    sys.stderr.flush()
    ctypes.CDLL(None).fflush(None)


with quiet():
    import pybullet as pb

__all__ = ["Caught", "forget_files", "pb", "quiet"]


def forget_files(client_id: int) -> None:
    """Let go of all files that Bullet parsed in this process; it keeps them all otherwise."""
    # Switched off, it empties what it keeps.
    for on in (0, 1):
        pb.setPhysicsEngineParameter(enableFileCaching=on, physicsClientId=client_id)
