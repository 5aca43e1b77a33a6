"""Versions of what decides bytes: promised equal only for one set of them."""

from __future__ import annotations

import platform
from importlib.metadata import PackageNotFoundError, version

import sdgen

#: Content follows from numpy (random lanes, geometry), shapely, trimesh and pybullet; pictures
#: also from embreex (light; not there on some machines), deflate (PNG) and pillow (JPEG).
PACKAGES = ("deflate", "embreex", "numpy", "pillow", "pybullet", "shapely", "trimesh")
#: What decides the bytes of pictures alone: content is the same without them.
OF_PICTURES = ("deflate", "embreex", "pillow")


def package_versions() -> dict[str, str]:
    """Installed versions by name; ``machine`` (the architecture) and ``sdgen`` included."""
    out = {"machine": platform.machine(), "sdgen": sdgen.__version__}
    for name in PACKAGES:
        try:
            out[name] = version(name)
        except PackageNotFoundError:
            out[name] = "unknown"
    return dict(sorted(out.items()))
