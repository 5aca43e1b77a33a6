"""Versions of what decides bytes: promised equal only for one set of them."""

from __future__ import annotations

import platform
import zlib
from importlib.metadata import PackageNotFoundError, version

import sdgen

#: Content follows from numpy (random lanes, geometry), shapely, trimesh and pybullet; pictures
#: also from pillow (JPEG) and zlib (PNG), which is a library of the machine and no package.
PACKAGES = ("numpy", "pillow", "pybullet", "shapely", "trimesh")
#: What decides the bytes of pictures alone: content is the same without them.
OF_PICTURES = ("pillow", "zlib")


def package_versions() -> dict[str, str]:
    """Installed versions by name; ``machine`` (the architecture), ``sdgen`` and ``zlib`` (the
    version that runs, not the one Python was built with) included."""
    out = {
        "machine": platform.machine(),
        "sdgen": sdgen.__version__,
        "zlib": zlib.ZLIB_RUNTIME_VERSION,
    }
    for name in PACKAGES:
        try:
            out[name] = version(name)
        except PackageNotFoundError:
            out[name] = "unknown"
    return dict(sorted(out.items()))
