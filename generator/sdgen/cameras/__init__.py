"""Where to look from: spots where small things would lie, the views that show most of them, and
what these show of a scene.

Decides content, so it draws nothing: rays come in through :class:`~sdgen.cameras.sight.Cast`.
"""

from sdgen.cameras.pinhole import intrinsics, project

__all__ = ["intrinsics", "project"]
