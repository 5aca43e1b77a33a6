"""The packages that importing needs beyond a plain install."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec

from sdgen.errors import SdgenError

#: Modules that the extra "assets" brings, and the packages they are in.
_PACKAGES = {
    "coacd": "coacd",
    "collada": "pycollada",
    "fast_simplification": "fast-simplification",
    "scipy": "scipy",
    "xatlas": "xatlas",
}


def check_packages() -> None:
    """Raise SdgenError when what an import needs beyond a plain install is not there."""
    missing = [name for name in _PACKAGES if find_spec(name) is None]
    if missing:
        raise SdgenError(
            f"importing needs {', '.join(_PACKAGES[name] for name in missing)}: "
            "pip install 'sdgen[assets]' (in a checkout: pip install '.[assets]')"
        )
    with signals_wait():
        for name in ("trimesh", "trimesh.creation", "scipy.ndimage", "scipy.spatial", *_PACKAGES):
            import_module(name)


@contextmanager
def signals_wait() -> Iterator[None]:
    """Ctrl-C counts afterwards: trimesh catches whatever is raised while it imports, and a stop
    with it."""
    if threading.current_thread() is not threading.main_thread():
        yield  # signals are another thread's
        return
    came: list[int] = []
    before = {
        number: signal.signal(number, lambda got, _: came.append(got))
        for number in (signal.SIGINT, signal.SIGTERM)
        if signal.getsignal(number) is not None
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        for got in came[:1]:
            signal.raise_signal(got)
