"""Where to look from: pinhole cameras, what rays see, near views, overviews and their choice.

Decides content, so it draws nothing: rays come in through :class:`~sdgen.cameras.sight.Cast`.
"""

from sdgen.cameras.choice import Sight, choose_views, unseen
from sdgen.cameras.pinhole import intrinsics, project

__all__ = ["Sight", "choose_views", "intrinsics", "project", "unseen"]
