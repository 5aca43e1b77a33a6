"""Geometry, materials, baking and export shared by every maker (runs inside Blender 3.4+)."""

import os
import sys

# Pillow comes from a virtual environment; appended so that Blender keeps its own numpy.
if os.environ.get("SDGEN_SITE_PACKAGES"):
    sys.path.append(os.environ["SDGEN_SITE_PACKAGES"])
