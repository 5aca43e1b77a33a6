"""Static pages that show a data set: scenes, views, labels, plans, graphs, models in 3-D."""

from sdgen.gallery.page import Shown, write_gallery
from sdgen.gallery.serve import serve

__all__ = ["Shown", "serve", "write_gallery"]
