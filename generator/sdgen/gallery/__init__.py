"""A static page that shows a data set: views, boxes, labels, floor plans."""

from sdgen.gallery.page import Shown, write_gallery
from sdgen.gallery.serve import serve

__all__ = ["Shown", "serve", "write_gallery"]
