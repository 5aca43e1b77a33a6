"""The user's cache of models: where it is, and files that appear in it whole or not at all.

Everything in it is named by the content it was made from, so it never goes stale and any number of
processes may share it. What is written lies in a scratch folder inside the cache until it is
whole; of a writer that was killed the next one clears that away.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

from sdgen.errors import FULL, AssetError
from sdgen.scratch import scratch_folder

_VERSION = b"2"
#: The user may choose another folder by this variable; child processes inherit it.
VARIABLE = "SDGEN_CACHE"


def cache_root() -> Path:
    """``$SDGEN_CACHE``, else ``sdgen`` in the user's cache folder."""
    chosen = os.environ.get(VARIABLE)
    if chosen:
        return Path(chosen)
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "sdgen"


@contextmanager
def usable_cache() -> Iterator[str | None]:
    """A cache that can be written, for this process and those it starts.

    Yields None, or a line that says that the user's cannot be written and that a scratch folder,
    gone at the end, stands in for it. Where the disk is full it would be full, too: then writing
    says so.
    """
    root = cache_root()
    try:
        # Of a writer that was killed, this takes away what it left.
        with _scratch():
            pass
    except OSError as error:
        why = None if error.errno in FULL else f"{root}: {error.strerror}"
    else:
        why = None
    if why is None:
        yield None
        return
    before = os.environ.get(VARIABLE)
    with scratch_folder() as folder:
        os.environ[VARIABLE] = str(folder)
        try:
            yield f"{why}: models are unpacked to a temporary folder, anew in every build"
        finally:
            if before is None:
                del os.environ[VARIABLE]
            else:
                os.environ[VARIABLE] = before


def digest(*chunks: bytes) -> str:
    """Short content hash of byte strings."""
    total = hashlib.sha256(_VERSION)
    for chunk in chunks:
        total.update(hashlib.sha256(chunk).digest())
    return total.hexdigest()[:20]


def write(folder: Path, files: Mapping[str, bytes]) -> None:
    """Put files into a folder of the cache, each at once, in the order given.

    Another process may be writing the same: then both write the same bytes. Raises AssetError
    where the cache cannot be written.
    """
    try:
        with _scratch() as place:
            folder.mkdir(parents=True, exist_ok=True)
            for name, data in files.items():
                (place / name).write_bytes(data)
                os.replace(place / name, folder / name)
    except OSError as error:
        raise AssetError([_hint(error)]) from None


def _scratch() -> AbstractContextManager[Path]:
    """A scratch folder on the cache's own disk."""
    place = cache_root() / "making"
    place.mkdir(parents=True, exist_ok=True)
    return scratch_folder(place)


def _hint(error: OSError) -> str:
    way = "make room" if error.errno in FULL else f"set {VARIABLE} to a folder that can"
    return f"{cache_root()}: the model cache cannot be written: {error.strerror}; {way}"
